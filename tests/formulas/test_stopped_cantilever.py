"""Statics of a cantilever with stops against the contact problem of a beam of two elements."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.stop_stiffness import bent_shape, contact_stiffness, free_stiffness
from flexcli.formulas.stopped_cantilever import (
    contact_load,
    excess_load,
    load_at_travel,
    reaction,
)

shares = st.floats(0.05, 0.95)
forces = st.floats(-10.0, 10.0)
gaps = st.floats(0.0, 1.0)


def blade(a, d, d_behind=np.inf):
    return {"E": 1.0, "I": 1.0, "L_a": a, "L_b": 1.0 - a, "d": d, "d_behind": d_behind}


def compliances(a):
    """Give deflection at the stop and the tip for unit forces there, by the unit-load integral."""
    x, w = np.polynomial.legendre.leggauss(4)
    low, high = a * (x + 1) / 2, a + (1 - a) * (x + 1) / 2
    at, weight = np.concatenate([low, high]), np.concatenate([w * a / 2, w * (1 - a) / 2])
    by_stop, by_tip = np.maximum(a - at, 0.0), 1.0 - at
    return [[np.sum(weight * p * q) for q in (by_stop, by_tip)] for p in (by_stop, by_tip)]


@given(shares, forces, gaps, gaps)
def test_reaction_solves_the_contact_problem(a, F, d, d_behind):
    (stop_stop, stop_tip), _ = compliances(a)
    free = F * stop_tip
    held = np.clip(free, -d_behind, d)  # what the stops leave of the deflection there
    expected = (held - free) / stop_stop
    found = reaction(F=F, **blade(a, d, d_behind))
    assert found == pytest.approx(expected, abs=1e-10 * (1 + abs(expected)))


@given(shares, forces, gaps)
def test_stop_pushes_and_only_against_the_load(a, F, d):
    found = reaction(F=F, **blade(a, d))
    assert found <= 0.0
    touching = contact_load(E=1.0, I=1.0, L_a=a, L_b=1.0 - a, d=d)
    assert (found < 0.0) == (touching < F)


@given(shares, st.floats(-2.0, 2.0), gaps, gaps)
def test_load_at_travel_returns_to_the_travel(a, delta, d, d_behind):
    (_, tip_stop), (_, tip_tip) = compliances(a)
    sides = blade(a, d, d_behind)
    F = load_at_travel(delta=delta, **sides)
    back = F * tip_tip + reaction(F=F, **sides) * tip_stop
    assert back == pytest.approx(delta, abs=1e-10)


@given(shares, st.floats(1e-3, 1.0))
def test_stiffness_changes_from_free_to_contact_at_the_gap(a, d):
    side, step = blade(a, d), 1e-3
    touch = d / bent_shape(a)
    loads = load_at_travel(delta=touch * (1.0 + step * np.array([-1.0, 0.0, 1.0])), **side)
    before, after = np.diff(loads) / (touch * step)
    assert before == pytest.approx(free_stiffness(E=1.0, I=1.0, L=1.0), rel=1e-9)
    stiff = contact_stiffness(E=1.0, I=1.0, L_a=a, L_b=1.0 - a)
    assert after == pytest.approx(stiff, rel=1e-9)


@given(shares, forces, gaps, gaps)
def test_mirrored_blade_has_the_mirrored_excess(a, F, d, d_behind):
    here = excess_load(F=F, **blade(a, d, d_behind))
    assert excess_load(F=-F, **blade(a, d_behind, d)) == -here


def test_a_blade_without_stops_is_free():
    assert excess_load(F=np.array([-1e9, 1e9]), **blade(0.5, np.inf)).tolist() == [0.0, 0.0]
    assert load_at_travel(delta=1.0, **blade(0.5, np.inf)) == pytest.approx(3.0)


def test_an_array_gives_what_its_elements_give():
    F = np.linspace(-3.0, 3.0, 7)[:, None]
    d = np.array([0.0, 0.2, np.inf])
    together = reaction(F=F, **blade(0.4, d, 0.1))
    single = np.array([[reaction(F=f, **blade(0.4, g, 0.1)) for g in d] for f in F[:, 0]])
    assert together == pytest.approx(single, abs=1e-15)


@pytest.mark.parametrize("gap", [{"d": -1e-6}, {"d": 1.0, "d_behind": -1.0}, {"d": np.nan}])
def test_a_start_inside_the_stop_is_refused(gap):
    with pytest.raises(ValueError, match="inside its stop"):
        excess_load(F=1.0, E=1.0, I=1.0, L_a=0.5, L_b=0.5, **gap)
