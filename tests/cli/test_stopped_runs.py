"""Runs that end before their time, by Ctrl-C or by a limit, and references that lead outside."""

import json
import os
import signal
import subprocess
import sys

import pytest

COMMAND = [sys.executable, "-c", "from flexcli.cli.app import main; main()"]


@pytest.mark.parametrize(
    "verb",
    ["size", "check", "simulate", "plan", "accuracy", "balance", "asd response", "asd worst-case"],
)
def test_a_time_limit_is_a_named_outcome_of_every_verb(flexure, tmp_path, sizing, verb):
    (tmp_path / "flexure.yaml").write_text(sizing.design)
    told = flexure(*verb.split(), "--time-limit", "1e-6", "--format", "json")
    document = json.loads(told.stdout)
    assert told.returncode == 1, told.stderr
    assert document["status"] == "undecided"
    (found,) = document["findings"]
    assert "within the time limit of 1e-06 s" in found["text"]
    assert "--time-limit" in found["hint"]


@pytest.mark.parametrize("limit", ["0", "-1", "nan", "inf", "soon"])
def test_a_time_limit_is_a_positive_number_of_seconds(flexure, limit):
    told = flexure("check", "--time-limit", limit)
    assert told.returncode == 2
    assert "--time-limit" in told.stderr


def test_a_limit_that_is_not_reached_changes_nothing(flexure, tmp_path, sizing):
    (tmp_path / "flexure.yaml").write_text(sizing.design)
    free, bounded = (
        json.loads(flexure("check", *more, "--format", "json").stdout)
        for more in ((), ("--time-limit", "1e5"))
    )
    for document in (free, bounded):
        document.pop("cost")
        for check in document["checks"]:
            check.pop("cost")
    assert free == bounded


def started(folder, *arguments, stderr):
    """Start the command as from a terminal: tests in a background job inherit no Ctrl-C."""
    return subprocess.Popen(
        [*COMMAND, *arguments],
        cwd=folder, stdout=subprocess.PIPE, stderr=stderr, text=True,
        env={**os.environ, "COLUMNS": "100", "TERM": "xterm"},
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),  # noqa: PLW1509
    )  # fmt: skip


@pytest.mark.slow
def test_a_long_run_says_what_it_does_and_ends_at_ctrl_c(tmp_path, sizing):
    (tmp_path / "flexure.yaml").write_text(sizing.design)
    ours, terminal = os.openpty()
    process = started(tmp_path, "accuracy", "--runs", "1000", "--format", "json", stderr=terminal)
    try:
        seen = b""
        while b"accuracy flexure.yaml" not in seen:
            seen += os.read(ours, 4096)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
    finally:
        process.kill()
        os.close(ours)
        os.close(terminal)
    assert process.returncode == 1
    (found,) = json.loads(out)["findings"]
    assert found["text"] == "interrupted"


@pytest.mark.slow
def test_a_limit_ends_what_its_shell_shields_from_ctrl_c(tmp_path, sizing):
    (tmp_path / "flexure.yaml").write_text(sizing.design)
    told = subprocess.run(
        ["sh", "-c", 'trap "" INT; exec "$0" "$@"', *COMMAND,
         "accuracy", "--runs", "1000", "--time-limit", "2"],
        cwd=tmp_path, capture_output=True, text=True, check=False, timeout=60,
    )  # fmt: skip
    assert told.returncode == 1
    assert "not done within the time limit of 2 s" in told.stderr


def test_what_is_not_begun_when_the_time_is_up_is_named(flexure, tmp_path, sizing):
    for name in ("a.yaml", "b.yaml"):
        (tmp_path / name).write_text(sizing.design)
    told = flexure("check", "a.yaml", "b.yaml", "--time-limit", "1e-6")
    assert told.returncode == 1
    assert "a.yaml: not" in told.stderr
    assert "b.yaml: not" in told.stderr


def test_the_message_of_a_foreign_file_shows_none_of_it(flexure, tmp_path, example_text):
    (tmp_path / "home").mkdir()
    (tmp_path / "foreign.yaml").write_text("flexure: 1\nmaterial: {youngs_modulus: the secret}\n")
    spec = tmp_path / "home" / "flexure.yaml"
    spec.write_text(example_text.replace("material: ti-6al-4v-course", "material: ../foreign.yaml"))
    assert "../foreign.yaml" in spec.read_text()
    told = flexure("validate", str(spec))
    assert told.returncode == 2
    assert "lies outside the spec's folder" in told.stderr
    assert "material: ../foreign.yaml" in told.stderr, "the spec's own line"
    allowed = flexure("validate", str(spec), "--allow-outside")
    assert allowed.returncode == 2
    assert "foreign.yaml:2:28" in allowed.stderr
    assert "material: {youngs" not in allowed.stderr
