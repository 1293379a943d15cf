"""Linkages in motion: closed forms of positions and derivatives, stops, frames, closure."""

from math import acos, hypot, pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from linkages import (
    crank_stage,
    four_bar,
    freudenstein,
    placed_four_bar,
    quick_return,
    redrawn,
    slider_crank,
)

from flexcli.errors import SolveError
from flexcli.mechanics.linkages.linkage import Linkage, Prismatic, Revolute
from flexcli.mechanics.linkages.travel import TravelLimit, motion, travel

ROUNDING = 1e-12  # some ten roundings of angles of order 1, over sines of 0.1
SLOPE = 1e-11
BEND = 1e-7  # second derivatives by differences of complex steps: 1e-5² of the fourth, at most
DEAD = 1e-10  # a dead point, and a decade
BRANCH = 1e-6  # a branch point, and a decade
NEAR = st.floats(-0.3, 0.3)


@st.composite
def four_bars(draw):
    """Four-bar linkages far from any singular pose, and joints anywhere near a unit of size."""
    corners = ((0.0, 0.0), (0.0, 1.0), (2.0, 1.5), (2.2, 0.0))
    return four_bar(*((x + draw(NEAR), y + draw(NEAR)) for x, y in corners))


def wrapped(angle):
    return (angle + pi) % (2 * pi) - pi


def complex_step(function, x):
    """Return the first and second derivative of a real-analytic function."""
    h, d = 1e-30, 1e-5
    first, above, below = (function(x + s + 1j * h).imag / h for s in (0.0, d, -d))
    return first, (above - below) / (2 * d)


# -- closed forms --------------------------------------------------------------------------------


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("bars", [(0.4, 1.0, 0.8, 1.1), (1.0, 1.2, 1.5, 0.9), (0.9, 0.3, 0.8, 1.0)])
def test_four_bar_follows_freudensteins_equation_on_its_own_branch(bars, side):
    rest, theta = 0.9, np.linspace(-0.3, 0.25, 23)
    found = motion(placed_four_bar(*bars, rest, side), theta)
    psi, start = freudenstein(*bars, rest + theta, side), freudenstein(*bars, rest, side)
    assert found.deflections["A"] == pytest.approx(theta, abs=ROUNDING)
    assert found.deflections["D"] == pytest.approx(wrapped(psi - start), abs=ROUNDING)
    first, second = complex_step(lambda x: freudenstein(*bars, rest + x, side), theta)
    assert found.ratios["D"] == pytest.approx(first, abs=SLOPE)
    assert found.curvatures["D"] == pytest.approx(second, rel=BEND, abs=BEND)
    # the angles around the loop close
    around = [found.deflections[name] for name in "ABC"]
    assert sum(around) == pytest.approx(found.deflections["D"], abs=ROUNDING)


def test_slider_crank_follows_its_closed_form_through_two_turns():
    r, rod, offset, rest = 0.3, 1.0, 0.1, 0.7
    theta = np.linspace(-2 * pi, 2 * pi, 81)
    found = motion(slider_crank(r, rod, offset, rest), theta)

    def x(turn):
        angle = rest + turn
        return r * np.cos(angle) + np.sqrt(rod**2 - (r * np.sin(angle) - offset) ** 2)

    assert found.deflections["z"] == pytest.approx(x(theta) - x(0.0), abs=ROUNDING)
    first, second = complex_step(x, theta)
    assert found.ratios["z"] == pytest.approx(first, abs=SLOPE)
    assert found.curvatures["z"] == pytest.approx(second, rel=BEND, abs=BEND)


def test_slide_on_a_turning_arm_follows_its_closed_form():
    r, d = 0.4, 1.0
    theta = np.linspace(-4.0, 4.0, 61)
    found = motion(quick_return(r, d), theta)
    forms = {
        "arm": lambda t: -np.arctan(r * np.sin(-t) / (d + r * np.cos(t))),
        "slide": lambda t: np.sqrt(r**2 + d**2 + 2 * r * d * np.cos(t)) - (r + d),
    }
    for name, form in forms.items():
        first, second = complex_step(form, theta)
        assert found.deflections[name] == pytest.approx(form(theta), abs=ROUNDING)
        assert found.ratios[name] == pytest.approx(first, abs=SLOPE)
        assert found.curvatures[name] == pytest.approx(second, rel=BEND, abs=BEND)


