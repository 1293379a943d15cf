"""What a temperature pushes buckles out of the plane as well, and is crushed where blades yield."""

import numpy as np
import pytest
import yaml
from scipy.optimize import brentq

import flexcli

TITANIUM = {"name": "m", "youngs_modulus": "114 GPa", "poisson_ratio": 0.34,
            "yield_strength": "880 MPa", "thermal_expansion": "9e-6 1/K"}  # fmt: skip
STEEL = {"name": "annealed", "youngs_modulus": "193 GPa", "poisson_ratio": 0.29,
         "yield_strength": "205 MPa", "thermal_expansion": "16e-6 1/K"}  # fmt: skip
NO_STRAIN = {"temperature": {"uniform": "1e-7 K"}}


def checked(geometry, requirements, material=TITANIUM, **case):
    spec = {"flexure": 1, "title": "warm", "material": material, "geometry": geometry,
            "cases": {"work": case}, "requirements": requirements}  # fmt: skip
    return {check.name: check for check in flexcli.verdicts(yaml.safe_dump(spec)).checks}


def bridge(h, b):
    """Return two blades in a row with a body between them, that a cold base pushes together."""
    blade = {"between": ["ground", "st"], "h": f"{h} mm", "b": f"{b} mm"}
    return {
        "kind": "layout", "moving": "st", "motion": {"translation": "90 deg"},
        "bodies": {"st": {"at": ["0 mm", "0 mm"]}},
        "blades": {
            "left": {**blade, "from": ["-20 mm", "0 mm"], "to": ["-2 mm", "0 mm"]},
            "right": {**blade, "from": ["20 mm", "0 mm"], "to": ["2 mm", "0 mm"]},
        },
    }  # fmt: skip


def cold(kelvin):
    return {"temperature": {"bodies": {"ground": f"{-kelvin} K"}}}


def test_a_narrow_bridge_buckles_aside_as_the_same_one_turned_does_in_its_plane():
    asked = {"buckling": {"factor": 1.5}, "yield": {"factor": 1.2}}
    aside = checked(bridge(0.2, 0.1), asked, **cold(5.0))
    turned = checked(bridge(0.1, 0.2), asked, **cold(5.0))
    assert aside["buckling"].verdict.value == turned["buckling"].verdict.value == "fail"
    assert aside["buckling"].factor == pytest.approx(turned["buckling"].factor, rel=0.02)
    assert aside["yield (yield-strength)"].verdict.value == "fail"


def test_it_passes_where_it_surely_stands_and_wide_blades_do_as_they_do_in_the_plane():
    asked = {"buckling": {"factor": 1.5}}
    stands = checked(bridge(0.2, 0.1), asked, **cold(1.0))["buckling"]
    assert stands.verdict.value == "pass"
    assert stands.factor_range[0] < 2.6
    wide = checked(bridge(0.2, 1.0), asked, **cold(5.0))["buckling"]
    assert wide.verdict.value == "pass"
    assert wide.factor == pytest.approx(2.02, rel=0.05)


def test_blades_between_bodies_that_ends_hold_in_the_plane_are_looked_at_as_well():
    narrow = checked(
        bridge(0.2, 0.05), {"buckling": {"factor": 1.5}}, ends="clamped-clamped", **cold(20.0)
    )["buckling"]
    assert narrow.verdict.value == "undecided"
    wide = checked(
        bridge(0.2, 1.0), {"buckling": {"factor": 1.5}}, ends="clamped-clamped", **cold(20.0)
    )["buckling"]
    assert wide.verdict.value == "pass"


STAGE = {"kind": "leaf-spring-stage", "h": "0.3 mm", "l": "20 mm", "b": "0.2 mm", "blades": 2,
         "spacing": "30 mm"}  # fmt: skip


def test_a_temperature_that_strains_nothing_leaves_what_a_force_turns_aside():
    # a column with a stiff arm that is pulled: u tanh u = l/e, e = l/2
    u = brentq(lambda u: u * np.tanh(u) - 2.0, 0.1, 10.0)
    borne = 2.0 * u**2 * 114e9 * 0.3e-3 * 0.2e-3**3 / 12.0 / 20e-3**2
    force = {"load": {"force": f"{borne / 1.2} N"}, "ends": "clamped-free"}
    found = checked(STAGE, {"buckling": {"factor": 3.0}}, **force, **NO_STRAIN)["buckling"]
    assert found.verdict.value == "fail"
    assert found.factor_range[0] < 1.2 < found.factor_range[1] < 1.3


STOCKY = {"kind": "leaf-spring-stage", "h": "1 mm", "l": "10 mm", "b": "5 mm", "blades": 2,
          "spacing": "10 mm"}  # fmt: skip


