"""Steinberg's three bands, as printed."""

import pytest
from stresses import ROUNDING

from flexcli.formulas.spectral_moments import Moments
from flexcli.formulas.steinberg import steinberg_damage_rate


def test_steinberg_counts_three_bands_as_printed():
    moments = Moments(4.0, 400.0, 4e4, 4e8)
    by_hand = 100.0 * (0.683 * 2**6.4 + 0.271 * 4**6.4 + 0.0433 * 6**6.4) / 1e12
    assert float(steinberg_damage_rate(moments, 6.4, 1e12)) == pytest.approx(by_hand, rel=ROUNDING)
