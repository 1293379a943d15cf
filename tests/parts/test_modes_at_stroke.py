"""Vibration beside a stroke: modes about where it holds the body, by exact beams."""

import numpy as np
import pytest
import yaml

import flexcli
from flexcli.numerics.modes import natural_modes
from flexcli.parts import modes_at_stroke
from flexcli.parts.design import DesignSpec
from flexcli.parts.modes_at_stroke import structures_at_stroke
from flexcli.parts.own_motion import structure_of
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.as_printed import AsPrinted
from flexcli.results import Verdict

H, L, G = 0.1e-3, 40e-3, 9.80665
BLADE = {"h": "0.1 mm", "l": "40 mm", "b": "1 mm"}
STAGE = {"kind": "leaf-spring-stage", **BLADE, "blades": 2, "spacing": "40 mm"}
PIVOT = {"kind": "cross-spring", **BLADE, "half_angle": "45 deg", "p": "-20 mm",
         "tilt": "held"}  # fmt: skip
RCC = {"kind": "rcc", **BLADE, "half_angle": "30 deg", "p": "20 mm"}
HINGE = {"kind": "notch-hinge", "e": "0.2 mm", "r": "2 mm", "b": "4 mm", "blocks": "massive"}


def spec(geometry, case, asked):
    return {
        "flexure": 1,
        "material": {"youngs_modulus": "114 GPa", "poisson_ratio": 0.0, "yield_strength": "880 MPa",
                     "density": "1e-3 kg/m^3"},
        "geometry": geometry,
        "mechanism": {"kind": "payload", "mass": "20 g", "inertia": "1e-5 kg*m^2"},
        "cases": {"a": case}, "requirements": asked,
    }  # fmt: skip


def check(geometry, case, asked, model=None):
    text = yaml.safe_dump(spec(geometry, case, asked))
    return next(c for c in flexcli.verdicts(text, model=model).checks if c.name != "geometry")


def shaken(stroke, frequency, axis="y", level="0.01 g"):
    sine = {"acceleration": level, "frequency": f"{frequency} Hz", "axis": axis}
    return {**({"stroke": stroke} if stroke else {}), "sine": sine, "q": 50}


def structures(geometry, stroke):
    """Return the structure at rest, and about both ends of a stroke."""
    found = DesignSpec.model_validate(spec(geometry, shaken(stroke, 50), {"dynamic-yield": 1}))
    sizes, elastic = found.fixed_sizes(), found.material.elastic
    ask = Ask(found.material, found.geometry, found.mechanism, sizes, found.scene("a"), AsPrinted())
    rest = structure_of(found.mechanism, found.geometry, elastic, sizes)
    return rest, structures_at_stroke(ask, [rest])


def frequencies(structure):
    return natural_modes(structure.stiffness, structure.mass).angular / (2.0 * np.pi)


@pytest.mark.parametrize("share", [1.0, 5.0, 20.0])
def test_a_stage_gives_way_along_its_blades_as_awtar_printed(share):
    """By 12/700 (x/h)² more: Awtar, Slocum & Sevincer (2007), blades that bend to an S."""
    rest, ends = structures(STAGE, {"translation": f"{share * H} m"})
    for end in ends:
        ratio = frequencies(end)[1] / frequencies(rest)[1]
        assert ratio == pytest.approx((1.0 + 12.0 / 700.0 * share**2) ** -0.5, rel=2e-3)


@pytest.mark.parametrize("geometry", [STAGE, PIVOT, RCC])
def test_exact_beams_at_rest_have_the_rows_of_the_structure(geometry):
    """Signs and order, of which the rows at a stroke are but the difference."""
    stroke = {"translation": "1 nm"} if geometry is STAGE else {"rotation": "1e-9 rad"}
    rest, _ = structures(geometry, stroke)
    found = DesignSpec.model_validate(spec(geometry, shaken(stroke, 50), {"dynamic-yield": 1}))
    layout = found.geometry.blades_layout(found.material.elastic, found.fixed_sizes())
    beams, moved = modes_at_stroke._slopes(layout, np.zeros(3)), rest.joint_motions["joint"]
    rows = {"stress joint": beams.faces, "axial stress joint": beams.axial}
    for name, each in rows.items():
        most = np.abs(rest.outputs[name]).max()
        assert np.abs(each @ moved - rest.outputs[name]).max() < 1e-5 * most
    most = np.abs(rest.wrenches["joint"]).max()
    assert np.abs(beams.holding @ moved - rest.wrenches["joint"]).max() < 1e-5 * most


