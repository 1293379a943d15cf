"""What accuracy costs: errors fall from model to model, bounds are honest, promises are kept."""

import json
from itertools import pairwise

import numpy as np
import pytest
from geometries_for_tests import MATERIAL, SAMPLES, spec
from strategies import crossed, design, rcc, stage

import flexcli
from flexcli.engine import accuracy as verb
from flexcli.engine.accuracy import accuracy, timed
from flexcli.engine.comparing.compared import Reference, Timed, compared
from flexcli.engine.comparing.model_series import (
    CONTROL_LEVELS,
    Finest,
    Number,
    SeriesModel,
    numbers,
    series,
)
from flexcli.engine.plan import ACCURACY
from flexcli.errors import SolveError
from flexcli.mechanics.equilibrium import LEVELS
from flexcli.parts.requirements import AS_PRINTED
from flexcli.report.as_json import document, dumps
from flexcli.results import Status

pytestmark = pytest.mark.slow  # every design is solved by every model

TURN = {"turn": {"stroke": {"rotation": "10 deg"}}}
SLENDER = {"h": "0.1 mm", "l": "20 mm", "b": "5 mm"}
TRUTH = Finest(tolerance=1e-13)
"""Finer than the finest of the series."""


def pivot(**changes):
    return design(rcc(**SLENDER, **changes), {"yield": 1}, TURN, material=MATERIAL)


def run(one, asked=0.01):
    return accuracy(one, one.fixed_sizes(), "spec", 1, asked).accuracy


def ranked(settled, models, runs):
    """Stand in for the clock: each model takes longer than the one before, in every quantity."""
    values = timed(settled, models, 0).values
    rank = np.arange(1.0, len(models) + 1.0)
    return Timed(values, np.broadcast_to(rank[:, None], (1, *values.shape)))


@pytest.fixture(scope="module")
def found():
    return run(pivot())


def test_errors_fall_from_model_to_model(found):
    names = ("source", "linear", "exact, 4 nodes", "exact, 6 nodes", "exact, 8 nodes", "exact")
    errors = {row.model: row.error for row in found.models}
    fall = [max(errors[name], 1e-11) for name in names]
    # the linear model's shift is nearly that of the formulas
    assert fall[0] >= fall[1]
    assert all(a > 5.0 * b for a, b in pairwise(fall[1:]))
    assert errors["exact"] < 1e-9
    assert errors[found.finest] == 0.0


@pytest.mark.parametrize(
    "geometry",
    [rcc(**SLENDER), crossed(**SLENDER, delta=-0.5), crossed(**SLENDER, delta=0.4)],
    ids=["rcc", "symmetric", "outside"],
)
def test_the_bound_on_the_finest_is_honest(geometry):
    one = design(geometry, {"yield": 1}, TURN, material=MATERIAL)
    by_name = {number.name: number for number in numbers(one, one.fixed_sizes())}
    for quantity in run(one).quantities:
        truth = by_name[quantity.name].by(TRUTH)
        assert abs(quantity.finest / truth - 1.0) <= quantity.bound
        assert quantity.bound < 1e-10


def test_the_bound_comes_from_nodes_that_the_finest_does_not_use():
    assert not set(CONTROL_LEVELS) & set(LEVELS)


def test_the_finest_stress_is_sought_between_the_places_that_check_looks_at():
    said = spec("hinged-stage") | {"stress-concentration": "none"}
    move = {"move": {"stroke": {"translation": "0.1 mm"}}}
    one = design(said, {"yield": 1}, move, material=MATERIAL)
    (sigma,) = (q for q in run(one).quantities if q.name == "sigma")
    errors = {reading.model: reading.error for reading in sigma.readings}
    # the stress of a notch peaks beside its middle, where no place is
    assert 1e-7 < errors["exact"] < 1e-4
    assert sigma.bound < 1e-8


