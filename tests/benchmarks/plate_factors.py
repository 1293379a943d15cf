"""Plate factors of clamped blades: the formulas beside the plate solved by Ritz's method.

Run by hand: python tests/benchmarks/plate_factors.py
Prints stiffness over the beam's for thin blades by b/l and ν, an older fit of the same kind, and
solids of finite thickness beside the effective width.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from plates.clamped_block import bending_factor, guided_factor
from plates.clamped_strip import Strip

from flexcli.formulas import plate_factors as plates

EARLIER = {
    "pure": (0.83177, 0.06475, 1.70569, -0.40198, 0.6723),
    "S": (2.48437, 2.78684, 17.24826, 0.13191, 2.62092),
}
"""Coefficients of a fit to other plate solutions, for b/l from 0.05 to 2."""


def earlier(which, x, nu):
    p_0, p_1, p_2, p_3, p_4 = EARLIER[which]
    odds = x * (p_0 + p_1 * x + p_2 * x**2) / (1 + p_3 * x + p_4 * x**2)
    return 1 / (1 - nu**2 * odds / (1 + odds))


def main():
    print("thin blades            pure bending                    S shape")
    print(f"{'b/l':>6} {'ν':>5}" + 2 * f"{'formula':>11}{'plate':>10}{'earlier':>10}")
    for b in (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 10.0):
        for nu in (0.2, 0.3, 0.45):
            plate, at = Strip(b, nu, bubbles=6), {"b": b, "l": 1.0, "poisson_ratio": nu}
            pure, bent = plates.pure_bending_factor(**at), plates.guided_factor(**at)
            print(
                f"{b:6.2f} {nu:5.2f}{pure:11.5f}{plate.bending_factor():10.5f}"
                f"{earlier('pure', b, nu):10.5f}{bent:11.5f}{plate.guided_factor():10.5f}"
                f"{earlier('S', b, nu):10.5f}"
            )
    print("\nfinite thickness, ν = 0.3")
    print(f"{'b/l':>6} {'h/l':>5}" + 2 * f"{'formula':>11}{'solid':>10}{'thin':>10}")
    for b, h in ((0.1, 0.05), (0.1, 0.1), (0.2, 0.02), (0.2, 0.1), (0.5, 0.1), (1.0, 0.1)):
        at = {"b": b, "l": 1.0, "poisson_ratio": 0.3}
        row = f"{b:6.2f} {h:5.2f}"
        for formula, solid in (
            (plates.pure_bending_factor, bending_factor),
            (plates.guided_factor, guided_factor),
        ):
            true = solid(b=b, h=h, nu=0.3)
            row += f"{formula(h=h, **at):11.5f}{true:10.5f}{formula(**at):10.5f}"
        print(row)


if __name__ == "__main__":
    main()
