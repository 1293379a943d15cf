"""Sizing by limits that are numbers: the optimum, balance, conflict and grid of the signomials."""

import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from judging import size_as_printed
from strategies import LOADS, PUSH, crossed, design, rcc, specs

from flexcli.engine import assess
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec

SAME = 1e-8
BOUNDED = {
    "h": {"free": ["50 um", "2 mm"]},
    "l": {"free": ["2 mm", "80 mm"]},
    "b": {"free": ["1 mm", "30 mm"]},
}


def as_numbers(spec):
    """A design whose closed forms are taken for numbers."""
    kind = type(spec.geometry)
    numbers = type(kind.__name__, (kind,), {"posynomial": False})
    return spec.model_copy(update={"geometry": numbers.model_construct(**spec.geometry.__dict__)})


def with_limits(spec, changed):
    """A design known as numbers with limits of its own, made of its closed forms."""

    class Own(DesignSpec):
        def closed_limits(self, sizes):
            return changed(super().closed_limits(sizes), sizes)

    return Own.model_construct(**as_numbers(spec).__dict__)


def both(spec):
    return size_as_printed(spec, "spec"), size_as_printed(as_numbers(spec), "spec")


def sizes_of(result):
    return [result.values[name].value for name in "hlb"]


def assert_same_design(exact, numbers):
    assert numbers.status is exact.status
    assert sizes_of(numbers) == pytest.approx(sizes_of(exact), rel=SAME)
    assert set(numbers.sizing.active) == set(exact.sizing.active)
    found = {row.constraint: row for row in numbers.sizing.sensitivities}
    for row in exact.sizing.sensitivities:
        assert found[row.constraint].driver == row.driver
        assert found[row.constraint].on == pytest.approx(row.on, abs=1e-5)


@pytest.mark.slow
@pytest.mark.parametrize(
    "objective",
    ["least-volume", "least-stiffness", "shortest", {"minimize": "b"}, {"minimize": "k_pivot"},
     {"maximize": "h"}, {"minimize": "mass"}],
)  # fmt: skip
def test_every_objective_has_the_optimum_of_the_signomials(objective):
    exact, numbers = both(design(rcc(**BOUNDED), LOADS, size={"objective": objective}))
    assert_same_design(exact, numbers)
    assert numbers.sizing.remarks == exact.sizing.remarks
    assert [d.label for d in numbers.sizing.designs] == [d.label for d in exact.sizing.designs]
    assert numbers.sizing.certificate == "local optimum, 5 starts: the only one found"
    assert numbers.cost.iterations > 0


def test_without_bounds_the_optimum_is_found_as_well():
    exact, numbers = both(design(rcc(), LOADS))
    assert_same_design(exact, numbers)


@pytest.mark.parametrize("fixed", ["h", "l", "b"])
def test_fixed_dimensions_stay(fixed):
    value = {"h": "250 um", "l": "12 mm", "b": "9 mm"}[fixed]
    assert_same_design(*both(design(rcc(**(BOUNDED | {fixed: value})), LOADS)))


def test_a_target_is_met_as_an_equality():
    asked = LOADS | {"l/h": {"equals": 50}}
    exact, numbers = both(design(rcc(**BOUNDED), asked))
    assert_same_design(exact, numbers)
    (check,) = (c for c in numbers.checks if c.name.startswith("l/h"))
    assert check.factor == pytest.approx(1.0, rel=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("requirements", "certificate"),
    [
        (LOADS, "root of the square system"),
        ({"fatigue": 2.5, "buckling": 2.5}, "least volume on the rest"),
    ],
)
def test_the_balanced_design_is_that_of_the_signomials(requirements, certificate):
    exact, numbers = both(design(rcc(), requirements, size={"objective": "balanced"}))
    assert numbers.sizing.certificate == exact.sizing.certificate == certificate
    assert_same_design(exact, numbers)
    assert numbers.sizing.remarks == exact.sizing.remarks


@pytest.mark.slow
def test_where_no_balance_exists_the_reason_is_that_of_the_signomials():
    geometry = rcc(b={"free": ["10 mm", "20 mm"]})
    exact, numbers = both(design(geometry, LOADS, size={"objective": "balanced"}))
    assert_same_design(exact, numbers)
    assert [n.text for n in numbers.warnings] == [n.text for n in exact.warnings]


def conflicting(factor=2.5):
    geometry = rcc(l={"free": ["1 mm", "8 mm"]}, b={"free": ["1 mm", "5 mm"]})
    cases = {"bend": {"stroke": {"rotation": "4 deg", "cycles": 1e7}}, "push": PUSH}
    return design(geometry, {"fatigue": factor, "buckling": 2.5}, cases)


