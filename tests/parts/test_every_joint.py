"""What every joint says of itself is true of the body that its own layout draws.

Closed forms, values and cards of every kind, at random shapes, against small and large motions of
the blades of ``layout()``, which know no formula. A joint that inherits what is another's fails.
"""

import inspect
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from math import cos, degrees, hypot, inf, sin
from typing import Any, Literal

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, asked, geometry, kinds, varied
from planar_support import support_compliance

from flexcli.formulas.card import Card
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.linear import linear
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.stresses import blade_stress
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import ENDS
from flexcli.parts.geometries import Geometry
from flexcli.parts.geometries.base import ACROSS_WIDTH, GROUND, MOVING, PIECE, Critical
from flexcli.parts.geometries.pivots import BladePair, PairFormulas, on_ray
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.results import QuantityKind, Value

SHAPES = 3
"""Random shapes of each kind."""

BENDING = Effects(extension=False, shear=False)
"""What closed forms are of: blades that bend alone."""

STRETCHING = Effects(extension=True, shear=False)

SOLVED = 1e-9
"""Of a linear solution with 48 nodes on a piece, and of critical forces."""

SMALL = 1e-7
"""Travel [rad, or over the length] at which what is of first order in it is left out."""

LARGE, LESS = 0.04, 0.25
"""Travel [rad, or over the length] at which the shift is solved, and a share of it."""

FALLS = 0.5
"""What a leading term leaves out is of first order in the travel at least: a quarter of it at a
quarter of the travel, with room for the orders after it."""

SHIFTED = 1e-5
"""Of a shift of some 1e-4 l, solved to 1e-9 of the motions."""

WIDE = 10.0
"""Strain up to which a blade is looked at, which wide ones buckle across their width at."""

WIDE_BEAM = 1e-6
"""Of a compliance in space: blades askew to the axes lose digits."""

NU = ELASTIC.nu


class Drawn:
    """The body of a layout, asked by solvers: nothing here reads a formula of the joint."""

    def __init__(self, part: Geometry) -> None:
        self.part = part
        self.sizes = part.probe()
        self.layout = part.layout(ELASTIC, self.sizes)
        self.axis = 2 if part.motion == "rotation" else 1
        self.index = self.layout.index(MOVING)
        self.unit = 1.0 if part.motion == "rotation" else part.length(self.sizes)
        point = self.layout.body(MOVING).point
        self.point = (0.0, 0.0) if part.motion == "rotation" else point

    @property
    def order(self) -> float:
        """What is left out of a stress: points for hinges, and (h/l)² where blades must stretch."""
        return 1e-5 + self.hinge + 2.0 * (self.part.slenderness(self.sizes) or 0.0) ** 2

    @property
    def hinge(self) -> float:
        """How far the hinges bend about their centres, over the limb: formulas take points."""
        return float(self.part.indicators(self.sizes, 0.0).get("c/l", 0.0))

    def small(self, held: Any, loads: Any = (), effects: Effects = BENDING) -> Any:
        """Small motions; where blades that do not stretch share a body, they stretch."""
        found = linear(self.layout, {MOVING: held}, loads=loads, effects=effects, nodes=48)
        if not found.unique.all() and effects is BENDING:
            return self.small(held, loads, STRETCHING)
        assert found.unique.all()
        return found

    @cached_property
    def stiffness(self) -> float:
        found = self.small(self.part.held(1.0))
        return float(found.reactions[0, self.index, self.axis])

    def moved(self, travel: float, effects: Effects = BENDING) -> Any:
        held = {MOVING: self.part.held(travel)}
        state = solve(self.layout, held, effects=effects, tolerance=1e-10)
        if not state.converged.all() and effects is BENDING:  # they lock each other
            return self.moved(travel, STRETCHING)
        return state.checked()

    def stress(self, travel: float) -> float:
        """Largest bending stress at any place of any blade, of first order in the travel."""
        least = SMALL * self.unit
        state = self.moved(least)
        each = [blade_stress(state, b.name, 41).bending for b in self.layout.blades]
        return max(float(np.abs(s).max()) for s in each) * travel / least

    def shift(self, travel: float, effects: Effects = BENDING) -> tuple[float, float]:
        """Motion of the centre, or of a stage's point: towards −x, and across."""
        x, y = point_motion(self.moved(travel, effects), MOVING, self.point)[0]
        return -float(x), float(y)

    def tension(self, direction: float) -> float:
        """Largest axial force in a blade per force on the moving body."""
        load = Load(MOVING, self.layout.body(MOVING).point, (cos(direction), sin(direction)))
        hold = (None, 0.0, None) if self.part.motion == "translation" else (None, None, None)
        found = self.small(hold, (load,), STRETCHING)
        most = 0.0
        for blade, force in zip(self.layout.blades, found.end_forces[0], strict=True):
            most = max(most, abs(float(force[:2] @ along(blade))))
        return most

    def support(self, axis: np.ndarray, *, shear: bool) -> float:
        """Stiffness of the free body along a direction in space."""
        x, y = self.point
        factor = 5.0 / 6.0 if shear else inf
        C = support_compliance(self.layout, MOVING, (x, y, 0.0), shear_factor=factor)
        return float(1.0 / (axis @ C[:3, :3] @ axis))

    def critical(self, ends: str, direction: float) -> float:
        """Force on the body, in a direction, at which straight blades that only bend buckle."""
        hold = ENDS[ends]
        held = (None, 0.0 if hold.across else None, 0.0 if hold.turn else None)
        load = Load(MOVING, self.layout.body(MOVING).point, (cos(direction), sin(direction)))
        return linear_critical(self.layout, {MOVING: held}, [load]).factor

    @property
    def flexible(self) -> list[tuple[float, float]]:
        """Length and volume of what flexes in each blade."""
        found = []
        u, w = np.polynomial.legendre.leggauss(200)
        for blade in self.layout.blades:
            pieces = blade.profile.pieces(length(blade))
            ends = [np.ravel(piece.position(PIECE)) for piece in pieces]
            areas = [float(np.sum(w * np.abs(p.slope(u)) * p.thickness(u))) for p in pieces]
            found.append((sum(abs(float(b - a)) for a, b in ends), sum(areas) * float(blade.b)))
        return found


