"""Notches, fillets, tapers and wide blades between rigid bodies: solids by CalculiX, in six axes.

Run by hand: python tests/benchmarks/hinges_in_space.py
It writes tests/mechanics/space/hinges.json in twenty minutes of one processor: for each hinge, in
units of the radius of its roots, of half its length or of a millimetre, its kind, its profile's
numbers, its length, its width and ν, and six stiffnesses about its middle, each with all else free,
over E. The mesh is the coarsest of ``verify``; twice as fine a one has up to 4 % more or less where
a notch is deep. That of blades is twice as fine; three times as fine a one has up to 0.3 % less.
"""

import json
import sys
from pathlib import Path

import numpy as np

from flexcli.engine.solid.calculix import run
from flexcli.engine.solid.deck import compliance_deck
from flexcli.engine.solid.model import solid_model
from flexcli.formulas.profile import Constant, Filleted, Notch, Tabulated
from flexcli.mechanics.layout import Blade, Body, Layout

FOUND = Path(__file__).parents[1] / "mechanics/space/hinges.json"
R, E, MM = 1e-3, 200e9, 1e3
KINDS = {
    "notch": Notch, "filleted": Filleted, "taper": lambda *h: Tabulated(*tapered(*h)),
    "blade": Constant,
}  # fmt: skip


def hinges(count=75, seed=3):
    """Yield kind, profile's numbers, length, width over R and ν, at random within the ranges."""
    random = np.random.default_rng(seed)
    while count:
        nu, b = float(random.choice([0.2, 0.3, 0.4])), float(10 ** random.uniform(-0.3, 1.2))
        if random.random() < 0.6:
            depth = float(10 ** random.uniform(-0.5, 0.3)) if random.random() < 0.5 else 1.0
            e, l = float(10 ** random.uniform(-1.7, 0.0)), 2.0
            found, inside = ("notch", [e, depth], l, b, nu), e * depth <= 1.0 and e <= b
        else:
            h, l = float(10 ** random.uniform(-1.3, 0.0)), float(random.uniform(4.0, 30.0))
            found = ("filleted", [h, 1.0], l, b, nu)
            inside = h <= b and h <= 0.1 * l and b <= 1.5 * l
        if inside:
            count -= 1
            yield found


def notches(count=60, seed=2, poisson=(0.0, 0.2, 0.4), widest=-0.25):
    """Yield notches from shallow to as deep as long in the same way, b over R up to 10^widest."""
    random = np.random.default_rng(seed)
    while count:
        nu, depth = float(random.choice(poisson)), float(random.choice([0.3, 1.0, 1.5, 2.0]))
        e, b = float(10 ** random.uniform(-2.5, -0.2)), float(10 ** random.uniform(-2.2, widest))
        if e * depth <= 1.0 and e <= b:
            count -= 1
            yield "notch", [e, depth], 2.0, b, nu


def tapered(first, last, *between):
    """Return places and thicknesses of a taper of two or three thicknesses, at even distances."""
    each = (first, *between, last)
    return tuple(np.linspace(0.0, 1.0, len(each)).tolist()), each


def tapers(count=36, seed=5):
    """Yield tapers, thinner or thicker in the middle or to one end, in the same way."""
    random = np.random.default_rng(seed)
    l = 20.0
    while count:
        nu, b = (
            float(random.choice([0.0, 0.2, 0.3, 0.4])),
            float(l * 10 ** random.uniform(-1.2, 0.0)),
        )
        thin = float(l * 10 ** random.uniform(-2.0, -1.0))
        ratio = 1.0 + float(random.choice([0.3, 1.0, 3.0])) * random.random()
        each = [thin, thin * ratio]
        if random.random() < 0.7:
            each = (
                [thin * ratio, thin * ratio, thin]
                if random.random() < 0.7
                else [thin, thin, thin * ratio]
            )
        if max(each) <= b and max(each) <= 0.12 * l:
            count -= 1
            yield "taper", each, l, b, nu


def blades(count=24, seed=7):
    """Yield blades wider than 2 l, or thicker than a fifth of l, in the same way."""
    random = np.random.default_rng(seed)
    l = 10.0
    for k in range(count):
        nu = float(random.choice([0.0, 0.2, 0.3, 0.4]))
        wide, thick = 10 ** random.uniform(0.3, 0.6), 10 ** random.uniform(-2.0, -0.52)
        if k % 3 == 0:
            wide, thick = 10 ** random.uniform(-0.5, 0.6), 10 ** random.uniform(-0.7, -0.53)
        yield "blade", [float(l * thick)], l, float(l * wide), nu


