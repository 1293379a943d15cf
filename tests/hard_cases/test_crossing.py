"""Where the blades of a pivot cross: zeros of the shift, the symmetric pivot, a sign change."""

from fractions import Fraction
from math import cos, pi, sqrt

import pytest
from judging import check_as_printed, size_as_printed
from strategies import BEND, crossed, design

from flexcli.formulas.pivot import end_stresses, parasitic_shift, rotational_stiffness
from flexcli.parts.geometries import Blade

ZEROS = [(-9 - sqrt(45)) / 18, (-9 + sqrt(45)) / 18]
"""Roots of 9δ² + 9δ + 1, Wittrick's crossing."""

L, THETA, ALPHA = 1.0, 0.1, pi / 4
UNIT = THETA**2 / (15 * cos(ALPHA))
"""Shift for a bracket of one."""

ROUNDING = 1e-15
SIDES = 1e-9
"""How far the sides of a point are apart; smooth quantities differ by some of that."""
SIZED = 1e-12
"""A solve in logarithms."""

BLADE = Blade(0.2e-3, 20e-3, 10e-3)


def shift(delta):
    return parasitic_shift(l=L, p=delta * L, theta=THETA, half_angle=ALPHA)


def bracket(delta):
    exact = Fraction(delta)
    return float(9 * exact**2 + 9 * exact + 1)


@pytest.mark.parametrize("zero", ZEROS)
def test_at_a_zero_of_the_shift_only_rounding_is_left(zero, kept):
    """Three terms of size one cancel: what is left must be rounding of one, not of a square."""
    assert abs(shift(zero) / UNIT - bracket(zero)) < 4 * ROUNDING
    kept(shift(zero), 0.0, scale=UNIT)


@pytest.mark.parametrize("zero", ZEROS)
@pytest.mark.parametrize("off", [-1e-6, 1e-6])
def test_beside_a_zero_the_shift_has_its_slope_and_sign(zero, off, kept):
    """The relative error grows as the inverse of the distance, and no more; the sign is right."""
    found = shift(zero + off) / UNIT
    assert found == pytest.approx(bracket(zero + off), rel=4 * ROUNDING / (sqrt(45) * abs(off)))
    assert (found > 0) == ((off > 0) == (zero > -0.5))
    kept(found, bracket(zero + off))


@pytest.mark.parametrize("zero", ZEROS)
def test_a_bound_on_the_shift_costs_nothing_at_a_zero(zero, kept):
    """A row whose demand is rounding, of either sign, must neither bind nor divide by zero."""
    asked = {"fatigue": 2.5}
    free = {"l": {"free": ["5 mm", "50 mm"]}, "b": "5 mm", "h": "0.1 mm"}
    plain = size_as_printed(design(crossed(delta=zero, **free), asked, {"bend": BEND}), "spec")
    shifted = asked | {"parasitic_shift": {"max": "1 nm"}}
    bounded = size_as_printed(design(crossed(delta=zero, **free), shifted, {"bend": BEND}), "spec")
    assert bounded.status.value == "pass"
    assert bounded.values["l"].value == pytest.approx(plain.values["l"].value, rel=SIZED)
    kept(bounded.values["l"].value, plain.values["l"].value)


def test_the_symmetric_pivot_is_the_softest_and_its_ends_are_stressed_alike():
    """At δ = −1/2 the deciding end changes: ties must not make the larger stress jump."""
    given = {"E": 114e9, "h": 0.2e-3, "l": 20e-3}
    least = rotational_stiffness(**given, b=10e-3, p=-10e-3)
    assert least == pytest.approx(2 * 114e9 * 10e-3 * 0.2e-3**3 / 12 / 20e-3, rel=ROUNDING)
    inner, outer = end_stresses(**given, p=-10e-3, theta=THETA)
    assert inner == -outer
    for off in (-SIDES, SIDES):
        beside = end_stresses(**given, p=(-0.5 + off) * 20e-3, theta=THETA)
        # the slope of either stress by δ is 3 where the stress is 1/2
        assert max(map(abs, beside)) == pytest.approx(inner, rel=7 * SIDES)
        assert rotational_stiffness(**given, b=10e-3, p=(-0.5 + off) * 20e-3) >= least * (1 - 1e-15)


@pytest.mark.parametrize("delta", [-0.5, -0.5 - SIDES, -0.5 + SIDES])
def test_sizing_passes_through_the_symmetric_pivot(delta):
    """Both ends are active there: two equal rows make a singular set of multipliers."""
    free = {"l": {"free": ["1 mm", "50 mm"]}, "b": "5 mm", "h": "0.5 mm"}
    spec = design(crossed(delta=delta, **free), {"fatigue": 2.5}, {"bend": BEND})
    result = size_as_printed(spec, "spec")
    symmetric = 2.5 * 114e9 * 0.5e-3 * spec.scene("bend").travel * 0.5 / 500e6
    assert result.values["l"].value == pytest.approx(symmetric, rel=7 * SIDES)


@pytest.mark.parametrize("end", [0, 1])
def test_on_both_sides_of_minus_two_thirds_the_other_end_decides(end, kept):
    """The one-ended formula gives an infinite, then a negative stroke here; the factor must be
    smooth, and the stress of the outer end.
    """
    factors = []
    for off in (-SIDES, 0.0, SIDES):
        delta = -2 / 3 + off if end == 0 else -1 / 3 + off
        spec = design(crossed(delta=delta, h="0.2 mm", l="20 mm", b="10 mm"), {"fatigue": 1.0},
                      {"bend": BEND})  # fmt: skip
        (found,) = check_as_printed(spec, BLADE, "spec").checks
        factors.append(found.factor)
    travel = spec.scene("bend").travel
    assert factors[1] == pytest.approx(500e6 / (114e9 * 0.01 * travel), rel=SIZED)
    kept(factors[1], 500e6 / (114e9 * 0.01 * travel))
    assert factors == pytest.approx([factors[1]] * 3, rel=4 * SIDES)
