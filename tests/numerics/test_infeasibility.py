"""The smallest set of rows that disagree."""

import math

import numpy as np
import pytest

from flexcli.numerics.infeasibility import conflict
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables

DIGITS = 1e-9  # solutions are polished to rounding; a margin of 1e5 for their conditioning


def test_three_rows_that_disagree_are_found_among_others():
    x, y = variables("x", "y")
    rows = [at_most("a", 3, x), at_most("b", x * y, 2), at_most("c", 1, y)]
    rows += [at_most("weaker", 0.5, y), at_most("apart", x, 100)]
    found = conflict(rows, [], ("x", "y"))
    assert found.members == ("a", "b", "c")
    assert found.smallest
    assert found.violation == pytest.approx(math.log(1.5) / 3, rel=DIGITS)
    assert found.certificate == "global"
    assert found.relaxations["a"] == pytest.approx(1.5, rel=DIGITS)
    # Dropping c leaves the weaker bound on y: 3·0.5 < 2 still holds.
    assert found.relaxations["c"] == pytest.approx(1.5, rel=DIGITS)


def test_a_smaller_set_is_found_although_phase_one_shows_a_larger():
    x, y = variables("x", "y")
    # Phase I balances the large three-row violation; the pair disagrees a little less.
    rows = [at_most("a", 9, x), at_most("b", x * y, 1), at_most("c", 9, y)]
    rows += [at_most("p", 4, x / y), at_most("q", x / y, 2)]
    found = conflict(rows, [], ("x", "y"))
    assert found.members == ("p", "q")
    assert found.smallest
    # The other three still disagree, so no relaxation of one row helps.
    assert found.relaxations == {"p": None, "q": None}


def test_equalities_take_part():
    x, y = variables("x", "y")
    rows = [at_most("a", 3, x), at_most("free", y, 100)]
    found = conflict(rows, [Equality("E", x, 0.5 * y / y)], ("x", "y"))
    assert found.members == ("a", "E")
    assert found.relaxations["E"] == pytest.approx(6.0, rel=DIGITS)


def test_satisfiable_rows_have_no_conflict_and_settled_rows_stand_alone():
    (x,) = variables("x")
    assert conflict([at_most("a", 1, x)], [], ("x",)).members == ()
    alone = conflict([at_most("a", 1, x), Settled("never", holds=False)], [], ("x",))
    assert alone.members == ("never",)
    assert alone.relaxations == {"never": None}


def test_a_nonconvex_conflict_says_local():
    x, y = variables("x", "y")
    rows = [at_most("sum", 3, x + y), at_most("b", x, 1), at_most("c", y, 1)]
    found = conflict(rows, [], ("x", "y"))
    assert found.certificate == "local"
    assert not found.smallest
    assert found.members == ("sum", "b", "c")
    assert found.relaxations == pytest.approx({"sum": 1.5, "b": 2.0, "c": 2.0}, rel=DIGITS)


@pytest.mark.parametrize("seed", range(4))
def test_random_conflicts_are_irreducible_and_obey_helly(seed):
    rng = np.random.default_rng(seed)
    n, names = 3, ("x", "y", "z")
    one = as_signomial(1.0)
    a = rng.normal(size=(12, n))
    rows = [
        Ratio(f"c{i}", Signomial(names, np.exp(rng.normal(0.7, 0.5, 1)), a[i : i + 1]), one)
        for i in range(12)
    ]
    found = conflict(rows, [], names)
    if found.violation <= 0:
        pytest.skip("satisfiable by chance")
    assert len(found.members) <= n + 1
    chosen = [row for row in rows if row.name in found.members]
    assert conflict(chosen, [], names).violation > 0
    for row in chosen:
        assert conflict([r for r in chosen if r is not row], [], names).members == ()
