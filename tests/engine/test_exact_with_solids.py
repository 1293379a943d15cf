"""The solid model of a single notch, from a spec: what beams cannot decide."""

import pytest
import yaml

import flexcli
from flexcli.errors import SolveError
from flexcli.mechanics.solids.unit_loads import NeckUnderLoads

NOTCH = """
flexure: 1
material: {{youngs_modulus: 200 GPa, poisson_ratio: {nu}, yield_strength: 1 GPa,
            density: 7800 kg/m^3, fatigue_amplitude: {{value: 400 MPa, cycles: 1e7}}}}
geometry: {{kind: {kind}, {blocks}}}
{mechanism}
cases:
  work: {{{case}}}
requirements:
{requirements}
"""

THICK = "notch-hinge, e: 0.5 mm, r: 1 mm, b: 10 mm"
STATED = "blocks: 2 mm"
STROKE = "stroke: {rotation: 1 mrad, cycles: 1e6}"
ACROSS = "wrench: {z: 300 N, theta_x: 0.5 N*m}"


def checked(
    tmp_path,
    requirements,
    *,
    kind=THICK,
    blocks=STATED,
    case=STROKE,
    model=None,
    mechanism="",
    nu=0.3,
    verb=flexcli.verdicts,
):
    path = tmp_path / "flexure.yaml"
    text = NOTCH.format(
        kind=kind, blocks=blocks, case=case, requirements=requirements, mechanism=mechanism, nu=nu
    )
    path.write_text(text, encoding="utf-8")
    return verb(path, model=model).checks


def only(checks):
    (check,) = (each for each in checks if each.verdict.value != "not judged")
    return check


def width(check):
    low, high = check.factor_range
    return (high - low) / check.factor


@pytest.mark.parametrize(
    ("requirements", "case", "most"),
    [
        ("  stiffness: {min: 1 N*m/rad}", STROKE, 0.01),
        ("  yield: 1.5", STROKE, 0.04),
        ("  fatigue: 1.5", STROKE, 0.04),
        ("  yield: 1.5", f"{STROKE}, {ACROSS}", 0.1),
        ("  yield: 1.5", ACROSS, 0.1),
        ("  support: [{direction: z, min: 1 N/m}]", STROKE, 0.02),
        ("  deflection: [{direction: z, max: 1 mm}]", "wrench: {z: 1 N}", 0.02),
    ],
)
def test_solids_know_more_of_a_thick_notch_than_beams_which_allow_for_it(
    tmp_path, requirements, case, most
):
    exact, solid = (
        only(checked(tmp_path, requirements, case=case, model=model))
        for model in ("exact", "solid")
    )
    assert width(solid) < most
    if exact.factor_range is not None:
        assert width(solid) < width(exact)
        low, high = exact.factor_range
        assert low <= solid.factor_range[1]
        assert solid.factor_range[0] <= high


def test_what_exact_beams_leave_undecided_climbs_to_solids(tmp_path):
    pinned = only(checked(tmp_path, "  stiffness: {min: 1 N*m/rad}", model="solid"))
    asked = 0.99 * pinned.factor
    beams = only(checked(tmp_path, f"  stiffness: {{min: {asked} N*m/rad}}", model="exact"))
    assert beams.verdict.value == "undecided"
    check = only(checked(tmp_path, f"  stiffness: {{min: {asked} N*m/rad}}"))
    assert (check.model, check.verdict.value) == ("solid", "pass")


def test_so_does_the_stress_of_vibration(tmp_path):
    of = {
        "kind": "elliptic-hinge, e: 0.5 mm, depth: 1 mm, l: 3 mm, b: 1 mm",
        "case": "asd: {profile: gevs-qualification, q: 20}",
        "mechanism": "mechanism: {kind: payload, mass: 5 g, inertia: 1e-7 kg*m^2}",
    }
    pinned = only(checked(tmp_path, "  dynamic-yield: 1", model="solid", **of))
    asked = f"  dynamic-yield: {pinned.factor / 1.03}"
    beams = only(checked(tmp_path, asked, model="exact", **of))
    assert beams.verdict.value == "undecided"
    check = only(checked(tmp_path, asked, **of))
    assert (check.model, check.verdict.value) == ("solid", "pass")


def test_a_wide_margin_asks_no_solid(tmp_path):
    assert only(checked(tmp_path, "  stiffness: {min: 1 N*m/rad}")).model != "solid"


