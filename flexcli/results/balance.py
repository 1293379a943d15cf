"""Results of balancing a mechanism."""

from typing import NamedTuple

__all__ = [
    "BalanceResult",
    "CouplingTerm",
    "GravityRow",
    "StrokeRow",
    "TransferRow",
    "UnknownResult",
]


class UnknownResult(NamedTuple):
    """A free number of a mechanism, and its choice within its bounds."""

    name: str
    value: float
    unit: str
    least: float | None
    most: float | None


class TransferRow(NamedTuple):
    """Displacement over acceleration of the base [s²] at a frequency, before and after balancing.

    Damped ones are complex: magnitude and phase. None where there is nothing to balance, no
    damping is stated, or the value is infinite (an undamped resonance).
    """

    frequency: float
    init: float | None
    final: float | None
    init_damped: complex | None = None
    final_damped: complex | None = None


class StrokeRow(NamedTuple):
    """A term of the equation of motion at rest and over the stroke.

    ``orders`` are the contributions of the first, second and third power of the coordinate at the
    end of the stroke; ``at_stroke`` is the exact value at the end that differs most from rest.
    """

    name: str
    unit: str
    at_rest: float
    orders: tuple[float, ...]
    at_stroke: float


class CouplingTerm(NamedTuple):
    """Dependence of the coupling on one number of the mechanism, and effect of its tolerance."""

    name: str
    value: float
    unit: str
    slope: float
    tolerance: float
    effect: float


class GravityRow(NamedTuple):
    """The effect of gravity along one axis: torque (or force) on the freedom, sag, stiffness."""

    axis: str
    mounted: str
    unit: str
    at_rest: float
    at_stroke: float | None
    sag: float | None
    stiffness: float


class BalanceResult(NamedTuple):
    """The answer of ``flexure balance`` beside its values."""

    outcome: str
    motion: str
    output_unit: str
    reason: str = ""
    remedy: str = ""
    stroke: float | None = None
    quality: float | None = None
    unknowns: tuple[UnknownResult, ...] = ()
    transfer: tuple[TransferRow, ...] = ()
    over_stroke: tuple[StrokeRow, ...] = ()
    sensitivities: tuple[CouplingTerm, ...] = ()
    gravity: tuple[GravityRow, ...] = ()
    remarks: tuple[str, ...] = ()
