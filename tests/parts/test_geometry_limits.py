"""Where two kinds of flexure become one: each limit through the parts, as a spec makes them."""

from math import pi

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, geometry
from hypothesis import given
from hypothesis import strategies as st
from planar_support import support_compliance
from support import support_stiffness

from flexcli.formulas.buckling import euler_load
from flexcli.parts.geometries.base import MOVING

E = ELASTIC.E
H, L, B = 1e-4, 20e-3, 5e-3
"""Blade of the samples [m]."""
BENDING = E * B * H**3 / 12.0
THETA, X = 1e-2, 1e-4

ROUNDING = 1e-13
LIMIT = 1e-5
"""Of a ratio of 1e-6 that tends to nothing, with coefficients up to ten."""


def stiffness(part):
    return part.stiffness(ELASTIC, part.probe())


def stresses(part, travel):
    return sorted(abs(s) for s in part.end_stresses(ELASTIC, part.probe(), travel).values())


def compliance(part):
    found = part.layout(ELASTIC, part.probe())
    (x, y), *_ = (body.point for body in found.bodies if body.name == MOVING)
    return support_compliance(found, MOVING, (x, y, 0.0))


def assert_alike(one, other, tolerance=1e-9):
    """Compare matrices entry by entry, against the size of row and column."""
    size = 1.0 / np.sqrt(np.diag(other))
    scale = np.outer(size, size)
    np.testing.assert_allclose(one * scale, other * scale, atol=tolerance)


def test_necked_down_to_its_whole_length_is_the_leaf_spring_stage():
    necked = geometry("necked-down-stage", l_c=10.0)
    leaf = geometry("leaf-spring-stage")
    assert stiffness(necked) == pytest.approx(stiffness(leaf), rel=ROUNDING)
    assert stresses(necked, X) == pytest.approx(stresses(leaf, X), rel=ROUNDING)
    for ends in ("clamped-guided", "clamped-clamped"):
        first = necked.critical(ELASTIC, necked.probe(), ends)[0].force
        assert first == pytest.approx(leaf.critical(ELASTIC, leaf.probe(), ends)[0].force)
    shifts = [part.parasitic_shift(part.probe(), X) for part in (necked, leaf)]
    assert shifts[0] == pytest.approx(shifts[1], rel=ROUNDING)
    assert necked.volume(necked.probe()) == pytest.approx(leaf.volume(leaf.probe()))
    assert_alike(compliance(necked), compliance(leaf))


def test_necked_down_to_nothing_is_rigid_links_between_pivots():
    """K_x = 2 n (EI/l_c)/l², the shift of a pin-jointed link x²/(2l)."""
    necked = geometry("necked-down-stage", l_c=1e-5)
    hinge = BENDING / 1e-8
    assert stiffness(necked) == pytest.approx(2 * 3 * hinge / L**2, rel=LIMIT)
    assert necked.parasitic_shift(necked.probe(), X) == pytest.approx(X**2 / (2 * L), rel=LIMIT)


def test_crossing_in_the_middle_is_the_symmetric_pivot():
    """Lecture: 2EI/l a pair; both ends of a blade bear E h θ/(2l)."""
    pivot = geometry("cross-spring", p=None, delta=-0.5)
    assert stiffness(pivot) == pytest.approx(2.0 * BENDING / L, rel=ROUNDING)
    assert stresses(pivot, THETA) == pytest.approx([E * H * THETA / (2 * L)] * 2, rel=ROUNDING)


def test_crossing_at_the_inner_ends_is_the_rcc_pivot_of_no_offset():
    crossed, remote = geometry("cross-spring", p=0.0), geometry("rcc", p=0.0)
    assert stiffness(crossed) == pytest.approx(8.0 * BENDING / L, rel=ROUNDING)
    assert stiffness(crossed) == stiffness(remote)
    assert stresses(crossed, THETA) == stresses(remote, THETA)


