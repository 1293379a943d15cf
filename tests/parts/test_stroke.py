"""Strokes: an amplitude, or a range with its mean."""

import pytest
from pydantic import ValidationError

from flexcli.parts.stroke import Stroke


def stroke(**given):
    return Stroke.model_validate(given)


def test_a_plain_travel_is_an_amplitude_without_mean():
    found = stroke(translation="410 um")
    assert (found.amplitude, found.mean, found.motion) == (410e-6, 0.0, "translation")


@pytest.mark.parametrize(
    ("travel", "amplitude", "mean"),
    [
        (["0 um", "820 um"], 410e-6, 410e-6),
        (["820 um", "0 um"], 410e-6, 410e-6),
        (["-0.41 mm", "410 um"], 410e-6, 0.0),
        (["-300 um", "100 um"], 200e-6, 100e-6),
        (["1 mm", "1 mm"], 0.0, 1e-3),
    ],
)
def test_a_range_is_split_into_amplitude_and_distance_of_its_middle(travel, amplitude, mean):
    found = stroke(translation=travel)
    assert found.amplitude == pytest.approx(amplitude, rel=1e-12)
    assert found.mean == pytest.approx(mean, rel=1e-12)


def test_a_symmetric_range_in_two_units_leaves_no_mean_at_all():
    assert stroke(translation=["-0.41 mm", "410 um"]).mean == 0.0


@pytest.mark.parametrize(
    "given",
    [
        {},
        {"translation": "1 mm", "rotation": "1 deg"},
        {"translation": "0 mm"},
        {"translation": "-1 mm"},
        {"translation": ["1 mm"]},
        {"translation": {"from": "1 mm"}},
        {"rotation": "1 deg", "cycles": 0},
    ],
)
def test_what_is_no_stroke_is_refused(given):
    with pytest.raises(ValidationError):
        stroke(**given)
