"""Shock response spectra: straight in log-log axes, unknown outside the table."""

import numpy as np
import pytest

from flexcli.formulas.shock import srs_level

ROUNDING = 1e-12


def test_srs_table_is_straight_in_log_log_and_conservative_at_a_step():
    table = ([100, 1000, 1000, 10000], [20.0, 200.0, 500.0, 500.0])
    asked = srs_level([100, 316.22776601683796, 1000, 5000], *table)
    np.testing.assert_allclose(asked, [20, 63.245553203367585, 500, 500], rtol=ROUNDING)


def test_a_frequency_outside_the_table_is_refused():
    with pytest.raises(ValueError, match="spans 100 to 200 Hz"):
        srs_level(99, [100, 200], [1, 1])
