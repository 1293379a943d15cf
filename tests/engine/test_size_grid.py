"""The manufacturing grid: the best feasible point against brute force, its price, its limits."""

from decimal import Decimal
from itertools import product

import numpy as np
import pytest
from judging import size_as_printed
from strategies import LOADS, crossed, design, rcc

from flexcli.engine import assess

COARSE = {"h": "10 um", "l": "0.5 mm", "b": "0.5 mm"}
BOUNDED = {
    "h": {"free": ["100 um", "1 mm"]},
    "l": {"free": ["5 mm", "30 mm"]},
    "b": {"free": ["1 mm", "12 mm"]},
}
STEPS = {"h": 10e-6, "l": 0.5e-3, "b": 0.5e-3}


def grid_spec(objective="least-volume", rounding=None, geometry=None):
    options = {"objective": objective, "round": rounding or COARSE}
    return design(geometry or rcc(**BOUNDED), LOADS, size=options)


def blade_of(result):
    return tuple(result.values[name].value for name in ("h", "l", "b"))


def every_point(spec, steps):
    """All grid points inside the bounds, and which of them are feasible."""
    axes = []
    for name in ("h", "l", "b"):
        extent, step = getattr(spec.geometry, name), Decimal(repr(steps[name]))
        count = range(1, int(Decimal(repr(extent.most)) / step) + 1)
        values = np.array([float(step * k) for k in count])
        axes.append(values[values >= extent.least])
    h, l, b = (x.reshape(-1) for x in np.meshgrid(*axes, indexing="ij"))
    margins = np.min(list(assess.factors(spec, h=h, l=l, b=b).values()), axis=0)
    return h, l, b, margins >= 1.0 - assess.ROUNDING


OBJECTIVES = {
    "least-volume": lambda h, l, b: h * l * b,
    "shortest": lambda h, l, b: l,
    "least-stiffness": lambda h, l, b: b * h**3 / l * (1 + 6e-3 / l + 12e-6 / l**2),
}


@pytest.mark.parametrize("objective", OBJECTIVES)
def test_the_point_is_the_best_of_all_that_are_feasible(objective):
    spec = grid_spec(objective)
    result = size_as_printed(spec, "spec")
    h, l, b, feasible = every_point(spec, STEPS)
    goal = np.where(feasible, OBJECTIVES[objective](h, l, b), np.inf)
    found = blade_of(result)
    # products of the same sizes in another order may round apart
    assert OBJECTIVES[objective](*found) == pytest.approx(goal.min(), rel=1e-12)
    ties = goal <= goal.min() * (1 + 1e-12)
    assert np.prod(found) == pytest.approx((h * l * b)[ties].min(), rel=1e-12)
    assert any("(proved" in remark for remark in result.sizing.remarks)
    assert result.status.value == "pass"


def test_the_point_nearest_to_the_balanced_design_is_taken():
    spec = grid_spec("balanced")
    result = size_as_printed(spec, "spec")
    h, l, b, feasible = every_point(spec, STEPS)
    ideal = [result.values[f"{n}_ideal"].value for n in ("h", "l", "b")]
    away = sum(abs(np.log(x / at)) for x, at in zip((h, l, b), ideal, strict=True))
    found = sum(abs(np.log(x / at)) for x, at in zip(blade_of(result), ideal, strict=True))
    assert found == pytest.approx(np.where(feasible, away, np.inf).min(), rel=1e-9)


def test_rounding_to_the_nearest_corner_often_fails_where_the_search_does_not():
    spec = grid_spec(rounding={"h": "50 um", "l": "1 mm", "b": "0.5 mm"})
    result = size_as_printed(spec, "spec")
    steps = {"h": 50e-6, "l": 1e-3, "b": 0.5e-3}
    ideal = {n: result.values[f"{n}_ideal"].value for n in ("h", "l", "b")}
    corners = product(*[
        (np.floor(ideal[n] / s) * s, np.ceil(ideal[n] / s) * s) for n, s in steps.items()
    ])  # fmt: skip
    feasible = [
        min(assess.factors(spec, **dict(zip("hlb", corner, strict=True))).values())
        >= 1 - assess.ROUNDING
        for corner in corners if min(corner) > 0
    ]  # fmt: skip
    assert not any(feasible)
    assert result.status.value == "pass"
    h, l, b, holds = every_point(spec, steps)
    assert np.prod(blade_of(result)) == pytest.approx((h * l * b)[holds].min(), rel=1e-12)


