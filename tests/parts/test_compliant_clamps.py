"""Blades cut from one piece with their bodies are as soft as plane bodies; no pass forgets it."""

from math import cos, pi, sin, tan

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from plates.rooted_strip import compliance, root
from pydantic import TypeAdapter
from scipy.optimize import brentq

import flexcli
from flexcli.formulas.clamps import clamp_compliance, extra_length
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import AnyGeometry
from flexcli.parts.space_joint import SpaceJoint
from flexcli.results import Status, Verdict

BODIES = {
    "large": {"beyond": (10.0, 10.0), "behind": 10.0},
    "small": {"beyond": (2.0, 2.0), "behind": 2.0},
    "near a side": {"beyond": (1.0, 10.0), "behind": 10.0},
}
FLUSH = {"beyond": (0.0, 10.0), "behind": 10.0}
NU = 0.3
PLANE = 1e-3 / 3.0
"""h/b of blades so wide that a body wider than they are takes nothing."""


def geometry(kind, clamps, **sizes):
    said = {name: f"{x!r} mm" if isinstance(x, float) else x for name, x in sizes.items()}
    return {"kind": kind, "clamps": clamps, **said}


def giving(spec, nu=NU):
    joint = TypeAdapter(AnyGeometry).validate_python(spec)
    return joint.compliant_clamps(joint.sized({}), nu)


@pytest.mark.parametrize("body", BODIES)
def test_a_root_turns_as_that_of_a_plane_body_does(body):
    found = clamp_compliance(h=1.0, b=1.0 / PLANE, poisson_ratio=NU)
    stress = root(**BODIES[body], nu=NU)[0, 0]
    strain = (1.0 - NU**2) * root(**BODIES[body], nu=NU / (1.0 - NU))[0, 0]
    assert found.least <= strain <= stress <= found.most


def test_on_a_half_plane_it_turns_by_5_and_less_than_odonnell_s_linear_stress_makes_it():
    turn = root(beyond=(40.0, 40.0), behind=40.0)[0, 0]
    assert turn == pytest.approx(12.0 * extra_length(h=1.0), rel=2e-3)
    assert turn < 16.67 / pi


def test_a_blade_at_the_side_of_its_body_turns_half_as_much_again():
    found = clamp_compliance(h=1.0, b=1.0 / PLANE, poisson_ratio=NU, flush=True)
    flush, inside = root(**FLUSH)[0, 0], root(**BODIES["large"])[0, 0]
    assert found.least <= inside < 1.5 * inside < flush <= found.most


@pytest.mark.parametrize("clamps", ["monolithic", "monolithic-flush"])
@pytest.mark.parametrize("l", [10.0, 40.0])
def test_single_blades_are_as_soft_as_plane_bodies(l, clamps):
    """Two halves of a blade on their bodies, each from its middle, are the whole."""
    body = FLUSH if clamps == "monolithic-flush" else BODIES["large"]
    half = compliance(l / 2.0, **body, nu=NU)
    true = {"guided-blade": 0.5 / half[1, 1], "moment-blade": 0.5 / half[0, 0]}
    beam = {"guided-blade": 1.0 / (l**3 + 1.2 * l / (0.5 / (1.0 + NU))), "moment-blade": 1 / 12 / l}
    for kind, stiffness in true.items():
        spec = geometry(kind, clamps, h=1.0, l=l, b=1.0 / PLANE)
        factor = giving(spec).stiffness
        assert factor.low <= stiffness / beam[kind] <= factor.high


