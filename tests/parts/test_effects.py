"""Effects: estimates against exact solutions, what they need, and that nothing counts twice."""

from typing import Any

import pytest
from geometries_for_tests import SAMPLES, geometry, spec

from flexcli.engine import omitted_effects
from flexcli.engine.joint_models.corrected import Corrected
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.engine.planning.coverage import COVERAGE, OUTER
from flexcli.mechanics.mesh import Effects
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import EFFECTS, MODEL_EFFECTS, SCENE_EFFECTS, ModelEffect, Setting
from flexcli.parts.requirements import AS_PRINTED, Ask

TITANIUM = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.33, "yield_strength": "900 MPa"}
PIVOT = {
    "kind": "cross-spring", "delta": 0.2, "half_angle": "40 deg",
    "h": "0.4 mm", "l": "20 mm", "b": "1 mm",
}  # fmt: skip
STAGE = {"kind": "leaf-spring-stage", "spacing": "20 mm", "h": "1 mm", "l": "20 mm", "b": "2 mm"}
CANTILEVER = {"kind": "cantilever", "h": "1 mm", "l": "20 mm", "b": "2 mm"}
TURN, MOVE = {"rotation": "0.02 rad"}, {"translation": "0.5 mm"}
THICK = [(PIVOT, TURN), (STAGE, MOVE), (CANTILEVER, MOVE)]

NEAR = 0.06
"""Of a change that formulas of leading order tell: shares of the order of the change itself."""


def design_of(geometry: dict[str, Any], stroke: dict[str, Any], **more: Any) -> DesignSpec:
    return DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": {"name": "titanium", **TITANIUM},
            "geometry": geometry,
            "cases": {"work": {"stroke": stroke, **more.pop("case", {})}},
            "requirements": {"yield": 1.0},
            **more,
        }
    )


def setting_of(design: DesignSpec) -> Setting:
    return omitted_effects.setting(design, design.fixed_sizes())


def named(name: str) -> ModelEffect:
    return next(effect for effect in MODEL_EFFECTS if effect.name == name)


def asked(design: DesignSpec, joint_model: Any) -> Ask:
    sizes = design.fixed_sizes()
    return Ask(design.material, design.geometry, None, sizes, design.scene("work"), joint_model)


def stress(design: DesignSpec, joint_model: Any) -> float:
    return max(abs(float(s.largest)) for s in joint_model.stresses(asked(design, joint_model))[1])


def numbers(design: DesignSpec, joint_model: Any) -> dict[str, float]:
    ask = asked(design, joint_model)
    return {
        "stiffness": float(joint_model.stiffness(ask)),
        "stress": stress(design, joint_model),
        "shift": float(joint_model.parasitic_shift(ask)),
    }


@pytest.mark.parametrize(("geometry", "stroke"), THICK)
@pytest.mark.parametrize(
    ("name", "less"),
    [("shear", {"shear": False}), ("axial extension", {"extension": False})],
)
def test_change_is_that_of_exact_blades_with_and_without(geometry, stroke, name, less):
    design = design_of(geometry, stroke)
    full = numbers(design, ExactModel(tolerance=1e-11))
    without = numbers(design, ExactModel(Effects()._replace(**less), tolerance=1e-11))
    changes = named(name).changes(setting_of(design))
    for number, change in changes.items():
        true = full[number] / without[number] - 1.0
        within = NEAR * change.bound + change.error + 1e-6
        assert change.value == pytest.approx(true, abs=within), number


@pytest.mark.parametrize(("geometry", "stroke"), [*THICK, (PIVOT, {"rotation": "0.1 rad"})])
def test_large_rotation_is_that_of_exact_slender_blades(geometry, stroke):
    design = design_of({**geometry, "h": "0.01 mm"}, stroke)
    slender = Effects(extension=False, shear=False)
    full = numbers(design, ExactModel(slender, tolerance=1e-11))
    first = numbers(design, AS_PRINTED)
    effect = named("large rotation")
    changes, estimates = (f(setting_of(design)) for f in (effect.changes, effect.estimates))
    for number, change in changes.items():
        true = full[number] / first[number] - 1.0
        assert change.value == pytest.approx(true, abs=0.2 * change.bound + change.error + 1e-4)
        assert abs(true) <= estimates[number] + 2e-4  # blade tension at this h/l


def test_blade_tension_is_what_both_faces_of_a_linear_pivot_add():
    design = design_of(PIVOT, TURN)
    slender = LinearModel(Effects(extension=False, shear=False))
    true = numbers(design, slender)["stress"] / numbers(design, AS_PRINTED)["stress"] - 1.0
    change = named("blade tension").changes(setting_of(design))["stress"]
    assert change.value == pytest.approx(true, rel=1e-6)


@pytest.mark.parametrize(("geometry", "stroke"), THICK)
def test_load_changes_the_stress_of_a_stroke_by_at_most_its_estimate(geometry, stroke):
    slender = {**geometry, "h": "0.1 mm"}
    loaded = design_of(slender, stroke, case={"load": {"force": "0.02 N"}})
    calm = design_of(slender, stroke)
    axial = numbers(loaded, AS_PRINTED)["stress"] - numbers(calm, AS_PRINTED)["stress"]
    exact = ExactModel(tolerance=1e-11)
    true = numbers(loaded, exact)["stress"] / (numbers(calm, exact)["stress"] + axial) - 1.0
    estimate = named("axial load").estimates(setting_of(loaded))["stress"]
    assert 0.3 * estimate < abs(true) <= 1.1 * estimate


