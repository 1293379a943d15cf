"""Layouts sized: against the joints that they draw, against brute force, and from other starts."""

import itertools
from math import exp, log
from pathlib import Path

import numpy as np
import pytest

import flexcli
from flexcli.engine.joint_models import joint_states
from flexcli.engine.judge import judge
from flexcli.engine.models import model_series
from flexcli.engine.sizing.decided import STEP, judged_at, slopes_at
from flexcli.errors import NoSolution
from flexcli.results import Status

EXAMPLES = Path(__file__).parents[2] / "examples"

STAGE = """flexure: 1
material: ti-6al-4v
{geometry}
cases: {{operation: {{stroke: {{translation: 2 mm, cycles: 1e7}}}}}}
requirements: {{fatigue: 1.5, stiffness: {{min: 0.2 N/mm}}}}
model: exact
"""
JOINT = """geometry:
  kind: leaf-spring-stage
  l: {free: [10 mm, 60 mm]}
  h: {free: [0.1 mm, 0.4 mm]}
  b: 1 mm
  spacing: 20 mm
"""
DRAWING = """parameters: {l: {free: [10 mm, 60 mm]}, h: {free: [0.1 mm, 0.4 mm]}, gap: 20 mm}
geometry:
  kind: layout
  bodies: {stage: {at: [l/2, gap/2]}}
  blades:
    low: {between: [ground, stage], from: [0 mm, 0 mm], to: [l, 0 mm], h: h, b: 1 mm}
    high: {between: [ground, stage], from: [0 mm, gap], to: [l, gap], h: h, b: 1 mm}
  moving: stage
  motion: {translation: 90 deg}
"""

GUIDED = """flexure: 1
material: ti-6al-4v
parameters: {{l: {{free: {l}}}, h: {{free: {h}}}, gap: 30 mm}}
geometry:
  kind: space-layout
  bodies:
    stage: {{at: [l, 0 mm, 0 mm], mass: 50 g, inertia: [1e-5 kg*m^2, 1e-5 kg*m^2, 2e-5 kg*m^2]}}
  blades:
    pair: {{between: [ground, stage], from: [0 mm, gap/2, 0 mm], to: [l, gap/2, 0 mm],
            h: h, b: 20 mm, width: z, mirror: [y]}}
  moving: stage
  motion: {{translation: y}}
cases: {{operation: {{stroke: {{translation: 1.5 mm, cycles: 1e7}}}}}}
requirements: {{fatigue: {fatigue}, frequency: {{min: 35 Hz}}}}
model: linear
"""
RANGES = {"l": "[20 mm, 90 mm]", "h": "[0.05 mm, 0.6 mm]", "fatigue": "6"}


def sizes(result, names="lh"):
    return [result.values[name].value for name in names]


def passes(design, l, h):
    at = design.geometry.sized({"l": float(l), "h": float(h)})
    return judge(*design.redrawn(at), model_series(design)).status is Status.PASS


@pytest.mark.slow
def test_a_drawn_stage_is_sized_as_the_joint_that_it_draws():
    joint = flexcli.size(STAGE.format(geometry=JOINT))
    drawn = flexcli.size(STAGE.format(geometry=DRAWING))
    assert drawn.status is joint.status is Status.PASS
    # the estimates of a drawing's plates are wider by some 0.1 % of a factor
    assert sizes(drawn) == pytest.approx(sizes(joint), rel=3e-3)
    assert "local optimum by the exact model" in drawn.sizing.certificate
    assert "not proved" in drawn.sizing.certificate


@pytest.fixture(scope="module")
def guided():
    spec = flexcli.load(GUIDED.format(**RANGES))
    return spec, flexcli.size(spec)


@pytest.mark.slow
def test_no_passing_point_of_a_grid_betters_a_layout_sized_in_space(guided):
    spec, found = guided
    design = spec.part
    assert found.status is Status.PASS
    l, h = sizes(found)
    assert len(found.sizing.active) == 2
    near = itertools.product(np.exp(np.linspace(-0.04, 0.04, 5)), repeat=2)
    far = itertools.product((0.6, 0.8, 1.25, 1.6), repeat=2)
    passing = [x * y for x, y in [*near, *far] if passes(design, l * x, h * y)]
    assert len(passing) > 1
    # the volume goes as l h; the sizing keeps a millionth of what is asked in hand
    assert min(passing) > 1.0 - 1e-5


