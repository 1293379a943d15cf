"""The verb balance: what the motion of its base does to a mechanism, before and after balancing."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from time import perf_counter

from flexcli.engine import assess, omitted_effects
from flexcli.engine import values as design_values
from flexcli.engine.balancing.base_motion import (
    gravity_rows,
    reaction_values,
    sag_values,
    suffix,
    transfer_rows,
    vibration_values,
)
from flexcli.engine.balancing.coupling_tolerance import coupling_terms, tolerance_values
from flexcli.engine.balancing.freedom import Freedom, freedoms
from flexcli.engine.balancing.over_stroke import over_stroke, shift_coupling
from flexcli.engine.judge import status_of
from flexcli.errors import SolveError
from flexcli.formulas.transfer import natural_frequency
from flexcli.parts.balancing import BalanceOptions
from flexcli.parts.design import DesignSpec
from flexcli.parts.mechanisms import Mechanism, MechanismError
from flexcli.parts.mechanisms.force_balance import Balancing
from flexcli.parts.mechanisms.parallel_stage import ParallelStage
from flexcli.parts.requirements import AS_PRINTED
from flexcli.results import Check, Cost, Note, QuantityKind, Result, Status, Value
from flexcli.results.balance import BalanceResult, CouplingTerm, UnknownResult

__all__ = ["balance"]

MODEL = "rigid bodies on linear springs"

SOURCE = "Lagrange's equation of the bodies; exercise 9 part I"

NOTABLE = 0.01
"""Part of the coupling before balancing that is worth a note when it comes back."""

DIFFERS = 0.01
"""Part of the blades' stiffness by which a stated one may differ before a note says so."""


def balance(design: DesignSpec, spec: str) -> Result:
    """Return couplings, equivalent masses, transfer functions and what small angles hide."""
    started = perf_counter()
    mechanism = design.mechanism
    if mechanism is None:
        raise SolveError("no-mass", "nothing that moves has a mass", "add a mechanism")
    if not design.geometry.closed_forms:
        text = f"a {design.geometry.name} has no closed forms to be balanced by"
        raise SolveError("no-closed-forms", text, "take a joint of the catalogue")
    try:
        states = freedoms(design, mechanism)
    except MechanismError as error:
        raise SolveError("no-freedom", str(error), error.hint) from error
    stage = mechanism if isinstance(mechanism, ParallelStage) else None
    options = _options(design)
    stroke = _stroke(design)
    terms = coupling_terms(stage.stage(), options.tolerances) if stage else ()
    values = _mechanism_values(design, mechanism, states)
    residuals = _residuals(design, stage, terms, values)
    values |= residuals
    if options.asd is not None:
        left = {name.removeprefix("tau_"): value.value for name, value in residuals.items()}
        values |= vibration_values(states, options.asd, left)
    values |= design_values.case_values(map(design.scene, design.cases))
    values |= reaction_values(states)
    checks = assess.checks(design.coupling_limits())
    quality = _quality(design, mechanism)
    gravity = gravity_rows(states, options.gravity, stroke)
    if stage is None:
        values |= sag_values(gravity, states[-1])
    solved = stage.balancing if stage else None
    sizes = design.fixed_sizes()
    known = sizes is not None
    errors = omitted_effects.errors_of(design, sizes, AS_PRINTED, values) if known else {}
    return Result(
        command="balance",
        spec=spec,
        status=_status(solved, checks),
        title=design.title,
        values=design_values.with_errors(values, errors),
        checks=checks,
        warnings=tuple(_notes(stage, states, stroke, values)),
        cost=Cost(perf_counter() - started, MODEL, max(errors.values(), default=None)),
        balance=BalanceResult(
            outcome=_outcome(solved),
            motion=mechanism.shaken_by(design.geometry),
            output_unit="rad" if states[-1].base_turns else "m",
            reason=solved.reason if solved else "",
            remedy=solved.remedy if solved else "",
            stroke=stroke or None,
            quality=quality,
            unknowns=_unknowns(solved),
            transfer=transfer_rows(states, options.asked(), quality),
            over_stroke=over_stroke(states, stroke),
            sensitivities=terms,
            gravity=gravity,
        ),
    )


def _stroke(design: DesignSpec) -> float:
    """Return the farthest that the joints travel in any case [rad or m]."""
    scenes = design.scenes()
    return max((scene.travel + scene.mean_travel for scene in scenes), default=0.0)


