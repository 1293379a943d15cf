"""Hinges for a given stroke: the lecture's chart and the inverse choice of ξ."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.necked_size import CARDS, aspect_ratio, hinge_thickness
from flexcli.formulas.necked_stage import end_stress
from flexcli.numerics.signomial import variables

ROUNDING = 1e-12
GIVEN = {"E": 200e9, "sigma": 400e6, "l": 50e-3, "x": 2e-3}
shares = st.floats(1e-6, 1.0)


@given(shares)
def test_the_thickness_is_that_which_reaches_the_stress_at_the_stroke(xi):
    h = hinge_thickness(xi=xi, **GIVEN)
    stress = end_stress(E=200e9, h=h, l=50e-3, x=2e-3, xi=xi)
    assert stress == pytest.approx(400e6, rel=ROUNDING)
    assert aspect_ratio(xi=xi, **GIVEN) == pytest.approx(xi * 50e-3 / 2 / h, rel=ROUNDING)


def test_a_leaf_spring_has_the_lectures_thickness():
    # lecture: x = σ l²/(3 E h)
    h = hinge_thickness(xi=1.0, **GIVEN)
    assert 400e6 * 50e-3**2 / (3 * 200e9 * h) == pytest.approx(2e-3, rel=ROUNDING)


def columns():
    table = next(card for card in CARDS if card.tables).tables["xi"]
    assert table.values[-1] == 1.0
    return table.values, {name: f for name, (_, f) in table.columns.items()}


def test_the_chart_is_one_for_the_leaf_spring():
    _, chart = columns()
    for function in chart.values():
        assert function(1.0) == pytest.approx(1.0, rel=ROUNDING)


def test_shorter_hinges_change_the_chart_as_the_lecture_concludes():
    # thinner, lower aspect ratio, softer along the stroke, stiffer in compression
    values, chart = columns()
    rising = {name: np.diff([f(xi) for xi in values]) for name, f in chart.items()}
    for name in ("thickness", "aspect ratio", "stiffness", "critical load, guided"):
        assert (rising[name] > 0).all()
    assert (rising["compression"] < 0).all()


def test_the_chart_tends_to_its_limits_for_short_hinges():
    # g → 3ξ, l_c/h → 1/3, K → 9ξ², K_t → 3; guided load g³ · 4/(π² ξ) → 108 ξ²/π²
    _, chart = columns()
    xi = 1e-7
    limits = {
        "thickness": 3 * xi,
        "aspect ratio": 1 / 3,
        "stiffness": 9 * xi**2,
        "compression": 3.0,
        "critical load, guided": 108 * xi**2 / np.pi**2,
        "critical load, locked": 27 * xi,
    }
    for name, limit in limits.items():
        assert chart[name](xi) == pytest.approx(limit, rel=1e-6)


def test_the_thickness_is_a_signomial_in_the_share():
    (xi,) = variables("xi")
    h = hinge_thickness(xi=xi, **GIVEN)
    assert h.at(xi=0.3) == pytest.approx(hinge_thickness(xi=0.3, **GIVEN), rel=ROUNDING)


@given(st.lists(shares, min_size=1, max_size=5))
def test_arrays_agree_with_element_wise_calls(rows):
    for function in (hinge_thickness, aspect_ratio):
        whole = function(xi=np.array(rows), **GIVEN)
        assert whole == pytest.approx([function(xi=xi, **GIVEN) for xi in rows], rel=ROUNDING)
