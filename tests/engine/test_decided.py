"""Sizing by the models that judge: the margins of its design are at their limit by them."""

import pytest
from geometries_for_tests import MATERIAL
from judging import size_as_printed
from strategies import design, rcc, three_blade

from flexcli.engine.check import check
from flexcli.engine.size import size
from flexcli.results import Status

CASES = {"turn": {"stroke": {"rotation": "8 deg"}}}
LIMITS = {"yield": 1.5, "stiffness": {"min": "0.05 N*m/rad"}}


def one(**changes):
    return design(
        rcc(b="5 mm", l={"free": ["5 mm", "60 mm"]}, **changes), LIMITS, CASES, material=MATERIAL
    )


@pytest.mark.parametrize("model", [None, "linear", "exact"])
def test_the_margins_of_the_model_that_decides_are_at_their_limit(model):
    result = size(one(), "spec", model)
    assert result.status is Status.PASS
    if model:
        assert {row.model for row in result.checks} == {model}
    for row in result.checks:
        low, _ = row.factor_range
        # what a finer model could save, and what the rounds add
        assert low / row.required == pytest.approx(1.0, abs=5e-4)
        assert low >= row.required * (1.0 - 1e-9)


def test_the_design_of_the_formulas_does_not_pass_the_exact_model():
    closed = size_as_printed(one())
    assert closed.status is Status.PASS
    sizes = one().geometry.sized({n: closed.values[n].value for n in ("h", "l")})
    assert check(one(), sizes, "spec", "exact").status is Status.FAIL


def test_a_conflict_stays_a_conflict():
    impossible = design(
        rcc(b="5 mm", l="10 mm"), {"yield": 10, "stiffness": {"min": "5 N*m/rad"}}, CASES,
        material=MATERIAL,
    )  # fmt: skip
    assert size(impossible, "spec", "exact").status is Status.INFEASIBLE


def test_a_point_of_the_grid_that_passes_is_preferred_to_one_left_undecided():
    asked = {
        "sag": {"equals": "645 nm", "tolerance": "2 %"},
        "frequency": {"equals": "10 Hz", "tolerance": "1 %"},
    }
    spec = design(
        three_blade(l="80 mm"),
        asked,
        {"mercury": {"acceleration": {"level": "3.7 m/s^2", "axis": "z"}}},
        size={"round": {"h": "1 um", "b": "0.1 mm"}},
        mechanism={"kind": "payload", "mass": "0.8 kg", "inertia": "1.72e-4 kg*m^2"},
        material={"youngs_modulus": "116 GPa", "poisson_ratio": 0.34, "density": "4430 kg/m^3"},
    )
    result = size(spec, "spec")
    # a step further from the target the range of the sag reaches out of its tolerance
    sizes = spec.geometry.sized({"h": 236e-6, "b": 35.7e-3})
    assert check(spec, sizes, "spec").status is Status.UNDECIDED
    assert result.status is Status.PASS
