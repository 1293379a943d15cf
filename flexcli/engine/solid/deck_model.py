"""The model in a CalculiX deck, in mm, N, MPa and t: bricks, materials, rigid bodies, supports."""

from collections.abc import Iterator, Mapping
from math import hypot

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.solid.bricks import CORNERS
from flexcli.engine.solid.growth import Spacer, grows, spacers_of, strains_of
from flexcli.engine.solid.model import SolidBody, SolidModel
from flexcli.formulas.anisotropy import turned_stiffness
from flexcli.mechanics.mesh import single

__all__ = [
    "BRICK_NODES",
    "MM",
    "MPA",
    "RIGID",
    "body_nodes",
    "fixed_line",
    "model_lines",
    "node_set",
    "stub_lines",
    "warming_lines",
]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

MM, MPA, TONNE_MM3 = 1e3, 1e-6, 1e-12
"""Of SI in the deck's units: lengths, stresses, densities."""

TONNE = 1e-3

STUB = 0.01
"""Side of the cube that holds a body from turning [m]."""

RIGID = 1e3
"""Modulus of what does not flex between the hinges of a blade, over that of the hinges. Of a rigid
body CalculiX would lack part of the tangent, and of a stiffer one it finds no large turn."""

WEIGHTLESS = 1e-9
"""Density of it over that of the hinges; a step *FREQUENCY takes none of nothing."""

BRICK_NODES = 22
"""Nodes of a brick beside the blades, and the two that state the motion of its far face."""

SPACER = 5e3
"""Side of the cube by which a clamp moves as its body grows, over that motion: the second order of
so small a strain does not matter. It is at least as long as blades are thick, or it would bend."""

SPACER_STIFFNESS = 1e4
"""Stiffness of it over that of the stiffest blade along itself."""

A_LINE = 12
"""Node numbers on a line of a set."""


def body_nodes(model: SolidModel) -> dict[str, tuple[int, int]]:
    """Return the numbers of the two nodes that state the motion of each body."""
    first = model.nodes + 1
    return {body.name: (first + 2 * k, first + 2 * k + 1) for k, body in enumerate(model.bodies)}


