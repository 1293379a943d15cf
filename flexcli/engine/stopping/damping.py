"""The quality factor of a tip mass on its blade."""

from flexcli.errors import SolveError
from flexcli.parts.case import Case
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.parts.quality import Quality

__all__ = ["case_quality"]


def case_quality(mechanism: TipMass, name: str, case: Case) -> float:
    """Return Q of the first mode: as the case or the mechanism states it, else a load of it."""
    if case.q is not None:
        return _of_first_mode(case.q)
    if mechanism.damping is not None:
        return mechanism.damping.quality
    if case.asd is not None:
        return _of_first_mode(case.asd.q)
    if case.shock is not None:
        return case.shock.q
    raise SolveError(
        "no-damping",
        f"case '{name}': nothing says how the tip mass is damped",
        "give mechanism.damping: {q: …}",
    )


def _of_first_mode(quality: Quality) -> float:
    return quality.modes.get(1, quality.all)
