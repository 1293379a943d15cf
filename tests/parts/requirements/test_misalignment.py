"""Misalignment stress: against pure bending, and plane frames of exact beams at the seat."""

from itertools import product

import numpy as np
import pytest
import yaml
from twins.joints import BODY, PLACES
from twins.reissner import GROUND, Beam, Frame, Mass

import flexcli
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.engine.joint_models.space_shell import SpaceShellModel
from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import FINE, NeckUnderLoads, equivalent
from flexcli.parts.requirements import Ask
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.space_misfits import misfit_stresses, worst_misfit
from flexcli.results import Verdict

E = 100e9


def misaligned(geometry, of, angle, model=None, nu=0):
    """Return the stress and its range where a blade's seat is turned in the plane."""
    rotation = {"about": "z", "by": f"{angle!r} rad"}
    return missed(geometry, {"of": of, "rotation": rotation}, model, nu)


def missed(geometry, seat, model=None, nu=0):
    """Return the stress of a missed seat and its range."""
    row = judged(geometry, seat | {"factor": 1e-6}, model, nu)
    return row.demand, [row.capacity / factor for factor in reversed(row.factor_range)]


def judged(geometry, asked, model=None, nu=0):
    spec = {
        "flexure": 1, "geometry": geometry, "requirements": {"misalignment_stress": asked},
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": nu, "yield_strength": "1 GPa"},
    }  # fmt: skip
    checks = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
    return next(row for row in checks if "misalign" in row.name)


def test_a_guided_blade_bends_by_the_turn_of_its_seat():
    sizes = {"kind": "guided-blade", "l": "20 mm", "h": "0.1 mm", "b": "2 mm"}
    stress, _ = misaligned(sizes, "blade", 1e-3)
    # what guides the body keeps it from turning: E h φ/2l
    assert stress == pytest.approx(E * 1e-4 * 1e-3 / (2.0 * 20e-3), rel=1e-6)


def turned_three_blade(l, h, p, turn):
    """Return the largest stress of a three-blade by a turned seat, of frames of exact beams."""
    # seen from the body: the base is free, and the first blade stands on the seat
    ways = [(1.0, 0.0), (-0.5, 0.75**0.5), (-0.5, -(0.75**0.5))]
    ends = [tuple((r * c, r * s) for r in (p, p + l)) for c, s in ways]
    beams = [Beam(BODY, GROUND if k else "seat", *each, h, 0.3e-3) for k, each in enumerate(ends)]
    bodies = ((BODY, Mass((0.0, 0.0))), ("seat", Mass(ends[0][1])))
    frame = Frame(bodies, tuple(beams), E, E / 2.0)
    for sense in (1.0, -1.0):
        state = frame.stable_solve({("seat", 0): 0.0, ("seat", 1): 0.0, ("seat", 2): sense * turn})
        yield max(float(abs(face).max()) for faces in frame.faces(state, PLACES) for face in faces)


THREE = {"kind": "three-blade", "l": "20 mm", "h": "0.08 mm", "b": "0.3 mm", "p": "4 mm"}


def test_the_tension_of_a_blade_that_its_seat_bends_is_in_the_range():
    _, (least, most) = misaligned(THREE, "blade 1", 3e-4, "linear")
    for true in turned_three_blade(20e-3, 0.08e-3, 4e-3, 3e-4):
        assert least <= true <= most


@pytest.mark.parametrize("turn", [3e-4, 3e-3, 0.03])
def test_exact_beams_tell_the_stress_of_seats_that_are_turned_far(turn):
    stress, (least, most) = misaligned(THREE, "blade 1", turn, "exact")
    each = list(turned_three_blade(20e-3, 0.08e-3, 4e-3, turn))
    assert stress == pytest.approx(max(each), rel=2e-3)
    assert least <= max(each) <= most
    assert most < 1.1 * least


def test_a_seat_that_buckles_a_blade_is_left_undecided():
    # 10 um along a blade of h/l = 1/250 between others that hold it
    seat = {"of": "blade 1", "factor": 3, "translation": {"along": "x", "by": "10 um"}}
    assert judged(THREE, seat).verdict is Verdict.UNDECIDED


