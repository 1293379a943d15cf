"""Bars whose section is strips that cross: section, springs and stress against solids."""

import json
from math import hypot, pi
from pathlib import Path

import numpy as np
import pytest
from strategies import design

from flexcli.engine.check import check
from flexcli.formulas.torsion_shapes import star_torsion_constant
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.layout import Drive, Isotropic, SpaceBody, SpaceLayout, SpaceStar
from flexcli.mechanics.space.linear import assemble
from flexcli.mechanics.space.springs import springs_of
from flexcli.mechanics.space.stresses import equivalent, hinge_error, stress_rows
from flexcli.results import Verdict

STEEL = {"youngs_modulus": "210 GPa", "yield_strength": "1 GPa", "poisson_ratio": 0.3}
SOLIDS = json.loads((Path(__file__).parent / "stars.json").read_text(encoding="utf-8"))
E, AXES = 200e9, [0, 2, 5]
"""Their first strip is along y, that of a star along its z."""


def star(h, b, l, n, nu):
    material = Isotropic(E, E / (2.0 + 2.0 * nu))
    ends = (0.0, 0.0, 0.0), (l, 0.0, 0.0)
    return SpaceStar("star", "ground", "b", *ends, hypot(h, b), material, h, b, n)


def outline(h, b, n):
    """Return the corners of the section, around it."""
    found = []
    for k in range(2 * n):
        u = np.array([np.cos(k * pi / n), np.sin(k * pi / n)])
        v = np.array([-u[1], u[0]])
        root = h / 2.0 / np.tan(pi / (2 * n)) * u + h / 2.0 * v
        found += [b / 2.0 * u - h / 2.0 * v, b / 2.0 * u + h / 2.0 * v, root]
    return np.array(found)


@pytest.mark.parametrize(("h", "b", "n"), [(0.3, 4.0, 2), (0.3, 4.0, 3), (0.5, 4.0, 5)])
def test_area_and_moments_of_a_star_are_those_of_its_outline(h, b, n):
    """By triangles from the axis to each side: along a ray exactly, over the side by Gauss."""
    one = star(h, b, 20.0, n, 0.3)
    p = outline(h, b, n)
    q = np.roll(p, -1, axis=0)
    twice = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    x, w = np.polynomial.legendre.leggauss(4)
    t = (x[:, None, None] + 1.0) / 2.0
    r2 = np.sum((p + t * (q - p)) ** 2, axis=-1)
    second, fourth = (float(np.sum(twice * (w / 2.0 @ r2**k) / (2 * k + 2))) for k in (1, 2))
    assert one.area == pytest.approx(float(twice.sum()) / 2.0, rel=1e-12)
    assert 2.0 * one.bent == pytest.approx(second, rel=1e-12)
    assert one.fourth == pytest.approx(fourth, rel=1e-12)


def test_springs_and_stress_of_stars_are_those_of_solids_within_what_is_told():
    """``tests/benchmarks/stars_in_space.py``: at random over the ranges that are told."""
    for h, b, l, n, nu, stiffness, stress in SOLIDS:
        one = star(h, b, l, n, nu)
        springs = springs_of(one)
        assert springs.is_known
        ratio = np.array(stiffness) / springs.springs.stiffness[AXES]
        assert np.all(ratio > 1.0 + springs.low[AXES] - 1e-3)
        assert np.all(ratio < 1.0 + springs.high[AXES])
        rows, (low, high) = stress_rows(one, springs), hinge_error(one)
        for axis, most in zip(AXES, stress, strict=True):
            told = equivalent(rows.normal[:, axis], rows.shear[:, axis]).max()
            if (
                springs.in_stress and axis != AXES[1]
            ):  # a force across bends the most at the clamps, where none was seen
                assert 1.0 + low < most / told < 1.0 + high


@pytest.mark.parametrize("n", [2, 3, 5])
def test_a_star_is_at_rest_what_its_exact_beams_are(n):
    one, end = star(0.3e-3, 5e-3, 20e-3, n, 0.3), (20e-3, 0.0, 0.0)
    layout = SpaceLayout((SpaceBody("b", end, end),), (one,), Drive("b", True, (1, 0, 0), end))
    linear = assemble(layout).compliance("b", end, locked=False)
    exact = support_compliance(solve(layout, levels=(12,)), "b", end, free=())
    size = np.sqrt(np.outer(np.diag(linear), np.diag(linear)))
    assert np.max(np.abs(linear - exact) / size) < 0.02


def checked(geometry, requirements, wrench):
    spec = design(
        {"kind": "torsion-star", **geometry}, requirements, {"push": {"wrench": wrench}},
        material=STEEL,
    )  # fmt: skip
    rows = check(spec, spec.fixed_sizes(), "test").checks
    (row,) = (row for row in rows if row.name != "geometry")
    return row


def test_a_pushed_star_twists_aside_before_it_bends():
    """At G J A/I_p, whatever its length: its arms are hinged on the axis."""
    h, b, l = 0.16e-3, 4e-3, 16e-3
    one = star(h, b, l, 2, 0.3)
    J = star_torsion_constant(h, b, 2)
    load = 210e9 / 2.6 * J * one.area / (2.0 * one.bent)
    sizes = {"h": "0.16 mm", "b": "4 mm", "l": "16 mm"}
    assert load < pi**2 / 4.0 * 210e9 * one.bent / l**2 / 2.0
    stood = checked(sizes, {"buckling": 1.8}, {"z": f"-{load / 2.0} N"})
    assert stood.verdict is Verdict.PASS
    assert checked(sizes, {"buckling": 2.2}, {"z": f"-{load / 2.0} N"}).verdict is Verdict.FAIL


def test_nothing_is_told_where_bending_may_buckle_thin_arms():
    """¾ of 4 G (h/b)², which is 75 MPa of a star forty times as wide as thick."""
    sizes = {"h": "0.1 mm", "b": "4 mm", "l": "20 mm"}
    bent = star(0.1e-3, 4e-3, 20e-3, 2, 0.3).bent / 2e-3
    for stress, verdict in ((50e6, Verdict.PASS), (250e6, Verdict.UNDECIDED)):
        found = checked(sizes, {"yield": 1.1}, {"theta_x": f"{stress * bent} N*m"})
        assert found.verdict is verdict