@pytest.mark.slow
def test_a_conflict_names_the_same_requirements_and_relaxations():
    exact, numbers = both(conflicting())
    assert numbers.status.value == exact.status.value == "infeasible"
    found = {r.name: r for r in numbers.sizing.conflict}
    assert set(found) == {r.name for r in exact.sizing.conflict}
    for row in exact.sizing.conflict:
        assert found[row.name].factor == pytest.approx(row.factor, rel=1e-7)
        assert found[row.name].text == row.text
    assert "not proved" in numbers.sizing.certificate
    (fatigue,) = (r for r in found.values() if r.name.startswith("fatigue"))
    factor = float(fatigue.text.split(" → ")[1])
    assert size_as_printed(as_numbers(conflicting(factor)), "spec").status.value == "pass"
    assert (
        size_as_printed(as_numbers(conflicting(factor * 1.01)), "spec").status.value == "infeasible"
    )


@pytest.mark.slow
def test_targets_that_conflict_give_way_to_the_side_that_does():
    asked = {"l/h": {"equals": 50}, "b/h": {"equals": 20}}
    sizes = {"h": {"free": ["0.8 mm", "1 mm"]}, "l": {"free": ["10 mm", "12 mm"]}}
    exact, numbers = both(design(rcc(**sizes), asked))
    assert numbers.status.value == exact.status.value == "infeasible"
    assert {r.text for r in numbers.sizing.conflict} == {r.text for r in exact.sizing.conflict}
    assert any(r.name.startswith("l/h (equals)") for r in exact.sizing.conflict)


def test_what_runs_away_is_named_with_its_remedy():
    spec = as_numbers(design(rcc(h="0.1 mm", l="10 mm"), {"fatigue": 1}))
    with pytest.raises(SolveError, match=r"falls without limit as .*b.* runs away") as caught:
        size_as_printed(spec, "spec")
    assert "bound b" in caught.value.remedy


def test_an_undetermined_dimension_is_an_error_that_names_it():
    geometry = rcc(h={"free": ["0.1 mm", "1 mm"]})
    spec = design(geometry, {"fatigue": 1}, size={"objective": "shortest"})
    with pytest.raises(SolveError, match="nothing holds b: the objective does not depend"):
        size_as_printed(as_numbers(spec), "spec")


COARSE = {"h": "10 um", "l": "0.5 mm", "b": "0.5 mm"}
NARROW = {
    "h": {"free": ["100 um", "1 mm"]},
    "l": {"free": ["5 mm", "30 mm"]},
    "b": {"free": ["1 mm", "12 mm"]},
}


@pytest.mark.slow
@pytest.mark.parametrize("objective", ["least-volume", "shortest", "least-stiffness", "balanced"])
def test_the_grid_point_is_that_of_the_signomials(objective):
    options = {"objective": objective, "round": COARSE}
    exact, numbers = both(design(rcc(**NARROW), LOADS, size=options))
    assert sizes_of(numbers) == sizes_of(exact)
    assert numbers.status.value == "pass"
    sure = "proved" if objective == "balanced" else "best of those searched"
    assert any(sure in remark for remark in numbers.sizing.remarks)


@pytest.mark.parametrize("objective", ["least-volume", "balanced"])
def test_a_dimension_without_grid_stays_continuous_and_optimal(objective):
    options = {"objective": objective, "round": {"h": ["0.2 mm", "0.3 mm", "0.5 mm"]}}
    exact, numbers = both(design(rcc(**NARROW), LOADS, size=options))
    assert numbers.status.value == "pass"
    assert sizes_of(numbers) == pytest.approx(sizes_of(exact), rel=SAME)


def test_the_better_of_two_branches_of_a_crossing_is_found():
    spec = design(crossed(p="-2 mm", **BOUNDED), LOADS)
    numbers = size_as_printed(as_numbers(spec))
    h, l, b = np.meshgrid(
        *(np.geomspace(*r, 60) for r in ((5e-5, 2e-3), (2e-3, 8e-2), (1e-3, 3e-2)))
    )
    margins = np.min(list(assess.factors(spec, h=h, l=l, b=b).values()), axis=0)
    scanned = np.where(margins >= 1.0, h * l * b, np.inf).min()
    assert np.prod(sizes_of(numbers)) <= scanned * (1 + 1e-9)
    assert numbers.status.value == "pass"


def of_fatigue(limits, factor):
    """The fatigue limits with a factor on their demand."""
    return [x._replace(demand=x.demand * factor) for x in limits if x.requirement == "fatigue"]


def steeper_when_short(sizes):
    """A factor on a demand, 1 for long blades, with a kink at 6 mm."""
    return (sizes.l / 6e-3) ** -1.5


