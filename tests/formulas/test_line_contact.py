"""A cylinder on a body: the pressure's integral, stresses under its centre line, its inverse."""

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.contact import LINE_SHEAR, line_contact
from flexcli.formulas.handbook.contact_load import line_load

CASE = {"b": 7.8e-3, "R": 50e-3, "E_star": 53.2e9}
forces = st.floats(1e-3, 1e3)
sizes = st.floats(1e-4, 1.0)
moduli = st.floats(1e9, 1e12)


@given(forces, sizes, sizes, moduli)
def test_pressure_over_the_contact_carries_the_force(F, b, R, E_star):
    contact = line_contact(F=F, b=b, R=R, E_star=E_star)
    # half an ellipse of pressure: π/2 a p b
    assert pi / 2 * contact.half_width * contact.pressure * b == pytest.approx(F, rel=1e-12)


def test_half_width_is_johnsons():
    # Johnson (1985), equation (4.43): a² = 4 P R/(π E*), P the force per length
    found = line_contact(F=10.0, **CASE).half_width
    assert found**2 == pytest.approx(4 * 10.0 / 7.8e-3 * 50e-3 / (pi * 53.2e9), rel=1e-14)


def test_shear_factor_is_the_greatest_on_the_axis():
    # Johnson (1985), equation (4.47): τ/p = (z − z²/√(1 + z²)) at depth z a, at 0.78 a
    z = np.linspace(0.5, 1.0, 100001)
    shear = z - z**2 / np.sqrt(1 + z**2)
    assert shear.max() == pytest.approx(LINE_SHEAR, abs=1e-8)
    assert z[shear.argmax()] == pytest.approx(0.786, abs=0.0005)


@given(forces, sizes, sizes, moduli)
def test_line_load_inverts_the_pressure(F, b, R, E_star):
    p = line_contact(F=F, b=b, R=R, E_star=E_star).pressure
    assert line_load(p=p, b=b, R=R, E_star=E_star) == pytest.approx(F, rel=1e-12)


def test_no_force_makes_no_contact_and_arrays_equal_elements():
    F = np.array([0.0, 1.0, 8.0])
    together = np.array(line_contact(F=F, **CASE))
    assert together == pytest.approx(np.array([line_contact(F=f, **CASE) for f in F]).T, rel=1e-15)
    assert together[:, 0].tolist() == [0.0] * 3
