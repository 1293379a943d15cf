"""What comes out of the command on a real terminal, in any encoding, and in the formats of CI."""

import fcntl
import json
import os
import pty
import re
import struct
import subprocess
import sys
import termios
import textwrap
from pathlib import Path
from xml.etree import ElementTree

import pytest
import typer.testing
import yaml

from flexcli.cli import app as command
from flexcli.report.formats import Format

ROOT = Path(__file__).parents[2]

NAME = "σ³ ½ ←"
"""A case's name of which ascii, cp1252 and latin-1 lack something."""

SPEC = f"""\
flexure: 1
title: a stage
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.34, yield_strength: 800 MPa}}
geometry: {{kind: leaf-spring-stage, spacing: 40 mm, h: 300 um, l: 50 mm, b: 10 mm}}
cases:
  "{NAME}": {{stroke: {{translation: 2 mm}}}}
requirements:
  stiffness: {{max: 1 N/m}}
  yield: 1.5
"""


@pytest.fixture
def design(tmp_path):
    (tmp_path / "flexure.yaml").write_text(SPEC, encoding="utf-8")
    return tmp_path


def on_terminal(folder, columns, *arguments):
    """Return what the command writes on a terminal of so many columns, and its exit code."""
    ours, its = pty.openpty()
    fcntl.ioctl(its, termios.TIOCSWINSZ, struct.pack("HHHH", 50, columns, 0, 0))
    environment = {key: value for key, value in os.environ.items()
                   if key not in ("COLUMNS", "LINES", "NO_COLOR", "FORCE_COLOR")}  # fmt: skip
    run = subprocess.Popen(
        [sys.executable, "-c", "from flexcli.cli.app import main; main()", *arguments],
        cwd=folder, stdin=its, stdout=its, stderr=subprocess.DEVNULL,
        env={**environment, "TERM": "xterm", "PYTHONIOENCODING": "utf-8"},
    )  # fmt: skip
    os.close(its)
    told = b""
    try:
        while part := os.read(ours, 65536):
            told += part
    except OSError:  # Linux says so at the end of what a terminal's other side wrote
        pass
    os.close(ours)
    return told.decode().replace("\r\n", "\n"), run.wait(timeout=60)


@pytest.mark.parametrize("columns", [40, 80, 200])
def test_a_terminal_of_any_width_shows_verdict_and_name_of_every_check(design, columns):
    told, code = on_terminal(design, columns, "check")
    assert code == 1
    assert "\x1b[1;31mFAIL" in told
    text = re.sub(r"\x1b\[[\d;]*m", "", told)
    assert max(map(len, text.splitlines())) <= columns
    assert re.search(r"^FAIL +stiffness \(max\)", text, re.MULTILINE)
    assert re.search(rf"^pass +yield \(yield-strength\), {NAME}", text, re.MULTILINE)


@pytest.fixture
def flexure(flexure, design):
    """Run the command in the folder of the design."""
    return flexure


@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "latin-1", "utf-8"])
def test_any_encoding_of_stdout_will_do(flexure, encoding):
    told = flexure("check", encoding=encoding)
    assert told.returncode == 1
    spelt = {"ascii": "sigma^3 1/2 <-", "cp1252": "sigma³ ½ <-", "latin-1": "sigma³ ½ <-"}
    assert f"yield (yield-strength), {spelt.get(encoding, NAME)}" in told.stdout
    assert max(map(len, told.stdout.splitlines())) <= 100
    told = flexure("check", "--format", "json", encoding=encoding)
    assert NAME in [row["case"] for row in json.loads(told.stdout)["checks"]]


def test_a_console_that_knows_only_ascii_gets_ascii(process, design):
    told = process("check", PYTHONIOENCODING="ascii")
    assert told.returncode == 1
    assert "yield (yield-strength), sigma^3 1/2 <-" in told.stdout
    assert "Traceback" not in told.stderr


