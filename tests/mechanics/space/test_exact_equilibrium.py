"""Exact beams in space against the planar solver, closed forms, published tips and themselves."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from layouts_in_space import LOADS, STEEL, askew, guide, rod, strip, turned
from scipy.integrate import solve_bvp, solve_ivp
from scipy.optimize import root
from scipy.spatial.transform import Rotation
from support import body_stiffness

from flexcli.errors import Outcome, SolveError
from flexcli.formulas.blade_spring import blade_springs, deformation_rows
from flexcli.formulas.plate_factors import guided_factor, pure_bending_factor
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.formulas.restrained_torsion import restrained_stiffness
from flexcli.formulas.sheet_factors import axial_factor
from flexcli.formulas.sheet_factors import guided_factor as sheet_guided_factor
from flexcli.formulas.torsion_section import torsion_constant
from flexcli.formulas.torsion_section import warping as section_warping
from flexcli.mechanics import equilibrium as planar
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.space.exact.demand import Frame, drive_frame
from flexcli.mechanics.space.exact.equilibrium import beside, solve
from flexcli.mechanics.space.layout import (
    BeamEffects,
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceLayout,
    SpaceLoad,
)
from flexcli.mechanics.tangent import body_stiffness as planar_stiffness

BEAM = BeamEffects(plate=False)
"""What the planar solver has; a planar blade neither twists nor warps."""
SLENDER = BeamEffects(extension=False, shear=False, plate=False, warping=False, long_fibres=False)
E, G = STEEL.E, STEEL.G
PLANE = [0, 1, 5]


def in_both(profile, b, *, delta=0.2, l=20e-3, alpha=0.7):
    """A crossed pivot in the plane and in space."""
    flat, deep, p = [], [], delta * l
    for name, side in (("upper", 1.0), ("lower", -1.0)):
        c, s = np.cos(side * alpha), np.sin(side * alpha)
        outer, inner = ((p + l) * c, (p + l) * s), (p * c, p * s)
        flat.append(Blade(name, "ground", "out", outer, inner, profile, b))
        ends = (*outer, 0.0), (*inner, 0.0)
        deep.append(SpaceBlade(name, "ground", "out", *ends, (0, 0, 1), profile, b, STEEL))
    body = strip(h=1e-4, b=b).bodies[0]._replace(name="out", point=(0, 0, 0), com=(0, 0, 0))
    drive = Drive("out", True, (0, 0, 1), (0, 0, 0))
    return (
        Layout((Body("out", (0.0, 0.0)),), tuple(flat), E, G),
        SpaceLayout((body,), tuple(deep), drive),
    )


VARYING = [
    Notch(0.2e-3, 9e-3),
    Filleted(0.15e-3, 2e-3),
    Tabulated((0.0, 0.3, 1.0), (0.3e-3, 0.1e-3, 0.5e-3)),
]


@pytest.mark.parametrize(
    ("profile", "angle"),
    [*product([Constant(0.1e-3), NeckedDown(0.15e-3, 4e-3)], [1e-3, 0.3, 0.7]),
     *product(VARYING, [0.02, 0.1])],
)  # fmt: skip
def test_a_planar_state_is_that_of_the_planar_solver(profile, angle):
    flat, deep = in_both(profile, 5e-3)
    expected = planar.solve(flat, {"out": (None, None, angle)}).checked()
    held = {"out": (None, None, None, None, None, angle)}
    found = solve(deep, held, effects=BEAM).checked()
    motion, force = expected.motions[0, 0], expected.reactions[0, 0]
    assert found.coordinates[0, PLANE] == pytest.approx(motion, rel=1e-9)
    assert found.reactions[0, 5] == pytest.approx(force[2], rel=1e-9)
    off = np.delete(found.coordinates[0], PLANE)
    assert np.max(np.abs(off)) < 1e-12 * angle
    K = body_stiffness(found, "out", (0, 0, 0))[np.ix_(PLANE, PLANE)]
    flat_K = planar_stiffness(expected, "out")[0]
    scale = np.sqrt(np.abs(np.outer(np.diag(flat_K), np.diag(flat_K))))
    assert np.max(np.abs(K - flat_K) / scale) < 1e-8


@pytest.mark.parametrize("h", [2e-7, 1e-4, 6e-3])
def test_thin_and_thick_blades_are_alike(h):
    """h/l from 1e-5 to 0.3, by the planar solver."""
    flat, deep = in_both(Constant(h), 5e-3)
    expected = planar.solve(flat, {"out": (None, None, 0.2)}).checked()
    found = solve(deep, {"out": (None, None, None, None, None, 0.2)}, effects=BEAM).checked()
    assert found.reactions[0, 5] == pytest.approx(expected.reactions[0, 0, 2], rel=1e-8)


@pytest.mark.parametrize("unit", [1e-3, 1e3])
def test_lengths_in_any_unit_give_the_same_digits(unit):
    found = [
        solve(
            guide(h=0.5e-3 * u, b=50e-3 * u, l=0.1 * u, apart=0.2 * u),
            {"stage": (8e-3 * u, *(None,) * 5)},
            loads=[SpaceLoad("stage", (0, 0.02 * u, 0.01 * u), (0, 5.0 * u**2, 30.0 * u**2))],
        ).checked()
        for u in (1.0, unit)
    ]
    lengths = np.array([1, 1, 1, 0, 0, 0])
    assert found[1].coordinates / unit**lengths == pytest.approx(found[0].coordinates, rel=1e-8)


def test_a_moment_rolls_a_rod_up_to_a_circle_and_further():
    EI, l = E * np.pi * 1e-3**4 / 64, 0.1
    layout = rod(d=1e-3, l=l)
    axis = np.array([0.0, 0.6, 0.8])
    for angle in (2.0 * np.pi, 2.5 * np.pi):
        moment = tuple(EI / l * angle * axis)
        state = solve(layout, loads=[SpaceLoad("tip", (l, 0, 0), moment=moment)], effects=SLENDER)
        turned = Rotation.from_rotvec(angle * axis)
        tip = np.array([np.sin(angle) / angle, 0, 0])
        tip += (1.0 - np.cos(angle)) / angle * np.cross(axis, [1.0, 0.0, 0.0])
        assert state.outcome is Outcome.CONVERGED
        assert state.coordinates[0, :3] / l == pytest.approx(tip - [1, 0, 0], abs=1e-9)
        found = Rotation.from_quat(state.quaternion("tip"), scalar_first=True)
        assert (turned.inv() * found).magnitude() < 1e-9


def test_a_moment_out_of_the_plane_winds_a_rod_into_a_helix():
    """R(s) = exp(s m/EI) exp(s (1/GJ − 1/EI) M_x e_x), and the tip by that of the first factor."""
    d, l = 1e-3, 0.1
    EI, GJ = E * np.pi * d**4 / 64, G * np.pi * d**4 / 32
    effects = BeamEffects(extension=False, shear=False, long_fibres=False)
    m = EI / l * np.array([1.2, 0.9, 2.1])
    state = solve(rod(d=d, l=l), loads=[SpaceLoad("tip", (l, 0, 0), moment=tuple(m))],
                  effects=effects).checked()  # fmt: skip
    omega = m * l / EI
    angle = np.linalg.norm(omega)
    n = omega / angle
    x = np.array([1.0, 0.0, 0.0])
    tip = np.sin(angle) / angle * x + (1.0 - np.cos(angle)) / angle * np.cross(n, x)
    tip += (1.0 - np.sin(angle) / angle) * (n @ x) * n
    assert state.coordinates[0, :3] / l == pytest.approx(tip - x, abs=1e-9)
    expected = Rotation.from_rotvec(omega) * Rotation.from_rotvec((1 / GJ - 1 / EI) * m[0] * l * x)
    found = Rotation.from_quat(state.quaternion("tip"), scalar_first=True)
    assert (expected.inv() * found).magnitude() < 1e-9


@pytest.mark.parametrize(
    ("load", "tip"), [(300.0, (22.33, 58.84, 40.08)), (600.0, (15.79, 47.23, 53.37))]
)
def test_a_bend_of_45_degrees_comes_where_simo_and_vu_quoc_say(load, tip):
    """Bathe & Bolourchi's bend as Simo & Vu-Quoc (1986) modelled it: eight straight beams.

    Section 1 × 1, E = 1e7, ν = 0. A torsion constant of 1/6 in the place of the exact 0.1406 and
    theirs is 1 % of the tip's way.
    """
    parts, radius = 8, 100.0
    angles = np.linspace(0.0, np.pi / 4.0, parts + 1)
    points = np.stack([radius * np.sin(angles), radius * (1 - np.cos(angles)), 0 * angles], axis=-1)
    names = ["ground", *(f"joint {i}" for i in range(1, parts)), "tip"]
    material = Isotropic(1e7, 0.5e7)
    body = strip(h=1.0, b=1.0).bodies[0]
    at = [tuple(map(float, point)) for point in points]
    blades = tuple(
        SpaceBlade(f"{i}", names[i], names[i + 1], at[i], at[i + 1], (0, 0, 1), Constant(1.0), 1.0,
                   material)
        for i in range(parts)
    )  # fmt: skip
    bodies = tuple(
        body._replace(name=names[i], point=at[i], com=at[i]) for i in range(1, parts + 1)
    )
    layout = SpaceLayout(bodies, blades, Drive("tip", False, (0, 0, 1), at[-1]))
    state = solve(layout, loads=[SpaceLoad("tip", at[-1], (0, 0, load))],
                  effects=BeamEffects(plate=False, warping=False), levels=(6, 8))  # fmt: skip
    x, y, z = points[-1] + state.checked().coordinates[-1, :3]
    # they name the axes (y, x, z)
    assert z == pytest.approx(tip[2], rel=0.01)
    assert sorted((x, y)) == pytest.approx(sorted(tip[:2]), rel=0.015)


PRINCETON = {"l": 0.508, "b": 12.3777e-3, "h": 3.2024e-3}
"""The strip of the Princeton beam experiment (Dowell & Traybar 1975), as modelled since [m]."""
ALUMINIUM = Isotropic(71.7e9, 71.7e9 / 2.62)


def princeton(load, angle, **how):
    """Return the tip's way down and aside under a weight at an angle from the width [rad]."""
    l = PRINCETON["l"]
    layout = strip(**PRINCETON)
    layout = replace(layout, blades=(replace(layout.blades[0], material=ALUMINIUM),))
    force = (0.0, load * np.sin(angle), -load * np.cos(angle))
    return solve(layout, loads=[SpaceLoad("tip", (l, 0, 0), force)], **how).checked()


