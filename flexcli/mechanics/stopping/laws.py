"""Stops on one or both sides of a blade, and how each kind pushes back."""

from dataclasses import dataclass
from math import asin, exp, inf, pi, sqrt
from typing import TypeAlias

from flexcli.errors import SolveError
from flexcli.mechanics.stopping.modal_blade import ModalBlade

__all__ = [
    "AnyStopLaw",
    "HertzStop",
    "LinearStop",
    "RigidStop",
    "Stops",
    "damped_stop_restitution",
    "damping_ratio",
    "refuse_start",
    "stiffness_on_blade",
]

INSIDE = 1e-12
"""A start that far beyond a stop, as a share of the room, is rounding."""
MOST_DAMPING = 1.0 - 1e-9
"""Damping ratio of a dashpot next to critical, where the bounce is the least."""


@dataclass(frozen=True)
class RigidStop:
    """A stop that doesn't give: the speed there turns round, times the restitution, at once.

    The impulse is ``(1 + e) v / Σ φ_r²`` with the modes' deflections φ_r at the stop. A continuous
    blade has no effective mass at a point: Σ φ_r² grows with the number of modes, so restitution
    is a property of the stop and the chosen modes together, and the left-out modes must have no
    residual compliance (``ModalBlade.truncated``). With it, a rigid stop is ``LinearStop(inf)``.
    """

    restitution: float

    def __post_init__(self) -> None:
        """Refuse what would make energy."""
        if not 0.0 <= self.restitution <= 1.0:
            raise ValueError(f"restitution must lie between 0 and 1, got {self.restitution:g}")


@dataclass(frozen=True)
class LinearStop:
    """A head without mass on a spring [N/m] beside a dashpot [N·s/m]; it can't pull.

    The blade's residual compliance lies in series with the spring, so that a rigid stop (inf) on
    a blade with one is a spring too. Contact ends when the force falls to zero; a damped head
    then comes back by exp(−kt/c), and is met again where it is.
    """

    stiffness: float = inf
    damping: float = 0.0

    def __post_init__(self) -> None:
        """Refuse what isn't a spring."""
        if not (self.stiffness > 0.0 and 0.0 <= self.damping < inf):
            raise ValueError("a linear stop needs a stiffness and no negative damping")


@dataclass(frozen=True)
class HertzStop:
    """A ball on a flat: ``F = k_H δ^(3/2) (1 + α δ')`` for the approach δ, never negative.

    ``stiffness`` is k_H [N/m^1.5], ``compliance`` [m/N] that of the stop's mount, in series with
    the contact as the blade's residual one is; ``dissipation`` is α [s/m] of Hunt and Crossley,
    with the rate of approach taken before those compliances.
    """

    stiffness: float
    compliance: float = 0.0
    dissipation: float = 0.0


AnyStopLaw: TypeAlias = RigidStop | LinearStop | HertzStop


@dataclass(frozen=True)
class Stops:
    """One law on both sides; the gaps [m] above and below the blade at rest, inf for no stop."""

    law: AnyStopLaw
    above: float
    below: float

    def __post_init__(self) -> None:
        """Refuse gaps that leave no room, or no stop."""
        if self.above < 0.0 or self.below < 0.0 or not self.above + self.below > 0.0:
            raise ValueError("gaps must not be negative, nor both zero")

    @property
    def room(self) -> float:
        """The finite gaps together [m]; 0 for a single stop in touch, and for none."""
        return sum(gap for gap in (self.above, self.below) if gap < inf)

    def gap(self, side: int) -> float:
        """Return the gap above (1) or below (−1) [m]."""
        return self.above if side > 0 else self.below


def stiffness_on_blade(blade: ModalBlade, stiffness: float) -> float:
    """Return the stiffness that the kept modes meet: stop and left-out modes in series.

    ``1/(r + 1/k)`` [N/m]. With it a rigid stop (k = inf) on a massless blade with a mass point is
    exactly the propped overhang of the statics.

    Raises
    ------
    ValueError
        When neither stop nor left-out modes give.
    """
    compliance = blade.stop_residual + 1.0 / stiffness
    if compliance <= 0.0:
        raise ValueError("neither the stop nor the left-out modes give: use RigidStop")
    return 1.0 / compliance


def damped_stop_restitution(ratio: float) -> float:
    """Return the restitution of a mass that meets a ``LinearStop`` with damping c = 2ζ√(km).

    ``e = exp(−ζ (π − 2 arcsin ζ)/√(1 − ζ²))``: the contact ends when the force vanishes; 0 ≤ ζ < 1.

    References
    ----------
    Schwager & Pöschel (2007), Granular Matter 9, equation (21).
    """
    wander = sqrt(1.0 - ratio**2)
    return exp(-ratio / wander * (pi - 2.0 * asin(ratio)))


def damping_ratio(restitution: float) -> float:
    """Return the damping ratio ζ with which a mass leaves a ``LinearStop`` with a restitution.

    The inverse of :func:`damped_stop_restitution`. Next to critical damping the bounce is the
    least, e⁻² = 0.135: below it that damping is returned.
    """
    if restitution == 1.0:
        return 0.0
    if restitution <= damped_stop_restitution(MOST_DAMPING):
        return MOST_DAMPING
    from scipy.optimize import brentq  # seldom wanted, and slow to import

    return float(brentq(lambda r: damped_stop_restitution(r) - restitution, 0.0, MOST_DAMPING))


def refuse_start(blade: ModalBlade, stops: Stops, at_stop: float) -> None:
    """Raise when a run can't start from a deflection at the stop.

    Raises
    ------
    SolveError
        ``start-inside-stop`` or ``rigid-stop-residual``.
    """
    if isinstance(stops.law, RigidStop) and blade.stop_residual > 0.0:
        raise SolveError(
            "rigid-stop-residual",
            "a stop with restitution meets a blade whose left-out modes give at the stop",
            "use LinearStop(), rigid on that compliance, or ModalBlade.truncated()",
        )
    rounding = INSIDE * stops.room
    if not -stops.below - rounding <= at_stop <= stops.above + rounding:
        raise SolveError(
            "start-inside-stop",
            f"the blade starts at {at_stop:g} m at the stop, beyond the gaps of "
            f"{stops.above:g} m above and {stops.below:g} m below",
            "start between the stops",
        )
