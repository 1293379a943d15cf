"""Plots of what the verbs found, as SVG: ink on paper, solid for the exact model."""
