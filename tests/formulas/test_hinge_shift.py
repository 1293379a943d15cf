"""The shift of a hinge's middle, against exact blades and limits."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from mechanisms_for_tests import cantilever

from flexcli.formulas.hinge_shift import blade_shift, circular_shift, profile_shift
from flexcli.formulas.profile import Constant, Filleted, Notch
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.mesh import Effects

ROUNDING = 1e-12
NEXT_ORDER = 2e-5
"""0.15 θ² of the leading order at θ = 10 mrad."""

PROFILES = {
    "blade": (Constant(1e-4), 20e-3),
    "circular": (Notch(1e-4, 2e-3), 4e-3),
    "elliptic": (Notch(5e-5, 1e-3), 6e-3),
    "filleted": (Filleted(1e-4, 5e-4), 10e-3),
}


@pytest.mark.parametrize("name", PROFILES)
def test_exact_hinges_turned_by_a_moment_shift_by_it(name):
    profile, l = PROFILES[name]
    theta = 1e-2
    slender = Effects(extension=False, shear=False)
    layout = cantilever(l=l, profile=profile)
    tip = solve(layout, held={"tip": (None, None, theta)}, effects=slender).checked()
    middle = tip.motions[0, 0, 0] + l / 2.0 * 2.0 * np.sin(theta / 2.0) ** 2
    assert profile_shift(profile, l=l, theta=theta) == pytest.approx(middle, rel=NEXT_ORDER)


def test_blade_is_an_arc():
    theta = 1e-3
    arc = np.sin(theta) / theta - np.cos(theta) / 2.0 - 0.5
    assert blade_shift(l=1.0, theta=theta) == pytest.approx(arc, rel=1e-6)
    found = profile_shift(Constant(1e-4), l=1.0, theta=theta)
    assert found == pytest.approx(blade_shift(l=1.0, theta=theta), rel=ROUNDING)


def test_thin_circular_throat_shifts_with_the_root_of_its_thickness():
    """Throat h = e + s²/r: f is a rational function and arctan of t = s/√(e r)."""
    t = np.linspace(-200.0, 200.0, 400_001)
    bend = t / 4 / (1 + t**2) ** 2 + 3 / 8 * (t / (1 + t**2) + np.arctan(t))
    share = 0.5 + bend / (3 * np.pi / 8)
    limit = np.trapezoid(share * (1 - share), t) / 2.0
    assert circular_shift(e=1e-8, r=1.0, theta=1.0) / 1e-4 == pytest.approx(limit, rel=1e-4)
    assert limit == pytest.approx(0.155, abs=5e-4)


@given(factors=st.lists(st.floats(0.1, 10.0), min_size=1, max_size=4))
def test_an_array_of_hinges_equals_the_hinges_one_by_one(factors):
    e, r = 1e-4 * np.array(factors), 2e-3
    found = circular_shift(e=e, r=r, theta=0.1)
    one = [float(circular_shift(e=each, r=r, theta=0.1)) for each in e]
    assert found == pytest.approx(one, rel=ROUNDING)
