"""How sizes are chosen: by convex programs on closed forms, or on numbers alone."""
