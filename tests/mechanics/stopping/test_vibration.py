from math import acos, asin, atan2, exp, inf, pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oscillators import oscillator, polynomial, quiet
from scipy.integrate import solve_ivp

from flexcli.errors import Outcome, SolveError
from flexcli.mechanics.stopping import vibration
from flexcli.mechanics.stopping.cantilever_modes import cantilever_modes
from flexcli.mechanics.stopping.laws import HertzStop, LinearStop, RigidStop, Stops
from flexcli.mechanics.stopping.vibration import StoppedVibration, simulate
from flexcli.numerics.signal_pieces import Samples, sine

BALANCE = 1e-11
"""Energy and momentum unaccounted for, as a share of what moved: rounding of some 1e3 events."""
CHATTER = 1e-9
"""The bounces left out are some 1e-9 high and 1e-4 long: the load changes over them by no more."""
LAWS = (RigidStop(1.0), RigidStop(0.6), LinearStop(80.0), LinearStop(80.0, 3.0))


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [10.0, 1e3, 1e6])
def test_energy_is_kept_over_a_thousand_cycles_without_damping(ratio):
    stops = Stops(LinearStop(ratio - 1.0), above=1.0, below=1.0)
    # the times free and against a spring, whose rest lies 1/ratio before the touch
    speed, stiff = sqrt(1.1**2 - 1.0), sqrt(ratio)
    period = 4.0 * (asin(1 / 1.1) + atan2(speed / stiff, 1 / ratio) / stiff)
    result = simulate(oscillator(), stops, quiet(1000 * period, 1000), rate=[1.1])
    assert result.contacts.time.size == 2000
    assert abs(result.balance.energy_residual) < 1e-9 * result.balance.start
    # and the last contact comes when the closed form says
    last = 999 * period + period / 2 + asin(1 / 1.1)
    assert result.contacts.time[-1] == pytest.approx(last, rel=1e-9)
    assert result.contacts.speed[-1] == pytest.approx(speed, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [1e3, 1e6])
def test_energy_of_three_modes_is_kept_against_a_stiff_stop(ratio):
    blade = cantilever_modes(
        E=60e9, I=1e-13, L=20e-3, L_a=12e-3, m=5e-3, blade_mass=5e-4, modes=3
    ).truncated()
    # the spring against that of the blade at the stop's height
    law = LinearStop(ratio * blade.angular[0] ** 2 / blade.stop[0] ** 2)
    stops = Stops(law, above=5e-6, below=5e-6)
    rate = 2.0 * 5e-6 / blade.stop[0] * blade.angular[0] * np.array([1.0, 0.0, 0.0])
    period = 2 * pi / blade.angular[0]
    result = simulate(blade, stops, quiet(50 * period, 50), rate=rate)
    assert result.contacts.time.size > 200
    assert abs(result.balance.energy_residual) < 1e-10 * result.balance.start


def test_free_vibration_against_one_spring_at_rest_has_the_bilinear_period():
    result = simulate(
        oscillator(), Stops(LinearStop(8.0), above=0.0, below=inf), quiet(500.0, 50), rate=[1.0]
    )
    period = pi + pi / 3.0
    np.testing.assert_allclose(np.diff(result.contacts.time[1:]), period, rtol=1e-11)
    np.testing.assert_allclose(result.contacts.duration[1:-1], pi / 3.0, rtol=1e-11)


def test_a_rigid_stop_at_rest_doubles_the_frequency():
    stops = Stops(RigidStop(1.0), above=0.0, below=inf)
    result = simulate(oscillator(), stops, quiet(100.0, 7), rate=[-1.0])
    np.testing.assert_allclose(np.diff(result.contacts.time), pi, rtol=1e-12)
    np.testing.assert_allclose(result.contacts.impulse, 2.0, rtol=1e-12)


def test_rigid_stops_shorten_the_period_by_the_angle_cut_off():
    amplitude = 2.0
    stops = Stops(RigidStop(1.0), above=1.0, below=inf)
    result = simulate(oscillator(), stops, quiet(200.0, 11), rate=[amplitude])
    period = 2.0 * (pi - acos(1.0 / amplitude))
    np.testing.assert_allclose(np.diff(result.contacts.time), period, rtol=1e-12)


