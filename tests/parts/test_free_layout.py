"""A mechanism that the spec draws itself: the same numbers as its kind, and frames as stated."""

from math import cos, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pydantic import TypeAdapter
from strategies import TITANIUM, design
from twins.joints import TURN as TURNS
from twins.reissner import GROUND, Beam, Frame, Mass

from flexcli.engine.check import check
from flexcli.engine.models import NamedModel, model_series
from flexcli.errors import SolveError
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.linear import linear
from flexcli.mechanics.mesh import Effects
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries import AnyGeometry
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import RequirementError

ADAPTER = TypeAdapter(AnyGeometry)
ELASTIC = Elastic(114e9, 0.34)
BENDING = Effects(extension=True, shear=False)

SAME = 1e-12
"""Two drawings of one mechanism: the same equations but for rounding of their coordinates."""

E, B, L = 114e9, 10e-3, 50e-3


def metres(*point):
    return [f"{float(x)!r} m" for x in point]


def blade(ends, start, end, **given):
    drawn = {"between": ends, "from": metres(*start), "to": metres(*end), "b": "10 mm", **given}
    return drawn if "profile" in drawn else {"h": "0.3 mm", **drawn}


def layout(bodies, blades, moving="stage", motion="rotation", **given):
    at = {name: {"at": metres(*point)} for name, point in bodies.items()}
    given = {"moving": moving, "motion": motion, **given}
    return {"kind": "layout", "bodies": at, "blades": blades, **given}


def rcc(centre=(0.0, 0.0), p=2e-3, l=20e-3):
    rays = {"blade-1": pi / 4.0, "blade-2": -pi / 4.0}
    blades = {
        name: blade(
            ["ground", "arm"],
            *((centre[0] + r * cos(a), centre[1] + r * sin(a)) for r in (p, p + l)),
            h="0.2 mm",
            b="5 mm",
        )
        for name, a in rays.items()
    }
    return layout({"arm": centre}, blades, "arm")


RCC = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg", "h": "0.2 mm", "l": "20 mm", "b": "5 mm"}
TURN = {"turn": {"stroke": {"rotation": "3 deg", "cycles": 1e7}}}
PUSHED = {"turn": {"stroke": {"rotation": "3 deg", "cycles": 1e7}, "load": {"force": "20 N"}}}


def found(geometry, model, requirements, cases):
    left = ("plate-widening", "anticlastic", "large-rotation", "axial-load")
    beams = {"effects": dict.fromkeys(left, "off")}
    part = design(geometry, requirements, cases).model_copy(update=beams)
    return check(part, part.fixed_sizes(), "spec", model)


@pytest.mark.parametrize("centre", [(0.0, 0.0), (12e-3, -7e-3)], ids=["origin", "elsewhere"])
@pytest.mark.parametrize("cases", [TURN, PUSHED], ids=["turned", "pushed"])
@pytest.mark.parametrize("model", ["linear", "exact"])
def test_an_rcc_pivot_that_is_drawn_is_that_of_the_catalogue(model, cases, centre):
    asked = {"yield": 1.5, "stiffness": {"min": "0.1 N*m/rad"}}
    drawn, known = (found(g, model, asked, cases) for g in (rcc(centre), RCC))
    for one, other in zip(drawn.checks, known.checks, strict=True):
        assert one.demand == pytest.approx(other.demand, rel=SAME), one.name
        assert one.capacity == pytest.approx(other.capacity, rel=SAME)
    assert drawn.values["k_pivot"].value == pytest.approx(known.values["k_pivot"].value, rel=SAME)
    if model == "exact":
        assert drawn.values["shift"].value == pytest.approx(known.values["shift"].value, rel=1e-9)


def pair(thin="0.3 mm", thick="0.3 mm", turn=0.0, **given):
    """Two blades from the ground to a stage at half their height, all turned about the origin."""

    def place(x, y):
        return cos(turn) * x - sin(turn) * y, sin(turn) * x + cos(turn) * y

    blades = {
        name: blade(["ground", "stage"], place(0.0, y), place(L, y), h=h)
        for name, y, h in (("low", 0.0, thin), ("high", 30e-3, thick))
    }
    motion = {"translation": f"{pi / 2.0 + turn!r} rad"}
    return layout({"stage": place(L / 2.0, 15e-3)}, blades, motion=motion, **given)


