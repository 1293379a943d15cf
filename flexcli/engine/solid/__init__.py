"""Solid models of a layout: quadratic bricks between rigid bodies, solved by CalculiX."""
