"""Blades that are one piece where they cross: what their crossing gives way beside beams.

Run by hand: python tests/benchmarks/plane_crossing.py
It writes tests/formulas/plane_crossing.json in some minutes: for each half-angle [deg] the terms
of the compliance of a crossing in a plane, less that of Timoshenko's beams that meet in a point, at
ν = 0 and 0.3, in units of E, h and b: of moments, moments with shear, shear, the shear of both
sides, and what stretches blades with the shear. Elements of high order on a mesh that is graded
towards the four corners; what acts on the ends of the arms is distributed as in beams. Of whole
joints between rigid ends, tests/parts/plane_shifts.json: the shift along the bisector over that of
thin beams; and tests/parts/plane_joints.json, of halves that hardly reach beyond the crossing: the
stiffness over 8 E I/l, and the motion across the bisector over the rotation and l; and
tests/parts/plane_deflections.json: motions along and across the bisector by forces, times E b.
"""

import json
import sys
from itertools import pairwise
from math import cos, radians, sin, tan
from pathlib import Path

import numpy as np
from scipy import sparse
from scipy.sparse.linalg import splu
from scipy.spatial import cKDTree

from flexcli.mechanics.solids.lagrange import element

FOUND = Path(__file__).parents[1] / "formulas/plane_crossing.json"
ANGLES = (5.0, 6.0, 7.0, 8.5, 10.0, 12.0, 15.0, 20.0, 25.0, 30.0, 35.0, 40.0, 45.0, 50.0, 55.0,
          60.0, 65.0, 70.0, 75.0, 78.0, 80.0, 81.5, 83.0, 84.0, 85.0)  # fmt: skip
JOINTS = (
    (0.0534, 0.355, 67.8, 0.3), (0.00476, 0.323, 36.4, 0.0), (0.00463, 0.5, 11.6, 0.0),
    (0.00851, 0.492, 40.2, 0.3), (0.0719, 0.318, 70.5, 0.3), (0.0353, 0.367, 12.5, 0.3),
    (0.00958, 0.219, 73.1, 0.3), (0.0658, 0.469, 24.8, 0.45), (0.0663, 0.412, 9.37, 0.45),
    (0.0202, 0.261, 40.3, 0.0), (0.0114, 0.295, 67.7, 0.0), (0.0379, 0.44, 41.2, 0.0),
    (0.00854, 0.44, 31.7, 0.3), (0.0204, 0.204, 25.5, 0.3),
)  # fmt: skip
"""Random joints, none of them used for a fit: h/l, crossing, half-angle [deg], ν."""

SHORT = (
    (0.2965, 0.4572, 22.19, 0.3), (0.3253, 0.3211, 41.62, 0.45), (0.1110, 0.3450, 79.31, 0.3),
    (0.2359, 0.3194, 59.19, 0.0), (0.2633, 0.4414, 66.25, 0.3), (0.2284, 0.4252, 23.12, 0.0),
    (0.0802, 0.3259, 8.367, 0.3), (0.1294, 0.2953, 20.24, 0.0), (0.1583, 0.3645, 69.25, 0.45),
    (0.2491, 0.4264, 45.74, 0.3), (0.1283, 0.2590, 33.30, 0.3), (0.1902, 0.4752, 65.48, 0.3),
    (0.1712, 0.4425, 23.88, 0.45), (0.0926, 0.2428, 45.87, 0.3), (0.0354, 0.2300, 52.0, 0.0),
    (0.0200, 0.3500, 15.0, 0.3),
)  # fmt: skip
"""Joints, the last two but short, none used for a fit: h/l, crossing, half-angle [deg], ν."""

DEFLECTED = (
    (0.08, 0.35, 70.0), (0.03, 0.3, 45.0), (0.03, 0.4, 75.0), (0.06, 0.4, 15.0), (0.05, 0.2, 60.0),
)  # fmt: skip
"""Joints of ν = 0: h/l, crossing, half-angle [deg]."""

MOVED = Path(__file__).parents[1] / "parts/plane_deflections.json"
STIFF = Path(__file__).parents[1] / "parts/plane_joints.json"
SHIFTS = Path(__file__).parents[1] / "parts/plane_shifts.json"
NUS = 0.0, 0.3
ORDER = 5
SMALLEST, RATIO = 1e-4, 0.2
"""Elements at the corners, over the thickness, and how much smaller each is than the next."""

REACH = 3.0
"""Length of the arms beyond the crossing, over the thickness: what is uneven has faded there."""


def cuts(total, longest):
    """Return where elements end from a corner on."""
    found = [0.0, SMALLEST]
    while found[-1] / RATIO < min(total, longest):
        found.append(found[-1] / RATIO)
    rest = max(1, int(np.ceil((total - found[-1]) / longest)))
    return np.array([*found, *(found[-1] + (total - found[-1]) / rest * np.arange(1, rest + 1))])


