"""Scenes of vibration as tests are written: crossovers, Q by modes, loads at once, near modes."""

import json
import re

import numpy as np
import pytest

STAGE = """\
flexure: 1
material: {youngs_modulus: 71 GPa, yield_strength: 500 MPa, poisson_ratio: 0.33, density: 1 kg/m^3}
geometry: {kind: leaf-spring-stage, h: 1 mm, l: 40 mm, b: 15 mm}
mechanism: {kind: payload, mass: 0.5 kg, damping: {q: 20}}
cases:
  shake: {CASE}
requirements:
  dynamic-yield: 1e-3
"""
FLAT = "{points: [{frequency: LOW, level: 0.01 g^2/Hz}, {frequency: HIGH, level: 0.01 g^2/Hz}]}"


@pytest.fixture
def respond(flexure, tmp_path):
    """Return the JSON of asd response for a case, with values put over the design's."""

    def run(case, *stated, command=("asd", "response")):
        (tmp_path / "flexure.yaml").write_text(STAGE.replace("CASE", case))
        puts = [word for each in stated for word in ("--set", each)]
        told = flexure(*command, *puts, "--format", "json")
        assert told.returncode in (0, 1), told.stdout
        return json.loads(told.stdout)

    return run


def peaks(found):
    outputs = (row for response in found["responses"] for row in response["outputs"])
    return {row["name"]: row["peak"] for row in outputs}


def flat(low, high):
    return FLAT.replace("LOW", f"{low} Hz").replace("HIGH", f"{high} Hz")


def test_a_sine_of_displacement_moves_the_stage_as_its_acceleration_does(respond):
    level = 1e-4 * (2.0 * np.pi * 30.0) ** 2
    one = peaks(respond("sine: {displacement: 0.1 mm, frequency: 30 Hz}"))
    other = peaks(respond(f"sine: {{acceleration: {level!r} m/s^2, frequency: 30 Hz}}"))
    assert one == pytest.approx(other, rel=1e-9)


def test_a_sweep_peaks_at_its_resonance_with_the_level_there(respond):
    plain = respond("asd: {profile: " + flat(20, 2000) + ", q: 20}")
    f_1 = plain["values"]["f_1_shake"]["value"]
    rate = "from: 5 Hz, to: 200 Hz, rate: 2 oct/min"
    found = peaks(respond(f"sweep: {{displacement: 0.1 mm, acceleration: 100 g, {rate}}}"))
    # displacement governs below 500 Hz: z = Q times it at the resonance, to 1/Q² in all
    assert found["travel"] == pytest.approx(20.0 * 1e-4, rel=3.0 / 20.0**2)
    capped = peaks(respond(f"sweep: {{displacement: 0.1 mm, acceleration: 0.1 g, {rate}}}"))
    angular = 2.0 * np.pi * f_1
    assert capped["travel"] == pytest.approx(20.0 * 0.980665 / angular**2, rel=3.0 / 20.0**2)


def test_crossovers_are_told(respond):
    case = "sweep: {displacement: 10 mm, acceleration: 15 g, from: 5 Hz, to: 99 Hz, rate: 1 Hz/s}"
    found = respond(case)
    assert "10 mm to 19.3 Hz, 15 g to 99 Hz" in found["responses"][0]["kind"]


def test_a_mode_s_own_q_counts_for_it_alone(respond):
    profile = flat(20, 2000)
    plain = peaks(respond(f"asd: {{profile: {profile}, q: 80}}"))
    own = peaks(respond(f"asd: {{profile: {profile}, q: {{all: 5, modes: {{1: 80}}}}}}"))
    assert own["travel"] == pytest.approx(plain["travel"], rel=1e-3)
    low = peaks(respond(f"asd: {{profile: {profile}, q: 5}}"))
    assert own["travel"] > 2.0 * low["travel"]


