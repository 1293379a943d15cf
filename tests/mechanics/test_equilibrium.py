"""The exact solver against elliptic integrals, shooting, printed tables and its own invariants."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from mechanisms_for_tests import E, cantilever, parallelogram, pivot
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve
from scipy.special import ellipeinc, ellipkinc

from flexcli.errors import Outcome, SolveError
from flexcli.formulas.pivot import parasitic_shift, rotational_stiffness
from flexcli.formulas.profile import Constant
from flexcli.mechanics.assembly import assemble
from flexcli.mechanics.energy import strain_energy
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Body, Load, Support
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of
from flexcli.numerics.newton import newton

SLENDER = Effects(extension=False, shear=False)
PRECISION = 1e-9
"""The tolerance that solve() is asked for by default."""

MATTIASSON = {
    1.0: (0.05643, 0.30172, 0.46135),
    2.0: (0.16064, 0.49346, 0.78175),
    5.0: (0.38763, 0.71379, 1.21537),
    10.0: (0.55500, 0.81061, 1.43029),
}
"""Shortening u/L, deflection w/L and rotation of the tip against PL²/EI (Mattiasson 1981)."""


def rigidity(h=1e-4, b=10e-3):
    return E * b * h**3 / 12.0


def elastica(load):
    """Tip shortening, deflection, rotation of a cantilever under a transverse dead load."""

    def modulus(theta):
        return np.sqrt((1.0 + np.sin(theta)) / 2.0)

    def start(k):
        return np.arcsin(1.0 / (np.sqrt(2.0) * k))

    def excess(theta):
        k = modulus(theta)
        return ellipkinc(np.pi / 2, k**2) - ellipkinc(start(k), k**2) - np.sqrt(load)

    theta = brentq(excess, 1e-9, np.pi / 2 - 1e-12, xtol=1e-15, rtol=1e-14)
    k = modulus(theta)
    root = np.sqrt(load)
    deflection = 1.0 - 2.0 / root * (ellipeinc(np.pi / 2, k**2) - ellipeinc(start(k), k**2))
    return 1.0 - np.sqrt(2.0 * np.sin(theta) / load), deflection, theta


def tip_of(load, l=20e-3):
    force = load * rigidity() / l**2
    layout = cantilever(l=l)
    result = solve(layout, loads=[Load("tip", (l, 0.0), (0.0, force))], effects=SLENDER).checked()
    return result.motions[0, 0] / [-l, l, 1.0]


@pytest.mark.parametrize("load", [0.1, 1.0, 2.0, 5.0, 10.0, 20.0])
def test_end_loaded_cantilever_follows_elliptic_integrals(load):
    assert tip_of(load) == pytest.approx(elastica(load), rel=PRECISION, abs=1e-13)


@pytest.mark.parametrize("load", MATTIASSON)
def test_end_loaded_cantilever_has_the_printed_digits_of_mattiasson(load):
    assert tip_of(load) == pytest.approx(MATTIASSON[load], abs=0.5e-5)


@pytest.mark.parametrize("turns", [0.25, 1.0, 2.0])
def test_an_end_moment_rolls_a_blade_up(turns):
    l = 20e-3
    angle = 2.0 * np.pi * turns
    load = Load("tip", (l, 0.0), moment=angle * rigidity() / l)
    x, y, phi = solve(cantilever(), loads=[load], effects=SLENDER).checked().motions[0, 0]
    expected = (l * np.sin(angle) / angle - l, l * (1.0 - np.cos(angle)) / angle, angle)
    assert (x, y, phi) == pytest.approx(expected, abs=1e-9 * l, rel=1e-9)


def test_a_thick_blade_under_large_loads_follows_reissners_equations():
    """Independent route: shooting with an adaptive integrator, everything unscaled."""
    l, h, b = 1.0, 0.3, 0.1
    E_soft, G_soft = 1.0, 0.4
    EI, EA, GA = E_soft * b * h**3 / 12, E_soft * b * h, 5 / 6 * G_soft * b * h
    P = np.array([-0.6, 3.0]) * EI / l**2

    def rate(_, state):
        theta, M = state[2], state[3]
        t, n = np.array([np.cos(theta), np.sin(theta)]), np.array([-np.sin(theta), np.cos(theta)])
        r = (1.0 + P @ t / EA) * t + (P @ n / GA) * n
        return [*r, M / EI, -(r[0] * P[1] - r[1] * P[0])]

    def shoot(M0):
        return solve_ivp(rate, (0.0, l), [0.0, 0.0, 0.0, M0[0]], rtol=1e-12, atol=1e-14).y[:, -1]

    M0 = fsolve(lambda m: [shoot(m)[3]], [P[1] * l], xtol=1e-13)
    x, y, theta, _ = shoot(M0)
    layout = cantilever(h=h, l=l, b=b, E=E_soft, G=G_soft)
    result = solve(layout, loads=[Load("tip", (l, 0.0), tuple(P))]).checked()
    assert result.motions[0, 0] == pytest.approx([x - l, y, theta], rel=1e-8)


@pytest.mark.parametrize("delta", [-1.0, -0.5, -0.1273, 0.0, 0.2, 1.0])
def test_a_pivot_at_rest_has_the_stiffness_and_shift_of_the_closed_forms(delta):
    h, l, b, alpha = 1e-4, 20e-3, 10e-3, np.radians(35.0)
    theta = 1e-3
    layout = pivot(h=h, l=l, b=b, delta=delta, alpha=alpha)
    result = solve(layout, {"out": (None, None, theta)}, effects=SLENDER).checked()
    K = rotational_stiffness(E=E, h=h, l=l, b=b, p=delta * l)
    assert result.reactions[0, 0, 2] / theta == pytest.approx(K, rel=1e-5)
    shift = parasitic_shift(l=l, p=delta * l, theta=theta, half_angle=alpha)
    # the closed form's next term is of order θ⁴ l
    assert result.motions[0, 0, 0] == pytest.approx(shift, rel=1e-4, abs=10.0 * theta**4 * l)


def test_a_parallelogram_shortens_by_three_fifths_of_the_squared_stroke():
    l = 20e-3
    stroke = np.array([1e-3, 1e-2]) * l
    layout = parallelogram()
    result = solve(layout, {"table": (None, stroke, 0.0)}, effects=SLENDER)
    # both blades are alike, so holding the rotation shares the load without a unique division
    assert all(o is not Outcome.CONVERGED for o in result.outcome)
    held = solve(layout, {"table": (None, stroke, 0.0)}, effects=Effects(True, False)).checked()
    shortening = -held.motions[:, 0, 0] * l / stroke**2
    assert shortening == pytest.approx([0.6, 0.6], rel=1e-3)
    k = held.reactions[:, 0, 1] / stroke
    assert k[0] == pytest.approx(24.0 * rigidity() / l**3, rel=1e-5)
    assert k[1] > k[0]


@pytest.mark.parametrize("n", [-9.0, -2.0, 3.0, 50.0])
def test_a_guided_blade_under_axial_load_follows_tanh_and_tan(n):
    """k = N / (l (1 − tanh(λ/2)/(λ/2))), λ² = N l²/EI, for a small stroke."""
    l, EI = 20e-3, rigidity()
    N = n * EI / l**2
    half = np.sqrt(complex(n)) / 2.0
    k = (N / l / (1.0 - np.tanh(half) / half)).real
    stroke = 1e-7 * l
    loads = [Load("tip", (l, 0.0), (N, 0.0))]
    result = solve(cantilever(), {"tip": (None, stroke, 0.0)}, loads=loads, effects=SLENDER)
    assert result.checked().reactions[0, 0, 1] == pytest.approx(k * stroke, rel=1e-9)


def test_a_right_angle_is_reached_from_rest_on_the_stable_side():
    result = solve(pivot(delta=-0.5), {"out": (None, None, np.pi / 2)}).checked()
    back = solve(pivot(delta=-0.5), {"out": (None, None, 0.0)}, start=result).checked()
    assert result.reactions[0, 0, 2] > 0.0
    assert back.motions[0, 0] == pytest.approx([0.0, 0.0, 0.0], abs=1e-12)


def test_a_right_angle_in_one_call_is_that_of_many_small_ones():
    layout = pivot(delta=0.2)
    direct = solve(layout, {"out": (None, None, np.pi / 2)}).checked()
    state = None
    for theta in np.linspace(0.0, np.pi / 2, 31)[1:]:
        state = solve(layout, {"out": (None, None, theta)}, start=state).checked()
    assert direct.reactions[0, 0, 2] == pytest.approx(state.reactions[0, 0, 2], rel=1e-8)
    assert direct.motions[0, 0] == pytest.approx(state.motions[0, 0], rel=1e-8)


def test_thickness_over_length_costs_no_digits():
    """The same slender pivot for h/l = 1e-5 … 0.3 when nothing but bending deforms it."""
    ratio = np.array([1e-5, 1e-4, 1e-2, 0.3])
    l = 20e-3
    layout = pivot(h=ratio * l, l=l)
    held = {"out": (None, None, 0.3)}
    bending = solve(layout, held, effects=SLENDER).checked()
    unit = rigidity(h=ratio * l) / l
    moments = bending.reactions[:, 0, 2] / unit
    assert moments == pytest.approx(moments[0], rel=1e-11)
    full = solve(layout, held).checked()
    assert full.reactions[:2, 0, 2] / unit[:2] == pytest.approx(moments[0], rel=1e-6)
    assert abs(full.reactions[3, 0, 2] / unit[3] / moments[0] - 1.0) > 1e-3


def test_nodes_give_spectral_convergence():
    """Log error of the tip falls in a straight line over the nodes, until rounding."""
    load, l = 10.0, 20e-3
    force = load * rigidity() / l**2
    layout = cantilever()
    reference = np.array(elastica(load))
    nodes, errors = np.arange(3, 17), []
    for count in nodes:
        coarse = assemble(layout, SLENDER, int(count))
        demand = demand_of(coarse, {}, [Load("tip", (l, 0.0), (0.0, force))])
        found = newton(
            lambda x, rows, of=coarse, to=demand: of.step(x, np.ones(1), rows, to),
            coarse.length_of,
            np.zeros((1, coarse.size)),
            tolerance=1e-13,
        )
        assert found.converged.all()
        motion = coarse.split(found.x)[2][0, 0] * [-1.0, 1.0, 1.0]
        errors.append(np.max(np.abs(motion - reference)))
    log_error = np.log10(errors)
    falling = log_error > -12.0
    assert np.all(np.diff(np.flatnonzero(falling)) == 1)
    slope, _ = np.polyfit(nodes[falling], log_error[falling], 1)
    assert slope < -0.9
    assert np.corrcoef(nodes[falling], log_error[falling])[0, 1] < -0.99
    assert np.all(log_error[~falling] < -12.0)
    assert log_error[-1] < -12.0


def test_one_hopeless_design_spoils_no_other():
    """Nothing holds the loose body of the middle design."""
    l = 20e-3
    k = np.array([1.0, 0.0, 1.0])
    layout = cantilever(supports=(Support("loose", (0.0, 0.0), (k, k, k)),))
    layout = replace(layout, bodies=(*layout.bodies, Body("loose", (0.0, 0.0))))
    load = Load("tip", (l, 0.0), (0.0, rigidity() / l**2))
    result = solve(layout, loads=[load, Load("loose", (0.0, 0.0), (1e-3, 0.0))])
    assert [o.name for o in result.outcome] == ["CONVERGED", "SINGULAR", "CONVERGED"]
    assert result.motions[0, 0] == pytest.approx(result.motions[2, 0], rel=1e-12)
    with pytest.raises(SolveError, match="design 1"):
        result.checked()


def test_a_name_that_is_no_body_is_refused():
    for wrong in ({"held": {"nobody": (0.0, 0.0, 0.0)}}, {"loads": [Load("nobody", (0.0, 0.0))]}):
        with pytest.raises(KeyError, match="nobody"):
            solve(cantilever(), **wrong)


@pytest.mark.parametrize("seed", range(4))
def test_the_jacobian_is_the_derivative_of_the_residual(seed):
    """Central differences of the condensed equations at random states, rotations following."""
    rng = np.random.default_rng(seed)
    layout = pivot(h=2e-3, delta=0.3)
    assembly = assemble(layout, Effects(), 9)
    load = Load("out", (1e-3, 2e-3), (30.0, -20.0), 0.1, follows=bool(seed % 2))
    demand = demand_of(assembly, {}, [load])
    rows, share = np.arange(1), np.ones(1)
    x = 0.3 * rng.standard_normal((1, assembly.size))
    # the rotations at the nodes in balance with the forces of the state
    for _ in range(30):
        step = assembly.step(x, share, rows, demand)
        blades = assembly.linearise(x, share, rows, demand).blades
        x[:, : assembly.turns] += blades[0].free.reshape(1, -1)
    assert np.isfinite(step).all()
    at = assembly.linearise(x, share, rows, demand)
    for column in range(3 * assembly.blades + 3 * assembly.bodies):
        residuals = []
        for side in (1.0, -1.0):
            y = x.copy()
            y[:, assembly.turns + column] += side * 1e-5
            for _ in range(6):
                blades = assembly.linearise(y, share, rows, demand).blades
                y[:, : assembly.turns] += blades[0].free.reshape(1, -1)
            residuals.append(assembly.linearise(y, share, rows, demand).residual[0])
        slope = (residuals[0] - residuals[1]) / 2e-5
        assert at.matrix[0, :, column] == pytest.approx(slope, abs=1e-7)


angles = st.floats(-np.pi, np.pi)
# beyond 0.6 rad a pivot with δ = 1 has pulled one of its blades straight, and jams
thetas = st.floats(-0.5, 0.5)
deltas = st.floats(-1.0, 1.0)


@settings(max_examples=15)
@example(angle=0.0, theta=5e-324, delta=0.0)
@given(angle=angles, theta=thetas, delta=deltas)
def test_turning_the_frame_turns_the_answer(angle, theta, delta):
    held = {"out": (None, None, theta)}
    one = solve(pivot(delta=delta), held).checked()
    other = solve(pivot(delta=delta, angle=angle), held).checked()
    c, s = np.cos(angle), np.sin(angle)
    x, y, _ = one.motions[0, 0]
    assert other.motions[0, 0, :2] == pytest.approx([c * x - s * y, s * x + c * y], abs=1e-11)
    assert other.reactions[0, 0, 2] == pytest.approx(one.reactions[0, 0, 2], rel=1e-8, abs=1e-11)


@settings(max_examples=15)
@given(theta=thetas, delta=deltas, force=st.floats(-1.0, 1.0))
def test_a_mirrored_pivot_gives_the_mirrored_answer(theta, delta, force):
    F = force * rigidity() / (20e-3) ** 2
    loads = [Load("out", (0.0, 0.0), (F, 0.5 * F))]
    mirrored = [Load("out", (0.0, 0.0), (F, -0.5 * F))]
    one = solve(pivot(delta=delta), {"out": (None, None, theta)}, loads=loads).checked()
    other = solve(pivot(delta=delta), {"out": (None, None, -theta)}, loads=mirrored).checked()
    assert other.motions[0, 0] == pytest.approx(one.motions[0, 0] * [1, -1, -1], abs=1e-10)


@settings(max_examples=10)
@given(factor=st.sampled_from([1e-6, 1e-3, 1e3]), theta=thetas)
def test_units_do_not_matter(factor, theta):
    one = solve(pivot(), {"out": (None, None, theta)}).checked()
    small = pivot(h=1e-4 * factor, l=20e-3 * factor, b=10e-3 * factor)
    other = solve(small, {"out": (None, None, theta)}).checked()
    moment = one.reactions[0, 0, 2] * factor**3
    assert other.reactions[0, 0, 2] == pytest.approx(moment, rel=1e-12, abs=1e-16 * factor**3)
    assert other.iterations[0] == one.iterations[0]


def test_a_batch_gives_the_answers_of_its_designs():
    rng = np.random.default_rng(7)
    h, l = 1e-4 * rng.uniform(0.5, 2.0, 6), 20e-3 * rng.uniform(0.5, 2.0, 6)
    delta, theta = rng.uniform(-1.0, 1.0, 6), rng.uniform(-0.9, 0.9, 6)
    batch = solve(pivot(h=h, l=l, delta=delta), {"out": (None, None, theta)}).checked()
    for i in range(6):
        layout = pivot(h=h[i], l=l[i], delta=delta[i])
        one = solve(layout, {"out": (None, None, theta[i])}).checked()
        assert batch.motions[i] == pytest.approx(one.motions[0], rel=1e-9, abs=1e-14)
        assert batch.reactions[i] == pytest.approx(one.reactions[0], rel=1e-8, abs=1e-12)


class Counted(Constant):
    """A blade that counts how often its pieces are asked for."""

    def pieces(self, l):
        reads.append(l)
        return super().pieces(l)


reads = []


def test_a_layout_is_read_once_for_all_its_equilibria_and_their_digits_are_the_same():
    def made(**changed):
        plain = pivot(**changed)
        blades = (replace(blade, profile=Counted(blade.profile.h)) for blade in plain.blades)
        return replace(plain, blades=tuple(blades))

    layout, turns = made(), (0.02, 0.2, 0.6)
    reads.clear()
    found = [solve(layout, {"out": (None, None, turn)}) for turn in turns]
    assert len(reads) == len(layout.blades)
    for state, turn in zip(found, turns, strict=True):
        alone = solve(made(), {"out": (None, None, turn)})
        assert (state.end_forces == alone.end_forces).all()
        assert state.nodes.tolist() == alone.nodes.tolist()


def test_the_equations_at_rest_are_those_of_a_layout_alone_whatever_was_put_on_it_before():
    loads = [Load("out", (1e-3, 2e-3), (0.3, -0.2), 1e-3), Load("out", (0.0, 0.0), (0.1, 0.0))]
    layout, sprung = pivot(), pivot(supports=(Support("out", (1e-3, 0.0), (2.0, 3.0, 1e-2)),))
    for known in (layout, sprung):
        solve(known, {"out": (None, None, 0.0)}, loads=loads)
        solve(known, {"out": (None, None, 0.3)}, loads=loads[:1])
    for known, alone in ((layout, pivot()), (sprung, replace(sprung))):
        for held in ({"out": (None, None, 0.0)}, {"out": (1e-6, None, 0.01)}, {}):
            found, fresh = (solve(each, held, loads=loads[1:]) for each in (known, alone))
            assert (found.motions == fresh.motions).all()
            assert (found.reactions == fresh.reactions).all()
    warm = replace(layout, body_growth={"out": 1e-3})
    assert np.any(solve(warm, {"out": (None, None, 0.0)}).end_forces != 0.0)


def test_what_is_known_of_a_layout_is_nothing_to_a_changed_copy_and_effects_are_apart():
    layout, held = pivot(), {"out": (None, None, 0.2)}
    once = solve(layout, held)
    other = replace(layout, E=2.0 * layout.E, G=2.0 * layout.G)
    assert solve(other, held).end_forces == pytest.approx(2.0 * once.end_forces, rel=1e-12)
    slender = solve(layout, held, effects=SLENDER)
    assert (slender.end_forces == solve(pivot(), held, effects=SLENDER).end_forces).all()
    assert not (slender.end_forces == once.end_forces).all()


def test_the_work_of_the_drive_is_the_energy_stored():
    """Closed form of neither: ∫ M dθ by Gauss quadrature against the sum of the blades' energy."""
    nodes, weights = np.polynomial.legendre.leggauss(12)
    theta = 0.6 * (nodes + 1.0) / 2.0
    sweep = solve(pivot(), {"out": (None, None, theta)}).checked()
    work = 0.6 / 2.0 * weights @ sweep.reactions[:, 0, 2]
    end = solve(pivot(), {"out": (None, None, 0.6)}).checked()
    assert strain_energy(end)[0] == pytest.approx(work, rel=1e-9)


