"""The rectangular section: moments against integrals, stresses and shear against definitions."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.section import axial_stress, blade_volume, second_moment, shear_parameter

ROUNDING = 1e-12
SIMPSON = 1e-9  # Simpson's rule is exact for the square it integrates; the rest is rounding

sizes = st.floats(1e-6, 1e3)


def test_second_moment_is_the_integral_of_the_distance_squared():
    width, depth = 3.0, 0.7
    y = np.linspace(-depth / 2, depth / 2, 3)
    simpson = width * depth / 6 * (y**2 @ np.array([1.0, 4.0, 1.0]))
    assert second_moment(width, depth) == pytest.approx(simpson, rel=SIMPSON)


@given(b=sizes, h=sizes)
def test_the_stiff_axis_is_the_one_across_the_longer_side(b, h):
    about_h, about_b = second_moment(b, h), second_moment(h, b)
    assert (about_h <= about_b * (1 + ROUNDING)) == (h <= b * (1 + ROUNDING)) or h == b
    assert about_h * b**2 == pytest.approx(about_b * h**2, rel=ROUNDING)


@given(scale=st.sampled_from([1e-3, 1e3]), h=sizes, l=sizes, b=sizes)
def test_volume_and_stress_scale_with_the_unit_of_length(scale, h, l, b):
    in_other = blade_volume(3, h * scale, l * scale, b * scale)
    assert in_other == pytest.approx(blade_volume(3, h, l, b) * scale**3, rel=ROUNDING)
    stress = axial_stress(5.0, h * scale, b * scale)
    assert stress == pytest.approx(axial_stress(5.0, h, b) / scale**2, rel=ROUNDING)


def test_shear_parameter_is_its_definition():
    # 12 E I/(κ G A l²) with κ = 5/6 and G = E/2(1 + ν)
    E, nu, b, d, l = 70e9, 0.3, 4e-3, 2e-3, 0.02
    shear_modulus = E / (2 * (1 + nu))
    defined = 12 * E * second_moment(b, d) / (5 / 6 * shear_modulus * b * d * l**2)
    assert shear_parameter(depth=d, l=l, poisson_ratio=nu) == pytest.approx(defined, rel=ROUNDING)


def test_arrays_agree_with_element_wise_calls():
    h, b = np.array([[1e-4], [2e-4]]), np.array([1e-3, 5e-3, 1e-2])
    whole = second_moment(b, h)
    assert whole.shape == (2, 3)
    assert whole[1, 2] == second_moment(b[2], h[1, 0])
