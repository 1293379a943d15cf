"""The smallest set of rows that disagree."""

import math

import numpy as np
import pytest

from flexcli.numerics.infeasibility import conflict
from flexcli.numerics.many_starts import spread
from flexcli.numerics.ratios import Equality, Ratio, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.numerics.signomial_program import signomial_program

DIGITS = 1e-9  # solutions are polished to rounding; a margin of 1e5 for their conditioning
ONE = as_signomial(1.0)


def conflict_of(rows, names):
    """The conflict of rows, by their names; an equality is the pair of ratios that meet at one."""
    ratios, owners = [], []
    for k, row in enumerate(rows):
        sides = [(row.numerator, row.denominator), (row.denominator, row.numerator)]
        for above, below in sides if isinstance(row, Equality) else sides[:1]:
            ratios.append(Ratio(row.name, above, below))
            owners.append(k)
    program = signomial_program(Ratio("none", ONE, ONE), ratios, [], names)
    points = spread(np.full(len(names), -5.0), np.full(len(names), 5.0), 64)
    found = conflict(program, owners, points)
    return found, tuple(rows[k].name for k in found.members)


def test_three_rows_that_disagree_are_found_among_others():
    x, y = variables("x", "y")
    rows = [at_most("a", 3, x), at_most("b", x * y, 2), at_most("c", 1, y)]
    rows += [at_most("weaker", 0.5, y), at_most("apart", x, 100)]
    found, members = conflict_of(rows, ("x", "y"))
    assert members == ("a", "b", "c")
    assert found.smallest
    assert found.violation == pytest.approx(math.log(1.5) / 3, rel=DIGITS)


def test_a_smaller_set_is_found_although_phase_one_shows_a_larger():
    x, y = variables("x", "y")
    # Phase I balances the large three-row violation; the pair disagrees a little less.
    rows = [at_most("a", 9, x), at_most("b", x * y, 1), at_most("c", 9, y)]
    rows += [at_most("p", 4, x / y), at_most("q", x / y, 2)]
    found, members = conflict_of(rows, ("x", "y"))
    assert members == ("p", "q")
    assert found.smallest


def test_equalities_take_part():
    x, y = variables("x", "y")
    rows = [at_most("a", 3, x), at_most("free", y, 100), Equality("E", x, 0.5 * y / y)]
    assert conflict_of(rows, ("x", "y"))[1] == ("a", "E")


def test_satisfiable_rows_have_no_conflict():
    (x,) = variables("x")
    assert conflict_of([at_most("a", 1, x)], ("x",))[1] == ()


def test_a_conflict_of_rows_that_are_not_convex_is_not_called_smallest():
    x, y = variables("x", "y")
    rows = [at_most("sum", 3, x + y), at_most("b", x, 1), at_most("c", y, 1)]
    found, members = conflict_of(rows, ("x", "y"))
    assert not found.smallest
    assert members == ("sum", "b", "c")


@pytest.mark.parametrize("seed", range(4))
def test_random_conflicts_are_irreducible_and_obey_helly(seed):
    rng = np.random.default_rng(seed)
    n, names = 3, ("x", "y", "z")
    a = rng.normal(size=(12, n))
    rows = [
        Ratio(f"c{i}", Signomial(names, np.exp(rng.normal(0.7, 0.5, 1)), a[i : i + 1]), ONE)
        for i in range(12)
    ]
    found, members = conflict_of(rows, names)
    if found.violation <= 0:
        pytest.skip("satisfiable by chance")
    assert len(members) <= n + 1
    chosen = [row for row in rows if row.name in members]
    assert conflict_of(chosen, names)[0].violation > 0
    for row in chosen:
        assert conflict_of([r for r in chosen if r is not row], names)[1] == ()
