"""flexcli: a design desk for flexure mechanisms."""

__version__ = "0.1.0"
