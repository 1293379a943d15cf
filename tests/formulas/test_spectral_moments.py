"""Moments of a stress: bandwidth of ideal noise, and what no spectrum has."""

import numpy as np
import pytest
from stresses import spectral_moments

from flexcli.formulas.spectral_moments import Moments


def test_bandwidth_of_ideal_low_pass_noise():
    # α_1 = √3/2, α_2 = √5/3 (Lutes and Sarkani 2004, section 4)
    moments = spectral_moments([1e-9, 1.0], [1.0, 1.0])
    assert float(moments.alpha1) == pytest.approx(np.sqrt(3) / 2, rel=1e-8)
    assert float(moments.alpha2) == pytest.approx(np.sqrt(5) / 3, rel=1e-8)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: Moments(1.0, 2.0, 1.0, 1.0), "no spectrum"),
        (lambda: Moments(1.0, 0.5, 1.0, 1.0), "no spectrum"),
        (lambda: Moments(1.0, 1.0, 0.0, 1.0), "m2 must be positive"),
        (lambda: spectral_moments([100], [1.0]), "m0 must be positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
