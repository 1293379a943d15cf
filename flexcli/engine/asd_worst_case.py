"""The verb worst-case: Miles over all frequencies, beside the exact response, and the peaks."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.asd import column
from flexcli.errors import SolveError
from flexcli.formulas.miles import miles, miles_worst_case
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.peaks import MINIMUM_CYCLES, davenport_peak_factor, peak_factor
from flexcli.formulas.response_spectrum import ResponseSpectrum
from flexcli.parts.asd import AppliedASD, ASDProfile, RandomVibration
from flexcli.parts.case import Case
from flexcli.parts.design import DesignSpec
from flexcli.parts.quality import Quality
from flexcli.results import Cost, Note, Result, Status, Value
from flexcli.results.vibration import Spectrum, WorstCaseRow
from flexcli.units import STANDARD_GRAVITY, show

__all__ = ["Environment", "environments", "exposed", "over_frequency", "worst_case"]

Floats = NDArray[np.float64]

MODEL = "closed-form (Miles) and quadrature (exact)"
CRITICAL = 0.5
"""Below this Q an oscillator does not oscillate, and has no resonance to design for."""
NEGLIGIBLE = 1e-3
"""Miles is called unsafe from so much below the exact response: less than it is quoted with."""

A_DECADE = 41
"""Natural frequencies a decade, and the fewest of all, at which the rms is given."""
LEAST_LEVEL = 1e-300
"""Level that stands for none where a logarithm is taken."""

MILES = "Miles, √(π/2 f Q ASD), over all frequencies"
EXACT = "exact single-degree-of-freedom response to the profile's band"
RICE = "√(2 ln(f₀ T)); Rice 1945"
DAVENPORT = "c + 0.5772/c, c = √(2 ln(f₀ T)); Davenport 1964"


@dataclass(frozen=True, eq=False)
class Environment:
    """One case's density as it is designed for, its profile, Q and sigma."""

    case: str
    name: str
    profile: ASDProfile
    applied: AppliedASD
    q: float
    sigma: float
    tolerance: float


def environments(
    design: DesignSpec, qualities: Sequence[float] = (), duration: float | None = None
) -> list[Environment]:
    """Return every vibration of a design, with its own Q and duration or with those given."""
    _refuse_overdamped(qualities)
    return [
        _environment(name, use.profile.name, use, q, duration)
        for case, loads in design.cases.items()
        for name, use in _profiles(case, loads)
        for q in qualities or (use.q.all,)
    ]


def _profiles(case: str, loads: Case) -> list[tuple[str, RandomVibration]]:
    """Return the profiles of a case, those by axis under names of their own."""
    if loads.asd is not None:
        return [(case, loads.asd)]
    every = loads.vibration
    axes = every.axes if every is not None else ()
    return [(f"{case} along {axis}", every.alone(axis)) for axis in axes if every is not None]


def exposed(
    name: str, profile: ASDProfile, qualities: Sequence[float], duration: float | None = None
) -> list[Environment]:
    """Return a profile as it is, with every Q given."""
    _refuse_overdamped(qualities)
    return [
        _environment("", name, RandomVibration(profile=profile, q=Quality(all=q)), q, duration)
        for q in qualities
    ]


def _refuse_overdamped(qualities: Sequence[float]) -> None:
    for q in qualities:
        if q < CRITICAL:
            text = f"Q = {q:g} is below {CRITICAL:g}, critical damping: nothing resonates"
            raise SolveError("overdamped", text, f"give a Q of at least {CRITICAL:g}")


def _environment(
    case: str, name: str, use: RandomVibration, q: float, duration: float | None
) -> Environment:
    applied = use.applied()
    if duration is not None:
        applied = replace(applied, duration=duration)
    return Environment(case, name, use.profile, applied, q, use.sigma, use.tolerance)


