"""Where the closed forms stop: the angle or stroke at which stiffness, stress and shift are off.

Run ``python tests/benchmarks/closed_form_limits.py``. For each kind, δ and α it prints where the
exact solver (slender blades) departs from the closed form by 1 % and 5 %, and beside it, in
brackets, where the next-order formulas say that it does. Angles in degrees, strokes in x/l;
"-" where the departure stays smaller up to 60° or x/l = 0.6.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas import (
    hinged_next_order,
    hinged_pivot,
    pivot,
    pivot_next_order,
    stage_next_order,
    unseparated,
    unseparated_next_order,
)
from flexcli.formulas.handbook import large_stroke
from flexcli.formulas.necked_stage import end_stress, shortening, translational_stiffness
from flexcli.formulas.notch_compliance import bending_reach, circular_compliance
from flexcli.formulas.pivot import WITTRICK
from flexcli.formulas.profile import Constant, NeckedDown, Notch, Profile
from flexcli.mechanics.equilibrium import Equilibrium, solve
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.stresses import greatest_stress
from flexcli.mechanics.tangent import held_stiffness

Floats = NDArray[np.float64]

E, G, H, L, B = 114e9, 42.5e9, 2e-6, 20e-3, 10e-3
SLENDER = Effects(extension=False, shear=False)
ANGLES = np.radians(np.concatenate([np.linspace(0.1, 2.0, 20), np.linspace(2.5, 60.0, 116)]))
STROKES = np.concatenate([np.linspace(0.002, 0.05, 25), np.linspace(0.055, 0.6, 110)])
SHARES = (0.01, 0.05)
DELTAS = (-1.0, -0.8727, -0.75, -0.5, -0.25, WITTRICK, 0.0, 0.25, 0.5, 1.0)
HALF_ANGLES = (30.0, 45.0, 60.0)


def first_beyond(at: Floats, change: Floats, share: float) -> float:
    """Return where |change| first passes a share, by straight lines between samples."""
    y = np.abs(change)
    over = np.flatnonzero(y > share)
    if over.size == 0:
        return float("nan")
    i = int(over[0])
    if i == 0:
        return float(at[0] * share / y[0])
    return float(at[i - 1] + (at[i] - at[i - 1]) * (share - y[i - 1]) / (y[i] - y[i - 1]))


def cells(at: Floats, exact: Floats, near: Floats, scale: float) -> list[str]:
    """Return "exact (predicted)" for each share."""
    found = []
    for share in SHARES:
        pair = [first_beyond(at, change, share) * scale for change in (exact, near)]
        found.append("{:>6} ({:>6})".format(*("-" if np.isnan(v) else f"{v:.3g}" for v in pair)))
    return found


def changes(found: Equilibrium, body: int, K: float, stress: Floats, shift: Floats) -> list[Floats]:
    """Return the departures of tangent stiffness, stress and shift of every design."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return [
            held_stiffness(found)[:, 0, 0] / K - 1.0,
            greatest_stress(found).bending.max(axis=1) / stress - 1.0,
            -found.motions[:, body, 0] / shift - 1.0,
        ]


def rays(reach: tuple[float, float], alpha: float, names: tuple[str, str]) -> list[Blade]:
    """Return two blades at ±α between two distances from the centre."""
    blades = []
    for angle in (alpha, -alpha):
        start, end = ((r * L * np.cos(angle), r * L * np.sin(angle)) for r in reach)
        blades.append(Blade(f"{names} {angle}", *names, start, end, Constant(H), B))
    return blades


def row(name: str, at: Floats, exact: list[Floats], near: list[Floats], scale: float) -> None:
    """Print a line of the table."""
    parts = [c for e, n in zip(exact, near, strict=True) for c in cells(at, e, n, scale)]
    print(f"{name:28}", *parts, sep="  ")


def reached(found: Equilibrium, at: Floats) -> tuple[Floats, Callable[[Floats], Floats]]:
    """Return the samples that converged, and what picks them."""
    ok = found.converged
    return at[ok], lambda values: np.broadcast_to(values, ok.shape)[ok]


def separate(delta: float, degrees: float) -> None:
    """Print the limits of a pivot of two separate blades."""
    alpha = np.radians(degrees)
    blades = rays((delta, 1.0 + delta), alpha, ("ground", "moving"))
    layout = Layout((Body("moving", (0.0, 0.0)),), tuple(blades), E, G)
    found = solve(layout, {"moving": (None, None, ANGLES)}, effects=SLENDER, tolerance=1e-7)
    at = {"l": L, "p": delta * L, "theta": ANGLES, "half_angle": alpha}
    K = pivot.rotational_stiffness(E=E, h=H, l=L, b=B, p=delta * L)
    ends = pivot.end_stresses(E=E, h=H, l=L, p=delta * L, theta=ANGLES)
    shift = pivot.parasitic_shift(**at)
    exact = changes(found, 0, K, np.abs(ends).max(axis=0), shift)
    near = [
        large_stroke.pivot_stiffness_change(**at),
        pivot_next_order.stress_change(**at),
        pivot_next_order.next_shift(**at) / shift,
    ]
    theta, pick = reached(found, ANGLES)
    name = f"pivot δ={delta:.4g} α={degrees:.0f}°"
    row(name, theta, [pick(e) for e in exact], [pick(n) for n in near], np.degrees(1.0))


