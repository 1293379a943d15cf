"""Where the closed forms of a pivot of two blades stop: rotations at which they are 1 and 5 % off.

Measured with the exact solver on slender blades by ``tests/benchmarks/closed_form_limits.py``,
which prints other half-angles and kinds as well, and what ``pivot_next_order`` predicts for them.
"""

from collections.abc import Callable
from math import radians

from flexcli.formulas.card import Range, Table

__all__ = ["LIMITS", "SHIFT_LIMITS", "STIFFNESS_LIMITS", "STIFF_TURN", "STRESS_LIMITS"]
__all__ += ["SHIFT_TURN", "STRESS_TURN"]

_NONE = 60.0
"""Printed where the closed form is not that far off up to 60°, the end of the measurement."""

LIMITS: dict[float, tuple[tuple[float, float], ...]] = {
    -1.0: ((10.4, 24.2), (6.52, _NONE), (_NONE, _NONE)),
    -0.75: ((10.1, 22.7), (2.40, 12.3), (13.9, 31.3)),
    -0.5: ((8.12, 18.4), (1.15, 5.83), (12.3, 27.9)),
    -0.25: ((10.1, 22.7), (2.40, 12.3), (9.39, 21.2)),
    0.0: ((10.4, 24.2), (6.52, _NONE), (6.64, 14.9)),
    0.25: ((4.89, 11.3), (17.0, 51.9), (5.50, 12.4)),
    0.5: ((3.37, 7.78), (7.51, 29.1), (4.61, 10.5)),
    1.0: ((2.13, 4.92), (1.88, 13.1), (3.47, 7.91)),
}
"""By δ at α = 45°: degrees at which (1 %, 5 %) of tangent stiffness, stress, shift are missed."""


def _limit(number: int, share: int) -> Callable[[float], float]:
    return lambda delta: radians(LIMITS[delta][number][share])


def _table(number: int) -> Table:
    columns = {
        "theta at 1 %": ("rad", _limit(number, 0)),
        "theta at 5 %": ("rad", _limit(number, 1)),
    }
    note = "α = 45°, slender blades, by the exact solver; 60° stands for no such angle up to there"
    return Table("delta", tuple(LIMITS), columns, note)


STIFFNESS_LIMITS, STRESS_LIMITS, SHIFT_LIMITS = (_table(number) for number in range(3))

STIFF_TURN = Range(
    "theta",
    most=radians(4.0),
    unit="rad",
    why="tangent stiffness within 5 % for δ from −1 to 1 and α from 30° to 60°; 10.6° for δ from "
    "−1 to 0, where it is within 1 % up to 4.7°",
)

STRESS_TURN = Range(
    "theta",
    most=radians(2.7),
    unit="rad",
    why="true stress at most 5 % higher for δ from −1 to 1 and α from 30° to 60° (worst for δ = 1 "
    "and for −½ at 60°); the excess grows with θ itself, on the unsafe side",
)

SHIFT_TURN = Range(
    "theta",
    most=radians(7.0),
    unit="rad",
    why="shift within 5 % for δ from −0.75 to 1 and α from 30° to 60° but near Wittrick's "
    "crossings, where the next order in θ rules",
)
