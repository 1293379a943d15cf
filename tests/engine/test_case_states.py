"""Loads of a case act together, in one state, in every model, as the case holds the body."""

from math import cos, pi, sin, tan

import pytest
from geometries_for_tests import MATERIAL, spec
from strategies import crossed, design, rcc, stage

import flexcli
from flexcli.engine.check import check
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import AS_PRINTED
from flexcli.results import QuantityKind, Verdict

E = 114e9
H, L, B = 0.1e-3, 20e-3, 5e-3
SIZES = {"h": "0.1 mm", "l": "20 mm", "b": "5 mm"}
SOLVERS = {"linear": LinearModel, "exact": ExactModel}
LIGHT = {"density": "1e-9 kg/m^3"}
"""Of blades that weigh nothing, as a force has no mass."""

STRONG = {**MATERIAL, **LIGHT, "tensile_strength": "900 MPa",
          "fatigue_amplitude": {"value": "500 MPa", "cycles": 1e7, "stress_ratio": -1}}  # fmt: skip

SLENDER = 3e-2
"""What shear, stretching and small rotations leave between the models of these blades."""


def asked(geometry, case, joint_model, mechanism=None):
    found = design(geometry, {"yield": 1}, {"c": case}, material=STRONG, mechanism=mechanism)
    return found.ask(found.scene("c"), found.fixed_sizes(), joint_model)


def largest(geometry, case, joint_model, mechanism=None):
    _, stresses = joint_model.stresses(asked(geometry, case, joint_model, mechanism))
    return max(abs(float(stress.largest)) for stress in stresses)


PAYLOAD = {"kind": "payload", "mass": "0.1 kg"}
SAME = {
    "pivot, across": (
        crossed(delta=-0.5, **SIZES),
        {"load": {"force": "5 N", "direction": "90 deg"}}, {"wrench": {"y": "5 N"}},
        {"acceleration": {"level": "50 m/s^2", "axis": "y"}},
    ),
    "pivot, along": (
        rcc(**SIZES),
        {"load": {"force": "5 N"}}, {"wrench": {"x": "5 N"}},
        {"acceleration": {"level": "50 m/s^2", "axis": "x"}},
    ),
    "stage, along its blades": (
        stage(**SIZES, spacing="15 mm"),
        {"load": {"force": "5 N"}}, {"wrench": {"y": "5 N"}},
        {"acceleration": {"level": "50 m/s^2", "axis": "y"}},
    ),
    "stage, along its stroke": (
        stage(**SIZES, spacing="15 mm"),
        {"load": {"force": "5 mN", "direction": "90 deg"}}, {"wrench": {"x": "5 mN"}},
        {"acceleration": {"level": "0.05 m/s^2", "axis": "x"}},
    ),
}  # fmt: skip


@pytest.mark.parametrize("joint_model", [AS_PRINTED, LinearModel(), ExactModel()])
@pytest.mark.parametrize("kind", SAME)
def test_a_force_is_the_same_however_it_is_written_and_acts_beside_the_stroke(kind, joint_model):
    geometry, *loads = SAME[kind]
    stroke = {"rotation": "2 deg"} if "pivot" in kind else {"translation": "0.4 mm"}
    alone = largest(geometry, {"stroke": stroke}, joint_model)
    found = [
        largest(geometry, {"stroke": stroke, **load}, joint_model, PAYLOAD if index == 2 else None)
        for index, load in enumerate(loads)
    ]
    assert found == pytest.approx([found[0]] * 3, rel=1e-7)
    assert found[0] > alone * (1.0 + 1e-4)


@pytest.mark.parametrize("joint_model", [AS_PRINTED, LinearModel(), ExactModel()])
def test_a_weight_along_the_stroke_sags_the_stage_besides(joint_model):
    """σ = 3Eh(x + m a/k)/l²: the drive does not hold against the load."""
    k = 2 * E * B * H**3 / L**3
    case = {"stroke": {"translation": "50 um"}, "acceleration": {"level": "0.1 m/s^2", "axis": "x"}}
    found = largest(stage(**SIZES, spacing="15 mm"), case, joint_model, PAYLOAD)
    assert found == pytest.approx(3 * E * H * (50e-6 + 0.01 / k) / L**2, rel=1e-3)


