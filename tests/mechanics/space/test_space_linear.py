import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from geometries_for_tests import SAMPLES, geometry
from scipy.linalg import eigh
from space_mechanisms import (
    STEEL,
    as_frame,
    blade,
    guide,
    random_mechanism,
    rod,
    rotation,
    turned,
)
from support import body_stiffness

from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.formulas.rigid_motion import motion_at
from flexcli.mechanics.linear import linear
from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import NeckUnderLoads
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.freedoms import freedoms
from flexcli.mechanics.space.inertia import mass_matrix
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceLoad,
)
from flexcli.mechanics.space.linear import assemble
from flexcli.mechanics.space.modes import natural_modes
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.space.springs import springs_of
from flexcli.parts.elastic import Elastic, NotAvailable

DIGITS = 1e-8  # two dense inversions of matrices whose entries differ by (l/h)² and units


@pytest.mark.parametrize("seed", range(8))
def test_compliance_is_that_of_a_frame_of_beams_written_out(seed):
    layout = random_mechanism(np.random.default_rng(seed))
    assembly, frame = assemble(layout), as_frame(layout)
    for number, body in enumerate(layout.bodies):
        C = assembly.compliance(body.name, body.point, locked=False)
        expected = frame.compliance(number)
        size = np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
        assert np.max(np.abs(C - expected) / size) < DIGITS


@pytest.mark.parametrize("seed", range(4))
def test_locked_drive_is_a_frame_with_one_motion_held(seed):
    layout = random_mechanism(np.random.default_rng(seed))
    drive = layout.drive
    held = np.zeros(12)
    held[6 + 3 * drive.turns : 9 + 3 * drive.turns] = drive.direction
    C = assemble(layout).compliance("b", layout.body("b").point, locked=True)
    expected = as_frame(layout).compliance(1, held)
    size = np.trace(np.abs(expected)) * np.ones((6, 6))
    assert np.max(np.abs(C - expected) / size) < 1e-6  # the frame's row is no unit vector
    e = np.array(drive.direction)
    assert np.max(np.abs(C[3 * drive.turns :][:3].T @ e)) < 1e-9 * np.abs(C).max()


@pytest.mark.parametrize("seed", range(4))
def test_what_a_load_here_moves_there_it_moves_here_from_there(seed):
    layout = random_mechanism(np.random.default_rng(seed))
    assembly = assemble(layout)
    a, b = layout.bodies
    one = assembly.load(SpaceLoad("a", a.com, (1.0, -2.0, 0.5), (0.01, 0.0, 0.02)))
    other = assembly.load(SpaceLoad("b", b.com, (0.3, 1.0, -2.0), (0.0, 0.03, 0.0)))
    found = assembly.moved(np.stack([one, other], axis=1)).coordinates
    assert one @ found[:, 1] == pytest.approx(other @ found[:, 0], rel=1e-9)


def test_bodies_that_move_as_one_strain_nothing():
    rng = np.random.default_rng(3)
    layout = random_mechanism(rng)
    loose = SpaceLayout(layout.bodies, layout.blades[1::3], layout.drive)
    assembly = assemble(loose)
    motion = rng.normal(size=6)
    d = np.concatenate([motion_at(b.point) @ motion for b in loose.bodies])
    d[6:] = np.linalg.solve(assembly.to_body, d[6:])
    assert np.max(np.abs(assembly.rows @ d)) < 1e-15


@pytest.mark.parametrize("seed", range(4))
def test_a_turned_mechanism_is_as_stiff(seed):
    rng = np.random.default_rng(seed)
    layout, R = random_mechanism(rng), rotation(rng)
    there = turned(layout, R, rng.uniform(-1.0, 1.0, 3))
    for locked in (False, True):
        here = assemble(layout).compliance("b", layout.body("b").point, locked=locked)
        other = assemble(there).compliance("b", there.body("b").point, locked=locked)
        T = np.kron(np.eye(2), R)
        size = np.abs(here).max(axis=0).max(axis=0)
        assert np.max(np.abs(T @ here @ T.T - other)) < 1e-9 * size
    one, same = (natural_modes(assemble(x), locked=False).angular for x in (layout, there))
    assert one == pytest.approx(same, rel=1e-8)


@pytest.mark.parametrize("size", [1e-6, 1e-3, 1.0])
def test_micrometres_and_metres_have_the_same_digits(size):
    def scaled(s):
        found = guide(l=0.1 * s, apart=0.07 * s, h=0.5e-3 * s, b=0.05 * s)
        return assemble(found).compliance("stage", found.bodies[0].point, locked=False)

    expected, units = scaled(1.0), np.array([1.0, 1.0, 1.0, size, size, size])
    found = scaled(size) * size * np.outer(units, units)
    where = np.abs(expected) > 1e-9 * np.sqrt(np.outer(np.diag(expected), np.diag(expected)))
    assert found[where] == pytest.approx(expected[where], rel=1e-9)


