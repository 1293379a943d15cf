"""The flexure command."""
