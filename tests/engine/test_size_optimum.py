"""Optima against general solvers and scans, their certificates, sensitivities and ties."""

import json
from math import log, pi, sqrt

import numpy as np
import pytest
from judging import size_as_printed
from scipy.optimize import minimize as scipy_minimize
from strategies import CASES, LOADS, PUSH, TITANIUM, crossed, design, rcc, stage, three_blade

from flexcli.engine import assess
from flexcli.errors import SolveError
from flexcli.parts.geometries import Blade
from flexcli.results import Status

SLSQP = 1e-6  # difference quotients of 1e-8 leave this of the logarithm of an objective
STEP = 1e-3  # of a demand, in difference quotients of whole sizings: an error of its square
BOUNDED = {
    "h": {"free": ["50 um", "2 mm"]},
    "l": {"free": ["2 mm", "80 mm"]},
    "b": {"free": ["1 mm", "30 mm"]},
}


def sized(spec):
    result = size_as_printed(spec, "spec")
    return result, np.array([result.values[n].value for n in ("h", "l", "b")])


def volume(x):
    return x[0] * x[1] * x[2]


def general_solver(spec, goal, start):
    """Least ln goal by SLSQP over ln(h, l, b) with the margins as constraints."""

    def inside(y):
        margins = assess.factors(spec, **dict(zip("hlb", np.exp(y), strict=True)))
        return np.log([max(float(m), 1e-300) for m in margins.values()])

    extents = spec.geometry.extents.values()
    bounds = [(log(e.least or 1e-6), log(e.most or 1.0)) for e in extents]
    return scipy_minimize(
        lambda y: log(goal(np.exp(y))), np.log(start), method="SLSQP", bounds=bounds,
        constraints={"type": "ineq", "fun": inside}, options={"ftol": 1e-14, "maxiter": 1000},
    )  # fmt: skip


# -- global optima -----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("objective", "goal"),
    [
        ("least-volume", volume),
        ("shortest", lambda x: x[1]),
        ({"minimize": "b"}, lambda x: x[2]),
        ({"maximize": "h"}, lambda x: 1 / x[0]),
        ("least-stiffness", None),
    ],
)
def test_a_global_optimum_is_that_of_a_general_solver(objective, goal):
    spec = design(rcc(**BOUNDED), LOADS, size={"objective": objective})
    goal = goal or (lambda x: spec.geometry.stiffness(spec.material.elastic, Blade(*x)))
    result, x = sized(spec)
    assert result.status.value == "pass"
    assert result.sizing.certificate.startswith("global")
    ends = [
        general_solver(spec, goal, start)
        for start in ((3e-4, 1e-2, 1e-2), (8e-4, 4e-2, 5e-3), (2e-4, 6e-3, 2e-2))
    ]
    # whether SLSQP arrives or not, no feasible point of it is better
    feasible = [
        e.fun
        for e in ends
        if min(assess.factors(spec, **dict(zip("hlb", np.exp(e.x), strict=True))).values())
        > 1 - 1e-6
    ]
    assert log(goal(x)) <= min(feasible) + SLSQP
    assert log(goal(x)) == pytest.approx(min(feasible), abs=SLSQP)


def test_the_least_volume_of_the_rocket_pivot_has_length_three_halves_p():
    # By hand for fatigue and buckling active: h = σ l²/(S E θ (2l + 3p)), b ∝ l²/h³, so V ∝ l³/h²
    # ∝ (2l + 3p)²/l, least at l = 3p/2.
    result, x = sized(design(rcc(), LOADS))
    assert x[1] == pytest.approx(1.5 * 2e-3, rel=1e-9)
    assert result.sizing.active == (
        "fatigue, bend: amplitude of the bending stress, inner end",
        "buckling, push: force F, buckling across the thickness",
    )


@pytest.mark.parametrize("fixed", ["h", "l", "b"])
def test_fixed_dimensions_stay_and_the_rest_is_optimal(fixed):
    value = {"h": "250 um", "l": "12 mm", "b": "9 mm"}[fixed]
    spec = design(rcc(**(BOUNDED | {fixed: value})), LOADS)
    result, x = sized(spec)
    assert result.values[fixed].value == getattr(spec.geometry, fixed).fixed
    others = [n for n in "hlb" if n != fixed]
    grid = [np.geomspace(*(getattr(spec.geometry, n).least, getattr(spec.geometry, n).most), 700)
            for n in others]  # fmt: skip
    first, second = np.meshgrid(*grid, indexing="ij")
    points = {others[0]: first, others[1]: second, fixed: np.array(x["hlb".index(fixed)])}
    margins = np.min(list(assess.factors(spec, **{n: points[n] for n in "hlb"}).values()), axis=0)
    volumes = points["h"] * points["l"] * points["b"]
    scanned = np.where(margins >= 1.0, volumes, np.inf).min()
    steps = sum(log(g[1] / g[0]) for g in grid)
    assert volume(x) <= scanned * (1 + 1e-9)
    # One step of the scan each way in both sizes; the constraints' exponents reach 3.
    assert volume(x) == pytest.approx(scanned, rel=4 * steps)


