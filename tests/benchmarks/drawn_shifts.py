"""Shift of random drawn layouts of wide blades: what plates change of it, against thin shells.

Run: python tests/benchmarks/drawn_shifts.py [designs] [--first SEED] [--kinds KIND …]. Prints what
shells leave their path by more than beams do, what is told of that, and how many were within its
error.
"""

import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from drawn_layouts import KINDS, drawn_layout

from flexcli.errors import SolveError


def main():
    """Print each design of each kind, and how many were told rightly."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", type=int, nargs="?", default=40)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*", default=KINDS)
    args = parser.parse_args()
    for kind in args.kinds:
        held, errors = 0, []
        for seed in range(args.first, args.first + args.designs):
            drawn = drawn_layout(seed, kind)
            told = drawn.told()
            if told is None:
                continue
            try:
                beams, shells = drawn.shifts()
            except SolveError as error:
                print(f"{kind:9} {seed:6} {str(error)[:60]}")
                continue
            value, error = told
            off = shells / beams - 1.0 - value
            held, errors = held + (abs(off) <= error), [*errors, error]
            mark = "" if abs(off) <= error else "  <-- beyond its error"
            print(f"{kind:9} {seed:6} told {value:+.4f} +- {error:.4f}, shells {off:+.4f}{mark}")
        middle = sorted(errors)[len(errors) // 2] if errors else float("nan")
        print(f"{kind}: {held} of {len(errors)} within their errors, in the middle {middle:.4f}")


if __name__ == "__main__":
    main()
