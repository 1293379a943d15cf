"""Nominal stress of wide blades in the plane by thin shells, against CalculiX's solids.

Run: python tests/benchmarks/shell_stresses.py [designs] [--first SEED] [--keep FILE].
Random joints of wide blades, small and large strokes, some under a force. Prints by how much solids
differ from what is told two thicknesses from a clamp, with the errors of both; FILE gets each as
one line (JSON) with what solids found. Solids whose own error is above 3 % say nothing.
"""

import argparse
import json
from pathlib import Path

import numpy as np
import yaml

import flexcli

KINDS = (
    "guided-blade", "rcc", "cross-spring", "three-blade", "leaf-spring-stage", "cantilever", "star",
)  # fmt: skip
E, L, COARSE = 100e9, 20e-3, 0.03


def drawn(seed):
    """Return a random joint of wide blades with a stroke."""
    rng, kind = np.random.default_rng(seed), KINDS[seed % len(KINDS)]
    b = L * float(np.exp(rng.uniform(np.log(0.15), np.log(3.0))))
    h = min(L * float(np.exp(rng.uniform(np.log(0.003), np.log(0.06)))), 0.15 * b)
    geometry = {"kind": kind, "h": f"{h} m", "l": f"{L} m", "b": f"{b} m"}
    more = {
        "rcc": {"p": f"{L * rng.uniform(0.0, 0.8)} m", "half_angle": f"{rng.uniform(15, 60)} deg"},
        "cross-spring": {
            "delta": float(rng.uniform(-0.8, -0.2)), "half_angle": f"{rng.uniform(25, 60)} deg",
        },
        "three-blade": {"p": "0 m"},
        "star": {
            "p": f"{-L * rng.uniform(0.3, 0.7)} m", "angles": ["0 deg", "100 deg", "215 deg"],
        },
        "leaf-spring-stage": {"spacing": "30 mm"},
    }.get(kind, {})  # fmt: skip
    travel = float(rng.choice([0.003, 0.03, 0.15, 0.3]))
    if kind in ("three-blade", "star"):
        travel = min(travel, 0.05)
    turns = kind in ("rcc", "cross-spring", "three-blade", "star")
    stroke = {"rotation": f"{travel} rad"} if turns else {"translation": f"{travel * L} m"}
    case = {"stroke": stroke}
    force = float(rng.choice([0.0, 0.0, 0.3])) * 10.0 * E * b * h**3 / 12.0 / L**2
    if force:
        direction = f"{rng.choice([0.0, 180.0])} deg"
        case |= {"load": {"force": f"{force} N", "direction": direction}, "ends": "clamped-guided"}
    elif rng.choice([False, True]):  # along the stroke, of the size of what that bears
        share, spring = travel * rng.uniform(0.1, 1.0), E * b * h**3 / L
        along = {"theta_z": f"{share * spring} N*m"} if turns else {"x": f"{share * spring / L} N"}
        case["wrench"] = along
    return {
        "flexure": 1,
        "material": {
            "youngs_modulus": f"{E} Pa", "poisson_ratio": float(rng.choice([0.2, 0.3, 0.45])),
            "yield_strength": "5 GPa",
        },
        "geometry": geometry | more, "cases": {"work": case}, "requirements": {"yield": 1.0},
    }  # fmt: skip


def main():
    """Print each design, and how many were within both errors."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", type=int, nargs="?", default=21)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep", type=Path)
    args = parser.parse_args()
    held = compared = 0
    for seed in range(args.first, args.first + args.designs):
        spec = drawn(seed)
        kind = spec["geometry"]["kind"]
        found = flexcli.verify(yaml.safe_dump(spec), model="shell", only=["sigma"])
        (row,) = found.verification.numbers
        if row.solid is None or row.model_error is None or row.solid_error > COARSE:
            print(f"{seed:6} {kind:18} {row.why[:60] or 'solids are too coarse'}")
            continue
        off, error = row.solid / row.model - 1.0, row.model_error.high
        compared, held = compared + 1, held + (abs(off) <= error + row.solid_error)
        mark = "" if abs(off) <= error else "  <-- beyond its error"
        print(
            f"{seed:6} {kind:18} solids {off:+.4f} ± {row.solid_error:.4f},"
            f" told ± {error:.4f}{mark}",
            flush=True,
        )
        if args.keep:
            kept = {
                "kind": kind, "spec": spec, "read": row.read, "solid": row.solid,
                "error": row.solid_error,
            }  # fmt: skip
            with args.keep.open("a") as file:
                file.write(json.dumps(kept) + "\n")
    print(f"{held} of {compared} within both errors")


if __name__ == "__main__":
    main()
