"""The gamma function against scipy's."""

import doctest

import numpy as np
import pytest
from scipy import special

from flexcli.numerics import gamma as module
from flexcli.numerics.gamma import gamma

FROM_LOGARITHM = 5e-13  # one rounding of ln Γ, which is 700 at the end of the range


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


def test_gamma_is_scipy_s_over_the_range_of_floats():
    x = np.geomspace(1e-6, 170, 400)
    np.testing.assert_allclose(gamma(x), special.gamma(x), rtol=FROM_LOGARITHM)


@pytest.mark.parametrize("n", range(1, 20))
def test_gamma_of_a_whole_number_is_the_factorial_before_it(n):
    assert float(gamma(np.array(float(n + 1)))) == pytest.approx(
        float(np.prod(np.arange(1.0, n + 1))), rel=FROM_LOGARITHM
    )