def test_miles_takes_the_largest_q_of_any_mode(respond):
    profile = flat(20, 2000)
    found = [
        respond(f"asd: {{profile: {profile}, q: {q}}}", command=("check",))["values"]
        for q in ("80", "{all: 5, modes: {2: 80}}")
    ]
    assert found[0]["g_rms_worst"]["value"] == found[1]["g_rms_worst"]["value"]


def test_a_mode_that_is_not_there_is_told(respond):
    case = f"asd: {{profile: {flat(20, 2000)}, q: {{all: 5, modes: {{77: 80}}}}}}"
    assert "no-such-mode" in [note["code"] for note in respond(case)["warnings"]]


@pytest.mark.parametrize("q", ["{all: 0.1}", "{modes: {1: 80}}", "{all: 5, modes: {0: 80}}",
                               "{all: 5, modes: {1: 0.1}}", "{all: 5, modes: 3}"])  # fmt: skip
def test_a_wrong_q_is_a_finding(flexure, tmp_path, q):
    case = f"asd: {{profile: {flat(20, 2000)}, q: {q}}}"
    (tmp_path / "flexure.yaml").write_text(STAGE.replace("CASE", case))
    told = flexure("check")
    assert told.returncode == 2
    assert "flexure.yaml:6" in told.stderr


def test_loads_that_shake_at_once_add_up(respond):
    sine = "sine: {acceleration: 0.5 g, frequency: 30 Hz}"
    asd = f"asd: {{profile: {flat(20, 2000)}, q: 20}}"
    each = [respond(case)["checks"][0]["demand"] for case in (sine, asd)]
    both = respond(f"{sine}, {asd}")["checks"]
    assert [check["name"] for check in both] == ["dynamic yield"]
    assert both[0]["demand"] == pytest.approx(sum(each), rel=1e-9)


def lives(flexure, tmp_path, cases):
    spec = STAGE.replace("dynamic-yield: 1e-3", "dynamic-life: 4")
    spec = spec.replace("  shake: {CASE}\n", "".join(f"  {n}: {{{c}}}\n" for n, c in cases.items()))
    worn = "sn_amplitudes: {points: [{cycles: 1e4, amplitude: 300 MPa}, "
    worn += "{cycles: 1e7, amplitude: 100 MPa}], stress_ratio: -1}"
    (tmp_path / "flexure.yaml").write_text(spec.replace("density:", f"{worn}, density:"))
    told = flexure("check", "--format", "json")
    assert told.returncode in (0, 1), told.stdout + told.stderr
    return {check["case"]: check for check in json.loads(told.stdout)["checks"]}


QUIET = f"asd: {{profile: {flat(20, 99)}, q: 20, scale: -20 dB, duration: 60 s}}"


def test_a_sine_on_random_vibration_takes_from_its_life(flexure, tmp_path):
    sine = "sines: [{acceleration: 1 g, frequency: 60 Hz}]"
    weak = "sines: [{acceleration: 1e-6 g, frequency: 20 Hz}]"
    cases = {"alone": QUIET, "sine": f"{QUIET}, {sine}", "weak": f"{QUIET}, {weak}"}
    found = lives(flexure, tmp_path, cases)
    assert found["sine"]["factor"] < 0.5 * found["weak"]["factor"]
    # without a sine the least of all methods is no more than the narrow-band one's
    assert found["alone"]["factor"] <= found["weak"]["factor"] * (1.0 + 1e-6)
    assert "Rice" in found["sine"]["source"]


def test_damages_of_several_cases_add_up(flexure, tmp_path):
    longer = QUIET.replace("duration: 60 s", "duration: 120 s")
    found = lives(flexure, tmp_path, {"a": QUIET, "b": longer})
    damage = 1.0 / found["a"]["factor"] + 1.0 / found["b"]["factor"]
    assert found[""]["factor"] == pytest.approx(1.0 / damage, rel=1e-9)
    low, high = found[""]["factor_range"]
    assert low < found[""]["factor"] < high


