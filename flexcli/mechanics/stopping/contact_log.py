"""The contacts of a run, one after another."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from flexcli.mechanics.stopping.result import Contacts

__all__ = ["ContactLog"]


@dataclass(frozen=True)
class _Touch:
    """A contact: when and how it began, the impulse at once, when it ended."""

    time: float
    side: int
    speed: float
    impulse: float = 0.0
    end: float = 0.0


class ContactLog:
    """Contacts so far; at most one is under way."""

    def __init__(self) -> None:
        """Start with none."""
        self._closed: list[_Touch] = []
        self._now: _Touch | None = None

    def __len__(self) -> int:
        """Return the number of contacts that have ended, the index of the one under way."""
        return len(self._closed)

    def strike(self, time: float, side: int, speed: float, impulse: float) -> None:
        """Take an impact, which has no length."""
        self._closed.append(_Touch(time, side, speed, impulse, time))

    def begin(self, time: float, side: int, speed: float) -> None:
        """Take the start of a contact that lasts."""
        self._now = _Touch(time, side, speed)

    def end(self, time: float) -> None:
        """Take the end of the contact under way."""
        if self._now is not None:
            self._closed.append(replace(self._now, end=time))
            self._now = None

    def contacts(self, time: float, impulses: Mapping[int, float]) -> Contacts:
        """Return all contacts at a time, with the impulses of those that last by their index."""
        touches = [
            *self._closed,
            *([replace(self._now, end=time)] if self._now else []),
        ]
        pushed = [t.impulse + impulses.get(i, 0.0) for i, t in enumerate(touches)]
        return Contacts(
            time=np.array([t.time for t in touches]),
            side=np.array([t.side for t in touches], dtype=np.int64),
            speed=np.array([t.speed for t in touches]),
            impulse=np.array(pushed),
            duration=np.array([max(t.end - t.time, 0.0) for t in touches]),
        )
