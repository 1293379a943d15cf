"""Newton's steps of one design, all unknowns at once, against those by condensed blades."""

from dataclasses import replace

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, travel, varied
from mechanisms_for_tests import cantilever

from flexcli.formulas.profile import Tabulated
from flexcli.mechanics.assembly import assemble
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Load, Support
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of
from flexcli.mechanics.uncondensed import Uncondensed
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING


def burdened(layout, body):
    """Return a layout on springs, grown by a temperature, and loads on it."""
    x, y = layout.body(body).point
    tip = (x + 1e-3, y - 2e-3)
    loads = [Load(body, tip, (3e-3, -2e-3), 1e-5), Load(body, tip, (1e-3, 2e-3), follows=True)]
    grown = {"body_growth": {body: 1e-4}, "blade_growth": {layout.blades[0].name: -2e-5}}
    spring = Support(body, tip, (2.0, 3.0, 1e-3))
    return replace(layout, supports=(*layout.supports, spring), **grown), loads


def assert_same_steps(layout, held, loads, effects, start=None):
    rng, share, row = np.random.default_rng(3), np.array([0.7]), np.arange(1)
    for nodes in (5, 8):
        assembly = assemble(layout, effects, nodes)
        demand = demand_of(assembly, held, loads, start=start)
        x = rng.uniform(-0.3, 0.3, (1, assembly.size))
        for _ in range(8):  # rotations in equilibrium: else the steps differ in their second order
            at = assembly.linearise(x, share, row, demand)
            x[0, : assembly.turns] += np.concatenate([blade.free.ravel() for blade in at.blades])
        alone = Uncondensed(assembly, demand)
        both = assembly.steps(x, share, row, demand)
        for own, condensed in zip(alone.steps(x[0], share[0]), both, strict=True):
            assert own == pytest.approx(
                condensed[0], rel=0.0, abs=1e-11 * np.max(np.abs(condensed))
            )
        step = alone.step(x, share, row)
        assert step == pytest.approx(both[0], rel=0.0, abs=1e-11 * np.max(np.abs(step)))


@pytest.mark.parametrize("kind", SAMPLES)
def test_steps_of_every_joint_of_the_plane_are_those_by_condensed_blades(kind):
    joint = varied(kind, np.random.default_rng(7))
    try:
        plain = joint.plane_layout(ELASTIC, joint.sized({}))
    except NotAvailable:
        pytest.skip("not a joint of the plane")
    layout, loads = burdened(plain, MOVING)
    stroke = {MOVING: joint.held(travel(joint))}
    for effects in (Effects(), Effects(extension=False, shear=False)):
        assert_same_steps(plain, stroke, (), effects)
        assert_same_steps(layout, {}, loads, Effects())
    start = solve(layout, stroke, loads=loads[:1])
    assert_same_steps(layout, {}, loads, Effects(), start)


def test_steps_of_blades_of_different_pieces_are_those_by_condensed_blades():
    plain = cantilever()
    notched = Tabulated((0.0, 0.3, 1.0), (2e-4, 1e-4, 3e-4))
    blade = replace(plain.blades[0], name="second", profile=notched, start=(0.0, 5e-3))
    layout, loads = burdened(replace(plain, blades=(*plain.blades, blade)), "tip")
    assert_same_steps(layout, {"tip": (None, 1e-4, None)}, loads, Effects())
