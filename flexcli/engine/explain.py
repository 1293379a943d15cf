"""The verb explain: the formulas of a part, or one formula, with validity and a worked case."""

from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from difflib import get_close_matches
from math import isinf
from typing import Any, NamedTuple

import numpy as np

from flexcli.errors import Finding, SpecError
from flexcli.formulas import (
    bar_limits,
    blade_mass,
    blade_spring,
    buckling,
    clamped_blade,
    clamped_star,
    clamps,
    contact,
    damage_spectrum,
    fillet,
    force_limit,
    handbook,
    held_at_clamps,
    held_blades,
    hinged_limb,
    hinged_next_order,
    joined_plates,
    joint_buckling,
    miles,
    pi_law,
    pivot_next_order,
    plate_buckling,
    plate_factors,
    plate_flattening,
    plates_under_force,
    pulled_stage,
    sheet_factors,
    shock,
    solid_crossing,
    stage_next_order,
    star_next_order,
    stop_line,
    stop_stiffness,
    stopped_cantilever,
    thick_blades,
    thick_notch,
    thick_plates,
    torsion_bar,
    torsion_shapes,
    unseparated_next_order,
)
from flexcli.formulas.card import Card, Range, Symbol, Table, sheet
from flexcli.parts.geometries import GEOMETRIES
from flexcli.results.explanation import (
    Explanation,
    FieldRow,
    FormulaRow,
    SymbolRow,
    TableRow,
    ValidityRow,
)

__all__ = ["explain", "topics"]

GENERAL: tuple[Card, ...] = (
    *blade_mass.CARDS,
    *blade_spring.CARDS,
    *buckling.CARDS,
    *clamps.CARDS,
    *contact.CARDS,
    *damage_spectrum.CARDS,
    *fillet.CARDS,
    *force_limit.CARDS,
    *handbook.CARDS,
    *held_at_clamps.CARDS,
    *held_blades.CARDS,
    *hinged_limb.CARDS,
    *hinged_next_order.CARDS,
    *joined_plates.CARDS,
    *joint_buckling.CARDS,
    *miles.CARDS,
    *pi_law.CARDS,
    *pivot_next_order.CARDS,
    *plate_buckling.CARDS,
    *plate_factors.CARDS,
    *plates_under_force.CARDS,
    *plate_flattening.CARDS,
    *pulled_stage.CARDS,
    *sheet_factors.CARDS,
    *shock.CARDS,
    *solid_crossing.CARDS,
    *clamped_blade.CARDS,
    *clamped_star.CARDS,
    *bar_limits.CARDS,
    *stage_next_order.CARDS,
    *star_next_order.CARDS,
    *stop_line.CARDS,
    *stop_stiffness.CARDS,
    *stopped_cantilever.CARDS,
    *thick_blades.CARDS,
    *thick_notch.CARDS,
    *thick_plates.CARDS,
    *torsion_bar.OFFSET_CARDS,
    *torsion_shapes.STRIP_CARDS,
    *unseparated_next_order.CARDS,
)
"""Formulas of no geometry of their own, and what comes after the first term of a joint's."""


class Topic(NamedTuple):
    """Something that can be explained: its other names, a sentence, its formulas."""

    also: tuple[str, ...]
    title: str
    cards: tuple[Card, ...]


def _topics() -> dict[str, Topic]:
    found = {}
    for name, kind in GEOMETRIES.by_kind.items():
        title = (kind.__doc__ or "").partition("\n")[0]
        found[name] = Topic(kind.also, title, kind.cards)
    for card in GENERAL:
        found[card.name] = Topic((), sheet(card.function).title, (card,))
    for topic in list(found.values()):
        for card in topic.cards:
            found.setdefault(card.name, Topic((), sheet(card.function).title, (card,)))
    return found


def topics() -> tuple[Explanation, ...]:
    """Return everything that can be explained, in short: name, other names, title, formulas."""
    return tuple(
        Explanation(name, topic.also, topic.title, tuple(_row(card) for card in topic.cards))
        for name, topic in _topics().items()
    )


def explain(
    name: str,
    table: str | None = None,
    fields: tuple[FieldRow, ...] = (),
    others: tuple[str, ...] = (),
) -> Explanation:
    """Return a topic in full, with one of its tables where it is asked for.

    ``fields`` are what a spec knows of the name, ``others`` the names of all that it knows.

    Raises
    ------
    SpecError
        When there is no such topic, or it has no such table.

    """
    found = _topics()
    names = {alias: key for key, topic in found.items() for alias in (key, *topic.also)}
    if name not in names and fields and table is None:
        return Explanation(name, (), fields[0].text, (), fields=fields)
    if name not in names:
        near = get_close_matches(name, dict.fromkeys((*names, *others)), 3)
        hint = f"did you mean {' or '.join(near)}?" if near else "'flexure explain' lists all"
        raise SpecError([Finding(name, "there is nothing of this name to explain", hint)])
    key = names[name]
    topic = found[key]
    rows = tuple(_row(card) for card in topic.cards)
    if table is None:
        return Explanation(key, topic.also, topic.title, rows, fields=fields)
    tables = {name: each for card in topic.cards for name, each in card.tables.items()}
    if table not in tables:
        hint = f"it has {', '.join(tables)}" if tables else "it has none"
        raise SpecError([Finding(key, f"there is no table '{table}'", hint)])
    return Explanation(key, topic.also, topic.title, rows, _table(table, tables[table]))


def _row(card: Card) -> FormulaRow:
    said = sheet(card.function)
    result = card.function(**card.example)
    results = result if isinstance(result, tuple) and len(said.gives) > 1 else (result,)
    return FormulaRow(
        name=card.name,
        title=said.title,
        equation=said.equation,
        symbols=tuple(_symbol(symbol, card.example.get(symbol.name)) for symbol in said.symbols),
        gives=tuple(_symbol(*pair) for pair in zip(said.gives, results, strict=True)),
        validity=tuple(_validity(limits) for limits in card.validity),
        notes=said.notes,
        source=said.source,
        tables=tuple(card.tables),
    )


def _symbol(symbol: Symbol, value: Any) -> SymbolRow:
    spoken: float | str | None
    if value is None or isinstance(value, str):
        spoken = value
    elif is_dataclass(value):
        numbers = {f.name: getattr(value, f.name) for f in fields(value)}
        spoken = ", ".join(f"{name} {float(each):.4g}" for name, each in numbers.items())
    elif np.ndim(value):
        spoken = ", ".join(f"{float(each):.4g}" for each in np.ravel(value))
    else:
        spoken = float(value)
    return SymbolRow(symbol.name, symbol.unit, symbol.meaning, spoken)


def _validity(limits: Range) -> ValidityRow:
    least, most = (None if isinf(end) else end for end in (limits.least, limits.most))
    text = f"{limits.quantity} {limits.spoken}"
    return ValidityRow(limits.quantity, least, most, limits.unit, limits.why, text)


def _table(name: str, table: Table) -> TableRow:
    columns: Mapping[str, tuple[float, ...]] = {
        table.variable: table.values,
        **{
            column: tuple(float(function(x)) for x in table.values)
            for column, (_, function) in table.columns.items()
        },
    }
    units = {table.variable: table.unit, **{c: unit for c, (unit, _) in table.columns.items()}}
    return TableRow(name, columns, units, table.note)
