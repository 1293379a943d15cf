"""A body on one joint as a structure about where its stroke holds it, by exact beams.

Blades that are bent give way along themselves, a force along them bends them further, and a base
that shakes along them moves the body along its stroke.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.lateral_bound import least_thickness
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.stresses import blade_stress
from flexcli.parts.geometries.base import GROUND, MOVING
from flexcli.parts.mechanisms.carried import is_guided
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.structure import Structure

__all__ = ["structures_at_stroke"]

Floats = NDArray[np.float64]

STEP = 0.03
"""Steps of the differences over h²/l, and over (h/l)² of a rotation: a 25th of what buckles a blade
that is pushed by as much. Half of them changed a stiffness by 2e-6 at most, and at rest it was 2e-7
from the blades' own."""


class _Bent(NamedTuple):
    """What moves of a body cause, by the move: what holds it, axial stress, and at both faces."""

    holding: Floats
    axial: Floats
    faces: Floats


def structures_at_stroke(ask: Ask, structures: Sequence[Structure]) -> tuple[Structure, ...] | None:
    """Return structures of the same joint, each about both ends of the stroke of its case.

    ``structures`` are those of small motion from rest. Coordinates of the body are along its own
    axes, which turn with it. Nothing where no exact beams tell it: of several joints or bodies,
    blades of varying thickness, or beside loads.
    """
    scene, geometry = ask.scene.standing, ask.geometry
    assert scene is not None  # there is a stroke
    layout = geometry.blades_layout(ask.material.elastic, ask.sizes)
    plain = all(
        isinstance(blade.profile, Constant) and {blade.first, blade.second} == {GROUND, MOVING}
        for blade in layout.blades
    )
    alone = len(layout.bodies) == len(structures[0].joint_motions) == 1
    if not (plain and alone) or scene.is_loaded or scene.temperature is not None or layout.supports:
        return None
    travels = np.array([float(end) for end in scene.stroke_ends])
    x, y, turn = geometry.held(1.0)
    held = [None if each is None else each * travels for each in (x, y, turn)]
    if is_guided(geometry):
        held[2] = 0.0 * travels
    try:
        reached = solve(layout, {MOVING: (held[0], held[1], held[2])}).checked().motions[:, 0]
        rest, *bent = (_slopes(layout, at) for at in (np.zeros(3), *reached))
    except SolveError:
        return None
    return tuple(
        _about(structure, rest, there, float(at[2]))
        for structure in structures
        for there, at in zip(bent, reached, strict=True)
    )


def _slopes(layout: Layout, at: Floats) -> _Bent:
    """Return by central differences what a move of the body from a place changes there.

    Stresses are in the order of the outputs of a structure: those at both ends of each blade.
    """
    lengths = [float(np.hypot(*np.subtract(b.end, b.start))) for b in layout.blades]
    thin = [float(least_thickness(blade)) for blade in layout.blades]
    small = min(h**2 / l for h, l in zip(thin, lengths, strict=True))
    steps = STEP * small * np.array([1.0, 1.0, 1.0 / max(lengths)])
    moved = at + np.concatenate([np.diag(steps), -np.diag(steps)])
    found = solve(layout, {MOVING: (moved[:, 0], moved[:, 1], moved[:, 2])}).checked()
    each = [blade_stress(found, blade.name, points=2) for blade in layout.blades]
    axial = np.concatenate([stress.axial for stress in each], axis=1)
    bending = np.concatenate([stress.bending for stress in each], axis=1)
    faces = np.concatenate([axial + bending, axial - bending], axis=1)
    return _Bent(*(
        ((values[:3] - values[3:]) / (2.0 * steps[:, None])).T
        for values in (found.reactions[:, 0], axial, faces)
    ))  # fmt: skip


def _about(structure: Structure, rest: _Bent, there: _Bent, turn: float) -> Structure:
    """Return a structure about a place, from what moves cause there and at rest."""
    c, s = np.cos(turn), np.sin(turn)
    own = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    ((name, rows),) = structure.joint_motions.items()
    holding = own.T @ there.holding @ own - rest.holding
    holding = (holding + holding.T) / 2.0
    wrench = structure.wrenches[name] + holding @ rows
    outputs = dict(structure.outputs)
    outputs[f"force {name}"] = wrench[None, :2]
    axial, faces = ("axial stress", there.axial, rest.axial), ("stress", there.faces, rest.faces)
    for what, one, other in (axial, faces):
        key = f"{what} {name}"
        outputs[key] = outputs[key] + (one @ own - other) @ rows
    return replace(
        structure,
        stiffness=structure.stiffness + rows.T @ holding @ rows,
        pull=_turned(structure.pull, c, s),
        outputs=outputs,
        wrenches={name: wrench},
    )


def _turned(pull: Mapping[str, Floats], c: float, s: float) -> dict[str, Floats]:
    """Return the inertial forces along the axes of the body, of a base that moves along its own."""
    return {"x": c * pull["x"] - s * pull["y"], "y": s * pull["x"] + c * pull["y"]}