def test_findings_and_help_need_no_more_than_ascii(flexure, design):
    (design / "flexure.yaml").write_text(SPEC.replace("2 mm", "2 µσ"), encoding="utf-8")
    told = flexure("check", encoding="ascii")
    assert told.returncode == 2
    assert "2 usigma" in told.stderr
    assert flexure("--help", encoding="ascii").returncode == 0


@pytest.mark.parametrize("style", ["text", "json", "github", "markdown", "sarif", "junit"])
def test_the_name_of_a_file_cannot_steer_a_terminal(flexure, style):
    told = flexure("check", "\x1b[31m\x9b2Jx.yaml", "--format", style)
    assert told.returncode == 2
    assert not set(told.stdout + told.stderr) & {"\x1b", "\x9b"}


@pytest.mark.parametrize(
    "arguments",
    [
        ("check", "--nonsense"),
        ("simulate", "--points", "many"),
        ("stops", "--seed", "-1"),
        ("check", "missing.yaml"),
        ("materials", "unobtainium"),
        ("nonsense",),
    ],
)
def test_wrong_usage_is_told_in_the_asked_format(flexure, arguments):
    told = flexure(*arguments, "--format", "json")
    assert told.returncode == 2
    document = json.loads(told.stdout)
    assert document["status"] == "error"
    assert document["findings"][0]["text"]
    assert "cost" in document


def test_wrong_usage_is_an_error_in_ci_too(flexure):
    assert flexure("check", "--nonsense", "--format", "github").stdout.startswith("::error ")
    told = flexure("check", "--nonsense", "--format", "junit")
    assert told.returncode == 2
    assert ElementTree.fromstring(told.stdout)[0].get("errors") == "1"


def test_a_format_of_results_is_refused_where_there_are_none(flexure):
    told = flexure("materials", "--format", "junit")
    assert told.returncode == 2
    assert ElementTree.fromstring(told.stdout)[0].get("errors") == "1"


def test_a_bug_is_told_in_the_asked_format(monkeypatch, capsys):
    def broken(**_):
        raise RuntimeError("not foreseen")

    monkeypatch.setattr(command, "command_line", lambda *_: broken)
    monkeypatch.setattr(sys, "argv", ["flexure", "check", "--format", "json"])
    with pytest.raises(SystemExit) as ended:
        command.main()
    assert ended.value.code == 101
    assert "not foreseen" in json.loads(capsys.readouterr().out)["findings"][0]["text"]


VERBS = ("size", "check", "simulate", "plan", "accuracy", "balance", "stops", "explain",
         "validate", "materials", "schema", "asd response", "asd worst-case")  # fmt: skip


@pytest.mark.parametrize("verb", VERBS)
@pytest.mark.parametrize("option", ["-h", "--help"])
def test_the_help_of_every_command_has_its_exit_codes(verb, option):
    told = typer.testing.CliRunner().invoke(command.command_line(), [*verb.split(), option])
    assert told.exit_code == 0
    words = " ".join(told.stdout.split())
    for code in ("0 passed", "1 the design fails", "2 bad input", "101 a bug"):
        assert code in words