def test_a_load_beyond_buckling_can_not_be_left_out():
    loaded = design_of(STAGE, MOVE, case={"load": {"force": "1 MN"}})
    assert named("axial load").estimates(setting_of(loaded))["stress"] == float("inf")


@pytest.mark.parametrize("effect", MODEL_EFFECTS, ids=lambda e: e.name)
@pytest.mark.parametrize(("geometry", "stroke"), THICK)
def test_estimate_is_no_less_than_the_change(effect, geometry, stroke):
    setting = setting_of(design_of(geometry, stroke))
    estimates = effect.estimates(setting)
    for number, change in effect.all_changes(setting).items():
        assert estimates[number] >= change.bound
        assert change.value is None or abs(change.value) <= 1.06 * change.bound


def test_blade_mass_is_rayleighs_share():
    heavy = design_of(
        STAGE, MOVE,
        material={"name": "titanium", **TITANIUM, "density": "4430 kg/m^3"},
        mechanism={"kind": "payload", "mass": "10 g"},
    )  # fmt: skip
    blades = 2 * 4430 * 1e-3 * 20e-3 * 2e-3
    ratio = 13.0 / 35.0 * blades / 10e-3
    change = named("blade mass").changes(setting_of(heavy))["frequency"]
    # Rayleigh's is an upper bound, exact to second order in the ratio
    assert change.value == pytest.approx((1.0 + ratio) ** -0.5 - 1.0, rel=2e-3)


def test_blade_mass_changes_a_frequency_and_a_sag_alone():
    heavy = design_of(
        STAGE, MOVE,
        material={"name": "titanium", **TITANIUM, "density": "4430 kg/m^3"},
        mechanism={"kind": "payload", "mass": "10 g"},
        case={"acceleration": {"level": "1 g", "axis": "y"}},
    )  # fmt: skip
    effect = named("blade mass")
    assert effect.all_changes(setting_of(heavy)).keys() == effect.only == {"frequency", "sag"}


def test_effects_have_names_of_their_own_and_each_model_effect_one_carrier_at_least():
    assert len({effect.key for effect in EFFECTS}) == len(EFFECTS)
    names = {effect.name for effect in MODEL_EFFECTS}
    exact = COVERAGE["exact"]
    assert exact.can | exact.always | OUTER == names


@pytest.mark.parametrize("model", ["linear", "exact"])
def test_no_effect_is_counted_twice(model):
    inner = {"linear": LinearModel, "exact": ExactModel}[model]()
    design = design_of(PIVOT, TURN)
    plain = numbers(design, inner)
    for effect in MODEL_EFFECTS:
        if effect.name in COVERAGE[model].can | COVERAGE[model].always:
            assert numbers(design, Corrected(inner, [effect])) == plain


@pytest.mark.parametrize("effect", MODEL_EFFECTS, ids=lambda e: e.name)
def test_a_correction_changes_each_number_by_its_change_and_no_other(effect):
    design = design_of(PIVOT, TURN)
    plain, corrected = (
        numbers(design, AS_PRINTED),
        numbers(design, Corrected(AS_PRINTED, [effect])),
    )
    changes = effect.all_changes(setting_of(design))
    for number, value in plain.items():
        change = changes[number].value if number in changes else 0.0
        assert corrected[number] / value - 1.0 == pytest.approx(change, abs=1e-12)


@pytest.mark.parametrize("effect", SCENE_EFFECTS, ids=lambda e: e.name)
def test_a_scene_effect_is_not_where_the_scene_lacks_it(effect):
    assert effect.indicator(setting_of(design_of(PIVOT, TURN))) is None


def test_an_effect_that_is_off_leaves_the_scene():
    case = {"acceleration": {"level": "1 g", "axis": "y"}}
    mechanism = {"kind": "payload", "mass": "1 kg"}
    with_it = design_of(PIVOT, TURN, case=case, mechanism=mechanism)
    without = design_of(PIVOT, TURN, case=case, mechanism=mechanism, effects={"gravity": "off"})
    assert with_it.scene("work").force > 0.0
    assert without.scene("work").force == 0.0


@pytest.mark.parametrize("kind", SAMPLES)
def test_every_kind_of_joint_is_estimated(kind):
    joint = geometry(kind)
    stroke = {joint.motion: "1 deg" if joint.motion == "rotation" else "0.1 mm"}
    setting = setting_of(design_of(spec(kind), stroke))
    for effect in MODEL_EFFECTS:
        indicator = effect.indicator(setting)
        estimates = effect.estimates(setting)
        assert all(estimate >= 0.0 for estimate in estimates.values())
        assert estimates.keys() <= effect.only
        assert indicator is not None or not estimates


def test_blades_that_hold_their_centre_stretch_as_it_turns():
    star = {"kind": "star", "angles": ["0 deg", "120 deg", "240 deg"], "p": "0 mm",
            "h": "0.25 mm", "l": "80 mm", "b": "10 mm"}  # fmt: skip
    design = design_of(star, {"rotation": "0.003 rad"})
    slender = Effects(extension=True, shear=False)
    change = stress(design, ExactModel(slender)) / stress(design, AS_PRINTED) - 1.0
    estimate = named("large rotation").estimates(setting_of(design))["stress"]
    assert 0.5 * estimate < change <= estimate
