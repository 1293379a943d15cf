"""Requirements as objectives of a sizing: whose bound moves, and which of its checks are meant."""

from typing import Any, NamedTuple

from flexcli.parts.base import spec_error
from flexcli.parts.requirements import Requirements
from flexcli.parts.requirements.base import Bound, FactorRequirement
from flexcli.parts.sizing import QUANTITIES, Minimize, SizeOptions

__all__ = ["MovingBound", "moving_bound", "pursued_bound", "refuse_misfit"]


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
    goal = design.sizing.against if goal is None else goal
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


def refuse_misfit(design: Any, options: SizeOptions) -> None:
    """Raise a finding where a grid or an objective is of no size, quantity or asked requirement."""
    sizes = (*design.geometry.extents, *design.parameters)
    for name in options.rounding:
        _refuse_unknown(name, sizes, ("size", "round", name))
    objective = options.objective
    if isinstance(objective, Minimize):
        _refuse_misfit_of(objective, design, sizes)
    elif objective == "shortest" and "l" not in sizes:
        raise spec_error(
            f"a {design.geometry.name} has no length l",
            "take least-volume",
            at=("size", "objective"),
        )
    if options.against is not None:
        moving_bound(design, options.against)


def _refuse_misfit_of(objective: Minimize, design: Any, sizes: tuple[str, ...]) -> None:
    verb = "minimize" if objective.minimize is not None else "maximize"
    name, asked = getattr(objective, verb), [str(at[0]) for at, _ in design.requirements.each()]
    known = {info.alias or field for field, info in Requirements.model_fields.items()}
    if name in known - {*asked, *sizes, *QUANTITIES}:
        raise spec_error(
            f"nothing is asked of '{name}', which would be its loosest bound",
            "add it to the requirements",
            at=("size", "objective", verb),
        )
    if name not in asked:
        _refuse_unknown(name, (*sizes, *QUANTITIES, *asked), ("size", "objective", verb))
    elif name not in (*sizes, *QUANTITIES):
        moving_bound(design, objective)


def _refuse_unknown(name: str, known: tuple[str, ...], at: tuple[str, ...]) -> None:
    if name not in known:
        raise spec_error(f"there is no size '{name}' here", f"one of {', '.join(known)}", at=at)


def pursued_bound(design: Any, options: SizeOptions) -> MovingBound | None:
    """Return the bound that an objective moves, where it names a requirement."""
    objective = options.objective
    if isinstance(objective, str):
        return None
    if (objective.minimize or objective.maximize) in (
        *design.geometry.extents,
        *design.parameters,
        *QUANTITIES,
    ):
        return None
    return moving_bound(design, objective)