def test_margins_are_those_of_the_point_and_its_price_is_told():
    result = size_as_printed(grid_spec(), "spec")
    ideal = np.prod([result.values[f"{n}_ideal"].value for n in ("h", "l", "b")])
    price = np.prod(blade_of(result)) / ideal - 1
    assert price > 0
    assert any(f"costs {price:+.1%} volume" in remark for remark in result.sizing.remarks)
    fixed = {n: f"{x!r} m" for n, x in zip("hlb", blade_of(result), strict=True)}
    margins = assess.factors(
        design(rcc(**fixed), LOADS), **dict(zip("hlb", blade_of(result), strict=True))
    )
    assert sorted(c.margin for c in result.checks) == pytest.approx(
        sorted(float(m) - 1 for m in margins.values())
    )


def test_points_are_the_decimal_multiples_of_the_step():
    h, l, b = blade_of(size_as_printed(grid_spec(), "spec"))
    assert [float(f"{x:.7g}") for x in (h, l, b)] == [h, l, b]


def test_sizes_that_are_chosen_have_no_error_and_the_optimum_has_one_that_nobody_knows():
    values = size_as_printed(grid_spec(), "spec").values
    assert [values[name].estimated_error for name in ("h", "l", "b")] == [0.0, 0.0, 0.0]
    assert values["h_ideal"].estimated_error is None


def test_a_stock_list_is_searched_beyond_its_nearest_sizes():
    spec = grid_spec(rounding={"h": ["0.1 mm", "0.3 mm", "0.7 mm"], "l": "0.5 mm", "b": ["10 mm"]})
    result = size_as_printed(spec, "spec")
    h, l, b = blade_of(result)
    assert h in (1e-4, 3e-4, 7e-4)
    assert b == 10e-3
    lengths = np.arange(1, 61) * 0.5e-3
    volumes = [
        thick * long * b
        for thick in (1e-4, 3e-4, 7e-4)
        for long in lengths
        if min(assess.factors(spec, h=np.array(thick), l=np.array(long), b=np.array(b)).values())
        >= 1 - 1e-9
        and 5e-3 <= long <= 30e-3
    ]
    assert h * l * b == pytest.approx(min(volumes), rel=1e-12)


@pytest.mark.parametrize("step", ["1 nm", "1e-15 m"])
def test_a_grid_finer_than_needed_costs_nothing(step):
    result = size_as_printed(grid_spec(rounding={"h": step, "l": step, "b": step}), "spec")
    assert result.status.value == "pass"
    ideal = [result.values[f"{n}_ideal"].value for n in ("h", "l", "b")]
    assert np.prod(blade_of(result)) == pytest.approx(np.prod(ideal), rel=1e-4)


@pytest.mark.slow
def test_a_dimension_without_grid_stays_continuous_and_optimal():
    spec = grid_spec(rounding={"h": "10 um", "l": "0.5 mm"})
    result = size_as_printed(spec, "spec")
    assert any("(proved" in remark for remark in result.sizing.remarks)
    h, l, b = blade_of(result)
    axes = np.arange(10, 101) * 10e-6, np.arange(10, 61) * 0.5e-3
    best = np.inf
    for thick in axes[0]:
        # the margins of buckling and yield are linear in b, the fatigue margin does not see it;
        # buckling across the width is far away
        margins = assess.factors(spec, h=np.array(thick), l=axes[1], b=np.array(12e-3))
        scale = np.minimum(margins["buckling, push"], margins["yield (fatigue-amplitude), push"])
        ok = (margins["fatigue, bend"] >= 1 - 1e-9) & (scale >= 1)
        width = np.maximum(12e-3 / scale, 1e-3)
        best = min(best, np.where(ok, thick * axes[1] * width, np.inf).min())
    assert h * l * b == pytest.approx(best, rel=1e-7)


def test_a_grid_without_a_feasible_point_is_infeasible_and_says_so():
    spec = grid_spec(rounding={"h": ["0.9 mm"], "l": ["5 mm"], "b": "0.5 mm"})
    result = size_as_printed(spec, "spec")
    assert result.status.value == "infeasible"
    assert result.checks == ()
    (note,) = (n for n in result.warnings if n.code == "no-grid-point")
    assert note.text.startswith("the manufacturing grid has no feasible design")


def test_a_grid_on_a_fixed_dimension_changes_nothing():
    geometry = rcc(**(BOUNDED | {"b": "9.9 mm"}))
    spec = design(geometry, LOADS, size={"round": {"b": "1 mm"}})
    assert blade_of(size_as_printed(spec, "spec"))[2] == 9.9e-3


def test_a_grid_of_a_curved_program_is_searched_and_not_called_proved():
    geometry = crossed(p="-2 mm", **BOUNDED)
    result = size_as_printed(grid_spec(geometry=geometry), "spec")
    assert result.status.value == "pass"
    spec = grid_spec(geometry=geometry)
    h, l, b, feasible = every_point(spec, STEPS)
    assert np.prod(blade_of(result)) <= (h * l * b)[feasible].min() * 1.2
    assert any("best of those searched" in remark for remark in result.sizing.remarks)
