"""The command line, run in this process."""

import json

import pytest
from typer.testing import CliRunner

from flexcli.cli.app import command_line


@pytest.fixture
def inside_root():
    """Run a command and return the JSON document that it prints."""
    return lambda *arguments: json.loads(CliRunner().invoke(command_line(), arguments).stdout)
