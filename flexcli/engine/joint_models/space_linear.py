"""The linear model of a mechanism in space: blades between rigid clamps under small motion.

Plates, sheets and restrained warping are in the springs of its blades, with their errors. What a
stroke leaves out of a linear model is estimated by its second order, and unknown where that is
not small.
"""

from functools import partial
from math import inf, isfinite
from typing import TYPE_CHECKING

import numpy as np

from flexcli.engine.joint_models.remembered import Remembered
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.space.layout import SpaceBlade
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.space.states import action
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Critical
from flexcli.parts.requirements import Ask, CriticalShare, EndStress, JointModel, Told
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.space_joint import SpaceJoint, joint_of
from flexcli.parts.space_own_motion import own_frequency
from flexcli.parts.space_states import (
    SOFTENED,
    Place,
    acting_groups,
    motions,
    straight_shares,
    stress_places,
    unsure_swing,
)
from flexcli.parts.strained_compliance import sag
from flexcli.results import EXACT, ErrorRange, QuantityKind

if TYPE_CHECKING:
    from flexcli.mechanics.space.swept_box import SweptBox

__all__ = ["SpaceLinearModel"]

WIDE = 1.5
"""Width over length up to which straight beams stand no more than a third beyond what blades do."""


class SpaceLinearModel(JointModel):
    """Small motion in space from rest."""

    name = "linear"
    at_stroke = "straight beams in space"

    def __init__(self) -> None:
        self._stresses: Remembered[tuple[list[Place], ErrorRange | None]] = Remembered()
        self._told: Remembered[Told] = Remembered()

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the error of its numbers: of the springs, and of what the motion leaves out."""
        scene = ask.scene
        if (kind is QuantityKind.SAG and not scene.sags) or (
            kind is QuantityKind.SHIFT and not scene.moves and scene.temperature is None
        ):
            return EXACT  # of nothing
        find = {
            QuantityKind.STIFFNESS: lambda: _joint(ask).error(_stiffness),
            QuantityKind.FREQUENCY: lambda: self._frequency(ask).error,
            QuantityKind.STRESS: lambda: self._places(ask)[1],
            QuantityKind.SHIFT: lambda: self._shift(ask).error,
            QuantityKind.SAG: lambda: self._sag(ask).error,
        }.get(kind)
        try:
            return find() if find is not None else None
        except NotAvailable:
            return None

    def swing_error(self, ask: Ask) -> ErrorRange | None:
        """Return the error of what a stroke alternates beside loads, which may hide its warping."""
        known = self.error(ask, QuantityKind.STRESS)
        if known is None or not ask.scene.moves or ask.scene.loads <= {LoadKind.STROKE}:
            return None
        return known + unsure_swing(_joint(ask), ask.scene)

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion, all else free [N·m/rad or N/m]."""
        if ask.scene.temperature is not None:
            raise NotAvailable("has no linear model of a stiffness at a temperature")
        return _stiffness(_joint(ask).assembly)

    def frequency_squared(self, ask: Ask) -> Computed:
        """Return the square of the lowest frequency of the drive's own motion [Hz²]."""
        return self._frequency(ask).value ** 2

    def sag(self, ask: Ask) -> Computed:
        """Return how far the moving body sags along the case's acceleration [m]."""
        return self._sag(ask).value

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness of the moving body along the case's acceleration [N/m]."""
        joint = _joint(ask)
        body = joint.layout.body(joint.layout.drive.body)
        C = joint.assembly.compliance(body.name, body.point, locked=False)
        index = "xyz".index(ask.scene.axis)
        return float(1.0 / C[index, index])

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return how far the driven point, or the axis, leaves its path at the stroke's ends."""
        return self._shift(ask).value

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return von Mises' stress of bending, stretching and twist, blade by blade."""
        return "nominal stress in space, von Mises", [
            EndStress(place.where, place.amplitude, place.mean, 0.0, is_at_face=True)
            for place in self._places(ask)[0]
        ]

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return the box around it by small motion, and the bodies that have no outline."""
        from flexcli.engine.joint_models.space_box import linear_box

        return linear_box(ask)

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Refuse: nothing here says at what load a mechanism in space buckles."""
        raise NotAvailable("has no buckling load in space")

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return the shares of the loads that turn straight blades aside.

        The range has no upper end: up to its lower one nothing buckles.
        """
        scene, joint = ask.scene, _joint(ask)
        if scene.temperature is not None or not joint.is_uniform or ask.geometry.is_guided:
            raise NotAvailable("has no linear model of what buckles it")
        sure = _borne_by_wide_blades(joint, scene, ask.most_share)
        return tuple(
            CriticalShare(share, scene.hold, ErrorRange(least * sure / share - 1.0, inf), stress)
            for share, least, stress in straight_shares(joint, scene, ask.most_share)
        )

    def _places(self, ask: Ask) -> tuple[list[Place], ErrorRange | None]:
        return self._stresses.of("stress", ask, lambda: stress_places(_joint(ask), ask.scene))

    def _frequency(self, ask: Ask) -> Told:
        find = partial(own_frequency, ask.geometry, ask.material, ask.sizes)
        found = self._told.of("frequency", ask, find)
        if ask.scene.temperature is None:
            return found
        return found.times(*self.warm_frequency_ratio(ask, locked=False))

    def _sag(self, ask: Ask) -> Told:
        return self._told.of("sag", ask, lambda: sag(_joint(ask), ask.scene))

    def _shift(self, ask: Ask) -> Told:
        return self._told.of("shift", ask, lambda: _shift(ask))


def _joint(ask: Ask) -> SpaceJoint:
    return joint_of(ask)


def _stiffness(assembly: SpaceAssembly) -> float:
    return float(assembly.moved(travel=np.ones(1)).drive[0])


def _borne_by_wide_blades(joint: SpaceJoint, scene: Scene, most: float) -> float:
    """Return the share of a load up to which beams surely stand that very wide blades bear."""
    members = zip(joint.layout.blades, joint.assembly.members, strict=True)
    if not any(isinstance(x, SpaceBlade) and x.b > WIDE * member.l for x, member in members):
        return 1.0
    # beams at strokes are for them alone
    from flexcli.engine.joint_models.space_errors import width_error

    forces = [action(joint.assembly, each).moved.forces for each in acting_groups(joint, scene)]
    more = width_error(joint.assembly, most * np.sum(np.abs(forces), axis=0)[:, 0])
    return 1.0 / max(SOFTENED * (1.0 + more), 1.0)


def _shift(ask: Ask) -> Told:
    """Return the largest motion off the path at either end of the stroke, and its error."""
    joint = _joint(ask)
    drive = joint.layout.drive
    point = np.subtract(drive.point, joint.layout.body(drive.body).point)
    rows = np.eye(3, 6)
    if not drive.turns:
        # the two directions across the travel
        rows = rows[np.argsort(np.abs(drive.direction))[:2]]
        e = np.asarray(drive.direction)
        rows = np.linalg.qr(np.column_stack([e, rows[:, :3].T]))[0].T[1:] @ np.eye(3, 6)
    most, doubt = 0.0, 0.0
    for motion in motions(joint, ask.scene, ask.material, ask.geometry.axes):
        moved, off = motion.at((float(point[0]), float(point[1]), float(point[2])), rows)
        most = max(most, float(np.linalg.norm(moved)))
        doubt = max(doubt, float(np.linalg.norm(off)))
    if not isfinite(doubt) or most == 0.0:
        return Told(most, None)
    return Told(most, ErrorRange(-doubt / most, doubt / most))
