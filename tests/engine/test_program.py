"""A design as rows of a program: every limit and bound, and what a row says when it gives way."""

import numpy as np
import pytest
from hypothesis import given, settings
from strategies import LOADS, crossed, design, rcc, specs

from flexcli.engine import assess
from flexcli.engine.sizing.problem import SizingProblem
from flexcli.engine.sizing.program import sizing_program
from flexcli.parts.geometries import Blade

AT = {"h": 3e-4, "l": 1.7e-2, "b": 6e-3}
ROUNDING = 1e-9  # signomials merge terms, which may cancel digits


@settings(max_examples=30)
@given(specs())
def test_a_row_holds_exactly_where_the_check_of_its_limit_passes(spec):
    program = sizing_program(SizingProblem(spec))
    blade = Blade(**({k: float(v) for k, v in AT.items()} | _fixed(spec)))
    x = {name: getattr(blade, name) for name in program.names}
    margins = assess.factors(spec, **{n: np.array(size) for n, size in blade._asdict().items()})
    used = {}
    for key, value in zip(program.constraints, program.at(program.constraints, x), strict=True):
        limit = program.rows[key].limit
        if limit is not None:
            used[limit.name] = max(used.get(limit.name, -np.inf), float(value[0]))
    for name, value in used.items():
        if abs(value) > 1e-6:
            assert (value < 0.0) == (margins[name] > 1.0), name


def _fixed(spec):
    extents = spec.geometry.extents
    return {name: e.fixed for name, e in extents.items() if e.fixed is not None}


def test_bounds_of_free_dimensions_are_rows_and_fixed_ones_are_none():
    spec = design(rcc(h={"free": [None, "1 mm"]}, b={"free": ["1 mm", None]}, l="20 mm"), LOADS)
    program = sizing_program(SizingProblem(spec))
    bounds = [key for key in program.constraints if program.rows[key].limit is None]
    assert bounds == ["most h", "least b"]
    assert program.names == ("h", "b")
    assert program.complete({"h": 1e-4, "b": 2e-3}) == Blade(1e-4, 2e-2, 2e-3)


@pytest.mark.parametrize("p", ["0 mm", "2 mm"])
@pytest.mark.parametrize("method", ["goodman", "soderberg", "swt", "none"])
def test_loads_on_a_remote_centre_are_all_convex(p, method):
    both = {
        "stroke": {"rotation": ["-1 deg", "3 deg"], "cycles": 1e6},
        "load": {"force": "50 N"},
        "ends": "clamped-guided",
    }
    asked = {"fatigue": {"factor": 2, "mean_stress": method}, "buckling": 2, "yield": 2}
    assert sizing_program(SizingProblem(design(rcc(p=p), asked, {"both": both}))).curved == ()


def test_a_crossing_at_a_fixed_place_is_not_convex_and_one_at_a_fixed_share_is():
    asked = {"fatigue": 2}
    assert sizing_program(SizingProblem(design(crossed(p="-2 mm"), asked))).curved
    assert not sizing_program(SizingProblem(design(crossed(delta=-0.5), asked))).curved


@pytest.mark.parametrize(
    ("objective", "expected"),
    [
        ("least-volume", lambda h, l, b, k: 2 * h * l * b),
        ("shortest", lambda h, l, b, k: l),
        ("least-stiffness", lambda h, l, b, k: k),
        ({"minimize": "k_pivot"}, lambda h, l, b, k: k),
        ({"minimize": "b"}, lambda h, l, b, k: b),
        ({"maximize": "h"}, lambda h, l, b, k: 1 / h),
    ],
)
def test_objectives_are_what_they_are_called(objective, expected):
    spec = design(rcc(), LOADS, size={"objective": objective})
    program = sizing_program(SizingProblem(spec))
    goal = program.goal(spec.sizing.objective)
    stiffness = spec.geometry.stiffness(spec.material.elastic, Blade(**AT))
    found = np.exp(goal.sign * program.at([goal.key], AT) + goal.shift)
    assert found == pytest.approx(expected(**AT, k=stiffness), rel=ROUNDING)


def test_targets_become_bands_of_their_tolerance():
    spec = design(rcc(), {"l/h": {"equals": 50, "tolerance": "2 %"}})
    program = sizing_program(SizingProblem(spec))
    above, below = program.banded()
    for term, side in ((above, 1.02), (below, 1 / 1.02)):
        on_rim = {"h": 1e-4, "l": 50 * side * 1e-4, "b": 1e-3}
        assert term.sign * program.at([term.key], on_rim) + term.shift == pytest.approx(
            0, abs=1e-12
        )
