"""The 6×6 support of every flexure that has a layout, beside its own closed forms."""

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, asked, geometry, travel
from hypothesis import given, settings
from hypothesis import strategies as st
from planar_support import support_compliance
from support import compliance_from

from flexcli.formulas.blade_spring import SHEAR_FACTOR
from flexcli.formulas.rigid_motion import axes_about_z, motion_at
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING

PLANE = (0, 1, 5)
"""Where x, y and φ stand among the six motions."""

STRETCH = 3e-6
"""Closed forms leave out the stretch of the blades, some (h/l)²: 2.5e-7 of the thin samples."""

KINDS = [
    kind
    for kind in SAMPLES
    if not isinstance(asked(geometry(kind).layout, ELASTIC, geometry(kind).probe()), NotAvailable)
]

every_kind = pytest.mark.parametrize("kind", KINDS)
places = st.tuples(*[st.floats(-0.02, 0.02)] * 3)


def layout(kind, **changes):
    part = geometry(kind, **changes)
    return part.layout(ELASTIC, part.probe())


def centre(found):
    """Return the reference point of the moving body."""
    ((x, y),) = (body.point for body in found.bodies if body.name == MOVING)
    return x, y, 0.0


def scaled(matrix, like):
    """Return a compliance or stiffness over the size of its rows and columns."""
    size = 1.0 / np.sqrt(np.diag(like))
    return matrix * np.outer(size, size)


def stiffness_of_stroke(part, shear_factor=np.inf):
    """Return what the assembled joint resists its stroke with; Euler's blades by default."""
    held = part.held(travel(part))
    index = [PLANE[k] for k, motion in enumerate(held) if motion is not None]
    motion = np.array([motion for motion in held if motion is not None])
    found = part.layout(ELASTIC, part.probe())
    C = support_compliance(found, MOVING, centre(found), shear_factor=shear_factor)
    return motion @ np.linalg.solve(C[np.ix_(index, index)], motion) / (motion @ motion)


def test_only_torsion_bars_have_no_layout():
    assert {geometry(kind).strain for kind in set(SAMPLES) - set(KINDS)} == {"twist"}


@every_kind
def test_the_closed_form_is_the_assembled_stiffness_without_shear(kind):
    part = geometry(kind, **({"h": 0.01} if "h" in SAMPLES[kind] else {"e": 0.005}))
    assembled = stiffness_of_stroke(part)
    assert part.stiffness(ELASTIC, part.probe()) == pytest.approx(assembled, rel=STRETCH)


BLADES = [kind for kind in KINDS if geometry(kind).blade(geometry(kind).probe()) is not None]


@pytest.mark.parametrize("kind", BLADES)
def test_shear_softens_the_stroke_by_the_stated_share_of_s_bending(kind):
    """s Φ of the stiffness to first order, Φ = (12/5)(1 + ν)(h/l)² of a blade between clamps."""
    part = geometry(kind, h=0.5)
    blade = part.blade(part.probe())
    phi = 2.4 * (1.0 + ELASTIC.nu) * (blade.h / blade.l) ** 2
    lost = 1.0 - stiffness_of_stroke(part, SHEAR_FACTOR) / stiffness_of_stroke(part)
    assert lost == pytest.approx(part.s_bending_share(part.probe()) * phi, rel=0.05, abs=1e-9)


@every_kind
@settings(max_examples=10)
@given(point=places)
def test_matrices_are_symmetric_and_positive_definite(kind, point):
    matrix = support_compliance(layout(kind), MOVING, point)
    np.testing.assert_array_equal(matrix, matrix.T)
    assert np.linalg.eigvalsh(scaled(matrix, matrix)).min() > 0.0


@every_kind
@settings(max_examples=10)
@given(point=places, turn=st.floats(-3.0, 3.0))
def test_moved_to_another_point_and_axes_they_agree(kind, point, turn):
    found, axes = layout(kind), axes_about_z(turn)
    here = support_compliance(found, MOVING, (0.0, 0.0, 0.0))
    there = support_compliance(found, MOVING, point, axes)
    moved = compliance_from(here, point, axes)
    np.testing.assert_allclose(scaled(moved, there), scaled(there, there), atol=1e-9)


@every_kind
@settings(max_examples=5)
@given(scale=st.floats(0.01, 100.0))
def test_compliance_scales_as_its_units(kind, scale):
    """All lengths times s: m/N by 1/s, 1/N by 1/s², rad/(N·m) by 1/s³."""
    small, large = layout(kind), geometry(kind, scale)
    large = large.layout(ELASTIC, large.probe())
    units = np.array([1.0] * 3 + [1.0 / scale] * 3)
    one = support_compliance(small, MOVING, centre(small))
    other = support_compliance(large, MOVING, centre(large))
    expected = one * np.outer(units, units) / scale
    np.testing.assert_allclose(scaled(other, expected), scaled(expected, expected), atol=1e-10)


@every_kind
def test_a_force_elsewhere_is_a_force_and_a_moment_at_the_centre(kind):
    """Reciprocity seen by a user: the motion at the point of a force is F · C there."""
    found, offset = layout(kind), np.array([2e-3, -3e-3, 4e-3])
    C = support_compliance(found, MOVING, centre(found))
    there = support_compliance(found, MOVING, tuple(np.add(centre(found), offset)))
    force = np.array([1.0, -2.0, 3.0, 0.0, 0.0, 0.0])
    at_centre = motion_at(offset).T @ force
    moved = motion_at(offset) @ (C @ at_centre)
    assert moved == pytest.approx(there @ force, rel=1e-8, abs=1e-9 * np.abs(moved).max())
