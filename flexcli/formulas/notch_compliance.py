"""Planar compliance of a hinge of any thickness profile, by the integral of M/(EI)."""

from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.profile import Notch, Profile
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["CARDS", "Compliance", "bending_reach", "circular_compliance", "planar_compliance"]

Floats = NDArray[np.float64]

SHEAR_FACTOR = 1.2
"""1/κ of a rectangular section (parabolic shear stress)."""

_FEWEST_NODES, _MOST_NODES = 32, 512
_SETTLED = 1e-12
"""The number of nodes doubles until no integral changes by more than this share."""
_ROUNDING = 1e-14
"""Of places along the hinge over its length: what the bending next to a throat far thinner than
that cannot be known better by."""

_LOST = 1e-3
"""Share of the bending across a hinge that rounding may take before it is refused."""

_POSITIVE = [0, 1, 3]
"""The integrals that cannot vanish; the coupling may, and settles with those around it."""


class Compliance(NamedTuple):
    """Compliances of a symmetric hinge about its centre: two [m/N] and one [rad/(N·m)]."""

    along: Floats
    across: Floats
    turn: Floats


def planar_compliance(
    profile: Profile, *, E: Computed, l: Computed, b: Computed, a: Computed, G: Computed = inf
) -> Floats:
    """Return the compliance of a hinge in its plane about a point of its axis.

    ``C_xx = ∫ds/(E b h)``, ``C_yy = ∫(a − s)²/(E I) ds + 1.2 ∫ds/(G b h)``,
    ``C_yφ = ∫(a − s)/(E I) ds``, ``C_φφ = ∫ds/(E I)`` with ``I = b h³/12``.

    Parameters
    ----------
    profile : Profile
        Thickness along the hinge; for n designs its arrays have shape (n, 1).
    E, G : Quantity
        Young's and shear modulus [Pa]; an infinite G leaves shear out.
    l, b, a : Quantity
        Length, width and distance of the point from the hinge's start [m]; floats or (n,).

    Returns
    -------
    C : array, shape (..., 3, 3)
        Motion (x along, y across, φ) of the point, carried by the body at the hinge's end, per
        force and moment there [m/N, 1/N, rad/(N·m)].

    Notes
    -----
    Small deformation of a beam whose thickness changes gently; what the profile leaves out is
    rigid. Symmetric; C_yφ vanishes at the middle of a symmetric profile.

    Raises
    ------
    ArithmeticError
        When the integrals of a very sharp profile do not settle, or its throat is thinner than
        some 1e-21 of its length.

    Examples
    --------
    >>> from flexcli.formulas.profile import Constant
    >>> C = planar_compliance(Constant(1.0), E=12.0, l=1.0, b=1.0, a=1.0)
    >>> C[1:].round(6).tolist()
    [[0.0, 0.333333, 0.5], [0.0, 0.5, 1.0]]

    References
    ----------
    Paros & Weisbord (1965), Machine Design 37(27), 151–156; Timoshenko (1955), Strength of
    Materials, Part I (shear of a rectangular section).

    """
    length, point, ratio = (np.asarray(v, dtype=np.float64)[..., None] for v in (l, a, E / G))
    nodes = _FEWEST_NODES
    sums = _sums(profile, length, point, ratio, nodes)
    while nodes < _MOST_NODES:
        nodes, coarser = 2 * nodes, sums
        sums = _sums(profile, length, point, ratio, nodes)
        along, across, _, turn = sums
        rounding = _ROUNDING * np.stack([along, length[..., 0] * np.sqrt(turn * across), turn])
        change = np.abs(sums - coarser)[_POSITIVE]
        if (change <= _SETTLED * np.abs(sums[_POSITIVE]) + rounding).all():
            if (rounding[1] > _LOST * across).any():
                raise ArithmeticError("the throat is too thin for its place to be told")
            break
    else:
        raise ArithmeticError(f"the profile is too sharp for {_MOST_NODES} nodes to a piece")
    along, across, coupling, turn = sums / np.asarray(E * b)
    C = np.zeros((*along.shape, 3, 3))
    C[..., 0, 0], C[..., 1, 1], C[..., 2, 2] = along, across, turn
    C[..., 1, 2] = C[..., 2, 1] = coupling
    return C


