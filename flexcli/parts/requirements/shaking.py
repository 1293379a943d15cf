"""What shakes the base in a case, each as the peaks that a structure answers with."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from flexcli.parts.asd import RandomVibration
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.shock import Shock
from flexcli.parts.structure import Structure

if TYPE_CHECKING:
    from flexcli.parts.excitation import Sine, Sweep

__all__ = ["SHAKES", "PeakFactor", "Shaking", "corners_of", "quality_of", "shakings", "together"]

SHAKES = frozenset({LoadKind.ASD, LoadKind.SHOCK, LoadKind.SINE, LoadKind.SWEEP})
"""Loads of a case that the modes answer."""

FEW = 50
"""Points of a density that are all looked at."""

PeakFactor = Callable[[Scene, RandomVibration, float], float]
"""Peak over rms of a random response, from its rate of upward zero crossings [Hz]."""


class Shaking(NamedTuple):
    """One excitation: its key in the spec, what a structure answers, and how it is spoken of.

    ``changes_at`` are the frequencies at which it changes [Hz].
    """

    kind: LoadKind
    peaks: Callable[[Structure], Mapping[str, float]]
    changes_at: tuple[float, ...]
    source: str
    named: Callable[[Structure, str], str]
    hint: str = ""


def shakings(ask: Ask, factor: PeakFactor) -> Iterator[Shaking]:
    """Yield every excitation of a case.

    Raises
    ------
    RequirementError
        When nothing says how a sine is damped.

    """
    scene = ask.scene
    if scene.vibration is not None:
        yield _random(scene, scene.vibration, factor)
    if scene.shock is not None:
        yield _shock(scene.shock)
    if scene.sine is not None:
        Q = quality_of(ask.mechanism, scene)
        yield _sine(LoadKind.SINE, scene.sine, Q, (scene.sine.frequency,))
    if scene.sweep is not None:
        low, high = sorted((scene.sweep.start, scene.sweep.end))
        corners = (low, *scene.sweep.crossovers(low, high), high)
        yield _sine(LoadKind.SWEEP, scene.sweep, quality_of(ask.mechanism, scene), corners)


def together(found: Sequence[Shaking]) -> Sequence[Shaking]:
    """Return what a case's excitations do at once: their peaks may meet, and add up."""
    if len(found) < 2:
        return found
    kinds = [each.kind for each in found if each.kind is not LoadKind.ASD]

    def peaks(structure: Structure) -> dict[str, float]:
        each = [shaking.peaks(structure) for shaking in found]
        return {name: sum(one[name] for one in each) for name in each[0]}

    return [
        Shaking(
            kinds[0],
            peaks,
            tuple(sorted({at for each in found for at in each.changes_at})),
            " and ".join(each.source for each in found),
            lambda _structure, _name: f"{' and '.join(each.kind for each in found)} at once,",
            next((each.hint for each in found if each.hint), ""),
        )
    ]


def quality_of(mechanism: Mechanism | None, scene: Scene) -> float:
    """Return Q of the modes: as the mechanism states it, else as another load of the case does."""
    if mechanism is not None and mechanism.damping is not None:
        return mechanism.damping.quality
    for environment in (scene.vibration, scene.shock):
        if environment is not None:
            return environment.q
    raise RequirementError(
        f"nothing says how the modes are damped in case '{scene.case}'",
        "add mechanism.damping: {q: 100}",
    )


def _random(scene: Scene, vibration: RandomVibration, factor: PeakFactor) -> Shaking:
    from flexcli.parts.response import random_outputs

    def peaks(structure: Structure) -> dict[str, float]:
        return {
            name: factor(scene, vibration, output.crossing_rate) * output.rms
            for name, output in random_outputs(structure, vibration).items()
        }

    def named(structure: Structure, name: str) -> str:
        rate = random_outputs(structure, vibration)[name].crossing_rate
        return f"{factor(scene, vibration, rate):.3g}σ"

    return Shaking(
        LoadKind.ASD, peaks, corners_of(vibration), f"modal response, {vibration.told_q}", named
    )


def corners_of(vibration: RandomVibration) -> tuple[float, ...]:
    """Return the frequencies at which a density changes [Hz].

    A resonance sees a density over its bandwidth f/Q: of a measured one with many points the
    highest and the lowest in each quarter of it stand for the rest.
    """
    applied = vibration.applied()
    f, g = applied.frequency, applied.level
    if f.size <= FEW:
        return tuple(f.tolist())
    quarter = np.floor(4.0 * vibration.largest_q * np.log(f))
    highest = np.lexsort((g, quarter))  # within each quarter by rising level
    ends = np.diff(quarter[highest]) > 0.0
    chosen = np.concatenate([highest[np.append(ends, True)], highest[np.insert(ends, 0, True)]])
    return tuple(np.unique(f[chosen]).tolist())


def _shock(shock: Shock) -> Shaking:
    from flexcli.parts.response import shock_peaks

    return Shaking(
        LoadKind.SHOCK,
        lambda structure: shock_peaks(structure, shock),
        tuple(point.frequency for point in shock.srs),
        f"modal response to the shock, Q = {shock.q:g}",
        lambda _structure, _name: "peak",
        "extend the spectrum to the modes' frequencies",
    )


def _sine(
    kind: LoadKind, sine: "Sine | Sweep", Q: float, frequencies: tuple[float, ...]
) -> Shaking:
    from flexcli.parts.response import sine_peaks

    return Shaking(
        kind,
        lambda structure: sine_peaks(structure, sine.level, Q, frequencies),
        frequencies,
        f"steady modal response to the {sine.told}, Q = {Q:g}",
        lambda _structure, _name: "amplitude of",
    )