@pytest.mark.parametrize(
    ("load", "angle", "along_width", "across"),
    [(8.896, 0, 10.71417630, 0.0), (8.896, 30, 10.11169630, 79.39482948),
     (8.896, 60, 6.604665004, 129.887616), (8.896, 90, 0.0, 146.245978),
     (13.345, 30, 16.65873206, 117.735994), (13.345, 60, 11.57837500, 181.861627)],
)  # fmt: skip
def test_the_princeton_beam_bends_as_others_have_it(load, angle, along_width, across):
    """In mm, by 10 to 199 beam elements of ANSYS: Obrezkov, Mikkola & Matikainen (2022), as quoted
    by Exudyn's test models. With ends that warp the first would be up to 1.2 % more."""
    tip = 1e3 * princeton(load, np.deg2rad(angle), effects=BEAM).coordinates[0, :3]
    assert -tip[2] == pytest.approx(along_width, rel=1e-3, abs=1e-9)
    assert tip[1] == pytest.approx(across, rel=1e-4, abs=1e-9)


def test_the_princeton_beam_is_that_of_its_differential_equations_to_1e_9():
    """Integrated from the clamp by Runge and Kutta's method, whose moment there is sought."""
    l, b, h = (PRINCETON[name] for name in ("l", "b", "h"))
    E, G = ALUMINIUM.E, ALUMINIUM.G
    A, load, angle = b * h, 13.345, np.deg2rad(45.0)
    give = np.array([1.0 / E, 1.2 / G, 1.2 / G]) / A
    bend = 1.0 / np.array([G * float(torsion_constant(h, b)), E * h * b**3 / 12, E * b * h**3 / 12])
    n = np.array([0.0, load * np.sin(angle), -load * np.cos(angle)])

    def slope(_, y):
        R, m = y[3:12].reshape(3, 3), y[12:]
        k, rate = bend * (R.T @ m), R @ (np.eye(3)[0] + give * (R.T @ n))
        turn = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
        return np.concatenate([rate, (R @ turn).ravel(), -np.cross(rate, n)])

    def end(m):
        start = np.concatenate([np.zeros(3), np.eye(3).ravel(), m])
        return solve_ivp(slope, (0.0, l), start, method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]

    clamp = root(lambda m: end(m)[12:], np.cross([l, 0, 0], n), options={"xtol": 1e-13}).x
    tip = end(clamp)[:3] - np.array([l, 0, 0])
    plain = BeamEffects(plate=False, warping=False, long_fibres=False)
    errors = [
        np.max(np.abs(princeton(load, angle, effects=plain, levels=(n,)).coordinates[0, :3] - tip))
        for n in (4, 6, 8, 12)
    ]
    assert errors[-1] < 1e-9 * np.max(np.abs(tip))
    # twice as many nodes, 2⁸ times less at least
    assert errors[2] < errors[0] / 256
    assert errors[3] < errors[1] / 256


