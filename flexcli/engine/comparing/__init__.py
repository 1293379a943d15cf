"""How models and methods are timed and compared with the finest."""
