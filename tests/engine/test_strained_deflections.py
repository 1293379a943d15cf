"""Deflections and sags of joints that a temperature or loads strain: beams under tension."""

from math import sqrt, tan, tanh

import numpy as np
import pytest

import flexcli
from flexcli.engine.joint_models.space_stroke import at_travel, driven_coordinate
from flexcli.engine.models import NamedModel
from flexcli.mechanics.space.layout import SpaceLoad
from flexcli.results import Status, Verdict

E, ALPHA, H, L, REACH = 114e9, 9e-6, 0.4e-3, 20e-3, 30e-3
BRIDGE = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0, yield_strength: 830 MPa,
           density: 1e-3 kg/m^3, thermal_expansion: 9e-6 1/K}}
geometry:
  kind: layout
  bodies: {{st: {{at: [0 mm, 0 mm]}}}}
  blades:
    a: {{between: [ground, st], from: [-30 mm, 0 mm], to: [-10 mm, 0 mm], h: 0.4 mm, b: {b} m}}
    c: {{between: [ground, st], from: [30 mm, 0 mm], to: [10 mm, 0 mm], h: 0.4 mm, b: {b} m}}
  moving: st
  motion: {{translation: 90 deg}}
mechanism: {{kind: payload, mass: 100 g}}
cases:
  work: {{{load}, temperature: {{uniform: {warmer} K, expansion: {{ground: 0 1/K}}}}}}
requirements:
  yield: {{factor: 1e-6}}
  {asked}
"""


def only(asked, warmer, load, b=0.5e-3, model=None):
    """Return the row of what is asked of the bridge, and the whole answer."""
    text = BRIDGE.format(asked=asked, warmer=warmer, load=load, b=b)
    found = flexcli.check(text, model=model)
    return next(row for row in found.checks if row.name.startswith(asked.split(":")[0])), found


def given(row):
    """Return the range of a motion against an upper bound."""
    return [row.capacity / factor for factor in reversed(row.factor_range)]


def softness(force, warmer, I, b):
    """Return how far a force moves a body between two clamped beams under thermal tension."""
    N = -E * b * H * ALPHA * warmer * REACH / L
    k = sqrt(abs(N) / (E * I))
    bent = L - 2.0 / k * (tanh(k * L / 2.0) if N > 0.0 else tan(k * L / 2.0))
    sheared = 2.4 * L / (E * b * H)  # l/(κ G A), G = E/2; its part in the tension is small
    return force / 2.0 * (bent / N + sheared)


@pytest.mark.parametrize("warmer", [-60.0, -20.0, 10.0])
def test_a_wrench_moves_a_strained_joint_as_beams_under_tension(warmer):
    asked = "deflection: {direction: y, max: 1 m}"
    row, _ = only(asked, warmer, "wrench: {y: 10 mN}", 2e-3)
    true = softness(0.01, warmer, 2e-3 * H**3 / 12.0, 2e-3)
    assert row.model == "exact"
    assert row.demand == pytest.approx(true, rel=0.03)
    assert given(row)[0] < true < given(row)[1] < 1.5 * given(row)[0]


@pytest.mark.parametrize("warmer", [-60.0, -20.0, 20.0])
def test_a_strained_joint_sags_across_its_plane_as_beams_under_tension(warmer):
    b = 0.45e-3
    row, _ = only("sag: {max: 1 m}", warmer, "acceleration: {level: 1 m/s^2, axis: z}", b)
    true = softness(0.1, warmer, H * b**3 / 12.0, b)
    assert row.demand == pytest.approx(true, rel=0.03)
    assert given(row)[0] < true < given(row)[1] < 1.5 * given(row)[0]


@pytest.mark.parametrize(
    ("asked", "load", "verdict"),
    [
        ("deflection: {direction: y, max: 1 m}", "wrench: {y: 10 mN}", Verdict.UNDECIDED),
        ("sag: {max: 1 m}", "acceleration: {level: 1 m/s^2, axis: z}", Verdict.FAIL),
    ],
)
def test_no_small_motion_tells_what_a_temperature_that_buckles_a_joint_leaves(asked, load, verdict):
    row, found = only(asked, 100.0, load)
    assert row.verdict is verdict
    assert found.status is not Status.PASS


def test_linear_springs_tell_what_little_strain_changes_and_leave_open_what_much_does():
    asked, load = "deflection: {direction: y, max: 1 m}", "wrench: {y: 10 mN}"
    row, _ = only(asked, -0.5, load, 2e-3, "linear")
    true = softness(0.01, -0.5, 2e-3 * H**3 / 12.0, 2e-3)
    assert given(row)[0] < true < given(row)[1]
    assert only(asked, -20.0, load, 2e-3, "linear")[0].factor_range is None


def test_hinges_that_a_temperature_does_not_strain_give_way_as_at_assembly():
    text = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, thermal_expansion: 9e-6 1/K}}
geometry: {{kind: notch-hinge, e: 0.1 mm, r: 1 mm, b: 2 mm, blocks: 2 mm}}
cases: {{work: {{stroke: {{rotation: 1 mrad}}, wrench: {{z: 10 mN}}{heat}}}}}
requirements: {{deflection: {{direction: z, max: 1 mm}}}}
"""
    cold, warm = (
        flexcli.verdicts(text.format(heat=heat), model="exact").checks[0]
        for heat in ("", ", temperature: {uniform: 1 K}")
    )
    assert warm.demand == pytest.approx(cold.demand, rel=1e-3)
    assert warm.factor_range == pytest.approx(cold.factor_range, rel=0.01)


