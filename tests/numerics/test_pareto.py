"""The Pareto front: what nothing beats in both costs."""

from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.pareto import pareto

COSTS = st.lists(st.tuples(*[st.integers(0, 9).map(float)] * 2), min_size=1, max_size=12)


@given(COSTS)
def test_every_choice_off_the_front_is_beaten_by_one_on_it(costs):
    front = pareto(*zip(*costs, strict=True))
    best = [row for row, on in zip(costs, front, strict=True) if on]
    assert best
    for row, on in zip(costs, front, strict=True):
        beaten = any(a <= row[0] and b <= row[1] and (a, b) != row for a, b in best)
        assert beaten is not on


def test_equals_stay_together_and_what_is_infinite_is_no_choice():
    inf = float("inf")
    assert pareto([1.0, 1.0, inf, 0.0], [2.0, 2.0, 0.0, inf]) == (True, True, False, False)
    assert pareto([inf], [1.0]) == (False,)
