"""A body on one joint as a structure about where its stroke holds it, by exact beams.

Blades that are bent give way along themselves, a force along them bends them further, and a base
that shakes along them moves the body along its stroke.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Piece
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stress_places import stress_places
from flexcli.mechanics.stresses import blade_stress
from flexcli.mechanics.tangent import held_stiffness
from flexcli.numerics.modes import natural_modes
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.loads_in_plane import loads_in_plane, senses_in_plane
from flexcli.parts.mechanisms.carried import is_guided
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.scene import Scene
from flexcli.parts.structure import Structure, bending_rows, turned

__all__ = ["structures_at_stroke", "unlike_beams"]

Floats = NDArray[np.float64]

STEP = 0.03
"""Steps of the differences over h²/l, and over (h/l)² of a rotation: a 25th of what buckles a blade
that is pushed by as much. Half of them changed a stiffness by 2e-6 at most, and at rest it was 2e-7
from the blades' own."""

SHARES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Of the way to an end of a stroke: modes move on it, and one that meets a frequency between two of
them is put onto it."""

BENT = np.linspace(-1.0, 1.0, 9)
"""Places along a uniform piece: the moment of a force along it follows how it is bent, and may be
largest between its ends."""


UNSHEARED = Effects(shear=False)
"""What beams do that the structure at rest has as well."""


class _Bent(NamedTuple):
    """What moves of the bodies cause, by the move (…, 3 bodies): forces that hold them, stresses.

    ``axial`` is that of the axial forces, ``faces`` at both faces, ``unsure`` what it may be off.
    """

    holding: Floats
    axial: Floats
    faces: Floats
    unsure: list[Floats]


def structures_at_stroke(
    ask: Ask, structures: Sequence[Structure]
) -> tuple[tuple[Structure, ...], ...] | None:
    """Return structures of the same joint on their ways to the ends of the stroke of its case.

    Of each structure, for each end and each sense in which static loads act: about the middle, and
    about :data:`SHARES` of the way to the end, under the loads. ``structures`` are those of small
    motion from rest without load. Coordinates of bodies are along their own axes, which turn with
    them. Nothing where no exact beams tell it: of several joints, on springs, beside loads out of
    the plane, or where the joint does not stay with its drive free.
    """
    scene, geometry = ask.scene.standing, ask.geometry
    assert scene is not None  # there is a stroke
    layout = geometry.blades_layout(ask.material.elastic, ask.sizes)
    if len(structures[0].joint_motions) > 1 or layout.supports or not _is_told(ask, scene):
        return None
    ends, signs = tuple(dict.fromkeys(map(float, scene.stroke_ends))), senses_in_plane(scene)
    groups, moves = signs.shape[1], 6 * len(layout.bodies)
    # rest without loads, then the ways under each combination of their senses
    travels = np.concatenate([[0.0], np.tile(np.outer(ends, SHARES).ravel(), len(signs))])
    senses = np.concatenate([
        np.zeros((1, groups)), np.repeat(signs, len(ends) * len(SHARES), axis=0)
    ])  # fmt: skip
    try:
        stands = _standing(ask, scene, layout, np.repeat(travels, moves), senses, moves)
        if stands.unstable.any():
            return None
        loads = _loads(ask, scene, layout, np.repeat(senses, moves, axis=0))
        places = stands.motions[::moves]
        rest, *bent = _slopes(layout, stands, places, loads)
    except SolveError:
        return None
    found = [
        [
            _about(structure, layout, geometry.axes, rest, there, at)
            for there, at in zip(bent, places[1:], strict=True)
        ]
        for structure in structures
    ]
    if not all(map(_is_stable, (each for one in found for each in one))):
        return None
    return tuple(
        tuple(one[k : k + len(SHARES)]) for one in found for k in range(0, len(one), len(SHARES))
    )


def _is_told(ask: Ask, scene: Scene) -> bool:
    """Return whether what stands beside a vibration acts in the plane, and where it is known.

    A weight acts at the centre of mass of what is carried, which swings on the body's point where
    it is off that.
    """
    if scene.temperature is not None or scene.in_space:
        return False
    off = any(wrench[i] for wrench in (scene.stated, *scene.inertial) for i in scene.across)
    if off or any(field[2] for field in scene.accelerations):
        return False
    weighs = any(map(any, scene.inertial))
    moving = ask.geometry.blades_layout(ask.material.elastic, ask.sizes).body(MOVING)
    hangs = ask.mechanism is not None and (
        ask.mechanism.arm != 0.0 or ask.geometry.payload_point(moving.point) != moving.point
    )
    return not (weighs and hangs)


def _loads(ask: Ask, scene: Scene, layout: Layout, senses: Floats) -> list[Load]:
    """Return what acts on the bodies of a joint, with its senses (states, groups)."""
    density = ask.material.density
    weight = 0.0 if density is None else density.value
    return loads_in_plane(scene, layout, weight, senses, 0.0)


def unlike_beams(ask: Ask) -> float | None:
    """Return by what share hinges and crossings may be bent further by a force than their beams.

    Its lever is how far they are bent aside, as their shift is, and what a solid crossing keeps
    from bending the halves of blades bend more. None of notches that no solids were compared with.
    """
    thick = ask.geometry.thick_notches(ask.sizes)
    shares = [*map(float, ask.geometry.crossed(ask.sizes))]
    if thick is not None:
        if thick.factor is None:
            return None
        shares += [float(share) for share in thick.shift]
    return max(abs(share - 1.0) for share in shares)


def _standing(
    ask: Ask, scene: Scene, layout: Layout, travels: Floats, senses: Floats, times: int
) -> Equilibrium:
    """Return the joint at travels of its drive under loads, all else free but for a guide.

    Travels are from where loads leave the joint, whose senses (states, groups) are each for so many
    ``times`` of them.
    """
    x, y, turn = ask.geometry.held(1.0)
    guided = 0.0 if is_guided(ask.geometry) else turn
    drive = 1 if y is not None else 2
    loads = _loads(ask, scene, layout, senses)
    if loads:
        left = solve(
            layout, {MOVING: (None, None, guided if drive == 1 else None)},
            loads=loads, effects=UNSHEARED,
        ).checked()  # fmt: skip
        travels = travels + np.repeat(left.motions[:, layout.index(MOVING), drive], times)
    held = [None if each is None else each * travels for each in (x, y, turn)]
    if is_guided(ask.geometry):
        held[2] = 0.0 * travels
    loads = _loads(ask, scene, layout, np.repeat(senses, times, axis=0))
    return solve(
        layout, {MOVING: (held[0], held[1], held[2])}, loads=loads, effects=UNSHEARED
    ).checked()


def _is_stable(structure: Structure) -> bool:
    """Return whether it stays where it is, its drive free."""
    try:
        natural_modes(structure.stiffness, structure.mass)
    except ValueError:
        return False
    return True


def _slopes(
    layout: Layout, stands: Equilibrium, places: Floats, loads: Sequence[Load] = ()
) -> Iterator[_Bent]:
    """Yield what moves of the bodies from each of their places change, stresses by differences.

    ``stands`` are the equilibria there under loads, ``places`` (states, bodies, 3), each as often
    as there are moves. Stresses are in the order of the outputs of a structure. The stiffness is
    the mean of the tangents on either side: that of the joint's own motion is a small part of its
    blades', and differences leave of it 1e-3.
    """
    bodies, steps = len(layout.bodies), _steps(layout)
    moves = np.concatenate([np.diag(steps), -np.diag(steps)])
    at = places.reshape(len(places), 1, 3 * bodies) + moves
    each = at.reshape(-1, bodies, 3)
    held = {body.name: tuple(each[:, i].T) for i, body in enumerate(layout.bodies)}
    found = solve(layout, held, loads=loads, effects=UNSHEARED, start=stands).checked()
    holding = held_stiffness(found)
    stresses = [blade_stress(found, blade.name, places=_places) for blade in layout.blades]
    for first in range(0, len(each), len(moves)):
        here = slice(first, first + len(moves))

        def slope(values: Floats, here: slice = here) -> Floats:
            plus, minus = np.split(values[here].reshape(len(moves), -1), 2)
            return np.asarray(((plus - minus) / (2.0 * steps[:, None])).T)

        axial = np.concatenate([slope(stress.axial) for stress in stresses])
        bending, unsure = bending_rows(
            (blade, stress.s[0], stress.h[0], slope(stress.bending))
            for blade, stress in zip(layout.blades, stresses, strict=True)
        )
        faces = np.concatenate([axial + bending, axial - bending])
        yield _Bent(holding[here].mean(axis=0), axial, faces, unsure)


def _steps(layout: Layout) -> Floats:
    """Return the steps of the differences along and about each body's axes (3 bodies,)."""
    lengths = [float(blade.length) for blade in layout.blades]
    thin = [float(blade.least_thickness) for blade in layout.blades]
    small, found = min(h**2 / l for h, l in zip(thin, lengths, strict=True)), list[float]()
    for body in layout.bodies:
        ends = [
            end
            for blade in layout.blades
            for name, end in ((blade.first, blade.start), (blade.second, blade.end))
            if name == body.name
        ]
        arms = [float(np.hypot(*np.subtract(end, body.point))) for end in ends]
        found += [1.0, 1.0, 1.0 / max(*arms, *lengths)]
    return STEP * small * np.array(found)


