"""Results of a tolerance run: yields, worst cases, and their sensitivities."""

from collections.abc import Mapping
from typing import NamedTuple

__all__ = ["Histogram", "ToleranceRow", "TolerancesResult", "WorstCase", "YieldRow"]


class ToleranceRow(NamedTuple):
    """A number that differs from part to part [SI]: nominal, least and most, how it is spread.

    The ends of a normal spread are those that the worst case goes to. ``halved`` is the share of
    the parts that pass with all requirements if this spread were half as wide, with the same
    parts otherwise.
    """

    name: str
    unit: str
    nominal: float
    low: float
    high: float
    spread: str
    halved: float


class WorstCase(NamedTuple):
    """The least margin within the tolerances: factor over required, where, and how sure.

    ``by`` is ``corner`` where the margin falls all the way to a corner of the tolerances, and
    the factor is that of the design there; ``bound`` where it does not, and the factor is one
    that no design within the tolerances falls below; ``search`` where it is the least found.
    ``verdict`` is what is known of all parts: pass, fail or undecided.
    """

    share: float
    verdict: str
    by: str
    at: Mapping[str, float]


class Histogram(NamedTuple):
    """Shares of the parts by factor over required, between one edge and the next."""

    edges: tuple[float, ...]
    shares: tuple[float, ...]


class YieldRow(NamedTuple):
    """How many parts pass a check, or all of them together.

    ``passed`` is the share of parts, which lies in ``interval`` at the confidence of the run;
    ``undecided`` are those that no model can tell, which count as not passing. ``nominal`` is
    factor over required of the design as drawn. ``first_order`` is the share that the slopes at
    the nominal design give, of a normal margin. ``slopes`` say by how many per cent the factor
    changes for 1 % more; ``first`` and ``total`` are Sobol's indices of the logarithm of the
    factor. ``error`` is how far (relative) the factor of a part may be from what the models say
    of it, by the parts that were judged besides. ``histogram`` is of the margins of all parts.
    """

    name: str
    passed: float
    interval: tuple[float, float]
    undecided: float
    nominal: float
    error: float | None = None
    first_order: float | None = None
    slopes: Mapping[str, float] = {}
    first: Mapping[str, float] = {}
    total: Mapping[str, float] = {}
    worst: WorstCase | None = None
    histogram: Histogram | None = None


class TolerancesResult(NamedTuple):
    """Yields of each check and of all together, of so many parts from a seed.

    ``judged`` is how many designs the models judged; ``method`` how the parts follow from them.
    ``asked`` is the share that shall pass, nothing where the worst case shall.
    """

    asked: float | None
    tolerances: tuple[ToleranceRow, ...]
    together: YieldRow
    checks: tuple[YieldRow, ...]
    parts: int
    judged: int
    seed: int
    confidence: float
    method: str