def model_lines(
    model: SolidModel,
    numbers: Mapping[str, tuple[int, int]],
    points: Mapping[tuple[str, float, float], int],
    density: float | None = None,
) -> list[str]:
    """Return nodes, elements, material, rigid bodies and what never moves."""
    lines = [
        "** bricks between rigid bodies, in mm, N, MPa, t" + (
            "; half of each blade, halves of forces and masses" if model.is_half else ""
        ),
        "*NODE, NSET=BLADES",
    ]  # fmt: skip
    for stretch in model.stretches:
        for number, place in enumerate(stretch.places * MM, stretch.first_node + 1):
            lines.append(f"{number}, " + ", ".join(f"{x:.14g}" for x in place))
    element = 1
    for index, stretch in enumerate(model.stretches):
        for name, chosen in (("BLADES", ~stretch.bricks.stiff), ("MIDDLES", stretch.bricks.stiff)):
            if not chosen.any():
                continue
            elset = f"{name}{index}" if grows(model.layout) else name
            lines.append(f"*ELEMENT, TYPE=C3D20R, ELSET={elset}")
            for nodes in stretch.bricks.elements[chosen] + stretch.first_node + 1:
                row = [str(element), *map(str, nodes.tolist())]
                lines += [", ".join(row[:15]) + ",", ", ".join(row[15:])]
                element += 1
    extra = 2 * len(model.bodies) + model.nodes + 1
    lines.append("*NODE, NSET=BODIES")
    for body in model.bodies:
        lines += [_node(number, body.point) for number in numbers[body.name]]
    of_loads: dict[str, list[int]] = {}
    placed = []
    for (name, x, y), index in points.items():
        of_loads.setdefault(name, []).append(extra + index)
        placed.append(_node(extra + index, (x, y, 0.0)))
    extra += len(points)
    masses: list[tuple[int, float]] = []
    for body in model.bodies if density is not None else ():
        for place, mass in body.masses:
            of_loads.setdefault(body.name, []).append(extra)
            placed.append(_node(extra, place))
            masses.append((extra, mass * model.share))
            extra += 1
    if placed:
        lines += ["*NODE", *placed]
    for number, (node, mass) in enumerate(masses):
        lines += [
            f"*ELEMENT, TYPE=MASS, ELSET=MASS{number}", f"{element}, {node}",
            f"*MASS, ELSET=MASS{number}", f"{mass * TONNE:.12g}",
        ]  # fmt: skip
        element += 1
    lines += _materials(model, density)
    spacers = list(spacers_of(model))
    apart = {int(node) for spacer in spacers for node in spacer.nodes}
    for index, body in enumerate(model.bodies):
        clamped = [node + 1 for node in body.nodes.tolist() if node not in apart]
        nodes = np.array([*clamped, *of_loads.get(body.name, [])], dtype=np.intp)
        if nodes.size:
            lines += [*node_set(f"BODY{index}", nodes)]
            lines += [_rigid(f"BODY{index}", numbers[body.name])]
    for index, spacer in enumerate(spacers):
        lines += _spacer(index, spacer, numbers.get(spacer.body), model, extra, element)
        extra, element = extra + BRICK_NODES, element + 1
    tied = [body.nodes + 1 for body in model.bodies]
    own = np.array([node for both in numbers.values() for node in both])
    lines += [*node_set("TIED", np.concatenate([own, *tied])), *node_set("GROUND", model.fixed + 1)]
    faces = [
        stretch.bricks.face(side)[::2].ravel() + stretch.first_node + 1
        for stretch in model.stretches
        for side in (0, -1)
    ]
    lines += [*node_set("FACES", np.concatenate(faces))]
    middle = [s.bricks.middle() + s.first_node + 1 for s in model.stretches]
    if model.is_half:
        lines += [*node_set("MIDDLE", np.concatenate(middle))]
    lines += ["*BOUNDARY", "GROUND, 1, 3"]
    if model.is_half:
        lines += ["MIDDLE, 3, 3"]
        for ref, rot in numbers.values():
            lines += [f"{ref}, 3, 3", f"{rot}, 1, 2"]
    if grows(model.layout):
        moving = any(spacer.body in numbers for spacer in spacers)
        lines += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", "BLADES, 0."]
        lines += ["SPACERS, 0."] if moving else []
    for body_name, held in model.layout.guides.items():
        lines += [fixed_line(numbers[body_name], axis, 0.0) for axis in range(3) if held[axis]]
    return lines


def stub_lines(
    index: int, body: SolidBody, nodes: tuple[int, int], stiffness: float, last: int, element: int
) -> list[str]:
    """Return a brick that holds a body from turning, its far end free to slide but not to turn.

    It bends in pure bending, and pulls at nothing: E I/L is the stiffness [N·m/rad]. A spring on a
    turn would count twice in a step *BUCKLE of CalculiX 2.20.
    """
    side = STUB * MM
    E = stiffness * MM * side / (side**4 / 12.0)
    x, y = (c * MM for c in body.point[:2])
    lines, near, far = _brick(last + 1, element, f"STUB{index}", (x, y), side)
    ref, rot = last + 21, last + 22
    return [
        *lines,
        "*NODE", f"{ref}, {x + side:.14g}, {y:.14g}, 0.", f"{rot}, {x + side:.14g}, {y:.14g}, 0.",
        f"*MATERIAL, NAME=STUB{index}", "*ELASTIC", f"{E:.12g}, 0.",
        f"*SOLID SECTION, ELSET=STUB{index}, MATERIAL=STUB{index}",
        *node_set(f"NEAR{index}", near), _rigid(f"NEAR{index}", nodes),
        *node_set(f"FAR{index}", far), _rigid(f"FAR{index}", (ref, rot)),
        "*BOUNDARY", f"{ref}, 3, 3", f"{rot}, 1, 3",
    ]  # fmt: skip


