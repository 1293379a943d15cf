"""The linear model of a joint: exact beams under small motion, with shear and stretching."""

from collections.abc import Sequence
from math import inf, nan
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.blade_weight import LEAST, BladeWeights, forced_stress
from flexcli.engine.joint_models.buckling import linear_critical_forces
from flexcli.engine.joint_models.exact import ExactModel, hanging
from flexcli.engine.joint_models.face_stress import largest_at_faces, worst_of_stroke
from flexcli.engine.joint_models.holds import driven_axis, hold_of
from flexcli.engine.joint_models.joint_states import layout_of, linearly, of_case
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.engine.planning.coverage import COVERAGE, covered
from flexcli.formulas.quantity import Computed
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Layout, Load, Number
from flexcli.mechanics.linear import NODES
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.own_weight import blade_places, direction
from flexcli.mechanics.stresses import BladeStress, beside_beam
from flexcli.numerics.rows import isfinite, larger, largest_of_each, of_each, states_of
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING, Critical
from flexcli.parts.requirements import AS_PRINTED, Ask, EndStress, JointModel
from flexcli.parts.requirements.closed_form import across_width
from flexcli.results import EXACT, ErrorRange, QuantityKind

if TYPE_CHECKING:
    from flexcli.mechanics.space.swept_box import SweptBox

__all__ = ["LinearModel", "LinearState"]

Floats = NDArray[np.float64]

AT_REST = (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY)

LEVELS = (16, NODES, 36, 54, 81, 122)
"""Gauss nodes on a piece, until the stiffness settles."""

SETTLED = 1e-9
"""Change from level to level at which it does [-]."""

STRETCH = 0.35, 1.2
"""Twice what an end's motion across a blade over its thickness changes, first and second order."""

KNOWN = 0.3
"""Change above which no order tells it."""

TURNS, AMPLITUDE = 2.0, 3.0
"""What the square of the largest rotation changes of a stress; of an amplitude beside a load, that
changes as the slope of what is of third order does, so many times as much."""

ROUNDING = 1e-10
"""Least error that a linear solution is taken to have [-]."""


class LinearState(NamedTuple):
    """The layout that was asked, as it stood, with motions and the forces on its blades' ends."""

    layout: Layout
    motions: Floats
    end_forces: Floats


class LinearModel(JointModel):
    """Small motion of the assembled blades; the shift is that of the closed forms."""

    name = "linear"
    always = COVERAGE["linear"].always
    weighs_blades = True
    directs_in_plane = True

    def __init__(self, effects: Effects | None = None) -> None:
        self.effects = Effects() if effects is None else effects
        self.covers = covered("linear", self.effects)
        self._known: Remembered[tuple[list[EndStress], float]]
        self._known = Remembered("linear", of_blades=True)
        self._known_stiffness: Remembered[tuple[float, int, float]]
        self._known_stiffness = Remembered("linear", of_blades=True)

    def error(self, ask: Ask, kind: QuantityKind) -> ErrorRange | None:
        """Return the error of a linear solution: that of its nodes, which its stiffness tells.

        Of stresses it is known only where effects tell what else a linear model leaves out. A
        shift is the closed form's, without the shear and stretching that this model carries.
        """
        if kind is QuantityKind.SHIFT:
            return None
        if kind is QuantityKind.SAG:
            return ExactModel(self.effects).error(ask, kind)
        at_rest = kind in AT_REST
        known = EXACT if at_rest else AS_PRINTED.error(ask, kind)
        if known is None or kind not in (*AT_REST, QuantityKind.STRESS):
            return known
        try:
            _, _, error = self._settled(ask)
            if kind is QuantityKind.STRESS:
                error += self._judged(ask)[1]
        except NotAvailable:
            return None
        return known + ErrorRange(-error, error) if isfinite(error) else None

    def stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the motion [N·m/rad or N/m]."""
        _refuse_temperature(ask)
        return self._settled(ask)[0]

    def _settled(self, ask: Ask) -> tuple[float, int, float]:
        """Return the stiffness, the nodes that it takes, its relative error."""
        return self._known_stiffness.of("stiffness", ask, lambda: self._find_stiffness(ask))

    def _find_stiffness(self, ask: Ask) -> tuple[float, int, float]:
        layout, axis = layout_of(ask), driven_axis(ask.geometry)
        found, error, nodes = nan, inf, 0
        for nodes in LEVELS:
            before = found
            held = {MOVING: ask.geometry.held(1.0)}
            solution = linearly(layout, held, effects=self.effects, nodes=nodes)
            found = of_each(solution.reactions[:, layout.index(MOVING), axis])
            error = abs(before / found - 1.0) if isfinite(before) else inf
            if error <= SETTLED:
                break
        return found, nodes, larger(error, ROUNDING)

    def sag_stiffness(self, ask: Ask) -> Computed:
        """Return the stiffness along the case's acceleration [N/m]."""
        if not ask.geometry.sags_along_stroke(ask.scene.axis):
            return 1.0 / hanging(ask).found
        return ExactModel(self.effects).sag_stiffness(ask)

    def carries(self, ask: Ask, kind: QuantityKind) -> frozenset[EffectName]:
        """Return what the springs in space and their error have of a sag off the stroke."""
        return ExactModel(self.effects).carries(ask, kind)

    def envelope(self, ask: Ask) -> tuple["SweptBox", tuple[str, ...]]:
        """Return the box around the joint in space, and the bodies that have no outline."""
        from flexcli.engine.joint_models.space_box import linear_box

        return linear_box(ask)

    def parasitic_shift(self, ask: Ask) -> Computed:
        """Return the closed form's: a linear model has no motion of second order."""
        return AS_PRINTED.parasitic_shift(ask)

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the forces at which the joint buckles at rest, its blades straight until then."""
        return (*linear_critical_forces(ask, self.effects), *across_width(ask))

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stress at both faces where it is greatest, blade by blade."""
        _refuse_temperature(ask)
        return "stress at the faces, bending with the axial force", self._judged(ask)[0]

    def _judged(self, ask: Ask) -> tuple[list[EndStress], float]:
        """Return the worst stresses of a case, and how far the largest may be off.

        By the weight of blades, and by what hinges have beside beams.
        """
        return self._known.of("stresses", ask, lambda: self._judge_stress(ask))

    def _judge_stress(self, ask: Ask) -> tuple[list[EndStress], float]:
        _, nodes, _ = self._settled(ask)
        found = of_case(ask, lambda layout, held, loads: self._solved(layout, held, loads, nodes))
        weights, stresses, most, off = BladeWeights.of(ask), list[EndStress](), 0.0, 0.0
        for index, blade in enumerate(found.layout.blades):
            axial, bending = forced_stress(blade, found.end_forces[:, index])
            s, h = blade_places(blade, blade.length)
            hinge, own = beside_beam(blade, BladeStress(s, bending, axial, h)), 0.0
            if weights is not None:
                added = weights.stress(index)
                own = weights.off(index, added, axial, bending, found.motions)
                axial, bending = axial + added[0], bending + added[1]
            if hinge is not None:
                bending = bending + hinge[0]
            faces = {"left": states_of(axial - bending), "right": states_of(axial + bending)}
            here = largest_at_faces(faces)
            if hinge is not None:
                own += largest_at_faces(faces, states_of(hinge[1])) - here
            most, off = larger(most, here), larger(off, own)
            stresses.extend(worst_of_stroke(ask, blade.name, faces))
        found_off = off / larger(most, LEAST)
        if hold_of(ask.scene).across and ask.scene.is_loaded and not ask.scene.moves:
            found_off = found_off + _by_stretching(found)
        if ask.scene.beyond:  # effects tell what loads do of which there are closed forms
            times = AMPLITUDE if ask.scene.moves else 1.0
            found_off = found_off + times * _beyond_first_order(found)
        return stresses, found_off

    def _solved(self, layout: Layout, held: Held, loads: Sequence[Load], nodes: int) -> LinearState:
        found = linearly(layout, held, loads, effects=self.effects, nodes=nodes)
        return LinearState(layout, found.motions, found.end_forces)


