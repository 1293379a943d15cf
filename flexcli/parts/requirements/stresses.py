"""The stresses that a case puts at the ends of a blade, named by what is in them."""

from collections.abc import Iterator
from typing import NamedTuple

from flexcli.formulas.quantity import Quantity
from flexcli.formulas.section import axial_stress
from flexcli.numerics.signomial import Signomial
from flexcli.parts.requirements.base import Ask
from flexcli.parts.scene import Scene

__all__ = ["EndStress", "driver", "end_stresses"]


class EndStress(NamedTuple):
    """Signed bending amplitude and mean at one face of one end, and the axial stress there."""

    where: str
    amplitude: Quantity
    mean: Quantity
    axial: Quantity

    @property
    def largest(self) -> Quantity:
        """Return the largest stress at this face."""
        return self.amplitude + self.mean + self.axial


def driver(scene: Scene) -> str:
    """Return what the stresses of a case grow with."""
    bending, loaded = scene.travel > 0.0 or scene.mean_travel > 0.0, scene.blade_force > 0.0
    return " and ".join(["stroke"] * bending + ["force"] * loaded)


def end_stresses(ask: Ask) -> tuple[str, Iterator[EndStress]]:
    """Return the name of the stress that is meant, and it at every end and for either sign.

    Both faces of a blade see the bending, once in tension and once in compression, so each end
    counts with both signs, unless its sign is known for every blade: then the face in tension
    has the larger stress, and the other would only make a convex program look like none.
    """
    scene, blade = ask.scene, ask.blade
    bending, loaded = scene.travel > 0.0 or scene.mean_travel > 0.0, scene.blade_force > 0.0
    name = {
        (True, False): "bending stress",
        (False, True): "axial stress",
        (True, True): "bending stress with the axial force",
    }[bending, loaded]

    def each() -> Iterator[EndStress]:
        axial = axial_stress(scene.blade_force, blade.h, blade.b) if loaded else 0.0
        if not bending:
            yield EndStress("blade", 0.0, 0.0, axial)
            return
        E = ask.material.E
        amplitudes = ask.geometry.end_stresses(E, blade, scene.travel)
        means = ask.geometry.end_stresses(E, blade, scene.mean_travel)
        for where, amplitude in amplitudes.items():
            mean = means[where] if scene.mean_travel > 0.0 else 0.0
            for sign in _faces(amplitude + mean):
                yield EndStress(where, sign * amplitude, sign * mean, axial)

    return name, each()


def _faces(bending: Quantity) -> tuple[float, ...]:
    """Return the signs with which the bending of an end counts."""
    if not isinstance(bending, Signomial):
        return (1.0, -1.0)
    if bending.negative_part().is_zero:
        return (1.0,)
    return (-1.0,) if bending.positive_part().is_zero else (1.0, -1.0)
