"""The current activity of a long run: the engine reports it, a listener shows it."""

from collections.abc import Callable
from contextvars import ContextVar

__all__ = ["doing", "listener"]

listener: ContextVar[Callable[[str], None] | None] = ContextVar("activity_listener", default=None)
"""Receives the current activity, in a few words; None where nobody listens."""


def doing(text: str) -> None:
    """Report the activity that begins now."""
    told = listener.get()
    if told is not None:
        told(text)
