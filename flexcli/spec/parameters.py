"""Named parameters of a drawing: sums and products of them stand where it has sizes.

``from: [0 mm, gap/2]`` with ``parameters: {gap: 30 mm}`` is ``from: [0 mm, 15 mm]``. An expression
has names, quantities, + − * /, parentheses, and sin, cos and tan of an angle; its dimension is
checked, and nothing is run. A parameter may be free between bounds: a sizing chooses it, and the
drawing follows.
"""

import ast
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from keyword import iskeyword
from math import sqrt
from typing import Any, NamedTuple

import numpy as np

from flexcli.errors import Finding
from flexcli.parts.geometries.base import Extent
from flexcli.parts.geometries.redrawn import DRAWING, Follows
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
_FUNCTIONS: dict[str, Callable[[Any], Any]] = {"sin": np.sin, "cos": np.cos, "tan": np.tan}
_CALL = re.compile(rf"\b(?:{'|'.join(_FUNCTIONS)})\s*\(", re.ASCII)


class _Measure(NamedTuple):
    """A number in SI, or those of many designs, and the powers of m, kg, s and rad of its unit."""

    value: Any
    exponents: tuple[int, ...]


class _ExpressionError(ValueError):
    """What is wrong with an expression, and what would be right."""

    def __init__(self, text: str, hint: str) -> None:
        super().__init__(text)
        self.hint = hint


