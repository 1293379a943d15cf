"""How results are shown, in each of the formats, from results only."""
