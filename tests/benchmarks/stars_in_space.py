"""Bars of strips that cross, between rigid bodies: solids by CalculiX, in five axes.

Run by hand: python tests/benchmarks/stars_in_space.py
It writes tests/mechanics/space/stars.json in a few minutes: for each star thickness, width, length
[m], number of strips and ν, and its stiffness along x and y, about y [N/m, N·m/rad], each with all
else free, and the largest von Mises stress of a unit of each [Pa], E being 200 GPa. The stress is
away from the clamps by a quarter of the width, from the roots by 0.4 of the thickness. Torsion is
left out: rigid bodies keep ends from warping, which those of a torsion star may do.
"""

import json
import sys
from itertools import pairwise
from math import pi, tan
from pathlib import Path

import numpy as np

from flexcli.engine.solid.calculix import run

FOUND = Path(__file__).parents[1] / "mechanics/space/stars.json"
E, MM, L = 200e9, 1e3, 20e-3
SHORT = ((3, 0.19, 0.7, 0.2), (3, 0.19, 0.7, 0.4), (3, 0.12, 0.7, 0.4), (2, 0.19, 0.8, 0.4),
         (2, 0.12, 0.8, 0.4), (4, 0.15, 0.7, 0.4), (3, 0.06, 0.8, 0.4))  # fmt: skip
"""Strips, h/b, b/l and ν of short stars."""
SOFT = ((3, 0.093, 0.795, 0.45), (2, 0.177, 0.117, 0.45), (2, 0.25, 0.3, 0.45),
        (3, 0.06, 0.85, 0.45), (2, 0.04, 0.5, 0.45), (4, 0.12, 0.5, 0.45), (2, 0.19, 0.9, 0.45),
        (6, 0.08, 0.4, 0.45))  # fmt: skip
"""The same of stars that narrow more."""
QUAD = np.array([[0, 1], [1, 2], [2, 3], [3, 0]])


def stars(count, seed, strips, widths, thicknesses):
    """Yield thickness, width, strips and ν at random, arms of at least a thickness."""
    random = np.random.default_rng(seed)
    while count:
        n = int(random.choice(strips))
        b = L * 10 ** random.uniform(*widths)
        h, nu = b * 10 ** random.uniform(*thicknesses), float(random.choice([0.0, 0.2, 0.3, 0.4]))
        if b / h / 2.0 - 0.5 / tan(pi / (2 * n)) >= 1.0:
            count -= 1
            yield h, b, n, nu


def section(h, b, n):
    """Return the corners of quadrangles that fill the section, the first strip along y."""
    reach = h / 2.0 / tan(pi / (2 * n))
    free = b / 2.0 - reach
    cuts = reach + free * np.array([0, 0.12, 0.5, 0.88, 1] if free > 6.0 * h else [0, 0.3, 0.7, 1])
    found, middles, roots = [], [], []
    for k in range(2 * n):
        u = np.array([np.cos(k * pi / n), np.sin(k * pi / n)])
        v = h / 2.0 * np.array([-u[1], u[0]])
        for a, c in pairwise(cuts):
            for low, high in ((-v, 0.0 * v), (0.0 * v, v)):
                found.append([a * u + low, c * u + low, c * u + high, a * u + high])
        middles.append(reach * u)
        roots.append(reach * u + v)
    after = [*middles[1:], middles[0]]
    found += [[np.zeros(2), *each] for each in zip(middles, roots, after, strict=True)]
    return np.array(found), np.array(roots)


def graded(l, first):
    """Return where elements end along a bar: six in its middle, each a quarter of the next."""
    growing = []
    while l / 6.0 * 4.0 ** -len(growing) > first:
        growing.insert(0, l / 6.0 * 4.0 ** -(len(growing) + 1))
    left = l - 2.0 * sum(growing)
    inner = max(1, int(np.ceil(left / (l / 6.0) - 1e-9)))
    sizes = [*growing, *[left / inner] * inner, *growing[::-1]]
    return np.concatenate([[0.0], np.cumsum(sizes)]) * (l / sum(sizes))


