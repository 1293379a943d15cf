import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import legendre

from flexcli.formulas.restrained_torsion import (
    CARDS,
    restrained_stiffness,
    restrained_stresses,
)
from flexcli.formulas.torsion_section import shear_factor, torsion_constant
from flexcli.formulas.torsion_shapes import warping_constant
from flexcli.parts.geometries.torsion import TorsionBar

E, NU = 114e9, 0.34
G = E / (2 * (1 + NU))
h, b = 0.1e-3, 10e-3
PLATE_E = E / (1 - NU**2)


def twisted_plate(aspect, nu):
    """K l/(G J) of a Kirchhoff plate l × 1, both ends clamped, one turned about x by Ritz's method.

    w = y g(x) + Σ a_ij X_i(x) Y_j(y) with X_i clamped at both ends and Y_j odd polynomials.
    """
    l = aspect
    x, w_x = legendre.leggauss(40)
    y, w_y = legendre.leggauss(30)

    def derivatives(c, nodes, side):
        return [legendre.legval(nodes, legendre.legder(c, m)) * (2 / side) ** m for m in range(3)]

    clamped = legendre.legmul([2 / 3, 0, -2 / 3], [2 / 3, 0, -2 / 3])
    along = [derivatives(legendre.legmul(clamped, [0] * i + [1]), x, l) for i in range(1, 20, 2)]
    across = [derivatives([0] * j + [1], y, 1.0) for j in range(1, 13, 2)]
    turning = derivatives(legendre.poly2leg([0.5, 0.75, 0, -0.25]), x, l)
    shapes = [(turning, [0.5 * part for part in across[0]])]
    shapes += [(one, other) for one in along for other in across]
    root = np.sqrt(np.outer(w_x * l / 2, w_y / 2)).ravel()
    xx = np.array([np.outer(f[2], g[0]).ravel() * root for f, g in shapes])
    yy = np.array([np.outer(f[0], g[2]).ravel() * root for f, g in shapes])
    xy = np.array([np.outer(f[1], g[1]).ravel() * root for f, g in shapes])
    energy = xx @ xx.T + yy @ yy.T + nu * (xx @ yy.T + yy @ xx.T) + 2 * (1 - nu) * xy @ xy.T
    size = 1 / np.sqrt(np.diag(energy))
    energy = energy * np.outer(size, size)
    rest = np.linalg.lstsq(energy[1:, 1:], energy[1:, 0], rcond=1e-13)[0]
    bending = (energy[0, 0] - energy[0, 1:] @ rest) / size[0] ** 2  # K over D = E h³/(12 (1 − ν²))
    return bending / (12 * (1 - nu**2)) * l / (1 / (2 * (1 + nu)) / 3)


@pytest.mark.parametrize("nu", [0.0, 0.2, 0.3, 0.4, 0.45, 0.5])
@pytest.mark.parametrize("aspect", [0.5, 1.0, 2.0, 4.0])
def test_a_bar_tells_how_far_its_stiffness_may_be_from_that_of_a_clamped_plate(aspect, nu):
    bar = TorsionBar(kind="torsion-bar", h="1 um", l="1 mm", b="1 mm", warping="restrained")
    sizes = bar.sized({})._replace(h=1e-7, l=aspect * 1e-3, b=1e-3)
    K = restrained_stiffness(E=2 * (1 + nu), G=1.0, h=1e-4, b=1.0, l=aspect)
    high = float(K) * aspect / (1e-4**3 / 3) / twisted_plate(aspect, nu) - 1.0
    assert -1e-4 <= high <= bar.end_errors(sizes, nu).stiffness


@pytest.mark.parametrize("nu", [0.0, 0.3])
@pytest.mark.parametrize(("aspect", "near"), [(0.5, 0.01), (1.0, 0.007), (3.0, 0.004)])
def test_stiffness_is_that_of_a_clamped_plate(aspect, near, nu):
    thin = 1e-4
    K = restrained_stiffness(E=2 * (1 + nu), G=1.0, h=thin, b=1.0, l=aspect)
    ours = float(K) * aspect / (thin**3 / 3)
    assert ours == pytest.approx(twisted_plate(aspect, nu), rel=near)


def test_long_strip_twists_as_if_it_could_warp():
    for l in (1.0, 10.0):
        K = restrained_stiffness(E=E, G=G, h=h, b=b, l=l)
        free = G * torsion_constant(h, b) / l
        lead = 2 * np.sqrt(PLATE_E * warping_constant(h, b) / (G * torsion_constant(h, b))) / l
        assert float(K / free) == pytest.approx(1 / (1 - lead), rel=1e-12)


