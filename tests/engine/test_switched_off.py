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


LEAF = {"h": 0.5e-3, "b": 50e-3, "l": 0.1}
TRAVEL = 20e-3


def guide(least="0.1 N/um", *off):
    """Return a guide of two blades over a fifth of their length, some effects switched off."""
    sizes = {name: f"{1e3 * size} mm" for name, size in LEAF.items()}
    support = {"direction": "z", "min": least, "drive": "locked"}
    return DesignSpec.model_validate(
        {
            "flexure": 1, "material": MATERIAL,
            "geometry": {"kind": "leaf-spring-stage", "spacing": "200 mm", **sizes},
            "cases": {"work": {"stroke": {"translation": f"{TRAVEL} m"}}},
            "requirements": {"support": [support, {**support, "at": "full-stroke"}]},
            "effects": dict.fromkeys(off, "off"),
        }
    )  # fmt: skip


def test_a_guide_without_warping_is_saint_venants_and_reaches_to_the_one_with_it():
    rest, stroke = "support z locked (min)", "support z at stroke locked (min)"
    whole = judged(guide(), "exact")
    bare = judged(guide("0.1 N/um", "warping", "plate-widening", "anticlastic"), "exact")
    elastic = guide().material.elastic
    h, b, l = LEAF.values()
    # half a blade bends and shears in its plane; the force twists it where it is bent to an S
    width, area = h * b**3 / 12.0, h * b
    straight = l**3 / (12.0 * elastic.E * width) + 1.2 * l / (elastic.G * area)
    J = b * h**3 / 3.0 * (1.0 - 0.63 * h / b)
    bent = straight + TRAVEL**2 * l / (28.0 * elastic.G * J)
    # the plane of a plate adds 2 %, what a twist stretches half of one
    assert bare[rest].capacity == pytest.approx(2.0 / straight, rel=1e-3)
    assert bare[stroke].capacity == pytest.approx(2.0 / bent, rel=0.01)
    for name in (rest, stroke):
        low, high = bare[name].factor_range
        assert low <= bare[name].factor <= high
        assert low <= whole[name].factor_range[0]
        assert high >= whole[name].factor_range[1]
    assert whole[stroke].factor > 3.0 * bare[stroke].factor


def test_what_held_ends_alone_make_pass_or_fail_is_undecided_without_them():
    stroke = "support z at stroke locked (min)"
    whole = judged(guide("0.5 N/um"), "exact")[stroke]
    assert whole.verdict is Verdict.PASS
    assert judged(guide("0.5 N/um", "warping"), "exact")[stroke].verdict is Verdict.UNDECIDED


def test_a_torsion_bar_without_warping_is_saint_venants():
    bar = {"h": 0.2, "b": 4.0, "l": 6.0, "warping": "restrained"}
    on, off = (
        judged(design("torsion-bar", effects, **bar), "closed-form")
        for effects in ({}, {"warping": "off"})
    )
    elastic = design("torsion-bar", {}, **bar).material.elastic
    h, b, l = 0.2e-3, 4e-3, 6e-3
    J = b * h**3 / 3.0 * (1.0 - 0.63 * h / b)
    plain = off["stiffness (min)"]
    assert plain.capacity == pytest.approx(
        SAMPLES["torsion-bar"]["bars"] * elastic.G * J / l, rel=1e-4
    )
    assert plain.factor_range[1] >= on["stiffness (min)"].factor > 1.2 * plain.factor
    assert plain.factor_range[0] <= plain.factor
