"""Blades that are one piece where they cross, against plane elements of the crossing alone."""

import json
from math import exp, pi, radians
from pathlib import Path

import pytest

from flexcli.formulas.solid_crossing import (
    crossing_compliance,
    crossing_offset,
    crossing_reach,
    joined_across,
    solid_crossing,
)
from flexcli.formulas.thick_blades import pivot_shift_across, pivot_softening

PLANE = json.loads((Path(__file__).parent / "plane_crossing.json").read_text(encoding="utf-8"))
SHORT = json.loads(
    (Path(__file__).parents[1] / "parts/plane_joints.json").read_text(encoding="utf-8")
)


@pytest.mark.parametrize("row", PLANE)
def test_the_fits_are_what_plane_elements_have(row):
    """``tests/benchmarks/plane_crossing.py``; of ν only what the shear shares depends.

    The elements leave off a pull at 5° and 85° what they leave of ν.
    """
    degrees, *terms = row
    for nu, (moment, mixed, shear, other, pulled) in ((0.0, terms[:5]), (0.3, terms[5:])):
        found = crossing_compliance(half_angle=radians(degrees), poisson_ratio=nu)
        assert found.moment == pytest.approx(moment, rel=1e-3)
        assert found.mixed == pytest.approx(mixed, rel=2e-3, abs=2e-3 * abs(moment))
        assert found.shear == pytest.approx(shear, rel=2e-3, abs=1e-3 * abs(moment))
        assert -found.other == pytest.approx(other, abs=4e-3 * abs(moment))
        assert -found.pulled == pytest.approx(pulled, rel=1e-3, abs=3e-3)


@pytest.mark.parametrize("row", [row for row in SHORT if row[3] == 0.0])
def test_joined_blades_move_across_as_a_plane_of_both(row):
    """The same of whole joints, with halves of 0.3 to 6 h beyond the crossing, ν = 0."""
    h, crossing, degrees, _, _, across = row
    at = {"h": h, "l": 1.0, "half_angle": radians(degrees), "crossing": crossing}
    beyond = min(crossing, 1.0 - crossing) / h - float(crossing_reach(half_angle=radians(degrees)))
    pulled = crossing_compliance(half_angle=radians(degrees), poisson_ratio=0.0).pulled
    found = joined_across(poisson_ratio=0.0, **at)
    off = 0.25 * exp(-2.0 * beyond) + 5e-3 * abs(float(pulled))
    assert float(found.solid) == pytest.approx(across, abs=abs(float(found.of_pulled)) * off)


@pytest.mark.parametrize("degrees", [20.0, 45.0, 75.0])
def test_thin_joined_blades_stretch_as_the_pivots_that_they_are(degrees):
    """Of pivots of p = 0 one after the other; what is left of both is by shear and stretching."""
    h, at = 1e-3, {"half_angle": radians(degrees), "poisson_ratio": 0.0}
    found = joined_across(h=h, l=1.0, crossing=0.3, **at)
    soft = [1.0 + 0.75 * float(pivot_softening(h=h, l=l, **at)) for l in (0.3, 0.7)]
    whole = 0.3 * soft[0] + 0.7 * soft[1]
    turns = [0.3 * soft[0] / whole, 0.7 * soft[1] / whole]
    parts = [
        float(pivot_shift_across(h=h, l=l, p=p, theta=turn, **at))
        for l, p, turn in zip((0.3, 0.7), (-0.3, 0.0), turns, strict=False)
    ]
    assert float(found.beams) == pytest.approx(sum(parts), rel=1e-3, abs=0.0)


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
