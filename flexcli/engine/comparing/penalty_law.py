"""A stop as a force of approach and speed, for integrators that find no impacts and contacts."""

from collections.abc import Callable
from math import acos, acosh, cos, cosh, sqrt
from typing import TypeAlias

from flexcli.mechanics.stopping.laws import (
    AnyStopLaw,
    HertzStop,
    RigidStop,
    damping_ratio,
    stiffness_on_blade,
)
from flexcli.mechanics.stopping.modal_blade import ModalBlade

__all__ = ["RIGID_PENALTY", "penalty_law"]

Push: TypeAlias = Callable[[float, float], float]

RIGID_PENALTY = 1e4
"""Stiffness of the spring for a rigid stop, over that of the blade at the stop."""


def penalty_law(blade: ModalBlade, law: AnyStopLaw) -> Push:
    """Return the push [N] of a stop on the modes for an approach [m] > 0 and its rate [m/s].

    The left-out modes and the stop's mount lie in series with the contact. A rigid stop with a
    restitution has no such law: a spring ``RIGID_PENALTY`` as stiff as the blade at the stop takes
    its place, beside the dashpot that gives one mode that restitution, or the least that a dashpot
    can.
    """
    if isinstance(law, HertzStop):
        return _hertz_push(law, blade.stop_residual)
    if isinstance(law, RigidStop):
        k = RIGID_PENALTY / float((blade.stop**2 / blade.angular**2).sum())
        mass = 1.0 / float(blade.stop @ blade.stop)
        c = 2.0 * damping_ratio(law.restitution) * sqrt(k * mass)
    else:
        k, c = stiffness_on_blade(blade, law.stiffness), law.damping
    return lambda approach, speed: max(k * approach + c * speed, 0.0)


def _hertz_push(law: HertzStop, residual: float) -> Push:
    hardness = (law.compliance + residual) * law.stiffness

    def push(approach: float, speed: float) -> float:
        # δ + C k δ^(3/2) = x is a depressed cubic of 1/√δ, with one positive root
        size = sqrt(3.0 * approach)
        turn = 1.5 * hardness * size
        root = cosh(acosh(turn) / 3.0) if turn >= 1.0 else cos(acos(turn) / 3.0)
        elastic = law.stiffness * (0.5 * size / root) ** 3
        return max(elastic * (1.0 + law.dissipation * speed), 0.0)

    return push
