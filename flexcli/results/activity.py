"""What is being done: the engine says it, whoever watches hears it."""

from collections.abc import Callable
from contextvars import ContextVar

__all__ = ["doing", "listener"]

listener: ContextVar[Callable[[str], None] | None] = ContextVar("activity_listener", default=None)
"""Told what is being done, in a few words; nothing where nobody watches."""


def doing(text: str) -> None:
    """Say what is being done from here on."""
    told = listener.get()
    if told is not None:
        told(text)
