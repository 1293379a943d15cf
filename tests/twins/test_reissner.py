"""The twins' beams against published numbers, limits, and other routes to the same numbers."""

from math import cos, pi, radians, sqrt

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipeinc, ellipkinc

from twins.designs import KINDS, drawn_twin
from twins.joints import BODY, TURN, Loads, Twin, joint_of
from twins.reissner import GROUND, Beam, Frame, Mass, Push

SLENDER = 1e-3
"""h/l at which stretching and shear, of second order in it, do less than the printed digits."""

CRITICAL = 2e-4
"""Relative: twice what halving leaves of a critical load."""


def strip(h=SLENDER, l=1.0, E=1.0, nu=0.3, density=0.0, **where):
    beam = Beam(GROUND, BODY, (0.0, 0.0), (l, 0.0), h, 1.0)
    return Frame(((BODY, Mass((l, 0.0), **where)),), (beam,), E, E / 2.0 / (1.0 + nu), density)


def rigidity(h=SLENDER):
    return h**3 / 12.0


# Mattiasson 1981, Int. J. Numer. Methods Eng. 17, table I: P l²/EI, w/l, u/l, θ
@pytest.mark.parametrize(
    ("load", "across", "along", "turn"),
    [
        (0.2, 0.06636, 0.00265, 0.09964),
        (1.0, 0.30172, 0.05643, 0.46135),
        (2.0, 0.49346, 0.16064, 0.78175),
        (5.0, 0.71379, 0.38763, 1.21537),
        (10.0, 0.81061, 0.55500, 1.43029),
    ],
)
def test_a_cantilever_under_an_end_force_bends_as_mattiasson_printed(load, across, along, turn):
    frame = strip()
    state = frame.solve({}, [Push(BODY, (1.0, 0.0), (0.0, load * rigidity()))])
    moved = frame.motion(state, BODY, (1.0, 0.0))
    found = (moved[1], -moved[0], state.bodies[0, 2])
    assert found == pytest.approx((across, along, turn), abs=1e-5)  # five printed decimals


def test_a_buckled_cantilever_follows_the_elastica():
    # P/P_E = (2K(k)/π)², k = sin(θ/2); tip at 2E(k)/K(k) − 1 (Timoshenko & Gere, 2.7)
    for turn in (0.5, 1.5, 2.5):
        k = np.sin(turn / 2.0)
        K, E = ellipkinc(pi / 2.0, k**2), ellipeinc(pi / 2.0, k**2)
        frame = strip()
        P = K**2 * rigidity()
        bent = frame.solve({(BODY, TURN): turn})
        share = [Push(BODY, (1.0, 0.0), (-P, 0.0))]
        state = frame.solve({(BODY, TURN): turn}, share, start=bent, from_held={(BODY, TURN): turn})
        tip = 1.0 + frame.motion(state, BODY, (1.0, 0.0))[0]
        assert state.reactions[TURN] == pytest.approx(0.0, abs=2e-4)
        assert tip == pytest.approx(2.0 * E / K - 1.0, abs=1e-4)


def test_a_moment_rolls_a_blade_into_an_arc():
    frame = strip()
    state = frame.solve({}, [Push(BODY, (1.0, 0.0), (0.0, 0.0), pi * rigidity())])
    moved = frame.motion(state, BODY, (1.0, 0.0))
    assert state.bodies[0, 2] == pytest.approx(pi, rel=1e-9)
    assert moved == pytest.approx((-1.0, 2.0 / pi), abs=1e-8)


@pytest.mark.parametrize(
    ("held", "factor"),
    [
        ((), 0.25),
        ((TURN,), 1.0),
        ((1,), (brentq(lambda x: np.tan(x) - x, 4.4, 4.6) / pi) ** 2),
        ((1, TURN), 4.0),
    ],
)
def test_a_pushed_blade_buckles_at_eulers_loads(held, factor):
    frame = strip()
    found = frame.critical(
        [Push(BODY, (1.0, 0.0), (-1.0, 0.0))],
        {(BODY, axis): 0.0 for axis in held},
        most=6.0 * pi**2 * rigidity(),
    )
    assert found == pytest.approx(factor * pi**2 * rigidity(), rel=CRITICAL)


@pytest.mark.parametrize("h", [0.01, 0.1, 0.3])
def test_a_guided_blade_is_as_stiff_as_timoshenko_says(h):
    twin = Twin(joint_of("guided-blade", h=h, l=1.0, b=0.5), 1.0, 0.3)
    phi = 12.0 / 12.0 * h**2 * 2.6 / (5.0 / 6.0)
    assert twin.stiffness() == pytest.approx(0.5 * h**3 / (1.0 + phi), rel=1e-9)


@pytest.mark.parametrize("delta", [-0.5, -0.1, 0.0, 0.3, 1.0])
def test_a_pivot_is_as_stiff_as_its_blades_at_their_offset(delta):
    # n 4EI/l (1 + 3δ + 3δ²), inextensible (Henein): stretching adds of the order (h/l)²
    g = {"h": 1e-4, "l": 1.0, "b": 1.0, "half_angle": 0.8, "delta": delta}
    twin = Twin(joint_of("cross-spring", **g), 1.0, 0.3)
    slender = 8.0 * (1e-12 / 12.0) * (1.0 + 3.0 * delta + 3.0 * delta**2)
    assert twin.stiffness() == pytest.approx(slender, rel=1e-6)


