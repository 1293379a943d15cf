"""Numbers of many designs at once, for code that is written for one design.

A :class:`Rows` stands where a design has a number: arithmetic is done for all designs together,
and where the code decides by a number, all of them must decide alike. Where they do not,
:class:`Diverged` ends the pass, and :func:`each_alike` begins one for the designs on either side.
So a design takes the very way that it would take alone; what cannot be done for many raises
``TypeError``, never takes one design's number for all.
"""

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextvars import ContextVar
from dataclasses import fields, is_dataclass, replace
from functools import reduce
from typing import Any, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Diverged",
    "Rows",
    "all_of_each",
    "atan2",
    "copysign",
    "cos",
    "design_by_design",
    "each_alike",
    "found_once",
    "hypot",
    "is_of_many",
    "isfinite",
    "larger",
    "largest_of_each",
    "number",
    "of_each",
    "one_alone",
    "one_by_one",
    "over_states",
    "sin",
    "smaller",
    "sqrt",
    "states_of",
    "tan",
]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]
Bools = NDArray[np.bool_]
Number: TypeAlias = float
"""A float, or the :class:`Rows` of many designs, which code uses like a float."""

Answer = TypeVar("Answer")

LENGTH = 131
"""Least number of designs in a pass: fewer are padded by the last one. It exceeds the length of any
list of places, directions or nodes in a formula, so that none is mistaken for designs."""


class Diverged(Exception):
    """A decision differs between designs: ``which`` are those for which it is true (designs,)."""

    def __init__(self, which: Bools) -> None:
        super().__init__("designs take different ways")
        self.which = which


class Rows(NDArray[np.float64]):
    """One number for each of many designs, shape (designs,)."""

    __hash__ = None

    @classmethod
    def of(cls, numbers: Any) -> Any:
        """Return numbers, one for each design."""
        return np.asarray(numbers).view(cls)

    def __bool__(self) -> bool:
        if self.ndim != 1:
            raise TypeError("numbers of designs in an array have no truth")
        which = np.asarray(self) != 0
        first = bool(which[0])
        if bool((which == first).all()):
            return first
        raise Diverged(which)

    def __eq__(self, other: object) -> Any:
        if isinstance(other, np.ndarray) and other.shape != self.shape:
            return False  # of another pass
        return super().__eq__(other)

    def __ne__(self, other: object) -> Any:
        if isinstance(other, np.ndarray) and other.shape != self.shape:
            return True
        return super().__ne__(other)

    def _refuse(self, *_: Any) -> Any:
        raise TypeError("many designs have no single number")

    __float__ = __int__ = __index__ = __complex__ = __iter__ = __len__ = _refuse

    def __format__(self, _: str) -> str:
        return "…"  # of many designs, in words that are told of none

    __str__ = __repr__ = lambda _: "…"

    def __getitem__(self, key: Any) -> Any:
        keys = key if isinstance(key, tuple) else (key,)
        if all(each is None or each is Ellipsis or each == slice(None) for each in keys):
            return np.asarray(self)[key]  # with further axes, of what a formula goes through
        return self._refuse()

    def _itself(self, *_: Any, **how: Any) -> Any:
        """Return the value itself, which is the largest and the sum of a single design."""
        return self if self.ndim == 1 else self._refuse()

    any = all = max = min = sum = mean = item = _itself


def number(value: Any) -> Number:
    """Return a value as a float, or as the numbers of many designs."""
    found: Number = Rows.of(value) if is_of_many(value) else float(value)
    return found


def of_each(values: Floats) -> Number:
    """Return the number of one design, or those of many, from an array (designs,)."""
    return number(values) if len(values) > 1 else float(values[0])


def states_of(values: NDArray[Any]) -> NDArray[Any]:
    """Return an array (states·designs, …) as (states, designs, …); of one design as it is."""
    now = _PASS.get()
    if now is None or len(values) % now.designs:
        return values
    return values.reshape(-1, now.designs, *values.shape[1:])


def all_of_each(truths: Bools) -> Number:
    """Return whether an array (states·designs,) is true in all states of each design."""
    found = states_of(truths).all(axis=0)
    return bool(found) if found.ndim == 0 else number(found)


def largest_of_each(values: Floats) -> Number:
    """Return the largest over states and places of each design, (states, designs, places)."""
    return number(values.max(axis=(0, -1)))


def is_of_many(value: Any) -> bool:
    """Return whether a value has numbers of many designs."""
    return isinstance(value, np.ndarray) and value.ndim > 0


