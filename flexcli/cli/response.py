"""``flexure asd response``: what the mechanism's own modes make of a vibration or a shock."""

from pathlib import Path

from flexcli.cli.common import Format, FormatOption, SpecArgument, attempt, finish, spec_path
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "response"
COMMAND = "asd response"


def run(spec: SpecArgument = None, style: FormatOption = Format.TEXT) -> None:
    """Modes, rms and peak travel, stress and force, and life of a given design, per case."""
    path = spec_path(spec)
    result = attempt(COMMAND, path, lambda: _respond(path))
    finish(COMMAND, [result], style, many=False)


def _respond(path: Path) -> Result:
    from flexcli.engine.response import respond
    from flexcli.spec.given import given_sizes
    from flexcli.spec.load import load_design

    design, document = load_design(path)
    return respond(design, given_sizes(design, document), str(path))
