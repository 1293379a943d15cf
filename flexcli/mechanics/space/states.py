"""States of a mechanism in space under its stroke and its loads, and the stress in them."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.freedoms import misfit
from flexcli.mechanics.space.inertia import blade_masses, mass_matrix, weight_along
from flexcli.mechanics.space.layout import MissedSeat, SpaceLoad, Vector, vector
from flexcli.mechanics.space.linear import Moved, SpaceAssembly
from flexcli.mechanics.space.second_order import SecondOrder, second_order
from flexcli.mechanics.space.stresses import StressRows, equivalent, stress_rows

__all__ = [
    "Acting",
    "BladeStress",
    "SpaceState",
    "Stresses",
    "action",
    "combined",
    "misfitted",
    "warmed",
]

Floats = NDArray[np.float64]


class Acting(NamedTuple):
    """What acts on a mechanism at once.

    ``wrench`` [N, N·m] acts on the moving body at ``point``, ``acceleration`` [m/s²] on all masses.
    """

    travel: float
    wrench: Floats
    point: Vector
    acceleration: Floats


class BladeStress(NamedTuple):
    """Normal and shear stress at the places of a blade [Pa], and where they are."""

    name: str
    normal: Floats
    shear: Floats
    warping: Floats
    where: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class SpaceState:
    """A linear state: coordinates, deformations and forces, and the weight on each blade [N/m].

    ``loads`` are those that it is under, ``locked`` says whether the drive holds it, ``warmth``
    which share of the layout's growth it has, ``missed`` what seat is off.
    """

    assembly: SpaceAssembly
    moved: Moved
    weights: Floats
    loads: tuple[SpaceLoad, ...]
    locked: bool
    warmth: float = 0.0
    missed: MissedSeat | None = None

    @property
    def bent(self) -> Floats:
        """Return by how much the six springs of each blade are deformed (blades, 6) [m, rad]."""
        rows = 6 * len(self.assembly.layout.blades)
        return np.asarray(self.moved.deformations[:rows, 0].reshape(-1, 6))

    @property
    def compression(self) -> float:
        """Return the largest force that pushes a blade over its least area [Pa], 0 if none does."""
        N = self.moved.forces[: 6 * len(self.assembly.layout.blades) : 6, 0]
        areas = np.array([blade.area for blade in self.assembly.layout.blades])
        return float(np.max(-N / areas, initial=0.0))

    def following(self) -> SecondOrder:
        """Return what the second order adds."""
        return second_order(
            self.assembly, self.moved, self.loads,
            locked=self.locked, warmth=self.warmth, missed=self.missed,
        )  # fmt: skip


class Stresses:
    """The stresses of an assembly's blades per force, found once for many states."""

    def __init__(self, assembly: SpaceAssembly) -> None:
        each = zip(assembly.layout.blades, assembly.members, strict=True)
        self.names = [blade.name for blade in assembly.layout.blades]
        self.rows: list[StressRows] = [stress_rows(blade, found) for blade, found in each]

    def of(self, forces: Floats, weights: Floats) -> list[BladeStress]:
        """Return the stresses by the springs' forces (rows,) and weights (blades, 3)."""
        found = []
        for k, (name, rows) in enumerate(zip(self.names, self.rows, strict=True)):
            acting = np.concatenate([forces[6 * k : 6 * k + 6], weights[k]])
            found.append(
                BladeStress(
                    name, rows.normal @ acting, rows.shear @ acting, rows.warping @ acting,
                    rows.where,
                )
            )  # fmt: skip
        return found

    def of_moments(self, moments: Floats) -> Floats:
        """Return bounds of the stress of moments (blades, 3, places) along each blade [Pa].

        Each moment counts with its largest, as if it were so at every place; a torque as if it
        twisted the whole blade.
        """
        most = np.abs(moments).max(axis=-1)
        worst = [
            equivalent(rows.normal[:, 3:6], rows.shear[:, 3:6]).max(axis=0) for rows in self.rows
        ]
        return np.asarray(np.sum(most * np.array(worst), axis=-1))


