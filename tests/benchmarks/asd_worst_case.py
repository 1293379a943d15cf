"""Time the worst case: closed form, dense grid, exact response; and how it grows with the profile.

Run by hand: python tests/benchmarks/asd_worst_case.py
Ratios are of this run, on this machine.
"""

from time import perf_counter

import numpy as np

from flexcli.formulas.miles import miles, miles_worst_case
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.response_spectrum import ResponseSpectrum
from flexcli.formulas.spectrum import spectral_level
from flexcli.formulas.spectrum_integrals import rms

Q = 100.0
GRIDS = (1_000, 10_000, 100_000, 1_000_000)


def profile(points=20, seed=7):
    """Give a profile of irregular slopes from 20 to 2000 Hz."""
    generator = np.random.default_rng(seed)
    inner = np.sort(20 * 100 ** generator.random(points - 2))
    return np.concatenate([[20], inner, [2000]]), 10 ** generator.uniform(-3, 0, points)


def seconds(call, repeats=20):
    """Give the least time of several calls, and the last result."""
    times = []
    for _ in range(repeats):
        begin = perf_counter()
        result = call()
        times.append(perf_counter() - begin)
    return min(times), result


def main():
    """Print the table."""
    f, g = profile()
    time, worst = seconds(lambda: miles_worst_case(f, g, Q))
    print(f"profile of {f.size} points, {rms(f, g):.3f} rms, Q = {Q:g}\n")
    print(f"{'worst case of Miles':34s} {'time [µs]':>10s} {'ratio':>8s} {'error':>10s}")
    print(f"{'closed form':34s} {1e6 * time:10.1f} {1:8.1f} {0:10.1e}")
    for count in GRIDS:
        asked = np.geomspace(20, 2000, count)
        grid_time, found = seconds(
            lambda asked=asked: miles(asked, Q, spectral_level(asked, f, g)).max(), 3
        )
        error = float(found / worst.response - 1)
        name = f"grid of {count:,} frequencies"
        print(f"{name:34s} {1e6 * grid_time:10.1f} {grid_time / time:8.1f} {error:10.1e}")

    print(f"\n{'exact response':34s} {'time [ms]':>10s} {'µs each':>8s} {'/ Miles':>10s}")
    for quality in (0.5, 10.0, Q, 1e6):
        for count in (1, 1_000):
            fn = np.array([worst.frequency]) if count == 1 else np.geomspace(5, 8000, count)
            time, exact = seconds(
                lambda fn=fn, quality=quality: oscillator_response(f, g, fn, quality), 5
            )
            at = int(np.argmin(np.abs(fn - worst.frequency)))
            near = float(
                exact.pseudo_acceleration[at]
                / miles(fn[at], quality, spectral_level(fn[at], f, g, side="upper"))
            )
            name = f"Q = {quality:g}, {count:,} oscillators"
            print(f"{name:34s} {1e3 * time:10.3f} {1e6 * time / count:8.1f} {near:10.3f}")
    print_growth()


def print_growth():
    """Print the whole worst case of long profiles beside the sum of every segment.

    The sum is timed over a share of the grid that the worst case asks for: every oscillator costs
    it the same.
    """
    print(
        f"\n{'exact worst case, Q = ' + f'{Q:g}':22s} {'time [s]':>9s} {'/ 1000 points':>14s}",
        end="",
    )
    print(f" {'sum one by one [s]':>19s} {'ratio':>7s} {'difference':>11s}")
    first = None
    for points in (100, 1_000, 10_000, 30_000):
        f, g = profile(points)

        def extremes(f=f, g=g):
            spectrum = ResponseSpectrum(f, g, Q)
            return spectrum, spectrum.maximum(), spectrum.shortfall()

        time, (spectrum, *_) = seconds(extremes, 3)
        grid = spectrum.grid[0]
        some = grid[:: max(1, grid.size * points // 400_000)]
        direct, response = seconds(
            lambda f=f, g=g, some=some: oscillator_response(f, g, some, Q), 1
        )
        direct *= 2 * grid.size / some.size  # the greatest response, and Miles' shortfall
        first = time if points == 1_000 else first
        growth = f"{time / first:14.1f}" if first else " " * 14
        apart = np.abs(spectrum(some) / response.absolute_acceleration - 1).max()
        name = f"{points:,} points"
        print(f"{name:22s} {time:9.3f} {growth} {direct:19.2f} {direct / time:7.0f} {apart:11.1e}")


if __name__ == "__main__":
    main()
