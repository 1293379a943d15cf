"""Closed forms that judge: those of the sources, improved where the sources' are rough."""

from collections.abc import Iterator
from math import cos, inf, pi, remainder

from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.plate_buckling import BUCKLING_ERROR, buckling_factor
from flexcli.formulas.section import shear_parameter
from flexcli.numerics.rows import Rows, isfinite, larger, number
from flexcli.numerics.signomial import Signomial
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import ENDS
from flexcli.parts.geometries.base import ACROSS_WIDTH, Critical
from flexcli.parts.requirements.as_printed import AsPrinted
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.scene import Push
from flexcli.results import ErrorRange
from flexcli.units import show

__all__ = ["CLOSED_FORM", "ClosedForm", "across_width", "least_blade_force", "of_case"]

DIRECTIONS = 72
"""Directions in which the least force is sought: 5 deg apart."""

STIFFEST = 0.5
"""Least effective length over length of any end conditions."""


class ClosedForm(AsPrinted):
    """The sources' formulas, but for the buckling of the joint as a whole where that is known."""

    model = "closed-form"

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the forces at which the joint buckles, one for each sense that they may have.

        Where the joint has no closed form of its own, the force of its most loaded blade alone.
        """
        if not all(isinstance(size, float | Rows) for size in ask.sizes):
            return super().critical(ask)
        try:
            return tuple(_each(ask))
        except NotAvailable:
            # what one blade bears is of the joint's order, and no more is known of it
            stress = ask.geometry.axial_stress(1.0, ask.sizes) * ask.scene.axial_share
            return tuple(c._replace(stress=stress) for c in super().critical(ask))


CLOSED_FORM = ClosedForm()


def _each(ask: Ask) -> Iterator[Critical]:
    scene = ask.scene
    assert scene.ends is not None  # the requirement asks for them
    if scene.beyond:
        raise NotAvailable(scene.beyond)
    for push in scene.pushes():
        critical = ask.geometry.joint_critical(
            ask.material.elastic,
            ask.sizes,
            scene.ends,
            _facing(ask, push),
        )
        # at rest it is known; what the stroke changes is not
        error = None if scene.bends else critical.error
        yield of_case(ask, push, critical._replace(error=error))
    yield from across_width(ask)


def of_case(ask: Ask, push: Push, critical: Critical) -> Critical:
    """Return a critical force in one direction as one on all forces of a case, and its way."""
    scene = ask.scene
    share = push.force / scene.force
    stress = None if critical.stress is None else critical.stress * share
    way = f"{critical.way} at {show(_facing(ask, push), 'rad')}"
    return critical._replace(way=way, force=critical.force / share, stress=stress)


def _facing(ask: Ask, push: Push) -> float:
    """Return the direction of a force from the joint's axis of symmetry, in (−π, π] [rad]."""
    return remainder(push.direction - ask.geometry.symmetry_axis, 2.0 * pi)


def least_blade_force(ask: Ask) -> Critical:
    """Return the least axial force in any blade at which the joint buckles at rest [N].

    Over all directions of a force on it, since a vibration shakes it along any; of its most loaded
    blade alone where the joint has no closed form of its own.
    """
    elastic, ends = ask.material.elastic, ask.scene.ends
    assert ends is not None  # the requirement asks for them
    per_force = ask.geometry.axial_stress(1.0, ask.sizes)
    found = []
    for index in range(DIRECTIONS):
        try:
            joint = ask.geometry.joint_critical(
                elastic, ask.sizes, ends, 2.0 * pi * index / DIRECTIONS
            )
        except NotAvailable:
            continue
        if joint.stress is not None and isfinite(number(joint.force)):
            found.append(joint._replace(force=joint.force * joint.stress / per_force))
    if not found:
        found = list(ask.geometry.critical(elastic, ask.sizes, ends))
    least = min(found, key=lambda critical: number(critical.force))
    return least._replace(stress=per_force)


def across_width(ask: Ask) -> Iterator[Critical]:
    """Yield the force that buckles a blade across its width, where there is a formula.

    Euler's load of the most loaded blade with the stated ends. Other blades that hold a body
    can only raise it, and so do clamps that keep a blade flat over its thickness; shear across the
    width lowers it. A force whose direction is stated may pull that blade, which it then leaves
    straight.
    """
    scene, elastic = ask.scene, ask.material.elastic
    assert scene.ends is not None  # the requirement asks for them
    blade, single = ask.geometry.blade(ask.sizes), ask.geometry.held_by_one_blade
    share = scene.axial_share
    if single:  # a blade alone bears no more of a force than what is along it
        along = (-cos(_facing(ask, push)) * push.force for push in scene.pushes())
        share = min(share, max(along, default=0.0) / scene.force)
    if blade is None or share <= 0.0:
        return
    sure = single or not scene.directed
    found = ask.geometry.critical(elastic, ask.sizes, scene.ends)
    for critical in found:
        if critical.way != ACROSS_WIDTH or isinstance(critical.force, Signomial):
            continue
        h, l, b = (number(size) for size in blade)
        phi = shear_parameter(depth=b, l=l, poisson_ratio=elastic.most_nu)
        n = number(critical.force) * 12.0 * l**2 / (elastic.E * h * b**3)
        softer = n * phi / 12.0 / (1.0 + n * phi / 12.0)
        alone = single or ENDS[scene.ends].hinged
        stiffer = 1.0 if alone else (EFFECTIVE_LENGTH[scene.ends] / STIFFEST) ** 2
        flat = _flatness(h, l, b, elastic.most_nu, scene.ends if alone else None)
        stress = share / (h * b)
        force = critical.force / share
        least, most = ask.geometry.crossed(ask.sizes)
        low = least * (1.0 - softer) / (1.0 + ask.clamp_softening) - 1.0
        error = ErrorRange(low, most * stiffer * flat - 1.0 if sure else inf)
        yield Critical(ACROSS_WIDTH, force, critical.source, stress, error)


def _flatness(h: float, l: float, b: float, nu: float, ends: str | None) -> float:
    """Return the most that a blade bent across its width bears as a plate over the beam.

    Of the ends that are named, or of any.
    """
    held = EFFECTIVE_LENGTH if ends is None else (ends,)
    deep = larger(h, b)
    return larger(
        number(buckling_factor(b=deep, l=l, ends=each, poisson_ratio=nu)) + BUCKLING_ERROR[each]
        for each in held
    )
