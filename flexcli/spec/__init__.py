"""From YAML text with positions to one design, or a list of findings."""