@pytest.mark.slow
@pytest.mark.parametrize(
    ("l", "h"), [("[35 mm, 300 mm]", "[0.15 mm, 5 mm]"), ("[5 mm, 70 mm]", "[0.02 mm, 0.5 mm]")]
)
def test_other_ranges_of_the_same_problem_lead_to_the_same_optimum(guided, l, h):
    other = flexcli.size(GUIDED.format(**RANGES | {"l": l, "h": h}))
    assert sizes(other) == pytest.approx(sizes(guided[1]), rel=1e-5)


def test_a_sized_layout_keeps_its_grid_and_its_objective():
    size = "size: {objective: {minimize: l}, round: {h: 10 um}}\n"
    given = {"parameters.l": "55 mm", "parameters.h": "500 um"}
    spec = flexcli.load(GUIDED.format(**RANGES) + size, overrides=given)
    assert not spec.part.geometry.free
    assert flexcli.size(spec).status is flexcli.verdicts(spec).status


@pytest.mark.slow
def test_a_sized_layout_is_written_in_place_and_passes_a_check(guided, tmp_path):
    spec, found = guided
    text = flexcli.spec_text(flexcli.sized(spec, found), tmp_path)
    assert "from: [0 mm, gap/2, 0 mm]" in text
    assert "free" not in text
    again = flexcli.check(text)
    assert again.status is Status.PASS
    told = {check.full_name: check.factor for check in again.checks}
    assert told == pytest.approx({c.full_name: c.factor for c in found.checks}, rel=1e-9)


@pytest.mark.slow
def test_a_layout_is_sized_on_its_grid():
    text = GUIDED.format(**RANGES) + "size: {round: {l: 0.5 mm, h: 10 um}}\n"
    found = flexcli.size(text)
    assert found.status is Status.PASS
    l, h = sizes(found)
    assert l / 0.5e-3 == pytest.approx(round(l / 0.5e-3), abs=1e-6)
    assert h / 10e-6 == pytest.approx(round(h / 10e-6), abs=1e-6)
    ideal_l, ideal_h = sizes(found, ["l_ideal", "h_ideal"])
    assert l * h < 1.1 * ideal_l * ideal_h


@pytest.mark.slow
def test_slopes_are_those_of_finer_differences(guided):
    spec, _ = guided
    design = spec.part
    models = model_series(design)
    here = {"l": 50e-3, "h": 0.4e-3}

    def shares(**factors):
        at = design.geometry.sized({n: here[n] * factors.get(n, 1.0) for n in here})
        used = judged_at(design, at, models).used
        return {name: log(each.share) for name, each in used.items()}

    found = slopes_at(design, judged_at(design, design.geometry.sized(here), models), models)
    step = 4e-3
    for k, name in enumerate(here):
        one, two, three, four = (shares(**{name: exp(i * step)}) for i in (-2, -1, 1, 2))
        for check, slope in found.items():
            fourth = one[check] - 8.0 * two[check] + 8.0 * three[check] - four[check]
            assert slope[k] == pytest.approx(fourth / (12.0 * step), rel=1e-6, abs=1e-6)


STROKES = """requirements:
  parasitic_shift: {max: 0.1 mm}
  support: {direction: z, min: 1 N/um, at: full-stroke}
"""


@pytest.mark.slow
def test_slopes_of_exact_beams_in_space_are_those_of_solutions_on_both_sides():
    text = GUIDED.format(**RANGES).replace("model: linear", "model: exact")
    kept = [line for line in text.splitlines(True) if not line.startswith("requirements")]
    design = flexcli.load("".join(kept) + STROKES).part
    models, here = model_series(design), {"l": 60e-3, "h": 0.3e-3}
    found = slopes_at(design, judged_at(design, design.geometry.sized(here), models), models)
    assert len(found) == 2
    for k, name in enumerate(here):
        above, below = (
            judged_at(design, design.geometry.sized({**here, name: here[name] * x}), models).used
            for x in (1.0 + STEP, 1.0 - STEP)
        )
        for check, slope in found.items():
            change = log(above[check].share / below[check].share)
            # implicit derivatives are even in the step but for its cube
            assert slope[k] == pytest.approx(change / log((1.0 + STEP) / (1.0 - STEP)), abs=STEP**2)