def test_crank_stage_follows_the_relations_of_exercise_12_c():
    L, theta = 50e-3, np.linspace(-1.2, 1.2, 49)
    found = motion(crank_stage(L), theta).deflections
    alpha = np.arcsin(1.0 - np.cos(theta))
    assert -found["alpha"] == pytest.approx(-alpha, abs=ROUNDING)
    assert -found["beta"] == pytest.approx(-(alpha - theta), abs=ROUNDING)
    assert found["z"] == pytest.approx(L * (np.sin(theta) - np.cos(alpha) + 1.0), abs=L * ROUNDING)


def test_parallelogram_keeps_its_stage_parallel():
    theta = np.linspace(-1.5, 1.5, 31)
    found = motion(four_bar((0.0, 0.0), (0.0, 0.7), (2.0, 0.7), (2.0, 0.0)), theta)
    for name, sign in {"A": 1, "B": -1, "C": 1, "D": 1}.items():
        assert found.deflections[name] == pytest.approx(sign * theta, abs=ROUNDING)
        assert found.curvatures[name] == pytest.approx(0.0, abs=1e-9)
    x, y = found.position("coupler", (1.0, 0.7))
    assert x == pytest.approx(1.0 - 0.7 * np.sin(theta), abs=ROUNDING)
    assert y == pytest.approx(0.7 * np.cos(theta), abs=ROUNDING)


def test_two_four_bars_in_a_row_are_one_after_the_other():
    bars, more, rest, reach = (0.4, 1.0, 0.8, 1.1), (0.5, 1.0, 0.9, 1.2), 0.9, 0.3
    first = placed_four_bar(*bars, rest, -1.0)
    # the second stands on D, with the rocker's other arm as its crank
    second = redrawn(placed_four_bar(*more, 1.0, -1.0), lambda x, y, s: (x + s * bars[3], y))
    renamed = (
        Revolute("E", "rocker", "rod", second.joints[1].point),
        Revolute("F", "rod", "lever", second.joints[2].point),
        Revolute("G", "base", "lever", second.joints[3].point),
    )
    theta = np.linspace(-reach, reach, 15)
    found = motion(Linkage((*first.joints, *renamed), "base", "A"), theta)

    def lever(turn):
        middle = freudenstein(*bars, rest + turn, -1.0) - freudenstein(*bars, rest, -1.0)
        return freudenstein(*more, 1.0 + middle, -1.0) - freudenstein(*more, 1.0, -1.0)

    slope, bend = complex_step(lever, theta)
    assert found.deflections["G"] == pytest.approx(lever(theta), abs=ROUNDING)
    assert found.ratios["G"] == pytest.approx(slope, abs=SLOPE)
    assert found.curvatures["G"] == pytest.approx(bend, rel=BEND, abs=BEND)


@pytest.mark.parametrize(
    "joint", [Revolute("j", "base", "a", (1.0, 2.0)), Prismatic("j", "base", "a", (3.0, 4.0))]
)
def test_a_single_joint_moves_as_its_input(joint):
    alone = Linkage((joint,), ground="base", input="j")
    found = motion(alone, np.array([-7.0, 0.0, 7.0]))
    assert found.deflections["j"] == pytest.approx([-7.0, 0.0, 7.0], abs=ROUNDING)
    assert found.ratios["j"] == pytest.approx(1.0)
    x, y = found.position("a", (1.0, 2.0))
    slides = isinstance(joint, Prismatic)
    assert x == pytest.approx([1.0 - 4.2, 1.0, 1.0 + 4.2] if slides else 1.0, abs=ROUNDING)
    assert y == pytest.approx([2.0 - 5.6, 2.0, 2.0 + 5.6] if slides else 2.0, abs=ROUNDING)


