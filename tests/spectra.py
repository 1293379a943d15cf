"""Spectral densities for tests: a published profile, random profiles, oscillators on them."""

import numpy as np
from hypothesis import strategies as st

from flexcli.parts.asd import ASDProfile

GEVS = ([20, 50, 800, 2000], [0.026, 0.16, 0.16, 0.026])
WORKMANSHIP = ([20, 80, 500, 2000], [0.01, 0.04, 0.04, 0.01])

qualities = st.one_of(
    st.floats(np.log10(0.5), 6).map(lambda x: float(10**x)).map(lambda q: max(q, 0.5)),
    st.sampled_from([0.5, 1 / np.sqrt(2), 1.0, 100.0, 1e6]),
)


@st.composite
def profiles(draw, scale="log"):
    count = draw(st.integers(2, 5))
    ratios = draw(st.lists(st.floats(1.001, 20), min_size=count - 1, max_size=count - 1))
    levels = draw(st.lists(st.floats(1e-4, 1e2), min_size=count, max_size=count))
    frequency = draw(st.floats(1, 100)) * np.cumprod([1.0, *ratios])
    if scale == "linear" and draw(st.booleans()):
        frequency[0] = 0.0
    if draw(st.booleans()):
        at = draw(st.integers(0, count - 1))
        frequency = np.insert(frequency, at, frequency[at])
        levels.insert(at, draw(st.floats(1e-4, 1e2)))
    return frequency, np.array(levels)


@st.composite
def lines(draw, zero=False):
    """Give a profile without steps, from 0 Hz and level 0 if asked."""
    count = draw(st.integers(2, 6))
    ratios = draw(st.lists(st.floats(1.0001, 30), min_size=count - 1, max_size=count - 1))
    levels = draw(st.lists(st.floats(1e-5, 1e2), min_size=count, max_size=count))
    start = draw(st.floats(0.1, 100))
    frequency = start * np.cumprod([1.0, *ratios])
    if zero:
        frequency, levels = frequency - start, [0.0, *levels[1:]]
    return frequency, np.array(levels)


@st.composite
def oscillators(draw, frequency):
    Q = draw(qualities)
    where = draw(st.sampled_from(["below", "inside", "edge", "beside an edge", "above"]))
    edge = float(draw(st.sampled_from(list(frequency[frequency > 0]))))
    low, high = float(frequency[frequency > 0][0]), float(frequency[-1])
    share = draw(st.floats(0, 1))
    fn = {
        "below": low * 10 ** (-3 * share),
        "inside": low * (high / low) ** share,
        "edge": edge,
        "beside an edge": edge * (1 + (2 * share - 1) / Q / 4),
        "above": high * 10 ** (3 * share),
    }[where]
    return fn, Q


def white_noise(fn, Q, level):
    """Return the rms responses of an oscillator to white noise, in closed form (Crandall 1963)."""
    pseudo, omega = np.sqrt(np.pi / 2 * fn * Q * level), 2 * np.pi * fn
    return {
        "absolute_acceleration": pseudo * np.sqrt(1 + Q**-2),
        "pseudo_acceleration": pseudo,
        "relative_velocity": pseudo / omega,
        "relative_displacement": pseudo / omega**2,
    }


def part(f, g, **more):
    """Return arrays of a profile, in hertz and g²/Hz, as the part that a spec gives.

    Steps at the ends, which a spec must not have, and steps of no height are left out.
    """
    first, last = int(f[0] == f[1]), len(f) - int(f[-1] == f[-2])
    points = []
    for at, level in zip(map(float, f[first:last]), map(float, g[first:last]), strict=True):
        point = {"frequency": f"{at!r} Hz", "level": f"{level!r} g^2/Hz"}
        if not points or points[-1]["frequency"] != point["frequency"]:
            points.append(point)
        elif points[-1]["level"] != point["level"]:
            points.append({**point, "step": True})
    return ASDProfile.model_validate({"points": points, **more})
