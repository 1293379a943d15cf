"""The whole mechanism of a spec as it is drawn: its bodies on all of their joints, moved exactly.

The joint alone is drawn by :mod:`flexcli.engine.draw`; here copies of it stand where the mechanism
has them, and its own motion is prescribed to the exact equations.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import cos, sin

import numpy as np

from flexcli.engine.draw import drawing, drawn_case, strength_shown
from flexcli.engine.drawn_layout import drawn_blade, drawn_bodies, drawn_states, turning
from flexcli.engine.joint_models.exact import TOLERANCE
from flexcli.engine.joint_models.joint_states import blades_of
from flexcli.errors import Outcome, SolveError
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.mechanisms.parallel_stage import SOLID_2, ParallelStage
from flexcli.parts.scene import Scene
from flexcli.parts.structure import PlacedJoint
from flexcli.results.drawing import (
    Drawing,
    DrawnBody,
    DrawnForce,
    DrawnLength,
    DrawnMass,
    DrawnState,
)

__all__ = ["mechanism_drawing"]

CLEAR = 3.5
"""Distance from lever to lever over the reach of a joint: the spec does not state it."""

AS_DRAWN = turning(0.0)


def mechanism_drawing(design: DesignSpec, sizes: Sizes, case: str | None = None) -> Drawing:
    """Return the mechanism of a design as it is drawn; of a body on one joint, that joint.

    Parameters
    ----------
    design : DesignSpec
        The design.
    sizes : named tuple
        Its sizes [m].
    case : str, optional
        The case whose stroke, lock and forces are drawn; the first that moves it, if left out.

    Raises
    ------
    SolveError
        When there is no such case.

    """
    stage = design.mechanism
    if not isinstance(stage, ParallelStage):
        return drawing(design, sizes, case)
    ask = drawn_case(design, sizes, case)
    try:
        joint = design.geometry.blades_layout(design.material.elastic, sizes)
    except (NotAvailable, SolveError):
        return drawing(design, sizes, case)
    scene = ask.scene
    ends = [end for blade in joint.blades for end in (blade.start, blade.end)]
    reach = max(float(np.hypot(*(np.ravel(c)[0] for c in end))) for end in ends)
    apart = CLEAR * reach
    layout, pivots = stage.layout(joint, scene.lock, apart)
    states: tuple[DrawnState, ...] = ()
    missed = ""
    if scene.moves and scene.lock is None:
        per_motion = stage.joint_travel_per_motion
        travels = [travel / per_motion for travel in scene.stroke_ends]
        states, missed = _states_at(layout, travels[:1] if scene.travel == 0.0 else travels)
    height = stage.height
    lengths = [DrawnLength("H", (0.0, 0.0), (0.0, height))]
    bodies = {body.name: body for body in drawn_bodies(layout, AS_DRAWN, SOLID_2)}
    for side, lever in enumerate(stage.stage().levers):
        name, x = f"solid {2 * side + 1}", side * apart
        masses = [
            DrawnMass(part, (x + float(body.com[0]), float(body.com[1])), float(body.mass))
            for part, body in zip(("", "balance"), lever.bodies, strict=False)
            if body.mass
        ]
        bodies[name] = _reaching(bodies[name], masses)
        if side == 0 and len(masses) > 1:
            lengths.append(DrawnLength("arm", (0.0, masses[1].at[1]), (0.0, 0.0)))
    return Drawing(
        kind=stage.kind,
        motion="translation",
        blades=tuple(drawn_blade(blade, AS_DRAWN) for blade in layout.blades),
        bodies=tuple(bodies.values()),
        sizes=tuple((name, float(size)) for name, size in sizes._asdict().items()),
        centre=(0.5 * apart, height),
        case=scene.case,
        states=states,
        forces=tuple(_forces(scene, pivots)),
        lengths=tuple(lengths),
        pivots=tuple((at.name, (float(at.point[0]), float(at.point[1]))) for at in pivots),
        missed=missed,
        joint_size=reach,
        strength=strength_shown(design),
        notes=(
            "the distance from lever to lever is not in the spec",
            *((f"{scene.lock} is locked",) if scene.lock else ()),
        ),
    )


def _states_at(layout: Layout, travels: Sequence[float]) -> tuple[tuple[DrawnState, ...], str]:
    """Return the mechanism at travels of solid 2, or why it does not get there."""
    held = {SOLID_2: (np.array(travels), None, None)}
    effects = blades_of(layout, Effects())
    state = solve(layout, held, effects=effects, tolerance=TOLERANCE)
    for outcome in state.outcome:
        if outcome is not Outcome.CONVERGED:
            return (), str(outcome.error())
    return drawn_states(state, AS_DRAWN, SOLID_2, dict(enumerate(travels))), ""


def _reaching(body: DrawnBody, masses: Sequence[DrawnMass]) -> DrawnBody:
    """Return a body with its masses, which reaches to those that have a name of their own."""
    far = tuple(mass.at for mass in masses if mass.name)
    none = ((0.0, 0.0),) * len(far)
    return replace(
        body,
        masses=tuple(masses),
        clamps=(*body.clamps, *far),
        ways=(*body.ways, *none),
        depths=(*body.depths, *(0.0 for _ in far)),
    )


def _forces(scene: Scene, pivots: Sequence[PlacedJoint]) -> Iterator[DrawnForce]:
    """Yield the forces of a case on the pivots."""
    for pivot in pivots:
        name = f"F_{pivot.name.removeprefix('P')}"
        if scene.forces and name in scene.values:
            direction = scene.forces[0][1]
            way = (cos(direction), sin(direction))
            at = (float(pivot.point[0]), float(pivot.point[1]))
            yield DrawnForce(name, at, way, abs(scene.values[name].value))
