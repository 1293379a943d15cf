from dataclasses import replace

import numpy as np
import pytest
import yaml
from geometries_for_tests import geometry
from space_mechanisms import STEEL, blade, guide, random_mechanism, rod

import flexcli
from flexcli.formulas.profile import Constant, Filleted, Notch
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import solve as solve_in_space
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.layout import (
    BeamEffects,
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceLoad,
)
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.space.states import Stresses
from flexcli.mechanics.space.stresses import equivalent
from flexcli.mechanics.stresses import blade_stress
from flexcli.parts.elastic import Elastic
from flexcli.parts.scene import NO_WRENCH, LoadKind, Scene
from flexcli.parts.space_joint import SpaceJoint
from flexcli.parts.space_misfits import misfit_stresses
from flexcli.parts.space_states import motions, stress_places
from flexcli.parts.strained_compliance import sag
from flexcli.parts.stress_across import across_stress
from flexcli.spec.load import load_shipped

FLAT = Elastic(114e9, 0.0)
SCENE = Scene(
    case="", travel=0.0, mean_travel=0.0, middle=0.0, cycles=None, force=0.0, force_name="",
    axial_share=0.0, ends=None, ends_why="", acceleration=0.0, axis="", vibration=None,
    shock=None, lock=None, wrench=None, forces=(), values={}, in_space=True,
)  # fmt: skip


def moved(travel, **given):
    return SCENE._replace(travel=travel, **given)


def largest(joint, scene):
    places, error = stress_places(joint, scene)
    return max(place.amplitude + abs(place.mean) for place in places), error


def test_a_guide_bends_by_three_times_its_plate_modulus_h_over_l_squared():
    l, h, x = 0.1, 0.2e-3, 1e-3
    flat = STEEL._replace(G=STEEL.E / 2.0)  # ν = 0: no plate, and no shear to speak of
    found, error = largest(SpaceJoint(guide(l=l, h=h, material=flat)), moved(x))
    bending = 3.0 * flat.E * h * x / l**2
    # the moment at the blades' ends pulls and pushes them besides
    axial = flat.E * h**3 / l**2 * x / l / (0.1 * h) * l
    assert found == pytest.approx(bending + axial, rel=1e-3)
    assert error is not None
    assert error.largest < 0.02


def test_a_weight_bends_a_blade_as_a_beam_between_clamps():
    # held all around by stiff rods, so that nothing but the blade's own weight bends it
    l, h, b = 0.1, 0.2e-3, 0.01
    one = blade("b", "ground", "body", (0, 0, 0), (l, 0, 0), width=(0, 0, 1.0), h=h, b=b)
    ends = [((l, 0, 0), (l, 0.01 * s, 0.01 * c)) for s, c in ((1, 1), (-1, 1), (1, -1), (-1, -1))]
    rods = [
        rod(f"r{i}", "ground", "body", end, start, d=4e-3, material=STEEL._replace(density=0.0))
        for i, (start, end) in enumerate(ends)
    ]
    body = SpaceBody("body", (l, 0.0, 0.0), (l, 0.0, 0.0))
    layout = SpaceLayout((body,), (one, *rods), Drive("body", False, (1.0, 0, 0), body.point))
    scene = SCENE._replace(inertial=(NO_WRENCH,), accelerations=((0.0, 98.1, 0.0),))
    places, _ = stress_places(SpaceJoint(layout), scene)
    worst = max(abs(p.mean) for p in places if p.where.startswith("b,"))
    # w l²/12 over b h²/6
    assert worst == pytest.approx(7800.0 * h * 98.1 * l**2 / 12.0 * 6.0 / h**2, rel=1e-3)


