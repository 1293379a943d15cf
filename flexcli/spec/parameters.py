"""Named parameters of a drawing: sums and products of them stand where it has sizes.

``from: [0 mm, gap/2]`` with ``parameters: {gap: 30 mm}`` is ``from: [0 mm, 15 mm]``. An expression
has names, quantities, + − * / and parentheses; its dimension is checked, and nothing is run.
"""

import ast
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from math import isfinite
from typing import Any, NamedTuple

from flexcli.errors import Finding
from flexcli.spec.document import Document, finding_at
from flexcli.spec.findings import nearest, path_text
from flexcli.spec.overrides import Place, with_value
from flexcli.units import DIMENSIONS, MAX_LENGTH, QuantityError, parse_quantity

__all__ = ["DRAWN", "NAMES", "with_parameters"]

KEY = "parameters"

DRAWN = ("layout", "space-layout")
"""Kinds of geometry in which parameters may stand."""

WORDS = frozenset(
    {"kind", "between", "body", "material", "moving", "width", "about", "mirror", "translation"}
)
"""Keys of a drawing that hold names and directions, not sizes."""

NAMES = r"(^|[-+*/(])\s*[A-Za-z_]"
"""Pattern of an expression with a name in it, which a quantity is not."""

_EXPONENTS: dict[str, tuple[int, ...]] = {
    "length": (1, 0, 0, 0), "angle": (0, 0, 0, 1), "mass": (0, 1, 0, 0), "ratio": (0, 0, 0, 0),
    "inertia": (2, 1, 0, 0), "density": (-3, 1, 0, 0), "stiffness": (0, 1, -2, 0),
    "rotational stiffness": (2, 1, -2, -1),
}  # fmt: skip
"""What sizes of a drawing measure, as powers of m, kg, s and rad."""

_QUANTITY = re.compile(
    r"(?<![\w.])((?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)(?:\s*([A-Za-zµ°%]+))?", re.ASCII
)
_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)


class _Measure(NamedTuple):
    """A number in SI and the powers of m, kg, s and rad of its unit."""

    value: float
    exponents: tuple[int, ...]


class _ExpressionError(ValueError):
    """What is wrong with an expression, and what would be right."""

    def __init__(self, text: str, hint: str) -> None:
        super().__init__(text)
        self.hint = hint


def with_parameters(document: Document) -> Document:
    """Return a design's document with the sizes that its expressions mean, or with findings."""
    stated = document.value.get(KEY)
    if not isinstance(stated, dict):
        return document
    geometry = document.value.get("geometry")
    if not isinstance(geometry, dict) or geometry.get("kind") not in DRAWN:
        text = "parameters are for a drawn geometry"
        return _with(document, [((KEY,), text, "draw it as a layout, or give sizes themselves")])
    wrong: list[tuple[Place, str, str]] = []
    known: dict[str, _Measure] = {}
    used: set[str] = set()
    for name, value in stated.items():
        try:
            known[name] = _parameter(str(name), value, known, used)
        except _ExpressionError as error:
            wrong.append(((KEY, name), str(error), error.hint))
    value = document.value
    for place, text in _texts(geometry, ("geometry",)):
        names = _names(text)
        if not names or (names.isdisjoint(stated) and _NAME.fullmatch(text.strip())):
            continue  # a quantity, or a word of its own
        if not names.isdisjoint(stated.keys() - known.keys()):
            continue  # what is wrong with the parameter is said already
        try:
            value = with_value(value, place, _written(_evaluated(text, known, used)))
        except _ExpressionError as error:
            wrong.append((place, str(error), error.hint))
    idle = known.keys() - used
    wrong += [((KEY, n), f"nothing uses the parameter '{n}'", "leave it out") for n in idle]
    return _with(replace(document, value=value), sorted(wrong, key=lambda each: str(each[0])))


def _with(document: Document, wrong: list[tuple[Place, str, str]]) -> Document:
    findings: list[Finding] = []
    for place, text, hint in wrong:
        position, path = document.position.closest(place)
        findings.append(finding_at(position, document.lines, path_text(path), text, hint))
    return replace(document, findings=(*document.findings, *findings))


def _texts(value: Any, place: Place) -> Iterator[tuple[Place, str]]:
    """Yield the texts that may be sizes, and where they stand."""
    if isinstance(value, str):
        yield place, value
    elif isinstance(value, dict):
        for key, inner in value.items():
            if key not in WORDS:
                yield from _texts(inner, (*place, key))
    elif isinstance(value, list):
        for index, inner in enumerate(value):
            yield from _texts(inner, (*place, index))


def _names(text: str) -> set[str]:
    """Return the names in an expression, without the units of its quantities."""
    return set(_NAME.findall(_QUANTITY.sub(" ", text)))


