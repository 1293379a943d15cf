"""Joints of the plane against themselves drawn in space: both claim the same truth.

Run: python tests/benchmarks/space_twins.py [specs] [--first SEED] [--kinds KIND …].
Random specs of the campaign, of joints of plain blades that nothing but these holds, are drawn anew
as a space-layout, whose bodies have all six freedoms, and judged with easy requirements by the
exact model as they are and as they are drawn. What models of the plane hold still, a body that
tilts or moves out of it, is free there: a check of which the two ranges lie apart has a wrong one.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from twins.drawn_in_space import JOINTS, apart


def main() -> None:
    """Print the checks of which the two ranges lie apart, and how many were compared."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("specs", type=int, nargs="?", default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*")
    asked = parser.parse_args()
    compared = drawn = 0
    for seed in range(asked.first, asked.first + asked.specs):
        found = apart(seed, tuple(asked.kinds or JOINTS))
        if found is None:
            continue
        drawn, compared = drawn + 1, compared + found.compared
        for line in found.apart:
            print(line, flush=True)
    print(f"{drawn} specs drawn in space, {compared} checks compared")


if __name__ == "__main__":
    main()
