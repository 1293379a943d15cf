"""The shell model of a mechanism in space: thin shells about rest and at the ends of its strokes.

It has what beams leave out: how a plate bends between its clamps, how it curls and twists along
its length, and the stress at a clamp. Under other loads than a stroke it is the linear model.
"""

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.space_exact import SpaceExactModel, beam_peaks
from flexcli.engine.joint_models.space_stroke import (
    Blades,
    StrokeErrors,
    at_travel,
    driven_coordinate,
)
from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.shell.first_guess import SHELL_LEVELS, shells_from_beams
from flexcli.mechanics.shell.stresses import rod_stresses, shell_stresses
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.support import driven_stiffness
from flexcli.mechanics.space.layout import SpaceRod
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["SHELLS", "SpaceShellModel"]

Floats = NDArray[np.float64]

TOLERANCE = 5e-3
"""Of forces and motions from one number of modes to the next: what is left is a quarter or so."""

SOLID_ERROR = 0.012
"""Error of a support stiffness against CalculiX's solids of deflected guides, b/l 0.2 and 0.5.

1 % of it by the mesh of the solids."""

EDGE = 0.63
"""Share of h/b by which the edges of a section lessen Saint-Venant's b h³/3 of a thin strip."""

SHEAR = 3.2
"""Share of (h/l)² by which shear across the thickness softens an S shape, E/(κ G) at ν = 1/3."""

THICKEST, STOUTEST = 0.05, 0.2
"""Largest h/l and h/b for which a thin shell's error is told."""

STRESS_ERROR = 0.03
"""Error of the stress at a clamp besides: polynomials swing there by a hundredth or two."""

BUCKLING_ERROR = 0.05
"""Error of a critical share besides: the mass of blades is not among their loads."""


def _of_shells(state: SpaceEquilibrium) -> StrokeErrors | None:
    """Return the errors of thin shells: what they carry of neither shear nor edges."""
    thin = 0.0
    lengths = state.part.assembly.members.lengths
    for blade, l in zip(state.layout.blades, lengths, strict=True):
        if isinstance(blade, SpaceRod):
            continue
        if not isinstance(blade.profile, Constant):
            return None
        h = float(blade.profile.h)
        if h > THICKEST * l or h > STOUTEST * blade.b:
            return None
        thin = max(thin, EDGE * h / blade.b + SHEAR * (h / l) ** 2)
    support = SOLID_ERROR + thin
    return StrokeErrors(support, support, support + STRESS_ERROR, support + BUCKLING_ERROR)


SHELLS = Blades("shell", shells_from_beams, SHELL_LEVELS, TOLERANCE, _of_shells,
                ((12, 16, 20), 2e-2))  # fmt: skip


class SpaceShellModel(SpaceExactModel):
    """The linear model about other loads, thin shells about rest and at strokes."""

    name = "shell"
    at_stroke = "thin shells"
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

    def signed_stresses(self, state: SpaceEquilibrium) -> dict[str, Floats]:
        """Return von Mises' stress at places of both faces, signed as the stress along [Pa]."""
        found = beam_peaks(rod_stresses(state))
        for blade in shell_stresses(state):
            signed = np.where(blade.along < 0.0, -blade.equivalent, blade.equivalent)
            found[blade.name] = signed.ravel()
        return found


def _driven(state: SpaceEquilibrium) -> float:
    return driven_stiffness(state, driven_coordinate(state.layout))
