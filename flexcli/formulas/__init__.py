"""Closed forms: pure functions of floats and arrays that broadcast, in SI."""
