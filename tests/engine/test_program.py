"""A design as rows of a program: every limit and bound, and what a row says when it gives way."""

import numpy as np
import pytest
from hypothesis import given, settings
from strategies import LOADS, crossed, design, rcc, specs

from flexcli.engine import assess
from flexcli.engine.sizing.program import objective_of, sizing_program
from flexcli.numerics.ratios import Ratio, Settled
from flexcli.parts.geometries import Blade

AT = {"h": 3e-4, "l": 1.7e-2, "b": 6e-3}
ROUNDING = 1e-9  # signomials merge terms, which may cancel digits


@settings(max_examples=30)
@given(specs())
def test_a_row_holds_exactly_where_the_check_of_its_limit_passes(spec):
    program = sizing_program(spec)
    blade = Blade(**({k: float(v) for k, v in AT.items()} | _fixed(spec)))
    x = {name: getattr(blade, name) for name in program.names}
    margins = assess.factors(spec, **{n: np.array(size) for n, size in blade._asdict().items()})
    rows = {}
    for row in program.constraints:
        limit = program.rows[row.name].limit
        if limit is None:
            continue
        if isinstance(row, Settled):
            used = 0.0 if row.holds else 2.0
        else:
            used = float(row.numerator.at(**x) / row.denominator.at(**x))
        rows[limit.name] = max(rows.get(limit.name, 0.0), used)
    for name, used in rows.items():
        if abs(used - 1.0) > 1e-6:
            assert (used < 1.0) == (margins[name] > 1.0), name


def _fixed(spec):
    extents = spec.geometry.extents
    return {name: e.fixed for name, e in extents.items() if e.fixed is not None}


def test_bounds_of_free_dimensions_are_rows_and_fixed_ones_are_none():
    spec = design(rcc(h={"free": [None, "1 mm"]}, b={"free": ["1 mm", None]}, l="20 mm"), LOADS)
    program = sizing_program(spec)
    bounds = [row.name for row in program.constraints if program.rows[row.name].limit is None]
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
    assert sizing_program(design(rcc(p=p), asked, {"both": both})).curved == ()


def test_a_crossing_at_a_fixed_place_is_not_convex_and_one_at_a_fixed_share_is():
    asked = {"fatigue": 2}
    assert sizing_program(design(crossed(p="-2 mm"), asked)).curved
    assert not sizing_program(design(crossed(delta=-0.5), asked)).curved


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
    program = sizing_program(spec)
    goal = objective_of(spec, spec.size.objective, program.sizes)
    stiffness = spec.geometry.stiffness(spec.material.elastic, Blade(**AT))
    assert goal.at(**AT) == pytest.approx(expected(**AT, k=stiffness), rel=ROUNDING)


def test_targets_become_bands_of_their_tolerance():
    spec = design(rcc(), {"l/h": {"equals": 50, "tolerance": "2 %"}})
    program = sizing_program(spec)
    above, below = (row for row in program.banded() if isinstance(row, Ratio))
    on_rim = {"h": 1e-4, "l": 50 * 1.02 * 1e-4, "b": 1e-3}
    assert above.numerator.at(**on_rim) / above.denominator.at(**on_rim) == pytest.approx(1.0)
    on_rim["l"] = 50 / 1.02 * 1e-4
    assert below.numerator.at(**on_rim) / below.denominator.at(**on_rim) == pytest.approx(1.0)
