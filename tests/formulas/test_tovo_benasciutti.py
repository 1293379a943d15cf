"""Tovo and Benasciutti's weight against its printed form."""

import numpy as np
import pytest
from hypothesis import given, settings
from stresses import ROUNDING, spectra

from flexcli.formulas.narrow_band import narrow_band_damage_rate
from flexcli.formulas.tovo_benasciutti import tovo_benasciutti_damage_rate


@given(moments=spectra)
@settings(deadline=None, max_examples=40)
def test_tovo_benasciutti_closed_form_is_the_one_printed(moments):
    k = 4.2
    a1, a2 = float(moments.alpha1), float(moments.alpha2)
    b = (
        (a1 - a2)
        * (1.112 * (1 + a1 * a2 - (a1 + a2)) * np.exp(2.11 * a2) + (a1 - a2))
        / (a2 - 1) ** 2
    )
    factor = tovo_benasciutti_damage_rate(moments, k, 1.0) / narrow_band_damage_rate(
        moments, k, 1.0
    )
    assert float(factor) == pytest.approx(b + (1 - b) * a2 ** (k - 1), rel=ROUNDING)
