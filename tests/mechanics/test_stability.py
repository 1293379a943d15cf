"""Which solutions stand, at which load they fall, and what softening leads there."""

from dataclasses import replace

import numpy as np
import pytest
from mechanisms_for_tests import E, G, cantilever, parallelogram, pivot
from paths import trace
from scipy.optimize import brentq

from flexcli.errors import Outcome, SolveError
from flexcli.formulas.buckling import euler_load
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.stability import critical_load, is_stable
from flexcli.mechanics.tangent import held_stiffness

SLENDER = Effects(extension=False, shear=False)
BENDING = Effects(extension=True, shear=False)
l, h, b = 20e-3, 1e-4, 10e-3
EI = E * b * h**3 / 12.0
THIN = 1e-6
"""Thickness at which a blade is next to inextensible: strain at its Euler load is 8e-9."""
EI_THIN = E * b * THIN**3 / 12.0
STRAIN = 1e-7
"""What extension and shear may do to the load of a thin blade."""
PUSH = Load("tip", (l, 0.0), (-EI / l**2, 0.0))

ENDS = {
    "clamped-free": {},
    "clamped-pinned": {"tip": (None, 0.0, None)},
    "clamped-guided": {"tip": (None, None, 0.0)},
    "clamped-clamped": {"tip": (None, 0.0, 0.0)},
}


@pytest.mark.parametrize("most", [50.0, 333.0])
@pytest.mark.parametrize("ends", ENDS)
def test_a_blade_buckles_at_eulers_load(ends, most):
    found = critical_load(cantilever(), ENDS[ends], [PUSH], most=most, effects=SLENDER)
    expected = euler_load(E=E, I=b * h**3 / 12.0, l=l, ends=ends) * l**2 / EI
    assert found.factor == pytest.approx(expected, rel=1e-9)
    assert found.multiplicity == 1
    assert not found.turns
    blade_alone = ends == "clamped-clamped"
    assert (np.max(np.abs(found.mode)) == 0.0) == blade_alone


def test_a_blade_is_unstable_in_as_many_ways_as_euler_loads_passed():
    """Cantilever: (2i − 1)² π²/4."""
    loads = [0.9, 1.1, 8.9, 9.1, 24.9, 25.1]
    factor = np.pi**2 / 4.0 * np.array(loads)
    state = solve(cantilever(), loads=[PUSH], load_factor=factor, effects=SLENDER)
    assert state.unstable.tolist() == [0, 1, 1, 2, 2, 3]
    assert is_stable(state).tolist() == [True, False, False, False, False, False]


def turning_stiffness(n, delta):
    """Rotational stiffness [EI/l] of a pivot about its centre, n = N l²/EI pushing each blade.

    Both blades are beam-columns (Timoshenko & Gere 1961, section 1.11) with the end motion −p θ,
    θ; moved on a circle about the centre, the end goes inwards by p θ²/2, which costs N p.
    """
    k = np.sqrt(n)
    c, s = np.cos(k), np.sin(k)
    D = 2.0 - 2.0 * c - k * s
    across, mixed, turn = k**3 * s / D, k**2 * (1.0 - c) / D, k * (s - k * c) / D
    return 2.0 * (delta**2 * across + 2.0 * delta * mixed + turn - n * delta)


def radial(unit=EI_THIN):
    """A radial load towards the blades of a pivot."""
    return [Load("out", (0.0, 0.0), (unit / l**2, 0.0))]


@pytest.mark.parametrize("delta", [0.2, -0.5])
def test_what_is_held_decides_the_critical_load_of_a_pivot(delta):
    """Kept from turning, both blades buckle clamped at 4π²EI/l²; let go, the pivot turns.

    Slender blades hold the centre by themselves: to hold it across the load changes nothing.
    """
    layout, share = pivot(h=THIN, delta=delta), 2.0 * np.cos(np.pi / 4)
    hold = {
        "locked": {"out": (None, 0.0, 0.0)},
        "guided": {"out": (None, None, 0.0)},
        "turning": {"out": (None, 0.0, None)},
        "free": {},
    }
    found = {key: critical_load(layout, held, radial(), most=200.0) for key, held in hold.items()}
    for key in ("locked", "guided"):
        assert found[key].factor == pytest.approx(4.0 * np.pi**2 * share, rel=STRAIN)
        assert found[key].multiplicity == 2
        assert np.max(np.abs(found[key].mode)) == 0.0
    turning = brentq(turning_stiffness, 1.0, 4.0 * np.pi**2 - 1.0, args=(delta,))
    for key in ("turning", "free"):
        assert found[key].factor == pytest.approx(turning * share, rel=STRAIN)
        assert found[key].multiplicity == 1
        assert found[key].mode[0, 2] == 1.0


