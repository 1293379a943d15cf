"""Blades as geometrically exact thin shells between rigid bodies: the finest model in space."""
