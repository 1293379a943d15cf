"""Effects that a scene may call for; a new one is a file here and a name in a tuple."""

from flexcli.parts.bending import Change
from flexcli.parts.effects.anticlastic import Anticlastic
from flexcli.parts.effects.axial_extension import AxialExtension
from flexcli.parts.effects.axial_load import AxialLoad
from flexcli.parts.effects.base import Effect, Indicator, ModelEffect, SceneEffect, Setting
from flexcli.parts.effects.blade_mass import BladeMass
from flexcli.parts.effects.blade_tension import BladeTension
from flexcli.parts.effects.clamps import ClampCompliance, ClampStress, RootRadius
from flexcli.parts.effects.damping import DampedMotion
from flexcli.parts.effects.end_stops import EndStops
from flexcli.parts.effects.estimate import Estimate, estimate, left_by
from flexcli.parts.effects.expansion import Expansion
from flexcli.parts.effects.gravity import Gravity
from flexcli.parts.effects.hinges import HingeLength, ThickNotch
from flexcli.parts.effects.large_rotation import LargeRotation
from flexcli.parts.effects.plate import PlateWidening
from flexcli.parts.effects.random_vibration import RandomVibration
from flexcli.parts.effects.shear import Shear
from flexcli.parts.effects.shock import ShockLoad
from flexcli.parts.effects.warping import Warping

__all__ = [
    "EFFECTS",
    "MODEL_EFFECTS",
    "SCENE_EFFECTS",
    "Change",
    "Effect",
    "Estimate",
    "Indicator",
    "ModelEffect",
    "SceneEffect",
    "Setting",
    "estimate",
    "left_by",
]

MODEL_EFFECTS: tuple[ModelEffect, ...] = (
    Shear(),
    AxialExtension(),
    BladeTension(),
    LargeRotation(),
    HingeLength(),
    AxialLoad(),
    PlateWidening(),
    Anticlastic(),
    Warping(),
    ClampStress(),
    RootRadius(),
    ClampCompliance(),
    ThickNotch(),
    BladeMass(),
)
"""What models of the blades carry or leave out."""

SCENE_EFFECTS: tuple[SceneEffect, ...] = (
    Gravity(),
    Expansion(),
    RandomVibration(),
    ShockLoad(),
    DampedMotion(),
    EndStops(),
)
"""What a scene states or not."""

EFFECTS: tuple[Effect, ...] = (*MODEL_EFFECTS, *SCENE_EFFECTS)
