"""Misalignment stress of every kind of joint, in any direction, against frames in space.

The frames share no code with the package but where its blades stand; they know neither plates nor
ends that are kept from warping, and the blades compared are without them.
"""

from dataclasses import replace
from functools import cache

import geometries_for_tests as samples
import numpy as np
import pytest
import yaml
from space_frame import Beam, Frame, beam_matrix

import flexcli
from flexcli.formulas.profile import Constant, NeckedDown
from flexcli.mechanics.space.layout import BeamEffects
from flexcli.parts.elastic import Elastic
from flexcli.parts.space_joint import SpaceJoint
from flexcli.parts.space_misfits import misfit_stresses

E, NU = 114e9, 0.0
G = E / 2.0 / (1.0 + NU)
UP = (0.0, 0.0, 1.0)
JOINTS = ("rcc", "cross-spring", "unseparated-cross", "three-blade", "star", "leaf-spring-stage",
          "necked-down-stage", "hinged-stage", "hinged-pivot", "guided-blade")  # fmt: skip
FREE = ("cantilever", "moment-blade", "notch-hinge", "filleted-hinge", "elliptic-hinge")
WAYS = {name: np.eye(6)[k] for k, name in enumerate(("x", "y", "z", "about x", "about y"))} | {
    "about z": np.eye(6)[5],
    "askew": np.array([0.3, -0.2, 0.5, 0.4, 0.6, -0.3]),
}
SHEARED = 0.06
"""Share by which the shear amid the sides of a section is above the parabola that frames have."""

NOTCHED = 0.1
"""Share by which sections of a notch miss its torsion."""


def twist(h, b):
    """Return J of a rectangle and its shear per torque amid faces and sides, by Saint-Venant."""
    n = np.arange(1.0, 60.0, 2.0)
    J = b * h**3 / 3.0 * (1.0 - 192.0 * h / np.pi**5 / b * np.sum(np.tanh(n * np.pi * b / 2 / h)
                                                                 / n**5))  # fmt: skip
    sides = np.exp(-n * np.pi * b / 2.0 / h)
    face = 1.0 - 8.0 / np.pi**2 * np.sum(2.0 * sides / (1.0 + sides**2) / n**2)
    odd = np.sin(n * np.pi / 2.0)
    side = 8.0 / np.pi**2 * np.sum(odd * np.tanh(n * np.pi * b / 2.0 / h) / n**2)
    return J, h / J * face, h / J * side


_gauss = cache(np.polynomial.legendre.leggauss)


def sections(blade, l):
    """Return places along a blade, thicknesses there and how much of the length each stands for."""
    profile, at = blade.profile, []
    x, w = _gauss(200)
    if isinstance(profile, Constant):
        return l * (1 + x) / 2, np.full(200, float(profile.h)), w * l / 2
    if isinstance(profile, NeckedDown):
        neck = float(profile.hinge)
        at = [neck * (1 + x) / 2, l - neck * (1 + x) / 2]
        return np.concatenate(at), np.full(400, float(profile.h)), np.tile(w * neck / 2, 2)
    # half an ellipse: s = l/2 (1 - cos a), the depth times its sine
    a = np.pi * (1 + x) / 2
    thick = float(profile.e) + 2.0 * float(profile.depth) * (1.0 - np.sin(a))
    return l / 2 * (1 - np.cos(a)), thick, w * np.pi / 2 * l / 2 * np.sin(a)


def carried(arm):
    """Return the wrench on a section by a wrench on the end, which is ``arm`` beyond it."""
    found = np.eye(6)
    found[4, 2], found[5, 1] = -arm, arm
    return found


