"""Section forces of beams in space at their clamps, against CalculiX's solids and against shells.

Run: python tests/benchmarks/moments_in_space.py [designs] [--first SEED] [--keep FILE].
Random guides and pivots at a stroke under loads out of the plane (``tests/moments_in_space.py``,
which has some of the numbers). Solids bent by much turn or near what buckles them may fail.
Prints by how much the largest nominal stress of beams differs from that of the forces and moments
by which solids and shells hold their clamps, and the largest difference at any clamp; what is told
besides a corner's warping. FILE gets each as one line (JSON) with what solids found.
"""

import argparse
import json
import sys
from contextlib import suppress
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

sys.path.insert(0, str(Path(__file__).parents[1]))

from moments_in_space import (
    E,
    bent_at,
    drawn,
    largest,
    loads_of,
    nominal,
    section_stresses,
    size_of_loads,
    state_of,
)

from flexcli.engine.joint_models.space_errors import STOUTEST, THICKEST, beam_errors
from flexcli.engine.solid.calculix import run
from flexcli.engine.solid.deck import CONTROLS
from flexcli.engine.solid.deck_model import MM, body_nodes, model_lines
from flexcli.engine.solid.model import solid_model_in_space
from flexcli.errors import SolveError
from flexcli.mechanics.shell.first_guess import shells_from_beams

SHELLS = {"levels": (0, 12, 16), "tolerance": 5e-3, "made": shells_from_beams}
MOST_STRAIN, MOST_TILT, MOST_BRICKS = 0.03, 0.05, 500
"""Of solids that are tried: others take long or do not converge."""


def by_solids(made, loads, fineness):
    """Return the nominal stress at both ends of blades of solids whose stage is held and loaded."""
    layout = made.layout
    model = solid_model_in_space(layout, fineness=fineness)
    if model.elements > MOST_BRICKS:
        return None
    ref, rot = body_nodes(model)["stage"]
    points = {("stage", *load.point[:2]): k for k, load in enumerate(loads)}
    first = 2 + model.nodes + 1
    held = [
        f"{ref}, {k + 1}, {k + 1}, {x * MM:.14g}" if k < 3 else f"{rot}, {k - 2}, {k - 2}, {x:.14g}"
        for k, x in enumerate(made.held) if x is not None
    ]  # fmt: skip
    forces = [
        f"{first + k}, {axis}, {x:.14g}"
        for k, load in enumerate(loads) for axis, x in enumerate(load.force, 1)
    ]  # fmt: skip
    printed = run("\n".join([
        *model_lines(model, body_nodes(model), points),
        "*STEP, NLGEOM, INC=40", "*STATIC", "0.25, 1., 1e-2, 0.5", CONTROLS,
        "*BOUNDARY", *held, "*CLOAD", *forces,
        "*NODE PRINT, NSET=TIED, FREQUENCY=100000", "U",
        "*NODE PRINT, NSET=GROUND, FREQUENCY=100000", "RF", "*END STEP", "",
    ]), "moments")  # fmt: skip
    (moved,), (pushed,) = (list(printed.tables(x)) for x in ("displacements", "forces"))
    turn = Rotation.from_rotvec(moved[rot]).as_matrix()
    point = np.array(layout.bodies[0].point)
    at_starts = []
    for stretch, blade in zip(model.stretches, layout.blades, strict=True):
        axes, start, own = stretch.axes, np.array(blade.start), stretch.bricks.end(0)
        # what the ground does to a blade is the opposite of what acts in its first section
        force = -np.array([pushed[n] for n in own + stretch.first_node + 1])
        moment = np.cross(stretch.places[own] - start, force).sum(axis=0)
        end = moved[ref] / MM + point + turn @ (np.array(blade.end) - point) - start
        at_starts.append(
            (axes @ force.sum(axis=0), axes @ moment, axes @ end, axes @ turn @ axes.T)
        )
    return nominal(layout, *zip(*at_starts, strict=True))


def compared(seed, fineness):
    """Return what beams, shells and solids find of a seed; nothing where it does not stand."""
    made = drawn(seed)
    blade = made.layout.blades[0]
    b, h = blade.b, float(blade.profile.h)
    try:
        size = size_of_loads(made)
        if size is None:
            return None
        state = state_of(made, size, tolerance=1e-6)
    except SolveError:
        return None
    beams, known = section_stresses(state), beam_errors(state)
    if known is None or largest(beams) > MOST_STRAIN * E:
        return None
    bent = bent_at(made, size)
    row = {
        "seed": seed, "size": size, "b": b / 0.1, "h": h / 0.1, "nu": blade.material.nu,
        "strain": largest(beams) / E, "told": known.stress_of(bent), "beams": beams.tolist(),
    }  # fmt: skip
    if h < THICKEST * 0.1 and h < STOUTEST * b:
        with suppress(SolveError):
            row["shells"] = section_stresses(state_of(made, size, **SHELLS)).tolist()
    turned = state.motion_of("stage", made.layout.bodies[0].point)[3:]
    if fineness and np.linalg.norm(turned[:2]) < MOST_TILT:
        try:
            found = by_solids(made, loads_of(made, size), fineness)
            row |= {} if found is None else {"solids": found.tolist()}
        except SolveError as error:
            row["why"] = str(error)
    return row


def off(beams, other):
    """Return by what the largest stress differs, and the most at any clamp, over the largest."""
    beams, other = np.array(beams), np.array(other)
    return largest(beams) / largest(other) - 1.0, largest(beams - other) / largest(other)


def main():
    """Print each mechanism."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", type=int, nargs="?", default=30)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--fineness", type=int, default=1, help="of solids; 0 for shells alone")
    parser.add_argument("--keep", type=Path)
    args = parser.parse_args()
    for seed in range(args.first, args.first + args.designs):
        row = compared(seed, args.fineness)
        if row is None:
            continue
        told = row["told"] + row["strain"]
        said = f"{seed:5} b/l {row['b']:.3f} h/l {row['h']:.4f} ν {row['nu']:.2f} told {told:.4f}"
        for what in ("shells", "solids"):
            if what in row:
                whole, most = off(row["beams"], row[what])
                mark = "  <-- beyond it" if abs(whole) > told else ""
                said += f"; over {what} {whole:+.4f}, clamps {most:.4f}{mark}"
        print(said, flush=True)
        if args.keep:
            with args.keep.open("a") as file:
                file.write(json.dumps(row) + "\n")


if __name__ == "__main__":
    main()
