"""Response of the modes against single oscillators, statics and the parts that it is made of."""

from math import pi, sqrt

import numpy as np
import pytest

from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.shock import half_sine_sums
from flexcli.formulas.stage import end_stress
from flexcli.parts.asd import RandomVibration
from flexcli.parts.geometries import Blade, Elastic
from flexcli.parts.geometries.leaf_stage import LeafSpringStage
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.mechanisms.parallel_stage import ParallelStage
from flexcli.parts.mechanisms.payload import Payload
from flexcli.parts.response import random_response, shock_peaks
from flexcli.parts.shock import Shock

E = 71.7e9
BLADE = Blade(0.5e-3, 40e-3, 15e-3)
STAGE = LeafSpringStage(kind="leaf-spring-stage", h="0.5 mm", l="40 mm", b="15 mm")
PAYLOAD = Payload(kind="payload", mass="0.5 kg")
LEVER = {"mass": "17 g", "com": "10 mm", "inertia": "5e-6 kg*m^2"}
PARALLEL = ParallelStage.model_validate(
    {
        "kind": "parallel-stage",
        "height": "20 mm",
        "solid-1": LEVER,
        "solid-2": {"mass": "68 g"},
        "solid-3": LEVER,
    }
)
FN = sqrt(float(STAGE.stiffness(Elastic(E), BLADE)) / 0.5) / (2 * pi)

POINTS = [
    {"frequency": "5 Hz", "level": "0.01 g^2/Hz"},
    {"frequency": "100 Hz", "level": "0.1 g^2/Hz"},
    {"frequency": "2000 Hz", "level": "0.02 g^2/Hz"},
]

EXACT = 1e-9
"""Relative: what the response of a single mode agrees to with the single oscillator."""


def vibration(**use):
    return RandomVibration.model_validate({"profile": {"points": POINTS}, "q": 20, **use})


def stage():
    return PAYLOAD.structure(STAGE, Elastic(E), BLADE, None)


def test_a_stage_along_its_stroke_is_one_oscillator():
    response = random_response(stage(), vibration(axis="x"))
    applied = vibration().applied()
    single = oscillator_response(applied.frequency, applied.level, FN, 20.0)
    assert response.outputs["travel"].rms == pytest.approx(
        float(single.relative_displacement), rel=EXACT
    )
    assert response.modes[0].frequency == pytest.approx(FN, rel=EXACT)


def test_the_stress_of_the_travel_is_that_of_the_stroke_formula():
    response = random_response(stage(), vibration(axis="x"))
    travel = response.outputs["travel"].rms
    expected = end_stress(E=E, h=BLADE.h, l=BLADE.l, x=travel)
    assert response.outputs["stress joint"].rms == pytest.approx(expected, rel=EXACT)


def test_independent_axes_add_by_their_squares():
    x, y, both = (
        random_response(stage(), vibration(axis=axis)).outputs["force joint"].rms
        for axis in ("x", "y", "x and y")
    )
    assert both == pytest.approx(sqrt(x**2 + y**2), rel=EXACT)


def test_a_level_raised_by_6_db_doubles_the_response_but_for_rounding_of_the_decibel():
    louder = random_response(stage(), vibration(scale="6 dB")).outputs["travel"].rms
    plain = random_response(stage(), vibration()).outputs["travel"].rms
    assert louder / plain == pytest.approx(10**0.3, rel=EXACT)


def test_modes_that_the_base_does_not_move_run_no_resonance(monkeypatch):
    import flexcli.parts.response as module

    asked = []
    real = module.response_moments

    def watched(**given):
        asked.append(given["angular"].size)
        return real(**given)

    monkeypatch.setattr(module, "response_moments", watched)
    response = random_response(stage(), vibration(axis="x"))
    assert [mode.dynamic for mode in response.modes] == [True, False]
    assert asked == [1, 1]  # the total with one mode, and that mode alone


def test_modes_far_above_the_band_are_lumped_and_cost_at_most_their_share():
    ends = [{"frequency": f, "level": "0.01 g^2/Hz"} for f in ("1 Hz", "80 Hz")]
    low = {"profile": {"points": ends}, "q": 20}
    narrow = RandomVibration.model_validate({**low, "axis": "y"})
    response = random_response(stage(), narrow)
    assert not any(mode.dynamic for mode in response.modes)
    grms = narrow.profile.grms
    # the blades carry the payload's inertia; the mode along them is 14 times above the band
    assert response.outputs["force joint"].rms == pytest.approx(0.5 * grms, rel=0.01)


