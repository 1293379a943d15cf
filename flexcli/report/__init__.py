"""How results are shown: text and JSON, from results only."""
