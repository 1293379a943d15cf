"""Rows of numbers by their keys, and the programs that are made of them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.program import Row
from flexcli.numerics.black_box import BlackBox
from flexcli.numerics.log_stencil import Field, gradients
from flexcli.numerics.many_starts import spread, starts_among
from flexcli.parts.geometries import Sizes

__all__ = ["NumberSizing", "Term"]

Floats = NDArray[np.float64]

USUAL = (1e-5, 1.0)
"""Sizes [m] among which the search starts where the design gives no bound."""
OPEN_SIDE = 1e4
"""Ratio of the ends of that range where one of them is given and lies outside the usual."""
FAR = 1e3
"""Largest |t| of an ease, in logarithms."""
SAMPLES = 1024
"""Points among which the starts are chosen."""


class Term(NamedTuple):
    """A row of a program: ``sign·f + shift − ease·t`` of the row f that is named."""

    key: str
    sign: float = 1.0
    shift: float = 0.0
    ease: float = 0.0


@dataclass(frozen=True, eq=False)
class NumberSizing:
    """Rows over the free dimensions by their keys, as functions of ln sizes.

    ``rows`` says what limits and bounds stand for; ``keys`` names the values of ``evaluate``:
    these, then those of ``quantities``: what can be least, and the sizes. ``closed`` tells that
    the limits are the closed forms of the design.
    """

    names: tuple[str, ...]
    sizes: Sizes
    constraints: tuple[str, ...]
    targets: tuple[str, ...]
    keys: tuple[str, ...]
    evaluate: Field
    quantities: Field
    low: Floats
    high: Floats
    base: Field | None
    noise: float
    starts: tuple[Mapping[str, float], ...]
    rows: dict[str, Row]
    closed: bool

    def complete(self, x: Mapping[str, Floats | float]) -> Sizes:
        """Return the sizes of a solution, fixed dimensions included."""
        return self.sizes._replace(**x)

    def value(self, goal: Term, x: Mapping[str, Floats]) -> Floats:
        """Return what a goal makes least, at many sizes."""
        first = len(self.rows)
        y = np.array([np.log(x[name]) for name in self.names])
        return np.asarray(np.exp(goal.sign * self.quantities(y)[self.keys.index(goal.key) - first]))

    def corrected_at(self, x: Mapping[str, float]) -> "NumberSizing":
        """Return the rows as the base model with its correction as it is at a point."""
        base = self.base
        if base is None:
            return self
        at = np.log([x[name] for name in self.names])
        off, slopes = gradients(lambda y: self.evaluate(y) - base(y), at)

        def evaluate(y: Floats) -> Floats:
            return base(y) + off[:, None] + slopes @ (y - at[:, None])

        return replace(self, evaluate=evaluate, base=None)

    def limits(self) -> list[Term]:
        """Return the rows that must not exceed zero."""
        return [Term(key) for key in self.constraints]

    def equalities(self) -> list[Term]:
        """Return the rows of the targets."""
        return [Term(key) for key in self.targets]

    def banded(self) -> list[Term]:
        """Return the constraints with each target as the band of its tolerance."""
        found = self.limits()
        for key in self.targets:
            limit = self.rows[key].limit
            assert limit is not None  # a bound on a dimension is no target
            assert limit.tolerance is not None
            width = limit.power * float(np.log1p(limit.tolerance))
            found += [Term(key, 1.0, -width), Term(key, -1.0, -width)]
        return found

    def between(self, bounds: Mapping[str, tuple[float | None, float | None]]) -> list[Term]:
        """Return the rows of further bounds on sizes."""
        found = []
        for name, (low, high) in bounds.items():
            if low is not None:
                found.append(Term(f"size {name}", -1.0, float(np.log(low))))
            if high is not None:
                found.append(Term(f"size {name}", 1.0, -float(np.log(high))))
        return found

    def program(self, goal: Term | None, limits: Sequence[Term], equal: Sequence[Term]) -> BlackBox:
        """Return a program of some rows; without a goal the least t that eases them."""
        terms = [goal or Term(self.keys[0], 0.0, 0.0, -1.0), *limits, *equal]
        picked = [self.keys.index(term.key) for term in terms]
        sign, shift, ease = (np.array([term[k] for term in terms])[:, None] for k in (1, 2, 3))
        names, low, high, n = self.names, self.low, self.high, len(self.names)
        if ease.any():
            names, low, high = (*names, "t"), np.append(low, -FAR), np.append(high, FAR)

        def of(values: Field) -> Field:
            def rows(y: Floats) -> Floats:
                found: Floats = np.where(sign == 0.0, 0.0, sign * values(y[:n])[picked]) + shift
                return found - ease * y[n] if y.shape[0] > n else found

            return rows

        base = of(self.base) if self.base is not None else None
        return BlackBox(names, of(self.evaluate), len(limits), low, high, base, self.noise)

    def starting_points(self, program: BlackBox, count: int) -> list[Floats]:
        """Return the starts that were given, or the best of many points between the bounds."""
        if self.starts:
            return [np.log([start[name] for name in self.names]) for start in self.starts]
        points = self.samples()
        if program.low.size > len(self.names):
            points = np.vstack([points, np.zeros((1, points.shape[1]))])
        return starts_among(points, program.rows(points), program.inequalities, count)

    def samples(self) -> Floats:
        """Return points spread over the bounds, or the starts that were given, in logarithms."""
        if self.starts:
            given = [[start[name] for start in self.starts] for name in self.names]
            return np.asarray(np.log(given))
        ends = np.log([self._range(name) for name in self.names])
        return spread(ends[:, 0], ends[:, 1], SAMPLES)

    def _range(self, name: str) -> tuple[float, float]:
        low, high = (self.rows.get(f"{side} {name}") for side in ("least", "most"))
        if low is not None and high is not None:
            return low.bound, high.bound
        if low is not None:
            return low.bound, max(USUAL[1], low.bound * OPEN_SIDE)
        if high is not None:
            return min(USUAL[0], high.bound / OPEN_SIDE), high.bound
        return USUAL
