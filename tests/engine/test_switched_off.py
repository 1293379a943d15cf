"""An effect that the spec switches off stays in the range of what is judged."""

from math import isfinite

import pytest
from geometries_for_tests import MATERIAL, SAMPLES, geometry, spec

from flexcli.engine.judge import judge, status_of
from flexcli.engine.models import NamedModel, series_of
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import MODEL_EFFECTS
from flexcli.results import Status, Verdict

NO_LESS = 1e-9
"""Relative: rounding of products in another order."""


def design(kind, effects, **sizes):
    joint = geometry(kind, **sizes)
    turns = joint.motion == "rotation"
    stroke = {joint.motion: "2 deg" if turns else "0.5 mm", "cycles": 1e6}
    least = "1e-9 N*m/rad" if turns else "1e-6 N/m"
    return DesignSpec.model_validate(
        {
            "flexure": 1, "title": "a sample", "material": MATERIAL,
            "geometry": spec(kind, **sizes),
            "cases": {"work": {"stroke": stroke}}, "effects": effects,
            "requirements": {"yield": 1.5, "stiffness": {"min": least}},
        }
    )  # fmt: skip


def judged(one, model):
    checks = judge(one, one.fixed_sizes(), (NamedModel(one, model),)).checks
    return {check.name: check for check in checks}


def assert_ranges_hold(kind, model, effects=MODEL_EFFECTS):
    on = judged(design(kind, {}), model)
    for effect in effects:
        off = judged(design(kind, {effect.key: "off"}), model)
        for name, check in on.items():
            # joints that are held more than they need have no answer without stretching
            found = off[name].factor_range if name in off else None
            if found is None or not isfinite(check.factor):
                continue
            low, high = found
            spare = NO_LESS * check.factor
            assert low - spare <= check.factor <= high + spare, (effect.key, name)
            assert high - low >= (1.0 - 1e-6) * (check.factor_range[1] - check.factor_range[0])


@pytest.mark.parametrize("kind", SAMPLES)
def test_the_range_of_a_closed_form_has_the_value_with_the_effect(kind):
    assert_ranges_hold(kind, "closed-form")


@pytest.mark.parametrize("kind", ["rcc", "guided-blade", "notch-hinge"])
@pytest.mark.parametrize("model", ["linear", "exact"])
def test_the_range_of_beams_has_the_value_with_the_effect(kind, model):
    assert model in series_of(design(kind, {}))
    names = ("shear", "axial-extension", "plate-widening", "thick-notch")
    assert_ranges_hold(kind, model, [e for e in MODEL_EFFECTS if e.key in names])


def test_stiffness_of_a_stage_without_plates_is_stiffer_at_the_most_by_what_plates_are():
    on, off = (
        judged(design("guided-blade", effects, b=10.0), "linear")["stiffness (min)"]
        for effects in ({}, {"plate-widening": "off"})
    )
    assert on.factor > 1.03 * off.factor
    assert off.factor_range[0] == pytest.approx(off.factor, rel=0.02)
    assert off.factor_range[1] >= on.factor


@pytest.mark.parametrize(
    ("effect", "load"),
    [
        ("gravity", {"acceleration": {"level": "1 g", "axis": "y"}}),
        ("shock", {"shock": {"half-sine": {"acceleration": "20 g", "duration": "11 ms"}}}),
    ],
)
def test_a_load_that_is_switched_off_is_named_and_nothing_passes_without_it(effect, load):
    one = DesignSpec.model_validate(
        {
            "flexure": 1, "title": "a payload", "material": MATERIAL,
            "geometry": spec("guided-blade"), "mechanism": {"kind": "payload", "mass": "1 g"},
            "cases": {"work": {"stroke": {"translation": "0.1 mm", "cycles": 1e6}, **load}},
            "requirements": {"yield": 1.0}, "effects": {effect: "off"},
        }
    )  # fmt: skip
    checks = judge(one, one.fixed_sizes(), (NamedModel(one, "closed-form"),)).checks
    rows = [check for check in checks if check.verdict is Verdict.NOT_JUDGED]
    assert [row.name for row in rows] == [next(iter(load))]
    assert all(check.verdict is Verdict.PASS for check in checks if check not in rows)
    assert status_of(checks) is Status.UNDECIDED
