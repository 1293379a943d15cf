"""The linear systems that a blade is, one after another: free, against a spring, held."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from math import inf
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.stopping.laws import LinearStop, RigidStop, Stops, stiffness_on_blade
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.numerics.linear_system import LinearSystem, second_order_system

__all__ = ["Contact", "Output", "Phase", "free_phase", "held_phase", "phases_of", "spring_phase"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]


class Contact(Enum):
    """What the blade does at its stops."""

    FREE = "free"
    SPRING = "against a spring"
    HELD = "held by a rigid stop"


class Output(NamedTuple):
    """An output ``constant + Re(on_y · y) + direct a`` of a phase, a the base's acceleration."""

    on_y: Complexes
    constant: float = 0.0
    direct: float = 0.0


@dataclass(frozen=True, eq=False)
class Phase:
    """Motion ``q = origin + basis z`` with a linear system for z, driven by the base.

    ``side`` is 1 above, −1 below, 0 when free; ``force`` is the stop's push on the blade, along
    −side; ``deflection`` is the blade's at the stop. ``z`` of a held blade has one coordinate
    less. ``spring`` and ``dashpot`` are the stop's, zero where there is none.
    """

    contact: Contact
    side: int
    origin: Floats
    basis: Floats
    system: LinearSystem
    drive: Complexes
    force: Output
    deflection: Output
    spring: float = 0.0
    dashpot: float = 0.0

    def project(self, q: Floats, rate: Floats) -> Complexes:
        """Return the amplitudes of a state."""
        return self.system.project(self.basis.T @ (q - self.origin), self.basis.T @ rate)

    def state(self, y: Complexes) -> tuple[Floats, Floats]:
        """Return (q, q') of amplitudes."""
        z, rate = self.system.state(y)
        return self.origin + self.basis @ z, self.basis @ rate

    @property
    def shapes(self) -> Complexes:
        """What takes y to q − origin; times the roots, to q'."""
        taken: Complexes = self.basis @ self.system.shapes
        return taken


def _amplitude_row(direction: Floats, basis: Floats, system: LinearSystem) -> Complexes:
    """Return the row whose real part, times the amplitudes, is the motion along a direction."""
    row: Complexes = direction @ basis @ system.shapes
    return row


def free_phase(blade: ModalBlade) -> Phase:
    """Return the blade away from its stops."""
    n = blade.angular.size
    system = second_order_system(blade.stiffness, blade.damper)
    return Phase(
        contact=Contact.FREE,
        side=0,
        origin=np.zeros(n),
        basis=np.eye(n),
        system=system,
        drive=system.drive(-blade.base),
        force=Output(np.zeros(system.roots.size, dtype=np.complex128)),
        deflection=Output(_amplitude_row(blade.stop, np.eye(n), system)),
    )


def spring_phase(blade: ModalBlade, law: LinearStop, gap: float, side: int) -> Phase:
    """Return the blade against a spring: stiffer by k φφᵀ, its rest moved by the gap."""
    n, s, c = blade.angular.size, blade.stop, law.damping
    k = stiffness_on_blade(blade, law.stiffness)
    together = np.outer(s, s)
    system = second_order_system(blade.stiffness + k * together, blade.damper + c * together)
    softness = s / blade.angular**2
    origin = side * gap * k * softness / (1.0 + k * (s @ softness))
    along = _amplitude_row(s, np.eye(n), system)
    # k (φ·origin side − gap) in the form that doesn't cancel
    push = -k * gap / (1.0 + k * float(s @ softness))
    return Phase(
        contact=Contact.SPRING,
        side=side,
        origin=origin,
        basis=np.eye(n),
        system=system,
        drive=system.drive(-blade.base),
        force=Output(side * along * (k + c * system.roots), push),
        deflection=Output(along, float(s @ origin)),
        spring=k,
        dashpot=c,
    )


def held_phase(blade: ModalBlade, gap: float, side: int) -> Phase:
    """Return the blade that rests on a rigid stop: what moves keeps the deflection there."""
    s = blade.stop
    weight = float(s @ s)
    basis = np.linalg.svd(s[None, :])[2][1:].T
    foot = side * gap * s / weight
    K = basis.T @ blade.stiffness @ basis
    C = basis.T @ blade.damper @ basis
    system = second_order_system(K, C)
    origin = foot - basis @ np.linalg.solve(K, basis.T @ blade.stiffness @ foot)
    elastic = s @ blade.stiffness
    on_y = elastic @ basis @ system.shapes + s @ blade.damper @ basis @ (
        system.shapes * system.roots
    )
    return Phase(
        contact=Contact.HELD,
        side=side,
        origin=origin,
        basis=basis,
        system=system,
        drive=system.drive(-basis.T @ blade.base),
        force=Output(
            -side / weight * on_y,
            -side * float(elastic @ origin) / weight,
            -side * float(s @ blade.base) / weight,
        ),
        deflection=Output(np.zeros(system.roots.size, dtype=np.complex128), side * gap),
    )


@lru_cache(maxsize=8)
def phases_of(blade: ModalBlade, stops: Stops) -> Mapping[tuple[Contact, int], Phase]:
    """Return the phases that a law knows, by contact and side; kept, for a search asks again."""
    phases = {(Contact.FREE, 0): free_phase(blade)}
    for side in (1, -1):
        gap = stops.gap(side)
        if gap == inf:
            continue
        if isinstance(stops.law, LinearStop):
            phases[Contact.SPRING, side] = spring_phase(blade, stops.law, gap, side)
        elif isinstance(stops.law, RigidStop):
            phases[Contact.HELD, side] = held_phase(blade, gap, side)
    return MappingProxyType(phases)
