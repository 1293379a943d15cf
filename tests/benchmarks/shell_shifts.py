"""Parasitic shift by thin shells of the plane's joints, against CalculiX's solids.

Run: python tests/benchmarks/shell_shifts.py [designs] [--first SEED] [--kinds KIND …]
[--keep FILE].
Random drawn layouts (``tests/drawn_layouts.py``), stages of alike blades whose shortening cancels,
and pivots of wide ones. Prints what is told and by how much solids differ, with the errors of both;
FILE gets each as one line (JSON) with what solids found.
"""

import argparse
import json
import sys
from pathlib import Path

import numpy as np
import yaml

sys.path.insert(0, str(Path(__file__).parents[1]))

from drawn_layouts import KINDS, L, drawn_layout
from shell_shifts import asked, spec_of

import flexcli
from flexcli.engine.joint_models.shell_shift import shift_by_shells
from flexcli.engine.verify import verify
from flexcli.parts.elastic import NotAvailable

MORE = "alike", "wide"


def drawn(seed, kind):
    """Return the random layout of a kind, or one of those that are not drawn unevenly."""
    if kind in KINDS:
        return drawn_layout(seed, kind)
    rng = np.random.default_rng(seed)
    layout = drawn_layout(seed, "folded" if kind == "alike" else "pair")
    h, b = L * 10 ** rng.uniform(-2.7, -1.0), L * 10 ** rng.uniform(-1.2, 0.48)
    blades = layout.spec["blades"]
    for blade in blades.values():
        blade |= {"h": f"{h} m", "b": f"{b} m"}
        if kind == "alike":
            ends = (0.0, L) if blade["between"][0] == "ground" else (L, 0.0)
            for key, x in zip(("from", "to"), ends, strict=True):
                blade[key] = [f"{x} m", blade[key][1]]
    return layout._replace(travel=layout.travel * (0.5 if kind == "wide" else 3.0))


def by_solids(spec, meshes):
    """Return the shift of a spec by solids on the finest of some meshes."""
    design = flexcli.load(yaml.safe_dump(spec)).part
    sizes = design.fixed_sizes()
    (row,) = verify(
        design, sizes, "", model="exact", only=["shift"], meshes=meshes
    ).verification.numbers
    return row


def main():
    """Print each design, and how many were within both errors."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", type=int, nargs="?", default=10)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*", default=(*KINDS, *MORE))
    parser.add_argument("--keep", type=Path)
    args = parser.parse_args()
    for kind in args.kinds:
        held = compared = 0
        for seed in range(args.first, args.first + args.designs):
            layout = drawn(seed, kind)
            spec = spec_of(layout)
            try:
                told, error = shift_by_shells(asked(spec))
            except NotAvailable as why:
                print(f"{kind:9} {seed:6} {str(why)[:60]}")
                continue
            coarse, fine = (by_solids(spec, meshes) for meshes in (1, 2))
            if fine.solid is None or fine.solid_error is None:
                print(f"{kind:9} {seed:6} {fine.why[:60]}")
                continue
            # of alike blades the law of finite strain cancels as well
            own = abs(coarse.solid / fine.solid - 1.0) if kind == "alike" else fine.solid_error
            off = fine.solid / told - 1.0
            compared, held = compared + 1, held + (abs(off) <= error + own)
            mark = "" if abs(off) <= error else "  <-- beyond its error"
            print(
                f"{kind:9} {seed:6} told {told:+.4e} +- {error:.4f}, solids {off:+.5f}"
                f" +- {own:.5f}{mark}",
                flush=True,
            )
            if args.keep:
                found = {"kind": kind, "spec": spec, "solid": fine.solid, "error": own}
                with args.keep.open("a") as file:
                    file.write(json.dumps(found) + "\n")
        print(f"{kind}: {held} of {compared} within both errors")


if __name__ == "__main__":
    main()