def test_branches_given_as_limits_of_their_own_meet_in_the_optimum():
    def branches(limits, sizes):
        return [*limits, *of_fatigue(limits, steeper_when_short(sizes))]

    result = size_as_printed(with_limits(design(rcc(**BOUNDED), LOADS), branches))
    assert result.values["l"].value == pytest.approx(6e-3, rel=1e-9)
    assert sum(row.startswith("fatigue") for row in result.sizing.active) == 2


@pytest.mark.slow
def test_a_limit_with_a_kink_at_the_optimum_is_refused_with_its_remedy():
    def kinked(limits, sizes):
        others = [x for x in limits if x.requirement != "fatigue"]
        return [*others, *of_fatigue(limits, np.maximum(1.0, steeper_when_short(sizes)))]

    with pytest.raises(SolveError, match="did not converge") as caught:
        size_as_printed(with_limits(design(rcc(**BOUNDED), LOADS), kinked))
    assert "each of its branches" in caught.value.remedy


@pytest.mark.slow
def test_sizes_off_the_domain_of_a_model_are_avoided():
    spec = design(rcc(**BOUNDED), LOADS)

    def slender_only(limits, sizes):
        known = sizes.l > 30 * sizes.h
        return [limit._replace(demand=np.where(known, limit.demand, np.nan)) for limit in limits]

    assert sizes_of(size_as_printed(with_limits(spec, slender_only))) == pytest.approx(
        sizes_of(size_as_printed(spec)), rel=SAME
    )


@pytest.mark.slow
def test_a_design_that_lacks_some_of_the_limits_is_avoided():
    spec = design(rcc(**BOUNDED), LOADS)

    def slender_has_all(limits, sizes):
        return limits if np.all(sizes.l > 30 * sizes.h) else limits[:-1]

    assert sizes_of(size_as_printed(with_limits(spec, slender_has_all))) == pytest.approx(
        sizes_of(size_as_printed(spec)), rel=SAME
    )


@pytest.mark.slow
def test_a_balance_counts_each_joint_with_sizes_of_its_own():
    spec = design(rcc(), LOADS, size={"objective": "balanced"})

    def two_joints(limits, _):
        return [
            limit._replace(requirement="fatigue", joint={"fatigue": "A", "yield": "B"}[kind])
            if (kind := limit.requirement) != "buckling"
            else limit
            for limit in limits
        ]

    result = size_as_printed(with_limits(spec, two_joints))
    assert result.sizing.certificate == "root of the square system"
    assert sizes_of(result) == pytest.approx(sizes_of(size_as_printed(spec)), rel=SAME)


def test_with_nothing_free_the_given_sizes_are_judged():
    exact, numbers = both(design(rcc(h="1 mm", l="20 mm", b="10 mm"), LOADS))
    judged, found = ([c._replace(seconds=0.0) for c in r.checks] for r in (exact, numbers))
    assert found == judged
    assert "nothing to choose" in numbers.sizing.certificate


def test_a_grid_is_searched_by_the_limits_of_the_design():
    stock = {"h": [1.6e-4, 1.9e-4, 2.3e-4], "l": [6e-3, 7e-3, 9e-3], "b": [0.022, 0.03]}
    rounding = {name: [f"{size!r} m" for size in sizes] for name, sizes in stock.items()}
    spec = design(rcc(**BOUNDED), LOADS, size={"round": rounding})

    def harder(limits, sizes):
        return [x._replace(demand=x.demand * (1.1 + sizes.h / 2e-3)) for x in limits]

    result = size_as_printed(with_limits(spec, harder))
    points = np.array(np.meshgrid(*stock.values(), indexing="ij")).reshape(3, -1)
    sizes = spec.geometry.sized(dict(zip("hlb", points, strict=True)))
    limits = harder(spec.closed_limits(sizes), sizes)
    used = np.max([x.demand * x.required / x.capacity for x in limits], axis=0)
    volumes = np.where(used <= 1.0, points.prod(axis=0), np.inf)
    assert np.isfinite(volumes.min())
    assert sizes_of(result) == pytest.approx(points[:, volumes.argmin()], rel=1e-12)


@pytest.mark.slow
@settings(max_examples=5, deadline=None, suppress_health_check=[HealthCheck.filter_too_much])
@given(specs())
def test_random_designs_are_no_worse_than_by_signomials(spec):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            exact = size_as_printed(spec, "spec")
        except SolveError as error:
            assume(error.code not in ("unbounded", "undetermined"))
            raise
        numbers = size_as_printed(as_numbers(spec))
    assert numbers.status is exact.status
    assume(exact.status.value == "pass")
    if numbers.sizing.objective == exact.sizing.objective == "least-volume":
        assert numbers.sizing.designs[0].volume <= exact.sizing.designs[0].volume * (1 + SAME)
