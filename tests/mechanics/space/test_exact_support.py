"""Tangents, support stiffness, frequencies, critical loads and stresses of exact beams in space."""

from dataclasses import replace

import numpy as np
import pytest
from layouts_in_space import INERTIA, LOADS, STEEL, askew, guide, rod, strip
from support import body_stiffness

from flexcli.formulas.plate_factors import guided_factor
from flexcli.formulas.restrained_torsion import restrained_stresses
from flexcli.formulas.torsion_section import torsion_constant
from flexcli.mechanics.space.exact import critical
from flexcli.mechanics.space.exact.critical import critical_load, straight_critical_factor
from flexcli.mechanics.space.exact.demand import Frame
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.exact.support import (
    support_compliance,
    unstable_when_free,
    vibration,
)
from flexcli.mechanics.space.layout import BeamEffects, SpaceLoad

E, G, nu = STEEL.E, STEEL.G, STEEL.nu
HELD = {"two": (None, None, None, 0.01, -0.02, 0.1)}
SMOOTH = BeamEffects(curling=False)


@pytest.mark.slow
def test_the_tangent_is_the_difference_of_reactions_and_symmetric():
    """Central differences of the reactions at a loaded pose without symmetry, springs and all."""
    loads = [load._replace(moment=(0.0, 0.0, 0.0)) for load in LOADS]
    how = {"loads": loads, "levels": (24,), "effects": SMOOTH}
    state = solve(askew(), HELD, **how).checked()
    point = (66e-3, 40e-3, 5e-3)
    K = body_stiffness(state, "two", point)
    frames = {"two": Frame(point, np.eye(3))}
    pose = state.motion_of("two", point)

    def reactions(motion):
        held = {"two": tuple(motion)}
        return solve(askew(), held, frames=frames, start=whole, **how).checked().reactions[1]

    whole = solve(askew(), {"two": tuple(pose)}, frames=frames, **how)
    at_rest_of_pose = np.zeros((6, 6))
    for i, step in enumerate(np.repeat([1e-7, 1e-5], 3)):
        ahead = np.eye(6)[i] * step
        at_rest_of_pose[i] = (reactions(pose + ahead) - reactions(pose - ahead)) / (2.0 * step)
    # the same in the coordinates of the rotation vector: symmetric since there is an energy
    scale = np.sqrt(np.abs(np.outer(np.diag(at_rest_of_pose), np.diag(at_rest_of_pose))))
    assert np.max(np.abs(at_rest_of_pose - at_rest_of_pose.T) / scale) < 1e-5
    by_shift = at_rest_of_pose[:3, :3]
    assert K[:3, :3] == pytest.approx(by_shift, rel=1e-5, abs=1e-6 * np.max(np.abs(by_shift)))
    assert pytest.approx(K.T, rel=1e-12) == K


@pytest.mark.parametrize(("effects", "nodes", "error"), [(SMOOTH, 40, 1e-8), (None, 40, 1e-3)])
def test_newtons_matrix_has_the_second_variation_as_its_symmetric_part(effects, nodes, error):
    """Two derivations: sections eliminated from their equations, and from the energy.

    They differ by what the nodes leave out: more where sections curl and uncurl along a blade.
    """
    state = solve(askew(), HELD, loads=LOADS, effects=effects, levels=(nodes,))
    at, k_f = state.linearised, 6 * state.part.assembly.blades
    condensed = []
    for matrix in (at.matrix, state.variation.matrix):
        follow = np.linalg.solve(matrix[:k_f, :k_f], matrix[:k_f, k_f:])
        condensed.append(matrix[k_f:, k_f:] - matrix[k_f:, :k_f] @ follow)
    newton, energy = condensed
    scale = np.sqrt(np.abs(np.outer(np.diag(energy), np.diag(energy))))
    assert np.max(np.abs((newton + newton.T) / 2.0 - energy) / scale) < error