def test_axes_in_turn_add_up_in_a_life(flexure, tmp_path):
    profile = f"{{asd: {flat(20, 99)}, scale: -20 dB, duration: 60 s}}"
    turns = f"axes: {{x: {profile}, y: {profile}}}, q: 20, combine: in-turn"
    found = lives(flexure, tmp_path, {"x": QUIET, "turns": turns})
    # what y does to a stage is nothing beside x: the same damage in twice the time
    assert found["turns"]["demand"] == pytest.approx(120.0)
    assert found["turns"]["factor"] == pytest.approx(found["x"]["factor"], rel=1e-3)


def test_a_life_under_a_shock_beside_random_vibration_is_refused(flexure, tmp_path):
    case = f"shock: {{velocity: 1 m/s}}, {QUIET}"
    spec = STAGE.replace("{CASE}", "{" + case + "}").replace(
        "dynamic-yield: 1e-3", "dynamic-life: 4"
    )
    (tmp_path / "flexure.yaml").write_text(spec)
    told = flexure("check")
    assert told.returncode == 2
    assert "a case of its own" in told.stderr


@pytest.mark.parametrize("command", [("asd", "response"), ("check",)])
def test_a_mode_just_above_the_band_is_told_with_what_it_would_do(respond, command):
    f_1 = respond(f"asd: {{profile: {flat(20, 2000)}, q: 20}}")["values"]["f_1_shake"]["value"]
    case = f"asd: {{profile: {flat(20, 0.99 * f_1)}, q: 20}}"
    found = respond(case, command=command)
    (note,) = (n for n in found["warnings"] if n["code"] == "mode-beside-band")
    less = float(re.search(r"with ([\d.]+)% less stiffness", note["text"])[1]) / 100.0
    before, after = map(float, re.search(r"from ([\d.]+) N to ([\d.]+) N", note["text"]).groups())
    if command == ("check",):
        return
    force = peaks(found)["force joint"]
    assert before == pytest.approx(force, rel=1e-3)
    softer = f"material.youngs_modulus={71.0 * (1.0 - less)!r} GPa"
    # less is rounded to 0.1 %, which moves the mode by a hundredth of its bandwidth
    assert after == pytest.approx(peaks(respond(case, softer))["force joint"], rel=2e-2)


def test_a_mode_far_from_the_band_is_not_told(respond):
    found = respond(f"asd: {{profile: {flat(500, 2000)}, q: 20}}")
    assert "mode-beside-band" not in [note["code"] for note in found["warnings"]]


def test_a_large_travel_is_told(respond):
    case = "sine: {displacement: 0.5 mm, frequency: FREQUENCY}"
    f_1 = respond(f"asd: {{profile: {flat(20, 2000)}, q: 20}}")["values"]["f_1_shake"]["value"]
    for frequency, is_told in ((f_1, True), (f_1 / 9.0, False)):  # 10 mm, and far less
        for command in (("asd", "response"), ("check",)):
            found = respond(case.replace("FREQUENCY", f"{frequency!r} Hz"), command=command)
            assert ("large-travel" in [n["code"] for n in found["warnings"]]) == is_told


ROWS = ("Miles for modes", "duration in the peak", "large rotation", "stress stiffening")


