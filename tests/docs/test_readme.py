"""The README holds: its links, its picture, its spec, and the commands that it lists."""

import re
from pathlib import Path

import pytest
import typer

import flexcli
from flexcli.cli.app import command_line
from flexcli.report.drawings.plane import drawing_svg

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")
NUMBER = re.compile(r"-?\d+\.?\d*")


def test_its_links_lead_somewhere():
    links = re.findall(r"\]\(([^)#]+)\)", README)
    assert len(links) > 10
    assert [link for link in links if not (ROOT / link).exists()] == []


def test_its_first_two_shell_blocks_are_the_main_job_and_the_tests():
    size, test, *_ = re.findall(r"^```sh\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
    assert "flexure size examples/" in size
    assert "pytest" in test


def test_its_picture_is_what_the_tool_draws():
    spec = flexcli.load(ROOT / "examples" / "wittrick-crossing" / "flexure.yaml")
    kept = (ROOT / "docs" / "images" / "wittrick-crossing.svg").read_text(encoding="utf-8")
    drawn = drawing_svg(flexcli.drawing(spec), spec.part.title)
    assert NUMBER.sub("", kept) == NUMBER.sub("", drawn)
    # half a pixel: what another machine's last digits could move by rounding is a hundredth
    numbers = [[float(x) for x in NUMBER.findall(svg)] for svg in (kept, drawn)]
    assert numbers[0] == pytest.approx(numbers[1], abs=0.5)


def test_its_spec_is_one():
    (text,) = re.findall(r"^```yaml\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
    assert flexcli.load(text).kind == "design"


def test_its_table_has_every_command():
    told = README.split("## Commands")[1].split("\n### ")[0]
    for name in typer.main.get_command(command_line()).commands:
        assert re.search(rf"`flexure {name}[ `]", told), name


@pytest.mark.parametrize("page", sorted((ROOT / "docs").rglob("*.md")), ids=lambda p: p.stem)
def test_sections_that_a_page_takes_from_the_readme_are_there(page):
    for heading in re.findall(r"<!-- README: (.+) -->", page.read_text(encoding="utf-8")):
        assert re.search(rf"^#+ {re.escape(heading)}$", README, re.MULTILINE)
