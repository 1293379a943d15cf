"""Stress at rigid clamps that keep a blade from growing across its width and its thickness."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card

__all__ = [
    "CARDS",
    "HELD_EDGES",
    "HELD_MIDDLE_ERROR",
    "HeldFace",
    "held_face",
    "held_middle",
    "held_together",
]

Floats = NDArray[np.float64]

HELD_MIDDLE_ERROR = 0.03
"""Relative error of ``held_middle`` amid clamps of blades of one thickness, b ≤ l [-]."""

HELD_EDGES = 0.32
"""Share by which the stress is larger than ``held_middle`` elsewhere on the clamp, at most [-].

That is as near as h/4 to the faces, and h/2 to the sides or b/40 if that is more: CalculiX's
solids had up to 0.312 there (b/h 1 to 60, b/l 0.1 to 4, ν 0 to 0.48; fillets of h/4 to 3 h, notches
with throats of 0.05 to 0.2 of the mouths), round bars 0.24 up to a fifth of their radius."""


class HeldFace(NamedTuple):
    """Stress of a blade at a face by the clamp that keeps it from growing, over E times a strain.

    ``across`` the blade it presses where the blade would grow more than its clamp, and ``along`` it
    pulls; where it would grow less, each has the other sign.
    """

    across: Floats
    along: Floats


def held_middle(*, poisson_ratio: ArrayLike) -> Floats:
    """Return von Mises' stress amid a rigid clamp that keeps a blade from growing [-].

    ``(1 + (1 − 2ν) s)/(1 − ν)``, ``s = 0.581 − 0.36 ν``: the clamp holds width and thickness by
    ``ε``, and the blade bears ``s E ε`` along itself there, which balances within its section.

    Parameters
    ----------
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        Over E times the difference of growth of blade and clamp [-].

    Notes
    -----
    A section in mid-width and mid-thickness, of a blade that is free to grow along itself. Within
    3 % of CalculiX's solids for b ≤ l, h ≤ b ≤ 10 h and ν ≤ 0.48; the stress of wider ones is less
    there, by up to 18 % (ν = 0, b = 4 l), and as large nearer to their sides. Towards the edges of
    the clamp it grows, at most by 32 % up to a quarter of the thickness from the faces and half of
    it (or b/40) from the sides; in the edges themselves it is singular. Of fillets at the roots it
    is up to 3 % more, of a round bar as much.

    Examples
    --------
    >>> round(float(held_middle(poisson_ratio=0.3)), 2)
    1.7

    References
    ----------
    Fitted here to CalculiX's C3D20R, an eighth of a blade between rigid clamps, graded to edges.

    """
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    s = 0.581 - 0.36 * nu
    return np.asarray((1.0 + (1.0 - 2.0 * nu) * s) / (1.0 - nu))


def held_face(*, poisson_ratio: ArrayLike) -> HeldFace:
    """Return the stress at a face, beside a rigid clamp that keeps a blade from growing across [-].

    ``σ_z = −(1 − 0.274 ν + 0.18 ν²) E ε``, ``σ_x = (0.292 − 0.28 ν + 0.133 ν²) E ε``.

    Parameters
    ----------
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    across, along : array
        Magnitudes of σ_z and σ_x, which differ in sign, over E times the difference of growth [-].

    Notes
    -----
    A strip in plane stress in mid-width of the clamp, where the thickness is free, as it is from
    some h off it on: within 0.002 for b ≤ l/2 and ν ≤ 0.45. Wider ones bear less along. Towards the
    sides shear adds: von Mises' stress beside bending that is the larger is that of 1.2 times both
    at most, but for b/40 or h/2 in their corners (solids, b/l 0.05 to 4).

    Examples
    --------
    >>> face = held_face(poisson_ratio=0.3)
    >>> round(float(face.across), 3), round(float(face.along), 3)
    (0.934, 0.22)

    References
    ----------
    Fitted here to CalculiX's C3D20R, a sheet with a clamp that holds its width.

    """
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    across = 1.0 - 0.274 * nu + 0.18 * nu**2
    return HeldFace(np.asarray(across), np.asarray(0.292 - 0.28 * nu + 0.133 * nu**2))


def held_together(*, along: ArrayLike, across: ArrayLike, held: ArrayLike) -> Floats:
    """Return von Mises' stress of one along a blade beside what its clamp holds there [Pa].

    ``√(σ² + X² + X Z + Z² + σ (2 X + Z))``, for the sign of σ that is the worse.

    Parameters
    ----------
    along : array_like
        Magnitude of the stress σ along the blade of stroke, loads and misfit [Pa].
    across, held : array_like
        Magnitudes of what the clamp holds across, Z, and along, X, of which the signs differ [Pa].

    Returns
    -------
    stress : array
        The equivalent stress [Pa].

    Notes
    -----
    Of a σ that is von Mises' stress itself, of bending whose clamp keeps it from narrowing too, no
    less than what is true.

    Examples
    --------
    >>> round(float(held_together(along=3e6, across=1e6, held=0.0)) / 1e6, 3)
    3.606

    References
    ----------
    von Mises (1913), Mechanik der festen Körper im plastisch-deformablen Zustand, in plane stress.

    """
    a, Z, X = (np.asarray(each, dtype=np.float64) for each in (along, across, held))
    return np.asarray(np.sqrt(a**2 + X**2 + X * Z + Z**2 + a * (2.0 * X + Z)))


_NU = {"poisson_ratio": 0.3}

CARDS = (
    Card("clamp-held-middle", held_middle, _NU),
    Card("clamp-held-face", held_face, _NU),
    Card("clamp-held-together", held_together, {"along": 100e6, "across": 20e6, "held": 5e6}),
)
