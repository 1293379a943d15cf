"""A vibration of a joint that a temperature strains: the static stress beside it."""

from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.ask import Ask
from flexcli.parts.requirements.shaking import quality_of
from flexcli.results import EXACT, ErrorRange, QuantityKind

__all__ = ["standing"]

SENSITIVE = 2.0
"""Factor on Q and the change of a stiffness: the change of the peak of a sine at resonance."""

TOLD = 0.3
"""Change of a peak above which a first-order estimate does not hold."""


def standing(ask: Ask) -> tuple[float, ErrorRange | None, ErrorRange | None]:
    """Return the largest static stress beside a vibration [Pa], its error, and that of a peak.

    The latter is the error of a peak by the modes at assembly, at the temperature; None where it is
    not small. All are None without a temperature.

    Raises
    ------
    NotAvailable
        When the model has no stress at a temperature.

    """
    scene = ask.scene
    if scene.temperature is None:
        return 0.0, EXACT, EXACT
    if ask.geometry.in_space:
        raise NotAvailable("has no vibration at a temperature in space")
    _, found = ask.joint_model.stresses(ask)
    stress = max((float(each.largest) for each in found), default=0.0)
    rest = ask._replace(scene=scene.at_assembly())
    ratio = float(ask.joint_model.stiffness(ask)) / float(ask.joint_model.stiffness(rest))
    random = scene.vibration
    quality = random.q if random is not None else quality_of(ask.mechanism, scene)
    off = SENSITIVE * quality.largest * abs(ratio - 1.0)
    error = ask.joint_model.error(ask, QuantityKind.STRESS)
    return stress, error, ErrorRange(-off, off) if off <= TOLD else None