PLACES = st.integers(-20_000, 10_000).map(lambda k: k / 1e4)


@given(delta=PLACES)
def test_pivot_is_the_same_from_either_body(delta):
    """δ ↔ −1 − δ: the bodies change their names, the ends of the blades their places."""
    one = geometry("cross-spring", p=None, delta=delta)
    other = geometry("cross-spring", p=None, delta=-1.0 - delta)
    assert stiffness(one) == pytest.approx(stiffness(other), rel=ROUNDING)
    largest = stresses(one, THETA)[-1]
    assert stresses(one, THETA) == pytest.approx(stresses(other, THETA), abs=ROUNDING * largest)


@given(delta=PLACES)
def test_hinged_pivot_is_the_same_from_either_body(delta):
    one = geometry("hinged-pivot", p=None, delta=delta)
    other = geometry("hinged-pivot", p=None, delta=-1.0 - delta)
    assert stiffness(one) == pytest.approx(stiffness(other), rel=ROUNDING)
    largest = stresses(one, THETA)[-1]
    assert stresses(one, THETA) == pytest.approx(stresses(other, THETA), abs=ROUNDING * largest)


@given(delta=PLACES, half_angle=st.floats(10.0, 80.0))
def test_star_of_two_is_the_pair(delta, half_angle):
    pair = geometry("cross-spring", p=None, delta=delta, half_angle=f"{half_angle} deg")
    angles = [f"{half_angle} deg", f"{-half_angle} deg"]
    star = geometry("star", p=None, delta=delta, angles=angles)
    assert stiffness(star) == pytest.approx(stiffness(pair), rel=ROUNDING)
    assert stresses(star, THETA) == pytest.approx(stresses(pair, THETA), rel=ROUNDING)
    assert star.axial_share(0.3) == pytest.approx(pair.axial_share(0.3), rel=1e-12)
    # kept in the plane: the pair's blades stand at two heights, and tilt it where it is free to
    one, other = (
        support_stiffness(part.layout(ELASTIC, part.probe()), MOVING, (0.0, 0.0, 0.0))
        for part in (star, pair)
    )
    plane = np.ix_((0, 1, 5), (0, 1, 5))
    assert_alike(one[plane], other[plane])


def test_three_blade_pivot_is_a_star_of_three():
    three = geometry("three-blade")
    star = geometry("star", p=1.0, angles=["0 deg", "120 deg", "240 deg"])
    assert stiffness(star) == pytest.approx(stiffness(three), rel=ROUNDING)
    assert stresses(star, THETA) == pytest.approx(stresses(three, THETA), rel=ROUNDING)
    assert_alike(compliance(star), compliance(three))


@given(pairs=st.integers(2, 12))
def test_pairs_side_by_side_are_as_many_times_one_pair(pairs):
    one, many = geometry("cross-spring"), geometry("cross-spring", pairs=pairs)
    assert stiffness(many) == pytest.approx(pairs * stiffness(one), rel=ROUNDING)
    assert stresses(many, THETA) == stresses(one, THETA)
    assert many.volume(many.probe()) == pytest.approx(pairs * one.volume(one.probe()))
    assert many.axial_share(0.2) == pytest.approx(one.axial_share(0.2) / pairs)


@given(crossing=st.floats(0.05, 0.95))
def test_joined_blades_are_four_times_as_stiff_and_go_a_quarter_as_far(crossing):
    """Lecture, against "identical" separated blades: of the same h, b and length end to end."""
    joined = geometry("unseparated-cross", crossing=crossing)
    separate = geometry("cross-spring", p=None, delta=-0.5)
    assert stiffness(joined) == pytest.approx(4.0 * stiffness(separate), rel=ROUNDING)
    most = stresses(joined, THETA)[-1] / stresses(separate, THETA)[-1]
    assert most == pytest.approx(4.0, rel=ROUNDING)
    ratios = joined.values(ELASTIC, joined.probe(), THETA)
    assert ratios["stiffness_ratio"].value == pytest.approx(4.0, rel=ROUNDING)
    assert ratios["stroke_ratio"].value == pytest.approx(0.25, rel=ROUNDING)


