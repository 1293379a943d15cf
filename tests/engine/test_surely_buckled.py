"""Loads that buckle beams fail a joint where what is no beam cannot hold them either."""

from math import pi

import pytest
import yaml

import flexcli
from flexcli.formulas.plate_factors import pure_bending_factor

E, H, LENGTH, NU = 70e9, 0.2e-3, 20e-3, 0.34


def judged(share, width):
    """Return the yield of a pair of blades pushed by a share of what buckles it as beams."""
    beams = 2.0 * pi**2 * E * width * H**3 / 12.0 / LENGTH**2
    spec = {
        "flexure": 1,
        "material": {
            "youngs_modulus": f"{E} Pa", "poisson_ratio": NU, "yield_strength": "2000 MPa",
        },
        "geometry": {
            "kind": "leaf-spring-stage", "blades": 2, "spacing": "20 mm",
            "h": f"{H} m", "l": f"{LENGTH} m", "b": f"{width} m",
        },
        "cases": {
            "work": {
                "load": {"force": f"{share * beams} N", "direction": "180 deg"},
                "ends": "clamped-guided",
            }
        },
        "requirements": {"yield": 1},
    }  # fmt: skip
    (check,) = (c for c in flexcli.verdicts(yaml.safe_dump(spec)).checks if "yield" in c.name)
    return check


def test_wide_blades_that_beams_would_not_hold_but_plates_do_do_not_fail():
    plates = float(pure_bending_factor(b=LENGTH, l=LENGTH, h=H, poisson_ratio=NU))
    assert plates > 1.07
    assert judged(1.05, LENGTH).verdict != "fail"


@pytest.mark.parametrize("width", [1e-3, LENGTH])
def test_what_buckles_plates_too_fails_by_a_share_with_its_error(width):
    check = judged(1.25, width)
    assert check.verdict == "fail"
    low, high = check.factor_range
    plates = float(pure_bending_factor(b=width, l=LENGTH, h=H, poisson_ratio=NU))
    assert low <= plates / 1.25 <= high * (1.0 + 1e-3)
    assert high < 1.0
