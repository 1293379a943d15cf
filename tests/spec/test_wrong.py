"""One bad spec per mistake in ``tests/wrong``, each beside the findings that it must give."""

from functools import cache
from pathlib import Path

import pytest
import yaml

from flexcli.errors import Finding, SpecError
from flexcli.spec.load import load

WRONG = Path(__file__).parent.parent / "wrong"
KEYS = ("line", "column", "path", "text")
NAMES = sorted(p.stem for p in WRONG.glob("*.yaml") if not p.stem.endswith(".expected"))


@cache
def findings(name: str) -> list[Finding]:
    with pytest.raises(SpecError) as raised:
        load(Path(f"{name}.yaml"))
    return raised.value.findings


@pytest.fixture(autouse=True)
def in_the_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(WRONG)


@pytest.mark.parametrize("name", NAMES)
def test_each_mistake_is_found_where_it_stands(name: str) -> None:
    expected = yaml.safe_load((WRONG / f"{name}.expected.yaml").read_text(encoding="utf-8"))
    found = [finding._asdict() for finding in findings(name)]
    # a hint that lists names is left out of the expectation: the list grows with the parts
    stated = [{"file": f"{name}.yaml", **one} for one in expected]
    assert [
        {key: mistake[key] for key in ("file", *KEYS, *(["hint"] if "hint" in one else []))}
        for mistake, one in zip(found, stated, strict=True)
    ] == stated


def test_each_finding_says_what_is_wrong_and_what_would_be_right() -> None:
    for name in NAMES:
        for finding in findings(name):
            assert finding.text, name
            assert finding.hint, name
            assert "Input should" not in finding.text, f"{name}: pydantic's own words"


def test_each_finding_shows_its_line() -> None:
    for name in NAMES:
        for finding in findings(name):
            lines = Path(finding.file).read_bytes().decode("utf-8", errors="replace").split("\n")
            line = lines[finding.line - 1]
            shown = finding.source_line.replace("\N{REPLACEMENT CHARACTER}", "")
            assert finding.column <= len(line) + 1, name
            assert shown == "" or line.replace("\t", " ").startswith(shown[:10]), name


def test_every_expectation_has_its_spec() -> None:
    assert {p.name.removesuffix(".expected.yaml") for p in WRONG.glob("*.expected.yaml")} == set(
        NAMES
    )
    assert len(NAMES) > 100
