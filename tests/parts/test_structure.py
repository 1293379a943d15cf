"""A mechanism as a linear structure: assembly of bodies on copies of one joint."""

from math import pi, sqrt

import numpy as np
import pytest
from planar_joint import joint_stiffness, stress_rows

from flexcli.mechanics.layout import Body
from flexcli.numerics.modes import natural_modes
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import Blade
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.structure import OwnMotion, PlacedJoint, assemble

E, h, l, b, p = 114e9, 637e-6, 17.5e-3, 10e-3, 2e-3
PAIR = (pi / 4, -pi / 4)
SIZE = {"E": E, "h": h, "l": l, "p": p, "angles": PAIR}
PIVOT = RCCPivot(kind="rcc", p="2 mm", half_angle="45 deg", h="637 um", l="17.5 mm", b="10 mm")
LAYOUT = PIVOT.layout(Elastic(E), Blade(h, l, b))
ORIGIN = (0.0, 0.0)

ROUNDING = 1e-9
"""Relative: assembly and an eigenproblem of condition 1e6."""


def body(name, mass, inertia, com=ORIGIN):
    return Body(name, ORIGIN, mass, inertia, com)


def alone(payload, turn=0.0):
    return assemble(
        [payload], [PlacedJoint("J", "ground", payload.name, ORIGIN, turn)], LAYOUT, None
    )


def test_a_joint_of_massless_blades_is_the_spring_of_its_closed_form():
    structure = alone(body("payload", 0.1, 1e-2))
    expected = joint_stiffness(b=b, **SIZE)
    np.testing.assert_allclose(structure.stiffness, expected, rtol=ROUNDING, atol=1e-9)
    axial, faces = stress_rows(**SIZE)
    motion = np.array([1e-6, -2e-6, 3e-4])
    for name, rows in (("axial stress J", axial), ("stress J", faces)):
        worst = np.abs(structure.outputs[name] @ motion).max()
        assert worst == pytest.approx(np.abs(rows @ motion).max(), rel=ROUNDING)


@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_the_wrench_on_a_joint_is_along_its_own_axes_whatever_way_it_is_turned(turn):
    structure = alone(body("payload", 0.1, 1e-2), turn)
    motion = np.array([1e-6, -2e-6, 3e-4])
    c, s = np.cos(turn), np.sin(turn)
    turned = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ motion
    expected = joint_stiffness(b=b, **SIZE) @ motion
    np.testing.assert_allclose(structure.wrenches["J"] @ turned, expected, rtol=ROUNDING, atol=1e-9)


def test_one_body_on_one_joint_turns_at_the_frequency_of_its_inertia():
    structure = alone(body("payload", 0.1, 1e-2))
    lowest = natural_modes(structure.stiffness, structure.mass).angular[0]
    # the centre of mass sits in the centre, but turning also shifts it a little by K_yφ
    assert lowest == pytest.approx(sqrt(joint_stiffness(b=b, **SIZE)[2, 2] / 1e-2), rel=1e-3)


@pytest.mark.parametrize("density", [0.0, 4430.0])
@pytest.mark.parametrize("angle", [0.3, pi / 2, 2.0])
def test_turning_the_whole_mechanism_leaves_its_frequencies(angle, density):
    def frequencies(turn):
        c, s = np.cos(turn), np.sin(turn)

        def at(x, y):
            return (c * x - s * y, s * x + c * y)

        bodies = [body("one", 0.05, 2e-5, at(0.01, -0.012)), body("two", 0.07, 1e-5, at(0.0, 0.03))]
        joints = [
            PlacedJoint("A", "ground", "one", at(0.0, 0.0), 0.4 + turn),
            PlacedJoint("B", "one", "two", at(0.0, 0.02), -0.2 + turn),
            PlacedJoint("C", "ground", "two", at(0.03, 0.02), turn),
        ]
        structure = assemble(bodies, joints, LAYOUT, None, density=density)
        return natural_modes(structure.stiffness, structure.mass).angular

    np.testing.assert_allclose(frequencies(angle), frequencies(0.0), rtol=ROUNDING)


@pytest.mark.parametrize("density", [0.0, 4430.0])
def test_the_moved_mass_is_that_of_bodies_and_blades_on_both_axes(density):
    bodies = [body("one", 0.05, 2e-5, (0.01, 0.02)), body("two", 0.07, 1e-5)]
    joints = [
        PlacedJoint("A", "ground", "one", ORIGIN, 0.0),
        PlacedJoint("B", "one", "two", (0.0, 0.02), 0.0),
    ]
    structure = assemble(bodies, joints, LAYOUT, None, density=density)
    whole = 0.12 + 4 * density * b * h * l
    assert structure.moved == pytest.approx({"x": whole, "y": whole}, rel=ROUNDING)


def test_a_held_coordinate_is_no_freedom():
    joints = [PlacedJoint("J", "ground", "platform", ORIGIN, 0.0)]
    platform = body("platform", 0.1, 0.0, (0.0, 0.02))
    structure = assemble([platform], joints, LAYOUT, None, held=[("platform", 2)])
    assert structure.mass.shape == (2, 2)


@pytest.mark.parametrize("density", [0.0, 4430.0])
def test_reciprocity_a_static_force_on_a_body_appears_in_its_joint(density):
    joints = [PlacedJoint("J", "ground", "payload", ORIGIN, 0.0)]
    given = OwnMotion("payload", (1.0, 0.0, 0.0), "travel")
    found = assemble([body("payload", 0.1, 1e-5)], joints, LAYOUT, given, density=density)
    force = np.zeros(found.mass.shape[0])
    force[:2] = 3.0, 4.0
    motion = np.linalg.solve(found.stiffness, force)
    np.testing.assert_allclose(found.outputs["force J"] @ motion, [[3.0, 4.0]], rtol=ROUNDING)
