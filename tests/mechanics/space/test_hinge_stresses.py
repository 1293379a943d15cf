"""Stress of forces across notches and blades with fillets: solids, and statics at a stroke."""

import json
from pathlib import Path

import numpy as np
import pytest

from flexcli.formulas import fillet, notch
from flexcli.formulas.profile import Filleted, Notch
from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import COARSE, NeckUnderLoads
from flexcli.mechanics.solids.unit_loads import equivalent as along_or_mises
from flexcli.mechanics.space.layout import Isotropic, SpaceBlade
from flexcli.mechanics.space.springs import springs_of
from flexcli.mechanics.space.stresses import equivalent, hinge_error, hinge_range, stress_rows

SOLIDS = json.loads((Path(__file__).parent / "hinge_stresses.json").read_text(encoding="utf-8"))
"""By ``tests/benchmarks/hinge_stresses.py``. The bound of notches was set before these were solved,
that of fillets was raised from 0.15 to 0.20 by them."""


def hinge(kind, numbers, l, b, nu):
    """Return a hinge of E = 1 along x."""
    if kind == "notch":
        e, depth = numbers
        at = {"e": e, "r": l**2 / (4.0 * depth)}
        profile, factors = Notch(e, depth), (notch.bending_factor, notch.axial_factor)
    else:
        h, r = numbers
        at = {"h": h, "l": l, "r": r}
        profile, factors = Filleted(h, r), (fillet.bending_factor, fillet.axial_factor)
    peak = tuple(float(factor(**at)) for factor in factors)
    material = Isotropic(1.0, 0.5 / (1.0 + nu))
    ends = (0.0, 0.0, 0.0), (l, 0.0, 0.0)
    return SpaceBlade("h", "ground", "body", *ends, (0.0, 0.0, 1.0), profile, b, material, peak)


def largest(blade, forces):
    """Return the largest stress under V_z, T and M_y at the middle."""
    rows, acting = stress_rows(blade, springs_of(blade)), np.zeros(9)
    acting[2:5] = forces
    return float(equivalent(rows.normal @ acting, rows.shear @ acting).max())


def test_the_stress_of_forces_across_a_hinge_lies_within_its_error_of_solids():
    for *shape, _, loads in SOLIDS:
        blade = hinge(*shape)
        low, high = hinge_error(blade)
        for *forces, found in loads:
            assert low < found / largest(blade, forces) - 1.0 < high


def test_a_margin_of_two_is_within_what_is_told_of_a_notch():
    # the width of the error: a stress half as large as it may be passes, twice as large fails
    low, high = hinge_error(hinge("notch", [0.1, 1.0], 2.0, 1.0, 0.3))
    assert -0.5 < low < 0.0 < high < 0.5


@pytest.mark.parametrize(
    ("kind", "numbers", "l", "b", "nu"),
    [
        ("notch", [1.2, 1.0], 2.0, 2.0, 0.3),
        ("notch", [0.5, 0.1], 2.0, 2.0, 0.3),
        ("notch", [0.1, 1.0], 2.0, 0.05, 0.3),
        ("notch", [0.1, 1.0], 2.0, 17.0, 0.3),
        ("filleted", [4.2, 1.0], 60.0, 9.0, 0.3),
        ("filleted", [0.2, 1.0], 10.0, 3.0, 0.49),
    ],
)
def test_nothing_is_told_of_hinges_that_no_solid_was_made_of(kind, numbers, l, b, nu):
    assert hinge_error(hinge(kind, numbers, l, b, nu)) is None


@pytest.mark.parametrize(
    ("e", "depth", "b", "nu"),
    [(0.05, 1.0, 0.1, 0.3), (0.01, 1.0, 0.6, 0.45), (0.1, 0.1, 1.0, 0.3), (0.3, 1.0, 1.0, 0.2)],
)
def test_the_stress_of_all_forces_lies_between_what_each_kind_leaves_of_its_part(e, depth, b, nu):
    blade = hinge("notch", [e, depth], 2.0, b, nu)
    rows, random = stress_rows(blade, springs_of(blade)), np.random.default_rng(0)
    one = equivalent(rows.normal, rows.shear).max(axis=0)[:6]
    loads = np.concatenate([np.eye(6), random.normal(size=(40, 6))]) / one
    loads[6:16, 2:5] = loads[16:22, 2:4] = 0.0
    solid = NeckUnderLoads(Neck(e, depth, 2.0, b, 0.0, 1.0), 1.0, nu)
    stress, _ = solid.stresses(loads, COARSE)
    for load, found in zip(loads, along_or_mises(stress), strict=True):
        low, high = hinge_range(blade, rows, np.concatenate([load, np.zeros(3)]))
        assert low < np.abs(found).max() < high


def test_forces_in_the_plane_of_a_notch_and_a_moment_about_its_thickness_are_known_well():
    blade = hinge("notch", [0.05, 1.0], 2.0, 0.1, 0.3)
    rows, forces = (
        stress_rows(blade, springs_of(blade)),
        np.array([1.0, 0, 0, 0, 0.03, 0.01] + 3 * [0]),
    )
    told = equivalent(rows.normal @ forces, rows.shear @ forces).max()
    low, high = np.array(hinge_range(blade, rows, forces)) / told
    assert 0.9 < low < high < 1.12
    across = np.eye(9)[2]
    low, high = np.array(hinge_range(blade, rows, across)) / largest(blade, [1.0, 0.0, 0.0])
    assert (low, high) == pytest.approx(1.0 + np.array(hinge_error(blade)))
