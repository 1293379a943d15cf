"""What a stroke changes in compliances: by how much beams are off shells, in every direction.

Run: python tests/benchmarks/changes_at_stroke.py [cases] [--first SEED]. Random guides and pivots
at rest and at a stroke, by beams and by thin shells, in their plane and across it. Prints the
largest change by beams over the compliance at rest, by how much the shells' change differs from it,
and what of that is left beside ``STROKE_ERROR`` of the change in each direction itself: the most
of it, as a share of the largest change, is to be below ``ASTRAY``.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from blades_at_stroke import Case, off_in_changes

from flexcli.engine.joint_models.space_deflection import ASTRAY, STROKE_ERROR
from flexcli.errors import SolveError

LEAST = 1e-5
"""Change below which shells and beams differ by rounding."""


def drawn(rng):
    """Return a random case: a guide moves by a share of its length, a pivot by degrees."""
    kind = str(rng.choice(["guide", "cross", "remote"]))
    b, h = 10.0 ** rng.uniform(-1.0, 0.3), 10.0 ** rng.uniform(-2.6, -1.4)
    stroke, nu = 10.0 ** rng.uniform(-4.0, -1.0), float(rng.choice([0.3, 0.3, 0.45, 0.0]))
    return Case(
        kind, b, min(h, b / 5.0), float(stroke if kind == "guide" else np.rad2deg(stroke)), nu
    )


def main():
    """Print the cases and the worst of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("cases", type=int, nargs="?", default=60)
    parser.add_argument("--first", type=int, default=0)
    args, worst = parser.parse_args(), 0.0
    for seed in range(args.first, args.first + args.cases):
        case = drawn(np.random.default_rng(seed))
        try:
            found = list(off_in_changes(case, STROKE_ERROR))
        except SolveError as error:
            print(f"{case}: {error}")
            continue
        row = " | ".join(f"{a:9.3g} off {b / a:6.3f} left {c / a:6.3f}" for a, b, c in found)
        print(f"{case.kind:7}{case.b:6.2f}{case.h:8.4f}{case.stroke:10.4g}{case.nu:6.2f} {row}")
        worst = max(worst, *(c / a for a, _, c in found if a > LEAST), 0.0)
    print(f"at most {worst:.3f} of the largest change is left, of {ASTRAY} that are told")


if __name__ == "__main__":
    main()