def test_chatter_under_a_constant_load_accumulates_at_the_analytic_time():
    # unit oscillator under a load g: x = 1 − u sin t + (g − 1)(1 − cos t) after leaving with u,
    # so that each bounce lasts 2 arctan(u/(g − 1)) and comes back with the speed it left with
    e, g = 0.5, 10.0
    stops = Stops(RigidStop(e), above=1.0, below=inf)
    result = simulate(oscillator(), stops, polynomial([-g], 3.0))
    fall, speed = acos(1.0 - 1.0 / g), sqrt(2.0 * g - 1.0)
    bounces = 2.0 * np.arctan(speed * e ** np.arange(1, 80) / (g - 1.0))
    expected = fall + np.concatenate([[0.0], np.cumsum(bounces)])
    count = result.contacts.time.size - 1
    assert 10 < count < 30
    np.testing.assert_allclose(result.contacts.time[:-1], expected[:count], rtol=CHATTER)
    assert result.contacts.time[-1] == pytest.approx(expected[-1], rel=CHATTER)
    # from there on it is held: all energy that the load gave is lost
    assert result.contacts.duration[-1] > 0.0
    assert result.balance.lost_at_stops == pytest.approx(g - 0.5, rel=1e-12)
    assert result.q[0] == pytest.approx(1.0, rel=1e-12)


def test_a_held_blade_leaves_when_the_load_no_longer_presses():
    # force = −a − ω² q with a = −10 + 2t: zero at t = 4.5
    stops = Stops(RigidStop(0.0), above=1.0, below=inf)
    result = simulate(oscillator(), stops, polynomial([-10.0, 2.0], 5.0))
    end = result.contacts.time + result.contacts.duration
    assert end[-1] == pytest.approx(4.5, rel=1e-12)
    assert result.peaks.force == pytest.approx(9.0 - 2.0 * result.contacts.time[-1], rel=1e-9)


def test_a_held_blade_of_several_modes_goes_on_moving_beyond_the_stop():
    blade = cantilever_modes(
        E=60e9, I=1e-13, L=20e-3, L_a=12e-3, m=5e-3, blade_mass=5e-4, modes=3, quality=50.0
    ).truncated()
    stops = Stops(RigidStop(0.0), above=5e-6, below=inf)
    result = simulate(blade, stops, polynomial([-100.0], 0.02), keep_history=True)
    assert result.contacts.duration.max() > 1e-3
    assert result.cost.events < 100
    assert abs(result.balance.energy_residual) < BALANCE * result.balance.base_work
    assert result.history.at_stop.max() < 5e-6 * (1 + 1e-9)
    # the tip swings on about the propped overhang's static deflection
    assert result.peaks.tip_above > 1.5 * 5e-6


@pytest.mark.parametrize("law", [RigidStop(1.0), RigidStop(0.5), LinearStop(1e6)])
@pytest.mark.parametrize("miss", [-1e-3, -1e-9, -1e-13, 0.0, 1e-13, 1e-9])
def test_grazing_neither_hangs_nor_changes_the_amplitude(law, miss):
    stops = Stops(law, above=1.0 + miss, below=1.0 + miss)
    result = simulate(oscillator(), stops, quiet(20 * pi, 10), rate=[1.0])
    assert result.outcome is Outcome.COMPLETE
    assert result.cost.events <= 100
    assert abs(result.balance.energy_residual) < 1e-12
    assert result.peaks.travel == pytest.approx(1.0, abs=1.1 * abs(miss) + 1e-12)


@pytest.mark.parametrize("law", [*LAWS, HertzStop(1e4)])
def test_a_start_inside_the_stop_is_a_named_error(law):
    with pytest.raises(SolveError, match="beyond the gaps") as caught:
        StoppedVibration(oscillator(), Stops(law, above=1.0, below=1.0), q=[1.1])
    assert caught.value.code == "start-inside-stop"


def test_a_rigid_stop_on_a_blade_with_residual_compliance_is_a_named_error():
    blade = cantilever_modes(E=60e9, I=1e-13, L=20e-3, L_a=12e-3, m=5e-3)
    with pytest.raises(SolveError) as caught:
        StoppedVibration(blade, Stops(RigidStop(0.5), above=1e-5, below=1e-5))
    assert caught.value.code == "rigid-stop-residual"


@pytest.mark.slow
@settings(max_examples=25, deadline=None)
@given(
    st.sampled_from(LAWS),
    st.floats(0.0, 0.1),
    st.floats(0.3, 3.0),
    st.floats(0.1, 3.0),
    st.floats(0.0, 2.0),
)
def test_energy_and_momentum_balance(law, damping, angular, amplitude, below):
    stops = Stops(law, above=0.7, below=below)
    result = simulate(
        oscillator(damping=damping),
        stops,
        sine(amplitude=amplitude, angular=angular, duration=60.0),
        rate=[0.3],
    )
    balance = result.balance
    moved = balance.start + abs(balance.base_work) + balance.damped + balance.lost_at_stops
    assert abs(balance.energy_residual) < BALANCE * moved
    assert balance.impulse_residual < BALANCE
    assert balance.damped >= 0.0
    assert balance.lost_at_stops >= -BALANCE * moved