def test_a_temperature_that_strains_nothing_leaves_deflections_to_the_cheapest_model():
    text = """
flexure: 1
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.3, yield_strength: 830 MPa,
           thermal_expansion: 9e-6 1/K}
geometry: {kind: cantilever, h: 0.2 mm, l: 20 mm, b: 4 mm}
cases: {work: {wrench: {y: 1 mN}, temperature: {uniform: 1 K}}}
requirements: {deflection: {direction: y, max: 1 mm}}
"""
    (row,) = (each for each in flexcli.verdicts(text).checks if each.name.startswith("deflection"))
    assert row.model == "closed-form"
    assert row.verdict is Verdict.PASS


@pytest.mark.parametrize("warmer", [-60.0, -20.0, 10.0])
def test_a_support_is_asked_at_the_temperatures_of_cases_too(warmer):
    asked = "support: {direction: y, min: 1 N/m}"
    row, found = only(asked, warmer, "wrench: {x: 1 mN}", 2e-3)
    cold, warm = (each for each in found.checks if each.name == row.name)
    assert (cold.case, warm.case) == ("", "work")
    assert cold.capacity == pytest.approx(
        1.0 / softness(1.0, -1e-9, 2e-3 * H**3 / 12.0, 2e-3), rel=1e-3
    )
    true = 1.0 / softness(1.0, warmer, 2e-3 * H**3 / 12.0, 2e-3)
    assert warm.model == "exact"
    assert warm.capacity == pytest.approx(true, rel=0.03)
    low, high = warm.factor_range
    assert low < true < high < 1.3 * low