def test_exercise_12_b_is_sized_from_its_equalities():
    # b = 30 mm, h = 250 µm from a sag of 645 nm and a frequency of 10 Hz at l = 80 mm
    spec = design(
        three_blade(l="80 mm"),
        {"sag": {"equals": "645 nm"}, "frequency": {"equals": "10 Hz"}},
        {"mercury": {"acceleration": {"level": "3.7 m/s^2", "axis": "z"}}},
        mechanism={"kind": "payload", "mass": "0.8 kg", "inertia": "1.72e-4 kg*m^2"},
        material={"youngs_modulus": "116 GPa"},
    )
    result, (h, l, b) = sized(spec)
    assert b == pytest.approx(30e-3, abs=0.5e-3)
    assert h == pytest.approx(250e-6, abs=0.5e-6)
    K_z, K_t = 0.8 * 3.7 / 645e-9, 4 * pi**2 * 10**2 * 1.72e-4
    exact = (K_z**3 / (27 * K_t * 116e9**2)) ** 0.125 * l  # exercise 12 B, equation (6)
    assert b == pytest.approx(exact, rel=1e-10)
    assert {s.driver for s in result.sizing.sensitivities} == {"target"}
    by_target = {s.constraint.split(" ")[0]: s.on for s in result.sizing.sensitivities}
    # equation (6): b ∝ sag^(−3/8) f^(−2/8)
    assert by_target["sag"]["b"] == pytest.approx(-3 / 8, abs=1e-6)
    assert by_target["frequency"]["b"] == pytest.approx(-1 / 4, abs=1e-6)
    assert len(result.sizing.active) == 2


def test_least_width_makes_a_blade_narrower_than_thick_and_buckling_counts_that():
    # Without a thick limit, a narrow tall section would buckle sideways.
    sizes = {"h": {"free": ["0.1 mm", "20 mm"]}, "l": "40 mm", "b": {"free": ["0.1 mm", None]}}
    spec = design(
        stage(**sizes), {"buckling": 2},
        {"push": {"load": {"force": "2 kN"}, "ends": "clamped-clamped"}},
        size={"objective": {"minimize": "b"}},
    )  # fmt: skip
    result, (h, l, b) = sized(spec)
    assert b < h
    (check,) = result.checks
    assert "across the width" in check.quantity
    needed = 2 * 1000 * 12 * (0.5 * l) ** 2 / (pi**2 * 114e9)
    assert h * b**3 == pytest.approx(needed, rel=1e-9)


# -- sensitivities -----------------------------------------------------------------------------


def changed(kind, factor):
    """The bounded rocket pivot with one demand scaled."""
    stroke, force, bound = (factor if kind == k else 1.0 for k in ("stroke", "force", "bound"))
    cases = {
        "bend": {"stroke": {"rotation": f"{1.1746 * stroke!r} deg", "cycles": 1e7}},
        "push": PUSH | {"load": {"force": f"{640 * force!r} N"}},
    }
    return design(rcc(b={"free": ["1 mm", f"{10 / bound!r} mm"]}), LOADS, cases)


@pytest.mark.parametrize("kind", ["stroke", "force", "bound"])
def test_sensitivities_are_what_a_changed_demand_costs(kind):
    result, _ = sized(changed(kind, 1.0))
    (row,) = (s for s in result.sizing.sensitivities if s.driver == kind)
    high, low = sized(changed(kind, 1 + STEP))[1], sized(changed(kind, 1 - STEP))[1]
    slopes = np.log(high / low) / log((1 + STEP) / (1 - STEP))
    assert [row.on[n] for n in "hlb"] == pytest.approx(slopes, abs=1e-5)
    assert row.on["objective"] == pytest.approx(sum(slopes), abs=1e-5)