@pytest.mark.parametrize("arguments", [("-h",), ("asd", "-h")])
def test_the_list_of_commands_has_whole_sentences(arguments, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    told = typer.testing.CliRunner().invoke(command.command_line(), arguments).stdout
    rows = told.split("Commands:")[1].split("\n\n")[0].strip().splitlines()
    assert len(rows) > 5
    assert all(row.endswith(".") and not row.endswith("...") for row in rows)


def test_the_shell_can_complete():
    told = typer.testing.CliRunner().invoke(command.command_line(), ["--help"]).stdout
    assert "--install-completion" in told


def line_of(text, spec=SPEC):
    return next(i for i, row in enumerate(spec.splitlines(), 1) if text in row)


def test_each_format_has_the_line_of_the_requirement_that_fails(flexure):
    line = line_of("stiffness:")
    document = json.loads(flexure("check", "--format", "json").stdout)
    places = {check["name"]: check["place"] for check in document["checks"]}
    assert places["stiffness (max)"] == {
        "file": "flexure.yaml", "line": line, "column": 3, "path": "requirements.stiffness",
    }  # fmt: skip
    assert places["yield (yield-strength)"]["line"] == line_of("yield: 1.5")
    (error,) = (row for row in flexure("check", "--format", "github").stdout.splitlines()
                if row.startswith("::error"))  # fmt: skip
    assert error.startswith(f"::error file=flexure.yaml,line={line},col=3,title=stiffness (max)::")
    log = json.loads(flexure("check", "--format", "sarif").stdout)
    regions = [found["locations"][0]["physicalLocation"].get("region")
               for found in log["runs"][0]["results"] if found["level"] == "error"]  # fmt: skip
    assert regions == [{"startLine": line, "startColumn": 3}]
    suite = ElementTree.fromstring(flexure("check", "--format", "junit").stdout)[0]
    assert [case.text.split(" ")[0] for case in suite.iter("failure")] == [
        f"flexure.yaml:{line}:3:"
    ]
    row = next(row for row in flexure("check", "--format", "markdown").stdout.splitlines()
               if row.startswith("| FAIL"))  # fmt: skip
    assert row.endswith(f"| {line} |")


def test_a_load_that_nobody_looks_at_has_its_own_line(flexure, design):
    spec = SPEC.replace("mm}}", "mm}, sine: {acceleration: 1 g, frequency: 20 Hz}}")
    (design / "flexure.yaml").write_text(spec, encoding="utf-8")
    told = flexure("check", "--format", "json")
    (row,) = (c for c in json.loads(told.stdout)["checks"] if c["verdict"] == "not judged")
    assert row["place"]["line"] == line_of("sine", spec)


def test_a_requirement_of_several_has_the_line_of_the_one_that_fails(flexure, design):
    one = "stiffness: {max: 1 N/m}"
    spec = SPEC.replace(one, "stiffness:\n    - {max: 1 kN/m}\n    - {min: 2 kN/m}")
    (design / "flexure.yaml").write_text(spec, encoding="utf-8")
    checks = json.loads(flexure("check", "--format", "json").stdout)["checks"]
    places = {check["name"]: check["place"]["line"] for check in checks}
    assert places["stiffness (max)"] == line_of("max: 1 kN/m", spec)
    assert places["stiffness (min)"] == line_of("min: 2 kN/m", spec)


@pytest.mark.parametrize("verb", ["size", "simulate"])
def test_other_verbs_that_judge_have_the_lines_too(flexure, design, verb):
    checks = json.loads(flexure(verb, "--format", "json").stdout)["checks"]
    assert checks
    assert all(check["place"]["line"] > 1 for check in checks)


def test_the_hooks_of_pre_commit_run_commands_that_there_are():
    hooks = yaml.safe_load((ROOT / ".pre-commit-hooks.yaml").read_text())
    assert {hook["id"] for hook in hooks} == {"flexure-validate", "flexure-check"}
    for hook in hooks:
        program, *verb = hook["entry"].split()
        assert program == "flexure"
        assert (
            typer.testing.CliRunner().invoke(command.command_line(), [*verb, "-h"]).exit_code == 0
        )


def test_the_workflow_of_the_guide_is_one_and_uses_formats_that_there_are():
    text = (ROOT / "docs" / "how-to" / "ci.md").read_text(encoding="utf-8")
    block = text.split("    # .github/workflows/flexures.yml\n")[1].split("\n\n")[0]
    steps = yaml.safe_load(textwrap.dedent(block))["jobs"]["flexures"]["steps"]
    asked = re.findall(r"--format (\w+)", " ".join(step.get("run", "") for step in steps))
    assert asked == ["github", "markdown"]
    assert set(asked) <= set(Format)