def test_mode_shares_of_the_mass_add_up_to_all_of_it():
    pivot = RCCPivot(kind="rcc", p="2 mm", half_angle="45 deg", h="0.6 mm", l="17 mm", b="10 mm")
    blade = Blade(0.6e-3, 17e-3, 10e-3)
    for lock in (None, "solid-2"):
        structure = PARALLEL.structure(pivot, Elastic(114e9), blade, lock)
        response = random_response(structure, vibration())
        assert sum(mode.mass_share for mode in response.modes) == pytest.approx(1.0, abs=1e-9)


def test_the_free_parallel_stage_swings_near_its_closed_form():
    # the bodies are rigid and the pivots stiff along their blades: a part in a thousand apart
    pivot = RCCPivot(kind="rcc", p="2 mm", half_angle="45 deg", h="0.3 mm", l="17 mm", b="10 mm")
    blade = Blade(0.3e-3, 17e-3, 10e-3)
    mode = PARALLEL.mode(pivot.stiffness(Elastic(114e9), blade), pivot)
    closed = sqrt(float(mode.stiffness) / mode.mass) / (2 * pi)
    structure = PARALLEL.structure(pivot, Elastic(114e9), blade, None)
    response = random_response(structure, vibration())
    assert response.modes[0].frequency == pytest.approx(closed, rel=2e-3)


@pytest.mark.parametrize("duration", ["0.5 ms", "5 ms", "50 ms"])
def test_a_half_sine_moves_a_stage_as_one_oscillator(duration):
    shock = Shock.model_validate(
        {"half-sine": {"acceleration": "50 g", "duration": duration}, "q": 10, "axis": "x"}
    )
    assert shock.half_sine is not None
    pulse, alone = shock.half_sine, [np.ones((1, 1, 1))]
    (peak,) = half_sine_sums(alone, [FN], 10.0, pulse.acceleration, pulse.duration)
    expected = peak / (2 * pi * FN) ** 2
    assert shock_peaks(stage(), shock)["travel"] == pytest.approx(expected, rel=EXACT)


def test_a_velocity_shock_deflects_a_stage_as_the_thesis_says():
    shock = Shock.model_validate({"velocity": "1 m/s", "axis": "x"})
    expected = 1.0 / (2 * pi * FN)  # Monti 2014: Δd = V/(2π f_n)
    assert shock_peaks(stage(), shock)["travel"] == pytest.approx(expected, rel=EXACT)


def test_a_spectrum_that_does_not_reach_a_mode_is_refused():
    shock = Shock.model_validate(
        {
            "srs": [
                {"frequency": "1 Hz", "acceleration": "1 g"},
                {"frequency": "2 Hz", "acceleration": "2 g"},
            ]
        }
    )
    with pytest.raises(ValueError, match="the spectrum ends at 2 Hz"):
        shock_peaks(stage(), shock)


def test_no_oscillator_exceeds_the_largest_half_sine_response():
    shock = Shock.model_validate(
        {"half-sine": {"acceleration": "1 m/s^2", "duration": "10 ms"}, "q": 1e6}
    )
    frequencies = np.geomspace(5.0, 1000.0, 2000)
    alone = [np.ones((1, 1, 1))]
    worst = max(shock.peaks(alone, f)[0] for f in np.split(frequencies, frequencies.size))
    assert worst == pytest.approx(shock.worst_acceleration(), rel=1e-3)
    assert worst <= shock.worst_acceleration() * (1 + 1e-4)


def test_a_stated_pivot_stiffness_is_refused_instead_of_passed_over():
    stated = PARALLEL.model_copy(update={"pivot_stiffness": (1.0, 1.0, 1.0, 1.0)})
    pivot = RCCPivot(kind="rcc", p="2 mm", half_angle="45 deg", h="0.6 mm", l="17 mm", b="10 mm")
    with pytest.raises(MechanismError, match="pivot-stiffness"):
        stated.structure(pivot, Elastic(114e9), Blade(0.6e-3, 17e-3, 10e-3), None)
