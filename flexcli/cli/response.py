"""``flexure asd response``: what the mechanism's own modes make of a vibration or a shock."""

from typing import TYPE_CHECKING

from flexcli.cli.common import Format, FormatOption, SetOption, SpecsArgument, finish, on_each
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "response"
COMMAND = "asd response"


def run(
    specs: SpecsArgument = None, stated: SetOption = None, style: FormatOption = Format.TEXT
) -> None:
    """Compute what a design's modes make of each case.

    It gives modes, rms and peaks of travel, stress and force, and life.
    """

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.asd_response(spec)

    results = on_each(COMMAND, specs, stated, verb)
    finish(COMMAND, results, style, many=len(results) > 1)
