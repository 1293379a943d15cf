"""The heads of damped stops on their way back, after the blade has left them."""

from math import exp

from flexcli.mechanics.stopping.phases import Phase
from flexcli.numerics.exponential_sum import Term

__all__ = ["StopHeads"]


class StopHeads:
    """How far each head [m] still is from its place: ``δ exp(−kt/c)`` since the blade left it."""

    def __init__(self) -> None:
        """Start with the heads in their places."""
        self._left: dict[int, tuple[Phase, float, float]] = {}

    def leave(self, phase: Phase, indentation: float, time: float) -> float:
        """Let go of a head without mass, and return the energy [J] its dashpot will eat."""
        if not phase.dashpot or indentation <= 0.0:
            return 0.0
        self._left[phase.side] = (phase, indentation, time)
        return 0.5 * phase.spring * indentation**2

    def distance(self, side: int, time: float) -> Term | None:
        """Return the distance from its place as a term of the time from now."""
        if side not in self._left:
            return None
        phase, indentation, since = self._left[side]
        rate = -phase.spring / phase.dashpot
        return (complex(rate), (complex(indentation * exp(rate * (time - since))),))

    def meet(self, side: int, time: float) -> float:
        """Take a head up again, and return the energy [J] still in its spring."""
        term = self.distance(side, time)
        if term is None:
            return 0.0
        phase = self._left.pop(side)[0]
        return 0.5 * phase.spring * abs(term[1][0]) ** 2
