"""Thickness of a blade along its length, cut into pieces on which it is smooth.

Every integral over a blade runs piece by piece over a variable u in [−1, 1] that is chosen so
that few Gauss nodes do: where a notch is sharp, its map crowds the nodes into its throat.
Parameters are floats, or arrays of many designs that broadcast against u on a trailing axis.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "Constant",
    "Edge",
    "Filleted",
    "NeckedDown",
    "Notch",
    "Piece",
    "Profile",
    "Tabulated",
    "per_design",
]

_PLACES = np.linspace(-1.0, 1.0, 41)
"""Where on a piece of a blade its thickness is looked at."""

Floats: TypeAlias = NDArray[np.float64]
Number: TypeAlias = Any
"""A float, or an array of shape (designs, 1)."""


def per_design(x: Any) -> Number:
    """Return a number of many designs, shape (designs,), as a profile takes it."""
    return x[:, None] if np.ndim(x) == 1 else x


class Piece(NamedTuple):
    """A smooth piece: position s(u) [m] from the blade's start, ds/du [m], thickness h(u) [m].

    ``is_uniform`` says that the last two are known to be the same at all u.
    """

    position: Callable[[Floats], Floats]
    slope: Callable[[Floats], Floats]
    thickness: Callable[[Floats], Floats]
    is_uniform: bool = False


class Edge(NamedTuple):
    """Part of a face: straight from a place to another, or a quarter of an ellipse about a centre.

    Places are (s, t) [m]: along the blade from its start, across it from the centre line. The
    half-axes of an ellipse lie along s and t.
    """

    start: tuple[float, float]
    end: tuple[float, float]
    centre: tuple[float, float] | None = None


_GAP = 1e-9
"""Share of the length by which a piece begins later than the one before it ends, if it is rigid
between them."""


class Profile(ABC):
    """A thickness profile, symmetric about the centre line of the blade."""

    def stretches(self, l: float) -> list[list[Piece]]:
        """Return the pieces of one blade in groups, between which it is rigid."""
        found: list[list[Piece]] = []
        last = -np.inf
        for piece in self.pieces(l):
            low, high = (float(s) for s in np.ravel(piece.position(np.array([-1.0, 1.0]))))
            if low > last + _GAP * l:
                found.append([])
            found[-1].append(piece)
            last = high
        return found

    def faces(self, l: float) -> tuple[tuple[Edge, ...], ...]:
        """Return the face on the left (t > 0) of each flexible stretch of one blade, exactly."""
        found: list[list[Edge]] = []
        ends, last = np.array([[-1.0, 1.0]]), -np.inf
        for piece, centre in zip(self.pieces(l), self._centres(l), strict=True):
            s_0, s_1 = (float(s) for s in np.ravel(piece.position(ends)))
            h_0, h_1 = (float(h) for h in np.broadcast_to(piece.thickness(ends), (1, 2))[0])
            if s_0 > last + _GAP * l:
                found.append([])
            if s_1 > s_0 + _GAP * l:
                found[-1].append(Edge((s_0, h_0 / 2.0), (s_1, h_1 / 2.0), centre))
            last = s_1
        return tuple(tuple(edges) for edges in found)

    def least_thickness(self, l: Number) -> Floats:
        """Return the least thickness of a blade of length l, or of each of many designs [m]."""
        each = [np.min(piece.thickness(_PLACES), axis=-1) for piece in self.pieces(l)]
        return np.asarray(np.min(each, axis=0))

    def mouth(self, l: float) -> float:
        """Return the thickness at the ends of one blade [m]."""
        return float(np.ravel(self.pieces(l)[-1].thickness(np.ones(1)))[0])

    def _centres(self, l: float) -> tuple[tuple[float, float] | None, ...]:
        """Return the centre of each piece's curve on the left, nothing where it is straight."""
        return (None,) * len(self.pieces(l))

    @abstractmethod
    def pieces(self, l: Number) -> tuple[Piece, ...]:
        """Return the flexible pieces of a blade of length l; what lies between them is rigid."""


@dataclass(frozen=True, eq=False)
class Constant(Profile):
    """The same thickness h [m] everywhere."""

    h: Number

    def pieces(self, l: Number) -> tuple[Piece, ...]:
        """Return the whole blade."""
        return (_straight(0.0, l, self.h, self.h),)


@dataclass(frozen=True, eq=False)
class NeckedDown(Profile):
    """Two hinges of thickness h [m] and length l_c [m] at the ends of a rigid middle."""

    h: Number
    hinge: Number

    def pieces(self, l: Number) -> tuple[Piece, ...]:
        """Return the two hinges."""
        first = _straight(0.0, self.hinge, self.h, self.h)
        return first, _straight(l - self.hinge, self.hinge, self.h, self.h)


