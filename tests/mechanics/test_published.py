"""The exact solver against published tables, series and shooting for the pivots of the field."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanisms_for_tests import E, cantilever, parallelogram, pivot
from paths import trace
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Load
from flexcli.mechanics.mesh import Effects

SLENDER = Effects(extension=False, shear=False)
l, h, b = 20e-3, 1e-4, 10e-3
EI = E * b * h**3 / 12.0

TIMOSHENKO = {
    20: (1.015, 0.970, 0.220),
    40: (1.063, 0.881, 0.422),
    60: (1.152, 0.741, 0.593),
    80: (1.293, 0.560, 0.719),
    100: (1.518, 0.349, 0.792),
    120: (1.884, 0.123, 0.803),
}
"""Buckled column by rotation of its free end [°]: P/P_cr, height and sway over the length.

Timoshenko & Gere (1961), Theory of Elastic Stability, table 2-4.
"""


ELASTICA = {
    (-10.0, 10.0, -2.0): (-0.20497830, 0.54561880, 0.02256414),
    (-5.0, 5.0, 0.0): (-0.04156213, 0.25921487, 0.00195483),
    (0.0, 20.0, 0.0): (-0.22850172, 0.57571581, 0.03564157),
    (2.0, 8.0, 3.0): (-0.05000763, 0.28456122, 0.00462420),
    (10.0, 4.0, -3.0): (-0.00722305, 0.11009499, -0.00012571),
}
"""Parallelogram, blades 0.6 l apart: u_x/l, u_y/l and φ by forces [EI/l²] and moment [EI/l].