def _has_layout(kind):
    try:
        geometry(kind).layout(FLAT, geometry(kind).probe())
    except NotAvailable:
        return False
    return True


FLAT = Elastic(114e9, 0.0)
"""Without Poisson's ratio no factor of plates or sheets acts on what a plane knows."""


@pytest.mark.parametrize("kind", list(filter(_has_layout, SAMPLES)))
def test_blades_that_do_not_contract_are_the_planar_model_in_the_plane(kind):
    joint = geometry(kind)
    layout, turns = joint.layout(FLAT, joint.probe()), joint.motion == "rotation"
    # blades beside each other would tilt the body out of the plane
    layout = replace(layout, blades=tuple(replace(blade, z=0.0) for blade in layout.blades))
    held = (None, None, 1.0) if turns else (None, 1.0, None)
    expected = linear(layout, {"moving": held})
    stiffness = expected.reactions[0, layout.index("moving"), 2 if turns else 1]
    assembly = assemble(from_plane(layout, "moving", turns=turns))
    found = assembly.moved(travel=np.ones(1))
    assert float(found.drive[0]) == pytest.approx(float(stiffness), rel=1e-9)


def _ring(radius, degrees, height):
    turn = np.radians(degrees)
    return np.array([radius * np.cos(turn), radius * np.sin(turn), height])


def test_three_bipods_of_slender_struts_are_those_of_pin_joints():
    # K = Σ EA/l q qᵀ of the struts' lines; that of their bending is (d/l)² of it
    d = 0.1e-3
    pairs = [
        (_ring(0.08, 120 * foot + side, 0.0), _ring(0.05, 120 * k + 60, 0.06))
        for k in range(3)
        for foot, side in ((k, 15), (k + 1, -15))
    ]
    rods = tuple(rod(f"s{i}", "ground", "top", a, b, d=d) for i, (a, b) in enumerate(pairs))
    body = SpaceBody("top", (0.0, 0.0, 0.06), (0.0, 0.0, 0.06), 1.0)
    layout = SpaceLayout((body,), rods, Drive("top", False, (0.0, 0.0, 1.0), body.point))
    K = np.zeros((6, 6))
    for a, b in pairs:
        l = np.linalg.norm(b - a)
        e = (b - a) / l
        line = np.concatenate([e, np.cross(b - body.point, e)])
        K += STEEL.E * np.pi * d**2 / 4.0 / l * np.outer(line, line)
    C = assemble(layout).compliance("top", body.point, locked=False)
    assert 1.0 / np.diag(C) == pytest.approx(1.0 / np.diag(np.linalg.inv(K)), rel=1e-3)
    found = freedoms(assemble(layout))
    assert (found.of_moving, found.overconstraints) == (0, 0)


def test_modes_are_those_of_the_whole_matrices():
    layout = random_mechanism(np.random.default_rng(5))
    assembly = assemble(layout)
    M = mass_matrix(assembly)[:12, :12]
    K = assembly.rows.T @ (assembly.stiffness[:, None] * assembly.rows)
    expected = np.sqrt(eigh(K, M, eigvals_only=True))
    assert natural_modes(assembly, locked=False).angular == pytest.approx(expected, rel=1e-7)
    held = np.delete(np.arange(12), assembly.driven)
    expected = np.sqrt(eigh(K[np.ix_(held, held)], M[np.ix_(held, held)], eigvals_only=True))
    assert natural_modes(assembly, locked=True).angular == pytest.approx(expected, rel=1e-7)


def test_blades_of_a_guide_weigh_thirteen_thirtyfifths_of_their_mass():
    # of a beam clamped to a body that does not turn; turning (h/l)² besides
    assembly = assemble(guide(h=0.1e-3, mass=0.0))
    M = mass_matrix(assembly)[:6, :6]
    blades = 2.0 * 7800.0 * 0.1e-3 * 0.05 * 0.1
    assert M[0, 0] == pytest.approx(13.0 / 35.0 * blades, rel=1e-5)
    whole = mass_matrix(assembly)
    ones = np.zeros(12)
    ones[[0, 6]] = 1.0
    assert ones @ whole @ ones == pytest.approx(blades, rel=1e-12)


def test_a_body_on_nothing_is_refused():
    layout = guide()
    more = (*layout.bodies, SpaceBody("loose", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 1.0))
    with pytest.raises(SolveError, match="without resistance"):
        assemble(SpaceLayout(more, layout.blades, layout.drive)).compliance(
            "stage", (0.0, 0.0, 0.0), locked=False
        )