WIDE = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "blades": 2, "spacing": "10 mm"}
SEATS = {
    "about x": {"rotation": {"about": "x", "by": "2 mrad"}},
    "about z": {"rotation": {"about": "z", "by": "2 mrad"}},
    "along z": {"translation": {"along": "z", "by": "10 um"}},
}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("b", "way"), [*product(["4 mm", "12 mm", "38 mm"], SEATS), ("60 mm", "about z")]
)
def test_shells_overlap_with_beams_where_these_know_their_error(b, way):
    part = flexcli.load(yaml.safe_dump({
        "flexure": 1, "geometry": WIDE | {"b": b}, "requirements": {"stiffness": {"min": "1 N/m"}},
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.3, "yield_strength": "1 GPa"},
    })).part  # fmt: skip
    ask = Ask(part.material, part.geometry, None, part.fixed_sizes(), part.scenes()[0],
              SpaceExactModel())  # fmt: skip
    joint = joint_in_space(part.geometry, part.material, part.fixed_sizes())
    off = SEATS[way]
    motion = np.zeros(6)
    motion[["along x", "along y", "along z", "about x", "about y", "about z"].index(way)] = (
        2e-3 if "rotation" in off else 1e-5
    )
    small = tuple(misfit_stresses(joint, [0], tuple(motion)))
    beams, shells = (
        worst_misfit(model.misfit_stresses(ask, small))[0]
        for model in (SpaceExactModel(), SpaceShellModel())
    )
    ranges = [[told.value * (1.0 + end) for end in told.error] for told in (beams, shells)]
    assert max(low for low, _ in ranges) <= min(high for _, high in ranges)


def test_shells_tell_the_stress_of_blades_that_are_too_wide_for_beams():
    wide, seat = WIDE | {"b": "50 mm"}, {"of": "blade 1"} | SEATS["about x"]
    beams = judged(wide, seat | {"factor": 1.0}, "exact", 0.3)
    assert beams.verdict is Verdict.UNDECIDED
    stress, (least, most) = missed(wide, seat, None, 0.3)
    # more than in narrower ones, which beams know, less than were sections as stiff as beams'
    narrower, _ = missed(WIDE | {"b": "38 mm"}, seat, "exact", 0.3)
    assert narrower < stress < beams.demand
    assert least < narrower < most < 1.5 * least


@pytest.mark.parametrize(("b", "nu"), [(0.4, 0.3), (4.0, 0.45)])
def test_a_turned_seat_stresses_a_hinge_as_a_solid_that_bears_three_quarters_of_the_turn(b, nu):
    e, r, turn = 0.1e-3, 4e-3, 1e-3
    stage = {"kind": "hinged-stage", "e": f"{e} m", "r": f"{r} m", "b": f"{b} mm", "l": "40 mm",
             "limbs": 2, "spacing": "40 mm", "blocks": "10 mm"}  # fmt: skip
    # four hinges alike, the stage free: it moves until the other three bear a quarter each
    solid, moment = NeckUnderLoads(Neck(e, r, 2.0 * r, b * 1e-3, 0.0, 5e-3), E, nu), np.eye(6)[[5]]
    stress = float(np.abs(equivalent(solid.stresses(moment, FINE)[0])).max())
    true = 0.75 * turn / solid.compliance(5)[0] * stress
    told, (low, high) = misaligned(stage, "limb 1 inner hinge", turn, nu=nu)
    assert low < true < high
    assert high - low < 0.25 * told


@pytest.mark.parametrize("along", ["x", "y"])
def test_the_stress_of_a_seat_off_in_the_plane_of_wide_blades_is_that_of_narrow_ones(along):
    """Nothing widens without lateral contraction: sections of any width are alike in a plane."""
    off = {"of": "a", "translation": {"along": along, "by": "1 um"}}

    def found(b):
        def blade(start, end):
            return {"between": ["ground", "st"], "from": start, "to": end, "h": "1 mm", "b": b}

        blades = {
            "a": blade(["0 mm", "0 mm"], ["20 mm", "0 mm"]),
            "c": blade(["5 mm", "-5 mm"], ["15 mm", "12.3 mm"]),
        }
        return missed(
            {"kind": "layout", "bodies": {"st": {"at": ["20 mm", "0 mm"]}}, "blades": blades,
             "moving": "st", "motion": "rotation"}, off,
        )  # fmt: skip

    stress, _ = found("4 mm")
    for b in ("45 mm", "70 mm"):
        value, (low, high) = found(b)
        assert value == pytest.approx(stress, rel=1e-6)
        assert low <= stress * 1.001
        assert stress <= high * 1.001
        assert high / low < 1.02
