"""How the margins of a design answer to its numbers: polynomials through designs that were judged.

Judging one part takes milliseconds to a second, a yield takes a hundred thousand of them. So the
models judge some tens of designs over all that the tolerances reach, a polynomial in the
logarithms goes through the logarithm of each limit's margin, and parts drawn at random, which the
polynomial has not seen, tell its error.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache, partial
from math import log
from typing import Any, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.assess import ROUNDING
from flexcli.engine.tolerances.readings import Margin, Plan, Row, reading
from flexcli.engine.tolerances.variations import Variation, as_made
from flexcli.numerics.polynomial_fit import PolynomialFit, polynomial_fit, terms
from flexcli.numerics.rows import Rows, each_alike, is_of_many
from flexcli.parts.design import DesignSpec
from flexcli.results import Verdict
from flexcli.results.activity import doing

__all__ = [
    "Judged",
    "Over",
    "Portable",
    "Recipe",
    "Response",
    "States",
    "Stopped",
    "drawn",
    "of_parts",
    "states",
    "verdicts_of",
]

Floats = NDArray[np.float64]
Bools = NDArray[np.bool_]

Reading: TypeAlias = "dict[Row, Margin]"
Answer = TypeVar("Answer")
Over: TypeAlias = Callable[[Callable[[Floats], Any], Sequence[Floats]], Iterable[Any]]
"""Puts a question to many designs, in order; nothing for those that Ctrl-C left undone."""
Find: TypeAlias = Callable[[Sequence[float]], dict[Any, Answer]]
"""Finds something of a part by its numbers [SI], or of many by those of all."""
Recipe: TypeAlias = tuple[Any, ...]
"""A function of a module that makes a design, and its arguments, which can be told apart."""

MANY = 32
"""Parts that are worth a pass, which goes over four times as many at least."""

PROBE = 8
"""Parts that tell whether parts can go through a question together."""

TASK = 256
"""Parts that do so at once: always the same ones, however many processes there are."""

SAME = 1e-6
"""Difference of a margin's logarithm that is none."""

HELD = 20
"""Parts drawn at random that tell the error of a fit."""

SAFETY = 2.0
"""Times the largest error at those parts that a fit is held to be off by at most."""

BEST = log(1.0 - ROUNDING)
"""Logarithm of the least share that passes."""


class Stopped(KeyboardInterrupt):
    """A run over several processes was interrupted; what was judged by then is kept."""


class Portable:
    """A design with the recipe by which another process makes it: a design cannot be pickled."""

    def __init__(self, design: DesignSpec, recipe: Recipe) -> None:
        self.design, self.recipe = design, recipe

    def __reduce__(self) -> tuple[Any, ...]:
        function, *arguments = self.recipe
        return _made, (function, tuple(arguments))


@lru_cache(maxsize=4)
def _made(function: Callable[..., DesignSpec], arguments: tuple[Any, ...]) -> Portable:
    return Portable(function(*arguments), (function, *arguments))


class Judged:
    """Designs that were judged: random parts first, then points over all that is reached."""

    def __init__(
        self,
        design: Portable,
        each: tuple[Variation, ...],
        plan: Plan,
        parts: Floats,
        over: Over,
        seed: int,
    ) -> None:
        self.design, self.each, self.plan, self.over, self.seed = design, each, plan, over, seed
        self.points, self.held = parts, len(parts)
        self.readings: list[Reading] = []

    def reach(self, degree: int) -> None:
        """Judge the random parts, and as many more designs as a polynomial of a degree needs."""
        from scipy.stats import qmc

        count = len(self.each)
        wanted = int(1.5 * terms(count, degree)) + 2 * count + 1
        shares = qmc.Sobol(d=count, seed=self.seed).random_base2(wanted.bit_length())[:wanted]
        # denser towards the ends, where polynomials through even points go astray
        more = -np.cos(np.pi * shares[len(self.points) - self.held :])
        self.points = np.vstack([self.points, more])
        self._read(self.points[len(self.readings) :], self.plan)

    def ask(self, plan: Plan) -> None:
        """Put questions again whose models have changed."""
        changed = {index: name for index, name in plan.items() if self.plan.get(index) != name}
        self.plan = plan
        old, self.readings = self.readings, []
        self._read(self.points, changed)
        self.readings = [
            {row: margin for row, margin in before.items() if row.question not in changed} | now
            for before, now in zip(old, self.readings, strict=True)
        ]

    def _read(self, points: Floats, plan: Plan) -> None:
        find = partial(_reading, self.design, self.each, plan)
        self.readings.extend(of_parts(self.over, find, self.each, points))


