"""Buckling of a joint: three models answer one question, at the motion and in the sense asked."""

from math import cos, pi, radians, sin, sqrt

import numpy as np
import pytest
from scipy.optimize import root
from strategies import design

from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.engine.judge import judge
from flexcli.engine.models import model_series
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.plate_buckling import buckling_factor
from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.parts.requirements import AS_PRINTED, CLOSED_FORM, Ask
from flexcli.results import Verdict

STEEL = {"youngs_modulus": "210 GPa", "poisson_ratio": 0.3}
CROSSED = {"kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg", "h": "0.3 mm",
           "l": "17.5 mm", "b": "3 mm"}  # fmt: skip
BLADE = {"h": "0.1 mm", "l": "20 mm", "b": "5 mm"}
ENDS = ("clamped-clamped", "clamped-guided", "clamped-pinned", "clamped-free", "pinned-pinned")
PRINTED = 6e-4
"""Of numbers given to four digits."""


def ask_of(geometry, ends, direction=None, stroke=None, material=STEEL, joint_model=CLOSED_FORM):
    load = {"force": "100 N"} | ({} if direction is None else {"direction": f"{direction} deg"})
    case = {"load": load, "ends": ends} | ({"stroke": stroke} if stroke else {})
    found = design(geometry, {"buckling": 1}, {"push": case}, material=material)
    sizes = found.fixed_sizes()
    return Ask(found.material, found.geometry, None, sizes, found.scene("push"), joint_model)


def critical(joint_model, *asked, **more):
    """Return the least critical force in the plane [N] and its error."""
    ask = ask_of(*asked, **more, joint_model=joint_model)
    found = [c for c in joint_model.critical(ask) if c.way != "across the width"]
    least = min(found, key=lambda c: float(c.force))
    return float(least.force), least.error


@pytest.mark.slow
@pytest.mark.parametrize(("degrees", "force"), [(1, 248.1), (10, 213.6), (20, 194.5)])
def test_a_pivot_held_at_its_stroke_bears_less_than_at_rest(degrees, force):
    """A pivot held from turning, pushed together: by independent elastica solutions."""
    stroke = {"rotation": f"{degrees} deg"}
    found, _ = critical(ExactModel(), CROSSED, "clamped-guided", 180, stroke=stroke)
    assert found == pytest.approx(force, rel=PRINTED)
    rest, _ = critical(ExactModel(), CROSSED, "clamped-guided", 180)
    assert rest == pytest.approx(257.6, rel=PRINTED)


@pytest.mark.parametrize("joint_model", [CLOSED_FORM, LinearModel(), ExactModel()])
def test_a_pivot_that_is_pulled_turns_away(joint_model):
    """361 N, where one of its blades alone would bear Euler's 1265 N."""
    thick = CROSSED | {"h": "0.637 mm"}
    pulled, error = critical(joint_model, thick, "clamped-pinned", 0)
    pushed, _ = critical(joint_model, thick, "clamped-pinned", 180)
    # by the slender limit, whose strain is 6e-4
    assert pulled == pytest.approx(361.0, rel=3e-3)
    assert pushed > 5.0 * pulled
    either, _ = critical(joint_model, thick, "clamped-pinned")
    assert either == pytest.approx(pulled, rel=1e-12)
    assert error is None or error.largest < 0.01


@pytest.mark.parametrize("half_angle", [20, 45])
def test_a_pivot_that_turns_by_the_stretching_of_pulled_blades_is_told_by_exact_beams(half_angle):
    """Slender blades pulled hundreds of times as hard as buckles them: by path, not by straight."""
    sizes = {"h": "5.2 um", "l": "1.28 mm", "b": "0.5 mm"}
    thin = {"kind": "rcc", **sizes, "p": "0 mm", "half_angle": f"{half_angle} deg"}
    asked = thin, "clamped-free", 0
    for straight in (CLOSED_FORM, LinearModel()):
        force, error = critical(straight, *asked)
        found, known = critical(ExactModel(), *asked)
        assert force != pytest.approx(found, rel=0.1)
        assert error is None
        assert known is not None
    pushed = critical(CLOSED_FORM, thin, "clamped-free", 180)[1]
    assert pushed is not None


