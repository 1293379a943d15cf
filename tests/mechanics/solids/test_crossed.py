"""Crossed blades of one piece as solids: CalculiX's, other plane elements, limits, symmetries."""

import json
from math import cos, radians, sin
from pathlib import Path

import numpy as np
import pytest

from flexcli.errors import SolveError
from flexcli.formulas.solid_crossing import solid_crossing
from flexcli.mechanics.solids.condensed import Part, joined, without
from flexcli.mechanics.solids.crossed import Crossed, CrossedMesh, CrossedSolid, graded
from flexcli.mechanics.solids.crossed_joint import crossed_aside, crossed_joint
from flexcli.mechanics.solids.extruded import (
    even_and_odd,
    flat,
    over_face,
    plane_stress,
    solid_law,
)

PARTS = Path(__file__).parents[2] / "parts"
PLANE = CrossedMesh(5, 1e-4, 5.0, 0.5, 2.0)
COARSE = CrossedMesh(3, 0.1, 20.0, 0.9, 2.0)
X, Y, TURN = range(3)
STAGE, BASE = range(2)

PLANE_ELEMENTS = 1e-3
"""What other plane elements, which are not graded towards the clamps, are too stiff by at most."""

MESHED = 0.006
"""What CalculiX's elements of h/30 at the corners leave too much of a stiffness up to 65°."""


def rows(name):
    return json.loads((PARTS / name).read_text(encoding="utf-8"))


def plane(h, crossing, degrees, nu, law=plane_stress):
    return CrossedSolid(Crossed(h, 1.0, crossing, radians(degrees)), law(1.0, nu), flat(1.0), PLANE)


def driven(K):
    """Return the stiffness in rotation of a body that is free otherwise, and its motion along y."""
    along = -K[Y, TURN] / K[Y, Y]
    return K[TURN, TURN] + K[TURN, Y] * along, along


@pytest.mark.parametrize("row", rows("plane_joints.json")[4:10:2])
def test_planes_are_as_stiff_as_those_of_other_elements(row):
    h, crossing, degrees, nu, stiffness, across = row
    k, along = driven(plane(h, crossing, degrees, nu).stiffness)
    assert k / (8.0 * h**3 / 12.0) == pytest.approx(stiffness, rel=PLANE_ELEMENTS)
    assert along == pytest.approx(across, rel=PLANE_ELEMENTS, abs=1e-4 * h)


@pytest.mark.parametrize("row", rows("plane_shifts.json")[4::5])
def test_planes_shift_in_second_order_as_those_of_other_elements(row):
    h, crossing, degrees, nu, ratio = row
    thin = (crossing**3 + (1.0 - crossing) ** 3) / 15.0 / cos(radians(degrees))
    assert plane(h, crossing, degrees, nu).second().green / thin == pytest.approx(ratio, rel=2e-3)


@pytest.mark.parametrize(("at", "nu"), [(17, 0.0), (17, 0.45), (18, 0.45), (19, 0.45), (22, 0.45)])
def test_solids_are_as_stiff_as_those_of_calculix(at, nu):
    row = rows("crossed_solids.json")[at]
    h, b, crossing, degrees, *stiff = row
    found = crossed_joint(h, b, crossing, radians(degrees), nu).diagonal
    own = 1.0 / found.value[TURN] / (8.0 * b * h**3 / 12.0)
    off = found.off[TURN] / found.value[TURN]
    assert 1.0 - off <= stiff[0 if nu == 0.0 else 2] / own <= 1.0 + off + MESHED
    assert off < 0.015


@pytest.mark.parametrize("row", rows("crossed_whole.json"))
def test_what_arms_bear_and_how_the_body_moves_is_that_of_calculix(row):
    h, b, crossing, degrees, nu, *compliances, across, shift, arms = row
    found = crossed_joint(h, b, crossing, radians(degrees), nu)
    for own, off, expected in zip(*found.diagonal, compliances, strict=True):
        assert abs(own - expected) <= off + MESHED * own
    assert abs(found.coupled.value - across) <= found.coupled.off
    least, most = found.shift
    assert least <= shift <= most
    ours = found.borne.value[:, :, BASE].reshape(6, 3)
    off = found.borne.off[:, :, BASE].reshape(6, 3)
    assert np.all(np.abs(ours - arms) <= off)


