from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.torsion_section import CARDS, shear_factor, torsion_constant, warping

ROUNDING = 1e-13
"""Relative: a dozen terms of one sign."""

TIMOSHENKO = [
    (1.0, 0.675, 0.1406),
    (1.2, 0.759, 0.166),
    (1.5, 0.848, 0.196),
    (2.0, 0.930, 0.229),
    (2.5, 0.968, 0.249),
    (3.0, 0.985, 0.263),
    (4.0, 0.997, 0.281),
    (5.0, 0.999, 0.291),
    (10.0, 1.000, 0.312),
]
"""b/a, k and k_1 of the table in Timoshenko & Goodier, Theory of Elasticity, section 109."""

ratios = st.floats(-6.0, 6.0).map(lambda exponent: 10.0**exponent)


@pytest.mark.parametrize(("ratio", "k", "k_1"), TIMOSHENKO)
def test_factors_are_those_of_the_printed_table(ratio, k, k_1):
    assert shear_factor(1.0, ratio) == pytest.approx(k, abs=6e-4)
    assert torsion_constant(1.0, ratio) / ratio == pytest.approx(k_1, abs=6e-4)


@given(ratio=ratios)
def test_series_is_the_plain_sum_of_two_thousand_terms(ratio):
    thin, broad = min(1.0, ratio), max(1.0, ratio)
    n = np.arange(1.0, 4001.0, 2.0)
    plain = 1.0 - 192.0 / pi**5 * thin / broad * np.sum(
        np.tanh(n * pi * broad / (2.0 * thin)) / n**5
    )
    J = torsion_constant(1.0, ratio)
    assert float(J) == pytest.approx(broad * thin**3 / 3.0 * plain, rel=ROUNDING)


def test_series_of_membrane_agrees():
    # J = 4 ∬ψ with ψ in double sines: another series, which converges with the cube of the count
    m = np.arange(1.0, 400.0, 2.0)
    b = 1.7
    term = 1.0 / (m[:, None] ** 2 * m**2 * (m[:, None] ** 2 + (m / b) ** 2))
    assert float(torsion_constant(1.0, b)) == pytest.approx(
        256.0 / pi**6 * b * term.sum(), rel=1e-6
    )


@given(h=ratios, b=ratios)
def test_order_of_the_sides_does_not_matter(h, b):
    assert torsion_constant(h, b) == torsion_constant(b, h)
    assert shear_factor(h, b) == shear_factor(b, h)


def test_thin_strip_has_a_third_of_b_h_cubed_and_unit_shear_factor():
    h = 1e-6
    assert float(torsion_constant(h, 1.0)) == pytest.approx(h**3 / 3.0 * (1 - 0.63 * h), rel=1e-8)
    assert shear_factor(h, 1.0) == 1.0


@given(ratio=st.floats(1.0, 1e3), scale=st.floats(1e-6, 1e6))
def test_torsion_constant_scales_with_the_fourth_power(ratio, scale):
    one = float(torsion_constant(1.0, ratio))
    assert float(torsion_constant(scale, scale * ratio)) == pytest.approx(scale**4 * one, rel=1e-12)


@pytest.mark.parametrize("formula", [torsion_constant, shear_factor])
def test_array_call_equals_element_wise_calls(formula):
    h, b = np.array([[1e-4], [1e-3]]), np.array([1e-4, 2e-3, 5.0])
    each = [[formula(one, other) for other in b] for one in h[:, 0]]
    assert formula(h, b).shape == (2, 3)
    np.testing.assert_array_equal(formula(h, b), each)


@pytest.mark.parametrize("side", [0.0, -1e-3, np.inf, np.nan])
def test_sides_that_are_none_are_refused(side):
    with pytest.raises(ValueError, match="b must be positive"):
        torsion_constant(1e-3, side)


def test_table_of_the_card_starts_at_the_square():
    table = CARDS[0].tables["ratio"]
    _, J = table.columns["J/(b h³)"]
    assert table.values[0] == 1.0
    assert J(1.0) == pytest.approx(0.1406, abs=5e-5)


@pytest.mark.parametrize("ratio", [0.05, 0.2, 0.5, 1.0])
def test_warping_is_that_of_the_function_that_frees_the_faces(ratio):
    """∇²ψ = 0 by its series, taken at the nodes of a quadrature; its largest value beside them."""
    x, w = np.polynomial.legendre.leggauss(120)
    y, z = np.meshgrid(x / 2.0, x * ratio / 2.0, indexing="ij")
    psi = y * z
    for k in range(20):
        rate = (2 * k + 1) * np.pi / ratio
        fading = np.exp(rate * (abs(y) - 0.5)) * (1.0 - np.exp(-2.0 * rate * abs(y)))
        wave = np.sin(rate * z) * np.sign(y) * fading / (1.0 + np.exp(-rate))
        psi = psi - 8.0 * ratio**2 / np.pi**3 * (-1) ** k / (2 * k + 1) ** 3 * wave
    weight = np.outer(w, w) * ratio / 4.0
    constant, largest = warping(ratio, 1.0)
    # twenty terms leave some 1e-6 of the warping of a square, of which little is left
    assert float(constant) == pytest.approx(float((weight * psi**2).sum()), rel=1e-5)
    # the nodes beside the largest miss it by some 1e-3
    assert float(largest) == pytest.approx(float(psi.max()), rel=2e-3)