@pytest.mark.parametrize("ratio", [0.02, 0.1, 0.5])
def test_restrained_twist_is_the_closed_form_for_small_torques(ratio):
    l, h = 0.1, 0.2e-3
    b = ratio * l
    K = float(restrained_stiffness(E=E, G=G, h=h, b=b, l=l))
    state = solve(
        strip(h=h, b=b, l=l), loads=[SpaceLoad("tip", (l, 0, 0), moment=(1e-6 * K, 0, 0))]
    )
    assert state.checked().coordinates[0, 3] == pytest.approx(1e-6, rel=1e-7)


def test_long_fibres_stiffen_a_twisted_strip_as_its_differential_equation_says():
    """``EΓ τ''/a² = GJ τ/a + W τ³ − T`` with τ = 0 at the clamps, besides ``T/(G I_p)``.

    By finite differences; a = 1 − J/I_p.
    """
    l, b, h, angle = 0.1, 50e-3, 0.5e-3, np.deg2rad(5.0)
    nu = STEEL.nu
    warping = E / (1.0 - nu**2) * float(section_warping(h, b)[0])
    GJ = G * float(torsion_constant(h, b))
    fourth = (b**5 * h + b * h**5) / 80.0 + b**3 * h**3 / 72.0
    polar = (b * h**3 + h * b**3) / 12.0
    apart = 1.0 - GJ / (G * polar)
    GJ, warping = GJ / apart, warping / apart**2
    W = E / 2.0 * (fourth - polar**2 / (b * h))

    def slope(s, y, p):
        beside = p[0] * 1e-2 / (G * polar) + 0 * s
        return np.stack([y[1] + beside, y[2], (GJ * y[1] + W * y[1] ** 3 - p[0] * 1e-2) / warping])

    def ends(start, end, p):
        return np.array([start[0], start[1], end[1], end[0] - angle])

    s = np.linspace(0.0, l, 400)
    guess = np.stack([s / l * angle, 0 * s + angle / l, 0 * s])
    by_differences = solve_bvp(slope, ends, s, guess, p=[1.0], tol=1e-8, max_nodes=20000)
    assert by_differences.success
    held = {"tip": (None, None, None, angle, None, None)}
    state = solve(strip(h=h, b=b, l=l), held).checked()
    assert state.reactions[0, 3] == pytest.approx(by_differences.p[0] * 1e-2, rel=1e-6)
    # it shortens as its fibres ask, and is far stiffer than without them
    soft = solve(strip(h=h, b=b, l=l), held, effects=BeamEffects(long_fibres=False)).checked()
    uncurled = solve(strip(h=h, b=b, l=l), held, effects=BeamEffects(curling=False)).checked()
    assert uncurled.reactions[0, 3] == pytest.approx(state.reactions[0, 3], rel=1e-9)
    assert state.reactions[0, 3] > 1.4 * soft.reactions[0, 3]
    assert state.coordinates[0, 0] < 0.0 == soft.coordinates[0, 0]


