"""The solid model of joints of limbs, from a spec: what beams cannot decide."""

import math

import numpy as np
import pytest

import flexcli
from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import FINE, NeckUnderLoads, equivalent

SPEC = """
flexure: 1
material: {{youngs_modulus: 200 GPa, poisson_ratio: 0.3, yield_strength: 1 GPa,
            density: 7800 kg/m^3, fatigue_amplitude: {{value: 400 MPa, cycles: 1e7}}}}
geometry: {{kind: {kind}, {blocks}}}
cases:
  work: {{{case}}}
requirements:
{requirements}
"""
SIZES = "e: 0.5 mm, r: 1 mm, l: 5 mm, b: 3 mm"
STAGE = f"hinged-stage, {SIZES}, limbs: 2, spacing: 6 mm"
PIVOT = f"hinged-pivot, {SIZES}, p: 3 mm, half_angle: 35 deg"
STROKES = {
    STAGE: "stroke: {translation: 5 um, cycles: 1e6}",
    PIVOT: "stroke: {rotation: 2 mrad, cycles: 1e6}",
}
SEAT_OFF = "  misalignment_stress: {{of: limb 1 inner hinge, factor: 1, {}}}"
ACROSS = "wrench: {z: 20 N, theta_x: 0.02 N*m}"


def checked(tmp_path, kind, requirements, *, blocks="blocks: 3 mm", case=None, model="solid"):
    path = tmp_path / "flexure.yaml"
    case = STROKES[kind] if case is None else case
    text = SPEC.format(kind=kind, blocks=blocks, case=case, requirements=requirements)
    path.write_text(text, encoding="utf-8")
    checks = flexcli.verdicts(path, model=model).checks
    (check,) = (c for c in checks if c.verdict.value != "not judged" and c.name != "geometry")
    return check


def stiffness(tmp_path, kind, **how):
    unit = "N/m" if kind == STAGE else "N*m/rad"
    return checked(tmp_path, kind, f"  stiffness: {{min: 1 {unit}}}", **how)


def limb_compliance(index, block=3e-3):
    solid = NeckUnderLoads(Neck(0.5e-3, 1e-3, 2e-3, 3e-3, 0.0, block, 1.5e-3), 200e9, 0.3)
    return solid.compliance(index)[0]


def width(check):
    low, high = check.factor_range
    return (high - low) / check.factor


def test_a_stage_of_limbs_is_as_stiff_as_their_swing(tmp_path):
    # the stage turns with its limbs' stretching, a spacing apart, which is far stiffer
    found = stiffness(tmp_path, STAGE).factor
    assert found == pytest.approx(2.0 / limb_compliance(1), rel=2e-3)


def test_a_pivot_of_limbs_turns_them_and_swings_them(tmp_path):
    # two limbs that point at the centre, which stretching lets move along the bisector's normal
    along, swing, turn = (1.0 / limb_compliance(index) for index in (0, 1, 5))
    angle, R = math.radians(35.0), 5.5e-3
    across = 2.0 * (along * math.sin(angle) ** 2 + swing * math.cos(angle) ** 2)
    coupled = 2.0 * swing * math.cos(angle) * R
    expected = 2.0 * (turn + swing * R**2) - coupled**2 / across
    assert stiffness(tmp_path, PIVOT).factor == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(
    ("kind", "requirements", "case", "most"),
    [
        (STAGE, "  yield: 1.5", None, 0.04),
        (PIVOT, "  fatigue: 1.5", None, 0.04),
        (STAGE, "  yield: 1.5", ACROSS, 0.1),
        (STAGE, "  support: [{direction: z, min: 1 N/m}]", None, 0.02),
        (PIVOT, "  deflection: [{direction: z, max: 1 mm}]", "wrench: {z: 1 N}", 0.02),
    ],
)
def test_solids_know_more_of_limbs_than_beams_which_allow_for_it(
    tmp_path, kind, requirements, case, most
):
    exact, solid = (
        checked(tmp_path, kind, requirements, case=case, model=model)
        for model in ("exact", "solid")
    )
    assert width(solid) < most
    if exact.factor_range is not None and exact.factor_range[1] is not None:
        assert width(solid) < width(exact)
        assert exact.factor_range[0] <= solid.factor_range[1]
        assert solid.factor_range[0] <= exact.factor_range[1]


@pytest.mark.parametrize(
    ("kind", "blocks", "inside"),
    [
        (STAGE, "", ("massive", "0 mm", "2.5 mm")),
        (STAGE, "blocks: massive", ("1.3 mm",)),
        (PIVOT, "blocks: massive", ("1.3 mm",)),
    ],
)
def test_blocks_that_are_left_open_are_in_the_range(tmp_path, kind, blocks, inside):
    least, most = stiffness(tmp_path, kind, blocks=blocks).factor_range
    for length in inside:
        low, high = stiffness(tmp_path, kind, blocks=f"blocks: {length}").factor_range
        assert least * (1.0 - 1e-9) <= low <= high <= most * (1.0 + 1e-9)


