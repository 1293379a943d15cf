"""The verb tolerances: what share of the parts passes, the worst of them, and what it hangs on."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import exp, nan, sqrt
from time import perf_counter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.check import judged as judged_with_values
from flexcli.engine.judge import judge
from flexcli.engine.models import model_series
from flexcli.engine.tolerances.readings import Plan, finer, first_plan
from flexcli.engine.tolerances.response import (
    BEST,
    HELD,
    Judged,
    Over,
    Portable,
    Recipe,
    Response,
    States,
    drawn,
    of_parts,
    states,
    verdicts_of,
)
from flexcli.engine.tolerances.variations import Variation, as_made, variations
from flexcli.engine.tolerances.worst import judged_of, worst_cases
from flexcli.errors import SolveError
from flexcli.numerics.polynomial_fit import terms
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.results import Check, Note, Result, Status, Verdict
from flexcli.results.activity import doing
from flexcli.results.tolerances import (
    Histogram,
    ToleranceRow,
    TolerancesResult,
    YieldRow,
)

__all__ = ["CONFIDENCE", "PARTS", "respond", "tolerances"]

Floats = NDArray[np.float64]

PARTS = 100_000
"""Parts that are drawn."""

CONFIDENCE = 0.95
"""Of the interval in which a yield lies."""

DEGREES = (2, 3, 4)
"""Degrees of the polynomials that are tried, one after the other."""

MOST_TERMS = 220
"""Coefficients beyond which no higher degree is tried."""

DOUBT = 0.5
"""Parts that the error of a fit leaves open, over those that chance does, that are too many."""

OPEN = 0.05
"""Width of the interval of a yield above which parts are judged each."""

DIRECT = 300
"""Parts that are judged each, then."""

FEW = 1e-4
"""Share of the parts that a model may leave open before a finer one is asked."""

SOBOL = 4096
"""Base of the samples that Sobol's indices are estimated from."""

BINS, TAIL = 30, 0.0005
"""Bars of a histogram of margins, and the share of the parts beyond either of its ends."""

NARROWED = 0.5
"""By how much each tolerance is narrowed to see what that gains."""


def tolerances(
    design: DesignSpec,
    sizes: Sizes,
    spec: str,
    *,
    parts: int = PARTS,
    seed: int = 0,
    confidence: float = CONFIDENCE,
    over: Over = map,
    recipe: Recipe = (),
) -> Result:
    """Return yields, worst cases and sensitivities of a design whose sizes are given.

    Parameters
    ----------
    design : DesignSpec
        The design with its tolerances.
    sizes : named tuple
        Its sizes [m].
    spec : str
        Its name in the result.
    parts : int
        How many parts are drawn.
    seed : int
        Of the parts: the same gives the same.
    confidence : float
        Of the interval in which a yield lies.
    over : callable
        Judges many designs, in order, in as many processes as it likes.
    recipe : tuple
        What makes the design anew in another process, where ``over`` uses several.

    Raises
    ------
    SolveError
        When the design has no tolerances, or end stops.

    """
    started = perf_counter()
    _refuse(design)
    drawn = nominal_of(design)
    found = judge(drawn, sizes, model_series(drawn))
    nominal = judged_with_values("tolerances", drawn, sizes, spec, found)
    run = _Run(Portable(design, recipe), found.checks, parts, seed, confidence, over)
    notes = tuple(_joints_alike(design))
    try:
        run.all()
    except KeyboardInterrupt:
        notes = (
            *notes,
            Note("interrupted", f"the run was stopped: it had judged {run.judged} designs"),
        )
    is_stopped = any(note.code == "interrupted" for note in notes)
    result = run.result()
    assert nominal.cost is not None  # a judgement has one
    return replace(
        nominal,
        status=_status(result) if not is_stopped else Status.UNDECIDED,
        values={},
        effects=(),
        tolerances=result,
        warnings=(*nominal.warnings, *notes),
        cost=replace(nominal.cost, seconds=perf_counter() - started),
    )


