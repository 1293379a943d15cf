"""An actuator drives the stroke: its force there against the joint's, by independent routes."""

from math import pi

import pytest
import yaml
from specs_for_tests import parallelogram

import flexcli
from flexcli.engine import drive_values
from flexcli.errors import SpecError
from flexcli.formulas.handbook.actuator import actuator_stroke, thermal_stroke
from flexcli.parts.design import DesignSpec
from flexcli.parts.requirements import Ask, DriveEffort
from flexcli.parts.requirements.as_printed import AsPrinted
from flexcli.results import EXACT, Status, Verdict

BENDER = {"blocking_force": "5.5 N", "free_stroke": "85 um", "drives": "both-ways"}
STAGE = {
    "kind": "leaf-spring-stage", "h": "0.337 mm", "l": "12 mm", "b": "3 mm", "blades": 4,
    "spacing": "3 mm",
}  # fmt: skip
LEVERS = {
    "kind": "parallel-stage", "height": "20 mm",
    "solid-1": {"mass": "10 g", "com": "10 mm", "inertia": "1e-6 kg*m^2"},
    "solid-2": {"mass": "50 g"},
    "solid-3": {"mass": "10 g", "com": "10 mm", "inertia": "1e-6 kg*m^2"},
}  # fmt: skip
TITANIUM = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.34, "thermal_expansion": "8.6e-6 1/K"}


def spec(geometry, stroke, actuator=BENDER, material=TITANIUM, factor=1.2, more=(), **case):
    return yaml.safe_dump(
        {
            "flexure": 1,
            "material": material,
            "geometry": geometry,
            "actuator": actuator,
            "cases": {"work": {"stroke": stroke, **case}},
            "requirements": {"drive": factor},
            **dict(more),
        }
    )


def drive(*of, **more):
    (check,) = (c for c in flexcli.verdicts(spec(*of, **more)).checks if c.name == "drive")
    return check


@pytest.mark.parametrize(("load", "deflection"), [(1.0, 0.30172), (2.0, 0.49346), (10.0, 0.81061)])
def test_the_force_at_a_large_stroke_is_that_of_the_elastica(load, deflection):
    # Mattiasson (1981), cantilever under an end load P l²/EI, to five digits
    E, h, l, b = 200e9, 1e-4, 0.1, 1e-3
    geometry = {"kind": "cantilever", "h": f"{h} m", "l": f"{l} m", "b": f"{b} m"}
    force = load * E * b * h**3 / 12.0 / l**2
    line = {"blocking_force": f"{100 * force} N", "free_stroke": "1 m"}
    stroke = {"translation": [f"{deflection * l / 2} m", f"{deflection * l} m"]}
    material = {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.0}
    found = drive(geometry, stroke, line, material)
    # dP/P over dw/w is up to 8 at the largest load, where 5e-6 is a rounded digit
    assert found.demand == pytest.approx(force, rel=1e-3)
    assert found.capacity == pytest.approx(100.0 * force * (1.0 - deflection * l), rel=1e-9)


def test_what_it_reaches_is_where_both_springs_balance():
    values = flexcli.check(spec(STAGE, {"translation": "50 um"})).values
    told, stiffness = values["s_reached"], values["k_stage"]
    by_springs = actuator_stroke(F_b=5.5, s_0=85e-6, k=stiffness.value)
    assert values["k_T"].value == pytest.approx(by_springs.k_T)
    # a stroke of l/200: what it adds to the stiffness at rest is of order 1e-5
    doubt = told.estimated_error + stiffness.estimated_error + 1e-4
    assert told.value == pytest.approx(float(by_springs.stroke), rel=doubt)


def test_a_drive_that_turns_the_joint_over_reaches_no_stroke():
    """At 5.5 rad its blades would pull it along."""
    pivot = {"kind": "three-blade", "p": "0 mm", "h": "1.37 mm", "l": "67 mm", "b": "200 mm",
             "root_radius": "2.68 mm"}  # fmt: skip
    line = {"blocking_force": "1e6 N", "free_stroke": "10 m", "drives": "both-ways", "arm": "10 mm"}
    steel = {"youngs_modulus": "210 GPa"}
    result = flexcli.check(spec(pivot, {"rotation": "1 mrad"}, line, steel))
    assert "k_T" in result.values
    assert "s_reached" not in result.values


