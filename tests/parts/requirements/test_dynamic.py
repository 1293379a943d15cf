"""Peaks of the modes with the range that the structure's own error gives them."""

from math import pi, sqrt

import numpy as np
import pytest
import yaml

import flexcli
from flexcli.parts.design import DesignSpec
from flexcli.parts.quality import Quality
from flexcli.parts.requirements import Ask, RequirementError, dynamic
from flexcli.parts.requirements.as_printed import AsPrinted
from flexcli.parts.requirements.response_range import compounded, uncertain_structure
from flexcli.parts.response import random_outputs, sine_peaks
from flexcli.parts.scene import LoadKind
from flexcli.results import EXACT, ErrorRange, QuantityKind, error_of_ratio

E, H, L, B = 114e9, 0.2e-3, 20e-3, 10e-3
MATERIAL = {"name": "titanium", "youngs_modulus": "114 GPa", "poisson_ratio": 0.3,
            "yield_strength": "900 MPa", "density": "1e-3 kg/m^3"}  # fmt: skip
STAGE = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "10 mm"}
K = 24.0 * E * B * H**3 / 12.0 / L**3
MASS = 0.05
F_0 = sqrt(K / MASS) / (2.0 * pi)
Q = 50.0


class Off(AsPrinted):
    """The printed formulas, their stiffness off by so much."""

    def __init__(self, low=0.0, high=0.0, known=True):
        self.off, self.known = ErrorRange(low, high), known

    def error(self, ask, kind):
        if not self.known:
            return None
        return self.off if kind is QuantityKind.STIFFNESS else EXACT


def design(case, requirements=None, **more):
    given = {
        "flexure": 1,
        "material": {**MATERIAL, **more},
        "geometry": STAGE,
        "mechanism": {"kind": "payload", "mass": f"{MASS} kg", "damping": {"q": Q}},
        "cases": {"shake": case},
        "requirements": requirements or {"dynamic-yield": 1.5},
    }
    return DesignSpec.model_validate(yaml.safe_load(yaml.safe_dump(given)))


def limit(case, joint_model, requirements=None, **more):
    found = design(case, requirements, **more)
    sizes = found.fixed_sizes()
    ((_, requirement),) = found.requirements.each()
    ask = Ask(
        found.material, found.geometry, found.mechanism, sizes, found.scene("shake"), joint_model
    )
    (worst,) = requirement.limits(ask)
    return worst


def flat(low, high, level=0.01):
    ends = [{"frequency": f"{f!r} Hz", "level": f"{level} g^2/Hz"} for f in (low, high)]
    return {"asd": {"profile": {"points": ends}, "q": Q, "duration": "60 s"}}


def sine(frequency, level=1.0):
    return {"sine": {"acceleration": f"{level} m/s^2", "frequency": f"{frequency!r} Hz"}}


def travel_stress(x):
    return 3.0 * E * H / L**2 * x


def test_white_noise_moves_one_mode_as_miles_says():
    """Miles: the rms of ω² z is √(π/2 f Q G), exact for white noise from zero to infinity."""
    level = 0.01 * 9.80665**2
    miles = sqrt(pi / 2.0 * F_0 * Q * level)
    expected = 3.0 * travel_stress(miles / (2.0 * pi * F_0) ** 2)
    found = limit(flat(F_0 / 100.0, F_0 * 100.0), Off())
    # of the band, what is outside two decades about the resonance
    assert found.demand == pytest.approx(expected, rel=1e-3)


def test_a_sine_moves_one_mode_by_its_gain():
    f = 0.9 * F_0
    gain = 1.0 / np.hypot(1.0 - 0.9**2, 0.9 / Q)
    expected = travel_stress(gain / (2.0 * pi * F_0) ** 2)
    assert limit(sine(f), Off()).demand == pytest.approx(expected, rel=1e-6)


