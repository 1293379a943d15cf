"""Accuracy against time as text: each quantity by each model, all together, and the curve."""

from collections.abc import Iterator
from math import inf

from flexcli.report.curve import curve
from flexcli.report.tables import Drawing, Line, Piece, Rows, table
from flexcli.results import Result
from flexcli.results.accuracy import AccuracyResult, ModelAccuracy, QuantityAccuracy
from flexcli.units import show

__all__ = ["accuracy_tables", "section", "told_error"]

DIGITS = 8
"""Of values, so that models can be told apart."""

LEAVES_OUT = (
    "errors are against exact plane beams; what those leave out (wide blades that bend as plates, "
    "compliant clamps) is in no column"
)

AGAINST_SHELLS = (
    "errors are against thin shells; what those leave out (the edges of sections in torsion, shear "
    "across the thickness, compliant clamps) is in no column"
)

AGAINST_SOLIDS = (
    "errors are against solid elements between rigid clamps, each known to the difference of two "
    "meshes. 'corrected' is the model that decides, with all that the others leave out; a solid's "
    "stress is that beside the clamp, times what exact beams have more where it is greatest"
)

LEAVES_OUT_IN_TIME = (
    "errors in time are against the event-driven simulation of the same modes; what those leave "
    "out (modes not kept, large rotation) is in no column"
)


def section(result: Result) -> Iterator[Piece]:
    """Yield the comparison of the models on a design."""
    if result.accuracy is not None:
        yield from accuracy_tables(result.accuracy)


def accuracy_tables(found: AccuracyResult) -> Iterator[Piece]:
    """Yield a table for each quantity, one of the whole, the curve and what to take."""
    yield from _series(found, "")
    against = AGAINST_SHELLS if found.is_shell else LEAVES_OUT
    yield Line((AGAINST_SOLIDS if found.is_solid else against, "dim"))
    if found.in_time is not None:
        yield from _series(found.in_time, " in time")
        yield Line((LEAVES_OUT_IN_TIME, "dim"))


def _series(found: AccuracyResult, where: str) -> Iterator[Piece]:
    """Yield the tables of one series of models, its curve and what to take."""
    for quantity in found.quantities:
        yield _quantity(quantity)
    yield _whole(found, where)
    front = sorted((m for m in found.models if m.pareto), key=lambda m: m.seconds)
    if len(front) > 1:
        yield _curve(found, front)
    take = found.recommended or "no model"
    yield Line((f"within {told_error(found.accuracy)}, all quantities{where}: {take}", "bold"))


def told_error(error: float, bound: float = 0.0) -> str:
    """Return a relative error for people: in % while that is short, at least the finest's own."""
    if error == inf:
        return "–"
    if error < bound:
        return f"≤ {bound:.1e}"
    return f"{error * 100.0:.2g} %" if 1e-4 <= error < 10.0 else f"{error:.1e}"


def _seconds(row: ModelAccuracy) -> tuple[str, str]:
    return show(row.seconds, "s", 3), f"{show(row.least, 's', 3)} … {show(row.most, 's', 3)}"


def _quantity(quantity: QuantityAccuracy) -> Rows:
    title = f"{quantity.name}, {quantity.label} (finest known to {quantity.bound:.1e})"
    rows = table(title, "", "model", "value", "error", "time", "spread", numbers=range(2, 6))
    for reading in quantity.readings:
        marks = ("•" if reading.pareto else " ") + ("←" * (reading.model == quantity.recommended))
        rows.add_row(
            marks,
            reading.model,
            show(reading.value, quantity.unit, DIGITS),
            told_error(reading.error, quantity.bound),
            show(reading.seconds, "s", 3),
            f"{show(reading.least, 's', 3)} … {show(reading.most, 's', 3)}",
        )
    return rows


def _whole(found: AccuracyResult, where: str) -> Rows:
    bound = _bound(found)
    marked = "(• Pareto set, ← the cheapest that does)"
    title = f"All quantities{where}, median of {found.runs} runs {marked}"
    rows = table(
        title, "", "model", "largest error", "time", "spread", "no answer", numbers=range(2, 5)
    )
    for model in found.models:
        marks = ("•" if model.pareto else " ") + ("←" * (model.model == found.recommended))
        told = _seconds(model) if not model.missing else ("–", "–")
        error = told_error(model.error, bound)
        rows.add_row(marks, model.model, error, *told, ", ".join(model.missing))
    return rows


def _bound(found: AccuracyResult) -> float:
    return max(quantity.bound for quantity in found.quantities)


def _curve(found: AccuracyResult, front: list[ModelAccuracy]) -> Drawing:
    bound = _bound(found)
    drawn = curve(
        [model.seconds for model in front],
        [max(model.error, bound) for model in front],
        linear=False,
        units=("s", "error"),
    )
    return Drawing(drawn)
