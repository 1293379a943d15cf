"""Text, JSON and CSV of a balance, from hand-made results."""

from math import pi

from flexcli.report.as_json import contents
from flexcli.report.balance_csv import transfer_csv
from flexcli.report.balance_text import MOST_ROWS, balance_tables
from flexcli.report.formats import Page
from flexcli.report.tables import on_page
from flexcli.results import Result, Status
from flexcli.results.balance import BalanceResult, GravityRow, StrokeRow, TransferRow, UnknownResult

ROWS = (
    TransferRow(10.0, -1e-6, 0.0, 1e-6j, 0j),
    TransferRow(100.0, None, 0.0),
)


def result(**changes):
    plain = {"outcome": "solved", "motion": "translation", "output_unit": "m", "transfer": ROWS}
    return BalanceResult(**{**plain, **changes})


def told(balance):
    return on_page(balance_tables(balance), Page(120))


def test_the_csv_has_a_row_per_frequency_and_empty_cells_for_no_number():
    heading, first, second = transfer_csv(ROWS).splitlines()
    assert heading.startswith("frequency_Hz,T_init_s2,T_final_s2,")
    assert first == f"10.0,-1e-06,0.0,1e-06,{pi / 2!r},0.0,0.0"
    assert second == "100.0,,0.0,,,,"


def test_json_splits_complex_numbers_into_magnitude_and_phase():
    rows = contents(Result("balance", "spec", Status.PASS, balance=result()))["balance"]["transfer"]
    assert rows[0]["T_init_damped"] == {"magnitude": 1e-6, "phase": pi / 2}
    assert rows[1]["T_init"] is None
    assert rows[1]["T_init_damped"] is None


def test_the_text_says_what_was_chosen_or_why_nothing_could_be():
    arm = UnknownResult("balancing arm", 0.02417161, "m", None, None)
    assert "chosen: balancing arm 24.1716 mm" in told(result(unknowns=(arm,)))
    failed = told(result(outcome="infeasible", reason="too short", remedy="allow more"))
    assert "not balanced: too short" in failed
    assert "remedy: allow more" in failed


def test_an_undamped_resonance_is_shown_as_infinite():
    assert "∞" in told(result(quality=100.0))


def test_a_sweep_is_cut_and_says_so():
    rows = tuple(TransferRow(float(f), 1.0, 1.0) for f in range(1, MOST_ROWS + 4))
    assert "3 more in --csv and JSON" in told(result(transfer=rows))


def test_rounding_beside_large_numbers_is_shown_as_zero():
    rows = (
        StrokeRow("tau_x_init", "kg", 0.08, (0.0, 0.0, 0.0), 0.08),
        StrokeRow("tau_x_final", "kg", 1e-17, (0.0, 1e-21, 0.0), -5e-18),
    )
    last = told(result(over_stroke=rows, stroke=0.02)).splitlines()[-1]
    assert last.split() == ["tau_x_final", "0", "0", "0", "0", "0"]


def test_gravity_of_two_states_names_them():
    rows = tuple(
        GravityRow("x", state, "N*m", 0.01, None, 1e-6, 0.0) for state in ("before", "after")
    )
    text = told(result(gravity=rows))
    assert "x, before balancing" in text
    assert "x, after balancing" in text
