"""Numbers of many designs in code for one: each design as alone, or no number at all."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.rows import (
    Rows,
    cos,
    design_by_design,
    each_alike,
    found_once,
    hypot,
    isfinite,
    larger,
    number,
    one_alone,
    one_by_one,
    smaller,
    sqrt,
)

NUMBERS = st.lists(st.floats(-50.0, 50.0).filter(lambda x: abs(x) > 1e-3), min_size=1, max_size=40)

ROUNDING = 1e-15
"""Of a sine, a root and the like, in which libraries differ."""


def of_one(x):
    """Return a number by ways that hang on it, as code for one design has them."""
    total = larger(abs(x), 1.0) if x > 0.0 else smaller(x, -2.0)
    while abs(total) > 10.0:
        total = total / 3.0
    if not isfinite(total):
        return 0.0
    return cos(total) + sqrt(abs(total)) * hypot(x, 1.0) if total > 1.5 else number(total * x)


@given(NUMBERS)
def test_each_design_takes_its_own_way(numbers):
    def do(which):
        return of_one(Rows.of(np.array(numbers)[which]))

    seen = []
    for which, found in each_alike(do, len(numbers)):
        seen.extend(which.tolist())
        if found is None:
            continue
        alone = [of_one(numbers[i]) for i in which]
        together = np.broadcast_to(np.asarray(found), max(len(which), np.size(found)))
        assert together[: len(which)].tolist() == pytest.approx(alone, rel=ROUNDING)
    assert sorted(seen) == list(range(len(numbers)))


@pytest.mark.parametrize(
    "of_many",
    [float, int, math.sqrt, math.isfinite, list, len, round, lambda x: x[0], lambda x: [1, 2][x],
     lambda x: {x: 1}, lambda x: max([1.0, x]) if isinstance(x[0], float) else None],
)  # fmt: skip
def test_no_number_of_one_design_stands_for_all(of_many):
    with pytest.raises(TypeError):
        of_many(Rows.of(np.arange(5.0)))


def test_what_is_found_at_length_is_found_once_for_each_design():
    numbers, asked = np.arange(400.0), []

    def do(which):
        x = Rows.of(numbers[which])
        square = found_once("square", "x", lambda: (asked.append(len(which)), x * x)[1])
        rest = 0
        while square > (rest + 1) * 40_000.0:
            rest += 1
        return square, rest

    for which, (square, rest) in each_alike(do, len(numbers)):
        assert np.asarray(square)[: len(which)].tolist() == (numbers[which] ** 2).tolist()
        assert set((numbers[which] ** 2 - 1e-9) // 40_000.0) <= {rest, -1.0}
    assert asked == [400]


def test_what_is_for_one_design_is_left_to_each_alone():
    def do(which):
        x = Rows.of(np.arange(200.0)[which])
        if x > 99.0:
            one_alone()
        return x

    found = {found is None: which.tolist() for which, found in each_alike(do, 200)}
    assert sorted(found[True]) == list(range(100, 200))
    assert sorted(found[False]) == list(range(100))


def test_what_is_found_design_by_design_is_of_all():
    numbers = np.arange(1.0, 151.0)

    def find(pair, words):
        x, y = pair
        assert type(x) is float
        return {"sum": (x + y, words), "root": None if x > 100.0 else math.sqrt(x)}

    seen, once = [], {"name": "sum and root", "about": None}
    for which, found in each_alike(
        lambda which: design_by_design(find, (Rows.of(numbers[which]), 2.0), "told", **once), 150
    ):
        seen.extend(which.tolist())
        total, word = found["sum"]
        assert np.asarray(total)[: len(which)].tolist() == (numbers[which] + 2.0).tolist()
        assert word == "told"
        if (which < 100).all():
            root = np.asarray(found["root"])[: len(which)]
            assert root.tolist() == pytest.approx(np.sqrt(numbers[which]).tolist(), rel=ROUNDING)
        else:
            assert found["root"] is None
    assert sorted(seen) == list(range(150))
    assert design_by_design(find, (4.0, 1.0), "", **once) == {"sum": (5.0, ""), "root": 2.0}


def test_a_number_that_is_none_ends_a_pass():
    def do(which):
        return 1.0 / Rows.of((np.arange(200.0) - 7.0)[which])

    assert [found for _, found in each_alike(do, 200)] == [None]


def test_a_function_of_floats_is_asked_once_for_each_set_of_numbers():
    asked = []

    def find(x, y):
        asked.append((x, y))
        return x + y, x - y

    x, y = Rows.of(np.array([1.0, 2.0, 1.0])), 3.0
    together, apart = one_by_one(find, x, y)
    assert (list(np.asarray(together)), list(np.asarray(apart))) == ([4.0, 5.0, 4.0], [-2, -1, -2])
    assert len(asked) == 2
    assert one_by_one(find, 1.0, 2.0) == (3.0, -1.0)
