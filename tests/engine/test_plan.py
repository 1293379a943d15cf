"""Plans: what they leave out, which model they take, and that they keep what they promise."""

from typing import Any

import pytest
from random_scenes import scenes

from flexcli.engine import assess
from flexcli.engine.check import check, told_values
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.plan import plan, planned_model
from flexcli.engine.planning.audit import audit
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec

MATERIAL = {"name": "titanium", "youngs_modulus": "114 GPa", "yield_strength": "900 MPa"}
PIVOT = {
    "kind": "cross-spring", "delta": -0.3, "half_angle": "45 deg",
    "h": "0.3 mm", "l": "10 mm", "b": "2 mm",
}  # fmt: skip
TURN = {"rotation": "4 deg"}
BEAMS = {"plate-widening": "off", "anticlastic": "off"}
CONTROL = ExactModel(tolerance=1e-12, levels=(10, 15, 22, 33, 50))
"""As fine as can be, on other nodes than those of the model that is judged."""


def design_of(geometry: dict[str, Any] = PIVOT, stroke: Any = TURN, **more: Any) -> DesignSpec:
    poisson = more.pop("poisson", {"poisson_ratio": 0.33})
    return DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": {**MATERIAL, **poisson},
            "geometry": geometry,
            "cases": {"work": {"stroke": stroke, **more.pop("case", {})}},
            "requirements": {"yield": 1.0},
            **more,
        }
    )


def row(found, name):
    return next(effect for effect in found.effects if effect.name == name)


def planned(design, **options):
    return plan(design, design.fixed_sizes(), **options)


def test_finer_accuracies_take_other_models_at_rising_cost_and_keep_their_promise():
    taken, costs = [], []
    for accuracy in (0.1, 0.01, 0.001, 1e-6):
        design = design_of(accuracy=accuracy, effects=BEAMS)
        sizes, found = design.fixed_sizes(), planned(design)
        values = told_values(design, sizes, planned_model(found))
        truth = told_values(design, sizes, CONTROL)
        for name in ("k_pivot", "shift"):
            assert values[name].value == pytest.approx(truth[name].value, rel=accuracy)
        stress, true = (
            assess.checks(design.limits(sizes, by))[0].demand
            for by in (planned_model(found), CONTROL)
        )
        assert stress == pytest.approx(true, rel=accuracy)
        taken.append((planned_model(found).name, found.tolerance))
        costs.append(found.cost)
    assert len(set(taken)) == 4
    assert costs == sorted(set(costs))


BEAMS_HAVE = ("shear", "axial extension")
"""What beams have whether it matters or not: it costs nothing, and without it joints that are held
more than they need have no answer."""


@pytest.mark.slow
def test_nothing_that_a_plan_leaves_out_matters_and_little_of_the_rest_is_idle():
    left, wrong, switched, idle = 0, 0, 0, 0
    for design in scenes(36, seed=7):
        found = planned(design)
        rows = audit(design, design.fixed_sizes(), found)
        wrong += sum(row.right is False for row in rows)
        for effect in found.effects:
            true = [r.true for r in rows if r.effect == effect.name and r.true is not None]
            left += not effect.on
            in_every_beam = found.model != "closed-form" and effect.name in BEAMS_HAVE
            if effect.on and true and not in_every_beam:
                switched += 1
                idle += max(map(abs, true)) < found.accuracy / 10.0
    assert left > 36
    assert wrong == 0
    assert switched > 15
    assert idle <= switched / 10


def test_what_is_left_out_stays_in_half_of_the_accuracy_all_together():
    for design in scenes(40, seed=3):
        found = planned(design)
        for name in found.reported:
            left = [e.estimates.get(name, 0.0) for e in found.effects if not e.on]
            assert sum(left) <= design.accuracy / 2.0


def test_a_plan_says_when_no_model_is_accurate_enough():
    found = planned(design_of(accuracy=1e-6))
    assert [note.code for note in found.notes] == ["accuracy-not-reached"]
    assert found.estimated_error > 1e-6


