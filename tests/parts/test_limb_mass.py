"""The stated mass of rigid limbs between hinges counts in the frequency, which it decides."""

from math import pi, sqrt

import pytest
from strategies import TITANIUM, design

from flexcli.engine.check import check
from flexcli.results import Status

LIMB = {"mass": "4 g", "inertia": "3e-7 kg*m^2", "com": "10 mm"}
SWING = 3e-7 + 4e-3 * 10e-3**2
"""Moment of inertia of a limb about its inner hinge [kg·m²]."""
SIZES = {"e": "0.2 mm", "r": "2 mm", "l": "25 mm", "b": "2 mm"}
STAGE = {"kind": "hinged-stage", **SIZES, "spacing": "40 mm", "limbs": 3}
PIVOT = {"kind": "hinged-pivot", **SIZES, "delta": 0.3, "half_angle": "40 deg"}
PAYLOAD = {"kind": "payload", "mass": "30 g", "inertia": "4e-6 kg*m^2"}
LIGHT = TITANIUM | {"density": "1 kg/m^3"}


def checked(geometry):
    """Return the check of a frequency far below that of a joint."""
    asked = {"frequency": {"min": "0.1 Hz"}, "yield": 1}
    travel = (
        {"rotation": "0.1 deg"} if geometry["kind"] == PIVOT["kind"] else {"translation": "1 um"}
    )
    cases = {"work": {"stroke": travel}}
    spec = design(geometry, asked, cases, mechanism=PAYLOAD, material=LIGHT)
    return check(spec, spec.geometry.sized({}), "spec.yaml")


@pytest.mark.parametrize(
    ("geometry", "stiffness", "inertia"),
    [
        (STAGE, "k_stage", 30e-3 + 3 * SWING / 25e-3**2),
        (PIVOT, "k_pivot", 4e-6 + 2 * SWING * 1.3**2),
    ],
    ids=["stage", "pivot"],
)
def test_limbs_swing_about_their_inner_hinges_with_the_body(geometry, stiffness, inertia):
    values = checked(geometry | {"limb": LIMB}).values
    angular = 2.0 * pi * values["f_0"].value
    # hinges that bend over a length, and give along the limbs, are no pins: (c/l)² of it
    assert angular == pytest.approx(sqrt(values[stiffness].value / inertia), rel=5e-3)


def test_it_decides_what_nobody_could_tell_without_it():
    open_, decided = checked(STAGE), checked(STAGE | {"limb": LIMB})
    assert open_.status is Status.UNDECIDED
    assert any("geometry.limb" in note.text for note in open_.warnings)
    assert decided.status is Status.PASS


def test_heavier_limbs_are_slower():
    heavy = LIMB | {"mass": "8 g"}
    first, second = (checked(PIVOT | {"limb": limb}).values["f_0"].value for limb in (LIMB, heavy))
    assert second < 0.99 * first
