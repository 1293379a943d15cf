"""The exact model of a joint: geometrically exact blades between its bodies, at full stroke."""

from collections.abc import Iterator, Sequence
from math import inf, pi

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.answers.face_stress import POINTS, worst_of_stroke
from flexcli.engine.answers.joint_states import (
    at_rest,
    blades_of,
    driven_axis,
    layout_of,
    over_stroke,
    solved,
    turned,
)
from flexcli.engine.planning.coverage import COVERAGE
from flexcli.errors import SolveError
from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.demand import Held
from flexcli.mechanics.equilibrium import LEVELS
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects, meshes
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.stability import critical_load
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import blade_stress
from flexcli.mechanics.tangent import held_stiffness
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING, Critical
from flexcli.parts.requirements import Answers, Ask, EndStress
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["ExactAnswers", "driven_stiffness"]

Floats = NDArray[np.float64]

TOLERANCE = 1e-9

HOLDS = {
    "clamped-clamped": "neither turns nor moves across the force",
    "clamped-guided": "does not turn",
    "clamped-free": "is free in the plane",
    "pinned-pinned": "is free in the plane",
    "clamped-pinned": "turns but does not move across the force",
}
"""What the ends of a blade mean for the body: which critical load of the joint is asked."""

REACH = 6.0
"""How far a critical load is looked for, over what all blades clamped at both ends would bear."""


class ExactAnswers(Answers):
    """Any rotation, stretching and shear of the blades; stress at both faces all along them.

    ``levels`` are the Gauss nodes on a piece, level by level until the tolerance is met; a single
    one is taken as it is.
    """

    model = "exact"
    covers = COVERAGE["exact"].can
    always = COVERAGE["exact"].always

    def __init__(
        self,
        effects: Effects | None = None,
        tolerance: float = TOLERANCE,
        levels: Sequence[int] = LEVELS,
    ) -> None:
        self.effects = Effects() if effects is None else effects
        self.tolerance = tolerance
        self.levels = levels

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return a hundred tolerances: what is reported is less sure than what is solved for."""
        if kind in (QuantityKind.SUPPORT, QuantityKind.RESPONSE):
            return None
        return ErrorRange(-100.0 * self.tolerance, 100.0 * self.tolerance)

    def stiffness(self, ask: Ask) -> Quantity:
        """Return the stiffness along the motion at rest, shear and stretching included."""
        state = at_rest(ask, self.effects, self.tolerance, self.levels)
        return float(driven_stiffness(state, ask)[0])

    def stiffness_at_end(self, ask: Ask) -> float:
        """Return the tangent of the effort at the end of the stroke, under the case's forces."""
        state = over_stroke(ask, self.effects, self.tolerance, self.levels)
        return float(driven_stiffness(state, ask)[0])

    def sag_stiffness(self, ask: Ask) -> Quantity:
        """Return the stiffness along the case's acceleration, from the 6×6 compliance across z."""
        if ask.scene.axis == "x" and ask.geometry.motion == "translation":
            return self.stiffness(ask)
        from flexcli.mechanics.support import support_compliance

        # a case's x is along the stroke, its y along the axis of symmetry
        index = {"x": 1, "y": 0, "z": 2}[ask.scene.axis]
        try:
            C = support_compliance(layout_of(ask), MOVING, (0.0, 0.0, 0.0))
        except SolveError as error:
            raise NotAvailable(f"has no stiffness along {ask.scene.axis}: {error}") from error
        return float(1.0 / C[index, index])

    def parasitic_shift(self, ask: Ask) -> Quantity:
        """Return the length of the shift at the end of the stroke, positive towards the base."""
        layout, scene, geometry = layout_of(ask), ask.scene, ask.geometry
        reach = scene.travel + scene.mean_travel
        state = solved(
            layout,
            {MOVING: geometry.held(reach)},
            effects=blades_of(layout, self.effects),
            tolerance=self.tolerance,
            levels=self.levels,
        )
        if geometry.motion == "translation":
            return -float(point_motion(state, MOVING, layout.body(MOVING).point)[0, 0])
        x, y = point_motion(state, MOVING, (0.0, 0.0))[0]
        return float(np.copysign(np.hypot(x, y), -x))

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress at both faces where it is greatest, blade by blade."""
        return "stress at the faces, bending with the axial force", list(self._each(ask))

    def _each(self, ask: Ask) -> Iterator[EndStress]:
        state = over_stroke(ask, self.effects, self.tolerance, self.levels)
        for blade in state.layout.blades:
            found = blade_stress(state, blade.name, POINTS)
            faces = {"left": found.left, "right": found.right}
            yield from worst_of_stroke(ask, blade.name, faces)

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the force at which the joint buckles in its plane, either way it may act."""
        scene, layout = ask.scene, layout_of(ask)
        if len(scene.forces) != 1:
            raise NotAvailable("has no exact critical load for forces in several directions")
        ((_, direction),) = scene.forces
        assert scene.ends is not None  # the requirement asks for them
        layout = turned(layout, -direction)
        found = min(
            (self._critical(ask, layout, sign) for sign in (1.0, -1.0)),
            key=lambda critical: float(critical.force),
        )
        return (found,)

    def _critical(self, ask: Ask, layout: Layout, sign: float) -> Critical:
        scene = ask.scene
        ends = scene.ends or ""
        clamped = sum(
            4.0 * pi**2 * float(np.sum(mesh.EI / mesh.l**2))
            for mesh in meshes(layout, blades_of(layout, self.effects), LEVELS[0])
        )
        most = REACH * clamped
        load = Load(MOVING, layout.body(MOVING).point, (sign, 0.0))
        source = f"exact model, the body {HOLDS[ends]}"
        try:
            reached = critical_load(
                layout, _hold(ends), [load], most=most,
                effects=blades_of(layout, self.effects), tolerance=self.tolerance,
                levels=self.levels,
            )  # fmt: skip
        except SolveError as error:
            if error.code != "no-critical-load":
                raise NotAvailable(f"has no exact critical load: {error}") from error
            return Critical(f"no critical force up to {most:.4g} N", inf, source)
        return Critical("in the plane", float(reached.factor), source)


def _hold(ends: str) -> Held:
    across = 0.0 if ends in ("clamped-clamped", "clamped-pinned") else None
    turn = 0.0 if ends in ("clamped-clamped", "clamped-guided") else None
    return {MOVING: (None, across, turn)}


def driven_stiffness(state: Equilibrium, ask: Ask) -> Floats:
    """Return the stiffness of the driven motion at equilibria that hold it (designs,)."""
    held = [axis for axis, motion in enumerate(ask.geometry.held(0.0)) if motion is not None]
    index = held.index(driven_axis(ask.geometry))
    return np.asarray(held_stiffness(state)[:, index, index])