def test_what_the_material_does_not_tell_is_left_out_with_a_warning():
    found = planned(design_of(accuracy=1e-4, poisson={}))
    assert not row(found, "shear").on
    assert "needs material.poisson_ratio" in row(found, "shear").reason
    assert [note.code for note in found.notes][:2] == ["effect-needs"] * 2


@pytest.mark.parametrize("wish", ["on", "off"])
def test_the_spec_has_the_last_word(wish):
    found = planned(design_of(accuracy=0.01, effects={"shear": wish}))
    assert row(found, "shear").on == (wish == "on")
    assert row(found, "shear").reason.endswith(f"{wish} by the spec")


def test_without_an_accuracy_only_what_is_asked_for_is_on():
    assert planned(design_of(effects={"shear": "on"})).on == ("shear",)


def test_a_model_that_is_insisted_on_tells_what_it_does_not_carry():
    found = planned(design_of(accuracy=1e-3, effects=BEAMS), model="linear")
    assert found.model == "linear"
    assert "effect-not-in-model" in [note.code for note in found.notes]
    assert not row(found, "large rotation").on


def test_a_model_that_the_joint_has_not_is_refused():
    bar = {"kind": "round-torsion-bar", "d": "0.5 mm", "l": "20 mm", "bars": 2}
    with pytest.raises(SolveError, match="has no exact model"):
        planned(design_of(bar, accuracy=0.01), model="exact")


def test_where_nobody_knows_what_closed_forms_leave_out_the_exact_model_is_taken():
    uneven = {"kind": "star", "angles": ["0 deg", "50 deg", "120 deg"], "delta": 0.2,
              "h": "0.1 mm", "l": "20 mm", "b": "0.1 mm"}  # fmt: skip
    found = planned(design_of(uneven, {"rotation": "1 deg"}, accuracy=0.01))
    assert found.model == "exact"


def test_without_another_model_the_unknown_error_is_told():
    """Its farthest fibres are outside the range of the formula for them: r θ/l ≤ 0.25."""
    bar = {"kind": "round-torsion-bar", "d": "2 mm", "l": "2 mm", "bars": 2}
    found = planned(design_of(bar, {"rotation": "40 deg"}, accuracy=0.01))
    assert found.model == "closed-form"
    assert found.known_error is None
    assert "accuracy-not-reached" in [note.code for note in found.notes]


def test_check_by_a_plan_tells_its_error_and_no_effects_of_closed_forms():
    design = design_of({**PIVOT, "h": "0.6 mm"}, accuracy=0.3, effects=BEAMS)
    result = check(design, design.fixed_sizes(), "")
    assert result.plan is not None
    assert result.cost.estimated_error == result.plan.estimated_error
    assert "effect-left-out" not in [note.code for note in result.warnings]


def test_a_scene_that_lacks_an_effect_runs_no_code_for_it(monkeypatch):
    def refuse(*_: Any, **__: Any) -> None:
        raise AssertionError

    monkeypatch.setattr("flexcli.mechanics.equilibrium.solve", refuse)
    monkeypatch.setattr("flexcli.engine.joint_models.joint_states.solve", refuse)
    monkeypatch.setattr("flexcli.formulas.miles.miles_worst_case", refuse)
    monkeypatch.setattr("flexcli.parts.bending.pair.under_tension", refuse)
    monkeypatch.setattr("flexcli.parts.heavy_blades.structure_of", refuse)
    design = design_of(accuracy=0.1)
    assert check(design, design.fixed_sizes(), "").checks
    exact = design_of(accuracy=1e-6)
    with pytest.raises(AssertionError):  # that would have been called
        check(exact, exact.fixed_sizes(), "")


