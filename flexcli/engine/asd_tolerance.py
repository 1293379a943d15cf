"""The verb tolerance: a measured run of a vibration test against the limits around its profile."""

from collections.abc import Iterator
from math import inf, log10
from time import perf_counter
from typing import NamedTuple

from flexcli.engine.asd import profile_row
from flexcli.engine.judge import status_of
from flexcli.errors import SolveError
from flexcli.formulas.decibels import scale_level
from flexcli.formulas.level_tolerance import LevelDeviation, level_deviation
from flexcli.formulas.spectrum import clip_profile
from flexcli.formulas.spectrum_integrals import rms
from flexcli.parts.asd import ASDProfile
from flexcli.results import Check, Cost, Note, Result, Value, Verdict

__all__ = ["Limits", "tolerance"]

MODEL = "closed-form"
ROUNDING = 1e-9
"""Share by which a level that is just met may be beyond."""


class Limits(NamedTuple):
    """What a run is held to: dB above and below the profile, share of its rms, band [Hz].

    What is not given is the profile's own, and not checked where that has none.
    """

    above: float | None = None
    below: float | None = None
    rms: float | None = None
    band: tuple[float | None, float | None] = (None, None)


def tolerance(
    measured: ASDProfile, limit: ASDProfile, names: tuple[str, str], asked: Limits
) -> Result:
    """Return whether a measured density keeps the limits around a profile.

    Raises
    ------
    SolveError
        When nobody says what the limits are, or the band has nothing of the profile.

    """
    started = perf_counter()
    own = limit.tolerance
    above = asked.above if asked.above is not None or own is None else own.above
    below = asked.below if asked.below is not None or own is None else own.below
    if above is None and below is None and asked.rms is None:
        text = f"nothing says how far a run may be off {names[1]}"
        raise SolveError("no-tolerance", text, "add --above '3 dB' --below '3 dB' --grms '10 %'")
    ends = limit.frequencies[0], limit.frequencies[-1]
    low, high = (
        float(end if given is None else given) for given, end in zip(asked.band, ends, strict=True)
    )
    if not max(low, ends[0]) < min(high, ends[1]):
        text = f"{names[1]} has nothing from {low:g} to {high:g} Hz"
        raise SolveError("no-band", text, f"it spans {ends[0]:g} to {ends[1]:g} Hz")
    found = level_deviation(
        (measured.frequencies, measured.levels, measured.scale),
        (limit.frequencies, limit.levels, limit.scale),
        inf if above is None else float(scale_level(1.0, above)),
        0.0 if below is None else float(scale_level(1.0, -below)),
        (low, high),
    )
    sizes = _rms_in(measured, low, high), _rms_in(limit, low, high)
    checks = (*_levels(found, above, below), *_rms(*sizes, asked.rms))
    return Result(
        command="asd tolerance",
        spec=", ".join(names),
        status=status_of(checks),
        values=_values(found, *sizes),
        checks=checks,
        warnings=tuple(_notes(measured, limit, names, (low, high))),
        profiles=tuple(profile_row(*pair) for pair in zip(names, (measured, limit), strict=True)),
        cost=Cost(perf_counter() - started, MODEL, None),
    )


def _levels(found: LevelDeviation, above: float | None, below: float | None) -> Iterator[Check]:
    if above is not None:
        text = f"level over the profile's, {_db(found.most)} at {found.f_most:.5g} Hz"
        yield _check("level above", f"{text}{_width(found.above)}", found.most,
                     float(scale_level(1.0, above)), "", f"{above:g} dB above")  # fmt: skip
    if below is not None:
        text = f"profile's level over it, {_db(found.least)} at {found.f_least:.5g} Hz"
        most = 1.0 / found.least if found.least > 0.0 else inf
        yield _check("level below", f"{text}{_width(found.below)}", most,
                     float(scale_level(1.0, below)), "", f"{below:g} dB below")  # fmt: skip


def _rms_in(profile: ASDProfile, low: float, high: float) -> float:
    """Return the rms of what a profile has in a band."""
    f, g = profile.frequencies, profile.levels
    if not max(low, f[0]) < min(high, f[-1]):
        return 0.0
    return rms(*clip_profile(f, g, lower=low, upper=high, scale=profile.scale), scale=profile.scale)


def _rms(measured: float, limit: float, share: float | None) -> Iterator[Check]:
    if share is not None and measured > 0.0:
        ratio = measured / limit
        off = max(ratio, 1.0 / ratio)
        bound = 1.0 + share if ratio >= 1.0 else 1.0 / (1.0 - share)
        text = f"rms, {ratio - 1.0:+.2%} from the profile's"
        yield _check("rms", text, off, bound, "", f"{share:.3g} of the rms either way")


def _check(name: str, text: str, demand: float, capacity: float, unit: str, source: str) -> Check:
    factor = capacity / demand if demand < inf else 0.0
    verdict = Verdict.PASS if factor >= 1.0 - ROUNDING else Verdict.FAIL
    return Check(name, "", text, demand, capacity, unit, factor, 1.0, verdict, source,
                 (factor, factor), MODEL)  # fmt: skip


def _db(ratio: float) -> str:
    return f"{10.0 * log10(ratio):+.2f} dB" if ratio > 0.0 else "nothing measured"


def _width(width: float) -> str:
    return f", beyond for {width:.4g} Hz" if width > 0.0 else ""


def _values(found: LevelDeviation, measured: float, limit: float) -> dict[str, Value]:
    least = 10.0 * log10(found.least) if found.least > 0.0 else -inf
    return {
        "db_most": Value(10.0 * log10(found.most) if found.most > 0.0 else -inf, "dB",
                         "most above the profile"),
        "f_most": Value(found.f_most, "Hz", "frequency of that"),
        "db_least": Value(least, "dB", "most below the profile"),
        "f_least": Value(found.f_least, "Hz", "frequency of that"),
        "width_above": Value(found.above, "Hz", "width of the band above the upper limit"),
        "width_below": Value(found.below, "Hz", "width of the band below the lower limit"),
        "g_rms": Value(measured, "m/s^2", "rms of the run in the band"),
        "g_rms_limit": Value(limit, "m/s^2", "rms of the profile in the band"),
    }  # fmt: skip


def _notes(
    measured: ASDProfile, limit: ASDProfile, names: tuple[str, str], band: tuple[float, float]
) -> Iterator[Note]:
    f = measured.frequencies
    if f[0] > band[0] or f[-1] < band[1]:
        text = f"{names[0]} spans {f[0]:g} to {f[-1]:g} Hz of {band[0]:g} to {band[1]:g} Hz"
        yield Note("band-not-covered", f"{text}: what was not measured is below every limit")
    ends = limit.frequencies[0], limit.frequencies[-1]
    if f[0] < ends[0] or f[-1] > ends[1]:
        text = f"{names[0]} goes beyond {names[1]}, {ends[0]:g} to {ends[1]:g} Hz"
        yield Note("beyond-band", f"{text}: what is there is not counted")
