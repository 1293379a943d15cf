"""Specs that were judged wrongly once, each an example of its kind, with what is true of it.

The true numbers were worked out by other methods: beams in 50 digits, spectral determinants, finite
elements, direct integration, and the twins of ``tests/twins``.
"""

import json
import tempfile
from collections.abc import Callable
from functools import cache
from math import degrees, isclose
from pathlib import Path
from typing import NamedTuple

import pytest
import yaml
from typer.testing import CliRunner

from flexcli.cli.app import command_line

HERE = Path(__file__).parent
PRINTED = 5e-3
"""Relative: true numbers are printed with three digits or more."""

PLATE = 0.02
"""Relative: what plate widening, which the beams of the true numbers lack, changes of a shift."""


class Said(NamedTuple):
    """What a command said of a spec: exit code, and its JSON."""

    exit_code: int
    found: dict
    spec: str = ""

    @property
    def status(self):
        return self.found["status"]

    def rows(self, name):
        return [row for row in self.found["checks"] if row["name"].startswith(name)]

    def verdicts(self, name):
        return {row["verdict"] for row in self.rows(name)}

    def value(self, name):
        return self.found["values"][name]["value"]


@cache  # several statements are made of what one command said
def run(spec, words):
    """Run a command on a spec of this folder; a bug of ours is not caught."""
    return ran(str(HERE / f"{spec}.yaml"), words)._replace(spec=spec)


def ran(path, words):
    """Run a command on a file."""
    verb, *options = words.split()
    if verb == "asd":
        verb, options = f"asd {options[0]}", options[1:]
    line = [*verb.split(), path, *options, "--format", "json"]
    result = CliRunner().invoke(command_line(), line, catch_exceptions=False)
    return Said(result.exit_code, json.loads(result.stdout))


def fails(name, true=None):
    """State that a requirement fails; its factor's range holds the true factor."""

    def statement(said):
        assert said.exit_code == 1
        assert "fail" in said.verdicts(name)
        if true is not None:
            assert_covers(said, name, true)

    return statement


def passes(name, true=None):
    """State that a requirement passes."""

    def statement(said):
        assert said.verdicts(name) == {"pass"}
        if true is not None:
            assert_covers(said, name, true)

    return statement


def assert_covers(said, name, true):
    """Assert that the worst row's range holds a true factor as far as it is printed."""
    low, high = min((row["factor_range"] for row in said.rows(name)), key=lambda r: r[0])
    assert low * (1.0 - PRINTED) <= true <= high * (1.0 + PRINTED)


def does_not_pass(*names):
    """State that the design does not pass, nor any of the checks that are named."""

    def statement(said):
        assert said.exit_code == 1
        assert said.status != "pass"
        for name in names:
            assert "pass" not in said.verdicts(name)

    return statement


def judges_or_names(load):
    """State that the design does not pass, and that the load is named or fails something."""

    def statement(said):
        assert said.status != "pass"
        assert "not judged" in said.verdicts(load) or said.status == "fail"

    return statement


def tells(name, true, rel):
    """State the true value of a name; what is told is as near as is asked."""

    def statement(said):
        assert isclose(abs(said.value(name)), true, rel_tol=rel), said.value(name)

    return statement


def knows_its_error(name, true):
    """State that a value is no farther from the true one than it says."""

    def statement(said):
        value = said.found["values"][name]
        assert isclose(abs(value["value"]), true, rel_tol=value["estimated_error"]), value

    return statement


def is_no_bug(said):
    """State that the outcome is named."""
    assert said.exit_code in (0, 1, 2)


def is_not_infeasible(said):
    """State that there is a design that passes."""
    assert said.status != "infeasible"


def sizes_what_exact_beams_hold(said):
    """State that there is a design, and that the exact model finds no fault with it."""
    assert said.status == "pass"
    spec = yaml.safe_load((HERE / f"{said.spec}.yaml").read_text())
    for name in ("h", "l", "b"):
        spec["geometry"][name] = f"{said.value(name)!r} m"
    spec.pop("size", None)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "sized.yaml")
        path.write_text(yaml.safe_dump(spec))
        again = ran(str(path), "check --model exact")
    assert {row["verdict"] for row in again.found["checks"]} <= {"pass", "undecided"}


def names_the_unbounded(size):
    """State that a size which nothing holds is a finding, not a number."""

    def statement(said):
        assert said.exit_code in (1, 2)
        assert any(f"thickness {size}" in finding["text"] for finding in said.found["findings"])

    return statement


class Row(NamedTuple):
    """A spec, the command, and what is true."""

    spec: str
    command: str
    statement: Callable[[Said], None]


def theta_adm(said):
    """State that the blades yield at 64.06°."""
    assert isclose(degrees(said.value("theta_adm")), 64.06, rel_tol=1e-3)


