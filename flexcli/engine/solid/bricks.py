"""Quadratic bricks that fill a stretch of a blade: 20 nodes each, on a lattice graded to its ends.

The lattice has two steps an element in each direction: along the blade, across its thickness,
across its width. Nodes lie on the true profile, the middles of edges too.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, log

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Piece

__all__ = ["CORNERS", "Bricks", "bricks", "graded"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

FIRST = 0.25
"""Longest element at a clamp, in thicknesses there: by it a mesh and the next finer one differ by
a few parts in 10 000 in stiffness, though the stress at the clamp's edge grows without end."""

GROWTH = 4.0
"""Longest element over its neighbour."""

MIDDLE = 4
"""Elements at least along a straight stretch."""

CURVED = 6
"""Elements along each side of a curved throat, evenly in the variable that crowds them there."""

HALVES = np.array([-1.0, 0.0, 1.0])
"""Where they end across a rod."""

CONSTANT, VARIED = np.array([-1.0, 1.0]), np.array([-1.0, -0.6, 0.6, 1.0])
"""Where the coarsest elements end across the thickness, in halves of it: where it varies, a face
has a peak of stress that fades within."""

STEEP = 0.995
"""Share of a quarter of an ellipse that is meshed, where its face stands up on the body: no brick
fits in the corner beyond, which is rigid here."""

CORNERS = np.array(
    [
        *((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)),
        *((1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2)),
        *((0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)),
    ]
)
"""Steps from an element's first node to each of its nodes, in the order of C3D20R."""


@dataclass(frozen=True, eq=False)
class Bricks:
    """A stretch in its own frame: s along, t across the thickness (left positive), z [m].

    ``places`` (nodes, 3) are the nodes, ``elements`` (elements, 20) which of them; ``lattice``
    (2 n_s + 1, 2 n_t + 1, 2 n_z + 1) has the number of each node, −1 where there is none.
    ``is_half`` says that only z ≥ 0 is filled, as far as the middle plane is one of symmetry;
    ``stiff`` (elements,) which of them stand for what does not flex.
    """

    places: Floats
    elements: Integers
    lattice: Integers
    is_half: bool
    stiff: NDArray[np.bool_]

    def end(self, side: int) -> Integers:
        """Return the nodes of the first (0) or of the last (−1) cross-section."""
        return _existing(self.lattice[side])

    def middle(self) -> Integers:
        """Return the nodes on the plane of symmetry, but those of both ends."""
        return _existing(self.lattice[1:-1, :, 0]) if self.is_half else np.zeros(0, dtype=np.intp)

    def face(self, side: int) -> Integers:
        """Return the nodes (along, across the width) of the right (0) or left (−1) face."""
        return self.lattice[:, side]

    @property
    def stiff_shares(self) -> tuple[float, float]:
        """Return how much would give way in what does not flex, over the rest: bent, stretched.

        Of a blade bent to an S it is ∫ x²/h³ ds of the one over that of the other, x from the
        middle of the blade; of one that is stretched ∫ ds/h.
        """
        s, h = self.places[self.face(-1)[:, 0], 0], 2.0 * self.places[self.face(-1)[:, 0], 1]
        stretched = np.diff(s[::2]) / h[1::2]
        square = (s - (s[0] + s[-1]) / 2.0) ** 2
        bent = stretched / h[1::2] ** 2 * (square[:-2:2] + 4.0 * square[1::2] + square[2::2]) / 6.0
        stiff = self.stiff.reshape(bent.size, -1)[:, 0]
        of_bent, of_stretched = (
            float(each[stiff].sum() / each[~stiff].sum()) for each in (bent, stretched)
        )
        return of_bent, of_stretched

    @property
    def volume(self) -> float:
        """Return the volume that the flexible bricks fill, counted whole [m³]."""
        x, w = np.polynomial.legendre.leggauss(3)
        u = np.stack(np.meshgrid(x, x, x, indexing="ij"), axis=-1).reshape(-1, 3)
        weight = np.einsum("i,j,k->ijk", w, w, w).ravel()
        slopes = np.stack([_slopes(at) for at in u])
        jacobians = np.einsum("gnd,enk->egdk", slopes, self.places[self.elements[~self.stiff]])
        found = float(np.sum(np.linalg.det(jacobians) * weight))
        return 2.0 * found if self.is_half else found