NIMBLE = {"youngs_modulus": "100 GPa", "poisson_ratio": 0.45}
LINE = {"blocking_force": "1e6 N", "free_stroke": "10 m", "drives": "both-ways"}
WIDE = {"h": "0.1 mm", "l": "20 mm", "b": "20 mm"}


def test_no_pivot_is_followed_around_by_a_drive_that_would_turn_it_over_and_over(monkeypatch):
    pivot = {"kind": "cross-spring", "h": "1 mm", "l": "6 mm", "b": "18 mm", "delta": -0.5,
             "half_angle": "45 deg"}  # fmt: skip
    strong = {"blocking_force": "1e6 N", "free_stroke": "10 m", "arm": "10 mm"}
    find, travels = drive_values._at, []

    def followed(actuator, ask, travel):
        travels.append(travel)
        return find(actuator, ask, travel)

    monkeypatch.setattr(drive_values, "_at", followed)
    result = flexcli.check(spec(pivot, {"rotation": ["0 rad", "1 mrad"]}, strong))
    assert "k_T" in result.values
    assert "s_reached" not in result.values
    assert max(travels, default=0.0) < pi


@pytest.mark.parametrize(
    ("geometry", "stroke", "arm", "force", "by_shells", "apart"),
    [
        ({"kind": "leaf-spring-stage", **WIDE, "blades": 2, "spacing": "15 mm"},
         {"translation": "20 um"}, {}, 2.0, 0.0145169, 1.01),
        ({"kind": "rcc", **WIDE, "p": "5 mm", "half_angle": "45 deg"},
         {"rotation": "2 mrad"}, {"arm": "10 mm"}, 4.0, 0.0424808, 1.06),
    ],
    ids=["stage", "pivot"],
)  # fmt: skip
def test_what_pulls_wide_blades_adds_no_more_than_to_beams(
    geometry, stroke, arm, force, by_shells, apart
):
    """Shells of 20 modes, and a string between the ends: 6/5 F x/l."""
    load = {"load": {"force": f"{force} N", "direction": "0 deg"}}
    pulled, alone = (drive(geometry, stroke, {**LINE, **arm}, NIMBLE, **of) for of in (load, {}))
    low, high = pulled.factor_range
    assert low <= pulled.capacity / by_shells <= high
    assert high / low < apart
    if not arm:
        string = 1.2 * force * 20e-6 / 20e-3
        assert pulled.demand - alone.demand == pytest.approx(string, rel=2e-2)


def test_a_stack_does_not_pull_and_a_stroke_beyond_its_own_fails():
    stack = {**BENDER, "drives": "one-way"}
    back = drive(STAGE, {"translation": "50 um"}, stack)
    assert (back.verdict, back.factor) == (Verdict.FAIL, 0.0)
    assert "does not drive" in back.quantity
    assert drive(STAGE, {"translation": ["0 um", "50 um"]}, stack).passed
    assert drive(STAGE, {"translation": ["0 um", "90 um"]}, stack).verdict is Verdict.FAIL


def test_an_arm_turns_a_moment_into_a_force_and_an_angle_into_a_stroke():
    pivot = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg",
             "h": "0.2 mm", "l": "20 mm", "b": "2 mm"}  # fmt: skip
    actuator = {**BENDER, "arm": "10 mm"}
    result = flexcli.check(spec(pivot, {"rotation": "1 mrad"}, actuator))
    (found,) = result.checks
    K = result.values["k_pivot"]
    assert found.capacity == pytest.approx(5.5 * (1.0 - 10e-6 / 85e-6), rel=1e-9)
    off = K.estimated_error + 1e-5  # θ² and what it changes
    assert found.demand == pytest.approx(K.value * 1e-3 / 10e-3, rel=off)


def test_four_pivots_between_levers_take_the_force_of_their_stage():
    pivot = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg",
             "h": "0.2 mm", "l": "20 mm", "b": "2 mm"}  # fmt: skip
    result = flexcli.check(spec(pivot, {"translation": "50 um"}, more={"mechanism": LEVERS}))
    (found,) = result.checks
    K = result.values["k_pivot"]
    force = 4.0 * K.value / 20e-3**2 * 50e-6
    assert found.demand == pytest.approx(force, rel=K.estimated_error + 1e-4)
    shaken = {"acceleration": {"level": "10 m/s^2", "axis": "x"}}
    with pytest.raises(SpecError, match="drive of several joints is not known"):
        flexcli.check(spec(pivot, {"translation": "50 um"}, more={"mechanism": LEVERS}, **shaken))


