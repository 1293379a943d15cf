"""``flexure asd`` on environments: responses, measured runs, shock and damage spectra, tests."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from flexcli.cli.asd.common import (
    ColumnOption,
    TableOption,
    UnitsOption,
    WriteOption,
    app,
    columns_of,
    finish_made,
    finish_one,
    finish_spectrum,
    quantity,
    refuse_no_quality,
    refuse_no_table,
    saved_spectra,
)
from flexcli.cli.common import (
    DEFAULT_SPEC,
    STDIN,
    Format,
    FormatOption,
    SetOption,
    SpecsArgument,
    finish,
    on_each,
    only_one,
    overrides_of,
    read,
    with_common_options,
)
from flexcli.cli.files import ForceOption
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

KINDS: tuple[Literal["density", "transfer"], ...] = ("density", "transfer")

MOST_EXPONENT = 30.0
"""Steeper curves are no fatigue, and their damage leaves the range of floats."""

SourceArgument = Annotated[
    str, typer.Argument(help="Name a shipped profile, a file of one, or a record (.csv).")
]
QualityOption = Annotated[float, typer.Option("--q", help="Take this quality factor.")]
ExponentOption = Annotated[
    float, typer.Option("--exponent", "-b", help="Take this exponent of the life curve, N ∝ 1/a^b.")
]
DurationOption = Annotated[
    str | None, typer.Option("--duration", help="Give the time of exposure, e.g. '2 min'.")
]
FromOption = Annotated[str | None, typer.Option("--from", help="Start here, e.g. '20 Hz'.")]
ToOption = Annotated[str | None, typer.Option("--to", help="End here, e.g. '2 kHz'.")]
PerOctaveOption = Annotated[
    int,
    typer.Option("--per-octave", min=1, max=1000, help="Natural frequencies per octave."),
]


@app.command()
@with_common_options
def response(
    specs: SpecsArgument = None,
    stated: SetOption = None,
    densities: Annotated[
        Path | None,
        typer.Option("--csv", "-o", help="Save the densities of the responses, .csv or .parquet."),
    ] = None,
    transfers: Annotated[
        Path | None,
        typer.Option("--frf", help="Save the transfer functions to every body, likewise."),
    ] = None,
    force: ForceOption = False,
    style: FormatOption = Format.TEXT,
) -> None:
    """Compute what a design's modes make of each case.

    It gives modes, rms and peaks of travel, stress and force, and life.
    """
    only_one("asd response", "--csv", specs, densities or transfers, style)
    files = {"density": densities, "transfer": transfers}

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        for path in files.values():
            refuse_no_table(path)
        return api.asd_response(spec, spectra=[kind for kind in KINDS if files[kind]])

    results = on_each("asd response", specs, stated, verb)
    with (
        saved_spectra(densities, results, "density", force=force),
        saved_spectra(transfers, results, "transfer", force=force),
    ):
        finish("asd response", results, style, many=len(results) > 1)


@app.command("worst-case")
@with_common_options
def worst_case(
    spec: Annotated[
        str, typer.Argument(help="Name a design, a shipped profile, or a file of a profile.")
    ] = DEFAULT_SPEC,
    qualities: Annotated[
        list[float] | None,
        typer.Option("--q", help="Give a quality factor, once or more; a design has its own."),
    ] = None,
    duration: DurationOption = None,
    units: UnitsOption = None,
    column: ColumnOption = None,
    stated: SetOption = None,
    output: TableOption = None,
    force: ForceOption = False,
    style: FormatOption = Format.TEXT,
) -> None:
    """Give Miles' worst case over all frequencies.

    Beside it stand the exact response and its peaks.
    """

    def verb() -> Result:
        from flexcli import api

        refuse_no_quality(qualities or [])
        refuse_no_table(output)
        source = spec if spec != STDIN else read(Path(spec), None)
        return api.asd_worst_case(
            source,
            qualities=qualities or (),
            duration=quantity("--duration", duration, "time"),
            spectra=output is not None,
            columns=columns_of(units, column),
            overrides=overrides_of(stated),
        )

    finish_spectrum("worst-case", spec, verb, output, style, force=force)


@app.command()
@with_common_options
def tolerance(
    measured: Annotated[str, typer.Argument(help="Name the file of the measured run.")],
    limit: Annotated[str, typer.Argument(help="Name the profile of the test.")],
    above: Annotated[
        str | None, typer.Option("--above", help="Allow so much above, e.g. '3 dB'.")
    ] = None,
    below: Annotated[
        str | None, typer.Option("--below", help="Allow so much below, e.g. '1.5 dB'.")
    ] = None,
    grms: Annotated[
        str | None, typer.Option("--grms", help="Allow the rms so much off, e.g. '10 %'.")
    ] = None,
    low: FromOption = None,
    high: ToOption = None,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Judge a measured run by the limits around a test's profile.

    The limits are the profile's own where none are given. It exits 1 when the run is out.
    """

    def verb() -> Result:
        from flexcli import api

        share = quantity("--grms", grms, "ratio")
        if share is not None and share >= 1.0:
            raise SpecError([Finding("--grms", f"{grms} must be below 100 %", "give e.g. '10 %'")])
        return api.asd_tolerance(
            measured,
            limit,
            above=quantity("--above", above, "decibel", least=-1e-300),
            below=quantity("--below", below, "decibel", least=-1e-300),
            rms=share,
            band=(quantity("--from", low, "frequency"), quantity("--to", high, "frequency")),
            columns=columns_of(units, column),
        )

    finish_one("tolerance", measured, verb, style)


