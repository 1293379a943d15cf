"""The stress that loads make at least, by equilibrium alone, however the blades bend."""

import numpy as np

from flexcli.engine.joint_models.holds import driven_axis, hold_of
from flexcli.engine.joint_models.joint_states import layout_of
from flexcli.mechanics.layout import Blade
from flexcli.mechanics.mesh import single
from flexcli.numerics.rows import one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask

__all__ = ["least_stress"]


def least_stress(ask: Ask) -> float:
    """Return the least that the largest equivalent stress of a joint can be under its loads [Pa].

    A force that nothing else bears goes through the blades of the moving body: ``|F|/ΣA``, A their
    thinnest sections. No section bears more than its area times the largest von Mises stress in
    it, in whatever direction the force is. A drive that holds a stage takes what is along its
    stroke, but where this starts: there the loads leave the joint. It is 0 where other parts than
    blades may bear a share.
    """
    one_alone()
    scene = ask.scene
    if scene.on_bodies:
        return 0.0
    takes = scene.lock is not None or (scene.moves and 0.0 not in scene.stroke_ends)
    borne = np.array([1.0, float(not (takes and driven_axis(ask.geometry) == 1)), 1.0])
    each = (borne * wrench[:3] for wrench in (scene.stated, *scene.inertial))
    forces = [force for force in each if np.any(force)]
    # ends that hold the body across one force may bear another
    if not forces or (len(forces) > 1 and hold_of(scene).across):
        return 0.0
    try:
        layout = layout_of(ask)
    except NotAvailable:
        return 0.0
    if layout.supports or layout.guides:
        return 0.0
    # of loads that act either way one pair of senses makes no less than the largest
    force = max(float(np.linalg.norm(each)) for each in forces)
    area = sum(_area(blade) for blade in layout.blades if MOVING in (blade.first, blade.second))
    return force / area if area else 0.0


def _area(blade: Blade) -> float:
    """Return the least area of a blade's sections [m²]."""
    return float(blade.b) * single(blade.least_thickness)
