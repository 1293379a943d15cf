"""Blades at stroke: solids by CalculiX, shells and beams over width, thickness, stroke and ν.

Run by hand: python tests/benchmarks/blades_at_stroke.py solids|shells|buckled|print
The first three write tests/mechanics/space/blades_at_stroke.json, ``print`` reads it. Two hours
of one processor for the solids, ten minutes each for the shells and for what buckles them: of
loads about those that buckle beams, which shells still stand and under which they fall.

A solid is one blade of C3D20R, one element through its thickness, three of the thickest ones,
crowded towards its clamps. Its
end is moved to the pose of a guide or of a pivot, free along itself, then a little to either side
in all six coordinates: its stiffness is a difference of nodal forces, by CalculiX's full Newton
steps, without rigid bodies. Two meshes, 1.5 times as fine, are extrapolated with the order 1.5 that
three meshes of the first guide have. Pose and stiffness give the support of two such blades.
"""

import json
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
from scipy.spatial.transform import Rotation

sys.path.insert(0, str(Path(__file__).parents[1]))

from blades_at_stroke import (
    FOUND,
    LENGTH,
    Case,
    E,
    at_stroke,
    found,
    held_at_stroke,
    mechanism,
    one_blade,
    own_stiffness,
    pushed,
    supports,
    two_of_them,
)

from flexcli.engine.joint_models.space_errors import beam_errors, shell_errors
from flexcli.engine.joint_models.space_stroke import BEAMS
from flexcli.engine.solid.bricks import CORNERS
from flexcli.engine.solid.calculix import run
from flexcli.mechanics.shell.first_guess import SHELL_LEVELS, shells_from_beams
from flexcli.mechanics.space.exact.critical import critical_load
from flexcli.mechanics.space.exact.equilibrium import Outcome, solve

MM = 1e3
MESHES = (20, 30)
"""Elements along a blade."""
ORDER = 1.5
PATH = 20
"""Poses on the way, between which the end goes straight."""
PUSH = 0.15
"""Of the force or moment at the stroke: the size of the steps to either side."""
CROWDED = 0.7
"""Share of a cosine in where the elements end."""

SOLIDS = (
    Case("guide", 1.0, 0.005, 0.2), Case("guide", 0.2, 0.02, 0.3), Case("cross", 1.0, 0.01, 15),
    Case("guide", 1.5, 0.005, 0.2), Case("guide", 0.5, 0.005, 0.1, 0.45),
    Case("cross", 0.4, 0.01, 30), Case("guide", 0.1, 0.005, 0.2), Case("cross", 1.5, 0.005, 10),
    Case("guide", 0.5, 0.005, 0.3), Case("guide", 0.02, 0.02, 0.3), Case("guide", 1.0, 0.005, 0.05),
    Case("remote", 0.5, 0.01, 10), Case("guide", 0.2, 0.005, 0.2), Case("guide", 0.5, 0.02, 0.2),
    Case("cross", 0.1, 0.01, 15), Case("guide", 1.5, 0.01, 0.05), Case("guide", 0.05, 0.05, 0.1),
    Case("guide", 0.3, 0.05, 0.2),
)  # fmt: skip

THICK_OR_WIDE = (
    Case("guide", 0.5, 0.1, 0.05), Case("cross", 3.0, 0.08, 1.0), Case("guide", 3.0, 0.05, 0.03),
    Case("cross", 1.0, 0.1, 3.0), Case("guide", 0.3, 0.15, 0.03), Case("guide", 2.0, 0.1, 0.03),
    Case("guide", 1.0, 0.1, 0.1, 0.45), Case("guide", 3.0, 0.02, 0.05),
    Case("cross", 0.2, 0.15, 3.0), Case("guide", 3.0, 0.1, 0.02, 0.45),
    Case("guide", 0.1, 0.1, 0.1), Case("cross", 2.0, 0.03, 6.0), Case("guide", 1.0, 0.2, 0.02),
    Case("guide", 0.5, 0.1, 0.05, 0.0), Case("remote", 1.0, 0.1, 3.0),
)  # fmt: skip
"""Solids of 12 and 18 elements along a blade, within 0.8 % by their meshes."""

