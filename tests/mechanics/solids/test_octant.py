"""Bricks of high order against closed forms of bars, and their order."""

import numpy as np
import pytest

from flexcli.formulas.torsion_section import torsion_constant
from flexcli.mechanics.solids import octant
from flexcli.mechanics.solids.lagrange import places_along
from flexcli.mechanics.solids.neck import Neck, neck_lattice
from flexcli.mechanics.solids.octant import Lattice, Octant

E, NU = 200e9, 0.3
X, Y, Z, THETA_X, THETA_Y, THETA_Z = range(6)
H, B = 1e-3, 2e-3


def bar(l, orders=(4, 4, 4), *, skewed=0.0):
    """Return a bar of H by B, its bricks skewed by a share of its thickness."""
    half = l / 2.0
    x = places_along(np.linspace(0.0, half, 1 + round(half / H)), orders[0])
    t = places_along(np.array([0.0, 1.0]), orders[1])
    z = places_along(np.array([0.0, 0.6, 1.0]), orders[2]) * B / 2.0
    lean = skewed * H * np.sin(2.0 * np.pi * x / half)
    return Lattice(x[:, None] + lean[:, None] * t, np.ones((x.size, 1)) * t * H / 2.0, z, orders)


def compliance(l, load, nu=NU, **how):
    return Octant(bar(l, **how), E, nu).moved(load).compliance


def rate(load, **how):
    """Return the compliance per length far from both ends."""
    return (compliance(12.0 * H, load, **how) - compliance(8.0 * H, load, **how)) / (4.0 * H)


def test_a_bar_that_does_not_narrow_is_stretched_evenly_by_skewed_bricks():
    lattice = bar(6.0 * H, (3, 3, 2), skewed=0.2)
    found = Octant(lattice, E, 0.0).moved(X)
    assert found.compliance == pytest.approx(6.0 * H / (E * B * H), rel=1e-9)
    assert found.stress[..., 0] == pytest.approx(np.full(lattice.shape, 1.0 / (B * H)), rel=1e-7)
    assert np.abs(found.stress[..., 1:]).max() < 1e-7 / (B * H)


@pytest.mark.parametrize(("load", "I"), [(THETA_Z, B * H**3 / 12.0), (THETA_Y, H * B**3 / 12.0)])
def test_a_bar_that_does_not_narrow_is_bent_as_a_beam(load, I):
    assert compliance(6.0 * H, load, nu=0.0) == pytest.approx(6.0 * H / (E * I), rel=1e-9)


@pytest.mark.parametrize(
    ("load", "stiffness"),
    [
        (X, E * B * H),
        (THETA_Y, E * H * B**3 / 12.0),
        (THETA_Z, E * B * H**3 / 12.0),
        (THETA_X, E / (2.0 + 2.0 * NU) * float(torsion_constant(H, B))),
    ],
)
def test_far_from_rigid_ends_a_bar_gives_way_as_saint_venant_says(load, stiffness):
    assert rate(load) == pytest.approx(1.0 / stiffness, rel=1e-4)


def test_a_bar_sheared_between_rigid_ends_is_timoshenkos():
    l, nu = 20.0 * H, 0.0
    beam = l**3 / (12.0 * E * B * H**3 / 12.0) + 1.2 * l / (E / 2.0 * B * H)
    assert compliance(l, Y, nu=nu) == pytest.approx(beam, rel=2e-3)


def test_the_largest_shear_of_a_twisted_bar_is_saint_venants():
    lattice = bar(12.0 * H, (4, 6, 6))
    found = Octant(lattice, E, NU).moved(THETA_X).stress
    # b = 2 h: T/(0.2459 b h²) in the middle of its wide sides
    assert np.abs(found[0, -1, 0, 4]) == pytest.approx(1.0 / (0.2459 * B * H**2), rel=2e-3)


def test_a_higher_order_is_nearer_to_the_finest():
    finest = compliance(4.0 * H, THETA_X, orders=(7, 7, 7))
    errors = [abs(compliance(4.0 * H, THETA_X, orders=(p, p, p)) / finest - 1) for p in (2, 3, 5)]
    assert errors[0] > 2.0 * errors[1] > 4.0 * errors[2]


def test_a_slender_body_keeps_digits_where_it_is_stretched_and_none_where_it_bends():
    e, b, l = 20e-6, 0.1e-3, 1.0
    found = Octant(neck_lattice(Neck(e, 1e-3, 2e-3, b, straight=l), (3, 5, 3)), E, NU).moved
    assert found(X) is not None
    assert found(X).compliance == pytest.approx(l / (E * e * b), rel=1e-3)
    assert found(THETA_Z) is None
    assert found(Y) is None


def test_loads_asked_for_together_are_those_asked_one_by_one_with_layers_found_once(monkeypatch):
    found = []
    layer = octant._Layer
    monkeypatch.setattr(octant, "_Layer", lambda *how: found.append(how[1]) or layer(*how))
    lattice = neck_lattice(Neck(0.2, 1.0, 2.0, 3.0, 0.5, 1.0), (2, 3, 2))
    both, each = Octant(lattice, E, NU), Octant(lattice, E, NU)
    both.solve(range(6))
    assert len(found) == lattice.layers
    for load in range(6):
        one, other = both.moved(load), each.moved(load)
        assert one.compliance == pytest.approx(other.compliance, rel=1e-12)
        assert one.stress == pytest.approx(other.stress, rel=1e-9, abs=1e-9 * one.stress.max())
