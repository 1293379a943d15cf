"""Limbs between two circular notches, with the blocks outside them: solids by CalculiX.

Run by hand: python tests/benchmarks/limbs_in_space.py [FILE]
It writes tests/mechanics/space/limbs.json in ten minutes of one processor: for each limb, all in
units of the radius of its notches, the thickness of its throats, their distance, its width, ν, the
length of its blocks, six compliances about its middle times E, and for each of these unit loads the
largest von Mises stress between its outer mouths. Half of its width is meshed.
"""

import json
import sys
from pathlib import Path

import numpy as np
from hinge_stresses import FINE, MM, along, mises

from flexcli.engine.solid.bricks import CORNERS, VARIED, _steps
from flexcli.engine.solid.calculix import run

FOUND = Path(__file__).parents[1] / "mechanics/space/limbs.json"
LIMBS = (
    (0.5, 5.0, 3.0, 0.3, 2.5), (0.8, 2.4, 1.0, 0.3, 1.0), (0.3, 2.2, 0.5, 0.0, 2.0),
    (0.1, 8.0, 0.5, 0.34, 1.0), (0.2, 4.0, 6.0, 0.45, 0.8), (0.05, 3.0, 0.1, 0.3, 0.7),
)  # fmt: skip
"""e, l, b, ν and the length of the blocks: thick and thin, short and long, narrow and wide."""

WAYS = {"even": (0, 1, 5), "odd": (2, 3, 4)}
"""Loads whose motion is its own mirror image in mid-width, and those of which it is reversed."""


def along_limb(e, l, blocks):
    """Return places and thicknesses along a limb from its middle, and which are between mouths."""
    bar = l / 2.0 - 1.0
    inner, outer = (along("notch", [e, 1.0], 2.0, L) for L in (bar, blocks))
    low, high = inner[0] <= 1.0, outer[0] > 1.0
    s = l / 2.0 - 1.0 + np.concatenate([inner[0][low], outer[0][high]])
    h = np.concatenate([inner[1][low], outer[1][high]])
    inside = s <= l / 2.0 - 1.0 + outer[0][outer[2]].max()
    s[0] = 0.0
    return (
        np.concatenate([-s[:0:-1], s]),
        np.concatenate([h[:0:-1], h]),
        np.concatenate([inside[:0:-1], inside]),
    )


def mesh(e, l, b, blocks):
    """Return the nodes of one half of the width, their lattice, elements, and which are inside."""
    s, h, between = along_limb(e, l, blocks)
    edge = min(max(1.2 * e / b, 0.03), 0.25)
    cuts = [0.0, 0.5, 0.8, 1.0]
    if edge < 0.25:
        cuts = [*np.linspace(0.0, 1.0 - 3.0 * edge, 3 if b > 3.0 * e else 2), 1.0 - edge, 1.0]
    across, width = _steps(VARIED, FINE), _steps(np.array(cuts), FINE)
    lattice = np.full((s.size, across.size, width.size), -1)
    there = np.asarray(sum(np.ix_(*(np.arange(n) % 2 for n in lattice.shape)))) <= 1
    lattice[there] = np.arange(there.sum())
    i, j, k = np.nonzero(there)
    places = np.stack([s[i], across[j] * h[i] / 2.0, width[k] * b / 2.0], axis=-1)
    first = np.stack(np.meshgrid(*(np.arange(0, n - 1, 2) for n in lattice.shape), indexing="ij"))
    at = first.reshape(3, -1).T[:, None] + CORNERS
    return places, lattice, lattice[tuple(np.moveaxis(at, -1, 0))], between[i]


def row(e, l, b, nu, blocks):
    """Return a limb with its compliances times E and the stresses of unit loads."""
    places, lattice, elements, inside = mesh(e, l, b, blocks)
    ref, rot = len(places) + 1, len(places) + 2
    sides = {"GROUND": lattice[0], "END": lattice[-1], "MIDDLE": lattice[1:-1, :, 0]}
    lines = ["*NODE"]
    lines += [f"{n + 1}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in enumerate(places * MM)]
    lines += [f"{node}, 0., 0., 0." for node in (ref, rot)]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=ALL")
    for n, nodes in enumerate(elements + 1):
        lines += [", ".join(map(str, [n + 1, *nodes[:14]])) + ",", ", ".join(map(str, nodes[14:]))]
    for name, nodes in sides.items():
        lines += [f"*NSET, NSET={name}", *(f"{node + 1}," for node in nodes[nodes >= 0])]
    lines += [
        "*MATERIAL, NAME=M", "*ELASTIC", f"1., {nu}", "*SOLID SECTION, ELSET=ALL, MATERIAL=M",
        f"*RIGID BODY, NSET=END, REF NODE={ref}, ROT NODE={rot}",
        "*NSET, NSET=REFS", f"{ref},", f"{rot},",
    ]  # fmt: skip
    compliances, largest = np.zeros(6), np.zeros(6)
    for way, loads in WAYS.items():
        deck = [*lines, "*BOUNDARY", "GROUND, 1, 3"]
        if way == "even":
            deck += ["MIDDLE, 3, 3", f"{ref}, 3, 3", f"{rot}, 1, 2"]
        else:
            deck += ["MIDDLE, 1, 2", f"{ref}, 1, 2", f"{rot}, 3, 3"]
        for index in loads:
            node, axis = (ref, index + 1) if index < 3 else (rot, index - 2)
            deck += ["*STEP", "*STATIC", "*CLOAD, OP=NEW", f"{node}, {axis}, 0.5"]
            deck += ["*NODE PRINT, NSET=REFS", "U", "*EL FILE", "S", "*END STEP"]
        found = run("\n".join([*deck, ""]), "limb")
        tables, fields = found.tables("displacements"), found.fields("STRESS")
        for index, moved, field in zip(loads, tables, fields, strict=True):
            node, axis = (ref, index) if index < 3 else (rot, index - 3)
            scale = MM if index < 3 else MM**3
            compliances[index] = moved[node][axis] * scale
            stress = np.array([field[n + 1] for n in np.flatnonzero(inside)])
            largest[index] = mises(stress).max() * (MM**2 if index < 3 else MM**3)
    each = ([float(f"{x:.5g}") for x in values] for values in (compliances, largest))
    return [e, l, b, nu, blocks, *each]


def main():
    file = Path(sys.argv[1]) if len(sys.argv) > 1 else FOUND
    rows = []
    for limb in LIMBS:
        rows.append(row(*limb))
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    file.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
