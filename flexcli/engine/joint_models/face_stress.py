"""Where along a blade the stress of a stroke is worst, from the stress at both of its ends."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.wide_under_force import StateFactors
from flexcli.mechanics.stresses import BladeStress
from flexcli.numerics.rows import Number, larger, largest_of_each, number
from flexcli.parts.requirements import Ask, EndStress
from flexcli.parts.worst_places import worst_places

__all__ = ["PlateStresses", "largest_at_faces", "worst_of_stroke"]

Floats = NDArray[np.float64]


class PlateStresses(NamedTuple):
    """What plates add to the stress of a case's blades at start and end (states, blades, 2) [Pa].

    ``bending`` has the sign of the moment, ``axial`` that of the pull; ``unsure`` is by what share
    the largest stress, and the largest half of what a stroke changes, may be off.
    """

    bending: Floats
    axial: Floats
    unsure: float

    def added(self, blade: int, found: BladeStress) -> BladeStress:
        """Return the stress along a blade with what plates add, straight between its ends."""
        share = found.s / found.s[:, -1:]
        ends = self.bending[:, blade], self.axial[:, blade]
        bending, axial = (x[:, :1] + (x[:, 1:] - x[:, :1]) * share for x in ends)
        return found._replace(bending=found.bending + bending, axial=found.axial + axial)


def largest_at_faces(faces: Mapping[str, Floats], off: Floats | float = 0.0) -> Number:
    """Return the largest stress at the faces of a blade, more at each place by what is off [Pa]."""
    return larger(*(largest_of_each(np.abs(face) + off) for face in faces.values()))


def worst_of_stroke(
    ask: Ask, blade: str, faces: Mapping[str, Floats], wide: StateFactors | None = None
) -> Iterator[EndStress]:
    """Yield the worst places of a blade's faces, from stresses (states, places) [Pa].

    Of many designs they are (states, designs, places). States are those of a case
    (:func:`flexcli.engine.joint_models.joint_states.of_case`): pairs of the two ends of the stroke
    where there is one. What the loads of the case pull on average, the same at both faces, is told
    apart as axial: no part of what a wide blade's bending does. ``wide`` are the factors of these.
    """
    scene, joint = ask.scene, ask.geometry.joint_of(blade)
    reverses = scene.mean_travel == 0.0 and not scene.is_loaded
    middle = np.mean(list(faces.values()), axis=0)
    loaded = float(scene.is_loaded)
    for face, stress in faces.items():
        in_pairs = ((s[::2], s[1::2]) if scene.moves else (s, s) for s in (stress, middle))
        (ones, others), (pulls, other_pulls) = in_pairs
        step = 2 if scene.moves else 1
        for index, (one, other, pull, last) in enumerate(
            zip(ones, others, pulls, other_pulls, strict=True)
        ):
            at = step * index
            for place in _worst(one, other):
                start, end, pulled, also = (_at(s, place) for s in (one, other, pull, last))
                axial = loaded * number(pulled + also) / 2.0
                yield EndStress(
                    f"{blade}, {face} face",
                    number(abs(start - end)) / 2.0,
                    number(start + end) / 2.0 - axial,
                    axial,
                    joint,
                    is_at_face=True,
                    reverses=reverses,
                    wide=None if wide is None else wide.of_pair(at, at + step - 1),
                    pulled=larger(number(abs(pulled)), number(abs(also))),
                )


def _at(stress: Floats, place: Any) -> Floats:
    """Return the stress at a place, which may be another in each design."""
    return np.take_along_axis(stress, np.asarray(place)[..., None], axis=-1)[..., 0]


def _worst(one: Floats, other: Floats) -> Iterable[Any]:
    """Return the places of a face that may be the worst, of each design where there are many."""
    places = worst_places(np.abs(one - other) / 2.0, (one + other) / 2.0)
    return dict.fromkeys(map(int, places)) if one.ndim == 1 else places
