"""Sums over many sources of a kernel that is smooth away from its target: a fast multipole method.

On a line cut into panels, halved level by level, the sources of a panel act on distant panels like
as many at its Chebyshev nodes; what arrives there is a polynomial, too. Only neighbours on the
finest level remain to be summed one by one.
"""

import functools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["NODES", "Panels", "node_shares", "panel_sums"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]
Kernel = Callable[[Floats], Floats]

NODES = 16
"""Nodes of a panel. A kernel with a pole three half-widths from a panel's middle, the least between
panels that are no neighbours, is interpolated to (3 + √8)^−16 = 6e-13 of itself."""


@dataclass(frozen=True, eq=False)
class Panels:
    """Equal panels on a line, the finest of levels that are halved from `roots` panels."""

    begin: float
    end: float
    roots: int
    halvings: int

    @property
    def count(self) -> int:
        """Number of the finest panels."""
        return self.roots << self.halvings

    @property
    def width(self) -> float:
        """Width of the finest panels."""
        return (self.end - self.begin) / self.count

    @property
    def edges(self) -> Floats:
        """Ends of the finest panels, shape (count + 1,)."""
        return np.linspace(self.begin, self.end, self.count + 1)

    def position(self, x: Floats, panel: Integers) -> Floats:
        """Return where points lie in their panel, from −1 to 1."""
        return 2.0 * ((x - self.begin) / self.width - panel) - 1.0


@functools.cache
def _chebyshev() -> tuple[Floats, Floats]:
    """Return Chebyshev nodes, and the polynomials T_k there as shares of a node, (node, k)."""
    angle = (np.arange(NODES) + 0.5) * np.pi / NODES
    shares = np.cos(np.outer(angle, np.arange(NODES))) * (2.0 / NODES)
    shares[:, 0] *= 0.5
    return np.cos(angle), shares


def node_shares(position: Floats) -> Floats:
    """Return the weights of a source at a position in [−1, 1] on the nodes, (…, NODES).

    The same weights interpolate: the value at the position is their sum over those at the nodes.
    """
    angle = np.arccos(np.clip(position, -1.0, 1.0))
    polynomials = np.cos(angle[..., None] * np.arange(NODES))
    shares: Floats = polynomials @ _chebyshev()[1].T
    return shares


@functools.cache
def _to_parent() -> tuple[Floats, Floats]:
    """Return the weights of each half's nodes on the nodes of the whole."""
    nodes = _chebyshev()[0]
    return node_shares(0.5 * (nodes - 1.0)), node_shares(0.5 * (nodes + 1.0))


def panel_sums(panels: Panels, sources: Floats, kernel: Kernel, *, near: bool) -> Floats:
    """Return the sum over the sources of all distant panels, at the nodes of the finest panels.

    Parameters
    ----------
    panels : Panels
        The finest panels; all targets and sources lie in them.
    sources : array, shape (count, NODES)
        Strength of the sources of each panel, shared among its nodes by `node_shares`.
    kernel : callable
        Effect of a unit source, of the distance source − target, smooth beyond a panel's width.
    near : bool
        Whether the kernel is smooth on the panels' own scale too, so that the sum takes in the
        panel itself and its two neighbours.

    Returns
    -------
    array, shape (count, NODES)
        To be interpolated by `node_shares`.

    References
    ----------
    Fong, Darve 2009, Journal of Computational Physics 228(23), 8712-8725.
    """
    lower, upper = _to_parent()
    levels = [sources]
    for _ in range(panels.halvings):
        pairs = levels[0].reshape(-1, 2, NODES)
        levels.insert(0, pairs[:, 0] @ lower + pairs[:, 1] @ upper)
    field = np.zeros_like(levels[0])
    for level, strength in enumerate(levels):
        count = strength.shape[0]
        if level:
            halves = np.empty_like(strength)
            halves[0::2], halves[1::2] = field @ lower.T, field @ upper.T
            field = halves
        width = (panels.end - panels.begin) / count
        for offset in _offsets(level, count, near=near and level == panels.halvings):
            _add(field, strength, kernel, width, offset, every=level == 0)
    return field


def _offsets(level: int, count: int, *, near: bool) -> list[int]:
    """Return the offsets of the panels summed at a level: those that its parents could not."""
    reach = count - 1 if level == 0 else 3
    least = 0 if near else 2
    return [offset for offset in range(-reach, reach + 1) if abs(offset) >= least]


def _add(
    field: Floats, strength: Floats, kernel: Kernel, width: float, offset: int, *, every: bool
) -> None:
    """Add to every panel the field of the one at an offset.

    Panels three apart are children of neighbours only for every second one.
    """
    nodes = _chebyshev()[0]
    effect = kernel(width * (offset + 0.5 * (nodes - nodes[:, None])))  # (target, source)
    first, last = max(0, -offset), min(strength.shape[0], strength.shape[0] - offset)
    step = 1
    if abs(offset) == 3 and not every:
        # an even panel's parent has its neighbour's children at −2, −1, 2 and 3, an odd one's at −3
        parity, step = (0, 2) if offset > 0 else (1, 2)
        first += (first - parity) % 2
    if first < last:
        targets = slice(first, last, step)
        field[targets] += strength[first + offset : last + offset : step] @ effect.T
