"""Force limits of a single oscillator on a shaker, whose apparent mass is a closed form."""

import numpy as np
import pytest

from flexcli.formulas.force_limit import force_limit, notch_factor

M, F0, Q = 4.0, 80.0, 30.0


def apparent(f):
    r = f / F0
    return M * (1.0 + r**2 / (1.0 - r**2 + 1j * r / Q))


def test_the_notched_force_is_the_limit_where_there_is_a_notch_and_below_it_elsewhere():
    f, level = np.geomspace(10.0, 1000.0, 400), 0.2
    factor = notch_factor(f, apparent(f), 1.4, M, F0)
    force = factor * level * np.abs(apparent(f)) ** 2
    limit = force_limit(f, level, 1.4, M, F0)
    assert (force <= limit * (1.0 + 1e-12)).all()
    assert force[factor < 1.0] == pytest.approx(limit[factor < 1.0], rel=1e-12)
    assert (factor < 1.0).any()
    assert (factor[f < 20.0] == 1.0).all()


def test_the_notch_at_resonance_is_c_over_q_squared():
    # |M| = M_0 √(1 + Q²) at the resonance
    assert float(notch_factor(F0, apparent(F0), 2.0, M, F0)) == pytest.approx(
        4.0 / (1.0 + Q**2), rel=1e-12
    )


def test_the_limit_rolls_off_by_its_exponent_beyond_the_knee():
    low, high = force_limit([40.0, 160.0], 1.0, 1.5, M, F0, 3.0)
    assert low == pytest.approx((1.5 * M) ** 2)
    assert high == pytest.approx((1.5 * M) ** 2 / 2.0**3)
