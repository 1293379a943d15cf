"""Text to values and positions: bounds, aliases, mistakes beside the values."""

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from yaml_texts import parsed, place, refused, value

from flexcli.errors import Finding, SpecError
from flexcli.spec.document import MAX_FINDINGS


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


def test_an_alias_stands_where_it_is_used() -> None:
    text = "a: &x {c: 1}\nb: *x\n"
    found = parsed(text)
    assert found.value == {"a": {"c": 1}, "b": {"c": 1}}
    assert place(text, "b") == (2, 4, 2, 1)
    assert place(text, "b", "c") == (1, 11, 1, 8)


def test_mistakes_that_leave_the_text_readable_stay_beside_the_values() -> None:
    found = parsed("a: 1\na: 2\nb:\nc: !tag 3\n? [k]\n: 4\nd: *no\n<<: {e: 5}\nf: 6\n")
    assert found.value == {"a": 1, "b": None, "c": None, "d": None, "f": 6}
    texts = [f.text for f in found.findings]
    for number, text in enumerate(
        ["given twice", "no value", "tag '!tag'", "not a plain name", "alias '*no'", "merge keys"]
    ):
        assert text in texts[number]
    assert [f.line for f in found.findings] == [2, 3, 4, 5, 7, 8]


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
    assert len(refused("a: 1\n" * 5_000)) == MAX_FINDINGS + 1


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


@pytest.mark.slow
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
