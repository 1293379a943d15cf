"""Sag: how far the weight of the moving body bends the joint."""

from collections.abc import Iterator
from math import inf
from typing import Annotated, ClassVar

import numpy as np

from flexcli.formulas.quantity import Computed
from flexcli.formulas.rigid_motion import axes_about_z, motion_along
from flexcli.parts.base import QuantityOf
from flexcli.parts.elastic import Buckled, NotAvailable
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, ErrorOf, Limit
from flexcli.parts.requirements.support import CENTRE
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["Sag"]

_Length = Annotated[float, QuantityOf("length", above=0.0)]


class Sag(Bound):
    """Bounds on m a / K along the axis of the case's acceleration.

    Beside a stroke that bends the joint otherwise at both of its ends as well, the drive free.
    """

    label: ClassVar[str] = "sag"
    by_solids: ClassVar[bool] = True
    per_case: ClassVar[bool] = True

    min: _Length | None = None
    max: _Length | None = None
    equals: _Length | None = None

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a steady acceleration."""
        return scene.acceleration > 0.0

    def weighs(self, scene: Scene) -> bool:
        """Return True."""
        return True

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the steady acceleration."""
        return frozenset({LoadKind.ACCELERATION})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the sag."""
        scene = ask.scene
        if not scene.sags:
            raise RequirementError(
                f"a sag is along one axis, and the acceleration of case '{scene.case}' is not",
                "give that of the sag a case of its own, with level: and axis:",
            )
        moves = scene.moves and not ask.geometry.sags_along_stroke(scene.axis)
        try:
            at_rest, at_stroke = self._at_rest(ask), self._at_stroke(ask) if moves else ()
        except MechanismError as failed:
            raise RequirementError(str(failed), failed.hint) from failed
        quantity = f"sag along {scene.axis}"
        for sag, error in at_rest:
            yield from self.bounds(
                sag,
                case=scene.case,
                quantity=quantity,
                unit="m",
                source=ask.geometry.source,
                kind=QuantityKind.SAG,
                error=error,
            )
        for sag, error in at_stroke:
            yield from self.bounds(
                abs(sag),
                case=scene.case,
                quantity=f"{quantity} at the stroke, drive free",
                unit="m",
                source=ask.geometry.source,
                error=error,
            )

    def _at_rest(self, ask: Ask) -> tuple[tuple[Computed, ErrorRange | ErrorOf | None], ...]:
        try:
            return ask.joint_model.sags(ask)
        except Buckled:
            raise
        except NotAvailable:
            return ((ask.joint_model.sag(ask), ErrorOf.MODEL),)

    def _at_stroke(self, ask: Ask) -> tuple[tuple[Computed, ErrorRange | None], ...]:
        """Return the sags at both ends of the stroke, as what weighs there deflects the joint.

        As a force on the moving body that sags it as far at rest; what weighs elsewhere in a layout
        may change by more or less, as much as that changes either way.
        """
        scene, sag = ask.scene, float(ask.joint_model.sag(ask))
        unknown = ((sag, None),)
        if ask.mechanism is not None and ask.mechanism.joints > 1:
            return unknown
        force = sag * float(ask.joint_model.sag_stiffness(ask))
        weight = force * np.eye(6)["xyz".index(scene.axis)]
        layout = motion_along(axes_about_z(ask.geometry.axes)).T
        stated = np.array(scene.stated) + layout @ weight
        asked = scene._replace(
            wrench=tuple(weight.tolist()),
            stated=tuple(stated.tolist()),
            inertial=(),
            accelerations=(),
        )
        try:
            found = ask.joint_model.deflections(ask._replace(scene=asked), CENTRE, scene.axis)
        except Buckled:
            raise
        except NotAvailable:
            return unknown
        if not ask.geometry.has_masses:
            return found
        each = list[tuple[Computed, ErrorRange | None]]()
        for deflection, error in found:
            off = abs(1.0 - sag / abs(deflection)) if deflection else inf
            known = None if error is None or off > 1.0 else error + ErrorRange(-off, off)
            each.append((deflection, known))
        return tuple(each)
