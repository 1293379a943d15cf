"""Critical loads of straight blades against Euler, Haringx and a spectral determinant."""

from dataclasses import replace

import numpy as np
import pytest
from mechanisms_for_tests import E, G, cantilever, parallelogram, pivot
from scipy.linalg import expm
from scipy.optimize import brentq

from flexcli.formulas.buckling import thick_load
from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.mechanics.stability import critical_load

l, b = 20e-3, 10e-3
ENDS = {
    "clamped-free": {},
    "clamped-pinned": {"tip": (None, 0.0, None)},
    "clamped-guided": {"tip": (None, None, 0.0)},
    "clamped-clamped": {"tip": (None, 0.0, 0.0)},
}
GRADED = 200.0
"""Axial force [EI/l²] up to which a transfer matrix, of entries up to exp(√n), keeps its digits."""

SPECTRAL = 1e-8
"""Of a transfer matrix and a brent root."""


@pytest.mark.parametrize("h", [1e-5, 1e-4, 2e-3])
@pytest.mark.parametrize("ends", ENDS)
def test_a_thick_blade_buckles_at_haringxs_load(ends, h):
    unit = E * b * h**3 / 12.0 / l**2
    axial = (h / l) ** 2 / 12.0
    found = linear_critical(
        cantilever(h=h), ENDS[ends], [Load("tip", (l, 0.0), (-unit, 0.0))], strain=0.6
    )
    expected = thick_load(ends=ends, axial=axial, shear=axial * E / (5.0 / 6.0 * G))
    assert found.factor == pytest.approx(expected, rel=1e-9)


def transfer(n, axial, shear):
    """Return end forces (x, y, m) per end motion of a clamped Timoshenko beam under tension n.

    y' = mψ + s q, ψ' = M, M' = m n ψ − m q with m = 1 − (s − a) n, by the matrix exponential.
    """
    m = 1.0 - (shear - axial) * n
    A = np.array([[0, m, 0, shear], [0, 0, 1, 0], [0, m * n, 0, -m], [0, 0, 0, 0]], dtype=float)
    T = expm(A)
    ends = T[:2, 2:] @ np.eye(2)
    clamp = np.linalg.inv(ends)  # (M, q) at the clamp for (y, ψ) at the end
    tip = np.vstack([clamp[1], T[2, 2:] @ clamp])  # (q, M) at the end
    K = np.zeros((3, 3))
    K[0, 0] = 1.0 / axial
    K[1:, 1:] = tip
    return K


def determinant(factor, blades, tensions, h):
    """Return the determinant of the body's stiffness about its point, units l, EI/l²."""
    axial = (h / l) ** 2 / 12.0
    shear = axial * E / (5.0 / 6.0 * G)
    K = np.zeros((3, 3))
    for (angle, reach), t in zip(blades, tensions, strict=True):
        c, s = np.cos(angle), np.sin(angle)
        r = reach * np.array([c, s])
        R = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        B = np.array([[1, 0, -r[1]], [0, 1, r[0]], [0, 0, 1]])
        K += B.T @ R.T @ transfer(factor * t, axial, shear) @ R @ B
        K[2, 2] -= factor * t * reach
    return np.linalg.det(K)


def star(angles, delta, h):
    blades = tuple(
        Blade(
            f"blade {i}", "ground", "moving",
            (delta * l * np.cos(a), delta * l * np.sin(a)),
            ((1 + delta) * l * np.cos(a), (1 + delta) * l * np.sin(a)),
            Constant(h), b,
        )
        for i, a in enumerate(angles)
    )  # fmt: skip
    return Layout((Body("moving", (0.0, 0.0)),), blades, E, G)


@pytest.mark.parametrize(
    ("angles", "delta", "h"),
    [
        ((0.8, -0.8), -0.5, 0.5e-3),
        ((0.8, -0.8), 0.1, 0.5e-3),
        ((0.0, 2.1, 4.2), 0.05, 1e-3),
        ((0.3, 1.9, -2.0, 2.8), -0.3, 0.2e-3),
    ],
)
@pytest.mark.parametrize("direction", [0.0, 1.0, np.pi])
def test_a_free_body_falls_where_the_determinant_of_its_blades_vanishes(
    angles, delta, h, direction
):
    unit = E * b * h**3 / 12.0 / l**2
    push = Load("moving", (0.0, 0.0), (unit * np.cos(direction), unit * np.sin(direction)))
    found = linear_critical(star(angles, delta, h), {}, [push])
    blades = [(a, 1.0 + delta) for a in angles]
    tensions = found.tensions / unit
    if found.factor * np.max(np.abs(tensions)) > GRADED:
        # what pulls an RCC pivot until it turns: the matrix exponential has no digits there
        found = replace(found, factor=np.inf, most=GRADED / np.max(np.abs(tensions)))
    if not np.isfinite(found.factor):
        most = min(found.most, GRADED / np.max(np.abs(tensions)))
        at = np.linspace(0.0, most, 40) * 0.99
        assert all(determinant(f, blades, tensions, h) > 0.0 for f in at)
        return
    near = found.factor * np.array([0.99, 1.01])
    root = brentq(determinant, *near, args=(blades, tensions, h), xtol=1e-14 * near[0])
    assert found.factor == pytest.approx(root, rel=SPECTRAL)
    below = np.linspace(0.0, 0.99, 60) * found.factor
    assert all(determinant(f, blades, tensions, h) > 0.0 for f in below)


def test_blades_that_buckle_between_bodies_that_stand_still_are_counted():
    """With its body locked a pivot shows no soft body at all; its blades bow at 4π²."""
    h = 1e-6
    unit = E * b * h**3 / 12.0 / l**2
    push = [Load("out", (0.0, 0.0), (unit, 0.0))]
    found = linear_critical(pivot(h=h, delta=0.2), {"out": (None, 0.0, 0.0)}, push)
    assert found.factor == pytest.approx(4.0 * np.pi**2 * 2**0.5, rel=1e-7)
    assert np.max(np.abs(found.mode)) == 0.0


def test_where_the_load_leaves_blades_straight_it_is_the_exact_load():
    h = 1e-3
    push = [Load("table", (l, 0.0), (-1.0, 0.0))]
    stage = parallelogram(h=h)
    for held in ((None, 0.0, 0.0), (None, None, 0.0), (None, None, None)):
        straight = linear_critical(stage, {"table": held}, push)
        assert straight.bends <= 1e-9
        exact = critical_load(stage, {"table": held}, push, most=1.5 * straight.factor)
        assert straight.factor == pytest.approx(exact.factor, rel=1e-8)


def test_what_pulls_straight_blades_apart_buckles_none():
    found = linear_critical(cantilever(h=1e-4), {}, [Load("tip", (l, 0.0), (1.0, 0.0))])
    assert found.factor == np.inf
