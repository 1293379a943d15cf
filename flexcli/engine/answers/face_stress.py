"""Where along a blade the stress of a stroke is worst, from the stress at both of its ends."""

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.layout import Blade
from flexcli.parts.requirements import Ask, EndStress

__all__ = ["POINTS", "blade_places", "worst_of_stroke"]

Floats = NDArray[np.float64]

POINTS = 257
"""Places along each piece of a blade at which both ends of the stroke are compared: the greatest
stress of a notch, which lies beside its throat, is found to some 1e-6."""


def blade_places(blade: Blade, l: float) -> tuple[Floats, Floats]:
    """Return places along the flexible pieces of a blade of length l and thickness there [m]."""
    u = np.linspace(-1.0, 1.0, POINTS)
    pieces = blade.profile.pieces(l)
    position, thickness = (
        np.concatenate([np.broadcast_to(function(u), u.shape) for function in functions])
        for functions in ([p.position for p in pieces], [p.thickness for p in pieces])
    )
    return position, thickness


def worst_of_stroke(ask: Ask, blade: str, faces: Mapping[str, Floats]) -> Iterator[EndStress]:
    """Yield the worst places of a blade's faces, from stresses (states, places) [Pa].

    States come in pairs: the two ends of the stroke, under each sign of the forces.
    """
    reverses = ask.scene.mean_travel == 0.0 and not ask.scene.forces
    joint = ask.geometry.joint_of(blade)
    for face, stress in faces.items():
        for pair in range(0, stress.shape[0], 2):
            yield from _worst(
                f"{blade}, {face} face", stress[pair], stress[pair + 1], joint, reverses=reverses
            )


def _worst(
    where: str, one: Floats, other: Floats, joint: str, *, reverses: bool
) -> Iterator[EndStress]:
    """Yield the places of a face at which the greatest stress and the greatest amplitude are.

    Where the stroke reverses, the larger of both ends counts as the amplitude: the little that
    the two differ by, of second order in the stroke, then needs no mean stress method.
    """
    amplitude, mean = np.abs(one - other) / 2.0, (one + other) / 2.0
    largest = np.maximum(np.abs(one), np.abs(other))
    for index in dict.fromkeys((int(np.argmax(largest)), int(np.argmax(amplitude)))):
        if reverses:
            yield EndStress(where, float(largest[index]), 0.0, 0.0, joint)
            continue
        for sign in (1.0, -1.0):
            yield EndStress(where, float(amplitude[index]), sign * float(mean[index]), 0.0, joint)
