"""Misalignment stress: against pure bending, and plane frames of exact beams at the seat."""

import pytest
import yaml
from twins.joints import BODY, PLACES
from twins.reissner import GROUND, Beam, Frame, Mass

import flexcli

E = 100e9


def misaligned(geometry, of, angle):
    """Return the stress and its range where a blade's seat is turned in the plane."""
    asked = {"of": of, "factor": 1e-6, "rotation": {"about": "z", "by": f"{angle!r} rad"}}
    spec = {
        "flexure": 1, "geometry": geometry, "requirements": {"misalignment_stress": asked},
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0, "yield_strength": "1 GPa"},
    }  # fmt: skip
    row = next(r for r in flexcli.check(yaml.safe_dump(spec)).checks if "misalign" in r.name)
    return row.demand, [row.capacity / factor for factor in reversed(row.factor_range)]


def test_a_guided_blade_bends_by_the_turn_of_its_seat():
    sizes = {"kind": "guided-blade", "l": "20 mm", "h": "0.1 mm", "b": "2 mm"}
    stress, _ = misaligned(sizes, "blade", 1e-3)
    # what guides the body keeps it from turning: E h φ/2l
    assert stress == pytest.approx(E * 1e-4 * 1e-3 / (2.0 * 20e-3), rel=1e-6)


def test_the_tension_of_a_blade_that_its_seat_bends_is_in_the_range():
    l, h, p, turn = 20e-3, 0.08e-3, 4e-3, 3e-4
    sizes = {"kind": "three-blade", "l": f"{l} m", "h": f"{h} m", "b": "0.3 mm", "p": f"{p} m"}
    _, (least, most) = misaligned(sizes, "blade 1", turn)
    # seen from the body: the base is free, and the first blade stands on the seat
    ways = [(1.0, 0.0), (-0.5, 0.75**0.5), (-0.5, -(0.75**0.5))]
    ends = [tuple((r * c, r * s) for r in (p, p + l)) for c, s in ways]
    beams = [Beam(BODY, GROUND if k else "seat", *each, h, 0.3e-3) for k, each in enumerate(ends)]
    bodies = ((BODY, Mass((0.0, 0.0))), ("seat", Mass(ends[0][1])))
    frame = Frame(bodies, tuple(beams), E, E / 2.0)
    for sense in (1.0, -1.0):
        state = frame.stable_solve({("seat", 0): 0.0, ("seat", 1): 0.0, ("seat", 2): sense * turn})
        true = max(float(abs(face).max()) for faces in frame.faces(state, PLACES) for face in faces)
        assert least <= true <= most
