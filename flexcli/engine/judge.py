"""Judge a design: each check by the cheapest model whose error does not reach its requirement.

Every requirement of every case is asked of the closed forms first. Where the range of its factor
reaches across the required one, the next model is asked, so that a wide margin costs nothing.
"""

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache, partial
from math import inf, isfinite, isnan, nan
from time import perf_counter
from typing import NamedTuple

from flexcli.engine import assess
from flexcli.engine.models import NamedModel
from flexcli.engine.plane_stability import PlaneStability
from flexcli.errors import SolveError
from flexcli.numerics.rows import one_alone
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import ANY, Buckled, NotAvailable
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.requirements import Ask, ErrorOf, Limit, Requirement, RequirementError
from flexcli.parts.requirements.base import FactorRequirement
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import (
    Check,
    Cost,
    ErrorRange,
    Note,
    QuantityKind,
    Result,
    Status,
    Verdict,
)
from flexcli.results.activity import doing

__all__ = [
    "FAR",
    "SURE",
    "Interrupted",
    "Judgement",
    "Used",
    "again",
    "finest",
    "judge",
    "limits_by",
    "status_of",
    "stopped_result",
]

WOULD_LOOK = {
    LoadKind.STROKE: "yield, fatigue or parasitic_shift",
    LoadKind.LOAD: "yield, or buckling with ends: in the case",
    LoadKind.WRENCH: "yield or deflection",
    LoadKind.ACCELERATION: "sag or yield",
    LoadKind.ASD: "dynamic-yield or dynamic-buckling",
    LoadKind.SHOCK: "dynamic-yield or dynamic-buckling",
    LoadKind.SINE: "dynamic-yield or dynamic-buckling",
    LoadKind.SWEEP: "dynamic-yield or dynamic-buckling",
    LoadKind.AXES: "dynamic-yield or dynamic-buckling",
    LoadKind.SINES: "dynamic-yield or dynamic-buckling",
    LoadKind.TEMPERATURE: "yield, or parasitic_shift beside a stroke",
}
"""Which requirement would look at a load that none looks at."""

OUT_OF_PLANE = frozenset({LoadKind.WRENCH, LoadKind.ACCELERATION, LoadKind.TEMPERATURE})
"""Loads that only a model of the whole joint looks at, where they act out of its plane."""

OF_PLANE = (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY, QuantityKind.SHIFT)
"""Numbers of a joint's own that loads out of its plane leave to models of the plane."""

FAR = 1.5
"""Factors over the required one beyond which a sizing asks no finer model."""

SURE = 1e-3
"""Width of a range (relative) that a sizing takes for a point: what a finer model could save."""


class Judgement(NamedTuple):
    """The checks of a design, the models that were asked, and what each of these took [s]."""

    checks: tuple[Check, ...]
    by_model: dict[str, float]
    models: tuple[NamedModel, ...]

    @property
    def status(self) -> Status:
        """Return what all checks together say."""
        return status_of(self.checks)

    @property
    def deciding(self) -> str:
        """Return the models that decided, the finest last, in words."""
        names = dict.fromkeys(check.model for check in self.checks if check.model)
        return ", ".join(sorted(names, key=list(self.by_model).index)) or "closed-form"


def status_of(checks: Iterable[Check]) -> Status:
    """Return fail for one that fails, else undecided for one that is not decided, else pass."""
    worst = min((check.verdict for check in checks), key=lambda verdict: verdict.rank, default=None)
    if worst is Verdict.FAIL:
        return Status.FAIL
    return Status.PASS if worst in (None, Verdict.PASS) else Status.UNDECIDED


class Interrupted(KeyboardInterrupt):
    """A judgement was interrupted; its checks so far, and a row for each that was not done."""

    def __init__(self, so_far: Judgement) -> None:
        super().__init__()
        self.so_far = so_far


