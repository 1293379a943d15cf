"""What the lecture states of joints and the examples' READMEs say of it, number by number."""

from math import pi, sin, sqrt

import pytest

from flexcli.engine.explain import explain
from flexcli.formulas import hinged_stage, necked_size, notch, notch_compliance
from flexcli.formulas.pivot import stiffness_ratio, stroke_ratio

HALF_DIGIT = 0.5e-5
"""Of a stroke printed in millimetres to two decimals [m]."""

HINGE = {"E": 210e9, "b": 10e-3, "e": 100e-6}
SIGMA, R, L = 800e6, 4e-3, 50e-3


def columns(name, table):
    return explain(name, table).table.columns


def row(name, table, variable, value):
    """Return the row of a chart that stands nearest to a value."""
    found = columns(name, table)
    at = min(range(len(found[variable])), key=lambda k: abs(found[variable][k] - value))
    assert found[variable][at] == pytest.approx(value, abs=1e-6)
    return {column: values[at] for column, values in found.items()}


def hinge_rotation(factor=1.0):
    K = notch.circular_stiffness(**HINGE, r=R)
    return notch.admissible_rotation(K=K, b=10e-3, e=100e-6, sigma=SIGMA, factor=factor)


def hinge_reach():
    C = notch_compliance.circular_compliance(**HINGE, r=R)
    return notch_compliance.bending_reach(across=C.across, turn=C.turn)


def test_stage_of_four_hinges_by_the_simplified_formula():
    (law,) = explain("hinged-stage-stroke-law").formulas
    assert law.gives[0].value == pytest.approx(2.84e-3, abs=HALF_DIGIT)


def test_stage_of_four_hinges_by_the_chart():
    assert pytest.approx(2.86e-3, abs=HALF_DIGIT) == 15.0 * SIGMA * L / 210e9


@pytest.mark.parametrize(
    "stroke",
    [
        hinge_rotation() * L,
        sin(hinge_rotation()) * L,
        hinged_stage.admissible_stroke(gamma=hinge_rotation(), l=L, c=hinge_reach()),
    ],
    ids=["arc", "sine", "beam"],
)
def test_three_models_round_to_the_value_called_exact(stroke):
    assert float(stroke) == pytest.approx(2.83e-3, abs=HALF_DIGIT)


def test_counting_the_stress_concentration_would_print_another_digit():
    factor = notch.bending_factor(e=100e-6, r=R)
    stroke = float(hinge_rotation(factor) * L)
    assert abs(stroke - 2.83e-3) > HALF_DIGIT
    assert stroke == pytest.approx(2.82e-3, abs=HALF_DIGIT)


def test_stress_concentration_is_negligible_above_five_throats_not_below():
    """Printed: "if r < 5 h_min"; K_t falls as the radius grows."""
    far, five, one = (float(notch.bending_factor(e=1.0, r=r)) for r in (50.0, 5.0, 1.0))
    assert 1.0 < far < 1.005
    assert five == pytest.approx(1.04, abs=0.005)
    assert one == pytest.approx(1.18, abs=0.005)


def test_law_of_the_notch_hinge_leaves_its_claim_of_2_6_per_cent():
    """Claimed for 1 µm < e < 1 mm, 0.1 mm < r < 1 m, so for e/r from 1e-6 to 10."""
    errors = columns("notch-hinge", "e/r")
    pairs = list(zip(errors["e/r"], errors["error of 0.07"], strict=True))
    assert all(abs(error) < 0.026 for ratio, error in pairs if ratio < 0.123)
    assert all(abs(error) > 0.026 for ratio, error in pairs if ratio > 0.124)
    assert dict(pairs)[10.0] == pytest.approx(-0.527, abs=0.0005)
    unrounded = zip(errors["e/r"], errors["error of 2/(9π)"], strict=True)
    assert all(abs(error) < 0.026 for ratio, error in unrounded if ratio <= 0.2)


def test_wittricks_crossing_has_the_printed_stroke_and_not_the_printed_stiffness():
    assert 1.0 / stroke_ratio(-0.127) == pytest.approx(3.2, abs=0.05)
    assert stiffness_ratio(-0.127) == pytest.approx(2.67, abs=0.005)
    # where the stiffness is 3.3 times, the stroke is not 3.2 times less
    elsewhere = (sqrt(9.0 - 12.0 * (1.0 - 3.3 / 4.0)) - 3.0) / 6.0
    assert stiffness_ratio(elsewhere) == pytest.approx(3.3)
    assert elsewhere == pytest.approx(-0.0622, abs=5e-5)
    assert 1.0 / stroke_ratio(elsewhere) == pytest.approx(3.63, abs=0.005)


@pytest.mark.parametrize(
    ("delta", "stiffness", "stroke", "shift"),
    [
        (-1.5, 26.0, 0.2 / 3.5, 7.75),
        (-1.0, 8.0, 0.2 / 2.0, 1.0),
        (-0.5, 2.0, 0.2 / 0.5, -1.25),
        (0.0, 8.0, 0.2 / 2.0, 1.0),
        (0.5, 26.0, 0.2 / 3.5, 7.75),
        (1.0, 56.0, 0.2 / 5.0, 19.0),
    ],
)
def test_chart_of_the_generalised_cross_spring_pivot(delta, stiffness, stroke, shift):
    """σ/E = 0.4 %, L/h = 50, θ = 15°, α = 45°: the formulas by hand, in rational numbers."""
    found = row("generalized-cross-spring", "delta", "delta", delta)
    assert found["K l/(E I)"] == pytest.approx(stiffness)
    assert found["theta_max"] == pytest.approx(stroke)
    leading = (pi / 12.0) ** 2 / (15.0 * sqrt(0.5))
    assert found["shift/l"] == pytest.approx(shift * leading)


@pytest.mark.parametrize(
    ("column", "rises"),
    [("aspect ratio", True), ("compression", False), ("stiffness", True), ("thickness", True)],
)
def test_shorter_hinges_do_what_the_lecture_concludes(column, rises):
    """Shorter aspect ratio, stiffer in compression, softer along the stroke, thinner."""
    values = columns("necked-down-stage", "xi")[column]
    assert list(values) == sorted(values, reverse=not rises)


def test_shorter_hinges_gain_at_most_three_times():
    leaf = {"E": 1.0, "sigma": 1.0, "l": 1.0, "x": 1.0}
    ratio = necked_size.aspect_ratio(**leaf, xi=1e-9) / necked_size.aspect_ratio(**leaf, xi=1.0)
    assert ratio == pytest.approx(1.0 / 3.0)
    assert columns("necked-down-stage", "xi")["compression"][0] == pytest.approx(3.0, rel=0.011)


def test_critical_load_of_a_locked_stage_is_greatest_at_a_third_of_its_length():
    found = columns("necked-down-stage", "xi")
    load = found["critical load, locked"]
    assert found["xi"][load.index(max(load))] == 0.3
    assert list(found["critical load, guided"]) == sorted(found["critical load, guided"])


@pytest.mark.parametrize(("delta", "gain"), [(-0.5, 2.0), (0.0, 1.0), (1.0, 0.5)])
def test_hinged_pivots_turn_against_their_hinges(delta, gain):
    found = row("hinged-pivot", "delta", "delta", delta)
    assert found["rotation/gamma"] == pytest.approx(gain)
