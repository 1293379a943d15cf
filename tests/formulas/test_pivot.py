"""Pivots of equal blades: printed numbers, symmetry about δ = −½, and a beam assembly."""

from math import cos, pi, radians, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.pivot import (
    axial_share,
    end_stresses,
    out_of_plane_stiffness,
    parasitic_shift,
    rotational_stiffness,
)
from flexcli.formulas.section import second_moment

ROUNDING = 1e-12
TITANIUM = 114e9  # Pa, exercise 9 part II
BLADE = {"h": 637e-6, "l": 17.5e-3, "b": 10e-3}
deltas = st.floats(-5.0, 5.0)
sizes = st.floats(1e-5, 1.0)


# -- printed numbers ---------------------------------------------------------------------------


def test_stiffness_of_the_rocket_pivot_is_the_printed_one():
    # exercise 9 part II, question 2: k_1 ≈ 15.51 N·m/rad
    found = rotational_stiffness(E=TITANIUM, p=2e-3, **BLADE)
    assert found == pytest.approx(15.51, abs=0.005)
    assert 4 * found / 20e-3**2 == pytest.approx(1.55e5, abs=0.005e5)  # k_eq


def test_stress_of_the_rocket_pivot_leaves_the_printed_safety_factor():
    # exercise 9 part II, question 1: "the stroke: ~2.5" with σ_D = 500 MPa
    inner, _ = end_stresses(E=TITANIUM, h=637e-6, l=17.5e-3, p=2e-3, theta=410e-6 / 20e-3)
    assert 500e6 / inner == pytest.approx(2.5, abs=0.05)


def test_mercury_pivot_has_the_printed_stiffnesses():
    # exercise 12 B: K_z = 4.59 N/µm, K_θ = 0.68 N·m/rad, both from the printed b = 30 mm and
    # h = 250 µm, so within their last digit: 3·(0.5/30) + 0.5/250 of K_z at the most
    size = {"E": 116e9, "h": 250e-6, "l": 80e-3, "b": 30e-3}
    assert out_of_plane_stiffness(blades=3, **size) == pytest.approx(4.59e6, rel=0.05)
    assert rotational_stiffness(p=0.0, blades=3, **size) == pytest.approx(0.68, abs=0.005)


@pytest.mark.parametrize(("angle", "printed"), [(1.95, 1206e-6), (16.95, 139e-6), (15.0, 157e-6)])
def test_crossed_pivots_of_exercise_12_c_reach_their_stress(angle, printed):
    # h = 2σL/(Eθ) of the symmetric pivot, σ = 100 MPa, L = 15 mm, E = 73 GPa; both the angle
    # (in hundredths of a degree) and h (in µm) are printed rounded
    inner, outer = end_stresses(E=73e9, h=printed, l=15e-3, p=-7.5e-3, theta=radians(angle))
    rounded = 0.005 / angle + 0.5e-6 / printed
    assert inner == pytest.approx(100e6, rel=rounded)
    assert outer == pytest.approx(-100e6, rel=rounded)


def test_wittricks_crossing_costs_the_printed_stroke():
    # lecture: at p = 0.127 L the stroke is about 1/3.2 of the symmetric pivot's. The stiffness
    # it prints beside it, 3.3 times, does not follow from its own formula, which gives 2.67.
    size = {"E": 1.0, "h": 0.01, "l": 1.0}
    crossing, symmetric = (
        max(map(abs, end_stresses(p=p, theta=1.0, **size))) for p in (-0.127, -0.5)
    )
    assert crossing / symmetric == pytest.approx(3.2, abs=0.05)
    stiff, soft = (rotational_stiffness(p=p, b=0.1, **size) for p in (-0.127, -0.5))
    assert stiff / soft == pytest.approx(4 * (1 - 3 * 0.127 + 3 * 0.127**2), rel=ROUNDING)


# -- limits and symmetry -----------------------------------------------------------------------


def test_the_symmetric_pivot_is_the_least_stiff():
    size = {"E": 1.0, "h": 1.0, "l": 1.0, "b": 1.0}
    least = rotational_stiffness(p=-0.5, **size)
    assert least == pytest.approx(2 * second_moment(1.0, 1.0), rel=ROUNDING)  # n EI/l
    p = np.linspace(-3, 2, 1001)
    assert rotational_stiffness(p=p, **size).min() == pytest.approx(least, rel=ROUNDING)


