"""The judgement of a design with end stops: what its cases do between the stops."""

from flexcli.engine.judge import Judgement
from flexcli.engine.stopping.choice import choose
from flexcli.engine.stopping.judge import judge_stops, looked_at, shakes
from flexcli.engine.stopping.statics import task_of
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements.dynamic import DynamicLife, DynamicYield
from flexcli.parts.scene import LoadKind
from flexcli.results import Check, Verdict, with_seconds

__all__ = ["between_stops"]


def between_stops(
    found: Judgement, design: DesignSpec, sizes: Sizes, model: str | None = None
) -> Judgement:
    """Return the judgement of a design with what its stops change; as it is where it has none.

    The stops' own limits come in addition, each by the line or a simulation. The stress under
    vibration is that between the stops, the life there is undecided, and a sine or sweep that
    only stops look at is judged. A model that is insisted on simulates nothing.
    """
    if design.stops is None:
        return found
    task = task_of(design, design.stops, sizes)
    pinned = model or design.model
    stopped = judge_stops(
        design, task, sizes, choose(task).place,
        simulate=pinned is None, with_requirements=True,
    )  # fmt: skip
    touching = {name for name, case in design.cases.items() if shakes(case)}
    ran = {run.case for run in stopped.simulations}
    untouched = ran - {run.case for run in stopped.simulations if run.contacts}
    kept = []
    for check in found.checks:
        if check.case in touching and check.name == DynamicYield.label:
            continue
        if check.verdict is Verdict.NOT_JUDGED and _is_seen(design, check):
            continue
        # the damage of all cases together has no case of its own
        touched = touching - untouched
        touched |= {""} if touched else set()
        is_life = check.case in touched and check.name == DynamicLife.label
        kept.append(_without_stops(check) if is_life else check)
    by_model = dict(found.by_model)
    for name, seconds in stopped.by_model.items():
        by_model = with_seconds(by_model, name, seconds)
    # rows that only say of statics which model made them have no seconds of their own
    for check in stopped.checks:
        by_model.setdefault(check.model, 0.0)
    return found._replace(checks=(*kept, *stopped.checks), by_model=by_model)


def _is_seen(design: DesignSpec, check: Check) -> bool:
    """Return whether the load that a row says nobody looks at is one that stops look at."""
    return LoadKind(check.name) in looked_at(design.cases[check.case])


def _without_stops(check: Check) -> Check:
    """Return the check of a life left open: it is that of the blade without its stops."""
    text = f"{check.quantity}, without the stops that it meets: no life is known between them"
    return check._replace(quantity=text, verdict=Verdict.UNDECIDED, factor_range=None)