class _Run:
    """A study on its way: what is known so far."""

    def __init__(
        self,
        design: Portable,
        checks: Sequence[Check],
        parts: int,
        seed: int,
        confidence: float,
        over: Over,
    ) -> None:
        self.portable, self.over = design, over
        self.design = design.design
        self.drawn = nominal_of(self.design)
        self.seed, self.confidence = seed, confidence
        self.each = variations(self.design)
        self.names = tuple(check.full_name for check in checks)
        self.shares = np.random.default_rng(seed).random((parts, len(self.each)))
        self.u = drawn(self.each, self.shares)
        self.verdicts: list[dict[str, Verdict]] = []
        self.rows: tuple[YieldRow, ...] = ()
        self.together = YieldRow("together", nan, (0.0, 1.0), nan, nan)
        self.halved: dict[str, float] = {}
        self.judged, self.method = 0, "nothing was judged"

    def all(self) -> None:
        """Do all of it, each step with what those before found."""
        judged = Judged(
            self.portable, self.each, first_plan(self.drawn), np.clip(self.u[:HELD], -1.0, 1.0),
            self.over, self.seed,
        )  # fmt: skip
        try:
            response = respond(judged, self.names, self.u)
        except KeyboardInterrupt:
            self.judged = len(judged.readings)
            self.method = "an interrupted run"
            self._take([verdicts_of(one) for one in judged.readings[: judged.held]])
            raise
        self.judged = len(judged.points)
        self.names = tuple(dict.fromkeys((*self.names, *response.checks)))
        self.method = (
            f"polynomials of degree {response.degree} in the logarithms through "
            f"{self.judged - judged.held} designs that were judged; their errors by "
            f"{judged.held} random parts more"
        )
        found = states(response, self.names, self.u)
        self.rows = tuple(
            _row(name, found.of(k), self.confidence) for k, name in enumerate(self.names)
        )
        self.together = _row("together", found.together, self.confidence)
        low, high = self.together.interval
        if high - low > OPEN:
            self._judge_parts()
        self.rows = self._with_slopes(response)
        self.halved = self._halved(response)
        worst = worst_cases(response, self.each, self.design)
        self.rows = tuple(row._replace(worst=worst.get(row.name)) for row in self.rows)

    def _judge_parts(self) -> None:
        """Judge a few of the parts themselves; a yield is as sure as so few can make it."""
        find = partial(_verdicts, self.portable, self.each)
        points = np.clip(self.u[:DIRECT], -1.0, 1.0)
        found: list[dict[str, Verdict]] = []
        try:
            found.extend(of_parts(self.over, find, self.each, points))
        finally:
            self.judged += len(found)
            self._take(found)

    def _take(self, found: Sequence[Mapping[str, Verdict]]) -> None:
        """Take the yields of random parts that were judged each, where they know more."""
        if not found:
            return
        table = np.array([[one.get(name) is Verdict.PASS for name in self.names] for one in found])
        fails = np.array([[one.get(name) is Verdict.FAIL for name in self.names] for one in found])
        known = States(table, table, table, ~table & ~fails)
        rows = [_row(name, known.of(k), self.confidence) for k, name in enumerate(self.names)]
        self.rows = tuple(map(_narrower, self.rows or rows, rows))
        self.together = _narrower(self.together, _row("together", known.together, self.confidence))
        self.method += f"; yields that it leaves open by {len(found)} parts that were judged each"

    def _with_slopes(self, response: Response) -> tuple[YieldRow, ...]:
        """Return the rows with what the margins hang on, at the design as drawn and over all."""
        if not response.rows:
            return self.rows
        at = np.array([[float(v.scale(np.asarray(v.nominal))) for v in self.each]])
        low = response.low.at(at)[0]
        slopes = np.stack([response.low.slope(i).at(at)[0] for i in range(len(self.each))])
        wide = np.array([v.width for v in self.each])  # of the variable, per relative change
        sigma = np.array([v.spread.sigma / abs(v.nominal) if v.nominal else 0.0 for v in self.each])
        found = []
        indices = self._indices(response)
        parts = response.low.at(np.clip(self.u, -1.0, 1.0))
        for row in self.rows:
            columns = response.places(row.name)
            if not columns:
                found.append(row)
                continue
            k = min(columns, key=lambda column: low[column])
            per_share = slopes[:, k] * wide
            spread = float(np.sqrt(((per_share * sigma) ** 2).sum()))
            names = [v.name for v in self.each]
            first, total = indices[row.name]
            found.append(
                row._replace(
                    nominal=exp(float(low[k])),
                    error=float(np.expm1(max(response.error_low[columns]))),
                    first_order=_normal_share(float(low[k]), spread),
                    slopes=dict(zip(names, per_share.tolist(), strict=True)),
                    first=dict(zip(names, first, strict=True)),
                    total=dict(zip(names, total, strict=True)),
                    histogram=_histogram(np.exp(parts[:, columns].min(axis=1))),
                )
            )
        return tuple(found)

    def _indices(self, response: Response) -> dict[str, tuple[list[float], list[float]]]:
        """Return Sobol's first and total indices of the logarithm of each factor."""
        from scipy.stats import sobol_indices

        doing("Sobol's indices")
        checks = list(response.checks)
        if len(self.each) == 1:  # all of it
            return {name: ([1.0], [1.0]) for name in checks}
        columns = [response.places(name) for name in checks]

        def margins(x: Floats) -> Floats:
            values = [v.scale(v.made(d)) for v, d in zip(self.each, x, strict=True)]
            low = response.low.at(np.clip(np.stack(values, axis=1), -1.0, 1.0))
            return np.stack([low[:, places].min(axis=1) for places in columns])

        spreads: list[Any] = [v.spread for v in self.each]  # by whose ppf the samples are drawn
        rng = np.random.default_rng(self.seed)
        found = sobol_indices(func=margins, n=SOBOL, dists=spreads, rng=rng)
        shape = (len(checks), len(self.each))
        first, total = (x.reshape(shape) for x in (found.first_order, found.total_order))
        return {name: (first[k].tolist(), total[k].tolist()) for k, name in enumerate(checks)}

    def _halved(self, response: Response) -> dict[str, float]:
        """Return the share that passes with each tolerance halved, of the same parts otherwise."""
        found = {}
        for name in dict.fromkeys(v.tolerance for v in self.each):
            narrow = [
                v._replace(spread=v.spread.scaled(NARROWED)) if v.tolerance == name else v
                for v in self.each
            ]
            parts = zip(self.each, narrow, self.shares.T, strict=True)
            u = np.stack([v.scale(v.made(n.spread.ppf(q))) for v, n, q in parts], axis=1)
            found[name] = float(states(response, self.names, u).together.passed.mean())
        return found

    def result(self) -> TolerancesResult:
        """Return what is known."""
        robust = self.design.robust
        return TolerancesResult(
            asked=robust.parts if robust is not None else None,
            tolerances=tuple(
                ToleranceRow(
                    v.name, v.unit, v.nominal, v.nominal + v.spread.low,
                    v.nominal + v.spread.high, v.spread.kind, self.halved.get(v.tolerance, nan),
                )
                for v in self.each
            ),
            together=self.together,
            checks=self.rows,
            parts=len(self.u),
            judged=self.judged,
            seed=self.seed,
            confidence=self.confidence,
            method=self.method,
        )  # fmt: skip


