"""Fronts against the convex truth, options against sizing each, objectives that grow."""

import numpy as np
import pytest

import flexcli
from flexcli import api
from flexcli.engine import trade_off
from flexcli.errors import SpecError
from flexcli.parts.trade_off import MovingBound
from flexcli.results.trade_off import FrontPoint

STAGE = """\
flexure: 1
title: guide
model: closed-form
material: {youngs_modulus: 100 GPa, poisson_ratio: 0, yield_strength: 800 MPa}
geometry:
  kind: leaf-spring-stage
  blades: 2
  spacing: 20 mm
  h: {free: [20 um, 1 mm]}
  l: {free: [5 mm, 200 mm]}
  b: 10 mm
  clamps: rigid
stroke: {translation: 1 mm}
requirements: {yield: 4, stiffness: {min: 0.3 N/mm}, parasitic_shift: {max: 1 mm}}
size: SIZE
"""

SLENDER = (300.0 / (2.0 * 100e9 * 10e-3)) ** (1.0 / 3.0)
"""h/l at the least stiffness: 2 E b (h/l)³ = 300 N/m."""


def front_of(size, **overrides):
    return flexcli.size(STAGE.replace("SIZE", size), overrides=overrides or None)


@pytest.mark.slow
def test_a_front_is_the_convex_truth_evenly_spread_and_proved():
    found = front_of("{objective: [volume, parasitic_shift], points: 7}")
    front = found.front
    assert found.status.value == "pass"
    assert front.proved
    assert len(front.points) == 7
    shifts = np.array([point.second for point in front.points])
    volumes = np.array([point.first for point in front.points])
    assert (np.diff(shifts) < 0.0).all()
    # 0.6 x²/l, and h in proportion to l: (x/l)² corrects the shortest by 1 %
    l = 0.6 * (1e-3) ** 2 / shifts
    assert volumes == pytest.approx(2.0 * 10e-3 * SLENDER * l**2, rel=0.02)
    steps = np.hypot(np.diff(np.log(shifts)), np.diff(np.log(volumes)))
    assert steps.max() < 2.6 * steps.min()
    assert front.knee is None  # a straight line in logarithms
    # up to the longest blade: 0.6 x²/200 mm
    assert shifts[-1] == pytest.approx(3e-6 / (SLENDER * 200.0), rel=0.1) or shifts[-1] < 3.4e-6


@pytest.mark.slow
def test_each_design_of_a_front_passes_its_check_and_no_grid_has_a_better_one():
    text = STAGE.replace("SIZE", "{objective: [volume, parasitic_shift], points: 5}")
    points = flexcli.size(text).front.points
    h, l = np.meshgrid(np.geomspace(20e-6, 1e-3, 400), np.geomspace(5e-3, 0.2, 400))
    k, stress = 2.0 * 100e9 * 10e-3 * (h / l) ** 3, 3.0 * 100e9 * h * 1e-3 / l**2
    feasible = (k >= 300.0) & (4.0 * stress <= 800e6)
    shift, volume = 0.6e-6 / l, 2.0 * 10e-3 * h * l
    for point in points:
        sizes = {f"geometry.{name}": f"{x} m" for name, x in point.sizes.items()}
        bound = 1e-3 if point.bound is None else point.bound
        assert point.second <= bound
        asked = {"requirements.parasitic_shift.max": f"{bound!r} m"}
        assert flexcli.check(text, overrides={**sizes, **asked}).status.value == "pass"
        better = feasible & (shift <= point.second) & (volume < point.first * 0.98)
        assert not better.any()  # but for the 2 % that the formulas of the grid leave out


@pytest.mark.slow
def test_the_knee_is_where_another_limit_takes_over():
    thin = {"geometry.h": {"free": ["0.1 mm", "1 mm"]}, "requirements.yield": 2}
    front = front_of("{objective: [volume, {maximize: yield}], points: 9}", **thin).front
    # the least thickness holds up to l = h/SLENDER; beyond, h grows with l
    l = 0.1e-3 / SLENDER
    factor = 800e6 * l**2 / (3.0 * 100e9 * 0.1e-3 * 1e-3)
    factors = [point.second for point in front.points]
    assert factors == sorted(factors)
    knee = factors[front.knee]
    assert knee == pytest.approx(factor, rel=0.5)  # one of nine designs over two decades
    assert front.second == "yield"


MATERIALS = "[ti-6al-4v, maraging-300, 6061-t6]"


