"""Forces across short wide blades: the shear in the middle of their faces, by every model."""

from math import sqrt

import pytest
import yaml

import flexcli

H, L, FORCE, STRENGTH = 0.5e-3, 20e-3, 50.0, 800e6


def factor(width, model):
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.0,
                     "yield_strength": f"{STRENGTH} Pa"},
        "geometry": {"kind": "cross-spring", "h": f"{H} m", "l": f"{L} m", "b": f"{width} m",
                     "delta": -0.5, "half_angle": "45 deg"},
        "cases": {"work": {"wrench": {"z": f"{FORCE} N"}}},
        "requirements": {"yield": 0.01},
    }  # fmt: skip
    (check,) = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
    return check.factor


@pytest.mark.parametrize("model", ["linear", "exact"])
@pytest.mark.parametrize("share", [0.25, 0.5, 1.5, 2.5])
def test_the_largest_stress_is_of_bending_or_of_shear(share, model):
    """By symmetry each blade bears half the force between ends that do not turn."""
    b = share * L
    bending = 6.0 * FORCE / 2.0 * L / 2.0 / (H * b**2)
    shear = sqrt(3.0) * 1.5 * FORCE / 2.0 / (b * H)
    assert (shear > bending) is (share > 1.2)
    true = STRENGTH / max(bending, shear)
    assert factor(b, model) == pytest.approx(true, rel=0.03)
