"""CalculiX decks of a solid model, step by step: states, unit loads, modes, buckling."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from flexcli.engine.solid.deck_model import (
    BRICK_NODES,
    MM,
    RIGID,
    body_nodes,
    fixed_line,
    model_lines,
    node_set,
    stub_lines,
    warming_lines,
)
from flexcli.engine.solid.model import SolidModel
from flexcli.mechanics.layout import Load
from flexcli.mechanics.mesh import single

__all__ = [
    "Deck",
    "State",
    "buckling_deck",
    "compliance_deck",
    "modes_deck",
    "rounding",
    "softness",
    "states_deck",
    "support_deck",
]

FIRST, NEXT = "0.5, 1., 1e-4, 1.", "1., 1., 1e-4, 1."
"""First increment of a step, its length, the least and the largest increment: of the way from rest,
and from one state to another near it."""

CONTROLS = "*CONTROLS, PARAMETERS=FIELD\n1e-5, 1e-3, 1e-5, , 1e-5, 1e-5"
"""Forces out of balance, and the last correction, over the mean and the increment: tighter than
CalculiX's own ½ % and 1 %."""


ROUNDED = 1e-14
"""Times (l/h)⁴, the rounding of a blade's solid."""

MODES, LOAD_FACTORS = 12, 4
"""Modes of vibration and of buckling that are computed."""


SPREAD = 1.02
"""Times what beams tell that stiff parts give way, as hinges reach into them: middles of 19 hinge
lengths had 1.001."""


class State(NamedTuple):
    """What is held of bodies (x, y [m], φ [rad]; nothing where free), and dead loads on them."""

    held: Mapping[str, tuple[float | None, float | None, float | None]]
    loads: Sequence[Load] = ()


class Deck(NamedTuple):
    """The text of a deck, and where to find each body in its results: the numbers of its nodes."""

    text: str
    bodies: Mapping[str, tuple[int, int]]


def softness(model: SolidModel) -> tuple[float, float]:
    """Return by what share what is not quite rigid softens the blades: bent to an S, in any way.

    Stretched, bent evenly or across the width, they give way all along what is between hinges.
    """
    shares = [stretch.bricks.stiff_shares for stretch in model.stretches]
    bent, stretched = (SPREAD * max(each) / RIGID for each in zip(*shares, strict=True))
    return bent, max(bent, stretched)


def rounding(model: SolidModel) -> float:
    """Return by what share rounding may change how a blade of bricks bends.

    It grows with the fourth power of the length over the least thickness: blades of l/h = 1000,
    2000 and 4000 were up to 1.3e-3, 0.01 and 0.19 off, a square one of 2500 0.21, a notch of 1800
    0.03.
    """
    slender = 0.0
    for bricks in (stretch.bricks for stretch in model.stretches):
        s, t = (bricks.places[bricks.lattice[:, [0, -1], 0], axis] for axis in (0, 1))
        slender = max(slender, float(np.ptp(s) / np.abs(t[:, 1] - t[:, 0]).min()))
    return ROUNDED * slender**4


def states_deck(model: SolidModel, states: Sequence[State], *, is_linear: bool = False) -> Deck:
    """Return a deck that goes through states one after the other from rest.

    Motions may be large; with ``is_linear`` each state is a small motion from rest. A layout that
    grows by a temperature does so on the way to the first.
    """
    numbers, points = body_nodes(model), _load_points(states[0].loads)
    head = model_lines(model, numbers, points)
    steps = []
    for index, state in enumerate(states):
        held = list(_held(numbers, state))
        loads = list(_loads(model, numbers, state.loads, points))
        way = ["*STEP, NLGEOM, INC=1000", "*STATIC", NEXT if index else FIRST, CONTROLS]
        steps += [
            *(["*STEP", "*STATIC"] if is_linear else way),
            *(["*BOUNDARY", *held] if held else []),
            *(["*CLOAD, OP=NEW", *loads] if loads else []),
            *(warming_lines(model) if index == 0 else []),
            "*NODE PRINT, NSET=TIED, FREQUENCY=100000", "U, RF",
            "*NODE FILE, NSET=FACES, FREQUENCY=100000", "U",
            "*EL FILE, NSET=FACES, FREQUENCY=100000", "S",
            "*END STEP",
        ]  # fmt: skip
    return Deck("\n".join([*head, *steps, ""]), numbers)


def compliance_deck(model: SolidModel, body: str, guided: bool) -> Deck:
    """Return a deck of six unit loads (N, N·mm) on the point of a body at rest, all others free.

    ``guided``: the body is kept from turning in the plane.
    """
    numbers = body_nodes(model)
    ref, rot = numbers[body]
    head = model_lines(model, numbers, {})
    if guided:
        head += ["*BOUNDARY", f"{rot}, 3, 3"]
    steps = []
    for index in range(6):
        node, axis = (ref, index + 1) if index < 3 else (rot, index - 2)
        # a guide takes the moment about z, and CalculiX no load where a motion is held
        load = [] if guided and index == 5 else ["*CLOAD, OP=NEW", f"{node}, {axis}, 1."]
        steps += [
            "*STEP", "*STATIC", *load, "*NODE PRINT, NSET=BODIES", "U", "*END STEP",
        ]  # fmt: skip
    return Deck("\n".join([*head, *steps, ""]), numbers)