def test_the_best_of_several_materials_is_taken():
    text = STAGE.replace("poisson_ratio: 0", "poisson_ratio: 0.3").replace("yield: 4", "yield: 10")
    size = f"{{objective: {{minimize: mass}}, among: {{material: {MATERIALS}}}}}"
    found = flexcli.size(text.replace("SIZE", size))
    masses = {}
    for material in MATERIALS.strip("[]").split(", "):
        alone = flexcli.size(text.replace("SIZE", "{}"), overrides={"material": material})
        if alone.status.value == "pass":
            density = flexcli.load(
                text.replace("SIZE", "{}"), overrides={"material": material}
            ).part.material.density.value
            masses[material] = alone.values["volume"].value * density
    assert len(masses) > 1
    best = min(masses, key=masses.get)
    assert found.choices.chosen == {"material": best}
    told = {row.option["material"]: row.objective for row in found.choices.rows}
    assert told == pytest.approx({**told, **masses}, rel=1e-6)


def test_the_saved_design_has_the_option_that_was_taken(tmp_path):
    size = f"{{objective: {{minimize: mass}}, among: {{material: {MATERIALS}}}}}"
    text = STAGE.replace("SIZE", size)
    (tmp_path / "flexure.yaml").write_text(text, encoding="utf-8")
    found = flexcli.size(text)
    saved = tmp_path / "sized.yaml"
    saved.write_text(api.spec_text(api.sized(text, found), tmp_path), encoding="utf-8")
    material = flexcli.load(saved).part.material.name
    chosen = flexcli.load(text, overrides=found.choices.chosen).part.material.name
    other = flexcli.load(text).part.material.name
    assert material == chosen != other
    assert flexcli.check(saved).status.value == "pass"


def test_the_largest_stiffness_is_what_the_strength_allows():
    found = front_of("{objective: {maximize: k_pivot}}", **{"geometry.l": "40 mm"})
    # 4 · 3 E h x/l² = 800 MPa
    h = 200e6 * 40e-3**2 / (3.0 * 100e9 * 1e-3)
    assert found.values["h"].value == pytest.approx(min(h, 1e-3), rel=2e-3)


@pytest.mark.parametrize("goal", ["{minimize: parasitic_shift}", "{maximize: yield}"])
def test_a_requirement_is_an_objective(goal):
    found = front_of(f"{{objective: {goal}}}")
    # both get better with the length, up to the thickest blade of the least stiffness
    assert found.status.value == "pass"
    assert found.values["h"].value == pytest.approx(1e-3, rel=1e-6)
    assert found.values["l"].value == pytest.approx(1e-3 / SLENDER, rel=2e-3)
    assert found.sizing.objective == goal.strip("{}").replace(":", "")
    assert "global optimum" in found.sizing.certificate
    assert {name.partition(":")[0] for name in found.sizing.active} == {"stiffness (min)", "most h"}


def test_a_requirement_as_an_objective_keeps_the_grid():
    found = front_of("{objective: {minimize: parasitic_shift}, round: {h: 50 um, l: 5 mm}}")
    l = 5e-3 * np.arange(1, 41)[:, None]
    h = 50e-6 * np.arange(1, 21)
    feasible = (h / l >= SLENDER) & (3e8 * h / l**2 * 4.0 <= 800e6)
    longest = float(np.where(feasible, l, 0.0).max())
    assert found.values["l"].value == pytest.approx(longest)
    assert "proved" in found.sizing.remarks[0]


DRAWING = """\
flexure: 1
material: ti-6al-4v
parameters: {l: {free: [20 mm, 90 mm]}, h: {free: [0.05 mm, 0.6 mm]}, gap: 30 mm}
geometry:
  kind: space-layout
  bodies:
    stage: {at: [l, 0 mm, 0 mm], mass: 50 g, inertia: [1e-5 kg*m^2, 1e-5 kg*m^2, 2e-5 kg*m^2]}
  blades:
    pair: {between: [ground, stage], from: [0 mm, gap/2, 0 mm], to: [l, gap/2, 0 mm],
            h: h, b: 20 mm, width: z, mirror: [y]}
  moving: stage
  motion: {translation: y}
cases: {operation: {stroke: {translation: 1.5 mm, cycles: 1e7}}}
requirements: {fatigue: 2, frequency: {min: 20 Hz}, stiffness: {max: 5 N/mm}}
model: linear
size: SIZE
"""