def test_a_locked_drive_and_a_free_one_are_two_numbers():
    """At 20 mm of stroke 70 times apart along the blades; alike off the plane of motion."""
    state = solve(guide(), {"stage": (20e-3, *(None,) * 5)}, effects=SMOOTH).checked()
    middle = (0.0, 50e-3, 0.0)
    locked = 1.0 / np.diag(support_compliance(state, "stage", middle))
    free = 1.0 / np.diag(support_compliance(state, "stage", middle, free=(0,)))
    assert 60.0 < locked[1] / free[1] < 80.0
    assert locked[2:5] == pytest.approx(free[2:5], rel=1e-9)
    # along the drive it is the slope of the drive force, by differences of the force
    ahead, behind = (
        solve(guide(), {"stage": (20e-3 + s, *(None,) * 5)}, effects=SMOOTH).reactions[0, 0]
        for s in (1e-5, -1e-5)
    )
    stage = (0.0, 100e-3, 0.0)
    along = 1.0 / support_compliance(state, "stage", stage, free=(0,))[0, 0]
    assert along == pytest.approx((ahead - behind) / 2e-5, rel=1e-6)


def test_leaving_out_restrained_warping_makes_a_deflected_guide_three_to_four_times_too_soft():
    middle = (0.0, 50e-3, 0.0)
    found = {}
    for warping in (True, False):
        for stroke in (0.0, 20e-3):
            held = {"stage": (stroke, *(None,) * 5)}
            state = solve(guide(), held, effects=SMOOTH._replace(warping=warping)).checked()
            found[warping, stroke] = 1.0 / support_compliance(state, "stage", middle)[2, 2]
    assert found[True, 0.0] == pytest.approx(found[False, 0.0], rel=1e-9)
    assert 3.0 < found[True, 20e-3] / found[False, 20e-3] < 4.0


@pytest.mark.parametrize(
    ("b", "stroke", "force", "stiffness"),
    [
        (50e-3, 20e-3, 56.87, (3.561e6, 9.173e5, 1311.4, 9283.5, 35809.0)),
        (20e-3, 20e-3, 22.275, (1.3808e6, 1.5603e5, 208.26, 1579.9, 13873.0)),
        (50e-3, 5e-3, 13.567, (3.9548e7, 7.2128e6, 10574.0, 71996.0, 3.8187e5)),
        (20e-3, 5e-3, 5.2554, (1.5296e7, 9.245e5, 995.66, 9249.1, 1.4763e5)),
    ],
)
def test_a_guide_at_stroke_is_that_of_solids(b, stroke, force, stiffness):
    """CalculiX 2.20, C3D20R between rigid bodies, one element through 0.5 mm, 1 % by its mesh.

    Support stiffness at the middle, drive locked, along y and z and about x, y, z. Without the
    curling of the sections the second is 13 % too soft at 20 mm.
    """
    frames = {"stage": Frame((0.0, 50e-3, 0.0), np.eye(3))}
    held = {"stage": (stroke, *(None,) * 5)}
    state = solve(guide(b=b), held, frames=frames, tolerance=1e-5).checked()
    assert state.reactions[0, 0] == pytest.approx(force, rel=0.01)
    C = support_compliance(state, "stage", (0.0, 50e-3, 0.0))
    assert 1.0 / np.diag(C)[1:] == pytest.approx(stiffness, rel=0.05)


def test_a_mass_on_a_rod_vibrates_at_its_frequencies():
    """√(3EI/l³/m) either way across, √(EA/l/m) along; inertia next to none."""
    d, l, mass = 2e-3, 0.1, 0.4
    layout = rod(d=d, l=l)
    small = tuple(tuple(1e-9 * x for x in row) for row in INERTIA)
    body = layout.bodies[0]._replace(mass=mass, inertia=small)
    state = solve(replace(layout, bodies=(body,)), effects=BeamEffects(shear=False)).checked()
    EI, EA = E * np.pi * d**4 / 64, E * np.pi * d**2 / 4
    across, along = np.sqrt(3 * EI / l**3 / mass), np.sqrt(EA / l / mass)
    angular = 2.0 * np.pi * vibration(state).frequency[0]
    assert angular[:2] == pytest.approx(across, rel=1e-7)
    assert np.min(np.abs(angular / along - 1.0)) < 1e-9


