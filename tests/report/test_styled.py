"""Styled text: as wide as a terminal shows it, broken where it may be, coloured where asked."""

import pytest

from flexcli.report.formats import Page
from flexcli.report.styled import Text, cell_len
from flexcli.report.tables import Line, on_page, table


@pytest.mark.parametrize(
    ("text", "cells"),
    [("flexure", 7), ("µm²", 3), ("板ばね", 6), ("e\N{COMBINING ACUTE ACCENT}", 1)],
)
def test_a_text_is_as_wide_as_a_terminal_shows_it(text, cells):
    assert cell_len(text) == cells


@pytest.mark.parametrize("width", range(1, 30))
def test_no_line_is_wider_than_asked_and_no_character_is_lost(width):
    text = Text(("a blade, ", "bold"), ("板ばねの  supercalifragilistic", ""), (" end", "dim"))
    lines = text.broken(width)
    assert all(cell_len(line.plain) <= max(width, 2) for line in lines)
    assert "".join(line.plain for line in lines).replace(" ", "") == text.plain.replace(" ", "")
    for line in lines:
        assert line.plain == "".join(run for run, _ in line.runs)


def test_words_stay_whole_where_they_fit():
    lines = [line.plain for line in Text(("one two three four", "")).broken(9)]
    assert lines == ["one two", "three", "four"]


def test_styles_stay_with_their_words_and_are_codes_on_a_coloured_page_alone():
    line = Line(("FAIL", "bold red"), " of it")
    assert on_page([line], Page(6)) == "FAIL\nof it\n"
    assert on_page([line], Page(6, is_coloured=True)) == "\x1b[1;31mFAIL\x1b[0m\nof it\n"


def test_heads_of_fewer_lines_stand_upon_the_rows():
    rows = table("", "name", "a long head of words", "why")
    rows.add_row("one", "yes", "it is so, and longer than fits beside it")
    first, second, third, _ = on_page([rows], Page(40)).splitlines()
    assert first.split() == ["a", "long", "head"]
    assert second.split() == ["name", "of", "words", "why"]
    assert third.startswith("one   yes           it is so")
