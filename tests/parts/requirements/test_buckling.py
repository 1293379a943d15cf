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
