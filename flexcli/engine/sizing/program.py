"""A design as a program over the logarithms of its free dimensions, and its solution.

Where every closed form is a signomial, the rows are exact and the program is a geometric one: its
optimum is proved where all rows are convex in the logarithms. Else the rows are known as numbers,
and local models of them, by value, slope and curvature, are renewed as the sizes move.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from math import exp, log
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.problem import SizingProblem
from flexcli.engine.sizing.rows import ONE, Row, Term, rows_of, size_of
from flexcli.errors import NoSolution
from flexcli.numerics.black_box import BlackBox
from flexcli.numerics.geometric_program import minimize
from flexcli.numerics.infeasibility import APART as FAR_APART
from flexcli.numerics.infeasibility import STARTS as FAR_STARTS
from flexcli.numerics.infeasibility import Conflict, conflict
from flexcli.numerics.log_program import LogProgram
from flexcli.numerics.log_stencil import Field
from flexcli.numerics.log_utilisation import log_utilisation
from flexcli.numerics.many_starts import solve, spread, starts_among
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.numerics.signomial_program import signomial_program
from flexcli.numerics.solution import Solution
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Objective

__all__ = ["BEST", "BEYOND", "STARTS", "SizingProgram", "sizing_program"]

Floats = NDArray[np.float64]

BEST = "best"
"""Unknown that a requirement is pursued by: the share of what it allows that is used, at most."""

WORLD = (1e-10, 1e4)
"""Sizes [m] beyond which a dimension has run away."""
USUAL = (1e-5, 1.0)
"""Sizes [m] among which the search starts where the design gives no bound."""
LIKELY = (1e-4, 1e-1)
"""Sizes [m] between which a first design is looked for where nothing bounds it."""
OPEN_SIDE = 1e4
"""Ratio of the ends of that range where one of them is given and lies outside the usual."""
FAR = 1e3
"""Largest logarithm of an unknown that eases rows."""
SAMPLES = 1024
"""Points among which the starts are chosen."""
STARTS = 5
"""Local runs per optimum of rows known as numbers, from the best of many points."""
BEYOND = 100.0
"""Times beyond the bounds designs are looked for, to tell which of them stand in the way."""
TRIALS, ENOUGH = 500, 8
"""Designs tried for a first one, and those after which the one of most numbers is taken."""


@dataclass(frozen=True, eq=False)
class SizingProgram:
    """The rows of a design by their keys, over the logarithms of its free dimensions.

    ``around`` are sizes and the half-width, in logarithms, of the region about them in which
    alone a design is looked for. ``pursued`` are the constraints of a requirement that is the
    objective itself, none of them where it has no formula yet; nothing where none is.

    ``values`` gives ln(demand/capacity) of the rows at some places at many points, shape
    (n, points) to (rows, points), NaN outside the domain of the formulas. ``exact`` tells that the
    rows are signomials, which ``rows`` then holds.
    """

    names: tuple[str, ...]
    sizes: Sizes
    rows: dict[str, Row]
    constraints: tuple[str, ...]
    targets: tuple[str, ...]
    values: Callable[[Floats, Sequence[int]], Floats]
    exact: bool
    problem: SizingProblem
    around: tuple[Mapping[str, float], float] | None = None
    pursued: tuple[str, ...] | None = None

    @property
    def curved(self) -> tuple[str, ...]:
        """Return the names of the requirements that are not convex in the logarithms."""
        if not self.exact:
            limiting = (*self.constraints, *self.targets)
            return tuple(dict.fromkeys(self.rows[key].name for key in limiting))
        rows = [(key, self._ratio(Term(key))) for key in self.constraints]
        curved = [key for key, row in rows if isinstance(row, Ratio) and not row.is_convex]
        curved += [key for key in self.targets if not self._equality(Term(key)).is_convex]
        return tuple(dict.fromkeys(self.rows[key].name for key in curved))

    def complete(self, x: Mapping[str, Floats | float]) -> Sizes:
        """Return the sizes of a solution, fixed dimensions included."""
        return self.sizes._replace(**{name: x[name] for name in self.names})

    def at(self, keys: Sequence[str], x: Mapping[str, Floats | float]) -> Floats:
        """Return ln(demand/capacity) of some rows at sizes, shape (rows, points)."""
        y = np.log(np.array([np.atleast_1d(x[name]) for name in self.names]))
        return np.asarray(self.picked(keys)(y))

    def picked(self, keys: Sequence[str]) -> Field:
        """Return some rows as functions of the logarithms of the sizes."""
        everything = list(self.rows)
        places = [everything.index(key) for key in keys]
        return lambda y: self.values(y, places)

    def limits(self, goals: Sequence[Term] = ()) -> list[Term]:
        """Return the rows that must not exceed zero, those that goals pursue their best share."""
        found = [Term(key) for key in self.constraints] + self.region()
        if not any(goal.eases for goal in goals):
            return found
        own = self.pursued or ()
        best = [Term(key, eases=((BEST, float(self.rows[key].power)),)) for key in own]
        return [*(each for each in found if each.key not in own), *best, _PURSUED]

    def worth(self, goal: Term, y: Floats) -> Floats:
        """Return what a goal makes least, at logarithms of the sizes (n, points)."""
        if not goal.eases:
            return np.asarray(goal.sign * self.picked([goal.key])(y)[0] + goal.shift)
        own = self.pursued or ()
        power = np.array([self.rows[key].power for key in own], dtype=np.float64)
        rows = self.picked(own)(y)
        return np.asarray((rows / power.reshape(-1, *[1] * (rows.ndim - 1))).max(axis=0))

    def about(self, sizes: Sizes, width: float) -> "SizingProgram":
        """Return the program of a region of so many logarithms either way about sizes."""
        centre = {name: float(getattr(sizes, name)) for name in self.names}
        return replace(self, around=(centre, width))

    def region(self) -> list[Term]:
        """Return the rows that hold the sizes in the region in which a design is looked for."""
        if self.around is None:
            return []
        centre, width = self.around
        return [
            Term(size_of(name), sign, -sign * log(centre[name]) - width)
            for name in self.names
            for sign in (1.0, -1.0)
        ]

    def senses(self, key: str) -> tuple[float, ...]:
        """Return the signs with which a row is kept at most zero: a target's with either."""
        return (1.0, -1.0) if key in self.targets else (1.0,)

    def equalities(self) -> list[Term]:
        """Return the rows of the targets."""
        return [Term(key) for key in self.targets]

    def banded(self, goals: Sequence[Term] = ()) -> list[Term]:
        """Return the constraints with each target as the band of its tolerance."""
        found = self.limits(goals)
        for key in self.targets:
            limit = self.rows[key].limit
            assert limit is not None  # a bound on a dimension is no target
            assert limit.tolerance is not None
            width = limit.power * float(np.log1p(limit.tolerance))
            found += [Term(key, 1.0, -width), Term(key, -1.0, -width)]
        return found

    def objectives(self, objective: Objective) -> list[Term]:
        """Return what becomes least, then what breaks ties: volume, l, b, h."""
        order = {"l": 0, "b": 1, "h": 2}
        sizes = sorted(self.names, key=lambda name: order.get(name, 3))
        goals = [self.goal(objective), Term("volume"), *(Term(size_of(name)) for name in sizes)]
        return list(dict.fromkeys(goals))

    def goal(self, objective: Objective) -> Term:
        """Return the row that an objective makes least, a constant where its size is fixed."""
        named = {"least-volume": "volume", "least-stiffness": "k_pivot", "balanced": "volume",
                 "mass": "volume", "shortest": "l"}  # fmt: skip
        if isinstance(objective, str):
            name, sign = named[objective], 1.0
        else:
            sign = 1.0 if objective.minimize is not None else -1.0
            name = objective.minimize or objective.maximize or ""
            name = named.get(name, name)
        if name in self.names:
            return Term(size_of(name), sign)
        if self.pursued is not None:
            return _PURSUED if self.pursued else Term("volume")
        given = self.sizes._asdict()
        if name in given:
            return Term(ONE, 1.0, sign * log(given[name]))
        if name not in self.rows and name != "k_pivot":
            remedy = f"leave {name} free, or make the volume least"
            raise NoSolution("given", f"{name} is given: nothing makes it less", remedy)
        if name not in self.rows:
            raise NoSolution(
                "no-formula",
                "the stiffness of what is drawn has no formula to be made least or largest by",
                "bound it, e.g. requirements: {stiffness: {max: 2 N/mm}}, and take "
                "objective: {minimize: stiffness}",
            )
        return Term(name, sign)

    def least(
        self,
        goals: Sequence[Term],
        limits: Sequence[Term],
        equal: Sequence[Term] = (),
        near: Mapping[str, float] | None = None,
        *,
        beyond: bool = False,
    ) -> Solution:
        """Make the first goal least subject to rows, ties broken by the next goals.

        ``near`` are sizes to start from, instead of a search for starts: between the bounds, or
        ``beyond`` as well. A program about a place starts there.
        """
        if near is None and self.around is not None:
            near = self.around[0]
        eases = [name for term in (*goals, *limits, *equal) for name, _ in term.eases]
        names = (*self.names, *dict.fromkeys(eases))
        world = [np.full(len(self.names), log(end)) for end in WORLD]
        further = np.full(len(names) - len(self.names), FAR)
        ends = np.append(world[0], -further), np.append(world[1], further)

        def starts(program: LogProgram) -> list[Floats]:
            if near is None:
                return self._starts(program, beyond=beyond)
            return [np.array([log(near[name]) if name in near else 0.0 for name in program.names])]

        if self.exact:
            return self._least_exact(names, ends, goals, limits, equal, starts)
        boxes = [
            BlackBox(names, self._as_used([goal, *limits, *equal], names), len(limits), *ends)
            for goal in goals
        ]
        return solve(
            boxes,
            lambda: starts(boxes[0]),
            [term.key for term in limits],
            [term.key for term in equal],
        )

    def _starts(self, program: LogProgram, *, beyond: bool) -> list[Floats]:
        points = self._samples_beyond() if beyond else self.samples()
        further = np.zeros((program.low.size - len(self.names), points.shape[1]))
        points = np.vstack([points, further])
        if beyond:
            return starts_among(program, points, FAR_STARTS, apart=FAR_APART)
        return starts_among(program, points, STARTS)

    def _samples_beyond(self) -> Floats:
        """Return points between the bounds and beyond them."""
        return np.hstack([self.samples(), self.samples(BEYOND)])

    def disagreement(self, terms: Sequence[Term], owners: Sequence[int]) -> Conflict:
        """Return which of the owners of some rows cannot hold together."""
        points = self._samples_beyond()
        if not self.exact:
            ends = (np.full(len(self.names), log(end)) for end in WORLD)
            rows = self._as_used([Term(ONE), *terms], self.names)
            return conflict(BlackBox(self.names, rows, len(terms), *ends), owners, points)
        rows_of_owners = [(self._ratio(term), own) for term, own in zip(terms, owners, strict=True)]
        for row, owner in rows_of_owners:
            if isinstance(row, Settled) and not row.holds:
                return Conflict((owner,), True, float("inf"))
        ratios = [(row, own) for row, own in rows_of_owners if isinstance(row, Ratio)]
        one = Ratio(ONE, as_signomial(1.0), as_signomial(1.0))
        program = signomial_program(one, [row for row, _ in ratios], [], self.names)
        return conflict(program, [owner for _, owner in ratios], points)

    # -- rows as signomials ------------------------------------------------------------------

    def _least_exact(
        self,
        names: tuple[str, ...],
        ends: tuple[Floats, Floats],
        goals: Sequence[Term],
        limits: Sequence[Term],
        equal: Sequence[Term],
        starts: Callable[[LogProgram], list[Floats]],
    ) -> Solution:
        """Solve a geometric program; a goal with negative terms by its least upper bound."""
        first, *ties = (self._sides(goal) for goal in goals)
        objectives = [_quotient(*sides) for sides in ties if _is_quotient(*sides)]
        rows = [self._ratio(term) for term in limits]
        if _is_quotient(*first):
            objectives = [_quotient(*first), *objectives]
        else:
            (top,) = variables("upper bound")
            rows.append(at_most("objective", first[0], first[1] * top))
            objectives = [_quotient(top, as_signomial(1.0)), *objectives]
            names, ends = (
                (*names, "upper bound"),
                (np.append(ends[0], -FAR), np.append(ends[1], FAR)),
            )
        equalities = [self._equality(term) for term in equal]
        return minimize(objectives, rows, equalities, names, starts, ends)

    def _sides(self, term: Term) -> tuple[Signomial, Signomial]:
        """Return demand and capacity of a term, of which the first is at most the second."""
        row = self.rows[term.key]
        demand, capacity = as_signomial(row.demand), as_signomial(row.capacity)
        if term.sign < 0.0:
            demand, capacity = capacity, demand
        demand = demand * exp(term.shift)
        for name, power in term.eases:
            (unknown,) = variables(name)
            capacity = capacity * unknown**power
        return demand, capacity

    def _ratio(self, term: Term) -> Ratio | Settled:
        return at_most(term.key, *self._sides(term))

    def _equality(self, term: Term) -> Equality:
        demand, capacity = self._sides(term)
        difference = demand - capacity
        return Equality(term.key, difference.positive_part(), difference.negative_part())

    # -- rows as numbers ---------------------------------------------------------------------

    def _as_used(self, terms: Sequence[Term], names: tuple[str, ...]) -> Field:
        """Return rows as the terms use them, over the logarithms of all unknowns."""
        n = len(self.names)
        rows = self.picked([term.key for term in terms])
        sign, shift = (np.array([term[k] for term in terms])[:, None] for k in (1, 2))
        powers = np.array(
            [[dict(term.eases).get(name, 0.0) for name in names[n:]] for term in terms]
        )
        return lambda y: np.asarray(sign * rows(y[:n]) + shift - powers @ y[n:])

    def samples(self, beyond: float = 1.0) -> Floats:
        """Return points spread over the bounds and some times beyond, in logarithms."""
        ends = np.log(np.array([self._range(name) for name in self.names]).reshape(-1, 2))
        return spread(ends[:, 0] - log(beyond), ends[:, 1] + log(beyond), SAMPLES)

    def _range(self, name: str) -> tuple[float, float]:
        low, high = (self.rows.get(f"{side} {name}") for side in ("least", "most"))
        if low is not None and high is not None:
            return low.bound, high.bound
        if low is not None:
            return low.bound, max(USUAL[1], low.bound * OPEN_SIDE)
        if high is not None:
            return min(USUAL[0], high.bound / OPEN_SIDE), high.bound
        return USUAL


