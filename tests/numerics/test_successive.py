"""Local optima of rows known only as numbers: known ones, those of the convex solver, outcomes."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from flexcli.errors import Outcome
from flexcli.numerics.black_box import BlackBox
from flexcli.numerics.geometric_program import minimize
from flexcli.numerics.log_utilisation import log_utilisation
from flexcli.numerics.many_starts import solve, spread, starts_among
from flexcli.numerics.ratios import Ratio
from flexcli.numerics.signomial import Signomial, as_signomial
from flexcli.numerics.successive import descend


def black_box(rows, names, inequalities, *, half=15.0):
    n = len(names)
    return BlackBox(tuple(names), rows, inequalities, np.full(n, -half), np.full(n, half))


def solved(programs, starts):
    """The best end of given starts, its rows named by their places."""
    program = programs[0]
    rows = program.rows(np.array(starts[0])[:, None]).shape[0] - 1
    names = [str(k) for k in range(rows)]
    count = program.inequalities
    return solve(programs, lambda: starts, names[:count], names[count:])


def hs71(y):
    """Hock and Schittkowski's problem 71, whose optimum is printed as 17.0140173."""
    a, b, c, d = np.exp(y)
    bounds = [log_utilisation(1.0, x) for x in (a, b, c, d)]
    bounds += [log_utilisation(x, 5.0) for x in (a, b, c, d)]
    return np.array(
        [np.log(a * d * (a + b + c) + c), log_utilisation(25.0, a * b * c * d), *bounds,
         np.log((a * a + b * b + c * c + d * d) / 40.0)]
    )  # fmt: skip


def test_hock_and_schittkowski_71_is_solved_to_its_printed_digits():
    found = descend(black_box(hs71, "abcd", 9), np.log([1.0, 5.0, 5.0, 1.0]))
    assert found.outcome is Outcome.CONVERGED
    assert np.exp(found.values[0]) == pytest.approx(17.0140173, abs=5e-8)
    assert found.residual < 1e-9
    assert found.violation < 1e-12


def outside_a_circle(y):
    """Least 2x + z for 1 ≤ x, z ≤ 10 outside a circle of radius 5: two corners are optima."""
    x, z = np.exp(y)
    return np.array(
        [np.log(2 * x + z), log_utilisation(25.0, x * x + z * z), log_utilisation(1.0, x),
         log_utilisation(1.0, z), log_utilisation(x, 10.0), log_utilisation(z, 10.0)]
    )  # fmt: skip


def test_of_two_optima_outside_a_circle_many_starts_find_the_better():
    program = black_box(outside_a_circle, "xz", 5)
    near = descend(program, np.log([4.8, 1.1]))
    assert np.exp(near.y) == pytest.approx([np.sqrt(24), 1.0], rel=1e-9)
    points = spread(np.zeros(2), np.log([10.0, 10.0]), 64)
    starts = [*starts_among(program, points, 4), np.log([4.8, 1.1])]
    found = solved([program], starts)
    assert list(found.x.values()) == pytest.approx([1.0, np.sqrt(24)], rel=1e-9)
    assert found.optima == 2
    assert found.unique


@st.composite
def geometric_programs(draw):
    """Random posynomials with a box: an objective and rows that the centre keeps."""
    rng = np.random.default_rng(draw(st.integers(0, 2**32)))
    n, count = draw(st.integers(1, 3)), draw(st.integers(1, 4))
    names = ("x", "y", "z")[:n]

    def posynomial(terms):
        exponents = rng.integers(-3, 4, size=(terms, n)).astype(float)
        assume(len({tuple(row) for row in exponents.tolist()}) == terms)
        return Signomial(names, rng.uniform(0.1, 1.0, terms), exponents)

    goal = posynomial(int(rng.integers(1, 4)))
    limits = []
    for k in range(count):
        row = posynomial(int(rng.integers(1, 4)))
        limits.append((f"row {k}", row * (0.7 / row.coefficients.sum())))
    for i, name in enumerate(names):
        for sign in (1.0, -1.0):
            bound = np.where(np.arange(n) == i, sign, 0.0)[None, :]
            limits.append((f"{name} {sign}", Signomial(names, np.array([0.05]), bound)))
    return goal, limits, names


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(geometric_programs())
def test_a_posynomial_as_numbers_has_the_optimum_of_the_convex_solver(problem):
    goal, limits, names = problem
    one = as_signomial(1.0)
    exact = minimize([goal], [Ratio(name, row, one) for name, row in limits], [], names)

    def rows(y):
        x = dict(zip(names, np.exp(y), strict=True))
        values = [np.log(goal.at(**x)), *(log_utilisation(row.at(**x), 1.0) for _, row in limits)]
        return np.array([np.broadcast_to(value, y.shape[1:]) for value in values])

    found = descend(black_box(rows, names, len(limits)), np.zeros(len(names)))
    assert found.outcome is Outcome.CONVERGED
    # it ends where a step gains less than 1e-9, and many such may be left
    assert found.values[0] == pytest.approx(np.log(exact.objective), abs=2e-6)
    if exact.unique:
        x = np.array([exact.x[name] for name in names])
        # about a flat optimum that is a distance of its root
        assert found.y == pytest.approx(np.log(x), abs=2e-3)