def test_a_plan_tells_what_a_vibration_calls_for(respond):
    """Blades of 40 × 15 × 1 mm that 0.5 kg shakes along them: half of P/P_cr in the frequency."""
    low = flat(20, 2000).replace("0.01 g", "1e-4 g")
    stiff = f"asd: {{profile: {low}, q: 20, duration: 2 min, axis: x and y}}"
    case = f"{stiff}, ends: clamped-guided"
    found = respond(case, command=("plan",))
    rows = {row["name"]: row for row in found["effects"]}
    assert {f"{name}, shake" for name in ROWS} <= set(rows)
    outputs = {row["name"]: row for row in respond(case)["responses"][0]["outputs"]}
    axial = outputs["axial stress joint"]["peak"]
    critical = np.pi**2 * 71e9 * 1e-3**2 / 12.0 / 0.04**2  # guided: σ_cr = π² E h²/(12 l²)
    stiffening = rows["stress stiffening, shake"]
    assert stiffening["indicator"] == pytest.approx(axial / critical, rel=0.02)
    assert stiffening["estimate"] == pytest.approx(0.5 * stiffening["indicator"], rel=1e-12)
    peak = rows["duration in the peak, shake"]
    cycles = outputs["stress joint"]["crossing_rate"] * 120.0
    assert peak["indicator"] == pytest.approx(np.sqrt(2.0 * np.log(cycles)), rel=1e-3)
    turned = rows["large rotation, shake"]["indicator"]
    assert turned == pytest.approx(outputs["travel"]["peak"] / 0.04, rel=1e-3)
    force = max(row["peak"] for name, row in outputs.items() if name.startswith("force"))
    miles = rows["Miles for modes, shake"]["indicator"]
    assert miles == pytest.approx(found_force(respond, case) / force, rel=1e-3)
    (scene,) = found["plan"]["scenes"]
    errors = {row["name"]: row["error"] for row in scene["models"]}
    assert errors[scene["model"]] == min(errors.values())
    assert errors["Miles"] >= errors["modes, closed-form"], "it leaves more out"


def found_force(respond, case):
    return respond(case, command=("check",))["values"]["F"]["value"]


def test_a_plan_without_vibration_has_none_of_them(flexure, tmp_path):
    spec = STAGE.replace("CASE", "{stroke: {translation: 1 mm}}")
    spec = spec.replace("dynamic-yield: 1e-3", "yield: 1.1")
    (tmp_path / "flexure.yaml").write_text(spec.replace("{{", "{").replace("}}}", "}}"))
    found = json.loads(flexure("plan", "--format", "json").stdout)
    assert found["effects"]
    assert not [row for row in found["effects"] if row["name"].endswith(", shake")]


def test_an_axial_force_near_the_critical_one_is_told(respond):
    loud = flat(20, 2000).replace("0.01", "1")
    case = f"asd: {{profile: {loud}, q: 20, axis: y}}, ends: clamped-guided"
    codes = [note["code"] for note in respond(case)["warnings"]]
    assert "axial-force-in-modes" in codes


BOTH = f"asd: {{profile: {flat(20, 2000)}, q: 20, axis: x and y}}"
EACH = f"axes: {{x: {{asd: {flat(20, 2000)}}}, y: {{asd: {flat(20, 2000)}, scale: -6 dB}}}}, q: 20"


def test_profiles_by_axis_add_as_squares_at_once(respond):
    along_x = peaks(respond(f"asd: {{profile: {flat(20, 2000)}, q: 20}}"))
    along_y = peaks(respond(f"asd: {{profile: {flat(20, 2000)}, scale: -6 dB, axis: y, q: 20}}"))
    both = peaks(respond(EACH))
    for name in ("travel", "force joint"):
        alone = np.hypot(along_x[name], along_y[name])
        assert both[name] == pytest.approx(alone, rel=1e-9)
    same = EACH.replace(", scale: -6 dB", "")
    assert peaks(respond(same)) == pytest.approx(peaks(respond(BOTH)), rel=1e-9)


def test_axes_in_turn_are_judged_one_by_one(respond):
    found = respond(EACH + ", combine: in-turn")
    (demand,) = (row["demand"] for row in found["checks"])
    each = [
        respond(f"asd: {{profile: {flat(20, 2000)}, scale: {db} dB, axis: {axis}, q: 20}}")
        for axis, db in (("x", 0), ("y", -6))
    ]
    alone = [row["demand"] for one in each for row in one["checks"]]
    assert demand == pytest.approx(max(alone), rel=1e-9)
    (together,) = respond(EACH)["checks"]
    assert demand < together["demand"]


