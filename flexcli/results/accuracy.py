"""Accuracy against computing time on one design: every model's numbers beside the finest's."""

from typing import NamedTuple

__all__ = ["AccuracyResult", "ModelAccuracy", "QuantityAccuracy", "Reading"]


class Reading(NamedTuple):
    """One quantity by one model, SI.

    ``error`` is relative to the finest model's value; ``seconds`` is the median of several runs,
    ``least`` and ``most`` their spread. ``pareto`` tells that no model is both faster and nearer.
    """

    model: str
    value: float
    error: float
    seconds: float
    least: float
    most: float
    pareto: bool


class QuantityAccuracy(NamedTuple):
    """One quantity by every model that has it; ``bound`` is the error of the finest, relative.

    ``recommended`` is the cheapest model within the accuracy asked, empty where there is none.
    """

    name: str
    label: str
    unit: str
    finest: float
    bound: float
    readings: tuple[Reading, ...]
    recommended: str


class ModelAccuracy(NamedTuple):
    """One model on the whole design: its largest error, and the time of all its quantities.

    ``missing`` names the quantities that it has no answer to.
    """

    model: str
    error: float
    seconds: float
    least: float
    most: float
    pareto: bool
    missing: tuple[str, ...]


class AccuracyResult(NamedTuple):
    """Errors and times of all models; ``recommended`` is the cheapest that meets the accuracy.

    It is empty where no model meets it. ``unsettled`` names quantities without a sure finest
    value, which take no part. ``in_time`` is the same of the design's motions between stops.
    ``is_solid`` says that the finest are solid elements, ``is_shell`` that they are thin shells;
    else they are plane beams.
    """

    accuracy: float
    runs: int
    finest: str
    quantities: tuple[QuantityAccuracy, ...]
    models: tuple[ModelAccuracy, ...]
    recommended: str
    unsettled: tuple[str, ...]
    in_time: "AccuracyResult | None" = None
    is_solid: bool = False
    is_shell: bool = False
