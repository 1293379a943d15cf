"""Random vibration judged by Miles' formula first: what it leaves out is in its range."""

from math import pi, sqrt

import numpy as np
import pytest
import yaml

import flexcli

E, RHO, NU = 113.8e9, 4430.0, 0.342
PROFILES = ("gevs-qualification", "nasa-std-7001-workmanship", "smc-s-016-unit-acceptance")


def stage(*, h=1e-3, l=40e-3, mass=0.15, q=30.0, factor=1.25, profile=None, kind=None, **more):
    profile = profile or {"points": [{"frequency": f"{f} Hz", "level": "0.05 g^2/Hz"}
                                     for f in (5, 5000)]}  # fmt: skip
    given = {"asd": profile if isinstance(profile, dict) else {"profile": profile}}
    given["asd"] |= {"q": q}
    return yaml.safe_dump(
        {
            "flexure": 1,
            "material": {"youngs_modulus": f"{E} Pa", "density": f"{RHO} kg/m^3",
                         "poisson_ratio": NU, "yield_strength": "880 MPa"},
            "geometry": {"kind": kind or "leaf-spring-stage", "h": f"{h} m", "l": f"{l} m",
                         "b": "10 mm", "spacing": "30 mm"},
            "mechanism": {"kind": "payload", "mass": f"{mass} kg"},
            "cases": {"launch": given | more},
            "requirements": {"dynamic-yield": factor},
        }
    )  # fmt: skip


def the_check(source, model=None):
    (found,) = flexcli.verdicts(source, model=model).checks
    return found


def test_a_wide_margin_is_decided_by_miles_and_has_his_number():
    found = the_check(stage())
    assert found.model == "Miles"
    assert found.verdict == "pass"
    k = 24.0 * E * 10e-3 * 1e-3**3 / 12.0 / 40e-3**3
    omega = sqrt(k / (0.15 + 2.0 * 13.0 / 35.0 * RHO * 10e-3 * 1e-3 * 40e-3))
    level = 0.05 * 9.80665**2
    travel = 3.0 * sqrt(pi / 2.0 * omega / (2.0 * pi) * 30.0 * level) / omega**2
    bending = 3.0 * E * 1e-3 * travel / 40e-3**2
    # wide blades are up to 1/(1 − ν²) stiffer: the stress at one acceleration goes with k^(1/4)
    assert bending * 0.995 < found.demand < bending * 1.05


def test_a_margin_within_his_range_is_left_to_the_modes():
    low, _ = the_check(stage()).factor_range
    between = the_check(stage(factor=low * 1.001))  # passes by the modes, which leave less out
    assert between.model != "Miles"
    assert between.verdict != "undecided"


def test_a_model_that_is_insisted_on_judges_instead():
    assert the_check(stage(), model="closed-form").model == "closed-form"


def test_sines_a_duration_and_what_is_below_the_band_are_left_to_the_modes():
    sine = {"sine": {"acceleration": "1 g", "frequency": "30 Hz"}, "q": 30}
    assert the_check(stage(**sine)).model != "Miles"
    lasting = yaml.safe_load(stage())
    lasting["cases"]["launch"]["asd"]["duration"] = "2 min"
    lasting["requirements"] = {"dynamic-yield": {"factor": 1.25, "peak": "duration"}}
    assert the_check(yaml.safe_dump(lasting)).model != "Miles"
    assert the_check(stage(h=0.3e-3, profile="gevs-qualification")).model != "Miles"


@pytest.mark.parametrize("seed", range(24))
def test_the_response_of_the_modes_lies_in_his_range(seed):
    draw = np.random.default_rng(seed)
    given = {
        "h": float(draw.uniform(0.4e-3, 2e-3)),
        "l": float(draw.uniform(30e-3, 80e-3)),
        "mass": float(10.0 ** draw.uniform(-2.5, 0.0)),  # blades of a third of it, or of nothing
        "q": float(10.0 ** draw.uniform(0.5, 2.5)),
        "profile": PROFILES[seed % 3],
    }
    asked = 1e-6  # passes by any range that is known
    quick = the_check(stage(**given, factor=asked))
    modes = the_check(stage(**given, factor=asked), model="exact")
    assert modes.verdict == quick.verdict == "pass"
    if quick.model == "Miles":
        assert quick.factor_range[0] <= modes.factor_range[0] * (1.0 + 1e-3)
        assert quick.factor_range[1] >= modes.factor_range[1] * (1.0 - 1e-3)
        assert quick.factor_range[0] <= quick.factor <= quick.factor_range[1]
    else:
        assert quick.demand == pytest.approx(modes.demand, rel=0.02)