STAGE = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0, yield_strength: 830 MPa,
           density: 1e-3 kg/m^3}}
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 4 mm, blades: 2, spacing: 10 mm}}
mechanism: {{kind: payload, mass: {mass} kg}}
cases: {{work: {{{loads}}}}}
requirements: {{{asked}: {{max: 1 m}}, yield: 1e-6}}
"""
DIRECTED = "deflection: {direction: x, max: 1 m}, yield"
PUSH = 2.0 * 9.8696 * E * 4e-3 * 0.2e-3**3 / 12.0 / 20e-3**2
"""Force along the blades that buckles the stage [N]."""


def pushed(share):
    """Return how far 10 mN move the stage beside a share of what buckles it."""
    I, P = 4e-3 * 0.2e-3**3 / 12.0, share * PUSH / 2.0
    k = sqrt(P / (E * I))
    return 5e-3 * (2.0 / k * tan(k * L / 2.0) - L) / P


def on_stage(loads, share, asked=DIRECTED, model=None):
    text = STAGE.replace(
        "{asked}: {{max: 1 m}}, yield", asked.replace("{", "{{").replace("}", "}}")
    )
    found = flexcli.check(text.format(mass=share * PUSH / 10.0, loads=loads), model=model)
    return next(row for row in found.checks if row.name.startswith(asked.split(":")[0]))


@pytest.mark.parametrize("share", [0.2, 0.7])
@pytest.mark.parametrize(
    "beside",
    [
        "wrench: {{x: 10 mN, y: -{P} N}}",
        "load: {{force: {P} N}}, ends: clamped-clamped, wrench: {{x: 10 mN}}",
        "acceleration: {{level: 10 m/s^2, axis: y}}, wrench: {{x: 10 mN}}",
    ],
)
def test_what_a_wrench_moves_beside_a_push_is_alike_however_that_is_written(beside, share):
    row = on_stage(beside.format(P=share * PUSH), share, model="exact")
    true = pushed(share)
    assert row.demand == pytest.approx(true, rel=0.01)
    assert given(row)[0] < true < given(row)[1] < 1.5 * given(row)[0]


def test_what_a_small_push_changes_is_in_the_range_of_linear_springs():
    beside = "acceleration: {level: 10 m/s^2, axis: y}, wrench: {x: 10 mN}"
    row = on_stage(beside, 0.02, model="linear")
    assert given(row)[0] < pushed(0.02) < given(row)[1]
    assert on_stage(beside, 0.5, model="linear").factor_range is None


@pytest.mark.parametrize("times", [1.2, 50.0])
def test_a_push_that_buckles_a_stage_fails_its_deflection(times):
    beside = f"acceleration: {{level: {10.0 * times} m/s^2, axis: y}}, wrench: {{x: 10 mN}}"
    row = on_stage(beside, 1.0)
    assert row.verdict is Verdict.FAIL
    assert row.factor == pytest.approx(1.0 / times, rel=0.01)


def test_a_push_that_may_buckle_a_stage_is_no_pass_of_its_deflection():
    beside = "acceleration: {level: 10.2 m/s^2, axis: y}, wrench: {x: 10 mN}"
    assert on_stage(beside, 1.0).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("times", [0.5, 3.0, 100.0])
def test_a_push_along_a_guided_blade_fails_where_it_buckles_it(times):
    """A guide keeps its end from turning: π² EI/l², four times that of a free one."""
    h, l, b = 0.1e-3, 40e-3, 2e-3
    force = times * 9.8696 * E * b * h**3 / 12.0 / l**2
    (row,) = flexcli.verdicts(f"""
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0, density: 1 kg/m^3}}
geometry: {{kind: guided-blade, h: {h} m, l: {l} m, b: {b} m}}
cases: {{work: {{wrench: {{y: {force} N}}}}}}
requirements: {{deflection: {{direction: y, max: 1 m}}}}
""").checks
    assert row.verdict is (Verdict.FAIL if times > 1.0 else Verdict.PASS)
    if times > 1.0:
        assert row.factor == pytest.approx(1.0 / times, rel=1e-3)


def test_a_sag_beside_a_push_that_nearly_buckles_a_stage_is_left_open():
    beside = f"acceleration: {{level: 1 m/s^2, axis: x}}, wrench: {{y: -{0.7 * PUSH} N}}"
    asked = "sag: {max: 1 m}, yield"
    assert on_stage(beside, 0.01, asked).verdict is Verdict.UNDECIDED
    assert on_stage("acceleration: {level: 1 m/s^2, axis: x}", 0.01, asked).verdict is Verdict.PASS


@pytest.mark.parametrize("share", [0.02, 0.05, 0.3, 0.5])
def test_a_sag_beside_a_wrench_is_that_of_the_sense_that_pushes(share):
    """A wrench acts either way: it pulls the blades straight, or pushes them."""
    beside = f"acceleration: {{level: 1 m/s^2, axis: x}}, wrench: {{y: {share * PUSH} N}}"
    row = on_stage(beside, 0.01, "sag: {max: 1 m}, yield")
    weight = 0.01 * PUSH / 10.0
    low, high = given(row)
    assert low < pushed(share) * weight / 10e-3 < high
    assert row.verdict is Verdict.PASS


def test_a_body_that_buckles_a_joint_by_its_weight_fails_a_sag_beside_a_small_load():
    beside = "acceleration: {level: 30 m/s^2, axis: y}, wrench: {x: 1 uN}"
    row = on_stage(beside, 1.0, "sag: {max: 1 m}, yield")
    assert row.verdict is Verdict.FAIL
    assert row.factor == pytest.approx(1.0 / 3.0, rel=0.01)


def test_a_column_that_may_buckle_fails_a_deflection_by_the_sense_that_pulls():
    """How far a wrench at 0.97 of Euler's load pushes it nobody knows, but how far it pulls."""
    h, l, b = 0.5e-3, 50e-3, 10e-3
    force = 0.97 * 9.8696 / 4.0 * E * b * h**3 / 12.0 / l**2
    text = f"""
flexure: 1
material: {{{{youngs_modulus: 114 GPa, poisson_ratio: 0, density: 1 kg/m^3}}}}
geometry: {{{{kind: cantilever, h: {h} m, l: {l} m, b: {b} m}}}}
cases: {{{{work: {{{{wrench: {{{{y: {force} N}}}}}}}}}}}}
requirements: {{{{deflection: {{{{direction: y, max: {{most}} m}}}}}}}}
"""
    pulled = force * l / (E * b * h)
    said = {
        share: flexcli.verdicts(text.format(most=share * pulled)).checks[0].verdict
        for share in (0.95, 1.5)
    }
    assert said == {0.95: Verdict.FAIL, 1.5: Verdict.UNDECIDED}


