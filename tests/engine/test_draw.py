"""What is drawn lies where the solver, statics and published shapes say that it lies."""

import re
from math import cos, hypot, sin
from pathlib import Path

import numpy as np
import pytest
from geometries_for_tests import MATERIAL, SAMPLES, spec
from scipy.integrate import solve_bvp

import flexcli
from flexcli.engine.draw import drawing
from flexcli.engine.draw_mechanism import mechanism_drawing
from flexcli.engine.simulate import simulate
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.report.drawings.caption import magnification
from flexcli.report.drawings.plane import drawing_svg
from flexcli.spec.load import load

EXAMPLES = Path(__file__).parents[2] / "examples"

PLANAR = sorted(set(SAMPLES) - {"torsion-bar", "round-torsion-bar", "torsion-star"})


def design(geometry, cases=None, **others):
    rotates = geometry["kind"] in ROTATES
    stroke = {"rotation": "2 deg"} if rotates else {"translation": "0.3 mm"}
    return DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": MATERIAL,
            "geometry": geometry,
            "cases": cases or {"work": {"stroke": stroke}},
            "requirements": {"yield": 1.5},
            **others,
        }
    )


ROTATES = {
    "rcc", "cross-spring", "unseparated-cross", "three-blade", "star", "notch-hinge",
    "moment-blade", "elliptic-hinge", "filleted-hinge", "hinged-pivot",
    "torsion-bar", "round-torsion-bar", "torsion-star",
}  # fmt: skip


def drawn(kind, **changes):
    part = design(spec(kind, **changes))
    return drawing(part, part.fixed_sizes())


def moved(place, body, motion):
    """Return where a place of a body is after its motion, worked out anew."""
    (u, v, phi), (px, py) = motion, body.point
    rx, ry = place[0] - px, place[1] - py
    return px + u + cos(phi) * rx - sin(phi) * ry, py + v + sin(phi) * rx + cos(phi) * ry


@pytest.mark.parametrize("kind", PLANAR)
def test_bent_blades_end_where_the_bodies_carry_them(kind):
    found = drawn(kind)
    bodies = {body.name: body for body in found.bodies}
    known = {name.replace("moving body", "moving"): body for name, body in bodies.items()}
    assert len(found.states) == 2
    for state in found.states:
        motions = {n.replace("moving body", "moving"): m for n, m in state.motions.items()}
        for blade in found.blades:
            for name, k in ((blade.first, 0), (blade.second, -1)):
                want = blade.axis[k]
                if name in motions:
                    want = moved(want, known[name], motions[name])
                size = hypot(*(b - a for a, b in zip(blade.axis[0], blade.axis[-1], strict=True)))
                # the exact model's own tolerance is 1e-9 of the length
                assert state.axes[blade.name][k] == pytest.approx(want, abs=1e-7 * size)


@pytest.mark.parametrize("kind", PLANAR)
def test_the_two_ends_of_a_stroke_lie_either_side_of_rest(kind):
    found = drawn(kind)
    plus, minus = found.states
    assert plus.travel == -minus.travel > 0.0
    for name, (u, v, phi) in plus.motions.items():
        most = max(abs(u), abs(v), abs(phi) * 1e-2)
        if most > 1e-6:
            x, y, turn = minus.motions[name]
            assert u * x <= 0.0 or v * y <= 0.0 or phi * turn <= 0.0


def test_a_blade_turned_by_a_moment_is_an_arc():
    found = drawn("moment-blade", h=0.02)
    state = found.states[0]
    l, theta = 20e-3, state.travel
    (line,) = state.axes.values()
    places = np.array(line)
    # on a circle of radius l/θ about the point across the clamp, whose axis is stretched by nothing
    start, way = places[0], np.array(found.blades[0].axis[-1]) - places[0]
    across = np.array([-way[1], way[0]]) / np.hypot(*way)
    centre = start + across * (l / theta)
    np.testing.assert_allclose(np.hypot(*(places - centre).T), l / theta, rtol=1e-9)


def test_a_pushed_cantilever_is_the_elastica():
    part = design(
        {"kind": "cantilever", "h": "0.05 mm", "l": "50 mm", "b": "10 mm"},
        {"work": {"stroke": {"translation": "25 mm"}}},
    )
    found = drawing(part, part.fixed_sizes())
    line = np.array(next(iter(found.states[0].axes.values())))
    start, end = (np.array(found.blades[0].axis[k]) for k in (0, -1))
    l, way = 50e-3, (end - start) / np.hypot(*(end - start))
    x, y = (line - start) @ way / l, np.abs((line - start) @ np.array([-way[1], way[0]])) / l
    want = elastica(0.5)
    np.testing.assert_allclose(y, np.interp(x, want[2], want[3]), atol=1e-5)  # 2000 places