def _mechanism_values(
    design: DesignSpec, mechanism: Mechanism, states: Sequence[Freedom]
) -> dict[str, Value]:
    """Return what is balanced, masses, coupling, stiffness and frequencies."""
    after = states[-1]
    if isinstance(mechanism, ParallelStage):
        found = mechanism.balance_values() | mechanism.mass_values()
    else:
        unit = "kg*m^2" if after.base_turns else "kg"
        found = {
            "m_eq": Value(after.m, unit, "equivalent mass", source=SOURCE),
            "tau_coupling": Value(after.coupling, unit, "coupling to the base", source=SOURCE),
        }
    if after.k is None:
        return found
    found |= _stiffness_values(design, mechanism)
    unit = "N*m/rad" if after.base_turns else "N/m"
    found["k_eq"] = Value(
        after.k, unit, "equivalent stiffness", source=SOURCE, kind=QuantityKind.STIFFNESS
    )
    for state in states:
        frequency = natural_frequency(state.k or 0.0, state.m)
        words = f"frequency {state.mounted} balancing" if states[1:] else "natural frequency"
        found[f"f{suffix(state, states) or '_0'}"] = Value(
            frequency, "Hz", words, source=SOURCE, kind=QuantityKind.FREQUENCY
        )
    return found


def _stiffness_values(design: DesignSpec, mechanism: Mechanism) -> dict[str, Value]:
    """Return the stiffness of a joint by its blades, and of the pivots that the spec states."""
    found: dict[str, Value] = {}
    geometry, blade = design.geometry, design.fixed_sizes()
    if blade is not None:
        k = float(geometry.stiffness(design.material.elastic, blade))
        name = "k_pivot" if geometry.motion == "rotation" else "k_stage"
        text = "stiffness of a joint"
        found[name] = Value(
            k, geometry.stiffness_unit, text, source=geometry.source, kind=QuantityKind.STIFFNESS
        )
    stated = mechanism.pivot_stiffness if isinstance(mechanism, ParallelStage) else None
    for number, given in enumerate(stated or (), start=1):
        if given is not None:
            label = f"stiffness of pivot P{number}"
            found[f"k_{number}"] = Value(given, "N*m/rad", label, model="given")
    return found


def _residuals(
    design: DesignSpec,
    stage: ParallelStage | None,
    terms: Sequence[CouplingTerm],
    values: Mapping[str, Value],
) -> dict[str, Value]:
    if stage is None:
        return {}
    nominal = values["tau_coupling"].value
    return tolerance_values(stage.stage(), _options(design).tolerances, terms, nominal)


def _quality(design: DesignSpec, mechanism: Mechanism) -> float | None:
    """Return Q: as the mechanism states it, else as its vibration does."""
    if mechanism.damping is not None:
        return mechanism.damping.quality
    vibration = _options(design).asd
    return vibration.q.all if vibration is not None else None


def _options(design: DesignSpec) -> BalanceOptions:
    return design.balance or BalanceOptions()


def _status(solved: Balancing | None, checks: Iterable[Check]) -> Status:
    if solved is not None and not solved.met:
        return Status.INFEASIBLE
    return status_of(checks)


def _outcome(solved: Balancing | None) -> str:
    if solved is None or not solved.unknowns:
        return "nothing is free"
    return "solved" if solved.met else "infeasible"


def _unknowns(solved: Balancing | None) -> tuple[UnknownResult, ...]:
    if solved is None:
        return ()
    return tuple(
        UnknownResult(unknown.label, value, unknown.unit, *unknown.bounds)
        for unknown, value in zip(solved.unknowns, solved.found, strict=True)
    )


def _notes(
    stage: ParallelStage | None,
    states: Sequence[Freedom],
    stroke: float,
    values: Mapping[str, Value],
) -> Iterator[Note]:
    """Yield what a reviewer must know beside the numbers."""
    if states[-1].k is None:
        text = "neither the blades nor pivot-stiffness give a stiffness: no frequency, no T(ω)"
        yield Note("no-stiffness", text)
    if stage is None:
        return
    if any(unknown.kind in ("mass", "split") for unknown in stage.balancing.unknowns):
        text = "the inertia of a free balancing mass is as stated, whatever its mass"
        yield Note("inertia-as-stated", text)
    given = [k for k in stage.pivot_stiffness or () if k is not None]
    pivot = values.get("k_pivot")
    if pivot is not None and any(abs(k - pivot.value) > DIFFERS * pivot.value for k in given):
        text = "a stated pivot-stiffness differs from that of the blades; the stated one is used"
        yield Note("stiffness-differs", text)
    before = abs(values["tau_coupling_init"].value)
    worst = values.get("tau_worst")
    allowed = stage.coupling.max * before if stage.coupling is not None else 0.0
    if worst is not None and worst.value > allowed > 0.0:
        text = f"within its tolerances the stage may keep {worst.value / before:.2%}"
        yield Note("tolerances-exceed-coupling", f"{text} of its coupling")
    drift = shift_coupling(states[-1], stroke)
    if drift > NOTABLE * before > 0.0:
        text = (
            f"at full stroke the pivots' own parasitic shift may bring back {drift / before:.1%} "
            "of the coupling, where all shift alike; between equal sides, pivots that are mirrored "
            "from one to the other cancel it"
        )
        yield Note("pivot-shift", text)