def length(blade: Blade) -> float:
    return hypot(*np.subtract(blade.end, blade.start))


def along(blade: Blade) -> np.ndarray:
    return np.subtract(blade.end, blade.start) / length(blade)


def alone(blade: Blade, drawn: Drawn) -> Layout:
    """Return a blade by itself along x, from a body that may be held to another."""
    l = length(blade)
    strip = replace(blade, first="base", second=MOVING, start=(0.0, 0.0), end=(l, 0.0), z=0.0)
    bodies = (Body("base", (0.0, 0.0)), Body(MOVING, (l, 0.0)))
    return Layout(bodies, (strip,), drawn.layout.E, drawn.layout.G)


def strut(blade: Blade, drawn: Drawn, ends: str) -> float:
    """Return the force at which a blade by itself buckles, held as named."""
    hold, layout = ENDS[ends], alone(blade, drawn)
    base = (0.0, 0.0, None if hold.hinged else 0.0)
    turn = 0.0 if hold.turn and not hold.hinged else None
    tip = (None, 0.0 if hold.across else None, turn)
    push = Load(MOVING, (length(blade), 0.0), (-1.0, 0.0))
    held = {"base": base, MOVING: tip}
    return linear_critical(layout, held, [push], strain=WIDE, effects=BENDING).factor


def near(found: Any, true: float, tolerance: float) -> None:
    assert float(found) == pytest.approx(true, rel=tolerance)


# --- closed forms -----------------------------------------------------------------------------


def stiffness(drawn: Drawn) -> None:
    near(drawn.part.stiffness(ELASTIC, drawn.sizes), drawn.stiffness, SOLVED + 10 * drawn.hinge**2)


def end_stresses(drawn: Drawn) -> None:
    travel = 0.01 * drawn.unit
    stated = drawn.part.end_stresses(ELASTIC, drawn.sizes, travel)
    most = max(abs(float(s)) for s in stated.values())
    near(most, drawn.stress(travel), drawn.order)


def parasitic_shift(drawn: Drawn) -> None:
    """It is the leading term: what it leaves out falls with the travel."""
    off = []
    for share in (1.0, LESS):
        travel = share * LARGE * drawn.unit
        stated = asked(drawn.part.parasitic_shift, drawn.sizes, travel)
        if isinstance(stated, NotAvailable):
            return
        off.append(abs(float(stated) / drawn.shift(travel)[0] - 1.0))
    assert off[1] <= FALLS * off[0] + SHIFTED + 2.0 * drawn.hinge