def test_sines_stand_on_the_random_vibration_of_their_case(respond):
    random = f"asd: {{profile: {flat(20, 2000)}}}, q: 20"
    (alone,) = respond(random)["checks"]
    (sine,) = respond("sine: {acceleration: 2 g, frequency: 40 Hz}, q: 20")["checks"]
    tone = "sines: [{acceleration: 2 g, frequency: 40 Hz}]"
    (both,) = respond(f"{random}, {tone}")["checks"]
    assert both["demand"] == pytest.approx(alone["demand"] + sine["demand"], rel=1e-9)
    # anywhere in a band it is no weaker than at the band's ends
    band = tone.replace("frequency: 40 Hz", "from: 40 Hz, to: 45 Hz")
    (wide,) = respond(f"{random}, {band}")["checks"]
    assert wide["demand"] >= both["demand"]


def test_the_q_of_a_case_serves_all_of_its_loads(respond):
    own = f"asd: {{profile: {flat(20, 2000)}, q: {{all: 20, modes: {{1: 80}}}}}}"
    case = f"asd: {{profile: {flat(20, 2000)}}}, q: {{all: 20, modes: {{1: 80}}}}"
    assert peaks(respond(case)) == peaks(respond(own))


@pytest.mark.parametrize(
    ("case", "told"),
    [
        (EACH.replace(", q: 20", ""), "add q: 50 to the case"),
        (EACH + ", " + BOTH, "stand beside an asd"),
        ("combine: in-turn, asd: {profile: gevs-qualification, q: 20}", "no axes to act"),
        ("sigma: 4, asd: {profile: gevs-qualification, q: 20}", "sigma is that of axes"),
        ("q: 20, stroke: {translation: 1 mm}", "nothing vibrates"),
        ("sines: [{acceleration: 2 g}], q: 20", "stands at one frequency"),
        ("axes: {x: {asd: gevs-quali}}, q: 20", "gevs-qualification"),
    ],
)
def test_axes_and_sines_that_say_too_little_or_too_much_are_findings(flexure, tmp_path, case, told):
    undamped = STAGE.replace(", damping: {q: 20}", "")
    (tmp_path / "flexure.yaml").write_text(undamped.replace("CASE", case))
    found = flexure("check")
    assert found.returncode == 2
    assert told in re.sub(r"\s+", " ", found.stdout + found.stderr)


def test_a_table_may_be_the_profile_of_an_axis(respond, tmp_path):
    (tmp_path / "psd.csv").write_text("frequency [Hz],level [g^2/Hz]\n20,0.01\n2000,0.01\n")
    by_table = respond("axes: {x: {asd: psd.csv}}, q: 20")
    assert peaks(by_table) == pytest.approx(
        peaks(respond(f"asd: {{profile: {flat(20, 2000)}, q: 20}}")), rel=1e-9
    )


def test_a_plan_estimates_modes_blade_mass_and_build_up(flexure, tmp_path):
    spec = STAGE.replace("density: 1 kg/m^3", "density: 2800 kg/m^3")
    case = f"{{asd: {{profile: {flat(20, 2000)}, q: 20}}}}"
    sweep = "{sweep: {acceleration: 1 g, from: 5 Hz, to: 200 Hz, rate: 30 oct/min}, q: 500}"
    cases = f"  shake: {case}\n  sweep: {sweep}\n"
    (tmp_path / "flexure.yaml").write_text(spec.replace("  shake: {CASE}\n", cases))
    told = flexure("plan", "--format", "json")
    rows = {row["name"]: row for row in json.loads(told.stdout)["effects"]}
    assert rows["higher modes, shake"]["on"]
    assert rows["blade mass, shake"]["on"]
    # two blades of 1.7 g move a part of it with 500 g: a percent at most
    assert 0.0 < rows["blade mass, shake"]["estimate"] < 0.01
    assert rows["steady for transient, sweep"]["estimate"] > 1.0


