"""Loads that buckle the joint fail a requirement on its stress, whatever the stress."""

from math import pi

import pytest
from strategies import design

from flexcli.engine.check import check
from flexcli.results import Verdict

STEEL = {
    "name": "steel",
    "youngs_modulus": "210 GPa",
    "poisson_ratio": 0.3,
    "yield_strength": "2000 MPa",
}
H, L, B = 0.5e-3, 50e-3, 10e-3
EULER = pi**2 / 4.0 * 210e9 * B * H**3 / 12.0 / L**2
"""Of a blade that is free at its tip [N]."""

SLENDER = 1e-3
"""What the blade's own shortening and shear change of Euler's load, (π h/l)² in size."""


def judged(force, direction="180 deg", model=None):
    spec = design(
        {"kind": "cantilever", "h": f"{H} m", "l": f"{L} m", "b": f"{B} m"}, {"yield": 1.5},
        {"push": {"load": {"force": f"{force} N", "direction": direction}}}, material=STEEL,
    )  # fmt: skip
    (row,) = check(spec, spec.fixed_sizes(), "test", model).checks
    return row


@pytest.mark.parametrize("model", [None, "exact"])
@pytest.mark.parametrize("times", [1.05, 3.0, 20.0])
def test_a_column_beyond_its_euler_load_fails_at_the_share_that_it_bears(times, model):
    row = judged(times * EULER, model=model)
    assert row.verdict is Verdict.FAIL
    assert row.factor == pytest.approx(1.0 / times, rel=SLENDER)
    assert "buckles" in row.quantity


def test_a_column_below_its_euler_load_and_one_that_is_pulled_do_not():
    assert judged(0.9 * EULER, model="exact").verdict is Verdict.PASS
    assert judged(3.0 * EULER, "0 deg", model="exact").verdict is Verdict.PASS


def test_a_column_beyond_its_euler_load_does_not_pass_by_any_model():
    for model in ("closed-form", "linear", "exact"):
        assert judged(1.2 * EULER, model=model).verdict is not Verdict.PASS