def node_set(name: str, nodes: Integers) -> Iterator[str]:
    """Yield the lines of a named set of nodes."""
    yield f"*NSET, NSET={name}"
    for first in range(0, nodes.size, A_LINE):
        row = nodes[first : first + A_LINE].tolist()
        yield ", ".join(map(str, row)) + ("," if first + A_LINE < nodes.size else "")


def fixed_line(nodes: tuple[int, int], axis: int, value: float) -> str:
    """Return the line that gives a body's coordinate (x, y [m] or φ) a value."""
    if axis == 2:
        return f"{nodes[1]}, 3, 3, {value:.14g}"
    return f"{nodes[0]}, {axis + 1}, {axis + 1}, {value * MM:.14g}"


def warming_lines(model: SolidModel) -> Iterator[str]:
    """Yield what a step needs to let everything grow: a unit of temperature, clamps of the base."""
    if not grows(model.layout):
        return
    yield from ("*TEMPERATURE", "BLADES, 1.")
    spacers = list(spacers_of(model))
    moving = {body.name for body in model.bodies}
    if any(spacer.body in moving for spacer in spacers):
        yield "SPACERS, 1."
    for index, spacer in enumerate(spacers):
        if spacer.body not in moving:
            yield "*BOUNDARY"
            for axis, moved in enumerate(spacer.moved, 1):
                yield f"CLAMP{index}, {axis}, {axis}, {moved * MM:.14g}"


def _materials(model: SolidModel, density: float | None) -> Iterator[str]:
    """Yield the material of what flexes and of what does not, blade by blade where they grow."""
    E, G = (single(x) for x in (model.layout.E, model.layout.G))
    nu = E / (2.0 * G) - 1.0
    stiff = [stretch.bricks.stiff for stretch in model.stretches]
    for name, has, stiffer, heavier in (
        ("BLADES", [not each.all() for each in stiff], 1.0, 1.0),
        ("MIDDLES", [bool(each.any()) for each in stiff], RIGID, WEIGHTLESS),
    ):
        elastic = ["*ELASTIC", f"{E * stiffer * MPA:.12g}, {nu:.12g}"]
        if model.stiffness is not None:
            elastic = _anisotropic(stiffer * model.stiffness)
        weighs = []
        if density is not None:
            weighs = ["*DENSITY", f"{density * heavier * TONNE_MM3:.12g}"]
        if not grows(model.layout):
            if any(has):
                yield from (f"*MATERIAL, NAME={name}", *elastic, *weighs)
                yield f"*SOLID SECTION, ELSET={name}, MATERIAL={name}"
            continue
        for index, stretch in enumerate(model.stretches):
            if not has[index]:
                continue
            own, (c, s, _) = f"{name}{index}", stretch.axes[0].tolist()
            along, across = strains_of(model, stretch)
            if model.stiffness is not None:
                turned = turned_stiffness(model.stiffness, stretch.axes)
                elastic = _anisotropic(stiffer * turned)
            yield f"*ORIENTATION, NAME={own}, SYSTEM=RECTANGULAR"
            yield f"{c:.14g}, {s:.14g}, 0., {-s:.14g}, {c:.14g}, 0."
            yield from (f"*MATERIAL, NAME={own}", *elastic, *weighs, "*EXPANSION, TYPE=ORTHO")
            yield f"{along:.12g}, {across:.12g}, {across:.12g}"
            yield f"*SOLID SECTION, ELSET={own}, MATERIAL={own}, ORIENTATION={own}"


def _anisotropic(stiffness: Floats) -> list[str]:
    """Return a stiffness (6, 6), rows in Voigt's order [Pa], as CalculiX takes it."""
    order = np.array([0, 1, 2, 5, 4, 3])  # 11, 22, 33, 12, 13, 23
    lower = stiffness[np.ix_(order, order)][np.tril_indices(6)] * MPA
    rows = (lower[:8], lower[8:16], lower[16:])
    return ["*ELASTIC, TYPE=ANISO", *(", ".join(f"{x:.12g}" for x in row) for row in rows)]