@pytest.mark.slow
@pytest.mark.parametrize("ends", ENDS)
@pytest.mark.parametrize("kind", ["cantilever", "leaf-spring-stage", "rcc", "cross-spring", "star"])
def test_ends_mean_one_thing_in_every_model(kind, ends):
    geometry = {
        "cantilever": {"kind": kind, **BLADE},
        "leaf-spring-stage": {"kind": kind, **BLADE, "blades": 3, "spacing": "20 mm"},
        "rcc": {"kind": kind, **BLADE, "p": "3 mm", "half_angle": "35 deg"},
        "cross-spring": {"kind": kind, **BLADE, "p": "-6 mm", "half_angle": "50 deg"},
        "star": {"kind": kind, **BLADE, "p": "2 mm", "angles": ["-60 deg", "0 deg", "60 deg"]},
    }[kind]
    closed, error = critical(CLOSED_FORM, geometry, ends, 180)
    assert error is not None
    linear, unsure = critical(LinearModel(), geometry, ends, 180)
    exact, own = critical(ExactModel(), geometry, ends, 180)
    assert unsure is not None
    # a body that runs away before its load is critical has a load between two, not one
    low, high = (0.0, 0.0) if own is None else (own.low, own.high)
    assert high - low < 0.02
    for least, most in (
        (closed * (1.0 + error.low), closed * (1.0 + error.high)),
        (linear * (1.0 - unsure.largest), linear * (1.0 + unsure.largest)),
    ):
        assert exact * (1.0 + low) <= most * (1.0 + 1e-8)
        assert exact * (1.0 + high) >= least * (1.0 - 1e-8)


@pytest.mark.slow
def test_errors_of_closed_form_and_linear_model_hold_the_exact_load():
    """Random pivots, thick and thin, steep and flat: at rest, their load along their axis."""
    rng = np.random.default_rng(7)
    for _ in range(10):
        delta, half = rng.uniform(-1.2, 0.8), rng.uniform(15, 75)
        h = 20.0 * 10 ** rng.uniform(-2.5, -1.2)
        geometry = {"kind": "cross-spring", "delta": float(delta), "half_angle": f"{half} deg",
                    **BLADE, "h": f"{h} mm"}  # fmt: skip
        ends = str(rng.choice(ENDS[:4]))
        exact, _ = critical(ExactModel(tolerance=1e-7), geometry, ends, 180)
        for joint_model in (CLOSED_FORM, LinearModel()):
            force, error = critical(joint_model, geometry, ends, 180)
            if error is not None:
                assert error.low <= exact / force - 1.0 <= error.high


def test_of_one_blade_alone_nobody_says_how_far_it_is_from_the_joint():
    """Euler of one blade is a quarter of what a pivot held from turning bears."""
    (alone, _), (joint, _) = (
        critical(joint_model, CROSSED, "clamped-guided")
        for joint_model in (AS_PRINTED, ExactModel())
    )
    assert joint == pytest.approx(4.0 * alone, rel=0.01)
    assert critical(AS_PRINTED, CROSSED, "clamped-guided")[1] is None
    joined = {"kind": "unseparated-cross", "half_angle": "40 deg", **BLADE}
    assert critical(CLOSED_FORM, joined, "clamped-guided", 180)[1] is None


@pytest.mark.parametrize("joint_model", [CLOSED_FORM, LinearModel(), ExactModel()])
def test_a_blade_hinged_at_both_ends_is_eulers_column_in_every_model(joint_model):
    for geometry, share in (
        ({"kind": "cantilever", **BLADE}, 1.0),
        ({"kind": "leaf-spring-stage", **BLADE, "spacing": "10 mm"}, 2.0),
        ({"kind": "rcc", **BLADE, "p": "3 mm", "half_angle": "45 deg"}, 2**0.5),
    ):
        euler = share * pi**2 * 210e9 * 5e-3 * 1e-12 / 12.0 / 20e-3**2
        force, error = critical(joint_model, geometry, "pinned-pinned", 180)
        # shear and stretching, (h/l)²
        assert force == pytest.approx(euler, rel=1e-4)
        assert error is not None