def very_wide_blades(count=20, seed=9):
    """Yield blades wider than 4 l, as hinges of necked-down stages are, in the same way."""
    random = np.random.default_rng(seed)
    l = 10.0
    for _ in range(count):
        nu = float(random.choice([0.0, 0.2, 0.3, 0.45]))
        wide, thick = 10 ** random.uniform(0.6, 1.8), 10 ** random.uniform(-2.0, -0.53)
        yield "blade", [float(l * thick)], l, float(l * wide), nu


WIDE = (
    (0.2, 1.0, 24.0, 0.3), (0.45, 1.0, 24.0, 0.0), (0.76, 0.26, 55.0, 0.45), (0.45, 1.0, 60.0, 0.0),
    (0.05, 1.0, 60.0, 0.45), (0.3, 0.5, 36.0, 0.2),
)  # fmt: skip
SOFT = (0.2, 8.0, 2.0, 0.45), (0.7, 7.2, 3.0, 0.49), (0.1, 12.0, 15.0, 0.49), (1.0, 8.0, 6.0, 0.45)


def wide_notches(count=24, seed=11):
    """Yield notches of b/l from 8 to 31, chosen ones and others in the same way."""
    for e, depth, b, nu in WIDE:
        yield "notch", [e, depth], 2.0, b, nu
    random = np.random.default_rng(seed)
    while count:
        nu = float(random.choice([0.0, 0.2, 0.3, 0.4, 0.45, 0.49]))
        depth = float(random.choice([0.2, 0.5, 1.0, 2.0]))
        e, b = float(10 ** random.uniform(-2.0, 0.3)), float(10 ** random.uniform(1.2, 1.8))
        if e * depth <= 1.0 and e <= 4.0 * depth:
            count -= 1
            yield "notch", [e, depth], 2.0, b, nu


def soft_fillets(count=16, seed=12):
    """Yield blades with fillets of a material that hardly gives way in volume, as those."""
    for h, l, b, nu in SOFT:
        yield "filleted", [h, 1.0], l, b, nu
    random = np.random.default_rng(seed)
    while count:
        nu, h = float(random.choice([0.45, 0.49])), float(10 ** random.uniform(-1.3, 0.0))
        l, b = float(random.uniform(4.0, 20.0)), float(10 ** random.uniform(-0.3, 1.3))
        if h <= b and h <= 0.15 * l and b <= 2.0 * l:
            count -= 1
            yield "filleted", [h, 1.0], l, b, nu


def sharp_fillets(count=24, seed=14):
    """Yield blades thicker than the radius of their fillets, in the same way."""
    random = np.random.default_rng(seed)
    while count:
        nu, h = float(random.choice([0.0, 0.2, 0.3, 0.45])), float(10 ** random.uniform(0.05, 0.6))
        l, b = h * float(10 ** random.uniform(0.8, 1.5)), h * float(10 ** random.uniform(0, 1.2))
        if l >= 4.0 and b <= 3.0 * l:
            count -= 1
            yield "filleted", [h, 1.0], l, b, nu


def stiffness(kind, numbers, l, b, nu, fineness=1):
    """Return six stiffnesses about the middle of a hinge by solids, over E."""
    profile = KINDS[kind](*(R * n for n in numbers))
    blade = Blade("hinge", "ground", "body", (0.0, 0.0), (l * R, 0.0), profile, b * R)
    layout = Layout((Body("body", (l * R / 2.0, 0.0)),), (blade,), E, E / (2.0 + 2.0 * nu))
    deck = compliance_deck(solid_model(layout, fineness=fineness), "body", guided=False)
    ref, rot = deck.bodies["body"]
    tables = run(deck.text, "hinge").tables("displacements")
    C = np.stack([np.concatenate([moved[ref], moved[rot]]) for moved in tables], axis=-1)
    return 1.0 / (np.diag(C) * np.repeat([1.0 / MM, MM], 3)) / E


def main():
    rows = []
    soft = *notches(12, 4, (0.45, 0.49), 1.2), *soft_fillets()
    wide = *very_wide_blades(), *wide_notches()
    for hinge in (*hinges(), *notches(), *soft, *tapers(), *blades(), *wide, *sharp_fillets()):
        fineness = 2 if hinge[0] == "blade" else 1
        rows.append([*hinge, stiffness(*hinge, fineness).tolist()])
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    FOUND.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