def judge(
    design: DesignSpec, sizes: Sizes, models: tuple[NamedModel, ...], *, formulas: bool = True
) -> Judgement:
    """Return every check of a design by the models in turn; raise Interrupted at Ctrl-C.

    Before several models the formula of a requirement is asked, where it has one and formulas
    may judge.
    """
    series = _Series(design, sizes, models, formulas=formulas)
    found = list(assess.checks(design.own_limits(sizes)))
    scenes = design.scenes()
    looked_at: dict[str, set[LoadKind]] = {scene.case: set() for scene in scenes}
    questions = list(design.questions(scenes))
    paths = {id(asked): ("requirements", *path) for path, asked in design.requirements.each()}
    for index, (requirement, scene) in enumerate(questions):
        try:
            path = paths[id(requirement)]
            found.extend(check._replace(path=path) for check in series.climbed(requirement, scene))
        except KeyboardInterrupt:
            open_ = (
                _not_done(asked, of)._replace(path=paths[id(asked)])
                for asked, of in questions[index:]
            )
            so_far = assess.worst_of_each([*found, *open_])
            raise Interrupted(Judgement(so_far, series.seconds, models)) from None
        looked_at[scene.case] |= requirement.looks_at(scene)
    for requirement in {id(asked): asked for asked, _ in questions if asked.adds_up}.values():
        path = paths[id(requirement)]
        found.extend(_together(requirement, [c for c in found if c.path == path]))
    for scene in scenes:
        found.extend(_not_judged(scene, looked_at[scene.case], design.geometry))
        found.extend(_switched_off(design, scene.case))
    return Judgement(assess.worst_of_each(found), series.seconds, models)


def again(
    design: DesignSpec, sizes: Sizes, models: tuple[NamedModel, ...], checks: Iterable[Check]
) -> tuple[Check, ...]:
    """Return checks of a design as it is now, each by the model that decided it before.

    No finer one is asked. A check of which that model says nothing any more is left out.
    """
    deciding: dict[tuple[tuple[str | int, ...], str], set[str]] = {}
    for check in checks:
        deciding.setdefault((check.path, check.case), set()).add(check.model)
    found: list[Check] = []
    paths = {id(each): ("requirements", *path) for path, each in design.requirements.each()}
    for requirement, scene in design.questions(design.scenes()):
        names = deciding.get((paths[id(requirement)], requirement.case_of(scene)), set())
        for model in models:
            if model.name not in names:
                continue
            with suppress(NotAvailable, RequirementError, SolveError):
                limits = list(limits_by(design, sizes, requirement, scene, model))
                found.extend(check._replace(model=model.name) for check in assess.checks(limits))
    return tuple(found)


def stopped_result(
    command: str, design: DesignSpec, spec: str, so_far: Judgement, seconds: float
) -> Result:
    """Return what a run had judged when it was stopped: it decides nothing but what fails."""
    text = "the run was stopped: what it had not judged by then is undecided"
    return Result(
        command=command,
        spec=spec,
        status=Status.FAIL if so_far.status is Status.FAIL else Status.UNDECIDED,
        title=design.title,
        checks=so_far.checks,
        warnings=(Note("interrupted", text),),
        cost=Cost(seconds, so_far.deciding, None, by_model=so_far.by_model),
    )


class Used(NamedTuple):
    """The share of what it allows that a check uses, the question it answers, and by which model.

    Question and model are told by their places.
    """

    share: float
    question: int
    model: int
    check: Check

    @property
    def is_target(self) -> bool:
        """Return whether all of it shall be used, no less."""
        return self.check.is_target