Su & Servey (2026), github.com/haijunsu-osu/parallelogram_model_comparison, Euler BVP.
"""


def test_a_parallelogram_follows_the_published_elastica():
    loads = np.array(list(ELASTICA))
    F = loads * [EI / l**2, EI / l**2, EI / l]
    load = Load("table", (l, 0.0), (F[:, 0], F[:, 1]), F[:, 2])
    state = solve(parallelogram(h=h, l=l, b=b, apart=0.6 * l), loads=[load], effects=SLENDER)
    assert state.converged.all()
    found = state.motions[:, 0] / [l, l, 1.0]
    # their boundary values are met to some 1e-5
    assert found == pytest.approx(np.array(list(ELASTICA.values())), abs=3e-5)


def column_at(degrees):
    """P/P_cr, height and sway of a buckled column by elliptic integrals."""
    m = np.sin(np.radians(degrees) / 2.0) ** 2
    K = ellipk(m)
    return (2.0 * K / np.pi) ** 2, 2.0 * ellipe(m) / K - 1.0, 2.0 * np.sqrt(m) / K


@pytest.mark.parametrize("degrees", TIMOSHENKO)
def test_a_column_past_its_euler_load_has_the_printed_digits(degrees):
    # the print rounds some of its last digits and cuts others
    assert column_at(degrees) == pytest.approx(TIMOSHENKO[degrees], abs=1e-3)
    load, height, sway = column_at(degrees)
    axial = load * np.pi**2 / 4.0 * EI / l**2
    state = solve(
        cantilever(),
        {"tip": (None, None, np.radians(degrees))},
        loads=[Load("tip", (l, 0.0), (-axial, 0.0))],
        effects=SLENDER,
    ).checked()
    x, y, _ = state.motions[0, 0]
    assert (1.0 + x / l, y / l) == pytest.approx((height, sway), rel=1e-8)
    # nothing but the load needs to hold it there
    assert state.reactions[0, 0, 2] == pytest.approx(0.0, abs=1e-8 * EI / l)
    assert state.unstable[0] == 0


def test_a_column_that_leans_a_little_follows_its_bent_branch():
    """1e-3 of the load across: near the branch that starts at the Euler load, stable all along."""
    most = 2.0 * np.pi**2 / 4.0
    across = Load("tip", (l, 0.0), (-most * EI / l**2, 1e-3 * most * EI / l**2))
    path = trace(
        cantilever(),
        {},
        loads=[across],
        effects=SLENDER,
        until=lambda state: state.motions[0, 0, 2] > np.radians(120.0),
    )
    assert path.turns == ()
    bent = [s for s in path.states if s.motions[0, 0, 2] > np.radians(20.0)]
    assert len(bent) > 5
    for state in bent:
        x, y, phi = state.motions[0, 0]
        found = (2.0 * float(state.reached[0]), 1.0 + x / l, y / l)
        assert found == pytest.approx(column_at(np.degrees(phi)), abs=5e-3)
    assert all(state.unstable[0] == 0 for state in path.states)


def guided_shortening(force):
    """Stroke and shortening over length of a guided blade: two cantilevers of half the length.

    Elliptic integrals of the end-loaded cantilever by its rotation; ``force`` is F l²/EI.
    """
    load = force / 4.0

    def k_of(theta):
        return np.sqrt((1.0 + np.sin(theta)) / 2.0)

    def excess(theta):
        k = k_of(theta)
        start = np.arcsin(1.0 / (np.sqrt(2.0) * k))
        return ellipk(k**2) - ellipkinc(start, k**2) - np.sqrt(load)

    theta = brentq(excess, 1e-6, np.pi / 2 - 1e-9, xtol=1e-15, rtol=1e-14)
    k = k_of(theta)
    start = np.arcsin(1.0 / (np.sqrt(2.0) * k))
    rise = 1.0 - 2.0 / np.sqrt(load) * (ellipe(k**2) - ellipeinc(start, k**2))
    return rise, 1.0 - np.sqrt(2.0 * np.sin(theta) / load)


@pytest.mark.parametrize("force", [1.0, 4.0, 12.0])
def test_a_guided_blade_shortens_as_elliptic_integrals_say(force):
    stroke, shortening = guided_shortening(force)
    state = solve(cantilever(), {"tip": (None, stroke * l, 0.0)}, effects=SLENDER).checked()
    assert state.motions[0, 0, 0] == pytest.approx(-shortening * l, rel=1e-8)
    assert state.reactions[0, 0, 1] == pytest.approx(force * EI / l**2, rel=1e-8)


def test_shortening_of_a_parallelogram_has_the_next_term():
    """``3x²/(5l) + 36x⁴/(175l³) + …``, by the series of the elastica in the load."""
    ratio = np.array([0.02, 0.05, 0.1])
    held = {"table": (None, ratio * l, 0.0)}
    state = solve(parallelogram(h=1e-6), held, effects=Effects(True, False)).checked()
    left = -state.motions[:, 0, 0] / l - 0.6 * ratio**2
    # the term after it is 0.13 times the square of the stroke
    assert left / ratio**4 == pytest.approx(36.0 / 175.0 + 0.133 * ratio**2, rel=1e-3)


def by_shooting(delta, theta, alpha=np.pi / 4):
    """Moment [EI/l] and motion of the centre [l] of a pivot with two inextensible blades.

    The problem of Haringx (1949) and Wittrick (1951) without series: each blade is an elastica from
    its clamp, both ends lie on the turned body, six unknowns.
    """
    directions = np.array([np.pi + alpha, np.pi - alpha])
    rays = np.stack([np.cos(directions), np.sin(directions)], axis=-1)
    starts, arms = -(delta + 1.0) * rays, -delta * rays
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])

    def end(i, F, m):
        def rate(_, y):
            c, s = np.cos(y[2]), np.sin(y[2])
            return [c, s, y[3], F[0] * s - F[1] * c]

        initial = [*starts[i], directions[i], m]
        return solve_ivp(rate, (0.0, 1.0), initial, rtol=1e-11, atol=1e-12).y[:, -1]

    def misfit(unknown):
        F, u, found = unknown[:2], unknown[4:], []
        for i, sign in enumerate((1.0, -1.0)):
            x, y, turn, _ = end(i, sign * F, unknown[2 + i])
            found += [*(np.array([x, y]) - u - R @ arms[i]), turn - directions[i] - theta]
        return found

    # curvature at the clamp of a blade whose end turns and moves by −δθ, small rotation
    m = -(2.0 + 6.0 * delta) * theta
    forces = [0.0, (12.0 * delta + 6.0) * theta * np.sqrt(0.5)]
    solution, _, ended, why = fsolve(
        misfit, [*forces, m, m, 0.0, 0.0], xtol=1e-12, full_output=True
    )
    assert ended == 1, why
    moment = 0.0
    for i, sign in enumerate((1.0, -1.0)):
        F, lever = sign * solution[:2], R @ arms[i]
        moment += end(i, F, solution[2 + i])[3] + lever[0] * F[1] - lever[1] * F[0]
    return moment, solution[4:]


@pytest.mark.slow
@pytest.mark.parametrize("degrees", [10.0, 20.0])
@pytest.mark.parametrize("delta", [-0.5, -0.127, 0.0, 0.5])
def test_a_generalised_pivot_follows_shooting(delta, degrees):
    theta = np.radians(degrees)
    moment, centre = by_shooting(delta, theta)
    held = {"out": (None, None, theta)}
    state = solve(pivot(delta=delta), held, effects=SLENDER).checked()
    assert state.reactions[0, 0, 2] * l / EI == pytest.approx(moment, rel=1e-7)
    assert state.motions[0, 0, :2] / l == pytest.approx(centre, abs=1e-8)


forces = st.tuples(*[st.floats(-1.0, 1.0)] * 3)


@settings(max_examples=15)
@given(first=forces, second=forces)
def test_small_loads_add_up(first, second):
    """Loads of 1e-6: motions differ from their sum by the square."""
    unit = 1e-6 * np.array([EI / l**2, EI / l**2, EI / l])

    def motions(parts):
        F = parts * unit
        load = Load("out", (1e-3, 2e-3), (F[0], F[1]), F[2])
        return solve(pivot(h=2e-3), loads=[load]).checked().motions[0, 0] / [l, l, 1.0]

    one, other = np.array(first), np.array(second)
    assert motions(one) + motions(other) == pytest.approx(motions(one + other), abs=1e-10)


@settings(max_examples=15)
@given(first=forces, second=forces, theta=st.floats(-0.4, 0.4))
def test_work_of_one_load_on_the_motion_by_another_is_mutual(first, second, theta):
    """Maxwell and Betti about a turned pose: small loads on top of what holds it there."""
    rest = solve(pivot(h=2e-3), {"out": (None, None, theta)}).checked()
    hold = rest.reactions[0, 0, 2]
    unit = 1e-6 * np.array([EI / l**2, EI / l**2, EI / l]) * 8e3

    def motions(parts):
        F = parts * unit
        loads = [Load("out", (0.0, 0.0), (F[0], F[1]), F[2] + hold)]
        found = solve(pivot(h=2e-3), loads=loads, start=rest, tolerance=1e-12)
        return (found.checked().motions - rest.motions)[0, 0]

    one, other = np.array(first), np.array(second)
    scale = unit[2] * 1e-6
    assert motions(one) @ (other * unit) == pytest.approx(
        motions(other) @ (one * unit), abs=1e-4 * scale
    )