class _Throat:
    """A quarter of an ellipse that leaves a throat: sine and thickness against u in [−1, 1].

    The place along the half-axis is sin φ of it, and with t = tan(φ/2) the thickness is
    e + 4 depth t²/(1 + t²), whose throat is √(e/(e + 4 depth)) wide: t = width · sinh(A v),
    v = (u + 1)/2, spreads it over the nodes.
    """

    def __init__(self, e: Number, depth: Number) -> None:
        self.e, self.depth = e, depth
        self.width = np.sqrt(e / (e + 4.0 * depth))
        self.stretch = np.arcsinh(1.0 / self.width)

    def _tangent(self, u: Floats) -> Floats:
        return np.asarray(self.width * np.sinh(self.stretch * (u + 1.0) / 2.0))

    def sine(self, u: Floats) -> Floats:
        """Return sin φ."""
        t = self._tangent(u)
        return np.asarray(2.0 * t / (1.0 + t**2))

    def sine_slope(self, u: Floats) -> Floats:
        """Return d(sin φ)/du."""
        t = self._tangent(u)
        growth = self.width * self.stretch / 2.0 * np.cosh(self.stretch * (u + 1.0) / 2.0)
        return np.asarray(2.0 * (1.0 - t**2) / (1.0 + t**2) ** 2 * growth)

    def thickness(self, u: Floats) -> Floats:
        """Return h(u) [m]."""
        t = self._tangent(u)
        return np.asarray(self.e + 4.0 * self.depth * t**2 / (1.0 + t**2))


@dataclass(frozen=True, eq=False)
class Notch(Profile):
    """Two opposite half-ellipses with a throat of thickness e [m].

    The half-axis along the blade is l/2, that across it ``depth`` [m]; a right-circular notch of
    radius r has l = 2r and depth r: ``h = e + 2 depth (1 − √(1 − (2s/l − 1)²))``.
    """

    e: Number
    depth: Number

    def pieces(self, l: Number) -> tuple[Piece, ...]:
        """Return the two sides of the throat."""
        curve = _Throat(self.e, self.depth)

        def half(side: float) -> Piece:
            return Piece(
                lambda u: np.asarray(l / 2.0 * (1.0 + side * curve.sine(side * u))),
                lambda u: np.asarray(l / 2.0 * curve.sine_slope(side * u)),
                lambda u: curve.thickness(side * u),
            )

        return half(-1.0), half(1.0)

    def _centres(self, l: float) -> tuple[tuple[float, float] | None, ...]:
        centre = l / 2.0, float(self.e) / 2.0 + float(self.depth)
        return centre, centre


@dataclass(frozen=True, eq=False)
class Filleted(Profile):
    """Constant thickness h [m] that ends in quarter circles of radius r [m] at both roots."""

    h: Number
    r: Number

    def pieces(self, l: Number) -> tuple[Piece, ...]:
        """Return fillet, straight middle and fillet; the nodes crowd where a fillet begins."""
        curve = _Throat(self.h, self.r)

        def fillet(side: float) -> Piece:
            start, reach = (self.r, -self.r) if side < 0.0 else (l - self.r, self.r)
            return Piece(
                lambda u: np.asarray(start + reach * curve.sine(side * u)),
                lambda u: np.asarray(self.r * curve.sine_slope(side * u)),
                lambda u: curve.thickness(side * u),
            )

        middle = _straight(self.r, l - 2.0 * self.r, self.h, self.h)
        return fillet(-1.0), middle, fillet(1.0)

    def _centres(self, l: float) -> tuple[tuple[float, float] | None, ...]:
        r, t = float(self.r), float(self.h) / 2.0 + float(self.r)
        return (r, t), None, (l - r, t)


@dataclass(frozen=True, eq=False)
class Tabulated(Profile):
    """Thicknesses [m] at fractions of the length from 0 to 1, straight lines between them."""

    fractions: tuple[float, ...]
    thicknesses: tuple[Number, ...]

    def pieces(self, l: Number) -> tuple[Piece, ...]:
        """Return a piece between each two entries."""
        ends = list(zip(self.fractions, self.thicknesses, strict=True))
        return tuple(
            _straight(s_0 * l, (s_1 - s_0) * l, h_0, h_1)
            for (s_0, h_0), (s_1, h_1) in pairwise(ends)
        )


def _straight(start: Number, length: Number, h_0: Number, h_1: Number) -> Piece:
    def fraction(u: Floats) -> Floats:
        return np.asarray((u + 1.0) / 2.0)

    return Piece(
        lambda u: np.asarray(start + length * fraction(u)),
        lambda u: np.asarray(length / 2.0 * np.ones_like(u)),
        lambda u: np.asarray(h_0 + (h_1 - h_0) * fraction(u)),
        is_uniform=h_0 is h_1,
    )
