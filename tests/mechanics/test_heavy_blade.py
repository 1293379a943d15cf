"""A blade with its mass whose fillets are tiny, or leave next to nothing between them."""

import numpy as np
import pytest
from scipy.integrate import quad

from flexcli.formulas.profile import Constant, Filleted
from flexcli.mechanics.heavy_blade import heavy_blade

E, L, B, H, DENSITY = 200e9, 20e-3, 5e-3, 0.1e-3, 7800.0


def by_quadrature(r):
    """Return stretching, force per shift of an end kept from turning, and its turning stiffness."""

    def thickness(s):
        x = min(s, L - s)
        return H if x >= r else H + 2.0 * (r - (r**2 - (r - x) ** 2) ** 0.5)

    def whole(weight):
        parts = [(0.0, r), (r, L / 2.0), (L / 2.0, L - r), (L - r, L)]
        return sum(quad(weight, *part, epsabs=0.0, epsrel=1e-11, limit=400)[0] for part in parts)

    along = whole(lambda s: 1.0 / (E * B * thickness(s)))
    turns = whole(lambda s: 12.0 / (E * B * thickness(s) ** 3))
    shifts = whole(lambda s: 12.0 * (L / 2.0 - s) ** 2 / (E * B * thickness(s) ** 3))
    # symmetric: about its middle an end's force only shifts it and a moment only turns it
    return 1.0 / along, 1.0 / shifts, 1.0 / turns + (L / 2.0) ** 2 / shifts


@pytest.mark.parametrize("density", [0.0, DENSITY])
@pytest.mark.parametrize("r", [1e-7, 1e-5, 1e-3, 9.0e-3, L / 2.0 * (1.0 - 1e-6)])
def test_the_stiffness_of_a_filleted_blade_is_that_of_its_flexibility(r, density):
    blade = heavy_blade(Filleted(H, r), E=E, l=L, b=B, density=density)
    K = blade.stiffness[3:6, 3:6]
    assert np.diag(K) == pytest.approx(by_quadrature(r), rel=1e-7)
    motion = np.array([0.0, 1.0, 0.0])
    bent = blade.bending[:, 3:6] @ motion
    thick = H + 2.0 * r
    assert bent[0] == pytest.approx(6.0 / (B * thick**2) * K[1, 1] * L / 2.0, rel=1e-6)
    assert bent[-1] == pytest.approx(-bent[0], rel=1e-6)


def test_tiny_fillets_leave_the_modes_of_the_inside_as_they_are():
    plain, filleted = (
        heavy_blade(profile, E=E, l=L, b=B, density=DENSITY)
        for profile in (Constant(H), Filleted(H, 1e-7))
    )
    squares = [np.diag(each.stiffness)[6:8] for each in (plain, filleted)]
    assert squares[1] == pytest.approx(squares[0], rel=1e-3)
    assert filleted.mass[:6, :6] == pytest.approx(
        plain.mass[:6, :6], rel=1e-3, abs=1e-6 * plain.mass[0, 0]
    )


def test_fillets_that_meet_have_no_blade_between_them():
    nearly, wholly = (
        heavy_blade(Filleted(H, r), E=E, l=L, b=B, density=DENSITY)
        for r in (L / 2.0 * (1.0 - 1e-9), L / 2.0)
    )
    assert wholly.stiffness[:6, :6] == pytest.approx(nearly.stiffness[:6, :6], rel=1e-6)
    assert np.all(np.isfinite(wholly.mass))
