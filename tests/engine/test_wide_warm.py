"""Wide blades whose ends a temperature moves are bent as plates are, as by a stroke of the ends."""

import pytest
import yaml

import flexcli

LENGTH, APART, GROWTH = 20e-3, 20e-3, -4e-4


def yields(width, case, **more):
    """Return the factor and range of yield of a pair of blades by exact beams."""
    spec = {
        "flexure": 1,
        "material": {
            "youngs_modulus": "70 GPa", "poisson_ratio": 0.34, "yield_strength": "200 MPa",
            "thermal_expansion": "20e-6 1/K",
        },
        "geometry": {
            "kind": "leaf-spring-stage", "blades": 2, "spacing": f"{APART} m",
            "h": "0.3 mm", "l": f"{LENGTH} m", "b": f"{width} m",
        },
        "cases": {"work": case},
        "requirements": {"yield": 1e-3},
        **more,
    }  # fmt: skip
    checks = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
    found = next(check for check in checks if check.name == "yield (yield-strength)")
    return found.factor, *found.factor_range


SHRINKS = {"temperature": {"bodies": {"ground": f"{GROWTH / 20e-6!r} K"}}}
"""The ground comes closer: either blade is bent to an S by half of it, the body stands still."""


@pytest.mark.parametrize("wide", [0.05, 0.17, 0.5, 1.0, 2.0])
def test_a_ground_that_shrinks_bends_blades_as_a_stroke_of_their_ends_does(wide):
    travel = abs(GROWTH) * APART / 2.0
    drawn, *_ = yields(wide * LENGTH, {"stroke": {"translation": f"{travel!r} m"}})
    warm, low, high = yields(wide * LENGTH, SHRINKS)
    assert low <= drawn <= high
    assert warm == pytest.approx(drawn, rel=2e-3)
    assert high / low < 1.07


@pytest.mark.parametrize("width", [3e-3, 20e-3])
def test_beside_a_stroke_both_add_up(width):
    travel = abs(GROWTH) * APART / 2.0
    stroke = {"stroke": {"translation": f"{travel!r} m"}}
    alone, *_ = yields(width, stroke)
    _, low, high = yields(width, {**SHRINKS, **stroke})
    assert low <= alone / 2.0 <= high


def test_without_the_effect_of_plates_it_is_that_of_beams():
    beam = 200e6 * LENGTH**2 / (3.0 * 70e9 * 0.3e-3 * abs(GROWTH) * APART / 2.0)
    warm, *_ = yields(20e-3, SHRINKS, effects={"plate-widening": "off"})
    assert warm == pytest.approx(beam, rel=2e-3)
