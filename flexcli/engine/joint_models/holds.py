"""What a case holds of the moving body: its guide, the stroke, a lock, the ends that are stated.

One mapping for stress and for buckling. The ends of a blade that a case states say what its force
leaves free: the body goes along the force, and is held across it or from turning. What acts along
the stroke alone has no force that presses on blades, so that nothing is held across it. A lock
keeps the body from turning. What a case neither drives nor holds is free in the plane.
"""

from flexcli.parts.ends import ENDS, Hold
from flexcli.parts.geometries.base import Geometry, Held
from flexcli.parts.scene import Scene

__all__ = ["FREE", "driven_axis", "held_at_rest", "held_by_stroke", "hold_of", "undriven"]


FREE = Hold(across=False, turn=False)

TURNING = 5
"""Component of a wrench that drives a rotation."""


def hold_of(scene: Scene) -> Hold:
    """Return what the ends or the lock of a case hold of the body."""
    if scene.lock is not None and not scene.states_ends:
        return Hold(across=False, turn=True)
    held = FREE if scene.ends is None else ENDS[scene.ends]
    if not scene.forces and scene.temperature is None:
        # a force or a moment along the stroke alone, which the ends do not bear
        pushed = scene.drive == TURNING and scene.push > 0.0
        held = held._replace(across=False, turn=held.turn and not pushed)
    return held


def driven_axis(geometry: Geometry) -> int:
    """Return which coordinate (x, y, φ) of the moving body the stroke drives."""
    return 2 if geometry.motion == "rotation" else 1


def held_at_rest(scene: Scene, geometry: Geometry) -> Held:
    """Return what is held of a body without a stroke, the force along x."""
    hold = hold_of(scene)
    turn = hold.turn or geometry.is_guided
    return None, 0.0 if hold.across else None, 0.0 if turn else None


def held_by_stroke(scene: Scene, geometry: Geometry, travel: object) -> Held:
    """Return what is held of a body at a travel [m or rad], which may be an array."""
    x, y, phi = geometry.held(1.0)
    if driven_axis(geometry) == 2:
        return x, y, travel  # type: ignore[return-value]
    return x, travel, 0.0 if hold_of(scene).turn else phi  # type: ignore[return-value]


def undriven(scene: Scene, geometry: Geometry, travel: float = 0.0) -> Held:
    """Return what is held of a body at a travel of its stroke besides its drive [m or rad].

    What keeps a body from turning does so whatever acts on it, where a stroke turns it as well.
    """
    x, y, phi = held_by_stroke(scene, geometry, travel)
    if driven_axis(geometry) == 2:
        return x, y, phi if hold_of(scene).turn else None
    return x, None, phi
