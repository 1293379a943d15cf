"""Compare shock and damage spectra with pyYeti: values to their own resolution, times as ratios.

Run by hand, in an environment of its own: pip install pyyeti, then
python tests/benchmarks/shock_and_damage_peers.py
"""

from time import perf_counter

import numpy as np
from pyyeti import fdepsd, psd, srs

from flexcli.formulas.damage_spectrum import damage_spectrum
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.record_spectrum import shock_response_spectrum
from flexcli.formulas.spectrum_integrals import rms

Q = 25.0


def timed(run):
    """Give what a run gives and its time."""
    started = perf_counter()
    found = run()
    return found, perf_counter() - started


def told(name, ours, theirs, times):
    """Print how far two arrays are apart, and the ratio of the times."""
    off = np.abs(np.asarray(ours) / np.asarray(theirs) - 1.0).max()
    print(f"{name:45} apart by {off:8.1e}, our time over theirs {times[0] / times[1]:6.2f}")


def main():
    """Print the comparison."""
    generator = np.random.default_rng(1)
    step = 1.0 / 20_000.0
    record = generator.normal(size=200_000)
    f = np.geomspace(20.0, 500.0, 30)
    ours, mine = timed(lambda: shock_response_spectrum(record, step, f, Q))
    theirs, other = timed(
        lambda: srs.srs(record, 1.0 / step, f, Q, ic="zero", stype="absacce", time="total")
    )
    told("srs of 10 s at 20 kHz", np.maximum(ours[0], ours[1]), theirs, (mine, other))

    profile = np.array([[20.0, 0.026], [50.0, 0.16], [800.0, 0.16], [2000.0, 0.026]])
    told("grms of GEVS", rms(*profile.T), psd.area(profile), (1.0, 1.0))
    natural = np.geomspace(30.0, 1500.0, 40)
    grid = np.geomspace(20.0, 2000.0, 20_000)
    level = psd.interp(profile, grid).ravel()
    ours, mine = timed(lambda: oscillator_response(*profile.T, natural, Q).absolute_acceleration)
    theirs, other = timed(lambda: srs.vrs((grid, level), natural, Q, linear=True))
    told("vrs of GEVS", ours, np.ravel(theirs), (mine, other))

    level = 2.0 * step  # of samples of unit variance, one-sided
    damage = damage_spectrum([1e-2, 0.5 / step], [level, level], f, Q, record.size * step, 4.0)
    found, other = timed(lambda: fdepsd.fdepsd(record, 1.0 / step, f, Q, verbose=False))
    ratio = damage / np.asarray(found.var)[:, 0] if found.var.ndim > 1 else damage
    print(f"fdepsd took {other:.2f} s; our narrow-band damage over its variance spans "
          f"{ratio.max() / ratio.min():.3g}")  # fmt: skip


if __name__ == "__main__":
    main()
