"""The page of one design, and that of a folder: self-contained HTML, for screen and paper."""

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from hashlib import sha256
from importlib import import_module
from math import isfinite, isnan, log
from typing import Any, NamedTuple

from flexcli import __version__
from flexcli.errors import SolveError
from flexcli.report.drawings.caption import caption
from flexcli.report.drawings.plane import drawing_svg
from flexcli.report.drawings.style import STYLE
from flexcli.report.drawings.views import view_svg
from flexcli.report.margins_text import decisive, worst_first
from flexcli.report.numbers import shown
from flexcli.report.plots.of_dossier import plots
from flexcli.results import Check, Result, Status, Verdict
from flexcli.results.dossier import Dossier, Equation
from flexcli.results.drawing import Drawing
from flexcli.results.explanation import SymbolRow
from flexcli.units import show

__all__ = ["FolderRow", "design_page", "folder_page", "folder_row", "summary"]

WORDS = {
    Verdict.FAIL: ("✕", "FAIL"), Verdict.UNDECIDED: ("?", "UNDECIDED"),
    Verdict.NOT_JUDGED: ("?", "NOT JUDGED"), Verdict.PASS: ("✓", "PASS"),
}  # fmt: skip
"""Glyph and word of each verdict, the worst first; nothing rests on colour."""

STATUS = {
    Status.PASS: "✓", Status.UNDECIDED: "?", Status.FAIL: "✕", Status.INFEASIBLE: "✕",
    Status.ERROR: "!",
}  # fmt: skip

WHOLE, WIDE, NARROW = 840.0, 528.0, 368.0
"""Width of a drawing across the text, beside another, and on phones [px]."""

WIDE_BAR = 1.5
"""Width of a bar from which its value is marked in it, in per cent of the axis."""

AXIS = (0.4, 8.0)
"""Ends of a bar's axis, as factors over the required one."""