@pytest.mark.parametrize("joint_model", [AS_PRINTED, LinearModel(), ExactModel()])
def test_a_moment_turns_a_pivot_by_its_stiffness_besides_the_stroke(joint_model):
    geometry = rcc(**SIZES)
    turn = asked(geometry, {"stroke": {"rotation": "1 mrad"}}, AS_PRINTED)
    moment = 1e-3 * float(AS_PRINTED.stiffness(turn))
    both = {"stroke": {"rotation": "1 mrad"}, "wrench": {"theta_z": f"{moment!r} N*m"}}
    twice = largest(geometry, {"stroke": {"rotation": "2 mrad"}}, joint_model)
    assert largest(geometry, both, joint_model) == pytest.approx(twice, rel=5e-3)


@pytest.mark.parametrize("joint_model", [LinearModel(), ExactModel()])
def test_a_force_bends_the_blades_of_a_pivot_by_stretching_them(joint_model):
    """The body moves ε l/cos α along the bisector, ε l tan α across a blade: 3 (h/l) tan α of σ."""
    alpha, force = pi / 6, 0.01
    geometry = {**rcc(**SIZES), "half_angle": "30 deg"}
    case = {"load": {"force": f"{force} N"}, "ends": "clamped-guided"}
    axial = force / (2 * cos(alpha) * B * H)
    found = largest(geometry, case, joint_model)
    assert found == pytest.approx(axial * (1 + 3 * H / L * tan(alpha)), rel=1e-4)
    closed = largest(geometry, case, AS_PRINTED)
    assert closed == pytest.approx(axial, rel=1e-12)


@pytest.mark.parametrize("ends", ["clamped-clamped", "clamped-guided"])
def test_what_the_ends_hold_in_buckling_they_hold_in_stress(ends):
    """A free body would fall at less than the force that its ends let it bear."""
    geometry, joint_model = rcc(**SIZES, p="20 mm"), ExactModel()
    found = {}
    for held in ("clamped-free", ends):
        case = {"load": {"force": "1 N"}, "ends": held}
        ways = joint_model.critical(asked(geometry, case, joint_model))
        found[held] = min(float(way.force) for way in ways)
    between = (found["clamped-free"] * found[ends]) ** 0.5
    assert found[ends] > 1.02 * found["clamped-free"]
    case = {"load": {"force": f"{between!r} N"}}
    assert largest(geometry, {**case, "ends": ends}, joint_model) > 0.0
    with pytest.raises(NotAvailable, match="buckle"):
        largest(geometry, {**case, "ends": "clamped-free"}, joint_model)


@pytest.mark.parametrize("joint_model", [LinearModel(), ExactModel()])
@pytest.mark.parametrize(
    "kind", ["three-blade", "star", "rcc", "leaf-spring-stage", "guided-blade"]
)
def test_states_without_motion_and_overconstrained_joints_solve(kind, joint_model):
    unit = "mm" if kind in ("leaf-spring-stage", "guided-blade") else "mrad"
    motion = "rotation" if unit == "mrad" else "translation"
    one_way = largest(spec(kind), {"stroke": {motion: [f"0 {unit}", f"0.2 {unit}"]}}, joint_model)
    both = largest(spec(kind), {"stroke": {motion: f"0.2 {unit}"}}, joint_model)
    assert one_way == pytest.approx(both, rel=1e-2)
    held = largest(spec(kind), {"load": {"force": "1 mN"}, "ends": "clamped-clamped"}, joint_model)
    assert held > 0.0


