"""Independent solutions of the joints, and what the verdicts are worth against them."""
