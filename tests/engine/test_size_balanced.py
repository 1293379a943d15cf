"""The balanced design: exercise 9's closed solution, when there is none, and what it costs."""

from math import log, pi, sqrt

import numpy as np
import pytest
from judging import size_as_printed
from strategies import BEND, CASES, LOADS, PUSH, crossed, design, rcc

from flexcli.engine.sizing.balanced import kind_of
from flexcli.errors import SolveError
from flexcli.parts.requirements import Limit
from flexcli.spec.load import load

BALANCED = {"objective": "balanced"}
E, SIGMA, S, P = 114e9, 500e6, 2.5, 2e-3
DIGITS = 1e-10
"""The system's condition number, some 70, times the solver's rounding, with room."""


def sized(spec):
    result = size_as_printed(spec, "spec")
    return result, np.array([result.values[n].value for n in ("h", "l", "b")])


def exercise_9(theta, force):
    """Exercise 9 part II: the thin root of eqs (1) to (3) in closed form."""
    slender = pi * sqrt(E / (3 * SIGMA))
    h = 9 * S * P * theta / (pi**2 - 6 * S * slender * theta)
    return np.array([h, slender * h, force * S / (h * SIGMA * sqrt(2))])


@pytest.fixture
def rocket(request):
    folder = request.config.rootpath / "examples" / "rocket-parallel-stage"
    return load(folder / "flexure.yaml").part


def test_the_rocket_pivot_is_the_printed_one(rocket):
    # exercise 9 part II: h ≈ 637 µm, l ≈ 17.5 mm, b ≥ 3.6 mm, then 10 mm
    result = size_as_printed(rocket, "spec")
    ideal = [result.values[f"{n}_ideal"].value for n in ("h", "l", "b")]
    assert ideal[0] == pytest.approx(637e-6, abs=0.5e-6)
    assert ideal[2] == pytest.approx(3.6e-3, abs=0.05e-3)
    # the source's l = π √(E/3σ) h is 17.45 mm; it prints the 17.5 mm that it rounds it up to
    assert ideal[1] == pytest.approx(pi * sqrt(114e9 / (3 * 500e6)) * ideal[0], rel=DIGITS)
    made = [result.values[n].value for n in ("h", "l", "b")]
    assert made == [637e-6, 17.5e-3, 10e-3]


def test_the_balanced_design_is_the_closed_solution_to_all_digits():
    spec = design(rcc(), LOADS, size=BALANCED)
    theta, force = spec.scene("bend").travel, spec.scene("push").force
    result, x = sized(spec)
    assert x == pytest.approx(exercise_9(theta, force), rel=DIGITS)
    assert len(result.sizing.active) == 3
    for check in result.checks:
        assert check.factor == pytest.approx(2.5, rel=1e-9)


def test_it_prints_what_it_costs_against_the_least_volume():
    result, x = sized(design(rcc(), LOADS, size=BALANCED))
    least = sized(design(rcc(), LOADS))[1]
    assert [d.label for d in result.sizing.designs] == ["balanced", "least volume"]
    more = np.prod(x) / np.prod(least) - 1
    assert more > 0.01  # the balanced design is not the optimum
    assert any(f"{more:.1%} more volume" in remark for remark in result.sizing.remarks)


@pytest.mark.parametrize("driver", ["stroke", "force"])
def test_its_sensitivities_are_those_of_the_closed_solution(driver):
    spec = design(rcc(), LOADS, size=BALANCED)
    theta, force = spec.scene("bend").travel, spec.scene("push").force
    result, _ = sized(spec)
    step = 1e-5
    up, down = 1 + step, 1 - step
    if driver == "stroke":
        ends = exercise_9(theta * up, force), exercise_9(theta * down, force)
    else:
        ends = exercise_9(theta, force * up), exercise_9(theta, force * down)
    slopes = np.log(ends[0] / ends[1]) / log(up / down)
    rows = [s for s in result.sizing.sensitivities if s.driver == driver]
    # a force drives buckling and yield, whose sensitivities add up
    found = [sum(row.on[n] for row in rows) for n in "hlb"]
    assert found == pytest.approx(slopes, abs=1e-6)


def test_an_ill_conditioned_balance_is_said_with_its_sensitivity():
    result, _ = sized(design(rcc(), LOADS, size=BALANCED))
    largest = max(abs(v) for s in result.sizing.sensitivities for v in s.on.values())
    (note,) = (n for n in result.warnings if n.code == "ill-conditioned")
    assert f"{largest:.1f} %" in note.text


@pytest.mark.slow
def test_close_to_the_largest_stroke_the_digits_stay():
    # where the closed solution's denominator all but vanishes; the force keeps b above h
    limit = pi / (6 * S * sqrt(E / (3 * SIGMA)))
    theta, force = limit * (1 - 1e-4), 6.4e8
    cases = {
        "bend": {"stroke": {"rotation": f"{theta!r} rad", "cycles": 1e7}},
        "push": PUSH | {"load": {"force": f"{force!r} N"}},
    }
    _, x = sized(design(rcc(), LOADS, cases, size=BALANCED))
    # 1e4 is the factor by which the vanishing denominator spreads rounding
    assert x == pytest.approx(exercise_9(theta, force), rel=1e4 * 1e-13)


