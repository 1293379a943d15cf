"""The limbs between hinges have a mass that nobody states: a frequency can only fall by it."""

from math import pi, sqrt

import pytest
from strategies import design

from flexcli.engine.check import check
from flexcli.results import Verdict

STEEL = {
    "name": "steel",
    "youngs_modulus": "210 GPa",
    "poisson_ratio": 0.3,
    "density": "7800 kg/m^3",
    "yield_strength": "800 MPa",
}
STAGE = {"kind": "necked-down-stage", "h": "0.2 mm", "l_c": "5 mm", "l": "40 mm", "b": "2 mm",
         "spacing": "40 mm"}  # fmt: skip


def judged(share, stage=STAGE):
    """Return what is said of a frequency that is a share of √(k/m)/2π, and the notes."""
    l, xi = 40e-3, 0.25
    k = 2.0 * 210e9 * 2e-3 * 0.2e-3**3 / (l**3 * xi * (3.0 - 3.0 * xi + xi**2))
    least = share * sqrt(k / 0.05) / (2.0 * pi)
    spec = design(
        stage, {"frequency": {"min": f"{least!r} Hz"}}, {"op": {"stroke": {"translation": "1 mm"}}},
        material=STEEL, mechanism={"kind": "payload", "mass": "50 g"},
    )  # fmt: skip
    result = check(spec, spec.fixed_sizes(), "test")
    (row,) = [c for c in result.checks if c.name.startswith("frequency")]
    return row, [note.code for note in result.warnings]


def test_a_frequency_that_limbs_of_no_mass_miss_fails():
    row, notes = judged(1.1)  # beyond what plates stiffen the hinges by
    assert row.verdict is Verdict.FAIL
    assert "limbs-without-mass" not in notes


@pytest.mark.parametrize("share", [0.9, 0.5])
def test_a_frequency_that_limbs_may_bring_down_is_open_and_says_why(share):
    row, notes = judged(share)
    assert row.verdict is Verdict.UNDECIDED
    assert "limbs-without-mass" in notes


def test_it_is_open_without_the_distance_of_the_blades_as_well():
    row, notes = judged(0.9, {k: v for k, v in STAGE.items() if k != "spacing"})
    assert row.verdict is Verdict.UNDECIDED
    assert row.factor_range[0] < 0.1
    assert "limbs-without-mass" in notes


@pytest.mark.parametrize(
    ("share", "bound", "asked"),
    [(0.99, "min", False), (1.01, "min", True), (1.01, "max", True), (0.99, "max", True)],
)
def test_solids_are_asked_only_where_they_could_decide(share, bound, asked):
    """Their stiffness is surer than that of beams; what limbs weigh no model knows."""
    stage = {"kind": "hinged-stage", "e": "0.3 mm", "r": "1 mm", "b": "5 mm", "limbs": 2,
             "l": "20 mm", "spacing": "40 mm"}  # fmt: skip
    text = {"frequency": {"min": "1 Hz"}}
    case = {"op": {"stroke": {"translation": "0.1 mm"}}}
    given = {"material": STEEL, "mechanism": {"kind": "payload", "mass": "50 g"}}
    spec = design(stage, text, case, **given)
    found = check(spec, spec.fixed_sizes(), "test", model="exact")
    (free,) = [row for row in found.checks if "frequency" in row.name]
    spec = design(stage, {"frequency": {bound: f"{share * free.capacity!r} Hz"}}, case, **given)
    result = check(spec, spec.fixed_sizes(), "test")
    assert ("solid" in result.cost.by_model) == asked


def test_so_is_a_sag():
    spec = design(
        STAGE | {"spacing": None}, {"sag": {"max": "10 mm"}},
        {"op": {"acceleration": {"level": "1 g", "axis": "x"}}},
        material=STEEL, mechanism={"kind": "payload", "mass": "50 g"},
    )  # fmt: skip
    result = check(spec, spec.fixed_sizes(), "test")
    (row,) = [c for c in result.checks if c.name.startswith("sag")]
    assert row.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "requirement", [{"yield": 1.2}, {"fatigue": 1.2}, {"sag": {"max": "1 um"}}], ids=str
)
def test_solids_are_not_asked_of_what_the_weight_of_limbs_is_a_part_of(requirement):
    """No model knows its error: a factor at its limit stays open, whoever tells it."""
    stage = {"kind": "hinged-stage", "e": "0.3 mm", "r": "1 mm", "b": "5 mm", "limbs": 2,
             "l": "20 mm", "spacing": "40 mm"}  # fmt: skip
    case = {"op": {"stroke": {"translation": "0.1 mm", "cycles": 1e6},
                   "acceleration": {"level": "1 g", "axis": "y"}}}  # fmt: skip
    steel = STEEL | {
        "tensile_strength": "1 GPa",
        "fatigue_amplitude": {"value": "300 MPa", "cycles": 1e7, "stress_ratio": -1},
    }
    given = {"material": steel, "mechanism": {"kind": "payload", "mass": "50 g"}}
    spec = design(stage, requirement, case, **given)
    result = check(spec, spec.fixed_sizes(), "test")
    (row,) = [row for row in result.checks if row.name.startswith(next(iter(requirement)))]
    assert row.verdict is Verdict.UNDECIDED
    assert "exact" in result.cost.by_model
    assert "solid" not in result.cost.by_model