def test_a_drive_is_no_hold():
    """A pivot kept at its stroke by a moment that stays turns away as a free one does."""
    stroke = {"rotation": "0.01 deg"}
    free, _ = critical(ExactModel(), CROSSED, "clamped-pinned", 180)
    driven, _ = critical(ExactModel(), CROSSED, "clamped-pinned", 180, stroke=stroke)
    assert driven == pytest.approx(free, rel=1e-3)


@pytest.mark.slow
def test_a_mirrored_design_under_a_mirrored_load_bears_the_same():
    stroke = {"rotation": ["0 deg", "8 deg"]}
    back = {"rotation": ["-8 deg", "0 deg"]}
    one, _ = critical(ExactModel(), CROSSED, "clamped-guided", 170, stroke=stroke)
    other, _ = critical(ExactModel(), CROSSED, "clamped-guided", -170, stroke=back)
    assert one == pytest.approx(other, rel=1e-7)


@pytest.mark.parametrize("share", [0.1, 0.3])
def test_a_blade_on_hinges_at_a_stroke_is_a_strut_that_leans(share):
    # it bears Euler's load along itself, and the drive what the force leaves across it
    geometry = {"kind": "guided-blade", **BLADE}
    rest, _ = critical(ExactModel(), geometry, "pinned-pinned", 180)
    stroke = {"translation": f"{share * 20} mm"}
    found, error = critical(ExactModel(), geometry, "pinned-pinned", 180, stroke=stroke)
    # its clamps' bending, (h/l)²
    assert found == pytest.approx(rest * sqrt(1.0 - share**2), rel=1e-4)
    assert error.high < 1e-3


def test_a_pivot_on_hinges_has_blades_of_unchanged_length_at_its_stroke():
    # held across and from turning, its two struts take the force by their cosines: c₁F/(c₁² + c₂²)
    theta, l = 0.3, 17.5
    corner = l / sqrt(8.0)
    feet, heads = np.array([[-1, 1], [-1, -1]]) * corner, np.array([[1, -1], [1, 1]]) * corner
    c, s = np.cos(theta), np.sin(theta)

    def struts(place):
        return heads @ np.array([[c, s], [-s, c]]) + place - feet

    place = root(lambda x: np.linalg.norm(struts(x), axis=1) - l, [0.0, 0.0], tol=1e-12).x
    cosines = struts(place)[:, 0] / l
    alone = pi**2 * 210e9 * 3e-3 * 0.3e-3**3 / 12.0 / 17.5e-3**2
    force = alone * (cosines**2).sum() / cosines.max()
    found, _ = critical(ExactModel(), CROSSED, "pinned-pinned", 180, stroke={"rotation": "0.3 rad"})
    # what a strut's own strain and shear change
    assert found == pytest.approx(force, rel=1.2e-2)


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
def test_a_blade_that_yields_first_bears_johnsons_parabola(model):
    """Euler of the 2 mm blade is 3.7 GPa; 880 MPa (1 − 880/4·3.7 GPa) is 1.10 of 1.5 kN."""
    titanium = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.34, "yield_strength": "880 MPa"}
    blade = {"kind": "cantilever", "h": "0.2 mm", "l": "2 mm", "b": "10 mm"}
    case = {"push": {"load": {"force": "1500 N"}, "ends": "clamped-clamped"}}
    spec = design(blade, {"buckling": 1.5}, case, material=titanium)
    (found,) = judge(spec, spec.fixed_sizes(), model_series(spec, model)).checks
    assert found.verdict is Verdict.FAIL
    # shear, and the plate that a wide blade is, move the elastic load by a tenth
    assert found.factor == pytest.approx(1.10, abs=0.02)


def test_a_pull_on_parallel_blades_buckles_none():
    stage = {"kind": "leaf-spring-stage", **BLADE, "spacing": "10 mm"}
    for joint_model in (CLOSED_FORM, LinearModel(), ExactModel()):
        assert critical(joint_model, stage, "clamped-guided", 0)[0] == np.inf


