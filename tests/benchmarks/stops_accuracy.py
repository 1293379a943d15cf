"""Error against time: exact between events, against a general integrator with a penalty contact.

Run by hand: python tests/benchmarks/stops_accuracy.py
A free oscillator between two springs k_c/k_f as stiff, no damping, 20 periods. Its contact times
are known in closed form; the error is that of the last one, as a share of the period. The general
integrator (scipy's Radau and DOP853) sees the force of the springs and nothing else; its contact
times are the crossings of its dense output. Ratios are of this run, on this machine.
"""

from math import asin, atan2, sqrt
from time import perf_counter

import numpy as np
from scipy.integrate import solve_ivp

from flexcli.mechanics.stopping.laws import LinearStop, Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.vibration import simulate
from flexcli.numerics.signal_pieces import Piece

PERIODS = 20
SPEED = 1.1
RATIOS = (10.0, 1e3, 1e6)
TOLERANCES = (1e-3, 1e-5, 1e-7, 1e-9, 1e-11)


def exact(ratio):
    """Give the period and the time of the last touch."""
    touch, speed = asin(1 / SPEED), sqrt(SPEED**2 - 1)
    # against the spring the rest lies 1/ratio before the touch
    against = 2 * atan2(speed / sqrt(ratio), 1 / ratio)
    period = 4 * touch + 2 * against / sqrt(ratio)
    return period, (PERIODS - 1) * period + period / 2 + touch


def event_driven(ratio):
    """Give time, error of the last contact and of energy."""
    period, last = exact(ratio)
    one = np.ones(1)
    blade = ModalBlade(angular=one, damping=0 * one, base=one, tip=one, stop=one, base_moment=one)
    stops = Stops(LinearStop(ratio - 1.0), 1.0, 1.0)
    pieces = [Piece(period, ())] * PERIODS
    begin = perf_counter()
    result = simulate(blade, stops, pieces, rate=[SPEED])
    seconds = perf_counter() - begin
    assert result.contacts.time.size == 2 * PERIODS
    energy = abs(result.balance.energy_residual) / result.balance.start
    return seconds, abs(result.contacts.time[-1] - last) / period, energy


def penalty(ratio, method, tolerance):
    """Give the same of a general integrator."""
    period, last = exact(ratio)
    k = ratio - 1.0

    def slope(t, x):
        push = k * (max(x[0] - 1, 0.0) - max(-x[0] - 1, 0.0))
        return np.array([x[1], -x[0] - push])

    def touch(t, x):
        return abs(x[0]) - 1

    touch.direction = 1
    begin = perf_counter()
    found = solve_ivp(
        slope,
        (0, PERIODS * period),
        [0.0, SPEED],
        method,
        rtol=tolerance,
        atol=tolerance,
        events=touch,
    )
    seconds = perf_counter() - begin
    q, v = found.y[:, -1]
    energy = 0.5 * (v * v + q * q + k * max(abs(q) - 1, 0.0) ** 2)
    touches = found.t_events[0]
    error = abs(touches[-1] - last) / period if touches.size == 2 * PERIODS else float("nan")
    return seconds, error, abs(2 * energy / SPEED**2 - 1)


def main():
    """Print the table."""
    print(f"{'k_c/k_f':>8s}  {'method':22s} {'time [ms]':>10s} {'ratio':>7s} ", end="")
    print(f"{'error of time':>14s} {'of energy':>10s}")
    for ratio in RATIOS:
        event_driven(ratio)  # first call pays for caches
        own, error, energy = event_driven(ratio)
        row = "{:8.0e}  {:22s} {:10.1f} {:7.1f} {:14.1e} {:10.1e}"
        print(row.format(ratio, "event-driven", 1e3 * own, 1.0, error, energy))
        for method in ("Radau", "DOP853"):
            for tolerance in TOLERANCES:
                seconds, error, energy = penalty(ratio, method, tolerance)
                name = f"{method} at {tolerance:.0e}"
                print(row.format(ratio, name, 1e3 * seconds, seconds / own, error, energy))
    print("\nnan: the integrator saw another number of contacts than there are")


if __name__ == "__main__":
    main()
