"""Compare shock and vibration response spectra with pyYeti: values, and times as ratios.

Run by hand, in an environment of its own: pip install pyyeti, then
python tests/benchmarks/response_spectra_peers.py
"""

from time import perf_counter

import numpy as np
from pyyeti import psd, srs

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
    told("grms of GEVS", rms(*profile.T), np.sqrt(psd.area(profile)), (1.0, 1.0))
    natural = np.geomspace(30.0, 1500.0, 40)
    grid = np.arange(20.0, 2000.01, 0.05)
    ours, mine = timed(lambda: oscillator_response(*profile.T, natural, Q).absolute_acceleration)
    theirs, other = timed(lambda: srs.vrs(profile, grid, Q, linear=False, Fn=natural))
    told("vrs of GEVS", ours, np.ravel(theirs), (mine, other))


if __name__ == "__main__":
    main()
