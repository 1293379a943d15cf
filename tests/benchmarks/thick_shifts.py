"""First-order shifts of thick, wide blades beside CalculiX's solids, drawn at random.

Run by hand: python tests/benchmarks/thick_shifts.py [--cases 8] [--seed 100]
Prints by how much solids differ from what is told, the last two meshes from each other, and the
error that is told.
"""

import argparse

import numpy as np
import yaml

import flexcli
from flexcli.engine.verify import verify

L, MESHES = 20e-3, (2, 3)
THINNEST, THICKEST, WIDEST = 0.05, 0.58, 5.0


def drawn(rng):
    """Return a spec of a star or a pair that turns by 1 µrad, asked for its shift."""
    h = L * np.exp(rng.uniform(np.log(THINNEST), np.log(THICKEST)))
    b = h * np.exp(rng.uniform(0.0, np.log(WIDEST)))
    sizes = {"h": f"{h} m", "l": f"{L} m", "b": f"{b} m"}
    p, first, between = L * rng.uniform(0.2, 1.2), rng.uniform(0.0, 360.0), rng.uniform(60.0, 170.0)
    kind = rng.choice(["star", "rcc", "cross-spring"])
    own = {
        "star": {"p": f"{p} m", "angles": [f"{x % 360.0} deg" for x in (first, first + between)]},
        "rcc": {"p": f"{p} m", "half_angle": f"{rng.uniform(15.0, 75.0)} deg"},
        "cross-spring": {
            "delta": float(-rng.uniform(0.1, 0.9)), "half_angle": f"{rng.uniform(15.0, 75.0)} deg"
        },
    }[kind]  # fmt: skip
    return {
        "flexure": 1,
        "material": {"youngs_modulus": "70 GPa", "poisson_ratio": float(rng.uniform(0.15, 0.47))},
        "geometry": {"kind": str(kind), **sizes, **own},
        "cases": {"work": {"stroke": {"rotation": "1 urad"}}},
        "requirements": {"parasitic_shift": {"max": "1 m"}},
    }


def by_solids(spec, meshes):
    """Return the shift of a spec by solids on the finest of some meshes."""
    design = flexcli.load(yaml.safe_dump(spec)).part
    (row,) = verify(
        design, design.fixed_sizes(), "", model="exact", only=["shift"], meshes=meshes
    ).verification.numbers
    return row.solid


def main():
    """Print each design."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=8)
    parser.add_argument("--seed", type=int, default=100)
    args = parser.parse_args()
    for seed in range(args.seed, args.seed + args.cases):
        spec = drawn(np.random.default_rng(seed))
        coarse, fine = (by_solids(spec, meshes) for meshes in MESHES)
        checks = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
        (check,) = (each for each in checks if each.name.startswith("parasitic shift"))
        told = np.nan if check.factor_range is None else check.factor / check.factor_range[0] - 1.0
        off = abs(fine) / check.demand - 1.0
        print(f"{seed} {spec['geometry']['kind']:12} {off:+.4f} "
              f"mesh {abs(coarse / fine - 1.0):.4f} told {told:.4f}", flush=True)  # fmt: skip


if __name__ == "__main__":
    main()
