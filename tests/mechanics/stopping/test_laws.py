from math import gamma, inf, pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from oscillators import oscillator, quiet

from flexcli.mechanics.stopping.cantilever_modes import cantilever_modes
from flexcli.mechanics.stopping.laws import (
    HertzStop,
    LinearStop,
    RigidStop,
    Stops,
    damped_stop_restitution,
    damping_ratio,
    stiffness_on_blade,
)
from flexcli.mechanics.stopping.vibration import simulate

SLOW = 1e-4
"""Frequency of the blade against that of the stop: its own spring adds some 1e-7."""

HERTZ = 1e-8
"""Energy lost by the adaptive method in some ten contacts, as a share of all."""


@pytest.mark.parametrize("ratio", [0.01, 0.1, 0.5, 0.9])
def test_a_damped_stop_that_cannot_pull_gives_its_restitution(ratio):
    law = LinearStop(1.0, 2.0 * ratio)
    stops = Stops(law, above=0.0, below=inf)
    result = simulate(oscillator(angular=SLOW), stops, quiet(12.0), rate=[1.0])
    assert result.contacts.time.size == 1
    assert -result.rate[0] == pytest.approx(damped_stop_restitution(ratio), rel=1e-5)


@given(st.floats(0.14, 1.0))
def test_the_damping_for_a_restitution_gives_it(e):
    assert damped_stop_restitution(damping_ratio(e)) == pytest.approx(e, rel=1e-6)


def test_a_deader_bounce_than_critical_damping_gives_is_that_of_critical_damping():
    assert damped_stop_restitution(damping_ratio(0.05)) == pytest.approx(np.exp(-2), rel=1e-3)


def test_a_damped_head_is_met_again_where_it_is():
    # a stiff blade comes back long before the slow head (k/c = 0.1) has recovered
    stops = Stops(LinearStop(1.0, 10.0), above=0.0, below=0.1)
    result = simulate(oscillator(damping=0.0), stops, quiet(30.0), rate=[1.0], keep_history=True)
    above = result.contacts.side == 1
    again = np.interp(result.contacts.time[above][1], result.history.time, result.history.at_stop)
    assert again > 0.01
    assert abs(result.balance.energy_residual) < 1e-12


def test_a_ball_on_a_hertzian_stop_has_the_classic_force_and_time():
    k, v = 100.0, 1.0
    stops = Stops(HertzStop(k), above=0.0, below=inf)
    result = simulate(oscillator(angular=SLOW), stops, quiet(1.0), rate=[v])
    deepest = (5.0 * v**2 / (4.0 * k)) ** 0.4
    lasts = 4.0 * sqrt(pi) * gamma(0.4) / (5.0 * gamma(0.9)) * deepest / v
    assert result.contacts.duration[0] == pytest.approx(lasts, rel=1e-6)
    assert result.contacts.impulse[0] == pytest.approx(2.0 * v, rel=1e-6)
    assert result.peaks.force == pytest.approx(k * deepest**1.5, rel=1e-4)
    assert abs(result.balance.energy_residual) < 1e-9


def test_a_hertzian_stop_in_series_with_a_soft_mount_is_the_mount():
    hard = simulate(
        oscillator(),
        Stops(HertzStop(1e9, compliance=1.0 / 8.0), above=0.0, below=inf),
        quiet(20.0),
        rate=[1.0],
    )
    np.testing.assert_allclose(hard.contacts.duration[1:-1], pi / 3.0, rtol=1e-4)


@pytest.mark.parametrize("dissipation", [0.0, 0.5])
def test_hertzian_contact_keeps_the_balance(dissipation):
    stops = Stops(HertzStop(1e4, 1e-5, dissipation), above=0.5, below=0.7)
    result = simulate(oscillator(damping=0.01), stops, quiet(10.0, 3), rate=[2.0])
    assert result.contacts.time.size >= 5
    assert abs(result.balance.energy_residual) < HERTZ * result.balance.start
    assert result.balance.impulse_residual < HERTZ
    assert (result.balance.lost_at_stops > 0.01) == (dissipation > 0.0)


def test_the_slower_of_two_touches_on_a_hertzian_stop_lasts_longer():
    stops = Stops(HertzStop(1e4), above=0.5, below=inf)
    slow, fast = (simulate(oscillator(), stops, quiet(4.0), rate=[v]).contacts for v in (0.51, 2.0))
    assert slow.duration[0] > fast.duration[0] > 0.0


@given(st.floats(1.0, 1e9))
def test_stop_and_left_out_modes_give_together(stiffness):
    blade = cantilever_modes(E=60e9, I=1e-13, L=20e-3, L_a=12e-3, m=5e-3)
    met = stiffness_on_blade(blade, stiffness)
    assert met < min(stiffness, 1.0 / blade.stop_residual)
    assert 1.0 / met == pytest.approx(1.0 / stiffness + blade.stop_residual)


def test_a_rigid_stop_on_modes_without_residual_has_no_stiffness():
    with pytest.raises(ValueError, match="RigidStop"):
        stiffness_on_blade(oscillator(), inf)


@pytest.mark.parametrize("restitution", [-0.1, 1.1])
def test_a_restitution_that_makes_energy_is_refused(restitution):
    with pytest.raises(ValueError, match="restitution"):
        RigidStop(restitution)


@pytest.mark.parametrize("gaps", [(-1.0, 1.0), (0.0, 0.0)])
def test_gaps_without_room_are_refused(gaps):
    with pytest.raises(ValueError, match="gaps"):
        Stops(RigidStop(1.0), *gaps)
