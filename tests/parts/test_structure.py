from math import pi, sqrt

import numpy as np
import pytest

from flexcli.formulas.planar_joint import joint_stiffness, stress_rows
from flexcli.numerics.modes import natural_modes
from flexcli.parts.structure import Body, Joint, Spring, assemble

E, h, l, b, p = 114e9, 637e-6, 17.5e-3, 10e-3, 2e-3
PAIR = (pi / 4, -pi / 4)

ROUNDING = 1e-9
"""Relative: assembly and an eigenproblem of condition 1e6."""


def spring(**changes):
    size = {"E": E, "h": h, "l": l, "p": p, "angles": PAIR}
    axial, faces = stress_rows(**size)
    return Spring(joint_stiffness(b=b, **size), axial, faces, **changes)


def test_one_body_on_one_joint_turns_at_the_frequency_of_its_inertia():
    body = Body("payload", 0.1, 1e-2)
    structure = assemble([body], [Joint("joint", None, "payload", (0, 0), 0.0, spring())], None)
    lowest = natural_modes(structure.stiffness, structure.mass).angular[0]
    # the centre of mass sits in the centre, but turning also shifts it a little by K_yφ
    assert lowest == pytest.approx(sqrt(spring().stiffness[2, 2] / 1e-2), rel=1e-3)


@pytest.mark.parametrize("angle", [0.3, pi / 2, 2.0])
def test_turning_the_whole_mechanism_leaves_its_frequencies(angle):
    def frequencies(turn):
        c, s = np.cos(turn), np.sin(turn)

        def at(x, y):
            return (c * x - s * y, s * x + c * y)

        bodies = [Body("one", 0.05, 2e-5, at(0.01, -0.012)), Body("two", 0.07, 1e-5, at(0.0, 0.03))]
        joints = [
            Joint("A", None, "one", at(0.0, 0.0), 0.4 + turn, spring()),
            Joint("B", "one", "two", at(0.0, 0.02), -0.2 + turn, spring()),
            Joint("C", None, "two", at(0.03, 0.02), turn, spring()),
        ]
        structure = assemble(bodies, joints, None)
        return natural_modes(structure.stiffness, structure.mass).angular

    np.testing.assert_allclose(frequencies(angle), frequencies(0.0), rtol=ROUNDING)


def test_total_moving_mass_is_that_of_the_bodies_on_both_axes():
    bodies = [Body("one", 0.05, 2e-5, (0.01, 0.02)), Body("two", 0.07, 1e-5)]
    joints = [
        Joint("A", None, "one", (0, 0), 0.0, spring()),
        Joint("B", "one", "two", (0, 0.02), 0.0, spring()),
    ]
    structure = assemble(bodies, joints, None)
    for axis in ("x", "y"):
        r = structure.influence[axis]
        assert r @ structure.mass @ r == pytest.approx(0.12)


def test_a_body_that_does_not_turn_loses_that_coordinate():
    body = Body("platform", 0.1, 0.0, (0.0, 0.02), turns=False)
    structure = assemble([body], [Joint("J", None, "platform", (0, 0), 0.0, spring())], None)
    assert structure.mass.shape == (2, 2)


def test_reciprocity_a_static_force_on_a_body_appears_in_its_joint():
    body = Body("payload", 0.1, 1e-5)
    structure = assemble([body], [Joint("J", None, "payload", (0, 0), 0.0, spring())], None)
    motion = np.linalg.solve(structure.stiffness, np.array([3.0, 4.0, 0.0]))
    np.testing.assert_allclose(structure.outputs["force J"] @ motion, [3.0, 4.0], rtol=ROUNDING)