def peaked(said):
    """State that Neuber's peak 1.180 stands on the nominal stress of 144.3 MPa, or is open."""
    (row,) = said.rows("yield")
    if row["factor_range"] is not None:
        # plate widening, which the beam of the nominal stress lacks, only adds to it; what a thick
        # notch takes off, switched off here, is in the range alone
        assert row["factor"] <= 5.752 / 1.1804 * (1.0 + PRINTED)


ROWS = (
    Row("pivot-pulled-buckles", "check", fails("buckling", 361.3 / 500.0)),
    Row("buckling-at-stroke", "check", fails("buckling", 194.5 / 220.0)),
    Row("blade-crushed", "check", fails("buckling", 1.104)),
    Row("acceleration-unjudged", "check", judges_or_names("acceleration")),
    Row("acceleration-unjudged", "check", fails("yield")),
    Row("wrench-unjudged", "check", judges_or_names("wrench")),
    Row("stroke-and-acceleration", "check", judges_or_names("acceleration")),
    Row("sine-unjudged", "check", judges_or_names("sine")),
    Row("light-tip-mass", "check", fails("dynamic yield")),
    Row("folded-stage-masses", "check", fails("frequency")),
    Row("shock-and-asd", "check", fails("dynamic yield")),
    # 276 MPa over 229.9 MPa at the stop; the error of a random peak, by one exposure of each
    # blade, may reach the 1.5 that is asked
    Row("stops-unjudged", "check", does_not_pass()),
    # 510 and 880 MPa over 433 MPa, and the little shear at the edge of the strip beside it
    Row("torsion-wide", "check", fails("fatigue", 510.0 / 433.0)),
    Row("torsion-wide", "check", passes("yield", 880.0 / 433.0)),
    # 0.740 by the larger end of the stroke; half the range with its mean is less severe
    Row("necked-outside-validity", "check", fails("fatigue")),
    Row("rcc-locked-accuracy", "check", passes("buckling")),
    Row("rcc-locked-accuracy", "check", passes("yield")),
    Row("ends-in-stress", "check", passes("buckling")),
    Row("ends-in-stress", "check --model exact", passes("buckling")),
    Row("ends-in-stress", "check --model exact", passes("yield")),
    Row("moment-blade-shift", "check", tells("shift", 508e-9, PLATE)),
    Row("moment-blade-shift", "check --model exact", tells("shift", 508e-9, PLATE)),
    Row("admissible-stroke", "check", theta_adm),
    Row(
        "necked-long-stroke",  # of blades so far apart that they keep their stage upright
        "check --set geometry.spacing=40m",
        knows_its_error("x_adm", 15.216e-3),
    ),
    # those that stand 0.8 l apart bear 0.12 l/d (x/l)³ of their stress more for it
    Row("necked-long-stroke", "check", tells("x_adm", 15.216e-3 / (1.0 + 4.2e-3), 1e-3)),
    # plane elements of the whole joint
    Row("unseparated-shift", "check", knows_its_error("shift", 674.7e-9)),
    Row(
        "unseparated-shift",  # as the beams of the true number, which meet in a point
        "check --set effects.plate-widening=off --set effects.clamp-compliance=off",
        tells("shift", 514.2e-9, 1e-3),
    ),
    Row("three-blade-accuracy", "check", passes("sag")),
    Row("hinged-pivot-crash", "size", is_no_bug),
    Row("scanner", "size", sizes_what_exact_beams_hold),
    Row("exact-stock", "size --model exact", sizes_what_exact_beams_hold),
    Row("exact-false-infeasible", "size --model exact", sizes_what_exact_beams_hold),
    Row("support-not-sized", "size", sizes_what_exact_beams_hold),
    Row("filleted-thin", "size", names_the_unbounded("h")),
    Row("necked-crash", "size", is_no_bug),
    Row("necked-crash", "validate", is_no_bug),
    Row("notch-false-infeasible", "size", is_not_infeasible),
    Row("elliptic-false-infeasible", "size", is_not_infeasible),
    Row("wrench-and-stroke", "check", does_not_pass("yield")),
    Row("wrench-and-stroke", "check --model linear", does_not_pass("yield")),
    Row("wrench-and-stroke", "check --model exact", does_not_pass("yield")),
    Row("notch-peak", "check", peaked),
    Row("notch-peak", "check --model exact", peaked),
)


SLOW = ("stops-unjudged", "hinged-pivot-crash", "exact-stock", "exact-false-infeasible")
"""Specs whose cases are run in time, contact by contact, or that are sized by the exact model."""


@pytest.mark.parametrize(
    "row",
    [
        pytest.param(
            row,
            id=f"{row.spec}, {row.command}",
            marks=[pytest.mark.slow] if row.spec in SLOW else [],
        )
        for row in ROWS
    ],
)
def test_what_is_true_is_said(row):
    row.statement(run(row.spec, row.command))
