"""Buckling of joints against what their most loaded blade bears."""

from math import cos, pi, radians

import pytest
import yaml

import flexcli

E, STRENGTH, H, L, B, ALPHA = 114e9, 800e6, 0.6e-3, 7e-3, 5e-3, radians(40.0)


def test_a_joint_without_a_closed_form_bears_what_its_most_loaded_blade_bears_before_it_yields():
    spec = {
        "flexure": 1,
        "model": "closed-form",
        "material": {"youngs_modulus": f"{E} Pa", "yield_strength": f"{STRENGTH} Pa"},
        "geometry": {
            "kind": "unseparated-cross", "crossing": 0.4, "half_angle": f"{ALPHA} rad",
            "h": f"{H} m", "l": f"{L} m", "b": f"{B} m",
        },
        "cases": {"push": {"load": {"force": "100 N", "direction": "0 deg"},
                           "ends": "clamped-guided"}},
        "requirements": {"buckling": 1.5},
    }  # fmt: skip
    (check,) = flexcli.check(yaml.safe_dump(spec)).checks
    euler = pi**2 * E * H**2 / 12.0 / L**2
    assert euler > STRENGTH / 2.0, "it yields first"
    johnson = STRENGTH * (1.0 - STRENGTH / (4.0 * euler))
    # each of both blades bears F/(2 cos α); shear lowers its load by some (h/l)²
    assert check.capacity == pytest.approx(johnson * H * B * 2.0 * cos(ALPHA), rel=(H / L) ** 2)
    assert check.factor_range is None, "one blade is not the joint"


@pytest.mark.parametrize("width", [0.3e-3, 3e-3])
def test_blades_narrower_than_thick_buckle_across_their_width(width):
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.3},
        "geometry": {"kind": "leaf-spring-stage", "h": "1 mm", "l": "40 mm", "b": f"{width} m",
                     "spacing": "10 mm"},
        "cases": {"push": {"load": {"force": "1 N"}, "ends": "clamped-guided"}},
        "requirements": {"buckling": 1.5},
    }  # fmt: skip
    (check,) = flexcli.check(yaml.safe_dump(spec)).checks
    thin, thick = sorted((1e-3, width))
    euler = 2.0 * pi**2 * E * thick * thin**3 / 12.0 / 40e-3**2
    assert ("width" in check.quantity) == (width < 1e-3)
    # clamps let a blade bear no more than Euler's load; shear takes and strain adds some (h/l)²
    assert check.capacity == pytest.approx(euler, rel=0.01)
    assert check.factor_range[0] < 1.01 * euler
