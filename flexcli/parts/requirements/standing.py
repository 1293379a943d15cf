"""What stands beside a vibration in its case: static stress and force, and what they change."""

from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.requirements.shaking import quality_of
from flexcli.parts.scene import LoadKind
from flexcli.results import EXACT, ErrorRange, QuantityKind

__all__ = ["STANDING", "changed_peaks", "standing_force", "standing_stress"]

STANDING = frozenset({LoadKind.STROKE, LoadKind.LOAD, LoadKind.WRENCH, LoadKind.ACCELERATION})
"""Loads that stand beside a vibration."""

SENSITIVE = 2.0
"""Factor on Q and the change of a stiffness: the change of the peak of a sine at resonance."""

TOLD = 0.3
"""Change of a peak above which a first-order estimate does not hold."""


def standing_stress(ask: Ask) -> tuple[float, ErrorRange | None]:
    """Return the largest static stress of stroke, loads and temperature [Pa], and its error.

    Raises
    ------
    NotAvailable
        When the model has no such stress.

    """
    scene = ask.scene.standing
    if scene is None:
        return 0.0, EXACT
    if scene.temperature is not None and ask.geometry.in_space:
        raise NotAvailable("has no vibration at a temperature in space")
    still = ask._replace(scene=scene)
    _, found = ask.joint_model.stresses(still)
    stress = max((float(each.largest) for each in found), default=0.0)
    return stress, ask.joint_model.error(still, QuantityKind.STRESS)


def standing_force(ask: Ask, stress_per_force: float) -> tuple[float, ErrorRange | None]:
    """Return the largest static force along a blade in the plane [N], and its error.

    ``stress_per_force`` is that along a blade [Pa/N].
    """
    scene = ask.scene.standing
    if scene is None or not scene.loads & STANDING:
        return 0.0, EXACT
    still = ask._replace(scene=scene)
    _, found = ask.joint_model.stresses(still)
    stress = max((abs(float(each.axial)) for each in found if not each.is_at_face), default=None)
    if stress is None:  # the model gives whole faces
        return standing_stress(ask)[0] / stress_per_force, None
    return stress / stress_per_force, ask.joint_model.error(still, QuantityKind.STRESS)


def changed_peaks(ask: Ask) -> ErrorRange | None:
    """Return the relative error of a peak by the modes at assembly, at a case's temperature.

    None where it is not small.
    """
    scene = ask.scene
    if scene.temperature is None:
        return EXACT
    rest = ask._replace(scene=scene.at_assembly())
    ratio = float(ask.joint_model.stiffness(ask)) / float(ask.joint_model.stiffness(rest))
    random = scene.vibration
    quality = random.q if random is not None else quality_of(ask.mechanism, scene)
    off = SENSITIVE * quality.largest * abs(ratio - 1.0)
    return ErrorRange(-off, off) if off <= TOLD else None