def driven(geometry):
    """Return the effort along the motion per travel, by linear beams that bend and stretch."""
    part = ADAPTER.validate_python(geometry)
    made = part.layout(ELASTIC, part.sized({}))
    axis = 2 if part.motion == "rotation" else 1
    solved = linear(made, {MOVING: part.held(1.0)}, effects=BENDING)
    return float(solved.reactions[0, [b.name for b in made.bodies].index(MOVING), axis])


def test_unequal_parallel_blades_add_their_stiffness():
    expected = E * B * (0.3e-3**3 + 0.5e-3**3) / L**3
    assert driven(pair(thick="0.5 mm")) == pytest.approx(expected, rel=1e-10)


@settings(max_examples=20)
@given(turn=st.integers(-180, 180))
def test_a_stage_is_the_same_however_it_is_turned_in_the_drawing(turn):
    assert driven(pair(turn=radians(turn))) == pytest.approx(driven(pair()), rel=1e-10)


@pytest.mark.parametrize(
    ("turn", "axis"), [(0.0, "y"), (pi / 2.0, "x"), (-pi / 2.0, "x"), (pi, "y")]
)
def test_springs_along_the_travel_add_and_springs_across_it_do_not(turn, axis):
    """Travel along y of the drawing, or, turned by a quarter, along x."""
    at = ADAPTER.validate_python(pair(turn=turn)).bodies["stage"].at
    spring = {"body": "stage", "at": metres(*at)}
    plain = driven(pair(turn=turn))
    along = driven(pair(turn=turn, supports=[{**spring, axis: "1 N/mm"}]))
    other = {"x": "y", "y": "x"}[axis]
    across = driven(pair(turn=turn, supports=[{**spring, other: "1 N/mm"}]))
    assert along - plain == pytest.approx(1e3, rel=1e-9)
    assert across == pytest.approx(plain, rel=1e-9)


def test_a_turning_spring_adds_to_a_rotation():
    spring = {"body": "arm", "at": metres(0.0, 0.0), "theta": "2 N*m/rad"}
    more = driven({**rcc(), "supports": [spring]}) - driven(rcc())
    assert more == pytest.approx(2.0, rel=1e-10)


def compound():
    """Two equal stages in series, the second folded back into the first."""
    places = {
        "outer-1": (["ground", "frame"], (0.0, -40e-3), (L, -40e-3)),
        "outer-2": (["ground", "frame"], (0.0, 40e-3), (L, 40e-3)),
        "inner-1": (["frame", "stage"], (L, -15e-3), (0.0, -15e-3)),
        "inner-2": (["frame", "stage"], (L, 15e-3), (0.0, 15e-3)),
    }
    blades = {name: blade(*given) for name, given in places.items()}
    middle = (L / 2.0, 0.0)
    motion = {"translation": "90 deg"}
    return layout({"frame": middle, "stage": middle}, blades, motion=motion)


def test_a_compound_stage_has_half_the_stiffness_and_no_shift():
    """One stage of the two shortens by 0.6 (x/2)²/l and the other gives it back."""
    x = 4e-3
    cases = {"move": {"stroke": {"translation": f"{x} m", "cycles": 1e7}}}
    result = found(compound(), None, {"yield": 1.5, "parasitic_shift": {"max": "1 um"}}, cases)
    assert result.cost.model == "exact"
    assert abs(result.values["shift"].value) < 1e-6 * 0.6 * (x / 2.0) ** 2 / L
    assert driven(compound()) == pytest.approx(E * B * 0.3e-3**3 / L**3, rel=1e-9)


def test_the_shift_of_a_stage_is_positive_to_the_left_of_its_travel():
    """The same drawing sent the other way: what lay to the left now lies to the right."""
    shifts = []
    for way in ("90 deg", "-90 deg"):
        drawn = {**pair(), "motion": {"translation": way}}
        cases = {"move": {"stroke": {"translation": "2 mm", "cycles": 1e7}}}
        result = found(drawn, None, {"parasitic_shift": {"max": "1 mm"}}, cases)
        shifts.append(result.values["shift"].value)
    assert shifts[0] == pytest.approx(0.6 * 2e-3**2 / L, rel=1e-2)
    assert shifts[1] == pytest.approx(-shifts[0], rel=1e-6)


UNEVEN = {
    "a": ((-20e-3, -10e-3), (3e-3, 2e-3), 1e-3),
    "b": ((1e-3, -15e-3), (2e-3, 12e-3), 2e-3),
    "c": ((10e-3, -15e-3), (-4e-3, 2e-3), 1.5e-3),
}
"""Start, end and thickness [m] of blades that are no mirror image of themselves."""


