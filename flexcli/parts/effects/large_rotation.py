"""Large rotation of the blades."""

from flexcli.parts.effects.base import Effect, Setting
from flexcli.results import EffectRow

__all__ = ["LargeRotation"]


class LargeRotation(Effect):
    """The closed forms are the first term in the rotation; the next is of its square."""

    name = "large rotation"

    def row(self, setting: Setting) -> EffectRow | None:
        """Return θ² (or the square of stroke/l), the order of what comes next."""
        travel = setting.largest_travel
        turns = setting.geometry.motion == "rotation"
        if travel == 0.0 or (not turns and setting.blade is None):
            return None
        angle = travel if setting.blade is None or turns else travel / setting.blade.l
        name = "θ" if turns else "stroke/l"
        return EffectRow(
            self.name, False, angle, angle**2, f"{name} = {angle:.2g}; order of its square"
        )
