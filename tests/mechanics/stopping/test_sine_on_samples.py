"""A sine that stands on samples keeps its size between them."""

import numpy as np
import pytest

from flexcli.mechanics.stopping.random_base import with_sine
from flexcli.numerics.signal_pieces import Samples


@pytest.mark.parametrize("per_period", [8.0, 20.0])
def test_straight_lines_between_samples_carry_the_sine_at_its_own_size(per_period):
    f, step = 50.0, 1.0 / (50.0 * per_period)
    found = with_sine(Samples(np.zeros(int(100 * per_period) + 1), step), 2.0, f, 0.7)
    ends = step * np.arange(found.values.size)
    t = np.linspace(0.0, ends[-1], 200_001)[:-1]
    line = np.interp(t, ends, found.values)
    part = 2.0 * np.mean(line * np.exp(-1j * (2.0 * np.pi * f * t + 0.7 - np.pi / 2.0)))
    assert part.real == pytest.approx(2.0, rel=1e-6)
    assert abs(part.imag) < 1e-6