def _of_either(plain: Callable[..., Answer], many: Callable[..., Any]) -> Callable[..., Answer]:
    """Return a function of floats (standard library) or of many designs (NumPy)."""

    def function(*values: Any) -> Answer:
        if any(map(is_of_many, values)):
            found: Answer = Rows.of(many(*values))
            return found
        return plain(*values)

    return function


cos = _of_either(math.cos, np.cos)
sin = _of_either(math.sin, np.sin)
tan = _of_either(math.tan, np.tan)
sqrt = _of_either(math.sqrt, np.sqrt)
copysign = _of_either(math.copysign, np.copysign)
hypot = _of_either(math.hypot, np.hypot)
atan2 = _of_either(math.atan2, np.arctan2)
isfinite = _of_either(math.isfinite, np.isfinite)


def larger(*values: Any) -> Number:
    """Return the largest of numbers, or of the items of a single iterable."""
    return _reduced(max, np.maximum, values)


def smaller(*values: Any) -> Number:
    """Return the smallest of numbers, or of the items of a single iterable."""
    return _reduced(min, np.minimum, values)


def _reduced(plain: Callable[[Any], Any], many: Any, values: tuple[Any, ...]) -> Number:
    each = tuple(values[0]) if len(values) == 1 else values
    found: Number = Rows.of(reduce(many, each)) if any(map(is_of_many, each)) else plain(each)
    return found


class _Pass:
    """A pass over many designs, with the expensive results of it, by name and key."""

    def __init__(self, which: Integers, known: Sequence[tuple[str, Any, Any]]) -> None:
        self.some = _filled_up(which)
        self.distinct, self.designs = len(which), len(self.some)
        self.known = list(known)

    def of_some(self, which: Integers) -> list[tuple[str, Any, Any]]:
        """Return the results of some of the designs."""
        return [_taken(each, which, self.designs) for each in self.known]


_PASS: ContextVar[_Pass | None] = ContextVar("_PASS", default=None)


def found_once(name: str, about: Any, find: Callable[[], Answer]) -> Answer:
    """Return an expensive result: numbers, in tuples, lists and records.

    Where designs decide differently the pass is split, and the later passes take the result of the
    first, by its name and key.
    """
    now = _PASS.get()
    if now is None:
        return find()
    for known, of, answer in now.known:
        if known == name and of == about:
            there: Answer = answer
            return there
    found = find()
    now.known.append((name, about, found))
    return found


def one_by_one(find: Callable[..., Any], *numbers: Number) -> Any:
    """Return the result of a function of floats, called once for each distinct set of numbers.

    It gives a float, or a tuple of floats.
    """
    if not any(map(is_of_many, numbers)):
        return find(*numbers)
    table = np.stack(np.broadcast_arrays(*(np.asarray(x, np.float64) for x in numbers)), axis=-1)
    each, place = np.unique(table, axis=0, return_inverse=True)
    found = [find(*row) for row in each.tolist()]
    if isinstance(found[0], tuple):
        kind = type(found[0])
        columns = (Rows.of(np.array(column)[place]) for column in zip(*found, strict=True))
        return kind(*columns) if hasattr(kind, "_fields") else tuple(columns)
    return Rows.of(np.array(found)[place])


def design_by_design(find: Callable[..., Answer], *values: Any, name: str, about: Any) -> Answer:
    """Return the result of a function of single designs, joined to numbers of many designs.

    The result is made of numbers, tuples, records and mappings, alike in all designs but for the
    numbers, and is computed once (:func:`found_once`).
    """
    now = _PASS.get()
    if now is None:
        return find(*values)
    return found_once(name, about, lambda: _each_by_itself(find, values, now))


def _each_by_itself(find: Callable[..., Answer], values: tuple[Any, ...], now: _Pass) -> Answer:
    token = _PASS.set(None)
    try:
        found = [
            find(*(_of_one(value, place, now.designs) for value in values))
            for place in range(now.distinct)
        ]
    finally:
        _PASS.reset(token)
    together: Answer = _of_all(found, now.designs)
    return together


def _of_one(value: Any, place: int, designs: int) -> Any:
    """Return one design's part of a value of many."""
    if isinstance(value, np.ndarray):
        return float(np.asarray(value)[place]) if value.shape == (designs,) else value
    if isinstance(value, tuple):
        each = [_of_one(x, place, designs) for x in value]
        return type(value)(*each) if hasattr(value, "_fields") else tuple(each)
    if isinstance(value, Mapping):
        return {name: _of_one(each, place, designs) for name, each in value.items()}
    if hasattr(value, "model_copy"):
        return _part_of_one(value, place, designs)
    return value


