"""Bodies and blades that a temperature grows: nothing where all grow alike, misfit where not."""

from dataclasses import replace

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, geometry
from paths import trace

from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.linear import linear
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import GROUND, MOVING

E, H, L, B = 110e9, 2e-4, 20e-3, 5e-3
STIFFNESS = E * H * B
EULER = (2.0 * np.pi) ** 2 / 12.0 * (H / L) ** 2
"""Strain at which a blade between two bodies that stand still buckles."""


def stage(**growth):
    """Return two blades side by side that carry a body."""
    blades = tuple(
        Blade(name, GROUND, MOVING, (0.0, y), (L, y), Constant(H), B)
        for name, y in (("low", 0.0), ("high", 15e-3))
    )
    return Layout((Body(MOVING, (1.2 * L, 5e-3)),), blades, E=E, G=42e9, **growth)


def alike(layout, strain):
    """Return a layout of which everything has grown by one strain."""
    names = [GROUND, *(body.name for body in layout.bodies)]
    return replace(
        layout,
        body_growth=dict.fromkeys(names, strain),
        blade_growth={blade.name: strain for blade in layout.blades},
    )


def plane_layout(kind):
    joint = geometry(kind)
    try:
        return joint.plane_layout(ELASTIC, joint.sized({}))
    except NotAvailable:
        return pytest.skip("not a joint of the plane")


@pytest.mark.parametrize("kind", SAMPLES)
def test_what_grows_everywhere_alike_is_larger_and_strains_nothing(kind):
    layout, strain = plane_layout(kind), -2e-3
    grown = alike(layout, strain)
    found = linear(grown, {})
    stiff = ELASTIC.E * max(float(blade.b) for blade in layout.blades) * 1e-4
    assert np.max(np.abs(found.end_forces[..., :2])) < 1e-9 * strain**2 * stiff + 1e-12 * stiff
    for body, moved in zip(layout.bodies, found.motions[0], strict=True):
        assert moved[:2] == pytest.approx(strain * np.array(body.point), abs=1e-12)


@pytest.mark.parametrize("solver", [linear, solve])
def test_a_blade_that_may_not_grow_is_pressed_by_its_stiffness_times_the_strain(solver):
    strain = 0.3 * EULER
    held = {MOVING: (0.0, 0.0, 0.0)}
    found = solver(stage(blade_growth={"low": strain, "high": -strain}), held)
    forces = found.end_forces[0, :, 0]
    assert forces == pytest.approx([-STIFFNESS * strain, STIFFNESS * strain], rel=1e-9)


@pytest.mark.parametrize(("share", "unstable"), [(0.97, False), (1.03, True)])
def test_blades_that_may_not_grow_buckle_at_eulers_strain(share, unstable):
    # the blade shortens and shears before it buckles, by as much as its strain there
    strain = share * EULER
    grown = stage(blade_growth={"low": strain, "high": strain})
    found = solve(grown, {MOVING: (0.0, 0.0, 0.0)})
    assert bool(found.unstable[0]) is unstable


def test_a_blade_longer_than_the_other_turns_the_body():
    strain = 1e-4
    found = solve(stage(blade_growth={"low": strain}), {})
    # both blades bend as much as the body turns, which takes next to no stretching
    assert found.motions[0, 0, 2] == pytest.approx(strain * L / 15e-3, rel=1e-3)


def test_a_hot_hub_presses_blades_around_it_by_its_own_growth():
    hub, outer, strain, blades = 3e-3, 12e-3, 2e-4, 5
    around = [2.0 * np.pi * i / blades for i in range(blades)]
    spokes = tuple(
        Blade(
            f"{i}", GROUND, MOVING, (outer * np.cos(a), outer * np.sin(a)),
            (hub * np.cos(a), hub * np.sin(a)), Constant(H), B,
        )
        for i, a in enumerate(around)
    )  # fmt: skip
    layout = Layout((Body(MOVING, (0.0, 0.0)),), spokes, E=E, G=42e9, body_growth={MOVING: strain})
    found = solve(layout, {})
    forces = np.hypot(*found.end_forces[0, :, :2].T)
    assert forces == pytest.approx(STIFFNESS * strain * hub / (outer - hub), rel=1e-9)
    assert np.abs(found.motions).max() < 1e-15


def test_the_temperature_may_come_before_the_load_or_with_it():
    grown = stage(body_growth={MOVING: 3e-3}, blade_growth={"low": 1e-4})
    load = Load(MOVING, (L, 0.0), (-3.0, 1.0))
    warm = solve(grown, {})
    after, together = solve(grown, {}, loads=[load], start=warm), solve(grown, {}, loads=[load])
    assert after.motions == pytest.approx(together.motions, rel=1e-8)


def test_a_path_warms_as_it_goes():
    grown = stage(blade_growth={"low": 2e-3, "high": -1e-3})
    path = trace(grown, {})
    share = path.share[-1]
    scaled = stage(blade_growth={"low": 2e-3 * share, "high": -1e-3 * share})
    # but for the levers, which have their length from the start
    assert path.states[-1].motions[0, 0] == pytest.approx(solve(scaled, {}).motions[0, 0], rel=2e-3)


def test_a_turned_drawing_grows_the_same_way():
    angle, load = 0.7, 2.0
    c, s = np.cos(angle), np.sin(angle)

    def turn(point):
        return c * point[0] - s * point[1], s * point[0] + c * point[1]

    plain = stage(body_growth={MOVING: 2e-3, GROUND: 1e-3}, blade_growth={"high": 5e-4})
    turned = replace(
        plain,
        bodies=tuple(b._replace(point=turn(b.point)) for b in plain.bodies),
        blades=tuple(replace(b, start=turn(b.start), end=turn(b.end)) for b in plain.blades),
    )
    one = solve(plain, {}, loads=[Load(MOVING, (0.0, 0.0), (0.0, load))]).motions[0, 0]
    push = Load(MOVING, (0.0, 0.0), turn((0.0, load)))
    other = solve(turned, {}, loads=[push]).motions[0, 0]
    assert other == pytest.approx([*turn(one[:2]), one[2]], rel=1e-8)
