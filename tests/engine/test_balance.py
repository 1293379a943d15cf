"""The verb balance on the exercise: its printed numbers, and what it adds to them."""

from itertools import product
from pathlib import Path

import numpy as np
import pytest
import yaml
from judging import check_as_printed

from flexcli.engine.balance import balance
from flexcli.parts.design import DesignSpec
from flexcli.results import Status
from flexcli.spec.load import load

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def exercise():
    return load(EXAMPLES / "force-balanced-stage" / "flexure.yaml").part


@pytest.fixture(scope="module")
def result(exercise):
    return balance(exercise, "flexure.yaml")


def changed(exercise, **mechanism):
    spec = yaml.safe_load((EXAMPLES / "force-balanced-stage" / "flexure.yaml").read_text())
    spec["mechanism"] = {**spec["mechanism"], **mechanism}
    spec["material"] = {"youngs_modulus": "114 GPa", "tensile_strength": "900 MPa",
                        "fatigue_amplitude": {"value": "500 MPa", "cycles": 1e7}}  # fmt: skip
    spec["cases"].pop("take-off")
    spec["requirements"] = {"fatigue": 2.5}
    spec["balance"].pop("asd")
    return DesignSpec.model_validate(spec)


def test_the_coupling_is_gone_to_rounding(result):
    values = result.values
    assert abs(values["tau_coupling"].value) < 1e-12 * values["tau_coupling_init"].value


def test_before_balancing_the_coupling_is_that_of_the_bodies(result):
    expected = 68.1223e-3 + 2 * 17.138708e-3 * 10.411598e-3 / 20e-3
    assert result.values["tau_coupling_init"].value == pytest.approx(expected, rel=1e-12)


def test_the_transfer_function_before_is_the_source_s_and_after_is_zero(result):
    k, m, tau = (result.values[name].value for name in ("k_eq", "m_eq_init", "tau_coupling_init"))
    for row in result.balance.transfer:
        omega_2 = (2 * 3.141592653589793 * row.frequency) ** 2
        assert row.init == pytest.approx(tau / k / (omega_2 * m / k - 1.0), rel=1e-12)
        assert abs(row.final) < 1e-12 * abs(row.init)
        assert abs(row.init_damped) <= abs(row.init)


def test_pivot_forces_are_those_of_part_ii(result):
    assert round(result.values["F_1"].value) == 641
    assert result.values["F_1"].value > result.values["F_2"].value


def test_the_ideal_stage_is_balanced_over_its_whole_stroke(result):
    before = result.values["tau_coupling_init"].value
    rows = {row.name: row for row in result.balance.over_stroke}
    for name in ("tau_x_final", "tau_y_final"):
        assert abs(rows[name].at_stroke) < 1e-12 * before
    assert abs(rows["tau_y_init"].at_stroke) > 0.01 * before


def test_the_shift_of_its_pivots_is_what_small_angles_hide(result):
    assert "pivot-shift" in [note.code for note in result.warnings]
    rows = {row.name: row for row in result.balance.over_stroke}
    row = rows["tau_x_final, pivots shift alike"]
    assert row.at_stroke == pytest.approx(-row.orders[0] + row.orders[1] - row.orders[2], rel=1e-4)


def test_tolerances_add_by_squares_below_the_worst_case(result):
    values = result.values
    effects = [term.effect for term in result.balance.sensitivities]
    assert values["tau_rss"].value == pytest.approx(sum(e**2 for e in effects) ** 0.5)
    assert sum(effects) < values["tau_worst"].value < 1.01 * sum(effects)


def test_the_rms_after_balancing_is_that_of_the_residual(result):
    x = {name: value.value for name, value in result.values.items() if name.startswith("x_rms")}
    assert x["x_rms_final"] < x["x_rms_rss"] < x["x_rms_worst"] < 0.01 * x["x_rms_init"]


def test_gravity_pulls_before_and_not_after(result):
    rows = {(row.axis, row.mounted): row for row in result.balance.gravity}
    tau = result.values["tau_coupling_init"].value
    assert rows["x", "before"].at_rest == pytest.approx(tau * 20e-3 * 9.80665, rel=1e-12)
    assert rows["y", "before"].stiffness == pytest.approx(tau * 9.80665 / 20e-3, rel=1e-12)
    assert all(abs(rows[axis, "after"].at_rest) < 1e-15 for axis in "xyz")


def test_a_counter_rotating_body_of_the_stated_inertia_would_stop_the_torque(result):
    m_eq = result.values["m_eq_final"].value
    assert result.values["J_counter"].value == pytest.approx(m_eq * 20e-3**2, rel=1e-12)


def test_beyond_its_package_the_design_is_infeasible_and_fails_its_check(exercise):
    body = {"mass": "35.565044 g", "arm": {"free": ["0 mm", "20 mm"]}, "inertia": "1e-6 kg*m^2"}
    design = changed(exercise, **{"balance-1": body, "balance-3": body})
    found = balance(design, "flexure.yaml")
    assert found.status is Status.INFEASIBLE
    assert found.balance.outcome == "infeasible"
    checked = check_as_printed(design, design.fixed_sizes(), "flexure.yaml")
    assert checked.status is Status.FAIL
    assert "not-balanced" in [note.code for note in checked.warnings]


