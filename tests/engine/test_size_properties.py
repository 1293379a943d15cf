"""Random specs through size and check: what is sized passes, and what is active is needed."""

import warnings

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from judging import check_as_printed, size_as_printed
from strategies import specs

from flexcli.engine import assess
from flexcli.errors import SolveError
from flexcli.parts.geometries import Blade

LESS = 0.99
ALLOWED = settings(max_examples=12, suppress_health_check=[HealthCheck.filter_too_much])


def sized(spec):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            result = size_as_printed(spec, "spec")
        except SolveError as error:
            assume(error.code not in ("unbounded", "undetermined"))
            raise
    assume(result.status.value != "infeasible")
    return result, Blade(*(result.values[name].value for name in ("h", "l", "b")))


def inside(spec, blade):
    """Whether a blade keeps its bounds and passes check."""
    slack = 1e-9
    for name, extent in spec.geometry.extents.items():
        size = getattr(blade, name)
        if size < (extent.least or 0.0) * (1 - slack) or size > (extent.most or np.inf) * (
            1 + slack
        ):
            return False
    return check_as_printed(spec, blade, "spec").status.value == "pass"


@ALLOWED
@given(specs())
def test_a_sized_design_passes_check(spec):
    result, blade = sized(spec)
    assert result.status.value == "pass"
    assert inside(spec, blade)
    assert {c.name for c in result.checks} == {
        c.name for c in check_as_printed(spec, blade, "spec").checks
    }


@pytest.mark.slow
@ALLOWED
@given(specs())
def test_shrinking_any_dimension_of_the_least_volume_fails(spec):
    spec = spec.model_copy(update={"size": type(spec.size)()})
    _, blade = sized(spec)
    # with one dimension less and the others as they are, the volume would be less
    for name in spec.geometry.free:
        smaller = blade._replace(**{name: getattr(blade, name) * LESS})
        assert not inside(spec, smaller)


@pytest.mark.slow
@ALLOWED
@given(specs())
def test_no_random_neighbour_of_less_volume_is_feasible(spec):
    spec = spec.model_copy(update={"size": type(spec.size)()})
    _, blade = sized(spec)
    rng = np.random.default_rng(1)
    free = [name in spec.geometry.free for name in ("h", "l", "b")]
    moved = np.exp(rng.normal(0, 0.1, (2000, 3)) * free) * np.array(blade)
    less = moved.prod(axis=1) < np.prod(blade) * (1 - 1e-6)
    margins = np.min(
        list(assess.factors(spec, **dict(zip("hlb", moved[less].T, strict=True))).values()), axis=0
    )
    for candidate in moved[less][margins >= 1.0]:
        assert not inside(spec, Blade(*(float(x) for x in candidate)))


@pytest.mark.slow
@ALLOWED
@given(specs())
def test_the_least_volume_is_no_larger_than_any_other_choice(spec):
    _, chosen = sized(spec)
    _, least = sized(spec.model_copy(update={"size": type(spec.size)()}))
    assert np.prod(least) <= np.prod(chosen) * (1 + 1e-8)
