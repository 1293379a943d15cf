"""``flexure draw`` as a user runs it."""

from pathlib import Path
from xml.etree import ElementTree

import pytest

WITTRICK = Path(__file__).parents[2] / "examples" / "wittrick-crossing" / "flexure.yaml"


def test_draw_writes_an_svg_to_stdout(flexure):
    done = flexure("draw", str(WITTRICK))
    assert done.returncode == 0
    assert ElementTree.fromstring(done.stdout).tag.endswith("svg")


@pytest.mark.parametrize("view", ["side", "isometric"])
def test_draw_writes_a_file_from_other_sides(flexure, tmp_path, view):
    done = flexure("draw", str(WITTRICK), "--view", view, "-o", str(tmp_path / "it.svg"))
    assert (done.returncode, done.stdout) == (0, "")
    assert f"{view} view" in (tmp_path / "it.svg").read_text(encoding="utf-8")


def test_a_case_that_is_not_there_writes_nothing(flexure, tmp_path):
    done = flexure("draw", str(WITTRICK), "--case", "flight", "-o", str(tmp_path / "it.svg"))
    assert done.returncode == 2
    assert "there is no case flight" in done.stderr
    assert not (tmp_path / "it.svg").exists()