# -- stops ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("r", [0.3, 0.01])
def test_a_driven_stage_stops_where_crank_and_rod_line_up(r):
    rest = np.sqrt(1.0 - r**2)
    found = travel(slider_crank(r, 1.0, drive="z"), -4.0, 4.0)
    assert found.low.end is found.high.end is TravelLimit.DEAD_POINT
    assert found.low.input == pytest.approx(1.0 - r - rest, abs=DEAD)
    assert found.high.input == pytest.approx(1.0 + r - rest, abs=DEAD)


# of 80 sizes those in which the change of units rounds a stop beyond itself, and a plain one
@pytest.mark.slow
@pytest.mark.parametrize("scale", [1.0, 0.93**10, 0.93**14, 0.93**52])
def test_the_stops_themselves_are_reached_in_any_unit(scale):
    found = travel(slider_crank(0.3 * scale, scale, drive="z"), -4.0, 4.0)
    theta = found.at([found.low.input, found.high.input]).deflections["theta"]
    assert theta == pytest.approx([pi / 2, -pi / 2], abs=1e-4)  # √DEAD, and a decade


def test_a_crank_that_cannot_turn_stops_where_coupler_and_rocker_line_up():
    a, b, c, d, rest = 1.0, 0.5, 0.9, 1.2, 0.9
    found = travel(placed_four_bar(a, b, c, d, rest, 1.0), -0.1, 2.0)
    stretched = acos((a**2 + d**2 - (b + c) ** 2) / (2 * a * d))
    assert found.low == (-0.1, TravelLimit.RANGE)
    assert found.high.end is TravelLimit.DEAD_POINT
    assert found.high.input == pytest.approx(stretched - rest, abs=DEAD)
    with pytest.raises(SolveError, match="cannot drive past it") as caught:
        found.at(stretched - rest + 1e-3)
    assert caught.value.code == "dead-point"


@pytest.mark.parametrize(("b", "a"), [(1.0, 1.0), (2.0, 0.7), (1e-3, 3e-3)])
def test_a_parallelogram_stops_where_it_lies_flat(b, a):
    parallelogram = four_bar((0.0, 0.0), (0.0, a), (b, a), (b, 0.0))
    found = travel(parallelogram, -4.0, 4.0)
    assert found.low.end is found.high.end is TravelLimit.BRANCH_POINT
    assert (found.low.input, found.high.input) == pytest.approx((-pi / 2, pi / 2), abs=BRANCH)
    with pytest.raises(SolveError, match="either of two ways") as caught:
        motion(parallelogram, 1.6)
    assert caught.value.code == "branch-point"


def test_passes_close_by_a_branch_point_on_its_own_branch():
    bars = (1.0, 2.0, 1.0, 2.0 * (1.0 - 1e-5))
    theta = np.linspace(0.0, 3.0, 13)
    found = motion(placed_four_bar(*bars, 0.5, -1.0), theta)
    psi, start = freudenstein(*bars, 0.5 + theta, -1.0), freudenstein(*bars, 0.5, -1.0)
    # 1e-5 from the branch point some five digits go
    assert wrapped(found.deflections["D"] - psi + start) == pytest.approx(0.0, abs=1e-9)


def test_short_and_nearly_flat_loops_are_followed_in_few_steps():
    bars = (0.3175, 1.1342, 1.1687, 0.3066)
    found = travel(placed_four_bar(*bars, 1.296, -1.0), -7.0, 7.0)
    assert found.low.end is found.high.end is TravelLimit.DEAD_POINT
    assert found.nodes.size < 150
    theta = np.linspace(found.low.input, found.high.input, 50)[1:-1]
    psi, start = freudenstein(*bars, 1.296 + theta, -1.0), freudenstein(*bars, 1.296, -1.0)
    error = wrapped(found.at(theta).deflections["D"] - psi + start)
    assert error == pytest.approx(0.0, abs=1e-10)


def test_a_travel_is_not_asked_beyond_what_was_followed():
    with pytest.raises(SolveError, match="the end asked for") as caught:
        travel(slider_crank(0.3, 1.0), -0.1, 0.1).at(0.2)
    assert caught.value.code == "not-followed"


