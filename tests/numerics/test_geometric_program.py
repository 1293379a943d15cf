"""Geometric programs: optima, multipliers, certificates, failures."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog
from scipy.optimize import minimize as scipy_minimize

from flexcli.errors import Outcome
from flexcli.numerics.geometric_program import minimize
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.numerics.signomial_program import signomial_program

DIGITS = 1e-10  # solutions are polished to rounding; logarithms of size 50 leave some 1e-14
ONE = as_signomial(1.0)
E, SIGMA, S, THETA, P, F = 114e9, 500e6, 2.5, 0.0205, 2e-3, 640.84


def least(goal, rows, equalities, names, starts=()):
    """The least of one objective, from given starts where it is not convex."""
    return minimize([goal], rows, equalities, names, lambda _: [np.log(start) for start in starts])


def pivot_rows(h, l, b, theta=THETA):
    """The pivot's ratios, as closures over floats, arrays or signomials."""
    return {
        "fatigue": S * E * h * theta * (2 / l + 3 * P / l**2) / SIGMA,
        "buckling": S * F * 3 * l**2 / (math.sqrt(2) * math.pi**2 * E * b * h**3),
        "yield": S * F / (math.sqrt(2) * SIGMA * h * b),
    }


def pivot(theta=THETA):
    h, l, b = variables("h", "l", "b")
    rows = [Ratio(name, value, ONE) for name, value in pivot_rows(h, l, b, theta).items()]
    return h * l * b, rows, ("h", "l", "b")


def test_least_volume_of_the_pivot_agrees_with_a_general_solver():
    volume, rows, names = pivot()
    found = least(volume, rows, [], names)
    other = scipy_minimize(
        lambda y: y.sum(),
        np.log([3e-4, 1e-2, 1e-2]),
        constraints={
            "type": "ineq",
            "fun": lambda y: -np.log(list(pivot_rows(*np.exp(y)).values())),
        },
        method="SLSQP",
        options={"ftol": 1e-14, "maxiter": 500},
    )
    assert found.outcome is Outcome.CONVERGED
    assert found.certificate == "global"
    assert found.unique
    # SLSQP works with difference quotients: 1e-8 of ln V.
    assert math.log(found.objective) == pytest.approx(other.fun, abs=1e-6)
    assert found.active == ("fatigue", "buckling")
    # By hand: hlb = hl·(l/h³)·..; dV/dl = 0 with h from fatigue gives l = 3p/2.
    assert found.x["l"] == pytest.approx(1.5 * P, rel=DIGITS)
    assert found.multipliers == pytest.approx({"fatigue": 2, "buckling": 1, "yield": 0}, abs=1e-9)
    assert found.gap <= 1e-12
    assert found.kkt_residual <= DIGITS


def test_multipliers_are_the_price_of_each_constraint():
    volume, rows, names = pivot()
    price = least(volume, rows, [], names).multipliers
    for i, row in enumerate(rows):
        values = []
        for relax in (1e-4, -1e-4):
            changed = list(rows)
            changed[i] = Ratio(row.name, row.numerator * math.exp(-relax), ONE)
            values.append(math.log(least(volume, changed, [], names).objective))
        assert (values[1] - values[0]) / 2e-4 == pytest.approx(price[row.name], abs=1e-6)


@st.composite
def known_optimum(draw):
    """A random program whose optimum is known: the multipliers are chosen, then the objective."""
    seed = draw(st.integers(0, 2**32 - 1))
    rng = np.random.default_rng(seed)
    n = draw(st.integers(1, 5))
    m = draw(st.integers(1, 6))
    names = tuple(f"x{i}" for i in range(n))
    y = rng.normal(0, draw(st.sampled_from([1.0, 10.0])), n)
    rows, pull, prices = [], np.zeros(n), {}
    for i in range(m):
        a = rng.normal(0, 1, (draw(st.integers(1, 4)), n))
        shares = rng.dirichlet(np.ones(len(a)))
        active = rng.random() < 0.6
        b = np.log(shares) - a @ y - (0.0 if active else rng.uniform(0.05, 3))
        rows.append(Ratio(f"c{i}", Signomial(names, np.exp(b), a), ONE))
        prices[f"c{i}"] = rng.uniform(0.2, 3) if active else 0.0
        pull += prices[f"c{i}"] * (shares @ a)
    # Objective terms whose mean exponent balances the pull of the constraints.
    a = rng.normal(0, 1, (n + 2, n))
    shares = rng.dirichlet(np.ones(n + 2) * 3)
    a += -pull - shares @ a
    objective = Signomial(names, shares * np.exp(-a @ y), a)
    return names, objective, rows, y, prices


