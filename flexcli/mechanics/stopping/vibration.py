"""A blade between stops in time: exact between events, events found from the safe side."""

from collections.abc import Iterable, Iterator
from math import inf
from time import perf_counter

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.errors import Outcome
from flexcli.mechanics.stopping.balance import MotionState, balance
from flexcli.mechanics.stopping.contact_log import ContactLog
from flexcli.mechanics.stopping.flight import Flight
from flexcli.mechanics.stopping.heads import StopHeads
from flexcli.mechanics.stopping.hertz_contact import HertzContact, HertzPass
from flexcli.mechanics.stopping.laws import HertzStop, RigidStop, Stops, refuse_start
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.phases import Contact, Phase, phases_of
from flexcli.mechanics.stopping.record import Record
from flexcli.mechanics.stopping.result import (
    Peaks,
    Progress,
    RunCost,
    StopResult,
)
from flexcli.numerics.first_crossing import first_crossing
from flexcli.numerics.linear_response import LinearResponse, respond
from flexcli.numerics.signal_pieces import Piece, Samples

__all__ = ["StoppedVibration", "simulate"]

Floats = NDArray[np.float64]

CHATTER = 1e-9
"""A bounce lower than that share of the room between the stops is the last: the blade is held."""
FAR = 1.0 + 1e-9
"""Times what the blade may move in a piece that a stop is away to be out of its reach."""
NUDGE = 1e-6
"""Share of the fastest time scale that first passes unasked when events fall on one time."""
MOST_EVENTS = 20_000
"""Events within one piece of the excitation (a period, a sample) before the run gives up."""


