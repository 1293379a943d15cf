"""Velocity shock: its energy."""

import numpy as np
import pytest

from flexcli.formulas.shock import velocity_shock_acceleration

ROUNDING = 1e-12


def test_the_energy_of_the_spring_is_that_of_the_jump():
    a, omega = velocity_shock_acceleration(0.11, 176), 2 * np.pi * 176
    assert float(a * a / omega**2) == pytest.approx(0.11**2, rel=ROUNDING)  # k d² = m V²


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: velocity_shock_acceleration(-1, 100), "V must be"),
        (lambda: velocity_shock_acceleration(1, 0), "fn must be positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
