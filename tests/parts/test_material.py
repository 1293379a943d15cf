"""Materials: strength at a life, stress ratios, and refusing what nobody gave."""

from pathlib import Path

import pytest
from pydantic import ValidationError

import flexcli
from flexcli.parts.material import Material, MissingProperty
from flexcli.spec.shipped import shipped_names, shipped_path

ROUNDING = 1e-12

PART = """\
geometry: {kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 4 mm, spacing: 20 mm, blades: 2}
cases: {a: {stroke: {translation: 0.1 mm}}}
requirements: {yield: 1}
"""


def material(**given):
    return Material.model_validate({"youngs_modulus": "100 GPa", **given})


def test_strength_between_points_of_the_curve_is_log_log():
    points = [{"cycles": 1e4, "amplitude": "400 MPa"}, {"cycles": 1e8, "amplitude": "100 MPa"}]
    strength, where = material(sn_amplitudes={"points": points}).reversed_amplitude(1e6)
    assert strength == pytest.approx(200e6, rel=ROUNDING)
    assert "S-N curve at 1e+06 cycles" in where


def test_basquins_law_is_in_reversals():
    # σ_a = σ_f' (2N)^b
    law = {"coefficient": "1 GPa", "exponent": -0.1, "to_cycles": 1e7}
    strength, _ = material(sn_amplitudes={"basquin": law}).reversed_amplitude(5e5)
    assert strength == pytest.approx(1e9 * 1e6**-0.1, rel=ROUNDING)


def test_the_curve_goes_before_the_single_amplitude():
    points = [{"cycles": 1e4, "amplitude": "400 MPa"}, {"cycles": 1e6, "amplitude": "200 MPa"}]
    both = material(
        sn_amplitudes={"points": points}, fatigue_amplitude={"value": "100 MPa", "cycles": 1e7}
    )
    assert both.reversed_amplitude(1e6)[0] == 200e6
    assert both.reversed_amplitude(1e7)[0] == 100e6


@pytest.mark.parametrize(
    ("given", "field"),
    [
        ({}, "fatigue_amplitude"),
        ({"fatigue_amplitude": {"value": "100 MPa", "cycles": 1e6}}, "sn_amplitudes"),
        (
            {
                "sn_amplitudes": {
                    "basquin": {"coefficient": "1 GPa", "exponent": -0.1, "to_cycles": 1e6}
                }
            },
            "sn_amplitudes",
        ),
    ],
    ids=["nothing", "single", "curve"],
)
def test_a_life_beyond_the_data_is_missing_not_extrapolated(given, field):
    with pytest.raises(MissingProperty) as caught:
        material(**given).reversed_amplitude(1.01e6)
    assert caught.value.field == field


def test_a_shorter_life_keeps_the_single_amplitude_and_says_so():
    single = material(fatigue_amplitude={"value": "100 MPa", "cycles": 1e7})
    strength, where = single.reversed_amplitude(1e5)
    assert strength == 100e6
    assert "kept for 100000" in where


def test_a_pulsating_strength_is_brought_to_full_reversal():
    pulsating = {"value": "300 MPa", "cycles": 1e7, "stress_ratio": 0}
    given = material(fatigue_amplitude=pulsating, tensile_strength="900 MPa")
    # Goodman at R = 0: mean = amplitude
    assert given.reversed_amplitude(1e7)[0] == pytest.approx(300e6 / (1 - 1 / 3), rel=ROUNDING)
    with pytest.raises(MissingProperty, match="tensile_strength"):
        material(fatigue_amplitude=pulsating).reversed_amplitude(1e7)


def test_a_fatigue_strength_whose_mean_reaches_the_tensile_strength_is_refused():
    with pytest.raises(ValidationError, match="reaches the tensile strength"):
        material(
            fatigue_amplitude={"value": "500 MPa", "stress_ratio": 0.5}, tensile_strength="900 MPa"
        )


def test_a_source_without_stress_ratio_is_read_as_fully_reversed():
    assert material(fatigue_amplitude={"value": "100 MPa"}).reversed_amplitude(1e9)[0] == 100e6


def test_placeholders_are_named():
    guess = {"value": "900 MPa", "status": "placeholder"}
    assert material(tensile_strength=guess).placeholders() == ("tensile_strength",)


def test_a_value_with_a_status_must_name_its_source():
    with pytest.raises(ValidationError, match="must name its source"):
        material(tensile_strength={"value": "900 MPa", "status": "measured"})


@pytest.mark.parametrize(
    "given",
    [
        {"yield_strength": "900 MPa", "tensile_strength": "800 MPa"},
        {"yield_strength": "30 GPa", "tensile_strength": "40 GPa"},
    ],
    ids=["out of order", "too strong"],
)
def test_implausible_strengths_are_refused(given):
    with pytest.raises(ValidationError):
        material(**given)


CURVED = [
    name for name in shipped_names("material")
    if "over_temperature" in (shipped_path("material", name) or Path()).read_text()
]  # fmt: skip


@pytest.mark.parametrize("name", CURVED)
def test_shipped_curves_over_temperature_meet_the_values_of_their_handbook(name):
    ours = flexcli.load(f"flexure: 1\nmaterial: {name}\n" + PART).part.material
    room, near = 293.0, 280.0
    # expansion falls towards the cold: from 280 to 293 K it is a little below the mean to 100 °C
    slope = -ours.growth(near - room, room) / (room - near)
    assert 0.8 < slope / ours.thermal_expansion.value < 1.02
    contracted = [ours.growth(T - room, room) for T in (240.0, 160.0, 80.0)]
    assert 0.0 > contracted[0] > contracted[1] > contracted[2]
    if ours.over_temperature.youngs_modulus is not None:
        ((_, modulus),) = [p for p in ours.over_temperature.youngs_modulus.points if p[0] >= room][
            :1
        ]
        # two laboratories and heats
        assert modulus == pytest.approx(ours.youngs_modulus.value, rel=0.09)