def _places(piece: Piece) -> Floats:
    """Return the places of a piece at which the stress of a bent blade is looked at."""
    return BENT if piece.is_uniform else stress_places(piece)


def _between(blade: Blade) -> Floats:
    """Return what takes rows of stress of a straight blade to the places of a bent one.

    The moment of small motion is linear along a piece, and that of what swings inside a blade is
    taken to be so.
    """
    parts = [
        np.stack([1.0 - BENT, 1.0 + BENT], axis=1) / 2.0
        if piece.is_uniform
        else np.eye(stress_places(piece).size)
        for piece in blade.profile.pieces(float(blade.length))
    ]
    return _diagonal(parts)


def _diagonal(parts: Sequence[Floats]) -> Floats:
    """Return matrices along the diagonal of one."""
    ends = np.cumsum([np.zeros(2, dtype=int), *(part.shape for part in parts)], axis=0)
    whole = np.zeros(tuple(ends[-1]))
    for part, (i, j) in zip(parts, ends[:-1], strict=True):
        whole[i : i + part.shape[0], j : j + part.shape[1]] = part
    return whole


def _about(
    structure: Structure, layout: Layout, axes: float, rest: _Bent, there: _Bent, at: Floats
) -> Structure:
    """Return a structure about a place (bodies, 3), from what moves cause there and at rest.

    ``axes`` is the angle from the layout's x to that of the structure [rad].
    """
    ((name, driven),) = structure.joint_motions.items()
    own = _diagonal([_turn(float(turn)) for turn in at[:, 2]])
    rows = np.concatenate([
        driven if body.name == MOVING else _along(structure.bodies[f"{name} {body.name}"], axes)
        for body in layout.bodies
    ])  # fmt: skip
    holding = own.T @ there.holding @ own - rest.holding
    holding = (holding + holding.T) / 2.0
    first = 3 * layout.index(MOVING)
    wrench = structure.wrenches[name] + holding[first : first + 3] @ rows
    outputs, between = dict(structure.outputs), list(map(_between, layout.blades))
    outputs[f"force {name}"] = wrench[None, :2]

    def moved(before: Floats, blades: Sequence[Floats], one: Floats, other: Floats) -> Floats:
        return np.asarray(_diagonal(blades) @ before + (one @ own - other) @ rows)

    axial, faces = f"axial stress {name}", f"stress {name}"
    outputs[axial] = moved(outputs[axial], between, there.axial, rest.axial)
    outputs[faces] = moved(outputs[faces], 2 * between, there.faces, rest.faces)
    unsure = {
        (name, k): moved(structure.unsure[name, k], between, one, other)
        for k, (one, other) in enumerate(zip(there.unsure, rest.unsure, strict=True))
    }
    turns = _turns(structure, name, layout, at)
    return replace(
        structure,
        stiffness=structure.stiffness + rows.T @ holding @ rows,
        pull=_turned(structure.pull, np.cos(turns), np.sin(turns)),
        outputs=outputs,
        wrenches={name: wrench},
        unsure=unsure,
    )


