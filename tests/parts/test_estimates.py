"""The errors that closed forms promise hold: random designs of every joint against exact blades.

The true number, by geometrically exact blades with shear and stretching, lies within the error
of the corrected closed form in all but one design of a hundred; where the error is unknown,
nothing is promised. Of what is promised, enough is known and close to be of use.
"""

from collections.abc import Callable, Iterator
from math import exp, log
from typing import Any

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, asked, geometry

from flexcli.engine import omitted_effects
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import MODEL_EFFECTS, Estimate, estimate
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Geometry
from flexcli.parts.requirements import AS_PRINTED, Ask, JointModel
from flexcli.results import QuantityKind

OUTER = {
    "plate widening",
    "anticlastic",
    "clamp stress",
    "clamp compliance",
    "thick notch",
    "blade mass",
}
"""What beams have no notion of: their own tests hold them."""

EFFECTS = [effect for effect in MODEL_EFFECTS if effect.name not in OUTER]

L = 20e-3
TITANIUM = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.33, "yield_strength": "9 GPa"}
DESIGNS = 40

SOLVED = 1e-6
"""How far the exact numbers themselves may be off: notches at rest to 1e-6."""

Sample = tuple[dict[str, Any], float]


def metres(**sizes: float) -> dict[str, str]:
    return {name: f"{float(size)!r} m" for name, size in sizes.items()}


def between(rng: np.random.Generator, low: float, high: float) -> float:
    return exp(rng.uniform(log(low), log(high)))


def blade(rng: np.random.Generator) -> dict[str, str]:
    return metres(h=L / between(rng, 5.0, 1000.0), l=L, b=rng.uniform(0.5e-3, 5e-3))


def angle(rng: np.random.Generator) -> str:
    return f"{rng.uniform(10.0, 80.0)!r} deg"


def pair(rng: np.random.Generator) -> dict[str, Any]:
    return {**blade(rng), "delta": rng.uniform(-0.9, 2.0), "half_angle": angle(rng)}


def remote(rng: np.random.Generator) -> dict[str, Any]:
    return {**blade(rng), **metres(p=rng.uniform(0.0, 2.0) * L), "half_angle": angle(rng)}


def joined(rng: np.random.Generator) -> dict[str, Any]:
    return {**blade(rng), "crossing": rng.uniform(0.2, 0.8), "half_angle": angle(rng)}


def star(rng: np.random.Generator) -> dict[str, Any]:
    count, turn = int(rng.integers(3, 6)), rng.uniform(0.0, 360.0)
    uneven = rng.uniform(0.0, 30.0, count) * float(rng.random() < 0.3)
    angles = [turn + 360.0 * i / count + uneven[i] for i in range(count)]
    spoken = [f"{float(a)!r} deg" for a in angles]
    return {**blade(rng), "angles": spoken, "delta": rng.uniform(-0.9, 2.0)}


def three(rng: np.random.Generator) -> dict[str, Any]:
    return {**blade(rng), **metres(p=rng.uniform(0.0, L))}


def parallel(rng: np.random.Generator) -> dict[str, Any]:
    return {**blade(rng), **metres(spacing=rng.uniform(0.5, 2.0) * L)}


def necked(rng: np.random.Generator) -> dict[str, Any]:
    l_c = rng.uniform(0.03, 0.5) * L
    thin = metres(h=min(l_c / 3.0, L / between(rng, 5.0, 1000.0)), l_c=l_c)
    return {**parallel(rng), **thin}


def circular(rng: np.random.Generator) -> dict[str, Any]:
    r = 2e-3
    return {**metres(r=r, e=r * between(rng, 3e-3, 0.4), b=2e-3), **NOMINAL}


def elliptic(rng: np.random.Generator) -> dict[str, Any]:
    sizes = metres(l=6e-3, depth=rng.uniform(0.2e-3, 4e-3), e=6e-3 * between(rng, 2e-3, 0.1))
    return {**sizes, "b": "2 mm", **NOMINAL}


def filleted(rng: np.random.Generator) -> dict[str, Any]:
    l = 10e-3
    sizes = metres(l=l, r=rng.uniform(0.02, 0.49) * l, h=l / between(rng, 5.0, 500.0))
    return {**sizes, "b": "2 mm", **NOMINAL}


def limb(rng: np.random.Generator) -> dict[str, Any]:
    r = rng.uniform(0.02, 0.49) * L
    return {**metres(l=L, r=r, e=r * between(rng, 5e-3, 0.3), b=2e-3), **NOMINAL}


def limb_stage(rng: np.random.Generator) -> dict[str, Any]:
    return {**limb(rng), **metres(spacing=L)}


def limb_pivot(rng: np.random.Generator) -> dict[str, Any]:
    return {**limb(rng), "delta": rng.uniform(-0.9, 2.0), "half_angle": angle(rng)}


NOMINAL = {"stress-concentration": "none"}

