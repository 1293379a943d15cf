"""Tapers and hinges at a stroke under loads out of their plane: solids by CalculiX, NLGEOM.

Run by hand: python tests/benchmarks/hinges_at_stroke.py COUNT SEED KIND FILE
It adds rows to a JSON file like tests/mechanics/space/hinges_at_stroke.json, a minute for each:
kind, profile's numbers, length, width [mm], ν, how far the end is moved across the thickness [m]
and turned [rad] (nothing where it is free), and loads at its middle (V_z, T, M_y) [N, N·m] with
the largest von Mises stress that each adds at rest and at the stroke [Pa], E being 200 GPa. The
stroke is what strains it by 0.3 to 1 times 1.5 %, of a turn of 0.21 rad at most. Stress is looked
at a thickness or more from the clamps. With SWINGS in place of a file it prints by which share of
its stress at rest each load alternates as the hinge turns from rest: half of the difference, in the
axes of sections that turn as those of exact beams.
"""

import json
import sys
from pathlib import Path

import numpy as np

from flexcli.engine.solid import bricks as meshes
from flexcli.engine.solid.calculix import run
from flexcli.formulas.profile import Filleted, Notch, Tabulated
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.stresses import blade_stresses, section_states
from flexcli.mechanics.space.layout import Drive, Isotropic, SpaceBlade, SpaceBody, SpaceLayout

E, MM, STRAIN, TURN, LOADED = 200e9, 1e3, 0.015, 0.21, 5e-4
MIXED = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.5, 0.5, 0], [-0.5, 0.5, 0.5]])
WIDTHS = np.array([-1.0, -0.86, -0.5, 0.0, 0.5, 0.86, 1.0])
CONTROLS = "*CONTROLS, PARAMETERS=FIELD\n1e-4, 1e-3, 1e-4, , 1e-4, 1e-4"


def hinges(kind, count, seed):
    """Yield profile's numbers, length, width [mm], ν and whether it is guided, at random."""
    random = np.random.default_rng(seed)
    while count:
        nu, guided = float(random.choice([0.2, 0.3, 0.4])), bool(random.integers(2))
        if kind == "taper":
            l = 20.0
            b, thin = l * 10 ** random.uniform(-1.2, -0.05), l * 10 ** random.uniform(-2.0, -1.2)
            thick = thin * (1.0 + float(random.choice([0.3, 1.0, 3.0])) * random.random())
            each = [[thin, thick], [thick, thin, thick], [thin, thick, thin]]
            numbers = each[random.integers(3)]
            inside = max(numbers) <= min(b, 0.12 * l)
        elif kind == "notch":
            l, guided, numbers = 2.0, False, [10 ** random.uniform(-1.3, -0.3), 1.0]
            b = 10 ** random.uniform(-0.3, 0.5)
            inside = numbers[0] <= b
        else:
            l, numbers = 2.0 + 10 ** random.uniform(0.5, 1.2), [10 ** random.uniform(-1, -0.1), 1.0]
            b = numbers[0] * 10 ** random.uniform(0.3, 1.2)
            inside = b <= 2.0 * l and numbers[0] <= l / 8.0
        if inside:
            count -= 1
            yield [float(each) for each in numbers], float(l), float(b), nu, guided


def layout_of(kind, numbers, l, b, nu):
    """Return a hinge between the ground and a body, whose point is its middle."""
    h = tuple(each / MM for each in numbers)
    even = tuple(np.linspace(0.0, 1.0, len(h)).tolist())
    made = {"taper": lambda: Tabulated(even, h), "notch": lambda: Notch(*h)}
    profile = made.get(kind, lambda: Filleted(*h))()
    end, middle = (l / MM, 0.0, 0.0), (l / MM / 2.0, 0.0, 0.0)
    material = Isotropic(E, E / (2.0 + 2.0 * nu))
    blade = SpaceBlade("h", "ground", "b", (0.0,) * 3, end, (0, 0, 1), profile, b / MM, material)
    return SpaceLayout((SpaceBody("b", middle, middle),), (blade,), Drive("b", True, (0, 0, 1),
                                                                          middle))  # fmt: skip


def stroke_of(layout, guided, share):
    """Return how far the end is held: shift across the thickness [m] and turn [rad]."""
    l = layout.blades[0].end[0]

    def at(turn):
        return (l * turn / 3.0, 0.0) if guided else (None, turn)

    y, turn = at(1e-3)
    state = solve(layout, {"b": (None, y, None, None, None, turn)}, levels=(27,)).checked()
    strain = np.abs(blade_stresses(state)[0].corner).max() / E / 1e-3
    return at(share * min(TURN, STRAIN / strain))


def stresses(layout, loads, held=None):
    """Return the largest stress that each load (V_z, T, M_y) adds, linear where nothing is held."""
    return [mises(each) for each in added(layout, loads, held)[1]]


