"""Models of a series share what they solve alike, and say what each says alone."""

import pytest
from strategies import design

from flexcli.engine.joint_models import exact, out_of_plane, space_stroke
from flexcli.engine.judge import judge
from flexcli.engine.models import NamedModel, model_series, series_of
from flexcli.errors import SolveError

STEEL = {"name": "steel", "youngs_modulus": "210 GPa", "poisson_ratio": 0.3,
         "yield_strength": "800 MPa", "tensile_strength": "900 MPa"}  # fmt: skip
STAGE = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "10 mm", "blades": 2,
         "spacing": "20 mm"}  # fmt: skip
CASE = {"op": {"stroke": {"translation": "1 mm"}, "wrench": {"z": "20 N"}}}
ASKED = {
    "yield": 1.0,
    "parasitic_shift": {"max": "25 um"},
    "deflection": {"direction": "z", "max": "1 mm"},
}


def spec(asked=ASKED):
    return design(STAGE, asked, CASE, material=STEEL)


def test_what_the_series_says_is_what_each_model_says_alone():
    one = spec()
    series = model_series(one)
    assert [model.name for model in series] == list(series_of(one))
    assert series[-1].name == "shell"
    judge(one, one.fixed_sizes(), series)
    for model in series:
        pair = (model, NamedModel(one, model.name))
        shared, alone = (judge(one, one.fixed_sizes(), (each,)).checks for each in pair)
        assert [check.name for check in shared] == [check.name for check in alone]
        for ours, theirs in zip(shared, alone, strict=True):
            assert ours.factor == pytest.approx(theirs.factor, rel=1e-12)
            apart = theirs.factor_range and pytest.approx(theirs.factor_range, rel=1e-9)
            assert ours.factor_range == apart


def test_each_is_solved_once(monkeypatch):
    found = []

    def counted(name, of):
        find = getattr(of, name)

        def counting(*args, **how):
            found.append(name)
            return find(*args, **how)

        monkeypatch.setattr(of, name, counting)

    counted("across_stress", out_of_plane)
    counted("trail_of", exact)
    one = spec()
    for model in model_series(one):
        (ask,) = one.asks(one.fixed_sizes(), model.joint_model)
        ask.joint_model.stresses(ask)
    assert found.count("across_stress") == 1
    once = found.count("trail_of")
    (ask,) = one.asks(one.fixed_sizes(), NamedModel(one, "exact").joint_model)
    ask.joint_model.stresses(ask)
    assert found.count("trail_of") == 2 * once > 0


def test_a_path_in_space_that_ends_is_followed_once(monkeypatch):
    followed = []

    def ends(*args, **how):
        followed.append(args)
        raise SolveError("no-path", "the path ends", "ask for less")

    monkeypatch.setattr(space_stroke, "solve", ends)
    one = spec()
    (ask,) = one.asks(one.fixed_sizes(), NamedModel(one, "exact").joint_model)
    for _ in range(3):
        with pytest.raises(SolveError, match="the path ends"):
            space_stroke.at_travel(ask, 1e-3)
    assert len(followed) == 1
