"""Blades at stroke by beams, shells and solids: what they were compared in, and what was found.

All blades are 100 mm long, of 200 GPa. A case has b/l, h/l, ν and its stroke: of a ``guide`` over
l, of a ``folded`` stage over 2 l, of a ``cross`` pivot (crossing in the middle) and of a
``remote`` one (0.3 l before the start) in degrees.
"""

import json
from pathlib import Path
from typing import NamedTuple

import numpy as np
from layouts_in_space import strip
from scipy.spatial.transform import Rotation
from support import body_stiffness

from flexcli.formulas.profile import Constant
from flexcli.formulas.rigid_motion import motion_at
from flexcli.mechanics.shell.first_guess import shells_from_beams
from flexcli.mechanics.space.exact.demand import Frame
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.second_variation import swing
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceLoad,
)

E, LENGTH = 200e9, 0.1

CROSSING = {"cross": 0.5, "remote": -0.3}
"""Where the blades of a pivot cross, over their length from the start."""

SPACING, ANGLE = 0.1, np.pi / 4.0
"""Between the blades of a guide [m]; of those of a pivot from its bisector [rad]."""

SHELLS = {"levels": (0, 12, 16), "tolerance": 5e-3, "made": shells_from_beams}
"""How a state is solved by thin shells."""

FOUND = Path(__file__).parent / "mechanics/space/blades_at_stroke.json"
"""By ``tests/benchmarks/blades_at_stroke.py``: {"shells": …, "solids": …}."""


class Case(NamedTuple):
    """A mechanism of blades at a stroke."""

    kind: str
    b: float
    h: float
    stroke: float
    nu: float = 0.3

    @property
    def turns(self):
        return self.kind in CROSSING

    @property
    def material(self):
        return Isotropic(E, E / 2.0 / (1.0 + self.nu))


def found(what):
    """Return what was found by ``shells`` or ``solids``: cases and numbers."""
    rows = json.loads(FOUND.read_text(encoding="utf-8"))[what]
    return [(Case(*row.pop("case")), row) for row in rows]


def mechanism(case):
    """Return the layout of a case; its drive is about the crossing, or at mid-height."""
    l, kind = LENGTH, case.kind

    def blade(name, first, second, start, end):
        profile = Constant(case.h * l)
        return SpaceBlade(
            name, first, second, start, end, (0, 0, 1), profile, case.b * l, case.material
        )

    middle = (0.0, l / 2.0, 0.0)
    if case.turns:
        blades = []
        for name, way in (("one", ANGLE), ("other", -ANGLE)):
            e = l * np.array([np.cos(way), np.sin(way), 0.0])
            start, end = -CROSSING[kind] * e, (1.0 - CROSSING[kind]) * e
            blades.append(blade(name, "ground", "stage", tuple(start), tuple(end)))
        centre = (0.0, 0.0, 0.0)
        stage = SpaceBody("stage", centre, centre)
        return SpaceLayout((stage,), tuple(blades), Drive("stage", True, (0, 0, 1), centre))
    bodies = [SpaceBody("stage", middle, middle)]
    outer = "stage" if kind == "guide" else "between"
    blades = [
        blade(f"out {x:+}", "ground", outer, (x, 0, 0), (x, l, 0))
        for x in (-SPACING / 2, SPACING / 2)
    ]
    if kind == "folded":
        bodies.append(SpaceBody("between", (0, l, 0), (0, l, 0)))
        blades += [
            blade(f"back {x:+}", "between", "stage", (x, l, 0), (x, 0, 0))
            for x in (-SPACING / 4, SPACING / 4)
        ]
    return SpaceLayout(tuple(bodies), tuple(blades), Drive("stage", False, (1, 0, 0), middle))


def at_stroke(case, **how):
    """Return the equilibrium of a case with its drive locked."""
    held, frames = held_at_stroke(case)
    return solve(mechanism(case), held, frames=frames, **how)


WAYS = {"push": (0.0, -1.0, 0.0), "pull": (0.0, 1.0, 0.0), "back": (-1.0, 0.0, 0.0)}
"""Of forces on the stage, along the blades of a guide or the bisector of a pivot."""


