"""The choice of ξ: inverse of the thickness, tolerance, and what cannot be made."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.necked_size import (
    hinge_ratio,
    hinge_thickness,
    shortest_hinge,
    stiffness_spread,
    thickness_for_spread,
)
from flexcli.formulas.necked_stage import end_stress, translational_stiffness

GIVEN = {"E": 200e9, "sigma": 400e6, "l": 50e-3, "x": 2e-3}
LEAF = hinge_thickness(xi=1.0, **GIVEN)
shares = st.floats(1e-9, 0.99)


@given(shares)
def test_the_ratio_inverts_the_thickness(xi):
    # a rounding of h costs dξ/ξ = dh/h · g/(ξ g'), below 34 for ξ < 0.99
    assert hinge_ratio(h=hinge_thickness(xi=xi, **GIVEN), **GIVEN) == pytest.approx(xi, rel=1e-11)


def test_the_thickest_hinge_is_the_full_blade():
    # sizes in powers of two, so that 3 E h x/(σ l²) is 1 without rounding
    assert hinge_ratio(E=1.0, sigma=3.0, l=1.0, x=0.5, h=2.0) == 1.0


@pytest.mark.parametrize("share", [1.001, 0.0, -1.0, np.nan])
def test_a_thickness_no_hinge_bears_is_refused_with_the_remedy(share):
    with pytest.raises(ValueError, match="thinner hinge or a longer blade"):
        hinge_ratio(h=share * LEAF, **GIVEN)


@given(st.floats(1e-9, 1e-4), st.floats(1e-3, 2.0))
def test_the_least_thickness_gives_just_the_allowed_spread(tolerance, spread):
    h = thickness_for_spread(tolerance=tolerance, spread=spread)
    thinnest, thickest = stiffness_spread(h=h, tolerance=tolerance)
    assert thickest - 1 == pytest.approx(spread, rel=1e-9)
    assert 1 - thinnest < spread


def test_the_spread_is_the_stiffness_at_the_limits_of_the_thickness():
    blade = {"E": 200e9, "l": 50e-3, "b": 10e-3, "xi": 0.2}
    nominal, low, high = (translational_stiffness(h=h, **blade) for h in (100e-6, 95e-6, 105e-6))
    spread = stiffness_spread(h=100e-6, tolerance=5e-6)
    assert spread == pytest.approx((low / nominal, high / nominal), rel=1e-12)


@pytest.mark.parametrize("machinable", [50e-6, 200e-6])
def test_the_shortest_hinge_bears_the_stroke_when_made_too_thick(machinable):
    tolerance = 5e-6
    xi, h = shortest_hinge(machinable=machinable, tolerance=tolerance, spread=0.1, **GIVEN)
    thickest = end_stress(E=200e9, h=h + tolerance, l=50e-3, x=2e-3, xi=xi)
    assert thickest == pytest.approx(400e6, rel=1e-12)
    assert h >= machinable
    assert stiffness_spread(h=h, tolerance=tolerance)[1] <= 1.1 * (1 + 1e-12)
    # one of the two limits on the thickness holds with equality
    slack = min(h / machinable - 1, 1.1 / stiffness_spread(h=h, tolerance=tolerance)[1] - 1)
    assert slack == pytest.approx(0.0, abs=1e-12)


@given(st.lists(st.floats(1e-6, 8e-4), min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    whole = hinge_ratio(h=np.array(rows), **GIVEN)
    assert whole == pytest.approx([hinge_ratio(h=h, **GIVEN) for h in rows], rel=1e-12)
    kept = {"tolerance": 1e-6, "spread": 0.2, **GIVEN}
    chosen = shortest_hinge(machinable=np.array(rows), **kept)
    single = [shortest_hinge(machinable=h, **kept) for h in rows]
    assert chosen.xi == pytest.approx([hinge.xi for hinge in single], rel=1e-12)
    assert chosen.h == pytest.approx([hinge.h for hinge in single], rel=1e-12)