STAGES = {
    "cantilever": blade,
    "guided-blade": blade,
    "leaf-spring-stage": parallel,
    "necked-down-stage": necked,
    "hinged-stage": limb_stage,
}
PIVOTS = {
    "moment-blade": blade,
    "rcc": remote,
    "cross-spring": pair,
    "unseparated-cross": joined,
    "star": star,
    "three-blade": three,
    "notch-hinge": circular,
    "elliptic-hinge": elliptic,
    "filleted-hinge": filleted,
    "hinged-pivot": limb_pivot,
}
KINDS = {**STAGES, **PIVOTS}

USEFUL = {
    "stiffness": 0.6,
    "stress": 0.15,  # of stars that are uneven, or turn beyond h/l, nothing is known
    "shift": 0.3,
}
"""Least share of the designs whose error is known, of the numbers that a joint has."""


def designs(kind: str, count: int) -> Iterator[DesignSpec]:
    """Yield random designs: l/h 5 to 1000, strokes up to 15° or 0.2 l."""
    rng = np.random.default_rng(12)
    for _ in range(count):
        sizes = KINDS[kind](rng)
        stroke = (
            {"translation": f"{between(rng, 1e-3, 0.2) * L!r} m"}
            if kind in STAGES
            else {"rotation": f"{between(rng, 1e-3, 0.262)!r} rad"}
        )
        yield design_of({"kind": kind, **sizes}, {"stroke": stroke})


def design_of(geometry: dict[str, Any], case: dict[str, Any]) -> DesignSpec:
    content = {
        "flexure": 1,
        "material": {"name": "titanium", **TITANIUM},
        "geometry": geometry,
        "cases": {"work": case},
        "requirements": {"yield": 1.0},
    }
    return DesignSpec.model_validate(content)


def stress(joint_model: JointModel, ask: Ask) -> float:
    return max(abs(float(s.largest)) for s in joint_model.stresses(ask)[1])


NUMBERS: dict[str, Callable[[JointModel, Ask], float]] = {
    "stiffness": lambda joint_model, ask: float(joint_model.stiffness(ask)),
    "stress": stress,
    "shift": lambda joint_model, ask: abs(float(joint_model.parasitic_shift(ask))),
}


def promised(design: DesignSpec, kind: str) -> tuple[Ask, Estimate]:
    sizes = design.fixed_sizes()
    assert sizes is not None
    ask = Ask(design.material, design.geometry, None, sizes, design.scene("work"), AS_PRINTED)
    setting = omitted_effects.setting(design, sizes)
    return ask, estimate(setting, QuantityKind(kind), EFFECTS)


@pytest.mark.slow
@pytest.mark.parametrize("number", NUMBERS)
@pytest.mark.parametrize("kind", KINDS)
def test_the_true_number_lies_within_the_error_of_the_closed_form(kind, number):
    exact, known, missed = ExactModel(tolerance=1e-9), 0, []
    for design in designs(kind, DESIGNS):
        ask, found = promised(design, number)
        try:
            closed = NUMBERS[number](AS_PRINTED, ask)
        except NotAvailable:
            assert number == "shift"  # of stars
            return
        if found.error is None or closed == 0.0:
            continue
        known += 1
        true = NUMBERS[number](exact, ask._replace(joint_model=exact))
        solved = SOLVED * max(1.0, ask.scene.travel * L / closed if number == "shift" else 1.0)
        off = true / (closed * found.factor) - 1.0
        if not found.error.low - solved <= off <= found.error.high + solved:
            missed.append((off, found.error, design.geometry))
    assert len(missed) <= DESIGNS // 100, missed
    if number != "shift" or kind != "hinged-pivot":  # whose shift nobody has derived
        assert known >= USEFUL[number] * DESIGNS


@pytest.mark.parametrize("kind", ["cantilever", "guided-blade", "leaf-spring-stage"])
def test_the_errors_of_straight_blades_hold_up_to_strokes_of_half_their_length(kind):
    rng, exact = np.random.default_rng(5), ExactModel(tolerance=1e-9)
    for share in (0.35, 0.42, 0.5):
        slender = {**KINDS[kind](rng), **metres(h=L / between(rng, 20.0, 1000.0))}
        design = design_of({"kind": kind, **slender}, {"stroke": {"translation": f"{share * L} m"}})
        for number in ("stress", "shift"):
            ask, found = promised(design, number)
            assert found.error is not None
            closed = NUMBERS[number](AS_PRINTED, ask) * found.factor
            off = NUMBERS[number](exact, ask._replace(joint_model=exact)) / closed - 1.0
            assert found.error.low <= off <= found.error.high


