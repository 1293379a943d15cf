"""``flexure stops`` as a user runs it."""

import csv
import json
import os
import signal
import subprocess
import sys

import pytest

SPEC = """\
flexure: 1
title: bender
material: {youngs_modulus: 60 GPa, poisson_ratio: 0.31, yield_strength: 55.4 MPa}
geometry: {kind: cantilever, h: 1.25 mm, l: 28.5 mm, b: 7.8 mm}
mechanism: {kind: tip-mass, mass: 8.07 g, damping: {q: 20}}
cases:
  resonance: {sine: {acceleration: 1.5 g, frequency: 176 Hz}}
requirements: {}
stops:
  travel: 100 um
  smallest-gap: 20 um
  bending: 2
"""
LONG = "asd: {profile: {points: [{frequency: 20 Hz, level: 1e-4 g^2/Hz}, \
{frequency: 2 kHz, level: 1e-4 g^2/Hz}]}, q: 20, duration: 1 h}"
LOUD = "asd: {profile: {points: [{frequency: 100 Hz, level: 1e-2 g^2/Hz}, \
{frequency: 300 Hz, level: 1e-2 g^2/Hz}]}, q: 20, duration: 0.1 s}"


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


def with_case(spec, case):
    spec.write_text(SPEC.replace("sine: {acceleration: 1.5 g, frequency: 176 Hz}", case))


def test_without_a_file_it_takes_the_spec_of_the_folder(flexure, spec):
    told = flexure("stops", "--no-simulate", COLUMNS="160")
    assert told.returncode == 1, told.stderr
    assert told.stdout.startswith("UNDECIDED  stops flexure.yaml")
    assert "chosen: height 14.834 mm, gap 32.52 µm" in told.stdout
    assert "Heights at which each limit holds" in told.stdout


def test_json_has_the_names_of_the_source(flexure, spec):
    document = json.loads(flexure("stops", "--no-simulate", "--format", "json").stdout)
    names = "k_free k_contact pi_1 pi_5 delta_G L_a F_contact F_excess sigma_base sigma_contact"
    assert set(names.split()) <= set(document["values"])
    assert document["stops"]["chosen"]["delta_G"] == document["values"]["delta_G"]["value"]
    assert document["stops"]["simulations"] == []
    assert "histories" not in document["stops"]


def test_a_simulation_that_finds_more_travel_exits_1(flexure, spec):
    told = flexure("stops", "--simulate", "--format", "json")
    document = json.loads(told.stdout)
    assert told.returncode == 1
    (travel,) = (check for check in document["checks"] if check["name"] == "travel")
    assert travel["verdict"] == "fail"
    assert travel["case"] == "resonance"
    assert travel["model"] == "rigid contact"
    assert "beyond-the-line" in [note["code"] for note in document["warnings"]]
    assert told.stderr == ""  # no progress bar where nobody looks


def test_what_the_line_leaves_undecided_a_simulation_decides(flexure, spec):
    told = flexure("stops", "--format", "json")
    document = json.loads(told.stdout)
    assert document["status"] == "fail"
    assert document["cost"]["model"] == "operating line, rigid contact"
    assert document["stops"]["simulations"]


def test_check_judges_a_design_between_its_stops(flexure, spec):
    document = json.loads(flexure("check", "--format", "json").stdout)
    (travel,) = (check for check in document["checks"] if check["name"] == "travel")
    assert travel["verdict"] == document["status"] == "fail"
    assert not any(check["verdict"] == "not judged" for check in document["checks"])


def test_a_stop_that_does_not_exist_exits_1_with_its_reason(flexure, spec):
    spec.write_text(SPEC.replace("bending: 2", "bending: 9"))
    told = flexure("stops")
    assert told.returncode == 1
    assert "no stop is possible: nowhere on the operating line: bending" in told.stdout


def test_a_mistake_exits_2_with_its_place(flexure, spec):
    spec.write_text(SPEC.replace("travel: 100 um", "travel: 100"))
    told = flexure("stops")
    assert told.returncode == 2
    assert "stops.travel: 100 has no unit" in told.stderr


def test_a_design_without_stops_exits_2(flexure, spec):
    spec.write_text(SPEC[: SPEC.index("stops:")])
    told = flexure("stops")
    assert told.returncode == 2
    assert "the design has no stops" in told.stderr


def test_the_history_is_saved(flexure, spec, tmp_path):
    flexure("stops", "--simulate", "--csv", "history.csv")
    rows = list(csv.DictReader((tmp_path / "history.csv").read_text().splitlines()))
    assert rows[0]["case"] == "resonance"
    assert max(float(row["force_N"]) for row in rows) > 1.0


@pytest.mark.slow
def test_the_response_is_saved_and_shown(flexure, spec, tmp_path):
    with_case(spec, "sweep: {from: 170 Hz, to: 200 Hz, rate: 200 Hz/s, acceleration: 1.5 g}")
    told = flexure("stops", "--sweep", "--no-simulate", "--csv", "sweep.csv", COLUMNS="160")
    rows = list(csv.DictReader((tmp_path / "sweep.csv").read_text().splitlines()))
    assert {row["direction"] for row in rows} == {"up", "down"}
    assert len(rows) > 40
    assert "going up it touches from" in told.stdout
    assert told.returncode == 1  # the design fails its travel


def test_a_table_of_nothing_is_refused(flexure, spec):
    told = flexure("stops", "--csv", "x.csv")
    assert told.returncode == 2
    assert "add --simulate or --sweep" in told.stderr


@pytest.mark.slow
def test_the_seed_can_be_chosen(flexure, spec):
    with_case(spec, LOUD)
    runs = [
        json.loads(flexure("stops", "--simulate", "--format", "json", *seed).stdout)
        for seed in ((), ("--seed", "0"), ("--seed", "7"))
    ]
    travels = [run["stops"]["simulations"][0]["travel"] for run in runs]
    assert travels[0] == travels[1] != travels[2]
    assert runs[2]["stops"]["simulations"][0]["seed"] == 7


@pytest.mark.slow
def test_ctrl_c_keeps_what_was_done_and_a_terminal_sees_how_far_it_is(spec, tmp_path):
    with_case(spec, LONG)
    command = [sys.executable, "-c", "from flexcli.cli.app import main; main()"]
    ours, terminal = os.openpty()
    process = subprocess.Popen(
        [*command, "stops", "--simulate", "--format", "json"],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=terminal, text=True,
        env={**os.environ, "COLUMNS": "100", "TERM": "xterm"},
    )  # fmt: skip
    try:
        seen = b""
        while b"resonance" not in seen:
            seen += os.read(ours, 4096)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
    finally:
        process.kill()
        os.close(ours)
        os.close(terminal)
    document = json.loads(out)
    assert process.returncode == 1
    (run,) = document["stops"]["simulations"]
    assert 0.0 < run["duration"] < run["planned"]
    assert 0.0 < run["confidence"] < 0.1
    assert "interrupted" in [note["code"] for note in document["warnings"]]
