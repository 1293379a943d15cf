"""The plots that a dossier has data for."""

from collections.abc import Iterator

from flexcli.report.plots.plot import Plot
from flexcli.report.plots.sizes import front_plot, region_plot
from flexcli.report.plots.stroke import along_plot, stroke_plots
from flexcli.report.plots.vibration import spectrum_plot
from flexcli.results.dossier import Dossier

__all__ = ["plots"]


def plots(dossier: Dossier) -> Iterator[Plot]:
    """Yield the plots of a dossier, beside the bars and tables that its page has itself."""
    for sweep in dossier.sweeps:
        if len(sweep.points) > 1:
            yield from stroke_plots(sweep)
    if dossier.drawing is not None and any(s.stress for s in dossier.drawing.states):
        yield along_plot(dossier.drawing)
    for spectrum in dossier.spectra:
        yield spectrum_plot(spectrum)
    if dossier.region is not None:
        yield region_plot(dossier.region)
    if dossier.result.front is not None:
        yield front_plot(dossier.result.front)