@pytest.mark.parametrize("kind", ["leaf-spring-stage", "necked-down-stage"])
def test_blades_that_stand_close_keep_their_stage_upright_by_forces_along_them(kind):
    """Their stress grows by 0.12 l/d (x/l)³, which the error had nothing of: 1.1 % beside 0.4 %."""
    rng, exact = np.random.default_rng(7), ExactModel(tolerance=1e-9)
    close = {**KINDS[kind](rng), **metres(h=L / 800.0, spacing=0.1 * L)}
    for share in (0.1, 0.2, 0.34):
        design = design_of({"kind": kind, **close}, {"stroke": {"translation": f"{share * L} m"}})
        for number in ("stress", "shift"):
            ask, found = promised(design, number)
            assert found.error is not None
            closed = NUMBERS[number](AS_PRINTED, ask) * found.factor
            off = NUMBERS[number](exact, ask._replace(joint_model=exact)) / closed - 1.0
            assert found.error.low <= off <= found.error.high


@pytest.mark.parametrize("kind", ["leaf-spring-stage", "cross-spring", "cantilever", "star"])
def test_the_stress_of_a_stroke_under_load_lies_within_its_error(kind):
    """Along the axis of symmetry, up to a tenth of Euler's load of guided blades."""
    rng, exact, missed = np.random.default_rng(3), ExactModel(tolerance=1e-9), []
    for design in designs(kind, DESIGNS // 2):
        h, l, b = design.fixed_sizes()
        euler = np.pi**2 * 114e9 * b * h**3 / 12.0 / l**2
        force = between(rng, 1e-4, 0.1) * euler
        case = {"stroke": design.cases["work"].stroke, "load": {"force": f"{force!r} N"}}
        loaded = design.model_copy(
            update={"cases": design_of_case(design, case)},
        )
        ask, found = promised(loaded, "stress")
        if found.error is None:
            continue
        true, closed = stress(exact, ask._replace(joint_model=exact)), stress(AS_PRINTED, ask)
        bending = stress(AS_PRINTED, ask._replace(scene=ask.scene._replace(force=0.0)))
        corrected = closed + bending * (found.factor - 1.0)
        off = true / corrected - 1.0
        if not found.error.low - SOLVED <= off <= found.error.high + SOLVED:
            missed.append((off, found.error, design.geometry, force / euler))
    assert not missed


def design_of_case(design: DesignSpec, case: dict[str, Any]) -> dict[str, Any]:
    given = design.cases["work"]
    load = design_of_load(case["load"])
    return {"work": given.model_copy(update={"load": load})}


def design_of_load(load: dict[str, Any]) -> Any:
    blades = {"kind": "leaf-spring-stage", "h": "1 mm", "l": "20 mm", "b": "1 mm"}
    return design_of(blades, {"load": load}).cases["work"].load


def test_a_linkage_and_an_uneven_star_promise_nothing():
    uneven = {"kind": "star", "angles": ["0 deg", "50 deg", "120 deg"], "delta": 0.2,
              "h": "0.1 mm", "l": "20 mm", "b": "5 mm"}  # fmt: skip
    _, found = promised(design_of(uneven, {"stroke": {"rotation": "1 deg"}}), "stress")
    assert found.error is None


@pytest.mark.parametrize(
    ("geometry", "stroke"),
    [
        ({"kind": "necked-down-stage", "h": "20 um", "l_c": "3 mm", "l": "30 mm", "b": "10 mm",
          "spacing": "20 mm"}, {"translation": "26 mm"}),
        ({"kind": "cross-spring", "delta": 0.5, "half_angle": "45 deg", "h": "0.1 mm",
          "l": "20 mm", "b": "5 mm"}, {"rotation": "30 deg"}),
        ({"kind": "hinged-stage", "e": "0.05 mm", "r": "2 mm", "l": "40 mm", "b": "5 mm",
          "spacing": "20 mm"}, {"translation": "30 mm"}),
        ({"kind": "torsion-bar", "h": "0.1 mm", "l": "5 mm", "b": "10 mm"}, {"rotation": "40 deg"}),
    ],
)  # fmt: skip
def test_outside_the_validity_that_explain_prints_nothing_is_promised_and_a_warning_tells(
    geometry, stroke
):
    design = design_of(geometry, {"stroke": stroke})
    _, found = promised(design, "stress")
    assert found.error is None
    sizes = design.fixed_sizes()
    assert sizes is not None
    rows = omitted_effects.effects(design, sizes)
    codes = {note.code for note in omitted_effects.warnings(design, sizes, rows)}
    assert "outside-validity" in codes


def test_numbers_at_rest_do_not_feel_the_stroke():
    design = design_of(
        {"kind": "cross-spring", "delta": 0.5, "half_angle": "45 deg", "h": "0.1 mm",
         "l": "20 mm", "b": "5 mm"}, {"stroke": {"rotation": "30 deg"}},
    )  # fmt: skip
    _, found = promised(design, "stiffness")
    assert found.error is not None
    assert found.error.largest < 1e-5


def test_every_joint_that_draws_its_blades_is_among_the_designs():
    drawn = {k for k in SAMPLES if not isinstance(layout_of(geometry(k)), NotAvailable)}
    assert drawn == set(KINDS)


def layout_of(part: Geometry) -> object:
    return asked(part.layout, ELASTIC, part.probe())