def elastica(rise):
    """Return ψ, ψ', x, y of a blade of unit length whose end is pushed up by a force across it."""

    def rates(s, z, q):
        return np.vstack([z[1], -q[0] * np.cos(z[0]), np.cos(z[0]), np.sin(z[0])])

    def ends(first, last, q):
        return np.array([first[0], first[2], first[3], last[1], last[3] - rise])

    s = np.linspace(0.0, 1.0, 41)
    guess = np.array([rise * s * 1.5, 1.5 * (1 - s), s, rise * s**2])
    found = solve_bvp(rates, ends, s, guess, p=[3.0], tol=1e-9)
    assert found.success
    return found.sol(np.linspace(0.0, 1.0, 2000))


def test_the_stress_along_a_blade_is_greatest_where_simulate_finds_it():
    part = design(spec("leaf-spring-stage"))
    found = drawing(part, part.fixed_sizes())
    swept = simulate(part, part.fixed_sizes(), "spec", 2).sweeps[0].points[-1]
    most = max(max(stress) for stress in found.states[0].stress.values())
    assert most == pytest.approx(swept.total, rel=1e-9)


@pytest.mark.parametrize("kind", ["torsion-bar", "round-torsion-bar", "torsion-star"])
def test_bars_that_twist_are_drawn_at_rest(kind):
    found = drawn(kind)
    assert found.twists
    assert len(found.blades) in (1, 2)
    assert not found.states


def test_a_drawing_has_the_thickness_of_its_profile():
    found = drawn("notch-hinge")
    (blade,) = found.blades
    assert min(blade.thickness) == pytest.approx(0.05e-3)
    assert max(blade.thickness) == pytest.approx(0.05e-3 + 2 * 2e-3)


def test_the_overlay_is_magnified_by_a_round_number_and_said():
    small = drawn("leaf-spring-stage")
    times = magnification(small)
    assert times in {1.0, 2.0, 3.0, 5.0, 10.0, 20.0}
    ends = np.array(small.states[0].axes["blade 1"])[-1] - np.array(small.blades[0].axis)[-1]
    assert times * np.hypot(*ends) < 0.2 * 20e-3


def test_a_case_that_is_not_there_is_told_with_those_that_are():
    part = design(spec("rcc"))
    with pytest.raises(SolveError, match="no case flight") as caught:
        drawing(part, part.fixed_sizes(), "flight")
    assert "work" in caught.value.remedy


def test_a_parallel_stage_is_drawn_moved_as_its_pivots_let_it():
    part = load(EXAMPLES / "force-balanced-stage" / "flexure.yaml").part
    found = mechanism_drawing(part, part.fixed_sizes())
    height = {length.name: length for length in found.lengths}["H"].end[1]
    assert [name for name, _ in found.pivots] == ["P1", "P2", "P3", "P4"]
    pivot = drawing(part, part.fixed_sizes())
    (cx, cy), path = pivot.centre, pivot.path
    shift = max(hypot(x - cx, y - cy) for x, y in path)
    assert len(found.blades) == 4 * len(pivot.blades)
    for state in found.states:
        x, _, phi = state.motions["solid 2"]
        assert x == pytest.approx(state.travel, rel=1e-9)  # what is prescribed
        # both levers turn alike: solid 2 stays level, to what two unlike ends of a blade leave
        assert abs(phi) < 1e-3 * abs(x) / height
        for lever in ("solid 1", "solid 3"):
            gone = x + height * state.motions[lever][2]
            assert abs(gone) < 2.0 * shift, "a lever has two pivots, and each shifts"
        bodies = {body.name: body for body in found.bodies if not body.is_ground}
        for blade in found.blades:
            for end, name in ((0, blade.first), (-1, blade.second)):
                want = blade.axis[end]
                if name in bodies:
                    want = moved(want, bodies[name], state.motions[name])
                assert state.axes[blade.name][end] == pytest.approx(want, abs=1e-9)


def test_a_locked_stage_stands_still_on_its_lock():
    part = load(EXAMPLES / "force-balanced-stage" / "flexure.yaml").part
    locked = [name for name, case in part.cases.items() if case.lock]
    found = mechanism_drawing(part, part.fixed_sizes(), locked[0])
    assert not found.states
    assert "solid 2" not in {body.name for body in found.bodies}
    assert any("locked" in note for note in found.notes)


def test_a_payload_is_drawn_with_its_mass_at_the_centre_that_the_model_gives_it():
    part = load(EXAMPLES / "linear-stage" / "flexure.yaml").part
    found = mechanism_drawing(part, part.fixed_sizes())
    (mass,) = [mass for body in found.bodies for mass in body.masses]
    assert mass.mass == part.mechanism.mass


