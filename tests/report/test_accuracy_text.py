"""What accuracy costs, on screen: from a hand-made result."""

from math import inf

from flexcli.report.accuracy_text import accuracy_tables, told_error
from flexcli.report.curve import curve
from flexcli.report.formats import Page
from flexcli.report.tables import on_page
from flexcli.results.accuracy import AccuracyResult, ModelAccuracy, QuantityAccuracy, Reading


def result(recommended="fine"):
    readings = (
        Reading("coarse", 1.1, 0.1, 1e-5, 0.9e-5, 2e-5, True),
        Reading("fine", 1.0, 0.0, 3e-3, 2e-3, 4e-3, True),
    )
    models = (
        ModelAccuracy("coarse", 0.1, 1e-5, 0.9e-5, 2e-5, True, ()),
        ModelAccuracy("half", inf, inf, inf, inf, False, ("k",)),
        ModelAccuracy("fine", 0.0, 3e-3, 2e-3, 4e-3, True, ()),
    )
    quantity = QuantityAccuracy("k", "stiffness", "N/m", 1.0, 1e-12, readings, recommended)
    return AccuracyResult(0.01, 5, "fine", (quantity,), models, recommended, ())


def shown(found):
    return on_page(accuracy_tables(found), Page(120))


def test_each_row_has_value_error_and_time_with_its_spread():
    row = next(line for line in shown(result()).splitlines() if "coarse" in line)
    assert row.split() == [
        "•", "coarse", "1.1", "N/m", "10", "%", "0.01", "ms", "0.009", "ms", "…", "0.02", "ms"
    ]  # fmt: skip


def test_the_recommended_model_is_marked_and_named():
    text = shown(result())
    assert "•←  fine" in text
    assert "within 1 %, all quantities: fine" in text


def test_no_model_is_said_when_none_does():
    assert "within 1 %, all quantities: no model" in shown(result(recommended=""))


def test_a_model_without_an_answer_names_what_it_lacks():
    row = next(line for line in shown(result()).splitlines() if "half" in line)
    assert row.split() == ["half", "–", "–", "–", "k"]


def test_the_curve_leads_from_the_cheapest_to_the_finest():
    lines = shown(result()).splitlines()
    foot = next(line for line in lines if line.split() == ["1e-05", "0.003", "s"])
    top = next(i for i, line in enumerate(lines) if line.strip() == "error")
    assert lines[top + 1].startswith("   1e-1 ┤")
    assert "1e-12" in lines[lines.index(foot) - 1]


def test_an_error_below_that_of_the_finest_is_not_claimed():
    assert told_error(1e-16, 1e-12) == "≤ 1.0e-12"
    assert told_error(0.0312) == "3.1 %"
    assert told_error(3.2e-7, 1e-12) == "3.2e-07"


def test_the_axes_of_a_curve_carry_their_units():
    text = curve([1e-4, 0.139876], [0.1, 1e-9], linear=False, units=("s", "error"))
    assert text.splitlines()[0].strip() == "error"
    assert text.splitlines()[-1].split() == ["0.0001", "0.1399", "s"]
