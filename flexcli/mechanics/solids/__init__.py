"""Linear elastic solids of necks: bricks of high order in one octant of a symmetric body."""
