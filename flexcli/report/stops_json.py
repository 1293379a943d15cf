"""The answer of ``flexure stops`` as JSON content, numbers in SI."""

from typing import Any

from flexcli.results.stops import StopsResult

__all__ = ["stops_document"]


def stops_document(stops: StopsResult) -> dict[str, Any]:
    """Return it as the contract has it; histories are for the CSV file alone."""
    return {key: value for key, value in stops._asdict().items() if key != "histories"}
