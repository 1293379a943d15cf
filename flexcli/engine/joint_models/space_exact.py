"""The exact model of a mechanism in space: geometrically exact beams at the ends of its strokes.

About rest it is the linear model; so it is under other loads than a stroke.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.space_linear import SpaceLinearModel
from flexcli.engine.joint_models.space_stroke import at_travel, is_compared, support_at_stroke
from flexcli.errors import SolveError
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.stresses import equivalent
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, EndStress
from flexcli.parts.space_joint import joint_in_space
from flexcli.parts.space_states import acting_groups
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["SpaceExactModel", "blade_peaks"]

Floats = NDArray[np.float64]

SHIFT_ERROR = 0.02
"""Error of the motion beside a stroke, against the solids of ``BEAM_ERROR``: within 0.7 %."""

STRESS_ERROR = 0.05
"""Error of the nominal stress of a stroke: of the drive's force, within 1 % of those solids, and of
how restrained warping spreads."""


class SpaceExactModel(SpaceLinearModel):
    """The linear model about rest, and exact beams at the ends of strokes."""

    name = "exact"

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the error of its numbers: of beams against solids, and of their nodes."""
        if kind is QuantityKind.SHIFT and ask.scene.moves:
            return _told(ask, SHIFT_ERROR, _shift)
        if kind is QuantityKind.STRESS and _is_stroke_alone(ask):
            return _told(ask, STRESS_ERROR, _largest)
        return super().error(ask, kind)

    def support_at_stroke(
        self, ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
    ) -> tuple[tuple[float, ErrorRange | None], ...]:
        """Return the support stiffness at both ends of the stroke, the drive locked or free."""
        return support_at_stroke(ask, index, point, locked=locked)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return how far the driven point, or the axis, leaves its path at the stroke's ends."""
        return max(_shift(state) for state in _ends(ask))

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress of a stroke, or what the linear model says of other loads too."""
        if not _is_stroke_alone(ask):
            return super().stresses(ask)
        first, last = (_stresses(state) for state in _ends(ask))
        found: list[EndStress] = []
        for name, one in first.items():
            amplitude, mean = np.abs(one - last[name]) / 2.0, (one + last[name]) / 2.0
            sought = (amplitude + np.abs(mean), amplitude)
            found.extend(
                EndStress(name, float(amplitude[i]), float(mean[i]), 0.0, is_at_face=True)
                for i in dict.fromkeys(int(np.argmax(each)) for each in sought)
            )
        return "nominal stress in space, von Mises", found


def _is_stroke_alone(ask: Ask) -> bool:
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    return ask.scene.moves and not acting_groups(joint, ask.scene)


def _ends(ask: Ask) -> tuple[SpaceEquilibrium, SpaceEquilibrium]:
    scene = ask.scene
    return (
        at_travel(ask, scene.middle + scene.travel),
        at_travel(ask, scene.middle - scene.travel),
    )


def _told(ask: Ask, error: float, number: Callable[[SpaceEquilibrium], float]) -> ErrorRange | None:
    """Return an error with what a number changes from the level of nodes before."""
    try:
        states = _ends(ask)
    except (NotAvailable, SolveError):
        return None
    change = 0.0
    for state in states:
        found = number(state)
        if state.coarser is None or not is_compared(state) or found == 0.0:
            return None
        change = max(change, abs(number(state.coarser) / found - 1.0))
    return ErrorRange(-error - change, error + change)


def _shift(state: SpaceEquilibrium) -> float:
    """Return how far the driven point leaves its path [m]."""
    drive = state.layout.drive
    moved = state.motion_of(drive.body, drive.point)[:3]
    if not drive.turns:
        along = np.asarray(drive.direction)
        moved = moved - (moved @ along) * along
    return float(np.linalg.norm(moved))


def blade_peaks(state: SpaceEquilibrium) -> tuple[float, str]:
    """Return the largest stress of the blades [Pa], and the blade that has it."""
    return max((float(np.max(np.abs(each))), name) for name, each in _stresses(state).items())


def _largest(state: SpaceEquilibrium) -> float:
    return blade_peaks(state)[0]


def _stresses(state: SpaceEquilibrium) -> dict[str, Floats]:
    """Return von Mises' stress at the corners and faces, signed as the normal stress, by blade."""
    found = {}
    for blade in blade_stresses(state):
        faces = np.stack([blade.axial + side * blade.bend_thin for side in (1.0, -1.0)], axis=-1)
        sheared = equivalent(faces, blade.shear[:, None] * np.ones(2))
        signed = np.where(faces < 0.0, -sheared, sheared)
        found[blade.name] = np.concatenate([blade.corner, signed], axis=1).ravel()
    return found