def over_frequency(each: Environment) -> tuple[Floats, Floats, Floats, Floats]:
    """Return the rms acceleration of oscillators by their natural frequency.

    Returns
    -------
    natural : array
        Natural frequencies over the profile's band, evenly spaced in logarithms, and those of the
        profile's points [Hz].
    level : array
        Density there [(m/s²)²/Hz].
    miles, exact : array
        Rms absolute acceleration [m/s²].

    """
    f, g = np.asarray(each.applied.frequency), np.asarray(each.applied.level)
    count = max(int(A_DECADE * np.log10(f[-1] / f[0])), A_DECADE)
    natural = np.union1d(np.geomspace(f[0], f[-1], count)[1:-1], f)
    if each.applied.scale == "log":
        level = np.exp(np.interp(np.log(natural), np.log(f), np.log(np.maximum(g, LEAST_LEVEL))))
    else:
        level = np.interp(natural, f, g)
    exact = ResponseSpectrum(f, g, each.q, each.applied.scale)(natural)
    return natural, level, miles(natural, each.q, level), exact


def _spectrum(each: Environment) -> Spectrum:
    natural, level, by_miles, exact = over_frequency(each)
    columns = (
        ("frequency", "Hz", "natural frequency of an oscillator", natural),
        ("miles", "m/s^2", "rms acceleration, by Miles", by_miles),
        ("exact", "m/s^2", "rms acceleration, exact", exact),
        ("level", "(m/s^2)^2/Hz", "density of the profile", level),
    )
    title = f"rms acceleration of oscillators, {each.name}, Q = {each.q:g}"
    return Spectrum("worst-case", title, each.case, tuple(column(*x) for x in columns))


def worst_case(
    found: Sequence[Environment], spec: str, title: str = "", *, spectra: bool = False
) -> Result:
    """Return Miles' worst case and the exact response of every environment; the greatest leads.

    ``spectra`` asks for both over the natural frequency besides.
    """
    started = perf_counter()
    rows = [_row(each) for each in found]
    lead = max(rows, key=lambda row: row.g_rms_worst)
    notes = dict.fromkeys(
        note for each, row in zip(found, rows, strict=True) for note in _notes(each, row, rows)
    )
    return Result(
        command="asd worst-case",
        spec=spec,
        status=Status.PASS,
        title=title,
        values=_values(lead),
        warnings=tuple(notes),
        worst_cases=tuple(rows),
        spectra=tuple(map(_spectrum, found)) if spectra else (),
        cost=Cost(perf_counter() - started, MODEL, abs(lead.miles_excess)),
    )


def _row(each: Environment) -> WorstCaseRow:
    f, g, scale = each.applied.frequency, each.applied.level, each.applied.scale
    worst = miles_worst_case(f, g, each.q, scale=scale)
    rms = float(worst.response)
    there = oscillator_response(f, g, worst.frequency, each.q, scale=scale)
    spectrum = ResponseSpectrum(f, g, each.q, scale)
    most, low = spectrum.maximum(), spectrum.shortfall()
    time = each.applied.duration
    peak = davenport = None
    if time is not None and worst.frequency * time > 1.0:
        peak = float(peak_factor(worst.frequency, time))
        davenport = float(davenport_peak_factor(worst.frequency, time))
    return WorstCaseRow(
        case=each.case,
        profile=each.name,
        applied=each.applied.text,
        q=each.q,
        f_worst=worst.frequency,
        g_rms_worst=rms,
        g_rms_exact=float(there.absolute_acceleration),
        g_rms_pseudo=float(there.pseudo_acceleration),
        f_max=most.frequency,
        g_rms_max=most.response,
        miles_excess_there=rms / float(there.absolute_acceleration) - 1.0,
        miles_excess=rms / most.response - 1.0,
        shortfall=low.excess / (1.0 + low.excess) if low.excess > 0.0 else 0.0,
        f_shortfall=low.frequency if low.excess > 0.0 else None,
        duration=time,
        c_sigma=each.sigma,
        a_sigma=each.sigma * rms,
        c_peak=peak,
        a_peak=peak * rms if peak is not None else None,
        c_davenport=davenport,
        a_davenport=davenport * rms if davenport is not None else None,
    )