def test_the_simulation_of_a_stroke_has_the_effects_of_its_plan_and_no_others(monkeypatch):
    from flexcli.engine.planning.by_plan import simulate_by_plan

    geometry = {
        "kind": "rcc", "p": "2 mm", "half_angle": "45 deg",
        "h": "1 mm", "l": "20 mm", "b": "5 mm",
    }  # fmt: skip

    def swept(**effects):
        spec = DesignSpec.model_validate(
            {
                "flexure": 1,
                "material": {**MATERIAL, "poisson_ratio": 0.34},
                "geometry": geometry,
                "stroke": {"rotation": "2 deg"},
                "requirements": {"yield": 0.1},
                "effects": {**BEAMS, **effects},
            }
        )
        return simulate_by_plan(spec, spec.fixed_sizes(), "spec", 3).sweeps[0].points[1].stiffness

    both = swept(shear="on", **{"axial-extension": "on"})
    neither = swept(shear="off", **{"axial-extension": "off"})
    closed = 8 * 114e9 * 5e-3 * 1e-9 / 12 / 20e-3 * (3 * 0.1**2 + 3 * 0.1 + 1)
    assert neither == pytest.approx(closed, rel=1e-9)
    assert both < 0.995 * neither


def test_stops_shut_out_what_their_modes_have_not():
    from flexcli.engine.plan import plan

    spec = DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": {**MATERIAL, "poisson_ratio": 0.34},
            "geometry": {"kind": "cantilever", "h": "0.2 mm", "l": "20 mm", "b": "5 mm"},
            "mechanism": {"kind": "tip-mass", "mass": "1 g", "damping": {"q": 30}},
            "stroke": {"translation": "4 mm"},
            "requirements": {"yield": 0.1},
            "stops": {"travel": "5 mm"},
            "accuracy": "0.1 %",
        }
    )
    notes = plan(spec, spec.fixed_sizes()).notes
    assert any(note.code == "effect-excluded" and "large rotation" in note.text for note in notes)


ALWAYS = {
    "linear": {"blade tension", "hinge length"},
    "exact": {"blade tension", "hinge length", "large rotation", "axial load"},
}
"""What a model of beams has whether asked or not; the exact one is in equilibrium as it is bent."""


@pytest.mark.parametrize("model", ALWAYS)
def test_a_plan_s_error_is_the_model_s_own_and_all_that_is_left_out_together(model):
    wishes = dict.fromkeys(("plate-widening", "anticlastic", "shear"), "off")
    found = planned(design_of({**PIVOT, "h": "0.6 mm"}, accuracy=0.5, effects=wishes), model=model)
    assert found.model == model
    own = found.tolerance if model == "exact" else 0.0
    several = 0
    for name in found.reported:
        out = [e for e in found.effects if not e.on and e.name not in ALWAYS[model]]
        left = [e.estimates.get(name, 0.0) for e in out]
        several += sum(share > 0.01 * found.errors[name] for share in left) > 1
        assert found.errors[name] == pytest.approx(own + sum(left), rel=1e-12)
    assert several > 0
    assert found.estimated_error == max(found.errors.values())


def test_a_plan_s_error_is_no_less_than_what_a_check_tells_of_the_same_bar():
    bar = {"kind": "torsion-bar", "h": "0.3 mm", "l": "20 mm", "b": "5 mm", "warping": "restrained"}
    design = design_of(bar, {"rotation": "1 deg"}, accuracy=0.05)
    (told,) = check(design, design.fixed_sizes(), "test", "closed-form").checks
    low, high = told.factor_range
    found = planned(design)
    assert found.errors["stress"] >= 0.99 * (high - low) / (high + low) > 1e-3


def test_values_beside_what_solids_judge_are_of_a_model_that_plans():
    """Solids and shells judge; ``accuracy`` was an error beside them."""
    notch = {"kind": "notch-hinge", "e": "0.1 mm", "r": "2 mm", "b": "0.2 mm"}
    spec = design_of(notch, TURN, accuracy="1 %")
    sizes = spec.fixed_sizes()
    solid, planned = (check(spec, sizes, "spec", model) for model in ("solid", "exact"))
    assert {row.model for row in solid.checks} == {"solid"}
    assert solid.plan is not None
    assert solid.plan.model == "exact"
    assert solid.values["k_pivot"].value == planned.values["k_pivot"].value
    assert "values-by-another-model" in [note.code for note in solid.warnings]
    assert "values-by-another-model" not in [note.code for note in planned.warnings]
