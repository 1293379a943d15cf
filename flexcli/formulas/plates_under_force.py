"""Bending of a wide blade between rigid clamps that a force pulls or pushes along itself.

A pulled blade bends near its clamps alone, which keep it flat there: it widens as a wider one does
at rest. Against a beam under the same force n = N l²/(EI), each factor is of the beam's EI.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.beam_column import s_bending, uniform_bending
from flexcli.formulas.card import Card, Range
from flexcli.formulas.plate_factors import guided_factor, pure_bending_factor

__all__ = ["CARDS", "FORCE_ERROR", "arc_under_force", "s_under_force", "under_force"]

Floats = NDArray[np.float64]

FORCE_ERROR = 0.12
"""Largest error of both factors, n ≥ −9.5, as a share of k − 1 [-]."""

_SERIES = 1e-3
"""|n| below which the first terms are more exact than the quotient."""

_CLAMPED = -30.0
"""n near −4π², where the stability functions end."""

_FULL = 5.0
"""|n| from which on the error is a whole one: it begins at none."""

_BUCKLES = -9.5
"""n below which the range reaches from a beam to the plate at rest, near −π²."""


def arc_under_force(
    *, b: ArrayLike, l: ArrayLike, n: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the stiffness EI of a pulled blade whose ends turn oppositely over the beam's.

    ``k(s b)`` of pure bending at rest; s between κ²/(mean of κ²) at the ends, where a narrow blade
    is held, and ``√(1 + 0.21 n (n + 11)/(n + 39))`` of a wide one
    (``√(1 + n/20)`` in compression).

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    n : array_like
        N l²/(EI), positive in tension [-].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        From 1 (narrow) to 1/(1 − ν²) (wide, or pulled) [-].

    Notes
    -----
    −9.5 ≤ n ≤ 2000. Within 12 % of k − 1 of thin plates solved by Ritz's method, ν ≤ ½. Below, near
    −π² of a blade on pins, anything from 1 to the factor at rest.

    Examples
    --------
    >>> blade = {"b": 0.22, "l": 1.0, "poisson_ratio": 0.45}
    >>> [round(float(arc_under_force(n=n, **blade)), 2) for n in (0.0, 58.0)]
    [1.04, 1.13]

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate under an axial force, two sides clamped.

    """
    return pure_bending_factor(b=_widths(b, l, n)[0], l=l, poisson_ratio=poisson_ratio, h=h)