STACK = """\
flexure: 1
material: {youngs_modulus: 114 GPa, yield_strength: 880 MPa, density: 1 kg/m^3, poisson_ratio: 0}
effects: {plate-widening: off}
geometry:
  kind: layout
  bodies:
    low: {at: [0 mm, 20 mm], mass: 50 g, inertia: 1e-5 kg*m^2}
    high: {at: [0 mm, 40 mm], mass: 50 g, inertia: 1e-5 kg*m^2}
  blades:
    l1: {between: [ground, low], from: [-20 mm, 0 mm], to: [-20 mm, 20 mm], h: 1 mm, b: 10 mm}
    r1: {between: [ground, low], from: [20 mm, 0 mm], to: [20 mm, 20 mm], h: 1 mm, b: 10 mm}
    l2: {between: [low, high], from: [-20 mm, 20 mm], to: [-20 mm, 40 mm], h: 1 mm, b: 10 mm}
    r2: {between: [low, high], from: [20 mm, 20 mm], to: [20 mm, 40 mm], h: 1 mm, b: 10 mm}
  moving: high
  motion: {translation: 0 deg}
mechanism: {kind: payload, mass: 1 mg, damping: {q: 25}}
cases:
  shake: {CASE}
requirements:
  dynamic-yield: 1e-3
"""


def stress_in_stack(flexure, tmp_path, case):
    (tmp_path / "flexure.yaml").write_text(STACK.replace("CASE", case))
    told = flexure("asd", "response", "--format", "json")
    assert told.returncode == 0, told.stdout
    return peaks(json.loads(told.stdout))["stress joint"]


def test_a_slow_shock_loads_two_stages_as_their_weight_does(flexure, tmp_path):
    # 80 periods long: both modes follow the pulse, and meet in its middle
    case = "shock: {half-sine: {acceleration: 40 g, duration: 600 ms}}"
    found = stress_in_stack(flexure, tmp_path, case)
    force = 2 * 0.05 * 40 * 9.80665 / 2.0  # both masses, on each of two blades
    bending = 6.0 * (force * 0.02 / 2.0) / (0.01 * 1e-3**2)  # S shape: M = F l/2
    # the edge of the pulse makes the modes swing a little
    assert found == pytest.approx(bending, rel=0.02)


def test_modes_that_meet_under_a_spectrum_add_up(flexure, tmp_path):
    points = "{frequency: 1 Hz, acceleration: 40 g}, {frequency: 100 kHz, acceleration: 40 g}"
    level = stress_in_stack(flexure, tmp_path, f"shock: {{srs: [{points}]}}")
    k, m = 2.0 * 114e9 * 0.01 * 1e-3**3 / 0.02**3, 0.05
    squares, shapes = np.linalg.eigh(np.array([[2 * k, -k], [-k, k]]) / m)
    moved = shapes[0] * shapes.sum(axis=0) / squares * 40 * 9.80665  # of the lower stage, by mode
    expected = 3.0 * 114e9 * 1e-3 / 0.02**2 * np.abs(moved).sum()
    assert level == pytest.approx(expected, rel=0.02)


def test_a_spectrum_may_end_below_the_modes_inside_blades_alone(flexure, tmp_path):
    """Modes of the blades above it have no part in the stress, the stage's own mode has all."""
    ends = "{frequency: 10 Hz, acceleration: 2 g}, {frequency: HIGH Hz, acceleration: 20 g}"
    text = STAGE.replace("CASE", f"shock: {{srs: [{ends}]}}").replace("1 kg/m^3", "2800 kg/m^3")
    spec = tmp_path / "flexure.yaml"
    spec.write_text(text.replace("HIGH", "2000"))
    told = flexure("check", "--format", "json")
    assert told.returncode == 0, told.stdout
    spec.write_text(text.replace("HIGH", "20"))
    told = flexure("check")
    assert told.returncode == 2
    assert "the spectrum ends at 20 Hz" in told.stderr