@app.command()
@with_common_options
def srs(
    source: SourceArgument,
    q: QualityOption = 10.0,
    duration: DurationOption = None,
    low: FromOption = None,
    high: ToOption = None,
    per_octave: PerOctaveOption = 12,
    output: TableOption = None,
    force: ForceOption = False,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Compute the shock response spectrum of a record.

    Of a random vibration it is the extreme response spectrum, over its duration.
    """

    def verb() -> Result:
        from flexcli import api

        refuse_no_quality([q])
        refuse_no_table(output)
        return api.asd_srs(
            source,
            q=q,
            low=quantity("--from", low, "frequency"),
            high=quantity("--to", high, "frequency"),
            per_octave=per_octave,
            duration=quantity("--duration", duration, "time"),
            columns=columns_of(units, column),
        )

    finish_spectrum("srs", source, verb, output, style, force=force)


@app.command()
@with_common_options
def fds(
    source: SourceArgument,
    exponent: ExponentOption,
    q: QualityOption = 10.0,
    duration: DurationOption = None,
    low: FromOption = None,
    high: ToOption = None,
    per_octave: PerOctaveOption = 12,
    output: TableOption = None,
    force: ForceOption = False,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Compute the fatigue damage spectrum of an environment.

    Cycles of a record are counted by rainflow (extra vibration); a profile's are narrow-band.
    """

    def verb() -> Result:
        from flexcli import api

        refuse_no_quality([q])
        _refuse_no_exponent(exponent)
        refuse_no_table(output)
        return api.asd_fds(
            source,
            exponent=exponent,
            q=q,
            low=quantity("--from", low, "frequency"),
            high=quantity("--to", high, "frequency"),
            per_octave=per_octave,
            duration=quantity("--duration", duration, "time"),
            columns=columns_of(units, column),
        )

    finish_spectrum("fds", source, verb, output, style, force=force)


@app.command("equal-damage")
@with_common_options
def equal_damage(
    environments: Annotated[
        list[str],
        typer.Argument(
            metavar="NAME[=DURATION]...",
            help="Name profiles or records with the time each lasts, e.g. road.yaml='20 h'.",
        ),
    ],
    duration: Annotated[str, typer.Option("--duration", help="Let the test last, e.g. '2 min'.")],
    exponent: ExponentOption,
    shape: Annotated[
        str | None, typer.Option("--shape", help="Take the shape of this profile.")
    ] = None,
    q: QualityOption = 10.0,
    low: FromOption = None,
    high: ToOption = None,
    write: WriteOption = None,
    force: ForceOption = False,
    units: UnitsOption = None,
    column: ColumnOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Turn environments into a test of equal damage.

    It has the shape of the first, or of another profile, and no less damage at any frequency.
    """

    def verb() -> Result:
        from flexcli import api

        refuse_no_quality([q])
        _refuse_no_exponent(exponent)
        parts = [name.partition("=") for name in environments]
        told = [(name, quantity(name, time or None, "time")) for name, _, time in parts]
        seconds = quantity("--duration", duration, "time")
        assert seconds is not None  # it is required
        return api.asd_equal_damage(
            told,
            duration=seconds,
            exponent=exponent,
            q=q,
            to=shape,
            low=quantity("--from", low, "frequency"),
            high=quantity("--to", high, "frequency"),
            columns=columns_of(units, column),
        )

    finish_made("equal-damage", ", ".join(environments), verb, write, style, force=force)


@app.command()
@with_common_options
def notch(
    spec: Annotated[str, typer.Argument(help="Name a design, or - for stdin.")] = DEFAULT_SPEC,
    constant: Annotated[
        float | None, typer.Option("--c", help="Give the constant C of the force limit, e.g. 1.5.")
    ] = None,
    knee: Annotated[
        str | None,
        typer.Option("--knee", help="Let it fall from here; left out, the mode of most mass."),
    ] = None,
    exponent: Annotated[
        float, typer.Option("--rolloff", help="Let it fall with this power of the frequency.")
    ] = 2.0,
    fixed_mass: Annotated[
        str | None, typer.Option("--fixed-mass", help="Add what stands beside, e.g. '1.2 kg'.")
    ] = None,
    case: Annotated[str | None, typer.Option("--case", help="Take this case of several.")] = None,
    axis: Annotated[str | None, typer.Option("--axis", help="Take this axis of several.")] = None,
    write: WriteOption = None,
    force: ForceOption = False,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Notch the profile of a case to limit the force at the base.

    The limit is semi-empirical: C² M₀² times the profile, falling beyond the knee.
    """

    def verb() -> Result:
        from flexcli import api

        if constant is None or not constant > 0.0:
            hint = "add --c 1.5, from tests of similar items"
            raise SpecError([Finding("--c", "the constant of the force limit is missing", hint)])
        if not exponent > 0.0:
            raise SpecError([Finding("--rolloff", f"{exponent:g} must be above 0", "give e.g. 2")])
        return api.asd_notch(
            read(Path(spec), None),
            constant=constant,
            knee=quantity("--knee", knee, "frequency"),
            exponent=exponent,
            fixed_mass=quantity("--fixed-mass", fixed_mass, "mass", least=-1e-300) or 0.0,
            case=case,
            axis=axis,
            overrides=overrides_of(stated),
        )

    finish_made("notch", spec, verb, write, style, force=force)


def _refuse_no_exponent(exponent: float) -> None:
    if not 1.0 <= exponent <= MOST_EXPONENT:
        hint = f"give 1 to {MOST_EXPONENT:g}, e.g. 8"
        raise SpecError([Finding("--exponent", f"{exponent:g} is no slope of a life curve", hint)])
