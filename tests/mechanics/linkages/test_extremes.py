"""Extremes over a range of the input: exercise 12 C, closed forms, and no grid beats them."""

from math import acos, degrees, pi, radians
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from linkages import crank_stage, four_bar, placed_four_bar, quick_return, slider_crank

from flexcli.errors import SolveError
from flexcli.formulas.pivot import end_stresses
from flexcli.mechanics.linkages.extremes import extremes
from flexcli.mechanics.linkages.travel import travel

ROUNDING = 1e-13
PLACE = 1e-9
END = radians(15.0)
SIGMA, E, BLADE = 100e6, 73e9, 15e-3  # exercise 12 C: Avional, fatigue, length of the blades


def over(linkage, start, end):
    return extremes(travel(linkage, start, end), start, end)


# -- exercise 12 C -------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def stage():
    return over(crank_stage(50e-3), -END, END)


def test_deflections_of_the_crank_stage_are_the_printed_ones(stage):
    assert degrees(stage["alpha"].largest) == pytest.approx(1.95, abs=0.005)
    assert degrees(stage["beta"].largest) == pytest.approx(16.95, abs=0.005)
    assert stage["z"].largest * 1e3 == pytest.approx(12.97, abs=0.005)


def test_the_crank_stage_deflects_unevenly_to_either_side(stage):
    # the print has the absolute values only: β is largest at −15°, z at +15°
    alpha = np.arcsin(1.0 - np.cos(END))
    assert stage["beta"].at_largest == -END
    assert stage["z"].at_largest == END
    assert stage["z"].least == pytest.approx(50e-3 * (1 - np.sin(END) - np.cos(alpha)), rel=1e-12)
    assert stage["z"].least * 1e3 == pytest.approx(-12.91, abs=0.005)
    assert stage["beta"].least == pytest.approx(alpha - END, rel=1e-12)
    # α turns back at rest: the rod leans to one side only
    assert stage["alpha"].least == pytest.approx(0.0, abs=ROUNDING)
    assert stage["alpha"].at_least == pytest.approx(0.0, abs=PLACE)


@pytest.mark.parametrize(
    ("joint", "printed"), [("alpha", 1206e-6), ("beta", 139e-6), ("theta", 157e-6)]
)
def test_blades_sized_for_their_own_deflection_are_the_printed_ones(stage, joint, printed):
    h = 2 * SIGMA * BLADE / (E * stage[joint].largest)
    assert h == pytest.approx(printed, abs=0.5e-6)
    inner, _ = end_stresses(E=E, h=h, l=BLADE, p=-BLADE / 2, theta=stage[joint].largest)
    assert inner == pytest.approx(SIGMA, rel=1e-12)


# -- closed forms --------------------------------------------------------------------------------


def test_a_rocker_turns_back_where_crank_and_coupler_line_up():
    a, b, c, d, rest = 0.4, 1.0, 0.8, 1.1, 0.9
    linkage = placed_four_bar(a, b, c, d, rest, -1.0)
    rocker = over(linkage, 0.0, 2 * pi)["D"]
    # angle at D of the triangle A, C, D with AC = b ± a
    wide, narrow = (acos((d**2 + c**2 - (b + s * a) ** 2) / (2 * d * c)) for s in (1, -1))
    assert rocker.greatest - rocker.least == pytest.approx(wide - narrow, abs=ROUNDING)
    # the crank then points at C, or away from it
    far, near = (acos((d**2 + (b + s * a) ** 2 - c**2) / (2 * d * (b + s * a))) for s in (1, -1))
    places = {(far - rest) % (2 * pi), (near + pi - rest) % (2 * pi)}
    mirrored = {(-far - rest) % (2 * pi), (pi - near - rest) % (2 * pi)}
    found = sorted((rocker.at_least, rocker.at_greatest))
    assert any(found == pytest.approx(sorted(p), abs=PLACE) for p in (places, mirrored))