@settings(max_examples=60, deadline=None)
@given(known_optimum())
def test_random_programs_reach_their_known_optimum(case):
    names, objective, rows, y, _ = case
    found = least(objective, rows, [], names)
    assert found.outcome is Outcome.CONVERGED
    assert math.log(found.objective) == pytest.approx(0.0, abs=1e-10)
    # n + 2 spread terms curve the objective in all directions, some of them weakly.
    np.testing.assert_allclose(np.log(list(found.x.values())), y, atol=1e-6)
    assert found.kkt_residual <= 1e-9
    # Weak duality: the multipliers bound the objective of any point from below.
    for seed in range(3):
        other = dict(
            zip(names, np.exp(y + np.random.default_rng(seed).normal(0, 1, len(y))), strict=True)
        )
        bound = math.log(objective.at(**other)) + sum(
            found.multipliers[row.name] * math.log(row.numerator.at(**other)) for row in rows
        )
        assert bound >= math.log(found.objective) - 1e-9


@settings(max_examples=25, deadline=None)
@given(st.lists(st.sampled_from([1e-6, 1.0, 1e3, 1e6]), min_size=3, max_size=3))
def test_units_do_not_change_the_design(units):
    volume, rows, names = pivot()
    scaled = [u * v for u, v in zip(units, variables(*names), strict=True)]
    rescaled = [Ratio(n, value, ONE) for n, value in pivot_rows(*scaled).items()]
    h, l, b = scaled
    found, reference = least(h * l * b, rescaled, [], names), least(volume, rows, [], names)
    for unit, name in zip(units, names, strict=True):
        assert unit * found.x[name] == pytest.approx(reference.x[name], rel=1e-9)


def test_gradients_and_curvature_agree_with_differences():
    x, y, z = variables("x", "y", "z")
    goal = Ratio("goal", x + y * z**2, 1 + x * z)
    rows = [Ratio("a", 1 / x + 2 / y**1.5 + z, 3 * y), Ratio("b", x * y, x + z + 1)]
    problem = signomial_program(goal, rows, [Equality("e", x + y, z**2 + 1)], ("x", "y", "z"))
    rng = np.random.default_rng(7)
    weights = rng.normal(size=4)
    step = 1e-6  # central differences: 1e-12 of truncation, 1e-10 of rounding
    for point in rng.normal(size=(4, 3)):
        at = problem.expand(point)
        np.testing.assert_allclose(problem.rows(point), at.values, rtol=1e-13, atol=1e-15)
        plus = [problem.expand(point + step * e) for e in np.eye(3)]
        minus = [problem.expand(point - step * e) for e in np.eye(3)]
        slopes = [(p.values - m.values) / (2 * step) for p, m in zip(plus, minus, strict=True)]
        bends = [
            weights @ (p.jacobian - m.jacobian) / (2 * step)
            for p, m in zip(plus, minus, strict=True)
        ]
        np.testing.assert_allclose(at.jacobian, np.transpose(slopes), atol=1e-8)
        np.testing.assert_allclose(at.curvature(weights), bends, atol=1e-8)


def test_the_model_of_a_ratio_touches_it_and_lies_above():
    x, y = variables("x", "y")
    row = Ratio("a", 1 / x + 2 / y**1.5, 3 * y + x**2 + x * y)
    problem = signomial_program(row, [], [], ("x", "y"))
    rng = np.random.default_rng(3)
    for point in rng.normal(size=(5, 2)):
        model = problem.model(problem.expand(point), point)
        assert model.values(np.zeros(2)) == pytest.approx(problem.rows(point), abs=1e-12)
        steps = rng.normal(scale=2.0, size=(2, 50))
        assert np.all(model.values(steps) >= problem.rows(point[:, None] + steps) - 1e-12)


