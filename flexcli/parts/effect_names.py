"""The effects that a design may have, by name."""

from enum import StrEnum

__all__ = ["EffectName"]


class EffectName(StrEnum):
    """An effect, as reports and scripts read it."""

    SHEAR = "shear"
    AXIAL_EXTENSION = "axial extension"
    BLADE_TENSION = "blade tension"
    LARGE_ROTATION = "large rotation"
    HINGE_LENGTH = "hinge length"
    AXIAL_LOAD = "axial load"
    PLATE_WIDENING = "plate widening"
    ANTICLASTIC = "anticlastic"
    WARPING = "warping"
    CLAMP_STRESS = "clamp stress"
    ROOT_RADIUS = "root radius"
    CLAMP_COMPLIANCE = "clamp compliance"
    THICK_NOTCH = "thick notch"
    BLADE_MASS = "blade mass"
    GRAVITY = "gravity"
    EXPANSION = "expansion"
    RANDOM_VIBRATION = "random vibration"
    SHOCK = "shock"
    DAMPING = "damping"
    END_STOPS = "end stops"

    @property
    def key(self) -> str:
        """Return how a spec writes it."""
        return self.value.replace(" ", "-")