def _turn(angle: float) -> Floats:
    """Return the axes (x, y, φ) of a body that is turned, in the columns."""
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _along(motion: Floats, axes: float) -> Floats:
    """Return rows (x, y, φ) of a motion along the axes of the layout."""
    u, v, turn = motion
    return np.stack([*turned((u, v), axes), turn])


def _turns(structure: Structure, name: str, layout: Layout, at: Floats) -> Floats:
    """Return by what angle each coordinate's axes are turned at a place (bodies, 3) [rad].

    Those of a body turn with it, and those of what swings inside a blade with its chord.
    """
    turns = np.zeros(structure.mass.shape[0])
    ends = np.cumsum([_between(blade).shape[1] for blade in layout.blades])
    rows = np.split(structure.outputs[f"stress {name}"][: ends[-1]], ends[:-1])
    for blade, stress in zip(layout.blades, rows, strict=True):
        turns[np.abs(stress).sum(axis=0) > 0.0] = _chord_turn(blade, layout, at)
    carried = next(iter(structure.bodies))  # the moving body is a part of it
    for body, (_, _, turn) in zip(layout.bodies, at, strict=True):
        own = structure.bodies[carried if body.name == MOVING else f"{name} {body.name}"]
        turns[np.abs(own).sum(axis=0) > 0.0] = turn
    return turns


def _chord_turn(blade: Blade, layout: Layout, at: Floats) -> float:
    """Return by what angle the chord of a blade is turned where bodies are at a place [rad]."""
    moved = list[complex]()
    for name, point in ((blade.first, blade.start), (blade.second, blade.end)):
        here = complex(*map(float, point))
        names = [body.name for body in layout.bodies]
        if name in names:
            index = names.index(name)
            origin = complex(*map(float, layout.bodies[index].point))
            x, y, turn = (float(each) for each in at[index])
            here = origin + complex(x, y) + (here - origin) * np.exp(1j * turn)
        moved.append(here)
    before = complex(*(float(b) - float(a) for a, b in zip(blade.start, blade.end, strict=True)))
    return float(np.angle((moved[1] - moved[0]) / before))


def _turned(pull: Mapping[str, Floats], c: Floats, s: Floats) -> dict[str, Floats]:
    """Return the inertial forces along axes that are turned, of a base that moves along its own."""
    return {"x": c * pull["x"] - s * pull["y"], "y": s * pull["x"] + c * pull["y"]}
