import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.blade_spring import (
    blade_springs,
    deformation_rows,
    middle_stiffness,
)
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.formulas.restrained_torsion import restrained_stiffness
from flexcli.formulas.rigid_motion import motion_at

E, G = 114e9, 42.5e9
h, l, b = 0.4e-3, 20e-3, 8e-3
END = (l, 0.0, 0.0)

ROUNDING = 1e-12
"""Relative: sums of a few hundred positive terms."""

PROFILES = {
    "constant": Constant(h),
    "necked-down": NeckedDown(h, 0.2 * l),
    "notch": Notch(20e-6, l / 2),
    "filleted": Filleted(h, 2e-3),
    "taper": Tabulated((0.0, 0.3, 1.0), (h, 2 * h, 3 * h)),
}


def springs(profile=PROFILES["constant"], **changes):
    return blade_springs(profile=profile, **{"l": l, "b": b, "E": E, "G": G, **changes})


def blade_stiffness(springs, point):
    B = deformation_rows(springs, point)
    return B.T @ np.diag(springs.stiffness) @ B


def blade_compliance(springs, point):
    back = np.linalg.inv(deformation_rows(springs, point))
    return back @ np.diag(1 / springs.stiffness) @ back.T


def test_end_stiffness_is_the_beam_of_the_textbook():
    # Przemieniecki (1968), section 5.6, the block of the far end; y is his y, z his z
    K = blade_stiffness(springs(), END)
    A, I_z, I_y = b * h, b * h**3 / 12, h * b**3 / 12
    Φ_y, Φ_z = (12 * E * I * 1.2 / (G * A * l**2) for I in (I_z, I_y))
    expected = np.zeros((6, 6))
    expected[0, 0] = E * A / l
    expected[1, 1] = 12 * E * I_z / (l**3 * (1 + Φ_y))
    expected[2, 2] = 12 * E * I_y / (l**3 * (1 + Φ_z))
    expected[3, 3] = K[3, 3]
    expected[4, 4] = (4 + Φ_z) * E * I_y / (l * (1 + Φ_z))
    expected[5, 5] = (4 + Φ_y) * E * I_z / (l * (1 + Φ_y))
    expected[1, 5] = expected[5, 1] = -6 * E * I_z / (l**2 * (1 + Φ_y))
    expected[2, 4] = expected[4, 2] = 6 * E * I_y / (l**2 * (1 + Φ_z))
    np.testing.assert_allclose(K, expected, rtol=ROUNDING, atol=1e-9)


def test_end_compliance_is_that_of_a_cantilever():
    C = blade_compliance(springs(shear_factor=np.inf), END)
    bending = E * b * h**3 / 12
    assert C[1, 1] == pytest.approx(l**3 / (3 * bending), rel=ROUNDING)
    assert C[1, 5] == pytest.approx(l**2 / (2 * bending), rel=ROUNDING)
    assert C[5, 5] == pytest.approx(l / bending, rel=ROUNDING)
    sheared = blade_compliance(springs(), END)
    assert sheared[1, 1] - C[1, 1] == pytest.approx(l / (5 / 6 * G * b * h), rel=1e-8)


@given(thin=st.floats(-5.0, -0.5), wide=st.floats(-3.0, 0.0))
def test_integrals_are_the_closed_form_at_any_ratio(thin, wide):
    size = {"h": l * 10**thin, "b": l * 10**wide}
    found = springs(Constant(size["h"]), b=size["b"])
    expected = middle_stiffness(E=E, G=G, l=l, **size)
    np.testing.assert_allclose(found.stiffness, [float(k) for k in expected], rtol=ROUNDING)
    assert found.across_thickness == pytest.approx(l / 2, rel=ROUNDING)


@pytest.mark.parametrize("share", [0.5, 0.2])
def test_parts_in_series_are_the_whole_blade(share):
    first, second = share * l, (1 - share) * l
    one = blade_compliance(springs(l=first), (first, 0, 0))
    other = blade_compliance(springs(l=second), (second, 0, 0))
    forth = motion_at((second, 0, 0))
    whole = forth @ one @ forth.T + other
    np.testing.assert_allclose(whole, blade_compliance(springs(), END), rtol=ROUNDING, atol=1e-20)


