"""Blades that point at one centre, at rest, against stars whose forces cancel and against pairs."""

from math import pi

import pytest

from flexcli.formulas.held_blades import at_rest

EVEN = (0.0, 2.0 * pi / 3.0, 4.0 * pi / 3.0)
ROUNDING = 1e-12


@pytest.mark.parametrize("gamma", [-1.4, 0.3, 1.7])
def test_an_even_star_without_shear_has_its_closed_forms(gamma):
    assert at_rest(slender=0.05, gamma=gamma, angles=EVEN, Phi=0.0) == pytest.approx(
        (1.0, 1.0, 1.0)
    )


@pytest.mark.parametrize("Phi", [0.01, 0.3])
def test_shear_softens_the_bending_of_an_even_star_that_needs_a_force_across_its_blades(Phi):
    gamma = 1.7
    found = at_rest(slender=0.05, gamma=gamma, angles=EVEN, Phi=Phi)
    # uniform bending is free of shear, the S-shaped part γ is less by 1/(1 + Φ)
    bending = (1.0 + 3.0 * gamma / (1.0 + Phi)) / (1.0 + 3.0 * gamma)
    stiffness = (1.0 + 3.0 * gamma**2 / (1.0 + Phi)) / (1.0 + 3.0 * gamma**2)
    assert found == pytest.approx((stiffness, bending, bending), rel=ROUNDING)