@pytest.mark.parametrize(
    ("blocks", "inside"),
    [("", ("massive", "0 mm", "2.5 mm")), ("blocks: massive", ("1.3 mm",))],
)
def test_blocks_that_are_left_open_are_in_the_range(tmp_path, blocks, inside):
    asked = "  stiffness: {min: 1 N*m/rad}"
    least, most = only(checked(tmp_path, asked, blocks=blocks, model="solid")).factor_range
    for length in inside:
        stated = f"blocks: {length}"
        low, high = only(checked(tmp_path, asked, blocks=stated, model="solid")).factor_range
        assert least * (1.0 - 1e-9) <= low <= high <= most * (1.0 + 1e-9)


def test_the_stress_of_a_stroke_is_the_peak_at_the_moment_of_the_solid(tmp_path):
    K = only(checked(tmp_path, "  stiffness: {min: 1 N*m/rad}", model="solid")).factor
    stress = only(checked(tmp_path, "  yield: 1", model="solid"))
    nominal = 6.0 * K * 1e-3 / (10e-3 * 0.5e-3**2)
    # Neuber's deep notch of e/r = 0.5 has 1.095, a wide one some more at its middle
    assert stress.demand == pytest.approx(1.10 * nominal, rel=0.03)


def test_solids_leave_to_beams_what_they_do_not_know(tmp_path):
    at_stroke = "  support: [{direction: z, min: 1 N/m, at: full-stroke}]"
    for asked in ("  parasitic_shift: {max: 1 mm}", at_stroke):
        check = only(checked(tmp_path, asked, model="solid"))
        assert check.verdict.value == "undecided"
        assert "take --model exact" in check.quantity


def test_a_stroke_beyond_what_was_compared_is_left_to_beams(tmp_path):
    far = "stroke: {rotation: 0.3 rad, cycles: 1e6}"
    check = only(checked(tmp_path, "  yield: 0.1", case=far, model="solid"))
    assert "farther than solids were compared" in check.quantity


def test_nominal_stress_is_left_to_beams(tmp_path):
    nominal = f"{STATED}, stress-concentration: none"
    check = only(checked(tmp_path, "  yield: 1", blocks=nominal, model="solid"))
    assert "nominal stress" in check.quantity


def test_a_joint_without_solids_says_so(tmp_path):
    blade = {"kind": "moment-blade, h: 0.5 mm, l: 10 mm", "blocks": "b: 10 mm"}
    with pytest.raises(SolveError, match="has no solid model"):
        checked(tmp_path, "  yield: 1", **blade, model="solid", verb=flexcli.check)


def test_the_force_of_a_drive_is_that_of_the_solid(tmp_path):
    actuator = "actuator: {blocking_force: 10 N, free_stroke: 1 mm, arm: 10 mm, drives: both-ways}"
    K = only(checked(tmp_path, "  stiffness: {min: 1 N*m/rad}", model="solid")).factor
    beams, solids = (
        only(checked(tmp_path, "  drive: 1", mechanism=actuator, model=model))
        for model in ("exact", "solid")
    )
    assert solids.demand == pytest.approx(K * 1e-3 / 10e-3, rel=2e-3)
    assert width(solids) < width(beams)


@pytest.mark.parametrize(
    ("e", "b", "nu", "turn", "solids"),
    [
        (0.3, 1.5, 0.3, 0.0666, (1.0144, 0.9989, 1.0003)),
        pytest.param(0.1, 0.4, 0.3, 0.1581, (1.2499, 0.9921, 1.0019), marks=pytest.mark.slow),
        pytest.param(0.2, 2.0, 0.4, 0.0542, (1.0142, 0.9992, 1.0001), marks=pytest.mark.slow),
    ],
)
def test_what_a_stroke_changes_of_a_deflection_is_that_of_solids_at_the_stroke(
    tmp_path, e, b, nu, turn, solids
):
    """CalculiX, large motion, drive free: ``tests/benchmarks/hinge_deflections.py``."""
    kind = f"notch-hinge, e: {e} mm, r: 1 mm, b: {b} mm"
    for axis, ratio in zip("xyz", solids, strict=True):
        asked, found = f"  deflection: [{{direction: {axis}, max: 1 mm}}]", []
        for end in (1e-9, turn):
            case = f"stroke: {{rotation: [0 rad, {end} rad]}}, wrench: {{{axis}: 10 mN}}"
            checks = checked(
                tmp_path, asked, kind=kind, blocks="blocks: 0 mm", case=case, model="solid", nu=nu
            )
            found.append(only(checks))
        rest, there = found
        low, high = there.factor_range
        assert low < there.factor * there.demand / rest.demand / ratio < high
        assert width(there) < 0.26
        assert there.demand / rest.demand - 1.0 == pytest.approx(ratio - 1.0, rel=0.15, abs=4e-4)


