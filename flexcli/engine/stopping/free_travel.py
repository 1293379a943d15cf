"""How far a tip mass would go without stops under each case."""

from math import hypot, pi

import numpy as np

from flexcli.engine.stopping.damping import case_quality
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.mechanisms.tip_mass import TipMass
from flexcli.parts.response import random_response, shock_peaks

__all__ = ["free_travel"]


def free_travel(design: DesignSpec, mechanism: TipMass, sizes: Sizes) -> dict[str, float]:
    """Return the peak of the tip [m] by case, sigma times the rms of what is random; peaks add.

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
            if case.vibration is not None and "x" in case.vibration.axes:
                along_x = case.vibration.alone("x")
                response = random_response(structure, along_x)
                peaks.append(along_x.sigma * response.outputs["travel"].rms)
            if case.shock is not None and case.shock.axis == "x":
                peaks.append(shock_peaks(structure, case.shock)["travel"])
        except ValueError as error:
            raise SolveError(
                "no-response", f"case '{name}': {error}", "extend the spectrum to the modes"
            ) from error
        for sine in (case.sine, case.sweep, *case.sines):
            if sine is not None and sine.axis == "x":
                low, high = sine.band
                # the frequency at which the tip goes farthest
                f = min(max(angular / (2.0 * pi), low), high)
                ratio = 2.0 * pi * f / angular
                gain = 1.0 / hypot(1.0 - ratio**2, ratio / case_quality(mechanism, name, case))
                peaks.append(float(sine.level(np.array(f))) / angular**2 * gain)
        if peaks:
            found[name] = sum(peaks)
    return found