def _by_stretching(found: LinearState) -> Number:
    """Return what stretching changes of the stress of a blade whose end is held along it.

    By w/h, its end's motion across it over its thickness: the stretch w²/2l² pulls the blade,
    which bears a share of 6 (w/h)²/10 of what bends it, and stresses it by w/6h of its bending.
    """
    layout, most = found.layout, np.zeros(len(found.motions))
    bodies = [body.name for body in layout.bodies]
    for blade in layout.blades:
        c, s = direction(blade)
        swing = np.zeros(len(found.motions))
        for name, at, sense in ((blade.first, blade.start, -1.0), (blade.second, blade.end, 1.0)):
            if name not in bodies:
                continue
            index = bodies.index(name)
            x, y, phi = found.motions[:, index].T
            arm = [a - p for a, p in zip(at, layout.bodies[index].point, strict=True)]
            swing = swing + sense * (c * (y + phi * arm[0]) - s * (x - phi * arm[1]))
        _, h = blade_places(blade, blade.length)
        most = np.maximum(most, np.abs(swing) / np.min(h, axis=-1))
    share = largest_of_each(states_of(most[:, None]))
    change = share * (STRETCH[0] + STRETCH[1] * share)
    return change if change < KNOWN else inf


def _beyond_first_order(found: LinearState) -> Number:
    """Return what rotations and axial forces change of the stress of a linear state, relative.

    An axial force N raises the moment at the root of a blade with a free end by 1/cos √n − 1 at
    most, n = N l²/EI: less than 4/π s/(1 − s) for the share s = 4 n/π² of what buckles it.
    """
    layout = found.layout
    lengths = [float(np.min(blade.length)) for blade in layout.blades]
    turned = np.abs(found.motions[:, :, 2]).max(axis=1)
    shifted = np.hypot(found.motions[:, :, 0], found.motions[:, :, 1]).max(axis=1)
    turned, pushed = np.maximum(turned, shifted / min(lengths)), np.zeros(len(turned))
    for index, (blade, l) in enumerate(zip(layout.blades, lengths, strict=True)):
        axial, _ = forced_stress(blade, found.end_forces[:, index])
        _, h = blade_places(blade, blade.length)
        E = layout.E * blade.stiffer
        n = 12.0 * np.abs(axial).max(axis=-1) * l**2 / (E * np.min(h, axis=-1) ** 2)
        pushed = np.maximum(pushed, 4.0 * n / np.pi**2)
    with np.errstate(divide="ignore"):
        softer = np.where(pushed < KNOWN, 4.0 / np.pi * pushed / (1.0 - pushed), inf)
    change = largest_of_each(states_of((TURNS * turned**2 + softer)[:, None]))
    return change if change < KNOWN else inf


def _refuse_temperature(ask: Ask) -> None:
    """Leave a temperature to the exact model: what it stretches stiffens and softens the rest."""
    if ask.scene.temperature is not None:
        raise NotAvailable("has no linear model of a temperature")