def mesh(h, b, n):
    """Return nodes, elements of 20 nodes, and the roots between two arms."""
    quads, roots = section(h, b, n)
    cuts, index, places, elements = graded(L, min(2.0 * h, L / 12.0)), {}, [], []

    def node(x, at):
        key = tuple(np.round(np.array([x, *at]) / L * 1e8).astype(int).tolist())
        if key not in index:
            index[key] = len(places)
            places.append((x, *at))
        return index[key]

    for a, c in pairwise(cuts):
        for corners in quads:
            edges = corners[QUAD].mean(axis=1)
            ends = [node(x, at) for each in (corners, edges) for x in (a, c) for at in each]
            elements.append([*ends, *(node((a + c) / 2.0, at) for at in corners)])
    return np.array(places), np.array(elements), roots


def solid(h, b, n, nu):
    """Return stiffness and largest stress along x and y, about y, of unit loads at the middle."""
    places, elements, roots = mesh(h, b, n)
    ref, rot = len(places) + 1, len(places) + 2
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{i + 1}, {x:.12g}, {y:.12g}, {z:.12g}" for i, (x, y, z) in enumerate(places * MM)]
    lines += ["*NODE, NSET=BODY", *(f"{each}, {L * MM / 2.0}, 0., 0." for each in (ref, rot))]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=ALL")
    for i, nodes in enumerate(elements + 1):
        lines += [", ".join(map(str, [i + 1, *nodes[:14]])) + ",", ", ".join(map(str, nodes[14:]))]
    for name, x in (("GROUND", 0.0), ("END", L)):
        there = np.flatnonzero(np.abs(places[:, 0] - x) < 1e-9 * L) + 1
        lines += [f"*NSET, NSET={name}", *(f"{each}," for each in there)]
    lines += [
        "*MATERIAL, NAME=M", "*ELASTIC", f"{E * 1e-6:.10g}, {nu}",
        "*SOLID SECTION, ELSET=ALL, MATERIAL=M",
        f"*RIGID BODY, NSET=END, REF NODE={ref}, ROT NODE={rot}", "*BOUNDARY", "GROUND, 1, 3",
    ]  # fmt: skip
    for node, axis, size in ((ref, 1, 1.0), (ref, 2, 1.0), (rot, 2, MM)):
        lines += ["*STEP", "*STATIC", "*CLOAD, OP=NEW", f"{node}, {axis}, {size}"]
        lines += ["*NODE PRINT, NSET=BODY", "U", "*EL FILE, NSET=ALL", "S", "*END STEP"]
    printed = run("\n".join([*lines, ""]), "star")
    moved = [each[node] for each, node in zip(printed.tables("displacements"), (ref, ref, rot),
                                              strict=True)]  # fmt: skip
    stiffness = [MM / moved[0][0], MM / moved[1][1], 1.0 / moved[2][1]]
    far = np.min([np.hypot(*(places[:, 1:] - root).T) for root in roots], axis=0) > 0.4 * h
    far &= np.abs(places[:, 0] - L / 2.0) <= L / 2.0 - b / 4.0
    most = []
    for field in printed.fields("STRESS"):
        stress = np.array([field[i + 1] for i in np.flatnonzero(far)])
        apart = np.sum((stress[:, :3] - np.roll(stress[:, :3], 1, axis=1)) ** 2, axis=1) / 2.0
        most.append(1e6 * float(np.sqrt(apart + 3.0 * np.sum(stress[:, 3:] ** 2, axis=1)).max()))
    return stiffness, most


def main():
    rows = []
    wide = stars(5, 1, [2, 2, 3, 4, 6], (-1.2, 0.0), (-1.7, -0.6))
    thick = stars(10, 3, [2, 2, 3, 3, 4], (-1.0, 0.0), (-1.3, -0.6))
    stout = stars(9, 5, [2, 2, 3], (-1.0, -0.05), (-0.7, -0.48))
    short = [(h * b * L, b * L, n, nu) for n, h, b, nu in (*SHORT, *SOFT)]
    for h, b, n, nu in (*wide, *thick, *stout, *short):
        found = [[float(f"{x:.5g}") for x in each] for each in solid(h, b, n, nu)]
        rows.append([float(f"{h:.5g}"), float(f"{b:.5g}"), L, n, nu, *found])
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    FOUND.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
