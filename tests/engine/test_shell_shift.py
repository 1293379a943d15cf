"""Parasitic shifts of the plane's joints by thin shells, against CalculiX's solids."""

import json
from pathlib import Path

import pytest
import yaml
from shell_shifts import asked

import flexcli
from flexcli.engine.joint_models.shell_shift import shift_by_shells

SOLIDS = [
    json.loads(line)
    for line in Path(__file__).with_name("shell_shifts.jsonl").read_text().splitlines()
]
"""What ``tests/benchmarks/shell_shifts.py`` kept: specs, the shift by solids, and its error."""

NARROWED = 0.035
"""A design that far from its limit on either side is decided."""

L, X = 20e-3, 2e-3


def folded(h="0.2 mm", b="10 mm", **more):
    """Return a stage of alike blades whose shortening cancels, asked for its shift."""

    def blade(bodies, start, end, y):
        ends = {"from": [f"{start} m", f"{y} m"], "to": [f"{end} m", f"{y} m"]}
        return {"between": bodies, **ends, "h": h, "b": b}

    blades = {
        f"{name}-{side}": blade(bodies, start, end, sign * y)
        for side, sign in (("a", 1.0), ("c", -1.0))
        for name, bodies, start, end, y in (
            ("out", ["ground", "frame"], 0.0, L, L / 2.0),
            ("in", ["frame", "stage"], L, 0.0, L / 4.0),
        )
    }
    at = {"at": [f"{L / 2.0} m", "0 m"]}
    return {
        "flexure": 1, "material": {"youngs_modulus": "114 GPa", "poisson_ratio": 0.3},
        "geometry": {
            "kind": "layout", "bodies": {"frame": at, "stage": at}, "blades": blades,
            "moving": "stage", "motion": {"translation": "90 deg"},
        },
        "cases": {"work": {"stroke": {"translation": f"{X} m"}}},
        "requirements": {"parasitic_shift": {"max": "1 m"}}, **more,
    }  # fmt: skip


def only(spec, model=None):
    (check,) = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
    return check


@pytest.mark.parametrize("of", SOLIDS, ids=lambda of: of["kind"])
def test_solids_are_within_the_error_of_a_shift_by_shells(of):
    told, error = shift_by_shells(asked(of["spec"]))
    assert abs(of["solid"] / told - 1.0) <= error + of["error"]
    assert error < NARROWED


def test_shells_decide_a_shift_that_cancels_in_second_order():
    spec = folded()
    by_shells, by_beams = (only(spec, model) for model in ("shell", "exact"))
    (low, high), (least, most) = by_shells.factor_range, by_beams.factor_range
    assert least < low < high < most, "a part of what beams leave open"
    limit = by_shells.demand * (1.0 + NARROWED)
    near = folded(requirements={"parasitic_shift": {"max": f"{limit!r} m"}})
    assert only(near, "exact").verdict.value == "undecided"
    decided = only(near)
    assert (decided.model, decided.verdict.value) == ("shell", "pass")


def test_narrow_alike_blades_cancel_within_what_shells_of_wider_ones_say():
    spec = folded(b="2 mm", h="0.1 mm")
    low, high = only(spec, "exact").factor_range
    least, most = only(spec, "shell").factor_range
    assert low < most
    assert least < high
    assert high / low < 1.06


TURN = {"work": {"stroke": {"rotation": "10 mrad"}}}
PIVOT = {"kind": "rcc", "h": "0.1 mm", "l": "20 mm", "b": "5 mm", "half_angle": "45 deg"}
CROSSED = PIVOT | {"kind": "cross-spring", "delta": -0.3}
JOINED = PIVOT | {"kind": "unseparated-cross"}
PIVOT |= {"p": "5 mm"}


@pytest.mark.parametrize(
    "changed",
    [
        {"material": {"youngs_modulus": "114 GPa"}},
        {"cases": TURN, "geometry": JOINED},
        {"cases": TURN, "geometry": PIVOT | {"root_radius": "1 mm"}},
        {"cases": TURN, "geometry": PIVOT | {"h": "4 mm"}},
    ],
    ids=["no ν", "joined", "filleted", "thick"],
)
def test_what_no_shells_were_held_against_has_no_shift_by_shells(changed):
    spec = folded(**changed)
    checks = flexcli.verdicts(yaml.safe_dump(spec), model="shell").checks
    (check,) = (each for each in checks if each.name.startswith("parasitic shift"))
    assert check.factor_range is None
    assert check.verdict.value == "undecided"


ACROSS = (
    (
        {"kind": "rcc", "h": "1.549009986 mm", "l": "45.78692316 mm", "b": "16.43559783 mm",
         "p": "0 mm", "half_angle": "65.08539996826845 deg"},
        0.45, 7.441448718979946e-05, 1.0979222e-9, 7e-4,
    ),
    (
        {"kind": "cross-spring", "h": "6.170619514 mm", "l": "176.2634073 mm",
         "b": "91.33394942 mm", "delta": -0.6666666666666666, "half_angle": "13.95389282 deg"},
        0.34, 0.19856967953809827 / 20.0, 6.3305971e-6, 1.8e-3,
    ),
)  # fmt: skip
"""Pivots, ν, rotation [rad], and their shift by CalculiX's solids on two meshes, with its error:
most of it is across the bisector, of first order, by the stretching of blades that bend."""


@pytest.mark.parametrize("model", ["exact", "shell"])
@pytest.mark.parametrize(("pivot", "nu", "turn", "solid", "error"), ACROSS, ids=["rcc", "crossed"])
def test_a_shift_across_the_bisector_rises_with_the_stiffness_of_plates(
    pivot, nu, turn, solid, error, model
):
    spec = folded(geometry=pivot, cases={"work": {"stroke": {"rotation": f"{turn} rad"}}})
    spec["material"] = {"youngs_modulus": "200 GPa", "poisson_ratio": nu}
    low, high = only(spec, model).factor_range
    assert low * (1.0 - error) <= 1.0 / solid <= high * (1.0 + error)
    assert high / low < 1.2


@pytest.mark.parametrize(
    "blade",
    [
        {"kind": "moment-blade", "h": "2.7 um", "l": "2.68 mm", "b": "0.243 mm"},
        {"kind": "cross-spring", "h": "0.0474 mm", "l": "6.62 mm", "b": "2.18 mm",
         "delta": -0.3333, "half_angle": "59.1 deg"},
    ],
    ids=["arc", "crossed"],
)  # fmt: skip
def test_far_turned_wide_blades_flatten_and_shift_as_shells_say(blade):
    spec = folded(geometry=blade, cases={"work": {"stroke": {"rotation": "45 deg"}}})
    spec["material"] = {"youngs_modulus": "200 GPa", "poisson_ratio": 0.45}
    low, high = only(spec, "shell").factor_range
    least, most = only(spec, "exact").factor_range
    assert least < low < high < most


def test_a_joint_of_blades_side_by_side_is_held_upright():
    spec = folded(geometry=CROSSED, cases=TURN)
    low, high = only(spec, "shell").factor_range
    least, most = only(spec, "exact").factor_range
    assert low < most
    assert least < high


def test_exact_beams_tell_a_shift_that_cancels_no_surer_than_rounding():
    spec = folded(h="0.094 mm", b="0.26 mm")
    slight = {"work": {"stroke": {"translation": "20 um"}}}
    low, high = only({**spec, "cases": slight}, "exact").factor_range
    assert high / low > 1.1