def action(assembly: SpaceAssembly, acting: Acting) -> SpaceState:
    """Return the linear state under a travel, at which the drive holds it, or under loads alone.

    Loads act with the drive free: a stroke is from where they leave the mechanism.
    """
    locked = acting.travel != 0.0
    body = assembly.layout.drive.body
    load = SpaceLoad(body, acting.point, vector(acting.wrench[:3]), vector(acting.wrench[3:]))
    pull = assembly.load(load)
    weights = np.zeros((len(assembly.members), 3))
    loads = [load] if np.any(acting.wrench) else []
    if np.any(acting.acceleration):
        pull = pull + weight_along(assembly, mass_matrix(assembly), acting.acceleration)
        masses = blade_masses(assembly)
        for k, member in enumerate(assembly.members):
            weights[k] = member.axes @ acting.acceleration * masses[k] / member.l
        loads += [
            SpaceLoad(each.name, each.com, vector(each.mass * acting.acceleration))
            for each in assembly.layout.bodies
            if each.mass
        ]
    travel = np.array([acting.travel]) if locked else None
    moved = assembly.moved(pull[:, None], travel=travel)
    return SpaceState(assembly, moved, weights, tuple(loads), locked)


def misfitted(
    assembly: SpaceAssembly, missed: MissedSeat, *, kept: tuple[Vector, ...] = ()
) -> SpaceState:
    """Return the state that a seat which is off leaves, the drive free.

    ``kept`` are axes about which a guide keeps the moving body from turning, by moments.
    """
    body = assembly.layout.body(assembly.layout.drive.body)
    off = misfit(assembly, missed.blade, missed.offset[:, None])
    weights = np.zeros((len(assembly.members), 3))
    state = SpaceState(
        assembly, assembly.moved(misfits=off), weights, (), locked=False, missed=missed
    )
    if not kept:
        return state
    unit = [SpaceLoad(body.name, body.point, (0.0, 0.0, 0.0), axis) for axis in kept]
    turned = assembly.moved(np.stack([assembly.load(load) for load in unit], axis=1))
    about = np.array(kept) @ assembly.motion(body.name, body.point)[3:]
    held = -np.linalg.solve(about @ turned.coordinates, about @ state.moved.coordinates)
    moved = Moved(
        state.moved.coordinates + turned.coordinates @ held,
        state.moved.deformations + turned.deformations @ held,
        state.moved.forces + turned.forces @ held,
        state.moved.drive + turned.drive @ held,
    )
    loads = tuple(
        load._replace(moment=vector(m * np.asarray(load.moment)))
        for load, m in zip(unit, held[:, 0], strict=True)
    )
    return replace(state, moved=moved, loads=loads)


def warmed(assembly: SpaceAssembly, *, locked: bool) -> SpaceState:
    """Return the state that the growth of a layout leaves, its drive free or locked at rest."""
    travel = np.zeros(1) if locked else None
    moved = assembly.moved(misfits=assembly.growth()[:, None], travel=travel)
    weights = np.zeros((len(assembly.members), 3))
    return SpaceState(assembly, moved, weights, (), locked=locked, warmth=1.0)


def combined(states: list[SpaceState], shares: list[float]) -> SpaceState:
    """Return a sum of states, each times its share."""
    first = states[0]
    each = list(zip(states, shares, strict=True))
    columns = zip(*(state.moved for state in states), strict=True)
    moved = Moved(*(np.tensordot(shares, parts, axes=1) for parts in columns))
    loads = tuple(load.times(s) for state, s in each for load in state.loads)
    weights = np.asarray(sum(s * state.weights for state, s in each))
    locked = any(state.locked for state in states)
    warmth = sum(s * state.warmth for state, s in each)
    return SpaceState(first.assembly, moved, weights, loads, locked, warmth)