def test_what_is_held_decides_the_critical_load_of_a_stage():
    """Table held in place: 4π²; kept upright: π²; free, its blades far apart: not less by much."""
    push = [Load("table", (l, 0.0), (-EI_THIN / l**2, 0.0))]
    stage = parallelogram(h=THIN)
    factors = [
        critical_load(stage, {"table": held}, push, most=120.0).factor / 2.0
        for held in ((None, 0.0, 0.0), (None, None, 0.0), (None, None, None))
    ]
    assert factors[:2] == pytest.approx([4.0 * np.pi**2, np.pi**2], rel=STRAIN)
    assert factors[2] == pytest.approx(np.pi**2, rel=1e-6)


def test_a_parallel_stage_softens_to_nothing_and_beyond():
    """k = 2 (N/l) / (tan(λ/2)/(λ/2) − 1), λ² = N l²/EI, negative past π² EI/l²."""
    n = np.array([0.5, 0.9, 0.99, 1.01, 1.5, 3.0]) * np.pi**2
    push = [Load("table", (l, 0.0), (-2.0 * EI_THIN / l**2, 0.0))]
    state = solve(
        parallelogram(h=THIN),
        {"table": (None, 0.0, 0.0)},
        loads=push,
        load_factor=n,
        effects=BENDING,
    )
    half = np.sqrt(n) / 2.0
    expected = 2.0 * n / (np.tan(half) / half - 1.0) * EI_THIN / l**3
    found = held_stiffness(state.checked())[:, 0, 0]
    assert found == pytest.approx(expected, rel=1e-5, abs=STRAIN * EI_THIN / l**3)
    assert (found > 0.0).tolist() == [True, True, True, False, False, False]


@pytest.mark.parametrize("delta", [0.2, -0.5])
def test_a_pivot_softens_to_nothing_and_beyond(delta):
    critical = brentq(turning_stiffness, 1.0, 4.0 * np.pi**2 - 1.0, args=(delta,))
    n = np.array([0.01, 0.5, 0.99, 1.01, 1.2]) * critical
    state = solve(
        pivot(h=THIN, delta=delta),
        {"out": (None, None, 0.0)},
        loads=radial(),
        load_factor=n * 2.0 * np.cos(np.pi / 4),
        effects=BENDING,
    )
    found = held_stiffness(state.checked())[:, 0, 0] * l / EI_THIN
    assert found == pytest.approx(turning_stiffness(n, delta), rel=1e-5)
    assert (found > 0.0).tolist() == [True, True, True, False, False]


def test_no_critical_load_is_said_to_be_none():
    with pytest.raises(SolveError) as said:
        critical_load(cantilever(), {}, [PUSH], most=1.0)
    assert said.value.code == "no-critical-load"
    pull = PUSH._replace(force=(EI / l**2, 0.0))
    with pytest.raises(SolveError) as said:
        critical_load(cantilever(), {}, [pull], most=100.0)
    assert said.value.code == "no-critical-load"


@pytest.mark.slow
def test_a_blade_that_a_moment_rolls_up_has_an_endless_path():
    roll = PUSH._replace(force=(0.0, 0.0), moment=EI / l)
    with pytest.raises(SolveError) as said:
        critical_load(cantilever(), {}, [roll], most=1e3, effects=SLENDER)
    assert said.value.code == "endless-path"


def test_a_start_that_falls_by_itself_is_named():
    pushed = PUSH._replace(force=(-3.0 * EI / l**2, 0.0))
    with pytest.raises(SolveError) as said:
        critical_load(replace(cantilever(), loads=(pushed,)), {}, [PUSH], most=1.0)
    assert said.value.code == "unstable-start"


def test_a_start_without_a_unique_answer_is_no_critical_load():
    loose = Body("loose", (0.0, 0.0))
    layout = replace(cantilever(), bodies=(*cantilever().bodies, loose))
    with pytest.raises(SolveError) as said:
        critical_load(layout, {}, [PUSH], most=10.0)
    assert said.value.code == "singular"


def arch(rise=2e-3, thickness=2e-4):
    """Two blades from the ground to a top, which is higher by the rise."""
    blades = tuple(
        Blade(str(s), "ground", "top", (s * l, 0.0), (0.0, rise), Constant(thickness), b)
        for s in (-1, 1)
    )
    return Layout((Body("top", (0.0, rise)),), blades, E, G)


GUIDED = {"top": (0.0, None, 0.0)}
LIMIT = 22.7745
"""Limit load [N] of the arch on its straight path, by arc length."""


