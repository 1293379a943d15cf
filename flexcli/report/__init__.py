"""Rendering of results, in each of the formats, from results only."""
