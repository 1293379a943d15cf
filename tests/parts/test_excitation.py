"""Sines and sweeps of the base as a spec writes them."""

import pytest
from pydantic import ValidationError

from flexcli.parts.case import Case
from flexcli.parts.excitation import Sweep

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