@pytest.mark.parametrize(("start", "end"), [(1.0, -1.0), (0.0, np.inf), (np.nan, 1.0)])
def test_a_range_needs_finite_rising_ends(start, end):
    with pytest.raises(ValueError, match="no range of the input"):
        travel(slider_crank(0.3, 1.0), start, end)


# -- invariants ----------------------------------------------------------------------------------


@settings(max_examples=25)
@given(linkage=four_bars(), theta=st.floats(-0.2, 0.2))
def test_links_keep_together_and_rigid(linkage, theta):
    found = motion(linkage, theta)
    for joint in linkage.joints:
        first, second = (found.position(link, joint.point) for link in joint[1:3])
        assert first == pytest.approx(second, abs=ROUNDING)
    (ax, ay), (bx, by) = (found.position("coupler", joint.point) for joint in linkage.joints[1:3])
    B, C = (joint.point for joint in linkage.joints[1:3])
    assert hypot(ax - bx, ay - by) == pytest.approx(hypot(B[0] - C[0], B[1] - C[1]), rel=ROUNDING)


@settings(max_examples=25)
@given(
    turn=st.floats(-pi, pi),
    mirror=st.sampled_from([1, -1]),
    scale=st.floats(1e-3, 1e3),
    shift=st.floats(-5.0, 5.0),
    theta=st.floats(-1.0, 1.0),
)
def test_motion_does_not_depend_on_where_and_how_large_it_is_drawn(
    turn, mirror, scale, shift, theta
):
    def change(x, y, is_point):
        z = scale * (complex(x, mirror * y) * np.exp(1j * turn) + is_point * shift)
        return z.real, z.imag

    linkage = quick_return(0.4, 1.0)
    plain, moved = motion(linkage, theta), motion(redrawn(linkage, change), mirror * theta)
    for joint in linkage.joints:
        unit = scale if isinstance(joint, Prismatic) else mirror
        for order, name in enumerate(("deflections", "ratios", "curvatures")):
            expected = unit * mirror**order * getattr(plain, name)[joint.name]
            found = getattr(moved, name)[joint.name]
            assert found == pytest.approx(expected, abs=10 * ROUNDING * max(1.0, abs(unit)))


def test_a_joint_turned_around_deflects_the_other_way():
    linkage = quick_return(0.4, 1.0)
    joints = tuple(
        j._replace(first=j.second, second=j.first) if j.name != linkage.input else j
        for j in linkage.joints
    )
    plain = motion(linkage, 0.8)
    turned = motion(Linkage(joints, linkage.ground, linkage.input), 0.8)
    for name in ("pin", "slide", "arm"):
        expected = pytest.approx(-plain.deflections[name], abs=ROUNDING)
        assert turned.deflections[name] == expected


@settings(max_examples=25)
@given(linkage=four_bars(), theta=st.floats(0.01, 0.2))
def test_driving_the_rocker_back_returns_the_crank(linkage, theta):
    there = motion(linkage, theta)
    back = Linkage(linkage.joints, linkage.ground, "D")
    found = motion(back, there.deflections["D"])
    if abs(there.ratios["D"]) > 0.1:
        assert found.deflections["A"] == pytest.approx(theta, abs=1e-10)
        assert found.ratios["A"] == pytest.approx(1.0 / there.ratios["D"], rel=1e-9)


def test_array_call_equals_element_wise_calls():
    linkage, theta = slider_crank(0.3, 1.0, 0.1), np.linspace(-1.0, 2.0, 6).reshape(2, 3)
    together = motion(linkage, theta)
    assert together.deflections["z"].shape == together.turns["rod"].shape == theta.shape
    for index in np.ndindex(theta.shape):
        alone = motion(linkage, theta[index])
        for name in together.deflections:
            for what in ("deflections", "ratios", "curvatures"):
                expected = getattr(together, what)[name][index]
                assert getattr(alone, what)[name] == pytest.approx(expected, abs=ROUNDING)
