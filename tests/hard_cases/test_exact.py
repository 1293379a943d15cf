"""The exact solver at its corners: films and blocks, right angles, loads at and past buckling."""

from math import pi, sin, tan

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, geometry
from mechanisms_for_tests import E, cantilever, pivot

from flexcli.formulas.buckling import euler_load
from flexcli.formulas.notch import circular_stiffness
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.stability import critical_load
from flexcli.mechanics.tangent import held_stiffness
from flexcli.parts.geometries.base import MOVING

SLENDER = Effects(extension=False, shear=False)
PRECISION = 1e-9
"""What solve() is asked for by default."""
ROUNDING = 1e-12
"""Of a small system, its shape and its loads alike."""
l, h, b = 20e-3, 1e-4, 10e-3
EI = E * b * h**3 / 12.0
DELTA = -0.3

OTHER_NODES = (10, 15, 22, 33, 50, 75)
"""None of the solver's own."""


def turned(layout, theta, **asked):
    """Turn a pivot by an angle; return moment [N·m] and shift (x, y) [m]."""
    state = solve(layout, {"out": (None, None, theta)}, **asked).checked()
    return state.reactions[:, 0, 2], state.motions[:, 0, :2]


@pytest.mark.parametrize("ratio", [1e-5, 1e-4, 1e-2, 0.1, 0.3])
def test_blades_from_film_to_block_that_only_bend_are_one_blade(ratio, kept):
    """A film is 12 (l/h)² = 1e11 times stiffer along than across: elements lock or lose digits."""
    moment, shift = turned(pivot(h=ratio * l, delta=DELTA), 0.3, effects=SLENDER)
    middle, place = turned(pivot(delta=DELTA), 0.3, effects=SLENDER)
    assert moment / (ratio * l / h) ** 3 == pytest.approx(middle, rel=ROUNDING)
    assert shift == pytest.approx(place, abs=ROUNDING * l)
    kept(moment / (ratio * l / h) ** 3, middle)


@pytest.mark.parametrize("ratio", [1e-5, 1e-4, 1e-3])
def test_stretching_of_a_film_vanishes_as_its_thickness_squared(ratio):
    """A term of 1e-11 beside one: a penalty for inextensible blades would be all that is seen."""
    bending, _ = turned(pivot(h=ratio * l, delta=DELTA), 0.3, effects=SLENDER, tolerance=1e-12)
    full, _ = turned(pivot(h=ratio * l, delta=DELTA), 0.3, tolerance=1e-12)
    assert full == pytest.approx(bending, rel=10.0 * ratio**2 + ROUNDING)


@pytest.mark.parametrize("ratio", [1e-5, 0.3])
@pytest.mark.parametrize("quarters", [1, 2, 4])
def test_a_blade_rolled_up_by_its_end_moment_is_a_circle(ratio, quarters, kept):
    """Chords that are corrected for small turns leave the circle at 90° and are lost at 360°."""
    angle = quarters * pi / 2.0
    M = E * b * (ratio * l) ** 3 / 12.0 / l * angle
    load = [Load("tip", (l, 0.0), moment=M)]
    x, y, phi = solve(cantilever(h=ratio * l), loads=load).checked().motions[0, 0]
    radius = l / angle
    expected = [radius * sin(angle), radius * (1.0 - np.cos(angle)), angle]
    assert [x + l, y, phi] == pytest.approx(expected, rel=PRECISION, abs=PRECISION * l)
    kept([x + l, y, phi], expected, scale=[l, l, 1.0])


@pytest.mark.parametrize("delta", [-0.5, DELTA, 0.2])
@pytest.mark.parametrize("degrees", [30.0, 60.0, 90.0])
def test_a_pivot_turned_to_a_right_angle_is_the_same_on_other_nodes(delta, degrees, kept):
    """Newton's method jumps to another branch, and both meshes of a doubling share their nodes."""
    layout = pivot(delta=delta)
    moment, shift = turned(layout, np.radians(degrees))
    other, place = turned(layout, np.radians(degrees), levels=OTHER_NODES)
    assert moment == pytest.approx(other, rel=10.0 * PRECISION)
    assert shift == pytest.approx(place, abs=10.0 * PRECISION * l)
    kept(moment, other)


@pytest.mark.parametrize("off", [-1e-2, -1e-6, 1e-6, 1e-2])
def test_stiffness_next_to_buckling_is_the_tangent_of_the_load(off, kept):
    """k = N/(l (tan(β/2)/(β/2) − 1)) goes through zero at β = π: a difference of equal numbers."""
    beta = pi * (1.0 + off) ** 0.5
    push = beta**2 * EI / l**2
    load = [Load("tip", (l, 0.0), (-push, 0.0))]
    state = solve(cantilever(), {"tip": (None, 0.0, 0.0)}, loads=load, effects=SLENDER).checked()
    found = held_stiffness(state)[0, 0, 0]
    half = beta / 2.0
    exact = push / l / (tan(half) / half - 1.0)
    assert found == pytest.approx(exact, rel=1e-14 / abs(off) + ROUNDING)
    assert (found > 0.0) == (off < 0.0)
    kept(found, exact)