@pytest.mark.parametrize("name", ["butterfly-pivot", "folded-stage", "leaf-spring-guide"])
def test_a_mechanism_in_space_is_drawn_moved_from_every_side(name):
    part = load(EXAMPLES / name / "flexure.yaml").part
    front = drawing(part, part.fixed_sizes())
    assert set(front.views) == {"side", "isometric"}
    rotates = front.motion == "rotation"
    drive = part.geometry.space_layout(part.material.elastic, part.fixed_sizes()).drive.body
    for state in front.states:
        u, v, phi = state.motions[drive]
        # what is prescribed; the front shows all of it
        gone = abs(phi) if rotates else hypot(u, v)
        assert gone == pytest.approx(abs(state.travel), rel=1e-2)
    for view in (front, *front.views.values()):
        assert [state.travel for state in view.states] == [s.travel for s in front.states]
        assert len(view.blades) > 1
    bodies = {body.name: body for body in front.bodies if not body.is_ground}
    for state in front.states:
        for blade in front.blades:
            for end, body in ((0, blade.first), (-1, blade.second)):
                want = blade.axis[end]
                if body in bodies:  # these stay in their plane
                    want = moved(want, bodies[body], state.motions[body])
                assert state.axes[blade.name][end] == pytest.approx(want, abs=1e-7)


def test_a_view_states_no_length_that_it_does_not_show():
    part = load(EXAMPLES / "tripod-mount" / "flexure.yaml").part
    corner = drawing(part, part.fixed_sizes()).views["isometric"]
    svg = drawing_svg(corner, "tripod")
    lengths = set(re.findall(r">([\d.]+) mm<", svg))
    seen = [hypot(*np.subtract(b.axis[-1], b.axis[0])) for b in corner.blades]
    short = [s for s, b in zip(seen, corner.blades, strict=True) if s < 0.99 * b.length]
    assert short
    assert not lengths & {f"{s * 1e3:.4g}" for s in short}


def test_a_linkage_whose_flexures_were_sized_is_drawn_by_its_links():
    path = EXAMPLES / "crank-linear-stage" / "flexure.yaml"
    spec = flexcli.sized(path, flexcli.size(path, model="source"))
    assert not spec.part.geometry.free
    links = {body.name for body in flexcli.drawing(spec).bodies}
    assert links == {"ground", "crank", "rod", "stage"}


THIN = {
    "geometry.joints.theta.flexure.h": "120um",
    "geometry.joints.beta.flexure.h": "60um",
    "geometry.joints.alpha.flexure.h": "330um",
}


@pytest.fixture(scope="module")
def crank():
    return flexcli.drawing(EXAMPLES / "crank-linear-stage" / "flexure.yaml", overrides=THIN)


def test_a_linkage_is_drawn_where_its_spec_has_it(crank):
    assert dict(crank.pivots) == {
        "theta": (0.0, 0.0),
        "beta": (0.0, 50e-3),
        "alpha": (-50e-3, 50e-3),
    }
    assert crank.centre == (0.0, 0.0)
    for name, place in crank.pivots:
        own = [blade for blade in crank.blades if blade.name.startswith(name)]
        assert len(own) == 2
        for blade in own:  # a blade of δ = −0.5 crosses in its middle
            middle = np.mean([blade.axis[0], blade.axis[-1]], axis=0)
            np.testing.assert_allclose(middle, place, atol=1e-12)
    (stage,) = crank.guides
    assert stage.is_ideal
    assert (stage.name, stage.way) == ("z", (1.0, 0.0))


@pytest.fixture(scope="module")
def led():
    """Return the crank's linkage driven by its stage, of leaf springs, with a payload on it."""
    pivot = {
        "kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg",
        "h": "0.1 mm", "l": "15 mm", "b": "5 mm",
    }  # fmt: skip
    leaves = {
        "kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "5 mm", "spacing": "15 mm",
    }  # fmt: skip
    above, left = ["0 mm", "50 mm"], ["-50 mm", "50 mm"]
    joints = {
        "z": {"links": ["base", "stage"], "at": ["-80 mm", "50 mm"], "along": [1, 0],
              "flexure": leaves},
        "alpha": {"links": ["rod", "stage"], "at": left, "turned": "180 deg", "flexure": pivot},
        "beta": {"links": ["rod", "crank"], "at": above, "flexure": pivot},
        "theta": {"links": ["crank", "base"], "turned": "90 deg", "flexure": pivot},
    }  # fmt: skip
    geometry = {"kind": "linkage", "ground": "base", "input": "z", "joints": joints}
    payload = {"kind": "payload", "mass": "50 g"}
    part = design(geometry, {"work": {"stroke": {"translation": "1 mm"}}}, mechanism=payload)
    return drawing(part, part.fixed_sizes())


