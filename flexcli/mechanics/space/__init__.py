"""Mechanisms in space: bodies with six freedoms, blades and rods in any direction."""
