"""Profiles and worst cases as text: lists, a sheet with its curve, tables over Q."""

from collections.abc import Iterator, Sequence
from math import isinf

from flexcli.report.curve import curve
from flexcli.report.tables import Drawing, Line, Piece, Rows, table
from flexcli.results import Result
from flexcli.results.vibration import BreakpointRow, ProfileRow, WorstCaseRow
from flexcli.units import STANDARD_GRAVITY, show

__all__ = ["profile_list", "profile_sheet", "section", "worst_cases"]

_AXES = {"log-log": "straight on log-log axes", "linear": "straight on linear axes"}


def _g(value: float | None) -> str:
    return "" if value is None else f"{value / STANDARD_GRAVITY:.4g} g"


def section(result: Result) -> Iterator[Piece]:
    """Yield the sheet of one profile, or the list of several, and the worst cases."""
    if result.breakpoints:
        yield from profile_sheet(result.profiles[0], result.breakpoints)
    elif result.profiles:
        yield profile_list(result.profiles)
    if result.worst_cases:
        yield from worst_cases(result.worst_cases)


def profile_list(rows: Sequence[ProfileRow]) -> Rows:
    """Return one line per profile: rms as computed and as published, status, standard."""
    listed = table("", "name", "rms", "published", "status", "standard", numbers=[1, 2])
    for row in rows:
        standard = " ".join(filter(None, (row.standard, row.revision)))
        listed.add_row(row.name, _g(row.g_rms), _g(row.published_grms), row.status, standard)
    return listed


def profile_sheet(row: ProfileRow, breakpoints: Sequence[BreakpointRow]) -> Iterator[Piece]:
    """Yield breakpoints with slopes, the curve, and where the numbers come from."""
    points = table("Breakpoints", "frequency", "level", "slope to the next", numbers=[0, 1, 2])
    for point in breakpoints:
        level = f"{point.level / STANDARD_GRAVITY**2:.4g} g²/Hz"
        points.add_row(f"{point.frequency:.6g} Hz", level, _slope(point.slope))
    facts = table("Source", "", "")
    facts.show_header = False
    above, below = row.tolerance_above, row.tolerance_below
    for what, text in {
        "standard": " ".join(filter(None, (row.standard, row.revision))),
        "place": row.location,
        "status": row.status,
        "published rms": _g(row.published_grms),
        "lines": _AXES[row.interpolation],
        "duration": "" if row.duration is None else show(row.duration, "s"),
        "axis": row.axis,
        "tolerance": "" if above is None or below is None else f"+{above:g} −{below:g} dB",
        "note": row.note,
    }.items():
        if text:
            facts.add_row(what, text)
    drawn = curve(
        [point.frequency for point in breakpoints],
        [point.level / STANDARD_GRAVITY**2 for point in breakpoints],
        linear=row.interpolation == "linear",
    )
    yield from (points, Drawing(drawn), facts)


def _slope(slope: float | None) -> str:
    if slope is None:
        return ""
    return "step" if isinf(slope) else f"{slope:+z.2f} dB/oct"


def worst_cases(rows: Sequence[WorstCaseRow]) -> Iterator[Piece]:
    """Yield Miles beside the exact response, and the peaks, over cases and Q.

    Of a single row, whose values stand alone, only what was applied to the profile.
    """
    applied = dict.fromkeys(
        f"{', '.join(filter(None, (row.case, row.profile)))}: {row.applied}" for row in rows
    )
    if len(rows) > 1:
        yield from (_miles(rows), _exact(rows), _peaks(rows))
    yield from (Line((told, "dim")) for told in applied)


def _miles(rows: Sequence[WorstCaseRow]) -> Rows:
    miles = table(
        "Miles over all frequencies", "case", "Q", "worst at", "Miles", "exact there",
        "Miles over it", numbers=range(1, 6),
    )  # fmt: skip
    for row in rows:
        miles.add_row(
            row.case, f"{row.q:g}", f"{row.f_worst:.5g} Hz", _g(row.g_rms_worst),
            _g(row.g_rms_exact), f"{row.miles_excess_there:+z.1%}",
        )  # fmt: skip
    return miles


def _exact(rows: Sequence[WorstCaseRow]) -> Rows:
    exact = table(
        "Exact response", "case", "Q", "greatest", "at", "Miles over it",
        "in the band below by", "at", numbers=range(1, 7),
    )  # fmt: skip
    for row in rows:
        below = "" if row.f_shortfall is None else f"{row.shortfall:.2%}"
        where = "" if row.f_shortfall is None else f"{row.f_shortfall:.5g} Hz"
        exact.add_row(
            row.case, f"{row.q:g}", _g(row.g_rms_max), f"{row.f_max:.5g} Hz",
            f"{row.miles_excess:+z.1%}", below, where,
        )  # fmt: skip
    return exact


def _peaks(rows: Sequence[WorstCaseRow]) -> Rows:
    peaks = table(
        "Peaks", "case", "Q", "duration", "as designed", "√(2 ln f₀T)", "Davenport",
        numbers=range(1, 6),
    )  # fmt: skip
    for row in rows:
        peaks.add_row(
            row.case, f"{row.q:g}", "" if row.duration is None else show(row.duration, "s"),
            _peak(row.c_sigma, row.a_sigma), _peak(row.c_peak, row.a_peak),
            _peak(row.c_davenport, row.a_davenport),
        )  # fmt: skip
    return peaks


def _peak(factor: float | None, acceleration: float | None) -> str:
    return "" if factor is None else f"{factor:.3g}σ = {_g(acceleration)}"