def _histogram(margins: Floats) -> Histogram:
    """Return the shares of parts by margin; the few beyond its ends are counted at them."""
    low, high = np.quantile(margins, [TAIL, 1.0 - TAIL])
    counts, edges = np.histogram(np.clip(margins, low, high), bins=BINS)
    return Histogram(tuple(edges.tolist()), tuple((counts / len(margins)).tolist()))


def _verdicts(
    design: Portable, each: tuple[Variation, ...], values: Sequence[float]
) -> dict[str, Verdict]:
    """Return what the models say of each check of a part, in whatever process."""
    return {name: check.verdict for name, check in judged_of(design.design, each, values).items()}


def _narrower(one: YieldRow, other: YieldRow) -> YieldRow:
    """Return which of two rows knows more."""
    widths = [high - low for low, high in (one.interval, other.interval)]
    return one if widths[0] <= widths[1] else other


def _normal_share(margin: float, spread: float) -> float:
    """Return how much of a normal spread about a margin is above zero."""
    from scipy.special import ndtr

    if spread == 0.0:
        return float(margin >= BEST)
    return float(ndtr(margin / spread))


def _status(found: TolerancesResult) -> Status:
    """Return whether the asked share of parts passes, or every part where none is asked."""
    low, high = found.together.interval
    if found.asked is not None:
        if low >= found.asked:
            return Status.PASS
        return Status.FAIL if high < found.asked else Status.UNDECIDED
    worst = [row.worst.verdict if row.worst is not None else "" for row in found.checks]
    if Verdict.FAIL.value in worst:
        return Status.FAIL
    return Status.PASS if set(worst) <= {Verdict.PASS.value} else Status.UNDECIDED


