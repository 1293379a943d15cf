"""Flexures at their corners: films, throats like films, hinges of no length, centres far away."""

from math import cos, radians, sin

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, geometry, kinds, spec
from judging import check_as_printed
from planar_support import support_compliance
from strategies import design

from flexcli.formulas.notch import circular_stiffness
from flexcli.formulas.pivot import WITTRICK
from flexcli.parts.geometries.base import MOVING

ROUNDING = 1e-13
PLANE = sorted(kind for kind in SAMPLES if kinds()[kind].strain == "bending")
THIN = {"h": 0.1, "e": 0.05}
"""Thickness of the samples [mm]."""


def thinned(kind, factor):
    (name,) = set(SAMPLES[kind]) & set(THIN)
    return geometry(kind, **{name: THIN[name] * factor})


@pytest.mark.parametrize("kind", PLANE)
@pytest.mark.parametrize("factor", [1.0, 1e-2, 1e-4])
def test_support_of_a_film_is_positive_definite_in_every_direction(kind, factor):
    """Stiffness along a film is 1e12 times that across: digits lost would leave a negative one."""
    part = thinned(kind, factor)
    C = support_compliance(part.layout(ELASTIC, part.probe()), MOVING, (3e-3, -2e-3, 1e-3))
    size = 1.0 / np.sqrt(np.diag(C))
    assert np.linalg.eigvalsh(C * np.outer(size, size)).min() > 0.0


# the fillets of a thin hinge bend over a length that falls with the root of h: no power at all
@pytest.mark.parametrize("kind", [kind for kind in PLANE if kind != "filleted-hinge"])
def test_stiffness_of_thinner_flexures_falls_by_its_power(kind):
    """h³ of blades, e^2.5 of notches: no absolute tolerance calls a film nothing."""
    stiff, soft = (
        part.stiffness(ELASTIC, part.probe()) for part in (thinned(kind, f) for f in (1e-4, 1e-6))
    )
    power = 3.0 if "h" in SAMPLES[kind] else 2.5
    assert stiff / soft == pytest.approx(100.0**power, rel=1e-4)


@pytest.mark.parametrize("ratio", [1e-6, 1e-3, 0.1, 1.0, 10.0])
def test_notch_hinge_has_the_same_stiffness_by_closed_form_and_by_quadrature(ratio, kept):
    """Over the whole domain that the lecture claims for its law, e/r from 1e-6 to 10."""
    part = geometry("notch-hinge", r=1.0, e=ratio)
    quadrature = 1.0 / part.compliance(ELASTIC, part.probe())[..., 2, 2]
    exact = circular_stiffness(E=ELASTIC.E, b=5e-3, e=ratio * 1e-3, r=1e-3)
    assert quadrature == pytest.approx(exact, rel=1e-12)
    kept(quadrature, exact)


@pytest.mark.parametrize("xi", [1e-12, 1e-6, 1e-3, 1.0])
def test_necked_down_hinges_of_no_length_keep_their_digits(xi, kept):
    """1 − (1 − ξ)³ is 3ξ: taken as written it would leave no digit at ξ = 1e-16."""
    sizes = geometry("necked-down-stage").probe()._replace(l_c=xi * 10e-3)
    part = geometry("necked-down-stage")
    short = 3.0 * xi - 3.0 * xi**2 + xi**3
    expected = 3 * ELASTIC.E * 5e-3 * 1e-12 / 20e-3**3 / short
    assert part.stiffness(ELASTIC, sizes) == pytest.approx(expected, rel=ROUNDING)
    kept(part.stiffness(ELASTIC, sizes), expected)
    force = part.critical(ELASTIC, sizes, "clamped-guided")[0].force
    bending = ELASTIC.E * 5e-3 * 1e-12 / 12.0
    limit = 4.0 * bending / (xi * 20e-3**2)
    assert force == pytest.approx(
        limit if xi < 1.0 else np.pi**2 * bending / 20e-3**2, rel=xi + 1e-12
    )


@pytest.mark.parametrize("delta", [1e3, 1e2, 0.25, -0.25])
@pytest.mark.parametrize("kind", ["cross-spring", "hinged-pivot"])
def test_far_centres_are_the_same_from_either_body(kind, delta, kept):
    """Powers of δ = 1000 beside one: a sum in the wrong order keeps the largest term only."""
    one, other = (geometry(kind, p=None, delta=d) for d in (delta, -1.0 - delta))
    found = [part.stiffness(ELASTIC, part.probe()) for part in (one, other)]
    assert found[0] == pytest.approx(found[1], rel=ROUNDING)
    kept(*found)
    worst = [
        max(abs(s) for s in part.end_stresses(ELASTIC, part.probe(), 1e-3).values())
        for part in (one, other)
    ]
    assert worst[0] == pytest.approx(worst[1], rel=ROUNDING)


ALPHA = radians(40.0)
"""Half-angle of the sample."""


def crossing(delta, travel="5 deg"):
    """Check a cross-spring pivot for its shift, with its warnings."""
    given = {**spec("cross-spring"), "p": None, "delta": delta}
    found = design(
        given, {"parasitic_shift": {"max": "1 um"}}, {"turn": {"stroke": {"rotation": travel}}}
    )
    return check_as_printed(found, found.fixed_sizes(), "spec")


@pytest.mark.parametrize("delta", [WITTRICK, -1.0 - WITTRICK, -0.127, -0.873])
def test_a_shift_whose_leading_term_vanishes_is_not_reported_as_none(delta):
    """Printed: "cancelled". The next order, across the bisector, is named and warned of."""
    result = crossing(delta)
    assert any("Wittrick" in note.text for note in result.warnings)
    left = result.values["shift_across"]
    bent = 5**0.5 / 315 * cos(ALPHA) / sin(ALPHA) ** 2 * radians(5.0) ** 3 * 20e-3
    # stretching adds −½ γ θ (h/l)² cos α/sin² α l, a sixth of it here
    assert bent < left.value < 1.25 * bent
    assert left.unit == "m"


@pytest.mark.parametrize("delta", [-0.5, 0.0, -1.0, 0.5])
def test_a_shift_that_its_leading_term_rules_needs_no_such_word(delta):
    """A warning that is always there is read by nobody."""
    result = crossing(delta, "1 deg")
    assert not any("Wittrick" in note.text for note in result.warnings)


@pytest.mark.parametrize("crossing_at", [1e-3, 0.5, 1.0 - 1e-3])
def test_joined_blades_may_cross_all_but_at_their_ends(crossing_at):
    """A part of no length is infinitely stiff, and its share of the stiffness 0/0."""
    part = geometry("unseparated-cross", crossing=crossing_at, h=1e-3)
    C = support_compliance(
        part.layout(ELASTIC, part.probe()), MOVING, (0.0, 0.0, 0.0), shear_factor=np.inf
    )
    # stretch of the short part, (h/(c l))² = 2.5e-3, adds to its bending
    assert C[5, 5] * part.stiffness(ELASTIC, part.probe()) == pytest.approx(1.0, rel=0.02)


def test_fillets_that_meet_leave_a_hinge_of_two_quarter_circles():
    """2 r = l: no straight part is left, and the stiffness is still that of the integral."""
    part = geometry("filleted-hinge", r=5.0, l=10.0)
    around = [part.stiffness(ELASTIC, part.probe()._replace(r=r)) for r in (4.999e-3, 5e-3)]
    assert around[0] == pytest.approx(around[1], rel=1e-2)
    assert around[0] < around[1]
