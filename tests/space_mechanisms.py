"""Mechanisms in space for tests: random ones, and those of the literature."""

import numpy as np
from space_frame import Beam, Frame, beam_matrix

from flexcli.formulas.clamped_blade import clamped_blade, clamped_rod
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceRod,
)

STEEL = Isotropic(2.1e11, 2.1e11 / 2.6, 7800.0)
Z = (0.0, 0.0, 1.0)


def vector(values):
    return tuple(float(v) for v in values)


def blade(name, first, second, start, end, *, width=Z, h=0.3e-3, b=8e-3, material=STEEL):
    return SpaceBlade(
        name, first, second, vector(start), vector(end), vector(width), Constant(h), b, material
    )


def rod(name, first, second, start, end, *, d=0.5e-3, material=STEEL):
    return SpaceRod(name, first, second, vector(start), vector(end), d, material)


def guide(l=0.1, apart=0.1, h=0.5e-3, b=0.05, mass=1.0, material=STEEL):
    """Two parallel blades along y; the stage travels along x."""
    blades = tuple(
        blade(name, "ground", "stage", (x, 0, 0), (x, l, 0), h=h, b=b, material=material)
        for name, x in (("left", -apart / 2), ("right", apart / 2))
    )
    body = SpaceBody("stage", (0.0, l, 0.0), (0.0, l, 0.0), mass)
    return SpaceLayout((body,), blades, Drive("stage", False, (1.0, 0.0, 0.0), (0.0, l, 0.0)))


def random_mechanism(rng):
    """Two bodies on blades and rods in any direction, every body held by several."""
    points = rng.uniform(-0.05, 0.05, (2, 3))
    bodies = tuple(
        SpaceBody(
            name, vector(p), vector(p + rng.uniform(-0.01, 0.01, 3)), rng.uniform(0.1, 1.0),
            tuple(vector(row) for row in np.diag(rng.uniform(1.0, 1.9, 3) * 1e-5)),
        )
        for name, p in zip("ab", points, strict=True)
    )  # fmt: skip
    members = []
    for number in range(6):
        first, second = (("ground", "a"), ("a", "b"), ("ground", "b"))[number % 3]
        start = rng.uniform(-0.06, 0.06, 3)
        end = start + rng.normal(size=3) * 0.03
        if number < 4:
            members.append(blade(f"m{number}", first, second, start, end, width=rng.normal(size=3)))
        else:
            members.append(rod(f"m{number}", first, second, start, end))
    e = rng.normal(size=3)
    drive = Drive("b", bool(rng.integers(2)), vector(e / np.linalg.norm(e)), vector(points[1]))
    return SpaceLayout(bodies, tuple(members), drive)


def as_frame(layout):
    """Return the frame of the same springs, blade by blade."""
    numbers = {body.name: i for i, body in enumerate(layout.bodies)}
    beams = []
    for member in layout.blades:
        l = float(np.linalg.norm(np.subtract(member.end, member.start)))
        E, G = member.material.E, member.material.G
        if isinstance(member, SpaceRod):
            k = clamped_rod(E=E, G=G, d=member.d, l=l).stiffness
        else:
            k = clamped_blade(E=E, G=G, h=member.profile.h, l=l, b=member.b).stiffness
        # the shear parameter that makes of EI, from the pure bending, the stiffness of the S shape
        shear_y, shear_z = (12.0 * k[t] / l**2 / k[s] - 1.0 for t, s in ((5, 1), (4, 2)))
        K = beam_matrix(l, k[0] * l, k[3] * l, k[4] * l, k[5] * l, shear_y, shear_z)
        first, second = numbers.get(member.first), numbers.get(member.second)
        beams.append(Beam(first, second, member.start, member.end, member.axes, K))
    return Frame([body.point for body in layout.bodies], beams)


def turned(layout, R, shift=(0.0, 0.0, 0.0)):
    """Return the same mechanism turned by a rotation matrix and moved."""

    def place(p):
        return vector(R @ np.asarray(p) + shift)

    def way(p):
        return vector(R @ np.asarray(p))

    bodies = tuple(
        SpaceBody(
            b.name, place(b.point), place(b.com), b.mass,
            tuple(vector(row) for row in R @ np.array(b.inertia) @ R.T),
        )
        for b in layout.bodies
    )  # fmt: skip
    members = []
    for m in layout.blades:
        ends = place(m.start), place(m.end)
        if isinstance(m, SpaceRod):
            members.append(SpaceRod(m.name, m.first, m.second, *ends, m.d, m.material))
        else:
            members.append(
                SpaceBlade(
                    m.name, m.first, m.second, *ends, way(m.width), m.profile, m.b, m.material
                )
            )
    d = layout.drive
    drive = Drive(d.body, d.turns, way(d.direction), place(d.point))
    return SpaceLayout(bodies, tuple(members), drive)


def rotation(rng):
    Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    return Q * np.sign(np.linalg.det(Q))