THICKER = (
    Case("guide", 1.0, 0.25, 0.02), Case("guide", 3.0, 0.25, 0.02, 0.34),
    Case("cross", 3.0, 0.25, 1.0, 0.45), Case("guide", 0.3, 0.25, 0.02, 0.45),
    Case("cross", 0.5, 0.25, 2.0, 0.45), Case("guide", 1.0, 0.25, 0.02, 0.45),
    Case("guide", 3.0, 0.25, 0.02, 0.45), Case("guide", 0.5, 0.25, 0.03, 0.0),
)  # fmt: skip
"""Three elements through the thickness, 10 and 15 along, within 0.8 % by their meshes."""

NARROW = (
    Case("guide", 0.02, 0.01, 0.1), Case("cross", 0.02, 0.01, 10.0),
    Case("cross", 0.05, 0.01, 10.0, 0.45), Case("cross", 0.02, 0.005, 5.0, 0.45),
    Case("guide", 0.05, 0.005, 0.1, 0.45), Case("cross", 0.05, 0.005, 15.0, 0.0),
    Case("remote", 0.05, 0.01, 5.0), Case("guide", 0.03, 0.003, 0.2),
    Case("cross", 0.1, 0.01, 3.0, 0.45), Case("cross", 0.02, 0.002, 30.0, 0.45),
    Case("guide", 0.02, 0.002, 0.3), Case("remote", 0.02, 0.004, 10.0, 0.45),
    Case("cross", 0.05, 0.002, 5.0),
)  # fmt: skip
"""Nearly beams. Sections no wider than thick, as the first of all have them, are too stiff in twist
for one element: by 0.055 at b = h/2, where two through the thickness leave 0.006."""

NARROWING = (
    Case("cross", 0.15, 0.015, 20, 0.45), Case("cross", 0.2, 0.02, 20, 0.45),
    Case("cross", 0.1, 0.02, 30, 0.45), Case("cross", 0.2, 0.05, 15, 0.45),
    Case("cross", 0.15, 0.03, 15, 0.45),
)  # fmt: skip
"""Which clamps keep from narrowing most, within 2 % by their meshes of 12 and 18 elements."""

OTHER_NU = (
    Case("guide", 0.5, 0.005, 0.1, 0.0), Case("guide", 0.5, 0.005, 0.1, 0.45),
    Case("guide", 0.2, 0.0025, 0.1, 0.45), Case("guide", 0.5, 0.0025, 0.05, 0.4),
    Case("guide", 0.1, 0.02, 0.3, 0.45), Case("cross", 0.75, 0.005, 10.0, 0.45),
    Case("cross", 1.0, 0.005, 3.0, 0.45),
)  # fmt: skip


def shell_cases():
    for h in (0.0025, 0.005, 0.01, 0.02):
        for b in (0.1, 0.2, 0.5, 0.75, 1.0, 1.5):
            yield from (Case("guide", b, h, s) for s in (0.0, 0.02, 0.05, 0.1, 0.2, 0.3))
    for h in (0.005, 0.01, 0.02):
        for b in (0.1, 0.2, 0.4, 0.5, 0.75, 1.0, 1.5):
            yield from (Case("cross", b, h, s) for s in (0.0, 3.0, 10.0, 15.0, 30.0))
    for h in (0.005, 0.02):
        for b in (0.1, 0.3, 0.5, 1.0, 1.5):
            yield from (Case("folded", b, h, s) for s in (0.02, 0.1, 0.2))
            yield from (Case("remote", b, h, s) for s in (3.0, 10.0))
    for nu in (0.0, 0.2, 0.4, 0.45):
        for b in (0.2, 0.5, 1.0):
            yield from (Case("guide", b, 0.005, s, nu) for s in (0.05, 0.2))
    yield from OTHER_NU
    yield from wide_cases()


def wide_cases():
    for b in (2.0, 3.0):
        for h in (0.003, 0.01, 0.03):
            yield from (Case("guide", b, h, s) for s in (0.02, 0.1, 0.2))
            yield from (Case("cross", b, h, s) for s in (2.0, 8.0))
        yield from (Case("folded", b, 0.01, 0.05), Case("remote", b, 0.01, 5.0))
        yield from (Case("guide", b, 0.01, 0.1, nu) for nu in (0.0, 0.45))
        yield Case("cross", b, 0.02, 4.0, 0.45)


class Mesh(NamedTuple):
    """Nodes [mm], elements, and the nodes of both ends."""

    places: np.ndarray
    elements: np.ndarray
    start: np.ndarray
    end: np.ndarray


