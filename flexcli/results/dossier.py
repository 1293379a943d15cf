"""All data of a design review about one design, gathered from the verbs."""

from collections.abc import Mapping
from dataclasses import dataclass

from flexcli.results.drawing import Drawing
from flexcli.results.explanation import SymbolRow
from flexcli.results.result import Result
from flexcli.results.shown import rendered
from flexcli.results.simulation import Sweep

__all__ = ["Dossier", "Equation", "Region", "Spectrum"]


@dataclass(frozen=True, eq=False)
class Equation:
    """A formula with the numbers of a design inserted; None where one of them is not known."""

    title: str
    equation: str
    source: str
    symbols: tuple[SymbolRow, ...]
    gives: tuple[SymbolRow, ...]
    validity: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class Spectrum:
    """A random vibration over frequency [Hz]: its density, and what an oscillator makes of it.

    ``miles`` and ``exact`` are the rms accelerations [m/s²] of oscillators at ``natural`` [Hz].
    """

    case: str
    profile: str
    q: float
    frequency: tuple[float, ...]
    level: tuple[float, ...]
    log_level: bool
    natural: tuple[float, ...]
    miles: tuple[float, ...]
    exact: tuple[float, ...]
    modes: tuple[float, ...] = ()


@dataclass(frozen=True, eq=False)
class Region:
    """Margins by the closed forms over two sizes, the others as chosen.

    ``margins`` are factor over required factor per check, rows by ``y``, columns by ``x`` [m].
    """

    names: tuple[str, str]
    x: tuple[float, ...]
    y: tuple[float, ...]
    margins: Mapping[str, tuple[tuple[float, ...], ...]]
    chosen: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Dossier:
    """One design with its verdicts, drawing, stroke, spectra, equations, and what was asked.

    ``drawing`` is that of its joint, ``mechanism`` that of the bodies on several of them.
    """

    result: Result
    text: str
    drawing: Drawing | None = None
    mechanism: Drawing | None = None
    sweeps: tuple[Sweep, ...] = ()
    spectra: tuple[Spectrum, ...] = ()
    equations: tuple[Equation, ...] = ()
    region: Region | None = None
    not_shown: tuple[str, ...] = ()

    def _repr_html_(self) -> str | None:
        html: str | None = rendered(self, "html")
        return html
