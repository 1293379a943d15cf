"""The life of a material under a random stress, by every method."""

from math import exp, inf, log, sqrt
from typing import NamedTuple

import numpy as np

from flexcli.formulas.damage import CURVE_METHODS, METHODS, curve_damage_rates, damage_rates
from flexcli.formulas.fatigue import goodman_factor
from flexcli.formulas.sine_on_random import rice_damage_rate
from flexcli.formulas.spectral_moments import Moments
from flexcli.parts.material import Material, MissingProperty

__all__ = ["SineStress", "life_curve", "life_under"]

UNIT = 1e6
"""Stress unit inside, 1 MPa in Pa: S^-k of a steep curve in Pa would leave the range of floats."""


STATIC = 0.5
"""Cycles to failure at the tensile strength: one reversal."""


def life_curve(material: Material) -> tuple[tuple[float, float], ...]:
    """Return the corners (cycles, fully reversed AMPLITUDE [Pa]) of the life curve used for damage.

    Basquin's law is its own line. Points are taken on the safe side: of a level stretch the fewest
    cycles; the last falling line is continued (no endurance limit among larger cycles: Miner
    elementary); the upper end goes to the tensile strength at one reversal, where that is known and
    lies below the first line continued.
    """
    falling: list[tuple[float, float]] = []
    for cycles, amplitude in material.reversed_curve():
        if not falling or amplitude < falling[-1][1]:
            falling.append((cycles, amplitude))
    if len(falling) < 2:
        raise MissingProperty("sn_amplitudes", "a life needs a line of it to fall")
    given, strength = material.sn_amplitudes, material.tensile_strength
    if given is None or given.basquin is not None or strength is None:
        return tuple(falling)
    top = material.strength("tensile_strength")
    (n1, s1), (n2, s2) = falling[:2]
    continued = log(s1) + (log(s1) - log(s2)) / log(n2 / n1) * log(n1 / STATIC)
    if n1 > STATIC and s1 < top < exp(min(continued, 700.0)):
        return ((STATIC, top), *falling)
    return tuple(falling)


class SineStress(NamedTuple):
    """Sines on a random stress: sum of their amplitudes [Pa], highest of their frequencies."""

    amplitude: float = 0.0
    frequency: float = 0.0


NO_SINE = SineStress()


def life_under(
    material: Material,
    moments: tuple[float, float, float, float],
    mean: float = 0.0,
    sine: SineStress = NO_SINE,
) -> dict[str, float]:
    """Return the time to failure [s] by each method, for moments of the stress [Pa² Hz^n].

    A method that is fitted to one slope has no life on a curve of several lines; with sines on
    the random stress the amplitudes are Rice's, and that is the one method.

    A standing tension [Pa] raises every amplitude by 1/(1 − σ_m/R_m) (Goodman); one that reaches
    R_m leaves no life.
    """
    curve, factor = life_curve(material), 1.0
    is_straight = len(curve) == 2
    names = [name for name, _ in METHODS] if is_straight else CURVE_METHODS
    if sine.amplitude > 0.0:
        names = ["rice"]
    elif moments[0] == 0.0:
        return dict.fromkeys(names, inf)
    if mean > 0.0:
        strength = material.strength("tensile_strength")
        if mean >= strength:
            return dict.fromkeys(names, 0.0)
        factor = float(goodman_factor(mean, strength))
    m0, m1, m2, m4 = np.array(moments) * (factor / UNIT) ** 2
    of, points = Moments(m0, m1, m2, m4), tuple((n, s / UNIT) for n, s in curve)
    if sine.amplitude > 0.0:
        crossings = sqrt(m2 / m0) if m0 > 0.0 else 0.0
        cycles = max(crossings, sine.frequency)
        size = sine.amplitude * factor / UNIT
        rates = {"rice": rice_damage_rate(sqrt(m0), size, cycles, points)}
    elif is_straight:
        (n1, s1), (n2, s2) = points
        k = log(n2 / n1) / log(s1 / s2)
        rates = {name: float(x) for name, x in damage_rates(of, k, n2 * s2**k).items()}
    else:
        rates = curve_damage_rates(of, points)
    return {name: (1.0 / rate if rate > 0.0 else inf) for name, rate in rates.items()}
