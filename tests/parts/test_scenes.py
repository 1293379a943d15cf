"""Scenes: what a case asks of each joint, for a stage of levers and for a payload."""

from math import atan2, cos, pi, sin, sqrt

import numpy as np
import pytest
from strategies import Inconsistent, design, rcc, stage, three_blade

from flexcli.parts.mechanisms import MechanismError
from flexcli.spec.load import load

ROUNDING = 1e-12
SIZED = {"h": "637 um", "l": "17.5 mm", "b": "10 mm"}
G = 9.80665
LEVER = {"mass": "17.138708 g", "com": "10.411598 mm", "inertia": "5.3569824e-6 kg*m^2"}
BALANCE = {"mass": "35.565044 g", "arm": "24.1716 mm", "inertia": "1.1271682e-6 kg*m^2"}


def parallel_stage(**changes):
    return {
        "kind": "parallel-stage",
        "height": "20 mm",
        "solid-1": LEVER,
        "solid-2": {"mass": "68.1223 g"},
        "solid-3": LEVER,
        "balance-1": BALANCE,
        "balance-3": BALANCE,
        **changes,
    }


def scene_of(case, mechanism, requirements=None, geometry=None):
    asked = requirements or {"l/h": {"min": 1}}
    spec = design(geometry or rcc(**SIZED), asked, {"only": case}, mechanism=mechanism)
    return spec.scene("only")


@pytest.fixture(scope="module")
def rocket(request):
    folder = request.config.rootpath / "examples" / "rocket-parallel-stage"
    return load(folder / "flexure.yaml").part


def test_the_stroke_of_a_stage_turns_its_pivots(rocket):
    # exercise 9 part II: θ = x/H ≈ 1.17°
    found = rocket.scene("operation").travel
    assert found == pytest.approx(410e-6 / 20e-3, rel=ROUNDING)
    assert np.degrees(found) == pytest.approx(1.17, abs=0.005)


def test_the_forces_of_the_rocket_are_the_printed_ones(rocket):
    # exercise 9 part II: 251 g, F_3σ ≈ 389 N, F_1 ≈ 641 N
    scene = rocket.scene("take-off")
    values = {name: value.value for name, value in scene.values.items()}
    assert values["g_rms_worst"] / G == pytest.approx(251, abs=0.5)
    assert values["F_3sigma"] == pytest.approx(389, abs=0.5)
    assert values["F_1"] == pytest.approx(641, abs=0.5)
    assert scene.force_name == "F_1"
    assert scene.blade_force == pytest.approx(values["F_1"] / sqrt(2), rel=ROUNDING)


def test_locked_levers_are_beams_on_two_supports():
    scene = scene_of(
        {"acceleration": {"level": "100 g", "axis": "x"}, "lock": "solid-2"}, parallel_stage()
    )
    mass = 17.138708e-3 + 35.565044e-3
    towards_platform = (17.138708e-3 * 10.411598e-3 - 35.565044e-3 * 24.1716e-3) / mass
    F, s = mass * 100 * G, towards_platform / 20e-3
    forces = [scene.values[f"F_{k}"].value for k in (1, 2, 3, 4)]
    expected = [F * (1 - s), -F * s]
    assert s < 0.0  # the balancing mass pulls the centre beyond the base pivot, so F_1 > F
    assert forces == pytest.approx(expected * 2, rel=ROUNDING)
    assert scene.values["F_steady"].value == pytest.approx(F, rel=ROUNDING)
    assert scene.ends == "clamped-clamped"


def test_without_balancing_masses_both_supports_share_the_levers_weight():
    bare = parallel_stage(**{"balance-1": None, "balance-3": None})
    scene = scene_of({"acceleration": {"level": "1 m/s^2", "axis": "x"}, "lock": "solid-2"}, bare)
    lower, upper = (scene.values[name].value for name in ("F_1", "F_2"))
    assert lower + upper == pytest.approx(17.138708e-3, rel=ROUNDING)
    assert upper / (lower + upper) == pytest.approx(10.411598 / 20, rel=ROUNDING)


def test_unequal_levers_are_reported_apart():
    heavy = parallel_stage(**{"solid-3": {**LEVER, "mass": "34 g"}})
    scene = scene_of({"acceleration": {"level": "1 g", "axis": "x"}, "lock": "solid-2"}, heavy)
    assert scene.values["F_steady_solid_3"].value > scene.values["F_steady"].value
    assert scene.values["F_3"].value != scene.values["F_1"].value


def test_equivalent_masses_are_the_printed_ones(rocket):
    # exercise 9 part I, question 4: 104.2 g and 213.7 g
    mechanism = rocket.mechanism
    assert mechanism.equivalent_mass(balanced=False) == pytest.approx(104.2e-3, abs=0.05e-3)
    assert mechanism.equivalent_mass(balanced=True) == pytest.approx(213.7e-3, abs=0.05e-3)