def random_designs(count):
    rng = np.random.default_rng(1957)
    for _ in range(count):
        delta = rng.choice([rng.uniform(0.0, 1.0), rng.uniform(-0.95, -0.05)])
        h = 20.0 * 10.0 ** rng.uniform(-4, -0.8)
        angle = rng.uniform(15, 75)
        geometry = crossed(
            delta=float(delta), h=f"{h} mm", l="20 mm", b="5 mm", half_angle=f"{angle} deg"
        )
        stroke = {"turn": {"stroke": {"rotation": f"{10.0 ** rng.uniform(-1, 1)} deg"}}}
        yield design(geometry, {"yield": 1}, stroke, material=MATERIAL), 10 ** rng.uniform(-8, -1)


def test_the_recommended_model_keeps_its_promise_on_random_designs(monkeypatch):
    monkeypatch.setattr(verb, "timed", ranked)
    kept = 0
    for one, asked in random_designs(12):
        sizes = one.fixed_sizes()
        result = accuracy(one, sizes, "spec", 1, asked).accuracy
        assert result.recommended
        joint_model = dict(series(one.geometry))[result.recommended]()
        settled = {quantity.name for quantity in result.quantities}
        for number in numbers(one, sizes):
            if number.name in settled:
                assert number.by(joint_model) == pytest.approx(number.by(TRUTH), rel=asked)
                kept += 1
    assert kept > 36


def test_a_tighter_accuracy_takes_a_finer_model(monkeypatch):
    monkeypatch.setattr(verb, "timed", ranked)
    order = [model.name for model in series(pivot().geometry)]
    taken = [order.index(run(pivot(), asked).recommended) for asked in (0.1, 1e-3, 1e-6, 1e-10)]
    assert taken[0] == 0
    assert taken == sorted(taken)
    assert len(set(taken)) == 4


def test_no_accuracy_beyond_the_finest_is_promised():
    one = pivot()
    result = accuracy(one, one.fixed_sizes(), "spec", 1, 1e-14)
    assert result.status is Status.FAIL
    assert result.accuracy.recommended == ""
    assert [note.code for note in result.warnings] == ["accuracy-not-met"]


def by_hand(values, seconds, asked, bound=1e-12):
    """Compare made-up models on one number whose finest value is 1."""
    models = [SeriesModel(name, AS_PRINTED) for name in "abcd"[: len(values)]]
    settled = [Reference(Number("k", "stiffness", "N/m", lambda joint_model: 1.0), 1.0, bound)]
    times = Timed(np.array(values)[:, None], np.array(seconds)[None, :, None])
    return compared(settled, models, times, asked)


def test_the_pareto_set_is_what_no_model_beats_in_both():
    # c is slower than b and no nearer; a is fastest, d nearest
    result = by_hand([1.1, 1.01, 0.98, 1.0], [1.0, 2.0, 3.0, 4.0], 0.05)
    (quantity,) = result.quantities
    assert [reading.pareto for reading in quantity.readings] == [True, True, False, True]
    assert [model.pareto for model in result.models] == [True, True, False, True]
    assert result.recommended == quantity.recommended == "b"


def test_models_nearer_than_the_finest_is_sure_are_alike():
    result = by_hand([1.0 + 1e-9, 1.0 + 1e-10, 1.0], [1.0, 2.0, 3.0], 1e-6, bound=1e-8)
    assert [model.pareto for model in result.models] == [True, False, False]
    # and what is asked must leave room for the finest's own error
    assert by_hand([1.0, 1.0], [1.0, 2.0], 1e-9, bound=1e-8).recommended == ""


def test_a_model_without_an_answer_is_not_recommended_and_says_what_it_lacks():
    result = by_hand([np.nan, 1.0], [np.nan, 1.0], 0.01)
    assert result.recommended == "b"
    assert result.models[0].missing == ("k",)
    assert [reading.model for reading in result.quantities[0].readings] == ["b"]


def test_the_spread_is_that_of_the_runs():
    settled = [Reference(Number("k", "stiffness", "N/m", lambda joint_model: 1.0), 1.0, 1e-12)]
    seconds = np.array([3.0, 1.0, 2.0])[:, None, None]
    times = Timed(np.ones((1, 1)), seconds)
    (model,) = compared(settled, [SeriesModel("a", AS_PRINTED)], times, 0.1).models
    assert (model.least, model.seconds, model.most) == (1.0, 2.0, 3.0)


