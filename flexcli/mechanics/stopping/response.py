"""Steady amplitudes of a blade between stops, one frequency after another from the last state."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.result import Peaks, StopOutcome
from flexcli.mechanics.stopping.vibration import StoppedVibration
from flexcli.numerics.signal_pieces import sine

__all__ = ["SteppedResponse", "steady_steps", "stepped_response"]

Floats = NDArray[np.float64]


class Step(NamedTuple):
    """What one frequency settled to: peaks over the last window, contacts per period."""

    angular: float
    peaks: Peaks
    contacts: float
    settled: bool


class SteppedResponse(NamedTuple):
    """Steps as arrays (steps,): rad/s, tip [m], clamp [N·m], push [N], contacts per period.

    ``settled`` is false where the peaks of two windows kept differing: beats, or chaos.
    """

    angular: Floats
    travel: Floats
    base_moment: Floats
    force: Floats
    contacts: Floats
    settled: NDArray[np.bool_]


def steady_steps(
    blade: ModalBlade,
    stops: Stops,
    *,
    angular: Iterable[float],
    amplitude: ArrayLike,
    window: int = 20,
    tolerance: float = 1e-3,
    most_windows: int = 100,
    kick: float = 0.0,
) -> Iterator[Step]:
    """Yield the steady motion at each frequency, in the order given.

    The base's sine goes on without a jump from one frequency to the next, so that going up and
    going down show the jumps and the range between them in which two motions are possible.

    Parameters
    ----------
    blade, stops : ModalBlade, Stops
        The scene.
    angular : iterable of float
        Angular frequencies of the base [rad/s].
    amplitude : array_like
        Amplitudes of the base's acceleration [m/s²], one for all or one for each.
    window : int
        Periods in which a peak is taken.
    tolerance : float
        Two windows whose travels agree to that share are steady.
    most_windows : int
        Windows after which a frequency is left, settled or not.
    kick : float
        Speed of the first mode's coordinate at the start [m/s·√kg].

    Raises
    ------
    RuntimeError
        When contacts follow each other without end.
    """
    rate = np.zeros(blade.angular.size)
    rate[0] = kick
    run = StoppedVibration(blade, stops, rate=rate)
    steps = np.array(list(angular), dtype=np.float64)
    for omega, A in zip(steps, np.broadcast_to(amplitude, steps.shape), strict=True):
        last, settled = np.inf, False
        span = window * 2.0 * np.pi / float(omega)
        for _ in range(most_windows):
            count = run.contact_count
            for _ in run.run(sine(amplitude=float(A), angular=float(omega), duration=span)):
                pass
            if run.outcome is StopOutcome.TOO_MANY_EVENTS:
                raise RuntimeError(f"{run.outcome.cause}: {run.outcome.remedy}")
            peaks = run.take_peaks()
            settled = abs(peaks.travel - last) <= tolerance * peaks.travel
            last = peaks.travel
            if settled:
                break
        yield Step(float(omega), peaks, (run.contact_count - count) / window, settled)


def stepped_response(
    blade: ModalBlade,
    stops: Stops,
    *,
    angular: Iterable[float],
    amplitude: ArrayLike,
    window: int = 20,
    tolerance: float = 1e-3,
    most_windows: int = 100,
    kick: float = 0.0,
) -> SteppedResponse:
    """Return all steps of ``steady_steps`` as arrays."""
    steps = list(
        steady_steps(
            blade,
            stops,
            angular=angular,
            amplitude=amplitude,
            window=window,
            tolerance=tolerance,
            most_windows=most_windows,
            kick=kick,
        )
    )
    return SteppedResponse(
        angular=np.array([s.angular for s in steps]),
        travel=np.array([s.peaks.travel for s in steps]),
        base_moment=np.array([s.peaks.base_moment for s in steps]),
        force=np.array([s.peaks.force for s in steps]),
        contacts=np.array([s.contacts for s in steps]),
        settled=np.array([s.settled for s in steps]),
    )
