"""Robust sizing: the least objective at which enough of the parts, or the worst of them, pass.

What the tolerances take of each margin is found at a choice, in value and in slope over the
toleranced sizes, the sizing asks for as much more, and so on until its choice stays: the least
objective under margins less their loss, as far as the sizing itself is sure of it. The choice is
then judged by a tolerance run like any other design.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import exp, log, sqrt
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.size import UNSETTLED, size
from flexcli.engine.sizing.free_height import with_height
from flexcli.engine.tolerances.readings import Plan, first_plan, reading
from flexcli.engine.tolerances.response import HELD, Judged, Portable, drawn
from flexcli.engine.tolerances.study import CONFIDENCE, PARTS, nominal_of, respond, tolerances
from flexcli.engine.tolerances.variations import Variation, variations
from flexcli.engine.tolerances.worst import least_of
from flexcli.parts.design import DesignSpec
from flexcli.parts.sizing import Correction
from flexcli.parts.tolerances import place_of, with_number
from flexcli.results import Note, Result, Status
from flexcli.results.activity import doing

__all__ = ["robust_size"]

Floats = NDArray[np.float64]

Losses: TypeAlias = dict[str, float]
"""By check: the loss of its factor to the tolerances, as a logarithm."""

ROUNDS = 10
SETTLED = 2e-4
"""Change of a loss (relative to the factor) at which the rounds end."""

STEP = 0.05
"""Change of a toleranced size, over its tolerance, over which the slope of a loss is taken."""

BISECTIONS = 30

SOME = 2000
"""Parts that tell whether a fit is close enough where only the worst of them counts."""

BEYOND = 1.2
"""How far a fit is followed beyond the designs that it goes through, for a slope."""

HAIR = 1e-4
"""What is asked above the loss, so that chance and rounding do not undo it."""

ACTIVE = 5e-3
"""Logarithm of a margin over its loss below which the loss holds the choice."""


def robust_size(design: DesignSpec, spec: str, model: str | None = None) -> Result:
    """Return the sized design of which the stated share of parts passes, judged by a run.

    Parameters
    ----------
    design : DesignSpec
        The design, its sizes free, with tolerances and what shall pass.
    spec : str
        Its name in the result.
    model : str, optional
        The model that alone judges, over that of the spec.

    """
    if model is not None:
        design = design.model_copy(update={"model": model})
    lost: dict[str, Correction] = {}
    share = _sure_share(design)
    drawn_parts = PARTS if share is not None else SOME
    plan: Plan | None = None
    notes: tuple[Note, ...] = (
        Note("did-not-settle", "the loss to tolerances did not converge: not the optimum"),
    )
    for number in range(ROUNDS):
        doing(f"loss to the tolerances, round {number + 1}")
        chosen = size(design, spec, losses=lost)
        has_sizes = bool(chosen.checks) and all(n in chosen.values for n in design.geometry.free)
        if chosen.status is Status.INFEASIBLE or not has_sizes:
            return _without_design(chosen, lost)
        made = _made(design, chosen)
        sizes = made.fixed_sizes()
        known = {check: log(float(each.at(sizes))) for check, each in lost.items()}
        loss = _Loss(made, drawn_parts, share, known, plan)
        found, plan = _corrections(loss, design.geometry.free), loss.plan
        moved = [abs(log(each.factor) - known.get(check, 0.0)) for check, each in found.items()]
        lost = found
        if max(moved, default=0.0) <= SETTLED:
            notes = ()
            break
    judged = tolerances(made, sizes, spec)
    assert judged.cost is not None  # a study has one
    sizing = chosen.sizing
    if sizing is not None:
        certificate = f"{sizing.certificate}, and within the loss to tolerances"
        sizing = replace(sizing, certificate=UNSETTLED if notes else certificate, sensitivities=())
    known_codes = {note.code for note in chosen.warnings}
    others = tuple(note for note in judged.warnings if note.code not in known_codes)
    return replace(
        judged,
        command="size",
        values=chosen.values,
        effects=chosen.effects,
        sizing=sizing,
        warnings=(*notes, *chosen.warnings, *others),
    )


def _made(design: DesignSpec, chosen: Result) -> DesignSpec:
    """Return the design with the sizes that were chosen."""
    height = chosen.values.get("H")
    made = design
    if height is not None and height.model == "sized":
        made = with_height(made, height.value)
    for name in design.geometry.free:
        made = with_number(made, place_of(made, name).path, chosen.values[name].value)
    return made


def _without_design(chosen: Result, lost: Mapping[str, Correction]) -> Result:
    """Return a sizing that found no design, with the largest loss to the tolerances."""
    if not lost:
        return chosen
    most = max(lost, key=lambda check: lost[check].factor)
    text = (
        "with each margin less its loss to the tolerances no sizes meet the requirements; the "
        f"largest loss is that of {most}, {100.0 * (lost[most].factor - 1.0):.2g} %"
    )
    return replace(chosen, warnings=(*chosen.warnings, Note("tolerances-too-wide", text)))


def _sure_share(design: DesignSpec) -> float | None:
    """Return the share of the drawn parts that has to pass for the stated one to be sure."""
    assert design.robust is not None  # the caller's
    asked = design.robust.parts
    if asked is None:
        return None
    from scipy.special import ndtri

    chance = float(ndtri(0.5 + CONFIDENCE / 2.0)) * sqrt(asked * (1.0 - asked) / PARTS)
    return min(asked + 1.1 * chance + 2.0 / PARTS, 1.0 - 1.0 / PARTS)


class _Loss:
    """What the tolerances take of each check, at a choice and beside it."""

    def __init__(
        self,
        made: DesignSpec,
        parts: int,
        share: float | None,
        lost: Losses,
        plan: Plan | None,
    ) -> None:
        self.made, self.share = made, share
        self.each = variations(made)
        self.shares = np.random.default_rng(0).random((parts, len(self.each)))
        u = drawn(self.each, self.shares)
        nominal = nominal_of(made)
        plan = plan or first_plan(nominal)
        names = tuple(dict.fromkeys(row.check for row in reading(nominal, plan)))
        points = np.clip(u[:HELD], -1.0, 1.0)
        judged = Judged(Portable(made, ()), self.each, plan, points, map, 0)
        self.response = respond(judged, names, u)
        self.plan = judged.plan
        self.checks = [name for name in self.response.checks if name not in self.response.unknown]
        self.risk = 0.0 if share is None else self._risk(share, lost)

    def at(self, each: Sequence[Variation]) -> Losses:
        """Return the losses where nominal values are those of ``each``."""
        here = self._at_nominal(each)
        if self.share is None:
            ends = self._scaled([v.nominal + np.array([v.spread.low, v.spread.high]) for v in each])
            least = least_of(self.response, ends[0], ends[1])
            worst = np.array([
                min(least[k].bound for k in self.response.places(check)) for check in self.checks
            ])  # fmt: skip
        else:
            worst = np.quantile(self._worst_rows(self._parts(each)), self.risk, axis=0)
        return dict(zip(self.checks, (here - worst).tolist(), strict=True))

    def with_nominal(self, path: tuple[str | int, ...], factor: float) -> Losses:
        """Return the losses with the nominal of the numbers at a path changed by a factor."""

        def there(v: Variation) -> Variation:
            if v.path != path:
                return v
            nominal = factor * v.nominal
            dimension = place_of(self.made, v.tolerance).dimension
            spread = self.made.tolerances[v.tolerance].spread(dimension, nominal)
            return v._replace(nominal=nominal, spread=spread)

        return self.at([there(v) for v in self.each])

    def _risk(self, share: float, lost: Losses) -> float:
        """Return the share of the parts that each check may fail for the others to hold as well.

        A check that holds the choice goes down to its loss, any other keeps the margin it has.
        """
        here = self._at_nominal(self.each)
        margins = self._worst_rows(self._parts(self.each))
        holds = here - np.array([lost.get(check, 0.0) for check in self.checks]) <= ACTIVE

        def passing(risk: float) -> float:
            needed = here - np.quantile(margins, risk, axis=0)
            kept = np.where(holds, needed, np.maximum(here, needed))
            return float((margins - here + kept >= 0.0).all(axis=1).mean())

        low, high = 0.0, 1.0 - share
        for _ in range(BISECTIONS):
            middle = (low + high) / 2.0
            low, high = (middle, high) if passing(middle) >= share else (low, middle)
        return low

    def _at_nominal(self, each: Sequence[Variation]) -> Floats:
        """Return the logarithm of each check's margin at nominal values."""
        u = self._scaled([np.array([v.nominal]) for v in each])
        return np.asarray(self._worst_rows(u)[0])

    def _parts(self, each: Sequence[Variation]) -> Floats:
        """Return the drawn parts with other nominal values, as the variables of the fits."""
        return self._scaled(
            [v.made(v.spread.ppf(q)) for v, q in zip(each, self.shares.T, strict=True)]
        )

    def _scaled(self, values: Sequence[Floats]) -> Floats:
        """Return values as the variables of the fits, a hair beyond them at most."""
        u = [v.scale(x) for v, x in zip(self.each, values, strict=True)]
        return np.clip(np.stack(u, axis=1), -BEYOND, BEYOND)

    def _worst_rows(self, u: Floats) -> Floats:
        """Return the logarithm of each check's margin, its error taken off, (points, checks)."""
        low = self.response.low.at(u) - self.response.error_low
        return np.stack(
            [low[:, self.response.places(check)].min(axis=1) for check in self.checks], axis=1
        )


def _corrections(loss: _Loss, free: Sequence[str]) -> dict[str, Correction]:
    """Return the loss of each check to the tolerances as a factor, with its slopes."""
    here = loss.at(loss.each)
    sizes = loss.made.fixed_sizes()
    about = {name: float(getattr(sizes, name)) for name in free}
    slopes: dict[str, dict[str, float]] = {check: {} for check in here}
    for name in free:
        path = place_of(loss.made, name).path
        reach = [(v.spread.high - v.spread.low) / v.nominal for v in loss.each if v.path == path]
        if reach:
            factor = 1.0 + STEP * min(reach)  # within what the fit goes through
            for check, there in loss.with_nominal(path, factor).items():
                slopes[check][name] = (there - here[check]) / log(factor)
    return {
        check: Correction(exp(taken + HAIR), about, slopes[check]) for check, taken in here.items()
    }
