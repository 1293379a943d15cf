"""Blades that are one piece where they cross, against plane elements of the crossing alone."""

import json
from math import pi, radians
from pathlib import Path

import pytest

from flexcli.formulas.solid_crossing import (
    crossing_compliance,
    crossing_offset,
    solid_crossing,
)

PLANE = json.loads((Path(__file__).parent / "plane_crossing.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("row", PLANE)
def test_the_fits_are_what_plane_elements_have(row):
    """``tests/benchmarks/plane_crossing.py``; of ν only what moments and shear share depends."""
    degrees, *terms = row
    for nu, (moment, mixed, shear, other) in ((0.0, terms[:4]), (0.3, terms[4:])):
        found = crossing_compliance(half_angle=radians(degrees), poisson_ratio=nu)
        assert found.moment == pytest.approx(moment, rel=1e-3)
        assert found.mixed == pytest.approx(mixed, rel=2e-3, abs=2e-3 * abs(moment))
        assert found.shear == pytest.approx(shear, rel=2e-3, abs=1e-3 * abs(moment))
        assert -found.other == pytest.approx(other, abs=4e-3 * abs(moment))


@pytest.mark.parametrize("degrees", [20.0, 45.0, 75.0])
@pytest.mark.parametrize("crossing", [0.5, 0.25])
def test_thin_joined_blades_are_as_if_rigid_over_a_length_of_their_thickness(degrees, crossing):
    """8 s/l: two pivots whose blades begin s from their centre."""
    h, alpha = 1e-6, radians(degrees)
    at = {"half_angle": alpha, "crossing": crossing, "poisson_ratio": 0.3}
    more = float(solid_crossing(h=h, l=1.0, **at)) - 1.0
    assert more == pytest.approx(8.0 * h * float(crossing_offset(half_angle=alpha)), rel=1e-4)


def test_a_crossing_is_the_same_from_either_side():
    at = {"h": 0.03, "l": 1.0, "half_angle": pi / 5.0, "poisson_ratio": 0.3}
    one, other = (solid_crossing(crossing=share, **at) for share in (0.3, 0.7))
    assert float(one) == pytest.approx(float(other), rel=1e-12)