@given(delta=deltas)
def test_mirroring_the_crossing_keeps_stiffness_shift_and_swaps_the_ends(delta):
    other = -1.0 - delta
    size = {"E": 1.0, "h": 1.0, "l": 1.0, "b": 1.0}
    cancels = 1.0 + 3.0 * abs(delta) + 3.0 * delta**2  # the terms that add up to the stiffness
    mine, mirrored = (rotational_stiffness(p=p, **size) for p in (delta, other))
    assert mine == pytest.approx(mirrored, rel=ROUNDING, abs=ROUNDING * cancels)
    bend = {"E": 1.0, "h": 1.0, "l": 1.0, "theta": 1.0}
    inner, outer = end_stresses(p=delta, **bend)
    far_inner, far_outer = end_stresses(p=other, **bend)
    assert (inner, outer) == pytest.approx((-far_outer, -far_inner), abs=ROUNDING * cancels)
    shifts = [parasitic_shift(l=1.0, p=p, theta=1.0, half_angle=0.5) for p in (delta, other)]
    assert shifts[0] == pytest.approx(shifts[1], abs=ROUNDING * cancels)


@given(delta=deltas)
def test_the_inner_end_decides_above_minus_one_half_and_the_outer_end_below(delta):
    inner, outer = end_stresses(E=1.0, h=1.0, l=1.0, p=delta, theta=1.0)
    if delta > -0.5 + 1e-9:
        assert abs(inner) > abs(outer)
    elif delta < -0.5 - 1e-9:
        assert abs(inner) < abs(outer)


@pytest.mark.parametrize("delta", [-0.7, -0.9, -1.5])
def test_the_one_ended_formula_turns_negative_below_minus_two_thirds(delta):
    inner, outer = end_stresses(E=1.0, h=1.0, l=1.0, p=delta, theta=1.0)
    assert inner < 0.0  # the lecture's admissible stroke would be negative
    assert abs(outer) > abs(inner)


def test_wittricks_crossings_are_the_zeros_of_the_shift():
    zeros = sorted(np.roots([9, 9, 1]))
    assert zeros == pytest.approx([-0.873, -0.127], abs=5e-4)  # lecture
    for delta in zeros:
        assert parasitic_shift(l=1.0, p=delta, theta=0.3, half_angle=0.7) == pytest.approx(
            0.0, abs=ROUNDING
        )
    inside = parasitic_shift(l=1.0, p=-0.5, theta=0.3, half_angle=0.7)
    outside = parasitic_shift(l=1.0, p=0.0, theta=0.3, half_angle=0.7)
    assert inside < 0.0 < outside


def test_three_blades_without_offset_are_half_again_as_stiff_as_two():
    size = {"E": 1.0, "h": 0.1, "l": 1.0, "b": 1.0, "p": 0.0}
    assert rotational_stiffness(blades=3, **size) == pytest.approx(
        1.5 * rotational_stiffness(**size), rel=ROUNDING
    )
    # exercise 12 B, equation (5)
    assert rotational_stiffness(blades=3, **size) == pytest.approx(0.1**3, rel=ROUNDING)


# -- independent route: beams assembled --------------------------------------------------------


def beam_stiffness(E, I, A, l):
    """Euler-Bernoulli beam between two nodes (u, v, φ each), along x."""
    a, c = E * A / l, E * I / l**3
    return np.array(
        [
            [a, 0, 0, -a, 0, 0],
            [0, 12 * c, 6 * c * l, 0, -12 * c, 6 * c * l],
            [0, 6 * c * l, 4 * c * l**2, 0, -6 * c * l, 2 * c * l**2],
            [-a, 0, 0, a, 0, 0],
            [0, -12 * c, -6 * c * l, 0, 12 * c, -6 * c * l],
            [0, 6 * c * l, 2 * c * l**2, 0, -6 * c * l, 4 * c * l**2],
        ]
    )


def assembled(E, h, l, b, p, angles):
    """Stiffness (3×3) of a body on blades about the centre, and each blade's map to its ends."""
    I, A = b * h**3 / 12, b * h
    total, blades = np.zeros((3, 3)), []
    for angle in angles:
        c, s = np.cos(angle), np.sin(angle)
        turn = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        # The body carries the inner end at distance p from the centre along the blade; the outer
        # end, at p + l, is clamped. A rotation φ about the centre moves the inner end by φ p.
        inner = np.array([[1, 0, 0], [0, 1, p], [0, 0, 1]]) @ turn
        ends = np.vstack([inner, np.zeros((3, 3))])
        K = beam_stiffness(E, I, A, l)
        blades.append(K @ ends)
        total += ends.T @ K @ ends
    return total, blades