def test_a_slide_goes_from_the_sum_to_the_difference():
    r, d = 0.4, 1.0
    found = over(quick_return(r, d), -1.0, 4.0)["slide"]
    assert found.greatest == pytest.approx(0.0, abs=ROUNDING)
    assert found.least == pytest.approx(-2 * r, abs=ROUNDING)
    assert found.at_least == pytest.approx(pi, abs=PLACE)
    assert (found.largest, found.at_largest) == (-found.least, found.at_least)


def test_an_arm_swings_farthest_where_it_touches_the_cranks_circle():
    r, d = 0.4, 1.0
    found = over(quick_return(r, d), -pi, pi)["arm"]
    assert found.greatest == pytest.approx(np.arcsin(r / d), abs=ROUNDING)
    assert found.least == pytest.approx(-np.arcsin(r / d), abs=ROUNDING)
    assert found.at_greatest == pytest.approx(pi / 2 + np.arcsin(r / d), abs=PLACE)


def test_a_range_away_from_rest_leaves_rest_out():
    found = over(crank_stage(50e-3), 0.1, 0.2)["alpha"]
    assert (found.at_least, found.at_greatest) == (0.1, 0.2)
    assert found.least == pytest.approx(np.arcsin(1 - np.cos(0.1)), rel=1e-10)


def test_a_range_of_one_input_has_one_value():
    found = over(crank_stage(50e-3), 0.1, 0.1)["z"]
    assert found.least == found.greatest


@pytest.mark.parametrize("reach", [1e-1, 1e-3, 1e-6])
def test_two_turning_points_between_neighbouring_samples_are_found(reach):
    def cubic(inputs):
        x = np.asarray(inputs) / reach
        return SimpleNamespace(
            deflections={"j": x**3 - 3.0 * x},
            ratios={"j": (3.0 * x**2 - 3.0) / reach},
            curvatures={"j": 6.0 * x / reach**2},
        )

    # the slope is positive at both ends, which lie between two nodes
    joints = (SimpleNamespace(name="j"),)
    stand_in = SimpleNamespace(
        at=cubic, nodes=np.array([-10.0, 13.0]), linkage=SimpleNamespace(joints=joints)
    )
    found = extremes(stand_in, -1.5 * reach, 1.7 * reach)["j"]
    assert (found.least, found.greatest) == pytest.approx((-2.0, 2.0), abs=ROUNDING)
    assert found.at_least == pytest.approx(reach, rel=PLACE)
    assert found.at_greatest == pytest.approx(-reach, rel=PLACE)


# -- properties ----------------------------------------------------------------------------------


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(
    jitter=st.lists(st.floats(-0.3, 0.3), min_size=8, max_size=8),
    start=st.floats(-0.25, 0.0),
    end=st.floats(0.0, 0.25),
)
def test_no_grid_finds_more(jitter, start, end):
    corners = np.array([[0.0, 0.0], [0.0, 1.0], [2.0, 1.5], [2.2, 0.0]])
    linkage = four_bar(*map(tuple, (corners + np.reshape(jitter, (4, 2))).tolist()))
    followed = travel(linkage, start, end)
    grid = followed.at(np.linspace(start, end, 400)).deflections
    for name, found in extremes(followed, start, end).items():
        assert found.least <= grid[name].min() + ROUNDING
        assert found.greatest >= grid[name].max() - ROUNDING
        ends = followed.at([found.at_least, found.at_greatest]).deflections[name]
        assert ends == pytest.approx([found.least, found.greatest], abs=ROUNDING)
        assert start <= found.at_least <= end


def test_refuses_what_was_not_followed_and_what_is_no_range():
    followed = travel(slider_crank(0.3, 1.0), -0.1, 0.1)
    with pytest.raises(SolveError, match="the end asked for"):
        extremes(followed, -0.1, 0.2)
    with pytest.raises(ValueError, match="no range of the input"):
        extremes(followed, 0.1, -0.1)
