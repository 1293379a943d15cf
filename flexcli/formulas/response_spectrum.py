"""The vibration response spectrum: all frequencies at once, its maximum, Miles against it."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.miles import miles
from flexcli.formulas.oscillator import PANELS_AT_ONCE, oscillator_response, response_integrals
from flexcli.formulas.spectrum import Scale, checked_profile, segment_slopes, spectral_level
from flexcli.numerics.maximum import greatest
from flexcli.numerics.panel_sums import NODES, Panels, node_shares, panel_sums
from flexcli.numerics.quadrature import gauss_rule

__all__ = [
    "MilesShortfall",
    "ResponseMaximum",
    "ResponseSpectrum",
    "peak_ratio",
]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

# The response is an integral over f of G/|f − pole|², so as a function of f_n it is singular
# only at complex f_n some f_b/(2Q) off a breakpoint f_b: steps grow with the distance from one.
_NEAREST = 0.125
_GROWTH = 1.5
_WIDEST = np.log(2.0) / 8
_STEEPEST = 0.5

# Panels in ln f. The widest is below the distance π/2 of the poles that every |H|² has; on one of
# 0.4/Q the poles of the resonance, 1/(2Q) off, are 2.5 half-widths away: it is smooth there too,
# interpolated to (2.5 + √7.25)^−16 = 4e-12.
_WIDEST_PANEL = 1.2
_SMOOTH_PANEL = 0.4
_MOST_HALVINGS = 17
# A piece of a line on which the density changes by more than e^10 is cut: 16 Gauss points there
# are good for 1e-15.
_STEEPEST_PIECE = 10.0
_PIECES_AT_ONCE = 4096
# What a panel costs, beside a Gauss panel of a single oscillator.
_COST_OF_PANEL = 3.0


@dataclass(frozen=True)
class ResponseMaximum:
    """The greatest rms absolute acceleration [x] and its natural frequency [Hz]."""

    response: float
    frequency: float


@dataclass(frozen=True)
class MilesShortfall:
    """How far the exact response exceeds Miles at most: ratio − 1 [-], where [Hz]."""

    excess: float
    frequency: float


def peak_ratio(Q: float) -> float:
    """Give the frequency ratio at which the transmissibility of an oscillator is greatest.

    r_p² = Q² (√(1 + 2/Q²) − 1), the zero of d|H_a|²/dr.

    Parameters
    ----------
    Q : float
        Quality factor, [-].

    Returns
    -------
    float
        f/f_n, below 1, [-].

    Notes
    -----
    |H_a| rises with r up to r_p and falls from there. So, whatever the profile, an oscillator
    below its band moves more when it is made stiffer, and one above f_2/r_p moves less: the
    greatest response lies between f_1 and f_2/r_p.

    Examples
    --------
    >>> round(peak_ratio(0.5), 6), round(1.0 - peak_ratio(100.0), 7)
    (0.707107, 2.5e-05)
    """
    # √(1 + x) − 1 without the difference of two near numbers
    return float(np.sqrt(2.0 / (np.sqrt(1.0 + 2.0 / Q**2) + 1.0)))


def _graded(start: Floats, end: Floats, slope: Floats, Q: float) -> tuple[Floats, Integers]:
    """Points from one breakpoint to the next, dense (in ln f) at both as 1/Q asks; their segment.

    Both ends of every segment are among its points.
    """
    length = np.log1p((end - start) / start)
    nearest = _NEAREST / Q
    rungs = np.ceil(np.log(np.maximum(0.5 * length / nearest, 1.0)) / np.log(_GROWTH))
    on, rung = _counted(rungs)
    ladder = nearest * _GROWTH**rung
    shorter = ladder < 0.5 * length[on]
    on, ladder = on[shorter], ladder[shorter]
    even = np.maximum(2, np.ceil(length * np.maximum(1.0 / _WIDEST, np.abs(slope) / _STEEPEST)))
    along, step = _counted(even + 1)
    segment = np.concatenate([on, on, along])
    steps = np.concatenate([ladder, length[on] - ladder, length[along] * step / even[along]])
    points = start[segment] * np.exp(steps)
    first, last = step == 0, step == even[along]
    tail = slice(2 * on.size, None)
    points[tail] = np.where(first, start[along], np.where(last, end[along], points[tail]))
    order = np.lexsort((points, segment))
    points, segment = points[order], segment[order]
    inside = (points >= start[segment]) & (points <= end[segment])
    fresh = np.concatenate([[True], (np.diff(points) != 0.0) | (np.diff(segment) != 0)])
    return points[inside & fresh], segment[inside & fresh]


def _counted(counts: Floats) -> tuple[Integers, Integers]:
    """Return for each of several counts its index and 0, 1, …, count − 1, one after another."""
    whole = counts.astype(np.intp)
    index = np.repeat(np.arange(whole.size), whole)
    return index, np.arange(index.size) - np.repeat(np.cumsum(whole) - whole, whole)


@dataclass(frozen=True, eq=False)
class ResponseSpectrum:
    """The exact rms absolute acceleration of oscillators of one Q, over their natural frequency.

    In ln f the response is a sum of |H_a(f/f_n)|² over G df, smooth where f is not near f_n:
    what lies far off is summed by panels (`flexcli.numerics.panel_sums`), and the neighbourhood of
    the resonance by the graded panels of `oscillator_response`. The time grows like the number of
    breakpoints plus that of oscillators. The error is below 1e-10.

    Attributes
    ----------
    frequency, level : arrays, shape (n,)
        Base acceleration density of positive frequencies, [Hz] and [x²/Hz].
    Q : float
        Quality factor, at least 0.5, [-].
    scale : "log" or "linear"
        Axes in which the profile is straight.

    Examples
    --------
    >>> spectrum = ResponseSpectrum(np.array([20.0, 2000]), np.array([0.04, 0.04]), 10.0)
    >>> round(float(spectrum(np.array([200.0]))[0]), 3)
    11.23
    """

    frequency: Floats
    level: Floats
    Q: float
    scale: Scale = "log"

    def __post_init__(self) -> None:
        checked_profile(self.frequency, self.level, scale=self.scale)
        if not self.Q >= 0.5:
            raise ValueError(f"Q must be at least 0.5 (critical damping), got {self.Q:g}")

    @property
    def top(self) -> float:
        """Natural frequency above which the response falls [Hz]."""
        return float(self.frequency[-1]) / peak_ratio(self.Q)

    @cached_property
    def grid(self) -> tuple[Floats, Integers]:
        """Points of every segment of positive width, and the segment of each."""
        f, g = self.frequency, self.level
        slopes = segment_slopes(f, g) if self.scale == "log" else np.zeros(f.size - 1)
        segments = np.flatnonzero(np.diff(f) > 0)
        points, on = _graded(f[segments], f[segments + 1], slopes[segments], self.Q)
        return points, segments[on].astype(np.intp)

    @cached_property
    def _beyond(self) -> Floats:
        """Points from the band's edge to the frequency above which the response falls."""
        ends = np.array([self.frequency[-1], self.top])
        return _graded(ends[:1], ends[1:], np.zeros(1), self.Q)[0]

    @cached_property
    def _panels(self) -> Panels | None:
        """The panels that make the grid cheapest; none where all is summed one by one."""
        f, Q = self.frequency, self.Q
        begin, end = float(np.log(f[0])), float(np.log(self.top))
        roots = int(np.ceil((end - begin) / _WIDEST_PANEL))
        targets = np.log(self.grid[0])
        points = np.log(f)

        def rungs(width: float) -> float:
            return 2.0 + float(np.log2(1.0 + 2.0 * Q * width))

        least, best = targets.size * (points.size + rungs(end - begin)), None
        for halvings in range(_MOST_HALVINGS + 1):
            panels = Panels(begin, end, roots, halvings)
            cost = _COST_OF_PANEL * panels.count
            if cost > least:
                break
            smooth = panels.width <= _SMOOTH_PANEL / Q
            if not smooth:
                asked = np.histogram(targets, panels.edges)[0]
                lying = np.histogram(points, panels.edges)[0]
                near = np.convolve(lying, np.ones(3))[1:-1] + 3.0 + rungs(3.0 * panels.width)
                cost += float(asked @ near)
            if cost < least:
                least, best = cost, panels
            if smooth:
                break
        return best

    @cached_property
    def _smooth(self) -> bool:
        return self._panels is not None and self._panels.width <= _SMOOTH_PANEL / self.Q

    @cached_property
    def _edges(self) -> Floats:
        """Inner ends of the panels [Hz]."""
        assert self._panels is not None
        return np.exp(self._panels.edges[1:-1])

    @cached_property
    def _refined(self) -> tuple[Floats, Floats]:
        """The profile with breakpoints at the panels' ends, and where a line is too steep."""
        f, g = self.frequency, self.level
        edges = self._edges[(self._edges > f[0]) & (self._edges < f[-1])]
        cuts = [edges]
        if self.scale == "log":
            # what lies between two points of one line is no steeper than the line
            pieces = np.ceil(np.abs(np.log(g[1:] / g[:-1])) / _STEEPEST_PIECE) * (np.diff(f) > 0)
            on, piece = _counted(np.maximum(pieces - 1.0, 0.0))
            cuts.append(f[on] * (f[on + 1] / f[on]) ** ((piece + 1) / pieces[on]))
        inner = np.setdiff1d(np.concatenate(cuts), f)
        both = np.concatenate([f, inner])
        levels = np.concatenate([g, spectral_level(inner, f, g, scale=self.scale)])
        order = np.argsort(both, kind="stable")
        return both[order], levels[order]

    @cached_property
    def _field(self) -> Floats:
        """Mean square that the distant panels add, at the nodes of each panel."""
        panels = self._panels
        assert panels is not None
        f, g = self._refined
        sources = np.zeros((panels.count, NODES))
        x, w = gauss_rule(NODES)
        wide = np.flatnonzero(np.diff(f) > 0)
        for part in np.split(wide, range(_PIECES_AT_ONCE, wide.size, _PIECES_AT_ONCE)):
            start, low, high = f[part, None], g[part, None], g[part + 1, None]
            growth = np.diff(f)[part, None] / start
            span = np.log1p(growth)
            if self.scale == "log":
                density = low * (high / low) ** x
            else:
                density = low + (high - low) * np.expm1(x * span) / growth
            strength = density * start * np.exp(x * span) * span * w
            panel = np.searchsorted(self._edges, f[part], side="right")
            position = panels.position(np.log(start) + x * span, panel[:, None])
            np.add.at(sources, panel, np.einsum("pk,pkn->pn", strength, node_shares(position)))
        return panel_sums(panels, sources, self._transmitted, near=self._smooth)

    def _transmitted(self, y: Floats) -> Floats:
        """|H_a|² at y = ln r, with all digits also near the resonance."""
        square, loss = np.exp(2.0 * y), 1.0 / self.Q**2
        return (1.0 + square * loss) / (square * (4.0 * np.sinh(y) ** 2 + loss))

    def __call__(self, fn: Floats) -> Floats:
        """Return the rms absolute acceleration [x] of oscillators between f_1 and `top` [Hz]."""
        if not ((fn >= self.frequency[0]) & (fn <= self.top)).all():
            raise ValueError(f"f_n must lie from {self.frequency[0]:g} to {self.top:g} Hz")
        panels = self._panels
        if panels is None:
            f, g = self.frequency, self.level
            return oscillator_response(f, g, fn, self.Q, scale=self.scale).absolute_acceleration
        panel = np.searchsorted(self._edges, fn, side="right")
        square = np.empty(fn.size)
        for part in np.split(np.arange(fn.size), range(_PIECES_AT_ONCE, fn.size, _PIECES_AT_ONCE)):
            shares = node_shares(panels.position(np.log(fn[part]), panel[part]))
            square[part] = np.einsum("tn,tn->t", shares, self._field[panel[part]])
        if not self._smooth:
            for rows, mean_square in self._near(fn, panel):
                square[rows] += mean_square
        return np.sqrt(square)

    def _near(self, fn: Floats, panel: Integers) -> Iterator[tuple[Integers, Floats]]:
        """Yield mean squares that an oscillator's own panel and its neighbours add, by rows."""
        f, g = self._refined
        last = f.size - 1
        starts = np.concatenate([[0], np.searchsorted(f, self._edges, side="right") - 1])
        ends = np.concatenate([np.searchsorted(f, self._edges, side="left"), [last]])
        begin = starts[np.maximum(panel - 1, 0)]
        end = np.minimum(ends[np.minimum(panel + 1, ends.size - 1)], last)
        order = np.argsort(end - begin, kind="stable")
        done = 0
        while done < order.size:
            size = int((end - begin)[order[done]]) + 60
            rows = order[done : done + max(1, PANELS_AT_ONCE // size)]
            done += rows.size
            count = max(int((end - begin)[rows].max()), 1) + 1
            at = np.minimum(begin[rows, None] + np.arange(count), end[rows, None])
            Q = np.full(rows.size, self.Q)
            still, moving = response_integrals(f[at], g[at], fn[rows], Q, self.scale)
            yield rows, still + moving / self.Q**2

    def maximum(self) -> ResponseMaximum:
        """Return the greatest exact response over all natural frequencies.

        max a_rms(f_n) for f_1 ≤ f_n ≤ f_2/r_p, between which it lies (see `peak_ratio`):
        bracketed on a grid that holds every breakpoint and is graded towards it as f_b/Q, then
        narrowed. The value is found to 1e-10; the frequency, where the maximum is flat, to some
        1e-5 of the width of the peak.

        Examples
        --------
        >>> most = ResponseSpectrum(np.array([20.0, 2000]), np.full(2, 0.2005), 100).maximum()
        >>> round(most.response, 1), round(most.frequency)
        (241.9, 1923)
        """
        points = np.unique(np.concatenate([self.grid[0], self._beyond]))

        def response(fn: Floats, _: Integers) -> Floats:
            return self(fn)

        value, place, _ = greatest(response, points, np.zeros(points.size, dtype=np.intp))
        return ResponseMaximum(value, place)

    def shortfall(self) -> MilesShortfall:
        """Return where in the band Miles is farthest below the exact response.

        max a_rms(f_n)/sqrt(π/2 · f_n Q G(f_n)) − 1; at a step, against both of its levels.

        Examples
        --------
        >>> f, g = np.array([20.0, 100, 100, 2000]), np.array([0.01, 0.01, 0.16, 0.16])
        >>> low = ResponseSpectrum(f, g, 50).shortfall()
        >>> round(low.excess, 2), round(low.frequency, 3)
        (1.87, 100.0)
        """
        f, g, scale = self.frequency, self.level, self.scale

        def excess(fn: Floats, segment: Integers) -> Floats:
            side_right = spectral_level(fn, f, g, scale=scale, side="right")
            side_left = spectral_level(fn, f, g, scale=scale, side="left")
            here = np.where(fn == f[segment + 1], side_left, side_right)
            return self(fn) / miles(fn, self.Q, here)

        value, place, _ = greatest(excess, *self.grid)
        return MilesShortfall(value - 1.0, place)
