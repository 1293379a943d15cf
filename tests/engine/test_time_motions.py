"""Motions short enough for every method: from rest, as long as their window, of either sign."""

from math import pi

import pytest
from stop_designs import REST, SINE, stopped

from flexcli.engine.comparing.time_motions import PERIODS, motions

PLACE = {"height": "17 mm", "gap": "36 um"}
PULSE = {"shock": {"half-sine": {"acceleration": "30 g", "duration": "3 ms"}}}
KICK = {"shock": {"velocity": "0.1 m/s", "q": 50}}


def moved(one):
    return list(motions(one, one.fixed_sizes()))


def test_on_one_side_a_shock_is_two_motions_and_each_begins_at_rest():
    one = stopped({**PLACE, "sides": "one"}, cases={"drop": PULSE})
    both = moved(one)
    assert [motion.name for motion in both] == ["drop_1", "drop_2"]
    assert both[1].label.startswith("drop, half-sine shock, turned round")
    assert not any(motion.rate.any() for motion in both)


def test_every_motion_is_as_long_as_its_window():
    for cases in (SINE, {"kick": KICK}, {"drop": PULSE}):
        (motion,) = moved(stopped(PLACE, cases=cases))
        turned = sum(piece.duration for piece in motion.pieces) * motion.blade.angular[0]
        assert turned == pytest.approx(2.0 * pi * PERIODS, rel=1e-12)


def test_a_velocity_shock_begins_with_the_speed_it_gives_the_tip():
    (motion,) = moved(stopped(PLACE, cases={"kick": KICK}))
    assert abs(motion.blade.tip @ motion.rate) == pytest.approx(0.1, rel=1e-9)


def test_a_case_with_sine_and_shock_is_two_motions_and_one_that_rests_is_none():
    both = {"both": {**SINE["resonance"], **PULSE}}
    names = [motion.name for motion in moved(stopped(PLACE, cases={**both, **REST}))]
    assert names == ["both_1", "both_2"]
    assert moved(stopped(PLACE, cases=REST)) == []
