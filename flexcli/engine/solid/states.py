"""A solid model as a solver of joints: motions, reactions, stresses of what is held or loaded."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.joint_states import states_of
from flexcli.engine.solid.calculix import Printed
from flexcli.engine.solid.deck import Deck, State, states_deck
from flexcli.engine.solid.deck_model import MM, MPA
from flexcli.engine.solid.model import SolidModel, Stretch, solid_model
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Layout, Load

__all__ = ["FaceStress", "Runner", "SolidStates", "solid_states"]

Floats = NDArray[np.float64]

Runner = Callable[[Deck], Printed]
"""Runs a deck, or says why it does not."""


class FaceStress(NamedTuple):
    """Stress along the faces of a stretch [Pa], the mean over its width, at places s [m]."""

    stretch: Stretch
    s: Floats
    left: Floats
    right: Floats


@dataclass(frozen=True, eq=False)
class SolidStates:
    """Equilibria of a solid model, one after the other.

    ``motions`` and ``reactions`` (states, bodies of the layout, 3) are x, y, φ of each body's
    point [m, m, rad] and what holds it there [N, N, N·m].
    """

    model: SolidModel
    motions: Floats
    reactions: Floats
    printed: Printed

    def face_stresses(self, state: int) -> tuple[FaceStress, ...]:
        """Return the stress along both faces of every stretch in a state."""
        moved = list(self.printed.fields("DISP"))[state]
        stress = list(self.printed.fields("STRESS"))[state]
        return tuple(_face_stress(stretch, moved, stress) for stretch in self.model.stretches)


def solid_states(
    layout: Layout,
    held: Held,
    loads: Sequence[Load],
    runner: Runner,
    *,
    fineness: int,
    is_linear: bool = False,
    stiffness: Floats | None = None,
) -> SolidStates:
    """Return the states that motions and loads, numbers or arrays of one for each, ask for.

    They move in the plane: half of each blade is modelled. ``is_linear``: small motion from rest.
    ``stiffness`` is that of :func:`solid_model`.
    """
    model = solid_model(layout, fineness=fineness, is_half=True, stiffness=stiffness)
    states = [State(*each) for each in states_of(held, loads)]
    deck = states_deck(model, states, is_linear=is_linear)
    printed = runner(deck)
    moved, forces = list(printed.tables("displacements")), list(printed.tables("forces"))
    motions = np.zeros((len(states), len(layout.bodies), 3))
    reactions = np.zeros_like(motions)
    for k, body in enumerate(layout.bodies):
        ref, rot = deck.bodies[body.name]
        for i in range(len(states)):
            motions[i, k] = *(moved[i][ref][:2] / MM), moved[i][rot][2]
            force = np.array([*forces[i][ref][:2], forces[i][rot][2] / MM])
            reactions[i, k] = force / model.share
    return SolidStates(model, motions, reactions, printed)


def _face_stress(
    stretch: Stretch, moved: dict[int, Floats], stress: dict[int, Floats]
) -> FaceStress:
    """Return the stress along the moved faces, where every node across the width has one."""
    solid, found = stretch.bricks, []
    weight = _simpson(solid.places[solid.face(0)[0], 2])
    for side in (-1, 0):
        numbers = solid.face(side)[::2]
        rows = numbers + stretch.first_node + 1
        u = np.array([[moved[n] for n in row] for row in rows])
        S = np.array([[stress[n] for n in row] for row in rows]) / MPA
        there = stretch.places[numbers] + u / MM
        way = np.gradient(there, solid.places[numbers[:, 0], 0], axis=0)
        way /= np.linalg.norm(way, axis=-1, keepdims=True)
        x, y, z = np.moveaxis(way, -1, 0)
        xx, yy, zz, xy, yz, zx = np.moveaxis(S, -1, 0)
        along = x * x * xx + y * y * yy + z * z * zz + 2.0 * (x * y * xy + y * z * yz + z * x * zx)
        found.append(along @ weight)
    s = solid.places[solid.face(0)[::2, 0], 0]
    return FaceStress(stretch, s, found[0], found[1])


def _simpson(z: Floats) -> Floats:
    """Return the weights of a mean over places at the ends and the middle of each element."""
    weight = np.zeros(z.size)
    for k in range(0, z.size - 1, 2):
        weight[k : k + 3] += np.array([1.0, 4.0, 1.0]) / 6.0 * (z[k + 2] - z[k])
    return np.asarray(weight / (z[-1] - z[0]))