HOLDS = {
    "clamped-free": {},
    "clamped-guided": {"tip": (None, None, 0.0)},
    "clamped-pinned": {"tip": (None, 0.0, None)},
    "clamped-clamped": {"tip": (None, 0.0, 0.0)},
}


@pytest.mark.parametrize("ends", HOLDS)
@pytest.mark.parametrize("ratio", [1e-5, 1e-3])
def test_the_critical_load_of_a_film_is_eulers(ends, ratio, kept):
    """Watching Newton's method fail gives the load to the size of its last step."""
    euler = euler_load(E=E, I=b * (ratio * l) ** 3 / 12.0, l=l, ends=ends)
    load = [Load("tip", (l, 0.0), (-euler, 0.0))]
    layout = cantilever(h=ratio * l)
    found = critical_load(layout, HOLDS[ends], load, most=3.0, effects=SLENDER).factor
    assert found == pytest.approx(1.0, rel=PRECISION)
    kept(found, 1.0)


@pytest.mark.parametrize("ends", HOLDS)
def test_within_a_millionth_of_its_critical_load_a_blade_stands_or_falls(ends):
    """Bisection on convergence calls both sides alike: the straight blade is a solution of both."""
    euler = euler_load(E=E, I=EI / E, l=l, ends=ends)
    load = [Load("tip", (l, 0.0), (-euler, 0.0))]
    factor = np.array([0.0, 1.0 - 1e-6, 1.0 + 1e-6, 1.5])
    state = solve(cantilever(), HOLDS[ends], loads=load, load_factor=factor, effects=SLENDER)
    assert state.checked().unstable.tolist() == [0, 0, 1, 1]


@pytest.mark.parametrize("factor", [1e-6, 1e-3, 0.3, 1e3])
def test_a_pivot_in_micrometres_has_the_digits_of_one_in_metres(factor, kept):
    """Forces of 1e-12 N and stiffnesses of 1e11: absolute tolerances see only one of them."""
    moment, shift = turned(pivot(delta=DELTA), 0.4)
    small = pivot(h=h * factor, l=l * factor, b=b * factor, delta=DELTA)
    found, place = turned(small, 0.4)
    assert found == pytest.approx(moment * factor**3, rel=ROUNDING)
    assert place == pytest.approx(shift * factor, abs=ROUNDING * l * factor)
    kept(found, moment * factor**3)


@pytest.mark.parametrize("angle", [1e-9, 0.7, pi / 2.0, 3.0])
def test_a_pivot_in_a_turned_frame_gives_the_turned_answer(angle, kept):
    """A blade along an axis has zeros where a turned one has rounding: branches on zero differ."""
    moment, shift = turned(pivot(delta=DELTA), 0.6)
    found, place = turned(pivot(delta=DELTA, angle=angle), 0.6)
    c, s = np.cos(angle), np.sin(angle)
    assert found == pytest.approx(moment, rel=PRECISION)
    assert place[0] == pytest.approx(np.array([[c, -s], [s, c]]) @ shift[0], abs=PRECISION * l)
    kept(found, moment)


@pytest.mark.parametrize("theta", [1e-6, 0.1, 1.0])
def test_a_pivot_turned_the_other_way_gives_the_mirrored_answer(theta, kept):
    """An asymmetric stencil or a start on one side is seen at large angles only."""
    moment, shift = turned(pivot(delta=DELTA), theta)
    back, place = turned(pivot(delta=DELTA), -theta)
    assert back == pytest.approx(-moment, rel=PRECISION)
    assert place == pytest.approx(shift * [1.0, -1.0], abs=PRECISION * l)
    kept(back, -moment)


@pytest.mark.parametrize("ratio", [1e-4, 1e-3, 1e-2, 0.1, 1.0])
def test_a_notch_bends_as_its_integral_from_hair_to_block(ratio, kept):
    """The bend sits in √(e r) of the throat: even nodes see a rigid bar, or one point of it."""
    part = geometry("notch-hinge", r=1.0, e=ratio)
    layout, theta = part.layout(ELASTIC, part.probe()), 1e-5
    state = solve(layout, {MOVING: (None, None, theta)}, effects=SLENDER).checked()
    index = [body.name for body in layout.bodies].index(MOVING)
    found = state.reactions[0, index, 2] / theta
    exact = circular_stiffness(E=ELASTIC.E, b=5e-3, e=ratio * 1e-3, r=1e-3)
    assert found == pytest.approx(exact, rel=PRECISION)
    kept(found, exact)
