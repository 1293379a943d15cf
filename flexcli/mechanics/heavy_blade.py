"""One blade with its mass as a component: motions of its two ends, and modes of its inside.

Fixed-interface reduction (Craig & Bampton 1968): the ends carry the blade's exact static shapes,
the inside adds its lowest modes between fixed ends. Along the blade's own axes an end moves by
(u along, w across, φ anticlockwise).
"""

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.blade_spring import SHEAR_FACTOR
from flexcli.formulas.profile import Constant, Piece, Profile
from flexcli.mechanics.stress_places import stress_places
from flexcli.numerics.collocation import gauss_nodes
from flexcli.numerics.modes import natural_modes

__all__ = ["HeavyBlade", "heavy_blade"]

Floats = NDArray[np.float64]

ELEMENTS = 16
"""Elements of a blade with mass, shared by its pieces that are not short: of the sixth mode inside
0.1 %, of the first two 1e-5 (the error falls as the fourth power of element over wave)."""

MODES = 6
"""Modes of the inside that are kept: what lies above them follows statically."""

SHORT, NEGLIGIBLE = 0.05, 1e-3
"""Shares of the length up to which a piece is one element, and none at all: it is rigid then."""

_NODES, PARTS = 12, 8
"""Gauss nodes on an element, whose integrals are smooth; parts of a piece with as many each."""


class HeavyBlade(NamedTuple):
    """Matrices on (u, w, φ of the start, u, w, φ of the end, inside) and rows of what it feels.

    ``mass`` and ``stiffness`` are (6 + m, 6 + m); ``axial`` and ``bending`` [Pa], rows (places,
    6 + m), are the axial stress and the bending stress at one face along every flexible piece, at
    the places s [m] of :func:`flexcli.mechanics.stress_places.stress_places`, where it is h [m]
    thick; ``end_force`` (3, 6 + m) is the force (along, across) on the blade's end [N] with the
    moment about it [N·m].
    """

    mass: Floats
    stiffness: Floats
    axial: Floats
    bending: Floats
    end_force: Floats
    s: Floats
    h: Floats


class _Element(NamedTuple):
    """Between two places: stiffness, mass, and N and M at both ends per motion of its ends."""

    start: float
    end: float
    stiffness: Floats
    mass: Floats
    forces: Floats
    moments: Floats


def heavy_blade(
    profile: Profile,
    *,
    E: float,
    l: float,
    b: float,
    density: float = 0.0,
    G: float | None = None,
) -> HeavyBlade:
    """Return a blade as a component for small vibration in its plane.

    Parameters
    ----------
    profile : Profile
        Thickness along the blade, of one design.
    E : float
        Young's modulus [Pa].
    l, b : float
        Length and width [m].
    density : float
        Density [kg/m³]; 0 for a blade without mass, which has no modes inside.
    G : float, optional
        Shear modulus [Pa] of a thick blade, which shears and whose sections have rotary inertia.

    Returns
    -------
    HeavyBlade
        Matrices and rows.

    Notes
    -----
    Euler–Bernoulli with stretching, Timoshenko with ``G``. What is rigid between flexible pieces
    has no stated thickness and so no mass.

    References
    ----------
    Craig & Bampton (1968), AIAA Journal 6(7); Przemieniecki (1968), Theory of Matrix Structural
    Analysis, section 11.3 (consistent mass).

    """
    pieces = profile.pieces(l)
    slide = 1.0 / (SHEAR_FACTOR * G) if G else 0.0
    K = _end_stiffness(pieces, E=E, l=l, b=b, slide=slide)
    N, V, M = K[3:]  # what the blade's end feels
    places = [_places(piece) for piece in pieces]
    s, h = np.concatenate(places, axis=-1)
    stresses = _stresses(s, h, b, lambda at: (N, M + (l - at) * V))
    still = HeavyBlade(np.zeros((6, 6)), K, *stresses, K[3:], s, h)
    if not density:
        return still
    told = [
        (piece, share)
        for piece, (at, _) in zip(pieces, places, strict=True)
        if (share := float(at[-1] - at[0]) / l) > NEGLIGIBLE
    ]
    made = {"E": E, "b": b, "density": density, "slide": slide}
    return _with_inside(still, told, l, is_uniform=isinstance(profile, Constant), **made)


def _end_stiffness(
    pieces: Sequence[Piece], *, E: float, l: float, b: float, slide: float
) -> Floats:
    """Return the stiffness by the motions of both ends (6, 6): its flexibility added up.

    A short piece would take the digits from a sum of stiffnesses.
    """
    nodes, weights = gauss_nodes(_NODES)
    marks = np.linspace(-1.0, 1.0, PARTS + 1)
    u = ((marks[:-1] + marks[1:]) / 2.0 + nodes[:, None] / PARTS).ravel()
    du = np.repeat(weights / PARTS, PARTS)
    flexibility, along = np.zeros((2, 2)), 0.0
    for piece in pieces:
        added, longer = _flexibility(piece, u, du, l, E=E, b=b, slide=slide)
        flexibility += added
        along += longer
    stretch, bent = _deformed(l)
    held = bent.T @ np.linalg.inv(flexibility) @ bent
    return np.asarray(stretch.T @ stretch / along + held)


