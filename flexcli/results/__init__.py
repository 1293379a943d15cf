"""Frozen records of a command's results, which reports print and scripts read.

Here are those that every verb has; the records of one verb are imported from its module, so that
a start loads no others. Rows are named tuples: a dataclass takes several times as long to make.
"""

from flexcli.results.judgement import (
    EXACT,
    Check,
    EffectRow,
    ErrorRange,
    Note,
    Place,
    Property,
    QuantityKind,
    Value,
    Verdict,
    error_of_ratio,
)
from flexcli.results.result import (
    Cost,
    PassedOver,
    Result,
    Status,
    with_seconds,
)

__all__ = [
    "EXACT",
    "Check",
    "Cost",
    "EffectRow",
    "ErrorRange",
    "Note",
    "PassedOver",
    "Place",
    "Property",
    "QuantityKind",
    "Result",
    "Status",
    "Value",
    "Verdict",
    "error_of_ratio",
    "with_seconds",
]
