"""The life of a material under a random stress, by every method."""

from math import inf, log

import numpy as np

from flexcli.formulas.spectral_fatigue import Moments, damage_rates
from flexcli.parts.material import Material, MissingProperty

__all__ = ["life_under", "sn_law"]


def sn_law(material: Material) -> tuple[float, float]:
    """Return k and C of N = C S^-k in fully reversed stress amplitude S [Pa].

    From Basquin's law, or from the flattest line of the S-N points, which is the one that small
    amplitudes meet. No endurance limit is taken: small amplitudes do damage.
    """
    curve = material.reversed_curve()
    (n1, s1), (n2, s2) = curve[-2:]
    if s1 == s2:
        raise MissingProperty("sn_amplitudes", "its last line is flat, which gives no slope")
    k = log(n2 / n1) / log(s1 / s2)
    return k, n2 * s2**k


def life_under(material: Material, moments: tuple[float, float, float, float]) -> dict[str, float]:
    """Return the time to failure [s] by each method, for spectral moments of the stress [Pa² Hzⁿ].

    The amplitude is scaled to MPa inside, so that S^-k of a steep curve stays within floats.
    """
    if moments[0] == 0.0:
        return {}
    k, constant = sn_law(material)
    unit = 1e6
    scaled = Moments(*(np.float64(m / unit**2) for m in moments))  # type: ignore[arg-type]
    rates = damage_rates(scaled, k, constant / unit**k)
    return {name: (1.0 / float(rate) if rate > 0.0 else inf) for name, rate in rates.items()}
