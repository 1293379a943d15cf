"""The excitations of the base in a case, each with the peaks of a structure's response."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.parts.asd import AppliedASD, Vibration
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.shock import Shock
from flexcli.parts.structure import Structure

if TYPE_CHECKING:
    from flexcli.parts.excitation import Sine, Sweep, Tone
    from flexcli.parts.quality import Quality

__all__ = [
    "RANDOM",
    "SHAKES",
    "SINES",
    "PeakFactor",
    "Shaking",
    "at_once",
    "quality_of",
    "random_at_once",
    "refuse_unknown_axes",
    "shakings",
]

Floats = NDArray[np.float64]

RANDOM = frozenset({LoadKind.ASD, LoadKind.AXES})
"""Loads whose response is stated by its root mean square."""

SINES = frozenset({LoadKind.SINE, LoadKind.SWEEP, LoadKind.SINES})
"""Those of a steady amplitude."""

SHAKES = RANDOM | SINES | {LoadKind.SHOCK}
"""Loads of a case that excite the modes."""

FEW = 50
"""Number of points of a density up to which all are examined."""

PeakFactor = Callable[[Scene, Vibration, float], float]
"""Peak over rms of a random response, from its rate of upward zero crossings [Hz]."""


class Shaking(NamedTuple):
    """One excitation: its key in the spec, the response of a structure, and its name in words.

    ``changes_at`` are the frequencies at which it changes [Hz], ``axes`` the shaken ones.
    """

    kind: LoadKind
    axes: tuple[str, ...]
    peaks: Callable[[Structure], Mapping[str, float]]
    changes_at: tuple[float, ...]
    source: str
    named: Callable[[Structure, str], str]
    hint: str = ""


def shakings(ask: Ask, factor: PeakFactor) -> Iterator[Shaking]:
    """Yield every excitation of a case, its random axes by themselves where they act in turn.

    Raises
    ------
    RequirementError
        When nothing says how a sine is damped.

    """
    scene = ask.scene
    for vibration in random_at_once(scene):
        yield _random(scene, vibration, factor)
    if scene.shock is not None:
        yield _shock(scene.shock)
    for kind, sines in _sines_of(scene).items():
        for sine in sines:
            yield _sine(kind, sine, quality_of(ask.mechanism, scene))


def random_at_once(scene: Scene) -> Sequence[Vibration]:
    """Return the random vibration of a case, by axis where its axes act in turn."""
    every = scene.vibration
    if every is None:
        return []
    return [every.alone(axis) for axis in every.axes] if scene.in_turn else [every]


def _sines_of(scene: Scene) -> "dict[LoadKind, Sequence[Sine | Sweep | Tone]]":
    """Return the sines of a case by their keys."""
    return {
        LoadKind.SINE: () if scene.sine is None else (scene.sine,),
        LoadKind.SWEEP: () if scene.sweep is None else (scene.sweep,),
        LoadKind.SINES: scene.sines,
    }


def at_once(ask: Ask, factor: PeakFactor) -> Sequence[Shaking]:
    """Return the simultaneous excitations of the base: axes that act in turn are separate."""
    found = list(shakings(ask, factor))
    if not ask.scene.in_turn:
        return _together(found)
    axes = sorted({axis for each in found for axis in each.axes})
    return [one for axis in axes for one in _together([s for s in found if axis in s.axes])]


def _together(found: Sequence[Shaking]) -> Sequence[Shaking]:
    """Return excitations combined: their peaks may coincide, and add up."""
    if len(found) < 2:
        return found
    kinds = [each.kind for each in found if each.kind not in RANDOM]

    def peaks(structure: Structure) -> dict[str, float]:
        each = [shaking.peaks(structure) for shaking in found]
        return {name: sum(one[name] for one in each) for name in each[0]}

    return [
        Shaking(
            kinds[0],
            tuple(dict.fromkeys(axis for each in found for axis in each.axes)),
            peaks,
            tuple(sorted({at for each in found for at in each.changes_at})),
            " and ".join(each.source for each in found),
            lambda _structure, _name: (
                f"{' and '.join(dict.fromkeys(each.kind for each in found))} at once,"
            ),
            next((each.hint for each in found if each.hint), ""),
        )
    ]


def quality_of(mechanism: Mechanism | None, scene: Scene) -> "Quality":
    """Return Q of the modes: the case's, else the mechanism's, else that of another load."""
    from flexcli.parts.quality import Quality

    if scene.quality is not None:
        return scene.quality
    if mechanism is not None and mechanism.damping is not None:
        return Quality(all=mechanism.damping.quality)
    if scene.vibration is not None:
        return scene.vibration.q
    if scene.shock is not None:
        return Quality(all=scene.shock.q)
    raise RequirementError(
        f"nothing says how the modes are damped in case '{scene.case}'",
        "add q: 50 to the case",
    )


def refuse_unknown_axes(structure: Structure, axes: Sequence[str]) -> None:
    """Raise :class:`RequirementError` for an axis along which the response is not known."""
    for axis in axes:
        if axis not in structure.pull:
            raise RequirementError(
                f"no model has the response of this mechanism to a base that moves along {axis}",
                f"draw it as a space-layout, or take {axis} out of the case",
            )


def _random(scene: Scene, vibration: Vibration, factor: PeakFactor) -> Shaking:
    from flexcli.parts.response import random_outputs

    axes = vibration.axes

    def peaks(structure: Structure) -> dict[str, float]:
        refuse_unknown_axes(structure, axes)
        return {
            name: factor(scene, vibration, output.crossing_rate) * output.rms
            for name, output in random_outputs(structure, vibration).items()
        }

    def named(structure: Structure, name: str) -> str:
        rate = random_outputs(structure, vibration)[name].crossing_rate
        return f"{factor(scene, vibration, rate):.3g}σ"

    several = f", {' and '.join(axes)} at once, added as squares" if len(axes) > 1 else ""
    one = f" along {axes[0]}" if scene.in_turn or axes == ("z",) else ""
    kind = LoadKind.AXES if LoadKind.AXES in scene.loads else LoadKind.ASD
    source = f"modal response{one}, {vibration.q.told}{several}"
    return Shaking(kind, axes, peaks, _corners_of(vibration), source, named)


def _corners_of(vibration: Vibration) -> tuple[float, ...]:
    """Return the frequencies at which a density changes [Hz].

    A resonance sees a density over its bandwidth f/Q: of a measured one with many points the
    highest and the lowest in each quarter of it stand for the rest.
    """
    each = [_corners(applied, vibration.q.largest) for applied in vibration.by_axis().values()]
    return tuple(np.unique(np.concatenate(each)).tolist())


def _corners(applied: AppliedASD, q: float) -> Floats:
    f, g = applied.frequency, applied.level
    if f.size <= FEW:
        return f
    quarter = np.floor(4.0 * q * np.log(f))
    highest = np.lexsort((g, quarter))  # within each quarter by rising level
    ends = np.diff(quarter[highest]) > 0.0
    chosen = np.concatenate([highest[np.append(ends, True)], highest[np.insert(ends, 0, True)]])
    return np.asarray(f[chosen])


def _shock(shock: Shock) -> Shaking:
    from flexcli.parts.response import shock_peaks

    def peaks(structure: Structure) -> dict[str, float]:
        refuse_unknown_axes(structure, (shock.axis,))
        return shock_peaks(structure, shock)

    return Shaking(
        LoadKind.SHOCK,
        (shock.axis,),
        peaks,
        tuple(point.frequency for point in shock.srs),
        f"modal response to the shock, Q = {shock.q:g}",
        lambda _structure, _name: "peak",
        "extend the spectrum to the modes' frequencies",
    )


def _sine(kind: LoadKind, sine: "Sine | Sweep | Tone", quality: "Quality") -> Shaking:
    from flexcli.parts.response import sine_peaks

    low, high = sine.band
    frequencies = tuple(dict.fromkeys((low, *sine.crossovers, high)))

    def peaks(structure: Structure) -> dict[str, float]:
        refuse_unknown_axes(structure, (sine.axis,))
        return sine_peaks(structure, sine.level, quality, frequencies, sine.axis)

    return Shaking(
        kind,
        (sine.axis,),
        peaks,
        frequencies,
        f"steady modal response to the {sine.told}, {quality.told}",
        lambda _structure, _name: "amplitude of",
    )