def test_sensitivities_of_a_crossed_pivot_scale_the_whole_demand():
    def spec(stroke):
        cases = {
            "bend": {"stroke": {"rotation": f"{2 * stroke!r} deg", "cycles": 1e7}},
            "push": CASES["push"],
        }
        sizes = {"h": {"free": ["0.3 mm", "1 mm"]}, "l": {"free": ["1 mm", "5 mm"]}, "b": "3 mm"}
        return design(crossed(p="-2 mm", **sizes), LOADS | {"yield": 2}, cases)

    result, _ = sized(spec(1.0))
    row = next(s for s in result.sizing.sensitivities if s.driver == "stroke")
    high, low = sized(spec(1 + STEP))[1], sized(spec(1 - STEP))[1]
    slopes = np.log(high / low) / log((1 + STEP) / (1 - STEP))
    assert [row.on[n] for n in "hl"] == pytest.approx(slopes[:2], abs=1e-4)


def test_a_stress_of_both_loads_names_both_as_its_drivers():
    both = {"stroke": {"rotation": "1 deg", "cycles": 1e6}, "load": {"force": "50 N"}}
    result, _ = sized(design(rcc(l="20 mm", h="0.3 mm"), {"yield": 2}, {"both": both}))
    assert [s.driver for s in result.sizing.sensitivities] == ["stroke and force"]


# -- more than one branch ----------------------------------------------------------------------


def scan(spec, count=4001):
    """For each l of a dense scan the largest h that fatigue allows and the least b for it."""
    g, E, S, sigma = spec.geometry, 114e9, 2.5, 500e6
    theta, blade_force = spec.scene("bend").travel, 2.5 * 640.0 / sqrt(2)
    l = np.geomspace(g.l.least, g.l.most, count)
    steepest = np.maximum(abs(2 / l + 3 * g.p / l**2), abs(1 / l + 3 * g.p / l**2))
    h = np.minimum(sigma / (S * E * theta) / steepest, g.h.most)
    stiff = 12 * blade_force * (l / 2) ** 2 / (pi**2 * E)
    across_h, across_b = stiff / h**3, (stiff / h) ** (1 / 3)
    b = np.maximum.reduce([across_h, across_b, blade_force / (sigma * h)])
    possible = (h >= g.h.least) & (b <= g.b.most)
    return l, h, np.where(possible, np.maximum(b, g.b.least), np.inf)


@pytest.mark.parametrize("lengths", [(1, 100), (1, 7.9), (8.1, 100), (7, 9)])
@pytest.mark.parametrize(
    ("objective", "goal", "shorter"),
    [
        ("least-volume", lambda h, l, b: h * l * b, True),
        ({"minimize": "b"}, lambda h, l, b: b, False),
    ],
)
def test_both_branches_of_a_crossing_are_solved(lengths, objective, goal, shorter):
    # p = −4 mm: the outer end decides for l < 2|p|, the inner one beyond. Volume and width both
    # fall with h for a given l, so that the scan may take the largest h.
    spec = design(
        crossed(
            p="-4 mm", l={"free": [f"{x} mm" for x in lengths]}, h={"free": ["20 um", "2 mm"]},
            b={"free": ["0.1 mm", "100 mm"]},
        ), LOADS, size={"objective": objective},
    )  # fmt: skip
    result, (h, l, b) = sized(spec)
    scanned_l, scanned_h, scanned_b = scan(spec)
    best = goal(scanned_h, scanned_l, scanned_b).min()
    assert goal(h, l, b) <= best * (1 + 1e-9)
    # at a kink the objective rises by its exponents, some 6, times the scan's step of ln l
    assert goal(h, l, b) == pytest.approx(best, rel=6 * log(scanned_l[1] / scanned_l[0]))
    assert result.sizing.certificate.startswith("local optimum")
    assert "fatigue" in result.sizing.certificate
    if lengths == (1, 100):
        assert bool(l < 8e-3) is shorter


# -- ties and missing optima -------------------------------------------------------------------


def test_a_tie_is_said_and_broken_by_the_volume():
    spec = design(rcc(**BOUNDED), LOADS, size={"objective": {"maximize": "b"}})
    result, x = sized(spec)
    assert any("not unique" in remark for remark in result.sizing.remarks)
    assert x[2] == pytest.approx(30e-3, rel=1e-9)
    pinned = design(rcc(**(BOUNDED | {"b": "30 mm"})), LOADS)
    assert x == pytest.approx(sized(pinned)[1], rel=1e-7)


def test_equal_volumes_are_broken_by_the_shorter_blade():
    # yield alone asks for an area, so at a fixed length every h and b of it is as good
    sizes = {"h": {"free": ["0.1 mm", "1 mm"]}, "l": {"free": ["5 mm", "9 mm"]},
             "b": {"free": ["1 mm", "20 mm"]}}  # fmt: skip
    spec = design(rcc(**sizes), {"yield": {"factor": 2.5, "cases": ["push"]}})
    result, (h, l, b) = sized(spec)
    assert any("not unique" in remark for remark in result.sizing.remarks)
    assert (h, l) == pytest.approx((1e-3, 5e-3), rel=1e-9)  # the narrowest, so the thickest
    assert h * b == pytest.approx(2.5 * 640 / sqrt(2) / 830e6, rel=1e-9)