def finest(
    design: DesignSpec,
    sizes: Sizes,
    models: tuple[NamedModel, ...],
    only: Container[int] | None = None,
    first: Mapping[int, int] | None = None,
    *,
    known: bool = False,
    near: tuple[DesignSpec, Sizes] | None = None,
) -> tuple[dict[str, Used], frozenset[int]]:
    """Return what each check uses, and the questions that are open: no model has their numbers.

    By a model that is sure of it where it is near its limit, or the objective; the low end of the
    factor counts, of a target its value. ``only`` are the questions to ask; all if left out.
    ``first`` tells by question which model is asked first. A number whose error nobody knows
    counts as it is, unless they all shall be ``known``: then its question is open. ``near`` is a
    design from which this one differs a little, where that difference is what is asked for.
    """
    names, open_ = [model.name for model in models], set()
    series, found = _Series(design, sizes, models, near), {}
    scenes, meant = design.scenes(), design.pursued

    def enough(check: Check) -> bool:
        is_goal = meant is not None and meant.has(check.name)
        return _is_sure(check, inf if is_goal else FAR)

    for index, (requirement, scene) in enumerate(design.questions(scenes)):
        if only is not None and index not in only:
            continue
        started = (first or {}).get(index, 0)
        checks = tuple(series.by_models(requirement, scene, enough, started))
        leaves = series.plane.as_check(requirement, scene, checks)
        if leaves is not None and not _is_sure(leaves, FAR):
            checks += (leaves,)
        for check in checks:
            share = _share(check)
            is_known = check.factor_range is not None or not known
            if isfinite(share) and share > 0.0 and is_known:
                model = names.index(check.model)
                found[check.full_name] = Used(share, index, model, check)
            elif not isfinite(check.factor) or check.factor_range is None:
                open_.add(index)
    return found, frozenset(open_)


def _is_sure(check: Check, far: float) -> bool:
    """Return whether a finer model would tell a sizing nothing more, ``far`` from the limit."""
    if check.factor_range is None:
        return False
    low, high = check.factor_range
    return low > far * check.required or high - low <= SURE * abs(low)


def _tells_less(check: Check, known: Check) -> bool:
    """Return whether a finer model is less sure of a factor than one before it.

    Both ranges have the true one, so that neither end of a wider one decides what those of the
    narrower do not.
    """
    return known.factor_range is not None and _width(check) > _width(known)


def _width(check: Check) -> tuple[float, float]:
    """Return how wide a range is, infinite where there is none; of two without end the lower ends.

    They are in the order of what is known.
    """
    if check.factor_range is None:
        return inf, inf
    low, high = check.factor_range
    return high - low, -low


def _is_decided(check: Check) -> bool:
    return check.verdict is not Verdict.UNDECIDED


def _share(check: Check) -> float:
    if check.is_target:
        return check.demand / check.capacity
    low = check.factor_range[0] if check.factor_range is not None else check.factor
    return check.required / low if low > 0.0 else nan


