"""Wirsching and Light's factor on the narrow-band rate."""

from stresses import SPECTRA, spectral_moments

from flexcli.formulas.narrow_band import narrow_band_damage_rate
from flexcli.formulas.wirsching_light import wirsching_light_damage_rate


def test_wirsching_light_lies_below_the_narrow_band_rate():
    for frequency, level in SPECTRA.values():
        moments = spectral_moments(frequency, level)
        assert wirsching_light_damage_rate(moments, 4, 1.0) < narrow_band_damage_rate(
            moments, 4, 1.0
        )