def _joints_alike(design: DesignSpec) -> Iterator[Note]:
    """Yield what is not told of blades that differ in a mechanism of several joints."""
    count = design.mechanism.joints if design.mechanism is not None else 1
    if count > 1 and any(tolerance.each == "blade" for tolerance in design.tolerances.values()):
        text = f"the blades of a joint differ, but the {count} joints of the mechanism are alike"
        yield Note("joints-alike", text)


def nominal_of(design: DesignSpec) -> DesignSpec:
    """Return the part that is as drawn, by the models that all parts are judged by."""
    each = variations(design)
    return as_made(design, each, [v.nominal for v in each])


def _refuse(design: DesignSpec) -> None:
    if not design.tolerances:
        text = "the design has no tolerances"
        raise SolveError("no-tolerances", text, "add e.g. tolerances: {h: 5 um}")
    if design.stops is not None:
        raise SolveError(
            "tolerances-of-stops",
            "the tolerances of a design with end stops are not studied",
            "take the stops out, or vary single numbers with 'flexure sweep'",
        )


def respond(judged: Judged, names: Sequence[str], u: Floats) -> Response:
    """Return margins fitted closely enough for the parts that are drawn.

    The degree rises, and finer models are asked, while that may decide more parts than chance
    leaves open.
    """
    count = u.shape[1]
    response: Response | None = None
    for degree in DEGREES:
        if response is not None and terms(count, degree) > MOST_TERMS:
            break
        judged.reach(degree)
        response = Response.of(judged, degree)
        while True:
            found = states(response, names, u)
            open_ = _open_questions(response, names, found)
            plan: Plan = finer(nominal_of(judged.design.design), judged.plan, open_)
            if plan == judged.plan:
                break
            judged.ask(plan)
            response = Response.of(judged, degree)
        whole = found.together
        doubt = int((whole.perhaps & ~whole.surely).sum())
        passed = float(whole.passed.mean())
        chance = sqrt(max(1.0, passed * (1.0 - passed) * len(u)))
        if doubt <= DOUBT * chance:
            break
    assert response is not None  # of the first degree
    return response


def _open_questions(response: Response, names: Sequence[str], found: States) -> set[int]:
    """Return which questions a model leaves open of parts that would not fail otherwise."""
    open_ = set()
    for k, check in enumerate(names):
        if int(found.undecided[:, k].sum()) > FEW * len(found.undecided):
            open_ |= {row.question for row in response.rows if row.check == check}
    return open_ - {-1}


def _row(name: str, found: States, confidence: float) -> YieldRow:
    count = len(found.passed)
    low, _ = _interval(int(found.surely.sum()), count, confidence)
    _, high = _interval(int(found.perhaps.sum()), count, confidence)
    share, open_ = float(found.passed.mean()), float(found.undecided.mean())
    return YieldRow(name, share, (low, high), open_, np.nan)


def _interval(passed: int, count: int, confidence: float) -> tuple[float, float]:
    """Return the interval of Clopper and Pearson (1934), which holds at least so often."""
    from scipy.special import betaincinv

    tail = (1.0 - confidence) / 2.0
    low = 0.0 if passed == 0 else float(betaincinv(passed, count - passed + 1, tail))
    high = 1.0 if passed == count else float(betaincinv(passed + 1, count - passed, 1.0 - tail))
    return low, high
