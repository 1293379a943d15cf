"""The greatest value on pieces of a line: known maxima, ends, jumps, noise-free convergence."""

import doctest

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics import maximum as module
from flexcli.numerics.maximum import greatest

VALUE = 1e-10  # what is asked for, and a decade
PLACE = 1e-4  # a flat maximum: √(1e-11) of its width, and a decade and a half


def one(grid):
    return grid, np.zeros(grid.size, dtype=np.intp)


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


@given(top=st.floats(0.01, 0.99), sharp=st.floats(1, 400))
def test_finds_a_lorentzian_wherever_it_stands(top, sharp):
    grid = np.linspace(0, 1, 2000)
    value, place, _ = greatest(lambda x, _: 1 / (1 + (sharp * (x - top)) ** 2), *one(grid))
    assert value == pytest.approx(1.0, rel=VALUE)
    assert place == pytest.approx(top, abs=PLACE / sharp)


@pytest.mark.parametrize("sign", [1, -1])
def test_a_maximum_at_an_end_is_the_end(sign):
    value, place, _ = greatest(lambda x, _: np.exp(sign * x), *one(np.linspace(-1, 1, 5)))
    assert value == pytest.approx(np.e, rel=VALUE)
    assert place == sign


def test_a_maximum_between_an_end_and_its_neighbour_is_found():
    value, place, _ = greatest(lambda x, _: 2 - (x - 0.01) ** 2, *one(np.linspace(0, 1, 11)))
    assert value == pytest.approx(2.0, rel=VALUE)
    assert place == pytest.approx(0.01, abs=PLACE)


def test_pieces_may_jump_where_they_meet():
    grid, piece = np.array([0.0, 0.5, 1.0, 1.0, 1.5, 2.0]), np.array([0, 0, 0, 1, 1, 1])
    value, place, on = greatest(lambda x, p: np.where(p == 0, 1 + x, 1.5 - x / 4), grid, piece)
    assert (value, place, on) == (2.0, 1.0, 0)


def test_of_two_peaks_the_greater_wins_though_the_grid_shows_the_other():
    def two(x, _):
        narrow = 1.02 / (1 + ((x - 0.2505) * 300) ** 2)
        return np.maximum(narrow, 1 / (1 + ((x - 0.75) * 3) ** 2))

    value, place, _ = greatest(two, *one(np.linspace(0, 1, 1001)))
    assert value == pytest.approx(1.02, rel=VALUE)
    assert place == pytest.approx(0.2505, abs=PLACE)