def test_an_infeasible_program_reports_its_least_violation():
    (x,) = variables("x")
    found = least(x, [at_most("low", 4, x), at_most("high", x, 1)], [], ("x",))
    assert found.outcome is Outcome.INFEASIBLE
    assert found.violation == pytest.approx(math.log(2), rel=DIGITS)
    assert least(x, [Settled("never", holds=False)], [], ("x",)).outcome is Outcome.INFEASIBLE
    twice = [Equality("one", x, ONE), Equality("two", x, 2 * ONE)]
    assert least(x, [], twice, ("x",)).outcome is Outcome.INFEASIBLE


def test_an_unbounded_program_names_what_runs_away():
    x, y, z = variables("x", "y", "z")
    found = least(x / y, [at_most("a", 1, z), at_most("b", z, 2)], [], ("x", "y", "z"))
    assert found.outcome is Outcome.UNBOUNDED
    assert found.runaway == ("x", "y")


def test_a_flat_optimum_is_not_unique_and_the_next_objective_decides():
    x, y = variables("x", "y")
    rows = [at_most("area", 1, x * y), at_most("low", 1, x), at_most("high", x, 10.0)]
    assert not least(x * y, rows, [], ("x", "y")).unique
    found = minimize([x * y, y], rows, [], ("x", "y"))
    assert found.tied
    assert found.unique
    assert found.x == pytest.approx({"x": 10.0, "y": 0.1}, rel=DIGITS)
    assert found.objective == pytest.approx(1.0, rel=1e-9)
    assert set(found.active) == {"area", "high"}
    assert found.multipliers["area"] == pytest.approx(1.0)
    assert not minimize([x + y, y], rows, [], ("x", "y")).tied


def test_sets_without_interior_are_solved_on_their_face():
    x, y = variables("x", "y")
    rows = [at_most("low", 2, x), at_most("high", x, 2), at_most("c", x, y)]
    found = least(x * y, rows, [], ("x", "y"))
    assert found.outcome is Outcome.CONVERGED
    assert found.x == pytest.approx({"x": 2.0, "y": 2.0}, rel=1e-12)
    assert found.kkt_residual <= DIGITS
    point = least(x, [at_most("only x = 1", x + 1 / x, 2)], [], ("x",))
    assert point.x["x"] == pytest.approx(1.0, abs=1e-6)
    assert point.unique


def test_a_program_without_free_variables_is_checked():
    assert least(as_signomial(3.0), [], [], ()).objective == pytest.approx(3.0)
    good, bad = (Ratio("c", as_signomial(v), ONE) for v in (0.5, 2.0))
    assert least(as_signomial(3.0), [good], [], ()).slack["c"] == pytest.approx(math.log(0.5))
    assert least(as_signomial(3.0), [bad], [], ()).outcome is Outcome.INFEASIBLE


def test_redundant_equalities_and_wild_coefficients_do_no_harm():
    x, y = variables("x", "y")
    same = [Equality("e", x * y, 1e-30 * ONE), Equality("twice", 1e30 * x**2 * y**2, 1e-30 * ONE)]
    found = least(1e30 * x + 1e28 * y, [], same, ("x", "y"))
    assert found.outcome is Outcome.CONVERGED
    assert found.kkt_residual <= 1e-9
    # Both terms are equal at the optimum: x/y = 1e-2 and xy = 1e-30.
    assert found.x == pytest.approx({"x": 1e-16, "y": 1e-14}, rel=1e-11)
    bounds = [at_most("a", 1e30, x), at_most("b", x, 1e31), at_most("c", x * y**2, 1e-25)]
    found = least(x / y, bounds, [], ("x", "y"))
    assert found.x["x"] == pytest.approx(1e30, rel=DIGITS)
    assert found.x["y"] == pytest.approx(math.sqrt(1e-55), rel=DIGITS)


def test_a_curved_equality_is_met_by_newton():
    x, y = variables("x", "y")
    found = least(x + y, [], [Equality("q", x + y**2, x * y)], ("x", "y"), [[1.0, 3.0]])
    # x = y²/(y−1): the derivative of x + y vanishes at 2(y−1)² = 1.
    assert found.x["y"] == pytest.approx(1 + math.sqrt(0.5), rel=DIGITS)
    assert found.certificate == "local"