def joined(crossing: float, degrees: float) -> None:
    """Print the limits of an unseparated pivot."""
    alpha = np.radians(degrees)
    blades = rays((-crossing, 0.0), alpha, ("ground", "cross"))
    blades += rays((0.0, 1.0 - crossing), alpha, ("cross", "moving"))
    bodies = (Body("cross", (0.0, 0.0)), Body("moving", (0.0, 0.0)))
    layout = Layout(bodies, tuple(blades), E, G)
    found = solve(layout, {"moving": (None, None, ANGLES)}, effects=SLENDER, tolerance=1e-7)
    at = {"crossing": crossing, "theta": ANGLES, "half_angle": alpha}
    K = unseparated.unseparated_stiffness(E=E, h=H, l=L, b=B)
    stress = unseparated.unseparated_stresses(E=E, h=H, l=L, theta=ANGLES)[0]
    shift = unseparated.unseparated_shift(l=L, **at)
    exact = changes(found, 1, K, stress, shift)
    part = {"l": 1.0, "p": 0.0, "theta": max(crossing, 1.0 - crossing) * ANGLES}
    part["half_angle"] = alpha
    moment = unseparated_next_order.moment_change(**at)
    own = pivot_next_order.stress_change(**part) - pivot_next_order.moment_change(**part)
    near = [
        3.0 * moment,
        moment + own,
        unseparated_next_order.next_shift(l=L, **at) / shift,
    ]
    theta, pick = reached(found, ANGLES)
    name = f"unseparated c={crossing:.2g} α={degrees:.0f}°"
    row(name, theta, [pick(e) for e in exact], [pick(n) for n in near], np.degrees(1.0))


def guided(xi: float, turn: float | None) -> None:
    """Print the limits of a stage (or of a cantilever, whose tip is free to turn)."""
    profile: Profile = Constant(H) if xi == 1.0 else NeckedDown(H, xi * L / 2.0)
    blade = Blade("blade", "ground", "moving", (0.0, 0.0), (L, 0.0), profile, B)
    layout = Layout((Body("moving", (L, 0.0)),), (blade,), E, G)
    x = STROKES * L
    found = solve(layout, {"moving": (None, x, turn)}, effects=SLENDER, tolerance=1e-7)
    part = 1.0 if turn is not None else 0.25
    K = part * translational_stiffness(E=E, h=H, l=L, b=B, xi=xi, blades=1)
    stress = (1.0 if turn is not None else 0.5) * end_stress(E=E, h=H, l=L, x=x, xi=xi)
    exact = changes(found, 0, K, stress, shortening(l=L, x=x, xi=xi))
    at = {"l": L, "x": x, "xi": xi}
    near = [
        large_stroke.stage_stiffness_change(**at),
        stage_next_order.stress_change(**at),
        stage_next_order.shift_change(**at),
    ]
    ratio, pick = reached(found, STROKES)
    name = "cantilever" if turn is None else f"stage, guided blade ξ={xi:.2g}"
    row(name, ratio, [pick(e) for e in exact], [pick(n) for n in near], 1.0)


def hinged(delta: float, degrees: float) -> None:
    """Print the limits of a pivot of limbs with slim notches (e/r = 0.01, r/l = 0.01)."""
    alpha, r = np.radians(degrees), 0.01 * L
    profile, bodies, blades = Notch(0.01 * r, r), [], []
    for name, angle in (("limb 1", alpha), ("limb 2", -alpha)):
        u = np.array([np.cos(angle), np.sin(angle)])
        bodies.append(Body(name, tuple(delta * L * u)))
        for place, first, second in (
            (delta, "ground", name),
            (1.0 + delta, name, "moving"),
        ):
            ends = [tuple((place * L + side * r) * u) for side in (-1.0, 1.0)]
            blades.append(Blade(f"{name} {place}", first, second, *ends, profile, B))
    bodies.append(Body("moving", (0.0, 0.0)))
    layout = Layout(tuple(bodies), tuple(blades), E, G)
    found = solve(layout, {"moving": (None, None, ANGLES)}, effects=SLENDER, tolerance=1e-7)
    at = {"l": L, "p": delta * L, "theta": ANGLES, "half_angle": alpha}
    C = circular_compliance(E=E, b=B, e=0.01 * r, r=r)
    c = bending_reach(across=C.across, turn=C.turn)
    K = float(hinged_pivot.rotational_stiffness(K=1.0 / C.turn, l=L, p=delta * L, c=c))
    turns = hinged_pivot.hinge_rotations(l=L, p=delta * L, theta=ANGLES)
    stress = np.abs(turns).max(axis=0) / C.turn * 6.0 / (B * (0.01 * r) ** 2)
    shift = hinged_pivot.parasitic_shift(**at)
    exact = changes(found, 2, K, stress, shift)
    near = [
        3.0 * large_stroke.hinged_pivot_moment_change(**at),
        hinged_next_order.pivot_turn_change(**at),
        hinged_next_order.pivot_shift_change(**at),
    ]
    theta, pick = reached(found, ANGLES)
    name = f"hinged δ={delta:.3g} α={degrees:.0f}°"
    row(name, theta, [pick(e) for e in exact], [pick(n) for n in near], np.degrees(1.0))


def main() -> None:
    """Print the table."""
    heads = [f"{what} {share:.0%}" for what in ("stiffness", "stress", "shift") for share in SHARES]
    print(f"{'exact (next order)':28}", *(f"{head:>15}" for head in heads), sep="  ")
    for degrees in HALF_ANGLES:
        for delta in DELTAS:
            separate(delta, degrees)
    for crossing in (0.3, 0.5):
        joined(crossing, 45.0)
    for delta in (-0.5, 0.25, 1.0):
        hinged(delta, 45.0)
    for xi in (1.0, 0.5, 0.2):
        guided(xi, 0.0)
    guided(1.0, None)


if __name__ == "__main__":
    main()
