"""Text to values and positions: the core schema of YAML 1.2, bounds, and what is refused."""

import os
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from flexcli.errors import Finding, SpecError
from flexcli.spec import document
from flexcli.spec.document import Document, finding_at, parse_document, read_document

LOADERS = [yaml.SafeLoader, *([yaml.CSafeLoader] if yaml.__with_libyaml__ else [])]


@pytest.fixture(params=LOADERS, ids=lambda loader: loader.__name__)
def either_parser(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run a test with libyaml's parser and with the one in Python that stands in for it."""
    monkeypatch.setattr(document, "_SafeLoader", request.param)


def parsed(text: str) -> Document:
    return parse_document(text, "spec.yaml")


def value(text: str) -> object:
    found = parsed(text)
    assert not found.findings
    return found.value


def refused(text: str) -> list[Finding]:
    with pytest.raises(SpecError) as raised:
        parsed(text)
    return raised.value.findings


def place(text: str, *path: str | int) -> tuple[int, int, int, int]:
    found, taken = parsed(text).position.closest(path)
    assert taken == path
    return found.line, found.column, found.key_line, found.key_column


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1e-3", 1e-3),
        ("1E7", 1e7),
        ("+.5", 0.5),
        ("010", 10),
        ("0o17", "0o17"),
        ("0x1F", "0x1F"),
        ("1_000", "1_000"),
        ("1:30", "1:30"),
        ("2024-01-01", "2024-01-01"),
        ("no", "no"),
        ("on", "on"),
        ("y", "y"),
        ("true", True),
        ("False", False),
        ("null", None),
        ("~", None),
        (".inf", float("inf")),
        ("-.INF", float("-inf")),
        ("'1e-3'", "1e-3"),
        ('"true"', "true"),
        ("0.2 mm", "0.2 mm"),
        ("µm", "µm"),
        ("=", "="),
        ("9" * 400, float("inf")),
    ],
)
@pytest.mark.usefixtures("either_parser")
def test_scalars_follow_the_core_schema(text: str, expected: object) -> None:
    found = value(f"- {text}")
    assert found == [expected]
    assert isinstance(found, list)
    assert type(found[0]) is type(expected)


@pytest.mark.usefixtures("either_parser")
def test_positions_are_those_of_an_editor() -> None:
    text = "a: 1\nb:\n  c: [x, {d: 2}]\n  é: ü\n"
    assert place(text, "a") == (1, 4, 1, 1)
    assert place(text, "b") == (3, 3, 2, 1)
    assert place(text, "b", "c") == (3, 6, 3, 3)
    assert place(text, "b", "c", 1) == (3, 10, 3, 10)
    assert place(text, "b", "c", 1, "d") == (3, 14, 3, 11)
    assert place(text, "b", "é") == (4, 6, 4, 3)


@pytest.mark.parametrize("newline", ["\n", "\r\n", "\r"])
@pytest.mark.usefixtures("either_parser")
def test_lines_are_counted_by_any_line_break(newline: str) -> None:
    text = newline.join(["a: 1", "", "b: 2", "c: 3"])
    found = parsed(text)
    assert place(text, "c") == (4, 4, 4, 1)
    assert found.lines["spec.yaml"][3] == "c: 3"


def test_a_byte_order_mark_is_no_column(tmp_path: Path) -> None:
    file = tmp_path / "spec.yaml"
    file.write_bytes(b"\xef\xbb\xbfa: 1\n")
    assert read_document(file).position.children["a"].column == 4


def test_an_alias_stands_where_it_is_used() -> None:
    text = "a: &x {c: 1}\nb: *x\n"
    found = parsed(text)
    assert found.value == {"a": {"c": 1}, "b": {"c": 1}}
    assert place(text, "b") == (2, 4, 2, 1)
    assert place(text, "b", "c") == (1, 11, 1, 8)


def test_steps_that_a_spec_does_not_have_are_passed_over() -> None:
    found, taken = parsed("a: {b: 1}").position.closest(("a", "tag", "b", 0))
    assert taken == ("a", "b")
    assert found.column == 8


def test_mistakes_that_leave_the_text_readable_stay_beside_the_values() -> None:
    found = parsed("a: 1\na: 2\nb:\nc: !tag 3\n? [k]\n: 4\nd: *no\n<<: {e: 5}\nf: 6\n")
    assert found.value == {"a": 1, "b": None, "c": None, "d": None, "f": 6}
    texts = [f.text for f in found.findings]
    for number, text in enumerate(
        ["given twice", "no value", "tag '!tag'", "not a plain name", "alias '*no'", "merge keys"]
    ):
        assert text in texts[number]
    assert [f.line for f in found.findings] == [2, 3, 4, 5, 7, 8]


