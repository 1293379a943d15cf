"""The formulas of a joint as their sources print them, as a model that requirements ask."""

from collections.abc import Iterator
from math import pi, remainder

from flexcli.formulas.quantity import Computed, Quantity
from flexcli.numerics.signomial import Signomial
from flexcli.parts.bending import FLOOR
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import ENDS
from flexcli.parts.geometries.base import Critical
from flexcli.parts.requirements.ask import Ask, EndStress, JointModel
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["AS_PRINTED", "AsPrinted", "stress_name"]


UNTOLD = frozenset({QuantityKind.BUCKLING, QuantityKind.SUPPORT, QuantityKind.RESPONSE})
"""Kinds of numbers for which effects have no estimates."""

STRAIGHT = 1e-9
"""Angle [rad] of a force to an axis of a joint that is rounding."""


class AsPrinted(JointModel):
    """Small rotation, slender blades: what the geometry's own formulas say."""

    name = "source"

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the error of rounding where every effect left out has an estimate."""
        if kind in UNTOLD or not _is_estimated(ask, kind):
            return None
        turned = ask.geometry.turns_freely and ask.scene.keeps_turn and ask.scene.bends
        if turned and kind is QuantityKind.STRESS:
            return None  # bent to an S where the formula has a free tip
        if kind is QuantityKind.STRESS and _is_borne_beside_blades(ask):
            return None
        return FLOOR

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion [N·m/rad or N/m]."""
        if ask.scene.temperature is not None:
            raise NotAvailable(ask.scene.beyond)
        return ask.geometry.stiffness(ask.material.elastic, ask.sizes)

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the case's acceleration [N/m]."""
        if ask.scene.temperature is not None:
            raise NotAvailable(ask.scene.beyond)
        return ask.geometry.sag_stiffness(ask.material.elastic, ask.sizes, ask.scene.axis)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return the signed shift at the end of the stroke [m]."""
        scene = ask.scene
        if scene.temperature is not None:
            raise NotAvailable(scene.beyond)
        return ask.geometry.parasitic_shift(ask.sizes, scene.travel + scene.mean_travel)

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress at every end and in either sense.

        Both faces of a blade see the bending, once in tension and once in compression, so each end
        counts with both signs, unless its sign is known for every blade: then the face in tension
        has the larger stress, and the other would only make a convex program appear non-convex.
        """
        return stress_name(ask), list(_each(ask))

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the forces on the joint at which its most loaded blade buckles [N]."""
        scene = ask.scene
        assert scene.ends is not None  # the requirement asks for them
        if scene.beyond:
            raise NotAvailable(scene.beyond)
        found = ask.geometry.critical(ask.material.elastic, ask.sizes, scene.ends)
        return tuple(c._replace(force=c.force / scene.axial_share) for c in found)


AS_PRINTED = AsPrinted()


def _is_borne_beside_blades(ask: Ask) -> bool:
    """Return whether ends bear a part of a force, which the formula gives to the blades.

    They keep the body from moving across the force: one that is oblique to the joint would.
    """
    scene = ask.scene
    if not scene.forces or scene.ends is None or not ENDS[scene.ends].across:
        return False
    axis = ask.geometry.symmetry_axis
    return any(
        abs(remainder(push.direction - axis, pi / 2.0)) > STRAIGHT for push in scene.pushes()
    )


def _is_estimated(ask: Ask, kind: QuantityKind) -> bool:
    """Return whether the effects that the formula leaves out have valid estimates."""
    elastic, scene = ask.material.elastic, ask.scene
    reach = scene.travel + scene.mean_travel
    if scene.push:
        try:
            reach += scene.push / ask.geometry.stiffness(elastic, ask.sizes)
        except NotAvailable:
            return False
    return ask.geometry.is_known(elastic, ask.sizes, reach, kind)


def stress_name(ask: Ask) -> str:
    """Return the name of the stresses of a case, by its loads."""
    return {
        (True, False): f"{ask.geometry.strain} stress",
        (False, True): "axial stress",
        (True, True): f"{ask.geometry.strain} stress with the axial force",
        (False, False): "stress",
    }[ask.scene.bends, ask.scene.blade_force > 0.0]


def _each(ask: Ask) -> Iterator[EndStress]:
    scene, geometry, sizes = ask.scene, ask.geometry, ask.sizes
    if scene.beyond:
        raise NotAvailable(scene.beyond)
    axial = geometry.axial_stress(scene.blade_force, sizes) if scene.blade_force else 0.0
    if not scene.bends:
        yield EndStress("blade", 0.0, 0.0, axial)
        return
    elastic = ask.material.elastic
    amplitudes: dict[str, Computed] = {}
    means: dict[str, Computed] = {}
    if scene.moves:
        amplitudes, means = geometry.stroke_stresses(elastic, sizes, scene.travel, scene.middle)
    pushed = _pushed(ask)
    for where in amplitudes or pushed:
        amplitude, joint = amplitudes.get(where, 0.0), geometry.joint_of(where)
        mean = means.get(where, 0.0) + pushed.get(where, 0.0)
        for sign in _faces(amplitude + mean):
            yield EndStress(where, sign * amplitude, sign * mean, axial, joint)


def _pushed(ask: Ask) -> dict[str, Computed]:
    """Return the stress of the load along the stroke itself, by place [Pa]: the sag of the joint.

    It acts either way, so that it adds to the mean of the stroke.
    """
    scene, geometry, elastic = ask.scene, ask.geometry, ask.material.elastic
    if scene.push == 0.0:
        return {}
    if not geometry.is_linear:
        raise NotAvailable("has no closed form for a load along its stroke")
    per_travel = geometry.end_stresses(elastic, ask.sizes, 1.0)
    try:
        sag = scene.push / geometry.stiffness(elastic, ask.sizes)
    except ArithmeticError as error:  # of signomials
        text = "has no closed form for a load along its stroke that could size it"
        raise NotAvailable(text) from error
    return {where: stress * sag for where, stress in per_travel.items()}


def _faces(bending: Quantity) -> tuple[float, ...]:
    """Return the signs with which the bending of an end counts."""
    if not isinstance(bending, Signomial):
        return (1.0, -1.0)
    if bending.negative_part().is_zero:
        return (1.0,)
    return (-1.0,) if bending.positive_part().is_zero else (1.0, -1.0)
