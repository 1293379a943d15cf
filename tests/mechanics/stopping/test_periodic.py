"""Periodic motions between stops: exact without contact, known with it, stable as they are told."""

from math import cos, exp, hypot, inf, pi, sin, sqrt, tan

import numpy as np
import pytest
from oscillators import oscillator, steady_steps, stepped

from flexcli.mechanics.stopping.laws import LinearStop, RigidStop, Stops
from flexcli.mechanics.stopping.periodic import DrivenBlade, MotionPoint
from flexcli.mechanics.stopping.response import stepped_motion

AT_REST = MotionPoint(np.zeros(1), np.zeros(1))
CLOSED = 1e-9
"""What a motion misses its start by, over how slowly disturbances of it die."""


@pytest.mark.parametrize("q", [0.6, 30.0, 1e4])
@pytest.mark.parametrize("ratio", [0.5, 1.0, 1.0003, 2.0])
def test_newton_from_rest_lands_on_the_steady_state_whatever_the_damping(q, ratio):
    driven = DrivenBlade(oscillator(damping=0.5 / q), Stops(LinearStop(10.0), 1e6, 1e6), 1.0)
    found = driven.periodic(ratio, AT_REST)
    exact = 1.0 / hypot(1.0 - ratio**2, ratio / q)
    assert driven.peaks(found).travel == pytest.approx(exact, rel=1e-6)
    assert driven.linear(ratio).tip == pytest.approx(exact, rel=1e-12)
    assert found.largest == pytest.approx(exp(-pi / q / ratio), rel=1e-6)


@pytest.mark.parametrize("ratio", [1.0, 1.2])
def test_over_a_period_the_base_does_what_damping_takes(ratio):
    stops = Stops(LinearStop(100.0), 1.0, 1.0)
    motion = stepped_motion(oscillator(damping=0.01), stops, 0.2)
    motion.point.rate[0] = 3.0
    motion.follow(ratio)
    driven, found = motion.driven, motion.motion
    assert found.contacts == 2
    spent = driven.run(found.angular, found.start, 1).result().balance
    assert spent.base_work == pytest.approx(spent.damped, rel=1e-7)
    # without dashpot the stops take nothing, and det of the map is exp(−2ζ ω_0 T)
    product = float(np.prod(found.multipliers).real)
    assert product == pytest.approx(exp(-0.02 * 2.0 * pi / ratio), rel=1e-5)


@pytest.mark.parametrize("e", [0.4, 0.7, 0.9])
@pytest.mark.parametrize("omega", [1.6, 1.7])
def test_one_impact_a_period_is_the_closed_form(e, omega):
    """Undamped mass on a spring, rigid stop at g, x'' + x = −A sin(ωt): flight between impacts.

    ``(g + v(1 + e)/(2 tan(T/2)))² + (v(1 − e)/(2ω))² = Γ²`` for the approach speed v, from the
    free motion that starts with −e v and ends with v after T = 2π/ω (Peterka; Shaw & Holmes 1983).
    """
    A, g = 1.0, 0.3
    T, forced = 2.0 * pi / omega, -A / (1.0 - omega**2)
    t = tan(T / 2.0)
    p, r = (1.0 + e) / (2.0 * t), (1.0 - e) / (2.0 * omega)
    a, b, c = p**2 + r**2, 2.0 * g * p, g**2 - forced**2
    v = (-b + sqrt(b**2 - 4.0 * a * c)) / (2.0 * a)
    phase = np.arctan2((g + v * p) / forced, v * r / forced)
    # away from the stop, half a period after an impact
    begin, rate = g - forced * sin(phase), -e * v - forced * omega * cos(phase)
    h = T / 2.0
    q = begin * cos(h) + rate * sin(h) + forced * sin(omega * h + phase)
    w = -begin * sin(h) + rate * cos(h) + forced * omega * cos(omega * h + phase)
    driven = DrivenBlade(oscillator(), Stops(RigidStop(e), g, inf), A)
    start = MotionPoint(np.array([q]), np.array([w]), phase + pi)
    found = driven.periodic(omega, start)
    assert found.contacts == 1
    assert found.start.q[0] == pytest.approx(q, abs=CLOSED)
    run = driven.run(omega, found.start, 1).result()
    assert run.contacts.speed[0] == pytest.approx(v, rel=CLOSED)
    # an impact shrinks areas of the phase plane by e²
    assert float(np.prod(found.multipliers).real) == pytest.approx(e**2, rel=1e-5)


@pytest.mark.parametrize(("kick", "touches"), [(0.0, False), (3.0, True)])
def test_both_branches_are_those_of_a_long_run(kick, touches):
    driven = DrivenBlade(oscillator(damping=0.01), Stops(LinearStop(100.0), 1.0, 1.0), 0.2)
    (step,) = steady_steps(driven.blade, driven.stops, angular=[1.2], amplitude=0.2, kick=kick)
    engine = driven.run(1.2, MotionPoint(np.zeros(1), np.array([kick])), 600)
    engine.take_peaks()
    end = MotionPoint(*engine.state)
    long = driven.run(1.2, end, 10).take_peaks()
    assert step.settled
    assert (step.contacts > 0.0) is touches
    # exp(−ζ ω_0 600 T) is 2e-14
    assert step.peaks.travel == pytest.approx(long.travel, rel=1e-8)


def test_a_motion_of_two_periods_is_found_as_one():
    scene = oscillator(damping=0.01), Stops(LinearStop(1e3), 0.05, inf)
    (step,) = steady_steps(*scene, angular=[3.1], amplitude=0.5)
    assert step.settled
    assert (step.periods, step.contacts) == (2, 0.5)


@pytest.mark.slow
def test_what_never_repeats_is_not_settled_and_has_a_range():
    # without damping a beat goes on for ever, and no motion is stable
    scene = oscillator(), Stops(LinearStop(20.0), 1.0, 1.0)
    (step,) = steady_steps(*scene, angular=[sqrt(2.0)], amplitude=0.1, kick=2.0)
    assert not step.settled
    assert step.multiplier is None
    assert step.least < step.peaks.travel


@pytest.mark.slow
def test_contact_ends_where_no_periodic_motion_goes_on():
    """Beyond the fold a run from the last motion falls back to the one without contact."""
    scene = oscillator(damping=0.05), Stops(LinearStop(100.0), 1.0, 1.0)
    angular = np.linspace(0.9, 2.5, 33)
    steps, travel = stepped(*scene, angular=angular, amplitude=0.2)
    last = int(np.flatnonzero([step.contacts for step in steps])[-1])
    assert all(step.settled for step in steps)
    exact = 0.2 / np.hypot(1.0 - angular**2, 0.1 * angular)
    np.testing.assert_allclose(travel[last + 1 :], exact[last + 1 :], rtol=1e-12)
    assert travel[last] > 3.0 * exact[last]
