"""Models beside each other: when a finest value is sure, and time that quantities share."""

from math import nan

import numpy as np
import pytest

from flexcli.engine.comparing.compared import UNSURE, Reference, Timed, compared, relative_bound
from flexcli.engine.comparing.time_accuracy import TimeNumber


class Model:
    def __init__(self, name):
        self.name = name


def test_the_bound_is_the_distance_to_the_control_and_its_tolerance():
    assert relative_bound(2.0, 2.002, 1e-6) == pytest.approx(1e-3 + 1e-6, rel=1e-9)


@pytest.mark.parametrize("pair", [(0.0, 0.0), (1.0, 1.0 + 1.1 * UNSURE), (1.0, nan), (nan, 1.0)])
def test_a_value_without_a_control_that_agrees_is_not_sure(pair):
    assert relative_bound(*pair, 1e-12) is None


def test_one_run_that_gives_two_quantities_is_paid_once():
    settled = [Reference(TimeNumber(name, name, "m"), 1.0, 1e-12) for name in "xy"]
    seconds = np.full((1, 2, 2), 3.0)
    shared = Timed(np.ones((2, 2)), seconds, np.full((1, 2), 3.0))
    found = compared(settled, [Model("a"), Model("b")], shared, 0.1)
    assert [model.seconds for model in found.models] == [3.0, 3.0]
    assert [r.seconds for q in found.quantities for r in q.readings] == [3.0] * 4


def test_a_model_that_lacks_a_quantity_has_no_time_of_all_even_where_it_is_shared():
    settled = [Reference(TimeNumber(name, name, "m"), 1.0, 1e-12) for name in "xy"]
    values = np.array([[1.0, nan], [1.0, 1.0]])
    found = compared(
        settled, [Model("a"), Model("b")],
        Timed(values, np.full((1, 2, 2), 3.0), np.array([[1.0, 3.0]])), 0.1,
    )  # fmt: skip
    assert found.recommended == "b"
    assert found.models[0].seconds == np.inf
    assert not found.models[0].pareto
