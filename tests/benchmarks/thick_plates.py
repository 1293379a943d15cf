"""Thick wide blades: the fitted factors beside solids of bricks, drawn at random.

Run by hand: python tests/benchmarks/thick_plates.py [--cases 40] [--seed 1]
Prints what is left of each over its error, positive where solids are stiffer.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from plates.thick_block import factors

from flexcli.formulas.thick_plates import thick_arc_factor, thick_error, thick_s_factor

THINNEST, THICKEST, WIDEST = 0.015, 0.32, 3.5


def drawn(rng):
    """Return thickness and width over length, and Poisson's ratio."""
    h = np.exp(rng.uniform(np.log(THINNEST), np.log(THICKEST)))
    b = np.exp(rng.uniform(np.log(h), np.log(WIDEST)))
    return float(h), float(b), float(rng.uniform(0.1, 0.48))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    rng, most = np.random.default_rng(args.seed), 0.0
    print(f"{'h/l':>6} {'b/l':>6} {'ν':>5}" + 2 * f"{'solid':>10}{'formula':>10}{'left':>7}")
    for _ in range(args.cases):
        h, b, nu = drawn(rng)
        solid, row = factors(h=h, b=b, nu=nu), f"{h:6.3f} {b:6.3f} {nu:5.2f}"
        for true, formula in zip(solid, (thick_arc_factor, thick_s_factor), strict=True):
            k = float(formula(h=h, l=1.0, b=b, poisson_ratio=nu))
            left = (true - k) / float(thick_error(k, h=h, l=1.0, poisson_ratio=nu))
            most = max(most, abs(left))
            row += f"{true:10.5f}{k:10.5f}{left:7.2f}"
        print(row, flush=True)
    print(f"largest: {most:.2f}")


if __name__ == "__main__":
    main()
