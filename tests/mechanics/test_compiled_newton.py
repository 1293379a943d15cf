"""Batches solved by compiled code against the arrays that these stand in for."""

from dataclasses import replace

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, geometry, travel, varied
from mechanisms_for_tests import cantilever, pivot

from flexcli.errors import Outcome
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Body, Load, Support
from flexcli.mechanics.mesh import Effects
from flexcli.numerics.compilation import compiled
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING

pytest.importorskip("numba")

pytestmark = pytest.mark.slow  # a fresh copy compiles for a quarter of a minute first

TOLERANCE = 1e-12
"""What both are asked for: Newton's method ends far below it."""

DIGITS = 3e-11
"""Of the largest force or motion: what sums in another order leave, some h²/l² times amplified."""


def both(layout, held, **how):
    """Return what is solved by compiled code and by arrays."""
    found = []
    for is_so in (True, False):
        with compiled(is_so):
            found.append(solve(layout, held, tolerance=TOLERANCE, **how))
    return found


def assert_same(fast, arrays):
    assert fast.outcome == arrays.outcome
    assert fast.nodes.tolist() == arrays.nodes.tolist()
    for mine, theirs in (
        (fast.motions[..., :2], arrays.motions[..., :2]),
        (fast.motions[..., 2], arrays.motions[..., 2]),
        (fast.end_forces[..., :2], arrays.end_forces[..., :2]),
        (fast.end_forces[..., 2], arrays.end_forces[..., 2]),
    ):
        assert mine == pytest.approx(theirs, rel=0.0, abs=DIGITS * np.max(np.abs(theirs)))


@pytest.mark.parametrize("kind", SAMPLES)
def test_every_joint_of_the_plane_has_the_same_digits_compiled(kind):
    rng = np.random.default_rng(7)
    joint = varied(kind, rng)
    try:
        layout = joint.plane_layout(ELASTIC, joint.sized({}))
    except NotAvailable:
        pytest.skip("not a joint of the plane")
    point = layout.body(MOVING).point
    tip = (point[0] + 1e-3, point[1] - 2e-3)
    loads = [
        Load(MOVING, tip, (3e-3, -2e-3), 1e-5),
        Load(MOVING, tip, (1e-3, 2e-3), follows=True),
    ]
    spring = Support(MOVING, tip, (2.0, 3.0, 1e-3))
    grown = {"body_growth": {MOVING: 1e-4}, "blade_growth": {layout.blades[0].name: -2e-5}}
    layout = replace(layout, supports=(*layout.supports, spring), **grown)
    assert_same(*both(layout, {MOVING: joint.held(travel(joint))}, loads=loads))


def test_designs_of_a_batch_have_the_same_digits_compiled():
    rng, n = np.random.default_rng(8), 40
    l = 20e-3 * rng.uniform(0.5, 1.5, n)
    many = pivot(h=10.0 ** rng.uniform(-4.5, -3.5, n), l=l, delta=rng.uniform(-1.0, 1.0, n))
    turn, pull = rng.uniform(-0.5, 0.5, n), rng.uniform(-1e-3, 1e-3, n)
    load = Load("out", (1e-3 * l / l, 0.0), (pull, 0.0))
    assert_same(*both(many, {"out": (None, None, turn)}, loads=[load]))


def test_a_path_from_another_equilibrium_is_the_same_compiled():
    layout = pivot(h=1e-4 * np.linspace(0.8, 1.2, 5))
    start = solve(layout, {"out": (None, None, 0.2)}, tolerance=TOLERANCE)
    assert_same(*both(layout, {"out": (1e-4, None, 0.1)}, start=start))


def test_blades_that_neither_stretch_nor_shear_are_the_same_compiled():
    effects = Effects(extension=False, shear=False)
    assert_same(*both(pivot(), {"out": (None, None, 0.3)}, effects=effects))


def test_a_design_without_an_answer_is_told_compiled_too():
    loose = replace(cantilever(), bodies=(*cantilever().bodies, Body("loose", (1.0, 0.0))))
    fast, arrays = both(loose, {}, loads=[Load("tip", (20e-3, 0.0), (0.0, 1e-2))])
    assert fast.outcome == arrays.outcome == (Outcome.SINGULAR,)


def test_blades_of_different_pieces_are_solved_by_arrays():
    notched = geometry("notch-hinge").plane_layout(ELASTIC, geometry("notch-hinge").sized({}))
    plain = cantilever()
    mixed = replace(plain, blades=(*plain.blades, replace(
        plain.blades[0], name="notched", profile=notched.blades[0].profile,
        start=(0.0, 5e-3), end=(notched_length(notched), 5e-3),
    )))  # fmt: skip
    fast, arrays = both(mixed, {"tip": (None, 1e-4, None)})
    assert_same(fast, arrays)
    assert fast.converged.all()


def notched_length(layout):
    start, end = layout.blades[0].start, layout.blades[0].end
    return float(np.hypot(end[0] - start[0], end[1] - start[1]))


def test_a_design_has_the_same_digits_in_any_batch():
    rng, n = np.random.default_rng(9), 60
    h, l, turn = 10.0 ** rng.uniform(-4.3, -3.7, n), rng.uniform(10e-3, 30e-3, n), 0.3
    for is_so in (True, False):
        with compiled(is_so):
            whole, *parts = (
                solve(pivot(h=h[some], l=l[some]), {"out": (None, None, turn)})
                for some in (slice(None), slice(0, 7), slice(7, 40), slice(40, n))
            )
        together = np.concatenate([part.end_forces for part in parts])
        assert (together == whole.end_forces).all()
