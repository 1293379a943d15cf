"""Stops where stepping in time breaks: stiffness 1e6, grazing, chatter, a start inside."""

from math import asin, inf, pi, sqrt

import numpy as np
import pytest
from oscillators import oscillator, polynomial, quiet

from flexcli.errors import Outcome, SolveError
from flexcli.mechanics.stopping.cantilever_modes import cantilever_modes
from flexcli.mechanics.stopping.laws import HertzStop, LinearStop, RigidStop, Stops
from flexcli.mechanics.stopping.vibration import StoppedVibration, simulate
from flexcli.numerics.signal_pieces import sine

KEPT = 1e-9
"""Energy after a thousand cycles, over that at the start."""


@pytest.mark.slow
@pytest.mark.parametrize("ratio", [10.0, 1e3, 1e6])
def test_a_stiff_stop_keeps_the_energy_over_a_thousand_cycles(ratio, kept):
    """A stepping method must resolve the stiff part, or make and lose energy at each contact."""
    stops = Stops(LinearStop(ratio - 1.0), above=1.0, below=1.0)
    free, speed = 4.0 * asin(1.0 / 1.1), sqrt(1.1**2 - 1.0)
    stiff = 4.0 * np.arctan2(sqrt(ratio) * speed, 1.0) / sqrt(ratio)
    cycles = 1000
    result = simulate(oscillator(), stops, quiet(cycles * (free + stiff), cycles), rate=[1.1])
    assert result.contacts.time.size == 2 * cycles
    assert abs(result.balance.energy_residual) < KEPT * result.balance.start
    kinetic_and_strain = result.balance.kinetic + result.balance.strain
    assert kinetic_and_strain == pytest.approx(result.balance.start, rel=KEPT)
    kept(kinetic_and_strain, result.balance.start)
    # the last cycle begins where the closed form has it
    assert result.contacts.time[-2] == pytest.approx((cycles - 1) * (free + stiff) + free / 4)


def test_a_stop_next_to_the_tip_is_a_million_times_stiffer_and_costs_no_more(kept):
    """The overhang's compliance vanishes as its cube: time steps would too."""

    def run(height):
        blade = cantilever_modes(E=60e9, I=1e-12, L=28.5e-3, L_a=height, m=8e-3, quality=30.0)
        pieces = sine(amplitude=15.0, angular=float(blade.angular[0]), duration=0.3)
        return simulate(blade, Stops(LinearStop(), 2e-5, 2e-5), pieces)

    high, middle = run(28.3e-3), run(20e-3)
    assert high.cost.events > 50
    evaluations = [r.cost.evaluations / r.cost.events for r in (high, middle)]
    assert evaluations[0] < 3.0 * evaluations[1]
    moved = high.balance.base_work + high.balance.damped
    assert abs(high.balance.energy_residual) < 1e-11 * moved
    kept(high.balance.energy_residual, 0.0, scale=moved)


@pytest.mark.parametrize("law", [RigidStop(0.7), LinearStop(1e6), HertzStop(1e5)])
@pytest.mark.parametrize("miss", [-1e-10, 0.0, 1e-10])
def test_a_grazing_contact_neither_hangs_nor_moves_the_peak(law, miss, kept):
    """At the top of the swing the speed is zero: a search for a sign change finds none, or two."""
    stops = Stops(law, above=1.0 + miss, below=inf)
    result = simulate(oscillator(), stops, quiet(40 * pi, 20), rate=[1.0])
    assert result.outcome is Outcome.COMPLETE
    assert result.cost.events < 200
    assert result.peaks.travel == pytest.approx(1.0, abs=1e-9)
    kept(result.peaks.travel, 1.0 + min(miss, 0.0))


@pytest.mark.parametrize("restitution", [0.1, 0.5, 0.9])
def test_chatter_comes_to_rest_at_its_accumulation_point(restitution, kept):
    """Infinitely many bounces in a finite time: an event loop without a rule never ends."""
    g, blade = 10.0, oscillator(angular=1e-5)
    result = simulate(blade, Stops(RigidStop(restitution), 1.0, inf), polynomial([-g], 20.0))
    fall = sqrt(2.0 / g)
    rest = fall * (1.0 + restitution) / (1.0 - restitution)
    assert result.outcome is Outcome.COMPLETE
    assert result.contacts.time[-1] == pytest.approx(rest, rel=1e-7)
    kept(result.contacts.time[-1], rest)
    assert result.contacts.duration[-1] > 0.0
    assert result.q[0] == pytest.approx(1.0, rel=1e-9)


@pytest.mark.parametrize("law", [RigidStop(0.5), LinearStop(1e3), HertzStop(1e4)])
@pytest.mark.parametrize("side", [1, -1])
def test_a_start_inside_a_stop_is_a_named_error(law, side):
    """The penalty of an overlap at the start would fling the blade away."""
    with pytest.raises(SolveError, match="start between the stops") as raised:
        StoppedVibration(oscillator(), Stops(law, 1.0, 1.0), q=[side * 1.001])
    assert raised.value.code == "start-inside-stop"


def test_a_start_on_the_stop_is_allowed_and_leaves_it(kept):
    """A distance of zero is inside by rounding, or a first event at time zero without end."""
    result = simulate(oscillator(), Stops(RigidStop(1.0), 1.0, 1.0), quiet(pi, 1), q=[1.0])
    assert result.outcome is Outcome.COMPLETE
    assert result.peaks.tip_below == pytest.approx(1.0, rel=1e-12)
    kept(result.peaks.tip_below, 1.0)