def pushed(case, way, size=1.0):
    """Return a force on the stage of a case, in EI/l² of one of its blades."""
    EI = E * case.b * case.h**3 * LENGTH**4 / 12.0
    force = tuple(size * EI / LENGTH**2 * c for c in WAYS[way])
    return SpaceLoad("stage", mechanism(case).drive.point, force)


def held_at_stroke(case):
    """Return what holds the drive of a case at its stroke, and the frames of that."""
    held = [None] * 6
    if case.turns:
        held[5] = np.deg2rad(case.stroke)
    else:
        held[0] = case.stroke * LENGTH * (2 if case.kind == "folded" else 1)
    return {"stage": held}, {"stage": Frame(mechanism(case).drive.point, np.eye(3))}


def supports(state):
    """Return the five support stiffnesses at the drive's point, the drive locked."""
    drive = state.layout.drive
    C = np.diag(support_compliance(state, "stage", drive.point))
    return 1.0 / np.delete(C, 5 if drive.turns else 0)


def one_blade(case, share=1.0, **how):
    """Return a single blade of a case, along x, that bears no force along itself."""
    if case.turns:
        angle = share * np.deg2rad(case.stroke)
        across = (1.0 - CROSSING[case.kind]) * LENGTH * np.sin(angle)
    else:
        angle, across = 0.0, share * case.stroke * LENGTH
    layout = strip(h=case.h * LENGTH, b=case.b * LENGTH, l=LENGTH, material=case.material)
    return solve(layout, {"tip": (None, across, 0.0, 0.0, 0.0, angle)}, **how)


def own_stiffness(state):
    """Return motion of the end, force on it and its 6 × 6 stiffness of a single blade."""
    end = (LENGTH, 0.0, 0.0)
    force = state.end_forces[0, :3]
    return state.motion_of("tip", end), force, body_stiffness(state, "tip", end)


def two_of_them(case, motion, force, K):
    """Return the five support stiffnesses of two such blades between ground and one body.

    Those of a guide side by side, at their middle; of a pivot crossing each other; along the axes
    of a blade of a guide, of the bisector of a pivot. ``force`` is
    that on a blade's end [N], ``K`` its stiffness about the moved end.
    """
    if case.turns:
        arm = Rotation.from_rotvec(motion[3:]).apply([LENGTH * (1.0 - CROSSING[case.kind]), 0, 0])
        turns = [Rotation.from_rotvec([0.0, 0.0, way]).as_matrix() for way in (ANGLE, -ANGLE)]
        arms, own = [R @ arm for R in turns], 5
    else:
        turns, own = [np.eye(3)] * 2, 1
        arms = [np.array([LENGTH / 2.0, side * SPACING / 2.0, 0.0]) for side in (1.0, -1.0)]
    whole = np.zeros((6, 6))
    for R, arm in zip(turns, arms, strict=True):
        T, X = np.kron(np.eye(2), R), motion_at(arm)
        here = X.T @ T @ K @ T.T @ X
        here[3:, 3:] -= swing(R @ force, -arm)
        whole += here
    rest = np.delete(np.arange(6), own)
    return 1.0 / np.diag(np.linalg.inv(whole[np.ix_(rest, rest)]))


def off_in_changes(case, told):
    """Yield how far beams are off shells in what a stroke changes in compliances.

    In the plane and across it: the largest change over the compliance at rest, how far it is off,
    and what is left of that in any direction beside the share ``told`` of the change there.
    """
    C = []
    for each in (case._replace(stroke=0.0), case):
        for how in ({"tolerance": 1e-6}, SHELLS):
            state = at_stroke(each, **how).checked()
            C.append(support_compliance(state, "stage", state.layout.drive.point))
    held = 5 if case.turns else 0
    for block in ((0, 1, 5), (2, 3, 4)):
        kept = np.ix_(*[[i for i in block if i != held]] * 2)
        rest, shells_rest, beams, shells = (c[kept] for c in C)
        root = np.linalg.inv(np.linalg.cholesky(rest))
        change, off = (root @ c @ root.T for c in (beams - rest, shells - shells_rest))
        off = off - change
        shares, ways = np.linalg.eigh(change)
        size = told * (ways * np.abs(shares)) @ ways.T
        most = max(np.linalg.eigvalsh(sign * off - size)[-1] for sign in (1.0, -1.0))
        yield np.abs(shares).max(), np.abs(np.linalg.eigvalsh(off)).max(), most
