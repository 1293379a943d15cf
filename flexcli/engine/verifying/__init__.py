"""Comparison of a model's numbers with those of solid elements."""
