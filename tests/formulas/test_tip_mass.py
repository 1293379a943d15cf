"""A massless blade with a body beyond its end: limits and a generalised eigenvalue problem."""

from math import pi, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.handbook.tip_mass import massless_frequencies

sizes = st.floats(1e-2, 10.0)
offsets = st.floats(-1.0, 3.0)
inertias = st.floats(1e-4, 10.0)


@given(sizes, sizes, offsets, inertias)
def test_frequencies_are_the_eigenvalues_of_stiffness_and_mass(L, m, c, J):
    K = np.array([[12.0, -6.0 * L], [-6.0 * L, 4.0 * L**2]]) / L**3
    M = np.array([[m, m * c], [m * c, J + m * c**2]])
    for f in massless_frequencies(E=1.0, I=1.0, L=L, m=m, c=c, J=J):
        # singular, measured in its own size: an eigenvalue solver loses digits of the fast mode
        inertial = (2 * pi * f) ** 2 * M
        (a, b), (_, d) = K - inertial
        size = K[0, 0] * (K[1, 1] + inertial[1, 1])
        assert a * d == pytest.approx(b**2, rel=1e-8, abs=1e-8 * size)


@given(sizes, sizes)
def test_point_mass_at_the_end_is_the_springs(L, m):
    f_1, f_2 = massless_frequencies(E=1.0, I=1.0, L=L, m=m)
    assert f_1 == pytest.approx(sqrt(3.0 / L**3 / m) / (2 * pi), rel=1e-12)
    assert np.isinf(f_2)


@given(sizes, sizes, st.floats(0.01, 3.0), inertias)
def test_offset_and_inertia_lower_the_frequency(L, m, c, J):
    plain, _ = massless_frequencies(E=1.0, I=1.0, L=L, m=m)
    assert massless_frequencies(E=1.0, I=1.0, L=L, m=m, c=c)[0] < plain
    assert massless_frequencies(E=1.0, I=1.0, L=L, m=m, J=J)[0] < plain


def test_arrays_equal_elements():
    c = np.array([0.0, 0.5, 2.0])
    together = np.array(massless_frequencies(E=1.0, I=1.0, L=1.0, m=1.0, c=c, J=0.1))
    single = [massless_frequencies(E=1.0, I=1.0, L=1.0, m=1.0, c=s, J=0.1) for s in c]
    assert together == pytest.approx(np.array(single).T, rel=1e-15)
