"""Life under a random stress through a material's S-N data."""

from math import gamma, inf, log, sqrt

import pytest
from scipy.special import gammainc

from flexcli.parts.material import Material, MissingProperty
from flexcli.parts.vibration_life import life_curve, life_under

BASQUIN = {"basquin": {"coefficient": "1466 MPa", "exponent": -0.143, "to_cycles": 1e6}}


def material(**fatigue):
    return Material.model_validate({"youngs_modulus": "71.7 GPa", **fatigue})


def narrow(sigma, rate):
    """Return the moments of a nearly single frequency of unit rms sigma [Pa]."""
    m0 = sigma**2
    return (m0, m0 * rate, m0 * rate**2, m0 * rate**4)


def law(material):
    """Return k and C of N = C S^-k, S in MPa, of a curve of one line."""
    (n1, s1), (n2, s2) = life_curve(material)
    k = log(n2 / n1) / log(s1 / s2)
    return k, n2 * (s2 / 1e6) ** k


def test_basquin_gives_its_own_law():
    k, constant = law(material(sn_amplitudes=BASQUIN))
    assert k == pytest.approx(1 / 0.143)
    # N = ½ (S/σ_f')^(1/b), in MPa
    assert constant == pytest.approx(0.5 * 1466 ** (1 / 0.143))


def points(*corners):
    return {"points": [{"cycles": n, "amplitude": f"{s} MPa"} for n, s in corners]}


STEEPENING = points((1e3, 500.0), (1e5, 460.0), (1e7, 120.0))
"""A low-cycle plateau, then a steep line: it lies below its last line continued upwards."""


def piecewise(sigma, rate, corners):
    """Return the narrow-band damage per second on lines between corners, continued at both ends.

    In closed form: ∫ aᵏ p(a) da of Rayleigh's density is an incomplete gamma function.
    """
    total, edges = 0.0, [inf, *(s for _, s in corners[1:-1]), 0.0]
    for (n1, s1), (n2, s2), high, low in zip(corners, corners[1:], edges, edges[1:], strict=False):
        k = log(n2 / n1) / log(s1 / s2)
        x_high, x_low = ((s / sigma) ** 2 / 2 for s in (high, low))
        between = gammainc(1 + k / 2, x_high) - gammainc(1 + k / 2, x_low)
        total += (sqrt(2) * sigma) ** k * gamma(1 + k / 2) * between / (n2 * s2**k)
    return rate * total


@pytest.mark.parametrize("sigma", [40.0, 90.0])
def test_a_life_counts_every_line_of_the_curve(sigma):
    corners = [(1e3, 500.0), (1e5, 460.0), (1e7, 120.0)]
    lives = life_under(material(sn_amplitudes=STEEPENING), narrow(sigma * 1e6, 80.0))
    assert 1 / lives["narrow-band"] == pytest.approx(piecewise(sigma, 80.0, corners), rel=1e-6)
    assert "wirsching-light" not in lives  # its correction is fitted to one slope


def test_a_plateau_is_not_passed_by_the_last_line():
    sigma, rate = 150.0, 80.0
    k = log(1e7 / 1e5) / log(460.0 / 120.0)
    line = rate * (sqrt(2) * sigma) ** k * gamma(1 + k / 2) / (1e7 * 120.0**k)
    lives = life_under(material(sn_amplitudes=STEEPENING), narrow(sigma * 1e6, rate))
    assert lives["narrow-band"] < 1 / line  # what the last line alone would promise


def test_steinberg_takes_three_amplitudes_on_the_curve():
    sigma, rate = 100.0, 80.0
    k = log(1e7 / 1e5) / log(460.0 / 120.0)
    cycles = [1e7 * (a / 120.0) ** -k for a in (sigma, 2 * sigma, 3 * sigma)]  # below 460 MPa
    damage = rate * sum(p / n for p, n in zip((0.683, 0.271, 0.0433), cycles, strict=True))
    lives = life_under(material(sn_amplitudes=STEEPENING), narrow(sigma * 1e6, rate))
    assert lives["steinberg"] == pytest.approx(1 / damage, rel=1e-9)


def test_a_level_last_line_is_no_endurance_limit_among_larger_cycles():
    level = material(sn_amplitudes=points((1e4, 300.0), (1e6, 150.0), (1e8, 150.0)))
    falling = material(sn_amplitudes=points((1e4, 300.0), (1e6, 150.0)))
    assert life_under(level, narrow(30e6, 50.0)) == life_under(falling, narrow(30e6, 50.0))


def test_a_curve_ends_at_the_tensile_strength_where_it_would_pass_it():
    steep = points((1e4, 300.0), (1e6, 150.0), (1e7, 120.0))
    known = life_curve(material(sn_amplitudes=steep, tensile_strength="400 MPa"))
    assert known[0] == (0.5, 400e6)
    # continued, the first line stays below a strength of 5 GPa: the curve is not lifted to it
    assert life_curve(material(sn_amplitudes=steep, tensile_strength="5 GPa"))[0] == (1e4, 300e6)


def test_a_curve_without_a_falling_line_has_no_life():
    level = material(sn_amplitudes=points((1e4, 150.0), (1e6, 150.0)))
    with pytest.raises(MissingProperty, match="fall"):
        life_under(level, narrow(30e6, 50.0))


def test_narrow_band_life_is_the_rayleigh_average():
    k, constant = law(material(sn_amplitudes=BASQUIN))
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
    k, constant = law(material(sn_amplitudes=at_zero, tensile_strength="2000 MPa"))
    amplitude = 1466.0 * 2e6**-0.143  # at a million cycles and R = 0, so the mean is as large
    assert (constant / 1e6) ** (1 / k) == pytest.approx(amplitude / (1 - amplitude / 2000.0))


def test_a_standing_tension_shortens_the_life_by_goodmans_factor_to_the_power_k():
    strong = material(sn_amplitudes=BASQUIN, tensile_strength="572 MPa")
    k, _ = law(strong)
    alone, with_mean = (life_under(strong, narrow(30e6, 50.0), mean) for mean in (0.0, 143e6))
    for method, life in alone.items():
        assert with_mean[method] == pytest.approx(life * 0.75**k)


def test_a_tension_as_large_as_the_strength_leaves_no_life():
    strong = material(sn_amplitudes=BASQUIN, tensile_strength="572 MPa")
    assert set(life_under(strong, narrow(1e6, 50.0), 572e6).values()) == {0.0}