def volume(drawn: Drawn) -> None:
    near(drawn.part.volume(drawn.sizes), sum(v for _, v in drawn.flexible), 1e-6)


def axial_force(drawn: Drawn) -> None:
    """What a body gives way before its blades pull back is (h/l)² of the force."""
    slender = max(drawn.part.slenderness(drawn.sizes) or 0.0, 1e-9) ** 2
    for direction in (0.0, 0.7):
        stated = asked(drawn.part.axial_share, direction)
        if isinstance(stated, NotAvailable):
            continue
        near(stated, drawn.tension(direction), SOLVED + 100.0 * slender)


def axial_stress(drawn: Drawn) -> None:
    stated = asked(drawn.part.axial_stress, 10.0, drawn.sizes)
    if isinstance(stated, NotAvailable):
        return
    each = []
    for blade in drawn.layout.blades:
        pieces = blade.profile.pieces(length(blade))
        thin = min(float(np.min(p.thickness(np.array([-1.0, 1.0])))) for p in pieces)
        each.append(float(blade.peak[1]) * 10.0 / (float(blade.b) * thin))
    near(stated, max(each), SOLVED)


def critical_of_a_blade(drawn: Drawn) -> None:
    """A blade by itself; where other bodies hold it between its ends, the joint bears more."""
    for ends in ("clamped-clamped", "clamped-pinned"):
        stated = asked(drawn.part.critical, ELASTIC, drawn.sizes, ends)
        if isinstance(stated, NotAvailable):
            continue
        for each in stated:
            if len(drawn.layout.bodies) > 1:
                if each.way == ACROSS_WIDTH:
                    continue
                true = min(drawn.critical(ends, turn) for turn in (0.0, np.pi))
                assert float(each.force) / drawn.tension(0.0) <= true
                continue
            sizes = {(length(b), float(b.b), str(b.profile)): b for b in drawn.layout.blades}
            blades = list(sizes.values())
            if each.way == ACROSS_WIDTH:
                blades = [replace(b, profile=Constant(b.b), b=b.profile.h) for b in blades]
            near(each.force, min(strut(b, drawn, ends) for b in blades), SOLVED)


def critical_of_the_joint(drawn: Drawn) -> None:
    """Within the error that is stated with it; where that is unknown, nothing is promised."""
    for ends in ("clamped-clamped", "clamped-guided"):
        for direction in (0.0, np.pi):
            form = drawn.part.joint_critical
            stated = asked(form, ELASTIC, drawn.sizes, ends, direction)
            if isinstance(stated, NotAvailable) or stated.error is None:
                continue
            if not np.isfinite(stated.force):
                assert not np.isfinite(drawn.critical(ends, direction))
                continue
            off = drawn.critical(ends, direction) / float(stated.force) - 1.0
            assert stated.error.low - SOLVED <= off <= stated.error.high + SOLVED


def sag_stiffness(drawn: Drawn) -> None:
    turn = drawn.part.axes
    for axis, direction in {
        "x": (cos(turn), sin(turn), 0.0),
        "y": (-sin(turn), cos(turn), 0.0),
        "z": (0.0, 0.0, 1.0),
    }.items():
        stated = asked(drawn.part.sag_stiffness, ELASTIC, drawn.sizes, axis)
        if isinstance(stated, NotAvailable):
            continue
        stroke = drawn.part.motion == "translation" and axis == "x"
        true = drawn.stiffness if stroke else drawn.support(np.array(direction), shear=False)
        near(stated, true, (SOLVED if stroke else WIDE_BEAM) + 10 * drawn.hinge**2)


FORMS = {
    form.__name__: form
    for form in (
        stiffness,
        end_stresses,
        parasitic_shift,
        volume,
        axial_force,
        axial_stress,
        critical_of_a_blade,
        critical_of_the_joint,
        sag_stiffness,
    )
}

# --- values -----------------------------------------------------------------------------------


def place_of_centre(drawn: Drawn) -> float:
    """Signed distance from the centre to where a blade or limb begins, over its length."""
    first = drawn.layout.blades[0]
    if len(drawn.layout.bodies) == 1:
        return float(np.dot(first.start, along(first))) / length(first)
    # a limb's ends are the middles of its hinges
    inner, outer = (np.add(b.start, b.end) / 2.0 for b in drawn.layout.blades[:2])
    return float(np.dot(inner, along(first))) / hypot(*(outer - inner))