@pytest.mark.slow
def test_the_best_of_a_requirement_of_a_drawing_is_what_others_allow():
    found = flexcli.size(DRAWING.replace("SIZE", "{objective: {maximize: frequency}}"))
    assert found.status.value == "pass"
    (frequency,) = (check for check in found.checks if check.name.startswith("frequency"))
    # k = 5 N/mm and 50 g, the mass of the blades beside
    assert frequency.capacity == pytest.approx(np.sqrt(5e3 / 50e-3) / (2.0 * np.pi), rel=0.05)
    sizes = {f"parameters.{name}": found.values[name].value for name in "lh"}
    for l, h in [(1.02, 1.0), (0.98, 1.0), (1.0, 1.02), (1.0, 0.98), (1.02, 1.02), (0.98, 0.98)]:
        moved = dict(zip(sizes, (l, h), strict=True))
        near = {key: f"{size * moved[key]!r} m" for key, size in sizes.items()}
        other = flexcli.check(DRAWING.replace("SIZE", "{}"), overrides=near)
        (now,) = (check for check in other.checks if check.name.startswith("frequency"))
        assert other.status.value != "pass" or now.capacity < frequency.capacity * (1.0 + 1e-6)


@pytest.mark.slow
def test_a_front_of_a_drawing_ends_at_the_best_of_both_objectives():
    size = "{objective: [volume, {maximize: frequency}], points: 4}"
    front = flexcli.size(DRAWING.replace("SIZE", size)).front
    alone = flexcli.size(DRAWING.replace("SIZE", "{objective: {maximize: frequency}}"))
    (frequency,) = (check for check in alone.checks if check.name.startswith("frequency"))
    assert len(front.points) == 4
    assert front.points[-1].second == pytest.approx(frequency.capacity, rel=3e-3)
    assert (np.diff([point.first for point in front.points]) > 0.0).all()
    for point in front.points:
        sizes = {f"parameters.{name}": f"{x!r} m" for name, x in point.sizes.items()}
        asked = {"requirements.frequency.min": f"{point.bound or 20.0!r} Hz"}
        again = flexcli.check(DRAWING.replace("SIZE", "{}"), overrides={**sizes, **asked})
        assert again.status.value == "pass"


@pytest.mark.parametrize(
    ("size", "told"),
    [
        ("{objective: [volume, frequency]}", "nothing is asked of 'frequency'"),
        ("{objective: [volume, stiffness]}", "no bound of 'stiffness' to minimize"),
        ("{objective: [volume]}", "a list of objectives has two"),
        ("{objective: [parasitic_shift, volume]}", "the second objective is a requirement"),
        ("{objective: [parasitic_shift, parasitic_shift]}", "both objectives are parasitic_shift"),
        ("{objective: {maximize: frequency}}", "nothing is asked of 'frequency'"),
        ("{objective: {minimize: stiffness}}", "no bound of 'stiffness' to minimize"),
        ("{objective: {minimize: yield}}", "no bound of 'yield' to minimize"),
        ("{objective: {maximize: beauty}}", "no size 'beauty'"),
        ("{among: {material: ti-6al-4v}}", "a choice is among two or more"),
    ],
)
def test_an_objective_that_is_not_asked_for_is_a_finding(size, told):
    with pytest.raises(SpecError, match=told):
        flexcli.load(STAGE.replace("SIZE", size))


def test_a_choice_without_any_design_that_passes_says_why_of_each():
    size = "{among: {geometry.b: [1 um, 2 um]}}"
    found = front_of(size)
    assert found.status.value == "infeasible"
    assert all(row.reason.startswith("in conflict") for row in found.choices.rows)


def test_a_shift_far_below_what_any_blade_has_is_a_conflict():
    asked = {"requirements.parasitic_shift.max": "0.15 um"}  # no bound of h alone would end it
    found = front_of("{}", **asked)
    assert found.status.value == "infeasible"
    assert any("0.15" in row.text or "150 nm" in row.text for row in found.sizing.conflict)


def test_a_front_that_jumps_is_filled_on_either_side_and_no_further():
    """Whatever is asked between 2 and 8 gives the design at 8 again, to some digits."""
    moving = MovingBound("frequency", ("requirements", "frequency", "min"), True, "frequency")
    asked = []

    class Jumping(trade_off._Run):
        def at(self, bound, near=None):
            asked.append(bound)
            second = bound if bound <= 2.0 else max(bound, 8.0 * (1.0 + 1e-9 * len(asked)))
            point = FrontPoint(second, second, bound, {"l": second}, "", {})
            self.found.append(point)
            return point

    design = flexcli.load(STAGE.replace("SIZE", "{}")).part
    run = Jumping(design, moving, None, None)
    run.at(1.0)
    run.at(16.0)
    run.fill(12)
    assert len(asked) < 30
    assert sum(point.second < 2.1 for point in run.points) > 2
    assert not any(2.1 < point.second < 7.9 for point in run.points)
