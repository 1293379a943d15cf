"""The terminal's curve: its ends, its corners, and nothing outside."""

from flexcli.report.curve import curve


def rows(text):
    return [line.partition("┤")[2] for line in text.splitlines() if "┤" in line]


def inked(row):
    return [index for index, dots in enumerate(row) if dots != "\N{BRAILLE PATTERN BLANK}"]


def test_a_plateau_is_one_row_over_the_whole_width():
    drawn = [row for row in rows(curve([20, 2000], [0.05, 0.05], linear=False)) if inked(row)]
    assert len(drawn) == 1
    assert inked(drawn[0]) == list(range(len(drawn[0])))


def test_a_slope_leads_from_corner_to_corner():
    drawn = rows(curve([20, 2000], [0.01, 1.0], linear=False))
    assert inked(drawn[0])[-1] == len(drawn[0]) - 1
    assert inked(drawn[-1])[0] == 0


def test_a_step_is_a_vertical_line():
    drawn = rows(curve([10, 100, 100, 1000], [0.01, 0.01, 1.0, 1.0], linear=False))
    assert all(inked(row) for row in drawn)


def test_linear_lines_are_curved_on_log_axes():
    ends = [20, 2000], [0.1, 1.0]
    assert curve(*ends, linear=True) != curve(*ends, linear=False)


def test_the_ends_are_labelled():
    text = curve([20, 2000], [0.01, 0.16], linear=False)
    assert text.splitlines()[-1].split() == ["20", "2000", "Hz"]
    assert "1e-2" in text
    assert "1e0" in text