@pytest.mark.parametrize("joint_model", [LinearModel(), ExactModel()])
def test_two_sided_fatigue_takes_half_the_range_with_its_mean(joint_model):
    """The ends of a stroke stress a place of a pivot unevenly: half the range is the amplitude."""
    case = {"stroke": {"rotation": "15 deg", "cycles": 1e6}}
    ask = asked(rcc(**SIZES), case, joint_model)
    _, found = joint_model.stresses(ask)
    for stress in found:
        low, high = stress.mean - stress.amplitude, stress.mean + stress.amplitude
        assert max(abs(low), abs(high)) == pytest.approx(stress.largest, rel=1e-12)
    worst = max(found, key=lambda stress: stress.largest)
    assert worst.amplitude <= worst.largest


def test_two_sided_fatigue_judges_the_amplitude_by_the_mean_stress_method():
    geometry = rcc(**SIZES, p="30 mm")
    cases = {"c": {"stroke": {"rotation": "8 deg", "cycles": 1e6}}}
    joint_model = ExactModel()
    found = {}
    for method in ("none", "goodman"):
        asks = {"fatigue": {"factor": 1, "mean_stress": method}}
        one = design(geometry, asks, cases, material=STRONG)
        found[method] = max(float(x.demand) for x in one.limits(one.fixed_sizes(), joint_model))
    bare = {k: v for k, v in STRONG.items() if k != "tensile_strength"}
    one = design(geometry, {"fatigue": 1}, cases, material=bare)
    larger_end = max(float(x.demand) for x in one.limits(one.fixed_sizes(), joint_model))
    assert found["none"] < found["goodman"] < larger_end
    largest_stress = max(
        s.largest
        for s in joint_model.stresses(one.ask(one.scene("c"), one.fixed_sizes(), joint_model))[1]
    )
    assert larger_end <= largest_stress * (1 + 1e-12)


@pytest.mark.parametrize(
    "kind", ["notch-hinge", "elliptic-hinge", "filleted-hinge", "hinged-stage", "hinged-pivot"]
)
@pytest.mark.parametrize("joint_model", [LinearModel(), ExactModel()])
def test_every_model_has_the_peak_of_a_notch(kind, joint_model):
    """K_t of the throat multiplies what a beam's section has, in all of them alike."""
    unit = "mm" if kind == "hinged-stage" else "mrad"
    case = {"stroke": {"translation" if unit == "mm" else "rotation": f"0.01 {unit}"}}
    thick = {} if kind == "filleted-hinge" else {"e": 0.4}
    ratios = [
        largest(spec(kind, **thick), case, each)
        / largest({**spec(kind, **thick), "stress-concentration": "none"}, case, each)
        for each in (AS_PRINTED, joint_model)
    ]
    # what little axial force the stroke makes has a factor of its own
    assert ratios[1] == pytest.approx(ratios[0], rel=1e-4)
    assert ratios[0] > 1.008


def test_the_exact_model_solves_a_case_once(monkeypatch):
    from flexcli.engine.joint_models import joint_states

    solved, inner = [], joint_states.solve
    monkeypatch.setattr(joint_states, "solve", lambda *a, **k: solved.append(1) or inner(*a, **k))
    cases = {"c": {"stroke": {"rotation": "2 deg", "cycles": 1e6}, "load": {"force": "1 N"}}}
    one = design(rcc(**SIZES), {"fatigue": 1, "yield": 1}, cases, material=STRONG)
    one.limits(one.fixed_sizes(), ExactModel())
    assert len(solved) == 1


@pytest.mark.parametrize("nodes", [(6, 9), (8, 12)])
@pytest.mark.parametrize("kind", ["notch-hinge", "rcc"])
def test_the_solvers_error_bounds_what_is_reported(kind, nodes):
    """Against the finest nodes: the stiffness at rest, where nothing moves, and the stress."""
    coarse, fine = ExactModel(tolerance=1e-2, levels=nodes), ExactModel(tolerance=1e-12)
    case = {"stroke": {"rotation": "2 deg"}}
    asks = [asked(spec(kind), case, each) for each in (coarse, fine)]
    for quantity, number in (
        (QuantityKind.STIFFNESS, lambda ask: float(ask.joint_model.stiffness(ask))),
        (QuantityKind.STRESS, lambda ask: max(s.largest for s in ask.joint_model.stresses(ask)[1])),
    ):
        known = coarse.error(asks[0], quantity)
        true = number(asks[1]) / number(asks[0]) - 1.0
        assert known is not None
        assert known.low - 1e-9 <= true <= known.high + 1e-9


