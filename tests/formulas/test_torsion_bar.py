from math import sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.blade_spring import blade_springs, deformation_rows
from flexcli.formulas.profile import Constant
from flexcli.formulas.torsion_bar import (
    CARDS,
    admissible_twist,
    offset_bars_stiffness,
    shear_stress,
    torsional_stiffness,
)
from flexcli.formulas.torsion_section import shear_factor, torsion_constant
from flexcli.formulas.torsion_shapes import circle_torsion_constant, strip_torsion_constant
from flexcli.numerics.signomial import variables

E, G = 114e9, 42.5e9
h, l, b = 0.5e-3, 20e-3, 5e-3

ROUNDING = 1e-12
"""Relative: a few products and sums of like size."""


def springs(thickness, width):
    return blade_springs(profile=Constant(thickness), l=l, b=width, E=E, G=G, shear_factor=np.inf)


@pytest.mark.parametrize("bars", [1, 2])
def test_bars_in_line_are_as_stiff_as_the_blades_they_are(bars):
    K = torsional_stiffness(G=G, J=torsion_constant(h, b), l=l, bars=bars)
    assert float(K) == pytest.approx(bars * springs(h, b).stiffness[3], rel=ROUNDING)


@given(r=st.floats(0.0, 0.1), bars=st.integers(2, 6))
def test_bars_around_an_axis_are_blades_whose_body_turns_about_it(r, bars):
    # the width is radial: the axis lies beside the blade across its width
    blade = springs(h, b)
    around = blade.stiffness @ deformation_rows(blade, (l, 0.0, -r))[:, 3] ** 2
    K = offset_bars_stiffness(
        E=E, G=G, I=b * h**3 / 12, J=float(torsion_constant(h, b)), l=l, r=r, bars=bars
    )
    assert pytest.approx(bars * around, rel=ROUNDING) == K


def test_strip_with_its_inner_edge_on_the_axis_tends_to_many_narrow_bars():
    # a width b cut into narrow fibres bends as the warping constant b³h³/144 has it, twice
    fibres = 2000
    r = (np.arange(fibres) + 0.5) * b / 2 / fibres
    I = b / 2 / fibres * h**3 / 12
    bent = offset_bars_stiffness(E=E, G=G, I=I, J=0.0, l=l, r=r, bars=2).sum()
    assert bent == pytest.approx(12 * E * b**3 * h**3 / 144 / l**3, rel=1e-6)


def test_admissible_twist_brings_the_equivalent_stress_to_the_admissible_one():
    k = float(shear_factor(h, b))
    θ = admissible_twist(G=G, h=h, l=l, sigma=400e6, factor=k)
    assert sqrt(3) * shear_stress(G=G, h=h, l=l, theta=θ, factor=k) == pytest.approx(400e6)


def test_circle_has_sixteen_torques_over_pi_cubes_of_its_diameter():
    d, θ = 1e-3, 0.1
    T = torsional_stiffness(G=G, J=circle_torsion_constant(d), l=l) * θ
    τ = shear_stress(G=G, h=d, l=l, theta=θ, factor=0.5)
    assert τ == pytest.approx(16 * T / (np.pi * d**3), rel=ROUNDING)


def test_square_stiffness_and_stress_are_those_of_its_table():
    # Timoshenko & Goodier, section 109: J = 0.1406 a⁴, τ = T/(0.208 a³)
    a, θ = 1e-3, 0.1
    T = float(torsional_stiffness(G=G, J=torsion_constant(a, a), l=l)) * θ
    τ = shear_stress(G=G, h=a, l=l, theta=θ, factor=float(shear_factor(a, a)))
    assert pytest.approx(0.1406, abs=5e-5) == T * l / (G * a**4 * θ)
    assert pytest.approx(0.208, abs=5e-4) == T / (τ * a**3)


def test_stiffness_takes_signomials():
    x, y, z = variables("h", "b", "l")
    K = torsional_stiffness(G=G, J=strip_torsion_constant(x, y), l=z)
    assert K.at(h=h, b=b, l=l) == pytest.approx(
        torsional_stiffness(G=G, J=strip_torsion_constant(h, b), l=l), rel=ROUNDING
    )


@pytest.mark.parametrize("card", CARDS, ids=lambda card: card.name)
def test_array_call_equals_element_wise_calls(card):
    lengths = card.example["l"] * np.array([1.0, 2.0, 5.0])
    each = [card.function(**{**card.example, "l": one}) for one in lengths]
    np.testing.assert_allclose(card.function(**{**card.example, "l": lengths}), each, rtol=1e-14)