def frame(joint, ends):
    """Return the stiffness of a pivot's blades about its centre as beams on springs, E = b = 1.

    The springs are those of a root on a half-plane: turn, shift, both, and stretch.
    """
    h, l, p, angles = joint
    turn, shift, mixed, stretch = ends
    K = np.zeros((3, 3))
    for angle in angles:
        # compliance of the outer end (along, across, turn) with the inner end held
        shear = 1.2 * 2.0 * (1.0 + NU)
        C = np.zeros((3, 3))
        C[0, 0] = l / h + 2.0 * stretch
        C[1:, 1:] = 12.0 / h**3 * np.array([[l**3 / 3, l**2 / 2], [l**2 / 2, l]])
        C[1, 1] += shear * l / h
        for arm, sense in ((l, 1.0), (0.0, -1.0)):
            spring = np.array([[turn / h**2, sense * mixed / h], [sense * mixed / h, shift]])
            at = np.array([[arm, 1.0], [1.0, 0.0]])  # moment and force there, per force and moment
            C[1:, 1:] += at.T @ spring @ at
        # motion of the outer end by that of the body at the centre
        B = np.array(
            [[cos(angle), sin(angle), 0.0], [-sin(angle), cos(angle), p + l], [0.0, 0.0, 1.0]]
        )
        K += B.T @ np.linalg.solve(C, B)
    return K[2, 2] - K[2, :2] @ np.linalg.solve(K[:2, :2], K[:2, 2])


@settings(max_examples=25, deadline=None)
@given(
    slender=st.floats(0.005, 0.1),
    delta=st.integers(-18, 30).map(lambda n: n / 20.0),
    half=st.floats(0.2, 1.3),
    body=st.sampled_from([(5.0, 3.8, 0.5, 2.5), (4.82, 2.1, 0.35, 1.1), (5.22, 9.8, 1.3, 4.5)]),
)
def test_a_pivot_on_springs_lies_in_the_range(slender, delta, half, body):
    joint = (slender, 1.0, delta, (half, -half))
    rigid = frame(joint, (0.0, 0.0, 0.0, 0.0))
    crossed = {"kind": "cross-spring", "delta": delta}
    spec = {"kind": "rcc", "p": f"{delta!r} m"} if delta >= 0.0 else crossed
    spec["half_angle"] = f"{half!r} rad"
    sizes = {"h": f"{slender!r} m", "l": "1 m", "b": "1 m", "clamps": "monolithic"}
    found = giving({**spec, **sizes})
    softer = frame(joint, body) / rigid
    assert found.stiffness.low <= softer <= found.stiffness.high
    assert softer >= 1.0 / (1.0 + found.softest)


def bent(joint, roots):
    """Return the largest moment at a root for a unit rotation of the body, E = b = 1.

    ``roots`` (blades, 2, 4) are turn, shift, both, and stretch of each, the inner end first.
    """
    h, l, p, angles = joint
    shear = 1.2 * 2.0 * (1.0 + NU)
    K, blades = np.zeros((3, 3)), []
    for angle, (inner, outer) in zip(angles, roots, strict=True):
        C = np.zeros((3, 3))
        C[0, 0] = l / h + inner[3] + outer[3]
        C[1:, 1:] = 12.0 / h**3 * np.array([[l**3 / 3, l**2 / 2], [l**2 / 2, l]])
        C[1, 1] += shear * l / h
        for (turn, shift, mixed, _), arm, sense in ((inner, l, 1.0), (outer, 0.0, -1.0)):
            spring = np.array([[turn / h**2, sense * mixed / h], [sense * mixed / h, shift]])
            at = np.array([[arm, 1.0], [1.0, 0.0]])
            C[1:, 1:] += at.T @ spring @ at
        B = np.array(
            [[cos(angle), sin(angle), 0.0], [-sin(angle), cos(angle), p + l], [0.0, 0.0, 1.0]]
        )
        blades.append((C, B))
        K += B.T @ np.linalg.solve(C, B)
    motion = np.append(-np.linalg.solve(K[:2, :2], K[:2, 2]), 1.0)
    forces = [np.linalg.solve(C, B @ motion) for C, B in blades]
    faces = [
        abs(6.0 * (across * arm + moment) / h**2) + abs(along / h)
        for along, across, moment in forces
        for arm in (l, 0.0)
    ]
    return max(faces)