def _is_quotient(demand: Signomial, capacity: Signomial) -> bool:
    return demand.is_posynomial and capacity.is_posynomial


def _quotient(demand: Signomial, capacity: Signomial) -> Ratio:
    return Ratio("objective", demand, capacity)


_PURSUED = Term(ONE, eases=((BEST, -1.0),))
"""The best share of a requirement: as a goal made least, as a limit no more than it allows."""


def sizing_program(problem: SizingProblem) -> SizingProgram:
    """Return the program of a design's requirements and bounds.

    Notes
    -----
    Rows known as numbers are smooth in the sizes: where a demand is the largest of several, each
    is a limit of its own.

    """
    design = problem.design
    names, exact = design.geometry.free, bool(design.geometry.posynomial)
    x = dict(zip(names, variables(*names), strict=True)) if exact else _probe(problem)
    rows = rows_of(problem, x)
    limiting = [key for key, row in rows.items() if row.limit is not None or row.bound]
    meant = design.pursued
    pursued = [
        key
        for key, row in rows.items()
        if meant is not None and row.limit is not None and meant.has(row.limit.title)
    ]
    targets = tuple(key for key in limiting if rows[key].is_target)
    sides = _signomial_sides(rows) if exact else _formula_sides(problem, len(rows))
    plain = np.array([key in targets or key not in limiting for key in rows])

    def values(y: Floats, places: Sequence[int]) -> Floats:
        shape = (len(places), *y.shape[1:])
        demand, capacity = np.empty(shape), np.empty(shape)
        with np.errstate(all="ignore"):  # far from any design numbers may overflow
            x = dict(zip(names, np.exp(y), strict=True))
            for k, (needed, offered) in enumerate(sides(x, places)):
                demand[k], capacity[k] = needed, offered
            found = log_utilisation(demand, capacity)
            either = plain[list(places)]
            found[either] = np.log(demand[either] / capacity[either])
        return found

    return SizingProgram(
        names=names,
        sizes=design.geometry.sized(x),
        rows=rows,
        constraints=tuple(key for key in limiting if key not in targets),
        targets=targets,
        values=values if exact else _guarded(values),
        exact=exact,
        problem=problem,
        pursued=None if meant is None else tuple(pursued),
    )