@pytest.mark.parametrize(("delta", "alpha"), [(-0.5, 45.0), (0.0, 30.0), (0.4, 60.0)])
def test_a_pivot_shifts_by_wittricks_leading_term(delta, alpha):
    # l θ² |9δ² + 9δ + 1|/(15 cos α); the next order is θ⁴ along and θ³ across
    g = {"h": 1e-4, "l": 1.0, "b": 1.0, "half_angle": radians(alpha), "delta": delta}
    found = Twin(joint_of("cross-spring", **g), 1.0, 0.3).shift(0.01)
    bracket = abs(9.0 * delta**2 + 9.0 * delta + 1.0)
    assert found == pytest.approx(1e-4 * bracket / 15.0 / cos(radians(alpha)), rel=5e-3)


def test_a_guide_shortens_by_three_fifths_of_its_stroke_squared():
    found = Twin(joint_of("guided-blade", h=1e-4, l=1.0, b=1.0), 1.0, 0.3).shift(0.01)
    assert found == pytest.approx(0.6e-4, rel=1e-3)  # the next order is x²/l²


def test_a_free_blade_swings_at_the_printed_eigenvalues():
    # 1.87510407, 4.69409113, 7.85475744 (Blevins, table 8-1): β⁴ EI/ρA
    frame = strip(density=1.0)
    beta = np.array([1.87510407, 4.69409113, 7.85475744])
    found = 2.0 * pi * frame.frequencies(3) / sqrt(SLENDER**2 / 12.0)
    # shear and rotary inertia take some (βh/l)² off
    assert found == pytest.approx(beta**2, rel=1e-4)


def test_a_light_tip_swings_with_a_third_of_the_blade():
    # Rayleigh: 33/140 of the blade's mass, exact to the first order of it
    E, h, l, b, rho, m = 114e9, 0.5e-3, 0.03, 0.01, 4430.0, 0.3
    twin = Twin(joint_of("cantilever", h=h, l=l, b=b), E, 0.3, rho)
    mass = m + 33.0 / 140.0 * rho * b * h * l
    simple = sqrt(twin.stiffness() / mass) / 2.0 / pi
    assert twin.frequency(m, 0.0) == pytest.approx(simple, rel=1e-5)


def test_a_hinge_of_a_straight_profile_is_a_blade():
    g = {"h": 1e-3, "l": 0.02, "b": 5e-3}
    blade = Twin(joint_of("moment-blade", **g), 114e9, 0.3)
    hinge = Twin(joint_of("filleted-hinge", r=1e-5, **g), 114e9, 0.3)
    # its fillets stiffen two thousandths of its length
    assert hinge.stiffness() == pytest.approx(blade.stiffness(), rel=1e-3)


def test_a_circular_notch_is_as_stiff_as_the_integral_of_its_thickness():
    e, r, b, E = 0.05e-3, 1e-3, 5e-3, 114e9
    x, w = np.polynomial.legendre.leggauss(400)
    t = np.sqrt(e * r) * np.tan(x * np.arctan(sqrt(r / e)))  # nodes crowd the throat
    dt = np.sqrt(e * r) * np.arctan(sqrt(r / e)) / np.cos(x * np.arctan(sqrt(r / e))) ** 2
    h = e + 2.0 * (r - np.sqrt(np.maximum(r**2 - t**2, 0.0)))
    expected = 1.0 / float(np.sum(w * dt * 12.0 / (E * b * h**3)))
    found = Twin(joint_of("notch-hinge", e=e, r=r, b=b), E, 0.3).stiffness()
    assert found == pytest.approx(expected, rel=1e-5)


def test_a_symmetric_pivot_pulled_and_held_across_turns_at_its_slender_limit():
    # −8.1415 = v of P l²/EI: det of the beam-columns' matrix about the crossing, worked out in
    # 50 digits for the specs that were judged wrongly
    h = 1e-3
    g = {"h": h, "l": 1.0, "b": 1.0, "half_angle": pi / 4.0, "delta": -0.5}
    found = Twin(joint_of("cross-spring", **g), 1.0, 0.3).critical(1.0, 0.0, "clamped-pinned")
    assert found / rigidity(h) == pytest.approx(8.1415, rel=CRITICAL)


def test_stress_of_a_guide_is_the_printed_formula_for_small_strokes():
    g = {"h": 1e-3, "l": 0.1, "b": 0.01, "spacing": 0.1}
    rows = Twin(joint_of("leaf-spring-stage", **g), 114e9, 0.0).face_stresses((1e-6, -1e-6))
    # 3 E h x/l², sheared by Φ = 12 (h/l)²·… of 1e-4
    assert np.abs(rows[0]).max() == pytest.approx(3.0 * 114e9 * 1e-3 * 1e-6 / 1e-2, rel=1e-3)


@pytest.mark.parametrize("kind", KINDS)
def test_more_nodes_change_no_true_number(kind):
    twins = [drawn_twin(3, kind, degree) for degree in (8, 11)]
    assert twins[0].stiffness() == pytest.approx(twins[1].stiffness(), rel=1e-5)
    travel = 0.05 if twins[0].joint.axis == TURN else 0.05 * twins[0].joint.beams[0].length
    rows = [twin.face_stresses((travel,), Loads()) for twin in twins]
    # the greatest stress of a notch lies between the places that are looked at
    assert np.abs(rows[0]).max() == pytest.approx(np.abs(rows[1]).max(), rel=1e-4)
