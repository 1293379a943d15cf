"""The linear model of a joint: exact beams under small motion, with shear and stretching."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.answers.exact import ExactAnswers
from flexcli.engine.answers.face_stress import blade_places, worst_of_stroke
from flexcli.engine.answers.joint_states import blades_of, case_demand, driven_axis, layout_of
from flexcli.engine.planning.coverage import COVERAGE
from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.linear import linear
from flexcli.mechanics.mesh import Effects
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING, Critical
from flexcli.parts.requirements import AS_PRINTED, Answers, Ask, EndStress
from flexcli.results import EXACT, ErrorRange, QuantityKind

__all__ = ["LinearAnswers"]

Floats = NDArray[np.float64]


class LinearAnswers(Answers):
    """Small motion of the assembled blades; shift and buckling are those of the closed forms."""

    model = "linear"
    covers = COVERAGE["linear"].can
    always = COVERAGE["linear"].always

    def __init__(self, effects: Effects | None = None) -> None:
        self.effects = Effects() if effects is None else effects

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return none at rest; what motion adds is known where the closed forms know it."""
        if kind in (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY, QuantityKind.SAG):
            return EXACT
        return AS_PRINTED.error(ask, kind)

    def stiffness(self, ask: Ask) -> Quantity:
        """Return the stiffness along the motion [N·m/rad or N/m]."""
        layout, axis = layout_of(ask), driven_axis(ask.geometry)
        found = linear(
            layout, {MOVING: ask.geometry.held(1.0)}, effects=blades_of(layout, self.effects)
        )
        return float(found.reactions[0, layout.index(MOVING), axis])

    def sag_stiffness(self, ask: Ask) -> Quantity:
        """Return the stiffness along the case's acceleration [N/m]."""
        return ExactAnswers(self.effects).sag_stiffness(ask)

    def parasitic_shift(self, ask: Ask) -> Quantity:
        """Return the closed form's: a linear model has no motion of second order."""
        return AS_PRINTED.parasitic_shift(ask)

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the closed form's: Euler's load of the most loaded blade."""
        return AS_PRINTED.critical(ask)

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress at both faces where it is greatest, blade by blade."""
        return "stress at the faces, bending with the axial force", list(self._each(ask))

    def _each(self, ask: Ask) -> Iterator[EndStress]:
        layout = layout_of(ask)
        held, loads = case_demand(ask, layout)
        found = linear(layout, held, loads=loads, effects=blades_of(layout, self.effects))
        if not found.unique.all():
            raise NotAvailable("has no unique linear solution: hold or support every body")
        for index, blade in enumerate(layout.blades):
            force = found.end_forces[:, index]
            start, end = np.array(blade.start), np.array(blade.end)
            l = float(np.hypot(*(end - start)))
            along = (end - start) / l
            s, h = blade_places(blade, l)
            N = force[:, :2] @ along
            V = force[:, :2] @ np.array([-along[1], along[0]])
            M = force[:, 2:] + V[:, None] * (l - s)
            axial, bending = N[:, None] / (blade.b * h), 6.0 * M / (blade.b * h**2)
            faces = {"left": axial - bending, "right": axial + bending}
            yield from worst_of_stroke(ask, blade.name, faces)