def test_joined_blades_are_two_rcc_pivots_one_after_the_other():
    joined = geometry("unseparated-cross", crossing=0.4)
    parts = [geometry("rcc", p=0.0, l=20.0 * share) for share in (0.4, 0.6)]
    series = 1.0 / sum(1.0 / stiffness(part) for part in parts)
    assert stiffness(joined) == pytest.approx(series, rel=ROUNDING)


@given(blades=st.integers(2, 20))
def test_leaf_stage_is_its_guided_blades_side_by_side(blades):
    guided, stage = geometry("guided-blade"), geometry("leaf-spring-stage", blades=blades)
    assert stiffness(stage) == pytest.approx(blades * stiffness(guided), rel=ROUNDING)
    assert stresses(stage, X) == pytest.approx(stresses(guided, X), rel=ROUNDING)
    shifts = [part.parasitic_shift(part.probe(), X) for part in (stage, guided)]
    assert shifts[0] == shifts[1]


def test_two_cantilevers_of_half_the_length_make_a_guided_blade():
    """The guided blade has no moment at its middle: 12EI/l³ is half of 3EI/(l/2)³."""
    half = geometry("cantilever", l=10.0)
    guided = geometry("guided-blade")
    assert stiffness(guided) == pytest.approx(stiffness(half) / 2.0, rel=ROUNDING)
    assert stresses(guided, X) == pytest.approx(stresses(half, X / 2.0), rel=ROUNDING)


NOTCHES = {
    "elliptic-hinge": {"e": 0.1, "depth": 1e-7, "l": 20.0},
    "filleted-hinge": {"h": 0.1, "r": 1e-5, "l": 20.0},
}


@pytest.mark.parametrize("kind", NOTCHES)
def test_notch_that_tends_to_nothing_is_the_blade(kind):
    """At a fixed length: an ellipse of no depth has a throat of infinite radius, r → ∞."""
    changes = {**NOTCHES[kind], "stress-concentration": "none"}
    hinge, blade = geometry(kind, **changes), geometry("moment-blade")
    assert stiffness(hinge) == pytest.approx(stiffness(blade), rel=LIMIT)
    assert stresses(hinge, THETA) == pytest.approx(stresses(blade, THETA), rel=LIMIT)
    assert hinge.volume(hinge.probe()) == pytest.approx(blade.volume(blade.probe()), rel=LIMIT)
    middle = support_compliance(blade.layout(ELASTIC, blade.probe()), MOVING, (0.0, 0.0, 0.0))
    assert_alike(compliance(hinge), middle, LIMIT)


def test_throat_much_thicker_than_its_notch_is_a_block_of_its_length():
    """e ≫ r: K → E b e³/(12 · 2r)."""
    hinge = geometry("notch-hinge", e=1e6, r=1.0)
    block = E * B * 1e3**3 / (12.0 * 2e-3)
    assert stiffness(hinge) == pytest.approx(block, rel=LIMIT)


def test_circular_notch_is_the_elliptic_one_as_deep_as_half_as_long():
    circular = geometry("notch-hinge", e=0.05, r=2.0)
    elliptic = geometry("elliptic-hinge", e=0.05, depth=2.0, l=4.0)
    assert stiffness(elliptic) == pytest.approx(stiffness(circular), rel=ROUNDING)
    assert stresses(elliptic, THETA) == pytest.approx(stresses(circular, THETA), rel=ROUNDING)
    assert elliptic.volume(elliptic.probe()) == pytest.approx(circular.volume(circular.probe()))
    assert_alike(compliance(elliptic), compliance(circular))


def thin(kind, **changes):
    """Return limbs whose hinges are points against them: reach c of about √(e r)/2 = 1e-6 l."""
    return geometry(kind, **{"e": 1e-6, "r": 1e-3, "l": 40.0, **changes})