def _freedoms(*members, names=("top",)):
    bodies = tuple(SpaceBody(n, (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)) for n in names)
    drive = Drive(names[-1], False, (1.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    found = freedoms(assemble(SpaceLayout(bodies, members, drive)))
    assert found.weakest > 1e-3 > 1e3 * found.none  # a clear gap
    return found.of_moving, found.of_all, found.overconstraints


def test_freedoms_and_overconstraints_are_those_of_exact_constraint_design():
    one = blade("a", "ground", "top", (0, 0, 0), (0, 0.05, 0))
    assert _freedoms(one) == (3, 3, 0)
    beside = blade("b", "ground", "top", (0.04, 0, 0), (0.04, 0.05, 0))
    assert _freedoms(one, beside) == (1, 1, 1)
    across = blade("b", "ground", "top", (-0.025, 0.025, 0.0), (0.025, 0.025, 0))
    assert _freedoms(one, across) == (1, 1, 1)
    wire = rod("b", "ground", "top", (0.02, 0, 0.01), (0.02, 0.05, 0.01))
    assert _freedoms(one, wire) == (2, 2, 0)
    upright = blade("b", "ground", "top", (0.04, 0, 0.0), (0.04, 0, 0.05), width=(0, 1, 0))
    assert _freedoms(one, upright) == (1, 1, 1)
    tangential = [
        blade(f"t{k}", "ground", "top", R @ (0.03, -0.02, 0), R @ (0.03, 0.02, 0),
              width=R @ (1.0, 0, 0))
        for k in range(3)
        for c, s in [(np.cos(2.1 * k), np.sin(2.1 * k))]
        for R in [np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])]
    ]  # fmt: skip
    # blades in the plane of the ring hold it in that plane, three times over
    assert _freedoms(*tangential) == (3, 3, 6)
    inner = blade("c", "mid", "top", (0, 0.05, 0), (0, 0, 0))
    outer = blade("d", "ground", "mid", (0.04, 0, 0), (0.04, 0.05, 0))
    assert _freedoms(outer, inner, names=("mid", "top"))[0] > 3


def _hinge(kind, numbers, l, b, nu):
    """A notch, a taper, a blade or one with fillets, in units of 1 mm, as a blade in space."""
    sizes = [1e-3 * n for n in numbers]
    if kind == "taper":
        first, last, *between = sizes
        each = first, *between, last
        profile = Tabulated(tuple(np.linspace(0.0, 1.0, len(each))), each)
    else:
        profile = {"notch": Notch, "filleted": Filleted, "blade": Constant}[kind](*sizes)
    material = Isotropic(200e9, 200e9 / (2.0 + 2.0 * nu))
    ends = (0.0, 0.0, 0.0), (1e-3 * l, 0.0, 0.0)
    return SpaceBlade("h", "ground", "b", *ends, (0, 0, 1), profile, 1e-3 * b, material)


def _about_the_middle(blade):
    """Return six stiffnesses about the middle of a blade, each with all else free."""
    middle = tuple(np.add(blade.start, blade.end) / 2.0)
    body, drive = SpaceBody("b", middle, middle), Drive("b", False, (0, 1, 0), middle)
    assembly = assemble(SpaceLayout((body,), (blade,), drive))
    return 1.0 / np.diag(assembly.compliance("b", middle, locked=False))


def test_hinges_are_those_of_solids_within_what_is_told():
    """``tests/benchmarks/hinges_in_space.py``: at random over the ranges that are told."""
    rows = json.loads((Path(__file__).parent / "hinges.json").read_text(encoding="utf-8"))
    known = 0
    for *hinge, solid in rows:
        blade = _hinge(*hinge)
        springs = springs_of(blade)
        ratio = 200e9 * np.array(solid) / _about_the_middle(blade)
        known += springs.is_known
        if springs.is_known:
            mesh = 3e-3 if hinge[0] == "blade" else 0.0
            assert np.all(ratio > 1.0 + springs.low - mesh), hinge
            assert np.all(ratio < 1.0 + springs.high + mesh), hinge
    assert known > 260


@pytest.mark.parametrize(("e", "depth", "over", "nu"), [
    (0.0006, 1.0, 1.5, 0.0), (0.0006, 1.0, 15.0, 0.45), (0.003, 0.3, 5.0, 0.45),
    (0.003, 2.0, 4.0, 0.3), (0.003, 0.3, 90.0, 0.49),
    (0.1, 1.0, 0.08, 0.3), (0.4, 1.0, 0.3, 0.45),
])  # fmt: skip
def test_sharp_notches_are_those_of_our_solids_within_what_is_told(e, depth, over, nu):
    # sharper than CalculiX's, or thicker than wide; ``over`` is the width over √(e ρ)
    b = over * (e / depth) ** 0.5
    blade, solid = (
        _hinge("notch", [e, depth], 2.0, b, nu),
        NeckUnderLoads(Neck(e, depth, 2.0, b, 0.0, 0.0), 1.0, nu),
    )
    springs, scale = springs_of(blade), np.repeat([1e-3, 1e-9], 3)
    softness, off = np.array([solid.compliance(k) for k in range(6)]).T
    ratio = 200e9 * scale / softness / _about_the_middle(blade)
    assert springs.is_known
    assert np.all(ratio > 1.0 + springs.low - off)
    assert np.all(ratio < 1.0 + springs.high + off)