JOINTS = {
    "rcc": 0.08, "cross-spring": 0.15, "three-blade": 0.05, "unseparated-cross": 0.1, "star": 0.05,
    "leaf-spring-stage": 2e-3, "cantilever": 3e-3, "guided-blade": 2e-3,
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("kind", JOINTS)
def test_the_error_of_a_stress_holds_against_the_exact_model_of_the_plane(kind):
    # without Poisson's ratio the exact planar model is the truth
    joint = geometry(kind)
    layout, turns = joint.layout(FLAT, joint.probe()), joint.motion == "rotation"
    layout = replace(layout, blades=tuple(replace(blade, z=0.0) for blade in layout.blades))
    known = 0
    for share in (0.05, 0.2, 0.5, 1.0):
        travel = share * JOINTS[kind]
        there = SpaceJoint(from_plane(layout, "moving", turns=turns))
        found, error = largest(there, moved(travel))
        exact = 0.0
        for end in (travel, -travel):
            state = solve(layout, {"moving": (None, None, end) if turns else (None, end, None)})
            for each in layout.blades:
                stress = blade_stress(state, each.name, 65)
                exact = max(exact, *(float(np.abs(f).max()) for f in (stress.left, stress.right)))
        if error is not None:
            known += 1
            assert error.low <= exact / found - 1.0 <= error.high
    assert known >= 1  # an estimate that nobody ever has is none


@pytest.mark.parametrize("kind", JOINTS)
def test_the_error_of_a_motion_holds_against_the_exact_model_of_the_plane(kind):
    joint = geometry(kind)
    layout, turns = joint.layout(FLAT, joint.probe()), joint.motion == "rotation"
    layout = replace(layout, blades=tuple(replace(blade, z=0.0) for blade in layout.blades))
    rows = np.eye(6)[[0, 1]]
    for share in (0.1, 0.4):
        travel = share * JOINTS[kind]
        there = SpaceJoint(from_plane(layout, "moving", turns=turns))
        both = motions(there, moved(travel), load_shipped("material", "ti-6al-4v"), 0.0)
        for motion, end in zip(both, (travel, -travel), strict=True):
            state = solve(layout, {"moving": (None, None, end) if turns else (None, end, None)})
            exact = state.motions[0, layout.index("moving"), :2]
            value, off = motion.at((0.0, 0.0, 0.0), rows)
            assert np.all(np.abs(value - exact) <= off + 1e-15)


def test_far_out_nobody_knows_the_stress():
    joint = geometry("leaf-spring-stage")
    layout = joint.layout(FLAT, joint.probe())
    there = SpaceJoint(from_plane(layout, "moving", turns=False))
    assert largest(there, moved(10e-3))[1] is None


@pytest.mark.parametrize("seed", range(4))
def test_loads_either_way_and_a_stroke_add_up_at_their_worst(seed):
    rng = np.random.default_rng(seed)
    joint = SpaceJoint(random_mechanism(rng))
    wrench = tuple(float(w) for w in rng.normal(size=6) * [1, 1, 1, 0.01, 0.01, 0.01])
    one, _ = largest(joint, moved(1e-5))
    other, _ = largest(joint, SCENE._replace(stated=wrench))
    both, _ = largest(joint, moved(1e-5, stated=wrench))
    assert max(one, other) <= both * (1.0 + 1e-12)
    assert both <= (one + other) * (1.0 + 1e-12)


def test_a_misfit_along_a_blade_pulls_it_and_pushes_what_stands_against_it():
    # two rods in a row with a rigid body between, one of them too long by δ: σ = E δ/2l
    a = rod("a", "ground", "body", (0, 0, 0), (0.05, 0, 0), d=1e-3)
    b = rod("b", "body", "ground", (0.05, 0, 0), (0.1, 0, 0), d=1e-3)
    body = SpaceBody("body", (0.05, 0.0, 0.0), (0.05, 0.0, 0.0))
    layout = SpaceLayout((body,), (a, b), Drive("body", False, (0, 0, 1.0), body.point))
    (found,) = misfit_stresses(SpaceJoint(layout), [0], (1e-6, 0.0, 0.0, 0.0, 0.0, 0.0))
    assert found.stress == pytest.approx(STEEL.E * 1e-6 / 0.1, rel=1e-9)
    assert "a being off" in found.where


def test_a_free_misfit_costs_nothing_but_the_bending_of_the_free_motions():
    # a single blade holds its body whatever its seat is
    one = blade("b", "ground", "body", (0, 0, 0), (0.05, 0, 0))
    body = SpaceBody("body", (0.05, 0.0, 0.0), (0.05, 0.0, 0.0))
    layout = SpaceLayout((body,), (one,), Drive("body", False, (0, 1.0, 0), body.point))
    off = (1e-5, 1e-5, 1e-5, 1e-3, 1e-3, 1e-3)
    (found,) = misfit_stresses(SpaceJoint(layout), [0], off)
    assert found.stress < 1e-6 * STEEL.E


def test_a_body_sags_by_its_weight_over_the_stiffness_and_half_that_of_its_blades():
    scene = SCENE._replace(
        acceleration=9.81, axis="z", inertial=(NO_WRENCH,), accelerations=((0.0, 0.0, 9.81),)
    )
    light = guide(material=STEEL._replace(density=0.0))
    joint = SpaceJoint(light)
    body = light.bodies[0]
    C = joint.assembly.compliance("stage", body.point, locked=False)
    found = sag(joint, scene)
    assert found.value == pytest.approx(9.81 * C[2, 2], rel=1e-9)
    assert found.error is not None
    heavy = sag(SpaceJoint(guide()), scene).value
    assert 1.0 < heavy / found.value < 1.0 + 2.0 * 7800 * 0.5e-3 * 0.05 * 0.1


def exact_largest(layout, travel, loads=()):
    """Return the largest stress of exact beams in space, the drive at a travel."""
    held = [None] * 6
    held[3 if layout.drive.turns else 0] = travel
    state = solve_in_space(
        layout,
        {layout.drive.body: tuple(held)},
        frames=drive_frame(layout.drive),
        loads=loads,
        effects=BeamEffects(curling=False),  # blades here bend too little to curl
        tolerance=1e-6,
    ).checked()
    found = 0.0
    for stress in blade_stresses(state):
        direct = np.abs(stress.axial) + np.abs(stress.bend_thin)
        face = np.hypot(direct, np.sqrt(3.0) * stress.shear)
        found = max(found, float(np.abs(stress.corner).max()), float(face.max()))
    return found


@pytest.mark.parametrize(("seed", "travel"), [(1, 1e-4), (1, 5e-4), (6, 2e-3), (7, 1e-4)])
def test_the_error_of_a_stress_holds_against_exact_beams_in_space(seed, travel):
    layout = random_mechanism(np.random.default_rng(seed))
    found, error = largest(SpaceJoint(layout), moved(travel))
    exact = max(exact_largest(layout, end) for end in (travel, -travel))
    assert error is not None
    assert error.low <= exact / found - 1.0 <= error.high


ACROSS = {
    "force": (0.0, 0.0, 1.0, 0.0, 0.0, 0.0),
    "tilt": (0.0, 0.0, 0.0, 5e-3, 0.0, 0.0),
    "both": (0.0, 0.0, 0.5, 0.0, 5e-3, 0.0),
}


@pytest.mark.parametrize("load", ACROSS)
@pytest.mark.parametrize(
    ("kind", "travel"), [("leaf-spring-stage", 5e-4), ("rcc", 0.03), ("cross-spring", 0.06)]
)
def test_loads_out_of_the_plane_add_no_more_than_exact_beams_say(kind, travel, load):
    joint = geometry(kind)
    flat = joint.layout(Elastic(114e9, 0.3), joint.probe())
    layout = from_plane(flat, "moving", turns=joint.motion == "rotation")
    there, point = SpaceJoint(layout), layout.body("moving").point
    across = frozenset({LoadKind.WRENCH})
    # well below what turns the blades aside, beyond which no such error is told
    scale = 20e6 / across_stress(there, SCENE._replace(stated=ACROSS[load])).value
    wrench = tuple(scale * component for component in ACROSS[load])
    found = across_stress(there, moved(travel, stated=wrench, across_by=across))
    planar = exact_largest(layout, travel)
    exact = max(
        exact_largest(
            layout,
            travel,
            (SpaceLoad("moving", point, tuple(s * w for w in wrench[:3]),
                       tuple(s * w for w in wrench[3:])),),
        )
        for s in (1.0, -1.0)
    )  # fmt: skip
    assert found.error is not None
    lower = max(planar, found.value * (1.0 + found.error.low))
    # a corner's stress and the equivalent one of faces differ by little in the sum
    assert 0.99 * lower <= exact <= planar + found.value * (1.0 + found.error.high)


@pytest.mark.parametrize("force", [0.0, 2.0])
def test_a_moment_in_the_plane_makes_a_force_across_it_twist_the_blade(force):
    # a strip that M_z bends by y = M l²/2EI at its tip bears the torque F_z y at its root
    l, h, b, E = 20e-3, 0.1e-3, 2e-3, 114e9
    strip = SpaceBlade(
        "s", "ground", "b", (0.0, 0.0, 0.0), (l, 0.0, 0.0), (0, 0, 1), Constant(h), b,
        Isotropic(E, E / 2.0),
    )  # fmt: skip
    tip = (l, 0.0, 0.0)
    layout = SpaceLayout((SpaceBody("b", tip, tip),), (strip,), Drive("b", True, (0, 0, 1), tip))
    there, across = SpaceJoint(layout), 0.02
    moment = 0.2 * E * b * h**3 / 12.0 / l
    scene = SCENE._replace(
        stated=(force, 0.0, across, 0.0, 0.0, moment), across_by=frozenset({LoadKind.WRENCH})
    )
    found = across_stress(there, scene)
    torque = across * moment * l**2 / (2.0 * E * b * h**3 / 12.0)
    forces = np.zeros(9)
    forces[2], forces[3], forces[4] = across, torque, -across * l / 2.0
    twisted = Stresses(there.assembly).rows[0]
    true = np.max(equivalent(twisted.normal @ forces, twisted.shear @ forces))
    alone = across_stress(there, SCENE._replace(stated=(0.0, 0.0, across, 0.0, 0.0, 0.0)))
    assert true > 1.05 * alone.value
    if force == 0.0:
        assert true <= found.value * (1.0 + found.error.high)
    else:  # it nearly doubles what bends the strip
        assert found.error is None or found.error.high > 0.1


def test_blades_that_cross_at_different_heights_leave_the_plane_under_a_force_in_it():
    # each bears N along itself, at heights ±b/2: their couple 2 N sin α b/2 tilts the body
    joint = geometry("cross-spring")
    elastic = Elastic(114e9, 0.3)
    layout = joint.space_layout(elastic, joint.probe())
    wrench = (5.0, 0.0, 0.0, 1e-4, 0.0, 0.0)
    scene = SCENE._replace(stated=wrench, across_by=frozenset({LoadKind.WRENCH}))
    assert across_stress(SpaceJoint(layout), scene).error is None
    tilted = SCENE._replace(stated=(0.0, 0.0, 0.0, 1e-4, 0.0, 0.0), across_by=scene.across_by)
    assert across_stress(SpaceJoint(layout), tilted).error is not None


def test_at_rest_a_force_out_of_the_plane_bends_the_widths():
    # three blades between bodies that do not turn: F l/2 on each, over h b²/6
    joint = geometry("leaf-spring-stage")
    layout = from_plane(joint.layout(Elastic(114e9, 0.3), joint.probe()), "moving", turns=False)
    found = across_stress(SpaceJoint(layout), SCENE._replace(stated=ACROSS["force"]))
    assert found.value == pytest.approx(1.0 / 3.0 * 10e-3 / (0.1e-3 * 5e-3**2 / 6.0), rel=1e-9)
    assert found.error.largest < 0.05


@pytest.mark.parametrize("angle", [0.0, 0.05, 0.15])
def test_a_moment_on_a_turned_notch_twists_its_throat_too(angle):
    # the throat turns by half as much as the body, and bears what acts on that; its two flanks turn
    # by less and by more, so that their torques differ and the throat warps besides
    joint = geometry("notch-hinge")
    layout = from_plane(joint.layout(Elastic(114e9, 0.3), joint.probe()), "moving", turns=True)
    there, moment = SpaceJoint(layout), 1e-3
    acting = (0.0, 0.0, 0.0, 0.0, moment, 0.0)
    scene = SCENE._replace(stated=acting)
    if angle:
        scene = moved(angle, stated=acting, across_by=frozenset({LoadKind.WRENCH}))
    found = across_stress(there, scene)
    at_rest = Stresses(there.assembly).rows[0]
    forces = np.zeros(9)
    forces[3:5] = moment * np.sin(angle / 2.0), moment * np.cos(angle / 2.0)
    expected = np.max(equivalent(at_rest.normal @ forces, at_rest.shear @ forces))
    assert 0.99 < found.value / expected < (1.2 if angle else 1.01)
    assert -0.5 < found.error.low < 0.0 < found.error.high < 0.5


SWINGING = [
    (Notch(0.0865, 1.0), 2.0, 2.193, 0.4, 0.0366, (0.0264, 0.0246, 0.0756)),
    (Notch(0.0622, 1.0), 2.0, 1.113, 0.4, 0.0568, (0.0416, 0.0376, 0.1229)),
    (Notch(0.0724, 1.0), 2.0, 1.939, 0.3, 0.1030, (0.0740, 0.0686, 0.2282)),
    (Notch(0.1234, 1.0), 2.0, 1.298, 0.2, 0.0678, (0.0512, 0.0464, 0.0888)),
    (Notch(0.1936, 1.0), 2.0, 1.951, 0.3, 0.0265, (0.0200, 0.0198, 0.0339)),
    (Filleted(0.7562, 1.0), 9.21, 1.784, 0.4, 0.2016, (0.0842, 0.1624, 0.1844)),
    (Filleted(0.5269, 1.0), 7.80, 1.509, 0.3, 0.1382, (0.0667, 0.1117, 0.1576)),
]
"""Hinges, lengths, widths, ν, and by which share of their stress V_z, T and M_y alternate as a
stroke turns them from rest to an angle [rad]: ``tests/benchmarks/hinges_at_stroke.py``."""


@pytest.mark.parametrize(
    "row",
    [pytest.param(row, marks=[] if k in (0, 3, 6) else pytest.mark.slow)
     for k, row in enumerate(SWINGING)],
)  # fmt: skip
def test_loads_across_a_hinge_alternate_no_more_than_they_are_told_to(row):
    profile, l, b, nu, turn, shares = row
    ends, middle = ((0.0, 0.0, 0.0), (l, 0.0, 0.0)), (l / 2.0, 0.0, 0.0)
    hinge = SpaceBlade(
        "h", "ground", "b", *ends, (0, 0, 1), profile, b, Isotropic(2e11, 1e11 / (1.0 + nu))
    )
    layout = SpaceLayout(
        (SpaceBody("b", middle, middle),), (hinge,), Drive("b", True, (0, 0, 1), middle)
    )
    for k, share in enumerate(shares):
        load = np.zeros(6)
        load[2 + k] = 1e4
        scene = moved(
            turn / 2.0, mean_travel=turn / 2.0, middle=turn / 2.0,
            stated=tuple(load.tolist()), across_by=frozenset({LoadKind.WRENCH}),
        )  # fmt: skip
        found = across_stress(SpaceJoint(layout), scene)
        most = found.value * (1.0 + found.error.high)
        assert share < found.swings / most < 2.0 * share + turn


@pytest.mark.parametrize("kind", ["hinged-stage", "hinged-pivot"])
def test_the_stress_of_loads_out_of_the_plane_of_hinges_is_told_to_a_half(kind):
    there = flat(kind)
    found = across_stress(there, SCENE._replace(stated=ACROSS["both"]))
    scale = 50e6 / found.value
    acting = tuple(scale * component for component in ACROSS["both"])
    travel = 0.02 if kind != "hinged-stage" else 5e-4
    far = across_stress(there, moved(travel, stated=acting, across_by=frozenset({LoadKind.WRENCH})))
    for each in (found, far):
        assert -0.5 < each.error.low < 0.0 < each.error.high < 0.6
    assert far.value > 0.98 * 50e6


def strained(joint, wrenches):
    """Return the deformations of all springs under wrenches at the moving body (springs, n)."""
    body = joint.layout.body(joint.layout.drive.body)
    rows = joint.assembly.motion(body.name, body.point)
    return joint.assembly.moved(rows.T @ wrenches).deformations


def flat(kind):
    joint = geometry(kind)
    planar = joint.layout(Elastic(114e9, 0.3), joint.probe())
    return SpaceJoint(from_plane(planar, "moving", turns=joint.motion == "rotation"))


@pytest.mark.parametrize("kind", ["rcc", "cross-spring", "cantilever", "star", "any"])
def test_a_motion_under_a_load_lies_within_its_error_whatever_the_springs_are(kind):
    rng = np.random.default_rng(11)
    joint = SpaceJoint(random_mechanism(rng)) if kind == "any" else flat(kind)
    loads = rng.normal(size=(6, 6)) * np.array([1.0, 1.0, 1.0, 0.01, 0.01, 0.01])[:, None]
    d, k = strained(joint, loads), joint.assembly.stiffness
    for _ in range(40):
        ends = np.where(rng.random(len(k)) < 0.5, joint.low, np.minimum(joint.high, 1e3))
        other = SpaceJoint(joint.layout)
        other.assembly = joint.assembly.scaled(1.0 + ends)
        now = strained(other, loads)
        for g in range(3):
            for f in range(3, 6):
                form = joint.form(d[:, g], d[:, f])
                change = float(k * (1.0 + ends) @ (now[:, g] * now[:, f])) - form.found
                low, high = form.off
                assert low - 1e-9 * form.work <= change <= high + 1e-9 * form.work


@pytest.mark.parametrize("kind", ["rcc", "cantilever", "star"])
def test_a_load_in_the_plane_makes_no_motion_out_of_it_less_sure(kind):
    joint = flat(kind)
    across, along = np.eye(6)[2], 1e3 * np.eye(6)[[0, 1, 5]].sum(axis=0)
    d = strained(joint, np.stack([across, along, across + along], axis=1))
    alone, both = (joint.form(d[:, 0], d[:, i]) for i in (0, 2))
    assert both.found == pytest.approx(alone.found, rel=1e-9)
    assert both.off == pytest.approx(alone.off, rel=1e-6)
    assert joint.form(d[:, 0], d[:, 1])[:2] == (0.0, (0.0, 0.0))


@pytest.mark.parametrize("force", ["-0.017 N", "-0.005 N", "-1e-5 N"])
def test_a_torque_beside_a_force_moves_necked_blades_along_it_in_second_order(force):
    """All of it, where the force is small."""
    spec = yaml.safe_dump(
        {
            "flexure": 1,
            "material": {"youngs_modulus": "114 GPa", "poisson_ratio": 0.0},
            "geometry": {"kind": "necked-down-stage", "h": "0.14 mm", "l": "4.06 mm",
                         "b": "0.2346 mm", "l_c": "1.71 mm", "blades": 2, "spacing": "2.85 mm"},
            "cases": {"work": {"wrench": {"y": force, "theta_x": "6.8e-6 N*m"}}},
            "requirements": {"deflection": {"direction": "y", "max": "1 m"}},
        }
    )  # fmt: skip
    closed, exact = (
        flexcli.verdicts(spec, model=model).checks[-1] for model in ("closed-form", "exact")
    )
    if closed.factor_range is None:
        assert exact.factor < 0.7 * closed.factor
        return
    assert closed.factor_range[0] <= exact.factor <= closed.factor_range[1]