def test_a_given_arm_that_misses_the_bound_fails(exercise):
    body = {"mass": "35.565044 g", "arm": "24 mm", "inertia": "1e-6 kg*m^2"}
    design = changed(exercise, coupling="0.1 %", **{"balance-1": body, "balance-3": body})
    found = balance(design, "flexure.yaml")
    assert found.status is Status.FAIL
    assert found.balance.outcome == "nothing is free"


def test_one_side_only(exercise):
    design = changed(exercise, **{"balance-3": None})
    found = balance(design, "flexure.yaml")
    assert found.status is Status.PASS
    assert found.values["l_bal_1"].value == pytest.approx(2 * 24.1716e-3, rel=1e-5)
    assert "l_bal_3" not in found.values


def test_without_stiffness_the_stage_still_balances_and_follows_as_a_free_mass(exercise):
    design = changed(exercise, **{"pivot-stiffness": "0 N*m/rad", "coupling": "10 %"})
    found = balance(design, "flexure.yaml")
    assert found.values["f_final"].value == 0.0
    row = found.balance.transfer[0]
    tau, m = found.values["tau_coupling"].value, found.values["m_eq_final"].value
    assert row.final == pytest.approx(tau / m / (2 * 3.141592653589793 * row.frequency) ** 2)


def test_with_free_blades_there_is_a_balance_and_no_frequency(exercise):
    extent = type(exercise.geometry.h).model_validate("free")
    geometry = exercise.geometry.model_copy(update=dict.fromkeys(("h", "l", "b"), extent))
    found = balance(exercise.model_copy(update={"geometry": geometry}), "flexure.yaml")
    assert found.values["l_bal"].value == pytest.approx(24.1716e-3, rel=1e-5)
    assert "f_final" not in found.values
    assert found.balance.transfer == ()
    assert "no-stiffness" in [note.code for note in found.warnings]


def test_the_linear_stage_sags_as_in_exercise_12_a():
    design = load(EXAMPLES / "linear-stage" / "flexure.yaml").part
    values = balance(design, "flexure.yaml").values
    assert round(values["sag_x"].value * 1e3, 1) == 11.4
    assert round(values["f_0"].value, 2) == 4.68
    assert values["k_eq"].value == pytest.approx(864.0)


def test_the_rotary_stage_couples_to_the_rotation_of_its_base():
    design = load(EXAMPLES / "mercury-three-blade-pivot" / "flexure.yaml").part
    sizes = {"h": "250 um", "l": "80 mm", "b": "30 mm"}
    extent = type(design.geometry.h)
    geometry = design.geometry.model_copy(
        update={name: extent.model_validate(size) for name, size in sizes.items()}
    )
    found = balance(design.model_copy(update={"geometry": geometry}), "flexure.yaml")
    assert found.balance.motion == "rotation"
    assert found.values["tau_coupling"].value == found.values["m_eq"].value == 1.72e-4
    assert round(found.values["f_0"].value, 1) == 10.0


@pytest.mark.parametrize(
    ("arms", "com", "arm"), [((12.0, 9.0), 1e-3, 0.5e-3), ((30.0, 40.0), 0.5e-3, 1e-3)]
)
def test_tolerances_of_an_unbalanced_stage_add_to_what_it_couples_already(exercise, arms, com, arm):
    """τ = m_2 + Σ m s/H, an arm on the other side: from every corner of the tolerances."""
    body = {"inertia": "1e-6 kg*m^2", "mass": "30 g"}
    sides = {f"balance-{i}": {**body, "arm": f"{a} mm"} for i, a in zip((1, 3), arms, strict=True)}
    found = changed(exercise, **sides, coupling=None)
    off = {"mass": 2e-3, "com": com, "arm": arm, "height": 0.0}
    tolerances = found.balance.tolerances.model_copy(update=off)
    asked = found.balance.model_copy(update={"tolerances": tolerances})
    values = balance(found.model_copy(update={"balance": asked}), "flexure.yaml").values

    masses = np.array([68.1223e-3, 17.138708e-3, 17.138708e-3, 30e-3, 30e-3])
    places = np.array([20.0, 10.411598, 10.411598, -arms[0], -arms[1]]) * 1e-3
    steps = np.array([2e-3] * 5 + [0.0] + [com] * 2 + [arm] * 2)

    def coupling(change):
        return float((masses + change[:5]) @ (places + change[5:])) / 20e-3

    nominal = coupling(np.zeros(10))
    assert abs(nominal) > 0.01
    assert values["tau_coupling"].value == pytest.approx(nominal, rel=1e-9)
    worst = max(abs(coupling(np.array(c) * steps)) for c in product([-1.0, 1.0], repeat=10))
    # products of a mass's and a length's tolerance may lessen the worst; all are counted on top
    most = worst + 2.0 * 2e-3 * (2.0 * com + 2.0 * arm) / 20e-3
    assert worst * (1.0 - 1e-9) <= values["tau_worst"].value <= most
    # of a product, the middle difference is its derivative
    alone = [(coupling(d) - coupling(-d)) / 2.0 for d in np.diag(steps)]
    expected = np.hypot(nominal, np.linalg.norm(alone))
    assert values["tau_rss"].value == pytest.approx(expected, rel=1e-9)
