"""Comparison with solid elements as text: each number by both, with their errors."""

from collections.abc import Iterator
from math import inf, isfinite

from flexcli.report.numbers import error_text
from flexcli.report.tables import Line, Piece, Rows, table
from flexcli.results import ErrorRange, Result
from flexcli.results.verification import Verification, VerifiedNumber
from flexcli.units import show

__all__ = ["section"]

DIGITS = 5

MEASURES = (
    "blades are bricks between rigid bodies; the error of a solid is by how much its coarser mesh "
    "differs, as if its order were one. Stress is the mean over the width of a face, two "
    "thicknesses from a clamp, in whose corner that of a solid has no bound"
)


def section(result: Result) -> Iterator[Piece]:
    """Yield the comparison with solid elements."""
    found = result.verification
    if found is None:
        return
    yield _numbers(found)
    for number in found.numbers:
        if number.why:
            yield Line(f"{number.name}: no number, for {number.why}", hang=2)
    apart = [n.name for n in found.numbers if n.agrees is False]
    if apart:
        yield Line(("apart by more than both errors: ", "bold red"), ", ".join(apart), hang=2)
    yield Line((MEASURES, "dim"), hang=0)


def _numbers(found: Verification) -> Rows:
    elements = " and ".join(str(count) for count in found.meshes)
    program = found.program or "not run"
    title = f"{found.model} model beside solid elements ({program}; {elements} elements)"
    rows = table(title, "", "number", found.model, "solid", "apart", numbers=(2, 3, 4))
    for number in found.numbers:
        rows.add_row(*_cells(number))
    return rows


def _cells(number: VerifiedNumber) -> tuple[str, ...]:
    mark = {True: "✓", False: "✗", None: "?"}[number.agrees]
    solid = model = apart = "–"
    if number.solid is not None and isfinite(number.solid):
        own = "?" if number.solid_error is None else _share(number.solid_error)
        solid = f"{show(number.solid, number.unit, DIGITS)} ± {own}"
    if number.apart is not None:
        apart = f"{number.apart:+.2%}"
    if number.model is not None:
        model = f"{show(number.model, number.unit, DIGITS)} {_range(number.model_error)}"
    name = f"{number.label}, {number.case}" if number.case else number.label
    return mark, name, model, solid, apart


def _range(error: ErrorRange | None) -> str:
    if error is None:
        return "± ?"
    if error.low == -error.high:
        return f"± {_share(error.high)}"
    high = "∞" if error.high == inf else f"+{error.high:.1%}"
    return f"−{abs(error.low):.1%}+{high}".replace("−0.0%", "").replace("++", "+")


def _share(error: float) -> str:
    return error_text(error) or "< 0.05 %"