def test_at_rest_a_blade_has_the_factors_of_its_plate_and_its_sheet():
    l, b, h = 0.1, 50e-3, 1e-6
    state = solve(strip(h=h, b=b, l=l))
    K = body_stiffness(state, "tip", (l / 2.0, 0, 0))
    at = {"b": b, "l": l, "poisson_ratio": STEEL.nu}
    EI = E * b * h**3 / 12.0
    assert K[5, 5] / (EI / l) == pytest.approx(pure_bending_factor(**at, h=h), rel=1e-9)
    assert K[1, 1] / (12.0 * EI / l**3) == pytest.approx(guided_factor(**at, h=h), rel=1e-9)
    assert K[0, 0] / (E * b * h / l) == pytest.approx(axial_factor(**at), rel=1e-9)
    sheared = 1.0 + 2.4 * (1.0 + STEEL.nu) * (b / l) ** 2
    across = E * h * b**3 / l**3 / sheared
    assert K[2, 2] / across == pytest.approx(sheet_guided_factor(**at), rel=1e-9)


def test_a_turned_mechanism_moves_alike():
    R = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()
    one, shift = guide(), np.array([0.3, -0.2, 0.5])
    other = turned(one, R, shift)
    load = SpaceLoad("stage", (0.02, 0.11, 0.03), (3.0, -40.0, 25.0))
    there = load._replace(point=tuple(R @ load.point + shift), force=tuple(R @ load.force))
    states = [
        solve(layout, {"stage": (0.01, *(None,) * 5)}, loads=[pull],
              frames=drive_frame(layout.drive)).checked()
        for layout, pull in ((one, load), (other, there))
    ]  # fmt: skip
    point = (0.0, 0.05, 0.01)
    here = states[0].motion_of("stage", point)
    moved = states[1].motion_of("stage", tuple(R @ point + shift))
    assert R @ here[:3] == pytest.approx(moved[:3], abs=1e-12)
    assert R @ here[3:] == pytest.approx(moved[3:], abs=1e-11)
    assert states[0].reactions[0, 0] == pytest.approx(states[1].reactions[0, 0], rel=1e-9)


