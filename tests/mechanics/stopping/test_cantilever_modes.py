import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.mechanics.stopping.cantilever_modes import cantilever_modes

E, I, L, m = 60e9, 1e-13, 20e-3, 5e-3
CANTILEVER_ROOTS = (1.8751041, 4.6940911, 7.8547574, 10.9955407)
"""βL of the bare cantilever, as tables print them."""


def test_a_bare_cantilever_has_the_tabulated_roots():
    blade = cantilever_modes(E=E, I=I, L=L, L_a=L / 2, m=0.0, blade_mass=1e-3, modes=4)
    roots = np.sqrt(blade.angular * np.sqrt(1e-3 * L**3 / (E * I)))
    np.testing.assert_allclose(roots, CANTILEVER_ROOTS, atol=5e-8)


def test_the_modes_carry_all_the_mass_in_the_end():
    blade = cantilever_modes(E=E, I=I, L=L, L_a=L / 2, m=m, blade_mass=1e-3, modes=8)
    assert (blade.base**2).sum() == pytest.approx(6e-3, rel=1e-2)
    assert (blade.base**2).sum() < 6e-3


@pytest.mark.parametrize("share", [0.2, 0.5, 0.75, 0.9])
def test_a_massless_blade_at_a_stop_is_the_propped_overhang(share):
    blade = cantilever_modes(E=E, I=I, L=L, L_a=share * L, m=m)
    L_a, L_b = share * L, (1 - share) * L
    free = blade.angular[0] ** 2
    against = free + blade.stop[0] ** 2 / blade.stop_residual
    assert m * free == pytest.approx(3 * E * I / L**3, rel=1e-12)
    assert m * against == pytest.approx(12 * E * I / (L_b**2 * (3 * L_a + 4 * L_b)), rel=1e-10)


@given(st.floats(0.0, 10e-3), st.floats(1e-9, 1e-6))
def test_a_massless_blade_with_a_turning_tip_mass_has_the_two_frequencies_of_its_2x2(c, J):
    blade = cantilever_modes(E=E, I=I, L=L, L_a=L / 2, m=m, c=c, J=J, modes=2)
    # flexibility of tip deflection and slope; the mass moves by w + cθ
    F = np.array([[L**3 / 3, L**2 / 2], [L**2 / 2, L]]) / (E * I)
    M = np.array([[m, m * c], [m * c, m * c * c + J]])
    expected = np.sort(1 / np.sqrt(np.linalg.eigvals(F @ M).real))
    np.testing.assert_allclose(blade.angular, expected, rtol=1e-8)


def test_modes_and_residual_give_the_static_answer_to_a_force_at_the_stop():
    L_a = 0.6 * L
    for modes in (1, 3):
        blade = cantilever_modes(E=E, I=I, L=L, L_a=L_a, m=m, blade_mass=1e-3, modes=modes)
        soft = blade.stop / blade.angular**2
        tip = blade.tip @ soft + blade.tip_residual
        assert tip == pytest.approx(L_a**2 * (3 * L - L_a) / (6 * E * I), rel=1e-12)
        assert blade.base_moment @ soft + blade.moment_residual == pytest.approx(L_a, rel=1e-12)


def test_more_modes_leave_less_to_the_residual():
    residuals = [
        cantilever_modes(E=E, I=I, L=L, L_a=0.6 * L, m=m, blade_mass=1e-3, modes=n).stop_residual
        for n in (1, 2, 4, 8)
    ]
    assert residuals == sorted(residuals, reverse=True)
    assert residuals[-1] > 0.0


def test_base_moment_of_the_first_mode_is_that_of_the_tip_force_of_a_massless_blade():
    blade = cantilever_modes(E=E, I=I, L=L, L_a=L / 2, m=m)
    stiffness = 3 * E * I / L**3
    assert blade.base_moment[0] == pytest.approx(stiffness * L * blade.tip[0], rel=1e-12)


@pytest.mark.parametrize("L_a", [0.0, 21e-3])
def test_a_stop_off_the_blade_is_refused(L_a):
    with pytest.raises(ValueError, match="must lie on the blade"):
        cantilever_modes(E=E, I=I, L=L, L_a=L_a, m=m)
