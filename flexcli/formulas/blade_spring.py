"""A straight blade of any profile as six springs between its ends, in space.

Along the blade's own axes (x from start to end, y across the thickness, z across the width) the
blade is six independent springs at its elastic centres: stretch, shift across the thickness with
rotation about z, shift across the width with rotation about y, and torsion. For a profile that
is the same from either end both centres are at mid-length, and for a constant thickness the six
are known in closed form.
"""

from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.profile import Constant, NeckedDown, Profile
from flexcli.formulas.quantity import Computed, Numbers
from flexcli.formulas.restrained_torsion import restrained_stiffness
from flexcli.formulas.rigid_motion import motion_at
from flexcli.formulas.section import second_moment, shear_parameter
from flexcli.formulas.torsion_section import torsion_constant
from flexcli.numerics.quadrature import gauss_rule

__all__ = [
    "CARDS",
    "SHEAR_FACTOR",
    "BladeSprings",
    "MiddleStiffness",
    "Warping",
    "bending",
    "blade_springs",
    "deformation_rows",
    "middle_stiffness",
]


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

    across_thickness, turn_z, bent_y = bending(s, 12.0 * ds / (width * h**3))
    across_width, turn_y, bent_z = bending(s, 12.0 * ds / (width**3 * h))
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


def bending(s: Floats, flexibility: Floats) -> tuple[Floats, Floats, Floats]:
    """Return a beam's elastic centre, and there its turn per moment and its shift per force.

    ``s_c = ∫s f ds/∫f ds``, ``∫f ds`` and ``∫(s − s_c)² f ds``, from places s and the flexibility
    ``f ds`` of each, the last axis.
    """
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


def deformation_rows(springs: BladeSprings, point: ArrayLike) -> Floats:
    """Return the deformation of the six springs per motion of the body at the blade's end.

    Parameters
    ----------
    springs : BladeSprings
        The springs.
    point : array_like, shape (..., 3)
        Where the motion of the body is stated, from the blade's start along its axes [m].

    Returns
    -------
    B : array, shape (..., 6, 6)
        Deformation = B d; K = Bᵀ diag(k) B [-, m].

    Examples
    --------
    >>> at = BladeSprings(np.ones(6), np.array(0.5), np.array(0.5))
    >>> (deformation_rows(at, (1.0, 0.0, 0.0)) @ [0, 0, 0, 0, 0, 1.0]).tolist()
    [0.0, -0.5, 0.0, 0.0, 0.0, 1.0]

    """
    start = -np.asarray(point, dtype=np.float64)
    forward = np.array([1.0, 0.0, 0.0])
    rows = motion_at(start + springs.across_thickness[..., np.newaxis] * forward)
    width = motion_at(start + springs.across_width[..., np.newaxis] * forward)
    rows[..., 2, :] = width[..., 2, :]
    return rows


class MiddleStiffness(NamedTuple):
    """Stiffness of a blade between rigid bodies, both motions stated at its middle.

    x along the blade, y across its thickness, z across its width [N/m], and about them [N·m/rad].
    """

    x: Computed
    y: Computed
    z: Computed
    theta_x: Computed
    theta_y: Computed
    theta_z: Computed


def middle_stiffness(
    *, E: Numbers, G: Numbers, h: Numbers, l: Numbers, b: Numbers
) -> MiddleStiffness:
    """Return the six stiffnesses of a blade at its middle, where no two of them are coupled.

    ``k_x = E b h/l``, ``k_y = E b h³/(l³ (1 + Φ_h))``, ``k_z = E h b³/(l³ (1 + Φ_b))``,
    ``k_θx = G J/l``, ``k_θy = E h b³/(12 l)``, ``k_θz = E b h³/(12 l)``, with
    ``Φ_d = (6/5)(E/G)(d/l)²``.

    Parameters
    ----------
    E, G : Quantity
        Young's and shear modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width [m].

    Returns
    -------
    k_x, k_y, k_z : Quantity
        Along the blade, across its thickness, across its width [N/m].
    k_θx, k_θy, k_θz : Quantity
        Torsion, bending of the width, bending of the thickness [N·m/rad].

    Notes
    -----
    Small deformation, shear with κ = 5/6, free warping, section free to contract across: a blade
    wide against its length is stiffer about z by up to 1/(1 − ν²).

    Examples
    --------
    >>> k = middle_stiffness(E=120.0, G=48.0, h=0.1, l=1.0, b=0.3)
    >>> round(k.y, 6), round(k.z, 6)
    (0.034951, 0.255118)

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    nu = E / (2.0 * G) - 1.0
    sheared_h = 1.0 + shear_parameter(depth=h, l=l, poisson_ratio=nu)
    sheared_b = 1.0 + shear_parameter(depth=b, l=l, poisson_ratio=nu)
    bending_h, bending_b = E * second_moment(b, h), E * second_moment(h, b)
    return MiddleStiffness(
        x=E * b * h / l,
        y=12.0 * bending_h / l**3 / sheared_h,
        z=12.0 * bending_b / l**3 / sheared_b,
        theta_x=G * torsion_constant(h, b) / l,
        theta_y=bending_b / l,
        theta_z=bending_h / l,
    )


CARDS: tuple[Card, ...] = (
    Card(
        name="blade-support-stiffness",
        function=middle_stiffness,
        example={"E": 114e9, "G": 42.5e9, "h": 0.25e-3, "l": 30e-3, "b": 10e-3},
        validity=(
            Range("h/l", most=0.3, why="beam theory: thickness well below the length"),
            Range("b/l", most=1.0, why="beam theory with shear; a wider blade is a plate"),
        ),
    ),
)
