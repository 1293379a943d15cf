"""The bound on loads that leave the plane is below what leaves it, and near it."""

from dataclasses import replace
from math import pi, sqrt

import numpy as np
import pytest
from scipy.optimize import brentq

from flexcli.formulas.profile import Constant
from flexcli.mechanics.lateral_bound import lateral_bound
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.space.exact.critical import straight_critical_factor
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.layout import SpaceLoad
from flexcli.mechanics.space.planar import from_plane

E, NU = 114e9, 0.33
G = E / 2.0 / (1.0 + NU)


def strip(h, b, l, tip=None):
    """Return a blade along x with its body at the tip, or elsewhere."""
    blade = Blade("blade", "ground", "tip", (0.0, 0.0), (l, 0.0), Constant(h), b)
    return Layout((Body("tip", tip or (l, 0.0)),), (blade,), E, G)


def bound(layout, *loads, directed=True, **how):
    """Return the bound of one design under loads that act together."""
    (found,) = lateral_bound(layout, [loads], directed=directed, driven=1, **how)
    return float(found)


def strong_and_torsion(h, b):
    """Return √(EI GJ) of a strip that is bent about its stiff axis [N·m²]."""
    J = h * b**3 / 3.0 * (1.0 - 0.63 * b / h)
    return sqrt(E * h * b**3 / 12.0 * G * J)


def test_a_column_bears_eulers_load_across_its_width():
    h, b, l = 1e-3, 0.2e-3, 50e-3
    euler = pi**2 * E * h * b**3 / 12.0 / (4.0 * l**2)
    found = bound(strip(h, b, l), Load("tip", (l, 0.0), (-1.0, 0.0)))
    assert found == pytest.approx(euler, rel=1e-3)
    assert found < euler


def test_a_wide_column_twists():
    h, b, l = 0.1e-3, 20e-3, 10e-3
    J = b * h**3 / 3.0 * (1.0 - 0.63 * h / b)
    twists = G * J * 12.0 / (b**2 + h**2)
    found = bound(strip(h, b, l), Load("tip", (l, 0.0), (-1.0, 0.0)))
    assert found == pytest.approx(twists, rel=1e-6)


@pytest.mark.parametrize("sense", [1.0, -1.0])
def test_a_strip_under_a_force_at_its_tip_bears_no_less(sense):
    # Timoshenko & Gere (1961), 6.3: 4.013 √(EI GJ)/l² of a dead force on the middle of its end
    h, b, l = 10e-3, 0.5e-3, 100e-3
    known = 4.013 * strong_and_torsion(h, b) / l**2
    found = bound(strip(h, b, l), Load("tip", (l, 0.0), (0.0, sense)))
    assert 0.2 * known < found < known


def test_a_strip_under_a_moment_bears_no_less():
    # Timoshenko & Gere (1961), 6.1: π √(EI GJ)/(2 l), clamped at one end as half of one on forks
    h, b, l = 10e-3, 0.5e-3, 100e-3
    known = pi / 2.0 * strong_and_torsion(h, b) / l
    found = bound(strip(h, b, l), Load("tip", (l, 0.0), moment=1.0))
    assert 0.3 * known < found < known


def arm(sense, ratio):
    """Return (k l)² of a column with a stiff arm of l/ratio, pushed in front or pulled behind.

    ``u tan u = ratio`` and ``u tanh u = ratio``: clamped at one end, of length u/k.
    """
    if sense > 0.0:
        return brentq(lambda u: u * np.tanh(u) - ratio, 1e-6, 10.0) ** 2
    return brentq(lambda u: u * np.tan(u) - ratio, 1e-6, pi / 2.0 - 1e-9) ** 2


# CalculiX 2.20, *BUCKLE of whole solids (C3D20R, 1137 nodes, ν 0.33; the body 3000 times as stiff,
# held across at the loaded point): h, b, l, spacing, length of the body [mm], sense, factor [N]
SOLIDS = [
    (0.2, 3.0, 10.0, 10.0, 60.0, -1.0, 162.05),
    (0.2, 3.0, 10.0, 10.0, 40.0, 1.0, 281.00),
    (0.1, 1.2, 5.0, 4.0, 60.0, -1.0, 10.741),
    (0.2, 4.0, 20.0, 8.0, 100.0, 1.0, 129.46),
]


@pytest.mark.parametrize(("h", "b", "l", "spacing", "reach", "sense", "solids"), SOLIDS)
def test_wide_stages_with_a_far_load_tip_as_columns_with_an_arm(
    h, b, l, spacing, reach, sense, solids
):
    h, b, l, spacing, reach = (1e-3 * x for x in (h, b, l, spacing, reach))
    known = arm(sense, l / reach) * 2.0 * E * h * b**3 / 12.0 / l**2
    assert known == pytest.approx(solids, rel=0.01)
    point = (l - sense * reach, 0.0)
    blades = tuple(
        replace(strip(h, b, l).blades[0], name=str(y), start=(0.0, y), end=(l, y))
        for y in (-spacing / 2.0, spacing / 2.0)
    )
    stage = Layout((Body("tip", point),), blades, E, G)
    found = bound(stage, Load("tip", point, (sense, 0.0)))
    assert 0.8 * solids < found < solids
    either = bound(stage, Load("tip", point, (sense, 0.0)), directed=False)
    assert either <= found