@cache
def _environment() -> Any:
    """Return the template environment; every text is escaped unless it is marked as markup."""
    try:
        jinja2 = import_module("jinja2")
    except ImportError as error:
        hint = "pip install 'flexcli[report]'"
        raise SolveError("no-pages", "a page needs the extra 'report'", hint) from error
    return jinja2.Environment(
        loader=jinja2.PackageLoader("flexcli.report"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )


def _markup(text: str) -> Any:
    return import_module("markupsafe").Markup(text)


def design_page(dossier: Dossier, date: str) -> str:
    """Return the page of one design; ``date`` is when it was made."""
    result = dossier.result
    checks = worst_first(result.checks)
    pictures = [
        {"title": p.title, "caption": p.caption, "picture": _markup(_labelled(p.svg, p.title))}
        for p in plots(dossier)
    ]
    title = result.title or result.spec
    context = {
        "result": result,
        "title": title,
        "about": _about(dossier),
        "date": date,
        "version": __version__,
        "glyph": STATUS[result.status],
        "word": result.status.value.upper(),
        "tally": _tally(checks),
        "lead": _lead(result, checks),
        "what_would": [n.text for n in result.warnings if n.code.startswith("needs-")],
        "checks": [_check(check) for check in checks],
        "designs": [],
        "sensitivities": [],
        "plots": pictures,
        "values": list(_values(result)),
        "effects": [
            {
                "name": e.name, "on": "yes" if e.on else "no", "reason": e.reason,
                "estimate": _percent(e.estimate),
            }
            for e in result.effects
        ],
        "equations": [_equation(one) for one in dossier.equations],
        "warnings": result.warnings,
        "text": dossier.text,
        "lines": len(dossier.text.splitlines()),
        "digest": sha256(dossier.text.encode()).hexdigest(),
        "models": result.cost.model if result.cost is not None else "",
        "drawing_style": _markup(STYLE),
    }  # fmt: skip
    shown = ((dossier.mechanism, WHOLE), (dossier.drawing, WIDE))
    context["drawings"] = [
        _pictured(drawn, title, width) for drawn, width in shown if drawn is not None
    ]
    if dossier.drawing is not None:
        context["isometric"] = _markup(
            _inline(view_svg(dossier.drawing, title, "isometric", stress=True))
        )
    if result.sizing is not None:
        context |= _sizing(result)
    sections = {
        "mechanism": "Mechanism", "margins": "Margins", "design": "Design",
        "sensitivities": "1 % more", "plots": "Plots", "values": "Values", "effects": "Effects",
        "equations": "Equations", "warnings": "Warnings", "input": "Input",
        "provenance": "Provenance",
    }  # fmt: skip
    there = {"mechanism": "drawings", "margins": "checks", "design": "designs"}
    context["sections"] = [
        (key, name)
        for key, name in sections.items()
        if context.get(there.get(key, key), True) not in (None, [], ())
    ]
    return str(_environment().get_template("design.html.j2").render(context))


def _pictured(drawn: Drawing, title: str, width: float) -> dict[str, Any]:
    """Return a drawing for wide and for narrow pages, of which a page shows one."""
    wide, narrow = (
        _markup(_inline(drawing_svg(drawn, title, stress=True, width=each)))
        for each in (width, NARROW)
    )
    return {"wide": wide, "narrow": narrow, "caption": caption(drawn)}


def summary(found: Result | Dossier) -> str:
    """Return the output for a notebook: verdict, drawing where there is one, margins or values."""
    result = found.result if isinstance(found, Dossier) else found
    drawn = found.drawing if isinstance(found, Dossier) else None
    title = result.title or result.spec
    checks = worst_first(result.checks)
    context = {
        "result": result,
        "title": title,
        "glyph": STATUS[result.status],
        "word": result.status.value.upper(),
        "lead": _lead(result, checks) if checks or result.sizing else "",
        "drawing": None if drawn is None else _markup(drawing_svg(drawn, title)),
        "checks": [_check(check) for check in checks],
        "values": [] if checks else list(_values(result)),
    }
    return str(_environment().get_template("summary.html.j2").render(context))


class FolderRow(NamedTuple):
    """A design in the page of a folder: where its own page is, and the check that decides."""

    spec: str
    page: str
    title: str
    status: str
    glyph: str
    word: str
    check: str
    factor: str
    required: str


def folder_row(result: Result, page: str) -> FolderRow:
    """Return the row of a design whose own page is at a path."""
    worst = decisive(result.checks)
    named = worst is not None
    return FolderRow(
        spec=result.spec,
        page=page,
        title=result.title or result.spec,
        status=result.status.value,
        glyph=STATUS[result.status],
        word=result.status.value.upper(),
        check=worst.full_name if worst is not None else "; ".join(f.text for f in result.findings),
        factor=_number(worst.factor) if named and worst is not None else "",
        required=_number(worst.required) if named and worst is not None else "",
    )


def folder_page(title: str, rows: Sequence[FolderRow], date: str) -> str:
    """Return the page that leads to those of the designs, the worst first."""
    order = [status.value for status in reversed(Status)]
    counts = {s: sum(row.status == s for row in rows) for s in order}
    tally = ", ".join(f"{n} {status}" for status, n in counts.items() if n) or "no design"
    worst = next((s for s in order if counts[s]), Status.PASS.value)
    context = {
        "title": title,
        "rows": sorted(rows, key=lambda row: order.index(row.status)),
        "tally": tally,
        "worst": worst,
        "word": worst.upper(),
        "date": date,
        "drawing_style": "",
    }
    return str(_environment().get_template("folder.html.j2").render(context))


def _inline(svg: str) -> str:
    """Return a drawing without the style that the page has already."""
    return re.sub(r"<style>.*?</style>", "", svg, flags=re.DOTALL)


def _labelled(svg: str, title: str) -> str:
    """Return a plot with a label for screen readers."""
    name = str(import_module("markupsafe").escape(title))
    return svg.replace("<svg ", f'<svg role="img" aria-label="{name}" ', 1)


def _about(dossier: Dossier) -> str:
    drawn = dossier.drawing
    said = [] if drawn is None else [drawn.kind.replace("-", " ")]
    if drawn is not None:
        said += [f"{name} {show(size, 'm')}" for name, size in drawn.sizes[:6]]
    return ", ".join([*said, *dossier.not_shown])


def _tally(checks: Sequence[Check]) -> str:
    counts = {v: sum(check.verdict is v for check in checks) for v in WORDS}
    return ", ".join(f"{n} {verdict.value}" for verdict, n in counts.items() if n)


def _lead(result: Result, checks: Sequence[Check]) -> str:
    """Return the sentence at the head of the page."""
    if result.status is Status.INFEASIBLE and result.sizing is not None:
        names = ", ".join(row.text or row.name for row in result.sizing.conflict)
        return (
            f"No sizes meet every requirement; in conflict: {names}." if names else "No sizes do."
        )
    worst = decisive(checks)
    if worst is None:
        return "Nothing is judged."
    name = worst.full_name[:1].upper() + worst.full_name[1:]
    if isnan(worst.factor):
        return f"{name}: {worst.quantity}."
    reached = f"a factor of {_number(worst.factor)} where {_number(worst.required)} is required"
    if worst.verdict is Verdict.PASS:
        return f"Every requirement holds. The nearest, {worst.full_name}, reaches {reached}."
    return f"{name} reaches {reached}."


def _check(check: Check) -> dict[str, Any]:
    glyph, word = WORDS[check.verdict]
    demand, capacity = (show(x, check.unit) for x in (check.demand, check.capacity))
    against = "" if isnan(check.demand) else f"{demand} against {capacity}; "
    ends = check.factor_range
    return {
        "glyph": glyph,
        "word": word,
        "style": check.verdict.value.replace(" ", "-"),
        "name": check.full_name,
        "factor": "" if isnan(check.factor) else _number(check.factor),
        "required": _number(check.required) if not isnan(check.required) else "",
        "range": "unknown"
        if ends is None and not isnan(check.factor)
        else ""
        if ends is None or ends[0] == ends[1]
        else f"{_number(ends[0])}, {_number(ends[1])}",
        "model": check.model,
        "time": f"{show(check.seconds, 's', 2)}" if check.seconds else "",
        "told": f"{against}{check.quantity}{'; ' if check.source else ''}{check.source}",
        "bar": _markup(_bar(check)),
    }


def _bar(check: Check) -> str:
    """Return the range of a factor over the required one on a logarithmic axis."""
    if isnan(check.factor) or not check.required > 0.0:
        return ""

    def at(share: float) -> float:
        least, most = AXIS
        inside = min(max(share, least), most)
        return 100.0 * log(inside / least) / log(most / least)

    low, high = check.factor_range or AXIS
    low, high = (x / check.required for x in (low, high)) if check.factor_range else AXIS
    start, end = at(low), at(high if isfinite(high) else AXIS[1])
    done = check.verdict in (Verdict.PASS, Verdict.FAIL)
    value = at(check.factor / check.required)
    # a gap in a bar that is hardly wider would leave nothing of it
    gap = f'<line class="gap" x1="{value:.2f}%" x2="{value:.2f}%" y1="8" y2="18"/>'
    gap = gap if end - start > WIDE_BAR else ""
    ticks = "".join(
        f'<line class="tick" x1="{at(x):.2f}%" x2="{at(x):.2f}%" y1="2" y2="24"/>'
        for x in (0.5, 2, 5)
    )
    return (
        f'<svg class="bar" height="26" aria-hidden="true">{ticks}'
        f'<rect class="{"done" if done else "open"}" x="{start:.2f}%" y="8" height="10" '
        f'width="{max(end - start, 0.4):.2f}%"/>'
        f"{gap}"
        f'<line class="req" x1="{at(1.0):.2f}%" x2="{at(1.0):.2f}%" y1="0" y2="26"/></svg>'
    )


def _number(x: float) -> str:
    return f"{x:.4g}".replace("-", "−") if isfinite(x) else "∞"


def _percent(x: float) -> str:
    if not isfinite(x):
        return "unknown"
    return "0" if x == 0.0 else f"{100.0 * x:.2g} %"


def _values(result: Result) -> Iterator[dict[str, str]]:
    for name, value in result.values.items():
        error = value.estimated_error
        yield {
            "label": value.label,
            "name": name,
            "text": shown(value.value, value.unit, error=error).replace("-", "−"),
            "error": "unknown" if error is None else _percent(error),
            "model": value.model,
        }


def _sizing(result: Result) -> Mapping[str, Any]:
    sizing = result.sizing
    assert sizing is not None  # the caller's
    names = list(dict.fromkeys(name for design in sizing.designs for name in design.sizes))
    units = {name: result.values[name].unit if name in result.values else "m" for name in names}
    driven = list(dict.fromkeys(name for row in sizing.sensitivities for name in row.on))
    return {
        "designs": [
            {
                "label": design.label,
                "sizes": [
                    show(design.sizes[name], unit) if name in design.sizes else ""
                    for name, unit in units.items()
                ],
                "volume": show(design.volume, "m^3"),
            }
            for design in sizing.designs
        ],
        "size_names": names,
        "objective": sizing.objective,
        "certificate": sizing.certificate,
        "active": ", ".join(sizing.active),
        "sensitivity_names": driven,
        "sensitivities": [
            {
                "name": f"{row.driver}, {row.constraint}" if row.driver else row.constraint,
                "on": [
                    f"{row.on[n]:+.2f} %".replace("-", "−") if n in row.on else "" for n in driven
                ],
            }
            for row in sizing.sensitivities
        ],
    }


def _equation(one: Equation) -> dict[str, str]:
    return {
        "title": one.title,
        "equation": one.equation,
        "source": one.source,
        "numbers": ", ".join(map(_told, one.symbols)),
        "gives": ", ".join(map(_told, one.gives)),
        "validity": ", ".join(one.validity),
    }


def _told(symbol: SymbolRow) -> str:
    value = symbol.value
    unit = symbol.unit.replace("·", "*").replace("²", "^2").replace("³", "^3")
    text = show(float(value), unit) if isinstance(value, int | float) else str(value)
    return f"{symbol.name} = {text}".replace("-", "−") if symbol.name else text
