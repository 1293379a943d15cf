"""Numbers side by side in one register against the same numbers one at a time."""

import math

import numpy as np
import pytest

numba = pytest.importorskip("numba")

pytestmark = pytest.mark.slow  # what uses lanes is compiled first

EPSILON = np.finfo(float).eps


def test_a_turn_has_all_its_digits_small_and_large():
    from flexcli.numerics.lanes import LANES, at, put, versed

    @numba.njit
    def both(angles, found):
        for i in range(angles.shape[0]):
            versine, sine = versed(at(angles, i))
            put(found, (i, 0), versine)
            put(found, (i, 1), sine)

    rng = np.random.default_rng(1)
    size = np.concatenate(
        [10.0 ** rng.uniform(-12.0, 0.0, 4 * LANES), rng.uniform(1, 40, 4 * LANES)]
    )
    angles = (size * rng.choice([-1.0, 1.0], size.size)).reshape(-1, LANES)
    found = np.empty((angles.shape[0], 2, LANES))
    both(angles, found)
    for angle, versine, sine in zip(angles.flat, found[:, 0].flat, found[:, 1].flat, strict=True):
        # of 1 − cos by the half angle, which the sine of the standard library takes exactly
        expected = 2.0 * math.sin(angle / 2.0) ** 2
        # near a zero of sine or versine at a large angle one digit of the angle itself is left
        last = 4.0 * EPSILON * (abs(angle) if abs(angle) > 1.0 else 0.0)
        assert versine == pytest.approx(expected, rel=4.0 * EPSILON, abs=last)
        assert sine == pytest.approx(math.sin(angle), rel=4.0 * EPSILON, abs=last)
