"""Notches and blades with fillets under forces across them: solids by CalculiX, with their blocks.

Run by hand: python tests/benchmarks/hinge_stresses.py HINGES FILE
It writes a JSON file like tests/mechanics/space/hinge_stresses.json, a minute for each hinge: its
kind, its profile's numbers, its length, width, ν and the length of the blocks, all in units of the
radius of its roots or of half its length, and loads at its middle (V_z, T, M_y) with the largest
von Mises stress between its mouths over E. Half of it is meshed, for these loads are antisymmetric.
The rows that are kept were solved on the same meshes by another solver of sparse equations, within
5e-5 of CalculiX, with the three loads by themselves and two mixtures of them, the ones that beams
were furthest off in.
"""

import json
import sys
from pathlib import Path

import numpy as np

from flexcli.engine.solid.bricks import CORNERS, VARIED, _stations, _steps
from flexcli.engine.solid.calculix import run
from flexcli.formulas.profile import Filleted, Notch

KINDS = {"notch": Notch, "filleted": Filleted}
FINE, MM, NU = 2, 1e3, (0.0, 0.2, 0.3, 0.4, 0.49)
MIXED = np.random.default_rng(0).normal(size=(14, 3))


def hinges(count, seed):
    """Yield kind, profile's numbers, length, width, ν and the length of the blocks, at random."""
    random = np.random.default_rng(seed)
    while count:
        nu, kind = float(random.choice(NU)), str(random.choice(list(KINDS)))
        if kind == "notch":
            shallow = 10.0 ** random.uniform(-1.0, 0.3)
            e, depth = 10.0 ** random.uniform(-3.3, 0.3), float(random.choice([1.0, 1.0, shallow]))
            l, b = 2.0, 10.0 ** random.uniform(-2.0, 1.2)
            numbers, inside = [e, depth], e * depth <= 1.0 and e <= min(b, 4.0 * depth)
        else:
            e, depth = 10.0 ** random.uniform(-1.7, 0.0), 1.0
            l = 2.0 + 10.0 ** random.uniform(-1.0, 1.5)
            b = e * 10.0 ** random.uniform(0.0, 2.3)
            numbers, inside = [e, 1.0], b <= 2.0 * l and e <= l / 4.0 and nu <= 0.4
        blocks = float(random.choice([0.0, 0.5, 1.0, 2.0])) * (e + 2.0 * depth)
        if inside and b / (l + 2.0 * blocks) > 0.01 and b < 250.0 * e:
            count -= 1
            yield kind, numbers, l, b, nu, blocks


def sharp_fillets(count=14, seed=1):
    """Yield blades thicker than the radius of their fillets, or of ν 0.45, in the same way."""
    random = np.random.default_rng(seed)
    while count:
        nu = float(random.choice([0.0, 0.3, 0.45, 0.45]))
        h = 10.0 ** (random.uniform(-0.6, 0.6) if nu == 0.45 else random.uniform(0.02, 0.6))
        l = 2.0 + h * 10.0 ** random.uniform(0.6, 1.5)
        b = h * 10.0 ** random.uniform(0.0, 1.5)
        blocks = float(random.choice([0.0, 0.5, 1.0])) * (h + 2.0)
        if b <= 2.0 * l and h <= l / 6.0 and b / (l + 2.0 * blocks) >= 0.01:
            count -= 1
            yield "filleted", [h, 1.0], l, b, nu, blocks


def along(kind, numbers, l, blocks):
    """Return places and thicknesses along a hinge and its blocks, and which are between them."""
    profile = KINDS[kind](*numbers)
    H, each = profile.mouth(l), [_stations([piece], FINE) for piece in profile.pieces(l)]
    s, h = (
        np.concatenate([pieces[0][:1], *(piece[1:] for piece in pieces)])
        for pieces in zip(*each, strict=True)
    )
    if not blocks:
        return s, h, (s >= s[2 * FINE]) & (s <= s[-1 - 2 * FINE])  # clear of the rigid bodies
    cuts, more = [0.0], 0.12 * H
    while cuts[-1] < blocks:
        cuts.append(blocks if blocks - cuts[-1] < 1.7 * more else cuts[-1] + more)
        more *= 2.2
    behind = -_steps(np.array(cuts), FINE)[::-1]
    # the last of a notch, steep as it is, becomes straight
    link = s[0] * np.linspace(0.0, 1.0, 2 * FINE + 1)[1:-1]
    if s[0] < 1e-9 * l:
        behind, link = behind[:-1], behind[:0]
    before = np.concatenate([behind, link])
    thick = np.interp(before, [0.0, max(s[0], 1e-9 * l)], [H, h[0]])
    where = np.concatenate([before, s, l - before[::-1]])
    inside = (where >= s[0]) & (where <= s[-1])
    return where, np.concatenate([thick, h, thick[::-1]]), inside


