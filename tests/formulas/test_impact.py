"""Impact of a ball: the source's numbers, Hertz' law against its own equation of motion."""

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from flexcli.formulas.contact import point_contact
from flexcli.formulas.handbook.impact import hertz_impact, reduced_mass, stopping_estimate
from flexcli.formulas.stop_stiffness import bent_shape

BALL = {"m": 1e-3, "v": 1.0, "R": 1e-3}
masses = st.floats(1e-6, 1.0)
speeds = st.floats(1e-3, 10.0)
radii = st.floats(1e-4, 0.1)
moduli = st.floats(1e9, 1e12)


# -- the source, section 3.1.3 -----------------------------------------------------------------


def test_estimate_gives_the_printed_time_and_force():
    # t = 0.0136 ms; the force is printed 73 N from −73000 m/s², cut off, not rounded
    found = stopping_estimate(E=70e9, **BALL)
    assert found.stopping_time == pytest.approx(13.6e-6, abs=0.05e-6)
    assert int(found.force) == 73


def test_estimate_solves_the_equation_of_the_source():
    # equation (VI) with dv/dt = −v/t
    found = stopping_estimate(E=70e9, **BALL)
    t, a = found.stopping_time, 1.0 / found.stopping_time
    approach = 0.5 * (1 / 1e-3) ** (1 / 3) * (3 * 1e-3 * a / (2 * 70e9)) ** (2 / 3)
    assert 1.0 * t - a * t**2 / 2 == pytest.approx(approach, rel=1e-12)


def test_two_thirds_of_the_speed_is_less_force_than_printed():
    # printed 48 N is two thirds of 73 N at the same time; the estimate's own time grows
    slow = stopping_estimate(E=70e9, **{**BALL, "v": 2 / 3}).force
    assert slow / stopping_estimate(E=70e9, **BALL).force == pytest.approx((2 / 3) ** 1.2)
    assert slow == pytest.approx(45.3, abs=0.05)


def test_moving_the_stop_a_third_down_takes_half_the_speed_not_seven_tenths():
    # printed "reduced by over 70%" is 1 − (2/3)³; the shape of the blade gives 48 %
    by_cube, by_shape = 1 - (2 / 3) ** 3, 1 - bent_shape(2 / 3)
    assert by_cube == pytest.approx(0.70, abs=0.005)
    assert by_shape == pytest.approx(0.48, abs=0.005)


@given(masses, speeds, radii, moduli)
def test_estimate_keeps_its_ratio_to_hertz(m, v, R, E):
    exact = hertz_impact(m=m, v=v, R=R, E_star=E)
    rough = stopping_estimate(m=m, v=v, R=R, E=E)
    assert exact.force / rough.force == pytest.approx(1.51, abs=0.005)
    assert exact.stopping_time / rough.stopping_time == pytest.approx(1.22, abs=0.005)


# -- Hertz -------------------------------------------------------------------------------------


@pytest.mark.parametrize("v", [0.01, 1.0, 5.0])
def test_hertz_impact_is_the_solution_of_its_equation_of_motion(v):
    m, R, E_star = 2e-3, 3e-3, 40e9
    found = hertz_impact(m=m, v=v, R=R, E_star=E_star)
    K = 4 / 3 * E_star * R**0.5

    # time in units of approach over speed, so that the tolerance is relative
    def motion(t, y):
        x, rate = y
        force = K * max(x * found.approach, 0.0) ** 1.5
        return [rate, -force / m * found.approach / v**2]

    def rest(t, y):
        return y[1]

    rest.terminal = True
    run = solve_ivp(motion, (0, 10), [0, 1], events=rest, rtol=1e-11, atol=1e-12, method="DOP853")
    assert run.y_events[0][0][0] == pytest.approx(1.0, rel=1e-8)
    time = run.t_events[0][0] * found.approach / v
    assert found.stopping_time == pytest.approx(time, rel=1e-7)
    assert found.duration == pytest.approx(2 * time, rel=1e-7)


@given(masses, speeds, radii, moduli)
def test_kinetic_energy_is_all_in_the_contact_at_rest(m, v, R, E_star):
    found = hertz_impact(m=m, v=v, R=R, E_star=E_star)
    assert 0.4 * found.force * found.approach == pytest.approx(m * v**2 / 2, rel=1e-12)
    static = point_contact(F=found.force, R=R, E_star=E_star)
    assert static.approach == pytest.approx(found.approach, rel=1e-12)


def test_duration_has_the_known_factor():
    # Johnson (1985), equation (11.24): T = 2.87 (m²/(R E*² v))^(1/5)
    found = hertz_impact(m=1.0, v=1.0, R=1.0, E_star=1.0)
    assert found.duration == pytest.approx(2.87, abs=0.005)
    assert found.duration / found.approach == pytest.approx(2.9432, abs=0.0002)


def test_one_gram_is_no_aluminium_ball_of_one_millimetre():
    # section 3.1.3: 2700 kg/m³ makes 11 mg of it
    assert 2700 * 4 / 3 * pi * 1e-9 == pytest.approx(11.3e-6, abs=0.05e-6)


def test_bodies_of_equal_mass_meet_with_half_of_it():
    assert reduced_mass(4.0, 4.0) == 2.0
    assert reduced_mass(4.0, np.inf) == 4.0


def test_arrays_equal_elements():
    v = np.array([0.1, 1.0, 10.0])
    together = np.array(hertz_impact(m=1e-3, v=v, R=1e-3, E_star=70e9))
    single = np.array([hertz_impact(m=1e-3, v=s, R=1e-3, E_star=70e9) for s in v]).T
    assert together == pytest.approx(single, rel=1e-14)