def separated(drawn: Drawn) -> Drawn:
    """The symmetric pivot of separate blades of the same sizes, and as many pairs."""
    h, l, b = (float(size) * 1e3 for size in drawn.sizes)
    angle = f"{degrees(drawn.part.half_angle)!r} deg"
    pairs = getattr(drawn.part, "pairs", 1)
    changes = {"p": None, "delta": -0.5, "half_angle": angle, "pairs": pairs}
    return Drawn(geometry("cross-spring", h=h, l=l, b=b, **changes))


def turn_of_drive(drawn: Drawn, height: float, travel: float) -> float:
    """Rotation of a stage that is driven at a height above the base, at a travel."""
    found = linear(
        drawn.layout, {}, loads=[Load(MOVING, (height, 0.0), (0.0, 1.0))], effects=STRETCHING
    )
    _, y, turn = found.motions[0, drawn.index]
    return float(turn / y) * travel


def along_stiffness(drawn: Drawn) -> float:
    held = (1.0, 0.0, 0.0) if drawn.part.motion == "translation" else (1.0, None, None)
    return float(drawn.small(held, effects=STRETCHING).reactions[0, drawn.index, 0])


def hinge_stiffness(drawn: Drawn) -> float:
    layout = alone(drawn.layout.blades[0], drawn)
    held = {"base": (0.0, 0.0, 0.0), MOVING: (None, None, 1.0)}
    return float(linear(layout, held, effects=BENDING, nodes=48).reactions[0, 1, 2])


def rotation_gain(drawn: Drawn) -> float:
    """Rotation of the pivot over that of its most turned hinge."""
    turns = {GROUND: 0.0}
    turns |= {
        body.name: float(drawn.small((None, None, 1.0)).motions[0, index, 2])
        for index, body in enumerate(drawn.layout.bodies)
    }
    return 1.0 / max(abs(turns[b.second] - turns[b.first]) for b in drawn.layout.blades)


ROUTES: dict[str, tuple[Callable[[Drawn, float], float], float]] = {
    "delta": (lambda d, _: place_of_centre(d), SOLVED),
    "shift_across": (lambda d, t: abs(d.shift(t, Effects())[1]), 0.05),
    "stiffness_ratio": (lambda d, _: d.stiffness / separated(d).stiffness, SOLVED),
    "stroke_ratio": (lambda d, _: separated(d).stress(1.0) / d.stress(1.0), 1e-5),
    "k_z_shear": (lambda d, _: d.support(np.array((0.0, 0.0, 1.0)), shear=True), WIDE_BEAM),
    "phi_drive": (lambda d, t: turn_of_drive(d, d.part.drive, t), 1e-3),
    "drive_best": (lambda d, _: d.layout.body(MOVING).point[0], SOLVED),
    "xi": (lambda d, _: d.flexible[0][0] / length(d.layout.blades[0]), SOLVED),
    "k_along": (lambda d, _: along_stiffness(d), 1e-8),
    "k_hinge": (lambda d, _: hinge_stiffness(d), SOLVED),
    "theta_per_gamma": (lambda d, _: rotation_gain(d), 1e-3),
    "K_t": (lambda d, _: float(d.layout.blades[0].peak[0]), SOLVED),
}
"""How each value follows from the layout, and how far it may be off: 1e-3 of what a stretching
blade gives way, and of hinges that are points; of the shift across, the order after its θ³."""


def values(drawn: Drawn) -> None:
    travel = LARGE * drawn.unit
    stated = drawn.part.values(ELASTIC, drawn.sizes, travel)
    missing = set(stated) - set(ROUTES)
    assert not missing, f"say how {missing} follow from the layout"
    for name, value in stated.items():
        route, tolerance = ROUTES[name]
        near(value.value, route(drawn, travel), tolerance)


# --- cards ------------------------------------------------------------------------------------

ADMISSIBLE = 100e6
"""Stress at which a stroke is asked [Pa]."""


