"""What is free of a stage is solved, with the least mass; what can't be has its reason."""

from dataclasses import replace

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from stages import rider

from flexcli.mechanics.parallel_stage import Lever, Stage
from flexcli.parts.mechanisms.force_balance import Unknown, balance
from flexcli.parts.mechanisms.free_value import Free

H, M_1, M_2, M_BAL, L_C1 = 20e-3, 17.138708e-3, 68.122300e-3, 35.565044e-3, 10.411598e-3
NEEDED = M_2 * H + 2 * M_1 * L_C1
BOTH, ONE, OTHER = (0, 1), (0,), (1,)

VANISHES = 1e-12
"""Coupling that a solution leaves, over that before: rounding of some ten operations."""


def stage(masses=(M_BAL, M_BAL), arms=(0.0, 0.0), com=L_C1, platform=M_2):
    levers = (
        Lever(rider(M_1, com, 0.0, 5e-6), rider(mass, -arm, 0.0, 1e-6))
        for mass, arm in zip(masses, arms, strict=True)
    )
    return Stage(H, platform, 0.0, tuple(levers))


def left(solution):
    return abs(solution.stage.moment / solution.stage.without_balance().moment)


def unknown(kind, sides=BOTH, least=None, most=None, total=0.0):
    return Unknown(kind, sides, Free(least, most), total)


def test_the_arm_of_exercise_9():
    solution = balance(stage(), [unknown("arm")], 0.0)
    assert solution.met
    assert round(solution.found[0] * 1e3, 4) == 24.1716


numbers = st.floats(1e-4, 0.1)


@given(numbers, numbers, st.floats(-0.02, 0.05), st.sampled_from([BOTH, ONE, OTHER]))
def test_at_the_solved_arm_the_coupling_vanishes(first, third, com, sides):
    given_stage = stage((first, third), (0.01, 0.01), com=com)
    assume(abs(given_stage.without_balance().moment) > 1e-6)
    solution = balance(given_stage, [unknown("arm", sides, least=-1e6)], 0.0)
    assert solution.met
    assert left(solution) < VANISHES * (1.0 + 0.01 * (first + third) / abs(NEEDED))


@given(numbers, numbers)
def test_swapping_the_sides_swaps_the_solution(first, third):
    one = balance(stage((first, third)), [unknown("arm", ONE)], 0.0)
    other = balance(stage((third, first)), [unknown("arm", OTHER)], 0.0)
    assert one.found == other.found
    assert one.stage.levers == other.stage.levers[::-1]


@given(st.floats(1e-3, 0.1), st.floats(0.0, 0.5))
def test_the_least_mass_that_does_is_added(arm, allowed):
    solution = balance(stage(arms=(arm, arm)), [unknown("mass")], allowed)
    assert solution.met
    assert solution.found[0] == pytest.approx((1.0 - allowed) * NEEDED / (2 * arm), rel=1e-12)


def test_a_coupling_that_is_allowed_whole_needs_no_mass():
    assert balance(stage(arms=(0.02, 0.02)), [unknown("mass")], 1.0).found == (0.0,)


def test_the_height_of_the_lever_balances_too():
    solution = balance(stage(arms=(0.03, 0.03)), [unknown("height", ())], 0.0)
    assert solution.met
    assert solution.found[0] == pytest.approx((2 * M_BAL * 0.03 - 2 * M_1 * L_C1) / M_2)
    assert left(solution) < VANISHES


def test_the_split_of_a_total_mass_between_arms_that_differ():
    total = 2 * M_BAL
    split = unknown("split", total=total)
    solution = balance(stage(arms=(0.02, 0.03)), [split], 0.0)
    first, third = (lever.balance.mass for lever in solution.stage.levers)
    assert first + third == pytest.approx(total)
    assert left(solution) < VANISHES


def test_of_arm_and_mass_the_arm_stands_at_its_limit_and_the_mass_is_least():
    solution = balance(stage(), [unknown("arm", most=0.03), unknown("mass")], 0.0)
    arm, mass = solution.found
    assert arm == 0.03
    assert mass == pytest.approx(NEEDED / (2 * 0.03))
    for shorter in (0.01, 0.02, 0.029):
        other = balance(stage(arms=(shorter, shorter)), [unknown("mass")], 0.0)
        assert other.stage.added_mass > solution.stage.added_mass


def test_of_height_and_arm_the_arm_is_shortest():
    height = unknown("height", (), 0.015, 0.025)
    solution = balance(stage(), [unknown("arm"), height], 0.0)
    assert solution.found[1] == 0.015
    assert left(solution) < VANISHES


def test_an_arm_beyond_the_package_says_what_is_left_and_what_mass_would_do():
    solution = balance(stage(), [unknown("arm", most=0.02)], 0.0)
    assert not solution.met
    assert solution.found == (0.02,)
    assert "24.17 mm, above its limit 20 mm" in solution.reason
    assert "85.97 g of balancing mass at 20 mm" in solution.remedy
    assert left(solution) == pytest.approx(1.0 - 0.02 / 0.0241716, rel=1e-4)


def test_a_negative_arm_is_refused_unless_its_bounds_allow_it():
    heavy = stage(com=-0.1)
    refused = balance(heavy, [unknown("arm")], 0.0)
    assert not refused.met
    assert "over-balanced" in refused.reason
    allowed = balance(heavy, [unknown("arm", least=-0.05)], 0.0)
    assert allowed.met
    assert allowed.found[0] < 0.0


def test_a_solution_just_within_its_limit_is_met():
    arm = NEEDED / (2 * M_BAL)
    assert balance(stage(), [unknown("arm", most=arm * (1 + 1e-15))], 0.0).met


@pytest.mark.parametrize(
    ("start", "asked", "why"),
    [
        (stage(masses=(0.0, 0.0)), unknown("arm"), "no moment at any arm"),
        (stage(arms=(0.02, -0.02)), unknown("mass"), "cancel each other"),
        (stage(arms=(0.02, 0.02)), unknown("split", total=0.07), "both arms are equal"),
        (stage(platform=0.0), unknown("height", ()), "no mass"),
    ],
)
def test_what_has_no_effect_says_so(start, asked, why):
    solution = balance(start, [asked], 0.0)
    assert not solution.met
    assert why in solution.reason


@given(st.integers(-30, -3))
def test_a_mass_that_tends_to_zero_needs_an_arm_that_grows_and_keeps_its_digits(exponent):
    mass = 10.0**exponent
    solution = balance(stage((mass, mass)), [unknown("arm")], 0.0)
    assert solution.found[0] * 2 * mass == pytest.approx(NEEDED, rel=1e-14)
    assert left(solution) < VANISHES


def test_arms_of_opposite_sign_balance_by_their_split():
    solution = balance(stage(arms=(0.06, -0.02)), [unknown("split", total=2 * M_BAL)], 0.0)
    assert solution.met
    assert left(solution) < VANISHES


def test_nothing_free_changes_nothing():
    given_stage = stage(arms=(0.01, 0.02))
    assert balance(given_stage, [], 0.0).stage is given_stage
    assert replace(given_stage).moment == given_stage.moment