def test_limbs_with_point_hinges_are_links_with_springs():
    """2 n K/l² of a stage; n K (1 + 2δ + 2δ²) of a pivot: K for a cross, 5 n K for δ = 1."""
    K = stiffness(geometry("notch-hinge", e=1e-6, r=1e-3))
    assert stiffness(thin("hinged-stage")) == pytest.approx(2 * 3 * K / 40e-3**2, rel=LIMIT)
    for delta, turns in ((-0.5, 0.5), (0.0, 1.0), (1.0, 5.0)):
        pivot = thin("hinged-pivot", p=None, delta=delta)
        assert stiffness(pivot) == pytest.approx(2 * K * turns, rel=LIMIT)


def test_hinge_of_a_cross_pivot_turns_half_as_far_as_the_pivot():
    """Lecture, RCC against cross pivot: more than γ for the cross, about γ/2 for the RCC."""
    hinge = stresses(geometry("notch-hinge", e=1e-6, r=1e-3), THETA)[0]
    gains = {
        delta: hinge / stresses(thin("hinged-pivot", p=None, delta=delta), THETA)[-1]
        for delta in (-0.5, -0.25, 0.0, 1.0)
    }
    expected = {-0.5: 2.0, -0.25: 4.0 / 3.0, 0.0: 1.0, 1.0: 0.5}
    assert gains == pytest.approx(expected, rel=ROUNDING)


def test_hinged_stage_reaches_the_stroke_of_its_hinges_over_its_limbs():
    """x = γ l: each hinge turns by x/l."""
    hinge = stresses(geometry("notch-hinge", e=1e-6, r=1e-3), X / 40e-3)
    assert stresses(thin("hinged-stage"), X) == pytest.approx(hinge, rel=LIMIT)


def test_blade_buckles_by_euler_in_every_kind_made_of_blades():
    expected = euler_load(E=E, I=B * H**3 / 12.0, l=L, ends="clamped-clamped")
    for kind in ("cantilever", "rcc", "cross-spring", "star", "three-blade", "leaf-spring-stage"):
        part = geometry(kind)
        found = part.critical(ELASTIC, part.probe(), "clamped-clamped")
        assert min(each.force for each in found) == pytest.approx(expected, rel=ROUNDING)


def test_square_torsion_bar_is_within_its_circles():
    """Its torsion constant lies between those of the circles inside and around it."""
    side = stiffness(geometry("torsion-bar", h=1.0, b=1.0, warping="free"))
    inside = stiffness(geometry("round-torsion-bar", d=1.0))
    around = stiffness(geometry("round-torsion-bar", d=2.0**0.5))
    assert inside < side < around
    assert side / inside == pytest.approx(0.1406 / (pi / 32.0), rel=1e-3)  # Timoshenko's 0.1406 a⁴


def test_wide_torsion_bars_side_by_side_are_the_strips_of_a_star():
    strip = geometry("torsion-bar", h=0.004, b=4.0, warping="free", bars=1)
    star = geometry("torsion-star", h=0.004, b=4.0, strips=3)
    # the two ends of a strip take 0.63 h/b off its b h³/3, the core adds 1.2 h/b
    assert stiffness(star) == pytest.approx(3.0 * stiffness(strip), rel=2e-3)


def test_a_long_torsion_bar_does_not_feel_its_clamps():
    free, held = (
        stiffness(geometry("torsion-bar", l=1e6, warping=warping))
        for warping in ("free", "restrained")
    )
    assert held == pytest.approx(free, rel=LIMIT)


def test_the_samples_are_slender_enough_for_their_closed_forms():
    for kind in SAMPLES:
        part = geometry(kind)
        at = part.indicators(part.probe(), THETA if part.motion == "rotation" else X)
        assert not [r for r in part.validity if not r.least <= at[r.quantity] <= r.most]