def test_an_oblique_force_on_a_stage_is_shared_by_statics():
    geometry, joint_model = stage(**SIZES, spacing="15 mm"), LinearModel()
    case = {"load": {"force": "1 mN", "direction": "60 deg"}}
    k = 2 * E * B * H**3 / L**3
    bends = 3 * E * H * 1e-3 * sin(pi / 3) / k / L**2
    axial = 1e-3 * cos(pi / 3) / (2 * B * H)
    assert largest(geometry, case, joint_model) == pytest.approx(bends + axial, rel=1e-3)
    assert largest(geometry, case, AS_PRINTED) == pytest.approx(bends + axial, rel=1e-12)


DRAWN = {
    "kind": "layout",
    "bodies": {"st": {"at": ["0 mm", "0 mm"], "mass": "0.1 kg", "com": ["1 mm", "2 mm"]}},
    "blades": {
        name: {"between": ["ground", "st"], "from": ["5 mm", f"{y} mm"],
               "to": ["25 mm", f"{5 * y} mm"], "b": "5 mm", "h": "0.2 mm"}
        for name, y in (("a", 5), ("c", -5))
    },
    "moving": "st",
    "motion": "rotation",
}  # fmt: skip
EXTREMES = {
    "a weight on a drawing's own masses": (DRAWN, {"acceleration": {"level": "3 g", "axis": "y"}}),
    "a moment on a drawing": (DRAWN, {"wrench": {"theta_z": "1 N*mm", "x": "1 N"}}),
    "far beyond buckling": (rcc(**SIZES), {"load": {"force": "100 kN"}}),
    "a stroke beside it": (
        rcc(**SIZES),
        {"stroke": {"rotation": "5 deg"}, "load": {"force": "100 kN"}},
    ),
    "a pivot turned right over": (rcc(**SIZES), {"wrench": {"theta_z": "100 N*m"}}),
    "nearly parallel blades": (
        {**rcc(**SIZES), "half_angle": "1e-6 deg"},
        {"load": {"force": "1 N", "direction": "90 deg"}, "ends": "clamped-clamped"},
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("model", [None, "linear", "exact"])
@pytest.mark.parametrize("kind", EXTREMES)
def test_what_cannot_be_solved_is_a_row_of_the_report(kind, model):
    geometry, case = EXTREMES[kind]
    one = design(geometry, {"yield": 1}, {"c": case}, material=STRONG)
    result = check(one, one.fixed_sizes(), "spec", model)
    (row,) = [each for each in result.checks if each.name.startswith("yield")]
    assert row.verdict in (Verdict.PASS, Verdict.FAIL, Verdict.UNDECIDED)
    if row.factor != row.factor:
        assert "no model has an answer" in row.quantity


def test_the_masses_of_a_drawing_load_it():
    """Two blades bear 0.1 kg: beside its axial stress, bending by the arm to its centre."""
    weighed, pushed = (
        largest(DRAWN, case, LinearModel())
        for case in (
            {"acceleration": {"level": "0.03 m/s^2", "axis": "y"}},
            {"wrench": {"y": "3 mN", "theta_z": "0.003 N*mm"}},
        )
    )
    assert weighed == pytest.approx(pushed, rel=1e-4)  # the arm of a dead load turns with it


@pytest.mark.parametrize("load", [
    {"wrench": {"x": "5 mN"}}, {"acceleration": {"level": "0.05 m/s^2", "axis": "x"}},
])  # fmt: skip
@pytest.mark.parametrize("ends", ["pinned-pinned", "clamped-clamped", "clamped-guided"])
def test_no_ends_hold_a_stage_against_a_force_along_its_stroke(ends, load):
    """σ = 3Fl/(2bh²) of two blades: ends hold a body across a force that presses on its blades."""
    geometry = stage(**SIZES, spacing="15 mm")
    case = {"ends": ends, **load}
    for joint_model in (AS_PRINTED, LinearModel(), ExactModel()):
        found = largest(geometry, case, joint_model, PAYLOAD if "acceleration" in load else None)
        assert found == pytest.approx(1.5 * 5e-3 * L / (B * H**2), rel=5e-3)


@pytest.mark.parametrize("ends", ["clamped-clamped", "pinned-pinned", "clamped-guided"])
def test_no_ends_hold_a_pivot_against_the_moment_that_turns_it(ends):
    """Its stress is that of the turn by its stiffness, as without ends."""
    geometry = crossed(delta=-0.5, **SIZES)
    case = {"wrench": {"theta_z": "1e-4 N*m"}}
    for joint_model in (AS_PRINTED, LinearModel(), ExactModel()):
        held, free = (
            largest(geometry, {**case, **more}, joint_model) for more in ({"ends": ends}, {})
        )
        assert held == pytest.approx(free, rel=1e-9)
        assert held > 1e6


def test_a_blade_held_along_itself_has_no_linear_stress_where_it_swings_far():
    """Its end moves by several thicknesses: what that stretches bears most of the force."""
    geometry = {"kind": "moment-blade", "h": "47 um", "l": "12.5 mm", "b": "2.6 mm"}
    case = {"ends": "pinned-pinned", "wrench": {"y": "15 mN"}}
    ask = asked(geometry, case, LinearModel())
    assert LinearModel().error(ask, QuantityKind.STRESS) is None
    linear, exact = (largest(geometry, case, each) for each in (LinearModel(), ExactModel()))
    assert exact < 0.5 * linear
    near = asked(geometry, {**case, "wrench": {"y": "0.05 mN"}}, LinearModel())
    error = LinearModel().error(near, QuantityKind.STRESS)
    small = {**case, "wrench": {"y": "0.05 mN"}}
    ratio = largest(geometry, small, ExactModel()) / largest(geometry, small, LinearModel()) - 1.0
    assert error.low <= ratio <= error.high


CANTILEVER = {"kind": "cantilever", **SIZES}


@pytest.mark.parametrize("joint_model", [LinearModel(), ExactModel()])
def test_a_stroke_is_from_where_a_moment_leaves_the_drive(joint_model):
    """σ = 3Ehx/2l² of the stroke, and 6M/bh² of the moment, which the drive does not bear."""
    moment = 1e-5
    case = {"stroke": {"translation": "50 um"}, "wrench": {"theta_z": f"{moment} N*m"}}
    found = largest(CANTILEVER, case, joint_model)
    stroke = 3.0 * E * H * 50e-6 / (2.0 * L**2)
    assert found == pytest.approx(stroke + 6.0 * moment / (B * H**2), rel=1e-3)


@pytest.mark.parametrize("share", [0.02, 0.1, 0.15])
def test_an_axial_force_beside_a_moment_is_in_the_error_of_linear_blades(share):
    """The root of a cantilever with a moment at its tip bears M/cos(l√(P/EI)) beside P."""
    moment, EI = 1e-5, E * B * H**3 / 12.0
    force = share * pi**2 / 4.0 * EI / L**2
    case = {"load": {"force": f"{force!r} N"}, "wrench": {"theta_z": f"{moment!r} N*m"}}
    bending = 6.0 * moment / cos(pi / 2.0 * share**0.5) / (B * H**2)
    true = bending + force / (B * H)
    found = largest(CANTILEVER, case, LinearModel())
    error = LinearModel().error(asked(CANTILEVER, case, LinearModel()), QuantityKind.STRESS)
    assert error.high > share
    assert found * (1.0 + error.low) <= true <= found * (1.0 + error.high)
    assert largest(CANTILEVER, case, ExactModel()) == pytest.approx(true, rel=1e-3)


def test_the_amplitude_of_linear_blades_is_unknown_beside_loads_that_move_them_far():
    """Tip force F l²/EI = 1.349 and tip moment 0.842 EI/l: the root's moment has twice its slope.

    By an elastica that ``scipy.integrate`` shot from its root: dM/dy = 5.999 EI/l² at the tip's
    y/l of 0.608, 3 at rest.
    """
    EI = E * B * H**3 / 12.0
    stroke = {"translation": ["0 um", "20 um"], "cycles": 1e7}
    wrench = {"x": f"{-1.3490754 * EI / L**2!r} N", "theta_z": f"{-0.8418769 * EI / L!r} N*m"}
    case = {"stroke": stroke, "wrench": wrench}
    ask = asked(CANTILEVER, case, LinearModel())
    assert LinearModel().error(ask, QuantityKind.STRESS) is None
    amplitudes = [
        max(float(each.amplitude) for each in model.stresses(asked(CANTILEVER, case, model))[1])
        for model in (LinearModel(), ExactModel())
    ]
    assert amplitudes[1] / amplitudes[0] == pytest.approx(5.999 / 3.0, rel=0.01)


def judged(geometry, case, model, **asked_for):
    found = design(geometry, asked_for, {"c": case}, material=STRONG)
    rows = check(found, found.fixed_sizes(), "spec", model).checks
    (row,) = (each for each in rows if each.factor_range is not None)
    return row


def test_a_shift_is_that_of_the_stroke_alone_in_closed_form():
    """3x²/5l of a guided blade, however far a force moves it besides."""
    geometry, x = {"kind": "guided-blade", **SIZES}, 50e-6
    force = f"{0.3 * E * B * H**3 / L**2!r} N"
    stroke = {"stroke": {"translation": f"{x!r} m"}}
    alone, pushed = (
        judged(geometry, {**stroke, **load}, "closed-form", parasitic_shift={"max": "1 m"})
        for load in ({}, {"wrench": {"x": force}})
    )
    assert pushed.factor_range == pytest.approx(alone.factor_range, rel=1e-9)
    assert pushed.demand == pytest.approx(0.6 * x**2 / L, rel=0.01)


@pytest.mark.parametrize("share", [0.02, 0.04, 0.08])
def test_a_deflection_that_curves_a_wide_blade_is_in_the_error_of_straight_ones(share):
    """x/l of 0.02 to 0.08 by F l³/12EI: sections keep flat, by 0.2 to 2.5 % less than at rest."""
    geometry = {"kind": "guided-blade", **SIZES}
    case = {"wrench": {"x": f"{share * E * B * H**3 / L**2!r} N"}}
    linear, exact = (
        judged(geometry, case, model, deflection={"direction": "x", "max": "1 m"})
        for model in ("linear", "exact")
    )
    assert exact.demand < linear.demand * (1.0 - 3.0 * share**2)
    assert linear.factor_range[0] <= exact.factor_range[0]
    assert exact.factor_range[1] <= linear.factor_range[1]


@pytest.mark.parametrize("model", ["linear", "exact"])
def test_a_stroke_beside_a_load_is_told_without_poisson_s_ratio(model):
    """A force that pulls all three blades of a pivot alike moves none of its stroke."""
    text = """
flexure: 1
material: {youngs_modulus: 143 GPa, yield_strength: 200 MPa}
geometry: {kind: three-blade, h: 0.2 mm, l: 20 mm, b: 1 mm, p: 0 mm}
cases:
  alone: {stroke: {rotation: 1 mrad}}
  beside: {stroke: {rotation: 1 mrad}, load: {force: 1 mN}}
requirements: {yield: 1}
"""
    alone, beside = (c for c in flexcli.verdicts(text, model=model).checks if "yield" in c.name)
    pull = 1e-3 / (0.2e-3 * 1e-3)
    assert alone.demand <= beside.demand <= (alone.demand + pull) * 1.001
    assert (beside.factor_range is not None) is (model == "exact")
