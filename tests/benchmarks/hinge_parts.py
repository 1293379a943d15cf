"""Notches under all six forces: our solids beside what each kind of forces leaves of its part.

Run by hand: python tests/benchmarks/hinge_parts.py COUNT SEED
It prints, for each notch of half a length of one, e, depth, width and ν, and between what the
largest stress of solids lies in what is told: -1 is the least that is told, 1 the most. Each takes
two seconds. The constants of :func:`flexcli.mechanics.space.stresses.hinge_range` are of 178.
"""

import sys

import numpy as np

from flexcli.formulas.notch import axial_factor, bending_factor
from flexcli.formulas.profile import Notch
from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import FINE, NeckUnderLoads
from flexcli.mechanics.solids.unit_loads import equivalent as along_or_mises
from flexcli.mechanics.space.layout import Isotropic, SpaceBlade
from flexcli.mechanics.space.springs import springs_of
from flexcli.mechanics.space.stresses import equivalent, hinge_range, stress_rows


def notches(count, random):
    """Yield e, depth, width, ν and length of the blocks of notches, at random."""
    while count:
        depth = float(random.choice([1.0, 1.0, 10.0 ** random.uniform(-0.7, 0.3)]))
        e, b = depth * 10.0 ** random.uniform(-3.0, 0.6), 10.0 ** random.uniform(-2.0, 1.2)
        nu = float(random.choice([0.0, 0.2, 0.3, 0.45, 0.49]))
        blocks = random.choice([0, 0.5, 1, 2])
        if e * depth <= 1.0 and e <= min(b, 4.0 * depth):
            count -= 1
            yield e, depth, b, nu, float(blocks) * (e + 2.0 * depth)


def places(notch, mixed):
    """Return where the stresses of solids lie in what is told, each load by itself and mixed."""
    e, depth, b, nu, block = notch
    from_to, up = ((0.0, 0.0, 0.0), (2.0, 0.0, 0.0)), (0.0, 0.0, 1.0)
    material = Isotropic(1.0, 0.5 / (1.0 + nu))
    at = {"e": e, "r": 1.0 / depth}
    peak = float(bending_factor(**at)), float(axial_factor(**at))
    blade = SpaceBlade("h", "ground", "body", *from_to, up, Notch(e, depth), b, material, peak)
    rows = stress_rows(blade, springs_of(blade))
    loads = np.concatenate([np.eye(6), mixed])
    loads /= equivalent(rows.normal, rows.shear).max(axis=0)[:6]
    stress, _ = NeckUnderLoads(Neck(e, depth, 2.0, b, 0.0, block), 1.0, nu).stresses(loads, FINE)
    for load, found in zip(loads, np.abs(along_or_mises(stress)).max(axis=1), strict=True):
        acting = np.concatenate([load, np.zeros(3)])
        told = equivalent(rows.normal @ acting, rows.shear @ acting).max()
        low, high = hinge_range(blade, rows, acting)
        yield (found - told) / ((high - told) if found > told else (told - low))


def main():
    count, random = int(sys.argv[1]), np.random.default_rng(int(sys.argv[2]))
    mixed = random.normal(size=(24, 6))
    mixed[:8, 2:5] = mixed[8:14, [0, 1, 5]] = mixed[14:19, 2:4] = 0.0
    for notch in notches(count, random):
        at = list(places(notch, mixed))
        sys.stdout.write(f"{np.round(notch, 4)} {min(at):.2f} to {max(at):.2f}\n")


if __name__ == "__main__":
    main()
