"""Blades that curvature flattens beside their clamps: what their moments rise by, against shells.

Run: python tests/benchmarks/flattened_blades.py [blades] [--first SEED]. Prints what random blades'
moments rise by more than beams' at a travel, by thin shells, and the range that is told of it.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from flattened_blades import drawn, risen, told

from flexcli.errors import SolveError

ROUNDING = 2e-4
"""What shells are off by the number of their modes."""


def main():
    """Print the blades, and how many were told rightly."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("blades", type=int, nargs="?", default=100)
    parser.add_argument("--first", type=int, default=0)
    args, held, count, width, most = parser.parse_args(), 0, 0, 0.0, 0.0
    for seed in range(args.first, args.first + args.blades):
        kind, travel, sizes = drawn(np.random.default_rng(seed))
        try:
            rise = risen(kind, travel, **sizes)
        except SolveError:
            continue
        change = told(kind, travel, **sizes)
        right = abs(rise - change.value) <= change.error + ROUNDING
        held, count, width = held + right, count + 1, max(width, change.error)
        most = max(most, rise)
        numbers = " ".join(f"{name} {size:.4g}" for name, size in sizes.items())
        print(f"{kind:13} {travel:8.4f} {numbers:44} rises {rise:8.4f}, told {change.value:8.4f}"
              f" +- {change.error:.4f}{'' if right else '  <-- beyond'}")  # fmt: skip
    print(f"{held} of {count} within their ranges, at most +- {width:.4f}; they rise by {most:.4f}")


if __name__ == "__main__":
    main()
