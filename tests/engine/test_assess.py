"""Judging blades: one or many give the same margins, and targets count from both sides."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from judging import check_as_printed
from strategies import CASES, LOADS, crossed, design, rcc, specs

from flexcli.engine import assess
from flexcli.numerics.rows import Rows
from flexcli.parts.geometries import Blade
from flexcli.parts.requirements import Limit
from flexcli.results import EXACT, ErrorRange, Verdict

ROUNDING = 1e-12
H, L, B = np.meshgrid([2e-4, 5e-4], [5e-3, 2e-2], [2e-3, 1e-2])


@settings(max_examples=25)
@given(specs())
def test_many_designs_at_once_have_the_margins_of_each_alone(spec):
    margins = assess.factors(spec, h=H, l=L, b=B)
    for at in np.ndindex(H.shape):
        blade = Blade(float(H[at]), float(L[at]), float(B[at]))
        alone = {
            f"{c.name}, {c.case}" if c.case else c.name: c.margin + 1.0
            for c in assess.checks(spec.limits(blade))
        }
        assert set(alone) == set(margins)
        for name, margin in alone.items():
            assert margins[name][at] == pytest.approx(margin, rel=ROUNDING)


def test_shapes_broadcast_and_large_batches_are_judged_in_parts(monkeypatch):
    spec = design(rcc(), LOADS)
    h, l = np.linspace(1e-4, 1e-3, 7)[:, None], np.linspace(5e-3, 5e-2, 5)
    whole = assess.factors(spec, h=h, l=l, b=np.array(5e-3))
    monkeypatch.setattr(assess, "CHUNK", 4)
    for name, margins in assess.factors(spec, h=h, l=l, b=np.array(5e-3)).items():
        assert margins.shape == (7, 5)
        np.testing.assert_array_equal(margins, whole[name])


def test_rounding_below_the_required_factor_is_no_failure():
    def passes(capacity):
        limit = Limit("x", "", "x", 1.0, capacity, "Pa", "", required=2.5, error=EXACT)
        return assess.checks([limit])[0].passed

    assert passes(2.5 * (1.0 - 1e-10))
    assert not passes(2.5 * (1.0 - 1e-8))


def test_without_demand_the_factor_is_infinite():
    limit = Limit("x", "", "x", 0.0, 1.0, "Pa", "", error=EXACT)
    assert assess.factor(limit, 0.0, 1.0) == np.inf
    assert assess.checks([limit])[0].verdict is Verdict.PASS
    # a nothing of which nobody knows how far it is off is no proof
    assert assess.checks([limit._replace(error=None)])[0].verdict is Verdict.UNDECIDED


def test_thicker_blades_lower_the_fatigue_margin_and_raise_the_buckling_margin():
    h = np.geomspace(1e-4, 2e-3, 50)
    margins = assess.factors(design(rcc(), LOADS), h=h, l=np.array(2e-2), b=np.array(1e-2))
    fatigue, buckling = margins["fatigue, bend"], margins["buckling, push"]
    assert (np.diff(fatigue) < 0).all()
    assert (np.diff(buckling) > 0).all()


def test_check_fails_a_blade_that_one_requirement_refuses():
    sized = {"h": "1 mm", "l": "20 mm", "b": "10 mm"}
    spec = design(rcc(**sized), LOADS)
    result = check_as_printed(spec, spec.fixed_sizes(), "spec")
    assert result.status.value == "fail"
    assert {c.name for c in result.checks if c.factor < c.required} == {"fatigue"}


def test_warnings_name_placeholders_and_stubby_blades():
    from strategies import TITANIUM

    guessed = TITANIUM | {"density": {"value": "4430 kg/m^3", "status": "placeholder"}}
    spec = design(rcc(h="1 mm", l="5 mm", b="5 mm"), {"yield": 1}, material=guessed)
    result = check_as_printed(spec, spec.fixed_sizes(), "spec")
    codes = {note.code for note in result.warnings}
    assert {"placeholder-material", "outside-validity"} <= codes


@given(st.floats(-1.0, 0.0))
def test_mirrored_crossings_have_the_same_margins(delta):
    def worst(d):
        # tenths of a thousandth keep the two numbers exact mirrors in decimals
        return assess.factors(
            design(crossed(delta=d, h="0.3 mm", l="20 mm", b="5 mm"), LOADS, CASES),
            h=np.array(3e-4), l=np.array(2e-2), b=np.array(5e-3),
        )  # fmt: skip

    delta = round(delta, 4)
    mine, mirrored = worst(delta), worst(round(-1.0 - delta, 4))
    for name, margin in mine.items():
        assert margin == pytest.approx(mirrored[name], rel=1e-9)


def test_many_designs_miss_a_target_on_either_side_alike():
    spec = design(rcc(), {"l/h": {"equals": 40, "tolerance": "2 %"}})
    off = np.array([1.5, 1.02, 1.0, 1.0 / 1.02, 1.0 / 1.5])
    found = assess.factors(spec, h=20e-3 / (40.0 * off), l=np.full(5, 20e-3), b=np.full(5, 5e-3))
    (margins,) = found.values()
    np.testing.assert_allclose(margins, 1.02 / np.maximum(off, 1.0 / off), rtol=1e-12)


@pytest.mark.parametrize("error", [EXACT, ErrorRange(-0.1, 0.05), None])
@pytest.mark.parametrize("required", [1.0, 1.5, 9.0])
def test_of_two_limits_the_worst_decides_each_of_many_designs_as_it_does_alone(error, required):
    # the first is the worse of one design, the second of the other
    capacities = np.array([[2.5, 4.0], [3.0, 2.0]])

    def judged(of):
        (found,) = assess.checks(
            Limit("x", "", "x", of(1.0 + 0.0 * row), of(row), "Pa", "",
                  required=required, error=error)
            for row in capacities
        )  # fmt: skip
        return found

    many = judged(Rows.of)
    for k in range(2):
        alone = judged(lambda row, k=k: float(row[k]))
        assert many.verdict is alone.verdict
        assert np.asarray(many.factor)[k] == alone.factor
        if error is None:
            assert many.factor_range is alone.factor_range is None
        else:
            assert np.asarray(many.factor_range)[:, k] == pytest.approx(alone.factor_range)


@pytest.mark.parametrize("error", [EXACT, ErrorRange(-1.0, 0.5), ErrorRange(-0.1, 0.05), None])
@pytest.mark.parametrize("in_capacity", [True, False])
@pytest.mark.parametrize("tolerance", [None, 0.02])
@pytest.mark.parametrize("power", [1, 2])
@pytest.mark.parametrize(
    ("demand", "capacity"),
    # small numbers, targets missed on either side and met, nothing that bears
    [(0.04, 0.09), (0.09, 0.04), (1.0, 1.0), (1.0, 4.0), (2.0, 0.0), (2.0, -1.0)],
)
def test_many_designs_are_told_what_each_is_told_alone(
    demand, capacity, power, tolerance, in_capacity, error
):
    def judged(of):
        limit = Limit(
            "x", "", "x", of(demand), of(capacity), "Pa", "",
            power=power, tolerance=tolerance, in_capacity=in_capacity, error=error,
        )  # fmt: skip
        (found,) = assess.checks([limit])
        return found

    many, alone = judged(lambda x: Rows.of([x, x])), judged(float)
    assert many.verdict is alone.verdict
    for name in ("demand", "capacity", "factor"):
        first, second = np.asarray(getattr(many, name))
        assert first == second == pytest.approx(getattr(alone, name)), name
    if error is None:
        assert many.factor_range is alone.factor_range is None
    else:
        assert np.asarray(many.factor_range)[:, 0] == pytest.approx(alone.factor_range)


@pytest.mark.parametrize("demand", [0.0, -1.0])
def test_a_target_that_is_not_there_at_all_is_missed(demand):
    limit = Limit("x", "", "x", demand, 2.0, "N/m", "", tolerance=0.1, error=EXACT)
    (alone,) = assess.checks([limit])
    (many,) = assess.checks([limit._replace(demand=Rows.of([demand, demand]))])
    assert alone.verdict is many.verdict is Verdict.FAIL
    assert alone.factor == np.asarray(many.factor)[0] == 0.0
