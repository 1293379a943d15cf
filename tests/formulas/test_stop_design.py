"""Stops on the operating line: chapter 9 of the thesis to its printed digits, and where it errs."""

from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.contact import point_contact
from flexcli.formulas.handbook.stop_numbers import deflection, stop_design
from flexcli.formulas.stop_line import HARD_STOP, REACHED

# Monti (2014), section 9.1: b = 7.8 mm and h = 1.25 mm are found from the printed stresses
L, THICKNESS = 28.5e-3, 1.25e-3
BEAM = {"E": 60e9, "I": 7.8e-3 * THICKNESS**3 / 12, "h": THICKNESS}
STRENGTH = 55.4e6


def design(a, delta_O=200e-6):
    return stop_design(L_a=a * L, L_b=L - a * L, delta_O=delta_O, **BEAM)


# -- section 9.1.3: the highest stop -----------------------------------------------------------


def test_highest_stop_has_the_printed_ratio_gap_and_tip_deflection():
    # π1 = 129, π5 = 2.29, δ_G = 87.3 µm (from the rounded π5), 102 µm at contact (cut off)
    highest = design(HARD_STOP)
    assert highest.pi_1 == pytest.approx(129.0, abs=0.5)
    assert highest.pi_5 == pytest.approx(2.29, abs=0.005)
    assert highest.gap == pytest.approx(87.3e-6, rel=0.001)
    assert int(highest.tip_at_contact * 1e6) == 102
    assert highest.hard


def test_inertial_force_is_the_printed_one_at_ten_times_the_printed_deceleration():
    # f = 176 Hz with k_f = 9.87 N/mm; V = 0.11 m/s, Δt = 5.7 ms/6, F = 0.94 N; a is printed
    # −12 m/s², which would make 0.10 N
    m = 9871.0 / (2 * pi * 176.0) ** 2
    v = 200e-6 / 2 * sqrt(9871.0 / m)
    deceleration = v / (1.0 / 176.0 / 6.0)
    assert v == pytest.approx(0.11, abs=0.005)
    assert deceleration == pytest.approx(117.0, abs=0.5)
    assert m * deceleration == pytest.approx(0.94, abs=0.005)


def test_contact_stress_of_the_printed_force_has_the_factor_the_source_denies():
    # τ = 26.6 MPa is below 27.7 MPa, half the strength: the text says above
    shear = point_contact(F=0.94 + 1.94, R=50e-3, E_star=53.2e9).shear
    assert shear == pytest.approx(26.6e6, abs=0.05e6)
    assert shear < STRENGTH / 2


def test_highest_stop_is_not_even_reached_within_its_range():
    highest = design(HARD_STOP)
    assert not highest.reached
    assert highest.stop_force == 0.0
    assert REACHED.most < HARD_STOP


# -- section 9.1.2: stress at the stop ---------------------------------------------------------


def test_stress_at_the_stop_can_exceed_that_of_the_free_base():
    # "the bending stress at the contact point can never exceed the bending stress found in the
    # original cantilever beam": with 200 µm to each side it does, at heights the line offers
    each_side = design(np.array([0.7, 0.8]), delta_O=400e-6)
    assert each_side.reached.all()
    assert (each_side.stop_stress > STRENGTH / 2).all()
    assert (each_side.factor(STRENGTH) < 2.0).all()


def test_stress_keeps_its_factor_when_the_limit_is_taken_as_the_whole_range():
    within = design(np.linspace(REACHED.least, REACHED.most, 50))
    assert within.factor(STRENGTH).min() > 2.9


# -- independent routes ------------------------------------------------------------------------


@given(st.floats(0.51, 0.89), st.floats(1e-6, 1e-3))
def test_tip_ends_at_half_the_range_and_the_blade_on_its_stop(a, delta_O):
    found = design(a, delta_O)
    beam = {"E": BEAM["E"], "I": BEAM["I"], "L_a": a * L, "L_b": L - a * L, "d": found.gap}
    assert found.reached
    assert found.stop_force > 0.0
    assert deflection(x=L, F=found.load, **beam) == pytest.approx(delta_O / 2, rel=1e-9)
    assert deflection(x=a * L, F=found.load, **beam) == pytest.approx(found.gap, rel=1e-9)


@given(st.floats(0.1, 0.99), st.floats(1.0, 10.0))
def test_forces_and_stresses_grow_with_the_range(a, factor):
    here, there = design(a), design(a, 200e-6 * factor)
    for name in ("gap", "load", "onset_stress", "stop_stress"):
        assert getattr(there, name) == pytest.approx(factor * getattr(here, name), rel=1e-9)


@given(st.floats(0.1, 0.99))
def test_factor_is_that_of_the_greatest_stress_on_the_way(a):
    found = design(a)
    stresses = (found.onset_stress, abs(found.base_stress), found.stop_stress)
    assert found.factor(STRENGTH) == pytest.approx(STRENGTH / max(stresses), rel=1e-12)


def test_arrays_equal_elements():
    shares = np.array([0.3, 0.6, 0.9])
    together = design(shares)
    for i, share in enumerate(shares):
        single = design(share)
        for name in vars(single):
            assert getattr(together, name)[i] == pytest.approx(getattr(single, name), rel=1e-14)
