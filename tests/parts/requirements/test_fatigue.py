"""Fatigue beside loads that compress: what no amplitude is, is none."""

import pytest
import yaml

import flexcli
from flexcli.results import Verdict

SPEC = {
    "flexure": 1,
    "material": {
        "youngs_modulus": "114 GPa", "poisson_ratio": 0.0, "density": "2700 kg/m^3",
        "tensile_strength": "1110 MPa", "yield_strength": "1000 MPa",
        "fatigue_amplitude": {"value": "555 MPa", "cycles": 1e7, "stress_ratio": -1},
    },
    "geometry": {
        "kind": "unseparated-cross", "h": "0.62375 um", "l": "1.15865 mm", "b": "0.34735 um",
        "half_angle": "47.206 deg", "crossing": 0.3798,
    },
    "stroke": {"rotation": ["0 deg", "3.024 deg"], "cycles": 1e7},
    "wrench": {"z": "-6.99e-12 N"},
    "requirements": {"fatigue": {"factor": 1e-6, "mean_stress": "swt"}},
}  # fmt: skip


@pytest.mark.parametrize("model", ["closed-form", None])
def test_a_load_that_may_compress_all_of_an_amplitude_leaves_a_range(model):
    """It had the root of a negative number."""
    (check,) = flexcli.verdicts(yaml.safe_dump(SPEC), model=model).checks
    assert check.verdict is not Verdict.FAIL
    assert check.factor_range is None or check.factor_range[0] > 0.0


@pytest.mark.parametrize("method", ["goodman", "soderberg", "swt", "none"])
def test_no_more_is_borne_at_the_stress_ratio_of_tests_than_they_found(method):
    E, h, l, turn, found = 100e9, 1e-3, 50e-3, 0.02, 430e6
    fatigue = {"value": f"{found} Pa", "cycles": 1e5, "stress_ratio": 0.1}
    spec = {
        "flexure": 1,
        "material": {
            "youngs_modulus": f"{E} Pa", "tensile_strength": "1100 MPa",
            "yield_strength": "1000 MPa", "fatigue_amplitude": fatigue,
        },
        "geometry": {"kind": "moment-blade", "h": f"{h} m", "l": f"{l} m", "b": "1 mm"},
        "stroke": {"rotation": [f"{0.1 * turn} rad", f"{turn} rad"], "cycles": 1e5},
        "requirements": {"fatigue": {"factor": 2, "mean_stress": method}},
    }  # fmt: skip
    (check,) = flexcli.verdicts(yaml.safe_dump(spec), model="closed-form").checks
    # pure bending, E h θ/2l: the same stress ratio whatever the load
    borne = found / (0.45 * E * h * turn / 2.0 / l)
    assert check.factor <= borne * (1.0 + 1e-6)
    if method != "soderberg":
        assert check.factor == pytest.approx(borne, rel=1e-6)