@pytest.mark.parametrize("ends", [(0.0, 0.02), (-0.02, 0.0), (-0.02, 0.02)])
def test_the_shift_of_an_uneven_pivot_is_that_of_its_worse_end(ends):
    """It stretches its blades by the rotation and shortens them by its square: ends differ."""
    nu = ELASTIC.nu
    beams = [Beam(GROUND, "arm", start, end, h, B) for start, end, h in UNEVEN.values()]
    frame = Frame((("arm", Mass((0.0, 0.0))),), beams, E, E / 2.0 / (1.0 + nu))
    each = [
        float(np.hypot(*frame.motion(frame.solve({("arm", TURNS): end}), "arm", (0.0, 0.0))[:2]))
        for end in ends
        if end
    ]
    if len(each) == 2:
        assert each[0] > 1.02 * each[1]
    blades = {
        name: blade(["ground", "arm"], start, end, h=f"{h} m")
        for name, (start, end, h) in UNEVEN.items()
    }
    drawn = layout({"arm": (0.0, 0.0)}, blades, "arm")
    cases = {"turn": {"stroke": {"rotation": [f"{end} rad" for end in ends], "cycles": 1e7}}}
    result = found(drawn, None, {"parasitic_shift": {"max": "1 mm"}}, cases)
    assert abs(result.values["shift"].value) == pytest.approx(max(each), rel=1e-3)


def tip(profile, l=30e-3):
    """One blade from the ground to an arm that turns."""
    return layout(
        {"arm": (0.0, 0.0)},
        {"only": blade(["ground", "arm"], (-l / 2.0, 0.0), (l / 2.0, 0.0), profile=profile)},
        "arm",
    )


TABLE = {"kind": "tabulated", "at": [0, 0.3, 1], "h": ["0.3 mm"] * 3}


@pytest.mark.parametrize("h", ["0.3 mm", {"free": ["0.1 mm", "1 mm"]}], ids=["fixed", "free"])
def test_a_table_of_one_thickness_is_a_blade_of_constant_thickness(h):
    part = ADAPTER.validate_python(tip({"kind": "constant", "h": h}))
    other = ADAPTER.validate_python(tip(TABLE))
    sizes, none = part.sized({"h_only": 0.3e-3}), other.sized({})
    held = {MOVING: (None, 1e-3, 0.4)}
    states = [
        solve(p.layout(ELASTIC, s), held).checked().reactions
        for p, s in ((part, sizes), (other, none))
    ]
    assert states[0] == pytest.approx(states[1], rel=1e-8)
    assert other.volume(none) == pytest.approx(part.volume(sizes), rel=SAME)
    assert other.ratios(none) == pytest.approx(part.ratios(sizes), rel=SAME)


@pytest.mark.parametrize(
    ("profile", "known"),
    [
        (
            {"kind": "notch", "e": "0.1 mm", "depth": "2 mm"},
            {"kind": "elliptic-hinge", "e": "0.1 mm", "depth": "2 mm"},
        ),
        (
            {"kind": "filleted", "h": "0.2 mm", "r": "1 mm"},
            {"kind": "filleted-hinge", "h": "0.2 mm", "r": "1 mm"},
        ),
        ({"kind": "constant", "h": "0.2 mm"}, {"kind": "moment-blade", "h": "0.2 mm"}),
    ],
    ids=["notch", "filleted", "constant"],
)
def test_a_drawn_profile_turns_as_the_hinge_of_the_catalogue(profile, known):
    hinge = ADAPTER.validate_python({**known, "l": "6 mm", "b": "10 mm"})
    assert driven(tip(profile, 6e-3)) == pytest.approx(
        float(hinge.stiffness(ELASTIC, hinge.sized({}))), rel=1e-10
    )
    part = ADAPTER.validate_python(tip(profile, 6e-3))
    assert part.volume(part.sized({})) == pytest.approx(
        float(hinge.volume(hinge.sized({}))), rel=1e-10
    )


def test_necked_blades_move_as_the_necked_stage():
    neck = {"kind": "necked-down", "h": "0.3 mm", "l_c": "8 mm"}
    drawn = pair()
    for each in drawn["blades"].values():
        del each["h"]
        each["profile"] = neck
    known = ADAPTER.validate_python(
        {"kind": "necked-down-stage", "h": "0.3 mm", "l_c": "8 mm", "l": "50 mm", "b": "10 mm"}
    )
    sizes = known.sized({})
    assert driven(drawn) == pytest.approx(known.stiffness(ELASTIC, sizes), rel=1e-9)
    part = ADAPTER.validate_python(drawn)
    assert part.volume(part.sized({})) == pytest.approx(known.volume(sizes), rel=SAME)