@settings(max_examples=40, deadline=None)
@given(
    slender=st.floats(0.005, 0.15),
    p=st.integers(-18, 20).map(lambda n: n / 20.0),
    half=st.floats(0.3, 1.2),
    bodies=st.lists(
        st.sampled_from([(5.0, 3.8, 0.5, 2.5), (4.82, 2.1, 0.35, 1.1), (5.22, 9.8, 1.3, 4.5)]),
        min_size=4, max_size=4,
    ),
)  # fmt: skip
def test_the_stress_of_a_pivot_whose_roots_differ_lies_in_the_range(slender, p, half, bodies):
    joint, none = (slender, 1.0, p, (half, -half)), np.zeros((2, 2, 4))
    sizes = {"h": f"{slender!r} m", "l": "1 m", "b": "1 m", "clamps": "monolithic"}
    spec = {"kind": "cross-spring", "delta": p, "half_angle": f"{half!r} rad", "tilt": "held"}
    least, most = giving({**spec, **sizes}).stress
    changed = bent(joint, np.reshape(bodies, (2, 2, 4))) / bent(joint, none) - 1.0
    assert least <= changed <= most


def test_roots_that_surely_give_way_lower_the_stress_of_a_stroke():
    """Of an S by 6 Δ/l, Δ = 5 h/12, of an arc by 2 Δ/l."""
    for kind, share in (("guided-blade", 6.0), ("moment-blade", 2.0)):
        least, most = giving(geometry(kind, "monolithic", h=1.0, l=40.0, b=1.0 / PLANE), 0.0).stress
        assert least <= 1.0 / (1.0 + share * extra_length(h=1.0) / 40.0) - 1.0 <= most
        assert most < 0.0
        assert most - least < 0.02


@pytest.mark.parametrize("slender", [0.005, 0.02, 0.08])
def test_euler_loads_of_columns_on_turning_springs_lie_in_the_range(slender):
    """Clamped, and guided: u = ½ l √(P/EI) is a root of tan u = −2 u Δ/l and of u tan u = l/2Δ."""
    found = giving(geometry("guided-blade", "monolithic", h=slender, l=1.0, b=1.0)).buckling
    d = extra_length(h=slender)
    clamped = brentq(lambda u: tan(u) + 2.0 * u * d, pi / 2 + 1e-9, pi - 1e-9) / pi
    guided = brentq(lambda u: 2.0 * u * tan(u) * d - 1.0, 1e-9, pi / 2 - 1e-9) / (pi / 2)
    for ratio in (clamped**2, guided**2):
        assert found.low <= ratio <= found.high
        assert ratio == pytest.approx(found.value, rel=0.5 * slender)  # of the range of the roots


def shortening(turn, moment):
    """Return how much a blade of l = 1 shortens whose roots take Δ = turn, bent by a moment(s)."""
    s = np.linspace(0.0, 1.0, 2001)
    m = moment(s)
    slope = np.concatenate([[0.0], np.cumsum((m[1:] + m[:-1]) / 2.0 * np.diff(s))]) + turn * m[0]
    chord = slope if moment(0.0) != moment(1.0) else slope - np.trapezoid(slope, s)
    travel = np.trapezoid(chord, s) if moment(0.0) != moment(1.0) else 2.0 * chord[-1] + 2.0 * turn
    return np.trapezoid(chord**2, s) / 2.0 / travel**2


def test_a_stage_and_a_crossed_pivot_shift_as_their_blades_shorten():
    """By the slopes of the blades themselves: an S of a stage, an arc of a cross at its middle."""
    slender = 0.02
    d = extra_length(h=slender)
    s_shape = shortening(d, lambda s: 1.0 - 2.0 * s) / shortening(0.0, lambda s: 1.0 - 2.0 * s)
    low, high = giving(geometry("guided-blade", "monolithic", h=slender, l=1.0, b=1.0)).shift
    assert low <= s_shape - 1.0 <= high
    arc = (1.0 + 2.0 * d) ** -2  # θ = κ (l + 2 Δ), and the slope from the chord is κ (s − l/2)
    spec = {"kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg"}
    found = giving({**spec, "h": f"{slender} m", "l": "1 m", "b": "1 m", "clamps": "monolithic"})
    # 5/60 of the shift, half of which an arc's shortening 1/24 takes off
    assert found.shift[0] <= -0.5 * (arc - 1.0) <= found.shift[1]


