"""What a designer names: each file is one validated part and its physics."""
