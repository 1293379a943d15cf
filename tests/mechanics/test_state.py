"""What is read off an equilibrium: stiffness, modes, stresses, path, linear limit."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanisms_for_tests import E, cantilever, pivot
from planar_joint import joint_stiffness

from flexcli.formulas.pivot import end_stresses
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.mechanics.equilibrium import LEVELS, solve
from flexcli.mechanics.layout import Body, Load, Support
from flexcli.mechanics.linear import linear
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.stresses import blade_stress, greatest_stress
from flexcli.mechanics.tangent import body_stiffness, free_compliance, held_stiffness

SLENDER = Effects(extension=False, shear=False)
l, h, b = 20e-3, 1e-4, 10e-3
EI = E * b * h**3 / 12.0

states = {
    "bent": {"held": {"out": (None, None, 0.3)}},
    "loaded": {"loads": [Load("out", (1e-3, 2e-3), (2 * EI / l**2, EI / l**2), 0.5 * EI / l)]},
    "held across": {"held": {"out": (None, 5e-7, None)}},
}


@pytest.mark.slow
@pytest.mark.parametrize("demand", states.values(), ids=states)
def test_stiffness_is_the_slope_of_the_reactions(demand):
    """Central differences of full solutions with all of the body's coordinates held."""
    layout = pivot()
    state = solve(layout, **demand).checked()
    K = body_stiffness(state, "out")[0]
    pose, size = state.motions[0, 0], np.array([1e-8, 1e-8, 1e-6])
    loads = demand.get("loads", ())
    columns = []
    for i in range(3):
        ends = [
            solve(layout, {"out": tuple(pose + side * size * (np.arange(3) == i))}, loads=loads)
            for side in (1.0, -1.0)
        ]
        columns.append((ends[0].reactions[0, 0] - ends[1].reactions[0, 0]) / (2.0 * size[i]))
    unit = np.array([1.0, 1.0, l])
    scaled = K * np.outer(unit, unit)
    assert np.array(columns).T * np.outer(unit, unit) == pytest.approx(
        scaled, abs=1e-5 * np.max(np.abs(scaled))
    )
    assert scaled == pytest.approx(scaled.T, abs=1e-12 * np.max(np.abs(scaled)))


def test_compliance_of_free_coordinates_is_the_inverse_of_the_stiffness():
    state = solve(pivot(), loads=states["loaded"]["loads"]).checked()
    product = free_compliance(state)[0] @ body_stiffness(state, "out")[0]
    assert product == pytest.approx(np.eye(3), abs=1e-6)


def test_stiffness_at_rest_is_that_of_the_linear_joint():
    K = joint_stiffness(E=E, h=h, l=l, b=b, p=0.2 * l, angles=(np.pi / 4, -np.pi / 4))
    state = solve(pivot(), effects=Effects(extension=True, shear=False)).checked()
    assert body_stiffness(state, "out")[0] == pytest.approx(K, rel=1e-9, abs=1e-9 * K[0, 0] * l)


def test_the_moment_over_the_stroke_is_the_integral_of_its_stiffness():
    nodes, weights = np.polynomial.legendre.leggauss(12)
    theta = 0.25 * (nodes + 1.0)
    stiffness = held_stiffness(solve(pivot(), {"out": (None, None, theta)}).checked())[:, 0, 0]
    moment = solve(pivot(), {"out": (None, None, 0.5)}).checked().reactions[0, 0, 2]
    assert 0.25 * weights @ stiffness == pytest.approx(moment, rel=1e-9)


def test_end_stress_of_a_pivot_tends_to_the_closed_form():
    theta, delta = 1e-4, 0.2
    state = solve(pivot(delta=delta), {"out": (None, None, theta)}, effects=SLENDER).checked()
    inner, outer = end_stresses(E=E, h=h, l=l, p=delta * l, theta=theta)
    peak = greatest_stress(state)
    assert peak.bending[0] == pytest.approx([inner, inner], rel=1e-3)
    assert peak.bending_at[0] == pytest.approx([l, l])
    along = blade_stress(state, "upper")
    assert np.abs(along.bending[0, [0, -1]]) == pytest.approx([outer, inner], rel=1e-3)


def test_the_maximum_inside_a_blade_is_found():
    """A clamped-pinned blade with end shortening has its largest moment between its ends."""
    layout = cantilever(profile=Tabulated((0.0, 0.5, 1.0), (2 * h, h, 2 * h)))
    state = solve(layout, {"tip": (None, 1e-3, 0.0)}).checked()
    peak = greatest_stress(state)
    dense = blade_stress(state, "blade", points=20001)
    total = np.maximum(np.abs(dense.left), np.abs(dense.right))[0]
    assert peak.total[0, 0] == pytest.approx(total.max(), rel=1e-7)
    assert peak.total[0, 0] >= total.max() * (1.0 - 1e-12)
    assert 0.0 < peak.total_at[0, 0] < l


PROFILES = {
    "constant": Constant(h),
    "necked": NeckedDown(h, 2e-3),
    "notch": Notch(h, 10e-3),
    "sharp notch": Notch(1e-6, 10e-3),
    "filleted": Filleted(h, 1e-3),
    "tabulated": Tabulated((0.0, 0.3, 1.0), (2 * h, h, 3 * h)),
}


