"""Compliance by the integral of M/(EI): beams, closed forms, and other quadratures."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from flexcli.formulas.notch import circular_stiffness, elliptic_stiffness
from flexcli.formulas.notch_compliance import (
    bending_reach,
    circular_compliance,
    planar_compliance,
)
from flexcli.formulas.pivot import rotational_stiffness
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.formulas.section import shear_parameter

INTEGRAL = 1e-11
"""Twice the settled share and the rounding of the steep powers."""
ratios = st.floats(1e-6, 10.0)


def test_a_constant_thickness_is_the_cantilever_of_the_textbooks():
    E, G, h, l, b = 200e9, 77e9, 3e-4, 0.05, 0.01
    I, A = b * h**3 / 12, b * h
    C = planar_compliance(Constant(h), E=E, l=l, b=b, a=l, G=G)
    bending = np.array([[l**3 / 3, l**2 / 2], [l**2 / 2, l]]) / (E * I)
    bending[0, 0] += 1.2 * l / (G * A)
    assert C[1:, 1:] == pytest.approx(bending, rel=INTEGRAL)
    assert C[0] == pytest.approx([l / (E * A), 0, 0], rel=INTEGRAL)


def test_shear_softens_a_guided_blade_by_its_parameter():
    # clamped–guided: about its middle a blade is softer by 1 + Φ
    E, nu, h, l = 200e9, 0.3, 0.02, 0.05
    stiff, soft = (
        planar_compliance(Constant(h), E=E, l=l, b=0.01, a=l / 2, G=G)[1, 1]
        for G in (np.inf, E / (2 * (1 + nu)))
    )
    assert soft / stiff == pytest.approx(
        1 + shear_parameter(depth=h, l=l, poisson_ratio=nu), rel=INTEGRAL
    )


@pytest.mark.parametrize("p", [-8e-3, -5e-3, 0.0, 2e-3, 20e-3])
def test_a_blade_held_at_a_distant_centre_is_the_blade_of_a_pivot(p):
    # the body turns about a point at p from the blade's start: 4EI/l (1 + 3δ + 3δ²)
    E, h, l, b = 114e9, 6e-4, 17.5e-3, 10e-3
    C = planar_compliance(Constant(h), E=E, l=l, b=b, a=-p)
    K = np.linalg.inv(C[1:, 1:])[1, 1]
    assert pytest.approx(rotational_stiffness(E=E, h=h, l=l, b=b, p=p, blades=1), rel=1e-10) == K


@given(ratios)
def test_the_integral_gives_the_closed_form_of_the_circular_hinge(ratio):
    C = circular_compliance(E=2.0, b=3.0, e=ratio, r=1.0)
    K = circular_stiffness(E=2.0, b=3.0, e=ratio, r=1.0)
    assert 1 / C.turn == pytest.approx(K, rel=INTEGRAL)


@pytest.mark.parametrize("ratio", [1e-4, 1e-2, 0.5])
@pytest.mark.parametrize("flat", [0.0, 0.2, 3.0])
def test_the_integral_gives_the_closed_form_of_the_elliptic_hinge(ratio, flat):
    C = planar_compliance(Notch(ratio, flat), E=1.0, l=2.0, b=1.0, a=1.0)
    K = elliptic_stiffness(E=1.0, b=1.0, e=ratio, l=2.0, depth=flat)
    assert 1 / C[2, 2] == pytest.approx(K, rel=INTEGRAL)


@pytest.mark.parametrize("ratio", [1e-3, 0.1, 1.0])
def test_stretch_and_sway_of_a_circular_hinge_are_an_adaptive_quadratures(ratio):
    E, G, b, r = 2.0, 0.8, 3.0, 1.0

    def over(power, lever):
        # 2 ∫ s^lever/h^power ds over half the notch, s = r sin φ
        def integrand(phi):
            h = ratio * r + 2 * r * (1 - np.cos(phi))
            return r * np.cos(phi) * (r * np.sin(phi)) ** lever / h**power

        cuts = [0, np.sqrt(ratio) / 2, np.pi / 2]
        return 2 * sum(
            quad(integrand, low, high, epsabs=0, epsrel=1e-12, limit=400)[0]
            for low, high in pairwise(cuts)
        )

    C = circular_compliance(E=E, b=b, e=ratio * r, r=r, G=G)
    assert C.along == pytest.approx(over(1, 0) / (E * b), rel=1e-10)
    sway = 12 * over(3, 2) / (E * b) + 1.2 * over(1, 0) / (G * b)
    assert C.across == pytest.approx(sway, rel=1e-10)


@pytest.mark.parametrize("ratio", [1e-5, 1e-3, 0.3])
def test_a_filleted_hinge_is_an_adaptive_quadratures(ratio):
    r, l, h = 1.0, 5.0, ratio
    cuts = [0, np.sqrt(ratio), np.pi / 2]
    fillet = sum(
        quad(
            lambda phi: r * np.cos(phi) / (h + 2 * r * (1 - np.cos(phi))) ** 3,
            low,
            high,
            epsabs=0,
            epsrel=1e-12,
            limit=400,
        )[0]
        for low, high in pairwise(cuts)
    )
    C = planar_compliance(Filleted(h, r), E=12.0, l=l, b=1.0, a=l / 2)
    assert C[2, 2] == pytest.approx(2 * fillet + (l - 2 * r) / h**3, rel=1e-10)


def test_a_fillet_without_radius_is_a_constant_blade():
    sharp = planar_compliance(Filleted(0.1, 0.0), E=1.0, l=2.0, b=1.0, a=1.0)
    blade = planar_compliance(Constant(0.1), E=1.0, l=2.0, b=1.0, a=1.0)
    assert sharp == pytest.approx(blade, rel=INTEGRAL, abs=1e-12)


def test_a_wedge_is_its_closed_form():
    # h from 1 to 2 over l = 1: ∫ds/h³ = (1 − 1/4)/2, ∫ds/h = ln 2
    C = planar_compliance(Tabulated((0.0, 1.0), (1.0, 2.0)), E=1.0, l=1.0, b=1.0, a=0.0)
    assert C[2, 2] == pytest.approx(12 * 3 / 8, rel=INTEGRAL)
    assert C[0, 0] == pytest.approx(np.log(2), rel=INTEGRAL)
    assert C[1, 2] == pytest.approx(-12 * 1 / 8, rel=INTEGRAL)  # ∫s/h³ ds = 1/8


def test_what_lies_between_hinges_is_rigid():
    E, h, l, l_c = 12.0, 1.0, 10.0, 1.0
    C = planar_compliance(NeckedDown(h, l_c), E=E, l=l, b=1.0, a=l / 2)
    arm = (l - l_c) / 2
    assert C[2, 2] == pytest.approx(2 * l_c, rel=INTEGRAL)
    assert C[1, 1] == pytest.approx(2 * (l_c * arm**2 + l_c**3 / 12), rel=INTEGRAL)


@given(ratios, st.floats(-3.0, 3.0))
def test_the_compliance_moves_with_its_point_as_a_rigid_body_does(ratio, a):
    hinge = {"E": 1.0, "l": 2.0, "b": 1.0, "G": 0.4}
    profile = Notch(ratio, 0.7)
    middle = planar_compliance(profile, a=1.0, **hinge)
    shift = np.eye(3)
    shift[1, 2] = a - 1.0
    moved = planar_compliance(profile, a=a, **hinge)
    assert moved == pytest.approx(shift @ middle @ shift.T, rel=1e-9, abs=1e-9 * middle[2, 2])
    assert (np.linalg.eigvalsh(middle / middle[2, 2]) > 0).all()


def test_the_reach_of_known_hinges():
    blade = planar_compliance(Constant(0.1), E=1.0, l=2.0, b=1.0, a=1.0)
    reach = bending_reach(across=blade[1, 1], turn=blade[2, 2])
    assert reach == pytest.approx(2 / np.sqrt(12), rel=INTEGRAL)
    # thin throat, h = e + s²/r: ∫s²/h³ = e r/3 ∫1/h³
    thin = circular_compliance(E=1.0, b=1.0, e=1e-8, r=1.0)
    assert bending_reach(across=thin.across, turn=thin.turn) == pytest.approx(
        np.sqrt(1e-8 / 3), rel=1e-6
    )


@given(st.lists(st.tuples(ratios, st.floats(0.1, 10), st.floats(1, 3)), min_size=1, max_size=4))
def test_arrays_agree_with_element_wise_calls(rows):
    e, r, b = np.array(rows).T
    whole = circular_compliance(E=2.0, b=b, e=e, r=r, G=0.7)
    for k, (x, y, z) in enumerate(rows):
        single = [float(C) for C in circular_compliance(E=2.0, b=z, e=x, r=y, G=0.7)]
        assert [C[k] for C in whole] == pytest.approx(single, rel=INTEGRAL, abs=0.0)


def test_a_profile_of_many_designs_agrees_with_each():
    h, r, l = np.array([0.1, 0.2]), np.array([0.5, 0.3]), np.array([2.0, 3.0])
    whole = planar_compliance(
        Filleted(h[:, None], r[:, None]), E=2.0, l=l, b=np.array([1.0, 4.0]), a=l / 3, G=0.7
    )
    assert whole.shape == (2, 3, 3)
    for k, b in enumerate((1.0, 4.0)):
        single = planar_compliance(Filleted(h[k], r[k]), E=2.0, l=l[k], b=b, a=l[k] / 3, G=0.7)
        assert whole[k] == pytest.approx(single, rel=INTEGRAL, abs=0.0)


@given(ratios, st.sampled_from([1e-6, 1e3]))
def test_a_change_of_the_unit_of_length_changes_no_digits(ratio, unit):
    C = circular_compliance(E=1.0, b=1.0, e=ratio, r=1.0, G=0.4)
    scaled = circular_compliance(E=1.0 / unit**2, b=unit, e=ratio * unit, r=unit, G=0.4 / unit**2)
    # m/N and rad/(N·m) for an unchanged newton
    expected = [C.along * unit, C.across * unit, C.turn / unit]
    assert scaled == pytest.approx(expected, rel=INTEGRAL, abs=0.0)


@pytest.mark.parametrize("ratio", [1e-9, 1e-12, 1e-15])
def test_a_throat_far_thinner_than_its_notch_bends_over_the_root_of_both(ratio):
    """c → √(e r/3), from the parabola that the notch is near its throat."""
    C = circular_compliance(E=1.0, b=1.0, e=ratio, r=1.0)
    reach = bending_reach(across=C.across, turn=C.turn)
    assert float(reach) == pytest.approx((ratio / 3.0) ** 0.5, rel=1e-8)


def test_a_throat_too_thin_to_be_told_is_refused():
    with pytest.raises(ArithmeticError, match="too thin"):
        circular_compliance(E=1.0, b=1.0, e=1e-40, r=1.0)