def test_slopes_in_the_plane_are_those_of_whole_solutions_and_solve_nothing(monkeypatch):
    asked = "requirements: {fatigue: 1.5, parasitic_shift: {max: 0.2 mm}, yield: 2}"
    text = STAGE.format(geometry=DRAWING).replace("1e7}}}", "1e7}, wrench: {x: 0.2 N, y: 0.1 N}}}")
    text = text.replace("fatigue: 1.5, stiffness: {min: 0.2 N/mm}", "").replace(
        "requirements: {}", asked
    )
    design, here = flexcli.load(text).part, {"l": 25e-3, "h": 0.2e-3}
    models = model_series(design)

    def judged(**sizes):
        return judged_at(design, design.geometry.sized({**here, **sizes}), models)

    place, solved = judged(), []
    assert len(place.used) == 3
    solve = joint_states.solve
    monkeypatch.setattr(joint_states, "solve", lambda *a, **k: solved.append(a) or solve(*a, **k))
    found = slopes_at(design, place, models)
    assert not solved
    for k, (name, size) in enumerate(here.items()):
        step = 4e-3
        logs = [
            {
                check: log(each.share)
                for check, each in judged(**{name: size * exp(i * step)}).used.items()
            }
            for i in (-2, -1, 1, 2)
        ]
        for check, slope in found.items():
            one, two, three, four = (each[check] for each in logs)
            whole = (one - 8.0 * two + 8.0 * three - four) / (12.0 * step)
            # of a stress the share that the loads bend is kept
            kept = 0.0 if check.startswith("parasitic") else 2e-3
            assert slope[k] == pytest.approx(whole, abs=3.0 * STEP**2 + kept)
    assert len(solved) > 8


@pytest.mark.slow
def test_a_layout_is_sized_up_to_where_the_model_knows_its_error_and_says_so():
    # the error of a support stiffness at a stroke is known up to b/l = 3
    text = GUIDED.format(**RANGES).replace("model: linear", "model: exact")
    text = text.replace("b: 20 mm", "b: 120 mm")
    asked = """requirements:
  frequency: {min: 35 Hz}
  support: {direction: z, min: 0.1 N/um, at: full-stroke}
"""
    kept = [line for line in text.splitlines(True) if not line.startswith("requirements")]
    found = flexcli.size("".join([*kept, asked]))
    assert sizes(found, "l") == pytest.approx([40e-3], rel=2e-4)
    assert "some numbers have no known error" in found.sizing.certificate


@pytest.mark.slow
def test_requirements_that_conflict_are_named_without_a_claim_of_proof():
    found = flexcli.size(GUIDED.format(**{**RANGES, "l": "[20 mm, 40 mm]", "fatigue": "20"}))
    assert found.status is Status.INFEASIBLE
    told = " ".join(each.name for each in found.sizing.conflict)
    assert "fatigue" in told
    assert "frequency" in told
    assert "no proof" in found.sizing.certificate


def test_the_thickness_of_a_drawn_blade_is_free_without_parameters():
    drawing = DRAWING.partition("\n")[2].replace("h: h", "h: {free: [0.05 mm, 0.4 mm]}")
    drawing = drawing.replace("l/2", "10 mm").replace("gap/2", "10 mm").replace("gap", "20 mm")
    text = STAGE.format(geometry=drawing.replace("[l,", "[20 mm,")).replace("exact", "linear")
    text = "".join(line for line in text.splitlines(True) if not line.startswith("cases"))
    found = flexcli.size(text.replace("fatigue: 1.5, ", ""))
    assert found.status is Status.PASS
    low, high = sizes(found, ["h_low", "h_high"])
    # the sum of the cubes is given, and that of the thicknesses is least where one has it all
    assert low + high < 0.9 * 2.0 * ((low**3 + high**3) / 2.0) ** (1.0 / 3.0)