class StoppedVibration:
    """A run: iterate ``run(excitation)`` to advance, ask for ``result`` after any step of it.

    Each step of the iteration is one piece of the excitation (a period of a sine), or a flight
    over many samples without an event.
    """

    def __init__(
        self,
        blade: ModalBlade,
        stops: Stops,
        *,
        q: ArrayLike | None = None,
        rate: ArrayLike | None = None,
        keep_history: bool = False,
    ) -> None:
        """Set up a start, at rest unless told.

        Raises
        ------
        SolveError
            ``start-inside-stop`` when the start lies beyond a stop, ``rigid-stop-residual`` when
            a stop with restitution meets a blade with residual compliance.
        """
        n = blade.angular.size
        self._blade, self._stops = blade, stops
        self._q = np.zeros(n) if q is None else np.array(q, dtype=np.float64)
        self._rate = np.zeros(n) if rate is None else np.array(rate, dtype=np.float64)
        at_stop = float(blade.stop @ self._q)
        refuse_start(blade, stops, at_stop)
        s, damper = blade.stop, np.diagonal(blade.damper)
        self._striking = s, damper, float(s @ s), float(s @ (damper * s))
        self._room = stops.room or abs(at_stop) or 1.0
        self._phases = phases_of(blade, stops)
        self._free = self._phase = self._phases[Contact.FREE, 0]
        self._hertz = {
            side: HertzContact(blade, stops.law, stops.gap(side), side)
            for side in (1, -1)
            if isinstance(stops.law, HertzStop)
        }
        self._hertz_side = 0
        self._y = self._phase.project(self._q, self._rate)
        self._heads = StopHeads()
        self._record = Record(blade, keep_history)
        self._log = ContactLog()
        self._lost = 0.0
        self._idle = 0
        self._events = self._evaluations = self._segments = 0
        self._time = 0.0
        self._start = MotionState(self._q.copy(), self._rate.copy(), 0.0)
        self._seconds = 0.0
        self._outcome = Outcome.INTERRUPTED

    def run(self, excitation: Iterable[Piece | Samples]) -> Iterator[Progress]:
        """Advance over the base's acceleration [m/s²], yielding after each piece or flight."""
        self._outcome = Outcome.INTERRUPTED
        for given in excitation:
            for _ in self._over(given):
                if self._outcome is Outcome.CHATTER:
                    return
                yield Progress(self._time, len(self._log))
        self._outcome = Outcome.COMPLETE

    def _pass(self, piece: Piece) -> None:
        """Advance over a piece, from event to event."""
        begin = perf_counter()
        events = self._events
        rest = piece
        while rest.duration > 0.0 and self._outcome is Outcome.INTERRUPTED:
            passed = self._advance(rest)
            rest = rest.after(passed) if passed < rest.duration else Piece(0.0, ())
            if self._events - events > MOST_EVENTS:
                self._outcome = Outcome.CHATTER
        self._seconds += perf_counter() - begin

    def _over(self, samples: Piece | Samples) -> Iterator[None]:
        """Advance over a piece; over samples in flights where there is no event, else by line."""
        if isinstance(samples, Piece):
            self._pass(samples)
            yield
            return
        flights: dict[int, Flight] = {}
        done = 0
        while done < samples.values.size - 1:
            clear = 0
            if not self._hertz_side and not self._record.keeps_history:
                begin, phase = perf_counter(), self._phase
                if id(phase) not in flights:
                    flights[id(phase)] = Flight(phase, self._stops, samples.step)
                flight = flights[id(phase)]
                rest = samples.values[done:]
                y, clear = flight.ahead(self._y, rest)
                if clear:
                    flown = Samples(rest[: clear + 1], samples.step)
                    index = len(self._log) if phase.side else -1
                    self._record.add_flight(phase, flight.sampled, y, flown, index)
                    self._y = y[:, -1]
                    self._time += clear * samples.step
                    self._segments += clear
                    done += clear
                self._seconds += perf_counter() - begin
            if not clear:
                self._pass(samples.line(done))
                done += 1
            yield

    def _advance(self, piece: Piece) -> float:
        """Go to the next event or the end of a piece, and return the time that took."""
        if self._hertz_side:
            return self._pass_hertz(piece)
        phase = self._phase
        response = respond(phase.system, phase.drive, self._y, piece)
        time, side = self._next_event(response)
        if time <= 0.0:
            self._idle += 1
            if self._idle > 1 and phase.contact is Contact.FREE:
                # it left without force and is back without time: within rounding, let it go on
                nudge = NUDGE * 2.0 ** (self._idle - 2) / self._fastest()
                time, side = min(nudge, piece.duration), 0
        else:
            self._idle = 0
        length = min(time, piece.duration)
        if length > 0.0:
            index = len(self._log) if phase.side else -1
            self._record.add(phase, response, self._time, length, index)
            self._segments += 1
            self._time += length
            self._y = response.amplitudes(length)
        if side:
            self._events += 1
            self._q, self._rate = phase.state(self._y)
            if phase.contact is Contact.FREE:
                self._meet(side, piece(length))
            else:
                self._release(side)
        return length

    def _fastest(self) -> float:
        return float(np.abs(self._phase.system.roots).max(initial=self._blade.angular.max()))

    def _next_event(self, response: LinearResponse) -> tuple[float, int]:
        """Return time and side of the next event, inf and 0 when the piece ends before."""
        phase, horizon = self._phase, response.piece.duration
        if phase.contact is not Contact.FREE:
            force = phase.force
            push = response.output(force.on_y.tolist(), force.constant, force.direct)
            time, count = first_crossing(push, horizon)
            self._evaluations += count
            return (time, phase.side) if time < inf else (inf, 0)
        found, at = inf, 0
        row = phase.deflection.on_y.tolist()
        start, reach = response.span(row)
        for side in (1, -1):
            gap, head = self._stops.gap(side), self._heads.distance(side, self._time)
            if gap == inf or (head is None and gap - side * start > reach * FAR):
                continue
            distance = response.output([-side * r for r in row], gap)
            if head:
                distance = distance.plus(head)
            time, count = first_crossing(distance, min(found, horizon))
            self._evaluations += count
            if time < found:
                found, at = time, side
        return found, at

    def _meet(self, side: int, a: float) -> None:
        """Turn from free motion to what the law makes of a touch."""
        speed = side * float(self._blade.stop @ self._rate)
        law = self._stops.law
        if isinstance(law, RigidStop):
            self._strike(side, speed, a, law.restitution)
            return
        self._log.begin(self._time, side, speed)
        if isinstance(law, HertzStop):
            self._hertz_side = side
            return
        self._lost -= self._heads.meet(side, self._time)
        self._go(self._phases[Contact.SPRING, side])

    def _go(self, phase: Phase) -> None:
        self._phase = phase
        self._y = phase.project(self._q, self._rate)

    def _strike(self, side: int, speed: float, a: float, restitution: float) -> None:
        """Turn the speed at a rigid stop round; hold the blade when the bounces have died."""
        s, damper, weight, damped = self._striking
        speed = max(speed, 0.0)
        after = restitution * speed
        square = self._blade.angular**2
        pressing = side * float(
            s @ (-self._blade.base * a - damper * self._rate - square * self._q)
        )
        # the jump of the speed changes the damping's part of the pressing as well
        pressing += damped * (speed + after) / weight
        held = pressing > 0.0 and after**2 < 2.0 * pressing * CHATTER * self._room
        left = 0.0 if held else after
        impulse = (speed + left) / weight
        self._rate = self._rate - side * impulse * s
        self._lost += 0.5 * (speed**2 - left**2) / weight
        self._record.strike(side, impulse)
        if held:
            # the bounces left out would have lasted 2v/(a(1 − e)), v the speed after this one
            rest = 2.0 * after / (pressing * (1.0 - restitution)) if restitution < 1.0 else 0.0
            self._record.impulses[len(self._log)] += impulse
            self._log.begin(self._time + rest, side, speed)
            self._go(self._phases[Contact.HELD, side])
            return
        if speed > 0.0:
            self._log.strike(self._time, side, speed, impulse)
        self._go(self._free)

    def _release(self, side: int) -> None:
        """Turn from contact to free motion."""
        indentation = side * float(self._blade.stop @ self._q) - self._stops.gap(side)
        self._lost += self._heads.leave(self._phase, indentation, self._time)
        self._log.end(self._time)
        self._go(self._free)

    def _pass_hertz(self, piece: Piece) -> float:
        """Go through a Hertzian contact, to its end or the end of a piece."""
        side = self._hertz_side
        found: HertzPass = self._hertz[side].pass_through(self._q, self._rate, piece)
        if found.length <= 0.0:
            self._idle += 1
        self._record.add_hertz(found, side, self._time, len(self._log))
        self._lost += found.lost
        self._q, self._rate = found.q, found.rate
        self._time += found.length
        self._segments += 1
        self._evaluations += found.evaluations
        self._y = self._free.project(self._q, self._rate)
        if found.released:
            self._events += 1
            self._hertz_side = 0
            self._log.end(self._time)
        return found.length

    @property
    def outcome(self) -> Outcome:
        """How the last excitation ended."""
        return self._outcome

    @property
    def state(self) -> tuple[Floats, Floats]:
        """The modal coordinates and rates now."""
        if self._hertz_side:
            return self._q.copy(), self._rate.copy()
        return self._phase.state(self._y)

    @property
    def contact_count(self) -> int:
        """Contacts so far."""
        return len(self._log)

    def take_peaks(self) -> Peaks:
        """Return the greatest values since the last time this was asked."""
        return self._record.take_peaks()

    def _springs(self) -> float:
        """Return what the springs in contact hold [J]."""
        if self._hertz_side:
            return self._hertz[self._hertz_side].energy(self._q)
        if not self._phase.spring:
            return 0.0
        side = self._phase.side
        indentation = side * float(self._blade.stop @ self._q) - self._stops.gap(side)
        return 0.5 * self._phase.spring * indentation**2

    def result(self) -> StopResult:
        """Return what happened so far."""
        self._record.flush()
        if not self._hertz_side:
            self._q, self._rate = self._phase.state(self._y)
        contacts = self._log.contacts(self._time, self._record.impulses)
        return StopResult(
            outcome=self._outcome,
            duration=self._time,
            q=self._q,
            rate=self._rate,
            peaks=self._record.peaks(),
            contacts=contacts,
            contact_time=float(contacts.duration.sum()),
            balance=balance(
                self._blade,
                self._record,
                start=self._start,
                end=MotionState(self._q, self._rate, self._springs()),
                lost=self._lost,
            ),
            cost=RunCost(self._events, self._evaluations, self._segments, self._seconds),
            history=self._record.history(),
        )


def simulate(
    blade: ModalBlade,
    stops: Stops,
    excitation: Iterable[Piece | Samples],
    *,
    q: ArrayLike | None = None,
    rate: ArrayLike | None = None,
    keep_history: bool = False,
) -> StopResult:
    """Return what a blade between stops does under a base acceleration, from start to end."""
    run = StoppedVibration(blade, stops, q=q, rate=rate, keep_history=keep_history)
    for _ in run.run(excitation):
        pass
    return run.result()