def _with_inside(
    still: HeavyBlade,
    told: Sequence[tuple[Piece, float]],
    l: float,
    *,
    is_uniform: bool,
    **made: float,
) -> HeavyBlade:
    """Return a blade with the mass and the modes of its inside.

    ``told`` are the pieces that bend it, and their shares of the length: one that is hardly there
    would take all digits of the stiffness beside it.
    """
    count = -(-ELEMENTS // max(1, sum(share > SHORT for _, share in told)))
    chains = [
        _elements(piece, count if share > SHORT else 1, is_uniform, **made) for piece, share in told
    ]
    elements = [element for chain in chains for element in chain]
    placed = _placed(elements, l)
    size = 3 * (len(elements) + 1)
    K, M = np.zeros((size, size)), np.zeros((size, size))
    for index, (element, T) in enumerate(zip(elements, placed, strict=True)):
        here = slice(3 * index, 3 * index + 6)
        K[here, here] += T.T @ element.stiffness @ T
        M[here, here] += T.T @ element.mass @ T
    static, modes = _reduction(K, M)
    reduction = np.hstack([static, modes])
    inside = [T @ modes[3 * index : 3 * index + 6] for index, T in enumerate(placed)]

    def felt(s: float) -> tuple[Floats, Floats]:
        index, share = _place(elements, s)
        first, last = elements[index].moments
        moment = (1.0 - share) * first + share * last
        return elements[index].forces[0] @ inside[index], moment @ inside[index]

    axial, bending = _stresses(still.s, still.h, made["b"], felt)
    last = np.vstack([elements[-1].forces, elements[-1].moments[-1]])
    of_modes = modes.shape[1]
    stiffness = np.zeros((6 + of_modes,) * 2)
    stiffness[:6, :6] = still.stiffness
    stiffness[6:, 6:] = _symmetric(modes.T @ K @ modes)
    return still._replace(
        mass=_symmetric(reduction.T @ M @ reduction),
        stiffness=stiffness,
        axial=np.hstack([still.axial, axial]),
        bending=np.hstack([still.bending, bending]),
        end_force=np.hstack([still.end_force, last @ inside[-1]]),
    )


def _places(piece: Piece) -> Floats:
    """Return places of a piece at which stress is looked at, and its thickness there (2, n) [m]."""
    at = stress_places(piece)
    s, h = (np.ravel(each(at)) for each in (piece.position, piece.thickness))
    return np.stack([s, np.broadcast_to(h, s.shape)])


def _stresses(
    s: Floats, h: Floats, b: float, felt: Callable[[float], tuple[Floats, Floats]]
) -> tuple[Floats, Floats]:
    """Return rows (places, n) of the axial and the bending stress by those of N and M."""
    N, M = (np.array(each) for each in zip(*map(felt, s.tolist()), strict=True))
    return N / (b * h)[:, None], 6.0 * M / (b * h**2)[:, None]


def _place(elements: Sequence[_Element], s: float) -> tuple[int, float]:
    """Return the element that is at a place, or nearest to it, and the share of its length."""
    nearest = min(
        range(len(elements)), key=lambda i: max(elements[i].start - s, s - elements[i].end)
    )
    element = elements[nearest]
    share = (s - element.start) / (element.end - element.start)
    return nearest, min(max(share, 0.0), 1.0)


def _elements(piece: Piece, count: int, is_uniform: bool, **made: float) -> tuple[_Element, ...]:
    """Return a piece in elements of equal share; those of a uniform one are alike."""
    marks = [float(u) for u in np.linspace(-1.0, 1.0, count + 1)]
    found = [
        _element(piece, u_1, u_2, **made)
        for u_1, u_2 in pairwise(marks[:2] if is_uniform else marks)
    ]
    if not is_uniform:
        return tuple(found)
    (first,), L = found, found[0].end - found[0].start
    return tuple(
        first._replace(start=first.start + i * L, end=first.start + (i + 1) * L)
        for i in range(count)
    )


def _element(
    piece: Piece, u_1: float, u_2: float, *, E: float, b: float, density: float, slide: float
) -> _Element:
    """Return the piece between two of its parameters: flexibility and mass by quadrature.

    ``slide`` is how far a section slides per shear force on its area [1/Pa], and nothing where
    the blade does not shear; then its sections have no inertia of their own either.
    """
    nodes, weights = gauss_nodes(_NODES)
    half = (u_2 - u_1) / 2.0
    u = (u_1 + u_2) / 2.0 + half * nodes
    ends = np.array([u_1, u_2])
    s_1, s_2 = (float(s) for s in np.ravel(piece.position(ends)))
    h = np.ravel(piece.thickness(u))
    ds = half * weights * np.ravel(piece.slope(u))
    L, s = s_2 - s_1, np.ravel(piece.position(u)) - s_1
    flexibility, along = _flexibility(piece, u, half * weights, s_2, E=E, b=b, slide=slide)
    stretch, bent = _deformed(L)
    end = np.linalg.inv(flexibility) @ bent  # force across and moment on the end
    x = s / L
    shape = np.stack(
        [
            1.0 - 3.0 * x**2 + 2.0 * x**3,
            L * (x - 2.0 * x**2 + x**3),
            3.0 * x**2 - 2.0 * x**3,
            L * (x**3 - x**2),
        ]
    )
    linear = np.stack([1.0 - x, x])
    dm = density * b * h * ds
    mass = np.zeros((6, 6))
    mass[np.ix_([0, 3], [0, 3])] = (linear * dm) @ linear.T
    mass[np.ix_([1, 2, 4, 5], [1, 2, 4, 5])] = (shape * dm) @ shape.T
    if slide:
        mass[np.ix_([2, 5], [2, 5])] += (linear * dm * h**2 / 12.0) @ linear.T
    return _Element(
        s_1,
        s_2,
        stretch.T @ stretch / along + bent.T @ end,
        mass,
        np.vstack([stretch / along, end[:1]]),
        np.vstack([end[1:] + L * end[:1], end[1:]]),
    )


def _flexibility(
    piece: Piece, u: Floats, du: Floats, end: float, *, E: float, b: float, slide: float
) -> tuple[Floats, float]:
    """Return how far an end is (shifted, turned) by a force across and a moment on it, and along.

    By what bends at the parameters u of a piece, with the weights du.
    """
    h = np.ravel(piece.thickness(u))
    ds = du * np.ravel(piece.slope(u))
    per_EI, rest = ds * 12.0 / (E * b * h**3), end - np.ravel(piece.position(u))
    mixed = np.sum(rest * per_EI)
    shifted = np.sum(rest**2 * per_EI) + slide * np.sum(ds / (b * h))
    return np.array([[shifted, mixed], [mixed, per_EI.sum()]]), float(np.sum(ds / (E * b * h)))


def _deformed(L: float) -> tuple[Floats, Floats]:
    """Return stretch, and shift across and turn of an end seen from the start, by their motions."""
    stretch = np.array([[-1.0, 0.0, 0.0, 1.0, 0.0, 0.0]])
    return stretch, np.array([[0.0, -1.0, -L, 0.0, 1.0, 0.0], [0.0, 0.0, -1.0, 0.0, 0.0, 1.0]])


def _placed(elements: Sequence[_Element], l: float) -> list[Floats]:
    """Return the motion of the ends of every element per motion of its two nodes (6, 6).

    Nodes are the start, one between each two elements and the end. A rigid part hangs on the
    node before it, the last one on the end.
    """
    found, at = [], 0.0  # the place of the node before
    for index, element in enumerate(elements):
        T = np.zeros((6, 6))
        T[:3, :3] = _rigid(element.start - at)
        at = l if index == len(elements) - 1 else element.end
        T[3:, 3:] = _rigid(element.end - at)
        found.append(T)
    return found


def _rigid(reach: float) -> Floats:
    """Return the motion of a place further along the blade than the node that carries it."""
    return np.array([[1.0, 0.0, 0.0], [0.0, 1.0, reach], [0.0, 0.0, 1.0]])


def _reduction(K: Floats, M: Floats) -> tuple[Floats, Floats]:
    """Return all coordinates per those of the ends, and per the modes of the inside."""
    every = np.arange(K.shape[0])
    ends, inside = np.concatenate([every[:3], every[-3:]]), every[3:-3]
    static = np.zeros((K.shape[0], 6))
    static[ends, np.arange(6)] = 1.0
    if not inside.size:
        return static, np.zeros((K.shape[0], 0))
    K_ii, M_ii = K[np.ix_(inside, inside)], M[np.ix_(inside, inside)]
    static[inside] = -np.linalg.solve(K_ii, K[np.ix_(inside, ends)])
    shapes = natural_modes(K_ii, M_ii).shapes[:, :MODES]
    modes = np.zeros((K.shape[0], shapes.shape[1]))
    modes[inside] = shapes
    return static, modes


def _symmetric(matrix: Floats) -> Floats:
    return np.asarray((matrix + matrix.T) / 2.0)