def arguments(card: Card, drawn: Drawn, travel: float) -> dict[str, Any] | None:
    """Return what a formula takes, of the design; nothing where the design does not have it."""
    part, sizes = drawn.part, drawn.sizes
    known: dict[str, Any] = {
        **sizes._asdict(), "E": ELASTIC.E, "G": ELASTIC.G, "poisson_ratio": NU, "s": 0.0,
        "theta": travel, "x": travel, "stress": ADMISSIBLE, "sigma": ADMISSIBLE,
        "blades": len(drawn.layout.blades),
    }  # fmt: skip
    for name in ("half_angle", "crossing", "limbs", "blades"):
        if hasattr(part, name):
            known[name] = getattr(part, name)
    if hasattr(sizes, "xi"):
        known["xi"] = sizes.xi
    if hasattr(part, "offset"):
        known["p"] = part.offset(sizes)
    if hasattr(part, "hinge"):
        known["K"], known["c"] = part.hinge(ELASTIC, sizes)
    taken = inspect.signature(card.function).parameters
    if any(n not in known and p.default is p.empty for n, p in taken.items()):
        return None
    return {name: known[name] for name in taken if name in known}


def cards(drawn: Drawn) -> None:
    """A card with a kind makes that number of the joint; of a hinge by itself, the hinge's."""
    travel = LESS * LARGE * drawn.unit
    held = 0
    for card in drawn.part.cards:
        taken = arguments(card, drawn, travel)
        if card.kind is None or taken is None:
            continue
        held += 1
        found = np.abs(np.ravel(np.asarray(card.function(**taken), dtype=float))).max()
        if card.function.__name__.startswith("admissible"):
            near(ADMISSIBLE, drawn.stress(float(found)), drawn.order)
        elif card.kind is QuantityKind.STIFFNESS:
            whole, hinge = drawn.stiffness, hinge_stiffness(drawn)
            tolerance = SOLVED + 10 * drawn.hinge**2
            assert any(abs(found / true - 1.0) < tolerance for true in (whole, hinge)), card.name
        elif card.kind is QuantityKind.STRESS:
            near(found, drawn.stress(travel), drawn.order)
        elif card.kind is QuantityKind.SHIFT:
            stated = abs(float(drawn.part.parasitic_shift(drawn.sizes, travel)))
            near(found, stated, SOLVED)  # which is held above
        elif card.kind is QuantityKind.SAG:
            shear = "G" in taken
            near(found, drawn.support(np.array((0.0, 0.0, 1.0)), shear=shear), WIDE_BEAM)
    assert held or not any(card.kind for card in drawn.part.cards)


CLAIMS = {**FORMS, "values": values, "cards": cards}

TWISTED = {"torsion-bar", "round-torsion-bar", "torsion-star"}
"""Their bars lie across the plane of a layout: tests of torsion solve their sections."""

JOINTS = sorted(set(kinds()) - {"linkage", "layout", "space-layout"} - TWISTED)
"""A linkage is made of others, a layout drawn freely has no closed forms."""


@pytest.mark.parametrize("claim", CLAIMS)
@pytest.mark.parametrize("kind", JOINTS)
def test_what_a_joint_says_is_true_of_the_body_that_it_draws(kind, claim):
    assert kind in SAMPLES, "give a sample of it in geometries_for_tests"
    for seed in range(SHAPES):
        CLAIMS[claim](Drawn(varied(kind, np.random.default_rng(seed))))


def test_all_but_twisted_bars_draw_their_body():
    for kind in kinds():
        if kind in SAMPLES:
            part = geometry(kind)
            drawn = asked(part.layout, ELASTIC, part.probe())
            assert isinstance(drawn, NotAvailable) == (kind in TWISTED), kind


# --- what is wrong does not pass -----------------------------------------------------------------

WRONG = [
    ("cross-spring", "stiffness", "stiffness"),
    ("notch-hinge", "stiffness", "stiffness"),
    ("unseparated-cross", "end_stresses", "end_stresses"),
    ("hinged-stage", "end_stresses", "end_stresses"),
    ("rcc", "parasitic_shift", "parasitic_shift"),
    ("hinged-pivot", "parasitic_shift", "parasitic_shift"),
    ("necked-down-stage", "volume", "volume"),
    ("star", "axial_share", "axial_force"),
    ("filleted-hinge", "axial_stress", "axial_stress"),
    ("cantilever", "critical", "critical_of_a_blade"),
    ("three-blade", "joint_critical", "critical_of_the_joint"),
    ("three-blade", "sag_stiffness", "sag_stiffness"),
    ("leaf-spring-stage", "values", "values"),
    ("cross-spring", "values", "values"),
    ("unseparated-cross", "values", "values"),
    ("elliptic-hinge", "values", "values"),
]


