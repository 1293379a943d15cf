"""The life of a material under a random stress, by every method."""

from math import inf, log

import numpy as np

from flexcli.formulas.damage import METHODS, damage_rates
from flexcli.formulas.fatigue import goodman_factor
from flexcli.formulas.spectral_moments import Moments
from flexcli.parts.material import Material, MissingProperty

__all__ = ["life_under", "sn_law"]

UNIT = 1e6
"""Stress unit inside, 1 MPa in Pa: S^-k of a steep curve in Pa would leave the range of floats."""


def sn_law(material: Material) -> tuple[float, float]:
    """Return k and C of N = C S^-k in fully reversed stress amplitude S [MPa].

    From Basquin's law, or the last line of the S-N points. A curve that flattens with the cycles
    lies above the continuation of its last line to shorter lives, so this is the safe side there;
    beyond the curve no endurance limit is taken.
    """
    (n1, s1), (n2, s2) = material.reversed_curve()[-2:]
    if s1 == s2:
        raise MissingProperty("sn_amplitudes", "a life needs its last line to fall")
    k = log(n2 / n1) / log(s1 / s2)
    return k, n2 * (s2 / UNIT) ** k


def life_under(
    material: Material, moments: tuple[float, float, float, float], mean: float = 0.0
) -> dict[str, float]:
    """Return the time to failure [s] by each method, for moments of the stress [Pa² Hz^n].

    A standing tension [Pa] raises every amplitude by 1/(1 − σ_m/R_m) (Goodman); one that reaches
    R_m leaves no life.
    """
    if moments[0] == 0.0:
        return {name: inf for name, _ in METHODS}
    k, constant = sn_law(material)
    factor = 1.0
    if mean > 0.0:
        strength = material.strength("tensile_strength")
        if mean >= strength:
            return {name: 0.0 for name, _ in METHODS}
        factor = float(goodman_factor(mean, strength))
    m0, m1, m2, m4 = np.array(moments) * (factor / UNIT) ** 2
    rates = damage_rates(Moments(m0, m1, m2, m4), k, constant)
    return {name: (1.0 / float(rate) if rate > 0.0 else inf) for name, rate in rates.items()}