def test_a_steady_acceleration_and_a_load_add_up():
    push = {"load": {"force": "10 N"}, "lock": "solid-2"}
    shake = {"acceleration": {"level": "100 g", "axis": "x"}, "lock": "solid-2"}
    both = scene_of(push | shake, parallel_stage())
    alone = scene_of(shake, parallel_stage())
    assert both.force == pytest.approx(alone.force + 10.0, rel=ROUNDING)
    assert both.blade_force == pytest.approx(both.force / sqrt(2), rel=ROUNDING)


def test_a_free_parallel_stage_refuses_a_force_through_its_pivots():
    with pytest.raises(MechanismError, match="swings") as caught:
        design(
            rcc(**SIZED), {"l/h": {"min": 1}},
            {"x": {"stroke": {"translation": "1 mm"}}}, mechanism=parallel_stage(),
        ).mechanism.free_force(9.81)  # fmt: skip
    assert caught.value.hint == "add lock: solid-2"


@pytest.mark.parametrize("axis", ["y", "z"])
def test_a_steady_acceleration_off_x_acts_on_the_bodies_of_a_locked_stage(axis):
    case = {"acceleration": {"level": "2 m/s^2", "axis": axis}, "lock": "solid-2"}
    found = scene_of(case, parallel_stage())
    assert found.on_bodies
    assert found.accelerations == (tuple(2.0 * (axis == a) for a in "xyz"),)
    assert found.force == 0.0


def test_only_solid_2_can_be_locked():
    with pytest.raises(Inconsistent, match="cannot be locked here"):
        scene_of({"acceleration": {"level": "1 g", "axis": "x"}, "lock": "door"}, parallel_stage())


def test_a_payload_loads_its_joint_with_mass_times_acceleration():
    payload = {"kind": "payload", "mass": "2 kg"}
    along = scene_of({"acceleration": {"level": "3 m/s^2", "axis": "y"}}, payload)
    assert along.force == pytest.approx(6.0, rel=ROUNDING)
    assert along.ends is None
    # along the stroke or the axis it bends the joint, and is no force in its plane
    assert scene_of({"acceleration": {"level": "3 m/s^2", "axis": "z"}}, payload).force == 0.0


@pytest.mark.parametrize("degrees", [0, 20, 90])
def test_the_direction_of_a_load_decides_the_force_in_a_blade(degrees):
    scene = scene_of({"load": {"force": "10 N", "direction": f"{degrees} deg"}}, None)
    a, d = pi / 4, np.radians(degrees)
    assert scene.blade_force == pytest.approx(
        5.0 * (cos(d) / cos(a) + np.sin(d) / np.sin(a)), rel=ROUNDING
    )


def test_a_stage_bears_a_load_along_its_blades_and_gives_way_to_one_across():
    sized = stage(h="0.3 mm", l="50 mm", b="10 mm", blades=4)
    along = scene_of({"load": {"force": "10 N"}}, None, geometry=sized)
    assert (along.blade_force, along.push) == pytest.approx((2.5, 0.0), rel=ROUNDING)
    oblique = scene_of({"load": {"force": "10 N", "direction": "30 deg"}}, None, geometry=sized)
    expected = (2.5 * cos(pi / 6), 10.0 * sin(pi / 6))
    assert (oblique.blade_force, oblique.push) == pytest.approx(expected, rel=ROUNDING)


@pytest.mark.parametrize("geometry", ["pivot", "stage"])
def test_a_wrench_is_the_load_that_has_its_force(geometry):
    """A load is from the axis of symmetry: a pivot's x, the blades of a stage, along −y."""
    sized = rcc(**SIZED) if geometry == "pivot" else stage(h="0.3 mm", l="50 mm", b="10 mm")
    loads = [{"x": "3 N", "y": "4 N"}, {"force": "5 N", "direction": f"{atan2(4, 3)!r} rad"}]
    if geometry == "stage":
        loads[0] = {"x": "4 N", "y": "-3 N"}
    wrench, load = (
        scene_of({key: value}, None, geometry=sized)
        for key, value in zip(("wrench", "load"), loads, strict=True)
    )
    assert wrench.stated == pytest.approx(load.stated, rel=ROUNDING, abs=ROUNDING)
    assert wrench.pushed_by == {"wrench"}


def test_a_load_and_a_wrench_that_cancel_leave_nothing():
    both = scene_of({"load": {"force": "5 N"}, "wrench": {"x": "-5 N"}}, None)
    assert both.force == pytest.approx(0.0, abs=ROUNDING)


def test_a_wrench_out_of_the_plane_is_in_no_stress_of_the_plane():
    scene = scene_of({"wrench": {"x": "5 N", "z": "1 N"}}, None)
    assert scene.force == pytest.approx(5.0, rel=ROUNDING)
    assert not scene.pushed_by