def _part_of_one(part: Any, place: int, designs: int) -> Any:
    """Return one design's part of a pydantic model of many."""
    own = {name: getattr(part, name) for name in type(part).model_fields}
    changed = {name: _of_one(each, place, designs) for name, each in own.items()}
    changed = {name: each for name, each in changed.items() if each is not own[name]}
    if not changed:
        return part
    found = part.model_copy(update=changed)
    for name in found.__dict__.keys() - own.keys():  # cached, of all designs
        del found.__dict__[name]
    return found


def _of_all(found: Sequence[Any], designs: int) -> Any:
    """Return the results of single designs as one value of many designs."""
    first = found[0]
    if any(each is None for each in found):
        none = np.array([each is None for each in found])
        if none.all():
            return None
        raise Diverged(np.pad(none, (0, designs - len(none)), mode="edge"))
    if isinstance(first, tuple):
        columns = [_of_all(column, designs) for column in zip(*found, strict=True)]
        return type(first)(*columns) if hasattr(first, "_fields") else tuple(columns)
    if isinstance(first, Mapping):
        if any(each.keys() != first.keys() for each in found):
            raise TypeError("designs have other things")
        return {name: _of_all([each[name] for each in found], designs) for name in first}
    if isinstance(first, float):
        return Rows.of(np.pad(np.array(found), (0, designs - len(found)), mode="edge"))
    if any(each != first for each in found):
        raise TypeError("designs have other words")
    return first


def one_alone() -> None:
    """Raise ``TypeError`` in a pass over many designs: the code that follows is written for one."""
    if _PASS.get() is not None:
        raise TypeError("is found for one design alone")


def _taken(value: Any, which: Integers, designs: int) -> Any:
    """Return the part of a value that belongs to some of the designs."""
    if isinstance(value, np.ndarray):
        return (
            value.take(which, axis=0) if value.ndim and len(np.asarray(value)) == designs else value
        )
    if isinstance(value, list):
        return [_taken(each, which, designs) for each in value]
    if isinstance(value, tuple):
        each = (_taken(x, which, designs) for x in value)
        return type(value)(*each) if hasattr(value, "_fields") else tuple(each)
    if isinstance(value, Mapping):
        return {name: _taken(each, which, designs) for name, each in value.items()}
    if is_dataclass(value) and not isinstance(value, type):
        parts = {field.name: getattr(value, field.name) for field in fields(value) if field.init}
        return replace(value, **_taken(parts, which, designs))
    return value


def over_states(states: int, *values: Any) -> tuple[int, tuple[Any, ...]]:
    """Return the number of designs, and their values repeated for each state (states·designs, …).

    Values of one design are left as they are.
    """
    now = _PASS.get()
    if now is None:
        return 1, values
    which = np.tile(np.arange(now.designs), states)
    found = tuple(_taken(value, which, now.designs) for value in values)
    return now.designs, found


def each_alike(
    do: Callable[[Integers], Answer], designs: int
) -> Iterator[tuple[Integers, Answer | None]]:
    """Yield the indices of designs that decide alike, and the result of a pass over them.

    ``do`` is given indices, some more than once; the result is None where something cannot be done
    for many. A single design goes through a pass as well, so that its digits do not depend on
    others.
    """
    todo: list[tuple[Integers, list[tuple[str, Any, Any]]]] = [(np.arange(designs), [])]
    while todo:
        which, known = todo.pop()
        now = _Pass(which, known)
        try:
            answer = _passed(do, now)
        except Diverged as ways:
            for side in (ways.which, ~ways.which):
                there = np.flatnonzero(side[: len(which)])
                todo.append((which[there], now.of_some(_filled_up(there))))
        except Exception:  # whatever it is, each design alone tells
            yield which, None
        else:
            yield which, answer


def _passed(do: Callable[[Integers], Answer], now: _Pass) -> Answer:
    """Return the result of a pass, or None where a value is not a finite number."""
    token = _PASS.set(now)
    try:
        with np.errstate(divide="raise", over="raise", invalid="raise"):
            return do(now.some)
    finally:
        _PASS.reset(token)


def _filled_up(which: Integers) -> Integers:
    """Return indices, padded by the last one to the least length of a pass."""
    return np.pad(which, (0, max(0, LENGTH - len(which))), mode="edge")
