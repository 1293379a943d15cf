"""The driving point of a leaf-spring stage and its stiffness under an axial load."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.buckling import euler_load
from flexcli.formulas.section import second_moment
from flexcli.formulas.stage import (
    admissible_translation,
    drive_rotation,
    end_stress,
    loaded_stiffness,
    translational_stiffness,
)

BLADE = {"E": 200e9, "h": 300e-6, "l": 50e-3, "b": 10e-3}
CRITICAL = 2 * euler_load(E=200e9, I=second_moment(10e-3, 300e-6), l=50e-3, ends="clamped-guided")


def test_the_rotation_is_least_at_mid_height_and_falls_with_the_square_of_the_spacing():
    def turn(drive, half):
        return drive_rotation(**BLADE, places=(-half, half), drive=drive, x=1e-3)

    assert turn(25e-3, 10e-3) == 0.0
    assert turn(35e-3, 10e-3) == pytest.approx(-turn(15e-3, 10e-3))
    assert turn(50e-3, 10e-3) / turn(50e-3, 20e-3) == pytest.approx(4.0, rel=1e-4)


def test_the_rotation_is_that_of_the_assembled_linear_blades():
    from planar_joint import blade_rows

    h, l, b, E, half, drive = 300e-6, 50e-3, 10e-3, 200e9, 8e-3, 43e-3
    K = np.zeros((3, 3))
    for y in (-half, half):
        e, w, phi = blade_rows(l=l, p=0.0, angle=0.0)
        e = e - np.array([0.0, 0.0, y])  # the tip's motion along the blade at the height y
        I = second_moment(b, h)
        K += E * h * b / l * np.outer(e, e) + E * I * (
            12 / l**3 * np.outer(w, w)
            - 6 / l**2 * (np.outer(w, phi) + np.outer(phi, w))
            + 4 / l * np.outer(phi, phi)
        )
    force = np.array([0.0, 1.0, drive])  # along y at the height of the drive
    d = np.linalg.solve(K, force)
    x = d[1] + d[2] * drive
    expected = d[2]
    got = drive_rotation(**BLADE, places=(-half, half), drive=drive, x=x)
    # the formula takes the travel as that of the blades' ends; it turns by a few µrad only
    assert got == pytest.approx(expected, rel=1e-3)


@given(st.floats(-50.0, 0.99))
def test_the_loaded_stiffness_solves_the_beam_column(share):
    k = np.sqrt(complex(share * CRITICAL / 2 / (200e9 * second_moment(10e-3, 300e-6))))
    half = k * 50e-3 / 2
    if abs(half) > 0.2:
        expected = (share * CRITICAL / (50e-3 * (np.tan(half) / half - 1))).real
        got = loaded_stiffness(**BLADE, axial=share * CRITICAL)
        assert got == pytest.approx(expected, rel=1e-9)


def test_the_series_and_the_closed_form_meet():
    base = CRITICAL / np.pi**2 * 0.01  # where (κl/2)² = 0.0025
    low, high = (float(loaded_stiffness(**BLADE, axial=base * s)) for s in (1 - 1e-9, 1 + 1e-9))
    assert low == pytest.approx(high, rel=2e-9)


def test_the_stiffness_vanishes_at_eulers_load_and_is_negative_beyond():
    unloaded = translational_stiffness(**BLADE)
    assert loaded_stiffness(**BLADE, axial=CRITICAL) == pytest.approx(0.0, abs=1e-9 * unloaded)
    assert loaded_stiffness(**BLADE, axial=1.01 * CRITICAL) < 0.0
    assert loaded_stiffness(**BLADE, axial=0.0) == pytest.approx(unloaded, rel=1e-14)


def test_loaded_stiffness_of_an_array_is_that_of_its_elements():
    loads = np.array([-100.0, 0.0, 1e-3, 50.0])
    each = [float(loaded_stiffness(**BLADE, axial=float(p))) for p in loads]
    assert loaded_stiffness(**BLADE, axial=loads) == pytest.approx(each, rel=1e-15)


def test_the_admissible_stroke_reaches_the_stress():
    x = admissible_translation(E=200e9, h=300e-6, l=50e-3, stress=100e6)
    assert end_stress(E=200e9, h=300e-6, l=50e-3, x=x) == pytest.approx(100e6)
