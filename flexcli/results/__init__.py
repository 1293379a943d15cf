"""What a command found out: frozen records that reports print and scripts read.

Rows are named tuples: making a dataclass costs several times as much at every start.
"""

from flexcli.results.accuracy import (
    AccuracyResult,
    ModelAccuracy,
    QuantityAccuracy,
    Reading,
)
from flexcli.results.balance import (
    BalanceResult,
    CouplingTerm,
    GravityRow,
    StrokeRow,
    TransferRow,
    UnknownResult,
)
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
)
from flexcli.results.plan import AuditRow, ModelRow, Plan
from flexcli.results.result import (
    Cost,
    PassedOver,
    Result,
    Status,
)
from flexcli.results.sizing import (
    Design,
    Relaxation,
    Sensitivity,
    SizingResult,
)
from flexcli.results.stops import (
    StopEnd,
    StopHistory,
    StopHold,
    StopKick,
    StopPlace,
    StopRatio,
    StopSimulation,
    StopsResult,
    StopSweep,
    SweepStep,
)
from flexcli.results.vibration import (
    BreakpointRow,
    CaseResponse,
    ModeResult,
    OutputResult,
    ProfileRow,
    Spectrum,
    SpectrumColumn,
    WorstCaseRow,
)

__all__ = [
    "EXACT",
    "AccuracyResult",
    "AuditRow",
    "BalanceResult",
    "BreakpointRow",
    "CaseResponse",
    "Check",
    "Cost",
    "CouplingTerm",
    "Design",
    "EffectRow",
    "ErrorRange",
    "GravityRow",
    "ModeResult",
    "ModelAccuracy",
    "ModelRow",
    "Note",
    "OutputResult",
    "PassedOver",
    "Place",
    "Plan",
    "ProfileRow",
    "Property",
    "QuantityAccuracy",
    "QuantityKind",
    "Reading",
    "Relaxation",
    "Result",
    "Sensitivity",
    "SizingResult",
    "Spectrum",
    "SpectrumColumn",
    "Status",
    "StopEnd",
    "StopHistory",
    "StopHold",
    "StopKick",
    "StopPlace",
    "StopRatio",
    "StopSimulation",
    "StopSweep",
    "StopsResult",
    "StrokeRow",
    "SweepStep",
    "TransferRow",
    "UnknownResult",
    "Value",
    "Verdict",
    "WorstCaseRow",
]