def support_deck(
    model: SolidModel,
    body: str,
    state: State,
    arms: Sequence[tuple[tuple[float, float], tuple[float, float]]],
    forces: Sequence[tuple[int, float, float]],
) -> tuple[Deck, tuple[tuple[int, int], ...]]:
    """Return a deck of forces along z on a body beside a state, and the nodes that they act on.

    ``arms`` are pairs of places on the body at rest [m], ``forces`` which pair is loaded and by
    what at each of its ends [N]; each set of forces acts alone, from the state on.
    """
    numbers = body_nodes(model)
    points = {(body, *end): len(arms[0]) * i + k for i, arm in enumerate(arms)
              for k, end in enumerate(arm)}  # fmt: skip
    first = 2 * len(model.bodies) + model.nodes + 1
    nodes = tuple((first + 2 * i, first + 2 * i + 1) for i in range(len(arms)))
    head = model_lines(model, numbers, points)
    head += node_set("ARMS", np.array(nodes, dtype=np.intp).ravel())
    steps = []
    for index, of in enumerate((None, *forces)):
        loads = [] if of is None else [
            f"{node}, 3, {force:.14g}" for node, force in zip(nodes[of[0]], of[1:], strict=True)
        ]  # fmt: skip
        steps += [
            "*STEP, NLGEOM, INC=1000", "*STATIC", NEXT if index else FIRST, CONTROLS,
            "*BOUNDARY", *_held(numbers, state),
            *(["*CLOAD, OP=NEW", *loads] if loads else []),
            "*NODE PRINT, NSET=ARMS, FREQUENCY=100000", "U", "*END STEP",
        ]  # fmt: skip
    return Deck("\n".join([*head, *steps, ""]), numbers), nodes


def modes_deck(model: SolidModel, density: float, guided: Sequence[str]) -> Deck:
    """Return a deck of the lowest modes at rest, bodies in ``guided`` kept from turning."""
    numbers = body_nodes(model)
    head = model_lines(model, numbers, {}, density=density)
    if guided:
        head += ["*BOUNDARY", *(f"{numbers[name][1]}, 3, 3" for name in guided)]
    step = [
        "*STEP", "*FREQUENCY", f"{MODES}",
        "*NODE PRINT, NSET=BODIES", "U", "*END STEP",
    ]  # fmt: skip
    return Deck("\n".join([*head, *step, ""]), numbers)


def buckling_deck(
    model: SolidModel,
    state: State,
    turning: Mapping[str, float] | None = None,
) -> Deck:
    """Return a deck of the lowest load factors of a state at rest.

    ``turning`` [N·m/rad] holds bodies from turning: by it the caller gives back what rigid bodies
    lack in CalculiX, the moment of their blades' forces as their arms turn.
    """
    numbers, points = body_nodes(model), _load_points(state.loads)
    head = model_lines(model, numbers, points)
    held = list(_held(numbers, state))
    node, element = 2 * len(model.bodies) + model.nodes + len(points), model.elements
    for index, (name, stiffness) in enumerate((turning or {}).items()):
        body = next(body for body in model.bodies if body.name == name)
        head += stub_lines(index, body, numbers[name], stiffness * model.share, node, element + 1)
        node, element = node + BRICK_NODES, element + 1
    if held:
        head += ["*BOUNDARY", *held]
    step = [
        "*STEP", "*BUCKLE", f"{LOAD_FACTORS}, 1e-4",
        "*CLOAD", *_loads(model, numbers, state.loads, points), "*END STEP",
    ]  # fmt: skip
    return Deck("\n".join([*head, *step, ""]), numbers)


def _load_points(loads: Sequence[Load]) -> dict[tuple[str, float, float], int]:
    """Return the places of loads, by their order."""
    found: dict[tuple[str, float, float], int] = {}
    for load in loads:
        found.setdefault(_place_of(load), len(found))
    return found


def _place_of(load: Load) -> tuple[str, float, float]:
    x, y = (single(c) for c in load.point)
    return load.body, x, y


def _held(numbers: Mapping[str, tuple[int, int]], state: State) -> Iterator[str]:
    for name, motion in state.held.items():
        for axis, value in enumerate(motion):
            if value is not None:
                yield fixed_line(numbers[name], axis, value)


def _loads(
    model: SolidModel,
    numbers: Mapping[str, tuple[int, int]],
    loads: Sequence[Load],
    points: Mapping[tuple[str, float, float], int],
) -> Iterator[str]:
    first = 2 * len(model.bodies) + model.nodes + 1
    for load in loads:
        node = first + points[_place_of(load)]
        for axis, force in enumerate(load.force, 1):
            yield f"{node}, {axis}, {single(force) * model.share:.14g}"
        if single(load.moment):
            yield f"{numbers[load.body][1]}, 3, {single(load.moment) * MM * model.share:.14g}"
