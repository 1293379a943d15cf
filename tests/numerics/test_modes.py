import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.linalg import eigh

from flexcli.numerics.modes import natural_modes, vibration_of

ROUNDING = 1e-9
"""Relative: eigenvalues of random 5 × 5 pencils of condition up to some 1e4."""


def random_pencil(seed, size=5):
    generator = np.random.default_rng(seed)
    A, B = generator.normal(size=(2, size, size))
    return A @ A.T + 0.1 * np.eye(size), B @ B.T + 0.1 * np.eye(size)


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_frequencies_are_those_of_the_generalised_eigenproblem(seed):
    K, M = random_pencil(seed)
    expected = np.sqrt(eigh(K, M, eigvals_only=True))
    np.testing.assert_allclose(natural_modes(K, M).angular, expected, rtol=ROUNDING)


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_shapes_have_unit_modal_mass_and_uncouple_both_matrices(seed):
    K, M = random_pencil(seed)
    modes = natural_modes(K, M)
    shapes = modes.shapes
    np.testing.assert_allclose(shapes.T @ M @ shapes, np.eye(5), atol=1e-9)
    expected = np.diag(modes.angular**2)
    np.testing.assert_allclose(shapes.T @ K @ shapes, expected, atol=1e-8 * expected.max())


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 2**32 - 1), st.booleans())
@example(seed=220, stable=False)  # two growing modes
def test_vibrations_of_a_compliance_are_those_of_the_stiffness_stable_or_not(seed, stable):
    K, M = random_pencil(seed)
    if not stable:
        K -= 1.5 * eigh(K, eigvals_only=True)[0] * np.eye(5)
    expected = eigh(K, M, eigvals_only=True)
    found = vibration_of(M[None], np.linalg.inv(K)[None])
    np.testing.assert_allclose(found.square[0], expected, rtol=1e-6)
    np.testing.assert_allclose(found.shapes[0].T @ M @ found.shapes[0], np.eye(5), atol=1e-6)
    assert (found.frequency[0, 0] > 0.0) == stable


def test_a_coordinate_that_is_held_or_has_no_mass_vibrates_at_no_frequency():
    found = vibration_of(np.diag([2.0, 0.0, 1.0])[None], np.diag([0.5, 3.0, 0.0])[None])
    assert found.frequency[0, 0] == pytest.approx(1.0 / (2.0 * np.pi))
    assert np.isinf(found.square[0, 1:]).all()


def test_a_coordinate_without_mass_has_no_mode():
    modes = natural_modes(np.array([[2.0, -1.0], [-1.0, 1.0]]), np.diag([1.0, 0.0]))
    assert modes.angular.size == 1
    # the massless end follows: the spring to it carries nothing
    assert modes.angular[0] == pytest.approx(1.0)


def test_stiffnesses_of_very_different_size_keep_the_lowest_mode():
    # a soft motion beside one 1e12 times stiffer, as a blade across and along
    modes = natural_modes(np.diag([1.0, 1e12]), np.eye(2))
    assert modes.angular[0] == pytest.approx(1.0, rel=1e-12)


def test_what_nothing_holds_is_refused():
    with pytest.raises(ValueError, match="not positive definite"):
        natural_modes(np.diag([1.0, 0.0]), np.eye(2))
