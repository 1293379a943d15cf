"""Drawings of mechanisms as SVG, to scale, with line weights 2:1 as in ISO 128."""