def quadrangles(angle, reaches, longest=0.6):
    """Return the corners of the elements at h = 1 of arms that reach that far, base and body."""
    along = [np.array([cos(a), sin(a)]) for a in (angle, -angle)]
    across = [np.array([-v[1], v[0]]) for v in along]
    half = cuts(1.0, 0.5)
    lines = np.concatenate([half - 1.0, 1.0 - half[-2::-1]])

    def corner(p, q):
        return np.linalg.solve(np.array(across), np.array([p, q]) / 2.0)

    found = [
        [corner(p, q), corner(p_, q), corner(p_, q_), corner(p, q_)]
        for p, p_ in pairwise(lines)
        for q, q_ in pairwise(lines)
    ]
    for k in (0, 1):
        for side, reach in zip((-1.0, 1.0), reaches, strict=True):
            face = np.sign(across[1 - k] @ along[k]) * side

            def place(p, s, k=k, side=side, face=face, reach=reach):
                root = corner(p, face) if k == 0 else corner(face, p)
                return (1.0 - s) * root + s * (side * reach * along[k] + p / 2.0 * across[k])

            ends = cuts(reach, longest) / reach
            found += [
                [place(p, s), place(p, s_), place(p_, s_), place(p_, s)]
                for p, p_ in pairwise(lines)
                for s, s_ in pairwise(ends)
            ]
    quads = np.array(found)
    x, y = quads[..., 0], quads[..., 1]
    turned = np.sum(x * np.roll(y, -1, axis=1) - y * np.roll(x, -1, axis=1), axis=1) < 0.0
    quads[turned] = quads[turned, ::-1]
    return quads


def bilinear(u, v):
    """Return the functions of the corners of a quadrangle and their slopes."""
    values = np.stack([(1 - u) * (1 - v), (1 + u) * (1 - v), (1 + u) * (1 + v), (1 - u) * (1 + v)])
    du = np.stack([-(1 - v), 1 - v, 1 + v, -(1 + v)])
    dv = np.stack([-(1 - u), -(1 + u), 1 + u, 1 - u])
    return values / 4.0, du / 4.0, dv / 4.0


def law(nu):
    """Return the law of plane stress at E = 1."""
    return np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]]) / (1 - nu**2)


