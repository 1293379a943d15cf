"""The shell model of a mechanism in space: thin shells about rest and at the ends of its strokes.

It has what beams leave out: how a plate bends between its clamps, how it curls and twists along
its length, and the stress at a clamp.
"""

from math import inf

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.beam_peaks import beam_peaks, beam_swings
from flexcli.engine.joint_models.space_errors import shell_errors
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.engine.joint_models.space_stroke import Blades, at_travel, driven_coordinate
from flexcli.errors import SolveError
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.shell.first_guess import SHELL_LEVELS, shells_from_beams
from flexcli.mechanics.shell.stresses import (
    CORNER,
    rod_stresses,
    shell_stresses,
    twisted_corners,
)
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.support import driven_stiffness
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, CriticalShare
from flexcli.results import EXACT, ErrorRange, QuantityKind

__all__ = ["SHELLS", "SpaceShellModel"]

Floats = NDArray[np.float64]

TOLERANCE = 5e-3
"""Of forces and motions from one number of modes to the next: what is left is a quarter or so."""

SHELLS = Blades("shell", shells_from_beams, SHELL_LEVELS, TOLERANCE, shell_errors,
                ((12, 16, 20), 2e-2))  # fmt: skip


class SpaceShellModel(SpaceExactModel):
    """Thin shells about rest, at strokes and under loads."""

    name = "shell"
    at_stroke = "thin shells"
    directs_blades = False
    blades = SHELLS
    stress_kind = "stress at the faces of shells, von Mises"

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the error of its numbers: of thin shells, and of their modes."""
        if kind is not QuantityKind.STIFFNESS or ask.scene.temperature is not None:
            return super().error(ask, kind)
        try:
            state = at_travel(ask, 0.0, self.blades)
        except (NotAvailable, SolveError):
            return None
        known = self.blades.errors(state)
        if known is None or state.coarser is None:
            return None
        change = abs(_driven(state.coarser) / _driven(state) - 1.0) + known.support
        return ErrorRange(-change, change)

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion at rest, all else free [N·m/rad or N/m].

        What a temperature changes is that of beams.
        """
        if ask.scene.temperature is not None:
            return super().stiffness(ask)
        return _driven(at_travel(ask, 0.0, self.blades))

    def critical_shares(self, ask: Ask) -> tuple[CriticalShare, ...]:
        """Return the shares of the loads that buckle it, where beams find the end of their path.

        Where beams lose it, shells would walk for minutes and lose it as well.
        """
        for each in SpaceExactModel().critical_shares(ask):
            if each.share < ask.most_share and each.error is not None and each.error.high == inf:
                raise NotAvailable(
                    "has no buckling load by shells: beams lose the path of the loads"
                )
        return super().critical_shares(ask)

    def signed_stresses(self, state: SpaceEquilibrium) -> dict[str, Floats]:
        """Return von Mises' stress at places of both faces, signed as the stress along [Pa]."""
        return _signed(state, CORNER)

    def swings(self, first: SpaceEquilibrium, last: SpaceEquilibrium) -> dict[str, Floats]:
        """Return half of von Mises' stress of what changes in rods: shells keep their signs."""
        return beam_swings(rod_stresses(first), rod_stresses(last))

    def unsure_stress(self, state: SpaceEquilibrium, largest: float) -> ErrorRange:
        """Return by what share less it is where corners count that are twice as large.

        Or by what more there is nominally in the corners, of twist.
        """
        outside = _signed(state, 2.0 * CORNER).values()
        smaller = max(float(np.max(np.abs(each))) for each in outside)
        less = 1.0 - smaller / largest
        return ErrorRange(-less, max(less, twisted_corners(state) / largest - 1.0))

    def unsure_swing(self, first: SpaceEquilibrium, last: SpaceEquilibrium) -> ErrorRange:
        """Return nothing: shells know how their sections warp."""
        return EXACT


def _signed(state: SpaceEquilibrium, corner: float) -> dict[str, Floats]:
    """Return von Mises' stress at places outside corners of a size, signed as that along [Pa]."""
    found = beam_peaks(rod_stresses(state))
    for blade in shell_stresses(state, corner):
        signed = np.where(blade.along < 0.0, -blade.equivalent, blade.equivalent)
        found[blade.name] = signed.ravel()
    return found


def _driven(state: SpaceEquilibrium) -> float:
    return driven_stiffness(state, driven_coordinate(state.layout))