@pytest.mark.slow
def test_an_angle_may_be_free():
    text = """flexure: 1
material: ti-6al-4v
parameters: {a: {free: [20 deg, 70 deg]}, l: 20 mm, h: {free: [0.1 mm, 0.5 mm]}}
geometry:
  kind: layout
  bodies: {rotor: {at: [0 mm, 0 mm]}}
  blades:
    one: {between: [ground, rotor], from: [-l/2*cos(a), -l/2*sin(a)], to: [l/2*cos(a), l/2*sin(a)],
          h: h, b: 5 mm, z: 5 mm}
    two: {between: [ground, rotor], from: [l/2*cos(a), -l/2*sin(a)], to: [-l/2*cos(a), l/2*sin(a)],
          h: h, b: 5 mm, z: -5 mm}
  moving: rotor
  motion: rotation
requirements: {stiffness: {equals: 0.5 N*m/rad}}
model: linear
size: {objective: {minimize: a}}
"""
    found = flexcli.size(text)
    assert found.status is Status.PASS
    assert found.values["a"].unit == "rad"
    assert found.values["a"].value == pytest.approx(np.radians(20.0), rel=1e-6)
    # two blades crossed in their middles: 2 E I/l
    E = 113.8e9
    h = found.values["h"].value
    assert E * 5e-3 * h**3 / 6.0 / 20e-3 == pytest.approx(0.5, rel=0.2)


def test_what_no_formula_tells_is_no_objective():
    text = GUIDED.format(**RANGES) + "size: {objective: least-stiffness}\n"
    with pytest.raises(NoSolution, match="stiffness"):
        flexcli.size(text)


@pytest.mark.slow
@pytest.mark.parametrize(
    "example",
    # thinner blades of the last buckle, where their strength ends by a jump
    ["folded-stage", "butterfly-pivot", "tripod-mount", "kinematic-mount"],
)
def test_examples_that_leave_sizes_free_are_sized_to_pass(example):
    found = flexcli.size(EXAMPLES / example / "to-size.yaml")
    assert found.status is Status.PASS


TANGENTIAL = """\
flexure: 1
material: ti-6al-4v
parameters: {l: {free: [8 mm, 60 mm]}}
geometry:
  kind: space-layout
  bodies: {mirror: {at: [0 mm, 0 mm, 0 mm]}}
  blades:
    tangent: {between: [ground, mirror], from: [75 mm, -l/2, 0 mm], to: [75 mm, l/2, 0 mm],
              h: 0.5 mm, b: 8 mm, width: z, repeat: {count: 3, about: z}}
  moving: mirror
  motion: {translation: z}
cases:
  cold: {temperature: {uniform: -70 K, expansion: {ground: 23e-6 1/K, mirror: 0.5e-6 1/K}}}
requirements: {yield: 3}
size: {objective: least-volume}
"""


@pytest.mark.slow
def test_a_kinematic_mount_is_sized_for_the_cold():
    """Each blade gives way by the radius' growth u between clamps: σ = 3 E h u/l²."""
    spec = flexcli.load(TANGENTIAL)
    result = flexcli.size(spec)
    (l,) = (value.value for name, value in result.values.items() if name == "l")
    along, across = result.checks
    u = 75e-3 * (23e-6 - 0.5e-6) * 70.0
    by_hand = 3.0 * 113.8e9 * 0.5e-3 * u / l**2
    assert by_hand < along.demand < by_hand / (1.0 - 0.342**2)  # from a strip to a plate
    assert across.demand > along.demand  # clamps keep blades from growing across
    assert (
        flexcli.verdicts(TANGENTIAL.replace("{free: [8 mm, 60 mm]}", f"{l!r} m")).status
        is Status.PASS
    )
    short = TANGENTIAL.replace("{free: [8 mm, 60 mm]}", f"{0.95 * l!r} m")
    assert flexcli.verdicts(short).status is not Status.PASS


def test_models_after_the_first_are_asked_of_a_drawing_as_it_is_drawn():
    text = GUIDED.format(**RANGES).replace("model: linear\n", "")
    design = flexcli.load(text).part
    at = design.geometry.sized({"l": 50e-3, "h": 0.4e-3})
    assert judged_at(design, at, model_series(design)).used
