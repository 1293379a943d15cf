"""A shell for the tests: runs ``flexure`` as a user does and keeps what it said."""

import json
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "rocket-parallel-stage" / "flexure.yaml"


@pytest.fixture
def example_text():
    return EXAMPLE.read_text()


def shell(folder):
    """Return what runs the command in a folder."""

    def run(*arguments, stdin=None, stdout=subprocess.PIPE, **environment):
        command = [sys.executable, "-c", "from flexcli.cli.app import main; main()", *arguments]
        return subprocess.run(
            command,
            cwd=folder,
            env={**os.environ, "COLUMNS": "100", **environment},
            stdin=stdin,
            stdout=stdout,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
            timeout=120,
        )

    return run


@pytest.fixture
def flexure(tmp_path):
    """Run the command in an empty folder; the answer has returncode, stdout and stderr."""
    return shell(tmp_path)


@pytest.fixture
def inside(tmp_path, monkeypatch):
    """Run the command in an empty folder in this process, which need not import it anew."""
    from typer.testing import CliRunner

    from flexcli.cli.app import command_line

    def run(*arguments, stdin=None):
        with monkeypatch.context() as at:
            at.chdir(tmp_path)
            told = CliRunner().invoke(
                command_line(), arguments, input=stdin, env={"COLUMNS": "100"}
            )
        if told.exception is not None and not isinstance(told.exception, SystemExit):
            raise told.exception
        return SimpleNamespace(returncode=told.exit_code, stdout=told.stdout, stderr=told.stderr)

    return run


@pytest.fixture(scope="session")
def sizing(tmp_path_factory):
    """Return what the one sizing of the example said and the design that it wrote."""
    folder = tmp_path_factory.mktemp("sizing")
    (folder / "flexure.yaml").write_text(EXAMPLE.read_text())
    told = shell(folder)("size", "--write", "sized.yaml", "--format", "json")
    assert told.returncode == 0, told.stderr
    document, design = json.loads(told.stdout), (folder / "sized.yaml").read_text()
    return SimpleNamespace(document=document, design=design)