def of_parts(
    over: Over, find: Find[Answer], each: tuple[Variation, ...], points: Floats
) -> Iterator[dict[Any, Answer]]:
    """Yield what is found of each part; raise Stopped where Ctrl-C left the rest undone.

    Parts go through it together, many a task, where some of them can.
    """
    values = np.stack([v.value(u) for v, u in zip(each, points.T, strict=True)], axis=1)
    some = values[:: max(1, len(values) // PROBE)][:PROBE]
    size = TASK if len(values) >= MANY and _found_together(find, some) else 1
    blocks = [values[start : start + size] for start in range(0, len(values), size)]
    number = 0
    for answers in over(partial(_found_by_parts, find), blocks):
        if answers is None:
            raise Stopped
        for one in answers:
            number += 1
            doing(f"design {number} of {len(points)}")
            yield one


def _found_by_parts(find: Find[Answer], values: Floats) -> list[dict[Any, Answer]]:
    """Return what is found of each part, in whatever process."""
    found = _found_together(find, values) if len(values) > 1 else {}
    return [found[i] if i in found else find(row) for i, row in enumerate(values.tolist())]


def _found_together(find: Find[Answer], values: Floats) -> dict[int, dict[Any, Answer]]:
    """Return what is found of parts that go through it together, by their places.

    One of them is found alone, too: where it differs, so are all.
    """
    found: dict[int, dict[Any, Answer]] = {}
    columns = values.T
    passes = each_alike(lambda which: find([Rows.of(x[which]) for x in columns]), len(values))
    for which, answer in passes:
        if answer is not None:
            own = {int(i): _of_one(answer, place) for place, i in enumerate(which)}
            middle = int(which[len(which) // 2])
            if _is_same(own[middle], find(values[middle].tolist())):
                found |= own
    return found


def _of_one(found: Mapping[Any, Any], place: int) -> dict[Any, Any]:
    """Return what a pass found for one of its parts: margins, or verdicts that all have."""

    def of_one(value: Any) -> Any:
        if isinstance(value, Margin):
            return Margin(*map(of_one, value))
        return float(np.asarray(value)[place]) if is_of_many(value) else value

    return {key: of_one(value) for key, value in found.items()}


def _is_same(one: Mapping[Any, Any], other: Mapping[Any, Any]) -> bool:
    """Return whether margins, or verdicts, are the same."""
    return one.keys() == other.keys() and all(
        np.allclose(value, other[key], rtol=0.0, atol=SAME, equal_nan=True)
        if isinstance(value, Margin)
        else value == other[key]
        for key, value in one.items()
    )


def _reading(
    design: Portable, each: tuple[Variation, ...], plan: Plan, values: Sequence[float]
) -> Reading:
    """Return the margins of a part by its numbers [SI], in whatever process."""
    return reading(as_made(design.design, each, values), plan)


def verdicts_of(found: Reading) -> dict[str, Verdict]:
    """Return what the margins of a part say of each check."""
    verdicts = {}
    for check in dict.fromkeys(row.check for row in found):
        margins = [margin for row, margin in found.items() if row.check == check]
        passes = all(margin.low >= BEST for margin in margins)
        fails = any(margin.high < BEST for margin in margins)
        verdicts[check] = Verdict.PASS if passes else Verdict.FAIL if fails else Verdict.UNDECIDED
    return verdicts


class Response(NamedTuple):
    """Ends of the margins of each row as polynomials, and the largest error of the lower ends.

    ``unknown`` are checks that have limits without a known error, or without an answer, in some
    parts: they may fail by their other limits, and pass in no part.
    """

    rows: tuple[Row, ...]
    low: PolynomialFit
    high: PolynomialFit
    error_low: Floats
    unknown: frozenset[str]
    degree: int

    @property
    def checks(self) -> tuple[str, ...]:
        """Return the names of the checks, in their order."""
        return tuple(dict.fromkeys(row.check for row in self.rows))

    def places(self, check: str) -> list[int]:
        """Return the columns of a check's rows."""
        return [k for k, row in enumerate(self.rows) if row.check == check]

    @classmethod
    def of(cls, judged: Judged, degree: int) -> "Response":
        """Return the polynomials through what was judged."""
        readings = [{**found, **_worst_of_each(found)} for found in judged.readings]
        rows = tuple(dict.fromkeys(row for found in readings for row in found))
        missing = Margin(np.nan, np.nan)
        table = np.array([[found.get(row, missing) for row in rows] for found in readings])
        table = table.reshape(len(readings), len(rows), 2)
        whole = np.isfinite(table).all(axis=(0, 2))
        known = [k for k in range(len(rows)) if whole[k]]
        u, held = judged.points, judged.held
        fits, errors = [], []
        for side in (0, 1):
            fit = polynomial_fit(u[held:], table[held:, known, side], degree)
            off = np.abs(fit.at(u[:held]) - table[:held, known, side])
            fits.append(fit)
            errors.append(SAFETY * off.max(axis=0, initial=0.0))
        off_by = dict(zip(known, np.maximum(*errors).tolist(), strict=True))
        taken, unknown = _rows_to_go_by(rows, off_by)
        places = [known.index(k) for k in taken]
        low, high = (PolynomialFit(f.exponents, f.coefficients[:, places]) for f in fits)
        return cls(
            tuple(rows[k] for k in taken), low, high, errors[0][places], unknown, degree
        )  # fmt: skip


def _worst_of_each(found: Reading) -> Reading:
    """Return the worst limit of each check, which is there where they come and go."""
    worst: Reading = {}
    for row, (low, high) in found.items():
        key = Row(row.check, row.question)
        least = worst.get(key, Margin(np.inf, np.inf))
        # what is not a number stays
        worst[key] = Margin(float(np.minimum(least.low, low)), float(np.minimum(least.high, high)))
    return worst


def _rows_to_go_by(
    rows: tuple[Row, ...], off_by: Mapping[int, float]
) -> tuple[list[int], frozenset[str]]:
    """Return the rows to go by and the checks that nothing is known of in some parts.

    A check goes by its limits, or by the worst of them where that has the smaller error.
    """
    taken, unknown = [], set()
    for check in dict.fromkeys(row.check for row in rows):
        own = [k for k, row in enumerate(rows) if row.check == check]
        (worst,) = (k for k in own if not rows[k].place)
        each = [k for k in own if k in off_by and k != worst]
        whole = len(each) == len(own) - 1
        if whole and max(off_by[k] for k in each) <= off_by[worst]:
            taken += each
        elif worst in off_by:
            taken.append(worst)
        else:
            taken += each
            unknown.add(check)
    return taken, frozenset(unknown)


class States(NamedTuple):
    """What is known of parts, (parts, checks): passing by the fit, surely, perhaps; undecided."""

    passed: Bools
    surely: Bools
    perhaps: Bools
    undecided: Bools

    def of(self, check: int) -> "States":
        """Return what is known of one check, (parts, 1)."""
        return States(*(x[:, check : check + 1] for x in self))

    @property
    def together(self) -> "States":
        """Return what is known of all checks of a part, (parts, 1)."""
        passed, surely, perhaps = (
            np.asarray(x.all(axis=1, keepdims=True))
            for x in (self.passed, self.surely, self.perhaps)
        )
        undecided = (self.passed | self.undecided).all(axis=1, keepdims=True) & ~passed
        return States(passed, surely, perhaps, np.asarray(undecided))


def states(response: Response, checks: Sequence[str], u: Floats) -> States:
    """Return what is known of parts; beyond the designs that were judged, nothing."""
    inside = (np.abs(u) <= 1.0 + 1e-9).all(axis=1)
    at = np.clip(u, -1.0, 1.0)
    low, high = response.low.at(at), response.high.at(at)
    shape = (len(u), len(checks))
    found = States(*(np.zeros(shape, dtype=bool) for _ in range(4)))
    for k, check in enumerate(checks):
        columns = response.places(check)
        if check in response.unknown or not columns:
            found.undecided[:, k] = (high[:, columns] >= BEST).all(axis=1)
            continue
        error, least = response.error_low[columns], low[:, columns]
        found.passed[:, k] = (least >= BEST).all(axis=1)
        found.surely[:, k] = (least - error >= BEST).all(axis=1) & inside
        found.perhaps[:, k] = (least + error >= BEST).all(axis=1) | ~inside
        found.undecided[:, k] = (high[:, columns] >= BEST).all(axis=1) & ~found.passed[:, k]
    return found


def drawn(each: Sequence[Variation], shares: Floats) -> Floats:
    """Return parts as scaled variables, from the shares of all parts that lie below each."""
    parts = zip(each, shares.T, strict=True)
    return np.stack([v.scale(v.made(v.spread.ppf(q))) for v, q in parts], axis=1)