@pytest.mark.parametrize("row", rows("crossed_aside.json")[::2])
def test_solids_give_way_out_of_their_plane_as_those_of_calculix(row):
    h, b, crossing, degrees, nu, *expected = row
    found = crossed_aside(h, b, crossing, radians(degrees), nu).diagonal
    assert np.all(np.abs(found.value - expected) <= found.off)
    assert np.all(found.off < 0.03 * found.value)


def test_a_force_aside_through_the_middle_of_equal_halves_tilts_nothing():
    # between both ends, not at the centre where they are as long
    found = crossed_aside(0.1, 0.2, 0.5, radians(50.0), 0.3)
    mirrored = crossed_aside(0.1, 0.2, 0.4, radians(50.0), 0.3)
    assert abs(found.coupled.value) <= found.coupled.off
    assert mirrored.coupled.value > 10.0 * mirrored.coupled.off


def test_without_a_poisson_ratio_a_solid_of_any_width_is_in_plane_stress():
    sizes, b = Crossed(0.15, 1.0, 0.4, radians(55.0)), 0.3
    width = even_and_odd(np.array([0.05, b / 2.0]), 4)
    solid = CrossedSolid(sizes, solid_law(1.0, 0.0), width, COARSE)
    same = CrossedSolid(sizes, plane_stress(1.0, 0.0), flat(b), COARSE)
    np.testing.assert_allclose(solid.stiffness, same.stiffness, rtol=1e-8, atol=1e-12)
    np.testing.assert_allclose(solid.second(), same.second(), rtol=1e-7)
    motion = [0.2, -0.1, 0.3]
    np.testing.assert_allclose(solid.borne(motion), same.borne(motion), rtol=1e-7, atol=1e-12)


def test_a_wide_solid_tends_to_plane_strain():
    sizes, nu, ratios = Crossed(0.15, 1.0, 0.4, radians(55.0)), 0.3, []
    strain = driven(CrossedSolid(sizes, solid_law(1.0, nu), flat(1.0), COARSE).stiffness)[0]
    stress = driven(CrossedSolid(sizes, plane_stress(1.0, nu), flat(1.0), COARSE).stiffness)[0]
    for b in (1.0, 10.0, 40.0):
        cuts = b / 2.0 - np.array([2.0, 0.5, 0.1, 0.0])
        width = even_and_odd(cuts[cuts > 0.0], 4)
        solid = CrossedSolid(sizes, solid_law(1.0, nu), width, COARSE)
        ratios.append((driven(solid.stiffness)[0] / b - stress) / (strain - stress))
    assert 0.0 < ratios[0] < ratios[1] < ratios[2] < 1.0
    # what free sides lack is of two ends, and the same at any width
    assert (1.0 - ratios[2]) * 4.0 == pytest.approx(1.0 - ratios[1], rel=0.1)


def test_a_joint_the_other_way_round_has_the_same_arms():
    one, other = (crossed_joint(0.15, 0.2, c, radians(40.0), 0.3) for c in (0.4, 0.6))
    off = one.diagonal.off + other.diagonal.off
    assert np.all(np.abs(one.diagonal.value - other.diagonal.value) <= off)
    assert one.diagonal.value == pytest.approx(other.diagonal.value, rel=1e-6)
    assert one.coupled.value == pytest.approx(-other.coupled.value, rel=1e-5)
    # a moment is borne by the arm at +α towards the body as by that at −α towards the base
    N, V, M = np.moveaxis(one.borne.value[TURN], -1, 0)
    n, v, m = np.moveaxis(other.borne.value[TURN], -1, 0)
    np.testing.assert_allclose(V[0, STAGE], -v[1, BASE], rtol=1e-5)
    np.testing.assert_allclose(M[0, STAGE], -m[1, BASE], rtol=1e-5)
    np.testing.assert_allclose(N[0, STAGE], n[1, BASE], rtol=1e-5)


def test_arms_bear_what_loads_the_body():
    alpha = radians(33.0)
    found = crossed_joint(0.12, 0.1, 0.35, alpha, 0.3).borne.value
    for arm, sign in ((STAGE, 1.0), (BASE, -1.0)):
        total = np.zeros((3, 3))
        for blade, y in ((0, sin(alpha)), (1, -sin(alpha))):
            c, s = sign * cos(alpha), sign * y
            N, V, M = found[:, blade, arm].T
            total += np.stack([N * c - V * s, N * s + V * c, M], axis=-1)
        np.testing.assert_allclose(total, sign * np.eye(3), atol=1e-6)