class Crossing:
    """Four arms of thickness 1, their nodes and their elements."""

    def __init__(self, degrees):
        self.angle = radians(degrees)
        self.reach = max(tan(self.angle), 1.0 / tan(self.angle)) / 2.0 + REACH
        self.mesh((self.reach, self.reach), 0.6)

    def mesh(self, reaches, longest):
        """Find the nodes of arms that reach that far, and those of each element."""
        self.reaches = reaches
        self.quads = quadrangles(self.angle, reaches, longest)
        one = element(ORDER)
        values, *_ = bilinear(*np.meshgrid(one.nodes, one.nodes, indexing="ij"))
        places = np.einsum("cij,ecd->eijd", values, self.quads).reshape(-1, 2)
        pairs = cKDTree(places).query_pairs(1e-3 * SMALLEST, output_type="ndarray")
        size = len(places)
        touch = sparse.coo_matrix((np.ones(len(pairs)), pairs.T), shape=(size, size))
        count, label = sparse.csgraph.connected_components(touch, directed=False)
        self.places = np.zeros((count, 2))
        self.places[label] = places
        self.nodes = label.reshape(len(self.quads), -1)

    def slopes(self):
        """Return the weights of Gauss's points and the slopes of each element's functions there."""
        one = element(ORDER)
        _, gauss = np.polynomial.legendre.leggauss(len(one.weights))[::-1]
        u, v = np.meshgrid(gauss, gauss, indexing="ij")
        _, du, dv = bilinear(u, v)
        J = np.stack([np.einsum("cij,ecd->eijd", d, self.quads) for d in (du, dv)], -1)
        weight = np.outer(one.weights, one.weights) * np.linalg.det(J)
        n = (ORDER + 1) ** 2
        along = np.einsum("im,jk->ijmk", one.slopes, one.values).reshape(*u.shape, n)
        over = np.einsum("im,jk->ijmk", one.values, one.slopes).reshape(*u.shape, n)
        found = np.einsum("aijp,eijad->eijpd", np.stack([along, over]), np.linalg.inv(J))
        count = len(self.quads)
        return weight.reshape(count, -1), found.reshape(count, -1, n, 2)

    def stiffness(self, nu):
        """Return the matrix of plane stress at E = 1."""
        weight, slopes = self.slopes()
        count, points, n, _ = slopes.shape
        B = np.zeros((count, points, 3, n, 2))
        B[..., 0, :, 0] = B[..., 2, :, 1] = slopes[..., 0]
        B[..., 1, :, 1] = B[..., 2, :, 0] = slopes[..., 1]
        root = np.linalg.cholesky(law(nu)).T
        sides = np.sqrt(weight)[..., None, None] * (root @ B.reshape(count, points, 3, 2 * n))
        sides = sides.reshape(count, -1, 2 * n)
        K = sides.transpose(0, 2, 1) @ sides
        dof = (2 * self.nodes[..., None] + np.arange(2)).reshape(count, -1)
        rows, columns = np.repeat(dof, 2 * n, axis=1), np.tile(dof, (1, 2 * n))
        size = 2 * len(self.places)
        return sparse.coo_matrix((K.ravel(), (rows.ravel(), columns.ravel())), (size,) * 2).tocsc()

    def arms(self):
        """Yield the sense of each arm (stage 1, base -1), its direction, nodes and their places."""
        for a in (self.angle, -self.angle):
            for side, reach in zip((-1.0, 1.0), self.reaches, strict=True):
                d = side * np.array([cos(a), sin(a)])
                there = np.flatnonzero(np.abs(self.places @ d - reach) < 1e-9 * reach)
                across = self.places[there] @ np.array([-d[1], d[0]])
                there = there[np.abs(across) < 0.6]
                across = self.places[there] @ np.array([-d[1], d[0]])
                order = np.argsort(across)
                yield side, d, there[order], across[order]

    def loads(self):
        """Return the forces of unit moments, of unit shear on either side, of a pull (dof, 4).

        The pull is on one blade, and the other is pushed as much.
        """
        forces = np.zeros((2 * len(self.places), 4))
        one = element(ORDER)
        _, gauss = np.polynomial.legendre.leggauss(len(one.weights))[::-1]
        pull = -1.0 / tan(self.angle)
        for side, d, nodes, places in self.arms():
            n = np.array([-d[1], d[0]])
            sense = np.sign(d[1] * side)  # of the arms at +α and −α
            for k in range(0, len(nodes) - 1, ORDER):
                low, high = places[k], places[k + ORDER]
                y = (low + high) / 2.0 + gauss * (high - low) / 2.0
                weight = one.weights * (high - low) / 2.0
                bend, shear = -12.0 * y, 1.5 * (1.0 - 4.0 * y**2)
                axial = pull * sense
                each = {
                    0: side * bend[:, None] * d,
                    (1 if side > 0 else 2): shear[:, None] * n
                    + (axial - self.reach * bend)[:, None] * d,
                    3: np.full((len(y), 1), sense) * d,
                }
                for load, traction in each.items():
                    part = one.values.T @ (weight[:, None] * traction)
                    at = nodes[k : k + ORDER + 1]
                    np.add.at(forces[:, load], 2 * at, part[:, 0])
                    np.add.at(forces[:, load], 2 * at + 1, part[:, 1])
        return forces

    def compliance(self, nu):
        """Return twice the energy of the loads, in pairs (4, 4)."""
        forces = self.loads()
        x, y = self.places.T
        turn = np.stack([-y, x], 1).ravel()
        off = np.array([forces[0::2].sum(0), forces[1::2].sum(0), turn @ forces])
        assert np.abs(off).max() < 1e-8, off
        fixed = [
            0,
            1,
            2 * int(np.argmax(np.hypot(x - x[0], y - y[0])))
            + int(abs(x - x[0]).max() > abs(y - y[0]).max()),
        ]
        free = np.setdiff1d(np.arange(2 * len(x)), fixed)
        K = self.stiffness(nu)[free][:, free].tocsc()
        solver = splu(K)
        moved = solver.solve(forces[free])
        moved += solver.solve(forces[free] - K @ moved)
        return forces[free].T @ moved

    def beams(self, nu):
        """Return the same of Timoshenko's beams that meet in a point."""
        l, EI = self.reach, 1.0 / 12.0
        own = l**3 / 3.0 / EI + 1.2 * l * 2.0 * (1.0 + nu) + l / tan(self.angle) ** 2
        mixed = -(l**2) / 2.0 / EI
        pulled = -l / tan(self.angle)
        return 2.0 * np.array([
            [2.0 * l / EI, mixed, -mixed, 0.0], [mixed, own, 0.0, pulled],
            [-mixed, 0.0, own, pulled], [0.0, pulled, pulled, 2.0 * l],
        ])  # fmt: skip


