"""The answer of ``flexure plan``: the plan of a design, audited where that is wished."""

from collections.abc import Iterator
from time import perf_counter

from flexcli.engine.plan import ACCURACY, plan
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements.shaking import SHAKES
from flexcli.results import Cost, Note, Result, Status, Value
from flexcli.results.plan import AuditRow, Plan

__all__ = ["planned"]

IN_NO_RESPONSE = ("stress stiffening", "large rotation")
"""Effects of a vibration's peaks on the modes themselves, which are those of small motion."""


def planned(
    design: DesignSpec, sizes: Sizes, spec: str, model: str | None, *, audit: bool
) -> Result:
    """Return the plan for given sizes, audited where that is wished."""
    started = perf_counter()
    notes = []
    if design.accuracy is None:
        text = f"the spec asks for no accuracy; planned for {ACCURACY:.0%}"
        notes.append(Note("accuracy-assumed", text))
    found = plan(design, sizes, model, ACCURACY)
    rows: tuple[AuditRow, ...] = ()
    if audit:
        rows = _audited(design, sizes, found)
    if any(design.scene(name).loads & SHAKES for name in design.cases):
        from flexcli.engine.planning.scene_models import scene_plans
        from flexcli.engine.planning.vibration_effects import vibration_effects

        found = found._replace(
            effects=(*found.effects, *vibration_effects(design, sizes)),
            scenes=tuple(scene_plans(design, sizes, found.accuracy)),
        )
        notes += _in_no_model(found)
    if design.stops is not None:
        from flexcli.engine.planning.stop_effects import stop_effects

        found = found._replace(effects=(*found.effects, *stop_effects(design, sizes)))
    wrong = any(row.right is False for row in rows)
    return Result(
        command="plan",
        spec=spec,
        status=Status.FAIL if wrong else Status.PASS,
        title=design.title,
        values={
            name: Value(float(x), "m", design.geometry.label(name), "given")
            for name, x in sizes._asdict().items()
        },
        effects=found.effects,
        warnings=(*notes, *found.notes),
        cost=Cost(perf_counter() - started, found.model, found.known_error),
        plan=found,
        audit=rows,
    )


def _in_no_model(found: Plan) -> Iterator[Note]:
    """Yield what the peaks of a vibration change by more than is asked, which no model has."""
    for row in found.effects:
        if row.name.startswith(IN_NO_RESPONSE) and row.estimate > found.accuracy:
            text = f"{row.name} may change {' and '.join(row.estimates)} by {row.estimate:.2g}"
            yield Note("effect-in-no-model", f"{text} of it; the modes of no model have it")


def _audited(design: DesignSpec, sizes: Sizes, found: Plan) -> tuple[AuditRow, ...]:
    """Return the audit of a plan, in its plane or in space."""
    if design.geometry.in_space:
        from flexcli.engine.planning.in_space import audit_in_space

        return audit_in_space(design, sizes, found)
    from flexcli.engine.planning.audit import audit

    return audit(design, sizes, found)