def test_an_acceleration_along_the_stroke_counts_on_top():
    more = {"mechanism": {"kind": "payload", "mass": "20 g"}}
    alone = drive(STAGE, {"translation": "20 um"}, more=more)
    shaken = drive(
        STAGE, {"translation": "20 um"}, more=more, acceleration={"level": "10 m/s^2", "axis": "x"}
    )
    assert shaken.demand - alone.demand == pytest.approx(20e-3 * 10.0, rel=1e-3)
    # what the joint's spring may be off by is so many newtons, whatever stands beside it
    for end in (0, 1):
        off = [c.demand * (c.factor / c.factor_range[end] - 1.0) for c in (alone, shaken)]
        assert off[1] == pytest.approx(off[0], rel=0.05)


def test_what_heat_grows_counts_against_the_free_stroke_and_moves_the_stage():
    grows = {**BENDER, "length": "20 mm", "thermal_expansion": "-5e-6 1/K"}
    heat = {"uniform": "20 K", "expansion": {"ground": "23.6e-6 1/K"}}
    asked = spec(STAGE, {"translation": "20 um"}, grows, temperature=heat)
    result = flexcli.check(asked)
    (found,) = result.checks
    growth = 28.6e-6 * 20e-3 * 20.0
    assert found.capacity == pytest.approx(5.5 * (1.0 - (20e-6 + growth) / 85e-6), rel=1e-9)
    told = result.values["s_thermal_work"]
    by_formula = thermal_stroke(
        alpha=-5e-6, alpha_frame=23.6e-6, L=20e-3, dT=20.0,
        k_T=5.5 / 85e-6, k=result.values["k_stage"].value,
    )  # fmt: skip
    assert told.value == pytest.approx(float(by_formula), rel=5e-3)


@pytest.mark.slow
def test_wide_blades_in_the_plane_and_as_shells_agree_within_what_both_tell():
    # b = l: a plate that curls neither at rest nor at its stroke
    plane = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "20 mm", "blades": 2,
             "spacing": "30 mm"}  # fmt: skip
    space = parallelogram("0.2 mm", "20 mm")
    line = {"blocking_force": "100 N", "free_stroke": "20 mm", "drives": "both-ways"}
    stroke = {"translation": "1 mm"}
    flat = drive(plane, stroke, line)
    shells = drive(space, stroke, line, more={"model": "shell"})
    assert flat.factor_range[0] <= shells.factor_range[1]
    assert shells.factor_range[0] <= flat.factor_range[1]
    assert flat.factor_range[1] / flat.factor_range[0] < 1.05, "an error that tells something"


def test_a_model_without_the_force_at_a_stroke_decides_nothing():
    asked = spec(STAGE, {"translation": "20 um"}, more={"model": "linear"})
    assert flexcli.verdicts(asked).status is Status.UNDECIDED


def test_four_pivots_that_start_at_rest_are_driven_from_there():
    pivot = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg",
             "h": "0.2 mm", "l": "20 mm", "b": "2 mm"}  # fmt: skip
    both, one = (
        drive(pivot, {"translation": stroke}, more={"mechanism": LEVERS})
        for stroke in ("50 um", ["0 um", "50 um"])
    )
    assert one.demand == pytest.approx(both.demand, rel=1e-3)
    assert one.passed


class Held(AsPrinted):
    """A joint that is pulled back to rest, and pushed less at its stroke."""

    def effort(self, ask):
        return DriveEffort(0.0, -2.0, EXACT), DriveEffort(20e-6, 1.0, EXACT)


@pytest.mark.parametrize(("drives", "forces"), [("both-ways", [2.0, 1.0]), ("one-way", [1.0])])
def test_what_pulls_at_rest_is_held_by_a_drive_that_pulls(drives, forces):
    grows = {**BENDER, "drives": drives, "length": "20 mm", "thermal_expansion": "8.6e-6 1/K"}
    asked = spec(STAGE, {"translation": ["0 um", "20 um"]}, grows, temperature={"uniform": "20 K"})
    design = DesignSpec.model_validate(yaml.safe_load(asked))
    ask = Ask(design.material, design.geometry, None, design.fixed_sizes(), design.scene("work"),
              Held(), design.actuator)  # fmt: skip
    ((_, requirement),) = design.requirements.each()
    assert [limit.demand for limit in requirement.limits(ask)] == forces