@pytest.mark.parametrize("nu", [0.3, None])
@pytest.mark.parametrize(
    ("ends", "length"), [("clamped-guided", 1.0), ("clamped-free", 2.0), ("clamped-clamped", 0.5)]
)
def test_across_the_width_a_blade_bears_engesser_s_load_at_least_and_that_of_two_clamps_at_most(
    ends, length, nu
):
    """1/P = 1/P_E + 1/(κ G A); no hold of its ends gives more than two clamps, of a plate."""
    E, h, l, b = 210e9, 0.1e-3, 20e-3, 10e-3
    material = {key: value for key, value in STEEL.items() if nu or key != "poisson_ratio"}
    stage = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "10 mm"}
    ask = ask_of(stage, ends, material=material)
    (found,) = (c for c in CLOSED_FORM.critical(ask) if c.way == "across the width")
    euler = pi**2 * E * h * b**3 / 12.0 / (length * l) ** 2
    # rubber, which keeps its volume, has the least shear modulus
    sheared = 5.0 / 6.0 * E / 2.0 / (1.0 + (nu or 0.5)) * h * b
    low, high = (float(found.force) * (1.0 + end) for end in found.error)
    assert low == pytest.approx(2.0 / (1.0 / euler + 1.0 / sheared), rel=1e-12)
    clamped = 2.0 * euler * (2.0 * length) ** 2
    assert clamped <= high <= clamped / (1.0 - (nu or 0.5) ** 2)


@pytest.mark.parametrize("kind", ["cantilever", "moment-blade", "guided-blade"])
@pytest.mark.parametrize("ends", ENDS)
def test_a_single_blade_buckles_across_its_width_as_its_ends_say(kind, ends):
    """It is thicker than wide: a plate of the width h and the thickness b, held by nothing else.

    A guide keeps it from turning in its plane alone.
    """
    E, h, l, b, nu = 210e9, 2e-3, 20e-3, 0.2e-3, 0.3
    blade = {"kind": kind, "h": "2 mm", "l": "20 mm", "b": "0.2 mm"}
    ask = ask_of(blade, ends, direction=180)
    (found,) = (c for c in CLOSED_FORM.critical(ask) if c.way == "across the width")
    plate = float(buckling_factor(b=h, l=l, h=b, ends=ends, poisson_ratio=nu))
    true = plate * pi**2 * E * h * b**3 / 12.0 / (EFFECTIVE_LENGTH[ends] * l) ** 2
    low, high = (float(found.force) * (1.0 + end) for end in found.error)
    assert low < true < high < 1.025 * low


@pytest.mark.parametrize("kind", ["cantilever", "moment-blade", "guided-blade"])
def test_a_single_blade_that_is_pulled_does_not_buckle_across_its_width(kind):
    blade = {"kind": kind, "h": "2 mm", "l": "20 mm", "b": "0.2 mm"}
    found = CLOSED_FORM.critical(ask_of(blade, "clamped-free", direction=0))
    assert all(float(c.force) == np.inf for c in found)


@pytest.mark.parametrize("ends", ["pinned-pinned", "clamped-free"])
def test_a_force_of_a_stated_direction_may_pull_the_blade_that_bears_most(ends):
    """Pushed the other way, the same two blades would buckle across their width."""
    narrow = CROSSED | {"b": "0.03 mm"}
    (pulled,) = (c for c in CLOSED_FORM.critical(ask_of(narrow, ends, direction=0))
                 if c.way == "across the width")  # fmt: skip
    assert pulled.error.high == np.inf
    (either,) = (c for c in CLOSED_FORM.critical(ask_of(narrow, ends)) if c.way == pulled.way)
    assert either.error.high < 16.0