def test_a_slender_joint_is_as_stiff_as_its_formula_has_it():
    h, crossing, alpha = 0.01, 0.4, radians(50.0)
    found = crossed_joint(h, 0.02, crossing, alpha, 0.0).diagonal
    own = 1.0 / found.value[TURN] / (8.0 * 0.02 * h**3 / 12.0)
    at = {"half_angle": alpha, "crossing": crossing, "poisson_ratio": 0.0}
    shared = 1.0 - 12.0 * h**2  # what shear and stretching take, h²/l² times 9 to 15
    expected = float(solid_crossing(h=h, l=1.0, **at)) * shared
    assert own == pytest.approx(expected, rel=2e-3)


@pytest.mark.parametrize(
    ("sizes", "why"),
    [
        ((0.3, 0.3, 0.2, radians(60.0), 0.3), "beyond the crossing"),
        ((0.1, 0.3, 0.4, radians(3.0), 0.3), "half-angles"),
        ((0.1, 0.3, 0.4, radians(40.0), 0.495), "Poisson"),
        ((0.002, 0.3, 0.4, radians(40.0), 0.3), "slender"),
    ],
)
def test_what_elements_cannot_tell_is_refused(sizes, why):
    with pytest.raises(SolveError, match=why):
        crossed_joint(*sizes)


def test_elements_strain_nothing_as_a_body_moves_and_all_alike_as_it_grows():
    corners, b, nu = np.array([[0.0, 0.0], [1.0, 0.2], [1.3, 1.1], [-0.1, 0.8]]), 0.7, 0.3
    width = even_and_odd(np.array([0.1, b / 2.0]), 4)
    face = over_face(corners, 3)
    K = face.stiffness(solid_law(2.0, nu), width, width.products())
    one = np.array([-1.0, -np.sqrt(0.2), np.sqrt(0.2), 1.0])
    u, v = (each.ravel() for each in np.meshgrid(one, one, indexing="ij"))
    values = np.stack([(1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v)])
    x, y = (values.T @ corners / 4.0).T
    even, odd = width.plane.shape[1], width.along.shape[1]
    z = width.z
    turn = np.concatenate([np.outer(-y, np.ones(even)), np.outer(x, np.ones(even))], axis=1)
    turn = np.concatenate([turn, np.zeros((x.size, odd))], axis=1).ravel()
    assert np.abs(K @ turn).max() < 1e-12
    pulled = [
        np.outer(x, np.ones(even)),
        np.outer(-nu * y, np.ones(even)),
        np.outer(1.0 + 0 * x, -nu * z),
    ]
    pulled = np.concatenate(pulled, axis=1).ravel()
    area = 0.5 * abs(
        np.dot(corners[:, 0], np.roll(corners[:, 1], -1))
        - np.dot(corners[:, 1], np.roll(corners[:, 0], -1))
    )
    assert pulled @ K @ pulled == pytest.approx(2.0 * area * b, rel=1e-12)


def test_what_is_eliminated_is_what_forces_leave_it():
    rng = np.random.default_rng(1)
    A = rng.normal(size=(6, 6))
    whole = Part(np.array([0, 2, 3, 5, 7, 8]), A @ A.T + np.eye(6))
    rest, gone = without(whole, np.array([2, 7]))
    u = np.zeros(9)
    u[rest.motions] = rng.normal(size=4)
    gone.recover(u)
    forces = whole.K @ u[whole.motions]
    assert forces[[1, 4]] == pytest.approx(0.0, abs=1e-12)
    np.testing.assert_allclose(rest.K @ u[rest.motions], forces[[0, 2, 3, 5]])
    both = joined([whole, Part(np.array([5, 9]), np.eye(2))])
    assert both.K[3, 3] == pytest.approx(whole.K[3, 3] + 1.0)


def test_elements_grow_from_both_ends_and_are_no_longer_than_the_longest():
    sizes = np.diff(graded(7.0, 0.1, 5.0, 2.0))
    np.testing.assert_allclose(sizes, sizes[::-1])
    assert sizes.sum() == pytest.approx(7.0)
    assert sizes[0] == pytest.approx(0.1)
    assert sizes.max() <= 2.0
    assert sizes[1] == pytest.approx(5.0 * sizes[0])
