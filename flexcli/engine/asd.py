"""The verbs on profiles: what one holds, one scaled by decibels, the envelope of several."""

from collections.abc import Mapping, Sequence
from math import sqrt
from time import perf_counter
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.decibels import db_per_octave_from_slope, scale_level
from flexcli.formulas.envelope import envelope
from flexcli.formulas.spectrum import segment_slopes
from flexcli.formulas.spectrum_integrals import rms_displacement, rms_velocity, spectral_moment
from flexcli.formulas.straight_spectrum import power_sum
from flexcli.parts.asd import ASDProfile, Breakpoint
from flexcli.results import Cost, Note, Result, Status, Value
from flexcli.results.vibration import BreakpointRow, ProfileRow, SpectrumColumn
from flexcli.units import LARGEST, SMALLEST, STANDARD_GRAVITY

__all__ = [
    "catalogue",
    "column",
    "describe",
    "enveloped",
    "made",
    "profile_row",
    "scaled",
    "summed",
]

Floats = NDArray[np.float64]

MODEL = "closed-form"

ORDERS = (0, 1, 2, 4)
"""Moments that are reported: those of mean, rate and bandwidth in spectral fatigue."""

ROUNDING = 0.01
"""How far a published rms may be off (a share of it): standards print two or three digits."""


def catalogue(command: str, profiles: Mapping[str, ASDProfile]) -> Result:
    """Return one row per profile: its rms beside the published one."""
    started = perf_counter()
    rows = tuple(profile_row(name, profile) for name, profile in profiles.items())
    notes = [note for name, profile in profiles.items() for note in _notes(name, profile)]
    return Result(
        command=command,
        spec=", ".join(profiles) if len(profiles) == 1 else "",
        status=Status.PASS,
        profiles=rows,
        warnings=tuple(notes),
        cost=Cost(perf_counter() - started, MODEL, None),
    )


def describe(command: str, name: str, profile: ASDProfile) -> Result:
    """Return everything about one profile: breakpoints with slopes, rms values, moments."""
    started = perf_counter()
    return Result(
        command=command,
        spec=name,
        status=Status.PASS,
        title=profile.name,
        values=_values(profile),
        warnings=tuple(_notes(name, profile)),
        profiles=(profile_row(name, profile),),
        breakpoints=_breakpoints(profile),
        cost=Cost(perf_counter() - started, MODEL, None),
    )


def scaled(name: str, profile: ASDProfile, db: float) -> ASDProfile:
    """Return a profile with its level raised by so many decibels (lowered, if negative).

    Raises SolveError where that leaves all physical sizes.
    """
    title, note = f"{profile.name or name}, {db:+g} dB", f"Made from {name} by {db:+g} dB."
    levels = scale_level(profile.levels, db)
    if not (levels.min() > SMALLEST and levels.max() < LARGEST):
        raise SolveError("beyond", f"{db:+g} dB leads beyond any physical level", "take fewer dB")
    return made(title, note, profile.frequencies, levels, [profile])


def enveloped(profiles: Mapping[str, ASDProfile]) -> ASDProfile:
    """Return the greatest of several profiles at every frequency, or raise SolveError."""
    scale, *others = (profile.scale for profile in profiles.values())
    if any(other != scale for other in others):
        raise SolveError(
            "mixed-axes",
            "profiles straight on log-log axes and on linear axes have no common straight lines",
            "give all of them the same interpolation",
        )
    try:
        f, g = envelope([(p.frequencies, p.levels) for p in profiles.values()], scale=scale)
    except ValueError as error:
        raise SolveError("gap", str(error), "add a profile that covers the gap") from error
    title = f"Envelope of {', '.join(profiles)}"
    return made(title, f"{title}.", f, g, list(profiles.values()))


def summed(profiles: Mapping[str, ASDProfile]) -> ASDProfile:
    """Return the sum of several profiles that act at once, or raise SolveError."""
    try:
        f, g = power_sum([(p.frequencies, p.levels, p.scale) for p in profiles.values()])
    except ValueError as error:
        raise SolveError("gap", str(error), "add a profile that covers the gap") from error
    title = f"Sum of {', '.join(profiles)}"
    return made(title, f"{title}.", f, g, list(profiles.values()), "log-log")