@pytest.mark.parametrize("law", LAWS)
def test_a_mirrored_scene_gives_the_mirrored_answer(law):
    def run(sign):
        gaps = (0.7, 0.9) if sign > 0 else (0.9, 0.7)
        return simulate(
            oscillator(damping=0.02),
            Stops(law, *gaps),
            sine(amplitude=sign * 1.5, angular=1.2, duration=40.0),
        )

    one, other = run(1.0), run(-1.0)
    np.testing.assert_allclose(one.contacts.time, other.contacts.time, rtol=1e-9)
    np.testing.assert_array_equal(one.contacts.side, -other.contacts.side)
    assert one.peaks.tip_above == pytest.approx(other.peaks.tip_below, rel=1e-9)


@pytest.mark.parametrize("scale", [1e-9, 1e6])
def test_micrometres_and_metres_give_the_same_digits(scale):
    def run(size):
        return simulate(
            oscillator(damping=0.02),
            Stops(LinearStop(50.0, 1.0), 0.7 * size, 0.9 * size),
            sine(amplitude=1.5 * size, angular=1.2, duration=40.0),
        )

    one, other = run(1.0), run(scale)
    np.testing.assert_allclose(one.contacts.time, other.contacts.time, rtol=1e-9)
    assert other.peaks.travel == pytest.approx(scale * one.peaks.travel, rel=1e-9)


@pytest.mark.slow
def test_a_blade_of_three_modes_agrees_with_a_general_integrator():
    blade = cantilever_modes(
        E=60e9, I=1e-13, L=20e-3, L_a=12e-3, m=5e-3, blade_mass=5e-4, modes=3, quality=30.0
    )
    gap, A, w = 4e-6, 5.0, 1.05 * blade.angular[0]
    result = simulate(
        blade, Stops(LinearStop(), gap, gap), sine(amplitude=A, angular=w, duration=0.015)
    )

    def slope(t, x):
        q, v = x[:3], x[3:]
        u = blade.stop @ q
        push = (np.maximum(u - gap, 0.0) - np.maximum(-u - gap, 0.0)) / blade.stop_residual
        force = -blade.base * A * np.sin(w * t) - blade.stop * push
        return np.concatenate([v, force - blade.damper @ v - blade.stiffness @ q])

    duration = result.duration
    reference = solve_ivp(
        slope, (0, duration), np.zeros(6), "DOP853", rtol=1e-10, atol=1e-15, max_step=2e-5
    ).y[:, -1]
    assert result.contacts.time.size > 5
    # in metres at the tip, mode by mode; the integrator is off by the kinks of the penalty
    np.testing.assert_allclose(blade.tip * result.q, blade.tip * reference[:3], atol=1e-5 * gap)


def test_the_tip_at_a_steady_load_is_that_of_the_statics():
    E, I, L, L_a, m = 60e9, 1e-13, 20e-3, 12e-3, 5e-3
    blade = cantilever_modes(E=E, I=I, L=L, L_a=L_a, m=m, quality=3.0)
    gap, a = 5e-6, -100.0
    result = simulate(blade, Stops(LinearStop(), gap, inf), polynomial([a], 1.0))
    # chapter 4: F' brings the blade to the stop, the rest bends the propped overhang
    F = -m * a
    F_touch = gap * 6 * E * I / (L_a**2 * (3 * L - L_a))
    L_b = L - L_a
    stiffness = 12 * E * I / (L_b**2 * (3 * L_a + 4 * L_b))
    expected = F_touch * L**3 / (3 * E * I) + (F - F_touch) / stiffness
    reaction = (F - F_touch) * (3 * L - L_a) / (2 * L_a)
    push = result.peaks.force
    assert blade.tip[0] * result.q[0] == pytest.approx(expected, rel=1e-9)
    held = (blade.stop[0] * result.q[0] - gap) / blade.stop_residual
    assert held == pytest.approx(reaction, rel=1e-9)
    assert push > held


def test_what_was_done_before_an_interruption_is_kept():
    run = StoppedVibration(oscillator(), Stops(RigidStop(0.9), 1.0, 1.0), rate=[2.0])
    steps = run.run(quiet(100.0, 100))
    for progress in steps:
        if progress.time > 30.0:
            break
    result = run.result()
    assert result.outcome is Outcome.INTERRUPTED
    assert result.outcome.remedy
    assert result.duration == pytest.approx(31.0)
    assert result.contacts.time.size == progress.contacts > 10
    # and the run can go on
    for _ in run.run(quiet(10.0)):
        pass
    assert run.result().outcome is Outcome.COMPLETE
    assert run.result().duration == pytest.approx(41.0)


def test_contacts_without_end_are_an_outcome(monkeypatch):
    monkeypatch.setattr(vibration, "MOST_EVENTS", 50)
    stops = Stops(RigidStop(1.0), above=1.0, below=inf)
    result = simulate(oscillator(), stops, polynomial([-10.0], 1e3))
    assert result.outcome is Outcome.CHATTER
    assert "compliance" in result.outcome.remedy