class _Series:
    """The models in turn, and the time that each took."""

    def __init__(
        self,
        design: DesignSpec,
        sizes: Sizes,
        models: tuple[NamedModel, ...],
        near: tuple[DesignSpec, Sizes] | None = None,
        *,
        formulas: bool = True,
    ) -> None:
        self.formulas = formulas and len(models) > 1 and not design.omitted
        self.design = design
        self.sizes = sizes
        self.models = models
        self.near = near
        self.seconds: dict[str, float] = {}
        self.plane = PlaneStability(design, sizes, models, self.seconds)

    def climbed(self, requirement: Requirement, scene: Scene) -> tuple[Check, ...]:
        """Return the checks of a requirement in a case, by the cheapest that decides them all."""
        found = self._by_formula(requirement, scene)
        if not found or not all(map(_is_decided, found)):
            found = tuple(self.by_models(requirement, scene, _is_decided))
        return self.plane.judged(requirement, scene, found)

    def _by_formula(self, requirement: Requirement, scene: Scene) -> tuple[Check, ...]:
        """Return the checks by the requirement's own formula, where no model is insisted on."""
        name = requirement.formula(scene) if self.formulas and not scene.unjudged else ""
        if not name:
            return ()
        started = perf_counter()
        ask = self.design.ask(scene, self.sizes, self.models[0].joint_model)
        try:
            found = assess.checks(_known(self.design, ask, requirement.by_formula(ask)))
        except (NotAvailable, RequirementError, SolveError):
            found = ()  # said where the models judge
        took = perf_counter() - started
        self.seconds[name] = self.seconds.get(name, 0.0) + took
        return tuple(check._replace(model=name, seconds=took) for check in found)

    def by_models(
        self,
        requirement: Requirement,
        scene: Scene,
        enough: Callable[[Check], bool],
        first: int = 0,
    ) -> Iterator[Check]:
        """Yield the checks of a requirement in a case, each by the first model that does.

        Models before ``first`` are asked only where it and those after it have no answer.
        """
        best: dict[str, Check] = {}
        spent, reason, least = 0.0, "", cache(partial(self._least_stress, scene))
        for model in self.models[first:]:
            doing(f"{requirement.label}, {scene.case}, by the {model.name} model")
            started = perf_counter()
            ask = self.design.ask(scene, self.sizes, model.joint_model) if best else None
            if ask is not None and not model.may_tell_more(requirement, ask, best.values()):
                continue
            buckled: Buckled | None = None
            try:
                limits = list(self._limits(requirement, scene, model))
            except Buckled as found:
                buckled, limits = found, []
            except (NotAvailable, RequirementError, SolveError) as error:
                reason, limits = str(error), []
            took = perf_counter() - started
            self.seconds[model.name] = self.seconds.get(model.name, 0.0) + took
            spent += took
            for check in assess.checks(limits):
                key, known = check.full_name, best.get(check.full_name)
                if known is not None and enough(known):
                    continue
                if known is None or enough(check) or not _tells_less(check, known):
                    best[key] = check._replace(model=model.name, seconds=spent)
            if buckled is not None:
                nobody = [_no_answer(requirement, scene, "", "", 0.0)] if first == 0 else []
                for check in list(best.values()) or nobody:
                    if not enough(check):
                        fails = _buckles(check, buckled)
                        best[check.full_name] = fails._replace(model=model.name, seconds=spent)
            if enough is _is_decided and requirement.is_of_stress:
                best |= _overborne(best, least)  # before finer ones follow hopeless loads
            if best and all(enough(check) for check in best.values()):
                break
        if enough is not _is_decided and requirement.is_of_stress:
            best |= _overborne(best, least)
        if not best and first > 0:
            yield from self.by_models(requirement, scene, enough)
        elif not best:
            yield _no_answer(requirement, scene, reason, self.models[-1].name, spent)
        yield from best.values()

    def _least_stress(self, scene: Scene) -> float:
        """Return the least stress of the loads of a case, by equilibrium alone [Pa]."""
        if not (scene.is_loaded or scene.across_by):
            return 0.0
        from flexcli.engine.joint_models.equilibrium_stress import least_stress

        return least_stress(self.design.ask(scene, self.sizes, self.models[-1].joint_model))

    def _limits(self, requirement: Requirement, scene: Scene, model: NamedModel) -> Iterator[Limit]:
        return limits_by(self.design, self.sizes, requirement, scene, model, self.near)


def limits_by(
    design: DesignSpec,
    sizes: Sizes,
    requirement: Requirement,
    scene: Scene,
    model: NamedModel,
    near: tuple[DesignSpec, Sizes] | None = None,
) -> Iterator[Limit]:
    """Yield the limits of a requirement in a case by one model, each with its error.

    What blades in space are without, as the spec switches it off, stays in it.
    """
    if scene.unjudged and requirement.looks_at(scene) & scene.loads:
        raise NotAvailable(scene.unjudged)
    if not design.omitted:
        yield from _limits_of(design, sizes, requirement, scene, model, near)
        return
    one_alone()
    whole: dict[str, tuple[float, float] | None] = {}
    # what buckles without it may stand with it, and what stands may not
    of_whole = list(_limits_of(design.whole, sizes, requirement, scene, model, near))
    try:
        found = list(_limits_of(design, sizes, requirement, scene, model, near))
    except Buckled as buckled:
        names = ", ".join(sorted(name.key for name in design.omitted))
        raise NotAvailable(f"buckles without {names}, which is switched off") from buckled
    for limit in of_whole:
        between, worst = assess.span(limit._replace(tolerance=None)), whole.get(limit.name)
        if limit.name not in whole or (worst and (not between or between < worst)):
            whole[limit.name] = between
    finite = {limit.name for limit in found if isfinite(_factor(limit))}
    for limit in found:
        # no demand has no range of its own: others of its check tell it
        told = isfinite(_factor(limit)) or limit.name not in finite
        error = _with_whole(limit, whole.get(limit.name)) if told else limit.known
        yield limit._replace(error=error)