def made(
    title: str,
    note: str,
    f: Floats,
    g: Floats,
    sources: Sequence[ASDProfile],
    scale: Literal["log-log", "linear"] | None = None,
) -> ASDProfile:
    """Return a profile of these breakpoints, straight as its sources are or as is said.

    It keeps the longest duration of its sources, and their axis when all agree.
    """
    steps = np.diff(f, prepend=-1.0) == 0.0
    found = ASDProfile(
        name=title,
        note=note,
        points=tuple(
            Breakpoint.model_construct(frequency=at, level=level, step=step)
            for at, level, step in zip(f.tolist(), g.tolist(), steps.tolist(), strict=True)
        ),
        interpolation=sources[0].interpolation if scale is None else scale,
        axis=sources[0].axis if len({source.axis for source in sources}) == 1 else "",
    )
    durations = [source.duration for source in sources if source.duration is not None]
    return found.model_copy(update={"duration": max(durations, default=None)})


def column(name: str, unit: str, label: str, values: Floats) -> SpectrumColumn:
    """Return a column of a spectrum: its name, SI unit, what it is, its numbers."""
    return SpectrumColumn(name, unit, label, tuple(values.tolist()))


def profile_row(name: str, profile: ASDProfile) -> ProfileRow:
    """Return what a list of profiles says of one."""
    tolerance = profile.tolerance
    return ProfileRow(
        name=name,
        title=profile.name,
        g_rms=profile.grms,
        published_grms=profile.published_grms,
        status=profile.status,
        standard=profile.standard,
        revision=profile.revision,
        location=profile.location,
        note=profile.note,
        interpolation=profile.interpolation,
        axis=profile.axis,
        duration=profile.duration,
        tolerance_above=tolerance.above if tolerance else None,
        tolerance_below=tolerance.below if tolerance else None,
    )


def _notes(name: str, profile: ASDProfile) -> list[Note]:
    """Return a warning where the published rms is another than that of the breakpoints."""
    published = profile.published_grms
    if published is None or abs(profile.grms / published - 1.0) <= ROUNDING:
        return []
    text = (
        f"{name}: the breakpoints give {profile.grms / STANDARD_GRAVITY:.4g} g, "
        f"{profile.grms / published - 1.0:+z.1%} from the published "
        f"{published / STANDARD_GRAVITY:.4g} g"
    )
    return [Note("grms-differs", text)]


def _breakpoints(profile: ASDProfile) -> tuple[BreakpointRow, ...]:
    f, g = profile.frequencies, profile.levels
    slopes: list[float | None] = [None] * f.size
    if profile.scale == "log":
        slopes = [*db_per_octave_from_slope(segment_slopes(f, g)).tolist(), None]
    return tuple(
        BreakpointRow(float(at), float(level), slope)
        for at, level, slope in zip(f, g, slopes, strict=True)
    )


def _values(profile: ASDProfile) -> dict[str, Value]:
    f, g, scale = profile.frequencies, profile.levels, profile.scale
    moments = spectral_moment(f, g, ORDERS, scale=scale)
    values = {
        "g_rms": Value(profile.grms, "m/s^2", "rms acceleration"),
        "v_rms": Value(rms_velocity(f, g, scale=scale), "m/s", "rms velocity"),
        "d_rms": Value(rms_displacement(f, g, scale=scale), "m", "rms displacement"),
        "f_zero": Value(
            sqrt(moments[2] / moments[0]), "Hz", "rate of upward zero crossings, √(m₂/m₀)"
        ),
    }
    for order, moment in zip(ORDERS, moments.tolist(), strict=True):
        unit = "(m/s^2)^2" + (f"*Hz^{order}" if order else "")
        label = f"spectral moment of order {order}, ∫ f^{order} G df"
        values[f"m_{order}"] = Value(moment, unit, label)
    return values
