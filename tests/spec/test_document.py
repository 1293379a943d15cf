"""Positions and the findings that point at them."""

from yaml_texts import parsed

from flexcli.spec.document import finding_at


def test_steps_that_a_spec_does_not_have_are_passed_over() -> None:
    found, taken = parsed("a: {b: 1}").position.closest(("a", "tag", "b", 0))
    assert taken == ("a", "b")
    assert found.column == 8


def test_a_finding_cannot_steer_a_terminal() -> None:
    found = parsed('"\\e[31m": "\\u202e"\n')
    finding = finding_at(found.position, found.lines, "\x1b[31m", "\x1b[31m", "\u202e\t")
    assert (finding.path + finding.text + finding.hint).isprintable()
    assert len(finding.text) == 5


def test_a_long_line_is_not_repeated_in_its_findings() -> None:
    found = parsed("a: " + "x" * 10_000)
    assert finding_at(found.position, found.lines, "a", "x").source_line == ""