def times(found: Any, factor: float) -> Any:
    """Return what a form gives, its numbers times a factor."""
    if isinstance(found, dict):
        return {name: times(each, factor) for name, each in found.items()}
    if isinstance(found, Value):
        return found._replace(value=found.value * factor)
    if isinstance(found, Critical):
        return found._replace(force=found.force * factor)
    if isinstance(found, tuple):
        return tuple(times(each, factor) for each in found)
    return found * factor


@pytest.mark.parametrize(("kind", "form", "claim"), WRONG)
def test_a_number_that_is_a_tenth_too_large_fails(kind, form, claim, monkeypatch):
    drawn = Drawn(varied(kind, np.random.default_rng(0)))
    right = getattr(type(drawn.part), form)
    wrong = lambda *arguments: times(right(*arguments), 1.1)  # noqa: E731
    monkeypatch.setattr(type(drawn.part), form, wrong)
    with pytest.raises(AssertionError):
        CLAIMS[claim](drawn)


class Butterfly(BladePair):
    """Two pivots in series, whose body between them nobody has told the formulas of."""

    source = "none"
    kind: Literal["butterfly"]
    p: float = 3e-3

    def offset(self, sizes: Any) -> Any:
        return self.p

    def layout(self, elastic: Any, sizes: Any) -> Layout:
        reach = (self.p, self.p + sizes.l)
        far = (-self.p, -self.p - sizes.l)
        strips = [
            self.strip(f"{side} {i}", bodies, on_ray(angle, ends), sizes)
            for side, bodies, ends in (
                ("base", (GROUND, "middle"), reach),
                ("stage", ("middle", MOVING), far),
            )
            for i, angle in enumerate(self.blade_angles)
        ]
        bodies = (Body("middle", (0.0, 0.0)), Body(MOVING, (0.0, 0.0)))
        return Layout(bodies, tuple(strips), elastic.E, elastic.shear)


BLADES = {
    "kind": "butterfly",
    "half_angle": "40 deg",
    **{name: f"{value} mm" for name, value in {"h": 0.1, "l": 20.0, "b": 5.0}.items()},
}


def test_a_new_joint_that_states_nothing_has_no_numbers():
    with pytest.raises(TypeError, match=r"abstract methods? .*end_stresses.*stiffness"):
        Butterfly.model_validate(BLADES)


class Bare(Butterfly):
    """The same with what every joint must state, and no more."""

    def stiffness(self, elastic: Any, sizes: Any) -> Any:
        return 1.0

    def end_stresses(self, elastic: Any, sizes: Any, travel: float) -> Any:
        return {"ends": travel}

    def wide_blades(self, sizes: Any, nu: float) -> None:
        return None


def test_what_a_new_joint_does_not_state_is_not_available():
    part = Bare.model_validate(BLADES)
    sizes = part.probe()
    for told in (
        asked(part.parasitic_shift, sizes, 0.01),
        asked(part.joint_critical, ELASTIC, sizes, "clamped-clamped", 0.0),
        asked(part.axial_share, 0.0),
        asked(part.sag_stiffness, ELASTIC, sizes, "z"),
    ):
        assert isinstance(told, NotAvailable)
    assert not part.values(ELASTIC, sizes, 0.01)
    assert not part.cards
    assert not any(part.is_known(ELASTIC, sizes, 0.01, kind) for kind in QuantityKind)


def test_a_joint_that_draws_another_body_inherits_no_formula_of_a_joint():
    with pytest.raises(TypeError, match="draws its own layout and inherits"):
        type("Redrawn", (RCCPivot,), {"layout": Butterfly.layout})


class Borrowed(PairFormulas, Butterfly):
    """The formulas of a pair, named for a body that is another."""


@pytest.mark.parametrize(
    "claim", ["stiffness", "end_stresses", "parasitic_shift", "volume", "cards"]
)
def test_formulas_that_a_joint_names_and_that_are_not_its_own_fail(claim):
    part = Borrowed.model_validate(BLADES)
    with pytest.raises(AssertionError):
        CLAIMS[claim](Drawn(part))