def test_the_error_falls_by_more_than_the_sixth_power_of_the_nodes():
    held = {"two": (None, None, None, 0.02, -0.04, 0.1)}
    smooth = BeamEffects(curling=False)
    true = solve(askew(), held, loads=LOADS, effects=smooth, levels=(32,)).end_forces
    counts = np.array([8, 12, 16, 20])
    errors = [
        np.max(
            np.abs(
                solve(askew(), held, loads=LOADS, effects=smooth, levels=(int(n),)).end_forces
                / true
                - 1.0
            )
        )
        for n in counts
    ]
    rates = -np.diff(np.log(errors)) / np.diff(np.log(counts))
    assert np.all(rates > 6.0)


def test_the_path_leads_to_one_state_from_rest_and_from_another_state():
    held = {"two": (None, None, None, None, None, 0.2)}
    there = solve(askew(), held, loads=LOADS).checked()
    other = solve(askew(), {"one": (1e-3, None, None, None, 0.02, None)}).checked()
    again = solve(askew(), held, loads=LOADS, start=other).checked()
    assert again.coordinates == pytest.approx(there.coordinates, rel=1e-8, abs=1e-12)


def test_what_a_state_becomes_is_off_by_the_square_of_the_change():
    held, levels = {"out": (None, None, None, None, None, 0.2)}, {"levels": (12,)}
    known = solve(in_both(Constant(0.1e-3), 5e-3)[1], held, **levels)

    def off(change):
        _, layout = in_both(Constant(0.1e-3 * (1.0 + change)), 5e-3, delta=0.2 + change)
        become = beside(known, layout, held, frames={})
        true = solve(layout, held, **levels)
        return abs(become.reactions[0, 5] / true.reactions[0, 5] - 1.0)

    steps = np.array([4e-2, 2e-2, 1e-2, 5e-3])
    rates = np.diff(np.log([off(step) for step in steps])) / np.diff(np.log(steps))
    assert rates == pytest.approx(2.0, abs=0.2)


@pytest.mark.slow
def test_loads_and_springs_are_in_balance_with_the_blades():
    """Virtual work of the energy of a spring and the loads: the reactions of a body held whole."""
    layout = askew()
    loads = [LOADS[0]]
    held = {"one": (2e-5, 1e-5, -1e-4, 0.02, 0.01, -0.01), "two": (0.0,) * 6}
    (spring,) = layout.springs
    with_all = solve(layout, held, loads=loads).checked()
    bare = solve(replace(layout, springs=()), held).checked()
    frame = Rotation.from_rotvec(held["one"][3:])

    def energy(values):
        R = Rotation.from_rotvec(values[3:])
        at = layout.body("one").point

        def moved(point):
            arm = np.subtract(point, at)
            return values[:3] + R.apply(arm) - arm

        k = np.array(spring.stiffness)
        found = 0.5 * np.sum(k[:3] * moved(spring.point) ** 2) + 0.5 * np.sum(
            k[3:] * values[3:] ** 2
        )
        return found - np.dot(loads[0].force, moved(loads[0].point))

    values, slope = np.array(held["one"]), np.zeros(6)
    for i, step in enumerate(np.repeat([1e-7, 1e-6], 3)):
        ahead = np.eye(6)[i] * step
        slope[i] = (energy(values + ahead) - energy(values - ahead)) / (2.0 * step)
    # the moment is about fixed axes: its work on the rotation vector is that of the spin
    for i in range(3):
        ahead = np.eye(3)[i] * 1e-6
        spin = Rotation.from_rotvec(values[3:] + ahead) * frame.inv()
        slope[3 + i] -= spin.as_rotvec() @ loads[0].moment / 1e-6
    difference = with_all.reactions[0] - bare.reactions[0]
    assert difference == pytest.approx(slope, rel=1e-5, abs=1e-6)