def test_hinges_that_meet_are_the_whole_blade():
    found = springs(NeckedDown(h, l / 2))
    np.testing.assert_allclose(found.stiffness, springs().stiffness, rtol=ROUNDING)


@pytest.mark.parametrize("name", ["constant", "necked-down", "notch", "filleted"])
def test_mirrored_profiles_have_both_centres_in_the_middle(name):
    found = springs(PROFILES[name])
    assert found.across_thickness == pytest.approx(l / 2, rel=ROUNDING)
    assert found.across_width == pytest.approx(l / 2, rel=ROUNDING)


def test_taper_has_its_centres_where_one_over_h_cubed_and_h_put_them():
    found = springs(Tabulated((0.0, 1.0), (h, 2 * h)))
    # ∫ s (1 + s)⁻³ / ∫ (1 + s)⁻³ = ⅓ and ∫ s (1 + s)⁻¹ / ∫ (1 + s)⁻¹ = 1/ln 2 − 1
    assert found.across_thickness == pytest.approx(l / 3, rel=ROUNDING)
    assert found.across_width == pytest.approx(l * (1 / np.log(2) - 1), rel=ROUNDING)


def test_shallow_notch_is_the_blade_it_is_cut_in():
    found = springs(Notch(h, 1e-9 * h))
    np.testing.assert_allclose(found.stiffness, springs().stiffness, rtol=1e-8)


def test_notch_turns_as_paros_and_weisbord_have_it_for_a_thin_throat():
    # M/θ = 2 E b e^2.5/(9 π r^0.5), Paros & Weisbord (1965), for e ≪ r
    e, r = 1e-9, 10e-3
    found = springs(Notch(e, r), l=2 * r)
    assert found.stiffness[5] == pytest.approx(2 * E * b * e**2.5 / (9 * np.pi * r**0.5), rel=1e-6)


def test_restrained_warping_is_that_of_the_strip():
    found = springs(warping="restrained")
    assert found.stiffness[3] == pytest.approx(
        float(restrained_stiffness(E=E, G=G, h=h, b=b, l=l)), rel=ROUNDING
    )
    hinge = 0.2 * l
    necked = springs(NeckedDown(h, hinge), warping="restrained")
    each = float(restrained_stiffness(E=E, G=G, h=h, b=b, l=hinge))
    assert necked.stiffness[3] == pytest.approx(each / 2, rel=ROUNDING)


def test_restrained_warping_of_a_varying_thickness_is_refused():
    with pytest.raises(ValueError, match="a profile Notch has not"):
        springs(PROFILES["notch"], warping="restrained")


@pytest.mark.parametrize("warping", ["free", "restrained"])
def test_array_call_equals_element_wise_calls(warping):
    rng = np.random.default_rng(3)
    thick, long, wide = (rng.uniform(1, 2, 5) * size for size in (h, l, b))
    young, shear = rng.uniform(0.9, 1.0, 5) * E, rng.uniform(1.0, 1.2, 5) * G
    many = springs(Constant(thick[:, None]), l=long, b=wide, E=young, G=shear, warping=warping)
    for k in range(5):
        one = springs(
            Constant(thick[k]), l=long[k], b=wide[k], E=young[k], G=shear[k], warping=warping
        )
        np.testing.assert_allclose(many.stiffness[k], one.stiffness, rtol=ROUNDING)
        np.testing.assert_allclose(many.across_thickness[k], one.across_thickness, rtol=ROUNDING)


@given(scale=st.floats(1e-3, 1e3))
def test_scaling_every_length_scales_forces_by_it_and_moments_by_its_cube(scale):
    found = springs(Constant(scale * h), l=scale * l, b=scale * b)
    powers = scale ** np.array([1, 1, 1, 3, 3, 3])
    np.testing.assert_allclose(found.stiffness, springs().stiffness * powers, rtol=1e-11)
