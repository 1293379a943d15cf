"""Build-up of a resonance under a sweep, against the response to a sampled sweep."""

import numpy as np
import pytest

from flexcli.formulas.record_spectrum import shock_response_spectrum
from flexcli.formulas.sweep_build_up import sweep_build_up


@pytest.mark.parametrize(("Q", "speed"), [(50.0, 2.0), (50.0, 20.0), (200.0, 10.0)])
def test_it_is_the_peak_of_the_response_to_the_sampled_sweep(Q, speed):
    f, step = 100.0, 2e-4
    t = np.arange(0.0, 60.0 / speed, step)
    phase = 2.0 * np.pi * (70.0 * t + 0.5 * speed * t**2)  # through 100 Hz to 130 Hz
    _, _, pseudo = shock_response_spectrum(np.sin(phase), step, [f], Q)
    # 50 samples a period, and the frequency moves while the resonance builds up
    assert sweep_build_up(Q, f, speed) == pytest.approx(float(pseudo[0]) / Q, rel=0.01)


def test_a_slow_sweep_reaches_the_steady_state():
    assert sweep_build_up(100.0, 100.0, 1e-4) == pytest.approx(1.0, rel=1e-6)
