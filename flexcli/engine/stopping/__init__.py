"""How an end stop is chosen, and the scene in time between stops."""
