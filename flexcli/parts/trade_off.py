"""Requirements as objectives of a sizing: whose bound moves, and which of its checks are meant."""

from typing import Any, NamedTuple

from flexcli.parts.base import spec_error
from flexcli.parts.requirements.base import Bound, FactorRequirement
from flexcli.parts.sizing import QUANTITIES, Minimize

__all__ = ["MovingBound", "moving_bound"]


class MovingBound(NamedTuple):
    """A requirement's key, the place of its bound in the spec, and how it tightens.

    ``label`` is what its checks are called.
    """

    key: str
    path: tuple[str | int, ...]
    rises: bool
    label: str

    def has(self, check: str) -> bool:
        """Return whether a check of that name, without its case, is of this bound."""
        if check != self.label and not check.startswith(f"{self.label} "):
            return False
        return len(self.path) < 3 or check.endswith(f"({self.path[2]})")


def moving_bound(design: Any, goal: Minimize | None = None) -> MovingBound:
    """Return the bound that an objective of a design moves, the second one if unsaid.

    Raises a finding where the spec does not state it, once.
    """
    goal = design.size.against if goal is None else goal
    key, rises = str(goal.minimize or goal.maximize), goal.minimize is None
    at, side = ("size", "objective"), "min" if rises else "max"
    asked = dict.fromkeys(str(path[0]) for path, _ in design.requirements.each())
    own = [one for path, one in design.requirements.each() if path[0] == key]
    if not own and key in (*design.geometry.extents, *design.parameters, *QUANTITIES):
        hint = f"write it first: [{key}, …], the second being one of {', '.join(asked)}"
        raise spec_error(f"the second objective is a requirement, '{key}' is none", hint, at=at)
    if not own:
        raise spec_error(
            f"nothing is asked of '{key}', which would be its loosest bound",
            f"name one of {', '.join(asked) or 'the requirements'}, or add {key}: {{{side}: …}}",
            at=at,
        )
    if len(own) > 1:
        raise spec_error(f"'{key}' has several bounds", "keep one of them", at=at)
    if isinstance(own[0], FactorRequirement) and rises:
        return MovingBound(key, ("requirements", key), rises, own[0].label)
    if isinstance(own[0], Bound) and getattr(own[0], side) is not None:
        return MovingBound(key, ("requirements", key, side), rises, own[0].label)
    verb = "maximize" if rises else "minimize"
    other = f"give it {side}:, its loosest" if isinstance(own[0], Bound) else "maximize it"
    raise spec_error(f"there is no bound of '{key}' to {verb}", other, at=at)
