"""A straight blade of any profile as six springs between its ends, in space.

Along the blade's own axes (x from start to end, y across the thickness, z across the width) the
blade is six independent springs at its elastic centres: stretch, shift across the thickness with
rotation about z, shift across the width with rotation about y, and torsion. For a profile that
is the same from either end both centres are at mid-length.
"""

from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant, NeckedDown, Profile
from flexcli.formulas.restrained_torsion import restrained_stiffness
from flexcli.formulas.torsion_section import torsion_constant
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["SHEAR_FACTOR", "BladeSprings", "Warping", "blade_springs"]

Floats = NDArray[np.float64]
Number = Any
"""A float, or an array of shape (designs,)."""

Warping = Literal["free", "restrained"]

SHEAR_FACTOR = 5.0 / 6.0
"""Timoshenko's factor κ of a rectangle, from the energy of its parabolic shear stress."""

NODES = 64
"""Gauss nodes on a piece: all digits of a notch of any throat and of a taper of 1 to 30.

Tapers of 1 to 100, and fillets of a radius of 5000 throats, keep eight digits.
"""


class BladeSprings(NamedTuple):
    """Six springs of a blade, shape (..., 6), and where they are [m from its start].

    ``stiffness`` is that of x, y, z at the centres [N/m], then of θ_x, θ_y, θ_z [N·m/rad].
    ``across_thickness`` is the centre of bending about z, ``across_width`` that about y.
    """

    stiffness: Floats
    across_thickness: Floats
    across_width: Floats


def blade_springs(
    *,
    profile: Profile,
    l: Number,
    b: Number,
    E: Number,
    G: Number,
    shear_factor: float = SHEAR_FACTOR,
    warping: Warping = "free",
) -> BladeSprings:
    """Return a blade as six springs at its elastic centres.

    ``1/k_x = ∫ds/(E b h)``, ``1/k_θ = ∫ds/(EI)``, ``1/k_w = ∫(s − s_c)²/(EI) ds + ∫ds/(κ G b h)``
    with ``s_c = ∫s/(EI) ds / ∫ds/(EI)`` for either way of bending, ``1/k_θx = ∫ds/(G J)``.

    Parameters
    ----------
    profile : Profile
        Thickness h(s) along the blade [m]; for many designs its numbers have shape (designs, 1).
    l, b : float or array, shape (designs,)
        Length and width [m].
    E, G : float or array, shape (designs,)
        Young's and shear modulus [Pa].
    shear_factor : float
        κ of the section in shear, ∞ for Euler's blade without shear [-].
    warping : {"free", "restrained"}
        Whether the ends of the flexible pieces may warp in torsion.

    Returns
    -------
    BladeSprings
        Stiffness and centres; every entry is a sum of positive terms, so that no ratio of the
        dimensions costs digits.

    Notes
    -----
    Beam theory: small deformation, b and h below l/3 or so. A constant blade has
    k_y = 12EI/(l³(1 + Φ)) and k_θz = EI/l. Restrained warping is that of a thin strip.

    Raises
    ------
    ValueError
        When warping is to be restrained in a profile whose pieces are not of constant thickness.

    Examples
    --------
    >>> from flexcli.formulas.profile import Constant
    >>> at = blade_springs(profile=Constant(0.1), l=1.0, b=0.3, E=120.0, G=48.0)
    >>> [round(float(k), 6) for k in at.stiffness]
    [3.6, 0.034951, 0.255118, 0.003792, 0.027, 0.003]
    >>> float(at.across_thickness)
    0.5

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6, stated at the centre.

    """
    nodes, weights = gauss_rule(NODES)
    u = 2.0 * nodes - 1.0
    long, wide = _column(l), _column(b)
    sampled = []
    for piece in profile.pieces(long):
        at_nodes = piece.position(u), 2.0 * weights * piece.slope(u), piece.thickness(u), wide
        sampled.append(np.broadcast_arrays(*at_nodes, u)[:4])
    s, ds, h, width = (np.concatenate(part, axis=-1) for part in zip(*sampled, strict=True))

    across_thickness, turn_z, bent_y = _bending(s, 12.0 * ds / (width * h**3))
    across_width, turn_y, bent_z = _bending(s, 12.0 * ds / (width**3 * h))
    stretch = np.sum(ds / (width * h), axis=-1)
    sheared = stretch / (shear_factor * np.asarray(G))
    twist = (
        np.sum(ds / torsion_constant(h, width), axis=-1) / G
        if warping == "free"
        else _restrained_twist(profile, l=long, b=wide, E=_column(E), G=_column(G))
    )
    flexible = (
        stretch / E,
        bent_y / E + sheared,
        bent_z / E + sheared,
        twist,
        turn_y / E,
        turn_z / E,
    )
    stiffness = 1.0 / np.stack(np.broadcast_arrays(*flexible), axis=-1)
    return BladeSprings(stiffness, across_thickness, across_width)


def _column(value: Number) -> Floats:
    """Return a number of each design with a trailing axis for the nodes."""
    return np.asarray(value, dtype=np.float64)[..., np.newaxis]


def _bending(s: Floats, flexibility: Floats) -> tuple[Floats, Floats, Floats]:
    """Return the elastic centre, and there the turn per moment and the shift per force, times E."""
    turn = np.sum(flexibility, axis=-1)
    centre = np.sum(s * flexibility, axis=-1) / turn
    return centre, turn, np.sum((s - centre[..., np.newaxis]) ** 2 * flexibility, axis=-1)


def _restrained_twist(profile: Profile, *, l: Floats, b: Floats, E: Floats, G: Floats) -> Floats:
    """Return the twist per torque of strips in a row, each clamped at both its ends."""
    match profile:
        case Constant(h=h):
            strips, length = 1.0, l
        case NeckedDown(h=h, hinge=length):
            strips = 2.0
        case _:
            raise ValueError(
                "restrained warping needs flexible pieces of constant thickness between rigid "
                f"ends, which a profile {type(profile).__name__} has not"
            )
    return np.asarray(strips / restrained_stiffness(E=E, G=G, h=h, b=b, l=length)[..., 0])
