"""Life under a random stress through a material's S-N data."""

from math import gamma, sqrt

import pytest

from flexcli.parts.material import Material, MissingProperty
from flexcli.parts.vibration_life import life_under, sn_law

BASQUIN = {"basquin": {"coefficient": "1466 MPa", "exponent": -0.143, "to_cycles": 1e6}}


def material(**fatigue):
    return Material.model_validate({"youngs_modulus": "71.7 GPa", **fatigue})


def narrow(sigma, rate):
    """Return the moments of a nearly single frequency of unit rms sigma [Pa]."""
    m0 = sigma**2
    return (m0, m0 * rate, m0 * rate**2, m0 * rate**4)


def test_basquin_gives_its_own_law():
    k, constant = sn_law(material(sn_amplitudes=BASQUIN))
    assert k == pytest.approx(1 / 0.143)
    # N = ½ (S/σ_f')^(1/b), in MPa
    assert constant == pytest.approx(0.5 * 1466 ** (1 / 0.143))


def test_the_last_line_of_points_gives_the_slope():
    points = {"points": [
        {"cycles": 1e3, "amplitude": "400 MPa"}, {"cycles": 1e5, "amplitude": "200 MPa"},
        {"cycles": 1e7, "amplitude": "150 MPa"},
    ]}  # fmt: skip
    k, constant = sn_law(material(sn_amplitudes=points))
    assert constant * 200.0**-k == pytest.approx(1e5)
    assert constant * 150.0**-k == pytest.approx(1e7)


def test_narrow_band_life_is_the_rayleigh_average():
    k, constant = sn_law(material(sn_amplitudes=BASQUIN))
    sigma, rate = 50e6, 100.0
    lives = life_under(material(sn_amplitudes=BASQUIN), narrow(sigma, rate))
    damage = rate / constant * (sqrt(2.0) * sigma / 1e6) ** k * gamma(1 + k / 2)
    assert lives["narrow-band"] == pytest.approx(1 / damage, rel=1e-9)
    assert lives["dirlik"] == pytest.approx(lives["narrow-band"], rel=0.05)


def test_no_stress_lasts_for_ever():
    lives = life_under(material(sn_amplitudes=BASQUIN), (0.0, 0.0, 0.0, 0.0))
    assert set(lives.values()) == {float("inf")}


def test_without_an_sn_curve_the_missing_field_is_named():
    with pytest.raises(MissingProperty, match="sn_amplitudes"):
        life_under(material(), narrow(1e6, 10.0))


def test_a_stress_ratio_is_brought_to_fully_reversed():
    at_zero = {**BASQUIN, "stress_ratio": 0.0}
    k, constant = sn_law(material(sn_amplitudes=at_zero, tensile_strength="2000 MPa"))
    amplitude = 1466.0 * 2e6**-0.143  # at a million cycles and R = 0, so the mean is as large
    assert (constant / 1e6) ** (1 / k) == pytest.approx(amplitude / (1 - amplitude / 2000.0))


def test_a_standing_tension_shortens_the_life_by_goodmans_factor_to_the_power_k():
    strong = material(sn_amplitudes=BASQUIN, tensile_strength="572 MPa")
    k, _ = sn_law(strong)
    alone, with_mean = (life_under(strong, narrow(30e6, 50.0), mean) for mean in (0.0, 143e6))
    for method, life in alone.items():
        assert with_mean[method] == pytest.approx(life * 0.75**k)


def test_a_tension_as_large_as_the_strength_leaves_no_life():
    strong = material(sn_amplitudes=BASQUIN, tensile_strength="572 MPa")
    assert set(life_under(strong, narrow(1e6, 50.0), 572e6).values()) == {0.0}
