import numpy as np
import pytest

from flexcli.mechanics.stopping.random_base import random_samples

PROFILE = ([20.0, 60.0, 100.0], [0.5, 2.0, 2.0])


def test_the_joined_lines_have_the_density_of_the_profile():
    duration, finer = 40.0, 8
    found = random_samples(*PROFILE, duration=duration, generator=np.random.default_rng(3))
    count = found.values.size - 1
    t = np.arange(count * finer) / finer
    joined = np.interp(t, np.arange(count + 1), found.values)
    density = 2 * np.abs(np.fft.rfft(joined) / joined.size) ** 2 * duration
    lines = np.arange(density.size) / duration
    inside = (lines >= 20.0) & (lines <= 100.0)
    share = density[inside] / np.exp(np.interp(np.log(lines[inside]), *np.log(PROFILE)))
    # a squared Rayleigh size is exponential: mean 1, variance 1, of 3201 lines
    assert share.mean() == pytest.approx(1.0, abs=4.0 / np.sqrt(share.size))
    assert share.var() == pytest.approx(1.0, abs=4.0 * np.sqrt(8.0 / share.size))
    below = lines < 20.0
    assert density[below].max() < 1e-12


def test_the_mean_square_of_a_stretch_scatters_as_that_of_a_gaussian_signal():
    generator, duration = np.random.default_rng(8), 1.0
    squares = [
        np.mean(random_samples(*PROFILE, duration=duration, generator=generator).values[1:] ** 2)
        for _ in range(400)
    ]
    # its variance is ∫ G² df / T, by each line's own (Bendat & Piersol, section 8.3)
    f = np.linspace(20.0, 100.0, 4001)
    level = np.exp(np.interp(np.log(f), *np.log(PROFILE)))
    expected = np.trapezoid(level**2, f) / duration
    assert np.var(squares) == pytest.approx(expected, rel=4.0 * np.sqrt(2.0 / 400))


def test_the_same_seed_gives_the_same_signal_and_another_one_does_not():
    def values(seed):
        return random_samples(*PROFILE, duration=2.0, generator=np.random.default_rng(seed)).values

    np.testing.assert_array_equal(values(1), values(1))
    assert not np.array_equal(values(1), values(2))


def test_too_few_samples_per_period_are_refused():
    with pytest.raises(ValueError, match="at least 4"):
        random_samples(*PROFILE, duration=1.0, generator=np.random.default_rng(1), oversampling=2.0)
