"""Peaks of a Gaussian signal: counts that cross-check each other, and the extreme value."""

import numpy as np
import pytest
from scipy.integrate import quad

from flexcli.formulas.peaks import (
    davenport_peak_factor,
    peak_factor,
)

ROUNDING = 1e-12  # a handful of operations


def test_three_sigma_is_expected_once_in_e_to_the_4_5_cycles():
    T = np.exp(4.5) / 200
    assert float(peak_factor(200, T)) == pytest.approx(3, rel=ROUNDING)


def test_davenport_factor_is_the_mean_of_the_extreme_value_density():
    # P(max < η) = exp(−N e^(−η²/2)); its mean tends to Davenport's with error O((ln N)^(-3/2))
    N = 600.0
    mean = quad(lambda x: -np.expm1(-N * np.exp(-(x**2) / 2)), 0, 20)[0]
    assert float(davenport_peak_factor(10, 60)) == pytest.approx(mean, rel=0.005)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: peak_factor(1, 0.5), "more than one cycle"),
        (lambda: peak_factor(100, -1), "T must be positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
