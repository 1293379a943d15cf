import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.rigid_motion import (
    axes_about_z,
    motion_along,
    motion_at,
)

coordinates = st.floats(-2.0, 2.0)
vectors = st.tuples(coordinates, coordinates, coordinates)
seeds = st.integers(0, 2**32 - 1)


def random_axes(seed):
    Q, _ = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return Q * np.linalg.det(Q)


@given(r=vectors, θ=vectors)
def test_motion_elsewhere_is_that_of_a_small_turn_of_the_body(r, θ):
    # p + θ × r + o(θ): the exact turn by Rodrigues' formula, differenced
    angle, step = np.linalg.norm(θ) or 1.0, 1e-6
    n = np.array(θ) / angle
    W = np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])

    def turned(a):
        return (np.eye(3) + np.sin(a) * W + (1 - np.cos(a)) * W @ W) @ r

    rate = (turned(step) - turned(-step)) / (2 * step) * angle
    found = motion_at(r) @ np.concatenate([np.zeros(3), θ])
    np.testing.assert_allclose(found, [*rate, *θ], atol=1e-8)


@given(r=vectors, s=vectors)
def test_going_on_is_going_there_at_once(r, s):
    both = motion_at(np.add(r, s))
    np.testing.assert_allclose(motion_at(s) @ motion_at(r), both, atol=1e-14)


def test_turn_about_z_leaves_z():
    axes = axes_about_z(np.array([0.3, -2.0]))
    np.testing.assert_allclose(axes @ axes.swapaxes(-1, -2), [np.eye(3)] * 2, atol=1e-15)
    np.testing.assert_allclose(axes[:, 2], [[0, 0, 1]] * 2)
    np.testing.assert_allclose(axes[0, 0], [np.cos(0.3), np.sin(0.3), 0])


@pytest.mark.parametrize(
    "axes", [2.0 * np.eye(3), np.diag([1.0, 1.0, -1.0]), [[1, 0, 0], [1, 0, 0], [0, 0, 1]]]
)
def test_axes_that_are_no_frame_are_refused(axes):
    with pytest.raises(ValueError, match="orthonormal rows"):
        motion_along(axes)