def test_a_stage_that_sags_gives_way_across_its_plane_as_at_a_stroke_as_far():
    text = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0, yield_strength: 830 MPa,
           density: 1e-3 kg/m^3}}
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 10 mm, blades: 2, spacing: 10 mm}}
mechanism: {{kind: payload, mass: 1 kg}}
cases: {{work: {{{moves}, wrench: {{z: 10 mN}}}}}}
requirements: {{deflection: {{direction: z, max: 1 m}}}}
"""
    level = 24.0 * E * 10e-3 * 0.2e-3**3 / 12.0 / 20e-3**3 * 1e-3
    sags = f"acceleration: {{level: {level} m/s^2, axis: x}}"

    def deflection(moves, model):
        checks = flexcli.verdicts(text.format(moves=moves), model=model).checks
        return next(row for row in checks if row.name.startswith("deflection"))

    sagged = deflection(sags, "exact")
    moved = deflection("stroke: {translation: 1 mm}", "exact")
    assert sagged.demand == pytest.approx(moved.demand, rel=0.02)
    assert given(sagged)[0] < moved.demand < given(sagged)[1]
    assert moved.demand > 1.1 * deflection("stroke: {translation: 1 um}", "exact").demand
    assert deflection(sags, "linear").factor_range is None


def test_a_joint_let_go_at_a_stroke_under_what_held_it_there_stays():
    spec = """
    flexure: 1
    material: {youngs_modulus: 200 GPa, poisson_ratio: 0.3}
    geometry: {kind: cross-spring, h: 0.2 mm, l: 20 mm, b: 4 mm, delta: -0.5, half_angle: 45 deg}
    cases: {work: {stroke: {rotation: 0.4 rad}}}
    requirements: {stiffness: {min: 1e-9 N*m/rad}}
    """
    design = flexcli.load(spec).part
    (scene,) = design.scenes()
    ask = design.ask(scene, design.fixed_sizes(), NamedModel(design, "exact").joint_model)
    held = at_travel(ask, 0.4)
    drive, own = held.layout.drive, driven_coordinate(held.layout)
    effort = float(held.reactions.ravel()[own])
    push = SpaceLoad(drive.body, drive.point, (0.0,) * 3, (0.0, 0.0, effort * drive.direction[2]))
    let_go = at_travel(ask, None, loads=(push,), start=held)
    from_rest = at_travel(ask, None, loads=(push,))
    for state in (let_go, from_rest):
        assert state.coordinates == pytest.approx(held.coordinates, rel=1e-4, abs=1e-5)
    assert let_go.iterations < from_rest.iterations


def test_a_force_along_the_width_of_a_guided_blade_softens_it_across_its_thickness():
    """By the square of its share of what turns the blade aside: 6e-4 here, 4e-4 without it."""
    text = """
flexure: 1
material: {youngs_modulus: 70 GPa, poisson_ratio: 0.0}
geometry: {kind: guided-blade, h: 41 um, l: 3.8 mm, b: 1.8 mm}
cases: {work: {wrench: {x: 8 mN, z: -36 mN}}}
requirements: {deflection: {direction: x, max: 1 m}}
"""
    (small, told), (true, known) = (
        (row.demand, np.divide(row.demand, row.factor_range) * row.factor / row.demand)
        for model in ("linear", "exact")
        for row in flexcli.verdicts(text, model=model).checks
        if row.name.startswith("deflection")
    )
    assert true / small - 1.0 > 4.5e-4
    assert small * told[1] <= true * known[1]
    assert true * known[0] <= small * told[0]
    assert told[0] - told[1] < 0.05


@pytest.mark.parametrize("torque", [1.3, 3.2, 6.4])
def test_a_blade_that_a_torque_twists_sags_less_within_what_small_motion_tells(torque):
    text = f"""
flexure: 1
material: {{youngs_modulus: 70 GPa, poisson_ratio: 0.45, density: 2700 kg/m^3}}
geometry: {{kind: guided-blade, h: 0.129 mm, l: 5.14 mm, b: 3.39 mm}}
mechanism: {{kind: payload, mass: 257 g}}
cases: {{work: {{wrench: {{theta_y: {torque} mN*m}}, acceleration: {{level: 0.4 m/s^2, axis: x}}}}}}
requirements: {{sag: {{max: 1 m}}}}
"""
    (small, told), (true, known) = (
        (row.demand, np.divide(row.demand, row.factor_range) * row.factor / row.demand)
        for model in ("linear", "exact")
        for row in flexcli.verdicts(text, model=model).checks
        if row.name.startswith("sag")
    )
    assert true < small
    assert small * told[1] <= true * known[1]
    assert true * known[0] <= small * told[0]
