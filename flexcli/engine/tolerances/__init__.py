"""What becomes of a design whose numbers differ from part to part."""