def s_under_force(
    *, b: ArrayLike, l: ArrayLike, n: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the stiffness EI of a pulled blade bent to an S over the beam's.

    ``k(s b)`` of the S at rest; s between a third of κ²/(mean of κ²) at the ends, of a narrow
    blade, and ``√(1 + n/24)`` of a wide one (n/48 in compression).

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    n : array_like
        N l²/(EI), positive in tension [-].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        From 1 (narrow) to 1/(1 − ν²) (wide, or pulled) [-].

    Notes
    -----
    −9.5 ≤ n ≤ 2000. Within 12 % of k − 1 of thin plates solved by Ritz's method, ν ≤ ½.

    Examples
    --------
    >>> blade = {"b": 0.22, "l": 1.0, "poisson_ratio": 0.45}
    >>> [round(float(s_under_force(n=n, **blade)), 2) for n in (0.0, 58.0)]
    [1.09, 1.15]

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate under an axial force, two sides clamped.

    """
    return guided_factor(b=_widths(b, l, n)[1], l=l, poisson_ratio=poisson_ratio, h=h)


def under_force(
    *,
    first: ArrayLike,
    last: ArrayLike,
    mean: ArrayLike,
    n: ArrayLike,
    b: ArrayLike,
    l: ArrayLike,
    poisson_ratio: ArrayLike,
    h: ArrayLike = 0.0,
    grows: bool = True,
) -> tuple[Floats, Floats]:
    """Return how a force changes the factor that a plate's end moments have over the beam's.

    The plate and the beam have the same end motions, and the beam bears n. Over what they have at
    rest, in the same shape: 1 at n = 0, where the factor is that of plates at rest.

    Parameters
    ----------
    first, last, mean : array_like
        Bending moment of the beam at its start and end, and its mean along it, in any unit; of
        constant curvature all are alike.
    n : array_like
        N l²/(EI) of the beam, positive in tension [-].
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].
    grows : bool
        Whether the force may come from other blades that bend, and be as much larger as these are
        stiffer. Else it is that of the beam: of a load, or of a stretch.

    Returns
    -------
    low, high : array
        Range of the factor at the end where the moment is larger [-].

    Notes
    -----
    Small end motions along and across the line of the blade; from 0 to infinity below n = −30, near
    −4π² where a beam whose ends are clamped buckles, but for ν = 0, where both are one.

    Examples
    --------
    >>> blade = {"b": 0.22, "l": 1.0, "poisson_ratio": 0.45}
    >>> [round(float(x), 2) for x in under_force(first=1, last=1, mean=0.26, n=58.0, **blade)]
    [1.02, 1.11]

    References
    ----------
    Derived here, from the factors of both shapes and stability functions.

    """
    one, other, turned, pull = (np.asarray(x, dtype=np.float64) for x in (first, last, mean, n))
    at = {"b": b, "l": l, "poisson_ratio": poisson_ratio, "h": h}
    even, odd = (one + other) / 2.0, (other - one) / 2.0
    rest = pure_bending_factor(**at), guided_factor(**at)
    arc_width, s_width = _widths(b, l, pull)
    found = pure_bending_factor(**at | {"b": arc_width}), guided_factor(**at | {"b": s_width})
    clamped = np.maximum(pull, _CLAMPED)
    # the same turns of the ends, and the same motion across, bend the blade at rest by these
    moved = odd / s_bending(clamped)
    sizes = np.abs(turned) + np.abs(moved)
    at_rest = np.abs(turned) * rest[0] + np.abs(moved) * rest[1]
    beam = np.maximum(np.abs(one), np.abs(other)) * at_rest / np.where(sizes, sizes, 1.0)
    each = []
    for away in (-1.0, 1.0):
        k_arc, k_s = (_astray(k, k_rest, pull, away) for k, k_rest in zip(found, rest, strict=True))
        arc, s = (
            k * q(np.maximum(pull / k, _CLAMPED)) - q(clamped)
            for k, q in ((k_arc, uniform_bending), (k_s, s_bending))
        )
        each.append((even + turned * arc, odd + moved * s))
        if grows:
            each.append((even * k_arc, odd * k_s))
    plate = [np.maximum(np.abs(arc + s), np.abs(arc - s)) for arc, s in each]
    # without Poisson's ratio plates are beams, whatever they bear
    bent, buckles = beam > 0.0, (pull <= _CLAMPED) & (np.asarray(poisson_ratio) > 0.0)
    low, high = (
        np.where(bent, extreme.reduce(plate) / np.where(bent, beam, 1.0), 1.0)
        for extreme in (np.minimum, np.maximum)
    )
    return np.where(buckles, 0.0, low), np.where(buckles, np.inf, high)


def _widths(b: ArrayLike, l: ArrayLike, n: ArrayLike) -> tuple[Floats, Floats]:
    """Return how wide blades at rest are that are kept as flat, bent to an arc and to an S [m].

    Between those of narrow blades, whose sides curl all along, and of wide ones.
    """
    pull, width = np.maximum(np.asarray(n, dtype=np.float64), _CLAMPED), np.asarray(b)
    x = width / np.asarray(l, dtype=np.float64)
    arc, s = _crowded(pull)
    pushed, drawn = pull < 0.0, np.maximum(pull, 0.0)
    wide_arc = np.where(
        pushed, 1.0 + pull / 20.0, 1.0 + 0.21 * drawn * (drawn + 11.0) / (drawn + 39.0)
    )
    wide_s = 1.0 + pull / np.where(pushed, 48.0, 24.0)
    narrow = np.where(pushed, np.exp(-5.0 * x**1.5), np.exp(-1.2 * x * (1.0 + arc)))
    wide_arc, wide_s = (np.sqrt(np.maximum(each, 0.1)) for each in (wide_arc, wide_s))
    return (
        np.asarray(width * (narrow * arc + (1.0 - narrow) * wide_arc)),
        np.asarray(width * (narrow * s + (1.0 - narrow) * wide_s)),
    )


def _crowded(n: Floats) -> tuple[Floats, Floats]:
    """Return the square of the curvature at the ends over its mean, of an arc, and of an S over 3.

    They are those of beams.
    """
    small = np.abs(n) < _SERIES
    z = np.sqrt(np.abs(np.where(small, 1.0, n))) / 2.0
    pulled = n > 0.0
    # over cosh² and sinh² at the ends, or over cos² and sin²
    tan = np.where(pulled, np.tanh(z), np.tan(z))
    edge = np.where(pulled, 1.0 - np.tanh(z) ** 2, 1.0 + np.tan(z) ** 2)
    arc, s = 0.5 * (edge + tan / z), 0.5 * np.abs(tan / z - edge) / tan**2
    return (
        np.where(small, 1.0 + n / 6.0, 1.0 / arc),
        np.where(small, 1.0 + n / 30.0, 1.0 / (3.0 * s)),
    )


def _astray(k: Floats, rest: Floats, n: Floats, away: float) -> Floats:
    """Return a factor at the lower or upper end of its range; there is no error at rest."""
    share = np.minimum(np.abs(n) / _FULL, 1.0)
    off = FORCE_ERROR * share * (k - 1.0)
    found = np.clip(k + away * off, 1.0, None)
    beyond = np.ones_like(k) if away < 0.0 else np.maximum(k, rest)
    return np.asarray(np.where(n < _BUCKLES, beyond, found))


_BLADE = {"b": 10e-3, "l": 20e-3, "n": 20.0, "poisson_ratio": 0.3, "h": 0.2e-3}
_WIDE = (
    Range("b/h", least=1.0, why="a plate is no thicker than wide"),
    Range("n", least=-9.5, most=2000.0, why="plates were compared from −9.5 to 2000"),
)

CARDS = (
    Card("plate-arc-under-force", arc_under_force, _BLADE, _WIDE),
    Card("plate-s-under-force", s_under_force, _BLADE, _WIDE),
)
