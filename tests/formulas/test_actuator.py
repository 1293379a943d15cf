"""An actuator against flexures: the numbers of Monti (2014), chapters 1 and 2, and its limits."""

import pytest

from flexcli.formulas.handbook.actuator import (
    actuator_stroke,
    drive_for_frequency,
    thermal_stroke,
)

CMBP03 = {"F_b": 5.5, "s_0": 85e-6}
"""Section 1.2.4: ±85 µm free, 5.5 N blocked."""


def test_the_actuator_of_the_large_nanopositioner_reaches_what_tables_1_1_and_1_2_print():
    # ±57 µm as designed leave the flexures 32 N/mm; ±50 µm as required would let them have 45
    k_T = actuator_stroke(**CMBP03, k=1.0).k_T
    stiffness = {stroke: k_T * (85e-6 / stroke - 1.0) for stroke in (57e-6, 50e-6)}
    for stroke, k in stiffness.items():
        found = actuator_stroke(**CMBP03, k=k)
        assert found.stroke == pytest.approx(stroke)
        assert found.force == pytest.approx(5.5 * (1.0 - stroke / 85e-6))
    assert [round(k / 1e3) for k in stiffness.values()] == [32, 45]


def test_without_flexures_it_goes_its_free_stroke_and_against_a_wall_has_its_blocking_force():
    assert actuator_stroke(**CMBP03, k=1e-6).stroke == pytest.approx(85e-6)
    assert actuator_stroke(**CMBP03, k=1e12).force == pytest.approx(5.5)


def test_most_work_is_done_on_flexures_as_stiff_as_the_actuator():
    k_T = 5.5 / 85e-6

    def work(k):
        found = actuator_stroke(**CMBP03, k=k)
        return found.force * found.stroke

    assert work(k_T) > max(work(0.9 * k_T), work(1.1 * k_T))
    assert work(k_T) == pytest.approx(5.5 * 85e-6 / 4.0)


def test_twice_the_frequency_takes_four_times_the_force():
    # section 2.2: "by a factor of 2, the force required increases by factor of 4"
    assert drive_for_frequency(F=1.0, ratio=2.0) == pytest.approx(4.0)


def test_heat_moves_a_free_stage_by_the_difference_in_expansion_and_a_held_one_not():
    heat = {"alpha": -5e-6, "alpha_frame": 23.6e-6, "L": 20e-3, "dT": 20.0, "k_T": 6e7}
    assert thermal_stroke(**heat, k=1e-3) == pytest.approx(-28.6e-6 * 20e-3 * 20.0)
    assert thermal_stroke(**heat, k=1e15) == pytest.approx(0.0, abs=1e-12)
    assert thermal_stroke(**{**heat, "alpha": 23.6e-6}, k=1e6) == 0.0
