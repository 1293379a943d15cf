"""Square systems of ratios."""

import math

import numpy as np
import pytest

from flexcli.numerics.ratios import Ratio
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.numerics.square_system import solve_square

AS_PRINTED = 1e-12  # condition number 63 times a few roundings
ONE = as_signomial(1.0)
E, SIGMA, S, THETA, P, F = 114e9, 500e6, 2.5, 0.0205, 2e-3, 640.84


def pivot(theta=THETA, factors=(1.0, 1.0, 1.0)):
    h, l, b = variables("h", "l", "b")
    rows = (
        S * E * h * theta * (2 / l + 3 * P / l**2) / SIGMA,
        S * F * 3 * l**2 / (math.sqrt(2) * math.pi**2 * E * b * h**3),
        S * F / (math.sqrt(2) * SIGMA * h * b),
    )
    return [
        Ratio(f"r{i}", c * row, ONE) for i, (c, row) in enumerate(zip(factors, rows, strict=True))
    ]


def test_the_fully_used_pivot_has_its_closed_form():
    (root,) = solve_square(pivot(), ("h", "l", "b"))
    slender = math.pi * math.sqrt(E / (3 * SIGMA))
    h = 9 * S * P * THETA / (math.pi**2 - 6 * S * slender * THETA)
    closed = {"h": h, "l": slender * h, "b": F * S / (h * SIGMA * math.sqrt(2))}
    assert root.x == pytest.approx(closed, rel=AS_PRINTED)
    assert root.x["h"] == pytest.approx(637.1e-6, abs=0.05e-6)
    assert root.residual <= 2e-15


def test_a_larger_stroke_has_no_fully_used_design():
    assert solve_square(pivot(1.2 * THETA), ("h", "l", "b")) == []


def test_sensitivities_agree_with_differences():
    (root,) = solve_square(pivot(), ("h", "l", "b"))
    for i in range(3):
        ends = []
        for sign in (1, -1):
            factors = np.ones(3)
            factors[i] = math.exp(sign * 1e-5)
            (moved,) = solve_square(pivot(factors=factors), ("h", "l", "b"), [root.x])
            ends.append(np.log(list(moved.x.values())))
        slope = (ends[0] - ends[1]) / 2e-5
        np.testing.assert_allclose(slope, root.sensitivity[:, i], rtol=1e-6)


def test_all_roots_are_found():
    x, y = variables("x", "y")
    roots = solve_square(
        [Ratio("sum", x + y, 3 * ONE), Ratio("product", x * y, 2 * ONE)], ("x", "y")
    )
    found = sorted((root.x["x"], root.x["y"]) for root in roots)
    np.testing.assert_allclose(found, [(1, 2), (2, 1)], rtol=1e-13)


@pytest.mark.parametrize("closeness", [1e-3, 1e-6, 1e-9])
def test_an_ill_conditioned_system_loses_no_more_than_its_condition_number(closeness):
    names = ("x", "y")
    exponents = np.array([[1.0, 1.0], [1.0, 1.0 + closeness]])
    x, y = 2.0, 3.0
    rows = [
        Ratio(f"r{i}", Signomial(names, 1 / np.atleast_1d(x ** a[0] * y ** a[1]), a[None]), ONE)
        for i, a in enumerate(exponents)
    ]
    (root,) = solve_square(rows, names)
    assert root.condition == pytest.approx(4 / closeness, rel=0.01)
    assert root.residual <= 1e-15
    # A few roundings of the data, amplified by the condition number.
    assert root.x["x"] == pytest.approx(x, rel=4 * root.condition * np.finfo(float).eps)


def test_counts_must_match():
    x, _ = variables("x", "y")
    with pytest.raises(ValueError, match="1 ratios for 2 unknowns"):
        solve_square([Ratio("a", x, ONE)], ("x", "y"))
