"""Meaning of the YAML parser's errors for a designer: place, fault, remedy."""

from typing import Any, NamedTuple

import yaml

__all__ = ["explain"]


class _SyntaxRule(NamedTuple):
    """Words of the parser on why it stopped, ours, and whether the fault is where it began."""

    words: str
    text: str
    hint: str
    unclosed: bool = False


_SYNTAX = (
    _SyntaxRule("flow", "this bracket is never closed", "close it", unclosed=True),
    _SyntaxRule("unknown escape", "an unknown escape in a quoted text", "use single quotes"),
    _SyntaxRule("quoted scalar", "this quote is never closed", "close it", unclosed=True),
    _SyntaxRule("simple key", "this line lacks its ':'", "write 'key: value'", unclosed=True),
    _SyntaxRule("cannot start any token", "a value cannot start like this", "put it in quotes"),
    _SyntaxRule(
        "mapping values are not allowed",
        "a ':' has no place here",
        "align the key with those above, or put a text with ': ' in quotes",
    ),
    _SyntaxRule("block mapping", "does not fit the lines above", "align it with the keys above"),
    _SyntaxRule("block collection", "does not fit the list above", "align it with its dashes"),
)
"""The first rule that fits wins; the words are common to both of PyYAML's parsers."""


def explain(
    error: yaml.MarkedYAMLError, text: str, lines: list[str], bracket: Any
) -> tuple[Any, str, str]:
    """Return the mark of a fault in the syntax, what is wrong and what would be right.

    ``bracket`` is the mark of the innermost bracket still open, if any.
    """
    words = " ".join(filter(None, (error.context, error.problem)))
    mark: Any = error.problem_mark or error.context_mark
    start: Any = error.context_mark or mark
    if bracket and "flow" in words:
        start = bracket
    rule = next((rule for rule in _SYNTAX if rule.words in words), None)
    said, hint = "is not valid YAML here", "check indentation, brackets and quotes"
    if rule:
        said, hint = rule.text, rule.hint
    if rule and rule.unclosed:
        if rule.words == "flow" and start.line == mark.line and mark.index < len(text):
            said, hint = "a comma or a closing bracket is missing here", "add it"
        else:
            mark = start
    row = lines[mark.line]
    if "\t" in row[: len(row) - len(row.lstrip())]:
        said, hint = "a tab in the indentation", "indent with spaces"
    return mark, said, hint