def negative_p_rows(h, l, b, p=-4e-3):
    """Fatigue at both ends with both signs: (name, demand, capacity)."""
    bound = SIGMA / (S * E * THETA)
    for name, curvature in (("clamp", 2 / l + 3 * p / l**2), ("free", 1 / l + 3 * p / l**2)):
        for sign in (1, -1):
            yield f"fatigue {name} {sign:+d}", sign * h * curvature, bound
    yield "buckling", S * F * 3 * l**2 / (math.sqrt(2) * math.pi**2 * E * b * h**3), 1.0
    yield "yield", S * F / (math.sqrt(2) * SIGMA * h * b), 1.0


@pytest.mark.parametrize(("low", "high"), [(1e-3, 7.9e-3), (8.1e-3, 0.1)])
def test_rows_that_are_not_convex_agree_with_a_dense_scan_on_both_branches(low, high):
    h, l, b = variables("h", "l", "b")
    rows = [at_most(*row) for row in negative_p_rows(h, l, b)]
    rows += [at_most("shortest", low, l), at_most("longest", l, high), at_most("thin", h, 2e-3)]
    starts = [[3e-4, length, 1e-2] for length in np.geomspace(low, high, 4)]
    found = least(h * l * b, rows, [], ("h", "l", "b"), starts)
    assert found.outcome is Outcome.CONVERGED
    assert found.certificate == "local"
    assert found.kkt_residual <= DIGITS
    # For a length: b follows from buckling and yield, V falls with h, so h is the largest.
    lengths = np.geomspace(low, high, 200_001)
    steepest = np.maximum(
        np.abs(2 / lengths - 0.012 / lengths**2), np.abs(1 / lengths - 0.012 / lengths**2)
    )
    thick = np.minimum(SIGMA / (S * E * THETA) / steepest, 2e-3)
    wide = np.maximum(
        S * F * 3 * lengths**2 / (math.sqrt(2) * math.pi**2 * E * thick**3),
        S * F / (math.sqrt(2) * SIGMA * thick),
    )
    scanned = (thick * lengths * wide).min()
    # The scan's step of 2e-5 in ln l, at a kink: 1e-4 of the volume at most.
    assert found.objective == pytest.approx(scanned, rel=1e-4)
    assert found.objective <= scanned * (1 + 1e-9)


def test_wrong_names_are_refused():
    x, y = variables("x", "y")
    with pytest.raises(ValueError, match="'y' occurs"):
        least(x * y, [], [], ("x",))
    with pytest.raises(ValueError, match="not a posynomial"):
        least(x - y, [], [], ("x", "y"))


@pytest.mark.parametrize("seed", range(40))
def test_monomial_programs_agree_with_linear_programming(seed):
    rng = np.random.default_rng(seed)
    n, m = int(rng.integers(1, 6)), int(rng.integers(1, 10))
    names = tuple(f"x{i}" for i in range(n))
    A, b = rng.integers(-2, 3, (m, n)).astype(float), rng.normal(0, 1, m)
    c = rng.integers(-2, 3, n).astype(float)
    rows = [
        Ratio(f"c{i}", Signomial(names, np.exp(-b[i : i + 1]), A[i : i + 1]), ONE) for i in range(m)
    ]
    found = least(Signomial(names, np.ones(1), c[None]), rows, [], names)
    other = linprog(c, A_ub=A, b_ub=b, bounds=(None, None))
    same = {0: Outcome.CONVERGED, 2: Outcome.INFEASIBLE, 3: Outcome.UNBOUNDED}
    assert found.outcome is same[other.status]
    if found.converged:
        assert math.log(found.objective) == pytest.approx(other.fun, abs=1e-8)


@pytest.mark.parametrize("width", [1e-5, 1e-7, 1e-8, 3e-9, 1e-9, 1e-10, 1e-12])
def test_bounds_that_almost_meet_cost_no_digits(width):
    x, y = variables("x", "y")
    rows = [at_most("low", 1, x), at_most("high", x, 1 + width), at_most("c", x**2 + 1 / x, y)]
    found = least(x * y, rows, [], ("x", "y"))
    assert found.outcome is Outcome.CONVERGED
    # Below the width at which an interior counts as empty, any point of it is the solution.
    assert found.objective == pytest.approx(2.0, rel=2e-9)
