"""Stage with four hinges: the lecture's example to its printed digits, and known stages."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas import necked_stage
from flexcli.formulas.hinged_stage import admissible_stroke, law_stroke, translational_stiffness
from flexcli.formulas.notch import (
    admissible_rotation,
    bending_factor,
    circular_stiffness,
    law_stiffness,
)
from flexcli.formulas.notch_compliance import (
    bending_reach,
    circular_compliance,
    planar_compliance,
)
from flexcli.formulas.profile import NeckedDown
from flexcli.numerics.signomial import variables

NOTCH = {"E": 210e9, "b": 10e-3, "e": 100e-6, "r": 4e-3}
SIGMA, LENGTH = 800e6, 50e-3
PRINT = 0.005e-3  # the lecture's strokes have two decimals in millimetres
shares = st.floats(1e-3, 1.0)


def hinge_rotation(K, factor=1.0):
    return admissible_rotation(K=K, b=NOTCH["b"], e=NOTCH["e"], sigma=SIGMA, factor=factor)


def test_the_simplified_formula_gives_the_lectures_2_84_mm():
    f = law_stroke(E=210e9, sigma=SIGMA, e=100e-6, r=4e-3, l=LENGTH)
    assert f == pytest.approx(2.84e-3, abs=PRINT)
    # it is the scaling law with 2/(9π), not with the printed 0.07, which gives 2.87 mm
    assert f == pytest.approx(hinge_rotation(law_stiffness(**NOTCH)) * LENGTH, rel=1e-12)
    rounded = 0.07 * 210e9 * 10e-3 * 100e-6**2.5 / 4e-3**0.5
    assert hinge_rotation(rounded) * LENGTH == pytest.approx(2.868e-3, abs=1e-6)


def test_the_exact_integral_gives_the_lectures_2_83_mm():
    gamma = hinge_rotation(circular_stiffness(**NOTCH))
    f = admissible_stroke(gamma=gamma, l=LENGTH, c=0.0)
    assert f == pytest.approx(2.83e-3, abs=PRINT)
    assert f == pytest.approx(2.8295e-3, abs=5e-8)


def test_what_the_printed_digits_tell_of_the_model_and_what_not():
    # at 2.83 mm: the arc, its sine and its chord, and hinges that also sway
    gamma = hinge_rotation(circular_stiffness(**NOTCH))
    hinge = circular_compliance(**NOTCH)
    c = bending_reach(across=hinge.across, turn=hinge.turn)
    alike = [
        np.sin(gamma) * LENGTH,
        np.tan(gamma) * LENGTH,
        admissible_stroke(gamma=gamma, l=LENGTH, c=c),
    ]
    assert alike == pytest.approx([2.83e-3] * 3, abs=PRINT)
    # not at 2.83 mm: with the stress concentration, or with l from end to end of the notches
    K = circular_stiffness(**NOTCH)
    concentrated = hinge_rotation(K, bending_factor(e=100e-6, r=4e-3)) * LENGTH
    shorter = gamma * (LENGTH - 2 * NOTCH["r"])
    for other in (concentrated, shorter):
        assert other < 2.83e-3 - 2 * PRINT


def test_the_chart_reading_is_the_lectures_2_86_mm():
    # f_max,n ≈ 15 read from the chart; exact: γE/σ = 14.85
    read = 15 * SIGMA * LENGTH / 210e9
    assert read == pytest.approx(2.86e-3, abs=PRINT)
    gamma = hinge_rotation(circular_stiffness(**NOTCH))
    assert gamma * 210e9 / SIGMA == pytest.approx(15, abs=0.5)


def test_half_the_thickness_gives_root_two_the_stroke():
    full, half = (law_stroke(E=210e9, sigma=SIGMA, e=e, r=4e-3, l=LENGTH) for e in (100e-6, 50e-6))
    assert half / full == pytest.approx(np.sqrt(2), rel=1e-14)


@given(shares)
def test_constant_hinges_give_the_necked_down_stage_even_when_long(xi):
    E, h, l, b = 200e9, 3e-4, 0.05, 0.01
    l_c = xi * l / 2
    K = translational_stiffness(K=E * b * h**3 / 12 / l_c, l=l - l_c, c=l_c / np.sqrt(12), limbs=3)
    necked = necked_stage.translational_stiffness(E=E, h=h, l=l, b=b, xi=xi, blades=3)
    assert pytest.approx(necked, rel=1e-12) == K
    # stroke at the moment of a hinge's centre
    gamma = 0.01
    moment = gamma * E * b * h**3 / 12 / l_c
    f = admissible_stroke(gamma=gamma, l=l - l_c, c=l_c / np.sqrt(12))
    assert f == pytest.approx(3 * 2 * moment / (l - l_c) / necked, rel=1e-12)


def test_a_limb_integrated_as_one_beam_gives_the_stage():
    E, h, l, b, l_c = 200e9, 3e-4, 0.05, 0.01, 0.004
    C = planar_compliance(NeckedDown(h, l_c), E=E, l=l, b=b, a=l / 2)
    hinge = {"K": E * b * h**3 / 12 / l_c, "l": l - l_c, "c": l_c / np.sqrt(12)}
    assert translational_stiffness(limbs=1, **hinge) == pytest.approx(1 / C[1, 1], rel=1e-11)


def test_the_law_stroke_is_a_monomial_and_pins_run_on_signomials():
    e, r, l = variables("e", "r", "l")
    f = law_stroke(E=210e9, sigma=SIGMA, e=e, r=r, l=l)
    assert f.is_monomial
    at = {"e": 1e-4, "r": 4e-3, "l": 0.05}
    assert f.at(**at) == pytest.approx(law_stroke(E=210e9, sigma=SIGMA, **at), rel=1e-12)
    K = translational_stiffness(K=law_stiffness(E=210e9, b=0.01, e=e, r=r), l=l, c=0.0)
    assert K.is_monomial


@given(st.lists(st.tuples(st.floats(0.1, 10), st.floats(0, 0.1)), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    l, c = np.array(rows).T
    for function, extra in (
        (translational_stiffness, {"K": 2.0}),
        (admissible_stroke, {"gamma": 0.1}),
    ):
        single = [function(l=x, c=y, **extra) for x, y in rows]
        assert function(l=l, c=c, **extra) == pytest.approx(single, rel=1e-14)
