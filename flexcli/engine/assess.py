"""Judge a blade by every requirement: one design into checks, or many at once into factors."""

from collections.abc import Iterable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import outside
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import MODEL_EFFECTS, Setting
from flexcli.parts.geometries import NotAvailable, Sizes
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements import CLOSED_FORM, Answers, Ask, Limit
from flexcli.results import Check, EffectRow, Note, Value
from flexcli.units import show

__all__ = [
    "ROUNDING",
    "case_values",
    "checks",
    "effects",
    "factor",
    "factors",
    "reported",
    "setting",
    "values",
    "warnings",
]

ROUNDING = 1e-9
"""A factor this little (relative) below the required one is rounding, not a failure: what a
sizing leaves when it puts a constraint exactly at its limit."""

NOTABLE = 0.05
"""An effect left out that may change a number by more than this is a warning, not only a row."""

STRENGTHS = ("admissible_stress", "fatigue_amplitude", "yield_strength")
"""What an admissible stroke is stated for: the first that the material gives."""

QUANTITY_OF = {
    "k_pivot": "stiffness",
    "k_stage": "stiffness",
    "k_eq": "stiffness",
    "k_least": "stiffness",
    "k_most": "stiffness",
    "theta_adm": "stress",
    "x_adm": "stress",
    "shift": "shift",
    "k_x": "sag",
    "k_y": "sag",
    "k_z": "sag",
    "sag": "sag",
    "f_0": "frequency",
    "f_init": "frequency",
    "f_final": "frequency",
}
"""Which of the quantities that effects change a value is, by the start of its name."""

DEFINED = ("volume", "delta", "xi", "theta_stroke", "x_stroke", "theta_mean", "x_mean")
"""Values that are what the spec says, in other words."""

CHUNK = 65_536
"""Designs per pass of :func:`factors`, which bounds its memory."""


def factor(limit: Limit, demand: float, capacity: float) -> float:
    """Return the factor of safety of one limit: capacity over demand, infinite for no demand.

    For a target it is the ratio of the smaller to the larger, 1 when met exactly.
    """
    if demand <= 0.0:
        return np.inf
    ratio = float(np.sign(capacity) * (abs(capacity) / demand) ** (1.0 / limit.power))
    return min(ratio, 1.0 / ratio) if limit.tolerance is not None and ratio > 0.0 else ratio


def required(limit: Limit) -> float:
    """Return the factor that a limit asks for."""
    return limit.required if limit.tolerance is None else 1.0 / (1.0 + limit.tolerance)


def checks(limits: Iterable[Limit]) -> tuple[Check, ...]:
    """Return one check for each requirement, case and variant, decided by its worst limit."""
    worst: dict[str, Check] = {}
    for limit in limits:
        root = 1.0 / limit.power
        demand, capacity = float(limit.demand), float(limit.capacity)
        found, asked = factor(limit, demand, capacity), required(limit)
        check = Check(
            name=limit.title,
            case=limit.case,
            quantity=limit.quantity,
            demand=max(demand, 0.0) ** root,
            capacity=float(np.sign(capacity)) * abs(capacity) ** root,
            unit=limit.unit,
            factor=found,
            required=asked,
            passed=found >= asked * (1.0 - ROUNDING),
            source=limit.source,
        )
        if limit.name not in worst or check.margin < worst[limit.name].margin:
            worst[limit.name] = check
    return tuple(worst.values())


