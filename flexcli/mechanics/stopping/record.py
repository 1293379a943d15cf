"""Peaks, work, losses and momentum of the segments of a run, gathered in batches."""

from collections import defaultdict
from math import ceil
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.stopping.hertz_contact import HertzPass
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.phases import Contact, Phase
from flexcli.mechanics.stopping.result import History, Peaks
from flexcli.numerics.linear_response import LinearResponse, respond
from flexcli.numerics.quadrature import gauss_rule
from flexcli.numerics.response_batch import ResponseBatch, greatest_values
from flexcli.numerics.sampled_response import SampledResponse
from flexcli.numerics.signal_pieces import Samples

__all__ = ["Record"]

Floats = NDArray[np.float64]

_BATCH = 512
"""Segments gathered before they are evaluated together."""
_STEPS = 4096
"""Steps between samples gathered before they are evaluated together."""
_NODES_PER_RADIAN = 0.5
_FEWEST_NODES, _MOST_NODES = 8, 256
"""Gauss points: exact to rounding for a product of motions that turn by one radian per 2 nodes."""
_PEAKS = Peaks._fields
_STEP_NODES = 6
"""The same for a step between samples, which is short and many."""
_PEAK_ROWS = (
    ("tip_above", 0, 1.0),
    ("tip_below", 0, -1.0),
    ("at_stop", 1, 1.0),
    ("at_stop", 1, -1.0),
    ("base_moment", 2, 1.0),
    ("base_moment", 2, -1.0),
    ("force", 3, 1.0),
)
"""What peaks are of: its name, its row of the outputs, its sign."""
_LEAST_SHARE = 0.8
"""A segment whose samples stay below that share of the greatest value can't exceed it."""


def _crest(times: Floats, values: Floats) -> float:
    """Return the greatest value of samples, of the parabola through it and its neighbours."""
    top = int(np.argmax(values))
    if not 0 < top < values.size - 1:
        return float(values[top])
    (a, b), (below, above) = ((v[top - 1] - v[top], v[top + 1] - v[top]) for v in (times, values))
    if a == 0.0 or b == 0.0:
        return float(values[top])
    slope = (below / a * b - above / b * a) / (b - a)
    bend = (above / b - below / a) / (b - a)
    return float(values[top] - slope**2 / (4.0 * bend)) if bend < 0.0 else float(values[top])


class _Segment(NamedTuple):
    start: float
    length: float
    contact: int
    response: LinearResponse


class _Steps(NamedTuple):
    """Steps between samples: y at the start of each, the signal's ends, the contact or −1."""

    flow: SampledResponse
    y: NDArray[np.complex128]
    before: Floats
    after: Floats
    contacts: NDArray[np.int64]


