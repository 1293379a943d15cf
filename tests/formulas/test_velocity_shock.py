"""Velocity shock: energy, and ω² between acceleration and deflection."""

import numpy as np
import pytest

from flexcli.formulas.shock import velocity_shock_acceleration, velocity_shock_deflection

ROUNDING = 1e-12


def test_velocity_shock_acceleration_is_omega_squared_times_deflection():
    a, d = velocity_shock_acceleration(0.11, 176), velocity_shock_deflection(0.11, 176)
    assert float(a / d) == pytest.approx((2 * np.pi * 176) ** 2, rel=ROUNDING)
    assert float(a * d) == pytest.approx(0.11**2, rel=ROUNDING)  # energy: k d² = m V²


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: velocity_shock_acceleration(-1, 100), "V must be"),
        (lambda: velocity_shock_deflection(1, 0), "fn must be positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
