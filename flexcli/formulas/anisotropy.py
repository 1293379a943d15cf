"""Elastic constants of crystals and orthotropic sheets along any axes, from the rotated tensor."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "StripConstants",
    "cubic_stiffness",
    "in_plane_compliance",
    "orthotropic_stiffness",
    "plate_anisotropy",
    "sheared_in_plane",
    "stiffest",
    "strip_constants",
    "turned_stiffness",
]

Floats = NDArray[np.float64]

FIRST, SECOND = np.array([0, 1, 2, 1, 0, 0]), np.array([0, 1, 2, 2, 2, 1])
"""Voigt's order: 11, 22, 33, 23, 13, 12."""

VOIGT = np.array([[0, 5, 4], [5, 1, 3], [4, 3, 2]])
"""Where two axes stand in it."""


PLANE = np.array([0, 2, 4])
"""Where the plane of a strip's faces stands in it: 11, 33 and 13."""


class StripConstants(NamedTuple):
    """Elastic constants of a strip: 1 along it, 2 across its thickness, 3 across its width.

    ``E`` is Young's modulus along it [Pa], ``E_width`` that across its width; ``nu_width`` is how
    far the width shrinks as it is stretched, ``nu_length`` the other way round [-]; ``G_wide``
    is the shear modulus of its broad faces, plane 13, ``G_thin`` that of its narrow sides, plane
    12 [Pa]. ``twists`` and ``skews`` are by how much pulling it along or across its width shears
    the one and the other, ``S_15²/(S_11 S_55)`` and its like, and ``thins`` by how much it thins as
    it is pulled, ``S_12²/(S_11 S_22)`` [-]. Where its ends are kept from twisting it is bent as
    much as ``held`` more hardly, and then sheared by ``sheared_held`` of the stress along it [-].
    """

    E: float
    E_width: float
    nu_width: float
    nu_length: float
    G_wide: float
    G_thin: float
    twists: float
    skews: float
    thins: float
    held: float
    sheared_held: float

    @property
    def nu(self) -> float:
        """Return Poisson's ratio of the isotropic plate that is as stiff where it is very wide.

        ``E/(1 − ν_13 ν_31)``; negative where the width grows.
        """
        root = np.sqrt(abs(self.nu_width * self.nu_length))
        return float(np.copysign(root, self.nu_width))


def cubic_stiffness(c11: float, c12: float, c44: float) -> Floats:
    """Return the stiffness matrix (6, 6) of a cubic crystal along its axes, in Voigt's order [Pa].

    Raises
    ------
    ValueError
        When the crystal would not be stable: c11 > |c12|, c11 + 2 c12 > 0, c44 > 0.

    """
    if not (c11 > abs(c12) and c11 + 2.0 * c12 > 0.0 and c44 > 0.0):
        raise ValueError("no crystal has these constants: c11 > |c12|, c11 + 2 c12 > 0, c44 > 0")
    C = np.diag([c11] * 3 + [c44] * 3)
    C[:3, :3] += c12 * (1.0 - np.eye(3))
    return C


def orthotropic_stiffness(*, E_1: float, E_2: float, G_12: float, nu_12: float) -> Floats:
    """Return the stiffness matrix (6, 6) of an orthotropic sheet, 3 being its normal [Pa].

    Its properties through the thickness, which bending in its plane hardly asks for, are taken as
    those across: E_3 = E_2, ν_13 = ν_23 = ν_12, G_13 = G_23 = G_12.

    Raises
    ------
    ValueError
        When no solid has these constants.

    """
    S = np.zeros((6, 6))
    nu_23 = nu_12 * E_2 / E_1
    S[0, 0], S[1, 1], S[2, 2] = 1.0 / E_1, 1.0 / E_2, 1.0 / E_2
    S[0, 1] = S[1, 0] = S[0, 2] = S[2, 0] = -nu_12 / E_1
    S[1, 2] = S[2, 1] = -nu_23 / E_2
    S[3, 3] = S[4, 4] = S[5, 5] = 1.0 / G_12
    if float(np.linalg.eigvalsh(S)[0]) <= 0.0:
        raise ValueError("no solid has these constants: |ν_12| is below √(E_1/E_2)")
    return np.asarray(np.linalg.inv(S))


