"""Mechanisms as rigid bodies on blades, and the solvers that take any of them."""
