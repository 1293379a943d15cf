"""Stiffness and stress of pivots whose blades differ by their directions, beside CalculiX's solids.

Run: python tests/benchmarks/uneven_crystals.py [designs] [--first SEED] [--keep FILE]
Prints what is told and by how much solids of the whole anisotropic joint differ, with the errors of
both; FILE gets each as one line (JSON) with what solids found.
"""

import argparse
import json
import sys
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(__file__).parents[1]))

from uneven_crystals import uneven_spec

import flexcli

NUMBERS = ("k_pivot", "sigma")


def main() -> None:
    """Print each number, and how many were within both errors."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", type=int, nargs="?", default=10)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep", type=Path)
    args = parser.parse_args()
    held = compared = 0
    for seed in range(args.first, args.first + args.designs):
        spec = uneven_spec(seed)
        kept = {"spec": spec}
        rows = flexcli.verify(yaml.safe_dump(spec), only=NUMBERS).verification.numbers
        for row in rows:
            if row.solid is None or row.solid_error is None or row.model_error is None:
                print(f"{seed:6} {row.name:8} {row.why[:70]}")
                continue
            compared, held = compared + 1, held + bool(row.agrees)
            kept[row.name] = [row.solid, row.solid_error]
            low, high = row.model_error
            print(
                f"{seed:6} {spec['geometry']['kind']:12} {row.name:8} told {low:+.4f} {high:+.4f},"
                f" solids {row.solid / row.model - 1.0:+.4f} +- {row.solid_error:.4f}"
                f"{'' if row.agrees else '  <-- apart'}",
                flush=True,
            )
        if args.keep and len(kept) == 1 + len(NUMBERS):
            with args.keep.open("a") as file:
                print(json.dumps(kept), file=file)
    print(f"{held} of {compared} within both errors")


if __name__ == "__main__":
    main()