@pytest.mark.parametrize("geometry", [STAGE, PIVOT, RCC])
def test_a_stroke_of_nothing_leaves_the_structure(geometry):
    unit = "translation" if geometry is STAGE else "rotation"
    rest, ends = structures(geometry, {unit: "1 nm" if geometry is STAGE else "1e-9 rad"})
    for end in ends:
        size = np.sqrt(np.outer(*2 * (np.diag(rest.stiffness),)))
        assert np.abs((end.stiffness - rest.stiffness) / size).max() < 1e-4
        for name in ("axial stress joint", "stress joint"):
            rows = rest.outputs[name]
            assert np.abs(end.outputs[name] - rows).max() <= 1e-5 * np.abs(rows).max()


@pytest.mark.parametrize(
    ("geometry", "stroke"),
    [
        (STAGE, {"translation": "1 mm"}),
        (PIVOT, {"rotation": "30 mrad"}),
        (RCC, {"rotation": "10 mrad"}),
    ],
)
def test_far_from_resonance_blades_bear_what_weighs_beside_the_stroke(geometry, stroke):
    """Above its own mode the drive's motion is held by its inertia, below the others all stands."""
    dynamic = check(geometry, shaken(stroke, 40), {"dynamic-yield": 1e-3})
    still = check(geometry, {"stroke": stroke}, {"yield": 1e-3}, "exact")
    weight = {"level": "0.01 g", "axis": "y"}
    loaded = check(geometry, {"stroke": stroke, "acceleration": weight}, {"yield": 1e-3}, "exact")
    alone = check(geometry, shaken(None, 40), {"dynamic-yield": 1e-3})
    found = dynamic.demand - still.demand
    assert found == pytest.approx(loaded.demand - still.demand, rel=0.06)
    assert found > 3.0 * alone.demand


def test_a_base_that_shakes_along_the_blades_moves_the_stage_along_its_stroke():
    """By dλ/dx = 6 x/(5 l) of what it does along it, at resonance."""
    stroke = 1e-3
    _, ends = structures(STAGE, {"translation": f"{stroke} m"})
    modes = natural_modes(ends[0].stiffness, ends[0].mass)
    one, other = (modes.shapes[:, 0] @ ends[0].pull[axis] for axis in ("y", "x"))
    assert abs(one / other) == pytest.approx(6.0 * stroke / (5.0 * L), rel=0.02)


def test_a_response_at_a_stroke_has_both_its_ends_and_rest_in_its_range():
    case = shaken({"translation": "1 mm"}, 400)
    found = check(STAGE, case, {"dynamic-yield": 1e-3}, "closed-form")
    low, high = found.factor_range
    alone = check(STAGE, {**case, "stroke": {"translation": "1 nm"}}, {"dynamic-yield": 1e-3})
    still = check(STAGE, {"stroke": {"translation": "1 mm"}}, {"yield": 1e-3})
    assert low <= 880e6 / found.demand <= high
    assert low <= 880e6 / (still.demand + alone.demand) <= high * (1.0 + 1e-6)


def test_no_response_passes_beside_a_stroke_of_which_no_model_has_the_modes():
    case = shaken({"rotation": "20 mrad"}, 400)
    found = check(HINGE, case, {"dynamic-yield": 1e-3})
    assert found.verdict is Verdict.UNDECIDED
    assert found.factor_range is None or found.factor_range[0] == 0.0
    small = check(HINGE, {**case, "stroke": {"rotation": "1e-7 rad"}}, {"dynamic-yield": 1e-3})
    assert small.verdict is Verdict.PASS


def test_what_shakes_a_stage_along_its_width_is_told_beside_a_small_stroke():
    """Its mirror image in the plane is itself, so that the stroke answers nothing."""
    stroke = {"translation": "0.05 mm"}
    still = {"inertia": dict.fromkeys(("xx", "yy", "zz"), "1e-5 kg*m^2")}
    wide = {**STAGE, "b": "1 mm"}
    text = spec(wide, shaken(stroke, 2, "z", "0.001 g"), {"dynamic-yield": 1e-3})
    text["mechanism"] |= still
    found = next(c for c in flexcli.verdicts(yaml.safe_dump(text)).checks if "dynamic" in c.name)
    assert found.verdict is Verdict.PASS
    weight = {"level": "0.001 g", "axis": "z"}
    loaded = check(wide, {"stroke": stroke, "acceleration": weight}, {"yield": 1e-3}, "exact")
    low, high = found.factor_range
    assert low < 880e6 / loaded.demand < high
    assert high / low < 1.5
