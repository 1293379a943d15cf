"""The verbs on vibration environments alone, as functions: profiles, records, their spectra.

Each takes names: of shipped profiles, of files of a profile or a record. ``columns`` tells of a
table what its heading does not. What needs a design too stands in :mod:`flexcli.api`.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Literal

from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.spec.table_file import Columns

__all__ = [
    "asd_combine",
    "asd_envelope",
    "asd_equal_damage",
    "asd_fds",
    "asd_grms",
    "asd_list",
    "asd_scale",
    "asd_show",
    "asd_srs",
    "asd_tolerance",
]


def asd_list() -> Result:
    """List the shipped profiles: rms as computed and as published, status, standard."""
    from flexcli.spec.shipped import shipped_names

    return asd_grms(shipped_names("asd"), command="asd list")


def asd_grms(
    names: Sequence[str], *, command: str = "asd grms", columns: "Columns | None" = None
) -> Result:
    """Compute the rms of profiles, by shipped names or files, beside the published one."""
    from flexcli.engine.asd import catalogue
    from flexcli.spec.profiles import load_profiles

    return catalogue(command, load_profiles(names, columns))


def asd_show(name: str, *, columns: "Columns | None" = None) -> Result:
    """Describe a profile: breakpoints, slopes, rms values, moments, sources."""
    from flexcli.engine.asd import describe
    from flexcli.spec.profiles import load_profile

    return describe("asd show", name, load_profile(name, columns))


def asd_envelope(names: Sequence[str], *, columns: "Columns | None" = None) -> Result:
    """Describe the envelope of profiles, with the exact points where they cross."""
    from flexcli.engine.asd import describe, enveloped
    from flexcli.spec.profiles import load_profiles

    return describe("asd envelope", ", ".join(names), enveloped(load_profiles(names, columns)))


def asd_scale(name: str, db: float, *, columns: "Columns | None" = None) -> Result:
    """Describe a profile with its level raised by so many decibels."""
    from flexcli.engine.asd import describe, scaled
    from flexcli.spec.profiles import load_profile

    return describe("asd scale", name, scaled(name, load_profile(name, columns), db))


def asd_combine(
    names: Sequence[str],
    *,
    rule: Literal["sum", "envelope"] = "sum",
    columns: "Columns | None" = None,
) -> Result:
    """Describe profiles that act at once, as the sum of their powers, or their envelope."""
    from flexcli.engine.asd import describe, enveloped, summed
    from flexcli.spec.profiles import load_profiles

    together = summed if rule == "sum" else enveloped
    return describe("asd combine", ", ".join(names), together(load_profiles(names, columns)))


def asd_tolerance(
    measured: str,
    limit: str,
    *,
    above: float | None = None,
    below: float | None = None,
    rms: float | None = None,
    band: tuple[float | None, float | None] = (None, None),
    columns: "Columns | None" = None,
) -> Result:
    """Judge a measured run by the limits around the profile of a test.

    ``above`` and ``below`` [dB] are those of the profile where left out, ``rms`` is a share of its
    rms either way, ``band`` [Hz] the part that counts.
    """
    from flexcli.engine.asd_tolerance import Limits, tolerance
    from flexcli.spec.profiles import load_profiles

    found = load_profiles([measured, limit], columns)
    asked = Limits(above, below, rms, band)
    return tolerance(found[measured], found[limit], (measured, limit), asked)


def asd_srs(
    name: str,
    *,
    q: float = 10.0,
    low: float | None = None,
    high: float | None = None,
    per_octave: int = 12,
    duration: float | None = None,
    columns: "Columns | None" = None,
) -> Result:
    """Compute the shock response spectrum of a record, or the extreme one of a profile.

    ``low`` and ``high`` [Hz] end the natural frequencies; ``duration`` [s] is that of a profile.
    """
    from flexcli.engine.asd_damage import Environment, Grid, shock_response
    from flexcli.spec.records import load_environment

    environment = Environment(name, load_environment(name, columns), duration)
    return shock_response(environment, q, Grid(low, high, per_octave))


def asd_fds(
    name: str,
    *,
    exponent: float,
    q: float = 10.0,
    low: float | None = None,
    high: float | None = None,
    per_octave: int = 12,
    duration: float | None = None,
    columns: "Columns | None" = None,
) -> Result:
    """Compute the fatigue damage spectrum of a record or of a profile.

    ``exponent`` is that of the life curve, N ∝ amplitude^(−exponent).
    """
    from flexcli.engine.asd_damage import Environment, Grid, fatigue_damage
    from flexcli.spec.records import load_environment

    environment = Environment(name, load_environment(name, columns), duration)
    return fatigue_damage(environment, q, exponent, Grid(low, high, per_octave))


def asd_equal_damage(
    environments: Sequence[tuple[str, float | None]],
    *,
    duration: float,
    exponent: float,
    q: float = 10.0,
    to: str | None = None,
    low: float | None = None,
    high: float | None = None,
    columns: "Columns | None" = None,
) -> Result:
    """Describe a profile of a duration [s] that does the damage of environments.

    Each is the name of a profile or a record, and how long it lasts [s] where it does not say.
    ``to`` names the profile whose shape is taken, that of the first environment where left out.
    """
    from flexcli.engine.asd_damage import Environment, Grid, equal_damage
    from flexcli.spec.profiles import load_profile
    from flexcli.spec.records import load_environment

    found = [Environment(n, load_environment(n, columns), time) for n, time in environments]
    shape = Environment(to, load_profile(to, columns)) if to is not None else None
    return equal_damage(found, shape, duration, q, exponent, Grid(low, high))
