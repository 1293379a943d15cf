"""The quality factor of a tip mass on its blade."""

from flexcli.errors import SolveError
from flexcli.parts.case import Case
from flexcli.parts.mechanisms.tip_mass import TipMass

__all__ = ["case_quality"]


def case_quality(mechanism: TipMass, name: str, case: Case) -> float:
    """Return Q: as the mechanism states it, else as its vibration or shock does."""
    if mechanism.damping is not None:
        return mechanism.damping.quality
    for environment in (case.asd, case.shock):
        if environment is not None:
            return environment.q
    raise SolveError(
        "no-damping",
        f"case '{name}': nothing says how the tip mass is damped",
        "give mechanism.damping: {q: …}",
    )
