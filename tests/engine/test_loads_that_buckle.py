"""Loads that buckle the joint fail a requirement on its stress, whatever the stress."""

from math import acos, cos, hypot, inf, pi, sqrt

import pytest
from scipy.optimize import brentq
from scipy.special import ellipk
from strategies import design

from flexcli.engine.check import verdicts
from flexcli.engine.models import model_series
from flexcli.results import Verdict

STEEL = {
    "name": "steel",
    "youngs_modulus": "210 GPa",
    "poisson_ratio": 0.3,
    "yield_strength": "2000 MPa",
}
H, L, B = 0.5e-3, 50e-3, 10e-3
EULER = pi**2 / 4.0 * 210e9 * B * H**3 / 12.0 / L**2
"""Of a blade that is free at its tip [N]."""

SLENDER = 1e-3
"""What the blade's own shortening and shear change of Euler's load, (π h/l)² in size."""


def judged(force, direction="180 deg", model=None):
    spec = design(
        {"kind": "cantilever", "h": f"{H} m", "l": f"{L} m", "b": f"{B} m"}, {"yield": 1.5},
        {"push": {"load": {"force": f"{force} N", "direction": direction}}}, material=STEEL,
    )  # fmt: skip
    (row,) = verdicts(spec, spec.fixed_sizes(), "test", model).checks
    return row


@pytest.mark.parametrize("model", [None, "exact"])
@pytest.mark.parametrize("times", [1.05, 3.0, 20.0])
def test_a_column_beyond_its_euler_load_fails_at_the_share_that_it_bears(times, model):
    row = judged(times * EULER, model=model)
    assert row.verdict is Verdict.FAIL
    assert row.factor == pytest.approx(1.0 / times, rel=SLENDER)
    assert "buckles" in row.quantity


def test_a_column_below_its_euler_load_and_one_that_is_pulled_do_not():
    assert judged(0.9 * EULER, model="exact").verdict is Verdict.PASS
    assert judged(3.0 * EULER, "0 deg", model="exact").verdict is Verdict.PASS


def test_a_column_beyond_its_euler_load_does_not_pass_by_any_model():
    for model in ("closed-form", "linear", "exact"):
        assert judged(1.2 * EULER, model=model).verdict is not Verdict.PASS


@pytest.mark.parametrize("model", [None, "exact"])
@pytest.mark.parametrize("degrees", [179.0, 170.0, 150.0])
def test_a_column_that_leans_from_the_first_on_may_bear_no_more_than_euler_s_load(degrees, model):
    spec = design(
        {"kind": "cantilever", "h": f"{H} m", "l": f"{L} m", "b": f"{B} m"}, {"buckling": 1.0},
        {"push": {"load": {"force": f"{EULER / 1.1} N", "direction": f"{degrees} deg"},
                  "ends": "clamped-free"}},
        material={**STEEL, "poisson_ratio": 0.0},
    )  # fmt: skip
    (row,) = (
        row
        for row in verdicts(spec, spec.fixed_sizes(), "test", model).checks
        if "in the plane" in row.source or "thickness" in row.quantity
    )
    low, high = row.factor_range
    along = 1.1 / abs(cos(degrees * pi / 180.0))
    assert low <= along * (1.0 + SLENDER)
    assert high >= along * (1.0 - SLENDER)


def worst(geometry, case):
    spec = design(geometry, {"yield": 1.5}, {"work": case}, material=STEEL)
    (row,) = verdicts(spec, spec.fixed_sizes(), "test").checks
    return row


def test_a_guided_tip_that_leans_away_has_the_stress_of_the_elastica():
    # its turn of 1e-4 rad leads it to one side, so that nothing branches; k = sin(α/2) from
    # P = (2 K(k)/π)² P_crit, and the curvature at the clamps is 2 k √(P/EI)
    h, l, b, times = 0.02e-3, 10e-3, 0.02e-3, 2.0
    stiff = 210e9 * b * h**3 / 12.0
    force = times * pi**2 * stiff / l**2
    m = brentq(lambda m: (2.0 * ellipk(m) / pi) ** 2 - times, 1e-6, 0.999)
    row = worst(
        {"kind": "moment-blade", "h": f"{h} m", "l": f"{l} m", "b": f"{b} m"},
        {
            "stroke": {"rotation": "1e-4 rad"}, "ends": "clamped-guided",
            "load": {"force": f"{force} N", "direction": "180 deg"},
        },
    )  # fmt: skip
    bent = 210e9 * h * sqrt(m * force / stiff)
    # the turn it starts from is 1e-4 rad of some 2, the mean stress of the force beside it
    assert row.demand == pytest.approx(bent, rel=2e-3)
    assert row.factor_range[1] / row.factor_range[0] < 1.0 + 1e-3


