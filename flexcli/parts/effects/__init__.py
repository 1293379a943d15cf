"""Effects that the closed forms leave out; a new one is a file here and a name in the tuple."""

from flexcli.parts.effects.axial_load import AxialLoad
from flexcli.parts.effects.base import Effect, Setting
from flexcli.parts.effects.large_rotation import LargeRotation
from flexcli.parts.effects.plate import PlateWidening
from flexcli.parts.effects.shear import Shear

__all__ = ["EFFECTS", "Effect", "Setting"]

EFFECTS: tuple[Effect, ...] = (Shear(), LargeRotation(), PlateWidening(), AxialLoad())