def test_an_objective_is_sized_though_the_volume_has_no_least():
    # p = 0: l ∝ h from fatigue and b ∝ 1/h, so the volume falls with h without limit
    free = rcc(p="0 mm", h={"free": [None, "0.3 mm"]})
    with pytest.raises(SolveError, match="falls without limit"):
        size_as_printed(design(free, LOADS), "spec")
    result, x = sized(design(free, LOADS, size={"objective": {"maximize": "h"}}))
    assert result.status.value == "pass"
    assert [d.label for d in result.sizing.designs] == ["optimum"]
    assert x[0] == pytest.approx(0.3e-3, rel=1e-9)


def test_what_runs_away_is_named_with_its_remedy():
    with pytest.raises(SolveError, match=r"falls without limit as .*b.* runs away") as caught:
        size_as_printed(design(rcc(h="0.1 mm", l="10 mm"), {"fatigue": 1}), "spec")
    assert "bound b" in caught.value.remedy


def test_an_undetermined_dimension_is_an_error_that_names_it():
    spec = design(
        rcc(h={"free": ["0.1 mm", "1 mm"]}), {"fatigue": 1}, size={"objective": "shortest"}
    )
    with pytest.raises(SolveError, match="nothing holds b: the objective does not depend"):
        size_as_printed(spec, "spec")


def test_with_nothing_free_the_given_sizes_is_judged():
    spec = design(rcc(h="1 mm", l="20 mm", b="10 mm"), LOADS)
    result = size_as_printed(spec, "spec")
    assert result.status.value == "fail"
    assert "nothing to choose" in result.sizing.certificate


# -- units -------------------------------------------------------------------------------------


def test_other_units_in_the_spec_give_the_same_digits():
    metric = design(rcc(p="2 mm", b={"free": ["1 mm", "10 mm"]}), LOADS)
    other = design(
        rcc(p="2000 um", half_angle="45 deg", b={"free": ["0.1 cm", "10000 um"]}), LOADS,
        {"bend": CASES["bend"], "push": PUSH | {"load": {"force": "0.64 kN"}}},
        material=TITANIUM | {"youngs_modulus": "114000 MPa"},
    )  # fmt: skip
    assert sized(metric)[1].tolist() == sized(other)[1].tolist()


@pytest.mark.parametrize("scale", [1e-3, 1e3])
def test_a_design_scaled_in_length_and_force_gives_the_scaled_blade(scale):
    def of(k):
        return design(
            rcc(p=f"{2 * k!r} mm", b={"free": [f"{k!r} mm", f"{10 * k!r} mm"]}), LOADS,
            {"bend": CASES["bend"], "push": PUSH | {"load": {"force": f"{640 * k * k!r} N"}}},
        )  # fmt: skip

    assert sized(of(scale))[1] / scale == pytest.approx(sized(of(1.0))[1], rel=1e-10)


def test_results_are_plain_numbers_for_json():
    from flexcli.report import as_json

    result = size_as_printed(design(rcc(**BOUNDED), LOADS), "spec")
    assert json.loads(as_json.dumps(as_json.document(result)))["status"] == "pass"


def test_a_stroke_to_one_side_sized_by_smith_watson_topper_is_thinner_by_the_root_of_two():
    """0 to 2°: amplitude and mean are both those of 1°, and √(σ_a (σ_a + σ_m)) = √2 σ_a."""
    theta, l, p, factor = np.deg2rad(1.0), 20e-3, 2e-3, 3.0
    found = size_as_printed(
        design(
            rcc(p="2 mm", l="20 mm", b="10 mm"),
            {"fatigue": {"factor": factor, "mean_stress": "swt"}},
            {"turn": {"stroke": {"rotation": ["0 deg", "2 deg"], "cycles": 1e7}}},
            size={"objective": {"maximize": "h"}},
        )
    )
    # a blade clamped at p and p + l from the centre bends by E h θ (2 l + 3 p)/l² at its inner end
    expected = 500e6 / factor / 2.0**0.5 * l**2 / (114e9 * theta * (2.0 * l + 3.0 * p))
    assert found.status is Status.PASS
    assert found.values["h"].value == pytest.approx(expected, rel=1e-6)
