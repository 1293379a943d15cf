"""General integrators with a penalty contact: closed forms, order, what their model leaves."""

from math import asin, atan2, pi, sqrt

import numpy as np
import pytest

from flexcli.engine.comparing.penalty_law import RIGID_PENALTY
from flexcli.engine.comparing.time_methods import (
    event_driven,
    penalty_run,
    stretches,
)
from flexcli.engine.comparing.time_motions import StoppedMotion
from flexcli.mechanics.stopping.laws import (
    LinearStop,
    RigidStop,
    Stops,
)
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.numerics.signal_pieces import Piece, Samples, half_sine, sine

SPEED, RATIO, SWINGS = 1.1, 10.0, 3
LUCK = 1e3
"""Global error over tolerance. A step over a kink of the force has an estimate that is right or
wrong by luck; a few swings were seen to lose from 0 to 430 tolerances, most of them some 30."""


def blade(**changes):
    """Give an oscillator of unit mass and stiffness, without damping."""
    one = np.ones(1)
    given = {"angular": one, "damping": 0 * one, "base": one, "tip": one, "stop": one,
             "base_moment": one}  # fmt: skip
    return ModalBlade(**{**given, **changes})


def free(law, length, *, speed=SPEED, **changes):
    """Give a free swing from the middle between stops at ±1."""
    motion = (blade(**changes), Stops(law, 1.0, 1.0), (Piece(length, ()),), np.array([speed]))
    return StoppedMotion("swing", "swing", *motion)


def bilinear():
    """Give a swing between springs, with its greatest travel and its last touch."""
    touch, at = asin(1 / SPEED), sqrt(SPEED**2 - 1)
    against = 2 * atan2(at / sqrt(RATIO), 1 / RATIO)
    period = 4 * touch + 2 * against / sqrt(RATIO)
    # k (x − 1)² + x² = v²: the root beyond the stop
    k = RATIO - 1
    travel = (k + sqrt(k * k - RATIO * (k - SPEED**2))) / RATIO
    motion = free(LinearStop(RATIO - 1.0), SWINGS * period)
    return motion, travel, (SWINGS - 1) * period + period / 2 + touch


@pytest.mark.parametrize("method", [pytest.param("Radau", marks=pytest.mark.slow), "DOP853"])
def test_a_swing_between_springs_tends_to_its_closed_form(method):
    motion, travel, last = bilinear()
    tolerances, errors = np.geomspace(1e-4, 1e-10, 7), []
    for tolerance in tolerances:
        found = penalty_run(motion, method, tolerance)
        force = (RATIO - 1) * (travel - 1)
        errors.append(
            max(abs(found.tip / travel - 1), abs(found.force / force - 1),
                abs(found.last_contact / last - 1))
        )  # fmt: skip
    assert errors[0] > 1e-6
    assert (errors <= LUCK * tolerances).all()
    # a local error of a tolerance makes a global one that goes down with it
    assert np.polyfit(np.log10(tolerances), np.log10(errors), 1)[0] > 0.6


def test_the_event_driven_run_is_at_its_closed_form():
    motion, travel, last = bilinear()
    found, residual = event_driven(motion)
    assert found.tip == pytest.approx(travel, rel=1e-13)
    assert found.last_contact == pytest.approx(last, rel=1e-13)
    assert residual < 1e-13


def test_the_penalty_of_a_rigid_stop_differs_by_the_length_of_its_contact():
    swing = free(RigidStop(0.8), 2 * pi)
    sharp, _ = event_driven(swing)
    soft = penalty_run(swing, "DOP853", 1e-10)
    # a contact lasts up to half a cycle on its spring, in which the blade's own turns it too
    contact = pi / sqrt(RIGID_PENALTY)
    assert sharp.tip == pytest.approx(1.0, rel=1e-12)
    assert 1.0 < soft.tip < 1.0 + SPEED / sqrt(RIGID_PENALTY)
    assert 0.0 < soft.last_contact - sharp.last_contact < 2.0 * contact
    assert sharp.force == 0.0 < soft.force


def test_no_contact_has_no_time_and_no_force():
    found = penalty_run(free(LinearStop(9.0), 2 * pi, speed=0.5), "DOP853", 1e-10)
    assert found.tip == pytest.approx(0.5, rel=1e-9)
    assert found.force == 0.0
    assert np.isnan(found.last_contact)


def test_periods_of_a_sine_are_one_stretch_of_the_same_signal():
    pieces = list(sine(amplitude=3.0, angular=7.0, duration=5.0))
    (whole,) = stretches(pieces)
    assert len(pieces) == 6
    assert whole.duration == pytest.approx(5.0, rel=1e-14)
    assert whole(4.9) == pytest.approx(3.0 * np.sin(7.0 * 4.9), rel=1e-12)


def test_a_pulse_and_a_sawtooth_are_cut_where_they_jump():
    pulse = [*half_sine(amplitude=1.0, width=0.1, duration=1.0), Piece(1.0, ())]
    assert [p.duration for p in stretches(pulse)] == pytest.approx([0.1, 1.9])
    assert len(stretches(Samples(np.array([0.0, 1.0, 0.5, 1.5]), 0.1).lines())) == 3
    teeth = [*Samples(np.array([0.0, 1.0]), 0.1).lines()] * 3
    assert len(stretches(teeth)) == 3


def test_stretches_change_nothing_but_the_restarts():
    motion = free(LinearStop(9.0), 1.0)._replace(
        pieces=tuple(sine(amplitude=0.3, angular=1.1, duration=20.0)), rate=np.zeros(1)
    )
    exact, _ = event_driven(motion)
    found = penalty_run(motion, "DOP853", 1e-11)
    assert found == pytest.approx(exact, rel=1e-8)
