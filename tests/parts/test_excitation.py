"""Sines and sweeps of the base as a spec writes them."""

import numpy as np
import pytest
from pydantic import ValidationError

from flexcli.parts.case import Case
from flexcli.parts.excitation import Sine, Sweep

BAND = {"from": "100 Hz", "to": "400 Hz", "acceleration": "1 g"}


def test_a_sweep_in_hertz_per_second_takes_the_band_over_the_rate():
    assert Sweep(**BAND, rate="2 Hz/s").duration == pytest.approx(150.0)


@pytest.mark.parametrize("rate", ["4 oct/min", " 4oct/min "])
def test_a_sweep_in_octaves_takes_its_octaves_over_the_rate(rate):
    sweep = Sweep(**BAND, rate=rate)
    assert not sweep.rate.is_linear
    assert sweep.duration == pytest.approx(30.0)


def test_a_sweep_may_fall():
    falling = {**BAND, "from": "400 Hz", "to": "100 Hz"}
    assert Sweep(**falling, rate="2 Hz/s").duration == pytest.approx(150.0)


@pytest.mark.parametrize("rate", ["0 Hz/s", "-1 oct/min", "x oct/min", "3 Hz", 5, True, None])
def test_a_rate_is_a_positive_number_with_its_unit(rate):
    with pytest.raises(ValidationError):
        Sweep(**BAND, rate=rate)


@pytest.mark.parametrize(
    "case", [{"sine": {"acceleration": "1 g", "frequency": "9 Hz"}},
             {"sweep": {**BAND, "rate": "1 Hz/s"}}],
)  # fmt: skip
def test_either_is_enough_of_a_case(case):
    assert Case.model_validate(case)


def test_an_empty_case_is_told_of_them():
    with pytest.raises(ValidationError, match="loads nothing"):
        Case.model_validate({})


ENDS = {"from": "5 Hz", "to": "100 Hz", "rate": "2 oct/min"}


def test_a_sweep_crosses_from_displacement_to_acceleration_where_both_are_equal():
    sweep = Sweep(**ENDS, displacement="10 mm", acceleration="15 g")
    f = np.sqrt(15.0 * 9.80665 / 0.01) / (2.0 * np.pi)
    assert sweep.crossovers == (pytest.approx(f, rel=1e-12),)
    level = sweep.level(np.array([5.0, 2.0 * f]))
    assert level == pytest.approx([0.01 * (10.0 * np.pi) ** 2, 15.0 * 9.80665], rel=1e-12)
    assert "10 mm to 19.3 Hz, 15 g to 100 Hz" in sweep.told


def test_a_velocity_between_makes_two_crossovers_and_one_above_both_none():
    between = Sweep(**ENDS, displacement="10 mm", velocity="0.8 m/s", acceleration="15 g")
    low, high = between.crossovers
    assert low == pytest.approx(0.8 / 0.01 / (2.0 * np.pi), rel=1e-12)
    assert high == pytest.approx(15.0 * 9.80665 / 0.8 / (2.0 * np.pi), rel=1e-12)
    above = Sweep(**ENDS, displacement="10 mm", velocity="2 m/s", acceleration="15 g")
    assert len(above.crossovers) == 1


def test_a_sine_of_displacement_or_velocity_is_one_of_acceleration():
    omega = 2.0 * np.pi * 30.0
    for given, expected in (
        ({"displacement": "1 mm"}, 1e-3 * omega**2),
        ({"velocity": "0.2 m/s"}, 0.2 * omega),
        ({"acceleration": "2 g"}, 2.0 * 9.80665),
    ):
        assert Sine(frequency="30 Hz", **given).acceleration == pytest.approx(expected, rel=1e-12)


def test_a_sine_without_any_level_is_a_finding():
    with pytest.raises(ValidationError, match="how strong"):
        Sine(frequency="30 Hz")