class Joint(Crossing):
    """Four arms that reach as far as their blades do, between rigid bodies."""

    def __init__(self, degrees, h, crossing):
        self.angle = radians(degrees)
        self.mesh((crossing / h, (1.0 - crossing) / h), 2.0)

    def held(self, nu):
        """Return the stiffness, and the body's nodes, their motions with it, and its own stiffness.

        The motions are along x, y and about the centre.
        """
        K, count = self.stiffness(nu), len(self.places)
        body = np.unique(np.concatenate([n for side, _, n, _ in self.arms() if side > 0.0]))
        base = np.unique(np.concatenate([n for side, _, n, _ in self.arms() if side < 0.0]))
        inner = np.setdiff1d(np.arange(count), np.concatenate([body, base]))
        free = (2 * inner[:, None] + np.arange(2)).ravel()
        held = (2 * body[:, None] + np.arange(2)).ravel()
        x, y = self.places[body].T
        moves = np.zeros((2 * count, 3))
        moves[2 * body, 0] = moves[2 * body + 1, 1] = 1.0
        moves[2 * body, 2], moves[2 * body + 1, 2] = -y, x
        moves[free] = splu(K[free][:, free].tocsc()).solve(-(K @ moves)[free])
        return K, body, moves, moves[held].T @ (K @ moves)[held]

    def turn(self, nu):
        """Return the stiffness in rotation over 8 E I/l, and the motion across over that and l."""
        *_, reacts = self.held(nu)
        given = np.append(np.linalg.solve(reacts[:2, :2], -reacts[:2, 2]), 1.0)
        l = sum(self.reaches)
        return 1.5 * l * reacts[2] @ given, given[1] / l

    def shift(self, nu):
        """Return the shift along the bisector over the square of a small rotation, and h.

        By the work of a unit force along it, on the strains of second order of the rotation that
        the linear one makes, St. Venant's and Kirchhoff's material.
        """
        K, body, moves, reacts = self.held(nu)
        x, y = self.places[body].T
        given = np.append(np.linalg.solve(reacts[:2, :2], -reacts[:2, 2]), 1.0)
        turned = moves @ given
        pushed = moves[:, :2] @ np.linalg.solve(reacts[:2, :2], [1.0, 0.0])
        radius = np.zeros(len(moves))
        radius[2 * body], radius[2 * body + 1] = x, y
        weight, slopes = self.slopes()
        by_turn, by_push = (
            np.einsum("egpd,epc->egcd", slopes, u.reshape(-1, 2)[self.nodes])
            for u in (turned, pushed)
        )

        def stress(slope):
            strain = slope[..., 0, 0], slope[..., 1, 1], slope[..., 0, 1] + slope[..., 1, 0]
            sx, sy, sxy = np.moveaxis(np.stack(strain, -1) @ law(nu), -1, 0)
            return np.stack([np.stack([sx, sxy], -1), np.stack([sxy, sy], -1)], -2)

        second = np.einsum("eg,egab,egca,egcb->", weight, stress(by_push), by_turn, by_turn)
        mixed = np.einsum("eg,egab,egca,egcb->", weight, stress(by_turn), by_turn, by_push)
        return second / 2.0 + mixed - radius @ (K @ pushed) / 2.0


def main():
    rows = []
    for degrees in ANGLES:
        joint = Crossing(degrees)
        both = [joint.compliance(nu) - joint.beams(nu) for nu in NUS]
        terms = ((0, 0), (0, 1), (1, 1), (1, 2), (1, 3))
        rows.append([degrees, *(float(f"{c[at]:.6g}") for c in both for at in terms)])
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    write(FOUND, rows)
    rows = []
    for h, crossing, degrees, nu in JOINTS:
        beams = (crossing**3 + (1.0 - crossing) ** 3) / 15.0 / cos(radians(degrees))
        ratio = Joint(degrees, h, crossing).shift(nu) * h / beams
        rows.append([h, crossing, degrees, nu, float(f"{ratio:.6g}")])
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    write(SHIFTS, rows)
    rows = []
    for h, crossing, degrees, nu in SHORT:
        found = Joint(degrees, h, crossing).turn(nu)
        rows.append([h, crossing, degrees, nu, *(float(f"{each:.6g}") for each in found)])
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    write(STIFF, rows)
    rows = []
    for h, crossing, degrees in DEFLECTED:
        *_, reacts = Joint(degrees, h, crossing).held(0.0)
        rows.append([h, crossing, degrees, *np.linalg.inv(reacts).diagonal()[:2].round(4)])
        sys.stderr.write(f"{json.dumps(rows[-1])}\n")
    write(MOVED, rows)


def write(path, rows):
    path.write_text("[\n" + ",\n".join(map(json.dumps, rows)) + "\n]\n", encoding="utf-8")


if __name__ == "__main__":
    main()