def added(layout, loads, held=None):
    """Return places along a hinge [m] and the stress (nodes, 6) that loads add there [Pa]."""
    blade = layout.blades[0]
    l, b, h = blade.end[0], blade.b, [float(p.thickness(np.array([-1.0, 1.0])).min())
                                      for p in blade.profile.pieces(blade.end[0])]  # fmt: skip
    meshes.VARIED = np.array([-1.0, 1.0]) if isinstance(blade.profile, Tabulated) else meshes.VARIED
    meshes._widths = lambda b, h: WIDTHS if b > 4.0 * h else WIDTHS[[0, 1, 3, 5, 6]]
    made = meshes.bricks(blade.profile.stretches(l), b)
    places, c, a = made.places * MM, l * MM / 2.0, l / 2.0
    ref, rot = len(places) + 1, len(places) + 2
    arms = {rot + 1: (0, 0), rot + 2: (0, 1), rot + 3: (0, -1), rot + 4: (-1, 0), rot + 5: (1, 0)}
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i + 1}, {x:.12g}, {y:.12g}, {z:.12g}" for i, (x, y, z) in enumerate(places)]
    lines += ["*NODE", *(f"{node}, {c}, 0., 0." for node in (ref, rot))]
    lines += [f"{node}, {c + c * x}, {c * y}, 0." for node, (x, y) in arms.items()]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=ALL")
    for i, nodes in enumerate(made.elements + 1):
        lines += [", ".join(map(str, [i + 1, *nodes[:14]])) + ",", ", ".join(map(str, nodes[14:]))]
    for name, nodes in (("GROUND", made.end(0) + 1), ("END", [*(made.end(-1) + 1), *arms])):
        lines += [f"*NSET, NSET={name}", *(f"{node}," for node in nodes)]
    lines += [
        "*MATERIAL, NAME=M", "*ELASTIC", f"{E * 1e-6:.10g}, {blade.material.nu:.10g}",
        "*SOLID SECTION, ELSET=ALL, MATERIAL=M",
        f"*RIGID BODY, NSET=END, REF NODE={ref}, ROT NODE={rot}", "*BOUNDARY", "GROUND, 1, 3",
    ]  # fmt: skip
    if held is not None:
        lines += [f"{rot}, 3, 3, 0."] if held[0] is not None else []
    for k, (V, T, M) in enumerate([np.zeros(3), *loads]):
        forces = (V, T / 2.0 / a, -T / 2.0 / a, M / 2.0 / a, -M / 2.0 / a)
        lines += ["*STEP"] if held is None else ["*STEP, NLGEOM, INC=1000"]
        lines += ["*STATIC"]
        if held is not None:
            lines += ["1., 1., 1e-4, 1." if k else "0.5, 1., 1e-4, .5", CONTROLS, "*BOUNDARY"]
            lines += [f"{ref}, 2, 2, {held[0] * MM:.14g}"] if held[0] is not None else []
            lines += [f"{rot}, 3, 3, {held[1]:.14g}"]
        lines.append("*CLOAD, OP=NEW")
        lines += [f"{node}, 3, {F:.12g}" for node, F in zip(arms, forces, strict=True)]
        lines += ["*EL FILE, NSET=ALL, FREQUENCY=100000", "S", "*END STEP"]
    x, far = made.places[:, 0], [min(each, 0.1 * l) for each in (h[0], h[-1])]
    clear = np.flatnonzero((x >= far[0]) & (x <= l - far[1]))
    fields = run("\n".join([*lines, ""]), "hinge").fields("STRESS")
    alone, *with_loads = (1e6 * np.array([field[i + 1][:6] for i in clear]) for field in fields)
    return x[clear], [each - alone for each in with_loads]


def mises(stress):
    """Return the largest stress of von Mises of six components at nodes."""
    direct, shear = stress[:, :3], stress[:, 3:]
    apart = np.sum((direct - np.roll(direct, 1, axis=1)) ** 2, axis=1) / 2.0
    return float(np.sqrt(apart + 3.0 * np.sum(shear**2, axis=1)).max())


def swings(kind, hinge, share):
    """Return the rotation of a hinge and the shares by which V_z, T and M_y alternate with it."""
    layout = layout_of(kind, *hinge[:4])
    l, (_, turn) = hinge[1] / MM, stroke_of(layout, False, share)
    loads = np.diag([1.0, l, l])
    loads = loads / np.array(stresses(layout, loads))[:, None] * LOADED * E
    (x, ends), (_, rest) = (added(layout, loads, (None, angle)) for angle in (turn, 1e-7))
    state = solve(layout, {"b": (None,) * 5 + (turn,)}, levels=(27,)).checked()
    (at,) = section_states(state)
    bent = np.cumsum(np.gradient(at.s) * at.M_z / at.h**3)
    angle = turn * np.interp(x / l, at.s, bent / bent[-1])
    return turn, [
        mises(turned(a, angle) - b) / 2.0 / mises(b) for a, b in zip(ends, rest, strict=True)
    ]


def turned(stress, angle):
    """Return stresses (nodes, 6) in axes turned by angles about z."""
    xx, yy, zz, xy, xz, yz = stress.T
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([
        c * c * xx + s * s * yy + 2.0 * c * s * xy, s * s * xx + c * c * yy - 2.0 * c * s * xy, zz,
        c * s * (yy - xx) + (c * c - s * s) * xy, c * xz + s * yz, c * yz - s * xz,
    ], axis=-1)  # fmt: skip


def row(kind, hinge, share):
    """Return a hinge with its stroke and loads, and the stress that each adds."""
    *shape, guided = hinge
    layout = layout_of(kind, *shape)
    l, held = shape[1] / MM, stroke_of(layout, guided, share)
    ones = np.diag([1.0, l, l])
    each = ones / np.array(stresses(layout, ones))[:, None] * LOADED * E
    loads = MIXED @ each
    found = zip(loads, stresses(layout, loads), stresses(layout, loads, held), strict=True)
    held = [None if each is None else float(f"{each:.5g}") for each in held]
    return [kind, *shape, held, [[*(float(f"{x:.5g}") for x in (*f, r, s))] for f, r, s in found]]


def main():
    count, seed, kind, file = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3], Path(sys.argv[4])
    shares = np.random.default_rng(seed).uniform(0.3, 1.0, count)
    for hinge, share in zip(hinges(kind, count, seed), shares, strict=True):
        if file.name == "SWINGS":
            print(kind, *hinge[:4], *swings(kind, hinge, float(share)))
            continue
        rows = json.loads(file.read_text(encoding="utf-8")) if file.exists() else []
        rows.append(row(kind, hinge, float(share)))
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
        file.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
