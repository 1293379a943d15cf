"""Modulus and radius of a contact: limits and symmetry."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.contact import contact_modulus
from flexcli.formulas.handbook.contact_load import relative_radius

moduli = st.floats(1e8, 1e12)
ratios = st.floats(0.0, 0.5)


@given(moduli, ratios, moduli, ratios)
def test_bodies_may_change_places(E_1, nu_1, E_2, nu_2):
    here = contact_modulus(E_1=E_1, nu_1=nu_1, E_2=E_2, nu_2=nu_2)
    assert contact_modulus(E_1=E_2, nu_1=nu_2, E_2=E_1, nu_2=nu_1) == pytest.approx(here, rel=1e-14)
    assert here < min(E_1 / (1 - nu_1**2), E_2 / (1 - nu_2**2))


def test_rigid_partner_leaves_the_plane_strain_modulus():
    found = contact_modulus(E_1=70e9, nu_1=0.5, E_2=np.inf, nu_2=0.3)
    assert found == pytest.approx(70e9 / 0.75, rel=1e-15)


@pytest.mark.parametrize(
    ("R_2", "relative"), [(np.inf, 2.0), (2.0, 1.0), (-4.0, 4.0)], ids=["flat", "ball", "hollow"]
)
def test_relative_radius_of_a_ball_on(R_2, relative):
    assert relative_radius(2.0, R_2) == pytest.approx(relative, rel=1e-15)


def test_arrays_equal_elements():
    E = np.array([60e9, 70e9, 200e9])[:, None]
    nu = np.array([0.0, 0.3])
    together = contact_modulus(E_1=E, nu_1=nu, E_2=210e9, nu_2=0.3)
    single = [[contact_modulus(E_1=e, nu_1=n, E_2=210e9, nu_2=0.3) for n in nu] for e in E[:, 0]]
    assert together == pytest.approx(np.array(single), rel=1e-15)
