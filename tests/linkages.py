"""Linkages for the tests, and the closed forms of their motion."""

import numpy as np

from flexcli.mechanics.linkages.linkage import Linkage, Prismatic, Revolute


def four_bar(A, B, C, D, drive="A"):
    """Joints at A and D on the ground, B and C on the coupler; the rocker's angle is D's."""
    return Linkage(
        (
            Revolute("A", "base", "crank", A),
            Revolute("B", "crank", "coupler", B),
            Revolute("C", "coupler", "rocker", C),
            Revolute("D", "base", "rocker", D),
        ),
        ground="base",
        input=drive,
    )


def placed_four_bar(a, b, c, d, theta, side):
    """Crank a, coupler b, rocker c, ground d along x, assembled at a crank angle."""
    psi = freudenstein(a, b, c, d, theta, side)
    B, C = a * np.exp(1j * theta), d + c * np.exp(1j * psi)
    return four_bar((0.0, 0.0), (B.real, B.imag), (C.real, C.imag), (d, 0.0))


def freudenstein(a, b, c, d, theta, side):
    """Return the rocker's angle: |d + c e^{iψ} − a e^{iθ}| = b, solved for tan(ψ/2)."""
    P, Q = 2 * c * (d - a * np.cos(theta)), -2 * a * c * np.sin(theta)
    S = b**2 - c**2 - (d - a * np.cos(theta)) ** 2 - (a * np.sin(theta)) ** 2
    return 2 * np.arctan((Q + side * np.sqrt(P**2 + Q**2 - S**2)) / (S + P))


def slider_crank(r, rod, offset=0.0, angle=np.pi / 2, drive="theta"):
    """Crank of radius r at the origin, rod to a stage that slides along x at a height."""
    x = r * np.cos(angle) + np.sqrt(rod**2 - (r * np.sin(angle) - offset) ** 2)
    return Linkage(
        (
            Revolute("theta", "base", "crank", (0.0, 0.0)),
            Revolute("elbow", "crank", "rod", (r * np.cos(angle), r * np.sin(angle))),
            Revolute("wrist", "rod", "stage", (x, offset)),
            Prismatic("z", "base", "stage", (2.0, 0.0)),
        ),
        ground="base",
        input=drive,
    )


def quick_return(r, d):
    """A crank about the origin carries a block that slides along an arm about (0, −d)."""
    return Linkage(
        (
            Revolute("crank", "base", "crank", (0.0, 0.0)),
            Revolute("pin", "crank", "block", (0.0, r)),
            Prismatic("slide", "arm", "block", (0.0, 1.0)),
            Revolute("arm", "base", "arm", (0.0, -d)),
        ),
        ground="base",
        input="crank",
    )


def crank_stage(L, drive="theta"):
    """Exercise 12 C: θ clockwise of an upright crank, α of the rod, β = α − θ, z of the stage."""
    return Linkage(
        (
            Revolute("theta", "crank", "base", (0.0, 0.0)),
            Revolute("beta", "rod", "crank", (0.0, L)),
            Revolute("alpha", "rod", "stage", (-L, L)),
            Prismatic("z", "base", "stage", (1.0, 0.0)),
        ),
        ground="base",
        input=drive,
    )


def redrawn(linkage, change):
    """Return the linkage with its plane changed by a linear map and a shift of the points."""
    joints = tuple(
        j._replace(point=change(*j.point, 1.0))
        if isinstance(j, Revolute)
        else j._replace(direction=change(*j.direction, 0.0))
        for j in linkage.joints
    )
    return Linkage(joints, linkage.ground, linkage.input)
