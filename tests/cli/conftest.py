"""A shell for the tests: runs ``flexure`` as a user does and keeps what it said."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "rocket-parallel-stage" / "flexure.yaml"


@pytest.fixture
def example_text():
    return EXAMPLE.read_text()


@pytest.fixture
def flexure(tmp_path):
    """Run the command in an empty folder; the answer has returncode, stdout and stderr."""

    def run(*arguments, stdin=None, stdout=subprocess.PIPE, **environment):
        command = [sys.executable, "-c", "from flexcli.cli.app import main; main()", *arguments]
        return subprocess.run(
            command,
            cwd=tmp_path,
            env={**os.environ, "COLUMNS": "100", **environment},
            stdin=stdin,
            stdout=stdout,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
            timeout=120,
        )

    return run
