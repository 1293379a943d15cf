"""Necked-down stage: the leaf spring at ξ = 1, the integrals over the hinges, pins at ξ → 0."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas import stage
from flexcli.formulas.necked_stage import (
    compliance_share,
    compression_stiffness,
    end_stress,
    shear_in_shift,
    shortening,
    stretch_in_shift,
    translational_stiffness,
)
from flexcli.numerics.quadrature import gauss_rule
from flexcli.numerics.signomial import variables

ROUNDING = 1e-12
BLADE = {"E": 200e9, "h": 300e-6, "l": 50e-3}
sizes = st.floats(1e-5, 1.0)
shares = st.floats(1e-6, 1.0)


def test_full_length_hinges_are_the_leaf_spring_stage():
    b, x = 10e-3, 1e-3
    K = translational_stiffness(b=b, xi=1.0, blades=3, **BLADE)
    assert pytest.approx(stage.translational_stiffness(b=b, blades=3, **BLADE), rel=ROUNDING) == K
    stress = end_stress(x=x, xi=1.0, **BLADE)
    assert stress == pytest.approx(stage.end_stress(x=x, **BLADE), rel=ROUNDING)
    assert shortening(l=50e-3, x=x, xi=1.0) == pytest.approx(
        stage.shortening(l=50e-3, x=x), rel=ROUNDING
    )


@given(shares)
def test_stiffness_stress_and_shortening_are_the_integrals_over_two_hinges(xi):
    E, h, l, b, F = 200e9, 3e-4, 0.05, 0.01, 1.0
    bending, l_c = E * b * h**3 / 12, xi * l / 2
    nodes, weights = gauss_rule(6)
    s, w = l_c * nodes, l_c * weights
    x = 2 * (w @ (F * (l / 2 - s) ** 2)) / bending
    assert translational_stiffness(E=E, h=h, l=l, b=b, xi=xi, blades=1) == pytest.approx(
        F / x, rel=ROUNDING
    )
    assert end_stress(E=E, h=h, l=l, x=x, xi=xi) == pytest.approx(
        6 * (F * l / 2) / (b * h**2), rel=ROUNDING
    )
    slope = F / bending * (l / 2 * s - s**2 / 2)
    middle = F / bending * (l / 2 * l_c - l_c**2 / 2)
    path = w @ slope**2 + middle**2 * (l - 2 * l_c) / 2
    assert shortening(l=l, x=x, xi=xi) == pytest.approx(path, rel=ROUNDING)
    # the force along turned hinges stretches them; their shear, a tenth of the stroke, tilts it
    turned = 2 * (w @ slope)
    stretched = -F * turned / (E * b * h) / path
    assert stretch_in_shift(h=h, l=l, xi=xi) == pytest.approx(stretched, rel=ROUNDING)
    sheared = (1 + 0.1 * x / (xi * l) * turned / path) / 1.1**2 - 1
    assert shear_in_shift(Phi=0.1, xi=xi) == pytest.approx(sheared, rel=ROUNDING, abs=ROUNDING)


def test_short_hinges_tend_to_pins_with_springs():
    # hinge: k = EI/l_c; two hinges bend by x/l each: K = 2k/l², λ = x²/(2l)
    E, h, l, b, xi = 200e9, 3e-4, 0.05, 0.01, 1e-9
    k = E * b * h**3 / 12 / (xi * l / 2)
    assert translational_stiffness(E=E, h=h, l=l, b=b, xi=xi, blades=1) == pytest.approx(
        2 * k / l**2, rel=2 * xi
    )
    assert shortening(l=l, x=1e-3, xi=xi) == pytest.approx(1e-6 / (2 * l), rel=2 * xi)


@pytest.mark.parametrize("xi", [1e-13, 1e-8, 1e-3, 0.5, 1.0 - 1e-9])
def test_the_share_keeps_its_digits_for_short_hinges(xi):
    # 1 − (1 − ξ)³ without cancellation; the plain difference has one digit left at ξ = 1e-15
    assert compliance_share(xi) == pytest.approx(-np.expm1(3 * np.log1p(-xi)), rel=1e-14)


def test_compression_stiffness_is_that_of_two_bars_in_series():
    E, h, l, b, xi = 200e9, 3e-4, 0.05, 0.01, 0.3
    bar = E * b * h / (xi * l / 2)
    assert compression_stiffness(E=E, h=h, l=l, b=b, xi=xi, blades=4) == pytest.approx(
        4 * bar / 2, rel=ROUNDING
    )


def test_the_formulas_run_on_signomials_in_the_dimensions():
    h, l, b = variables("h", "l", "b")
    at = {"h": 2e-4, "l": 0.04, "b": 0.008}
    K = translational_stiffness(E=1e9, h=h, l=l, b=b, xi=0.3)
    assert K.is_monomial
    assert K.at(**at) == pytest.approx(translational_stiffness(E=1e9, xi=0.3, **at), rel=ROUNDING)
    sigma = end_stress(E=1e9, h=h, l=l, x=1e-3, xi=0.3)
    assert sigma.is_monomial
    (xi,) = variables("xi")
    share = compression_stiffness(E=1e9, h=h, l=l, b=b, xi=xi)
    assert share.is_monomial


@given(st.lists(st.tuples(sizes, sizes, shares), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    h, l, xi = np.array(rows).T
    for function, extra in (
        (translational_stiffness, {"E": 2.0, "b": 3.0}),
        (end_stress, {"E": 2.0, "x": 3.0}),
        (compression_stiffness, {"E": 2.0, "b": 3.0}),
    ):
        whole = function(h=h, l=l, xi=xi, **extra)
        single = [function(h=t, l=u, xi=v, **extra) for t, u, v in rows]
        assert whole == pytest.approx(single, rel=ROUNDING)
    single = [shortening(l=u, x=0.1, xi=v) for _, u, v in rows]
    assert shortening(l=l, x=0.1, xi=xi) == pytest.approx(single, rel=ROUNDING)


@given(h=sizes, l=sizes, b=sizes, xi=shares, unit=st.sampled_from([1e-6, 1e3]))
def test_a_change_of_the_unit_of_length_changes_no_digits(h, l, b, xi, unit):
    # E b h³/l³ is a pressure times a length
    K = translational_stiffness(E=1.0, h=h, l=l, b=b, xi=xi)
    scaled = translational_stiffness(E=1.0 / unit**2, h=h * unit, l=l * unit, b=b * unit, xi=xi)
    assert scaled * unit == pytest.approx(K, rel=ROUNDING)