@pytest.mark.parametrize("l", [10.0, 40.0])
def test_a_blade_between_two_others_is_at_no_side_of_its_body(l):
    """The outer two of four may be: so the whole is, and no softer than with both there."""
    inner, flush = (
        0.5 / compliance(l / 2.0, **body, nu=NU)[1, 1] for body in (BODIES["large"], FLUSH)
    )
    sizes = {"h": 1.0, "l": l, "b": 1.0 / PLANE}
    spec = {**geometry("leaf-spring-stage", "monolithic-flush", **sizes), "spacing": "3 mm"}
    softest, stiffest = ((2.0 * inner + 2.0 * outer) * l**3 / 4.0 for outer in (flush, inner))
    four, pair = (giving({**spec, "blades": n}, 0.0).stiffness for n in (4, 2))
    assert four.low <= softest < stiffest <= four.high
    assert four.high - four.low < 0.8 * (pair.high - pair.low)
    near = giving({**spec, "blades": 4, "spacing": "2.9 mm"}, 0.0).stiffness
    assert near == pair


def test_blades_in_line_turn_each_other_s_roots_by_less_than_is_left_open():
    """A moment bends the side of Flamant's half-plane by 2/π E x²; a row stands 3 h apart."""
    found, own = clamp_compliance(h=1.0, b=1.0 / PLANE, poisson_ratio=NU), root()[0, 0]
    each = 2.0 * np.array([2.0 / (pi * (3.0 * k) ** 2) for k in range(1, 1000)])
    in_turn = own + float(each @ np.where(np.arange(len(each)) % 2, -1.0, 1.0))
    assert found.least < own - each.sum() < own < in_turn < found.most


def test_rigid_clamps_change_nothing_and_giving_ones_soften_in_every_model():
    spec = geometry("leaf-spring-stage", "rigid", h=0.4, l=20.0, b=200.0, spacing=30.0)
    plain = dict(spec)
    del plain["clamps"]
    for model in ("closed-form", "linear", "exact"):
        rigid, unsaid, cut = (
            judged(said, {"stiffness": {"min": "1 N/m"}}, model=model).values["k_stage"].value
            for said in (spec, plain, {**spec, "clamps": "monolithic"})
        )
        assert rigid == unsaid
        factor = giving({**spec, "clamps": "monolithic"}).stiffness
        assert factor.low <= cut / rigid <= factor.high < 1.0


def judged(said, requirements, model=None, **more):
    text = yaml.safe_dump(
        {
            "flexure": 1,
            "title": "roots",
            "material": {
                "name": "steel", "youngs_modulus": "200 GPa", "poisson_ratio": NU,
                "density": "8 mg/cm^3", "yield_strength": "1 GPa",
            },
            "geometry": said,
            "requirements": requirements,
            **more,
        }
    )  # fmt: skip
    return flexcli.check(text, model=model)


def cut_stage(l, clamps):
    """Return a stage of two blades of 0.2 mm · l, cut from one piece, and its true frequency [Hz].

    It carries 1 kg; plane stress at 200 GPa. Blades as narrow as they are thick stay beams across.
    """
    body = FLUSH if clamps == "monolithic-flush" else BODIES["large"]
    one = 200e9 * 0.2e-3 * 0.5 / compliance(l / 2.0, **body, nu=NU)[1, 1]
    frequency = float((2.0 * one / 1.0) ** 0.5 / (2.0 * pi))
    spec = geometry("leaf-spring-stage", clamps, h=0.2, l=0.2 * l, b=0.2, spacing=30.0)
    return spec, frequency


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact", None])
@pytest.mark.parametrize("l", [10.0, 40.0])
@pytest.mark.parametrize("clamps", ["monolithic", "monolithic-flush"])
def test_a_frequency_above_the_true_one_never_passes_and_one_well_below_does(clamps, l, model):
    spec, true = cut_stage(l, clamps)
    payload = {"mechanism": {"kind": "payload", "mass": "1 kg"}}
    for share, never in ((1.03, Verdict.PASS), (0.9, Verdict.FAIL)):
        asked = {"frequency": {"min": f"{share * true!r} Hz"}}
        (check,) = judged(spec, asked, model=model, **payload).checks
        assert check.verdict is not never