def mesh_of(case, along):
    across = round(along / 5 if case.b <= 0.2 else along * 0.4)
    l, through = LENGTH * MM, 3 if case in THICKER else 1

    def crowded(count):
        u = np.linspace(0.0, 1.0, count + 1)
        u = (1.0 - CROWDED) * u + CROWDED * (1.0 - np.cos(np.pi * u)) / 2.0
        return np.sort(np.concatenate([u, (u[:-1] + u[1:]) / 2.0]))

    x, z = crowded(along) * l, (crowded(across) - 0.5) * case.b * l
    y = (crowded(through) - 0.5) * case.h * l
    shape = (x.size, y.size, z.size)
    there = np.asarray(sum(np.ix_(*(np.arange(n) % 2 for n in shape)))) <= 1
    number = np.full(shape, -1)
    number[there] = np.arange(there.sum())
    i, j, k = np.nonzero(there)
    first = np.stack(np.meshgrid(*(np.arange(0, n - 1, 2) for n in shape), indexing="ij"), -1)
    at = first.reshape(-1, 1, 3) + CORNERS
    ends = (number[side][number[side] >= 0] for side in (0, -1))
    return Mesh(np.stack([x[i], y[j], z[k]], -1), number[at[..., 0], at[..., 1], at[..., 2]], *ends)


def deck_of(case, mesh, path, poses, force):
    """Return the text of a deck: along the path, then to the poses, the first by a force along x.

    One node of the end is free along x, the others follow it by what the turn asks of them.
    """
    places, end = mesh.places, mesh.end
    lead, others = int(end[0]), end[1:]
    centre = np.array([LENGTH * MM, 0.0, 0.0])
    turned = len(places) + np.arange(others.size)
    lines = ["*NODE"]
    lines += [f"{n}," + ",".join(f"{c:.12g}" for c in at) for n, at in enumerate(places, 1)]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=BLADE")
    for n, nodes in enumerate(mesh.elements + 1, 1):
        row = [str(n), *map(str, nodes)]
        lines += [",".join(row[:15]) + ",", ",".join(row[15:])]
    lines += _nset("START", mesh.start) + _nset("END", end)
    lines += [
        "*MATERIAL, NAME=M", "*ELASTIC", f"{E * 1e-6:.10g},{case.nu}",
        "*SOLID SECTION, ELSET=BLADE, MATERIAL=M", "*BOUNDARY", "START,1,3", "*NODE",
        *(f"{d + 1},0.,0.,0." for d in turned), *_nset("LEAD", np.array([lead])),
        "*BOUNDARY", *(f"{d + 1},2,3" for d in turned),
    ]  # fmt: skip
    for node, d in zip(others, turned, strict=True):
        lines += ["*EQUATION", "3", f"{node + 1},1,1.,{lead + 1},1,-1.,{d + 1},1,-1."]
    times = np.linspace(0.0, 1.0, len(path) + 1)

    def amplitude(name, values):
        rows = (f"{t:.10g},{v:.14g}" for t, v in zip(times, [0.0, *values], strict=True))
        return [f"*AMPLITUDE, NAME={name}", *rows]

    held = []
    for k, y in enumerate(np.unique(places[end][:, 1])):
        row = end[places[end][:, 1] == y]
        arm = np.array([0.0, y, 0.0])
        swung = [Rotation.from_rotvec(p[3:]).apply(arm) - arm for p in path]
        up = [p[1] * MM + s[1] for p, s in zip(path, swung, strict=True)]
        lines += _nset(f"ROW{k}", row) + amplitude(f"UP{k}", up)
        held += [f"*BOUNDARY, AMPLITUDE=UP{k}", f"ROW{k},2,2,1."]
        ahead = [
            Rotation.from_rotvec(p[3:]).apply([0.0, y - places[lead][1], 0.0])[0] for p in path
        ]
        lines += _nset(f"TURN{k}", turned[np.isin(others, row)]) + amplitude(f"AHEAD{k}", ahead)
        held += [f"*BOUNDARY, AMPLITUDE=AHEAD{k}", f"TURN{k},1,1,1."]
    controls = ["*CONTROLS, PARAMETERS=FIELD", "1e-5, 1e-3, 1e-5, , 1e-5, 1e-5"]
    printed = ["*NODE PRINT, NSET=END, FREQUENCY=100000", "RF",
               "*NODE PRINT, NSET=LEAD, FREQUENCY=100000", "U", "*END STEP"]  # fmt: skip
    way = ["*STEP, NLGEOM, INC=1000", "*STATIC", "0.1,1.,1e-5,.2"]
    lines += [*way, *controls, *held, "*BOUNDARY", "END,3,3", *printed]
    for (shift, R), push in zip(poses, force, strict=True):
        moved = centre + shift * MM + R.apply(places[end] - centre) - places[end]
        lines += ["*STEP, NLGEOM, INC=1000", "*STATIC", "1.,1.", *controls, "*BOUNDARY"]
        for node, u in zip(end, moved, strict=True):
            lines += [f"{node + 1},{a},{a},{u[a - 1]:.14g}" for a in (2, 3)]
        for d, u in zip(turned, moved[1:], strict=True):
            lines.append(f"{d + 1},1,1,{u[0] - moved[0, 0]:.14g}")
        lines += ["*CLOAD, OP=NEW", f"{lead + 1},1,{push:.10g}", *printed]
    return "\n".join([*lines, ""])


