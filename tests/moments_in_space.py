"""Section forces at the clamps of blades in space: random guides and pivots under loads.

All blades are 100 mm long, of 200 GPa. A seed draws a guide, a crossed pivot or one of three
blades, the stroke at which its drive holds it, and dead forces at two points of its stage.
"""

import json
from pathlib import Path
from typing import NamedTuple

import numpy as np

from flexcli.errors import SolveError
from flexcli.formulas.amplified import FURTHER, bent_by_forces
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.rotation import matrix_of
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceLoad,
)

E, LENGTH = 200e9, 0.1
FOUND = Path(__file__).parent / "mechanics/space/moments.jsonl"
"""By ``tests/benchmarks/moments_in_space.py``: seed, size of the loads, stress of solids [Pa]."""

HALVINGS = 8
"""Of loads, until the joint stands more than they are."""

E_X = np.array([1.0, 0.0, 0.0])


class Drawn(NamedTuple):
    """A mechanism, what holds its stage, and the forces on it [N], as large as ``strain`` asks."""

    layout: SpaceLayout
    held: tuple
    points: tuple
    forces: np.ndarray
    strain: float
    stands: float


def drawn(seed):
    """Return the mechanism of a seed; its loads may be raised ``stands`` times."""
    rng = np.random.default_rng(seed)
    b = LENGTH * np.exp(rng.uniform(np.log(0.02), np.log(1.0)))
    h = min(LENGTH * np.exp(rng.uniform(np.log(0.002), np.log(0.1))), b * rng.uniform(0.05, 1.0))
    nu = float(rng.choice([0.0, 0.3, 0.34, 0.45]))
    material, kind = Isotropic(E, E / 2.0 / (1.0 + nu)), int(rng.integers(3))
    stroke = float(rng.choice([1e-3, 0.03, 0.1, 0.2, 0.3]))

    def blade(name, start, end):
        ends = (tuple(map(float, each)) for each in (start, end))
        return SpaceBlade(
            name, "ground", "stage", *ends, (0, 0, 1), Constant(float(h)), float(b), material
        )

    if kind == 0:
        sides = (-LENGTH / 2.0, LENGTH / 2.0)
        blades = [blade(f"{x:+}", (x, 0.0, 0.0), (x, LENGTH, 0.0)) for x in sides]
    else:
        crossing, angle = rng.uniform(-0.5, 0.7), np.deg2rad(rng.uniform(25.0, 60.0))
        ways = ([1.0, -1.0], [1.0, 0.1, -1.1])[kind - 1]
        each = [LENGTH * np.array([np.cos(angle * k), np.sin(angle * k), 0.0]) for k in ways]
        blades = [blade(f"{k}", -crossing * e, (1.0 - crossing) * e) for k, e in enumerate(each)]
        stroke = stroke if kind == 1 else stroke / 5.0
    middle = np.mean([each.end for each in blades], axis=0)
    point = (0.0, LENGTH / 2.0, 0.0) if kind == 0 else tuple(map(float, middle))
    drive = Drive("stage", kind > 0, (1, 0, 0) if kind == 0 else (0, 0, 1), point)
    held = (stroke * LENGTH, *[None] * 5) if kind == 0 else (*[None] * 5, stroke)
    layout = SpaceLayout((SpaceBody("stage", point, point),), tuple(blades), drive)
    away = rng.uniform(-1.0, 1.0, (2, 3)) * LENGTH * np.array([1.0, 1.0, 0.0])
    points = tuple(tuple(map(float, middle + each)) for each in away)
    forces = rng.normal(size=(2, 3)) * np.array([*[float(rng.choice([0.0, 0.3, 1.0]))] * 2, 1.0])
    strain = float(rng.choice([1e-4, 1e-3, 4e-3]))
    return Drawn(layout, held, points, forces, strain, float(rng.choice([1.1, 2.0, 4.0, 8.0])))


def loads_of(made, size):
    """Return the dead loads of a mechanism, so many times its drawn forces."""
    each = zip(made.points, size * made.forces, strict=True)
    return [SpaceLoad("stage", point, tuple(map(float, force))) for point, force in each]


def state_of(mechanism, size, held=None, **how):
    """Return the equilibrium of a mechanism under so many times its drawn forces."""
    motion, loads = mechanism.held if held is None else held, loads_of(mechanism, size)
    return solve(mechanism.layout, {"stage": motion}, loads=loads, **how).checked()


def size_of_loads(made):
    """Return how many times its drawn forces a mechanism bears, at rest to its strain, or stands.

    Nothing where it does not stand a small share of them.
    """
    blade = made.layout.blades[0]
    tiny = 1e-7 * E * blade.b * float(blade.profile.h) ** 2 / 6.0 / LENGTH
    rest = tuple(None if each is None else 0.0 for each in made.held)
    size = tiny * made.strain * E / largest(section_stresses(state_of(made, tiny, rest)))
    for _ in range(HALVINGS):
        try:
            states = state_of(made, size), state_of(made, made.stands * size)
            if not any(state.unstable for state in states):
                return size
        except SolveError:
            pass
        size *= 0.75
    return None


def nominal(layout, forces, moments, ends, turns):
    """Return nominal stress at both ends of all blades: axial, across the width, the thickness.

    Of ``forces`` and ``moments`` (blades, 3) at the starts in their axes, ``ends`` (blades, 3) and
    ``turns`` (blades, 3, 3) of the far ends against them; the shape is (2 blades, 3) [Pa].
    """
    found = []
    for blade, f, m, end, turn in zip(layout.blades, forces, moments, ends, turns, strict=True):
        h, b = float(blade.profile.h), blade.b
        unit = np.array([b * h, h * b**2 / 6.0, b * h**2 / 6.0])
        for force, moment in ((f, m), (turn.T @ f, turn.T @ (m - np.cross(end, f)))):
            found.append(np.array([force[0], moment[1], moment[2]]) / unit)
    return np.array(found)


def section_stresses(state):
    """Return the nominal stress at both ends of blades of beams or shells."""
    forces, moments = np.split(state.own_forces, 2, axis=-1)
    ends, members = state.linearised.blades, state.part.assembly.members
    reach, l = ends.motion + E_X, members.lengths[:, None]
    unit = members.bending[:, None] / l
    started = moments + np.cross(reach, forces)
    turns = matrix_of(ends.turn)
    return nominal(state.layout, forces * unit / l, started * unit, reach * l, turns)


def found():
    """Return seeds, sizes of loads, and what solids found of them (2 blades, 3) [Pa]."""
    rows = map(json.loads, FOUND.read_text(encoding="utf-8").splitlines())
    return [(row["seed"], row["size"], np.array(row["solids"])) for row in rows]


def largest(stresses):
    """Return the largest stress at a corner of a section."""
    return float(np.max(np.sum(np.abs(stresses), axis=-1)))


def bent_at(mechanism, size):
    """Return what share of its largest stress forces bend, by beams."""
    held = mechanism.held
    less = tuple(None if each is None else (1.0 - FURTHER) * each for each in held)
    states = (0.0, held), (0.0, less), (size, held), ((1.0 + FURTHER) * size, held)
    each = (largest(section_stresses(state_of(mechanism, *at))) for at in states)
    return float(bent_by_forces(*map(np.array, each)))