def test_a_sweep_over_the_resonance_has_its_top():
    case = {"sweep": {"acceleration": "1 m/s^2", "rate": "1 oct/min",
                      "from": f"{F_0 / 3!r} Hz", "to": f"{F_0 * 3!r} Hz"}}  # fmt: skip
    # the top of |1/(1 − r² + ir/Q)| is Q/√(1 − 1/(4Q²))
    top = Q / sqrt(1.0 - 0.25 / Q**2)
    expected = travel_stress(top / (2.0 * pi * F_0) ** 2)
    assert limit(case, Off()).demand == pytest.approx(expected, rel=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("case", [flat(F_0 / 2.0, 0.97 * F_0), flat(20.0, 40.0), sine(0.97 * F_0)])
def test_the_range_covers_every_stiffness_within_the_error(case):
    low, high = -0.08, 0.05
    found = limit(case, Off(low, high))
    for off in np.linspace(low, high, 60):
        true = _with_stiffness(case, 1.0 + off)
        error = true / found.demand - 1.0
        # between the stiffnesses that were tried the response is smooth
        assert found.error.low - 1e-3 <= error <= found.error.high * (1.0 + 1e-3) + 1e-3


def test_a_resonance_inside_the_range_counts_though_both_ends_are_away_from_it():
    found = limit(sine(1.001 * F_0), Off(-0.2, 0.2))
    top = Q / (2.0 * pi * 1.001 * F_0) ** 2  # with the stiffness at which it resonates
    # at resonance the stress is that of a mode of stiffness times travel
    assert found.demand * (1.0 + found.error.high) >= 0.999 * travel_stress(top)


def _with_stiffness(case, factor):
    """Give the peak stress of the one mode with its stiffness and stresses times a factor."""
    found = design(case)
    sizes = found.fixed_sizes()
    structure = found.mechanism.structure(found.geometry, found.material.elastic, sizes, None)
    structure = structure.stiffened(factor)
    scene = found.scene("shake")
    if scene.vibration is not None:
        return 3.0 * random_outputs(structure, scene.vibration)["stress joint"].rms
    ends = (scene.sine.frequency, scene.sine.frequency)
    return sine_peaks(structure, scene.sine.level, Quality(all=Q), ends)["stress joint"]


def test_an_unknown_stiffness_leaves_the_response_unknown():
    assert limit(sine(0.5 * F_0), Off(known=False)).error is None


def test_a_known_structure_leaves_only_what_the_travel_bends_otherwise():
    found = limit(sine(0.5 * F_0, 0.01), Off())
    assert found.error.largest < 1e-6


def test_a_life_is_shorter_by_the_power_of_the_stress():
    points = [{"cycles": n, "amplitude": s} for n, s in ((1e3, "800 MPa"), (1e7, "200 MPa"))]
    curve = {"sn_amplitudes": {"points": points, "stress_ratio": -1}}
    asked = {"dynamic-life": {"factor": 4, "method": "dirlik"}}
    case = flat(F_0 / 4.0, 4.0 * F_0, 0.1)
    found = limit(case, Off(-0.1, 0.1), asked, **curve)
    assert found.in_capacity
    assert found.error.low < 0.0 < found.error.high
    softer, plain = (_with_stiffness(case, f) for f in (0.9, 1.0))
    k = np.log(1e4) / np.log(4.0)
    # the crossing rate moves by 5 % besides
    assert 1.0 + found.error.high == pytest.approx((plain / softer) ** k, rel=0.1)


def test_it_looks_at_all_that_shakes_and_at_what_stands_beside_it():
    case = {**sine(50.0), "stroke": {"translation": "0.1 mm"}}
    found = design(case)
    ((_, requirement),) = found.requirements.each()
    assert requirement.looks_at(found.scene("shake")) == {LoadKind.SINE, LoadKind.STROKE}


def test_it_is_asked_of_cases_that_shake_and_are_named():
    found = design(sine(50.0), {"dynamic-yield": {"factor": 1.5, "cases": ["shake"]}})
    ((_, requirement),) = found.requirements.each()
    shaken = found.scene("shake")
    assert requirement.applies(shaken)
    assert not requirement.applies(shaken._replace(case="another"))
    assert not requirement.applies(shaken._replace(loads=frozenset({LoadKind.STROKE})))


def test_errors_of_a_product_and_of_a_ratio_have_their_worst_ends():
    one, other = ErrorRange(-0.1, 0.2), ErrorRange(-0.2, 0.25)
    assert compounded(one, other) == pytest.approx((0.9 * 0.8 - 1.0, 1.2 * 1.25 - 1.0))
    assert error_of_ratio(one, other) == pytest.approx((0.9 / 1.25 - 1.0, 1.2 / 0.8 - 1.0))
    for found in (compounded, error_of_ratio):
        assert found(None, other) is found(one, None) is None
    # a number that may be nothing bounds no ratio
    assert error_of_ratio(one, ErrorRange(-1.0, 0.0)) is None


def test_a_sine_without_damping_is_a_finding():
    found = design(sine(50.0))
    mechanism = found.mechanism.model_copy(update={"damping": None})
    ask = Ask(
        found.material, found.geometry, mechanism, found.fixed_sizes(),
        found.scene("shake")._replace(quality=None), Off(),
    )  # fmt: skip
    ((_, requirement),) = found.requirements.each()
    with pytest.raises(RequirementError, match="damped"):
        list(requirement.limits(ask))


def test_a_slow_shaking_along_the_blades_presses_each_with_its_share_of_the_payload():
    """Far below its resonance the payload rides along: two blades carry m a."""
    low, high, level = 20.0, 40.0, 0.01 * 9.80665**2
    case = flat(low, high)
    case["asd"]["axis"] = "y"
    case["ends"] = "clamped-guided"
    found = limit(case, Off(), {"dynamic-buckling": 2.0})
    peak = 3.0 * sqrt(level * (high - low))
    # the gain of the resonance along the blades, over 2 kHz, is (40 Hz/2 kHz)² above one
    assert found.demand == pytest.approx(MASS * peak / 2.0, rel=1e-3)
    assert found.quantity.startswith("3σ axial force")
    assert found.unit == "N"
    assert found.required == 2.0
    # Euler's load of a blade whose ends keep their direction, but for its stretch, some (h/l)²
    assert found.capacity == pytest.approx(pi**2 * E * B * H**3 / 12.0 / L**2, rel=1e-3)


@pytest.mark.parametrize(("given", "most"), [({"poisson_ratio": 0.3}, 0.3), ({}, 0.5)])
def test_wide_blades_bear_more_than_beams_by_what_a_plate_is_stiffer_at_most(given, most):
    """Cylindrical bending is stiffer by 1/(1 − ν²); what a peak uses is less by that at most."""
    case = {**flat(20.0, 40.0), "ends": "clamped-guided"}
    case["asd"]["axis"] = "y"
    asked = {"dynamic-buckling": 2.0}
    found = limit(case, Off(), asked, **{"poisson_ratio": None, **given}).error
    narrow = limit(case, Off(), asked, poisson_ratio=1e-9).error
    wider = (1.0 + narrow.low) / (1.0 + found.low) - 1.0
    # beside the error of the beams, some (h/l)²
    assert wider == pytest.approx(most**2 / (1.0 - most**2), rel=1e-3)
    assert found.high == pytest.approx(narrow.high, abs=(H / L) ** 2)


class OffByTurn(Off):
    """The printed formulas, whose stresses are off in proportion to the rotation."""

    def error(self, ask, kind):
        if kind is QuantityKind.STRESS:
            return ErrorRange(0.0, 10.0 * ask.scene.travel)
        return super().error(ask, kind)


@pytest.fixture
def unpushed(monkeypatch):
    """Leave out what forces along the blades change, some 0.5 to 6 % here: tests of their own."""
    monkeypatch.setattr(dynamic, "pushed", lambda _ask, found, *_: found)


def limits_of_levers(case, asked=None, **material):
    """Return the limits on a stage of levers whose stresses are off as their pivots turn."""
    lever = {"mass": "17 g", "com": "10 mm", "inertia": "5e-6 kg*m^2"}
    stage = {"kind": "parallel-stage", "height": "20 mm", "solid-1": lever, "solid-3": lever,
             "solid-2": {"mass": "68 g"}, "damping": {"q": Q}}  # fmt: skip
    spec = {
        "flexure": 1, "material": {**MATERIAL, **material},
        "mechanism": stage, "cases": {"shake": case},
        "geometry": {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg", "h": "0.1 mm",
                     "l": "20 mm", "b": "10 mm"},
        "requirements": asked or {"dynamic-yield": 1.5},
    }  # fmt: skip
    found = DesignSpec.model_validate(spec)
    ((_, requirement),) = found.requirements.each()
    sizes, scene = found.fixed_sizes(), found.scene("shake")
    ask = Ask(found.material, found.geometry, found.mechanism, sizes, scene, OffByTurn())
    return list(requirement.limits(ask))


@pytest.mark.usefixtures("unpushed")
def test_the_stress_of_a_peak_is_as_far_off_as_the_pivots_turn_at_it():
    """Levers turn pivots by the stroke over their height: θ from the stress E h θ (2l + 3p)/l²."""
    found = limits_of_levers(sine(1.0, 5.0))
    worst = max(found, key=lambda each: float(each.demand))
    theta = turned(worst.demand)
    assert theta > 1e-3
    # the axial force that comes with it is a part in a hundred of the stress
    assert worst.error.high == pytest.approx(10.0 * theta, rel=0.02)


def turned(stress):
    """Return the rotation of the levers' pivots at a stress of their inner ends [rad]."""
    return stress * 20e-3**2 / (E * 0.1e-3 * (2.0 * 20e-3 + 3.0 * 2e-3))


@pytest.mark.usefixtures("unpushed")
def test_a_life_is_as_far_off_as_the_pivots_turn_at_the_peaks():
    case = flat(2.0, 20.0, 0.01)
    peak = max(float(each.demand) for each in limits_of_levers(case))
    points = [{"cycles": n, "amplitude": s} for n, s in ((1e3, "800 MPa"), (1e9, "100 MPa"))]
    curve = {"sn_amplitudes": {"points": points, "stress_ratio": -1}}
    asked = {"dynamic-life": {"factor": 4, "method": "narrow-band"}}
    found = limits_of_levers(case, asked, **curve)
    k = np.log(1e6) / np.log(8.0)
    worst = min(found, key=lambda each: float(each.capacity))
    assert 1.0 + worst.error.low == pytest.approx((1.0 + 10.0 * turned(peak)) ** -k, rel=0.1)


def test_a_locked_stage_turns_no_pivot_whatever_shakes_it():
    found = limits_of_levers({**flat(20.0, 40.0), "lock": "solid-2"})
    assert found
    assert all(each.error.high == pytest.approx(0.0, abs=1e-3) for each in found)


@pytest.mark.usefixtures("unpushed")
def test_a_peak_beyond_the_strength_is_as_far_off_as_where_it_reaches_it():
    """What pivots are off at the motion of a stress that they never bear does not count."""
    found = limits_of_levers(sine(1.0, 200.0))
    worst = max(found, key=lambda each: float(each.demand))
    bearable = 900e6 / 1.5
    assert worst.demand > 2.0 * bearable
    assert worst.error.high == pytest.approx(10.0 * turned(bearable), rel=0.02)


class Stiffer(Off):
    """A joint that is stiffer than printed along its motion, as wide blades are."""

    def stiffness(self, ask):
        return 1.1 * super().stiffness(ask)


@pytest.mark.parametrize("axis", ["x", "y"])
def test_what_stretches_blades_is_no_stiffer_by_what_stiffens_their_bending(axis):
    case = flat(20.0, 40.0)
    case["asd"]["axis"] = axis
    given = design(case)
    sizes, scene = given.fixed_sizes(), given.scene("shake")
    ask = Ask(given.material, given.geometry, given.mechanism, sizes, scene, Stiffer())
    found = uncertain_structure(ask, ())
    plain = given.mechanism.structure(given.geometry, given.material.elastic, sizes, None)
    ratios = [other.stiffness[0, 0] / plain.stiffness[0, 0] for other in found.others]
    # clamps that give way soften what stretches; what bends has them in the model's own number
    least = 1.1 if axis == "x" else 1.0 / (1.0 + ask.clamp_softening)
    assert (min(ratios), max(ratios)) == pytest.approx((least, 1.1))


def test_a_drawn_stage_whose_body_has_the_mass_is_judged_as_the_stage_that_carries_it():
    blades = {
        name: {"between": ["ground", "stage"], "h": "0.2 mm", "b": "10 mm",
               "from": ["0 mm", y], "to": ["20 mm", y]}
        for name, y in (("left", "15 mm"), ("right", "-15 mm"))
    }  # fmt: skip
    drawn = {
        "kind": "layout", "moving": "stage", "motion": {"translation": "90 deg"},
        "bodies": {"stage": {"at": ["10 mm", "0 mm"], "mass": f"{MASS} kg", "inertia": "1 kg*m^2"}},
        "blades": blades,
    }  # fmt: skip
    payload = {"kind": "payload", "mass": f"{MASS} kg"}
    given = {"flexure": 1, "material": MATERIAL, "requirements": {"dynamic-yield": 1.5},
             "model": "exact"}  # fmt: skip

    def judged(axis, **parts):
        (shaken,) = sine(1.0, 50.0).values()
        case = {"sine": {**shaken, "axis": axis}, "q": Q}
        spec = yaml.safe_dump({**given, "cases": {"shake": case}, **parts})
        return flexcli.check(spec).checks[0]

    own = judged("y", geometry=drawn)
    carried = judged("x", geometry={**STAGE, "spacing": "30 mm"}, mechanism=payload)
    travel = 50.0 / (2.0 * pi * F_0) ** 2
    assert own.demand == pytest.approx(travel_stress(travel), rel=0.03)
    assert own.demand == pytest.approx(carried.demand, rel=0.01)
    # both are off by what the stage moves, not more
    assert own.factor_range == pytest.approx(carried.factor_range, rel=0.02)


def test_damages_of_cases_add_up_and_so_do_what_they_may_be():
    points = [{"cycles": n, "amplitude": s} for n, s in ((1e3, "800 MPa"), (1e9, "100 MPa"))]
    given = {
        "flexure": 1,
        "material": {**MATERIAL, "sn_amplitudes": {"points": points, "stress_ratio": -1}},
        "geometry": {**STAGE, "spacing": "30 mm"},
        "mechanism": {"kind": "payload", "mass": f"{MASS} kg", "damping": {"q": Q}},
        "cases": {
            "launch": {**flat(F_0 / 3.0, 3.0 * F_0, 0.02), "ends": "clamped-guided"},
            "fly": {**flat(20.0, 60.0, 0.03), "ends": "clamped-guided"},
        },
        # what else is asked of them adds nothing
        "requirements": {"dynamic-life": {"factor": 4, "method": "dirlik"}, "dynamic-buckling": 1},
    }
    # along the blades nothing resonates, and Miles' formula has nothing
    for case in given["cases"].values():
        case["asd"]["axis"] = "x and y"
    found = [c for c in flexcli.check(yaml.safe_dump(given)).checks if "life" in c.name]
    both, *each = sorted(found, key=lambda c: bool(c.case))
    assert [len(each), both.case] == [2, ""]
    assert 1.0 / both.factor == pytest.approx(sum(1.0 / c.factor for c in each))
    for end in (0, 1):
        damage = sum(1.0 / c.factor_range[end] for c in each)
        assert 1.0 / both.factor_range[end] == pytest.approx(damage)