@pytest.mark.parametrize("theta", [np.radians(10.0), 0.5])
def test_a_cross_spring_pivot_follows_shooting_of_the_elastica(theta):
    """Independent route (the problem of Haringx and Wittrick): two elasticas, six unknowns.

    Each inextensible blade starts clamped at the ground; both ends lie on the turned body.
    """
    l, alpha, delta = 1.0, np.pi / 4, -0.5
    p = delta * l
    directions = [np.pi + alpha, np.pi - alpha]
    starts = [-(p + l) * np.array([np.cos(a), np.sin(a)]) for a in directions]
    arms = [-p * np.array([np.cos(a), np.sin(a)]) for a in directions]
    R = np.array([[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]])

    def end(start, direction, n_x, n_y, m):
        def rate(_, y):
            c, s = np.cos(y[2]), np.sin(y[2])
            return [c, s, y[3], n_x * s - n_y * c]

        initial = [*start, direction, m]
        return solve_ivp(rate, (0.0, l), initial, rtol=1e-12, atol=1e-13).y[:, -1]

    def misfit(unknown):
        F, m_0, m_1, u = unknown[:2], unknown[2], unknown[3], unknown[4:]
        found = []
        for sign, start, arm, a, m in zip(
            (1, -1), starts, arms, directions, (m_0, m_1), strict=True
        ):
            x, y, turn, _ = end(start, a, sign * F[0], sign * F[1], m)
            found += [*(np.array([x, y]) - u - R @ arm), turn - a - theta]
        return found

    solution = fsolve(misfit, [0.0, 0.0, theta, theta, 0.0, 0.0], xtol=1e-13)
    moment = 0.0
    for sign, start, arm, a, m in zip(
        (1, -1), starts, arms, directions, solution[2:4], strict=True
    ):
        F = sign * solution[:2]
        M = end(start, a, *F, m)[3]
        lever = R @ arm
        moment += M + lever[0] * F[1] - lever[1] * F[0]
    layout = pivot(l=l, h=1e-2, b=0.1, alpha=alpha, delta=delta)
    state = solve(layout, {"out": (None, None, theta)}, effects=SLENDER).checked()
    EI = rigidity(h=1e-2, b=0.1)
    assert state.reactions[0, 0, 2] / EI == pytest.approx(moment, rel=1e-8)
    assert state.motions[0, 0, :2] == pytest.approx(solution[4:], abs=1e-9)