def test_thin_blades_of_a_three_blade_pivot_are_strings_far_out():
    # each end goes along a circle about the centre: blades become as much longer as their chords,
    # and the clamps bend them by √(3 ε) of the angle at which they leave, within some (l/h √ε)⁻¹
    h, l, p, turn = 0.02e-3, 46e-3, 10e-3, 0.25
    row = worst(
        {"kind": "three-blade", "h": f"{h} m", "l": f"{l} m", "b": "0.02 mm", "p": f"{p} m"},
        {"stroke": {"rotation": [f"{turn} rad", f"{turn} rad"]}},
    )
    chord = sqrt(p**2 + (p + l) ** 2 - 2.0 * p * (p + l) * cos(turn))
    strain = chord / l - 1.0
    leaves = acos(
        ((p + l) - p * cos(turn)) / hypot((p + l) - p * cos(turn), p * cos(pi / 2 - turn))
    )
    at_body = turn + leaves
    string = 210e9 * (strain + sqrt(3.0 * strain) * at_body)
    assert row.verdict is Verdict.FAIL
    assert row.demand == pytest.approx(string, rel=0.05)


@pytest.mark.parametrize("times", [3.0, 1e3, 1e5])
def test_of_two_senses_the_one_that_pushes_is_seen_to_buckle_however_far_beyond(times):
    # pulled as far, the blades have no equilibrium that can be found, and buckle at none
    h, l, b, angle = 7.4e-6, 7e-3, 5.2e-6, 51.0
    euler = 4.0 * pi**2 * 210e9 * b * h**3 / 12.0 / l**2
    level = times * 2.0 * cos(angle * pi / 180.0) * euler / 0.3
    spec = design(
        {"kind": "rcc", "h": f"{h} m", "l": f"{l} m", "b": f"{b} m", "p": "12.5 mm",
         "half_angle": f"{angle} deg"},
        {"yield": 0.5, "fatigue": {"factor": 0.5, "mean_stress": "none"}},
        {"work": {"stroke": {"rotation": "4e-5 rad", "cycles": "1e6"},
                  "acceleration": {"level": f"{level} m/s^2", "axis": "x"}}},
        # so strong that no section is too small for the force
        material={**STEEL, "density": "8000 kg/m^3", "yield_strength": "40 GPa",
                  "tensile_strength": "40 GPa",
                  "fatigue_amplitude": {"value": "40 GPa", "cycles": 1e6, "stress_ratio": -1}},
        mechanism={"kind": "payload", "mass": "0.3 kg", "inertia": "1.4e-5 kg*m^2"},
    )  # fmt: skip
    for row in verdicts(spec, spec.fixed_sizes(), "test").checks:
        assert row.verdict is Verdict.FAIL
        assert row.factor_range == pytest.approx((1.0 / times, 1.0 / times), rel=5e-3)


STRIP = {"name": "without Poisson's ratio", "youngs_modulus": "200 GPa", "poisson_ratio": 0.0,
         "yield_strength": "2000 MPa"}  # fmt: skip
PRANDTL = 4.013 * sqrt(200e9 * 100e9 * (1.0 - 0.63 * 0.05) * 2e-3**2 * 0.1e-3**6 / 36.0) / 0.1**2
"""Of a strip 0.1 × 2 mm², 100 mm long, pushed along its width [N] (Prandtl 1899)."""


def pushed_along_its_width(force, kind, requirements, model=None):
    drawn = {
        "cantilever": {"kind": "cantilever", "h": "0.1 mm", "l": "100 mm", "b": "2 mm"},
        "space-layout": {
            "kind": "space-layout",
            "bodies": {"tip": {"at": ["100 mm", "0 mm", "0 mm"]}},
            "blades": {
                "strip": {
                    "between": ["ground", "tip"], "from": ["0 mm", "0 mm", "0 mm"],
                    "to": ["100 mm", "0 mm", "0 mm"], "width": "z", "h": "0.1 mm", "b": "2 mm",
                },
            },
            "moving": "tip", "motion": {"translation": "y"},
        },
    }[kind]  # fmt: skip
    case = {"push": {"wrench": {"z": f"{force} N"}}}
    spec = design(drawn, requirements, case, material=STRIP)
    return verdicts(spec, spec.fixed_sizes(), "test", model).checks


@pytest.mark.parametrize(("kind", "times"), [("cantilever", 4.0), ("space-layout", 1.1)])
def test_a_blade_that_turns_aside_under_a_load_along_its_width_fails(kind, times):
    (row,) = pushed_along_its_width(times * PRANDTL, kind, {"yield": 1.5})
    assert row.verdict is Verdict.FAIL
    # clamps keep it from warping over some of its width at either end
    assert row.factor == pytest.approx(1.0 / times, rel=0.03)
    assert "buckles" in row.quantity


