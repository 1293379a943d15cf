"""Sag beside a stroke: a joint that its stroke bends gives way more to what it weighs."""

import pytest
import yaml

import flexcli

E, H, L, B, M, G = 114e9, 0.1e-3, 40e-3, 10e-3, 2e-3, 9.80665
STAGE = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "40 mm", "b": "10 mm", "blades": 2,
         "spacing": "40 mm"}  # fmt: skip

MATERIAL = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.0, "yield_strength": "880 MPa"}


def sag(axis, stroke=None, **how):
    case = {"acceleration": {"level": "1 g", "axis": axis}}
    if stroke:
        case["stroke"] = {"translation": f"{stroke} m"}
    spec = {
        "flexure": 1,
        "material": MATERIAL, "geometry": STAGE, "cases": {"a": case},
        "mechanism": {"kind": "payload", "mass": "2 g"},
        "requirements": {"sag": {"max": "1 m"}, "yield": 1e-6},
    }  # fmt: skip
    checks = flexcli.verdicts(yaml.safe_dump(spec), **how).checks
    return next(check for check in checks if check.name.startswith("sag"))


@pytest.mark.parametrize("stroke", [0.5e-3, 2e-3])
def test_a_stage_that_stands_aside_sags_along_its_blades_by_moving_along_its_stroke(stroke):
    """By (dλ/dx)²/k and 12/700 (x/h)² l/EA besides (Awtar 2007), λ = 3 x²/(5 l)."""
    area, k = 2.0 * B * H, 2.0 * E * B * H**3 / L**3
    slope = 6.0 * stroke / (5.0 * L)
    soft = L / (E * area) * (1.0 + 12.0 / 700.0 * (stroke / H) ** 2) + slope**2 / k
    found = sag("y", stroke)
    assert found.demand == pytest.approx(M * G * soft, rel=0.02)
    assert found.demand > 5.0 * sag("y").demand


def test_a_stage_that_stands_aside_sags_across_by_the_twist_of_its_blades():
    found, rest = sag("z", 2e-3), sag("z")
    assert 2.0 < found.demand / rest.demand < 6.0
    assert found.factor_range[0] < found.factor < found.factor_range[1]


def test_what_weighs_along_the_stroke_sags_as_at_rest():
    assert sag("x", 2e-3).demand == pytest.approx(sag("x").demand, rel=0.02)


def test_a_linear_model_does_not_know_the_sag_at_a_stroke():
    assert sag("y", 2e-3, model="linear").factor_range is None
    assert sag("y", model="linear").factor_range is not None
