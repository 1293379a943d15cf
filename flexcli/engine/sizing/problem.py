"""What a sizing solves: a design, and what its formulas are corrected by near a choice."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Limit, limit_of
from flexcli.parts.sizing import Correction

__all__ = ["SizingProblem"]

_NONE: Mapping[str, Correction] = MappingProxyType({})


class SizingProblem(NamedTuple):
    """A design to be sized, with the corrections of its checks by name.

    ``corrections`` make its formulas say what the models that judge do; ``losses`` are what the
    tolerances of the sizes take of each check. Both hold near a choice of the sizes.
    """

    design: DesignSpec
    corrections: Mapping[str, Correction] = _NONE
    losses: Mapping[str, Correction] = _NONE

    @property
    def is_corrected(self) -> bool:
        """Return whether the formulas say what the models that judge do, near a choice."""
        return bool(self.corrections)

    def corrected(self, corrections: Mapping[str, Correction]) -> "SizingProblem":
        """Return the problem with its formulas corrected, check by check."""
        return self._replace(corrections=corrections)

    def limits(self, sizes: Sizes) -> list[Limit]:
        """Return the limits of sizes: floats, arrays or signomials.

        They are the formulas', corrected; checks without a formula follow, if they were judged.
        """
        limits = self.design.closed_limits(sizes)
        if self.corrections:
            limits = [self._corrected(limit, sizes) for limit in limits] + [
                limit_of(known.alone, known.at(sizes))
                for known in self.corrections.values()
                if known.alone is not None
            ]
        return [self._less(limit, sizes) for limit in limits]

    def _corrected(self, limit: Limit, sizes: Sizes) -> Limit:
        known = self.corrections.get(limit.name)
        if known is None or limit.kind is None:  # what no requirement asks for is as drawn
            return limit
        scaled = limit if known.alone is not None else limit.scaled(known.at(sizes))
        return scaled.narrowed(known.spread)

    def _less(self, limit: Limit, sizes: Sizes) -> Limit:
        """Return a limit reduced by the loss to tolerances; that of a target is narrowed."""
        loss = self.losses.get(limit.name)
        if loss is None:
            return limit
        if limit.tolerance is None:
            return limit.scaled(loss.at(sizes))
        return limit.narrowed(loss.factor - 1.0)
