"""Stress of hinges that a vibration shakes: far below resonance that of the same weight."""

import pytest
import yaml

import flexcli
from flexcli.results import Verdict

NOTCH = {"kind": "notch-hinge", "e": "0.2 mm", "r": "2 mm", "b": "4 mm"}
THIN = {"kind": "notch-hinge", "e": "0.02 mm", "r": "5 mm", "b": "4 mm"}
SHALLOW = {"kind": "elliptic-hinge", "e": "0.2 mm", "depth": "1 mm", "l": "4 mm", "b": "4 mm"}
FILLETED = {"kind": "filleted-hinge", "h": "0.2 mm", "l": "8 mm", "r": "1 mm", "b": "4 mm"}
SHORT = {**FILLETED, "l": "2.4 mm"}


def checked(geometry, case, asked, model=None):
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": "114 GPa", "poisson_ratio": 0.0, "yield_strength": "880 MPa",
                     "density": "1e-3 kg/m^3"},
        "geometry": {**geometry, "blocks": "massive"},
        "mechanism": {"kind": "payload", "mass": "20 g", "inertia": "1e-5 kg*m^2"},
        "cases": {"a": case}, "requirements": asked,
    }  # fmt: skip
    return flexcli.verdicts(yaml.safe_dump(spec), model=model).checks[-1]


def shaken(axis, how):
    base = {"acceleration": "1 g", "frequency": "1 Hz", "axis": axis}
    flat = {"points": [{"frequency": "0.5 Hz", "level": "1 g^2/Hz"},
                       {"frequency": "1.5 Hz", "level": "1 g^2/Hz"}]}  # fmt: skip
    if how == "sine":
        return {"sine": base, "q": 50}
    return {"asd": {"profile": flat, "axis": axis, "sigma": 1}, "q": 50}


@pytest.mark.parametrize("how", ["sine", "asd"])
@pytest.mark.parametrize("geometry", [NOTCH, THIN, SHALLOW, FILLETED, SHORT])
def test_what_weighs_across_a_throat_stresses_it_beside_the_throat(geometry, how):
    """Its moment vanishes in the throat; the thickest ends of the hinge bear next to nothing."""
    dynamic = checked(geometry, shaken("y", how), {"dynamic-yield": 1e-3}, "exact")
    weight = {"acceleration": {"level": "1 g", "axis": "y"}}
    still = checked(geometry, weight, {"yield": 1e-3}, "exact")
    (low, high), (least, most) = dynamic.factor_range, still.factor_range
    assert low <= least
    assert most <= high
    assert high < 1.35 * low


def test_a_hinge_that_a_weight_across_it_breaks_passes_no_vibration_as_large():
    """Its stress was that of the ends of the notch, a fiftieth."""
    weight = {"acceleration": {"level": "1 g", "axis": "y"}}
    still = checked(NOTCH, weight, {"yield": 1000}, "exact")
    assert still.verdict is Verdict.FAIL
    found = checked(NOTCH, shaken("y", "sine"), {"dynamic-yield": 1000})
    assert found.verdict is Verdict.FAIL
