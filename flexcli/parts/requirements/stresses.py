"""The stresses that a case puts at the ends of a blade, named by what is in them."""

from collections.abc import Iterator
from typing import NamedTuple

from flexcli.formulas.quantity import Quantity
from flexcli.numerics.signomial import Signomial
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.base import Ask, RequirementError
from flexcli.parts.scene import Scene

__all__ = ["EndStress", "driver", "end_stresses"]


class EndStress(NamedTuple):
    """Signed bending amplitude and mean at one face of one end, and the axial stress there."""

    where: str
    amplitude: Quantity
    mean: Quantity
    axial: Quantity

    @property
    def is_reversed(self) -> bool:
        """Return whether nothing stands beside the amplitude."""
        return all(isinstance(s, float) and s == 0.0 for s in (self.mean, self.axial))

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
    scene, sizes = ask.scene, ask.sizes
    bending, loaded = scene.travel > 0.0 or scene.mean_travel > 0.0, scene.blade_force > 0.0
    name = {
        (True, False): f"{ask.geometry.strain} stress",
        (False, True): "axial stress",
        (True, True): f"{ask.geometry.strain} stress with the axial force",
    }[bending, loaded]

    def each() -> Iterator[EndStress]:
        axial = _axial(ask) if loaded else 0.0
        if not bending:
            yield EndStress("blade", 0.0, 0.0, axial)
            return
        elastic = ask.material.elastic
        try:
            amplitudes, means = ask.geometry.stroke_stresses(
                elastic, sizes, scene.travel, scene.middle
            )
        except NotAvailable as error:
            raise RequirementError(f"a {ask.geometry.name} {error}") from error
        for where, amplitude in amplitudes.items():
            mean = means.get(where, 0.0)
            for sign in _faces(amplitude + mean):
                yield EndStress(where, sign * amplitude, sign * mean, axial)

    return name, each()


def _axial(ask: Ask) -> Quantity:
    try:
        return ask.geometry.axial_stress(ask.scene.blade_force, ask.sizes)
    except NotAvailable as error:
        raise RequirementError(f"a {ask.geometry.name} {error}") from error


def _faces(bending: Quantity) -> tuple[float, ...]:
    """Return the signs with which the bending of an end counts."""
    if not isinstance(bending, Signomial):
        return (1.0, -1.0)
    if bending.negative_part().is_zero:
        return (1.0,)
    return (-1.0,) if bending.positive_part().is_zero else (1.0, -1.0)
