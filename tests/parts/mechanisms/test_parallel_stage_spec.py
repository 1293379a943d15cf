"""The parallel stage of a spec: what may be free, and that every verb sees what was chosen."""

import pytest
from pydantic import TypeAdapter, ValidationError

from flexcli.parts.mechanisms import AnyMechanism

SOLID = {"mass": "17.138708 g", "com": "10.411598 mm", "inertia": "5.3569824e-6 kg*m^2"}
BALANCE = {"mass": "35.565044 g", "arm": "24.1716 mm", "inertia": "1.1271682e-6 kg*m^2"}


def stage(first=(), third=(), **keys):
    spec = {
        "kind": "parallel-stage",
        "height": "20 mm",
        "solid-1": SOLID,
        "solid-2": {"mass": "68.1223 g"},
        "solid-3": SOLID,
        "balance-1": {**BALANCE, **dict(first)},
        "balance-3": {**BALANCE, **dict(third)},
    }
    return TypeAdapter(AnyMechanism).validate_python({**spec, **keys})


def fault(**keys):
    with pytest.raises(ValidationError) as error:
        stage(**keys)
    (raw,) = error.value.errors()
    return raw["ctx"]["text"]


FREE_ARM = {"arm": "free"}


def test_forces_and_masses_are_those_of_the_arm_that_was_chosen():
    free, given = stage(FREE_ARM, FREE_ARM), stage()
    for body in ("F_1", "F_2"):
        one, other = (s.locked_forces("solid-2", 9.81)[body] for s in (free, given))
        assert one == pytest.approx(other, rel=1e-5)
    assert free.equivalent_mass(balanced=True) == pytest.approx(
        given.equivalent_mass(balanced=True), rel=1e-5
    )


def test_nothing_free_and_no_bound_ask_no_coupling():
    assert stage().coupling_limit() is None
    assert stage(coupling="1 %").coupling_limit() is not None
    assert stage(FREE_ARM).coupling_limit() is not None


def test_stated_pivots_stand_in_place_of_the_blades():
    assert stage().stiffnesses(15.0) == (15.0,) * 4
    assert stage(**{"pivot-stiffness": "0 N*m/rad"}).stiffnesses(15.0) == (0.0,) * 4
    some = stage(**{"pivot-stiffness": ["14 N*m/rad", None, "16 N*m/rad", None]})
    assert some.stiffnesses(15.0) == (14.0, 15.0, 16.0, 15.0)
    assert some.mode(15.0, None).stiffness == pytest.approx(60.0 / 0.02**2)


def test_a_common_unknown_keeps_the_tighter_bounds():
    (arm,) = stage(
        {"arm": {"free": ["1 mm", "40 mm"]}}, {"arm": {"free": [None, "30 mm"]}}
    )._unknowns()
    assert arm.bounds == (0.001, 0.03)


def test_the_share_of_a_total_keeps_both_masses_within_their_bounds():
    (split,) = stage(
        {"mass": {"free": ["10 g", "60 g"]}}, {"mass": {"free": [None, "50 g"]}},
        **{"added-mass": "100 g"},
    )._unknowns()  # fmt: skip
    assert split.bounds == pytest.approx((0.5, 0.6))


@pytest.mark.parametrize(
    ("keys", "text"),
    [
        ({"first": {"arm": "free", "mass": "free"}}, "there is no best one"),
        ({"first": FREE_ARM, "height": "free"}, "needs bounds"),
        ({"first": {"arm": "free", "mass": "free"}, "height": "free"}, "more than two"),
        ({"added-mass": "70 g"}, "both free"),
        ({"pivot-stiffness": ["1 N*m/rad"] * 3}, "four pivots"),
        ({"first": {"arm": {"free": ["3 mm", "2 mm"]}}}, "not below"),
        ({"first": {"arm": {"free": "3 mm"}}}, "free between bounds"),
        ({"damping": {"q": 100, "ratio": 0.1}}, "a q or a ratio"),
        ({"damping": {"ratio": 2}}, "nothing oscillates"),
    ],
)
def test_what_cannot_be_solved_is_refused(keys, text):
    assert text in fault(**keys)


def test_damping_by_ratio_is_half_the_inverse_of_q():
    assert stage(damping={"ratio": "0.5 %"}).damping.quality == 100.0
