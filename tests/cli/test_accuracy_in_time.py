"""``flexure accuracy`` on a design with stops: the series in time after that at rest."""

from pathlib import Path

import pytest
from typer.testing import CliRunner

from flexcli.cli.app import command_line
from flexcli.engine.comparing import time_accuracy

pytestmark = pytest.mark.slow  # general integrators step through many contacts

EXAMPLE = Path(__file__).parents[2] / "examples" / "boundary-control" / "flexure.yaml"


@pytest.fixture(scope="module")
def told():
    with pytest.MonkeyPatch.context() as patch:
        # the slow end of the series takes most of the time and shows nothing more here
        patch.setattr(time_accuracy, "TOLERANCES", (1e-4, 1e-6))
        yield CliRunner().invoke(command_line(), ["accuracy", str(EXAMPLE)], env={"COLUMNS": "120"})


def test_the_example_shows_its_peaks_by_each_method(told):
    assert told.exit_code == 0, told.output
    for name in ("tip_peak_resonance", "F_peak_resonance", "t_contact_resonance"):
        assert name in told.output
    for model in ("Radau at 1e-06", "DOP853 at 1e-04", "event-driven"):
        # once for each of the three numbers, once for all
        assert told.output.count(f" {model} ") >= 4


def test_it_names_the_cheapest_at_rest_and_in_time(told):
    assert "within 1 %, all quantities: source" in told.output
    assert "within 1 %, all quantities in time: " in told.output
    assert "no model" not in told.output
    assert told.output.index("k_stage") < told.output.index("tip_peak_resonance")