def test_history_peaks_and_contacts_tell_the_same_story():
    result = simulate(
        oscillator(damping=0.01),
        Stops(LinearStop(200.0), 1.0, 1.0),
        sine(amplitude=1.0, angular=1.1, duration=60.0),
        keep_history=True,
    )
    history = result.history
    assert (np.diff(history.time) >= 0.0).all()
    assert history.tip.max() <= result.peaks.tip_above * (1 + 1e-12)
    assert history.tip.max() == pytest.approx(result.peaks.tip_above, rel=1e-2)
    touching = history.force > 1e-9
    assert (np.abs(history.at_stop[touching]) > 1.0 - 1e-9).all()
    assert result.peaks.force == pytest.approx(200.0 * (result.peaks.travel - 1.0), rel=1e-9)


def test_pieces_of_a_signal_can_be_cut_anywhere():
    stops = Stops(LinearStop(100.0, 2.0), 0.5, 0.5)
    values = [0.0, 2.0, -1.0, 1.5, -2.0, 0.5, 0.0]
    fine = np.interp(np.arange(0, 6.001, 0.1), np.arange(7), values)
    coarse = simulate(oscillator(damping=0.01), stops, Samples(np.array(values), 1.0).lines())
    cut = simulate(oscillator(damping=0.01), stops, Samples(fine, 0.1).lines())
    np.testing.assert_allclose(coarse.contacts.time, cut.contacts.time, rtol=1e-11)
    np.testing.assert_allclose(coarse.q, cut.q, rtol=1e-9)


SLUGGISH = 0.5
"""Damping (share of critical) that is felt in the press on a stop."""


def test_a_plastic_stop_holds_a_damped_blade_from_its_first_touch_under_a_load_that_presses():
    # at the stop it stands, where no damping acts: the stop bears the load less the spring
    load, gap = 1.5, 1.0
    stops = Stops(RigidStop(0.0), above=gap, below=inf)
    result = simulate(oscillator(damping=SLUGGISH), stops, polynomial([-load], 30.0))
    ((time,), (duration,)) = result.contacts.time, result.contacts.duration
    assert time + duration == pytest.approx(30.0, rel=1e-12)
    assert result.contacts.impulse[0] == pytest.approx(
        sqrt(2.0 * _energy_at(load, gap)) + (load - gap) * duration, rel=1e-9
    )


def _energy_at(load, gap):
    """Return the kinetic energy of a damped unit oscillator when it gets to the gap, by Runge."""

    def rates(_, y):
        return y[1], load - y[0] - 2.0 * SLUGGISH * y[1]

    def touch(_, y):
        return y[0] - gap

    touch.terminal = True
    found = solve_ivp(rates, (0.0, 30.0), (0.0, 0.0), events=touch, rtol=1e-12, atol=1e-13)
    return found.y_events[0][0][1] ** 2 / 2.0


def test_a_plastic_stop_lets_a_damped_blade_go_that_nothing_presses():
    # it stops, and the spring takes it back from rest at the gap, with decays of 1/2 and 2 per s
    gap = 1.0
    stops = Stops(RigidStop(0.0), above=gap, below=inf)
    result = simulate(oscillator(damping=1.25), stops, quiet(5.0), rate=[4.0])
    assert result.contacts.time.size == 1
    assert result.contacts.duration[0] == 0.0
    since = 5.0 - result.contacts.time[0]
    back = gap * (4.0 * exp(-since / 2.0) - exp(-2.0 * since)) / 3.0
    assert result.q[0] == pytest.approx(back, rel=1e-9)


@pytest.mark.parametrize("law", [LinearStop(50.0), LinearStop(50.0, 2.0), RigidStop(0.5)])
def test_flights_over_samples_end_where_line_after_line_does(law):
    blade, values = oscillator(damping=0.05), np.random.default_rng(2).normal(size=1201)
    whole = Samples(values, 0.3)
    at_once = simulate(blade, Stops(law, 2.0, inf), [whole])
    one_by_one = simulate(blade, Stops(law, 2.0, inf), whole.lines())
    assert at_once.contacts.time.size == one_by_one.contacts.time.size > 3
    np.testing.assert_allclose(at_once.q, one_by_one.q, rtol=1e-9)
    np.testing.assert_allclose(at_once.peaks, one_by_one.peaks, rtol=1e-9)
    np.testing.assert_allclose(
        at_once.contacts.impulse, one_by_one.contacts.impulse, rtol=1e-8, atol=1e-9
    )
    moved = at_once.balance.base_work
    assert abs(at_once.balance.energy_residual) < 1e-12 * moved
    assert at_once.balance.impulse_residual < 1e-12
