import numpy as np
import pytest

from flexcli.formulas.blade_spring import middle_stiffness
from flexcli.formulas.pivot import out_of_plane_stiffness
from flexcli.formulas.stage import translational_stiffness
from flexcli.formulas.torsion_bar import torsional_stiffness

E, G = 114e9, 42.5e9
h, l, b = 0.2e-3, 50e-3, 5e-3


def test_slender_blade_is_half_a_leaf_spring_stage():
    k = middle_stiffness(E=E, G=G, h=h, l=l, b=b)
    stage = translational_stiffness(E=E, h=h, l=l, b=b, blades=1)
    assert k.y == pytest.approx(stage, rel=4 * (h / l) ** 2)
    assert k.theta_z == pytest.approx(stage * l**2 / 12, rel=1e-12)


def test_shear_takes_from_the_width_what_timoshenko_s_beam_says():
    k = middle_stiffness(E=E, G=G, h=h, l=l, b=b)
    bending = out_of_plane_stiffness(E=E, h=h, l=l, b=b, blades=1)
    # force over bending l³/12EI and shear l/(κ G A), one after the other
    assert 1 / k.z == pytest.approx(1 / bending + 1.2 * l / (G * b * h), rel=1e-12)


def test_thin_strip_twists_with_a_third_of_b_h_cubed():
    k = middle_stiffness(E=E, G=G, h=1e-4 * b, l=l, b=b)
    strip = torsional_stiffness(G=G, J=b * (1e-4 * b) ** 3 / 3, l=l)
    assert float(k.theta_x) == pytest.approx(strip, rel=1e-4)


def test_array_call_equals_element_wise_calls():
    thick = np.array([1e-4, 2e-4, 1e-3])
    many = middle_stiffness(E=E, G=G, h=thick, l=l, b=b)
    for k, one in enumerate(thick):
        alone = middle_stiffness(E=E, G=G, h=one, l=l, b=b)
        for found, expected in zip(many, alone, strict=True):
            assert np.broadcast_to(found, 3)[k] == pytest.approx(float(expected), rel=1e-14)
