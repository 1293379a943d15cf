"""Parallelogram flexure under 1547 loads: linear, BCM, pseudo-rigid-body, elastica, exact.

The loads and the stage are those of Su & Servey's model stack (2026, github.com/haijunsu-osu/
parallelogram_model_comparison): l = 250 mm, h = 5 mm, b = 50 mm, 150 mm between the blades. Run

    OMP_NUM_THREADS=1 python tests/benchmarks/parallelogram_models.py [MASTER.csv]

With ``comparison/preset_data/PARALLOGRAM_ALL_MODELS_master.csv`` of that repository its rows are
put beside ours. The reference is our exact solution of extensible, shearable blades; for finite
elements, that with the plate factor of such blades. Errors of u_y and u_x are relative, those of
φ absolute [rad]; rows without a transverse load are left out.
"""

import csv
import sys
from itertools import product
from time import perf_counter

import numpy as np
from scipy.integrate import solve_bvp

from flexcli.formulas.plate_factors import guided_factor
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.mesh import Effects

E, NU, L, H, B = 210e9, 0.3, 250e-3, 5e-3, 50e-3
W = 0.3
"""Half the distance between the blades over their length."""
UNIT = E * B * H**3 / 12.0 / L**2
"""EI/l² [N]."""

AY = (0.0, 0.5, *range(1, 11), *range(12, 21, 2))
AX = (-10, *range(-5, 6), 10)
MOMENTS = range(-3, 4)
LOADS = np.array(list(product(AY, AX, MOMENTS)), dtype=float)

SLENDER = Effects(extension=False, shear=False)

GAMMA, SPRING = 0.8517, 2.65
"""Characteristic radius and stiffness of Howell (2001), Compliant Mechanisms, chapter 5."""

PUBLISHED = ("linear", "bcm", "prb", "prb_opt", "guided", "euler", "fea2d", "fea3d")


def linear(ax, ay, m):
    """Return (u_x, u_y, φ) of straight blades that only bend."""
    return 0.0 * ax, ay / 24.0, 0.0 * m


def beam_constraint(ax, ay, m):
    """Return those of Awtar, Slocum & Sevincer (2007), whose range is a tenth of the length."""
    t = H / L
    y = ay / (24.0 + 1.2 * ax)
    x = ax * t**2 / 24.0 - 0.6 * y**2 + ax * y**2 / 1400.0
    return x, y, (t**2 / 12.0 + y**2 / 700.0) * (m + y * (12.0 + 0.1 * ax)) / (2.0 * W**2)


def pseudo_rigid(ax, ay, m, stiffness=2.0 * GAMMA * SPRING, gamma=GAMMA):
    """Return those of rigid links γl with two springs each, which are 2γK_Θ EI/l of guided ends.

    The axial force turns the links as well: 4 k Θ = γ (a_y cos Θ − a_x sin Θ).
    """
    turn = np.zeros_like(ay)
    for _ in range(100):
        pull = ay * np.cos(turn) - ax * np.sin(turn)
        slope = -ay * np.sin(turn) - ax * np.cos(turn)
        turn = turn - (4.0 * stiffness * turn - gamma * pull) / (4.0 * stiffness - gamma * slope)
    return gamma * (np.cos(turn) - 1.0), gamma * np.sin(turn), 0.0 * m


def exact(ax, ay, m, effects=None, factor=1.0):
    """Return those of our exact model, blades stiffer by a factor."""
    blades = tuple(
        Blade(name, "ground", "stage", (0.0, s * W * L), (L, s * W * L), Constant(H), B)
        for name, s in (("upper", 1.0), ("lower", -1.0))
    )
    stage = Layout((Body("stage", (L, 0.0)),), blades, factor * E, factor * E / (2.0 + 2.0 * NU))
    load = Load("stage", (L, 0.0), (ax * UNIT, ay * UNIT), m * UNIT * L)
    found = solve(stage, loads=[load], effects=effects)
    assert found.converged.all()
    assert not found.unstable.any()
    x, y, phi = found.motions[:, 0].T
    return x / L, y / L, phi


def elastica(ax, ay, m):
    """Return those of two inextensible blades by SciPy's collocation, one load at a time."""
    side = np.array([W, -W])

    def rates(s, z, p):
        n = np.array([[p[0], p[1]], [ax - p[0], ay - p[1]]])
        each = z.reshape(2, 4, -1)
        return np.concatenate(
            [
                [np.cos(t), np.sin(t), k, f[0] * np.sin(t) - f[1] * np.cos(t)]
                for (_, _, t, k), f in zip(each, n, strict=True)
            ]
        )

    def ends(first, last, p):
        one, two = last.reshape(2, 4)
        fixed = first.reshape(2, 4)[:, :3].ravel()
        phi = one[2]
        arms = [side[i] * np.array([-np.sin(phi), np.cos(phi)]) for i in (0, 1)]
        n = [(p[0], p[1]), (ax - p[0], ay - p[1])]
        moment = sum(a[0] * f[1] - a[1] * f[0] for a, f in zip(arms, n, strict=True))
        apart = one[:2] - two[:2] - (arms[0] - arms[1] - [0.0, 2.0 * W])
        return np.array([*fixed, one[2] - two[2], *apart, one[3] + two[3] + moment - m])

    s = np.linspace(0.0, 1.0, 21)
    y = ay / 24.0
    straight = [s, y * s**2 * (3 - 2 * s), 6 * y * s * (1 - s), 6 * y * (1 - 2 * s)]
    found = solve_bvp(
        rates, ends, s, np.array(straight * 2), p=[ax / 2 - y, ay / 2], tol=1e-8, max_nodes=20_000
    )
    if not found.success:
        return np.nan, np.nan, np.nan
    one, two = found.y[:, -1].reshape(2, 4)
    return (one[0] + two[0]) / 2 - 1.0, (one[1] + two[1]) / 2, one[2]