def test_a_linkage_led_by_its_stage_moves_along_it_in_the_drawing(led):
    plus, minus = led.states
    assert (plus.motions["stage"][0], minus.motions["stage"][0]) == pytest.approx((1e-3, -1e-3))
    # to the right above the pivot is clockwise, by 1 mm over 50 mm and the square of that
    assert plus.motions["crank"][2] == pytest.approx(-1.0 / 50.0, rel=0.02)
    (mass,) = [m for body in led.bodies if body.name == "stage" for m in body.masses]
    assert mass.mass == 50e-3


@pytest.mark.parametrize("name", ["crank", "led"])
def test_bent_blades_of_a_linkage_end_where_its_links_carry_them(name, request):
    found = request.getfixturevalue(name)
    bodies = {body.name: body for body in found.bodies if not body.is_ground}
    assert len(found.states) == 2
    for state in found.states:
        for blade in found.blades:
            for name, k in ((blade.first, 0), (blade.second, -1)):
                want = blade.axis[k]
                if name in bodies:
                    want = moved(want, bodies[name], state.motions[name])
                # the exact model's own tolerance is 1e-9 of the length
                assert state.axes[blade.name][k] == pytest.approx(want, abs=1e-7 * 15e-3)


def test_a_drawn_linkage_moves_as_its_rigid_links_do_but_for_the_shifts_of_its_pivots(crank):
    for state in crank.states:
        # theta joins crank and base: a positive turn is of the base against the crank
        assert state.motions["crank"][2] == pytest.approx(-state.travel)
        x, y, turn = state.motions["stage"]
        assert (y, turn) == pytest.approx((0.0, 0.0), abs=1e-12)  # its ideal guide
        sink = 50e-3 * (1.0 - cos(state.travel))
        back = 50e-3 * sin(state.travel) + 50e-3 - np.sqrt(50e-3**2 - sink**2)
        # no pivot of crossed blades shifts by more than a tenth of l θ²
        assert x == pytest.approx(back, abs=3 * 0.1 * 15e-3 * state.travel**2)


def test_a_linkage_with_pins_that_no_exact_model_takes_is_drawn_at_rest_and_says_why():
    part = DesignSpec.model_validate(PINNED)
    found = drawing(part, part.fixed_sizes())
    assert not found.states
    assert "ideal joint" in found.missed
    assert [name for name, _ in found.pivots] == ["a", "c", "d", "e"]
    assert {blade.name.split()[0] for blade in found.blades} == {"a"}
    rod = next(body for body in found.bodies if body.name == "rod")
    assert rod.clamps == ((0.0, 50e-3), (-50e-3, 60e-3))


PINNED = {
    "flexure": 1,
    "material": {"youngs_modulus": "70 GPa", "poisson_ratio": 0.33, "yield_strength": "200 MPa"},
    "geometry": {
        "kind": "linkage", "ground": "base", "input": "a",
        "joints": {
            "a": {
                "links": ["crank", "base"],
                "flexure": {
                    "kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg",
                    "h": "0.1 mm", "l": "15 mm", "b": "5 mm",
                },
            },
            "c": {"links": ["rod", "crank"], "at": ["0 mm", "50 mm"]},
            "d": {"links": ["rod", "rocker"], "at": ["-50 mm", "60 mm"]},
            "e": {"links": ["rocker", "base"], "at": ["-50 mm", "0 mm"]},
        },
    },
    "stroke": {"rotation": "5 deg"},
    "requirements": {"yield": 1},
}  # fmt: skip


def test_the_stress_drawn_in_space_is_the_one_that_the_exact_model_judges():
    path = EXAMPLES / "leaf-spring-guide" / "flexure.yaml"  # no loads beside its stroke
    front = flexcli.drawing(path)
    (judged,) = [c for c in flexcli.check(path, model="exact").checks if c.name.startswith("yield")]
    for view in (front, *front.views.values()):
        state = view.states[0]
        assert state.stress.keys() == {blade.name for blade in view.blades}
        for blade, stress in state.stress.items():
            assert len(stress) == len(state.axes[blade])
        most = max(max(stress) for stress in state.stress.values())
        assert most == pytest.approx(judged.demand, rel=1e-6)


def test_blades_of_a_folded_stage_are_stressed_at_their_clamps_by_their_bending():
    part = load(EXAMPLES / "folded-stage" / "flexure.yaml").part
    front = drawing(part, part.fixed_sizes())
    E, h, l = part.material.elastic.E, 0.2e-3, 50e-3
    travel = front.states[0].travel
    for stress in front.states[0].stress.values():
        # half of the stroke on each blade, 3 E h δ / l², at both clamps; between the cylindrical
        # bending of a plate and that of a beam, 1/(1 − ν²)
        bent = 3.0 * E * h * 0.5 * abs(travel) / l**2
        for end in (0, -1):
            assert 0.98 * bent < stress[end] < 1.15 * bent
        assert min(stress) < 0.2 * bent  # bending changes sign in the middle; stretch is left