@pytest.mark.parametrize("delta", [-1.4, -0.873, -2 / 3, -0.5, -1 / 3, -0.127, 0.0, 0.114, 3.0])
@pytest.mark.parametrize("angles", [(0.6, -0.6), (0.0, 2 * pi / 3, 4 * pi / 3)])
def test_beams_assembled_over_the_body_give_stiffness_and_end_stresses(delta, angles):
    E, h, l, b, theta = TITANIUM, 3e-4, 0.02, 5e-3, 0.03
    K, blades = assembled(E, h, l, b, delta * l, angles)
    # The centre is free to move; with equal blades it does not, to first order.
    condensed = K[2, 2] - K[2, :2] @ np.linalg.solve(K[:2, :2], K[:2, 2])
    moved = np.linalg.solve(K[:2, :2], -K[:2, 2])
    # Assembling adds the axial terms, some (l/h)² times larger.
    noise = 1e-9
    if len(angles) == 3:
        np.testing.assert_allclose(moved, 0.0, atol=noise * l)
    fixed = K[2, 2]
    found = rotational_stiffness(E=E, h=h, l=l, b=b, p=delta * l, blades=len(angles))
    assert found == pytest.approx(fixed, rel=noise)
    # Letting the centre move costs the order (h/l)² that slender blades leave out.
    assert condensed == pytest.approx(found, rel=20 * (h / l) ** 2 * (1 + 2 * abs(delta)) ** 2)
    inner, outer = end_stresses(E=E, h=h, l=l, p=delta * l, theta=theta)
    modulus, scale = b * h**2 / 6, abs(inner) + abs(outer)
    for forces in blades:
        end = forces @ np.array([0.0, 0.0, theta]) / modulus
        assert (end[2], end[5]) == pytest.approx((inner, outer), abs=noise * scale)


@given(alpha=st.floats(1e-5, 1.57), direction=st.floats(-pi, pi))
def test_axial_forces_of_two_blades_are_in_equilibrium(alpha, direction):
    angles = (alpha, -alpha)
    shares = axial_share(angles, direction)
    scale = max(map(abs, shares))
    sums = (sum(n * f(a) for n, a in zip(shares, angles, strict=True)) for f in (np.cos, np.sin))
    assert tuple(sums) == pytest.approx((cos(direction), np.sin(direction)), abs=1e-9 * scale)


def test_the_rocket_pivot_spreads_its_force_by_root_two():
    # exercise 9 part II, equations (2) and (3)
    assert axial_share((pi / 4, -pi / 4), 0.0) == pytest.approx([1 / sqrt(2)] * 2, rel=ROUNDING)


@given(direction=st.floats(-pi, pi))
def test_three_blades_share_a_force_alike_in_every_direction(direction):
    angles = (0.0, 2 * pi / 3, 4 * pi / 3)
    shares = axial_share(angles, direction)
    expected = [2 / 3 * cos(direction - a) for a in angles]
    assert shares == pytest.approx(expected, abs=ROUNDING)


def test_parallel_blades_refuse_a_force_across_them():
    with pytest.raises(ValueError, match="parallel"):
        axial_share((0.0, 0.0), 0.5)


# -- arrays and units --------------------------------------------------------------------------


@given(st.lists(st.tuples(sizes, sizes, sizes, st.floats(-2, 2)), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    h, l, b, p = np.array(rows).T
    whole = rotational_stiffness(E=1.0, h=h, l=l, b=b, p=p)
    stresses = end_stresses(E=1.0, h=h, l=l, p=p, theta=0.1)
    shift = parasitic_shift(l=l, p=p, theta=0.1, half_angle=0.5)
    for k, (h_k, l_k, b_k, p_k) in enumerate(rows):
        one = rotational_stiffness(E=1.0, h=h_k, l=l_k, b=b_k, p=p_k)
        # the vector power may round apart from the scalar one; 1 + 3δ + 3δ² ≥ ¼ of its terms
        terms = one * (1 + 3 * abs(p_k / l_k) + 3 * (p_k / l_k) ** 2) * 4
        assert whole[k] == pytest.approx(one, rel=ROUNDING, abs=abs(terms) * ROUNDING)
        single = end_stresses(E=1.0, h=h_k, l=l_k, p=p_k, theta=0.1)
        assert (stresses[0][k], stresses[1][k]) == pytest.approx(single, rel=ROUNDING)
        alone = parasitic_shift(l=l_k, p=p_k, theta=0.1, half_angle=0.5)
        size = l_k * (1 + 9 * abs(p_k / l_k) + 9 * (p_k / l_k) ** 2)
        assert shift[k] == pytest.approx(alone, rel=ROUNDING, abs=size * ROUNDING)


@given(h=sizes, l=sizes, b=sizes, delta=deltas, scale=st.sampled_from([1e-6, 1e-3, 1e3]))
def test_stiffness_and_stress_scale_with_the_unit_of_length(h, l, b, delta, scale):
    in_metres = rotational_stiffness(E=1.0, h=h, l=l, b=b, p=delta * l)
    scaled = rotational_stiffness(E=1.0, h=h * scale, l=l * scale, b=b * scale, p=delta * l * scale)
    cancels = 4 * (1 + 3 * abs(delta) + 3 * delta**2)
    assert scaled == pytest.approx(in_metres * scale**3, rel=ROUNDING * cancels)
    stress = end_stresses(E=1.0, h=h, l=l, p=delta * l, theta=0.1)
    same = end_stresses(E=1.0, h=h * scale, l=l * scale, p=delta * l * scale, theta=0.1)
    assert same == pytest.approx(stress, abs=ROUNDING * h / l * cancels)
