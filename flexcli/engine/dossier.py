"""The verb report: what a design review reads, gathered from the other verbs."""

import inspect
from collections.abc import Iterator, Sequence
from math import isfinite
from typing import Any

import numpy as np

from flexcli.engine.asd_worst_case import environments, over_frequency
from flexcli.engine.assess import factors
from flexcli.engine.draw import drawing
from flexcli.engine.simulate import strokes
from flexcli.errors import SolveError
from flexcli.formulas.card import Card, sheet
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.scene import largest_travel
from flexcli.results import Result
from flexcli.results.dossier import Dossier, Equation, Region, Spectrum
from flexcli.results.drawing import Drawing
from flexcli.results.explanation import SymbolRow
from flexcli.results.simulation import Sweep

__all__ = ["dossier"]

POINTS = 41
"""Travels over the stroke, and designs along each side of a region."""

POINTS_IN_SPACE = 11
"""Travels over the stroke of a mechanism in space, where each takes longer."""

AROUND = 2.5
"""Factor about the chosen sizes that a region is drawn over."""


def dossier(
    design: DesignSpec, sizes: Sizes, result: Result, text: str, chosen: Sequence[str] = ()
) -> Dossier:
    """Return what is to be read about a design beside the verdicts.

    Parameters
    ----------
    design : DesignSpec
        The design.
    sizes : named tuple
        Its sizes, given or chosen [m].
    result : Result
        What ``check`` or ``size`` said of it.
    text : str
        The spec itself.
    chosen : sequence of str
        Symbols of the sizes that were chosen, of which a region shows the first two.

    """
    not_shown: list[str] = []
    drawn: Drawing | None = None
    whole: Drawing | None = None
    sweeps: tuple[Sweep, ...] = ()
    region: Region | None = None
    try:
        drawn = drawing(design, sizes)
        if design.mechanism is not None and design.mechanism.joints > 1:
            from flexcli.engine.draw_mechanism import mechanism_drawing

            whole = mechanism_drawing(design, sizes)
    except SolveError as reason:
        not_shown.append(f"no drawing: {reason.text}")
    if any(scene.moves for scene in design.scenes()):
        try:
            points = POINTS_IN_SPACE if design.geometry.in_space else POINTS
            sweeps = strokes(design, sizes, points)
        except SolveError as reason:
            not_shown.append(f"no simulation over the stroke: {reason.text}")
    if len(chosen) > 1:
        region = _region(design, sizes, chosen)
    return Dossier(
        result,
        text,
        drawing=drawn,
        mechanism=whole,
        sweeps=sweeps,
        spectra=tuple(_spectra(design, result)),
        equations=tuple(_equations(design, sizes)),
        region=region,
        not_shown=tuple(not_shown),
    )


def _spectra(design: DesignSpec, result: Result) -> Iterator[Spectrum]:
    """Yield each random vibration of the design with Miles' and the exact response."""
    frequencies = [
        value.value for name, value in result.values.items() if name in ("f_0", "f_final", "f_1")
    ]
    for each in environments(design):
        natural, _, by_miles, exact = over_frequency(each)
        f = each.applied.frequency
        yield Spectrum(
            case=each.case,
            profile=each.name,
            q=each.q,
            frequency=tuple(map(float, f)),
            level=tuple(map(float, each.applied.level)),
            log_level=each.applied.scale == "log",
            natural=tuple(natural.tolist()),
            miles=tuple(by_miles.tolist()),
            exact=tuple(exact.tolist()),
            modes=tuple(x for x in frequencies if f[0] <= x <= f[-1]),
        )


def _equations(design: DesignSpec, sizes: Sizes) -> Iterator[Equation]:
    """Yield the formulas of the joint with the design's numbers put in."""
    known = _known(design, sizes)
    for card in design.geometry.cards:
        if (found := _equation(card, known)) is not None:
            yield found


def _known(design: DesignSpec, sizes: Sizes) -> dict[str, Any]:
    """Return what is known of a design by the names that formulas call it."""
    geometry, elastic = design.geometry, design.material.elastic
    travel = largest_travel(design.scenes())
    found: dict[str, Any] = {
        **{name: float(size) for name, size in sizes._asdict().items()},
        "E": elastic.E,
        "theta" if geometry.motion == "rotation" else "x": travel,
    }
    if elastic.nu is not None:
        found["poisson_ratio"] = elastic.nu
    for name in ("p", "half_angle", "blades", "spacing", "crossing", "l_c"):
        value = getattr(geometry, name, None)
        if isinstance(value, int | float):
            found.setdefault(name, value)
    count = getattr(geometry, "blade_count", None)
    if count is not None:
        found["blades"] = count
    offset = getattr(geometry, "offset", None)
    if callable(offset):
        found["p"] = float(offset(sizes))
    return found


def _equation(card: Card, known: dict[str, Any]) -> Equation | None:
    """Return a formula with numbers, or nothing where one of its arguments is not known."""
    arguments = {}
    for name, parameter in inspect.signature(card.function).parameters.items():
        if name in known:
            arguments[name] = known[name]
        elif parameter.default is inspect.Parameter.empty:
            return None
    try:
        found = card.function(**arguments)
    except (ValueError, NotAvailable):  # outside of what the formula takes
        return None
    told = sheet(card.function)
    gives = _numbers(found)
    if gives is None or not all(map(isfinite, gives)):
        return None
    units = [entry.unit for entry in told.gives] + [""] * len(gives)
    names = [entry.name for entry in told.gives] + [""] * len(gives)
    return Equation(
        title=told.title,
        equation=told.equation,
        source=told.source,
        symbols=tuple(
            SymbolRow(s.name, s.unit, s.meaning, arguments[s.name])
            for s in told.symbols
            if s.name in arguments
        ),
        gives=tuple(
            SymbolRow(name, unit, "", value)
            for name, unit, value in zip(names, units, gives, strict=False)
        ),
        validity=tuple(f"{limits.quantity} {limits.spoken}" for limits in card.validity),
    )


def _numbers(found: Any) -> list[float] | None:
    """Return what a formula gives as numbers, where it gives a few."""
    values = list(found.values()) if isinstance(found, dict) else found
    values = list(values) if isinstance(values, tuple | list) else [values]
    try:
        return [float(value) for value in values]
    except (TypeError, ValueError):
        return None


def _region(design: DesignSpec, sizes: Sizes, names: Sequence[str]) -> Region | None:
    """Return the margins by the closed forms over the first two of some sizes."""
    first, second = names[:2]
    chosen = tuple(float(getattr(sizes, name)) for name in (first, second))
    x, y = (np.geomspace(at / AROUND, at * AROUND, POINTS) for at in chosen)
    try:
        found = factors(design, **{first: x[None, :], second: y[:, None]})
    except (NotAvailable, SolveError):
        return None
    shape = (POINTS, POINTS)
    return Region(
        names=(first, second),
        x=tuple(x.tolist()),
        y=tuple(y.tolist()),
        margins={
            name: tuple(map(tuple, np.broadcast_to(margin, shape).tolist()))
            for name, margin in found.items()
        },
        chosen=(chosen[0], chosen[1]),
    )
