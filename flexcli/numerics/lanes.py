"""Numbers of eight designs side by side in one register, for code that Numba compiles.

A ``Lanes`` value is added, multiplied and compared lane by lane, so that the digits of a lane hang
on no other. Arrays of them have the lanes as their last axis; ``at`` reads and ``put`` writes one.
Products may be fused with the sum that they go to, nothing is reordered.
"""

import operator
from collections.abc import Callable
from importlib import import_module
from math import factorial, pi, sin
from typing import Any, TypeAlias

__all__ = [
    "LANES",
    "Lanes",
    "any_above",
    "at",
    "larger",
    "put",
    "size_of",
    "splat",
    "versed",
    "where_above",
]

Lanes: TypeAlias = Any
"""Eight numbers in one register."""

LANES = 8
"""Designs in a register: 512 bits, which smaller machines take in two or four."""

ir, cgutils, types, _extending = (
    import_module(name)
    for name in ("llvmlite.ir", "numba.core.cgutils", "numba.core.types", "numba.extending")
)
_Type: Any = types.Type
_PrimitiveModel: Any = _extending.models.PrimitiveModel

_VECTOR = ir.VectorType(ir.DoubleType(), LANES)


class _Lanes(_Type):  # type: ignore[misc]
    """The type of eight numbers in one register."""

    def __init__(self) -> None:
        super().__init__(name="Lanes")


_lanes = _Lanes()


class _Model(_PrimitiveModel):  # type: ignore[misc]
    """The storage of eight numbers as one LLVM vector."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, _VECTOR)


_extending.register_model(_Lanes)(_Model)


def _intrinsic(function: Callable[..., Any]) -> Callable[..., Any]:
    found: Callable[..., Any] = _extending.intrinsic(function)
    return found


def _overloads(symbol: Callable[..., Any]) -> Callable[[Callable[..., Any]], object]:
    found: Callable[[Callable[..., Any]], object] = _extending.overload(symbol, strict=False)
    return found


def _inlined(function: Callable[..., Any]) -> Callable[..., Any]:
    found: Callable[..., Any] = import_module("numba").njit(error_model="numpy")(function)
    return found


def _pointer(context: Any, builder: Any, kind: Any, array: Any, index: Any, index_kind: Any) -> Any:
    """Return a pointer to the first lane of an array's value."""
    view = context.make_array(kind)(context, builder, array)
    steps = (
        [index] if isinstance(index_kind, types.Integer) else cgutils.unpack_tuple(builder, index)
    )
    kinds = [index_kind] if isinstance(index_kind, types.Integer) else list(index_kind)
    steps = [context.cast(builder, s, k, types.intp) for s, k in zip(steps, kinds, strict=True)]
    first = cgutils.get_item_pointer(
        context, builder, kind, view, [*steps, ir.Constant(ir.IntType(64), 0)]
    )
    return builder.bitcast(first, _VECTOR.as_pointer())


@_intrinsic
def at(_typing: Any, array: Any, index: Any) -> Any:
    """Return the lanes of an array at an index."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        place = _pointer(context, builder, signature.args[0], args[0], args[1], signature.args[1])
        return builder.load(place, align=8)

    return _lanes(array, index), code


@_intrinsic
def put(_typing: Any, array: Any, index: Any, value: Any) -> Any:
    """Write lanes to an array at an index."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        place = _pointer(context, builder, signature.args[0], args[0], args[1], signature.args[1])
        builder.store(args[2], place, align=8)
        return context.get_dummy_value()

    return types.void(array, index, value), code


@_intrinsic
def splat(_typing: Any, number: Any) -> Any:
    """Return lanes that all have the same number."""

    def code(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        number = context.cast(builder, args[0], signature.args[0], types.float64)
        one = builder.insert_element(
            ir.Constant(_VECTOR, ir.Undefined), number, ir.Constant(ir.IntType(32), 0)
        )
        mask = ir.Constant(ir.VectorType(ir.IntType(32), LANES), [0] * LANES)
        return builder.shuffle_vector(one, ir.Constant(_VECTOR, ir.Undefined), mask)

    return _lanes(number), code


@_intrinsic
def where_above(_typing: Any, a: Any, b: Any, yes: Any, no: Any) -> Any:
    """Return ``yes`` in the lanes where a is larger than b, elsewhere ``no``."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        return builder.select(builder.fcmp_ordered(">", args[0], args[1]), args[2], args[3])

    return _lanes(a, b, yes, no), code


@_intrinsic
def any_above(_typing: Any, a: Any, b: Any) -> Any:
    """Return whether a is larger than b in any lane."""

    def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
        bits = builder.bitcast(builder.fcmp_ordered(">", *args), ir.IntType(LANES))
        return builder.icmp_unsigned("!=", bits, ir.Constant(ir.IntType(LANES), 0))

    return types.boolean(a, b), code


def _unary(name: str) -> Callable[..., Any]:
    @_intrinsic
    def compute(_typing: Any, a: Any) -> Any:
        def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            kind = ir.FunctionType(_VECTOR, [_VECTOR])
            full = f"llvm.{name}.v{LANES}f64"
            function = cgutils.get_or_insert_function(builder.module, kind, full)
            return builder.call(function, args)

        return _lanes(a), code

    return compute


size_of, _nearest = _unary("fabs"), _unary("rint")


def _binary(symbol: Callable[..., Any], name: str) -> None:
    """Define an operation between lanes, or between lanes and a number."""

    @_intrinsic
    def compute(_typing: Any, a: Any, b: Any) -> Any:
        def code(_context: Any, builder: Any, _signature: Any, args: Any) -> Any:
            return getattr(builder, name)(*args, flags=("contract",))

        return _lanes(a, b), code

    @_overloads(symbol)
    def operate(a: Any, b: Any) -> Any:
        if a is _lanes and b is _lanes:
            return lambda a, b: compute(a, b)  # noqa: PLW0108 (its names must be a and b)
        if a is _lanes and isinstance(b, types.Number):
            return lambda a, b: compute(a, splat(b))
        if b is _lanes and isinstance(a, types.Number):
            return lambda a, b: compute(splat(a), b)
        return None


for _symbol, _name in (
    (operator.add, "fadd"),
    (operator.sub, "fsub"),
    (operator.mul, "fmul"),
    (operator.truediv, "fdiv"),
):
    _binary(_symbol, _name)


_SINE = tuple((-1.0) ** n / factorial(2 * n + 1) for n in range(11, -1, -1))
_COSINE = tuple((-1.0) ** n / factorial(2 * n) for n in range(11, -1, -1))
"""Taylor's coefficients: 12 leave 1e-19 of sine and cosine up to π/2."""

_PI = float.fromhex("0x1.921fb54p+1")
_REST = pi - _PI + sin(pi)
"""π in two parts, of which whole multiples of the first have no rounding."""


@_inlined
def larger(a: Lanes, b: Lanes) -> Lanes:
    """Return the larger of two, lane by lane."""
    return where_above(a, b, a, b)


@_inlined
def versed(angle: Lanes) -> tuple[Lanes, Lanes]:
    """Return 1 − cos and sin of angles, both with all their digits where the angle is small.

    By the half angle less whole half turns, whose signs cancel in ``2 sin²`` and ``2 sin cos``.
    """
    turns = _nearest(angle * (0.5 / pi))
    half = 0.5 * angle - turns * _PI - turns * _REST
    square = half * half
    s, c = splat(0.0), splat(0.0)
    for a in _SINE:
        s = s * square + a
    for a in _COSINE:
        c = c * square + a
    s = s * half
    return 2.0 * s * s, 2.0 * s * c
