"""Layouts for the tests of exact beams in space: a cantilever, a guide, a joint of odd angles."""

from dataclasses import replace

import numpy as np

from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceLoad,
    SpaceRod,
    SpaceSpring,
)

STEEL = Isotropic(200e9, 200e9 / 2.6)
INERTIA = ((2e-4, 0.0, 0.0), (0.0, 3e-4, 0.0), (0.0, 0.0, 4e-4))


def _body(name, point, mass=0.5):
    return SpaceBody(name, point, point, mass, INERTIA)


def strip(*, h, b, l=0.1, material=STEEL):
    """A blade clamped at the origin, along x, its width along z; the body ``tip`` at its end."""
    end = (l, 0.0, 0.0)
    blade = SpaceBlade(
        "blade", "ground", "tip", (0.0,) * 3, end, (0, 0, 1), Constant(h), b, material
    )
    return SpaceLayout((_body("tip", end),), (blade,), Drive("tip", False, (0, 1, 0), end))


def rod(*, d, l=0.1, material=STEEL):
    """A round rod clamped at the origin, along x."""
    end = (l, 0.0, 0.0)
    member = SpaceRod("rod", "ground", "tip", (0.0,) * 3, end, d, material)
    return SpaceLayout((_body("tip", end),), (member,), Drive("tip", False, (0, 1, 0), end))


def guide(*, h=0.5e-3, b=50e-3, l=100e-3, apart=200e-3, material=STEEL):
    """Two blades along y from the ground to the body ``stage``, which moves along x."""
    blades = tuple(
        SpaceBlade(
            name, "ground", "stage", (x, 0, 0), (x, l, 0), (0, 0, 1), Constant(h), b, material
        )
        for name, x in (("left", -apart / 2.0), ("right", apart / 2.0))
    )
    middle = (0.0, l, 0.0)
    return SpaceLayout((_body("stage", middle),), blades, Drive("stage", False, (1, 0, 0), middle))


def askew():
    """Two bodies on blades and a rod in odd directions, a spring, and loads: no symmetry at all."""
    blades = (
        SpaceBlade("a", "ground", "one", (0, 0, 0), (60e-3, 5e-3, 0), (0, 0.2, 1), Constant(0.4e-3),
                   15e-3, STEEL),
        SpaceBlade("b", "one", "two", (70e-3, 0, 5e-3), (70e-3, 50e-3, 10e-3), (1, 0.1, 0.3),
                   Constant(0.3e-3), 12e-3, STEEL),
        SpaceRod("c", "ground", "two", (0, 40e-3, -20e-3), (60e-3, 60e-3, -10e-3), 1e-3, STEEL),
    )  # fmt: skip
    bodies = (
        SpaceBody("one", (62e-3, 0, 3e-3), (60e-3, 1e-3, 0), 0.1, INERTIA),
        SpaceBody("two", (65e-3, 55e-3, 0), (66e-3, 50e-3, 2e-3), 0.2, INERTIA),
    )
    spring = SpaceSpring("one", (65e-3, 2e-3, 0), (300.0, 100.0, 500.0, 0.3, 0.2, 0.1))
    drive = Drive("two", True, (0.0, 0.0, 1.0), (65e-3, 55e-3, 0))
    return SpaceLayout(bodies, blades, drive, (spring,))


LOADS = (
    SpaceLoad("one", (61e-3, 4e-3, -2e-3), (0.5, -0.3, 0.8), (0.01, 0.02, -0.01)),
    SpaceLoad("two", (60e-3, 40e-3, 9e-3), (-0.2, 0.4, 0.3)),
)
"""On the bodies of ``askew``."""


def turned(layout, R, shift):
    """The layout turned by R and moved."""

    def at(point):
        return tuple(R @ np.asarray(point, dtype=float) + shift)

    def along(direction):
        return tuple(R @ np.asarray(direction, dtype=float))

    bodies = tuple(
        b._replace(point=at(b.point), com=at(b.com), inertia=tuple(map(tuple, R @ b.inertia @ R.T)))
        for b in layout.bodies
    )
    blades = tuple(
        replace(b, start=at(b.start), end=at(b.end))
        if isinstance(b, SpaceRod)
        else replace(b, start=at(b.start), end=at(b.end), width=along(b.width))
        for b in layout.blades
    )
    drive = layout.drive._replace(
        point=at(layout.drive.point), direction=along(layout.drive.direction)
    )
    return SpaceLayout(bodies, blades, drive)
