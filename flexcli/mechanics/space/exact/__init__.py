"""Geometrically exact beams in space: equilibria of bodies and blades at any stroke."""