def test_what_cannot_hold_ends_at_the_least_violation_with_its_weights():
    def rows(y):
        x, z = np.exp(y)
        return np.array(
            [np.log(x + z), log_utilisation(2.0, x * z), log_utilisation(x, 0.5),
             log_utilisation(z, 0.5)]
        )  # fmt: skip

    found = descend(black_box(rows, "xz", 3), np.array([1.0, -2.0]))
    assert found.outcome is Outcome.INFEASIBLE
    # x z = 2/t, x = z = t/2: t³ = 8
    assert found.violation == pytest.approx(np.log(2.0), abs=1e-8)
    assert found.multipliers == pytest.approx([1 / 3] * 3, abs=1e-6)


def test_an_objective_without_an_end_runs_to_the_end_of_the_world():
    def rows(y):
        return np.array([y[0] + y[1], log_utilisation(np.exp(y[0]), 0.5)])

    assert descend(black_box(rows, "xz", 1), np.zeros(2)).outcome is Outcome.UNBOUNDED


def test_a_start_off_the_domain_is_no_optimum():
    rows = black_box(lambda y: np.array([np.where(y[0] < 0.0, np.nan, y[0])]), "x", 0)
    assert descend(rows, np.array([-1.0])).outcome is Outcome.STALLED


def test_a_domain_that_ends_on_the_way_is_not_left():
    def rows(y):
        return np.array([(y[0] - 1.0) ** 2 + np.where(y[0] > 3.0, np.nan, 0.0)])

    found = descend(black_box(rows, "x", 0), np.array([2.9]))
    assert found.outcome is Outcome.CONVERGED
    assert found.y == pytest.approx([1.0], abs=1e-8)


def test_ties_are_broken_by_the_next_objective_on_the_plane_of_equally_good_points():
    def rows_of(goal):
        def rows(y):
            x, z, w = np.exp(y)
            return np.array(
                [goal(y), log_utilisation(2.0, x * z), log_utilisation(1.0, w),
                 log_utilisation(x, 3.0)]
            )  # fmt: skip

        return black_box(rows, "xzw", 3)

    first, then = rows_of(lambda y: y[0] + y[1]), rows_of(lambda y: y[1] + y[2])
    found = solved([first, then], [np.log([2.0, 2.0, 2.0])])
    assert list(found.x.values()) == pytest.approx([3.0, 2.0 / 3.0, 1.0], rel=1e-9)
    assert found.tied
    assert found.unique
    alone = solved([first], [np.log([2.0, 2.0, 2.0])])
    assert not alone.unique


def test_starts_keep_their_distance_and_come_best_first():
    points = spread(np.full(2, -3.0), np.full(2, 3.0), 256)
    program = black_box(lambda y: np.array([y.sum(axis=0), 1.0 - y[0]]), "xz", 1)  # x ≥ e
    starts = starts_among(program, points, 4)
    assert len(starts) == 4
    assert all(start[0] >= 1.0 for start in starts)
    assert [s.sum() for s in starts] == sorted(s.sum() for s in starts)
    for i, start in enumerate(starts):
        assert all(np.abs(start - other).max() >= 1.0 for other in starts[:i])
