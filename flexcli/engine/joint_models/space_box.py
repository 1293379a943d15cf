"""The box around a joint in space: by small motion, and by exact beams on its way.

It is looked at at rest, over the stroke, and, where a case has loads or a temperature, over the
stroke under half of them and under all: a stroke is from where they leave the joint.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import cache, partial
from itertools import product

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.dead_loads import loads_of, signed
from flexcli.engine.joint_models.holds import hold_of
from flexcli.engine.joint_models.space_errors import beam_errors
from flexcli.engine.joint_models.space_stroke import (
    at_travel,
    driven_coordinate,
    sag_of_drive,
)
from flexcli.errors import SolveError
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.lines import lines_of
from flexcli.mechanics.space.layout import SpaceLoad, vector
from flexcli.mechanics.space.states import Acting, action, combined, warmed
from flexcli.mechanics.space.swept_box import Edges, Sweep, SweptBox, swept_box
from flexcli.numerics.interpolation import lagrange
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint, joint_in_space
from flexcli.parts.space_outline import Outline, own_sags
from flexcli.parts.space_poses import (
    IN_PLANE,
    Poses,
    beside_drive,
    is_flat,
    origins,
    poses,
    rows_of,
    shifted_by_stretch,
    still,
)
from flexcli.parts.space_states import acting_groups, bent_by_gradient

__all__ = ["exact_box", "linear_box"]

Floats = NDArray[np.float64]

TRAVELS = 33
"""Travels between the ends of the range at which it is looked at: odd, for the middle is one."""

SHARES = (0.5, 1.0)
"""Of the loads."""

HALF = 0.5
"""Error of a stiffness up to which what it bears is moved by a known amount."""

_SHIFT, _TURN = slice(0, 3), slice(3, 6)

Loaded = Callable[[float, Sequence[float]], Sweep]
"""The sweep under a share of a case's loads, each in its sense."""


def linear_box(ask: Ask) -> tuple[SweptBox, tuple[str, ...]]:
    """Return the box by small motion to second order, and the parts that have no outline."""
    scene, travels = ask.scene, _travels(ask.scene)
    if ask.geometry.is_guided:
        raise NotAvailable("is guided, which its box by small motion is not: take --model exact")
    if scene.states_ends and hold_of(scene).turn:
        raise NotAvailable("is kept from turning, its box by small motion not: take --model exact")

    def plain() -> Sweep:
        joint = _joint(ask, warm=False)
        moved = poses(joint, scene, travels, None) if scene.moves else still(joint)
        return Outline(joint, ask.geometry).sweep(moved)

    def loaded(share: float, signs: Sequence[float]) -> Sweep:
        joint = _joint(ask)
        groups = acting_groups(joint, scene)
        states = [action(joint.assembly, each) for each in groups]
        shares = [share * sign for sign in signs]
        if scene.temperature is not None:
            states.append(warmed(joint.assembly, locked=scene.moves))
            shares.append(share)
        moved = poses(joint, scene, travels, combined(states, shares))
        sags = sum(share * own_sags(joint, each.acceleration) for each in groups)
        return Outline(joint, ask.geometry).sweep(moved, sags=sags)

    return _box(ask, plain, loaded)


def exact_box(ask: Ask) -> tuple[SweptBox, tuple[str, ...]]:
    """Return the box by exact beams, and the parts that have no outline."""
    scene, travels, known = ask.scene, _travels(ask.scene), _known_travels(ask.scene)

    @cache
    def plain() -> Sweep:
        at = known if scene.moves else np.zeros(1)
        states = [at_travel(ask, float(travel), warmth=0.0) for travel in at]
        return _spread(_of_states(ask, _joint(ask, warm=False), states), known, travels)

    @cache
    def acting() -> tuple[SpaceJoint, list[list[SpaceLoad]], Floats, Floats]:
        joint = _joint(ask)
        groups = acting_groups(joint, scene)
        halves = np.array(sum(_off_by_halves(joint, each) for each in groups))
        sags = np.array(sum(own_sags(joint, each.acceleration) for each in groups))
        return joint, [loads_of(joint, each) for each in groups], halves, sags

    def loaded(share: float, signs: Sequence[float]) -> Sweep:
        joint, each, halves, sags = acting()
        loads = tuple(signed(each, [share * sign for sign in signs]))
        at = partial(at_travel, ask, loads=loads, hold=hold_of(scene))
        sag = sag_of_drive(ask, loads) if scene.moves else 0.0
        states = [at(float(t) + sag) for t in known] if scene.moves else [at(None)]
        told = _of_states(ask, joint, states, share * halves, share * sags)
        found = _spread(told, known, travels)
        # what loads move is as unsure as what bears them
        supports = [error.support for error in map(beam_errors, states) if error is not None]
        soft = max(supports, default=0.0)
        if soft > HALF:
            return found._replace(is_known=False)
        gone = found.points - plain().points
        moved = float(np.linalg.norm(gone, axis=-1).max())
        ways = np.abs(gone).max(axis=(0, 1)) > IN_PLANE * moved
        return found._replace(off=found.off + ways * moved * soft / (1.0 - soft))

    try:
        return _box(ask, plain, loaded)
    except SolveError as error:
        raise NotAvailable(f"has no exact equilibrium: {error}") from error