@pytest.mark.parametrize(("model", "most"), [("linear", inf), ("exact", 2.2)])
def test_buckling_is_asked_of_a_load_along_the_width_of_a_blade(model, most):
    # straight beams tell up to what share nothing buckles, exact ones where
    (row,) = pushed_along_its_width(PRANDTL / 2.0, "cantilever", {"buckling": 1.4}, model)
    assert row.verdict is Verdict.PASS
    low, high = row.factor_range
    assert low < 2.0 < high
    assert high <= most


@pytest.mark.parametrize(("asked", "verdict"), [(7.0, Verdict.PASS), (9.5, Verdict.FAIL)])
def test_a_large_factor_on_what_buckles_a_joint_is_looked_for_beyond_it(asked, verdict):
    (row,) = pushed_along_its_width(PRANDTL / 8.0, "cantilever", {"buckling": asked})
    assert row.verdict is verdict


def test_a_body_that_falls_over_its_blades_fails_though_it_stands_straight():
    # a mass at a height on a cross of two blades falls where m a s exceeds their stiffness k_θ
    found = []
    for height in (40.0, 120.0):
        spec = design(
            {
                "kind": "space-layout",
                "bodies": {
                    "mast": {"at": ["0 mm", "0 mm", "0 mm"], "mass": "0.4 kg",
                             "com": ["0 mm", f"{height} mm", "0 mm"]},
                },
                "blades": {
                    "left": {"between": ["ground", "mast"], "from": ["-10 mm", "-10 mm", "-20 mm"],
                             "to": ["10 mm", "10 mm", "-20 mm"], "width": "z", "h": "0.3 mm",
                             "b": "10 mm"},
                    "right": {"between": ["ground", "mast"], "from": ["10 mm", "-10 mm", "20 mm"],
                              "to": ["-10 mm", "10 mm", "20 mm"], "width": "z", "h": "0.3 mm",
                              "b": "10 mm"},
                },
                "moving": "mast",
                "motion": {"rotation": {"about": "z", "at": ["0 mm", "0 mm", "0 mm"]}},
            },
            {"yield": 1.5}, {"ground": {"acceleration": {"y": "-1 g"}}}, material=STEEL,
        )  # fmt: skip
        (row,) = verdicts(spec, spec.fixed_sizes(), "test").checks
        found.append(row)
    k = 2.0 * 210e9 * 10e-3 * 0.3e-3**3 / 12.0 / (sqrt(2.0) * 20e-3)
    assert 0.4 * 9.81 * 0.04 < k < 0.4 * 9.81 * 0.12
    assert [row.verdict for row in found] == [Verdict.PASS, Verdict.FAIL]


def test_a_torsion_bar_that_is_pushed_along_its_axis_buckles_as_a_column():
    half = pi**2 / 8.0 * 210e9 * 3e-3 * 0.5e-3**3 / 12.0 / 0.05**2
    spec = design(
        {"kind": "torsion-bar", "h": "0.5 mm", "l": "50 mm", "b": "3 mm"}, {"buckling": 1.9},
        {"push": {"wrench": {"z": f"-{half} N"}}}, material=STEEL,
    )  # fmt: skip
    (row,) = verdicts(spec, spec.fixed_sizes(), "test", "exact").checks
    # a wide bar is stiffer by what its clamps keep it from curling
    assert row.factor == pytest.approx(2.0, rel=0.01)
    assert row.verdict is Verdict.PASS


@pytest.mark.parametrize(("b", "known"), [(100, True), (200, False)])
def test_what_buckles_blades_without_an_error_is_not_looked_for_after_other_models(b, known):
    # beams were held against shells up to a width of three lengths
    drawn = {"kind": "cantilever", "h": "0.5 mm", "l": "50 mm", "b": f"{b} mm"}
    spec = design(drawn, {"buckling": 2.5}, {"push": {"wrench": {"z": "1 N"}}}, material=STEEL)
    (scene,), sizes = spec.scenes(), spec.fixed_sizes()
    beams = next(model for model in model_series(spec) if model.name == "exact")
    ask = spec.ask(scene, sizes, beams.joint_model)
    assert beams.may_tell_more(spec.requirements.buckling[0], ask, ()) is known


def test_shells_are_asked_of_supports_and_deflections_alone_in_a_joint_of_the_plane():
    drawn = {"kind": "cantilever", "h": "0.5 mm", "l": "50 mm", "b": "10 mm"}
    asked = {"yield": 1.5, "deflection": {"direction": "z", "max": "1 mm"}}
    work = {"stroke": {"translation": "1 mm"}, "wrench": {"z": "1 N"}}
    spec = design(drawn, asked, {"work": work}, material=STEEL)
    (scene,), sizes, shells = spec.scenes(), spec.fixed_sizes(), model_series(spec)[-1]
    assert shells.name == "shell"
    each = {type(found): found for _, found in spec.requirements.each()}
    ask = spec.ask(scene, sizes, shells.joint_model)
    told = {kind.label: shells.may_tell_more(found, ask, ()) for kind, found in each.items()}
    assert told == {"yield": False, "deflection": True}
