"""Whether equilibria are solved by code that Numba compiles (extra ``fast``)."""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from importlib.util import find_spec

__all__ = ["compiled", "has_numba", "is_compiled", "pays"]

STATES = 7500
"""Number of equilibria, in a batch or a study, from which compiled code saves its loading time."""

_ASKED: ContextVar[bool | None] = ContextVar("_ASKED", default=None)


def has_numba() -> bool:
    """Return whether Numba is installed."""
    return find_spec("numba") is not None


def pays(states: int) -> bool:
    """Return whether compiled code is available and worth its loading for so many equilibria."""
    return states >= STATES and has_numba()


def is_compiled(states: int) -> bool:
    """Return whether one batch of so many equilibria is solved by compiled code."""
    asked = _ASKED.get()
    return pays(states) if asked is None else asked


@contextmanager
def compiled(is_so: bool) -> Iterator[None]:
    """Solve by compiled code, or by arrays, however few equilibria there are at a time.

    A study decides once for all of its designs, so that their digits depend on no batch or process.
    """
    token = _ASKED.set(is_so)
    try:
        yield
    finally:
        _ASKED.reset(token)
