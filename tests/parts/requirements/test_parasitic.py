"""Parasitic motions against the shortening of bent blades."""

import pytest
import yaml
from specs_for_tests import parallelogram

import flexcli
from flexcli.errors import SpecError

STROKE, L = 1e-3, 20e-3
LIMIT = 60e-6


def check(geometry, requirements):
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": "114 GPa", "poisson_ratio": 0.3},
        "geometry": geometry,
        "cases": {"work": {"stroke": {"translation": f"{STROKE} m"}}},
        "requirements": requirements,
    }
    return flexcli.check(yaml.safe_dump(spec)).checks


def test_the_range_of_a_parasitic_motion_holds_the_shortening_of_a_parallelogram():
    asked = {"parasitic_motion": {"direction": "y", "max": f"{LIMIT} m"}}
    (found,) = check(parallelogram("0.1 mm", "2 mm"), asked)
    # 3 x²/5l of a blade bent to an S, but for terms of order (x/l)²
    true = LIMIT / (0.6 * STROKE**2 / L)
    low, high = found.factor_range
    assert low < true * (1.0 + (STROKE / L) ** 2)
    assert high > true * (1.0 - (STROKE / L) ** 2)
    assert found.factor == pytest.approx(low), "what is told has its error in it"


@pytest.mark.parametrize("most", ["0 um", "-5 um"])
def test_a_shift_is_bounded_by_a_length_above_zero(most):
    stage = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "2 mm"}
    with pytest.raises(SpecError, match="must be above 0"):
        check(stage, {"parasitic_shift": {"max": most}})