def one_by_one(model):
    """Return a model of single loads over all of them."""
    return lambda *loads: np.array([model(*load) for load in zip(*loads, strict=True)]).T


def timed(model, *loads):
    """Return the answers, and the seconds a load."""
    begun = perf_counter()
    found = model(*loads)
    return np.array(np.broadcast_arrays(*found)), (perf_counter() - begun) / len(loads[0])


def row(name, found, reference, used, seconds):
    """Print how far a model is off."""
    there = used & np.isfinite(found[1])
    with np.errstate(invalid="ignore", divide="ignore"):
        y, x = (np.abs(found[i] / reference[i] - 1.0)[there] for i in (1, 0))
    phi = np.abs(found[2] - reference[2])[there]
    rows = f"{there.sum():5d}"
    print(
        f"{name:34} {rows} {np.median(y):9.1e} {y.max():9.1e} {np.median(x):9.1e} "
        f"{np.median(phi):9.1e} {1e6 * seconds:12.1f}"
    )


def main():
    """Print the tables."""
    ay, ax, m = LOADS.T
    loads = ax, ay, m
    reference, seconds = timed(exact, *loads)
    slender, seconds_slender = timed(lambda *of: exact(*of, SLENDER), *loads)
    factor = float(guided_factor(b=B, l=L, h=H, poisson_ratio=NU))
    plate, _ = timed(lambda *of: exact(*of, factor=factor), *loads)
    bent = ay > 0.0
    near = bent & (np.abs(reference[1]) <= 0.1)
    print(
        f"{'model':34} {'loads':>5} {'u_y':>9} {'largest':>9} {'u_x':>9} {'φ':>9} {'µs a load':>12}"
    )
    for title, used in (("all loads", bent), ("u_y up to l/10", near)):
        print(title)
        for name, model in (
            ("linear", linear),
            ("beam constraint model", beam_constraint),
            ("pseudo-rigid-body", pseudo_rigid),
            ("pseudo-rigid-body, springs 2K_Θ", lambda *of: pseudo_rigid(*of, 2.0 * SPRING)),
        ):
            row(name, *_first(timed(model, *loads), reference, used))
        row("ours, inextensible", slender, reference, used, seconds_slender)
        row("ours (the reference)", reference, reference, used, seconds)
    some = np.flatnonzero(bent)[:: len(ay) // 40]
    found, seconds = timed(one_by_one(elastica), *(of[some] for of in loads))
    row("SciPy's elastica beside ours", found, slender[:, some], np.full(some.size, True), seconds)
    if len(sys.argv) > 1:
        published(sys.argv[1], reference, slender, plate)


def _first(answer, reference, used):
    found, seconds = answer
    return found, reference, used, seconds


def published(path, reference, slender, plate):
    """Print the published rows beside ours, and those that are wrong."""
    with open(path, encoding="utf-8", newline="") as stream:
        table = {
            tuple(float(line[k]) for k in ("Ay", "Ax", "B")): line
            for line in csv.DictReader(stream)
        }
    lines = [table[tuple(load)] for load in LOADS]
    ay, _, m = LOADS.T
    print("published rows; solid and beam elements beside ours with the plate factor")
    columns = {}
    for name in PUBLISHED:
        found = np.array([[float(of[f"{k}_{name}"]) for of in lines] for k in ("ux", "uy", "phi")])
        seconds = np.median([float(of[f"t_{name}"]) for of in lines])
        ours = slender if name in ("euler", "guided") else plate if "fea" in name else reference
        row(name, found, ours, ay > 0.0, seconds)
        columns[name] = found
    print("without an answer:", {n: int(np.isnan(c[1]).sum()) for n, c in columns.items()})
    flat = columns["fea2d"]
    print("beam elements more than 10 % off, (a_y, a_x, m) and (u_y, φ):")
    for i in np.flatnonzero((ay > 0.0) & (np.abs(flat[1] - plate[1]) > 0.1 * np.abs(plate[1]))):
        print(*LOADS[i], *np.round(flat[1:, i], 4), "ours", *np.round(plate[1:, i], 4))
    solid = columns["fea3d"]
    at = {tuple(load): i for i, load in enumerate(LOADS)}
    mirror = np.array([at[y, x, -b] for y, x, b in LOADS])
    same = (m < 0.0) & (ay > 0.0) & (solid[1] == solid[1, mirror]) & (solid[2] == solid[2, mirror])
    print(f"solids under m < 0 with the digits of the row of m > 0: {same.sum()}")
    right = (ay > 0.0) & ~same
    row("fea3d without those", solid, plate, right, 0.0)
    lines = np.flatnonzero(same)
    row(
        "fea3d of those beside ours of −m",
        solid[:, lines],
        plate[:, mirror[lines]],
        ay[lines] > 0,
        0.0,
    )


if __name__ == "__main__":
    main()
