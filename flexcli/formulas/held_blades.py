"""Pivots of blades that point at one centre, at rest: shear and stretching in their S-bending.

Turned by θ about the centre, each blade bends uniformly, free of force, and in an S-shaped part
(γ = 1 + 2δ) that a force across it keeps up. Blades whose forces do not cancel shift the centre
by d, which lessens the S-shaped part and pulls or pushes along the blades.
"""

from math import cos, sin
from typing import NamedTuple

import numpy as np

from flexcli.formulas.card import Card

__all__ = ["CARDS", "AtRest", "at_rest"]


class AtRest(NamedTuple):
    """Small rotation of such a pivot, relative to slender blades with a fixed centre."""

    stiffness: float
    """Rotational stiffness over that of the closed form [-]."""
    bending: float
    """Largest bending stress over that of the closed form [-]."""
    stress: float
    """Largest stress with the axial one, over the same [-]."""


def at_rest(*, slender: float, gamma: float, angles: tuple[float, ...], Phi: float) -> AtRest:
    """Return stiffness and stress of blades that point at one centre, over their closed forms.

    ``k_a = 12/(h/l)²`` along and ``k_s = 12/(1 + Φ)`` across each blade [EI/l³];
    ``d = −(Σ k_a e eᵀ + k_s n nᵀ)⁻¹ k_s (γ θ l/2) Σ n``, ``f = k_s (γ θ l/2 + n·d)``,
    ``N = k_a e·d``, moments ``(EI/l) θ ± f l/2``.

    Parameters
    ----------
    slender : Quantity
        h/l [-].
    gamma : Quantity
        γ = 1 + 2p/l [-].
    angles : tuple of float
        Direction of each blade [rad]; not all parallel.
    Phi : Quantity
        Timoshenko's shear parameter of a blade, 0 without shear [-].

    Returns
    -------
    found : AtRest
        Ratios to the closed forms ``N EI/l (1 + 3γ²)`` and ``E h θ/(2l) (1 + 3|γ|)``.

    Notes
    -----
    Exact for the linear beam of Timoshenko; for two blades the factors of
    :mod:`flexcli.formulas.thick_blades`.

    Examples
    --------
    >>> from math import pi
    >>> star = (0.0, 2 * pi / 3, 4 * pi / 3)
    >>> round(at_rest(slender=0.1, gamma=1.0, angles=star, Phi=0.0).stiffness, 12)
    1.0
    >>> pair = at_rest(slender=0.1, gamma=1.0, angles=(pi / 4, -pi / 4), Phi=0.0)
    >>> round(pair.stiffness, 12) == round(1.0 - 0.75 * 0.01 / 1.01, 12)
    True

    References
    ----------
    Stiffness of the blades condensed on the rotation, the centre unloaded; Przemieniecki (1968),
    Theory of Matrix Structural Analysis, section 5.6.

    """
    along = 12.0 / slender**2
    across = 12.0 / (1.0 + Phi)
    e = np.array([[cos(a), sin(a)] for a in angles])
    n = np.array([[-sin(a), cos(a)] for a in angles])
    lever = gamma / 2.0  # of the blade's middle about the centre, in lengths of a blade
    K = along * e.T @ e + across * n.T @ n
    shift = -np.linalg.solve(K, across * lever * n.sum(axis=0))
    force = across * (lever + n @ shift)
    pull = along * e @ shift
    count = len(angles)
    stiffness = (count + lever * force.sum()) / (count * (1.0 + 3.0 * gamma**2))
    bending = 1.0 + np.abs(force) / 2.0
    stress = bending + np.abs(pull) * slender / 6.0
    most = 1.0 + 3.0 * abs(gamma)
    return AtRest(float(stiffness), float(bending.max() / most), float(stress.max() / most))


CARDS = (
    Card(
        "blades-at-rest",
        at_rest,
        {"slender": 0.05, "gamma": 1.2, "angles": (0.0, 2.0, 4.0), "Phi": 0.008},
    ),
)
