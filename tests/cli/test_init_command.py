"""``flexure init`` and ``flexure examples``: something to start from, written where it is asked."""

import json
from pathlib import Path

import pytest
import yaml

EXAMPLES = Path(__file__).parents[2] / "examples"


def test_a_first_spec_is_sized_written_and_checked(flexure, tmp_path):
    assert flexure("init", "-o", "flexure.yaml").returncode == 0
    assert (tmp_path / "flexure.yaml").read_text() == flexure("init").stdout
    assert flexure("size", "--write", "sized.yaml").returncode == 0
    assert flexure("check", "sized.yaml").returncode == 0
    first, _ = (tmp_path / "sized.yaml").read_text().split("\n", 1)
    assert first.startswith("# yaml-language-server:"), "the schema stays in the first line"


def test_a_first_spec_replaces_no_file_but_by_force(flexure, tmp_path):
    mine = tmp_path / "flexure.yaml"
    mine.write_text("mine")
    told = flexure("init", "rcc", "-o", "flexure.yaml")
    assert (told.returncode, mine.read_text()) == (2, "mine")
    assert "--force" in told.stderr
    assert flexure("init", "rcc", "-o", "flexure.yaml", "--force").returncode == 0
    assert "kind: rcc" in mine.read_text()


def test_an_unknown_kind_names_the_nearest(flexure):
    told = flexure("init", "leafspring-stage")
    assert (told.returncode, told.stdout) == (2, "")
    assert "did you mean 'leaf-spring-stage'?" in told.stderr


@pytest.mark.parametrize("words", [("examples",), ("examples", "list")])
def test_every_example_is_listed_with_its_command(flexure, words):
    told = flexure(*words).stdout
    for folder in EXAMPLES.glob("*/"):
        assert folder.name in told
    found = json.loads(flexure("examples", "list", "--format", "json").stdout)
    for folder in EXAMPLES.glob("*/"):
        expected = yaml.safe_load((folder / "expected.yaml").read_text(encoding="utf-8"))
        verb = expected["command"].split()[0]
        assert found["examples"][folder.name]["command"].split()[:2] == ["flexure", verb]
    assert found["cost"]["seconds"] >= 0.0


def test_a_copied_example_runs_by_the_command_that_is_told(flexure, tmp_path):
    told = flexure("examples", "copy", "lecture-leaf-spring", "mine/stage")
    assert told.returncode == 0
    command = told.stdout.splitlines()[-1].split()
    assert command == ["flexure", "check", str(Path("mine/stage/flexure.yaml"))]
    assert flexure(*command[1:]).returncode == 0
    source = EXAMPLES / "lecture-leaf-spring"
    copied = tmp_path / "mine" / "stage"
    assert {path.name: path.read_bytes() for path in copied.iterdir()} == {
        path.name: path.read_bytes() for path in source.iterdir()
    }


def test_a_copy_replaces_nothing_and_leaves_nothing_half_done(flexure, tmp_path):
    (tmp_path / "torsion-bar").mkdir()
    (tmp_path / "torsion-bar" / "flexure.yaml").write_text("mine")
    told = flexure("examples", "copy", "torsion-bar")
    assert told.returncode == 2
    assert "it exists" in told.stderr
    assert [path.name for path in (tmp_path / "torsion-bar").iterdir()] == ["flexure.yaml"]
    assert flexure("examples", "copy", "torsion-bar", "--force").returncode == 0
    assert (tmp_path / "torsion-bar" / "README.md").is_file()


@pytest.mark.parametrize("name", ["lineer-stage", "../specs", ""])
def test_what_is_no_example_is_not_copied(flexure, tmp_path, name):
    told = flexure("examples", "copy", name)
    assert told.returncode == 2
    assert "linear-stage" in told.stderr
    assert not list(tmp_path.iterdir())