def stiffest(C: ArrayLike) -> float:
    """Return Young's modulus in the direction in which it is the largest [Pa].

    ``1/(S_ij m_i m_j)``, ``m = (n_1², n_2², n_3², n_2 n_3, n_1 n_3, n_1 n_2)``, over directions n.

    Parameters
    ----------
    C : array_like, shape (6, 6)
        Stiffness along axes of which each pair spans a plane of symmetry, in Voigt's order [Pa].

    Notes
    -----
    Directions are a degree apart, and so along edges and diagonals of a cube to a thousandth.

    Examples
    --------
    >>> round(stiffest(cubic_stiffness(165.7e9, 63.9e9, 79.6e9)) / 1e9)
    188

    References
    ----------
    Nye (1957), Physical Properties of Crystals, chapter 8.

    """
    S = np.linalg.inv(np.asarray(C, dtype=np.float64))
    polar, around = np.meshgrid(*2 * (np.radians(np.arange(91.0)),))
    x, y, z = np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)
    m = np.stack([x**2, y**2, z**2, y * z, x * z, x * y])
    return float(1.0 / np.einsum("iab,ij,jab->ab", m, S, m).min())


def strip_constants(C: ArrayLike, axes: ArrayLike) -> StripConstants:
    """Return the constants of a strip that is cut from a crystal or sheet along any axes.

    ``E = 1/S'_11``, ``G_13 = 1/S'_55``, ``ν_13 = −S'_13/S'_11`` with S' the inverse of
    ``turned_stiffness``.

    Parameters
    ----------
    C : array_like, shape (6, 6)
        Stiffness along the material's axes in Voigt's order [Pa].
    axes : array_like, shape (3, 3)
        Rows: the strip's length, thickness and width in the material's axes, orthonormal.

    Returns
    -------
    StripConstants
        Its engineering constants.

    Notes
    -----
    What couples bending with twist along axes that are none of symmetry (S_15 and its like) is in
    none of the others but ``held``: the larger of ``1/(1 − S_15²/(S_11 S_55)) − 1``, of a narrow
    strip that is kept from twisting, and of a wide one that is kept from curling too, over what a
    plate of ν_13 ν_31 has of it. A strip that may twist is as soft as its E says.

    Examples
    --------
    >>> C = cubic_stiffness(165.7e9, 63.9e9, 79.6e9)
    >>> r = 0.5**0.5
    >>> found = strip_constants(C, [[r, r, 0.0], [-r, r, 0.0], [0.0, 0.0, 1.0]])
    >>> round(found.E / 1e9, 1), round(found.nu_width, 3)
    (169.1, 0.362)

    References
    ----------
    Nye (1957), Physical Properties of Crystals, chapter 8; of silicon, Hopcroft, Nix & Kenny
    (2010), What is the Young's modulus of silicon?, doi:10.1109/JMEMS.2009.2039697.

    """
    S = np.linalg.inv(turned_stiffness(C, axes))
    E, E_width = 1.0 / S[0, 0], 1.0 / S[2, 2]

    def coupled(i: int, k: int) -> float:
        return float(S[i, k] ** 2 / (S[i, i] * S[k, k]))

    wide = np.linalg.inv(S[PLANE[:, None], PLANE])[0, 0] * S[0, 0]
    plate = 1.0 / (1.0 - coupled(0, 2))
    return StripConstants(
        E=float(E),
        E_width=float(E_width),
        nu_width=float(-S[0, 2] * E),
        nu_length=float(-S[0, 2] * E_width),
        G_wide=float(1.0 / S[4, 4]),
        G_thin=float(1.0 / S[5, 5]),
        twists=max(coupled(0, 4), coupled(2, 4)),
        skews=max(coupled(0, 5), coupled(2, 5)),
        thins=coupled(0, 1),
        held=max(1.0 / (1.0 - coupled(0, 4)), float(wide / plate)) - 1.0,
        sheared_held=float(abs(S[0, 4] / S[4, 4])),
    )