def beam_of(blade, names):
    """Return a blade as a beam, by the flexibility of its sections where they differ."""
    start, end = np.array(blade.start), np.array(blade.end)
    l = float(np.linalg.norm(end - start))
    x = (end - start) / l
    axes = np.stack([x, np.cross(blade.width, x), blade.width])
    b, bodies = (
        blade.b,
        [names.index(n) if n in names else None for n in (blade.first, blade.second)],
    )
    if isinstance(blade.profile, Constant):
        h = float(blade.profile.h)
        shear = 12.0 * E / (5.0 / 6.0 * G * l**2)
        K = beam_matrix(l, E * b * h, G * twist(h, b)[0], E * h * b**3 / 12, E * b * h**3 / 12,
                        shear * h**2 / 12, shear * b**2 / 12)  # fmt: skip
        return Beam(*bodies, start, end, axes, K)
    C = np.zeros((6, 6))
    for s, h, w in zip(*sections(blade, l), strict=True):
        A = b * h
        own = [1 / (E * A), 1.2 / (G * A), 1.2 / (G * A), 1 / (G * twist(h, b)[0]),
               12 / (E * h * b**3), 12 / (E * b * h**3)]  # fmt: skip
        C += w * carried(l - s).T @ np.diag(own) @ carried(l - s)
    K, H = np.linalg.inv(C), carried(l)
    return Beam(*bodies, start, end, axes, np.block([[H @ K @ H.T, -H @ K], [-K @ H.T, K]]))


def stress(blade, force):
    """Return the largest stress of a blade by the wrench on its end: corners, and mid-faces."""
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    b, most = blade.b, 0.0
    for s, h in zip(*sections(blade, l)[:2], strict=True):
        N, V_y, V_z, T, M_y, M_z = np.abs(carried(l - s) @ force)
        _, face, side = twist(h, b)
        N = N / b / h * blade.peak[1]
        thin, wide = 6.0 * M_z / b / h**2 * blade.peak[0], 6.0 * M_y / h / b**2
        places = [(N + thin + wide, 0.0), (N + thin, T * face + 1.5 * V_z / b / h),
                  (N + wide, T * side + 1.5 * V_y / b / h)]  # fmt: skip
        most = max(most, *(np.hypot(normal, 3**0.5 * shear) for normal, shear in places))
    return most


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("kind", JOINTS)
def test_a_missed_seat_stresses_a_joint_as_a_frame_in_space(kind, way):
    spec = {"flexure": 1, "geometry": samples.spec(kind), "material": samples.MATERIAL,
            "requirements": {"mass": {"max": "1 kg"}}}  # fmt: skip
    design = flexcli.load(yaml.safe_dump(spec)).part
    part = design.geometry
    layout = part.space_layout(Elastic(E, NU), design.fixed_sizes())
    bare = BeamEffects(plate=False, warping=False)
    narrow = {} if kind.startswith("hinged") else {"b": 0.4e-3}
    blades = tuple(replace(blade, feels=bare, **narrow) for blade in layout.blades)
    layout = replace(layout, blades=blades)
    offset = 1e-6 * WAYS[way] * ([1.0] * 3 + [100.0] * 3)
    kept = (UP,) if part.is_guided else ()
    (told,) = misfit_stresses(SpaceJoint(layout), [0], tuple(offset), kept=kept)
    names = [body.name for body in layout.bodies]
    frame = Frame([body.point for body in layout.bodies], [beam_of(each, names) for each in blades])
    held = None
    if kept:
        held = np.zeros(len(frame.K))
        held[6 * names.index(layout.drive.body) + 5] = 1.0
    forces = frame.missed(0, offset, held)[:, 6:]
    true = max(stress(*each) for each in zip(blades, forces, strict=True))
    if true < 1e-9 * E * 1e-6 / 20e-3:  # nothing holds against it
        assert told.stress == 0.0
        return
    if narrow:
        assert true * (1.0 - 1e-6) <= told.stress <= true * (1.0 + SHEARED)
    else:
        assert told.stress == pytest.approx(true, rel=NOTCHED)


@pytest.mark.parametrize("kind", FREE)
def test_nothing_is_stressed_where_nothing_is_over_constrained(kind):
    asked = {"of": "blade" if kind in FREE[:2] else "hinge", "factor": 3,
             "rotation": {"about": [1, 2, 3], "by": "30 mrad"}}  # fmt: skip
    spec = {"flexure": 1, "geometry": samples.spec(kind), "material": samples.MATERIAL,
            "requirements": {"misalignment_stress": asked}}  # fmt: skip
    row = next(r for r in flexcli.check(yaml.safe_dump(spec)).checks if "misalign" in r.name)
    assert row.demand == 0.0
    assert row.verdict == "pass"
    assert "nothing is stressed" in row.quantity