def test_short_strip_resists_by_bending_of_its_fibres():
    l = 1e-4
    bending = 12 * PLATE_E * warping_constant(h, b) / l**3
    K = restrained_stiffness(E=E, G=G, h=h, b=b, l=l)
    # the Saint-Venant part enters with 6/5 G J/l
    assert float(K) == pytest.approx(
        bending + 1.2 * G * float(torsion_constant(h, b)) / l, rel=1e-6
    )


@given(exponent=st.floats(-6.0, 4.0))
def test_stiffness_is_more_than_both_its_parts(exponent):
    l = b * 10.0**exponent
    free = G * float(torsion_constant(h, b)) / l
    bending = 12 * PLATE_E * warping_constant(h, b) / l**3
    K = float(restrained_stiffness(E=E, G=G, h=h, b=b, l=l))
    assert (1 - 1e-12) * (free + bending) <= K <= (1 + 1e-12) * (1.2 * free + bending)


def test_stiffness_is_smooth_where_the_forms_change():
    switch = 2 * np.sqrt(PLATE_E * warping_constant(h, b) / (G * torsion_constant(h, b)))
    below, above = restrained_stiffness(
        E=E, G=G, h=h, b=b, l=switch * np.array([1 - 1e-9, 1 + 1e-9])
    )
    assert float(below / above) == pytest.approx(1.0, abs=1e-8)
    assert below > above


@pytest.mark.parametrize("l", [5e-3, 20e-3, 60e-3])
def test_stresses_are_those_of_the_differential_equation(l):
    θ, n = 0.05, 1000
    GJ, EΓ = G * float(torsion_constant(h, b)), PLATE_E * warping_constant(h, b)
    step = l / n
    # G J ψ − E'Γ ψ'' = T for the twist rate ψ, which vanishes at both ends
    A = np.diag(np.full(n - 1, GJ + 2 * EΓ / step**2))
    A -= np.diag(np.full(n - 2, EΓ / step**2), 1) + np.diag(np.full(n - 2, EΓ / step**2), -1)
    rate = np.linalg.solve(A, np.ones(n - 1))
    rate *= θ / (step * rate.sum())
    found = restrained_stresses(E=E, G=G, h=h, b=b, l=l, theta=θ)
    shear = float(shear_factor(h, b)) * G * h * rate[n // 2 - 1]
    bend = (4 * rate[0] - rate[1]) / (2 * step)
    assert float(found.shear) == pytest.approx(shear, rel=1e-4)
    assert float(found.normal) == pytest.approx(PLATE_E * b * h / 4 * bend, rel=1e-3)


@given(l=st.floats(1e-3, 1.0), θ=st.floats(1e-3, 0.2))
def test_torque_is_the_bimoment_and_the_twist_of_half_the_strip(l, θ):
    K = float(restrained_stiffness(E=E, G=G, h=h, b=b, l=l))
    σ = float(restrained_stresses(E=E, G=G, h=h, b=b, l=l, theta=θ).normal)
    bimoment = warping_constant(h, b) * σ / (b * h / 4)
    half = G * float(torsion_constant(h, b)) * θ / 2 + bimoment
    assert K * θ * l / 2 == pytest.approx(half, rel=1e-10)


def test_moduli_that_no_isotropic_material_has_are_refused():
    with pytest.raises(ValueError, match="no isotropic material"):
        restrained_stiffness(E=3.5 * G, G=G, h=h, b=b, l=0.1)


def test_array_call_equals_element_wise_calls():
    l, width = np.array([[1e-3], [50e-3]]), np.array([1e-3, 10e-3, 50e-3])
    at = restrained_stresses(E=E, G=G, h=h, b=width, l=l, theta=0.1)
    K = restrained_stiffness(E=E, G=G, h=h, b=width, l=l)
    for i, j in np.ndindex(2, 3):
        one = {"E": E, "G": G, "h": h, "b": width[j], "l": l[i, 0]}
        assert K[i, j] == restrained_stiffness(**one)
        assert at.normal[i, j] == restrained_stresses(**one, theta=0.1).normal
        assert at.shear[i, j] == restrained_stresses(**one, theta=0.1).shear


def test_table_of_the_card_falls_to_one():
    table = CARDS[0].tables["slenderness"]
    _, ratio = table.columns["K l/(G J)"]
    found = [ratio(value) for value in table.values]
    assert found == sorted(found, reverse=True)
    assert found[-1] == pytest.approx(1.0, abs=0.011)
