"""Soft clamps let a joint bend further under loads near those that buckle it."""

from math import pi, sqrt, tan

import pytest
import yaml

import flexcli

E, H, LENGTH, WIDTH, ACROSS, STRENGTH = 70e9, 1e-3, 20e-3, 2e-3, 0.5, 10e9
BEAMS = 2.0 * pi**2 * E * WIDTH * H**3 / 12.0 / LENGTH**2


def ranges(share):
    """Return the ranges of yield and of buckling of a stage pushed by a share of ``BEAMS``."""
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.0,
                     "yield_strength": f"{STRENGTH} Pa"},
        "geometry": {"kind": "leaf-spring-stage", "blades": 2, "spacing": "20 mm",
                     "clamps": "monolithic", "h": f"{H} m", "l": f"{LENGTH} m", "b": f"{WIDTH} m"},
        "cases": {"work": {"wrench": {"y": f"{share * BEAMS} N", "x": f"{ACROSS} N"},
                           "ends": "clamped-guided"}},
        "requirements": {"yield": 1e-3, "buckling": 1e-3},
    }  # fmt: skip
    checks = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
    return {check.name.split(" ")[0]: check.factor_range for check in checks}


@pytest.mark.parametrize("share", [0.5, 0.75])
def test_the_stress_has_that_of_all_that_may_buckle_it(share):
    """A guided blade as much longer as its buckling says has M = F/2k tan(k l/2) at its ends."""
    found = ranges(share)
    push = share * BEAMS / 2.0
    for critical in (each * push for each in found["buckling"]):
        # of the same EI, as long as what buckles there
        longer = pi * sqrt(E * WIDTH * H**3 / 12.0 / critical)
        k = pi * sqrt(push / critical) / longer
        moment = ACROSS / 2.0 / k * tan(k * longer / 2.0)
        stress = 6.0 * moment / (WIDTH * H**2) + push / (WIDTH * H)
        low, high = found["yield"]
        assert low * (1.0 - 0.02) <= STRENGTH / stress <= high
