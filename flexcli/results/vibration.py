"""Results of a vibration or a shock, and the profiles that state one."""

from collections.abc import Mapping
from typing import NamedTuple

__all__ = [
    "BreakpointRow",
    "CaseResponse",
    "ModeResult",
    "OutputResult",
    "ProfileRow",
    "Spectrum",
    "SpectrumColumn",
    "WorstCaseRow",
]


class ModeResult(NamedTuple):
    """One natural mode: frequency [Hz], share of the mass that it moves, rms of its responses.

    ``dynamic`` is false for a mode that the band can't excite or the base does not move.
    """

    frequency: float
    mass_share: float
    dynamic: bool
    rms: Mapping[str, float]


class OutputResult(NamedTuple):
    """One response: rms and its zero crossings (random only), peak, peak expected in the time."""

    name: str
    unit: str
    rms: float | None
    peak: float
    expected_peak: float | None
    crossing_rate: float | None


class CaseResponse(NamedTuple):
    """What the modes make of the vibration or the shock of one case; lives [s] by method."""

    case: str
    kind: str
    modes: tuple[ModeResult, ...]
    outputs: tuple[OutputResult, ...]
    lives: Mapping[str, Mapping[str, float]]
    duration: float | None


class ProfileRow(NamedTuple):
    """A profile of acceleration density: its rms [m/s²], as computed and as published, sources."""

    name: str
    title: str
    g_rms: float
    published_grms: float | None
    status: str
    standard: str
    revision: str
    location: str
    note: str
    interpolation: str
    axis: str
    duration: float | None
    tolerance_above: float | None
    tolerance_below: float | None


class BreakpointRow(NamedTuple):
    """A corner of a profile [Hz, (m/s²)²/Hz] and the slope to the next one [dB/octave].

    The slope of a step is infinite; on linear axes, and at the last point, there is none.
    """

    frequency: float
    level: float
    slope: float | None


class WorstCaseRow(NamedTuple):
    """Miles over all frequencies beside the exact response, for one case and one Q; SI units.

    ``g_rms_worst`` is Miles' maximum, at ``f_worst``; ``g_rms_exact`` and ``g_rms_pseudo`` are the
    exact absolute acceleration and pseudo-acceleration there. ``g_rms_max`` is the greatest exact
    absolute acceleration over all natural frequencies, at ``f_max``, which may lie beyond the band.
    ``miles_excess_there`` and ``miles_excess`` tell how far Miles' maximum lies above these (a
    share of them), ``shortfall`` how far Miles lies below the exact response where in the band it
    does most, at ``f_shortfall``. ``c_*`` are peaks over
    rms, ``a_*`` those times ``g_rms_worst``; they lack where the duration does.
    """

    case: str
    profile: str
    applied: str
    q: float
    f_worst: float
    g_rms_worst: float
    g_rms_exact: float
    g_rms_pseudo: float
    f_max: float
    g_rms_max: float
    miles_excess_there: float
    miles_excess: float
    shortfall: float
    f_shortfall: float | None
    duration: float | None
    c_sigma: float
    a_sigma: float
    c_peak: float | None
    a_peak: float | None
    c_davenport: float | None
    a_davenport: float | None


class SpectrumColumn(NamedTuple):
    """One column of a spectrum: name, SI unit ("" for none), what it is, its numbers."""

    name: str
    unit: str
    label: str
    values: tuple[float, ...]


class Spectrum(NamedTuple):
    """Numbers over the first column, the frequency: their kind, what they are, of which case."""

    kind: str
    name: str
    case: str
    columns: tuple[SpectrumColumn, ...]