def test_rigid_limbs_between_clamped_mouths_are_the_stiffest_of_those_left_open(tmp_path):
    # CalculiX's solids of this pivot, rigid beyond the mouths: flexure verify, 42.783 ± 1 %
    _, most = stiffness(tmp_path, PIVOT, blocks="").factor_range
    assert most == pytest.approx(42.78, rel=0.01)


def test_what_exact_beams_leave_undecided_of_limbs_climbs_to_solids(tmp_path):
    asked = 0.99 * stiffness(tmp_path, STAGE).factor
    limit = f"  stiffness: {{min: {asked} N/m}}"
    assert checked(tmp_path, STAGE, limit, model="exact").verdict.value == "undecided"
    check = checked(tmp_path, STAGE, limit, model=None)
    assert (check.model, check.verdict.value) == ("solid", "pass")


@pytest.mark.parametrize(
    "sizes", ["e: 0.005 mm, r: 1 mm, l: 5 mm, b: 3 mm", "e: 0.5 mm, r: 1 mm, l: 2.01 mm, b: 3 mm"]
)
def test_limbs_that_no_solid_was_compared_with_are_left_to_beams(tmp_path, sizes):
    kind = STAGE.replace(SIZES, sizes)
    check = checked(tmp_path, kind, "  stiffness: {min: 1 N/m}", case=STROKES[STAGE])
    assert check.verdict.value == "undecided"
    assert "solids of limbs" in check.quantity or "no solids" in check.quantity


def test_a_seat_off_across_a_stage_stresses_its_limbs_as_their_springs_share_it(tmp_path):
    # both limbs are off by half of it, less what the body turns about their direction
    d, s, E = 1e-6, 6e-3, 200e9
    solid = NeckUnderLoads(Neck(0.5e-3, 1e-3, 2e-3, 3e-3, 0.0, 3e-3, 1.5e-3), E, 0.3)
    swing, twist = (1.0 / solid.compliance(index)[0] for index in (2, 3))
    phi = swing * s * d / 4.0 / (swing * s**2 / 4.0 + twist)
    wrench = np.array(
        [[0.0, 0.0, swing * (d / 2.0 - phi * s / 2.0), sign, 0.0, 0.0] for sign in (1, -1)]
    )
    wrench[:, 3] *= twist * phi
    expected = np.abs(equivalent(solid.stresses(wrench, FINE)[0])).max()
    found = checked(tmp_path, STAGE, SEAT_OFF.format("translation: {along: z, by: 1 um}"))
    assert found.demand == pytest.approx(expected, rel=1e-3)
    assert width(found) < 0.1


@pytest.mark.parametrize(
    "way", ["translation: {along: y, by: 1 um}", "rotation: {about: z, by: 1 mrad}"]
)
def test_a_seat_off_is_surer_by_solids_and_within_what_beams_tell(tmp_path, way):
    off = SEAT_OFF.format(way)
    beams, solids = (checked(tmp_path, PIVOT, off, model=each) for each in ("exact", "solid"))
    assert width(solids) < 0.5 * width(beams)
    assert beams.factor_range[0] <= solids.factor <= beams.factor_range[1]


@pytest.mark.slow
@pytest.mark.parametrize("ends", ["", ", ends: clamped-guided"])
def test_each_throat_bears_what_its_own_end_of_a_limb_that_weighs_something_does(ends):
    """What a limb weighs is borne between its hinges: one bears another moment than the other."""
    text = f"""
flexure: 1
material: {{youngs_modulus: 70 GPa, poisson_ratio: 0.34, density: 2700 kg/m^3,
           yield_strength: 80 MPa}}
geometry: {{kind: hinged-pivot, e: 2.3 mm, r: 9.8 mm, b: 100 mm, l: 90 mm, p: 73 mm,
           half_angle: 43 deg, blocks: 40 mm, limb: {{mass: 2 kg, inertia: 1.4e-3 kg*m^2}}}}
mechanism: {{kind: payload, mass: 20 g, inertia: 2e-4 kg*m^2}}
cases: {{a: {{acceleration: {{level: 20 m/s^2, axis: y}}{ends}}}}}
requirements: {{yield: 1}}
"""
    beams, solids = (
        next(row for row in flexcli.verdicts(text, model=model).checks if row.kind == "stress")
        for model in ("exact", "solid")
    )
    assert solids.factor == pytest.approx(beams.factor, rel=0.15)  # 17 times less, both as one
    assert beams.factor_range[0] <= solids.factor_range[1]
    assert solids.factor_range[0] <= beams.factor_range[1]
