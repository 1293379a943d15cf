"""Many steps between samples at once: the same as one after another, and bounded between them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from flexcli.numerics.linear_response import respond
from flexcli.numerics.linear_system import second_order_system
from flexcli.numerics.sampled_response import SampledResponse
from flexcli.numerics.signal_pieces import Samples

ROUNDING = 1e-12
"""Relative to the greatest amplitude, after a hundred steps of either."""


def scene(seed, damping, step):
    generator = np.random.default_rng(seed)
    A, b = generator.normal(size=(3, 3)), generator.normal(size=3)
    K = A @ A.T + np.eye(3)
    system = second_order_system(K, {"none": 0.0, "light": 0.02, "heavy": 3.0}[damping] * K)
    y = system.project(*generator.normal(size=(2, 3)))
    return system, system.drive(b), y, Samples(generator.normal(size=101), step)


@settings(max_examples=20, deadline=None)
@given(
    st.integers(0, 2**32 - 1),
    st.sampled_from(["none", "light", "heavy"]),
    st.sampled_from([1e-6, 0.05, 1.0]),
)
def test_the_steps_at_once_are_those_one_after_another(seed, damping, step):
    system, drive, y, base = scene(seed, damping, step)
    flow = SampledResponse(system, drive, step)
    count = min(100, flow.most)
    found = flow.at_samples(y, base.values[: count + 1])
    for n in range(count):
        np.testing.assert_allclose(found[:, n], y, rtol=0, atol=ROUNDING * np.abs(found).max())
        y = respond(system, drive, y, base.line(n)).amplitudes(step)


@pytest.mark.parametrize("damping", ["none", "light", "heavy"])
@pytest.mark.parametrize("step", [0.01, 0.2, 3.0])
@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 2**32 - 1))
def test_between_its_points_an_output_stays_within_its_bound(damping, step, seed):
    system, drive, y, base = scene(seed, damping, step)
    flow = SampledResponse(system, drive, step)
    a = base.values[: min(100, flow.most) + 1]
    states = flow.at_samples(y, a)[:, :-1]
    shares = np.linspace(0.0, 1.0, 65)
    for row in (system.shapes[0], system.shapes[1] * system.roots):  # a deflection, a speed
        values = (row @ flow.within(states, a[:-1], a[1:], shares)).real
        for every in (16, 64):  # points a quarter of a step apart, and its ends alone
            bound = flow.stray(row, states, a[:-1], a[1:], step * every / 64)
            chords = np.stack([np.interp(shares, shares[::every], v[::every]) for v in values])
            slack = ROUNDING * np.abs(values).max()
            assert (np.abs(values - chords).max(axis=1) <= bound + slack).all()
