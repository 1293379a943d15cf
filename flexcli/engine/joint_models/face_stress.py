"""Where along a blade the stress of a stroke is worst, from the stress at both of its ends."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.rows import number
from flexcli.parts.requirements import Ask, EndStress

__all__ = ["WEIGHTS", "worst_of_stroke"]

Floats = NDArray[np.float64]

WEIGHTS = (0.0, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0)
"""Of the mean stress beside the amplitude: strength over what the mean is compared with."""


def worst_of_stroke(ask: Ask, blade: str, faces: Mapping[str, Floats]) -> Iterator[EndStress]:
    """Yield the worst places of a blade's faces, from stresses (states, places) [Pa].

    Of many designs they are (states, designs, places). States are those of a case
    (:func:`flexcli.engine.joint_models.joint_states.of_case`): pairs of the two ends of the stroke
    where there is one. What the loads of the case pull on average, the same at both faces, is told
    apart as axial: no part of what a wide blade's bending does.
    """
    scene, joint = ask.scene, ask.geometry.joint_of(blade)
    reverses = scene.mean_travel == 0.0 and not scene.is_loaded
    middle = np.mean(list(faces.values()), axis=0) * float(scene.is_loaded)
    for face, stress in faces.items():
        in_pairs = ((s[::2], s[1::2]) if scene.moves else (s, s) for s in (stress, middle))
        (ones, others), (pulls, other_pulls) = in_pairs
        for one, other, pull, last in zip(ones, others, pulls, other_pulls, strict=True):
            for place in _worst(one, other):
                start, end, pulled, also = (_at(s, place) for s in (one, other, pull, last))
                axial = number(pulled + also) / 2.0
                yield EndStress(
                    f"{blade}, {face} face",
                    number(abs(start - end)) / 2.0,
                    number(start + end) / 2.0 - axial,
                    axial,
                    joint,
                    is_at_face=True,
                    reverses=reverses,
                )


def _at(stress: Floats, place: Any) -> Floats:
    """Return the stress at a place, which may be another in each design."""
    return np.take_along_axis(stress, np.asarray(place)[..., None], axis=-1)[..., 0]


def _worst(one: Floats, other: Floats) -> Iterable[Any]:
    """Return the places of a face where the stress, the amplitude or what stands for both is most.

    Between the greatest amplitude and the greatest tension lies what a mean stress method may
    find the worst: a few weights of the mean find it.
    """
    amplitude, mean = np.abs(one - other) / 2.0, (one + other) / 2.0
    sought = [amplitude + np.abs(mean)]
    sought += [amplitude + weight * np.maximum(mean, 0.0) for weight in WEIGHTS]
    places = [np.argmax(each, axis=-1) for each in sought]
    return dict.fromkeys(map(int, places)) if one.ndim == 1 else places
