import numpy as np
import pytest

from flexcli.mechanics.stopping.random_base import random_samples

PROFILE = ([20.0, 60.0, 100.0], [0.5, 2.0, 2.0])


def test_the_joined_lines_have_the_density_of_the_profile():
    duration, finer = 4.0, 64
    found = random_samples(*PROFILE, duration=duration, generator=np.random.default_rng(3))
    count = found.values.size - 1
    t = np.arange(count * finer) / finer
    joined = np.interp(t, np.arange(count + 1), found.values)
    density = 2 * np.abs(np.fft.rfft(joined) / joined.size) ** 2 * duration
    lines = np.arange(density.size) / duration
    inside = (lines >= 20.0) & (lines <= 100.0)
    expected = np.exp(np.interp(np.log(lines[inside]), *np.log(PROFILE)))
    np.testing.assert_allclose(density[inside], expected, rtol=1e-3)
    below = lines < 20.0
    assert density[below].max() < 1e-12


def test_the_same_seed_gives_the_same_signal_and_another_one_does_not():
    def values(seed):
        return random_samples(*PROFILE, duration=2.0, generator=np.random.default_rng(seed)).values

    np.testing.assert_array_equal(values(1), values(1))
    assert not np.array_equal(values(1), values(2))


def test_too_few_samples_per_period_are_refused():
    with pytest.raises(ValueError, match="at least 4"):
        random_samples(*PROFILE, duration=1.0, generator=np.random.default_rng(1), oversampling=2.0)