def random_joint(rng):
    """Return a body, or two in a row, on blades thicker than wide, with a load anywhere."""
    l, h = 20e-3, 1e-3 * 10.0 ** rng.uniform(-0.3, 0.3)
    b = h * rng.uniform(0.1, 0.7)
    far = tuple(l * rng.uniform(-3.0, 3.0, 2))
    bodies, blades = [Body("tip", far)], []
    chain = rng.random() < 0.4
    if chain:
        bodies.insert(0, Body("middle", (l, 0.0)))
    for k in range(rng.integers(1, 4)):
        start, end = (0.0, l * rng.uniform(-0.7, 0.7)), (l, l * rng.uniform(-0.7, 0.7))
        on = "middle" if chain else "tip"
        blades.append(Blade(f"{k}", "ground", on, start, end, Constant(h), b))
    if chain:
        for k in range(rng.integers(1, 3)):
            start, end = ((l * x, l * y) for x, y in rng.uniform(0.2, 2.0, (2, 2)))
            blades.append(Blade(f"on {k}", "middle", "tip", start, end, Constant(h), b))
    layout = Layout(tuple(bodies), tuple(blades), E, G)
    force, moment = rng.normal(size=2), rng.choice([0.0, 1.0]) * l * rng.normal()
    return layout, Load("tip", far, tuple(force), moment)


@pytest.mark.parametrize("seed", range(24))
def test_straight_beams_in_space_bear_more(seed):
    layout, load = random_joint(np.random.default_rng(seed))
    found = bound(layout, load)
    space = from_plane(layout, "tip", turns=False, density=0.0)
    acting = SpaceLoad("tip", (*load.point, 0.0), (*load.force, 0.0), (0.0, 0.0, load.moment))
    true = straight_critical_factor(
        space, None, [acting], most=1e3 * found, frames=drive_frame(space.drive)
    )
    # of blades thicker than wide what buckles is out of the plane
    assert found < true * (1.0 + 2e-3)


@pytest.mark.parametrize("seed", range(24))
def test_straight_beams_in_space_grow_further_before_they_leave_the_plane(seed):
    rng = np.random.default_rng(seed)
    layout, load = random_joint(rng)
    of_bodies = {name: 1e-4 * rng.normal() for name in ("ground", "tip", "middle")}
    of_blades = {blade.name: 1e-4 * rng.normal() for blade in layout.blades}
    layout = replace(layout, body_growth=of_bodies, blade_growth=of_blades)
    loads, acting = [], []
    if seed % 2:
        x, y = load.force
        loads = [load._replace(force=(1e-2 * x, 1e-2 * y), moment=0.0)]
        acting = [SpaceLoad("tip", (*load.point, 0.0), (1e-2 * x, 1e-2 * y, 0.0))]
    (found,) = lateral_bound(layout, [loads] if loads else [], directed=True, driven=1)
    strained = len(layout.blades) > len(layout.bodies)
    assert strained or loads or found > 1e9  # else all grows as it likes
    space = from_plane(layout, "tip", turns=False, density=0.0)
    space = replace(space, body_growth=of_bodies, blade_growth=of_blades)
    true = straight_critical_factor(
        space, None, acting, most=1e3 * found, frames=drive_frame(space.drive)
    )
    assert found < true * (1.0 + 2e-3) or not (strained or loads)


def test_a_blade_that_grows_between_held_bodies_bears_eulers_strain():
    h, b, l = 1e-3, 0.2e-3, 50e-3
    far = Body("tip", (l, 0.0))
    blades = (*strip(h, b, l).blades, replace(strip(h, b, l).blades[0], name="on",
                                              first="tip", second="ground",
                                              start=(l, 0.0), end=(2 * l, 0.0)))  # fmt: skip
    growth = {"blade": 1e-4, "on": 1e-4}
    layout = replace(strip(h, b, l), bodies=(far,), blades=blades, blade_growth=growth)
    (found,) = lateral_bound(layout, [], directed=False, driven=1, tips=False)
    # shear and 4 π²: a column clamped at both ends
    assert float(found) == pytest.approx(4.0 * pi**2 * b**2 / 12.0 / l**2 / 1e-4, rel=1e-3)
    (less,) = lateral_bound(layout, [], directed=False, driven=1)
    assert float(less) < float(found) / 4.0


@pytest.mark.parametrize("seed", range(12))
def test_what_an_ideal_joint_guides_in_the_plane_may_leave_it(seed):
    layout, load = random_joint(np.random.default_rng(seed))
    found = bound(replace(layout, guides={"tip": (False, True, False)}), load)
    space = from_plane(layout, "tip", turns=False, density=0.0)
    acting = SpaceLoad("tip", (*load.point, 0.0), (*load.force, 0.0), (0.0, 0.0, load.moment))
    true = straight_critical_factor(
        space, {"tip": [None, 0.0, None, None, None, None]}, [acting], most=1e3 * found
    )
    assert found < true * (1.0 + 2e-3)


def test_many_designs_are_as_each_alone():
    load = Load("tip", (20e-3, 0.0), (-1.0, 0.5))
    widths, travels = np.array([1e-3, 2e-3, 5e-3]), np.array([0.1e-3, 0.5e-3, 2e-3])
    alone = [
        bound(strip(0.1e-3, float(b), 20e-3), load, travels=(float(x), -float(x)))
        for b, x in zip(widths, travels, strict=True)
    ]
    many = lateral_bound(
        strip(0.1e-3, widths, 20e-3), [[load]], directed=True, driven=1,
        travels=(travels, -travels),
    )  # fmt: skip
    assert many == pytest.approx(alone, rel=1e-9)


def test_a_stroke_softens_wide_blades():
    # a force on the blade's axis tips nothing; one beside it does
    body = (20e-3, -40e-3)
    load = Load("tip", body, (0.0, 1.0))
    still = bound(strip(0.1e-3, 5e-3, 20e-3, body), load)
    bent = bound(strip(0.1e-3, 5e-3, 20e-3, body), load, travels=(4e-3, -4e-3))
    assert bent < still
