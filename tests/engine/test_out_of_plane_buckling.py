"""Loads that a narrow joint bears in its plane, and that buckle it out of it, pass nothing."""

from math import cos, radians, sin, tanh

import pytest
import yaml
from scipy.optimize import brentq

import flexcli

E, H, L = 114e9, 0.2e-3, 40e-3
MATERIAL = {"name": "m", "youngs_modulus": f"{E} Pa", "poisson_ratio": 0.0,
            "yield_strength": "880 MPa", "tensile_strength": "950 MPa",
            "fatigue_amplitude": {"value": "400 MPa", "cycles": 1e6, "stress_ratio": -1},
            }  # fmt: skip


def borne(b):
    """Return what buckles two blades aside [N] that are clamped at the ground and tip with a body.

    It acts on a point at half their length, e = l/2 behind their ends, and pulls as they bear
    less so: ``u tanh u = l/e`` against ``u tan u = −l/e`` where it pushes.
    """
    u = brentq(lambda u: u * tanh(u) - 2.0, 0.1, 10.0)
    return 2.0 * u**2 * E * H * b**3 / 12.0 / L**2


def result(force, b, **case):
    spec = {
        "flexure": 1, "title": "narrow", "material": MATERIAL,
        "geometry": {"kind": "leaf-spring-stage", "h": f"{H} m", "l": f"{L} m", "b": f"{b} m",
                     "blades": 2, "spacing": "60 mm"},
        "cases": {"work": {"stroke": {"translation": "0.05 mm", "cycles": 1e6},
                           "wrench": {"y": f"{force} N"}, **case}},
        "requirements": {"yield": 1.2, "fatigue": {"factor": 1.2, "mean_stress": "none"}},
    }  # fmt: skip
    return flexcli.check(yaml.safe_dump(spec))


def judged(force, b, **case):
    return result(force, b, **case).checks


@pytest.mark.parametrize(("b", "sense"), [(0.25e-3, 1.0), (0.25e-3, -1.0), (0.5e-3, 1.0)])
def test_what_buckles_a_narrow_stage_aside_fails_its_stress(b, sense):
    for check in judged(sense * 1.2 * borne(b), b):
        assert check.verdict.value == "fail"
        low, high = check.factor_range
        assert low <= 1.0 / 1.2 * (1.0 + 2e-3)
        assert high >= 1.0 / 1.2 * (1.0 - 2e-3)
        assert high - low < 0.1


def test_below_that_it_passes_as_before():
    for check in judged(0.6 * borne(0.25e-3), 0.25e-3):
        assert check.verdict.value == "pass"
        assert "buckles" not in check.quantity


def test_near_that_it_does_not_pass():
    for check in judged(0.999 * borne(0.25e-3), 0.25e-3):
        assert check.verdict.value != "pass"


@pytest.mark.parametrize(("share", "warned"), [(1.2, True), (0.3, False)])
def test_ends_that_hold_the_body_keep_it_from_tipping_as_a_warning_says(share, warned):
    found = result(share * borne(0.25e-3), 0.25e-3, ends="clamped-guided")
    assert not any("buckles" in check.quantity for check in found.checks)
    texts = [note.text for note in found.warnings if note.code == "held-in-plane"]
    assert len(texts) == warned
    assert all("ends: clamped-guided of case 'work' is taken to hold" in text for text in texts)


FAR = {
    "kind": "rcc",
    "h": "0.1 mm",
    "l": "10 mm",
    "b": "2 mm",
    "half_angle": "20 deg",
    "p": "80 mm",
}
"""A pivot of wide blades, its point far beyond them: pulled by 16.5 N there it turns over aside."""


def far_pivot(force, model=None, material=MATERIAL, requirements=None, **case):
    spec = {
        "flexure": 1, "title": "far", "material": material, "geometry": FAR,
        "cases": {"work": {"load": {"force": f"{force} N", "direction": "0 deg"},
                           "ends": "clamped-free", **case}},
        "requirements": requirements or {"buckling": 1.2, "yield": 1.2},
    }  # fmt: skip
    return flexcli.verdicts(yaml.safe_dump(spec), model=model).checks


def tips_aside():
    """Return what turns two blades on a body over aside [N], which is pulled far in front of them.

    Each bends about its own direction as well, by its torsion.
    """
    l, h, b, half, p = 10e-3, 0.1e-3, 2e-3, radians(20.0), 80e-3
    EI, GJ = E * h * b**3 / 12.0, E / 2.0 * b * h**3 / 3.0
    stiffness = 2.0 * (EI * cos(half) ** 2 + GJ * sin(half) ** 2) / l
    return stiffness / (p + l * cos(half) / 2.0)


@pytest.mark.parametrize("model", [None, "closed-form", "linear", "exact"])
def test_what_turns_wide_blades_over_by_a_far_load_fails_all_that_looks_at_it(model):
    for check in far_pivot(2.0 * tips_aside(), model):
        assert check.verdict.value == "fail"
        assert check.factor == pytest.approx(0.5, rel=0.1)


def test_buckling_has_no_more_than_what_turns_a_joint_over_aside():
    force = 0.5 * tips_aside()
    found = {check.name: check for check in far_pivot(force)}
    assert found["buckling"].verdict.value == "pass"
    assert found["buckling"].factor == pytest.approx(2.0, rel=0.1)
    # far from what it bears the range of what is told reaches down to what is sure
    low, high = far_pivot(force / 10.0)[0].factor_range
    assert low <= 1.02 * 20.0 < high


def test_without_a_poissons_ratio_such_loads_pass_nothing():
    soft = {key: value for key, value in MATERIAL.items() if key != "poisson_ratio"}
    for check in far_pivot(2.0 * tips_aside(), material=soft):
        assert check.verdict.value == "undecided"
    for check in far_pivot(0.1 * tips_aside(), material=soft):
        assert check.verdict.value == "pass"


def test_a_temperature_beside_them_changes_nothing_of_that():
    warm = {**MATERIAL, "thermal_expansion": "9e-6 1/K"}
    case = {"temperature": {"uniform": "1 K"}}
    for check in far_pivot(2.0 * tips_aside(), material=warm, requirements={"yield": 1.2}, **case):
        assert check.verdict.value == "fail"


def test_a_stroke_that_bends_wide_blades_lets_them_tip_sooner():
    shares = []
    for angle in (0.1, 1.0):
        (check,) = far_pivot(
            1.5 * tips_aside(), stroke={"rotation": f"{angle} deg"}, requirements={"yield": 0.1}
        )
        assert "buckles the joint in space" in check.quantity
        shares.append(check.factor)
    assert shares[1] < 0.8 * shares[0]


def test_a_sizing_chooses_what_stands_in_its_plane():
    force, (h, l) = 20.0, (0.2e-3, 40e-3)
    spec = {
        "flexure": 1, "title": "sized", "material": MATERIAL,
        "geometry": {"kind": "leaf-spring-stage", "h": f"{h} m", "l": f"{l} m", "b": "free",
                     "blades": 2, "spacing": "60 mm"},
        "cases": {"work": {"load": {"force": f"{force} N", "direction": "0 deg"}}},
        "requirements": {"yield": 2.0},
    }  # fmt: skip
    found = flexcli.size(yaml.safe_dump(spec))
    assert found.status.value == "pass"
    # the force that tips it aside at the chosen width
    assert borne(found.values["b"].value) == pytest.approx(force, rel=0.05)
    (active,) = found.sizing.active
    assert "buckles the joint in space" in active
