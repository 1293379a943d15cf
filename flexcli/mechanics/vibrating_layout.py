"""A layout as matrices for small vibration in its plane: bodies and blades with their mass."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from math import hypot

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant
from flexcli.mechanics.heavy_blade import HeavyBlade, heavy_blade
from flexcli.mechanics.layout import Blade, Layout, Point

__all__ = ["VibratingLayout", "vibrating_layout"]

Floats = NDArray[np.float64]

DIRECTIONS = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0)}
"""Rigid motion of the base along each axis, as (x, y, φ) of every body."""


@dataclass(frozen=True, eq=False)
class VibratingLayout:
    """Mass, stiffness and base excitation of the free coordinates; rows of each blade by name.

    Free coordinates are motions (x, y, φ) of the bodies' points relative to the base, without
    those held, then modes inside the blades. ``pull`` is the inertial force per acceleration of
    the base along an axis, ``moved`` all the mass that it moves [kg]. ``motions`` are rows (3, n)
    of each body; ``axial``, ``bending`` [Pa] and ``end_force`` (3, n), along x and y [N] and
    about the end [N·m], are rows of each blade, ``places`` (2, places) where its stress is looked
    at, from its start, and its thickness there [m].
    """

    mass: Floats
    stiffness: Floats
    pull: Mapping[str, Floats]
    moved: Mapping[str, float]
    motions: Mapping[str, Floats]
    axial: Mapping[str, Floats]
    bending: Mapping[str, Floats]
    end_force: Mapping[str, Floats]
    places: Mapping[str, Floats]


def vibrating_layout(
    layout: Layout,
    density: float = 0.0,
    held: Collection[tuple[str, int]] = (),
    *,
    thick: bool = False,
) -> VibratingLayout:
    """Return the matrices of a layout of one design at rest.

    Parameters
    ----------
    layout : Layout
        The mechanism; its loads and acceleration play no part.
    density : float
        Of the blades [kg/m³]; 0 leaves their mass out.
    held : collection of (str, int)
        Body and coordinate (0 x, 1 y, 2 φ) that do not move against the base.
    thick : bool
        Whether blades shear and their sections have rotary inertia; the layout has ``G`` then.

    Returns
    -------
    VibratingLayout
        Matrices and rows.

    Notes
    -----
    Small vibration about rest of blades that stretch, without load in them.

    """
    names = [body.name for body in layout.bodies]
    blades = _heavy(layout, density, thick=thick)
    bodies = 3 * len(names)
    inner = np.cumsum([0, *(blade.mass.shape[0] - 6 for blade in blades)]) + bodies
    # the base is the last body: its inertia excites the blades that stand on it
    ground = int(inner[-1])
    size = ground + 3
    at = {name: 3 * index for index, name in enumerate(names)}
    K, M = np.zeros((size, size)), np.zeros((size, size))
    for body in layout.bodies:
        arm = _motion_at(body.com, body.point)
        place = slice(at[body.name], at[body.name] + 3)
        M[place, place] += arm.T @ np.diag([body.mass, body.mass, body.inertia]) @ arm
    for support in layout.supports:
        arm = _motion_at(support.point, layout.body(support.body).point)
        place = slice(at[support.body], at[support.body] + 3)
        K[place, place] += arm.T @ np.diag(support.stiffness) @ arm
    axial, bending, end_force = {}, {}, {}
    for index, (strip, blade) in enumerate(zip(layout.blades, blades, strict=True)):
        T = np.zeros((blade.mass.shape[0], size))
        frame = _frame(strip)
        for row, name, end in ((0, strip.first, strip.start), (3, strip.second, strip.end)):
            first = at.get(name, ground)
            point = layout.body(name).point if name in at else (0.0, 0.0)
            T[row : row + 3, first : first + 3] = frame @ _motion_at(end, point)
        T[6:, inner[index] : inner[index + 1]] = np.eye(blade.mass.shape[0] - 6)
        K += T.T @ blade.stiffness @ T
        M += T.T @ blade.mass @ T
        axial[strip.name], bending[strip.name] = blade.axial @ T, blade.bending @ T
        end_force[strip.name] = frame.T @ blade.end_force @ T
    free = np.setdiff1d(np.arange(ground), [at[name] + axis for name, axis in held])
    pulls = {axis: _pull(M, unit, names, ground) for axis, unit in DIRECTIONS.items()}
    rows = np.eye(size)
    return VibratingLayout(
        mass=M[np.ix_(free, free)],
        stiffness=K[np.ix_(free, free)],
        pull={axis: force[free] for axis, (force, _) in pulls.items()},
        moved={axis: moved for axis, (_, moved) in pulls.items()},
        motions={name: rows[at[name] : at[name] + 3, free] for name in names},
        axial={name: found[:, free] for name, found in axial.items()},
        bending={name: found[:, free] for name, found in bending.items()},
        end_force={name: found[:, free] for name, found in end_force.items()},
        places={
            strip.name: np.stack([blade.s, blade.h])
            for strip, blade in zip(layout.blades, blades, strict=True)
        },
    )


def _heavy(layout: Layout, density: float, *, thick: bool) -> list[HeavyBlade]:
    """Return every blade as a component; alike ones of constant thickness are made once."""
    made: dict[tuple[float, ...], HeavyBlade] = {}
    G = layout.G if thick else None
    found = []
    for blade in layout.blades:
        (x_1, y_1), (x_2, y_2) = blade.start, blade.end
        l, profile = hypot(x_2 - x_1, y_2 - y_1), blade.profile
        stiffer = blade.stiffer
        key = (profile.h, l, blade.b, stiffer) if isinstance(profile, Constant) else ()
        if key not in made or not key:
            made[key] = heavy_blade(
                profile, E=layout.E * stiffer, l=l, b=blade.b, density=density,
                G=None if G is None else G * stiffer,
            )  # fmt: skip
        found.append(made[key])
    return found


def _motion_at(place: Point, point: Point) -> Floats:
    """Return the motion of a place of a body per motion (x, y, φ) of its point."""
    x, y = place[0] - point[0], place[1] - point[1]
    return np.array([[1.0, 0.0, -y], [0.0, 1.0, x], [0.0, 0.0, 1.0]])


def _frame(blade: Blade) -> Floats:
    """Return the turn from the plane's axes to the blade's: along it, across it, rotation."""
    dx, dy = blade.end[0] - blade.start[0], blade.end[1] - blade.start[1]
    length = hypot(dx, dy)
    c, s = dx / length, dy / length
    return np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


def _pull(
    M: Floats, unit: tuple[float, float, float], names: list[str], ground: int
) -> tuple[Floats, float]:
    """Return the inertial force when all moves with the base, and the mass that does."""
    rigid = np.zeros(M.shape[0])
    rigid[: 3 * len(names)] = np.tile(unit, len(names))
    rigid[ground:] = unit
    force = M @ rigid
    return force, float(rigid @ force)
