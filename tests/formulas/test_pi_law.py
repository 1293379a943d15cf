"""The operating line: printed points, its inverse, and where it meets statics."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.card import outside
from flexcli.formulas.pi_law import (
    MEASURED,
    contact_threshold,
    operating_line,
    ratio_on_line,
)
from flexcli.formulas.stop_stiffness import stiffness_ratio
from flexcli.formulas.stopped_cantilever import load_at_travel, reaction


def line_over_threshold(a):
    return operating_line(stiffness_ratio(L_a=a, L_b=1.0 - a)) / contact_threshold(a)


def test_line_passes_the_printed_point():
    # section 9.1.3: π1 = 129 corresponds with π5 = 2.29
    assert operating_line(129.0) == pytest.approx(2.29, abs=0.005)


def test_line_in_the_units_of_the_source_has_its_printed_factor():
    # section 9.1.1, equation (III): δ_G = 0.00994 k_c^0.304 in mm and N/mm, k_f = 9.87 N/mm
    k_c = np.array([10.0, 100.0, 1200.0])
    ours = 0.2 / operating_line(k_c / 9.87)
    assert ours == pytest.approx(0.00994 * k_c**0.304, rel=0.000005 / 0.00994 * 1.02)


@given(st.floats(1e-3, 1e6))
def test_ratio_on_line_inverts_the_line(pi_1):
    assert ratio_on_line(operating_line(pi_1)) == pytest.approx(pi_1, rel=1e-12)


@given(st.floats(0.05, 1.0, exclude_max=True), st.floats(1e-6, 1e-3))
def test_below_the_threshold_no_stop_pushes_and_above_one_does(a, gap):
    beam = {"E": 1.0, "I": 1.0, "L_a": a, "L_b": 1.0 - a, "d": gap}
    half = contact_threshold(a) * gap / 2
    pushes = [
        reaction(F=load_at_travel(delta=half * factor, **beam), **beam) != 0.0
        for factor in (1 - 1e-6, 1 + 1e-6)
    ]
    assert pushes == [False, True]


@pytest.mark.parametrize(("low", "high"), [(0.505, 0.506), (0.893, 0.894)])
def test_line_crosses_the_threshold_where_the_docstring_says(low, high):
    assert (line_over_threshold(low) - 1.0) * (line_over_threshold(high) - 1.0) < 0.0


def test_line_lies_above_the_threshold_only_between_the_crossings():
    inside, below, above = np.linspace(0.506, 0.893), np.linspace(0.01, 0.505), (0.894, 0.99)
    assert (line_over_threshold(inside) > 1.0).all()
    assert (line_over_threshold(below) < 1.0).all()
    assert (line_over_threshold(np.linspace(*above)) < 1.0).all()


def test_ranges_name_what_the_source_did_not_measure():
    assert outside(MEASURED, {"pi_1": 129.0, "pi_5": 2.29, "gap/free range": 0.1, "modes": 1}) == []
    (stiff, impossible) = outside(MEASURED, {"pi_1": 300.0, "pi_5": float(operating_line(300.0))})
    assert (stiff.quantity, impossible.quantity) == ("pi_1", "pi_5")
    assert outside(MEASURED, {"gap/free range": 0.02})[0].quantity == "gap/free range"


def test_line_falls_below_two_beyond_the_ratio_the_range_names():
    assert ratio_on_line(2.0) == pytest.approx(201.0, abs=0.5)


@pytest.mark.parametrize("function", [operating_line, ratio_on_line, contact_threshold])
def test_arrays_equal_elements_and_nonsense_is_refused(function):
    values = np.array([[0.3, 0.5], [0.9, 1.0]])
    assert function(values) == pytest.approx(np.vectorize(function)(values), rel=1e-15)
    with pytest.raises(ValueError, match="must be positive"):
        function(0.0)