def turned_stiffness(C: ArrayLike, axes: ArrayLike) -> Floats:
    """Return the stiffness matrix (6, 6) along other axes, in Voigt's order [Pa].

    ``C'_ijkl = a_im a_jn a_ko a_lp C_mnop``.

    Parameters
    ----------
    C : array_like, shape (6, 6)
        Stiffness along the material's axes in Voigt's order [Pa].
    axes : array_like, shape (3, 3)
        Rows: the other axes in the material's, orthonormal.

    References
    ----------
    Nye (1957), Physical Properties of Crystals, chapter 8.

    """
    whole = np.asarray(C, dtype=np.float64)[VOIGT[:, :, None, None], VOIGT]
    a = np.asarray(axes, dtype=np.float64)
    turned = np.einsum("im,jn,ko,lp,mnop->ijkl", a, a, a, a, whole)
    found: Floats = turned[FIRST[:, None], SECOND[:, None], FIRST, SECOND]
    return found


def in_plane_compliance(C: ArrayLike, axes: ArrayLike) -> Floats:
    """Return the compliance (3, 3) of a strip in the plane of its faces [1/Pa].

    That of plane stress: rows and columns 11, 33 and 13 of the inverse of ``turned_stiffness``.

    Parameters
    ----------
    C, axes : array_like
        As of :func:`strip_constants`.

    References
    ----------
    Lekhnitskii (1968), Anisotropic Plates.

    """
    S = np.linalg.inv(turned_stiffness(C, axes))
    return np.asarray(S[PLANE[:, None], PLANE])


def sheared_in_plane(strip: StripConstants) -> tuple[float, float]:
    """Return what bending of a strip across its thickness is off that of an isotropic beam.

    ``|1.2 E/G_12 − 2.4 (1 + ν)|`` times (h/l)², as sections shear by a modulus of their own, and
    ``6 (0.075 S_12²/(S_11 S_22) + 0.3 S_16²/(S_11 S_66) √(E/G_12))`` times h/l, as clamps keep what
    is pulled from thinning and shearing.

    Parameters
    ----------
    strip : StripConstants
        Of a length l and a thickness h [m].

    Returns
    -------
    by_square, by_first : tuple of float
        Shares of the stiffness, over (h/l)² and over h/l [-].

    Notes
    -----
    The second is an upper bound for an S: each clamp shortens a strip by at most the part in
    brackets of its thickness, of sheets with E_1/E_2 up to 14 and E_1/G_12 up to 28, at any angle.

    References
    ----------
    Derived here: plane bodies of finite elements (degree 7), half a strip clamped at its end.

    """
    own = strip.E / strip.G_thin
    by_square = abs(1.2 * own - 2.4 * (1.0 + strip.nu))
    return by_square, 6.0 * (0.075 * strip.thins + 0.3 * strip.skews * float(np.sqrt(own)))


def plate_anisotropy(strip: StripConstants) -> float:
    """Return how far the plate of a strip is from an isotropic one [-].

    The largest of |κ − 1|, ``κ = (ν_31 D_1 + 2 G_13)/√(D_1 D_3)`` with D = E/(1 − ν_13 ν_31), and
    of |(E_1/E_3)^¼ − 1|, by which the width of an isotropic plate would be scaled.

    References
    ----------
    Lekhnitskii (1968), Anisotropic Plates: the two numbers on which the bending of an orthotropic
    plate depends, besides its stiffness.

    """
    shared = 1.0 - strip.nu_width * strip.nu_length
    D_1, D_3 = strip.E / shared, strip.E_width / shared
    kappa = (strip.nu_length * D_1 + 2.0 * strip.G_wide) / np.sqrt(D_1 * D_3)
    scaled = (strip.E / strip.E_width) ** 0.25
    return float(max(abs(kappa - 1.0), abs(scaled - 1.0)))
