"""Whether equilibria are solved by compiled code: by Numba (extra ``fast``), where it pays."""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from importlib.util import find_spec

__all__ = ["compiled", "has_numba", "is_compiled", "pays"]

STATES = 7500
"""Equilibria from which compiled code saves what loading it takes, in a batch or in a study."""

_ASKED: ContextVar[bool | None] = ContextVar("_ASKED", default=None)


def has_numba() -> bool:
    """Return whether there is what compiles."""
    return find_spec("numba") is not None


def pays(states: int) -> bool:
    """Return whether compiled code is there and worth its loading for so many equilibria."""
    return states >= STATES and has_numba()


def is_compiled(states: int) -> bool:
    """Return whether so many equilibria, one batch, are solved by compiled code."""
    asked = _ASKED.get()
    return pays(states) if asked is None else asked


@contextmanager
def compiled(is_so: bool) -> Iterator[None]:
    """Solve by compiled code, or by arrays, however few equilibria there are at a time.

    A study decides once for all of its designs: their digits hang on no batch, and no process.
    """
    token = _ASKED.set(is_so)
    try:
        yield
    finally:
        _ASKED.reset(token)
