"""Pivots of hinged limbs: exact four-bar kinematics, blades as long hinges, γ and γ/2."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import fsolve

from flexcli.formulas import pivot
from flexcli.formulas.hinged_pivot import (
    CARDS,
    admissible_rotation,
    hinge_rotations,
    parasitic_shift,
    rotational_stiffness,
)
from flexcli.formulas.notch_compliance import (
    bending_reach,
    circular_compliance,
    planar_compliance,
)
from flexcli.formulas.profile import NeckedDown
from flexcli.numerics.signomial import variables

ALPHA = 0.6
deltas = st.floats(-3.0, 3.0)


def four_bar(theta, l, p, inner_fixed=True):
    """Return shift of the centre and rotations of inner and outer hinges, exact for pins."""
    near, far = (p, p + l) if inner_fixed else (p + l, p)
    axes = [np.array([np.cos(a), np.sin(a)]) for a in (ALPHA, -ALPHA)]
    turn = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])

    def limbs(shift):
        return [shift + turn @ (far * u) - near * u for u in axes]

    shift, info, found, _ = fsolve(
        lambda d: [v @ v - l**2 for v in limbs(d)], np.zeros(2), full_output=True, xtol=1e-14
    )
    assert found == 1 or np.abs(info["fvec"]).max() < 1e-14
    turned = []
    for limb, u in zip(limbs(shift), axes, strict=True):
        rest = (far - near) * u
        turned.append(np.arctan2(rest[0] * limb[1] - rest[1] * limb[0], rest @ limb))
    fixed, moving = np.array(turned), theta - np.array(turned)
    return shift, *((fixed, moving) if inner_fixed else (moving, fixed))


@pytest.mark.parametrize("p", [-1.4, -0.75, -0.5, -0.2, 0.3, 1.0])
@pytest.mark.parametrize("inner_fixed", [True, False])
def test_hinges_turn_as_those_of_a_four_bar_linkage(p, inner_fixed):
    theta = 1e-3
    _, inner, outer = four_bar(theta, 1.0, p, inner_fixed)
    expected = hinge_rotations(l=1.0, p=p, theta=theta)
    # the exact rotations of the two limbs differ from it by opposite terms in θ²
    assert inner.mean() == pytest.approx(expected[0], abs=5 * theta**3 * (1 + abs(p)) ** 3)
    assert outer.mean() == pytest.approx(expected[1], abs=5 * theta**3 * (1 + abs(p)) ** 3)


@pytest.mark.parametrize("p", [-1.4, -0.75, -0.5, -0.2, 0.3, 1.0])
def test_the_centre_shifts_as_that_of_a_four_bar_linkage(p):
    # the outer hinges on the moving body: blades, too, pull a remote centre towards the fixed
    # end, against their direction, which counts as positive
    theta = 1e-3
    shift, *_ = four_bar(theta, 1.0, p)
    expected = parasitic_shift(l=1.0, p=p, theta=theta, half_angle=ALPHA)
    assert -shift[0] == pytest.approx(expected, rel=1e-4)


def test_far_from_the_centre_a_hinged_limb_shifts_five_sixths_of_a_blade():
    # x²/(2l) of a link against 3x²/(5l) of a blade
    common = {"l": 1.0, "p": 1e6, "theta": 0.01, "half_angle": ALPHA}
    ratio = parasitic_shift(**common) / pivot.parasitic_shift(**common)
    assert ratio == pytest.approx(5 / 6, rel=1e-5)


@given(st.floats(-2.0, 2.0))
def test_hinges_of_half_the_length_are_the_pivot_of_blades(delta):
    E, h, l, b = 114e9, 6e-4, 17.5e-3, 10e-3
    p, l_c = delta * l, l / 2
    K = rotational_stiffness(
        K=E * b * h**3 / 12 / l_c, l=l - l_c, p=p + l_c / 2, c=l_c / np.sqrt(12)
    )
    blades = pivot.rotational_stiffness(E=E, h=h, l=l, b=b, p=p)
    assert pytest.approx(blades, rel=1e-11) == K


def limb(C_hinge, l, p):
    """Return the compliance about the centre of two hinges at p and p + l, in series."""
    total = np.zeros((3, 3))
    for place in (p, p + l):
        shift = np.eye(3)
        shift[1, 2] = -place
        total += shift @ C_hinge @ shift.T
    return total


@pytest.mark.parametrize("delta", [-0.9, -0.5, 0.0, 0.4, 1.5])
def test_notch_hinges_in_series_give_the_stiffness(delta):
    l, p = 20e-3, delta * 20e-3
    C = circular_compliance(E=210e9, b=10e-3, e=100e-6, r=4e-3)
    exact = np.linalg.inv(limb(np.diag(C), l, p)[1:, 1:])[1, 1]
    hinge = {"K": 1 / C.turn, "l": l, "p": p, "limbs": 1}
    c = bending_reach(across=C.across, turn=C.turn)
    assert rotational_stiffness(c=c, **hinge) == pytest.approx(exact, rel=1e-10)
    # pins with springs miss it by some (c/l)²
    assert rotational_stiffness(c=0.0, **hinge) == pytest.approx(exact, rel=2e-3)


def test_a_necked_down_limb_integrated_as_one_beam_gives_the_stiffness():
    E, h, l, b, l_c, p = 114e9, 2e-4, 20e-3, 10e-3, 2e-3, 5e-3
    C = planar_compliance(NeckedDown(h, l_c), E=E, l=l, b=b, a=-p)
    hinge = {"K": E * b * h**3 / 12 / l_c, "l": l - l_c, "p": p + l_c / 2}
    K = rotational_stiffness(c=l_c / np.sqrt(12), limbs=1, **hinge)
    assert pytest.approx(np.linalg.inv(C[1:, 1:])[1, 1], rel=1e-10) == K


@given(deltas)
def test_a_pivot_and_its_mirror_image_in_the_middle_of_the_limbs_agree(delta):
    near, far = ({"l": 1.0, "p": d} for d in (delta, -1 - delta))
    stiff = [rotational_stiffness(K=1.0, c=0.05, **at) for at in (near, far)]
    assert stiff[0] == pytest.approx(stiff[1], rel=1e-12)
    turn = [admissible_rotation(gamma=1.0, **at) for at in (near, far)]
    assert turn[0] == pytest.approx(turn[1], rel=1e-12)
    shift = [parasitic_shift(theta=1.0, half_angle=0.5, **at) for at in (near, far)]
    assert shift[0] == pytest.approx(shift[1], rel=1e-12, abs=1e-15)


@given(st.floats(-0.999, -0.001))
def test_crossing_limbs_turn_by_more_than_gamma_at_most_by_twice(delta):
    # lecture: "Max pivot rotation > γ"
    theta = admissible_rotation(gamma=1.0, l=1.0, p=delta)
    assert 1.0 < theta <= 2.0 == admissible_rotation(gamma=1.0, l=1.0, p=-0.5)


@given(st.floats(0.0, 5.0))
def test_a_remote_centre_turns_by_no_more_than_gamma(delta):
    # lecture: "Max pivot rotation ≈ γ/2", exact where the centre is a limb's length away
    assert admissible_rotation(gamma=1.0, l=1.0, p=delta) <= 1.0
    assert admissible_rotation(gamma=1.0, l=1.0, p=1.0) == 0.5


@given(deltas)
def test_the_more_strained_hinge_is_at_its_limit(delta):
    theta = admissible_rotation(gamma=0.1, l=1.0, p=delta)
    turned = np.abs(hinge_rotations(l=1.0, p=delta, theta=theta))
    assert turned.max() == pytest.approx(0.1, rel=1e-12)
    energy = rotational_stiffness(K=2.0, l=1.0, p=delta, c=0.0, limbs=3) * theta**2
    assert energy == pytest.approx(3 * 2.0 * (turned**2).sum(), rel=1e-12)


def test_the_shifts_are_equal_for_equal_outer_radius_at_half_a_limb():
    # lecture: "parasitic shifts approx. equal": outer radius 1, cross l = 2, RCC l = 1/(1 + δ)
    cross = parasitic_shift(l=2.0, p=-1.0, theta=0.1, half_angle=ALPHA)
    for delta, ratio in ((0.5, 1.0), (1.0, 2.0)):
        l = 1 / (1 + delta)
        rcc = parasitic_shift(l=l, p=delta * l, theta=0.1, half_angle=ALPHA)
        assert -rcc / cross == pytest.approx(ratio, rel=1e-12)


def test_the_chart_has_its_least_stiffness_and_most_rotation_at_the_cross_pivot():
    table = next(card for card in CARDS if card.tables).tables["delta"]
    columns = {name: [f(d) for d in table.values] for name, (_, f) in table.columns.items()}
    assert table.values[np.argmin(columns["stiffness/K"])] == -0.5
    assert table.values[np.argmax(columns["rotation/gamma"])] == -0.5
    assert min(columns["stiffness/K"]) == pytest.approx(1.0, rel=1e-12)


def test_pins_run_on_signomials_in_the_distance():
    (p,) = variables("p")
    K = rotational_stiffness(K=0.2, l=20e-3, p=p, c=0.0)
    assert K.is_posynomial
    at = rotational_stiffness(K=0.2, l=20e-3, p=3e-3, c=0.0)
    assert K.at(p=3e-3) == pytest.approx(at, rel=1e-12)


@given(st.lists(st.tuples(st.floats(0.1, 10), deltas), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    l, p = np.array(rows).T
    for function, extra in (
        (rotational_stiffness, {"K": 2.0, "c": 0.01}),
        (admissible_rotation, {"gamma": 0.1}),
        (parasitic_shift, {"theta": 0.1, "half_angle": 0.5}),
    ):
        single = [function(l=x, p=y, **extra) for x, y in rows]
        assert function(l=l, p=p, **extra) == pytest.approx(single, rel=1e-12)
