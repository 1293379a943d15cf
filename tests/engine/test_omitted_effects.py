"""What is left out of a number is told where it may change it by five in a hundred, not below."""

import pytest
from strategies import TITANIUM, design

from flexcli.engine.check import check

WIDE = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "200 mm"}
"""Blades that bend as plates: their stiffness is 1/(1 − ν²) that of a beam, ν²/(1 − ν²) more."""


STROKE = {"work": {"stroke": {"translation": "1 um", "cycles": 1e6}}}


def omitted_effects(poisson_ratio, model):
    material = {**TITANIUM, "poisson_ratio": poisson_ratio}
    found = design(WIDE, {"stiffness": {"max": "1 N/um"}}, STROKE, material=material)
    result = check(found, found.fixed_sizes(), "spec", model)
    return [note.text for note in result.warnings if note.code == "effect-left-out"]


# 4.8 % and 5.2 %
@pytest.mark.parametrize(("poisson_ratio", "told"), [(0.214, False), (0.223, True)])
def test_plates_for_beams_are_a_warning_from_five_in_a_hundred(poisson_ratio, told):
    found = omitted_effects(poisson_ratio, "source")
    assert [text.split(",")[0] for text in found] == (["plate widening"] if told else [])
    assert all("may change results by 5%" in text for text in found)


def test_an_effect_that_the_model_carries_is_no_warning():
    assert omitted_effects(0.34, "closed-form") == []


NARROW = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "5 mm"}


@pytest.mark.parametrize(
    ("shape", "told"),
    [
        ({}, []),
        ({"h": "4.9 um"}, ["thin"]),
        ({"h": "5.1 um"}, []),
        ({"b": "0.099 mm"}, ["narrow"]),
        ({"b": "0.101 mm"}, []),
    ],
)
def test_a_section_that_nobody_makes_or_that_bends_the_other_way_is_a_warning(shape, told):
    found = design({**NARROW, **shape}, {"stiffness": {"max": "1 N/um"}}, STROKE)
    result = check(found, found.fixed_sizes(), "spec", "source")
    assert [n.code for n in result.warnings if n.code in ("thin", "narrow")] == told


@pytest.mark.parametrize("asked", ["yield", "fatigue", "stiffness"])
def test_a_stress_that_anyone_asks_for_has_its_effects_told(asked):
    """A wide blade is stressed by 1/(1 − ν²) more than a beam at its clamps."""
    bound = {"max": "1 N/um"} if asked == "stiffness" else 1.0
    found = design(WIDE, {asked: bound}, STROKE)
    result = check(found, found.fixed_sizes(), "spec", "source")
    (widening,) = (row for row in result.effects if row.name == "plate widening")
    assert ("stress" in widening.estimates) == (asked != "stiffness")


@pytest.mark.parametrize("stated", [True, False])
def test_a_fatigue_amplitude_of_no_stated_stress_ratio_is_a_warning(stated):
    amplitude = {"value": "500 MPa", "cycles": 1e7} | ({"stress_ratio": -1} if stated else {})
    material = {**TITANIUM, "fatigue_amplitude": amplitude}
    found = design(NARROW, {"fatigue": 1.0}, STROKE, material=material)
    result = check(found, found.fixed_sizes(), "spec", "source")
    assert ("stress-ratio-unstated" in [note.code for note in result.warnings]) != stated


@pytest.mark.parametrize(("p", "told"), [("0.2 mm", True), ("0.22 mm", False)])
def test_blades_that_meet_before_the_centre_are_a_warning(p, told):
    """At 90° to each other their middles are √2 p apart there, their faces h less."""
    shape = {"kind": "rcc", "p": p, "half_angle": "45 deg", "h": "0.3 mm", "l": "20 mm",
             "b": "5 mm"}  # fmt: skip
    found = design(shape, {"stiffness": {"max": "100 N*m/rad"}})
    result = check(found, found.fixed_sizes(), "spec", "source")
    assert ("blades-meet" in [note.code for note in result.warnings]) == told