def _factor(limit: Limit) -> float:
    plain = limit._replace(tolerance=None)
    return assess.factor(plain, float(limit.demand), float(limit.capacity))


def _with_whole(limit: Limit, whole: tuple[float, float] | None) -> ErrorRange | None:
    """Return the error of a limit by which its factor reaches to those of the whole design."""
    own, found = assess.span(limit._replace(tolerance=None)), _factor(limit)
    if own == whole:
        return limit.known
    if own is None or whole is None:
        return None
    low, high = min(own[0], whole[0]), max(own[1], whole[1])
    if not (low > 0.0 and isfinite(found)):
        return None
    if limit.in_capacity:
        return ErrorRange(low / found - 1.0, high / found - 1.0)
    return ErrorRange(found / high - 1.0, found / low - 1.0)


def _limits_of(
    design: DesignSpec,
    sizes: Sizes,
    requirement: Requirement,
    scene: Scene,
    model: NamedModel,
    near: tuple[DesignSpec, Sizes] | None,
) -> Iterator[Limit]:
    """Yield the limits of a design as it is felt, each with the error of its model."""
    ask = design.ask(scene, sizes, model.joint_model)
    if near is not None:
        known, at = near
        ask = ask._replace(near=known.ask(scene, at, model.joint_model))
    yield from _known(design, ask, requirement.limits(ask))


def _known(design: DesignSpec, ask: Ask, limits: Iterable[Limit]) -> Iterator[Limit]:
    """Yield limits, each with the error of its number, and of the material's."""
    errors: dict[QuantityKind, ErrorRange | None] = {}
    for limit in limits:
        kind, error = limit.kind, limit.known
        if kind is None:
            yield limit
            continue
        # the joint's own number: what is at a stroke brings its error
        is_at_rest = limit.error is ErrorOf.MODEL
        if is_at_rest:
            if kind not in errors:  # one for all places of a stress
                errors[kind] = ask.joint_model.error(ask, kind)
            error = errors[kind]
        if error is not None:
            beside_plane = bool(ask.scene.across_by) and not (is_at_rest and kind in OF_PLANE)
            in_space = design.geometry.in_space or beside_plane
            doubted = partial(
                ask.doubted, error, kind, in_space=in_space, is_directed=limit.is_directed,
                is_own=is_at_rest,
            )  # fmt: skip
            error = doubted()
            # plates of crystals take their time: where their bounds decide nobody needs them
            if is_at_rest and ask.material.planes and _is_open(limit._replace(error=error)):
                error = doubted(at_rest=True)
        if error is not None and limit.strengths:
            error = ask.material.weakened(error, limit.strengths)
        yield limit._replace(error=error)


def _is_open(limit: Limit) -> bool:
    """Return whether the error of a limit leaves it undecided."""
    return assess.verdict(assess.span(limit), assess.required(limit)) is Verdict.UNDECIDED


def _overborne(checks: Mapping[str, Check], least_stress: Callable[[], float]) -> dict[str, Check]:
    """Return the open checks of a strength that fail by the equilibrium of the loads alone."""
    open_ = {name: c for name, c in checks.items() if c.verdict is Verdict.UNDECIDED}
    least = least_stress() if open_ else 0.0
    found = {}
    for name, check in open_.items():
        most = check.capacity / least if least else inf
        if most < check.required * (1.0 - SURE):
            found[name] = check._replace(
                quantity="mean stress of the sections that bear the force, at least",
                demand=least, factor=most, factor_range=(0.0, most), verdict=Verdict.FAIL,
                source="equilibrium: the force over the thinnest sections of all blades there",
            )  # fmt: skip
    return found


def _no_answer(
    requirement: Requirement, scene: Scene, reason: str, model: str, seconds: float
) -> Check:
    """Return the row of a requirement that no model could answer, with the reason."""
    row = _open_row(requirement, scene, f"no model has an answer: {reason}")
    return row._replace(model=model, seconds=seconds)


