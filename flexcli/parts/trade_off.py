"""The second objective of a sizing: a requirement of the spec, whose bound moves along a front."""

from typing import Any, NamedTuple

from flexcli.parts.base import spec_error
from flexcli.parts.requirements.base import Bound, FactorRequirement

__all__ = ["MovingBound", "moving_bound"]


class MovingBound(NamedTuple):
    """A requirement's key, the place of its bound in the spec, and how it tightens."""

    key: str
    path: tuple[str | int, ...]
    rises: bool


def moving_bound(design: Any) -> MovingBound:
    """Return the bound that the second objective of a design moves.

    Raises a finding where the spec does not state it, once.
    """
    goal = design.size.against
    key, rises = goal.minimize or goal.maximize, goal.minimize is None
    at = ("size", "objective")
    own = [one for path, one in design.requirements.each() if path[0] == key]
    side = "min" if rises else "max"
    if not own:
        known = ", ".join(dict.fromkeys(str(path[0]) for path, _ in design.requirements.each()))
        raise spec_error(
            f"nothing is asked of '{key}', which would be its loosest bound",
            f"name one of {known or 'the requirements'}, or add {key}: {{{side}: …}}", at=at,
        )  # fmt: skip
    if len(own) > 1:
        raise spec_error(f"'{key}' has several bounds", "keep one of them", at=at)
    if isinstance(own[0], FactorRequirement) and rises:
        return MovingBound(key, ("requirements", key), rises)
    if isinstance(own[0], Bound) and getattr(own[0], side) is not None:
        return MovingBound(key, ("requirements", key, side), rises)
    verb = "maximize" if rises else "minimize"
    other = f"give it {side}:, its loosest" if isinstance(own[0], Bound) else "maximize it"
    raise spec_error(f"there is no bound of '{key}' to {verb}", other, at=at)
