"""Decibels: slopes of published profiles, and conversions against each other."""

import numpy as np
import pytest
from spectra import GEVS, WORKMANSHIP

from flexcli.formulas.decibels import (
    db_per_octave_from_slope,
    levels_from_slopes,
    scale_level,
    slope_from_db_per_octave,
)
from flexcli.formulas.spectrum import segment_slopes
from flexcli.formulas.spectrum_integrals import rms

ROUNDING = 1e-13  # some hundred operations in double precision


def test_gevs_levels_follow_from_its_slopes():
    levels = levels_from_slopes(GEVS[0], [6, 0, -6], known_index=2, known_level=0.16)
    np.testing.assert_allclose(levels, GEVS[1], rtol=0, atol=0.0005)


def test_workmanship_slopes_are_3_db_per_octave():
    db = db_per_octave_from_slope(segment_slopes(*WORKMANSHIP))
    np.testing.assert_allclose(db, [3.01, 0, -3.01], atol=0.001)


def test_one_octave_at_m_db_per_octave_changes_the_level_by_m_db():
    low, high = levels_from_slopes([10, 20], [4.5], known_index=0, known_level=2.0)
    assert high == pytest.approx(float(scale_level(low, 4.5)), rel=ROUNDING)


def test_slope_conversions_are_inverse():
    assert float(db_per_octave_from_slope(slope_from_db_per_octave(7.3))) == pytest.approx(7.3)


def test_three_db_is_a_factor_ten_to_the_0_3():
    assert float(scale_level(1.0, 3)) == 10**0.3
    assert rms(GEVS[0], scale_level(GEVS[1], 6)) == pytest.approx(
        rms(*GEVS) * 10**0.3, rel=ROUNDING
    )


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: levels_from_slopes([1, 2], [3, 3], known_index=0, known_level=1), "segments"),
        (lambda: levels_from_slopes([2, 1], [3], known_index=0, known_level=1), "increasing"),
        (lambda: levels_from_slopes([1, 2], [np.inf], known_index=0, known_level=1), "finite"),
        (lambda: levels_from_slopes([1, 2], [3], known_index=2, known_level=1), "known_index"),
        (lambda: levels_from_slopes([1, 2], [3], known_index=0, known_level=0), "positive"),
    ],
)
def test_invalid_arguments_are_refused(call, text):
    with pytest.raises(ValueError, match=text):
        call()
