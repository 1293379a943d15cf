"""The models that answer for a joint beside its closed forms."""