def _nset(name, nodes):
    rows = (nodes[k : k + 12] + 1 for k in range(0, nodes.size, 12))
    return [f"*NSET, NSET={name}", *(",".join(map(str, row)) + "," for row in rows)]


def solid_blade(case, along):
    """Return motion of the end, force and moment on it, and its 6 × 6 stiffness, by solids."""
    shell = one_blade(case, levels=(0, 12, 16), tolerance=5e-3, made=shells_from_beams)
    motion, _, K = own_stiffness(shell)
    path = np.array(
        [own_stiffness(one_blade(case, share))[0] for share in np.linspace(1 / PATH, 1.0, PATH)]
    )
    mesh = mesh_of(case, along)
    load = np.abs(shell.end_forces[0])
    size = max(load[1], load[5] / LENGTH)
    steps = PUSH * size * np.array([1, 1, 1, LENGTH, LENGTH, LENGTH]) / np.diag(K)
    steps = np.minimum(steps, np.repeat([5e-4, 5e-3], 3))
    turn = Rotation.from_rotvec(motion[3:])
    both = [(i, sign) for i in range(6) for sign in (1.0, -1.0)]
    poses, force = [], []
    for i, sign in both:
        d = sign * steps * (np.arange(6) == i)
        poses.append((motion[:3] + d[:3], Rotation.from_rotvec(d[3:]) * turn))
        force.append(sign * PUSH * size if i == 0 else 0.0)
    printed = run(deck_of(case, mesh, path, poses, force), "blade")
    lead, centre = mesh.places[mesh.end[0]], np.array([LENGTH * MM, 0.0, 0.0])
    loads, ahead = [], []
    for (_, R), forces, moved in zip(
        [(None, turn), *poses], printed.tables("forces"), printed.tables("displacements"),
        strict=True,
    ):  # fmt: skip
        F = np.array([forces[node + 1] for node in mesh.end])
        arms = R.apply(mesh.places[mesh.end] - centre)
        loads.append(np.concatenate([F.sum(0), np.cross(arms, F).sum(0) / MM]))
        swung = R.apply(lead - centre) - (lead - centre)
        ahead.append((moved[mesh.end[0] + 1][0] - swung[0]) / MM)
    change, size = np.zeros((6, 6)), np.diag(steps)
    for i in range(6):
        change[:, i] = (loads[1 + 2 * i] - loads[2 + 2 * i]) / 2.0
        size[0, i] = (ahead[1 + 2 * i] - ahead[2 + 2 * i]) / 2.0
    K = change @ np.linalg.inv(size)
    return np.array([ahead[0], *motion[1:]]), loads[0], (K + K.T) / 2.0


def solid_row(case, meshes=MESHES):
    each = []
    for along in meshes:
        motion, load, K = solid_blade(case, along)
        each.append(np.array([*two_of_them(case, motion, load[:3], K), load[1], load[5]]))
    part = (meshes[0] / meshes[1]) ** ORDER
    whole = each[1] + (each[1] - each[0]) * part / (1.0 - part)
    mesh = float(np.max(np.abs(whole[:5] / each[1][:5] - 1.0)))
    support, drive = whole[:5].tolist(), whole[6 if case.turns else 5]
    return {"case": list(case), "support": support, "drive": float(drive), "mesh": mesh}