@pytest.mark.parametrize(("axis", "direction"), [("x", 0.0), ("y", pi / 2)])
def test_a_pivot_is_accelerated_along_its_bisector_and_across_it(axis, direction):
    payload = {"kind": "payload", "mass": "2 kg"}
    scene = scene_of({"acceleration": {"level": "3 m/s^2", "axis": axis}}, payload)
    assert scene.forces == ((pytest.approx(6.0, rel=ROUNDING), pytest.approx(direction)),)


def test_a_stage_is_accelerated_along_its_stroke_and_along_its_blades():
    payload, sized = {"kind": "payload", "mass": "2 kg"}, stage(h="0.3 mm", l="50 mm", b="10 mm")
    along, across = (
        scene_of({"acceleration": {"level": "3 m/s^2", "axis": axis}}, payload, geometry=sized)
        for axis in "xy"
    )
    assert (along.push, along.blade_force) == pytest.approx((6.0, 0.0), rel=ROUNDING)
    assert (across.push, across.blade_force) == pytest.approx((0.0, 3.0), rel=ROUNDING)


@pytest.mark.parametrize("kind", ["pivot", "stage"])
def test_components_load_as_a_wrench_of_mass_times_them_does(kind):
    sized = None if kind == "pivot" else stage(h="0.3 mm", l="50 mm", b="10 mm")
    beside = {} if sized is None else {"geometry": sized}
    payload = {"kind": "payload", "mass": "2 kg"}
    case = {"acceleration": {"x": "3 m/s^2", "y": "-1 m/s^2", "z": "4 m/s^2"}}
    accelerated = scene_of(case, payload, **beside)
    pushed = scene_of({"wrench": {"x": "6 N", "y": "-2 N", "z": "8 N"}}, None, **beside)
    assert accelerated.inertial == (pytest.approx(pushed.stated, rel=ROUNDING),)
    assert accelerated.axial_share == pytest.approx(pushed.axial_share, rel=ROUNDING)
    assert (len(accelerated.across_by), accelerated.pushed_by) == (len(pushed.across_by), set())


def test_one_component_is_a_level_along_its_axis():
    payload = {"kind": "payload", "mass": "2 kg"}
    given = ({"level": "3 m/s^2", "axis": "y"}, {"y": "3 m/s^2"}, {"x": "0 g", "y": "3 m/s^2"})
    one, *others = (scene_of({"acceleration": each}, payload) for each in given)
    assert all(each._replace(values={}) == one._replace(values={}) for each in others)


def test_an_acceleration_of_no_size_loads_nothing():
    payload = {"kind": "payload", "mass": "2 kg"}
    still = {"acceleration": {"level": "0 g", "axis": "z"}, "load": {"force": "5 N"}}
    beside = scene_of({"load": {"force": "5 N"}}, payload)
    found = scene_of(still, payload)
    assert (found.loads, found.forces, found.inertial) == (beside.loads, beside.forces, ())


def test_an_acceleration_of_nothing_is_refused():
    with pytest.raises(Inconsistent, match="needs a mass"):
        scene_of({"acceleration": {"level": "1 g", "axis": "x"}}, None)


def test_nearly_parallel_blades_have_no_closed_form_for_a_force_across_them():
    almost = rcc(**(SIZED | {"half_angle": "1e-9 rad"}))
    scene = scene_of({"load": {"force": "1 N", "direction": "5 deg"}}, None, geometry=almost)
    assert "too parallel" in scene.beyond


def test_stroke_and_joint_must_be_of_the_same_motion():
    for mechanism in (None, {"kind": "payload", "mass": "1 kg"}):
        with pytest.raises(Inconsistent, match="motion"):
            scene_of({"stroke": {"translation": "1 mm"}}, mechanism)


def test_frequency_and_sag_of_exercise_12_a():
    sized = stage(h="300 um", l="50 mm", b="10 mm")
    spec = design(
        sized,
        {"sag": {"max": "1 m"}, "frequency": {"min": "1 Hz"}},
        {"weight": {"acceleration": {"level": "9.81 m/s^2", "axis": "x"}}},
        mechanism={"kind": "payload", "mass": "1 kg"},
        material={"youngs_modulus": "200 GPa"},
    )
    limits = {limit.requirement: limit for limit in spec.limits(spec.fixed_sizes())}
    assert limits["frequency"].capacity ** 0.5 == pytest.approx(4.68, abs=0.005)
    assert limits["sag"].demand == pytest.approx(11.4e-3, abs=0.05e-3)


def test_a_rotation_without_inertia_has_no_frequency():
    with pytest.raises(Inconsistent, match="inertia"):
        design(
            three_blade(h="0.25 mm", l="80 mm", b="30 mm"),
            {"frequency": {"min": "1 Hz"}},
            {"x": {"stroke": {"rotation": "1 deg"}}},
            mechanism={"kind": "payload", "mass": "1 kg"},
        )
