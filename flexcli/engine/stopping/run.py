"""One run of a blade between its stops, driven leg by leg, and its row of the result."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from time import perf_counter

from flexcli.engine.stopping.excitation import Excitation, excitation
from flexcli.engine.stopping.scene import contact_model, stop_scene
from flexcli.engine.stopping.statics import StopTask, force_at_travel
from flexcli.errors import Outcome
from flexcli.formulas.stopped_cantilever import bending_stress
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.result import Peaks
from flexcli.mechanics.stopping.vibration import StoppedVibration
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.stops.stops import Simulation
from flexcli.results.stops import StopHistory, StopPlace, StopSimulation

__all__ = ["Enough", "StopRun", "stop_runs"]

LOOK_UP = 32
"""Pieces or flights between two reports on how far a run is, at most."""
REPORTS = 200
"""Least number of them: a flight may be long."""
LOOK_AT_PEAKS = 64
"""Pieces or flights between two looks at whether what a run has found is enough."""

Enough = Callable[[float, float, float], bool]
"""Told travel [m] and stresses at base and stop [Pa] so far; answers whether to end."""


@dataclass(frozen=True, eq=False)
class StopRun:
    """A case ready to run: ``law`` says in words how the stop pushes back."""

    task: StopTask
    place: StopPlace
    case: str
    law: str
    blade: ModalBlade
    shaken: Excitation
    engine: StoppedVibration
    model: str = ""
    stiffening: float = 0.0

    def driven(
        self, go_on: Callable[[float], bool], enough: Enough | None = None
    ) -> StopSimulation:
        """Drive the blade for as long as it shall go on, and return what came of it.

        A random run may end early, where its peaks are enough for a verdict.
        """
        begun = perf_counter()
        most, last, decided = self._peaks_of_legs(go_on, enough if self.shaken.exposure else None)
        found = self.engine.result()
        task, shaken = self.task, self.shaken
        exposed = found.duration / shaken.exposure if shaken.exposure else None
        contact = task.stops.contact.stress(most.force, task.elastic)
        base, at_stop = self._stresses(most)
        stopped = found.outcome is Outcome.CHATTER
        ranged = last if shaken.settles else most
        return StopSimulation(
            case=self.case,
            kind=shaken.kind,
            law=self.law,
            q=0.5 / float(self.blade.damping[0]),
            modes=self.blade.angular.size,
            seed=shaken.seed,
            planned=shaken.planned,
            duration=found.duration,
            outcome=f"{found.outcome.cause}: {found.outcome.remedy}" if stopped else "",
            confidence=exposed / (exposed + 1.0) if exposed is not None else None,
            travel=most.travel,
            pi_5=(ranged.tip_above + ranged.tip_below) / self.place.delta_G,
            force=most.force,
            impulse=most.impulse,
            contacts=found.contacts.time.size,
            contact_share=found.contact_time / found.duration if found.duration else 0.0,
            fastest=float(found.contacts.speed.max(initial=0.0)),
            sigma_base=base,
            sigma_contact=at_stop,
            p_hertz=contact.pressure if contact else None,
            tau_hertz=contact.shear if contact else None,
            energy_residual=found.balance.energy_error,
            impulse_residual=found.balance.impulse_residual,
            events=found.cost.events,
            seconds=perf_counter() - begun,
            model=self.model,
            has_decided=decided,
        )

    def _stresses(self, peaks: Peaks) -> tuple[float, float]:
        """Return the peak stresses at the base and at the stop [Pa]."""
        task, c = self.task, self.task.mechanism.offset
        load = (1.0 + self.stiffening) * force_at_travel(task, self.place, c, peaks.travel)
        arm = task.L - self.place.L_a + c
        base, at_stop = (
            float(bending_stress(M=M, I=task.I, h=task.h)) for M in (peaks.base_moment, load * arm)
        )
        return base, at_stop

    def history(self) -> StopHistory | None:
        """Return the samples, where they were kept."""
        history = self.engine.result().history
        if history is None:
            return None
        return StopHistory(self.case, *(tuple(column.tolist()) for column in history))

    def _peaks_of_legs(
        self, go_on: Callable[[float], bool], enough: Enough | None
    ) -> tuple[Peaks, Peaks, bool]:
        """Run leg after leg; return the peaks of all and of the last, whether they were enough."""
        engine, count, reported = self.engine, 0, 0.0
        most = last = engine.take_peaks()
        for leg in self.shaken.legs:
            for progress in engine.run(leg):
                count += 1
                done = progress.time / self.shaken.planned
                if count % LOOK_UP == 0 or done > reported + 1.0 / REPORTS:
                    reported = done
                    if not go_on(done):
                        last = engine.take_peaks()
                        return _higher(most, last), last, False
                if enough is not None and count % LOOK_AT_PEAKS == 0:
                    most = _higher(most, engine.take_peaks())
                    if enough(most.travel, *self._stresses(most)):
                        return most, most, True
            last = engine.take_peaks()
            most = _higher(most, last)
            if engine.outcome is Outcome.CHATTER:
                break
        return most, last, False


def _higher(one: Peaks, other: Peaks) -> Peaks:
    return Peaks(*map(max, one, other))


def stop_runs(
    design: DesignSpec,
    task: StopTask,
    sizes: Sizes,
    place: StopPlace,
    case: str,
    *,
    options: Simulation,
    keep_history: bool = False,
    head: float | None = None,
    stiffening: float = 0.0,
    more_modes: int = 0,
) -> Iterator[StopRun]:
    """Yield the runs of a case; with a stop on one side a sine or shock has either sign.

    Raises
    ------
    SolveError
        ``no-time`` and alike for what is no motion in time.
    """
    given = design.cases[case]
    blade, stops, law = stop_scene(
        design, task, sizes, place, case,
        head=head, stiffening=stiffening, more_modes=more_modes,
    )  # fmt: skip
    model = contact_model(task.stops.contact, head)
    for sign in (1,) if task.stops.sides == "both" else (1, -1):
        for shaken in excitation(case, given, blade, options, sign):
            engine = StoppedVibration(blade, stops, rate=shaken.rate, keep_history=keep_history)
            yield StopRun(task, place, case, law, blade, shaken, engine, model, stiffening)
