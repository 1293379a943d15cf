"""Study: which values of a design vary, over which points, and what is done at each."""

from itertools import product
from math import isfinite
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from pydantic import Field, field_validator, model_validator

from flexcli.parts.base import Part, spec_error
from flexcli.units import number_and_unit

__all__ = ["Study", "Variation", "points_of"]

MOST = 1_000_000
"""Designs of a study."""

KEYS = frozenset({"from", "to", "points", "spacing", "values"})
"""What a variation takes."""


class Variation(Part):
    """The values of one place of the spec: between two ends, or listed."""

    is_plain: ClassVar[bool] = True

    least: str = Field("", alias="from")
    """First value, as the spec writes it, e.g. ``0.1 mm``."""
    most: str = Field("", alias="to")
    """Last value, in the same unit, e.g. ``0.3 mm``."""
    points: Annotated[int, Field(strict=True, ge=1, le=MOST)] = 11
    """How many values of a grid, the ends among them, e.g. ``20``."""
    spacing: Literal["linear", "log"] = "linear"
    """Whether they stand at equal differences or equal ratios, e.g. ``log``."""
    values: tuple[str, ...] = ()
    """Values one by one, e.g. ``[ti-6al-4v, maraging-300]``."""

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if isinstance(data, list):
            return {"values": [str(value) for value in data]}
        if not isinstance(data, dict) or not set(data) <= KEYS:
            hint = "write {from: 0.1 mm, to: 0.3 mm, points: 5} or a list"
            raise spec_error("a variation is a range with points, or a list", hint)
        return {k: str(v) if k in ("from", "to") else v for k, v in data.items()}

    @model_validator(mode="after")
    def _has_values(self) -> "Variation":
        if self.values:
            return self
        if not (self.least and self.most):
            raise spec_error("a variation has no values", "write {from: …, to: …} or a list")
        first, last = self.ends
        if self.spacing == "log" and not (first[0] > 0.0 and last[0] > 0.0):
            raise spec_error("equal ratios need ends above zero", "take spacing: linear")
        return self

    @property
    def ends(self) -> tuple[tuple[float, str], tuple[float, str]]:
        """Return both ends as numbers and their unit."""
        found = []
        for text in (self.least, self.most):
            parts = number_and_unit(text)
            if parts is None or not isfinite(parts[0]):
                raise spec_error(f"'{text}' is no number with a unit", "write e.g. 200 um")
            found.append(parts)
        first, last = found
        if first[1] != last[1]:
            text = f"the ends are in '{first[1]}' and '{last[1]}'"
            raise spec_error(text, "write both in one unit")
        return first, last

    def between(self, shares: Any) -> list[str]:
        """Return the values at shares of the way from the first end to the last."""
        (low, unit), (high, _) = self.ends
        at = low + (high - low) * np.asarray(shares, dtype=np.float64)
        if self.spacing == "log":
            at = low * (high / low) ** np.asarray(shares, dtype=np.float64)
        return [f"{value:.12g} {unit}".strip() for value in at.tolist()]

    @property
    def grid(self) -> list[str]:
        """Return the values of a grid."""
        if self.values:
            return list(self.values)
        return self.between(np.linspace(0.0, 1.0, self.points))


class Study(Part):
    """What varies, how its points are laid, and what is done at each."""

    vary: Annotated[dict[str, Variation], Field(min_length=1)]
    """Places of the spec, by their paths, and their values,
    e.g. ``{geometry.h: {from: 0.1 mm, to: 0.3 mm, points: 5}}``.
    """
    each: Literal["check", "verdict", "size", "simulate", "balance", "response", "stops"] = "check"
    """What is done at each point, e.g. ``size``; a verdict is a check without values, a response
    that of the modes to vibration and shock.
    """
    sample: Literal["grid", "sobol", "latin-hypercube"] = "grid"
    """All combinations, or points spread over the ranges, e.g. ``sobol``."""
    points: Annotated[int, Field(strict=True, ge=1, le=MOST)] = 64
    """How many points a sample has, e.g. ``256``."""
    seed: Annotated[int, Field(strict=True, ge=0)] = 0
    """Of a sample: the same seed gives the same points, e.g. ``7``."""

    @field_validator("vary")
    @classmethod
    def _is_no_study_itself(cls, value: dict[str, Variation]) -> dict[str, Variation]:
        for path in value:
            if path.split(".")[0] == "study":
                raise spec_error("a study cannot vary itself", "name another place of the spec")
        return value


def points_of(study: Study) -> list[dict[str, str]]:
    """Return the points of a study: by the paths of the spec, the values to put there.

    A sample is of Sobol's sequence, scrambled, or a Latin hypercube (McKay, Beckman and Conover
    1979), by SciPy; of a list it takes the value whose share of the way it falls in.

    Raises
    ------
    ValueError
        When there are too many.

    """
    names = list(study.vary)
    if study.sample == "grid":
        grids = [study.vary[name].grid for name in names]
        count = 1
        for grid in grids:
            count *= len(grid)
        if count > MOST:
            raise ValueError(f"{count} designs are more than {MOST}")
        return [dict(zip(names, values, strict=True)) for values in product(*grids)]
    from scipy.stats import qmc

    many = study.points
    if study.sample == "sobol":  # drawn in a power of two, which keeps its balance
        sobol = qmc.Sobol(d=len(names), seed=study.seed)
        shares = sobol.random_base2(max(many - 1, 0).bit_length())[:many]
    else:
        shares = qmc.LatinHypercube(d=len(names), seed=study.seed).random(many)
    columns = []
    for k, name in enumerate(names):
        varied = study.vary[name]
        if varied.values:
            last = len(varied.values) - 1
            columns.append([varied.values[min(int(s * (last + 1)), last)] for s in shares[:, k]])
        else:
            columns.append(varied.between(shares[:, k]))
    return [dict(zip(names, values, strict=True)) for values in zip(*columns, strict=True)]
