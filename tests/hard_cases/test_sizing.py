"""Sizing at the edge of what exists: vanishing denominators, square sections, near misses."""

from math import pi, sqrt

import numpy as np
import pytest
from judging import size_as_printed
from strategies import CASES, LOADS, PUSH, design, rcc

E, SIGMA, S, P = 114e9, 500e6, 2.5, 2e-3
SLENDER = pi * sqrt(E / (3 * SIGMA))
"""l/h at which fatigue strength and clamped buckling stress are one (exercise 9)."""
LARGEST = pi / (6 * S * sqrt(E / (3 * SIGMA)))
"""Stroke [rad] at which π² = 6 S π √(E/3σ) θ, the denominator of exercise 9's thickness."""
BALANCED = {"objective": "balanced"}

ROUNDING = 1e-13
"""Of a well-conditioned root; a vanishing denominator spreads it."""
BOUND_KEPT = 1e-9
"""What a sizing may leave of a row at its limit, and check calls rounding."""


def at_stroke(theta, force, size_keys=BALANCED):
    cases = {
        "bend": {"stroke": {"rotation": f"{theta!r} rad", "cycles": 1e7}},
        "push": PUSH | {"load": {"force": f"{force!r} N"}},
    }
    result = size_as_printed(design(rcc(), LOADS, cases, size=size_keys), "spec")
    return result, np.array([result.values[name].value for name in "hlb"])


@pytest.mark.slow
@pytest.mark.parametrize("below", [1e-2, 1e-4, 1e-5])
def test_just_below_the_largest_stroke_the_balanced_design_keeps_its_digits(below, kept):
    """The denominator is a difference of two numbers that agree to 1/below: it spreads rounding."""
    theta = LARGEST * (1 - below)
    force = 6.4e12  # large enough that b stays above h
    result, found = at_stroke(theta, force)
    h = 9 * S * P * theta / (pi**2 - 6 * S * SLENDER * theta)
    exact = np.array([h, SLENDER * h, force * S / (h * SIGMA * sqrt(2))])
    assert result.sizing.objective == "balanced"
    assert found == pytest.approx(exact, rel=ROUNDING / below)
    kept(found, exact)


@pytest.mark.slow
@pytest.mark.parametrize("off", [0.0, 1e-12, 1e-6, 1e-2])
def test_at_the_largest_stroke_and_above_it_says_so_and_takes_the_least_volume(off):
    """The formula divides by zero at it and gives a negative thickness above it."""
    result, found = at_stroke(LARGEST * (1 + off), 640.0)
    assert result.status.value == "pass"
    assert "no-balanced-design" in [note.code for note in result.warnings]
    least = at_stroke(LARGEST * (1 + off), 640.0, {"objective": "least-volume"})[1]
    assert found.tolist() == least.tolist()
    assert (found > 0).all()


def test_the_least_volume_passes_the_largest_stroke_smoothly(kept):
    """Nothing happens to the least volume where the balanced design goes to infinity."""
    beside = [
        at_stroke(LARGEST * (1 + off), 640.0, {"objective": "least-volume"})[1]
        for off in (-1e-9, 0.0, 1e-9)
    ]
    np.testing.assert_allclose(beside[0], beside[2], rtol=1e-8)
    kept(beside[1], (beside[0] + beside[2]) / 2.0)


def test_a_section_narrower_than_thick_buckles_across_its_width(kept):
    """A model with one axis of buckling thickens the blade without limit as it narrows it."""
    result = size_as_printed(design(rcc(p="0 mm"), LOADS, size=BALANCED), "spec")
    h, l, b = (result.values[name].value for name in "hlb")
    assert b < h
    (buckling,) = (c for c in result.checks if c.name == "buckling")
    assert buckling.quantity.endswith("across the width")
    capacity = 4 * pi**2 * E * h * b**3 / 12 / l**2 * sqrt(2)
    assert buckling.factor == pytest.approx(capacity / 640.0, rel=1e-12)
    assert buckling.factor == pytest.approx(S, rel=BOUND_KEPT)
    kept(buckling.factor, S)


def test_on_a_square_section_both_axes_buckle_alike():
    """The deciding axis changes at b = h: the factor has a corner there, and no jump."""

    def factor(b):
        spec = design(rcc(h="1 mm", l="20 mm", b=f"{b!r} mm"), {"buckling": 1.0}, CASES)
        (found,) = size_as_printed(spec, "spec").checks
        return found

    below, square, above = (factor(b) for b in (1 - 1e-9, 1.0, 1 + 1e-9))
    assert below.quantity.endswith("across the width")
    assert above.quantity.endswith("across the thickness")
    assert below.factor == pytest.approx(square.factor * (1 - 3e-9), rel=ROUNDING)
    assert above.factor == pytest.approx(square.factor * (1 + 1e-9), rel=ROUNDING)


def bounded(excess):
    """Ask of l/h what the bounds of l and h leave no room for, by a relative excess."""
    geometry = rcc(
        h={"free": ["1 mm", "2 mm"]}, l={"free": ["1 mm", "10 mm"]}, b={"free": ["1 mm", "9 mm"]}
    )
    asked = {"l/h": {"min": 10 * (1 + excess)}, "fatigue": 0.001}
    return size_as_printed(design(geometry, asked), "spec")


@pytest.mark.parametrize("excess", [0.0, 1e-12, 1e-9])
def test_infeasible_by_one_part_in_a_billion_is_rounding(excess):
    """A point where three rows meet has no inside: a strict method calls the exact fit empty."""
    result = bounded(excess)
    assert result.status.value == "pass"
    assert result.values["h"].value >= 1e-3 * (1 - BOUND_KEPT)
    assert result.values["l"].value <= 10e-3 * (1 + BOUND_KEPT)


@pytest.mark.parametrize("excess", [1e-8, 1e-6])
def test_infeasible_by_more_than_rounding_names_the_rows(excess):
    """A tolerance a little too wide would pass a design that breaks its own bounds."""
    result = bounded(excess)
    assert result.status.value == "infeasible"
    assert {row.name for row in result.sizing.conflict} == {"l/h (min): l/h", "least h", "most l"}