def _box(ask: Ask, plain: Callable[[], Sweep], loaded: Loaded) -> tuple[SweptBox, tuple[str, ...]]:
    scene, cold = ask.scene, _joint(ask, warm=False)
    rest = Outline(cold, ask.geometry)
    sweeps = [_stacked([rest.sweep(still(cold))])]
    acts = bool(acting_groups(cold, scene)) or scene.temperature is not None
    if scene.moves or acts:
        base = plain()
        sweeps.append(_stacked([base]))
    # what is locked, and the whole of a mechanism, no joint tells
    told = not (acts and (scene.lock is not None or scene.unjudged))
    sweeps += [
        _stacked([base, *(loaded(share, signs) for share in SHARES)])
        for signs in (_senses(cold, scene) if acts and told else ())
    ]
    found = swept_box(sweeps)
    return found._replace(is_known=found.is_known and told), rest.bare


def _stacked(sweeps: Sequence[Sweep]) -> Sweep:
    points, off, known = zip(*sweeps, strict=True)
    return Sweep(np.stack(points), np.stack(off), all(known))


def _senses(joint: SpaceJoint, scene: Scene) -> Iterator[tuple[float, ...]]:
    """Yield the senses in which the loads of a case act, a directed one in its own alone."""
    own = (1.0,) if scene.has_one_sense and any(scene.stated) else (1.0, -1.0)
    groups = acting_groups(joint, scene)
    first = any(scene.stated)
    return product(*(own if first and k == 0 else (1.0, -1.0) for k in range(len(groups))))


def _joint(ask: Ask, *, warm: bool = True) -> SpaceJoint:
    heat = ask.scene.temperature if warm else None
    return joint_in_space(ask.geometry, ask.material, ask.sizes, heat)


def _range(scene: Scene) -> tuple[float, float]:
    """Return between which travels it moves, rest being one of them."""
    return min(*scene.stroke_ends, 0.0), max(*scene.stroke_ends, 0.0)


def _travels(scene: Scene) -> Floats:
    return np.linspace(*_range(scene), TRAVELS) if scene.moves else np.zeros(1)


def _known_travels(scene: Scene) -> Floats:
    """Return five travels of which exact beams tell, rest and both ends among them."""
    low, high = _range(scene)
    if not low < 0.0 < high:
        return np.linspace(low, high, 5)
    return np.array([low, low / 2.0, 0.0, high / 2.0, high])


def _spread(sweep: Sweep, known: Floats, travels: Floats) -> Sweep:
    """Return a sweep at many travels from that at five.

    By the polynomial through all, which differs from that through every other one by more than it
    is off.
    """
    if len(sweep.points) == 1:
        return sweep
    points = np.tensordot(lagrange(known, travels), sweep.points, axes=1)
    coarse = np.tensordot(lagrange(known[::2], travels), sweep.points[::2], axes=1)
    i = np.clip(np.searchsorted(known, travels, side="right") - 1, 0, len(known) - 2)
    t = ((travels - known[i]) / (known[i + 1] - known[i]))[:, None, None]
    off = np.maximum(sweep.off[i] * (t < 1.0), sweep.off[i + 1] * (t > 0.0))
    return Sweep(points, off + np.abs(points - coarse), sweep.is_known)


def _of_states(
    ask: Ask,
    joint: SpaceJoint,
    states: Sequence[SpaceEquilibrium],
    halves: Floats | float = 0.0,
    sags: Floats | float = 0.0,
) -> Sweep:
    """Return the sweep of equilibria; ``halves`` (bodies, 6) is how far off they are besides."""
    layout, scene = joint.layout, ask.scene
    told = [(b.name, vector(p)) for b, p in zip(layout.bodies, origins(joint), strict=True)]
    motion = np.array([[state.motion_of(*each) for each in told] for state in states])
    # where the drive is, is told by what holds it, or bears the loads
    driven = [state.coordinates.ravel()[driven_coordinate(layout)] for state in states]
    beside = beside_drive(layout, motion, np.array(driven))
    errors = [beam_errors(state) for state in states]
    sizes = [(each.shift, each.rest) for each in errors if each is not None]
    is_known = len(sizes) == len(states) and bool(np.isfinite(sizes).all())
    share, rest = np.array(sizes if is_known else [(0.0, 0.0)] * len(states)).T[..., None, None]
    ones = shifted_by_stretch(joint, scene, np.ones(len(layout.blades)))
    off = share * np.abs(beside) + rest * ones + halves
    bent = np.abs(bent_by_gradient(joint, scene)[1]) if layout.grows else np.zeros(6)
    shift, turn = (np.linalg.norm(off[..., at] + bent[at], axis=-1) for at in (_SHIFT, _TURN))
    flat = is_flat(joint, motion)
    if flat and layout.drive.turns and not np.any(halves):
        turn[:, layout.index(layout.drive.body)] = 0.0  # it is held
    warmth = float(layout.grows)
    moved = Poses(motion, shift, turn, flat, warmth=warmth, is_known=is_known)
    lines = [
        Edges(*(np.stack(parts) for parts in zip(*each, strict=True)))
        for each in zip(*map(lines_of, states), strict=True)
    ]
    return Outline(joint, ask.geometry).sweep(moved, sags=sags, lines=lines, share=share[..., 0])


def _off_by_halves(joint: SpaceJoint, acting: Acting) -> Floats:
    """Return how far off bodies are whose blades weigh by halves on them (bodies, 6) [m, rad]."""
    assembly = joint.assembly
    pull = sum((assembly.load(load) for load in loads_of(joint, acting)), np.zeros(assembly.size))
    halves = assembly.moved(pull[:, None]).coordinates
    off = (action(assembly, acting).moved.coordinates - halves)[:, 0]
    return np.asarray(np.abs(rows_of(joint) @ off))