def test_a_deflection_beyond_the_strokes_that_were_compared_is_left_to_beams(tmp_path):
    asked = "  deflection: [{direction: z, max: 1 mm}]"
    case = "stroke: {rotation: 0.3 rad, cycles: 1e6}, wrench: {z: 1 N}"
    check = only(checked(tmp_path, asked, case=case, model="solid"))
    assert "farther than solids were compared" in check.quantity


FILLETED = {"kind": "filleted-hinge", "h": "1 mm", "l": "20 mm", "r": "4 mm", "b": "10 mm"}
NOTCHED = {"kind": "notch-hinge", "e": "0.3 mm", "r": "2 mm", "b": "2 mm"}


@pytest.mark.slow
@pytest.mark.parametrize(("hinge", "case", "least"), [
    (NOTCHED, {"wrench": {"x": "1 N"}}, 0.99),  # of which beams are told the peak itself
    (FILLETED, {"wrench": {"theta_z": "0.01 N*m"}}, 1.07),
    (FILLETED, {"stroke": {"rotation": "1e-5 rad"}}, 1.07),
])  # fmt: skip
def test_what_flat_throats_and_fillets_bear_in_their_middle_is_in_the_range_of_beams(
    hinge, case, least
):
    words = {
        "flexure": 1, "title": "hinge",
        "material": {"youngs_modulus": "114 GPa", "poisson_ratio": 0.34,
                     "yield_strength": "800 MPa"},
        "geometry": {**hinge, "blocks": "massive"}, "cases": {"work": case},
        "requirements": {"yield": {"factor": 1e-6}},
    }  # fmt: skip
    beams, solid = (
        next(c for c in flexcli.verdicts(yaml.safe_dump(words), model=model).checks
             if c.name.startswith("yield"))
        for model in ("exact", "solid")
    )  # fmt: skip
    assert solid.demand > least * beams.demand
    assert beams.factor_range[0] < solid.factor < beams.factor_range[1]


def test_a_range_that_says_nothing_of_a_stress_holds_what_is_told(tmp_path):
    """Two errors beyond all of a stress had a product that was larger than it, both ways."""
    of = {
        "kind": "notch-hinge, e: 76 um, r: 3.39 mm, b: 5.15 mm",
        "case": "stroke: {rotation: 20 urad}, acceleration: {level: 755 g, axis: y}",
        "mechanism": "mechanism: {kind: payload, mass: 0.444 g, inertia: 2.04e-8 kg*m^2}",
        "blocks": "blocks: 5 mm",
    }
    check = only(checked(tmp_path, "  yield: 0.5", model="solid", **of))
    assert check.factor_range is None or check.factor_range[0] <= check.factor
    assert check.factor_range is None or check.factor_range[1] >= check.factor


def test_solids_are_not_asked_where_the_spec_leaves_out_what_they_have_of_thick_notches():
    """What is switched off stays in the error of beams, and decides nothing."""
    text = NOTCH.format(
        kind=THICK, blocks=STATED, case=STROKE, mechanism="", nu=0.3,
        requirements="  stiffness: {min: 1 N*m/rad}",
    )  # fmt: skip
    value = flexcli.verdicts(text, model="exact").checks[0].factor
    near = text.replace("min: 1 N*m/rad", f"min: {0.99 * value} N*m/rad")
    whole, without = (
        flexcli.verdicts(each).checks[0] for each in (near, near + "effects: {thick-notch: off}\n")
    )
    assert whole.model == "solid"
    assert (without.model, without.verdict.value) == ("exact", "undecided")


def test_a_deflection_in_the_plane_asks_no_compliance_across_it(tmp_path, monkeypatch):
    asked, compliance = set(), NeckUnderLoads.compliance

    def recorded(neck, index):
        asked.add(index)
        return compliance(neck, index)

    monkeypatch.setattr(NeckUnderLoads, "compliance", recorded)
    bound = "  deflection: {direction: y, max: 1 mm}"
    found = only(checked(tmp_path, bound, case="wrench: {y: 1 N}", model="solid"))
    assert asked == {0, 1, 5}
    # what acts across its plane as well asks for all, and moves it alike in it
    beside = only(checked(tmp_path, bound, case="wrench: {y: 1 N, z: 1 nN}", model="solid"))
    assert asked == set(range(6))
    assert beside.factor == pytest.approx(found.factor, rel=1e-9)
    assert beside.factor_range == pytest.approx(found.factor_range, rel=1e-6)