def test_a_strip_buckles_sideways_at_michells_load():
    """4.0126 √(EI GJ)/l² of a strip so deep that it does not bend under the load (Michell 1899)."""
    l, b, h = 1.0, 50e-3, 50e-6
    critical = 4.0126 * np.sqrt(E * b * h**3 / 12.0 * G * float(torsion_constant(h, b))) / l**2
    effects = BeamEffects(*(False,) * 6)
    load = SpaceLoad("tip", (l, 0, 0), (0, 0, -critical))
    found = critical_load(strip(h=h, b=b, l=l), None, [load], most=2.0, effects=effects)
    assert found.factor == pytest.approx(1.0, rel=2e-5)
    straight = straight_critical_factor(strip(h=h, b=b, l=l), None, [load], most=2.0)
    assert straight == pytest.approx(1.0, rel=0.03)  # with warping and plates
    assert found.multiplicity == 1
    assert not found.turns
    # it goes sideways and turns
    assert np.max(np.abs(found.mode[0, [1, 3, 5]])) == 1.0
    assert np.max(np.abs(found.mode[0, [0, 2, 4]])) < 1e-8


@pytest.mark.parametrize(("held", "factor"), [((), 0.25), ((0, 1, 2, 3, 4, 5), 4.0)])
def test_a_rod_buckles_at_eulers_load_held_or_free(held, factor):
    """With its body held, nothing but the rod moves: the count sees it all the same, twofold."""
    d, l = 1e-4, 0.1
    EI = E * np.pi * d**4 / 64
    motion = {"tip": tuple(0.0 if i in held and i > 0 else None for i in range(6))}
    load = SpaceLoad("tip", (l, 0, 0), (-(np.pi**2) * EI / l**2, 0, 0))
    found = critical_load(rod(d=d, l=l), motion, [load], most=6.0,
                          effects=BeamEffects(shear=False))  # fmt: skip
    assert found.factor == pytest.approx(factor, rel=1e-5)
    straight = straight_critical_factor(rod(d=d, l=l), motion, [load], most=6.0)
    assert straight == pytest.approx(factor, rel=2e-3)
    assert found.multiplicity == 2
    assert (np.max(np.abs(found.mode)) == 0.0) == bool(held)


def test_what_buckles_only_with_the_drive_free_is_counted_then():
    """A guide pushed down its blades at stroke: four times the load of a free drive, if locked."""
    held = {"stage": (20e-3, *(None,) * 5)}
    load = SpaceLoad("stage", (0.0, 50e-3, 0.0), (0.0, -1000.0, 0.0))
    state = solve(guide(), held, loads=[load], load_factor=0.4, effects=SMOOTH).checked()
    assert state.unstable == 0
    assert unstable_when_free(state, (0,)) == 1


def test_nothing_critical_is_told():
    load = SpaceLoad("tip", (0.1, 0, 0), (1.0, 0, 0))
    found = critical_load(rod(d=1e-3), None, [load], most=3.0)
    assert found.factor == np.inf
    assert straight_critical_factor(rod(d=1e-3), None, [load], most=3.0) == np.inf


def test_a_path_is_walked_on_from_where_it_is_known_to_stand(monkeypatch):
    """Half of Euler's load buckles no column; the walk to all of it begins there."""
    d, l = 1e-3, 0.1
    euler = np.pi**2 * E * np.pi * d**4 / 64 / (4.0 * l**2)
    layout, load = rod(d=d, l=l), SpaceLoad("tip", (l, 0, 0), (-euler, 0, 0))
    starts = []
    follow = critical.follow
    monkeypatch.setattr(critical, "follow", lambda *a, **k: starts.append(a[1]) or follow(*a, **k))
    half = critical_load(layout, None, [load], most=0.5)
    assert half.factor == np.inf
    found = critical_load(layout, None, [load], most=1.5, walked=half.walked)
    assert found.factor == pytest.approx(1.0, rel=1e-3)
    assert found.factor == pytest.approx(
        critical_load(layout, None, [load], most=1.5).factor, rel=1e-6
    )
    assert starts[1][1] == pytest.approx(half.walked.factor / 1.5)
    assert half.walked.factor >= 0.5