def test_long_blades_are_decided_within_three_per_cent():
    spec, true = cut_stage(40.0, "monolithic")
    payload = {"mechanism": {"kind": "payload", "mass": "1 kg"}}
    for share, status in ((1.03, Status.FAIL), (0.97, Status.PASS)):
        asked = {"frequency": {"min": f"{share * true!r} Hz"}}
        assert judged(spec, asked, **payload).status is status


def test_a_pass_that_rests_on_unsaid_rigid_clamps_is_warned_of_with_the_number():
    spec, true = cut_stage(40.0, "monolithic")
    del spec["clamps"]
    payload = {"mechanism": {"kind": "payload", "mass": "1 kg"}}
    asked = {"frequency": {"min": f"{1.01 * true!r} Hz"}}
    found = judged(spec, asked, **payload)
    (note,) = [note for note in found.warnings if note.code == "rigid-clamps"]
    assert found.status is Status.PASS
    assert "frequency (min), a factor of 0.98" in note.text or "of 0.99" in note.text
    for said, share in (("rigid", 1.01), (None, 0.9)):  # told, and far from the limit
        more = {**spec, "clamps": said} if said else spec
        far = judged(more, {"frequency": {"min": f"{share * true!r} Hz"}}, **payload)
        assert far.status is Status.PASS
        assert "rigid-clamps" not in [note.code for note in far.warnings]


def test_support_and_buckling_contain_what_the_roots_give_way():
    spec = geometry("leaf-spring-stage", "rigid", h=0.2, l=10.0, b=10.0, spacing=30.0)
    cases = {
        "hung": {"acceleration": {"level": "1 g", "axis": "z"}},
        "pushed": {"load": {"force": "10 N", "direction": "180 deg"}, "ends": "clamped-guided"},
    }
    payload = {"mechanism": {"kind": "payload", "mass": "100 g"}, "cases": cases}
    pushed = {"factor": 1.0, "cases": ["pushed"]}
    asked = {"support": {"direction": "z", "min": "1 N/m"}, "buckling": pushed}
    firm = judged(spec, asked, **payload)
    asked = {
        "support": {
            "direction": "z",
            "min": f"{row(firm.checks, 'support').factor / 1.02!r} N/m",
        },
        "buckling": {**pushed, "factor": 0.98 * row(firm.checks, "buckling").factor},
    }
    for clamps, verdict in (("rigid", True), ("monolithic", False)):
        found = judged({**spec, "clamps": clamps}, asked, **payload)
        for name in ("support", "buckling"):
            assert row(found.checks, name).passed is verdict


@pytest.mark.parametrize("clamps", ["monolithic", "monolithic-flush"])
@pytest.mark.parametrize(("l", "b"), [(6.0, 1.0), (10.0, 20.0), (40.0, 3.0)])
def test_a_blade_in_space_gives_way_at_its_roots_as_plane_bodies_do(l, b, clamps):
    """Stretched, across its thickness and turned, about its middle, at ν = 0; E = 1, h = 1."""
    nu, body = 0.0, FLUSH if clamps == "monolithic-flush" else BODIES["large"]
    joint = TypeAdapter(AnyGeometry).validate_python(
        {"kind": "guided-blade", "clamps": clamps, "h": "1 m", "l": f"{l} m", "b": f"{b} m"}
    )
    sizes = joint.sized({})
    layout = joint.space_layout(Elastic(1.0, nu), sizes)
    found = SpaceJoint(layout, roots=joint.root_springs(sizes, nu))
    half = np.diag(compliance(l / 2.0, **body, nu=nu))
    for spring, true in ((0, 0.5 * b / half[2]), (1, 0.5 * b / half[1]), (5, 0.5 * b / half[0])):
        rigid = found.assembly.stiffness[spring]
        assert rigid * (1.0 + found.low[spring]) <= true <= rigid * (1.0 + found.high[spring])