def test_thicknesses_are_sizes_by_blade():
    part = ADAPTER.validate_python(pair(thick="free"))
    assert (tuple(part.extents), part.free) == (("h_low", "h_high"), ("h_high",))
    assert part.label("h_high") == "thickness of blade high"
    sizes = part.sized({"h_high": 0.5e-3})
    assert (sizes.h_low, sizes.h_high) == pytest.approx((0.3e-3, 0.5e-3))
    assert part.ratios(sizes)["l/h high"] == pytest.approx(100.0)
    notched = ADAPTER.validate_python(tip({"kind": "notch", "e": "free", "depth": "2 mm"}))
    assert notched.free == ("e_only",)


@settings(max_examples=5, deadline=None)
@given(h=st.lists(st.floats(0.1e-3, 0.8e-3), min_size=2, max_size=4, unique=True))
def test_an_array_of_thicknesses_is_the_thicknesses_one_by_one(h):
    part = ADAPTER.validate_python(pair(thick="free"))
    many = part.sized({"h_high": np.array(h)})
    state = solve(part.layout(ELASTIC, many), {MOVING: part.held(1e-3)}).checked()
    volumes = part.volume(many)
    for index, each in enumerate(h):
        one = part.sized({"h_high": each})
        alone = solve(part.layout(ELASTIC, one), {MOVING: part.held(1e-3)}).checked()
        assert state.reactions[index, 0, 1] == pytest.approx(alone.reactions[0, 0, 1], rel=1e-8)
        assert volumes[index] == pytest.approx(part.volume(one), rel=SAME)


def test_what_is_drawn_has_no_closed_form_and_says_what_has():
    part = ADAPTER.validate_python(rcc())
    sizes = part.sized({})
    with pytest.raises(NotAvailable, match="take --model linear or exact"):
        part.stiffness(ELASTIC, sizes)
    with pytest.raises(NotAvailable, match="take --model linear or exact"):
        part.end_stresses(ELASTIC, sizes, 0.1)
    with pytest.raises(SolveError, match="no closed forms"):
        _ = NamedModel(design(rcc(), {"yield": 1.5}, TURN), "closed-form").joint_model


@pytest.mark.parametrize(
    ("geometry", "asked", "model"),
    [(rcc(), None, "linear"), (rcc(), "linear", "linear"), (RCC, None, "closed-form")],
)
def test_the_model_is_the_cheapest_that_there_is_unless_one_is_asked(geometry, asked, model):
    assert model_series(design(geometry, {"yield": 1.5}, TURN), asked)[0].name == model


def test_the_linear_model_has_no_shift_and_says_which_has():
    part = design(rcc(), {"parasitic_shift": {"max": "1 um"}}, TURN)
    with pytest.raises(RequirementError, match="--model exact"):
        part.limits(part.fixed_sizes(), NamedModel(part, "linear").joint_model)


def test_a_drawing_is_loaded_without_closed_forms_and_with_what_else_must_fit():
    part = design(rcc(), {"yield": 1.5, "fatigue": 1.5, "stiffness": {"max": "1 N*m/rad"}}, TURN)
    assert part.problems() == []
    for wrong, said in (
        ({"stiffness": {"max": "1 N/m"}}, "is in N"),
        ({"frequency": {"min": "1 Hz"}}, "needs a mass"),
        ({"yield": 1.5}, "yield_strength"),
    ):
        bare = {key: TITANIUM[key] for key in ("youngs_modulus", "poisson_ratio")}
        with pytest.raises(Exception, match=said):
            design(rcc(), wrong, TURN, material=bare)


def test_bodies_on_springs_alone_may_stand_where_these_hold_them():
    """Two springs along y, apart, hold the rotation that one of them leaves free."""
    springs = [
        {"body": "base", "at": metres(x, 1e-3), "x": "1 N/um", "y": "1 N/um"} for x in (0.0, 0.02)
    ]
    blades = {"only": blade(["base", "arm"], (0.0, 0.0), (0.03, 0.0))}
    drawn = layout({"base": (0.0, 0.0), "arm": (0.015, 0.0)}, blades, "arm")
    assert driven({**drawn, "supports": springs}) > 0.0
    with pytest.raises(ValueError, match="not held"):
        ADAPTER.validate_python({**drawn, "supports": springs[:1]})
