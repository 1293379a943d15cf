"""Axial load, shear and blade mass against independent routes."""

import numpy as np
import pytest
from mechanisms_for_tests import E, G, cantilever, pivot
from scipy.integrate import quad

from flexcli.formulas import blade_mass, thick_blades
from flexcli.formulas.beam_column import s_bending, uniform_bending
from flexcli.formulas.handbook import loaded_pivot
from flexcli.formulas.pivot import axial_share, rotational_stiffness
from flexcli.formulas.section import shear_parameter
from flexcli.formulas.stage import translational_stiffness
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Load
from flexcli.mechanics.linear import linear
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.stability import critical_load
from flexcli.mechanics.tangent import held_stiffness

H, L, B = 1e-4, 20e-3, 10e-3
BLADE = {"E": E, "h": H, "l": L, "b": B}
EI = E * B * H**3 / 12.0
SLENDER = Effects(extension=False, shear=False)


@pytest.mark.parametrize("n", [-9.0, -2.0, -9e-4, 9e-4, 0.5, 40.0])
def test_stability_functions_solve_the_beam_column(n):
    """θ'' = n θ − c: opposite and equal end rotations by collocation of the exact solution."""
    k = np.sqrt(complex(n))
    uniform = (k / 2.0 / np.tanh(k / 2.0)).real
    tau = (np.tanh(k / 2.0) / (k / 2.0)).real
    assert uniform_bending(n) == pytest.approx(uniform, rel=1e-12)
    assert s_bending(n) == pytest.approx(n * tau / (12.0 * (1.0 - tau)), rel=1e-9)


@pytest.mark.parametrize("delta", [-0.9, -0.5, 0.0, 0.6])
@pytest.mark.parametrize("direction", [0.0, 1.1, np.pi / 2])
@pytest.mark.parametrize("size", [-4.0, 0.5, 8.0])
def test_loaded_pivot_has_the_stiffness_of_the_exact_solver(delta, direction, size):
    alpha, force = 0.7, size * EI / L**2
    layout = pivot(h=H, l=L, b=B, delta=-1.0 - delta, alpha=alpha, angle=np.pi)
    pull = (force * np.cos(direction), force * np.sin(direction))
    held = {"out": (None, None, 1e-5)}
    loads = [Load("out", (0.0, 0.0), pull)]
    found = solve(layout, held, loads=loads, effects=SLENDER, tolerance=1e-9).checked()
    tensions = [force * share for share in axial_share((alpha, -alpha), direction)]
    K = loaded_pivot.loaded_stiffness(**BLADE, p=delta * L, tensions=tensions)
    assert held_stiffness(found)[0, 0, 0] == pytest.approx(float(K), rel=1e-4)


def test_gains_are_the_derivatives_of_the_loaded_stiffness():
    alpha, p, small = 0.6, 0.3 * L, 1e-2 * EI / L**2

    def stiffness(force, direction):
        tensions = [force * s for s in axial_share((alpha, -alpha), direction)]
        return loaded_pivot.loaded_stiffness(**BLADE, p=p, tensions=tensions)

    slope = (stiffness(small, 0.0) - stiffness(-small, 0.0)) / (2.0 * small)
    gain = loaded_pivot.radial_gain(l=L, p=p, half_angle=alpha)
    assert slope == pytest.approx(gain, rel=1e-5)
    K_0 = rotational_stiffness(**BLADE, p=p)
    force = 30.0 * small
    curved = (stiffness(force, np.pi / 2) - K_0) / force**2
    gain = loaded_pivot.transverse_gain(**BLADE, p=p, half_angle=alpha)
    assert curved == pytest.approx(gain, rel=1e-3)


def test_shear_softens_guided_blade_and_cantilever_as_timoshenko_says():
    h, x = 3e-3, 1e-5
    Phi = shear_parameter(depth=h, l=L, poisson_ratio=E / (2.0 * G) - 1.0)
    layout = cantilever(h=h, l=L, b=B)
    K = translational_stiffness(E=E, h=h, l=L, b=B, blades=1)
    cases = ((0.0, K, thick_blades.stiffness_change(Phi=Phi)),)
    cases += ((None, K / 4.0, thick_blades.stiffness_change(Phi=Phi, series=0.25)),)
    for turn, stiffness, change in cases:
        found = linear(layout, {"tip": (None, x, turn)}).reactions[0, 0, 1] / x
        assert found == pytest.approx(stiffness * (1.0 + change), rel=1e-12)


def test_shear_lowers_buckling_by_engessers_first_term():
    h = 1e-3
    Phi = shear_parameter(depth=h, l=L, poisson_ratio=E / (2.0 * G) - 1.0)
    layout = cantilever(h=h, l=L, b=B)
    load = Load("tip", (L, 0.0), (-(np.pi**2) / 4.0 * E * B * h**3 / 12.0 / L**2, 0.0))
    with_shear = critical_load(layout, None, [load], most=1.5, effects=Effects(False, True))
    change = thick_blades.buckling_change(Phi=Phi, effective_length=2.0)
    assert with_shear.factor - 1.0 == pytest.approx(change, rel=0.01)


def test_blade_mass_shares_are_integrals_of_the_static_shapes():
    def square(shape):
        return quad(lambda s: shape(s) ** 2, 0.0, 1.0)[0]

    guided = square(lambda s: 3 * s**2 - 2 * s**3)
    assert guided == pytest.approx(blade_mass.TORSION_CLAMPED, rel=1e-12)
    for delta in (-1.0, -0.5, 0.4):
        J = square(lambda s, d=delta: (1 + d) * (3 * s**2 - 2 * s**3) + s**3 - s**2)
        found = blade_mass.pivot_inertia(m_b=1.0, l=1.0, p=delta, blades=1)
        assert found == pytest.approx(J, rel=1e-12)


@pytest.mark.parametrize(("ratio", "exact"), [(0.01, 2e-6), (0.1, 2e-4)])
def test_rayleighs_frequency_of_a_cantilever_with_tip_mass_is_an_upper_bound(ratio, exact):
    """Against the smallest root of 1 + cos k cosh k + (k/ratio)(cos k sinh k − sin k cosh k)."""
    k = np.linspace(0.1, 1.6, 200001)
    mass = 1.0 / ratio
    f = 1 + np.cos(k) * np.cosh(k) + k * mass * (np.cos(k) * np.sinh(k) - np.sin(k) * np.cosh(k))
    i = int(np.flatnonzero(f[:-1] * f[1:] < 0.0)[0])
    root = k[i] - f[i] * (k[i + 1] - k[i]) / (f[i + 1] - f[i])
    massless = np.sqrt(3.0 / mass)
    true = root**2 / massless - 1.0
    change = blade_mass.frequency_change(33.0 / 140.0 * ratio)
    assert 0.0 <= change - true < exact
