"""Loads that a narrow joint bears in its plane, and that buckle it out of it, pass nothing."""

from math import tanh

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


def judged(force, b, **case):
    spec = {
        "flexure": 1, "title": "narrow", "material": MATERIAL,
        "geometry": {"kind": "leaf-spring-stage", "h": f"{H} m", "l": f"{L} m", "b": f"{b} m",
                     "blades": 2, "spacing": "60 mm"},
        "cases": {"work": {"stroke": {"translation": "0.05 mm", "cycles": 1e6},
                           "wrench": {"y": f"{force} N"}, **case}},
        "requirements": {"yield": 1.2, "fatigue": {"factor": 1.2, "mean_stress": "none"}},
    }  # fmt: skip
    return flexcli.check(yaml.safe_dump(spec)).checks


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


def test_ends_that_hold_the_body_keep_it_from_tipping():
    for check in judged(1.2 * borne(0.25e-3), 0.25e-3, ends="clamped-guided"):
        assert "buckles" not in check.quantity
