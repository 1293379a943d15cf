"""What is no YAML: where it begins, and what is said of it."""

import pytest
from yaml_texts import refused


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
