"""Stress along every blade at both faces, by bending alone and with the axial force."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas import fillet, notch
from flexcli.formulas.profile import Filleted, Notch, Piece
from flexcli.mechanics.layout import Blade
from flexcli.mechanics.mesh import Segment, column, pick
from flexcli.mechanics.section_forces import flexible_pieces, section_forces
from flexcli.mechanics.state import Equilibrium, Part

__all__ = [
    "BladeStress",
    "Peak",
    "beside_beam",
    "beside_beam_rows",
    "blade_stress",
    "greatest_stress",
]

Floats = NDArray[np.float64]

_POINTS = 33
"""Places on a piece; crowded towards its ends, where the largest stress mostly is."""

_ZOOMS = 6
"""Times that the neighbours of the largest sample are sampled again: to rounding."""

_SHARE = (np.sin(np.linspace(-np.pi / 2.0, np.pi / 2.0, _POINTS)) + 1.0) / 2.0


class BladeStress(NamedTuple):
    """Stress along one blade (designs, points) [Pa] at places s [m] from its start.

    ``bending`` is 6M/(b h²) with the sign of the moment, which is positive when it turns the end
    anticlockwise and then stretches the face on the right of the way from start to end; ``h`` are
    the thicknesses there [m].
    """

    s: Floats
    bending: Floats
    axial: Floats
    h: Floats

    @property
    def left(self) -> Floats:
        """Return the stress at the left face [Pa]."""
        return self.axial - self.bending

    @property
    def right(self) -> Floats:
        """Return the stress at the right face [Pa]."""
        return self.axial + self.bending

    @property
    def sheared(self) -> Floats:
        """Return the bending stress of the moment beyond the one in the middle place [Pa]."""
        middle = self.h.shape[-1] // 2, self.h.shape[-1] // 2 + 1
        there = self.bending[..., slice(*middle)] * self.h[..., slice(*middle)] ** 2
        return self.bending - there / self.h**2


class Peak(NamedTuple):
    """Greatest magnitudes in each blade (designs, blades) [Pa], and where [m from its start].

    ``bending`` is of the bending stress alone, ``total`` of the stress at either face.
    """

    bending: Floats
    bending_at: Floats
    total: Floats
    total_at: Floats


def blade_stress(
    state: Equilibrium,
    blade: str,
    points: int = _POINTS,
    *,
    places: Callable[[Piece], Floats] | None = None,
) -> BladeStress:
    """Return the stress along a blade, at places on each of its flexible pieces.

    ``σ = N/(b h) ± 6M/(b h²)``, elastic, each times the factor by which the blade's shape raises
    it (``Blade.peak``).

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.
    blade : str
        Name of the blade.
    points : int
        Places on each piece, its ends among them.
    places : callable, optional
        Function that gives the places of a piece instead, from −1 to 1, all designs alike.

    Returns
    -------
    BladeStress
        Place, bending stress, axial stress and thickness.

    """
    index = [b.name for b in state.layout.blades].index(blade)
    values, evenly = [], np.linspace(-1.0, 1.0, points)
    for part in state.parts:
        found = [
            _stress(state, part, index, segment, u[None])
            for segment in flexible_pieces(part, index)
            if segment.piece is not None
            for u in [evenly if places is None else places(segment.piece)]
        ]
        values.append(np.concatenate(found, axis=-1))
    return BladeStress(*np.moveaxis(state.scatter(values), 1, 0))


def beside_beam(blade: Blade, found: BladeStress) -> tuple[Floats, Floats] | None:
    """Return what no beam has of the bending stress of a hinge, and the error of that.

    Forces across the thickness stress the faces beside a throat more.

    Parameters
    ----------
    blade : Blade
        A blade; one that has no throat, or whose nominal stress is asked for, has nothing of that.
    found : BladeStress
        Its stress by bending and pull.

    Returns
    -------
    added, off : array, shape (designs, points)
        The stress with the sign of the bending, and how far it may be off either way [Pa].

    References
    ----------
    :func:`flexcli.formulas.notch.sheared_peak`, :func:`flexcli.formulas.fillet.sheared_peak`.

    """
    across = _sheared(blade)
    if across is None:
        return None
    if isinstance(blade.profile, Filleted):
        return _beside_fillets(found, across)
    sheared = found.sheared
    return across.more * sheared, across.off * np.abs(sheared)


def beside_beam_rows(
    blade: Blade, s: Floats, h: Floats, bending: Floats
) -> tuple[Floats, tuple[Floats, ...]]:
    """Return what no beam has of rows of the bending stress of a hinge, and what is unsure of it.

    Parameters
    ----------
    blade : Blade
        A blade, as in :func:`beside_beam`.
    s, h : array, shape (places,)
        Places from its start, and its thickness there [m].
    bending : array, shape (places, n)
        Rows of its bending stress.

    Returns
    -------
    added : array, shape (places, n)
        Rows with the sign of the bending.
    unsure : tuple of array, shape (places, n)
        Rows whose sizes, added up, it may be off by either way; none where nothing is added.

    """
    across = _sheared(blade)
    if across is None:
        return np.zeros_like(bending), ()
    more, off, reach = (float(np.ravel(each)[0]) for each in across)
    middle = float(blade.length) / 2.0
    after = int(np.searchsorted(s, middle))
    before = max(after - 1, 0)
    share = (middle - s[before]) / (s[after] - s[before]) if s[after] > s[before] else 0.0
    moment = bending * h[:, None] ** 2
    there = (1.0 - share) * moment[before] + share * moment[after]
    sheared = (moment - there) / h[:, None] ** 2
    if not isinstance(blade.profile, Filleted):
        return more * sheared, (off * sheared,)
    per_length = (moment[0] - there) / (s[0] - middle)
    return more * sheared, (off * sheared, reach * per_length / h[:, None] ** 2)


def _sheared(blade: Blade) -> fillet.Sheared | None:
    """Return what a force across a hinge makes of its stress, shares (designs, 1), if it has one.

    None of notches has a reach.
    """
    if np.all(np.asarray(blade.peak[0]) == 1.0):
        return None
    along = (end - start for start, end in zip(blade.start, blade.end, strict=True))
    l = column(np.hypot(*along))[:, None]
    match blade.profile:
        case Notch(e=e, depth=depth):
            more, off = notch.sheared_peak(e=e, rho=l**2 / (4.0 * depth), depth=depth)
            return fillet.Sheared(more, off, 0.0)
        case Filleted(h=h, r=r):
            return fillet.sheared_peak(h=h, l=l, r=r)
        case _:
            return None


def _beside_fillets(found: BladeStress, across: fillet.Sheared) -> tuple[Floats, Floats]:
    """Return what a force across a blade with fillets adds to its bending stress, and its error.

    By the smaller of two bounds: that both peaks are in one place, or that the peak of the moment
    all along is where the force adds what it reaches.
    """
    sheared = found.sheared
    added, size = across.more * sheared, np.abs(sheared)
    least = across.off * size
    apart = found.s[..., :1] - found.s[..., found.s.shape[-1] // 2][..., None]
    per_length = np.abs(sheared[..., :1] * found.h[..., :1] ** 2 / apart)
    peak = np.max((1.0 + across.more + across.off) * size, axis=-1, keepdims=True)
    together = np.maximum(peak - size - np.abs(added), least)
    reached = np.maximum(across.reach * per_length / found.h**2 - np.abs(added), least)
    whole = np.abs(found.bending + added)
    largest = [np.max(whole + off, axis=-1, keepdims=True) for off in (together, reached)]
    return added, np.where(largest[0] <= largest[1], together, reached)


def greatest_stress(state: Equilibrium) -> Peak:
    """Return the largest bending stress, and the largest stress at either face, of each blade.

    Sampled on each piece, then between the neighbours of the largest sample, again and again.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.

    Returns
    -------
    Peak
        Both maxima with their places.

    """
    values = []
    for part in state.parts:
        blades = range(part.assembly.blades)
        peaks = [_peak(state, part, blade, w) for w in (0.0, 1.0) for blade in blades]
        table = np.stack(peaks, axis=-1).reshape(part.rows.size, 2, 2, part.assembly.blades)
        values.append(np.swapaxes(table, 1, 2).reshape(part.rows.size, 4, -1))
    return Peak(*np.moveaxis(state.scatter(values), 1, 0))


def _stress(state: Equilibrium, part: Part, blade: int, segment: Segment, u: Floats) -> Floats:
    """Return place, bending stress, axial stress and thickness (designs, 4, points)."""
    at = section_forces(state, part, blade, segment, u)
    bends, pulls = (pick(column(k), part.rows)[:, None] for k in state.layout.blades[blade].peak)
    bending = bends * 6.0 * at.M / (at.b * at.h**2)
    return np.stack([at.s, bending, pulls * at.N / (at.b * at.h), at.h], axis=1)


def _peak(state: Equilibrium, part: Part, blade: int, axial_share: float) -> Floats:
    """Return the maximum of ``|bending| + axial_share |axial|`` and its place (designs, 2)."""
    designs = part.rows.size
    best, each = np.zeros((designs, 2)), np.arange(designs)
    for segment in flexible_pieces(part, blade):
        low, high = np.full(designs, -1.0), np.ones(designs)
        for _ in range(_ZOOMS):
            u = low[:, None] + (high - low)[:, None] * _SHARE
            s, bending, axial, _ = np.moveaxis(_stress(state, part, blade, segment, u), 1, 0)
            value = np.abs(bending) + axial_share * np.abs(axial)
            top = np.argmax(value, axis=1)
            better = value[each, top] > best[:, 0]
            best[better] = np.stack([value[each, top], s[each, top]], axis=-1)[better]
            low = u[each, np.maximum(top - 1, 0)]
            high = u[each, np.minimum(top + 1, _POINTS - 1)]
    return best