@pytest.mark.parametrize("kind", ["necked-down-stage", "star"])
def test_every_kind_made_of_blades_has_a_finest_value(kind):
    turns = kind == "star"
    stroke = {"rotation": "2 deg"} if turns else {"translation": "1 mm"}
    one = design(spec(kind), {"yield": 1}, {"move": {"stroke": stroke}}, material=MATERIAL)
    result = run(one)
    assert {"sigma", "k_end"} <= {quantity.name for quantity in result.quantities}
    assert all(quantity.bound < 1e-9 for quantity in result.quantities)


def test_the_critical_force_is_compared_in_the_plane():
    push = {"push": {"load": {"force": "1 N"}, "ends": "clamped-guided"}}
    one = design(stage(**SLENDER, spacing="30 mm"), {"buckling": 1}, push, material=MATERIAL)
    (quantity,) = (q for q in run(one).quantities if q.name == "F_cr")
    assert quantity.readings[0].error < 0.01


def test_a_joint_without_an_exact_model_has_nothing_to_compare():
    assert "torsion-bar" in SAMPLES
    one = design(spec("torsion-bar"), {"yield": 1}, TURN, material=MATERIAL)
    with pytest.raises(SolveError, match="not made of straight blades") as raised:
        run(one)
    assert raised.value.code == "one-model"


def test_the_accuracy_is_the_users_then_the_specs_then_the_default(monkeypatch):
    monkeypatch.setattr(verb, "timed", ranked)

    def taken(one, asked=None):
        return accuracy(one, one.fixed_sizes(), "spec", 1, asked).accuracy.accuracy

    stated = pivot().model_copy(update={"accuracy": 0.03})
    assert taken(stated, 0.2) == 0.2
    assert taken(stated) == 0.03
    assert taken(pivot()) == ACCURACY


def test_json_has_every_model_of_every_quantity(found):
    one = pivot()
    result = accuracy(one, one.fixed_sizes(), "spec", 1)
    content = json.loads(dumps(document(result)))
    rows = content["accuracy"]
    assert rows["recommended"] in [model["model"] for model in rows["models"]]
    assert {q["name"] for q in rows["quantities"]} == set(content["values"])
    keys = {"model", "value", "error", "seconds", "least", "most", "pareto"}
    assert all(keys == set(r) for q in rows["quantities"] for r in q["readings"])
    assert content["values"]["k_pivot"]["model"] == rows["finest"] == found.finest
    assert content["cost"]["estimated_error"] == max(q["bound"] for q in rows["quantities"])


def test_the_stiffness_at_rest_is_that_at_assembly():
    # blades between walls that stay cold, half way to where they buckle
    text = """
flexure: 1
material: {youngs_modulus: 113.8 GPa, poisson_ratio: 0.342, thermal_expansion: 8.6e-6 1/K}
geometry:
  kind: layout
  bodies: {stage: {at: [0 mm, 0 mm]}}
  blades:
    left: {between: [ground, stage], from: [-40 mm, 0 mm], to: [0 mm, 0 mm], h: 0.2 mm, b: 2 mm}
    right: {between: [stage, ground], from: [0 mm, 0 mm], to: [40 mm, 0 mm], h: 0.2 mm, b: 2 mm}
  moving: stage
  motion: {translation: 90 deg}
cases: {hot: {temperature: {uniform: 1.2 K, expansion: {ground: 0 1/K, stage: 0 1/K}}}}
requirements: {buckling: 1.5}
"""
    part = flexcli.load(text).part
    stiffness = next(iter(numbers(part, part.geometry.sized({}))))
    guided = 2.0 * 12.0 * 113.8e9 * 2e-3 * 0.2e-3**3 / 12.0 / 40e-3**3
    # hot it is half as stiff; the blades shear a little
    assert stiffness.by(Finest()) == pytest.approx(guided, rel=2e-3)