def bricks(
    stretches: Sequence[Sequence[Piece]],
    b: float,
    *,
    fineness: int = 1,
    is_half: bool = False,
    is_round: bool = False,
) -> Bricks:
    """Return the bricks that fill the flexible stretches of a blade, and what is rigid between.

    Parameters
    ----------
    stretches : sequence of sequence of Piece
        Of one design; the pieces of a stretch each begin where the one before ends.
    b : float
        Width [m].
    fineness : int
        Each element of the coarsest mesh is cut into so many along, across and over the width.
    is_half : bool
        Fill one side of the middle plane only.
    is_round : bool
        The section is the ellipse in that rectangle: sides of the square are bent to its arcs.

    """
    s, h, rigid = _lattice_along(stretches, fineness)
    constant = HALVES if is_round else CONSTANT
    across = _steps(constant if np.allclose(h, h[0], rtol=1e-9) else VARIED, fineness)
    widths = _widths(b, float(h.min()))
    width = _steps(widths[widths >= 0.0] if is_half else widths, fineness)
    number = np.full((s.size, across.size, width.size), -1, dtype=np.intp)
    odd = sum(np.ix_(*(np.arange(n) % 2 for n in number.shape)))
    there = np.asarray(odd) <= 1
    number[there] = np.arange(int(there.sum()))
    i, j, k = np.nonzero(there)
    t, z = across[j], width[k]
    if is_round:
        t, z = t * np.sqrt(1.0 - z**2 / 2.0), z * np.sqrt(1.0 - t**2 / 2.0)
    places = np.stack([s[i], t * h[i] / 2.0, z * b / 2.0], axis=-1)
    first = np.stack(
        np.meshgrid(*(np.arange(0, n - 1, 2) for n in number.shape), indexing="ij"), axis=-1
    ).reshape(-1, 1, 3)
    at = first + CORNERS
    stiff = np.repeat(rigid, at.shape[0] // rigid.size)
    return Bricks(places, number[at[..., 0], at[..., 1], at[..., 2]], number, is_half, stiff)


def graded(l: float, first: float) -> Floats:
    """Return where elements end along a length, equal in its middle, short at both its ends.

    Parameters
    ----------
    l : float
        Length [m].
    first : float
        Longest element at an end [m].

    """
    widest = l / MIDDLE
    steps = max(0, ceil(log(widest / first, GROWTH))) if first < widest else 0
    growing = widest * GROWTH ** -np.arange(steps, 0, -1.0)
    left = l - 2.0 * float(growing.sum())
    inner = max(1, ceil(left / widest - 1e-9))
    sizes = np.concatenate([growing, np.full(inner, left / inner), growing[::-1]])
    return np.concatenate([[0.0], np.cumsum(sizes)]) * (l / float(sizes.sum()))


def _lattice_along(
    stretches: Sequence[Sequence[Piece]], fineness: int
) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """Return place and thickness at each step along the blade, and which elements are rigid."""
    s, h = _stations(stretches[0], fineness)
    rigid = [np.zeros(s.size // 2, dtype=bool)]
    for pieces in stretches[1:]:
        after, thick = _stations(pieces, fineness)
        l = float(after[0] - s[-1])
        between = _steps(graded(l, FIRST * float(max(h[-1], thick[0]))) / l, fineness)
        s, h = (
            np.concatenate([own, own[-1] + between[1:-1] * (new[0] - own[-1]), new])
            for own, new in ((s, after), (h, thick))
        )
        rigid += [np.ones(between.size // 2, dtype=bool), np.zeros(after.size // 2, dtype=bool)]
    return s, h, np.concatenate(rigid)


def _stations(pieces: Sequence[Piece], fineness: int) -> tuple[Floats, Floats]:
    """Return place along the blade and thickness at each step of the lattice."""
    s: list[Floats] = []
    h: list[Floats] = []
    for piece in pieces:
        u = _steps(_cuts(piece), fineness)
        at = np.broadcast_to(piece.position(u[None, :]), (1, u.size))[0]
        thick = np.broadcast_to(piece.thickness(u[None, :]), (1, u.size))[0]
        from_ = 1 if s else 0
        s.append(at[from_:])
        h.append(thick[from_:])
    return np.concatenate(s), np.concatenate(h)


def _cuts(piece: Piece) -> Floats:
    """Return u where the coarsest elements of a piece end."""
    ends = np.array([[-1.0, 0.0, 1.0]])
    s = np.ravel(piece.position(ends))
    h = np.broadcast_to(piece.thickness(ends), (1, 3))[0]
    l = float(s[2] - s[0])
    if np.allclose(h, h[0], rtol=1e-9) or abs(s[1] - (s[0] + s[2]) / 2.0) < 1e-9 * l:
        # straight: u is the fraction of the length
        return 2.0 * graded(l, FIRST * float(h.max())) / l - 1.0
    u = np.linspace(-1.0, 1.0, CURVED + 1)
    fine = np.linspace(-1.0, 1.0, 20001)
    share = np.abs(np.ravel(piece.position(fine[None, :])) - (s[0] if h[0] < h[2] else s[2])) / l
    reached = fine[share <= STEEP]
    low, high = float(reached[0]), float(reached[-1])
    return low + (u + 1.0) / 2.0 * (high - low)


def _widths(b: float, h: float) -> Floats:
    """Return where the coarsest elements end across the width, in halves of it."""
    if b <= 2.0 * h:
        return np.array([-1.0, 0.0, 1.0])
    edge = 1.0 - 2.0 * max(min(h / b, 0.25), 0.08)
    return np.array([-1.0, -edge, 0.0, edge, 1.0])


def _steps(cuts: Floats, fineness: int) -> Floats:
    """Return both ends of every element, cut so finely, and the middle between them."""
    shares = np.arange(2 * fineness) / (2.0 * fineness)
    inner = cuts[:-1, None] + shares * np.diff(cuts)[:, None]
    return np.append(inner.ravel(), cuts[-1])


def _existing(numbers: Integers) -> Integers:
    """Return the nodes of a part of the lattice; faces and bricks have none in their middle."""
    return numbers[numbers >= 0]


def _slopes(at: Floats) -> Floats:
    """Return the slopes (20, 3) of the shape functions at a place in [−1, 1]³."""
    own = CORNERS - 1.0
    x = 1.0 + own * at
    found = np.empty((20, 3))
    for d in range(3):
        p, q = (d + 1) % 3, (d + 2) % 3
        corner = own[:8]
        total = corner @ at - 2.0
        found[:8, d] = corner[:, d] * x[:8, p] * x[:8, q] * (total + x[:8, d]) / 8.0
        for n in range(8, 20):
            if own[n, d] == 0.0:
                found[n, d] = -2.0 * at[d] * x[n, p] * x[n, q] / 4.0
            else:
                other = p if own[n, p] == 0.0 else q
                rest = q if other == p else p
                found[n, d] = own[n, d] * (1.0 - at[other] ** 2) * x[n, rest] / 4.0
    return found
