"""Bending of a stopped cantilever: it keeps to its stop, is in equilibrium, and keeps energy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.handbook.stop_numbers import deflection
from flexcli.formulas.stopped_cantilever import (
    bending_moment,
    bending_stress,
    contact_load,
    load_at_travel,
)

shares = st.floats(0.05, 0.95)
forces = st.floats(-10.0, 10.0)
gaps = st.floats(0.0, 1.0)


def blade(a, d, d_behind=np.inf):
    return {"E": 1.0, "I": 1.0, "L_a": a, "L_b": 1.0 - a, "d": d, "d_behind": d_behind}


def gauss(low, high):
    x, w = np.polynomial.legendre.leggauss(4)
    return low + (high - low) * (x + 1) / 2, w * (high - low) / 2


@given(shares, forces, gaps, gaps)
def test_blade_stays_between_its_stops_and_lies_on_one_in_contact(a, F, d, d_behind):
    at_stop = deflection(x=a, F=F, **blade(a, d, d_behind))
    free = deflection(x=a, F=F, **blade(a, np.inf))
    assert at_stop == pytest.approx(np.clip(free, -d_behind, d), abs=1e-10)


@given(shares, forces, gaps, st.floats(0.05, 1.0))
def test_deflection_is_the_moment_integrated_twice(a, F, d, x):
    # unit load at x: δ(x) = ∫ M (x − s) ds over 0..x, in pieces smooth up to the stop
    total = 0.0
    for low, high in ((0.0, min(a, x)), (min(a, x), x)):
        s, w = gauss(low, high)
        total += np.sum(w * bending_moment(x=s, F=F, **blade(a, d)) * (x - s))
    assert deflection(x=x, F=F, **blade(a, d)) == pytest.approx(total, abs=1e-11)


@given(shares, st.floats(0.1, 10.0), gaps)
def test_work_of_the_tip_force_is_the_strain_energy(a, F, d):
    # the rigid stop does no work; F over δ is a line with one corner, at contact
    beam = blade(a, d)
    corner = min(F, float(contact_load(E=1.0, I=1.0, L_a=a, L_b=1.0 - a, d=d)))
    at = [deflection(x=1.0, F=f, **beam) for f in (0.0, corner, F)]
    work = corner * at[1] / 2 + (corner + F) / 2 * (at[2] - at[1])
    energy = 0.0
    for low, high in ((0.0, a), (a, 1.0)):
        s, w = gauss(low, high)
        energy += np.sum(w * bending_moment(x=s, F=F, **beam) ** 2) / 2
    assert work == pytest.approx(energy, rel=1e-9)


@given(shares, st.floats(-2.0, 2.0), gaps, gaps)
def test_tip_is_where_the_load_at_travel_holds_it(a, delta, d, d_behind):
    beam = blade(a, d, d_behind)
    F = load_at_travel(delta=delta, **beam)
    assert deflection(x=1.0, F=F, **beam) == pytest.approx(delta, abs=1e-10)


@given(shares, forces, gaps)
def test_moments_at_base_and_stop_are_the_ones_of_chapter_9(a, F, d):
    beam = blade(a, d)
    first = min(F, float(contact_load(E=1.0, I=1.0, L_a=a, L_b=1.0 - a, d=d)))
    base, stop = (bending_moment(x=x, F=F, **beam) for x in (0.0, a))
    assert base == pytest.approx(first - (F - first) * (1.0 - a) / 2, abs=1e-12)
    assert stop == pytest.approx(F * (1.0 - a), abs=1e-12)


@given(shares, forces)
def test_moment_under_the_same_force_is_never_above_that_of_the_free_base(a, F):
    # section 9.1.2 is right for a given force
    s = np.linspace(0.0, 1.0, 33)
    stopped = np.abs(bending_moment(x=s, F=F, **blade(a, 0.0)))
    assert stopped.max() <= abs(F) * (1 + 1e-12)


def test_moment_for_the_same_travel_can_exceed_that_of_the_free_base():
    # section 9.1.2 is wrong for a given travel of the tip, which is what a resonance brings
    beam = {"E": 60e9, "I": 1.2695e-12, "L_a": 25.65e-3, "L_b": 2.85e-3, "d": 87.3e-6}
    stopped = load_at_travel(delta=200e-6, **beam)
    free = load_at_travel(delta=200e-6, **{**beam, "d": np.inf})
    at_stop = bending_moment(x=25.65e-3, F=stopped, **beam)
    assert at_stop > 6.0 * bending_moment(x=0.0, F=free, **{**beam, "d": np.inf})


def test_stress_of_the_piezo_bender_is_half_its_strength():
    # Monti (2014), section 9.1.1: 56.3 N·mm is 27.7 MPa, with I of 7.8 mm by 1.25 mm
    I = 7.8e-3 * 1.25e-3**3 / 12
    assert bending_stress(M=56.3e-3, I=I, h=1.25e-3) == pytest.approx(55.4e6 / 2, abs=0.05e6)


def test_an_array_gives_what_its_elements_give():
    x, F = np.linspace(0.0, 1.0, 5)[:, None], np.array([-3.0, 0.0, 4.0])
    beam = blade(0.4, 0.1, 0.2)
    for function in (deflection, bending_moment):
        single = [[function(x=s, F=f, **beam) for f in F] for s in x[:, 0]]
        assert function(x=x, F=F, **beam) == pytest.approx(np.array(single), abs=1e-15)
