"""The command as a whole: help, exit codes, streams, interruptions."""

import json
import subprocess
import sys

import pytest

VERBS = ("size", "check", "validate", "materials", "schema")


def test_help_names_every_verb_and_exit_code(flexure):
    told = flexure("--help")
    assert told.returncode == 0
    for word in (*VERBS, "0 passed", "1 the design fails", "2 bad input", "101 a bug"):
        assert word in " ".join(told.stdout.split())


@pytest.mark.parametrize("verb", VERBS)
def test_every_verb_has_help(flexure, verb):
    assert flexure(verb, "--help").returncode == 0


def test_version_is_that_of_the_package(flexure):
    from flexcli import __version__

    assert flexure("--version").stdout.strip() == f"flexure {__version__}"


@pytest.mark.parametrize(
    "arguments", [("nonsense",), ("size", "--format", "xml"), ("size", "a", "b")]
)
def test_wrong_usage_exits_2_without_traceback(flexure, arguments):
    told = flexure(*arguments)
    assert told.returncode == 2
    assert "Traceback" not in told.stderr
    assert told.stderr


def test_without_a_file_the_folders_flexure_yaml_is_taken(flexure, tmp_path, example_text):
    (tmp_path / "flexure.yaml").write_text(example_text)
    told = flexure("size", "--model", "source")
    assert "size flexure.yaml" in " ".join(told.stdout.split())


def test_without_a_file_and_a_flexure_yaml_it_says_so(flexure):
    told = flexure("size")
    assert told.returncode == 2
    assert "flexure.yaml: there is no such file" in told.stderr


def test_json_stands_alone_on_stdout_when_the_spec_is_wrong(flexure, tmp_path):
    (tmp_path / "flexure.yaml").write_text("flexure: 1\nmaterial: unobtainium\n")
    told = flexure("size", "--format", "json")
    document = json.loads(told.stdout)
    assert told.returncode == 2
    assert document["status"] == "error"
    assert {f["path"] for f in document["findings"]} >= {"material"}
    assert all(f["line"] and f["text"] for f in document["findings"])


def test_the_list_of_commands_says_of_each_what_its_own_help_says():
    from typer.main import get_command

    from flexcli.cli.app import command_line, contents

    whole, listed = (get_command(app).commands for app in (command_line(), contents()))
    assert list(listed) == list(whole)
    assert {name: one.get_short_help_str(200) for name, one in listed.items()} == {
        name: one.get_short_help_str(200) for name, one in whole.items()
    }


def test_a_bug_exits_101_with_its_traceback(monkeypatch, capsys):
    from flexcli.cli import app

    def broken():
        raise RuntimeError("not foreseen")

    monkeypatch.setattr("sys.argv", ["flexure", "check"])
    monkeypatch.setattr(app, "command_line", lambda *_: broken)
    with pytest.raises(SystemExit) as ended:
        app.main()
    assert ended.value.code == app.EXIT_BUG == 101
    told = capsys.readouterr().err
    assert "RuntimeError: not foreseen" in told
    assert "a bug of ours" in told


def test_a_closed_pipe_ends_with_one_line(tmp_path, example_text):
    (tmp_path / "flexure.yaml").write_text(example_text)
    script = (
        f"{sys.executable} -c 'from flexcli.cli.app import main; main()' size --model source "
        "2>err; echo $? >code"
    )
    reader = subprocess.run(
        ["bash", "-c", f"( {script} ) | true"], cwd=tmp_path, check=False, timeout=60
    )
    assert reader.returncode == 0
    told = (tmp_path / "err").read_text()
    assert "Traceback" not in told
    assert len(told.splitlines()) <= 1


def test_a_full_disk_ends_with_one_line_and_code_2(process, tmp_path, example_text):
    (tmp_path / "flexure.yaml").write_text(example_text)
    with open("/dev/full", "w") as full:
        told = process("size", "--model", "source", stdout=full)
    assert told.returncode == 2
    assert told.stderr.splitlines() == [
        "flexure: the output could not be written: No space left on device"
    ]


@pytest.mark.parametrize(
    ("stated", "coloured"),
    [
        ({}, False),
        ({"FORCE_COLOR": "1"}, True),
        ({"FORCE_COLOR": "1", "NO_COLOR": "1"}, False),
        ({"FORCE_COLOR": "1", "TERM": "dumb"}, False),
    ],
)
def test_colours_come_where_they_are_wanted(flexure, stated, coloured):
    usual = {"NO_COLOR": "", "FORCE_COLOR": "", "TERM": "xterm"}
    assert ("\x1b[1m" in flexure("materials", **{**usual, **stated}).stdout) is coloured


def test_no_color_and_narrow_terminals_are_honoured(flexure, tmp_path, example_text):
    (tmp_path / "flexure.yaml").write_text(example_text)
    told = flexure("size", "--model", "source", COLUMNS="40", NO_COLOR="1", FORCE_COLOR="")
    assert "\x1b[3" not in told.stdout
    assert max(len(line) for line in told.stdout.splitlines()) <= 40