@pytest.mark.parametrize("crossing", [0.5, 0.3])
@pytest.mark.parametrize("degrees", [30.0, 60.0])
def test_joined_blades_on_pins_bear_more_than_one_alone_and_less_than_their_longer_parts(
    crossing, degrees
):
    """Against beams with a body on each pin, pushed along the bisector as the body would."""
    l, E, nu = 20e-3, 210e9, 0.3
    cross = {"kind": "unseparated-cross", "h": "0.1 mm", "l": "20 mm", "b": "0.2 mm",
             "half_angle": f"{degrees} deg", "crossing": crossing}  # fmt: skip
    ask = ask_of(cross, "pinned-pinned", direction=180)
    found = next(c for c in CLOSED_FORM.critical(ask) if c.way != "across the width")
    low, high = (float(found.force) * (1.0 + end) for end in found.error)
    bodies, blades, held, loads = [Body("cross", (0.0, 0.0))], [], {}, []
    for sign in (1.0, -1.0):
        along = np.array([cos(radians(degrees)), sign * sin(radians(degrees))])
        for place, side in ((-crossing * l, "base"), ((1.0 - crossing) * l, "body")):
            point, pin = tuple((place * along).tolist()), f"{side} {sign}"
            bodies.append(Body(pin, point))
            ends = (point, (0.0, 0.0)) if side == "base" else ((0.0, 0.0), point)
            names = (pin, "cross") if side == "base" else ("cross", pin)
            blades.append(Blade(f"to {pin}", *names, *ends, Constant(0.1e-3), 0.2e-3))
            held[pin] = (0.0 if side == "base" else None, 0.0, None)
            if side == "body":
                loads.append(Load(pin, point, (-0.5, 0.0)))
    frame = Layout(tuple(bodies), tuple(blades), E, E / (2.0 + 2.0 * nu))
    assert low <= linear_critical(frame, held, loads).factor <= high


def test_a_side_force_on_a_blade_at_a_stroke_has_an_outcome():
    """At rest it pushes no blade, so that nothing tells how far the search would have to go."""
    from flexcli import api

    found = api.check("""\
flexure: 1
material: ti-6al-4v
geometry: {kind: moment-blade, h: 0.1 mm, l: 74 mm, b: 2.4 mm}
stroke: {rotation: 0.02 mrad}
wrench: {y: -0.2 mN}
ends: clamped-pinned
requirements: {buckling: 2}
""")
    assert {check.verdict.value for check in found.checks} <= {"pass", "undecided", "not judged"}


@pytest.mark.parametrize("joint_model", [LinearModel(), ExactModel()])
def test_thick_blades_on_hinges_share_a_force_as_bars_of_a_truss(joint_model):
    """F/(2 cos α) in each, of which clamped ends take 6 % where h = l/10: π² EI/l² less shear."""
    geometry = {"kind": "rcc", "p": "0 mm", "half_angle": "68 deg", "h": "6.9 mm", "l": "69 mm",
                "b": "15.5 mm"}  # fmt: skip
    found, _ = critical(joint_model, geometry, "pinned-pinned", 180)
    h, l, b = 6.9e-3, 69e-3, 15.5e-3
    euler = pi**2 * 210e9 * b * h**3 / 12.0 / l**2
    sheared = euler / (1.0 + euler * 1.2 / (80.8e9 * b * h))
    force = 2.0 * cos(radians(68.0)) * sheared
    assert found == pytest.approx(force, rel=1.2e-2)


@pytest.mark.parametrize(
    ("h", "ends", "fewer"),
    [("0.12 mm", "clamped-guided", 0.022), ("0.17 mm", "clamped-clamped", 0.146)],
)
def test_a_critical_force_may_be_as_low_as_that_of_solids(h, ends, fewer):
    """How much earlier CalculiX's solids buckle (b = 0.3 mm, ν = 0.34, small motion)."""
    elastic = {"name": "elastic", "youngs_modulus": "114 GPa", "poisson_ratio": 0.34}
    blade = {"kind": "guided-blade", "h": h, "l": "1 mm", "b": "0.3 mm"}
    case = {"push": {"load": {"force": "1 N"}, "ends": ends}}
    spec = design(blade, {"buckling": 1.0}, case, material=elastic)
    found = judge(spec, spec.fixed_sizes(), model_series(spec, "exact")).checks
    low, _ = found[0].factor_range
    assert 1.0 - 1.6 * fewer < low / found[0].factor < 1.0 - fewer