@dataclass(frozen=True, eq=False)
class Expressions(Follows):
    """A drawing whose sizes follow free parameters.

    ``extents`` are the ranges of the free parameters by name, ``dimensions`` what they measure;
    ``written`` is the drawing as the spec has it, ``stated`` all parameters in their order, and
    ``texts`` what stands for sizes, by place in the drawing.
    """

    extents: Mapping[str, Extent]
    dimensions: Mapping[str, str]
    written: Mapping[str, Any]
    stated: Mapping[str, Any]
    texts: tuple[tuple[Place, str], ...]

    def at(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the drawing at values of the free parameters [SI], as a spec writes it."""
        drawn: Any = self.written
        for place, measure in self._measures(values):
            drawn = with_value(drawn, place, _written(measure))
        return dict(drawn)

    def numbers(self, values: Mapping[str, Any]) -> Iterator[tuple[Place, Any]]:
        """Yield the numbers [SI] of one or of many designs, and where they stand."""
        yield from ((place, measure.value) for place, measure in self._measures(values))

    def _measures(self, values: Mapping[str, Any]) -> Iterator[tuple[Place, _Measure]]:
        known: dict[str, _Measure] = {}
        for name, value in self.stated.items():
            if name in self.extents:
                known[name] = _Measure(values[name], _EXPONENTS[self.dimensions[name]])
            else:
                known[name] = _evaluated(str(value), known, set())
        for place, text in self.texts:
            yield place, _evaluated(text, known, set())


def with_parameters(document: Document) -> tuple[Document, dict[str, Any]]:
    """Return a design's document with the sizes that its expressions mean, or with findings.

    Beside it, what it validates: the same, save that a drawing with free parameters knows how it
    follows them. In the document these stand in the middle of their ranges.
    """
    stated = document.value.get(KEY)
    if not isinstance(stated, dict):
        return document, document.value
    geometry = document.value.get("geometry")
    if not isinstance(geometry, dict) or geometry.get("kind") not in DRAWN:
        text = "parameters are for a drawn geometry"
        hint = "draw it as a layout, or give sizes themselves"
        return _with(document, [((KEY,), text, hint)]), document.value
    wrong: list[tuple[Place, str, str]] = []
    known: dict[str, _Measure] = {}
    extents: dict[str, Extent] = {}
    dimensions: dict[str, str] = {}
    used: set[str] = set()
    for name, value in stated.items():
        try:
            if isinstance(value, dict):
                known[name], extents[name], dimensions[name] = _free(str(name), value)
            else:
                known[name] = _parameter(str(name), value, known, used)
        except _ExpressionError as error:
            wrong.append(((KEY, name), str(error), error.hint))
    value = document.value
    texts: list[tuple[Place, str]] = []
    for place, text in _texts(geometry, ()):
        names = _names(text)
        if not names or (names.isdisjoint(stated) and _NAME.fullmatch(text.strip())):
            continue  # a quantity, or a word of its own
        if _is_quantity(text):
            continue  # of a unit with several names, as kg/m^3
        if not names.isdisjoint(stated.keys() - known.keys()):
            continue  # what is wrong with the parameter is said already
        try:
            meant = _written(_evaluated(text, known, used))
            value = with_value(value, ("geometry", *place), meant)
            texts.append((place, text))
        except _ExpressionError as error:
            wrong.append((("geometry", *place), str(error), error.hint))
    idle = known.keys() - used
    wrong += [((KEY, n), f"nothing uses the parameter '{n}'", "leave it out") for n in idle]
    found = _with(document._replace(value=value), sorted(wrong, key=lambda each: str(each[0])))
    if not extents or wrong:
        return found, value
    drawing = Expressions(extents, dimensions, geometry, stated, tuple(texts))
    return found, {**value, "geometry": {**value["geometry"], DRAWING: drawing}}


def _with(document: Document, wrong: list[tuple[Place, str, str]]) -> Document:
    findings: list[Finding] = []
    for place, text, hint in wrong:
        position, path = document.position.closest(place)
        findings.append(finding_at(position, document.lines, path_text(path), text, hint))
    return document._replace(findings=(*document.findings, *findings))


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
    """Return the names in an expression, without units of quantities and names of functions."""
    return set(_NAME.findall(_CALL.sub("(", _QUANTITY.sub(" ", text))))


def _is_quantity(text: str) -> bool:
    for dimension in _EXPONENTS:
        with suppress(QuantityError):
            parse_quantity(text, dimension)
            return True
    return False


def _parameter(name: str, value: Any, known: Mapping[str, _Measure], used: set[str]) -> _Measure:
    _refuse_name(name)
    if isinstance(value, bool) or not isinstance(value, str | int | float):
        raise _ExpressionError("a parameter is a quantity", "write e.g. 30 mm")
    return _evaluated(str(value), known, used)


def _refuse_name(name: str) -> None:
    if not _NAME.fullmatch(name) or name in _FUNCTIONS:
        raise _ExpressionError(
            f"'{name}' is no name for a parameter", "take letters, digits and _, a letter first"
        )


def _free(name: str, value: dict[str, Any]) -> tuple[_Measure, Extent, str]:
    """Return the middle of a free parameter's range, the range, and what it measures."""
    _refuse_name(name)
    if name.startswith("_") or iskeyword(name):
        raise _ExpressionError(f"'{name}' is no name for what is chosen", "take another name")
    ends = value.get("free")
    if set(value) != {"free"} or not isinstance(ends, list) or len(ends) != 2:
        raise _ExpressionError(
            "a parameter is a quantity, or free between two", "write {free: [20 mm, 60 mm]}"
        )
    least, most = (_evaluated(str(end), {}, set()) for end in ends)
    if least.exponents != most.exponents:
        raise _ExpressionError(
            f"{_said(least)} and {_said(most)} are no range", "give both ends in one unit"
        )
    if not 0.0 < least.value < most.value:
        hint = "write [least, most]; of what may be either way, e.g. from: [0 mm, gap - 10 mm]"
        raise _ExpressionError("a free parameter is between two sizes above zero", hint)
    extent = Extent.model_construct(fixed=None, least=least.value, most=most.value)
    dimension = next(d for d, powers in _EXPONENTS.items() if powers == least.exponents)
    return _Measure(sqrt(least.value * most.value), least.exponents), extent, dimension


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
            case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in _FUNCTIONS:
                return _of_angle(name, of(inner))
            case ast.BinOp(left=left, op=operator, right=right) if type(operator) in _OPERATORS:
                return _OPERATORS[type(operator)](of(left), of(right))
        raise _ExpressionError(f"'{text}' is no sum of products", "write e.g. gap/2 + 3 mm")

    found = of(tree)
    if not np.all(np.isfinite(found.value)):
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


def _of_angle(name: str, a: _Measure) -> _Measure:
    if a.exponents != _EXPONENTS["angle"]:
        raise _ExpressionError(f"{name} is of an angle", f"write e.g. {name}(30 deg)")
    return _Measure(_FUNCTIONS[name](a.value), _EXPONENTS["ratio"])


def _quotient(a: _Measure, b: _Measure) -> _Measure:
    if np.any(b.value == 0.0):
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
            unit, value = DIMENSIONS[name].si, float(measure.value)
            return f"{value!r} {unit}" if unit else value
    raise _ExpressionError("this measures nothing that a drawing has", "check its dimension")