@pytest.mark.parametrize(
    ("geometry", "requirements", "reason"),
    [
        (rcc(b={"free": ["10 mm", "20 mm"]}), LOADS, "violates least b"),
        (rcc(l="12 mm", b="8 mm"), LOADS, "cannot all be active on 1 free dimensions"),
        (
            rcc(h={"free": ["0.2 mm", "1 mm"]}, l="12 mm", b="8 mm"), {"l/h": {"max": 40}},
            "no load requirement",
        ),
        (
            rcc(h={"free": ["50 um", "1 mm"]}, b="5 mm", l={"free": ["1 mm", "50 mm"]}),
            {"fatigue": 2.5, "yield": {"factor": 2.5, "cases": ["bend"]}},
            "cannot all be at their limit together",
        ),
    ],
)  # fmt: skip
def test_where_none_exists_the_reason_is_given_and_the_least_volume_taken(
    geometry, requirements, reason
):
    spec = design(geometry, requirements, size=BALANCED)
    result, x = sized(spec)
    (note,) = (n for n in result.warnings if n.code == "no-balanced-design")
    assert reason in note.text
    assert "sized for least volume instead" in note.text
    assert result.sizing.objective == "least-volume"
    assert x.tolist() == sized(design(geometry, requirements))[1].tolist()


def test_without_a_least_volume_the_balance_stands_alone():
    # p = 0: only a section narrower than thick, buckling sideways, can balance
    result, (h, _, b) = sized(design(rcc(p="0 mm"), LOADS, size=BALANCED))
    assert result.sizing.certificate == "root of the square system"
    assert b < h
    assert [d.label for d in result.sizing.designs] == ["balanced"]
    assert "there is no least volume to compare with: nothing holds it" in result.sizing.remarks


def test_without_balance_and_without_least_volume_there_is_no_answer():
    with pytest.raises(SolveError, match="falls without limit"):
        size_as_printed(design(rcc(h="0.1 mm"), {"fatigue": 2.5}, size=BALANCED), "spec")


def test_fewer_loads_than_sizes_leave_the_rest_to_the_volume():
    spec = design(rcc(), {"fatigue": 2.5, "buckling": 2.5}, size=BALANCED)
    result, x = sized(spec)
    assert result.sizing.certificate == "least volume on the rest"
    factors = [c.factor for c in result.checks]
    assert factors == pytest.approx([2.5, 2.5], rel=1e-9)
    assert x[1] == pytest.approx(1.5 * P, rel=1e-7)  # as the least volume has it


@pytest.mark.slow
def test_of_several_cases_the_hardest_balances_and_the_others_hold():
    cases = CASES | {
        "gentle": {"stroke": {"rotation": "0.5 deg", "cycles": 1e7}},
        "nudge": {"load": {"force": "64 N"}, "ends": "clamped-clamped"},
    }
    many = design(rcc(), LOADS, cases, size=BALANCED)
    assert sized(many)[1] == pytest.approx(sized(design(rcc(), LOADS, size=BALANCED))[1], rel=1e-12)
    assert size_as_printed(many, "spec").status.value == "pass"


@pytest.mark.slow
def test_a_crossed_pivot_balances_with_the_stress_of_the_deciding_end():
    sizes = {"l": {"free": ["2 mm", "80 mm"]}}
    spec = design(crossed(p="-2 mm", **sizes), LOADS, {"bend": BEND, "push": PUSH}, size=BALANCED)
    result = size_as_printed(spec, "spec")
    assert result.status.value == "pass"
    if result.sizing.objective == "balanced":
        assert [c.factor for c in result.checks] == pytest.approx([2.5] * 3, rel=1e-9)
        step = 1e-4
        rows = {s.driver: s.on for s in result.sizing.sensitivities}
        ends = []
        for factor in (1 + step, 1 - step):
            turn = {"stroke": {"rotation": f"{1.1746 * factor!r} deg", "cycles": 1e7}}
            cases = {"bend": turn, "push": PUSH}
            ends.append(sized(design(crossed(p="-2 mm", **sizes), LOADS, cases, size=BALANCED))[1])
        slopes = np.log(ends[0] / ends[1]) / log((1 + step) / (1 - step))
        assert [rows["stroke"][n] for n in "hlb"] == pytest.approx(slopes, rel=1e-4)


def test_a_kind_of_load_counts_once_in_each_joint_with_sizes_of_its_own():
    def kind(requirement, joint):
        return kind_of(Limit(requirement, "", "", 1.0, 1.0, "", "", joint=joint))

    assert kind("fatigue", "") == "fatigue"
    assert kind("fatigue", "A") != kind("fatigue", "B")
    assert kind("fatigue", "A") != kind("yield", "A")
