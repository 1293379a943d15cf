"""Numerical methods that know no mechanics."""