def test_a_frame_states_the_motion_of_a_body_by_another_point_and_axes():
    layout = guide()
    axes = Rotation.from_rotvec([0.0, 0.0, 0.3]).as_matrix()
    frame = {"stage": Frame((0.0, 0.02, 0.0), axes)}
    state = solve(layout, {"stage": (5e-3, *(None,) * 5)}, frames=frame).checked()
    shift = state.motion_of("stage", (0.0, 0.02, 0.0))[:3]
    assert axes[0] @ shift == pytest.approx(5e-3, rel=1e-12)


@pytest.mark.parametrize("profile", VARYING)
def test_a_blade_of_varying_thickness_is_that_of_its_integrals_at_rest(profile):
    l, b = 20e-3, 5e-3
    layout = strip(h=1e-4, b=b, l=l)
    layout = replace(layout, blades=(replace(layout.blades[0], profile=profile),))
    free = BeamEffects(plate=False, warping=False)
    springs = blade_springs(profile=profile, l=l, b=b, E=E, G=G)
    rows = deformation_rows(springs, (l, 0.0, 0.0))
    K = rows.T @ np.diag(springs.stiffness) @ rows
    size = np.sqrt(np.outer(np.diag(K), np.diag(K)))
    found = body_stiffness(solve(layout, effects=free, levels=(40,)), "tip", (l, 0, 0))
    assert np.max(np.abs(found - K) / size) < 1e-8
    held = body_stiffness(solve(layout, levels=(40,)), "tip", (l, 0, 0))
    assert np.all(np.linalg.eigvalsh((held - found) / size) > -1e-9)


def test_the_warping_of_a_taper_is_held_back_as_its_differential_equation_says():
    """``(E'Γ f')' = G (I_p − J)(f − φ')``, ``T = G I_p φ' − G (I_p − J) f``, f = 0 at the ends."""
    l, b, thick, thin = 20e-3, 10e-3, 2e-3, 0.5e-3
    layout = strip(h=1e-4, b=b, l=l)
    taper = Tabulated((0.0, 1.0), (thick, thin))
    layout = replace(layout, blades=(replace(layout.blades[0], profile=taper),))
    unit = G * b * thick**3

    def slope(t, y, p):
        h = thick + t * (thin - thick)
        polar = G * (b * h**3 + h * b**3) / 12.0 / unit
        apart = polar - G * torsion_constant(h, b) / unit
        warped = E / (1.0 - STEEL.nu**2) * section_warping(h, b)[0] / (unit * l**2)
        rate = (p[0] + apart * y[1]) / polar
        return np.stack([rate, y[2] / warped, apart * (y[1] - rate)])

    def ends(start, end, p):
        return np.array([start[0], start[1], end[1], end[0] - 1.0])

    t = np.linspace(0.0, 1.0, 400)
    by_differences = solve_bvp(slope, ends, t, np.stack([t, t * (1 - t), 0 * t]), p=[0.1], tol=1e-8)
    assert by_differences.success
    found = body_stiffness(solve(layout, levels=(32,)), "tip", (l, 0, 0))[3, 3]
    assert found == pytest.approx(by_differences.p[0] * unit / l, rel=1e-6)


def test_a_body_that_nothing_holds_has_no_answer():
    layout = guide()
    loose = layout.bodies[0]._replace(name="loose")
    state = solve(replace(layout, bodies=(*layout.bodies, loose)))
    assert state.outcome is Outcome.SINGULAR
    with pytest.raises(SolveError, match="hold or support every body"):
        state.checked()