@pytest.mark.parametrize(
    ("text", "line", "says"),
    [
        ("a: {b: 1\nc: 2\n", 1, "never closed"),
        ("a: [1, 2\nb: 3\n", 1, "never closed"),
        ("a: [1, [2, 3]\n", 1, "never closed"),
        ("a: {b: 1 c: 2}\n", 1, "comma"),
        ("a: 1\nb: 'x\nc: 3\n", 2, "quote"),
        ('a: 1\nb: "\\q"\n', 2, "escape"),
        ("a: 1\n  b: 2\n", 2, "':' has no place"),
        ("a:\n    b: 1\n  c: 2\n", 3, "does not fit"),
        ("a:\n\tb: 1\n", 2, "tab"),
        ("a: 1\nb 2\n", 2, "lacks its ':'"),
        ("a: @x\n", 1, "cannot start"),
        ("- a\nb: 1\n", 2, "does not fit the list"),
        ("a: 1\n--- \nb: 2\n", 2, "second document"),
        ("", 1, "is empty"),
        ("# nothing\n", 1, "is empty"),
        ("---\n...\n---\na: 1\n", 3, "second document"),
        ("a: \x07\n", 1, "U+0007"),
        ("a: 1\nb: \ufeff2\n", 2, "U+FEFF"),
        ("%FOO\n", 1, "is not valid YAML"),
    ],
)
@pytest.mark.usefixtures("either_parser")
def test_what_is_no_yaml_shows_where_it_begins(text: str, line: int, says: str) -> None:
    (finding,) = refused(text)
    if says == "is not valid YAML":
        assert finding.text.startswith(says)
        return
    assert says in finding.text
    assert finding.line == line
    assert finding.hint


@pytest.mark.usefixtures("either_parser")
def test_findings_before_broken_yaml_are_kept() -> None:
    assert [f.line for f in refused("a: 1\na: 2\nb: [1\n")] == [2, 3]


@pytest.mark.parametrize("opening", ["[", "- ", "{a: ", "? ", "? - "])
@pytest.mark.usefixtures("either_parser")
def test_depth_is_bounded(opening: str) -> None:
    assert any("deeper" in f.text for f in refused(opening * 5_000))


def test_depth_counts_what_aliases_unfold() -> None:
    lines = ["a0: &a0 [x]", *(f"a{n}: &a{n} [*a{n - 1}]" for n in range(1, 60))]
    assert any("deeper" in f.text for f in refused("\n".join(lines)))


def test_size_counts_what_aliases_unfold() -> None:
    lines = ["a0: &a0 [" + "x, " * 10 + "]"]
    lines += [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 10)}]" for n in range(1, 9)]
    assert any("more than" in f.text for f in refused("\n".join(lines)))


def test_a_value_cannot_hold_itself() -> None:
    (finding,) = parsed("a: &x [1, *x]").findings
    assert "inside what it names" in finding.text


def test_findings_are_bounded() -> None:
    assert len(refused("a: 1\n" * 5_000)) == document.MAX_FINDINGS + 1


def test_a_finding_cannot_steer_a_terminal() -> None:
    found = parsed('"\\e[31m": "\\u202e"\n')
    finding = finding_at(found.position, found.lines, "\x1b[31m", "\x1b[31m", "\u202e\t")
    assert (finding.path + finding.text + finding.hint).isprintable()
    assert len(finding.text) == 5


def test_a_long_line_is_not_repeated_in_its_findings() -> None:
    found = parsed("a: " + "x" * 10_000)
    assert finding_at(found.position, found.lines, "a", "x").source_line == ""


def test_files_that_cannot_be_read_are_findings(tmp_path: Path) -> None:
    loop = tmp_path / "loop.yaml"
    loop.symlink_to(loop)
    pipe = tmp_path / "pipe.yaml"
    os.mkfifo(pipe)
    large = tmp_path / "large.yaml"
    large.write_bytes(b"#" * (document.MAX_BYTES + 1))
    latin = tmp_path / "latin.yaml"
    latin.write_bytes("a: 1\nb: µ\n".encode("latin-1"))
    for path, says, line in (
        (tmp_path / "none.yaml", "no such file", 0),
        (tmp_path, "is a folder", 0),
        (loop, "leads to no file", 0),
        (pipe, "is a device", 0),
        (large, "too large", 0),
        (latin, "not UTF-8", 2),
        (tmp_path / ("n" * 300 + ".yaml"), "cannot be read", 0),
    ):
        with pytest.raises(SpecError) as raised:
            read_document(path)
        (finding,) = raised.value.findings
        assert says in finding.text
        assert finding.line == line
        assert finding.hint
        assert finding.where.startswith(str(path))


def plain_values() -> st.SearchStrategy[object]:
    leaves = st.none() | st.booleans() | st.integers() | st.floats() | st.text()
    return st.recursive(
        leaves,
        lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
        max_leaves=20,
    )


def findings_in(text: str) -> tuple[Finding, ...]:
    """Return what is found in a text, whether that ends the reading or not."""
    try:
        return parsed(text).findings
    except SpecError as error:
        return tuple(error.findings)


@given(st.text() | st.text(alphabet="{}[]:,-&*!?|>'\"%@`#<~ab1. \n\t", max_size=60))
def test_any_text_is_read_or_refused(text: str) -> None:
    assert all(f.line >= 1 and f.text and f.hint for f in findings_in(text))


@given(
    st.recursive(
        st.booleans() | st.integers(-(10**9), 10**9) | st.floats(allow_nan=False, width=32),
        lambda inner: (
            st.lists(inner, min_size=1, max_size=4)
            | st.dictionaries(st.from_regex(r"[a-d]{1,3}", fullmatch=True), inner, min_size=1)
        ),
        max_leaves=20,
    )
)
def test_plain_values_survive_being_written_and_read(data: object) -> None:
    assert value(yaml.safe_dump(data)) == data


@given(plain_values())
def test_what_yaml_writes_is_read_or_refused(data: object) -> None:
    text = yaml.safe_dump(data, allow_unicode=True)
    assert all(f.line >= 1 and f.text and f.hint for f in findings_in(text))
