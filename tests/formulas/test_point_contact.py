"""A ball on a body: printed numbers, the pressure's integral, and stresses under its centre."""

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.contact import POINT_SHEAR, chord_deviation, point_contact
from flexcli.formulas.handbook.contact_load import point_load

forces = st.floats(1e-3, 1e3)
radii = st.floats(1e-4, 1.0)
moduli = st.floats(1e9, 1e12)


def greatest_shear(nu):
    """Give the greatest shear on the axis over the peak pressure (Johnson 1985, eq. 3.45)."""
    z = np.linspace(0.3, 0.7, 40001)
    axial = 1.0 / (1.0 + z**2)
    radial = (1.0 + nu) * (1.0 - z * np.arctan(1.0 / z)) - axial / 2.0
    return np.max(np.abs(axial - radial)) / 2.0


def test_chapter_9_radius_pressure_and_shear_are_reproduced():
    # section 9.1.3: a = 0.127 (printed as an area in mm²), p = 85.8 N/mm², τ = 26.6 MPa under
    # F_e = 2.88 N, R = 50 mm; the materials are not printed, 53.2 GPa is E* found from p
    contact = point_contact(F=2.88, R=50e-3, E_star=53.2e9)
    assert contact.radius * 1e3 == pytest.approx(0.127, abs=0.0005)
    assert contact.pressure / 1e6 == pytest.approx(85.8, abs=0.05)
    assert contact.shear / 1e6 == pytest.approx(26.6, abs=0.05)


@pytest.mark.parametrize(("nu", "factor"), [(0.25, 0.32), (0.3, POINT_SHEAR), (0.35, 0.30)])
def test_shear_factor_is_the_greatest_on_the_axis(nu, factor):
    assert greatest_shear(nu) == pytest.approx(factor, abs=0.005)


def test_shear_factor_is_that_of_a_poisson_ratio_of_three_tenths():
    assert greatest_shear(0.3) == pytest.approx(POINT_SHEAR, abs=5e-5)


@given(forces, radii, moduli)
def test_pressure_over_the_contact_carries_the_force(F, R, E_star):
    contact = point_contact(F=F, R=R, E_star=E_star)
    # half an ellipsoid of pressure: 2/3 p π a²
    carried = 2.0 / 3.0 * contact.pressure * pi * contact.radius**2
    assert carried == pytest.approx(F, rel=1e-12)


@given(forces, radii, moduli)
def test_force_is_the_slope_of_the_energy_and_three_halves_of_force_over_approach(F, R, E_star):
    # F = 4/3 E* √R δ^(3/2), so dF/dδ = 3F/(2δ) = 2 E* a
    contact = point_contact(F=F, R=R, E_star=E_star)
    assert 1.5 * F / contact.approach == pytest.approx(2 * E_star * contact.radius, rel=1e-12)


@given(forces, radii, moduli)
def test_point_load_inverts_the_pressure(F, R, E_star):
    p = point_contact(F=F, R=R, E_star=E_star).pressure
    assert point_load(p=p, R=R, E_star=E_star) == pytest.approx(F, rel=1e-12)


def test_no_force_makes_no_contact_and_arrays_equal_elements():
    F = np.array([0.0, 1.0, 8.0])
    together = np.array(point_contact(F=F, R=0.05, E_star=50e9))
    single = np.array([point_contact(F=f, R=0.05, E_star=50e9) for f in F]).T
    assert together == pytest.approx(single, rel=1e-15)
    assert together[:, 0].tolist() == [0.0] * 4


@pytest.mark.parametrize("share", [0.7, 0.9, 1.1184, 1.5])
def test_a_line_is_off_a_ball_by_its_middle_or_its_end(share):
    x = np.linspace(0.0, 1.0, 200_001)
    off = np.max(np.abs(x ** (2.0 / 3.0) - share * x))
    assert chord_deviation(share) == pytest.approx(off, rel=1e-8)