@pytest.mark.parametrize(
    "beside", [NO_STRAIN, {"wrench": {"z": "1e-9 N"}}], ids=["temperature", "force across"]
)
def test_stocky_blades_yield_before_they_buckle_whatever_acts_beside_the_force(beside):
    # Euler's stress is 7.7 times the strength: the elastic share passes where the crushed one fails
    force = {"load": {"force": "800 N"}, "ends": "clamped-free"}
    asked = {"buckling": {"factor": 4.0}}
    alone = checked(STOCKY, asked, STEEL, **force)["buckling"]
    assert "Johnson" in alone.source
    assert alone.factor == pytest.approx(205e6 * (1 - 1 / 4 / 7.7) * 10e-6 / 800, rel=0.01)
    both = checked(STOCKY, asked, STEEL, **force, **beside)["buckling"]
    assert both.verdict.value == alone.verdict.value == "fail"
    assert both.factor_range[0] < alone.factor * 1.002
    assert both.factor_range[1] > alone.factor * 0.998
    assert both.factor_range[1] < 205e6 * 10e-6 / 800 * 1.001


DRIVEN = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "4 mm", "blades": 2,
          "spacing": "20 mm"}  # fmt: skip


@pytest.mark.parametrize(
    "beside", [NO_STRAIN, {"wrench": {"z": "1e-9 N"}}], ids=["temperature", "force across"]
)
def test_a_drive_is_no_hold_whatever_acts_beside_the_force(beside):
    # locked, the stage would sway at none and its blades buckle at four times the force
    force = {"load": {"force": "10 N"}, "stroke": {"translation": "10 um"}, "ends": "clamped-free"}
    sways = 2.0 * np.pi**2 * 114e9 * 4e-3 * 0.1e-3**3 / 12.0 / 20e-3**2 / 10.0
    asked = {"buckling": {"factor": 3.0 * sways}}
    alone = checked(DRIVEN, asked, **force)["buckling"]
    assert alone.factor == pytest.approx(sways, rel=0.12)  # as a plate, and strained by the stroke
    both = checked(DRIVEN, asked, **force, **beside)["buckling"]
    assert both.verdict.value == alone.verdict.value == "fail"
    assert both.factor_range[0] < alone.factor_range[1]
    assert both.factor_range[1] > alone.factor_range[0]


def test_a_hinge_buckles_beside_a_temperature_as_surely_as_its_stiffness_is_known():
    thick = {"kind": "notch-hinge", "e": "0.5 mm", "r": "2 mm", "b": "5 mm"}
    force = {"load": {"force": "10 N"}, "ends": "clamped-free"}
    asked = {"buckling": {"factor": 100.0}}
    cold_, warm = (checked(thick, asked, **force, **more)["buckling"] for more in ({}, NO_STRAIN))
    assert warm.factor_range[0] < cold_.factor_range[1]
    assert warm.factor_range[1] > cold_.factor_range[0]


def test_a_temperature_that_strains_nothing_leaves_wide_blades_with_held_ends_as_they_are():
    wide = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "25 mm", "blades": 2,
            "spacing": "20 mm"}  # fmt: skip
    force, asked = (
        {"load": {"force": "10 N"}, "ends": "clamped-guided"},
        {"buckling": {"factor": 4.0}},
    )
    alone, warm = (checked(wide, asked, **force, **more)["buckling"] for more in ({}, NO_STRAIN))
    assert warm.verdict is alone.verdict
    assert warm.factor == pytest.approx(alone.factor, rel=0.15)
    # a shift looks at no force, however far it would turn its joint aside
    moved = {"load": {"force": "500 N", "direction": "180 deg"}, "stroke": {"translation": "10 um"}}
    shift = checked(STAGE, {"parasitic_shift": {"max": "1 um"}}, **moved)["parasitic shift (max)"]
    assert shift.verdict.value == "pass"


def test_blades_on_hinges_are_no_clamped_ones_beside_a_temperature():
    # told as clamped ones they would bear four times as much
    force, asked = (
        {"load": {"force": "10 N"}, "ends": "pinned-pinned"},
        {"buckling": {"factor": 9.0}},
    )
    alone, warm = (checked(DRIVEN, asked, **force, **more)["buckling"] for more in ({}, NO_STRAIN))
    assert alone.verdict.value == "fail"
    assert warm.verdict.value == "undecided"
    assert "hinges" in warm.quantity


def test_a_gradient_that_strains_no_blade_changes_nothing_of_what_a_load_buckles():
    """Both blades cross in their middles, about which it is: each grows by nothing."""
    cross = {"kind": "cross-spring", "h": "0.05 mm", "l": "20 mm", "b": "0.2 mm", "delta": -0.5,
             "half_angle": "45 deg"}  # fmt: skip
    force, asked = {"load": {"force": "0.05 N"}, "ends": "clamped-free"}, {"buckling": 1.5}
    cold = checked(cross, asked, **force)["buckling"]
    warm = checked(cross, asked, **force, temperature={"gradient": {"x": "100 K/m"}})["buckling"]
    (low, high), (least, most) = cold.factor_range, warm.factor_range
    assert max(low, least) <= min(high, most)


def test_a_load_across_spares_no_shift_of_a_joint_that_a_temperature_buckles_aside():
    heat, asked = cold(5.0), {"parasitic_shift": {"max": "1 m"}}
    stroke = {"stroke": {"translation": "1 um"}}
    for wrench in ({}, {"wrench": {"z": "1e-12 N"}}):
        check = checked(bridge(0.2, 0.1), asked, **heat, **stroke, **wrench)[
            "parasitic shift (max)"
        ]
        assert check.verdict.value == "fail"