def mesh(kind, numbers, l, b, blocks):
    """Return the nodes of one half of the width, their lattice, elements, and which are inside."""
    s, h, between = along(kind, numbers, l, blocks)
    edge = min(max(1.2 * h.min() / b, 0.03), 0.25)
    cuts = [0.0, 0.5, 0.8, 1.0]
    if edge < 0.25:
        cuts = [*np.linspace(0.0, 1.0 - 3.0 * edge, 3 if b > 3.0 * h.min() else 2), 1.0 - edge, 1.0]
    across, width = _steps(VARIED, FINE), _steps(np.array(cuts), FINE)
    lattice = np.full((s.size, across.size, width.size), -1)
    there = np.asarray(sum(np.ix_(*(np.arange(n) % 2 for n in lattice.shape)))) <= 1
    lattice[there] = np.arange(there.sum())
    i, j, k = np.nonzero(there)
    places = np.stack([s[i], across[j] * h[i] / 2.0, width[k] * b / 2.0], axis=-1)
    first = np.stack(np.meshgrid(*(np.arange(0, n - 1, 2) for n in lattice.shape), indexing="ij"))
    at = first.reshape(3, -1).T[:, None] + CORNERS
    return places, lattice, lattice[tuple(np.moveaxis(at, -1, 0))], between[i]


def stresses(kind, numbers, l, b, nu, blocks):
    """Return the stress at the nodes (3, nodes, 6) under V_z, T and M_y of one, E being one."""
    places, lattice, elements, inside = mesh(kind, numbers, l, b, blocks)
    ref, rot = len(places) + 1, len(places) + 2
    sides = {"GROUND": lattice[0], "END": lattice[-1], "MIDDLE": lattice[1:-1, :, 0]}
    lines = ["*NODE"]
    lines += [f"{n + 1}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in enumerate(places * MM)]
    lines += [f"{node}, {l * MM / 2.0:.12g}, 0., 0." for node in (ref, rot)]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=ALL")
    for n, nodes in enumerate(elements + 1):
        lines += [", ".join(map(str, [n + 1, *nodes[:14]])) + ",", ", ".join(map(str, nodes[14:]))]
    for name, nodes in sides.items():
        lines += [f"*NSET, NSET={name}", *(f"{node + 1}," for node in nodes[nodes >= 0])]
    lines += [
        "*MATERIAL, NAME=M", "*ELASTIC", f"1., {nu}", "*SOLID SECTION, ELSET=ALL, MATERIAL=M",
        f"*RIGID BODY, NSET=END, REF NODE={ref}, ROT NODE={rot}",
        "*BOUNDARY", "GROUND, 1, 3", "MIDDLE, 1, 2", f"{ref}, 1, 2", f"{rot}, 3, 3",
    ]  # fmt: skip
    for node, axis in ((ref, 3), (rot, 1), (rot, 2)):
        lines += ["*STEP", "*STATIC", "*CLOAD, OP=NEW", f"{node}, {axis}, 0.5"]
        lines += ["*EL FILE", "S", "*END STEP"]
    found = np.zeros((3, len(places), 6))
    for step, field in enumerate(run("\n".join([*lines, ""]), "hinge").fields("STRESS")):
        for node, stress in field.items():
            if node < ref:
                found[step, node - 1] = stress
    return found[:, inside] * np.array([MM**2, MM**3, MM**3])[:, None, None]


def mises(stress):
    """Return von Mises' stress of six components."""
    direct, shear = stress[..., :3], stress[..., 3:]
    apart = np.sum((direct - np.roll(direct, 1, axis=-1)) ** 2, axis=-1)
    return np.sqrt(apart / 2.0 + 3.0 * np.sum(shear**2, axis=-1))


def row(hinge):
    """Return a hinge with its loads and the largest stress of each."""
    found = stresses(*hinge)
    one = mises(found).max(axis=-1)
    loads = [*np.eye(3), *(MIXED / one)]
    most = [mises(np.tensordot(load, found, axes=1)).max() for load in loads]
    each = zip(loads, most, strict=True)
    return [*hinge, [[*(float(f"{x:.4g}") for x in (*load, m))] for load, m in each]]


def main():
    count, file = int(sys.argv[1]), Path(sys.argv[2])
    rows = []
    for hinge in (*hinges(count, seed=101), *sharp_fillets()):
        rows.append(row(hinge))
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    file.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
