"""Verdicts of many designs at once are those of each alone, for every joint that has the way."""

from math import isclose

import numpy as np
import pytest
import yaml
from geometries_for_tests import MATERIAL, geometry
from geometries_for_tests import spec as said

from flexcli import api
from flexcli.study import block_of, rows_of

TOGETHER = (
    "cantilever", "guided-blade", "moment-blade", "rcc", "cross-spring", "unseparated-cross",
    "leaf-spring-stage", "necked-down-stage", "filleted-hinge", "hinged-stage", "hinged-pivot",
)  # fmt: skip
"""Joints whose designs are judged together; the others' are judged one at a time."""

LONG = (
    ("three-blade", None),
    ("star", None),
    ("hinged-stage", "exact"),
    ("filleted-hinge", "exact"),
)
"""The same by models that take long of one design."""

DESIGNS = 14
"""Of which three are judged alone, too."""

SAME = 1e-8
"""Of a factor: equilibria are solved to 1e-9, by steps that may differ in their last."""


MASS = {"mechanism": {"kind": "payload", "mass": "0.1 kg", "inertia": "1e-5 kg*m^2"}}


def study(kind, seed, model=None, **more):
    """Return a spec of a joint, and designs that differ in all its numbers."""
    rng, turns = np.random.default_rng(seed), geometry(kind).motion == "rotation"
    stroke = {"rotation": "5 deg"} if turns else {"translation": "0.5 mm"}
    text = yaml.safe_dump(
        {
            "flexure": 1,
            "material": MATERIAL,
            "geometry": said(kind) | more.get("geometry", {}),
            **more.get("parts", {}),
            "cases": {"operation": {"stroke": stroke}},
            "requirements": {
                "yield": 1.5,
                "stiffness": {"max": "0.2 N*m/rad" if turns else "1 N/mm"},
                **more.get("requirements", {}),
            },
        }
    )
    lengths = {
        f"geometry.{name}": value
        for name, value in said(kind).items()
        if isinstance(value, str) and value.endswith((" mm", " deg"))
    }
    stroke = {f"cases.operation.stroke.{name}": value for name, value in stroke.items()}
    numbers = {**lengths, **stroke, "material.youngs_modulus": "114 GPa", "requirements.yield": "2"}
    points = [
        {
            name: f"{float(value.split()[0]) * 1.2 ** rng.uniform(-1.0, 1.0):.9g}"
            + value.partition(" ")[1] + value.partition(" ")[2]
            for name, value in numbers.items()
        }
        for _ in range(DESIGNS)
    ]  # fmt: skip
    return (api.Portable.of(api.load(text)), "verdict", model), points


@pytest.mark.parametrize(
    ("kind", "model"),
    [
        *((kind, None) for kind in TOGETHER),
        ("rcc", "exact"),
        ("leaf-spring-stage", "exact"),
        ("cross-spring", "linear"),
        *(pytest.param(kind, model, marks=pytest.mark.slow) for kind, model in LONG),
    ],
)
def test_designs_judged_together_are_as_each_alone(kind, model):
    of, points = study(kind, 7, model)
    assert block_of(*of, points) > 1
    assert_as_alone(of, points)


def assert_as_alone(of, points):
    together = rows_of(*of, points)
    for place in range(0, DESIGNS, 5):
        row, columns = together[place]
        ((alone, expected),) = rows_of(*of, points[place : place + 1])
        assert row._replace(cells={}) == alone._replace(cells={})
        assert columns == expected
        for name, cell in alone.cells.items():
            there = row.cells[name]
            assert there == cell or isclose(there, cell, rel_tol=SAME), name


@pytest.mark.parametrize(
    "more",
    [
        {"geometry": {"clamps": "monolithic"}},
        {"geometry": {"root_radius": "0.3 mm"}},
        {"parts": MASS, "requirements": {"frequency": {"min": "5 Hz"}}},
    ],
)
def test_what_is_found_of_each_alone_stands_among_what_is_found_together(more):
    of, points = study("rcc", 5, **more)
    assert block_of(*of, points) > 1
    assert_as_alone(of, points)


@pytest.mark.parametrize("is_compiled", [False, True])
def test_no_digit_of_a_row_hangs_on_the_designs_beside_it(is_compiled):
    """So no cut of a study into tasks, and no worker that is lost, shows in its file."""
    if is_compiled:
        pytest.importorskip("numba")
    of, points = study("rcc", 11, "exact")
    found = [
        [row for start in range(0, 6, size)
         for row in rows_of(*of, points[start : min(6, start + size)], is_compiled=is_compiled)]
        for size in (6, 4)
    ]  # fmt: skip
    assert found[0] == found[1]


def test_designs_that_cannot_be_judged_together_are_judged():
    of, points = study("torsion-bar", 3)
    assert block_of(*of, points) == 1
    rows = rows_of(*of, points)
    assert [row.point for row, _ in rows] == points
    assert rows[4] == rows_of(*of, points[4:5])[0]


def test_designs_that_cannot_be_read_say_so_and_the_others_are_judged():
    of, points = study("rcc", 3)
    points[5] = {**points[5], "geometry.h": "-0.1 mm"}
    points[6] = {**points[6], "geometry.h": "0.1 kg"}
    rows = rows_of(*of, points)
    assert [place for place, (row, _) in enumerate(rows) if row.status == "error"] == [5, 6]
    assert "must be above 0" in rows[5][0].reason
    assert rows[4][0] == rows_of(*of, points[4:5])[0][0]