def _notes(each: Environment, row: WorstCaseRow, rows: Sequence[WorstCaseRow]) -> Iterator[Note]:
    """Yield what a designer should know before trusting Miles, or the number of sigma."""
    case = f"{row.case}: " if row.case else ""
    about = f"{case}Q = {row.q:g}: " if len(rows) > 1 else case
    if row.shortfall > NEGLIGIBLE and row.f_shortfall is not None:
        yield Note(
            "miles-unsafe",
            f"{about}Miles is up to {row.shortfall:.1%} below the exact response, most at "
            f"{row.f_shortfall:.5g} Hz",
        )
    if row.miles_excess < -NEGLIGIBLE:
        yield Note(
            "worst-case-unsafe",
            f"{about}the worst case of Miles is {-row.miles_excess:.1%} below the greatest exact "
            f"response, {row.g_rms_max / STANDARD_GRAVITY:.4g} g at {row.f_max:.5g} Hz",
        )
    if row.duration is None:
        yield Note("no-duration", f"{case}no duration is given: only {row.c_sigma:g}σ is known")
    elif row.duration * row.f_worst < MINIMUM_CYCLES:
        yield Note(
            "few-cycles",
            f"{case}{row.duration * row.f_worst:.3g} cycles at {row.f_worst:g} Hz are too few for "
            "a peak factor",
        )
    elif row.c_peak is not None and row.c_peak > row.c_sigma:
        yield Note(
            "sigma-exceeded",
            f"{case}in {show(row.duration, 's')} at {row.f_worst:g} Hz the greatest peak is "
            f"{row.c_peak:.2f}σ, beyond the {row.c_sigma:g}σ of the design",
        )
    allowed = each.profile.tolerance
    if allowed is not None and each.tolerance < allowed.above:
        yield Note(
            "tolerance-not-applied",
            f"{case}the test may be {allowed.above:g} dB above its profile; "
            f"{each.tolerance:g} dB is designed for",
        )
    if each.profile.status in ("unverified", "reconstructed"):
        yield Note(
            "levels-not-verified",
            f"{case}the levels of this profile are {each.profile.status}: see its note",
        )


def _values(row: WorstCaseRow) -> dict[str, Value]:
    """Return the row as named values with label, model and source."""
    exact = "quadrature"
    values = {
        "f_worst": Value(row.f_worst, "Hz", "frequency of the worst case"),
        "g_rms_worst": Value(
            row.g_rms_worst, "m/s^2", f"worst rms acceleration, Q = {row.q:g}", source=MILES
        ),
        "g_rms_exact": Value(
            row.g_rms_exact, "m/s^2", "exact rms absolute acceleration there", exact, EXACT
        ),
        "g_rms_pseudo": Value(
            row.g_rms_pseudo, "m/s^2", "exact rms pseudo-acceleration (spring) there", exact, EXACT
        ),
        "g_rms_max": Value(
            row.g_rms_max,
            "m/s^2",
            "greatest exact rms absolute acceleration, over all frequencies",
            exact,
            EXACT,
        ),
        "f_max": Value(row.f_max, "Hz", "frequency of the greatest exact response", exact, EXACT),
        "miles_excess_there": Value(
            row.miles_excess_there, "", "worst case above the exact response there"
        ),
        "miles_excess": Value(row.miles_excess, "", "worst case above the greatest exact response"),
        "shortfall": Value(
            row.shortfall, "", "most that Miles is below the exact response in the band", exact
        ),
        "c_sigma": Value(row.c_sigma, "", "peak over rms, as designed for"),
        "a_sigma": Value(row.a_sigma, "m/s^2", f"peak of {row.c_sigma:g}σ"),
    }
    if row.f_shortfall is not None:
        values["f_shortfall"] = Value(row.f_shortfall, "Hz", "frequency of that", exact)
    if row.c_peak is not None and row.a_peak is not None:
        told = f"most probable greatest peak in {show(row.duration or 0.0, 's')}"
        values["c_peak"] = Value(row.c_peak, "", "peak over rms, √(2 ln(f₀ T))", source=RICE)
        values["a_peak"] = Value(row.a_peak, "m/s^2", told, source=RICE)
    if row.c_davenport is not None and row.a_davenport is not None:
        label = "peak over rms, Davenport's mean"
        values["c_davenport"] = Value(row.c_davenport, "", label, source=DAVENPORT)
        values["a_davenport"] = Value(
            row.a_davenport, "m/s^2", "mean greatest peak", source=DAVENPORT
        )
    return values