def factors(design: DesignSpec, **sizes: NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    """Return margins of many designs at once: factor over required factor, per check.

    Parameters
    ----------
    design : DesignSpec
        The design whose sizes vary.
    **sizes : array
        Sizes by symbol (h, l, b of blades) [m]; broadcast against each other, and the fixed ones
        that are not given against them.

    Returns
    -------
    dict of array
        For each check the factor over the required one, in the broadcast shape: a design passes
        where all are at least 1.

    """
    given = design.geometry.sized(sizes)._asdict()
    shape = np.broadcast_shapes(*(np.shape(x) for x in given.values()))
    flat = {
        name: np.broadcast_to(np.asarray(x, dtype=np.float64), shape).reshape(-1)
        for name, x in given.items()
    }
    size = int(np.prod(shape))
    found: dict[str, NDArray[np.float64]] = {}
    for start in range(0, size, CHUNK):
        part = slice(start, start + CHUNK)
        for limit in design.closed_limits(
            design.geometry.sized({name: x[part] for name, x in flat.items()})
        ):
            margins = found.setdefault(limit.name, np.full(size, np.inf))
            np.minimum(margins[part], _margin(limit), out=margins[part])
    return {name: margins.reshape(shape) for name, margins in found.items()}


def _margin(limit: Limit) -> NDArray[np.float64]:
    demand = np.asarray(limit.demand, dtype=np.float64)
    capacity = np.asarray(limit.capacity, dtype=np.float64)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.where(demand > 0.0, np.abs(capacity) / demand, np.inf)
    ratio = np.copysign(ratio if limit.power == 1 else ratio ** (1.0 / limit.power), capacity)
    if limit.tolerance is not None:
        ratio = np.minimum(ratio, 1.0 / ratio)
    return np.asarray(ratio / required(limit))


def values(design: DesignSpec, sizes: Sizes, answers: Answers = CLOSED_FORM) -> dict[str, Value]:
    """Return the named numbers of a design by a model: sizes, cases, joint and mechanism."""
    geometry, material = design.geometry, design.material
    found = {
        name: Value(float(size), "m", geometry.label(name), model="given")
        for name, size in sizes._asdict().items()
    }
    found |= case_values(design)
    asks = [
        Ask(material, geometry, design.mechanism, sizes, design.scene(name), answers)
        for name in design.cases
    ]
    stiffness = float(answers.stiffness(asks[0]))
    symbol = "k_pivot" if geometry.motion == "rotation" else "k_stage"
    found[symbol] = Value(
        stiffness, geometry.stiffness_unit, "stiffness of a joint", answers.model, geometry.source
    )
    found["volume"] = Value(
        float(geometry.volume(sizes)), "m^3", "volume of what flexes in a joint"
    )
    found |= geometry.values(material.elastic, sizes, _largest_travel(design))
    found |= _admissible(design, sizes)
    for ask in asks:
        found |= _shift(ask, found)
    if design.mechanism is not None:
        found.update(design.mechanism.values(stiffness, geometry))
        if "f_0" in found:
            f_0, factor = found["f_0"], answers.frequency_factor(asks[0])
            found["f_0"] = f_0._replace(value=f_0.value * factor, model=answers.model)
        for ask in asks:
            found.update(_sag(ask))
    return found


def _admissible(design: DesignSpec, sizes: Sizes) -> dict[str, Value]:
    """Return the travel at which the stress reaches the strength that the material states."""
    geometry, material = design.geometry, design.material
    strength = next((name for name in STRENGTHS if getattr(material, name) is not None), None)
    if strength is None or not geometry.is_linear:
        return {}
    try:
        stresses = geometry.end_stresses(material.elastic, sizes, 1.0)
    except NotAvailable:
        return {}
    most = max(abs(float(stress)) for stress in stresses.values())
    symbol, unit = ("theta", "rad") if geometry.motion == "rotation" else ("x", "m")
    text = f"stroke at which the stress reaches the {strength.replace('_', ' ')}"
    return {f"{symbol}_adm": Value(material.strength(strength) / most, unit, text)}


def case_values(design: DesignSpec) -> dict[str, Value]:
    """Return what the cases ask of each joint; names that differ between cases end in theirs."""
    found: dict[str, Value] = {}
    for name in design.cases:
        for key, value in design.scene(name).values.items():
            found[key if key not in found or found[key] == value else f"{key}_{name}"] = value
    return found


def _shift(ask: Ask, known: Mapping[str, Value]) -> dict[str, Value]:
    """Return the parasitic shift at the end of a case's stroke, where the model has it."""
    if not ask.scene.bends:
        return {}
    try:
        shift = float(ask.answers.parasitic_shift(ask))
    except NotAvailable:
        return {}
    name = "shift" if "shift" not in known else f"shift_{ask.scene.case}"
    label = "parasitic shift at full stroke, positive towards the base"
    return {name: Value(shift, "m", label, ask.answers.model, ask.geometry.source)}


def _sag(ask: Ask) -> dict[str, Value]:
    """Return sag and stiffness along a steady acceleration, where the model has them."""
    scene = ask.scene
    if scene.acceleration == 0.0 or ask.mechanism is None:
        return {}
    try:
        stiffness = float(ask.answers.sag_stiffness(ask))
        weight = ask.mechanism.hanging_mass() * scene.acceleration
    except (NotAvailable, MechanismError):
        return {}
    source, axis, model = ask.geometry.source, scene.axis, ask.answers.model
    return {
        f"k_{axis}": Value(stiffness, "N/m", f"stiffness along {axis}", model, source),
        f"sag_{axis}": Value(weight / stiffness, "m", f"sag along {axis}", model, "m a / K"),
    }


def setting(design: DesignSpec, sizes: Sizes) -> Setting:
    """Return a design as effects are estimated on it."""
    scenes = tuple(design.scene(name) for name in design.cases)
    return Setting(design.material, design.geometry, design.mechanism, sizes, scenes, design.stops)


def reported(design: DesignSpec, given: Setting) -> tuple[str, ...]:
    """Return which numbers of the joint a design reports, of those that effects change."""
    asked = design.requirements
    shift = design.geometry.closed_forms and any(s.bends for s in given.scenes)
    held = any(s.blade_force for s in given.scenes)
    hangs = asked.sag is not None or any(s.acceleration for s in given.scenes)
    has = {
        "stiffness": True,
        "stress": bool(asked.fatigue or asked.yielding),
        "shift": shift,
        "buckling": asked.buckling is not None and held,
        "sag": design.mechanism is not None and hangs,
        "frequency": design.mechanism is not None,
    }
    return tuple(name for name, there in has.items() if there)


def effects(
    design: DesignSpec, sizes: Sizes, answers: Answers = CLOSED_FORM
) -> tuple[EffectRow, ...]:
    """Return the effects that this design can have, and which of them the model leaves out."""
    given = setting(design, sizes)
    names = reported(design, given)
    rows = []
    for effect in MODEL_EFFECTS:
        indicator = effect.indicator(given)
        if indicator is None:
            continue
        all_estimates = effect.estimates(given)
        estimates = {name: all_estimates[name] for name in names if name in all_estimates}
        most = max(estimates, key=lambda name: estimates[name], default="")
        reason = f"{indicator.text}; most in {most}" if most else indicator.text
        size = estimates.get(most, 0.0)
        carried = effect.name in answers.covers | answers.always
        rows.append(EffectRow(effect.name, carried, indicator.value, size, reason, estimates))
    return tuple(rows)


def left_out(rows: Iterable[EffectRow]) -> dict[str, float]:
    """Return the estimated error of each reported quantity: all together that is left out."""
    found: dict[str, float] = {}
    for row in rows:
        for name, estimate in row.estimates.items():
            found[name] = found.get(name, 0.0) + (0.0 if row.on else estimate)
    return found


def with_errors(values: Mapping[str, Value], errors: Mapping[str, float]) -> dict[str, Value]:
    """Return values with their estimated errors, from those of the quantities they are of."""

    def error(name: str, value: Value) -> float | None:
        if value.model == "given" or name.startswith(DEFINED):
            return 0.0
        kind = next((k for start, k in QUANTITY_OF.items() if name.startswith(start)), "")
        return errors.get(kind)

    return {name: v._replace(estimated_error=error(name, v)) for name, v in values.items()}


def warnings(design: DesignSpec, sizes: Sizes, rows: tuple[EffectRow, ...]) -> tuple[Note, ...]:
    """Return what a reviewer must know beside the margins."""
    notes: list[Note] = []
    if design.mechanism is not None:
        notes.extend(design.mechanism.notes())
    placeholders = design.material.placeholders()
    if placeholders:
        text = f"placeholder values, not physical: material.{', material.'.join(placeholders)}"
        notes.append(Note("placeholder-material", text))
    if design.requirements.fatigue is not None:
        single = design.material.fatigue_amplitude
        if single is not None and single.stress_ratio is None:
            text = "the source of the fatigue amplitude states no stress ratio; read as R = −1"
            notes.append(Note("stress-ratio-unstated", text))
    notes.extend(_outside_validity(design, sizes))
    notes.extend(
        Note("effect-left-out", f"{row.name}, left out, may change results by {row.estimate:.0%}")
        for row in rows
        if row.estimate >= NOTABLE and not row.on
    )
    return tuple(notes)


def _largest_travel(design: DesignSpec) -> float:
    scenes = [design.scene(name) for name in design.cases]
    return max((scene.travel + scene.mean_travel for scene in scenes), default=0.0)


def _outside_validity(design: DesignSpec, sizes: Sizes) -> Iterator[Note]:
    """Yield where the design leaves the range in which its closed forms hold."""
    geometry = design.geometry
    at = geometry.indicators(sizes, _largest_travel(design))
    for limits in outside(geometry.validity, {name: float(x) for name, x in at.items()}):
        text = f"{limits.quantity} = {show(float(at[limits.quantity]), limits.unit)} is outside "
        yield Note("outside-validity", f"{text}{limits.spoken}: {limits.why}")
