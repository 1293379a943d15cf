"""The response of a structure over the range of its uncertain stiffness and masses."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import inf, pi
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.stress_places import SAMPLED, is_uneven
from flexcli.numerics.modes import natural_modes
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.mechanisms.carried import carried
from flexcli.parts.own_motion import DENSEST, structure_of
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.stand_in import STAND_IN
from flexcli.parts.structure import Answer, Structure, largest_of
from flexcli.results import EXACT, ErrorRange, QuantityKind, error_of_ratio

if TYPE_CHECKING:
    from flexcli.parts.strained_compliance import BentBeside

__all__ = ["Uncertain", "between", "compounded", "pushed", "uncertain_structure"]

Floats = NDArray[np.float64]

STEPS = 5
"""Stiffnesses between both ends of the range: the response has no narrower features between the
frequencies at which the excitation changes, which are added."""

SOFTENED = 12
"""Steps of what blades that are bent give way along themselves."""

TINY = 1e-3
"""Share by which they do that no response notices."""

HALVED = 16
"""Times that the stroke is halved at which a mode meets a frequency: its resonance is wider."""

MOST_MODES = 8
"""Lowest modes that are moved onto each such frequency."""

MOST_FACTORS = 64
"""Most stiffnesses that put a mode onto such a frequency, evenly among the points of a density."""


@dataclass(frozen=True, eq=False)
class Uncertain:
    """A structure by the model asked, others within its uncertainty, and the error that remains.

    ``others`` is None where the uncertainty is unknown.
    """

    structure: Structure
    others: tuple[Structure, ...] | None
    shape_error: Callable[[Answer, float], ErrorRange | None] = lambda *_: ErrorRange(0.0, 0.0)
    """Further error of the stress of a response, at a share of its peaks, by the shapes of its
    modes."""
    stiffer: tuple[float, float] | None = None
    """Range of the factor on all of its stiffness, where nothing else of it is uncertain."""
    is_bounded: bool = True
    """Whether its response is linear: else its own peaks push blades so far that it may be any
    larger."""
    on_way: tuple[Structure, ...] = ()
    """Those of the others that a stroke passes on its way, resonances among them."""

    def of(self, answer: Answer) -> dict[str, tuple[float, ErrorRange | None]]:
        """Return each number of a response with the range of its error over all structures."""
        found = answer(self.structure)
        if self.others is None:
            return {name: (value, None) for name, value in found.items()}
        everywhere = [found, *(answer(other) for other in self.others)]
        return {
            name: (value, self.opened(between(value, [each[name] for each in everywhere])))
            for name, value in found.items()
        }

    def beside_beams(self, answer: Answer) -> ErrorRange:
        """Return the error of the stress of hinges by what forces across them do beside beams."""
        off = 0.0
        for each in (self.structure, *(self.others or ())):
            if not each.unsure:
                continue
            rows = {f"unsure {k} {joint}": rows for (joint, k), rows in each.unsure.items()}
            rows |= {f"stress {joint}": each.outputs[f"stress {joint}"] for joint, _ in each.unsure}
            peaks, whole = answer(replace(each, outputs=rows)), dict[str, float]()
            for joint, k in each.unsure:
                whole[joint] = whole.get(joint, 0.0) + peaks[f"unsure {k} {joint}"]
            for joint, doubt in whole.items():
                if doubt > 0.0:
                    off = max(off, doubt / peaks[f"stress {joint}"])
        return ErrorRange(-min(off, 1.0), off)

    def opened(self, error: ErrorRange | None) -> ErrorRange | None:
        """Return the error of a peak, which without a bound has none from above."""
        return error if error is None or self.is_bounded else error._replace(high=inf)

    def stress_error(
        self, ask: Ask, peak: float, answer: Answer, reached: float = 1.0
    ) -> ErrorRange | None:
        """Return the error of the stress at a peak of the driven motion, beside that of the peak.

        ``answer`` gives the peaks of a structure, of which a share is ``reached``.

        The stress of the modes is linear in the motion; the model gives the static stress at that
        motion, with an error of its own.
        """
        mechanism, structure = ask.mechanism, self.structure
        ratio = mechanism.joint_travel_per_motion if mechanism is not None else 1.0
        peak *= reached
        scene = ask.scene.without_loads()._replace(travel=peak * ratio, mean_travel=0.0, middle=0.0)
        held = ask._replace(scene=scene)
        shapes = compounded(self.shape_error(answer, reached), self.beside_beams(answer))
        error = compounded(ask.joint_model.error(held, QuantityKind.STRESS), shapes)
        if error is None or structure.motion is None or peak == 0.0:
            return error
        still = np.linalg.solve(structure.stiffness, structure.motion) * structure.motion_stiffness
        rows = [rows for name, rows in structure.outputs.items() if name.startswith("stress")]
        linear = max(_largest(each @ still) for each in rows) * peak
        try:
            _, stresses = ask.joint_model.stresses(held)
        except (NotAvailable, SolveError):
            return None
        off = max(abs(float(stress.largest)) for stress in stresses) / linear - 1.0
        return compounded(error, ErrorRange(min(off, 0.0), max(off, 0.0)))


def _largest(at_places: Floats) -> float:
    """Return the largest value, of components at a place the root of their squares."""
    each = np.abs(at_places) if at_places.ndim == 1 else np.linalg.norm(at_places, axis=-1)
    return float(each.max())


def pushed(ask: Ask, found: Uncertain, answer: Answer, frequencies: tuple[float, ...]) -> Uncertain:
    """Return a mechanism over what bends and pushes its blades beside small vibration.

    Without a bound from above where peaks push blades by as much as buckles them, or nearly.
    """
    from flexcli.parts.requirements import pushed_by_peaks as beside

    if found.others is None:
        return found
    changed = beside.pushed_by_peaks(ask, found.structure, answer, found.on_way)
    bent = beside.bent_by_motion(ask, found.structure, answer)
    if changed is None or bent is None:
        return replace(found, stiffer=None, is_bounded=False)
    if changed != EXACT:
        found = uncertain_structure(ask, frequencies, changed)
    return found if bent == beside.STRAIGHT else _bent(found, bent, answer)


def _bent(found: Uncertain, bent: "BentBeside", answer: Answer) -> Uncertain:
    """Return a mechanism whose blades are bent: softer along them, and bent further by that force.

    At one of both faces it adds to the stress. In space, where stresses are not told apart, all of
    a stress is taken to be of that force.
    """
    assert found.others is not None  # it is known
    structure, along = found.structure, 1.0
    shares = [bent.softer * (k / SOFTENED) ** 2 for k in range(1, SOFTENED + 1)]
    if not structure.wrenches:
        softened = [structure.stiffened(1.0 / (1.0 + share)) for share in shares]
    else:
        softened = [structure.softened_along(share) for share in shares]
        along = max(largest_of(answer(each), "axial") for each in (structure, *softened))
        along /= largest_of(answer(structure), "stress") or inf
    off, inner = bent.stressed * along, found.shape_error
    return replace(
        found,
        others=(*found.others, *softened),
        shape_error=lambda peaks, reached: compounded(inner(peaks, reached), ErrorRange(0.0, off)),
        stiffer=found.stiffer if bent.softer <= TINY else None,
    )


def uncertain_structure(
    ask: Ask, frequencies: tuple[float, ...], changed: ErrorRange = EXACT
) -> Uncertain:
    """Return the mechanism of a case by the model asked, with its range of stiffness and mass.

    Its stiffness is that of the blades times the model's correction of the driven motion. Over the
    range of that number the modes move; every one in reach is put on each of the ``frequencies``
    [Hz] at which the excitation changes, so that no resonance is missed. All of its stiffness may
    be ``changed`` by as much as well.

    Raises
    ------
    RequirementError
        When nothing that moves has a mass, or the joint is not made of blades in a plane.

    """
    ask = ask._replace(scene=ask.scene.at_assembly())  # what heat strains is judged beside it
    if ask.scene.vibrates_in_space:
        return _in_space(ask, frequencies, changed)
    geometry, elastic, sizes, scene = ask.geometry, ask.material.elastic, ask.sizes, ask.scene
    density = ask.material.density

    def made(rho: float) -> Structure:
        return structure_of(ask.mechanism, geometry, elastic, sizes, scene.lock, rho)

    try:
        plain = made(0.0 if density is None else density.value)
        heavy = made(DENSEST) if density is None else None
        joint = carried(geometry, elastic, sizes).motion_stiffness
    except MechanismError as error:
        raise RequirementError(str(error), error.hint) from error
    except NotAvailable as error:
        hint = "draw it as a space-layout, whose modes are known"
        raise RequirementError(f"a {geometry.name} {error}", hint) from error
    stands_in = ask.joint_model is STAND_IN  # its stiffness is a number, no joint's
    factor = 1.0 if stands_in else float(ask.joint_model.stiffness(ask)) / joint
    bases = [plain] if heavy is None else [plain, heavy]
    stressed: float | None = 0.0
    on_way = list[Structure]()
    beside = _stiffened_by_loads(ask)
    if not stands_in and beside is not None and _stands_bent(ask):
        from flexcli.parts.modes_at_stroke import structures_at_stroke, unlike_beams
        from flexcli.parts.requirements.pushed_by_peaks import bent_by_stroke

        ways = structures_at_stroke(ask, bases)
        stressed = bent_by_stroke(ask) if ways is None else unlike_beams(ask)
        if ways is not None:
            on_way = [each.stiffened(factor) for each in _on_their_ways(ways, frequencies, factor)]
            bases = [*(way[-1] for way in ways), *bases]
    structure = bases[0].stiffened(factor)
    off = ask.joint_model.error(ask, QuantityKind.STIFFNESS)
    if off is None or beside is None or geometry.has_limbs(elastic, sizes):
        return Uncertain(structure, None)
    ends = [factor * (1.0 + a) * (1.0 + b) for a, b in zip(off, beside, strict=True)]
    if _leaves_its_motion(ask) or on_way:
        # what stretches the blades is no softer or stiffer by their width, but by their clamps
        least, most = map(float, ask.geometry.crossed(ask.sizes))
        ends += [most, least / (1.0 + ask.clamp_softening)]
    flat = 0.0
    if ask.scene.standing is not None:
        from flexcli.parts.requirements.pushed_by_peaks import flattened_by_stroke

        flat = flattened_by_stroke(ask, plain)
    low = max(min(ends), 0.0) * (1.0 + changed.low)
    high = max(ends) * (1.0 + changed.high) * (1.0 + flat)
    if low <= 0.0 or high == inf:
        return Uncertain(structure, None)
    others = list(on_way)
    for base in bases:
        onto = sorted(set(_onto(base, frequencies, low, high)))
        chosen = {*np.linspace(low, high, STEPS).tolist(), *onto[:: 1 + len(onto) // MOST_FACTORS]}
        others += [base.stiffened(each) for each in sorted(chosen)]
    stiffer = (low / factor, high / factor) if len(bases) == 1 and stressed == 0.0 else None
    blades = geometry.blades_layout(elastic, sizes).blades
    uneven = any(is_uneven(blade) for blade in blades)
    more = ErrorRange(0.0, (1.0 + (stressed or 0.0)) * (1.0 + SAMPLED * uneven) - 1.0)
    return Uncertain(
        structure, tuple(others), lambda *_: more, stiffer, stressed is not None, tuple(on_way)
    )


def _on_their_ways(
    ways: Sequence[Sequence[Structure]], frequencies: tuple[float, ...], factor: float
) -> Iterator[Structure]:
    """Yield structures on the ways of a stroke to its ends, and those whose modes meet frequencies.

    Their stiffness is so many times as large by a ``factor``, without which they are given.
    """
    met = list[tuple[Structure, Structure, int, float]]()
    for way in ways:
        yield from way[:-1]
        modes = [_frequencies(each, factor) for each in way]
        for k in range(len(way) - 1):
            for mode, both in enumerate(zip(modes[k], modes[k + 1], strict=False)):
                met += [
                    (way[k], way[k + 1], mode, frequency)
                    for frequency in frequencies
                    if min(both) < frequency < max(both)
                ]
    for one, other, mode, frequency in met[:: 1 + len(met) // MOST_FACTORS]:
        rises = _frequencies(one, factor)[mode] < frequency
        low, high = 0.0, 1.0
        for _ in range(HALVED):
            share = (low + high) / 2.0
            before = (_frequencies(one.mixed(other, share), factor)[mode] < frequency) == rises
            low, high = (share, high) if before else (low, share)
        yield one.mixed(other, (low + high) / 2.0)


def _frequencies(structure: Structure, factor: float) -> Floats:
    """Return the lowest frequencies of a structure of so many times its stiffness [Hz]."""
    modes = natural_modes(factor * structure.stiffness, structure.mass)
    return modes.angular[:MOST_MODES] / (2.0 * pi)


def _in_space(ask: Ask, frequencies: tuple[float, ...], changed: ErrorRange) -> Uncertain:
    """Return a mechanism that moves in space, over the range of its springs and masses."""
    from flexcli.parts.space_vibration import likely_structures, shape_error

    stands_in = ask.joint_model is STAND_IN
    try:
        joint, own, others, (low, high) = likely_structures(
            ask.mechanism, ask.geometry, ask.material, ask.sizes, 0 if stands_in else STEPS,
            ask.scene.lock,
        )  # fmt: skip
    except NotAvailable as error:
        hint = "draw it as a space-layout, or take z out of the case"
        raise RequirementError(f"a {ask.geometry.name} {error}", hint) from error
    beside = _stiffened_by_loads(ask)
    if beside is None:
        others = None
    if others is not None and beside is not None:
        low *= (1.0 + beside.low) * (1.0 + changed.low)
        high *= (1.0 + beside.high) * (1.0 + changed.high)
        others += tuple(own.stiffened(end) for end in dict.fromkeys((low, high)))
        onto = sorted(set(_onto(own, frequencies, low, high)))
        others += tuple(own.stiffened(f) for f in onto[:: 1 + len(onto) // MOST_FACTORS])
        others += (own.stiffened(1.0 / (1.0 + ask.clamp_softening)),)
    return Uncertain(own, others, partial(shape_error, joint, own, ask.scene.shaken_axes))


def _stands_bent(ask: Ask) -> bool:
    """Return whether a stroke stands beside a vibration.

    One of the mechanism's own motion alone moves blades that are bent along themselves as well.
    """
    return ask.scene.standing is not None and ask.scene.standing.moves


def _stiffened_by_loads(ask: Ask) -> ErrorRange | None:
    """Return by what share static loads beside a vibration change stiffnesses; None if by much."""
    scene = ask.scene.standing
    if scene is None or not (any(scene.stated) or any(map(any, scene.inertial))):
        return EXACT
    from flexcli.parts.space_joint import joint_of
    from flexcli.parts.space_states import acting_groups
    from flexcli.parts.strained_compliance import changed_beside

    try:
        joint = joint_of(ask._replace(scene=scene))
        driven = not (ask.scene.vibrates_in_space or _leaves_its_motion(ask))
        softer = changed_beside(joint, scene, acting_groups(joint, scene), driven=driven)
    except NotAvailable:  # no shear modulus
        return None
    return error_of_ratio(EXACT, softer)


def _leaves_its_motion(ask: Ask) -> bool:
    """Return whether the base shakes more than the mechanism's own motion."""
    scene, axes = ask.scene, ask.scene.shaken_axes
    turns = ask.geometry.motion == "rotation" and getattr(ask.mechanism, "joints", 1) == 1
    return scene.lock is not None or "y" in axes or turns or not ask.geometry.closed_forms


def _onto(
    structure: Structure, frequencies: tuple[float, ...], low: float, high: float
) -> Iterator[float]:
    """Yield factors on the stiffness that put a mode onto one of the frequencies."""
    if not frequencies:
        return
    modes = natural_modes(structure.stiffness, structure.mass).angular[:MOST_MODES] / (2.0 * pi)
    for frequency in frequencies:
        for factor in (frequency / modes) ** 2:
            if low < factor < high:
                yield float(factor)


def compounded(one: ErrorRange | None, other: ErrorRange | None) -> ErrorRange | None:
    """Return the combined range of two relative errors; None where one is unknown."""
    if one is None or other is None:
        return None
    ends = [(1.0 + a) * (1.0 + b) - 1.0 for a in one for b in other]
    return ErrorRange(min(ends), max(ends))


def between(value: float, all_values: list[float]) -> ErrorRange | None:
    """Return the relative errors between which the true value lies; None for a value of zero."""
    if value == 0.0:
        return ErrorRange(0.0, 0.0) if not any(all_values) else None
    if not np.isfinite(all_values).all():
        return None
    return ErrorRange(min(all_values) / value - 1.0, max(all_values) / value - 1.0)