def shell_row(case):
    state = at_stroke(case, tolerance=5e-3, levels=SHELL_LEVELS, made=shells_from_beams).checked()
    k, before = supports(state), supports(state.coarser)
    modes = float(np.max(np.abs(before / k - 1.0)))
    return {"case": list(case), "support": k.tolist(), "modes": modes}


def buckling_cases():
    for h in (0.005, 0.01, 0.02):
        for b in (0.1, 0.2, 0.5, 1.0, 1.5):
            yield from ((Case("guide", b, h, s), "push") for s in (0.02, 0.05, 0.1, 0.2))
    for nu in (0.0, 0.45):
        yield from ((Case("guide", b, 0.005, 0.1, nu), "push") for b in (0.2, 0.5, 1.0))
    for b in (0.2, 0.5, 1.0):
        yield Case("cross", b, 0.005, 3.0), "back"
    for b, s in ((0.3, 0.05), (0.3, 0.1), (0.5, 0.05), (0.5, 0.1)):
        yield from ((Case("folded", b, 0.005, s), way) for way in ("push", "pull"))
    for b, h, s in ((0.5, 0.01, 0.15), (0.4, 0.01, 0.2), (0.6, 0.01, 0.2), (0.5, 0.007, 0.2)):
        yield Case("guide", b, h, s), "push"


def buckled_row(case, way, level=14):
    held, frames = held_at_stroke(case)
    layout = mechanism(case)
    beams, (levels, tolerance) = at_stroke(case, tolerance=1e-5), BEAMS.critical
    found = critical_load(
        layout, held, [pushed(case, way)], most=400.0, frames=frames, start=beams, levels=levels,
        tolerance=tolerance,
    )  # fmt: skip
    stands, state = 0.0, at_stroke(
        case, tolerance=5e-3, levels=(0, level), made=shells_from_beams
    ).checked()  # fmt: skip
    for share in (0.5, 0.8, 0.9, 0.94, 0.97, 0.99, 1.0, 1.01, 1.02, 1.04, 1.07, 1.1):
        size = share * found.factor
        state = solve(
            layout, held, loads=[pushed(case, way, size)], frames=frames, start=state,
            levels=(level,), made=shells_from_beams, tolerance=1e-4,
        )  # fmt: skip
        if state.outcome is not Outcome.CONVERGED or state.unstable:
            return {"case": list(case), "way": way, "stands": stands, "falls": size}
        stands = size
    raise ValueError(f"{case} does not buckle")


def told():
    print("over solids, %: beams (least, most), shells, what is told of each")
    for case, row in found("solids"):
        over = []
        for how in ({}, {"levels": (0, 12, 16), "tolerance": 5e-3, "made": shells_from_beams}):
            state = one_blade(case, **how)
            k = two_of_them(case, *own_stiffness(state))
            over.append((state, 100.0 * (k / np.array(row["support"]) - 1.0)))
        (beams, b), (shells, s) = over
        tell = [100.0 * e.support for e in (beam_errors(beams), shell_errors(shells))]
        print(f"{case!s:75} {b.min():6.2f}{b.max():6.2f} {s.min():6.2f}{s.max():6.2f}"
              f" {tell[0]:5.1f}{tell[1]:5.1f}")  # fmt: skip


def main(what):
    if what == "print":
        told()
        return
    rows = {
        "solids": lambda: [
            *(solid_row(c) for c in (*SOLIDS, *NARROW)),
            *(solid_row(c, (12, 18)) for c in (*THICK_OR_WIDE, *NARROWING)),
            *(solid_row(c, (10, 15)) for c in THICKER),
        ],
        "shells": lambda: [shell_row(c) for c in shell_cases()],
        "buckled": lambda: [buckled_row(*c) for c in buckling_cases()],
    }[what]()
    whole = json.loads(FOUND.read_text(encoding="utf-8")) if FOUND.exists() else {}
    whole[what] = rows
    digits = json.dumps(whole, default=float)
    whole = json.loads(digits, parse_float=lambda x: float(f"{float(x):.6g}"))
    FOUND.write_text(json.dumps(whole).replace("}, {", "},\n{") + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