def test_a_rod_that_bows_from_the_first_on_has_the_load_of_a_straight_one_beside_it():
    """A force across leaves no critical point at Euler's load, from where on the rod bows far."""
    d, l = 1e-4, 0.1
    EI = E * np.pi * d**4 / 64
    euler = np.pi**2 * EI / (4.0 * l**2)
    load = SpaceLoad("tip", (l, 0, 0), (-euler, 1e-4 * euler, 0))
    assert critical_load(rod(d=d, l=l), None, [load], most=1.05).factor > 1.05
    straight = straight_critical_factor(rod(d=d, l=l), None, [load], most=1.05)
    assert straight == pytest.approx(1.0, rel=2e-3)


def test_a_path_that_is_lost_tells_how_far_it_was_stable():
    """Bowed blades under a force along their width: motion and force from rest at once lead there.

    Their sections snap somewhat beyond, where the walk by arc length ends.
    """
    bowed, motion = guide(b=20e-3), {"stage": (5e-3, None, None, None, None, None)}
    load = SpaceLoad("stage", (0.0, 0.05, 0.0), (0.0, 0.0, 200.0))
    start = solve(bowed, motion, tolerance=1e-5)
    levels = (12, 18, 27, 40)
    found = critical_load(
        bowed, motion, [load], most=5.0, start=start, levels=levels, tolerance=1e-3
    )
    assert found.is_lost
    assert found.factor > 1.5
    there = solve(bowed, motion, loads=[load], load_factor=0.99 * found.factor, tolerance=1e-4)
    assert there.checked().unstable == 0


def test_stresses_are_those_of_a_bent_and_a_twisted_strip():
    l, b, h = 0.1, 20e-3, 0.2e-3
    layout = strip(h=h, b=b, l=l)
    force = 1e-4
    state = solve(layout, loads=[SpaceLoad("tip", (l, 0, 0), (0, force, force))]).checked()
    (bent,) = blade_stresses(state)
    assert bent.s[[0, -1]] == pytest.approx([0.0, 1.0], abs=1e-12)
    assert bent.bend_thin[0] == pytest.approx(force * l * 6.0 / (b * h**2), rel=1e-4)
    assert bent.bend_wide[0] == pytest.approx(force * l * 6.0 / (h * b**2), rel=1e-4)
    worst = bent.bend_thin[0] + bent.bend_wide[0]
    # what the offset of the bent strip twists it by comes on top
    assert np.max(np.abs(bent.corner[0])) == pytest.approx(worst + bent.warping[0], rel=1e-6)
    angle = 1e-4
    twisted = solve(layout, {"tip": (None, None, None, angle, None, None)}).checked()
    (found,) = blade_stresses(twisted)
    expected = restrained_stresses(E=E, G=G, h=h, b=b, l=l, theta=angle)
    assert found.warping[0] == pytest.approx(float(expected.normal), rel=1e-4)
    assert np.max(found.shear) == pytest.approx(float(expected.shear), rel=1e-3)


def test_the_blades_of_a_guide_bear_the_stress_of_their_s_shape():
    """3 E h s/l² of a small stroke between ends that do not turn, times the plate's factor."""
    stroke, h, l = 1e-4, 0.5e-3, 0.1
    state = solve(guide(h=h, l=l), {"stage": (stroke, *(None,) * 5)}).checked()
    factor = float(guided_factor(b=50e-3, h=h, l=l, poisson_ratio=nu))
    for found in blade_stresses(state):
        assert found.bend_thin[0] == pytest.approx(3.0 * E * h * stroke / l**2 * factor, rel=1e-3)