def _not_done(requirement: Requirement, scene: Scene) -> Check:
    return _open_row(requirement, scene, "not judged: the run was stopped before")


def _open_row(requirement: Requirement, scene: Scene, text: str) -> Check:
    case = requirement.case_of(scene)
    asked = requirement.factor if isinstance(requirement, FactorRequirement) else nan
    return Check(requirement.label, case, text, nan, nan, "", nan, asked, Verdict.UNDECIDED, "")


def _buckles(check: Check, buckled: Buckled) -> Check:
    """Return the row of a requirement that fails, for the loads of its case buckle the joint."""
    share = buckled.share
    return check._replace(
        quantity="the joint buckles under this share of the loads of the case",
        demand=1.0, capacity=share, unit="", factor=share, factor_range=buckled.between,
        verdict=Verdict.FAIL, source="loss of stability on the path of the loads",
    )  # fmt: skip


def _together(requirement: Requirement, checks: Sequence[Check]) -> Iterator[Check]:
    """Yield the check of what several cases use up together: the sum of their damages (Miner).

    The worst places of the cases count as if they were one.
    """
    rows = assess.worst_of_each(checks)
    if len(rows) < 2:
        return
    names, nobody = ", ".join(row.case for row in rows), any(isnan(row.factor) for row in rows)
    damage = nan if nobody else sum(1.0 / row.factor for row in rows)
    ranges = [row.factor_range for row in rows if row.factor_range is not None]
    error = None
    if len(ranges) == len(rows) and 0.0 < damage < inf and all(low > 0.0 for low, _ in ranges):
        least, most = (sum(1.0 / each[end] for each in ranges) for end in (1, 0))
        error = ErrorRange(least / damage - 1.0, most / damage - 1.0)
    text = f"damage of {names} together"
    if nobody:
        text = f"{text} is not known: one of them has no life"
        yield Check(requirement.label, "", text, nan, nan, "", nan, nan, Verdict.UNDECIDED, "",
                    path=rows[0].path)  # fmt: skip
        return
    source = "damages add up (Miner), the worst places of the cases taken as one"
    limit = Limit(
        requirement.label, "", text, damage, 1.0, "", source,
        required=rows[0].required, kind=QuantityKind.RESPONSE, error=error,
    )  # fmt: skip
    for check in assess.checks([limit]):
        yield check._replace(path=rows[0].path, model=rows[-1].model)


def _not_judged(scene: Scene, looked_at: set[LoadKind], joint: Geometry) -> Iterator[Check]:
    """Yield a row for each load of a case that no requirement looks at."""
    lacking = joint.layout_lacks
    for kind in LoadKind:
        if kind in scene.loads and kind not in looked_at:
            text = f"no requirement looks at this load; {WOULD_LOOK[kind]} would"
            if lacking and kind in OUT_OF_PLANE:
                text += f", given {' and '.join(f'geometry.{key}' for key in lacking)}"
            elif not joint.has_plane:
                text += _but_not_in_space(joint)
            yield Check(
                kind.value, scene.case, text, nan, nan, "", nan, nan, Verdict.NOT_JUDGED, "",
                path=("cases", scene.case, kind.value),
            )  # fmt: skip


def _but_not_in_space(joint: Geometry) -> str:
    """Return why a joint without a plane has no model in space either, if it has none."""
    try:
        joint.space_layout(ANY, joint.probe())
    except NotAvailable as error:
        return f", but a {joint.name} {error}"
    return ""


def _switched_off(design: DesignSpec, case: str) -> Iterator[Check]:
    """Yield a row for each load of a case that the spec's effects leave out of it."""
    for effect, key in design.switched_off(case):
        text = f"effects: {{{effect}: off}} leaves this load out; nobody has looked at it"
        yield Check(
            key, case, text, nan, nan, "", nan, nan, Verdict.NOT_JUDGED, "",
            path=("effects", effect),
        )  # fmt: skip