def weight(newton, rise=2e-3):
    """A load on the top of the arch."""
    return [Load("top", (0.0, rise), (0.0, -newton))]


@pytest.mark.slow
def test_the_path_of_a_shallow_arch_turns_twice_and_ends_stable():
    rise = 2e-3
    path = trace(arch(rise), GUIDED, loads=weight(100.0))
    assert len(path.turns) == 2
    assert is_stable(path.states[0])[0]
    assert is_stable(path.states[-1])[0]
    assert not is_stable(path.states[len(path.states) // 2])[0]
    # flat, its thrust is level and balances no load
    flat = int(np.argmin([abs(s.motions[0, 0, 1] + rise) for s in path.states]))
    assert abs(path.share[flat]) < 0.1 * path.share.max()
    assert 100.0 * path.share[path.turns[0] - 1] == pytest.approx(LIMIT, rel=1e-2)
    one = path.states[3]
    again = solve(arch(rise), GUIDED, loads=weight(100.0), load_factor=path.share[3]).checked()
    assert one.motions == pytest.approx(again.motions, rel=1e-8)


@pytest.mark.parametrize("load", [22.8, 25.0, 40.0, 50.0, 100.0, 500.0])
def test_a_load_beyond_the_limit_point_ends_there_and_on_no_other_branch(load):
    state = solve(arch(), GUIDED, loads=weight(load))
    assert state.outcome == (Outcome.TURNED,)
    assert state.reached[0] * load == pytest.approx(LIMIT, rel=1e-3)


def test_an_arch_below_its_limit_tells_that_its_blades_have_buckled():
    """They may buckle from 14.28 N on, both alike; the straight path goes on and is unstable."""
    state = solve(arch(), GUIDED, loads=weight(1.0), load_factor=np.array([10.0, 14.0, 14.5, 22.0]))
    assert state.checked().unstable.tolist() == [0, 0, 2, 2]
    found = critical_load(arch(), GUIDED, weight(1.0), most=100.0)
    assert found.factor == pytest.approx(14.28, abs=0.005)
    assert (found.multiplicity, found.turns) == (2, False)


def test_a_stout_arch_snaps_at_its_limit_load():
    stout, rise = arch(1e-3, 4e-4), 1e-3
    found = critical_load(stout, GUIDED, weight(1.0, rise), most=1000.0)
    assert found.turns
    assert abs(found.mode[0, 1]) > 0.0
    assert found.state.unstable[0] == 0
    loads = found.factor * np.array([0.5, 0.999, 1.01, 2.0])
    state = solve(stout, GUIDED, loads=weight(1.0, rise), load_factor=loads)
    assert [o.name for o in state.outcome] == ["CONVERGED", "CONVERGED", "TURNED", "TURNED"]
    assert state.unstable.tolist() == [0, 0, 0, 0]
    assert state.reached[2:] * loads[2:] == pytest.approx(found.factor, rel=1e-3)


def test_a_column_follows_its_bifurcated_branch():
    """A thousandth of the load across makes the path bend away: no turn, stable all along."""
    across = PUSH._replace(force=(-4.0 * EI / l**2, 4e-3 * EI / l**2))
    path = trace(cantilever(), {}, loads=[across], effects=SLENDER)
    assert path.turns == ()
    assert all(is_stable(s)[0] for s in path.states)
    assert path.states[-1].motions[0, 0, 2] > np.radians(90.0)


def test_a_column_that_leans_has_no_critical_load():
    """It bends away from the straight branch before that gets unstable, and goes on standing."""
    leaning = PUSH._replace(force=(-EI / l**2, 1e-3 * EI / l**2))
    with pytest.raises(SolveError) as said:
        critical_load(cantilever(), {}, [leaning], most=6.0, effects=SLENDER)
    assert said.value.code == "no-critical-load"


@pytest.mark.slow
def test_pivots_loaded_just_below_their_critical_load_stand_and_just_above_do_not():
    """Turned first, then loaded: on the way to both at once the critical load may be another."""
    rng = np.random.default_rng(5)
    for delta, alpha, theta in zip(
        rng.uniform(-1.0, 0.5, 4), rng.uniform(0.4, 1.2, 4), rng.uniform(-0.1, 0.1, 4), strict=True
    ):
        layout, held = pivot(delta=delta, alpha=alpha), {"out": (None, None, theta)}
        found = critical_load(layout, held, radial(EI), most=500.0)
        turned = solve(layout, held)
        for share, stands in ((0.95, True), (0.999, True), (1.01, False)):
            load = share * found.factor
            state = solve(layout, held, loads=radial(EI), load_factor=load, start=turned)
            assert (state.converged[0] and state.unstable[0] == 0) == stands
