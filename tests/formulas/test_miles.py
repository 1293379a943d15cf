"""Miles: the number of the flexure course, and the worst case against a dense grid."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from spectra import GEVS, profiles

from flexcli.formulas.miles import miles, miles_worst_case

ROUNDING = 1e-12  # a handful of operations


def test_miles_gives_the_251_g_of_the_flexure_course():
    # Exercise 9 part II: 0.2 g²/Hz at 2000 Hz, Q = 100, printed as 251 g
    assert float(miles(2000, 100, 0.2)) == pytest.approx(250.66, abs=0.005)


def test_worst_case_of_gevs_is_at_the_end_of_the_plateau():
    worst = miles_worst_case(*GEVS, 100)
    assert worst.frequency == 800
    assert worst.response == pytest.approx(np.sqrt(np.pi / 2 * 800 * 100 * 0.16), rel=ROUNDING)


@pytest.mark.parametrize("scale", ["log", "linear"])
@given(data=st.data())
@settings(deadline=None, max_examples=60)
def test_worst_case_is_the_supremum_of_a_dense_grid(scale, data):
    f, g = data.draw(profiles(scale))
    worst = miles_worst_case(f, g, 30.0, scale=scale)
    share = np.linspace(0, 1, 400)
    products = []
    for (a, b), (ga, gb) in zip(itertools.pairwise(f), itertools.pairwise(g), strict=True):
        if scale == "log":
            products.append(a * (b / a) ** share * ga * (gb / ga) ** share)
        else:
            products.append((a + (b - a) * share) * (ga + (gb - ga) * share))
    grid = float(np.sqrt(np.pi / 2 * 30.0 * np.max(products)))
    assert grid <= float(worst.response) * (1 + ROUNDING)
    assert float(worst.response) == pytest.approx(grid, rel=1e-4)  # the grid's own coarseness
    assert float(worst.response) == pytest.approx(
        float(miles(worst.frequency, 30.0, worst.level)), rel=ROUNDING
    )


def test_worst_case_takes_the_higher_side_of_a_step():
    up = miles_worst_case([10, 100, 100, 1000], [1, 1, 9, 0.1], 10)
    down = miles_worst_case([10, 100, 100, 1000], [1, 9, 0.1, 0.1], 10)
    assert (up.frequency, up.level) == (100, 9)
    assert (down.frequency, down.level) == (100, 9)


def test_worst_case_on_a_slope_of_minus_one_is_its_lowest_frequency():
    assert miles_worst_case([30, 70, 700], [1 / 30, 1 / 70, 1 / 700], 10).frequency == 30


def test_worst_case_inside_a_linear_segment_is_the_top_of_a_parabola():
    worst = miles_worst_case([0, 10], [5, 0], 2, scale="linear")
    assert worst.frequency == pytest.approx(5, rel=ROUNDING)
    assert worst.level == pytest.approx(2.5, rel=ROUNDING)


def test_worst_case_serves_several_q_and_a_range_at_once():
    worst = miles_worst_case(*GEVS, [10, 40], upper=200)
    assert worst.frequency == 200
    assert worst.response.tolist() == [miles(200, 10, 0.16), miles(200, 40, 0.16)]


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: miles(0, 10, 1), "f must be positive"),
        (lambda: miles(1, 10, -1), "negative"),
        (lambda: miles_worst_case(*GEVS, 10, lower=4000), "nothing between"),
        (lambda: miles_worst_case(*GEVS, 0), "Q must be positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