@pytest.mark.parametrize("spring", [0, 1, 4])
def test_a_notch_without_widening_is_its_beam_the_more_the_sharper_it_is(spring):
    # the throat gives way as √(ρ/e), what is beside it does not: one over the other vanishes
    width = [springs_of(_hinge("notch", [e, 1.0], 2.0, 1.0, 0.0)) for e in (1e-2, 1e-4, 1e-6)]
    low = np.array([each.low[spring] for each in width])
    assert np.all(np.diff(low) > 0.0)
    assert low[-1] > -0.011


@pytest.mark.parametrize("r", [0.02, 0.3, 4.0])
@pytest.mark.parametrize("nu", [0.0, 0.45])
def test_fillets_of_any_radius_are_between_no_fillets_and_a_blade_that_ends_where_they_begin(r, nu):
    filleted = _hinge("filleted", [0.5, r], 10.0, 6.0, nu)
    sharp, short = (_hinge("blade", [0.5], l, 6.0, nu) for l in (10.0, 10.0 - 2.0 * r))
    found, least, most = (springs_of(each) for each in (filleted, sharp, short))
    own, soft, stiff = (_about_the_middle(each) for each in (filleted, sharp, short))
    assert found.is_known
    assert np.all(own * (1.0 + found.low) >= soft * (1.0 + least.low) * (1.0 - DIGITS))
    assert np.all(own * (1.0 + found.high) <= stiff * (1.0 + most.high) * (1.0 + DIGITS))
    assert np.all(found.low <= 0.0)
    assert np.all(found.high >= 0.0)


@pytest.mark.parametrize(("h", "b"), [(3.0, 0.4), (1.2, 1.0)])
def test_a_blade_thicker_than_wide_is_one_turned_by_a_right_angle(h, b):
    upright, flat = (springs_of(_hinge("blade", [t], 20.0, w, 0.3)) for t, w in ((h, b), (b, h)))
    turned = [0, 2, 1, 3, 5, 4]
    assert upright.springs.stiffness.tolist() == flat.springs.stiffness[turned].tolist()
    assert upright.low.tolist() == flat.low[turned].tolist()
    assert upright.high.tolist() == flat.high[turned].tolist()
    assert np.all(np.isfinite(upright.high))


@pytest.mark.parametrize("hinge", [("notch", [0.2, 1.0], 2.0, 3.0, 0.3),
                                   ("filleted", [0.3, 1.0], 12.0, 5.0, 0.3)])  # fmt: skip
def test_a_hinge_is_at_rest_what_its_exact_beams_are(hinge):
    blade, end = _hinge(*hinge), (1e-3 * hinge[2], 0.0, 0.0)
    layout = SpaceLayout((SpaceBody("b", end, end),), (blade,), Drive("b", False, (0, 1, 0), end))
    linear = np.linalg.inv(assemble(layout).compliance("b", end, locked=False))
    exact = body_stiffness(solve(layout, levels=(32,)), "b", end)
    size = np.sqrt(np.outer(np.diag(linear), np.diag(linear)))
    assert np.max(np.abs(linear - exact) / size) < 1e-8


def test_a_necked_blade_is_two_blades_and_what_is_rigid_between():
    neck, l, middle = 4e-3, 20e-3, SpaceBody("m", (10e-3, 0, 0), (10e-3, 0, 0))
    material = Isotropic(200e9, 77e9)
    end = SpaceBody("b", (l, 0, 0), (l, 0, 0))
    drive = Drive("b", False, (0, 1, 0), (l, 0, 0))

    def blade(first, second, start, stop, profile):
        ends = (start, 0.0, 0.0), (stop, 0.0, 0.0)
        return SpaceBlade(first + second, first, second, *ends, (0, 0, 1), profile, 6e-3, material)

    whole = blade("ground", "b", 0.0, l, NeckedDown(0.2e-3, neck))
    parts = [blade("ground", "m", 0.0, neck, Constant(0.2e-3)),
             blade("m", "b", l - neck, l, Constant(0.2e-3))]  # fmt: skip
    one = assemble(SpaceLayout((end,), (whole,), drive))
    two = assemble(SpaceLayout((middle, end), tuple(parts), drive))
    C = two.compliance("b", (l, 0, 0), locked=False)
    size = np.sqrt(np.outer(np.diag(C), np.diag(C)))
    assert np.max(np.abs(one.compliance("b", (l, 0, 0), locked=False) - C) / size) < 1e-10
