"""Specs from a stranger: large, deep and explosive ones cost bounded work, counted in nodes."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml
from yaml_texts import parsed, refused

from flexcli.errors import SpecError
from flexcli.spec import parse
from flexcli.spec.parse import MAX_DEPTH, MAX_NODES
from flexcli.spec.read import MAX_BYTES, read_document

EVENTS_PER_NODE = 2
"""A collection has a start and an end; a scalar and an alias are one event."""
EDGES = 4
"""Events of the stream and of the document."""


class Counter:
    """Counts the events that the reader takes from the parser."""

    def __init__(self) -> None:
        self.events = 0

    def parse(self, text: str, Loader: Any) -> Iterator[Any]:
        for event in yaml.parse(text, Loader=Loader):
            self.events += 1
            yield event


class CountedYaml:
    """Stands for the module in the reader, with its parser counted."""

    def __init__(self, counter: Counter) -> None:
        self.parse = counter.parse

    def __getattr__(self, name: str) -> Any:
        return getattr(yaml, name)


@pytest.fixture
def counter(monkeypatch: pytest.MonkeyPatch) -> Counter:
    counted = Counter()
    monkeypatch.setattr(parse, "yaml", CountedYaml(counted))
    return counted


def nodes(value: object) -> int:
    """Count the values of a tree as one who walks it meets them, aliases unfolded."""
    if isinstance(value, dict):
        return 1 + sum(1 + nodes(inner) for inner in value.values())
    if isinstance(value, list):
        return 1 + sum(map(nodes, value))
    return 1


@pytest.mark.usefixtures("counter")
def test_a_spec_of_the_greatest_size_is_read(tmp_path: Path) -> None:
    """A bound that counts characters after decoding, or one byte off, refuses what it promises."""
    file = tmp_path / "large.yaml"
    file.write_bytes(b"a: 1\n#".ljust(MAX_BYTES, b"x"))
    assert read_document(file).value == {"a": 1}


def test_one_byte_more_is_refused_before_it_is_parsed(tmp_path: Path, counter: Counter) -> None:
    """A file without end (a device, a stream) must not be read to its end first."""
    file = tmp_path / "larger.yaml"
    file.write_bytes(b"a: 1\n#".ljust(MAX_BYTES + 1, b"x"))
    with pytest.raises(SpecError, match="larger than"):
        read_document(file)
    assert counter.events == 0


@pytest.mark.slow
def test_a_file_full_of_values_stops_at_the_bound_on_values(counter: Counter) -> None:
    """Half a million one-letter values fit in a megabyte: positions would take a gigabyte."""
    (finding,) = refused("[" + "x," * (MAX_BYTES // 2 - 1) + "]")
    assert f"more than {MAX_NODES} values" in finding.text
    assert counter.events <= EVENTS_PER_NODE * MAX_NODES + EDGES


@pytest.mark.parametrize("opening", ["[", "{a: ", "- ", "? "])
def test_deep_nesting_stops_at_the_bound_on_depth(opening: str, counter: Counter) -> None:
    """A reader that recurses ends in a stack overflow that no one can catch."""
    findings = refused(opening * 20_000)
    assert any("deeper" in finding.text for finding in findings)
    assert counter.events <= EVENTS_PER_NODE * (MAX_DEPTH + 1) + EDGES


def bomb(width: int, height: int) -> str:
    lines = ["a0: &a0 [" + "x, " * width + "]"]
    lines += [f"a{n}: &a{n} [" + ", ".join([f"*a{n - 1}"] * width) + "]" for n in range(1, height)]
    return "\n".join(lines)


def test_an_alias_bomb_stops_at_the_bound_on_unfolded_values(counter: Counter) -> None:
    """Ten lines unfold to a billion values as soon as someone walks them."""
    text = bomb(10, 10)
    (finding,) = refused(text)
    assert "aliases unfolded" in finding.text
    # no more than the bomb is long, however far it would unfold
    assert counter.events <= text.count("*") + text.count("x") + 40


def test_the_largest_tree_that_aliases_may_unfold_to_is_bounded() -> None:
    """What is let through is walked by everyone after: it must be as small as it was counted."""
    found = parsed(bomb(5, 6))
    assert nodes(found.value) <= MAX_NODES
    with pytest.raises(SpecError, match="more than"):
        parsed(bomb(5, 8))


def test_aliases_do_not_hide_depth(counter: Counter) -> None:
    """Each line is two levels deep; unfolded they are a hundred."""
    lines = ["a0: &a0 [x]", *(f"a{n}: &a{n} [*a{n - 1}]" for n in range(1, 100))]
    findings = refused("\n".join(lines))
    assert any("deeper" in finding.text for finding in findings)
    assert counter.events <= 5 * (MAX_DEPTH + 1) + EDGES