def circular_compliance(
    *, E: Quantity, b: Quantity, e: Quantity, r: Quantity, G: Quantity = inf
) -> Compliance:
    """Return the compliances of a right-circular notch hinge in its plane about its centre.

    ``C_x = ∫ds/(E b h)``, ``C_y = ∫s²/(E I) ds + 1.2 ∫ds/(G b h)``, ``C_φ = ∫ds/(E I)`` over
    −r < s < r with ``h = e + 2r − 2√(r² − s²)``.

    Parameters
    ----------
    E, G : Quantity
        Young's and shear modulus [Pa]; an infinite G leaves shear out.
    b, e, r : Quantity
        Width, thickness of the throat and radius of the notches [m]; broadcast.

    Returns
    -------
    C_x, C_y : array
        Motion of the centre along and across the hinge per force there [m/N].
    C_phi : array
        Rotation per moment [rad/(N·m)]; by symmetry it turns about the centre.

    Notes
    -----
    Small rotation. Exact for a beam: as a plane body the hinge is softer in bending by about
    0.4 e/r, see ``notch.circular_stiffness``.

    Examples
    --------
    >>> hinge = circular_compliance(E=210e9, b=10e-3, e=100e-6, r=4e-3)
    >>> f"{1.0 / hinge.turn:.6f}"
    '0.235611'

    References
    ----------
    Paros & Weisbord (1965), Machine Design 37(27), 151–156; Henein & Thalmann, lecture
    "Dimensioning of flexure joints", « exact » formula of the circular notch hinge.

    """
    throat, radius = (np.asarray(v, dtype=np.float64)[..., None] for v in (e, r))
    C = planar_compliance(Notch(throat, radius), E=E, l=2.0 * r, b=b, a=r, G=G)
    return Compliance(C[..., 0, 0], C[..., 1, 1], C[..., 2, 2])


def bending_reach(*, across: Quantity, turn: Quantity) -> Computed:
    """Return how far from its centre a hinge bends, as the root of the mean square.

    ``c = √(C_y/C_φ)`` without shear: l/√12 for a constant thickness, about √(e r/3) for a
    circular notch.

    Parameters
    ----------
    across : Quantity
        Motion of the centre across the hinge per force there, by bending [m/N].
    turn : Quantity
        Rotation per moment [rad/(N·m)].

    Returns
    -------
    c : Quantity
        Reach [m].

    Notes
    -----
    With it a linkage of such hinges is as stiff as its integrals say, not only as pins and
    springs are: see ``hinged_stage`` and ``hinged_pivot``.

    Examples
    --------
    >>> hinge = circular_compliance(E=210e9, b=10e-3, e=100e-6, r=4e-3)
    >>> c = bending_reach(across=hinge.across, turn=hinge.turn)
    >>> f"{c * 1e6:.1f} {(100e-6 * 4e-3 / 3) ** 0.5 * 1e6:.1f}"
    '358.5 365.1'

    References
    ----------
    Radius of gyration of the elastic weight ds/(E I).

    """
    return (across / turn) ** 0.5


def _sums(profile: Profile, l: Floats, a: Floats, ratio: Floats, nodes: int) -> Floats:
    """Return E b times C_xx, C_yy, C_yφ and C_φφ, shape (4, ...)."""
    x, weights = gauss_rule(nodes)
    u = 2.0 * x - 1.0
    pieces = []
    for piece in profile.pieces(l):
        h = piece.thickness(u)
        stretch = 2.0 * weights * piece.slope(u) / h
        bend = 12.0 * stretch / h**2
        lever = a - piece.position(u)
        across = bend * lever**2 + SHEAR_FACTOR * ratio * stretch
        terms = np.broadcast_arrays(stretch, across, bend * lever, bend)
        pieces.append(np.stack([t.sum(axis=-1) for t in terms]))
    return np.asarray(sum(np.broadcast_arrays(*pieces)))


_HINGE = {"E": 210e9, "b": 10e-3, "e": 100e-6, "r": 4e-3}
_BEAM = Range("e/r", 0.0, 0.2, "as a plane body the hinge is softer, at e/r = 0.2 by 7 %")

CARDS: tuple[Card, ...] = (
    Card("circular-notch-compliance", circular_compliance, _HINGE, (_BEAM,)),
    Card("hinge-reach", bending_reach, {"across": 5.5e-7, "turn": 4.2}),
)