@pytest.mark.parametrize("profile", PROFILES.values(), ids=PROFILES)
def test_small_moment_bends_any_profile_by_its_integral(profile):
    """φ = M ∫ ds/EI by a composite rule of many nodes."""
    x, w = np.polynomial.legendre.leggauss(200)
    flexibility = sum(
        float(np.sum(w * piece.slope(x) * 12.0 / (E * b * piece.thickness(x) ** 3)))
        for piece in profile.pieces(l)
    )
    moment = 1e-3 / flexibility
    state = solve(cantilever(profile=profile), loads=[Load("tip", (l, 0.0), moment=moment)])
    assert state.checked().motions[0, 0, 2] == pytest.approx(1e-3, rel=1e-9)
    assert max(state.nodes) <= LEVELS[-1]


def test_a_rigid_middle_is_rigid():
    """Two short hinges: a force across gives the bending of the hinges alone."""
    hinge = 1e-3
    F = 1e-4 * EI / l**2
    state = solve(
        cantilever(profile=NeckedDown(h, hinge)),
        loads=[Load("tip", (l, 0.0), (0.0, F))],
        effects=SLENDER,
    ).checked()
    far = l**3 - (l - hinge) ** 3 + hinge**3
    assert state.motions[0, 0, 1] == pytest.approx(F * far / 3.0 / EI, rel=1e-7)


def test_linear_is_the_limit_of_small_loads():
    loads = [Load("out", (1e-3, 0.0), (1e-6, 2e-6), 1e-9)]
    exact = solve(pivot(), loads=loads).checked()
    small = linear(pivot(), loads=loads)
    assert small.unique.all()
    assert small.motions == pytest.approx(exact.motions, rel=1e-4)
    assert small.end_forces == pytest.approx(exact.end_forces, rel=1e-4, abs=1e-12)


def test_gravity_and_springs_balance():
    """A mass on a spring beside a blade that is too soft to matter."""
    k = 1e4
    layout = cantilever(supports=(Support("tip", (l, 0.0), (k, k, 10.0)),))
    body = Body("tip", (l, 0.0), mass=0.1, com=(l, 0.0))
    layout = replace(layout, bodies=(body,), acceleration=(0.0, -9.81))
    state = solve(layout).checked()
    stiffness = body_stiffness(solve(cantilever()).checked(), "tip")[0, 1, 1] + k
    assert state.motions[0, 0, 1] == pytest.approx(-0.981 / stiffness, rel=1e-2)


def test_a_following_force_turns_with_its_body():
    """The tip force is perpendicular to the section: the moment is that of an independent sum."""
    F = 3.0 * EI / l**2
    load = Load("tip", (l, 0.0), (0.0, F), follows=True)
    state = solve(cantilever(), loads=[load], effects=SLENDER).checked()
    phi = state.motions[0, 0, 2]
    assert state.end_forces[0, 0, :2] == pytest.approx(
        [-F * np.sin(phi), F * np.cos(phi)], rel=1e-9
    )
    dead = solve(cantilever(), loads=[load._replace(follows=False)], effects=SLENDER).checked()
    assert phi > dead.motions[0, 0, 2]


def test_a_point_of_a_body_moves_with_its_rotation():
    state = solve(pivot(), {"out": (None, None, 0.4)}).checked()
    x, y, phi = state.motions[0, 0]
    arm = 5e-3
    expected = (x + arm * (np.cos(phi) - 1.0), y + arm * np.sin(phi))
    assert point_motion(state, "out", (arm, 0.0))[0] == pytest.approx(expected, rel=1e-12)


def test_a_closed_loop_of_motions_does_no_work():
    """Tip turned, pushed across, turned back, taken back; free along the blade."""
    corners = [(0.0, 0.0), (0.5, 0.0), (0.5, 5e-3), (0.0, 5e-3), (0.0, 0.0)]
    nodes, weights = np.polynomial.legendre.leggauss(8)
    work = 0.0
    for (t_0, y_0), (t_1, y_1) in pairwise(corners):

        def held(share, t=(t_0, t_1), y=(y_0, y_1)):
            return {"tip": (None, y[0] + share * (y[1] - y[0]), t[0] + share * (t[1] - t[0]))}

        states = (solve(cantilever(), held(share)) for share in (nodes + 1.0) / 2.0)
        force = np.array([s.checked().reactions[0, 0] for s in states])
        work += weights @ (force[:, 2] * (t_1 - t_0) + force[:, 1] * (y_1 - y_0)) / 2.0
    assert work == pytest.approx(0.0, abs=1e-9 * EI / l)


@settings(max_examples=10)
@given(
    force=st.tuples(st.floats(-2, 2), st.floats(-2, 2)),
    moment=st.floats(-0.5, 0.5),
    theta=st.floats(-0.5, 0.5),
)
def test_stiffness_under_dead_loads_is_symmetric(force, moment, theta):
    F = tuple(f * EI / l**2 for f in force)
    loads = [Load("out", (1e-3, 2e-3), F, moment * EI / l)]
    state = solve(pivot(), {"out": (None, None, theta)}, loads=loads).checked()
    unit = np.array([1.0, 1.0, 1.0 / l])
    K = body_stiffness(state, "out")[0] * np.outer(unit, unit)
    assert pytest.approx(K.T, abs=1e-11 * np.max(np.abs(K))) == K
