"""How far a tip mass would go without stops under each case."""

from math import hypot, pi

from flexcli.engine.stopping.damping import case_quality
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.excitation import Sine, Sweep
from flexcli.parts.geometries import Sizes
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.parts.response import random_response, shock_peaks

__all__ = ["free_travel"]


def free_travel(design: DesignSpec, mechanism: TipMass, sizes: Sizes) -> dict[str, float]:
    """Return the peak of the tip [m] by case: sigma times the rms where it is random.

    Raises
    ------
    SolveError
        ``no-response`` where a vibration or shock says nothing about the tip.
    """
    structure = mechanism.structure(design.geometry, design.material.elastic, sizes, None)
    stiffness = float(design.geometry.stiffness(design.material.elastic, sizes))
    angular = (stiffness / mechanism.equivalent_mass(sizes.l)) ** 0.5
    found: dict[str, float] = {}
    for name, case in design.cases.items():
        peaks = []
        try:
            if case.asd is not None and "x" in case.asd.axes:
                along_x = case.asd.model_copy(update={"axis": "x"})
                response = random_response(structure, along_x)
                peaks.append(case.asd.sigma * response.outputs["travel"].rms)
            if case.shock is not None and case.shock.axis == "x":
                peaks.append(shock_peaks(structure, case.shock)["travel"])
        except ValueError as error:
            raise SolveError(
                "no-response", f"case '{name}': {error}", "extend the spectrum to the modes"
            ) from error
        for sine in (case.sine, case.sweep):
            if sine is not None:
                ratio = _drive(sine, angular) / angular
                gain = 1.0 / hypot(1.0 - ratio**2, ratio / case_quality(mechanism, name, case))
                peaks.append(sine.acceleration / angular**2 * gain)
        if peaks:
            found[name] = max(peaks)
    return found


def _drive(sine: Sine | Sweep, angular: float) -> float:
    """Return the angular frequency at which the tip goes farthest."""
    if isinstance(sine, Sine):
        return 2.0 * pi * sine.frequency
    low, high = sorted((2.0 * pi * sine.start, 2.0 * pi * sine.end))
    return min(max(angular, low), high)
