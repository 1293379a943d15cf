"""Nominal stress of wide blades in the plane by thin shells, against CalculiX's solids."""

import json
import re
from pathlib import Path

import pytest
import yaml

import flexcli
from flexcli.engine.joint_models.out_of_plane import OutOfPlane
from flexcli.engine.joint_models.shell_stress import by_plates
from flexcli.engine.models import NamedModel
from flexcli.engine.solid.numbers import StressPlace
from flexcli.engine.verifying.model_numbers import ModelNumbers
from flexcli.errors import SolveError
from flexcli.results import QuantityKind, Verdict

SOLIDS = [
    json.loads(line)
    for line in Path(__file__).with_name("shell_stresses.jsonl").read_text().splitlines()
]
"""What ``tests/benchmarks/shell_stresses.py`` kept: specs, the stress by solids, its error."""

READ = re.compile(r"(?P<face>\w+) face of (?P<blade>.+), mean .*, (?P<s>[\d.]+) mm from its start")


def asked(spec, model="shell"):
    """Return a model of a spec whose bodies stay upright, and the question of its only case."""
    design = flexcli.load(yaml.safe_dump(spec)).part
    (scene,) = design.scenes()
    found = NamedModel(design, model).joint_model
    if isinstance(found, OutOfPlane):
        found = found.inner
    return found, design.ask(scene, design.fixed_sizes(), found)


def guided(b="10 mm", h="0.1 mm", nu=0.3, case=None, **more):
    return {
        "flexure": 1,
        "material": {
            "youngs_modulus": "100 GPa", "poisson_ratio": nu, "yield_strength": "500 MPa",
        },
        "geometry": {"kind": "guided-blade", "h": h, "l": "20 mm", "b": b},
        "cases": {"work": case or {"stroke": {"translation": "1 um"}}},
        "requirements": {"yield": 1.0},
        **more,
    }  # fmt: skip


@pytest.mark.parametrize("of", SOLIDS, ids=lambda of: of["kind"])
def test_solids_are_within_the_error_of_a_stress_by_shells(of):
    model, ask = asked(of["spec"])
    place = READ.match(of["read"])
    at = StressPlace(place["blade"], place["face"], float(place["s"]) * 1e-3)
    told, error = ModelNumbers(model).stress(ask, at)
    off = of["solid"] / told - 1.0
    assert error.low - of["error"] <= off <= error.high + of["error"]
    assert error.high < 0.02


@pytest.mark.parametrize("b", ["3 mm", "10 mm", "40 mm"])
def test_at_small_strokes_shells_bear_what_plates_do(b):
    told = [
        max(float(stress.largest) for stress in model.stresses(ask)[1])
        for model, ask in (asked(guided(b), name) for name in ("shell", "closed-form"))
    ]
    assert told[0] == pytest.approx(told[1], rel=2e-3)


def test_without_poissons_ratio_small_strokes_have_the_stress_of_beams():
    _, ask = asked(guided(nu=0.0))
    found = by_plates(ask)
    beam = 3.0 * 100e9 * 0.1e-3 * 1e-6 / 20e-3**2
    assert abs(found.bending).max() < 2e-3 * beam


def test_statics_tell_the_moments_of_a_wide_cantilever_under_a_force_at_its_tip():
    spec = guided(case={"wrench": {"x": "0.01 N"}})
    spec["geometry"]["kind"] = "cantilever"
    model, ask = asked(spec)
    largest = max(float(stress.largest) for stress in model.stresses(ask)[1])
    assert largest == pytest.approx(6.0 * 0.01 * 20e-3 / (10e-3 * 0.1e-3**2), rel=2e-3)
    assert model.error(ask, "stress").high < 1e-2


def test_shells_decide_what_curvature_that_flattens_leaves_to_beams():
    """A pull beside a stroke of an eighth of the length: beams know the stress to 3 %."""
    case = {"stroke": {"translation": "2.5 mm"}, "load": {"force": "0.4 N", "direction": "180 deg"},
            "ends": "clamped-guided"}  # fmt: skip
    (beams,) = flexcli.verdicts(yaml.safe_dump(guided(case=case)), model="exact").checks
    low, high = beams.factor_range
    near = beams.factor + 0.9 * (high - beams.factor)
    spec = guided(case=case, requirements={"yield": near})
    (left,) = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
    assert left.verdict is Verdict.UNDECIDED
    (check,) = flexcli.verdicts(yaml.safe_dump(spec)).checks
    assert check.verdict is not Verdict.UNDECIDED
    assert check.model == "shell"
    assert low <= check.factor_range[0] <= check.factor_range[1] <= high


def test_an_admissible_stroke_is_sought_by_beams():
    """It takes many strokes far beyond that of the case, which shells would walk for minutes."""
    found = flexcli.check(yaml.safe_dump(guided()), model="shell").values["x_adm"]
    assert found.model == "exact"
    assert found == flexcli.check(yaml.safe_dump(guided()), model="exact").values["x_adm"]


@pytest.mark.parametrize("effect", ["plate-widening", "anticlastic"])
def test_shells_do_not_judge_by_what_a_spec_leaves_out(effect):
    spec = guided(effects={effect: "off"})
    with pytest.raises(SolveError, match="no shell model"):
        flexcli.check(yaml.safe_dump(spec), model="shell")


def test_shells_are_not_asked_of_a_stress_that_an_effect_leaves_without_error(monkeypatch):
    spec = guided(b="20 mm", h="0.4 mm", effects={"shear": "off"})
    spec["geometry"] = {
        "kind": "star", "h": "0.4 mm", "l": "20 mm", "b": "20 mm", "p": "1 mm",
        "angles": ["0 deg", "80 deg"],
    }  # fmt: skip
    spec["cases"] = {"work": {"stroke": {"rotation": "1 mrad"}}}
    model, ask = asked(spec)
    assert model.error(ask, QuantityKind.STRESS) is None

    def none(ask):
        raise AssertionError("shells were asked")

    monkeypatch.setattr("flexcli.engine.joint_models.exact_with_shells.by_plates", none)
    (check,) = flexcli.check(yaml.safe_dump(spec)).checks
    assert check.verdict is Verdict.UNDECIDED
