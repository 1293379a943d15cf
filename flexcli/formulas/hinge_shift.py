"""Parasitic shift of a hinge: its bending is spread along it, not gathered in its middle."""

from math import radians

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import SMALL_ROTATION, Card, Range, Table
from flexcli.formulas.profile import Notch, Profile
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.numerics.quadrature import gauss_rule
from flexcli.results import QuantityKind

__all__ = ["BLADE_CARDS", "CARDS", "blade_shift", "circular_shift", "profile_shift"]

Floats = NDArray[np.float64]

_NODES = 64
"""Gauss nodes on a piece, as for the springs of a blade."""


def blade_shift(*, l: Quantity, theta: Quantity) -> Computed:
    """Return the shift of the middle of a blade that a moment turns.

    ``λ = θ² l/12``.

    Parameters
    ----------
    l : Quantity
        Length of the blade [m].
    theta : Quantity
        Rotation of its tip [rad].

    Returns
    -------
    shift : Quantity
        Shift of the moving body's point in the middle of the blade, along the blade and away from
        its base [m].

    Notes
    -----
    Leading order in θ, a moment alone: the blade is an arc. Across it, θ³ l/24 is left.

    Examples
    --------
    >>> round(12.0 * blade_shift(l=20e-3, theta=0.1) * 1e6, 9)
    200.0

    References
    ----------
    Arc of a circle: x = l sin θ/θ − (l/2) cos θ − l/2.

    """
    return l * (theta**2 / 12.0)


def profile_shift(profile: Profile, *, l: Quantity, theta: Quantity) -> Computed:
    """Return the shift of the middle of a hinge of any symmetric profile that a moment turns.

    ``λ = (θ²/2) ∫f (1 − f) ds``, f the share of the rotation up to s: ``∫₀ˢ h⁻³/∫₀ˡ h⁻³``.

    Parameters
    ----------
    profile : Profile
        Thickness along the hinge [m], flexible all along; its numbers have shape (designs, 1)
        where there are many designs.
    l : Quantity
        Length of the hinge [m].
    theta : Quantity
        Rotation [rad].

    Returns
    -------
    shift : Quantity
        Shift of the moving body's point in the middle of the hinge, along the hinge and away
        from its base [m].

    Notes
    -----
    Leading order in θ, a moment alone; across the hinge a shift of the order θ³ is left. A blade
    has f = s/l and θ² l/12, a throat of no length none.

    Examples
    --------
    >>> from flexcli.formulas.profile import Constant
    >>> round(float(12.0 * profile_shift(Constant(1e-4), l=1.0, theta=1.0)), 12)
    1.0

    References
    ----------
    Tip of a beam of slope φ(s) = θ f(s): x = −∫φ²/2 ds, seen from half its length behind the tip;
    Henein & Thalmann, lecture "Dimensioning of flexure joints", shift of the circular hinge.

    """
    nodes, weights = gauss_rule(_NODES)
    u = 2.0 * nodes - 1.0
    up_to = np.outer(2.0 * nodes, nodes).ravel() - 1.0
    before: Floats = np.zeros(1)
    turned, lengths = [], []
    for piece in profile.pieces(np.asarray(l, dtype=np.float64)[..., np.newaxis]):
        curved = piece.slope(up_to) * piece.thickness(up_to) ** -3.0
        within = curved.reshape(*curved.shape[:-1], _NODES, _NODES) @ weights * 2.0 * nodes
        turned.append(before + within)
        lengths.append(2.0 * weights * piece.slope(u))
        whole = lengths[-1] * piece.thickness(u) ** -3.0
        before = before + np.sum(whole, axis=-1, keepdims=True)
    share = np.concatenate(np.broadcast_arrays(*turned), axis=-1) / before
    ds = np.concatenate(np.broadcast_arrays(*lengths), axis=-1)
    spread = np.sum(ds * share * (1.0 - share), axis=-1)
    return spread * theta**2 / 2.0


def circular_shift(*, e: Quantity, r: Quantity, theta: Quantity) -> Computed:
    """Return the shift of the middle of a right-circular notch hinge that a moment turns.

    ``λ = (θ²/2) ∫f (1 − f) ds``, f the share of the rotation up to s: 0.155 √(e r) θ² where the
    throat is thin.

    Parameters
    ----------
    e, r : Quantity
        Thickness of the throat and radius of the notches [m]; numbers only.
    theta : Quantity
        Rotation [rad].

    Returns
    -------
    shift : Quantity
        Shift of the moving body's point in the throat, along the hinge and away from its base [m].

    Notes
    -----
    Leading order in θ, a moment alone; exact blades of this profile shift by 0.15 θ² of it less.

    Examples
    --------
    >>> shift = circular_shift(e=50e-6, r=3e-3, theta=radians(5.0))
    >>> f"{shift * 1e6:.3f} um"
    '0.453 um'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", parasitic shift of the hinge for a
    rotation of 5° (a chart; its curve is not in the text).

    """
    throat, radius = (np.asarray(x, dtype=np.float64)[..., np.newaxis] for x in (e, r))
    length = 2.0 * np.asarray(r, dtype=np.float64)
    return profile_shift(Notch(throat, radius), l=length, theta=theta)


BLADE_CARDS: tuple[Card, ...] = (
    Card(
        "blade-under-moment-shift",
        blade_shift,
        {"l": 20e-3, "theta": 0.1},
        (SMALL_ROTATION,),
        kind=QuantityKind.SHIFT,
    ),
)

CARDS: tuple[Card, ...] = (
    Card(
        "circular-notch-shift",
        circular_shift,
        {"e": 50e-6, "r": 3e-3, "theta": radians(5.0)},
        (Range("e/r", 0.0, 0.2, "thickness that changes gently"), SMALL_ROTATION),
        {
            "shift": Table(
                "e/r",
                (1e-4, 1e-3, 0.01, 0.025, 0.05, 0.1, 0.2),
                {
                    "shift/r at 5°": (
                        "",
                        lambda ratio: circular_shift(e=ratio, r=1.0, theta=radians(5.0)),
                    )
                },
                "along the hinge, away from its base",
            )
        },
        kind=QuantityKind.SHIFT,
    ),
)