def test_a_support_gives_way_as_much_as_its_own_springs_do():
    """A force across the width bends it as that of a blade in plane bending on the same roots."""
    spec = geometry("leaf-spring-stage", "monolithic", h=0.2, l=10.0, b=2.0, spacing=30.0)
    asked = {"support": [{"direction": each, "min": "1 N/m"} for each in ("x", "y", "z")]}
    ranges = {
        check.name.split()[1]: check.factor_range[0] / check.factor
        for check in judged(spec, asked).checks
    }
    stretched = 2.0 * 8.0 * 0.2 / 10.0
    assert ranges["y"] == pytest.approx(1.0 / (1.0 + stretched), rel=0.01)
    assert ranges["z"] < ranges["y"] < ranges["x"] < 1.0


@pytest.mark.parametrize("h", [2.0, 3.0])
def test_beams_in_space_that_tell_the_stress_of_a_tilting_body_know_of_its_roots(h):
    """Beams upright have their stress lowered by roots that surely give way."""
    spec = geometry("cross-spring", "monolithic", h=h, l=20.0, b=20.0, half_angle="60 deg")
    spec["delta"] = -1.0 / 3.0
    cases = {"turned": {"stroke": {"rotation": "2 mrad"}}}
    asked = judged(spec, {"yield": 1e-3}, model="exact", cases=cases)
    upright = judged({**spec, "tilt": "held"}, {"yield": 1e-3}, model="exact", cases=cases)
    (low, high), (least, most) = (
        row(found.checks, "yield").factor_range for found in (asked, upright)
    )
    assert low <= most
    assert least <= high


def row(checks, name):
    (found,) = (check for check in checks if check.name.startswith(name))
    return found


def test_blades_that_share_the_cut_of_a_drawn_layout_soften_alike():
    """Two equal blades drawn freely are the stage of two blades."""
    stage = geometry("leaf-spring-stage", "monolithic", h=0.2, l=10.0, b=10.0, spacing=30.0)
    blade = {"between": ["ground", "stage"], "h": "0.2 mm", "b": "10 mm"}
    drawn = {
        "kind": "layout",
        "clamps": "monolithic",
        "bodies": {"stage": {"at": ["0 mm", "5 mm"]}},
        "blades": {
            name: {**blade, "from": [x, "0 mm"], "to": [x, "10 mm"]}
            for name, x in (("left", "-15 mm"), ("right", "15 mm"))
        },
        "moving": "stage",
        "motion": {"translation": "0 deg"},
    }
    one, other = giving(stage).stiffness, giving(drawn).stiffness
    assert one[:3] == pytest.approx(other[:3], rel=1e-9)


def test_joined_blades_give_way_at_their_outer_ends_alone():
    """By the moment there, half of that where they cross: 5 h/(12 L) of a part's compliance."""
    spec = {"kind": "unseparated-cross", "half_angle": "45 deg"}
    sizes = {"h": "0.1 mm", "l": "20 mm", "b": "10 mm"}
    rigid, cut = (giving({**spec, **sizes, "clamps": each}) for each in ("rigid", "monolithic"))
    softer = 5.0 * 0.1 / (12.0 * 10.0)
    found = cut.stiffness.value / rigid.stiffness.value
    assert found == pytest.approx(1.0 / (1.0 + softer), abs=0.2 * softer)
    assert cut.stiffness.low < rigid.stiffness.low
    assert cut.buckling.low < 1.0


def test_a_crossing_in_a_crystal_is_as_unsure_as_it_is_large():
    """Its plane elasticity is that of an isotropic material."""
    spec = {
        "flexure": 1, "stroke": {"rotation": "1 deg"}, "requirements": {"yield": 1e-3},
        "geometry": {"kind": "unseparated-cross", "h": "0.5 mm", "l": "20 mm", "b": "1 mm",
                     "half_angle": "45 deg"},
    }  # fmt: skip
    silicon = {"crystal": {"c11": "165.7 GPa", "c12": "63.9 GPa", "c44": "79.6 GPa"}}
    alike = {"youngs_modulus": "130 GPa", "poisson_ratio": 0.28}
    widths = []
    for made in (alike, silicon):
        spec["material"] = {**made, "yield_strength": "1 GPa"}
        (check,) = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
        low, high = check.factor_range
        widths.append(high / low - 1.0)
    crossed = 0.04  # of stiffness and stress, here
    assert widths[0] < crossed
    assert widths[1] > widths[0] + crossed