Sides: TypeAlias = Callable[
    [Mapping[str, Floats], Sequence[int]], Iterable[tuple[Floats | float, Floats | float]]
]
"""Demand and capacity of the rows at some places at many sizes."""


def _signomial_sides(rows: Mapping[str, Row]) -> Sides:
    both = [(as_signomial(row.demand), as_signomial(row.capacity)) for row in rows.values()]
    return lambda x, places: [tuple(side.at(**x) for side in both[k]) for k in places]


def _formula_sides(problem: SizingProblem, count: int) -> Sides:
    def sides(
        x: Mapping[str, Floats], places: Sequence[int]
    ) -> Iterable[tuple[Floats | float, Floats | float]]:
        rows = list(rows_of(problem, x).values())
        if len(rows) != count:
            raise ValueError(f"{len(rows)} rows where {count} were found before")
        return [(rows[k].demand, rows[k].capacity) for k in places]

    return sides


def _guarded(
    values: Callable[[Floats, Sequence[int]], Floats],
) -> Callable[[Floats, Sequence[int]], Floats]:
    """Return rows with NaN for the designs of which the formulas have no numbers."""

    def guarded(y: Floats, places: Sequence[int]) -> Floats:
        with suppress(ArithmeticError, ValueError):
            return values(y, places)
        shape = y.shape[1:]
        found = np.full((len(places), *shape), np.nan)
        flat, each = y.reshape(len(y), -1), found.reshape(len(places), -1)
        for i in range(flat.shape[1]) if flat.shape[1] > 1 else ():
            each[:, i : i + 1] = guarded(flat[:, i : i + 1], places)
        return found

    return guarded


def _probe(problem: SizingProblem) -> dict[str, Floats]:
    """Return sizes of which the formulas have all numbers, looked for between the bounds.

    Raises
    ------
    NoSolution
        When there are none among many.

    """
    geometry = problem.design.geometry
    extents, names = geometry.extents, geometry.free
    ends = {
        name: (extents[name].least or LIKELY[0], extents[name].most or LIKELY[1]) for name in names
    }
    rng = np.random.default_rng(0)
    best: dict[str, Floats] = {}
    most = -1
    for trial in range(TRIALS):
        shares = np.full(len(names), 0.5) if trial == 0 else rng.random(len(names))
        sizes = {
            name: np.full(1, low * (high / low) ** share)
            for (name, (low, high)), share in zip(ends.items(), shares, strict=True)
        }
        with suppress(ArithmeticError, ValueError):
            count = len(rows_of(problem, sizes))
            if count > most:
                best, most = sizes, count
            if trial >= ENOUGH:
                break
    if not best:
        raise NoSolution(
            "no-design-to-start-from",
            f"no sizes were found of which a {geometry.name} has numbers",
            "bound its free sizes to what can be made",
        )
    return best