def _spacer(
    index: int,
    spacer: Spacer,
    nodes: tuple[int, int] | None,
    model: SolidModel,
    first: int,
    element: int,
) -> list[str]:
    """Return a stiff brick that moves a clamp of a body away from it as the body grows.

    A clamp of the base has none: it is moved as the base is.
    """
    if nodes is None:
        return [*node_set(f"CLAMP{index}", spacer.nodes + 1)]
    long = max(SPACER * hypot(*spacer.moved), _thickest(model))
    x, y = (c * MM for c in spacer.place)
    lines, near, far = _brick(first, element, f"SPACER{index}", (x, y), long * MM, nset="SPACERS")
    ref, rot = first + 20, first + 21
    # of a shear the far face moves twice the strain's component
    strain = (spacer.moved[0] / long, 0.0, 0.0, spacer.moved[1] / (2.0 * long), 0.0, 0.0)
    E = SPACER_STIFFNESS * _axial(model) / long * MPA
    held = [f"{ref}, 3, 3", f"{rot}, 1, 2"] if model.is_half else []
    return [
        "*NODE", f"{ref}, {x:.14g}, {y:.14g}, 0.", f"{rot}, {x:.14g}, {y:.14g}, 0.",
        *lines, f"*MATERIAL, NAME=SPACER{index}", "*ELASTIC", f"{E:.12g}, 0.",
        "*EXPANSION, TYPE=ANISO", ", ".join(f"{each:.12g}" for each in strain),
        f"*SOLID SECTION, ELSET=SPACER{index}, MATERIAL=SPACER{index}",
        *node_set(f"NEAR{index}", near), _rigid(f"NEAR{index}", nodes),
        *node_set(f"CLAMP{index}", np.concatenate([spacer.nodes + 1, far])),
        _rigid(f"CLAMP{index}", (ref, rot)), *(["*BOUNDARY", *held] if held else []),
    ]  # fmt: skip


def _thickest(model: SolidModel) -> float:
    """Return how thick the blades are at most [m]."""
    return max(float(np.ptp(stretch.bricks.places[:, 1])) for stretch in model.stretches)


def _axial(model: SolidModel) -> float:
    """Return the stiffness of the stiffest blade along itself, as thick as it is anywhere [N/m]."""
    E, found = single(model.layout.E), 0.0
    for stretch in model.stretches:
        size = np.ptp(stretch.bricks.places, axis=0)
        found = max(found, float(E * size[1] * size[2] / size[0]))
    return found


def _brick(
    first: int, element: int, name: str, at: tuple[float, float], side: float, nset: str = ""
) -> tuple[list[str], Integers, Integers]:
    """Return the lines of a cube on one side of a place, and the nodes of its near and far face."""
    places = np.array([*at, 0.0]) + (CORNERS / 2.0 - np.array([0.0, 0.5, 0.5])) * side
    own = first + np.arange(20)
    near, far = (own[CORNERS[:, 0] == end] for end in (0, 2))
    lines = [
        "*NODE" + (f", NSET={nset}" if nset else ""),
        *(f"{n}, {a:.14g}, {b:.14g}, {c:.14g}" for n, (a, b, c) in zip(own, places, strict=True)),
        f"*ELEMENT, TYPE=C3D20, ELSET={name}",
        ", ".join(map(str, [element, *own[:14]])) + ",", ", ".join(map(str, own[14:])),
    ]  # fmt: skip
    return lines, near, far


def _rigid(name: str, nodes: tuple[int, int]) -> str:
    return f"*RIGID BODY, NSET={name}, REF NODE={nodes[0]}, ROT NODE={nodes[1]}"


def _node(number: int, place: tuple[float, float, float]) -> str:
    return ", ".join((str(number), *(f"{c * MM:.14g}" for c in place)))
