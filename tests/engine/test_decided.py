"""Sizing by the models that judge: the margins of its design are at their limit by them."""

import pytest
from geometries_for_tests import MATERIAL
from judging import size_as_printed
from strategies import design, rcc, three_blade

from flexcli import api
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


def test_a_conflict_stays_one_on_a_grid():
    impossible = design(
        rcc(b="5 mm", l="10 mm"), {"yield": 10, "stiffness": {"min": "5 N*m/rad"}}, CASES,
        material=MATERIAL, size={"round": {"h": "10 um"}},
    )  # fmt: skip
    assert size(impossible, "spec").status is Status.INFEASIBLE


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


# -- vibration: no formula stands behind a response ---------------------------------------------

STAGE = """\
flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, h: {free: [0.1 mm, 1 mm]}, l: {free: [10 mm, 60 mm]}, b: 1 cm}
mechanism: {kind: payload, mass: 50 g}
cases:
  operation: {stroke: {translation: 0.5 mm, cycles: 1e6}}
  launch: {asd: {profile: gevs-qualification, q: 50}}
requirements: {fatigue: 2, yield: 1.5, dynamic-yield: 1.25}
size: {objective: least-volume}
"""
"""Below the profile's first corner the response falls by a factor of ten within 5 % of a length."""

BLADE = """\
flexure: 1
material: ti-6al-4v
geometry: {kind: guided-blade, h: {free: [0.1 mm, 3 mm]}, l: 30 mm, b: 8 mm}
mechanism: {kind: payload, mass: 20 g}
cases:
  launch: {asd: {profile: gevs-qualification, q: 40}}
requirements: {dynamic-yield: 1.25, frequency: {min: 30 Hz}}
size: {objective: least-volume}
"""
"""The stress falls with the thickness only beyond where it is largest: its slope misleads."""


def passes(spec, **sizes):
    overrides = {f"geometry.{name}": f"{x!r} m" for name, x in sizes.items()}
    return api.check(spec, overrides=overrides).status is Status.PASS


@pytest.mark.slow
def test_a_stage_under_vibration_is_sized_at_the_edge_of_what_it_bears():
    found = api.size(STAGE)
    assert found.status is Status.PASS
    assert "did-not-settle" not in {note.code for note in found.warnings}
    h, l = (found.values[name].value for name in ("h", "l"))
    assert h == pytest.approx(0.1e-3, rel=1e-6)
    # on the thinnest blades no shorter stage passes: looked at in steps, close by and far
    for shorter in (0.99, 0.95, 0.85, 0.75, 0.67):
        assert not passes(STAGE, h=h, l=shorter * l)


@pytest.mark.slow
def test_a_blade_that_passes_is_found_though_the_slope_at_the_first_choice_leads_away():
    found = api.size(BLADE)
    assert found.status is Status.PASS
    h = found.values["h"].value
    assert passes(BLADE, h=h)
    for thinner in (0.99, 0.9, 0.75, 0.5, 0.25):
        assert not passes(BLADE, h=thinner * h)