class Record:
    """Sums over the segments of a run.

    ``work`` of the base, ``damped`` in the blade, ``dashpots`` [J]; the integrals of the base's
    acceleration, of q and of the signed push of the stops (times their side) are the terms of
    momentum; ``impulses`` are those of the pushes, by contact.
    """

    def __init__(self, blade: ModalBlade, keep_history: bool) -> None:
        """Start at zero."""
        self._blade = blade
        self._segments: dict[tuple[int, int], list[_Segment]] = defaultdict(list)
        self._flights: dict[tuple[int, float], list[_Steps]] = defaultdict(list)
        self._phases: dict[int, Phase] = {}
        self._waiting = 0.0
        self._samples: list[tuple[Floats, ...]] | None = [] if keep_history else None
        self.work = self.damped = self.dashpots = 0.0
        self.base_integral = 0.0
        self.push_integral = 0.0
        self.q_integral = np.zeros(blade.angular.size)
        self.impulses: dict[int, float] = defaultdict(float)
        self._most = dict.fromkeys(_PEAKS, 0.0)

    @property
    def keeps_history(self) -> bool:
        """Whether samples in time are kept."""
        return self._samples is not None

    def add(
        self, phase: Phase, response: LinearResponse, start: float, length: float, contact: int
    ) -> None:
        """Take a segment: the response from its own zero to a length, part of a contact or −1."""
        rates = np.abs(phase.system.roots).max(initial=0.0)
        rates += max((abs(rate) for rate, _ in response.piece.terms), default=0.0)
        count = ceil((_FEWEST_NODES + _NODES_PER_RADIAN * 2.0 * rates * length) / 8.0) * 8
        key = id(phase), min(count, _MOST_NODES)
        self._phases[id(phase)] = phase
        self._segments[key].append(_Segment(start, length, contact, response))
        self._waiting += 1.0 / _BATCH
        if self._waiting >= 1.0:
            self.flush()

    def flush(self) -> None:
        """Evaluate the segments that wait."""
        for (identity, count), segments in self._segments.items():
            self._evaluate(self._phases[identity], count, segments)
        for (identity, step), flights in self._flights.items():
            self._evaluate_steps(self._phases[identity], step, flights)
        self._segments.clear()
        self._flights.clear()
        self._waiting = 0.0

    def _evaluate(self, phase: Phase, count: int, segments: list[_Segment]) -> None:
        batch = ResponseBatch([s.response for s in segments])
        lengths = np.array([s.length for s in segments])
        nodes, weights = gauss_rule(count)
        times = lengths[:, None] * np.concatenate([[0.0], nodes, [1.0]])
        y = batch.amplitudes(times)
        a = batch.signal(times)
        impulses = self._add_integrals(phase, lengths, weights, y[..., 1:-1], a[..., 1:-1])
        if phase.contact is not Contact.FREE:
            for segment, impulse in zip(segments, impulses, strict=True):
                self.impulses[segment.contact] += float(impulse)
        self._see_peaks(phase, batch, times, y, a)
        if self._samples is not None:
            starts = np.array([s.start for s in segments])
            tip, at_stop, _, force = self._outputs(phase, y, a)
            self._samples.append(
                tuple(v.ravel() for v in (starts[:, None] + times, tip, at_stop, force))
            )

    def add_flight(
        self,
        phase: Phase,
        flow: SampledResponse,
        y: NDArray[np.complex128],
        base: Samples,
        contact: int,
    ) -> None:
        """Take a phase over samples of the base, y at each of them; part of a contact or −1."""
        a = base.values
        self._phases[id(phase)] = phase
        self._flights[id(phase), base.step].append(
            _Steps(flow, y[:, :-1], a[:-1], a[1:], np.full(a.size - 1, contact))
        )
        self._waiting += (a.size - 1) / _STEPS
        if self._waiting >= 1.0:
            self.flush()

    def _evaluate_steps(self, phase: Phase, step: float, flights: list[_Steps]) -> None:
        """Take steps between samples, wherever each begins."""
        flow = flights[0].flow
        y = np.concatenate([f.y for f in flights], axis=1)
        before, after, contacts = (
            np.concatenate([getattr(f, name) for f in flights])
            for name in ("before", "after", "contacts")
        )
        rates = float(np.abs(phase.system.roots).max(initial=0.0))
        nodes, weights = gauss_rule(min(ceil(_STEP_NODES + rates * step), _MOST_NODES))
        shares = np.concatenate([[0.0], nodes, [1.0]])
        inner = flow.within(y, before, after, shares)
        signal = before[:, None] + (after - before)[:, None] * shares
        lengths = np.full(before.size, step)
        pushed = self._add_integrals(phase, lengths, weights, inner[..., 1:-1], signal[..., 1:-1])
        if phase.contact is not Contact.FREE:
            for contact, impulse in zip(contacts.tolist(), pushed.tolist(), strict=True):
                self.impulses[contact] += impulse
        spacing = step * float(np.diff(shares).max())
        samples = self._outputs(phase, inner, signal)
        may_lead = np.zeros(before.size, dtype=np.bool_)
        for index, row in enumerate(self._rows(phase)):
            stray = flow.stray(row, y, before, after, spacing)
            for name, of, sign in _PEAK_ROWS:
                if of == index:
                    tops = (sign * samples[index]).max(axis=1)
                    may_lead |= tops + stray > max(self._most[name], float(tops.max()))
        if may_lead.any():
            chosen = np.flatnonzero(may_lead)
            lines = [Samples(np.array([before[i], after[i]]), step).line(0) for i in chosen]
            batch = ResponseBatch(
                [
                    respond(phase.system, phase.drive, y[:, i], line)
                    for i, line in zip(chosen, lines, strict=True)
                ]
            )
            times = np.tile(step * shares, (chosen.size, 1))
            self._see_peaks(phase, batch, times, inner[chosen], signal[chosen])

    def _rows(self, phase: Phase) -> tuple[NDArray[np.complex128], ...]:
        """Return what takes amplitudes to tip, deflection at the stop, moment and push."""
        blade, push = self._blade, phase.side * phase.force.on_y
        return (
            blade.tip @ phase.shapes - blade.tip_residual * push,
            phase.deflection.on_y - blade.stop_residual * push,
            blade.base_moment @ phase.shapes - blade.moment_residual * push,
            phase.force.on_y,
        )

    def _add_integrals(
        self,
        phase: Phase,
        lengths: Floats,
        weights: Floats,
        y: NDArray[np.complex128],
        a: Floats,
    ) -> Floats:
        """Add work, losses and momentum of segments from Gauss points; return the impulses."""
        blade, shapes = self._blade, phase.shapes
        q = phase.origin[:, None] + (shapes @ y).real
        rate = (shapes @ (phase.system.roots[:, None] * y)).real
        push = phase.force.constant + (phase.force.on_y @ y).real + phase.force.direct * a

        def integral(values: Floats) -> Floats:
            total: Floats = (values * weights).sum(axis=-1) * (
                lengths if values.ndim == 2 else lengths[:, None]
            )
            return total

        self.work -= float(integral(a * np.einsum("n,snt->st", blade.base, rate)).sum())
        rates_lost = np.einsum("n,snt->st", np.diagonal(blade.damper), rate**2)
        self.damped += float(integral(rates_lost).sum())
        if phase.dashpot:
            at_stop = np.einsum("n,snt->st", blade.stop, rate)
            self.dashpots += phase.dashpot * float(integral(at_stop**2).sum())
        self.base_integral += float(integral(a).sum())
        self.q_integral += integral(q).sum(axis=0)
        impulses = integral(push)
        self.push_integral += phase.side * float(impulses.sum())
        return impulses

    def _outputs(self, phase: Phase, y: NDArray[np.complex128], a: Floats) -> tuple[Floats, ...]:
        """Return tip, deflection at the stop, moment at the clamp and push."""
        blade = self._blade
        push = phase.force.constant + (phase.force.on_y @ y).real + phase.force.direct * a
        modal = np.stack([blade.tip, blade.base_moment])
        moving = (modal @ phase.shapes @ y).real
        rest = modal @ phase.origin
        at_stop = phase.deflection.constant + (phase.deflection.on_y @ y).real
        return (
            rest[0] + moving[:, 0] - phase.side * blade.tip_residual * push,
            at_stop - phase.side * blade.stop_residual * push,
            rest[1] + moving[:, 1] - phase.side * blade.moment_residual * push,
            push,
        )

    def _see_peaks(
        self,
        phase: Phase,
        batch: ResponseBatch,
        times: Floats,
        y: NDArray[np.complex128],
        a: Floats,
    ) -> None:
        """Refine the greatest values of the segments that may have them, all at once."""
        names, outputs, signs = zip(*_PEAK_ROWS, strict=True)
        of, sign = np.array(outputs), np.array(signs)
        samples = sign[:, None, None] * np.stack(self._outputs(phase, y, a))[of]
        tops = samples.max(axis=-1)
        known = np.array([self._most[name] for name in names])
        best = np.maximum(known, tops.max(axis=1))
        rows, segments = np.nonzero(tops > _LEAST_SHARE * best[:, None])
        if rows.size == 0:
            return
        some, of, sign = batch.of(segments), of[rows], sign[rows, None]

        def function(t: Floats) -> Floats:
            found = np.stack(self._outputs(phase, some.amplitudes(t), some.signal(t)))
            return np.asarray(sign * found[of, np.arange(of.size)])

        found, _ = greatest_values(function, times[segments], samples[rows, segments])
        for row, value in zip(rows.tolist(), found.tolist(), strict=True):
            self._most[names[row]] = max(self._most[names[row]], value)

    def add_hertz(self, found: HertzPass, side: int, start: float, contact: int) -> None:
        """Take a pass through a Hertzian contact; its peaks are crests through its samples."""
        blade, most = self._blade, self._most
        self.work += found.work
        self.damped += found.damped
        self.base_integral += found.base_integral
        self.push_integral += side * found.impulse
        self.q_integral += found.q_integral
        self.impulses[contact] += found.impulse
        push = found.pushes
        tip = blade.tip @ found.motions - side * blade.tip_residual * push
        at_stop = blade.stop @ found.motions - side * blade.stop_residual * push
        moment = blade.base_moment @ found.motions - side * blade.moment_residual * push
        for name, values in (
            ("tip_above", tip),
            ("tip_below", -tip),
            ("at_stop", np.abs(at_stop)),
            ("base_moment", np.abs(moment)),
            ("force", push),
        ):
            most[name] = max(most[name], _crest(found.times, values))
        if self._samples is not None:
            self._samples.append((start + found.times, tip, at_stop, push))

    def strike(self, side: int, impulse: float) -> None:
        """Take an impact on a rigid stop."""
        self.push_integral += side * impulse
        self._most["impulse"] = max(self._most["impulse"], impulse)

    def peaks(self) -> Peaks:
        """Return the greatest values since they were last taken."""
        self.flush()
        return Peaks(**self._most)

    def take_peaks(self) -> Peaks:
        """Return the greatest values since they were last taken, and take them."""
        peaks = self.peaks()
        self._most = dict.fromkeys(_PEAKS, 0.0)
        return peaks

    def history(self) -> History | None:
        """Return the samples so far, in order of time."""
        if not self._samples:
            return None
        columns = [np.concatenate(column) for column in zip(*self._samples, strict=True)]
        order = np.argsort(columns[0], kind="stable")
        return History(*(column[order] for column in columns))
