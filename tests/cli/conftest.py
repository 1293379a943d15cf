"""A shell for the tests: runs ``flexure`` as a user does and keeps what it said."""

import gc
import io
import json
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from flexcli.cli.app import main

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
def process(tmp_path):
    """Run the command in an empty folder as a process of its own."""
    return shell(tmp_path)


@pytest.fixture
def flexure(tmp_path, monkeypatch):
    """Run the command in an empty folder; the answer has returncode, stdout and stderr.

    It runs in this process, from the command's entry to its exit code.
    """

    def run(*arguments, stdin="", encoding="utf-8", **environment):
        streams = {name: io.TextIOWrapper(io.BytesIO(), encoding) for name in ("stdout", "stderr")}
        source = io.TextIOWrapper(io.BytesIO(stdin.encode()), "utf-8")
        with monkeypatch.context() as at:
            at.chdir(tmp_path)
            for name, stream in (*streams.items(), ("stdin", source)):
                at.setattr(sys, name, stream)
            at.setattr(sys, "argv", ["flexure", *arguments])
            at.setattr(gc, "freeze", lambda: None)  # this process goes on
            for name, value in {"COLUMNS": "100", **environment}.items():
                at.setenv(name, value)
            with pytest.raises(SystemExit) as ended:
                main()
        told = {}
        for name, stream in streams.items():
            stream.flush()
            told[name] = stream.buffer.getvalue().decode(encoding)
        return SimpleNamespace(returncode=ended.value.code or 0, **told)

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
