"""Compare our damage rates with peers and with rainflow counts of generated records.

Run by hand, in an environment of its own: pip install FLife rainflow py-fatigue, then
python tests/benchmarks/spectral_fatigue.py
A peer that is not installed leaves its column out. Stress is an amplitude throughout.
"""

from importlib import import_module
from time import perf_counter

import numpy as np

from flexcli.formulas.damage import damage_rates
from flexcli.formulas.spectral_moments import Moments
from flexcli.formulas.spectrum import spectral_level
from flexcli.formulas.spectrum_integrals import spectral_moment

SPECTRA = {
    "flat 10–300 Hz": ([10, 300], [1.0, 1.0]),
    "narrow 95–105 Hz": ([95, 105], [1.0, 1.0]),
    "two modes 10–12, 90–100 Hz": ([10, 12, 12, 90, 90, 100], [10, 10, 1e-6, 1e-6, 1, 1]),
    "falling f⁻² 5–500 Hz": ([5, 500], [1.0, 1e-4]),
}
EXPONENTS = (3.0, 5.0, 8.0)
C = 1e10
RECORDS, COUNT, POINTS_PER_PERIOD = 4, 2**20, 16


def peer(name):
    """Import a package, or say None."""
    try:
        return import_module(name)
    except ImportError:
        return None


def record(frequency, level, generator):
    """Give a Gaussian record of a profile and its duration."""
    rate = POINTS_PER_PERIOD * frequency[-1]
    f = np.fft.rfftfreq(COUNT, 1 / rate)
    g = spectral_level(np.maximum(f, 1e-300), frequency, level)
    normal = generator.standard_normal((2, f.size))
    return np.fft.irfft(np.sqrt(g * rate * COUNT / 4) * (normal[0] + 1j * normal[1])), COUNT / rate


def counted_rate(counter, records, k):
    """Give the damage rate of records from (range, count) pairs, and its scatter."""
    rates = [
        sum(count * (size / 2) ** k for size, count in counter(signal)) / C / time
        for signal, time in records
    ]
    return float(np.mean(rates)), float(np.std(rates) / np.mean(rates) / np.sqrt(len(rates)))


def flife_rates(flife, frequency, level, k):
    """Give FLife's damage rates on a fine grid of the same profile."""
    grid = np.linspace(0, frequency[-1] * 1.0001, 400_001)
    density = spectral_level(np.maximum(grid, 1e-300), frequency, level)
    data = flife.SpectralData(input=(density, grid))
    return {
        "narrow-band": 1 / flife.Narrowband(data).get_life(C, k),
        "wirsching-light": 1 / flife.WirschingLight(data).get_life(C, k),
        "dirlik": 1 / flife.Dirlik(data).get_life(C, k),
        "tovo-benasciutti": 1 / flife.TovoBenasciutti(data).get_life(C, k, method="method 2"),
    }


def main():
    """Print the tables."""
    rainflow, flife, py_fatigue = peer("rainflow"), peer("FLife"), peer("py_fatigue")
    generator = np.random.default_rng(20250101)
    for name, (frequency, level) in SPECTRA.items():
        moments = Moments(*spectral_moment(frequency, level, [0, 1, 2, 4]))
        records = [record(frequency, level, generator) for _ in range(RECORDS)]
        print(f"\n{name}: alpha1 {moments.alpha1:.3f}, alpha2 {moments.alpha2:.3f}")
        heads = f"{'ours [1/s]':>12s} {'FLife/ours − 1':>15s} {'ours/rainflow':>14s}"
        print(f"{'k':>4s} {'method':18s} {heads}")
        for k in EXPONENTS:
            ours = {key: float(value) for key, value in damage_rates(moments, k, C).items()}
            theirs = flife_rates(flife, frequency, level, k) if flife else {}
            counted = scatter = float("nan")
            if rainflow:
                counted, scatter = counted_rate(rainflow.count_cycles, records, k)
            for method, rate in ours.items():
                gap = (
                    f"{float(theirs[method]) / rate - 1:15.1e}"
                    if method in theirs
                    else f"{'–':>15s}"
                )
                print(f"{k:4.0f} {method:18s} {rate:12.4e} {gap} {rate / counted:14.3f}")
            least, most = min(ours, key=ours.__getitem__), max(ours, key=ours.__getitem__)
            print(
                f"{'':4s} rainflow {counted:.4e} ± {100 * scatter:.1f} %; spread "
                f"{ours[most] / ours[least]:.2f} ({least} to {most})"
            )
            if py_fatigue and rainflow:
                other, _ = counted_rate(
                    lambda signal: py_fatigue_cycles(py_fatigue, signal), records[:1], k
                )
                one, _ = counted_rate(rainflow.count_cycles, records[:1], k)
                print(
                    f"{'':4s} py-fatigue's count over rainflow's, first record: {other / one:.6f}"
                )
    begin = perf_counter()
    for _ in range(1000):
        damage_rates(Moments(*spectral_moment(frequency, level, [0, 1, 2, 4])), 5.0, C)
    alone = (perf_counter() - begin) / 1000
    print(f"\nmoments and all five methods: {1e6 * alone:.0f} µs per design; ", end="")
    if flife:
        begin = perf_counter()
        flife_rates(flife, frequency, level, 5.0)
        print(
            f"FLife's four on its grid {(perf_counter() - begin) / alone:.0f} times as long; ",
            end="",
        )
    square = np.linspace(0.5, 2, 100_000) ** 2
    many = Moments(*(square * m for m in (moments.m0, moments.m1, moments.m2, moments.m4)))
    begin = perf_counter()
    damage_rates(many, 5.0, C)
    print(f"{10 * (perf_counter() - begin):.2f} µs in a batch of 100,000")


def py_fatigue_cycles(py_fatigue, signal):
    """Give (range, count) pairs of py-fatigue's rainflow counter."""
    module = import_module("py_fatigue.cycle_count.rainflow")
    cycles = np.asarray(module.rainflow(signal, extended_output=False))
    return [(2 * half_range, count) for half_range, _, count in cycles[:, :3].tolist()]


if __name__ == "__main__":
    main()
