from dataclasses import replace

import numpy as np
import pytest
from geometries_for_tests import geometry
from scipy.optimize import brentq
from space_mechanisms import (
    STEEL,
    blade,
    guide,
    random_mechanism,
    rod,
    rotation,
    turned,
)

from flexcli.formulas.rigid_motion import motion_at
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.space.layout import Drive, SpaceBody, SpaceLayout, SpaceLoad
from flexcli.mechanics.space.linear import assemble
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.space.second_order import second_order, stiffened_by_loads
from flexcli.parts.elastic import Elastic

FLAT = Elastic(114e9, 0.0)


def at_travel(layout, travel):
    assembly = assemble(layout)
    found = assembly.moved(travel=np.array([travel]))
    return assembly, found, second_order(assembly, found, (), locked=True)


def test_a_guide_comes_down_by_three_fifths_of_its_travel_squared_over_its_length():
    _, _, after = at_travel(guide(l=0.1, h=0.05e-3), 2e-3)
    assert after.coordinates[1] == pytest.approx(-0.6 * 2e-3**2 / 0.1, rel=1e-5)  # shear, (h/l)²


def test_a_blade_in_pure_bending_is_an_arc():
    # the end at (sin θ, 1 − cos θ) l/θ: l − l θ²/6 along it
    one = rod("r", "ground", "tip", (0, 0, 0), (0.05, 0, 0))
    tip = SpaceBody("tip", (0.05, 0.0, 0.0), (0.05, 0.0, 0.0))
    layout = SpaceLayout((tip,), (one,), Drive("tip", True, (0.0, 0.0, 1.0), tip.point))
    _, found, after = at_travel(layout, 0.1)
    to_point = assemble(layout).motion("tip", tip.point)
    assert (to_point @ found.coordinates[:, 0])[1] == pytest.approx(0.05 * 0.05, rel=1e-9)
    assert (to_point @ after.coordinates)[0] == pytest.approx(-0.05 * 0.1**2 / 6.0, rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_bodies_that_turn_as_one_strain_nothing_to_second_order(seed):
    rng = np.random.default_rng(seed)
    layout = random_mechanism(rng)
    # between the two bodies alone; one of them on a soft rod, which the other follows
    link = layout.blades[1]
    theta = rng.normal(size=3) * 1e-2
    soft = STEEL._replace(E=1.0, G=0.4)
    stay = rod("stay", "ground", "a", (0, 0, 0), layout.body("a").point, material=soft)
    only = SpaceLayout(layout.bodies, (link, stay), layout.drive)
    assembly = assemble(only)
    a, b = only.bodies
    # the ends of the link as the bodies turn about a: no first-order deformation of it
    motion = np.concatenate([np.zeros(3), theta])
    d = np.concatenate([motion, motion_at(np.subtract(b.point, a.point)) @ motion])
    d[6:] = np.linalg.solve(assembly.to_body, d[6:])
    deformations = assembly.rows @ d[:, None]
    assert np.max(np.abs(deformations[:6])) < 1e-15
    moved = assembly.moved(np.zeros((12, 1)))._replace(
        coordinates=d[:, None], deformations=deformations,
        forces=assembly.stiffness[:, None] * deformations * np.r_[np.ones(6), np.zeros(6)][:, None],
    )  # fmt: skip
    after = second_order(assembly, moved, (), locked=False)
    arm = np.subtract(b.point, a.point)
    expected = np.cross(theta, np.cross(theta, arm)) / 2.0
    relative = assembly.motion("b", b.point) @ after.coordinates
    own = assembly.motion("a", a.point) @ after.coordinates
    found = relative[:3] - own[:3] - np.cross(own[3:], arm)
    assert found == pytest.approx(expected, abs=1e-6 * np.linalg.norm(expected))
    assert np.max(np.abs(relative[3:] - own[3:])) < 1e-6 * np.linalg.norm(theta) ** 2


@pytest.mark.parametrize("seed", range(3))
def test_a_turned_mechanism_has_the_same_second_order(seed):
    rng = np.random.default_rng(seed)
    layout, R = random_mechanism(rng), rotation(rng)
    other = turned(layout, R, rng.uniform(-0.1, 0.1, 3))
    found = []
    for each, way in ((layout, np.eye(3)), (other, R)):
        assembly = assemble(each)
        body = each.body("b")
        load = SpaceLoad("b", body.com, tuple(way @ (3.0, -2.0, 1.0)), tuple(way @ (0.1, 0.0, 0.1)))
        moved = assembly.moved(assembly.load(load)[:, None])
        after = second_order(assembly, moved, (load,), locked=False)
        motion = assembly.motion("b", body.point) @ after.coordinates
        found.append((np.kron(np.eye(2), way.T) @ motion, after.forces, after.rotation))
    size = np.abs(found[0][0]).max()
    assert found[1][0] == pytest.approx(found[0][0], abs=1e-7 * size)
    # of the four blades; the axes across a rod are any two
    blades = slice(0, 24)
    most = np.abs(found[0][1]).max()
    assert found[1][1][blades] == pytest.approx(found[0][1][blades], abs=1e-7 * most)
    assert found[1][2] == pytest.approx(found[0][2], rel=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_a_rod_cut_in_two_has_the_same_second_order(seed):
    # bent both ways and twisted, so that every product of rotations takes part; shear, which is
    # (d/l)² and depends on the length of a piece, is what they differ by
    rng = np.random.default_rng(seed)
    tip = SpaceBody("tip", (0.05, 0.0, 0.0), (0.05, 0.0, 0.0))
    mid = SpaceBody("mid", (0.02, 0.0, 0.0), (0.02, 0.0, 0.0))
    drive = Drive("tip", True, (1.0, 0.0, 0.0), tip.point)
    whole = rod("r", "ground", "tip", (0, 0, 0), tip.point, d=0.05e-3)
    parts = (
        rod("r1", "ground", "mid", (0, 0, 0), mid.point, d=0.05e-3),
        rod("r2", "mid", "tip", mid.point, tip.point, d=0.05e-3),
    )
    scale = STEEL.E * np.pi * 0.05e-3**4 / 64.0
    force = rng.normal(size=3) * scale / 0.05**2 * 0.1
    moment = rng.normal(size=3) * scale / 0.05 * 0.1
    load = SpaceLoad("tip", tip.point, tuple(force), tuple(moment))
    found = []
    for layout in (
        SpaceLayout((tip,), (whole,), drive),
        SpaceLayout((mid, tip), parts, drive),
    ):
        assembly = assemble(layout)
        moved = assembly.moved(assembly.load(load)[:, None])
        after = second_order(assembly, moved, (load,), locked=False)
        found.append(assembly.motion("tip", tip.point) @ after.coordinates)
    one, two = found
    assert two[:3] == pytest.approx(one[:3], abs=2e-4 * np.linalg.norm(one[:3]))
    assert two[3:] == pytest.approx(one[3:], abs=2e-4 * np.linalg.norm(one[3:]))


PLANAR = {
    "rcc": 0.05, "cross-spring": 0.05, "three-blade": 0.03, "unseparated-cross": 0.05,
    "leaf-spring-stage": 4e-4, "cantilever": 4e-4,
}  # fmt: skip
"""Joints and the travel at which the next order is some per cent of the second."""


@pytest.mark.parametrize("kind", PLANAR)
def test_a_planar_joint_moves_as_its_exact_model_to_second_order(kind):
    joint = geometry(kind)
    layout, turns = joint.layout(FLAT, joint.probe()), joint.motion == "rotation"
    layout = replace(layout, blades=tuple(replace(blade, z=0.0) for blade in layout.blades))
    errors = []
    for travel in (PLANAR[kind], PLANAR[kind] / 2.0):
        held = (None, None, travel) if turns else (None, travel, None)
        exact = solve(layout, {"moving": held})
        expected = exact.motions[0, layout.index("moving")]
        assembly, found, after = at_travel(from_plane(layout, "moving", turns=turns), travel)
        name, point = "moving", (*map(float, layout.body("moving").point), 0.0)
        both = assembly.motion(name, point) @ (found.coordinates[:, 0] + after.coordinates)
        errors.append(float(np.max(np.abs(both[[0, 1, 5]] - expected))))
        size = float(np.max(np.abs(expected)))
    # what is left is of third order or higher
    assert errors[1] < errors[0] / 6.0 or errors[0] < 1e-9 * size


def buckles_at(blade_, load):
    """Return the force at which a cantilever between the ground and its tip turns aside [N]."""
    tip = SpaceBody("tip", blade_.end, blade_.end)
    layout = SpaceLayout((tip,), (blade_,), Drive("tip", False, (0.0, 1.0, 0.0), tip.point))
    assembly = assemble(layout)
    moved = assembly.moved(assembly.load(load)[:, None])
    after = second_order(assembly, moved, (load,), locked=False)
    return np.linalg.norm(load.force) / after.buckling if after.buckling else np.inf


STRIP = {"h": 0.1e-3, "b": 2e-3, "material": STEEL._replace(G=STEEL.E / 2.0)}
EI = STEEL.E * 2e-3 * 0.1e-3**3 / 12.0
GJ = STEEL.E / 2.0 * 2e-3 * 0.1e-3**3 / 3.0 * (1.0 - 0.63 * 0.05)


@pytest.mark.parametrize("beyond", [0.0, 0.05, 0.2])
def test_a_column_with_a_lever_on_its_tip_buckles_where_its_sine_says(beyond):
    # the tip deflects by D cos β l, as a bar of this length leans by D β sin β l (ν = 0)
    strip, l = blade("s", "ground", "tip", (0, 0, 0), (0.1, 0, 0), **STRIP), 0.1
    load = SpaceLoad("tip", (l + beyond, 0.0, 0.0), (-1e-9, 0.0, 0.0))
    root = brentq(lambda x: np.cos(x) - x * beyond / l * np.sin(x), 1e-3, 2.0)
    assert buckles_at(strip, load) == pytest.approx(EI * (root / l) ** 2, rel=1e-4)


def test_a_strip_loaded_along_its_width_turns_aside_at_prandtl_s_load():
    # Prandtl (1899): 4.013 √(EI GJ)/l²; clamps keep the strip from warping over some b at its ends
    strip = blade("s", "ground", "tip", (0, 0, 0), (0.1, 0, 0), **STRIP)
    load = SpaceLoad("tip", (0.1, 0.0, 0.0), (0.0, 0.0, 1e-9))
    assert buckles_at(strip, load) == pytest.approx(4.013 * (EI * GJ) ** 0.5 / 0.1**2, rel=0.02)


def test_nothing_buckles_that_is_pulled():
    strip = blade("s", "ground", "tip", (0, 0, 0), (0.1, 0, 0), **STRIP)
    assert buckles_at(strip, SpaceLoad("tip", strip.end, (1e-3, 0.0, 0.0))) > 1e6 * EI / 0.1**2


def test_a_weight_that_stands_on_a_stage_or_a_lever_softens_it():
    # 6 F/(5 l) of the stage's blades together (Timoshenko); F s of a lever s on a stiff body
    layout, force = guide(l=0.1, h=0.5e-3), 1.0
    assembly = assemble(layout)
    pushed = SpaceLoad("stage", (0.0, 0.1, 0.0), (0.0, -force, 0.0))
    moved = assembly.moved(assembly.load(pushed)[:, None])
    along = assembly.moved(travel=np.ones(1)).coordinates[:, 0]
    found = stiffened_by_loads(assembly, moved, (pushed,), along)
    assert found == pytest.approx(-1.2 * force / 0.1, rel=1e-3)  # shear, (h/l)²
    turned = np.zeros(assembly.size)
    turned[5] = 1.0  # about the stage's own z, the blades' forces left out
    high = pushed._replace(point=(0.0, 0.3, 0.0))
    unloaded = moved._replace(forces=0.0 * moved.forces)
    levered = stiffened_by_loads(assembly, unloaded, (high,), turned)
    assert levered == pytest.approx(-force * 0.2, rel=1e-9)