def _parameter(name: str, value: Any, known: Mapping[str, _Measure], used: set[str]) -> _Measure:
    if not _NAME.fullmatch(name):
        raise _ExpressionError(
            f"'{name}' is no name for a parameter", "take letters, digits and _, a letter first"
        )
    if isinstance(value, dict) and "free" in value:
        hint = f"give it a value, and vary it: flexure sweep --vary {KEY}.{name}=20mm:60mm:9"
        raise _ExpressionError("a parameter is not chosen by size", hint)
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise _ExpressionError("a parameter is a quantity", "write e.g. 30 mm")
    return _evaluated(str(value), known, used)


def _evaluated(text: str, known: Mapping[str, _Measure], used: set[str]) -> _Measure:
    """Return what an expression means; the names in it are added to those used."""
    if len(text) > MAX_LENGTH:
        raise _ExpressionError("this expression is too long", "name its parts as parameters")
    quantities: list[_Measure] = []

    def take(found: re.Match[str]) -> str:
        quantities.append(_quantity(found[1], found[2] or "", known))
        return f" _{len(quantities) - 1} "

    plain = _QUANTITY.sub(take, text.replace("\N{MINUS SIGN}", "-"))
    try:
        tree = ast.parse(plain.strip(), mode="eval").body
    except SyntaxError:
        raise _ExpressionError(
            f"'{text}' is no sum of products", "write e.g. gap/2 + 3 mm"
        ) from None

    def of(node: ast.expr) -> _Measure:
        match node:
            case ast.Name(id=name) if name[0] == "_" and name[1:].isdecimal():
                return quantities[int(name[1:])]
            case ast.Name(id=name):
                if name not in known:
                    raise _ExpressionError(f"there is no parameter '{name}'", nearest(name, known))
                used.add(name)
                return known[name]
            case ast.UnaryOp(op=ast.USub(), operand=inner):
                return _negative(of(inner))
            case ast.BinOp(left=left, op=operator, right=right) if type(operator) in _OPERATORS:
                return _OPERATORS[type(operator)](of(left), of(right))
        raise _ExpressionError(f"'{text}' is no sum of products", "write e.g. gap/2 + 3 mm")

    found = of(tree)
    if not isfinite(found.value):
        raise _ExpressionError(f"'{text}' is not finite", "check what it divides by")
    return found


def _quantity(number: str, unit: str, known: Mapping[str, _Measure]) -> _Measure:
    if unit in known and not any(unit in DIMENSIONS[name].units for name in _EXPONENTS):
        raise _ExpressionError(f"'{number} {unit}' has no unit", f"write {number}*{unit}")
    everyday = [name for name in _EXPONENTS if unit in DIMENSIONS[name].units]
    for name in everyday or _EXPONENTS:
        try:
            measured = parse_quantity(f"{number} {unit}".strip(), name)
            return _Measure(measured, _EXPONENTS[name])
        except QuantityError:
            continue
    raise _ExpressionError(f"'{unit}' is no unit of a size", "write e.g. 30 mm")


def _negative(a: _Measure) -> _Measure:
    return a._replace(value=-a.value)


def _sum(a: _Measure, b: _Measure) -> _Measure:
    if a.exponents != b.exponents:
        raise _ExpressionError(
            f"{_said(a)} and {_said(b)} do not add up", "add what has the same dimension"
        )
    return a._replace(value=a.value + b.value)


def _product(a: _Measure, b: _Measure) -> _Measure:
    powers = tuple(p + q for p, q in zip(a.exponents, b.exponents, strict=True))
    return _Measure(a.value * b.value, powers)


def _quotient(a: _Measure, b: _Measure) -> _Measure:
    if b.value == 0.0:
        raise _ExpressionError("this divides by zero", "check what it divides by")
    return _product(a, _Measure(1.0 / b.value, tuple(-power for power in b.exponents)))


_OPERATORS: dict[type[ast.operator], Callable[[_Measure, _Measure], _Measure]] = {
    ast.Add: _sum,
    ast.Sub: lambda a, b: _sum(a, _negative(b)),
    ast.Mult: _product,
    ast.Div: _quotient,
}


def _said(measure: _Measure) -> str:
    return next(
        (
            DIMENSIONS[name].named
            for name, powers in _EXPONENTS.items()
            if powers == measure.exponents
        ),
        "what no size measures",
    )


def _written(measure: _Measure) -> str | float:
    """Return a measure as a spec writes it, with every digit."""
    for name, powers in _EXPONENTS.items():
        if powers == measure.exponents:
            unit = DIMENSIONS[name].si
            return f"{measure.value!r} {unit}" if unit else measure.value
    raise _ExpressionError("this measures nothing that a drawing has", "check its dimension")
