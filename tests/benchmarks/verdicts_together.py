"""Verdicts of designs judged together beside one at a time: time a design, what decided, agreement.

Run: python tests/benchmarks/verdicts_together.py [designs] [--alone DESIGNS]
Processor time of one core, reading of the designs included.
"""

import argparse
from collections import Counter
from math import isnan
from pathlib import Path
from resource import RUSAGE_SELF, getrusage
from time import process_time

from flexcli import api
from flexcli.parts.study import Study, points_of
from flexcli.study import BLOCK, rows_of

EXAMPLES = Path(__file__).parents[2] / "examples"

ROCKET = {"geometry.h": "640 um", "geometry.l": "18 mm", "geometry.b": "10 mm"}
MERCURY = {"geometry.h": "65 um", "geometry.b": "20 mm"}

CASES = (
    ("generalized-cross-spring", {}, {"geometry.h": "100um:200um", "geometry.l": "15mm:30mm",
     "material.youngs_modulus": "100GPa:200GPa"}),
    ("wittrick-crossing", {}, {"geometry.h": "80um:160um", "geometry.l": "20mm:40mm",
     "geometry.half_angle": "30deg:50deg", "stroke.rotation": "3deg:6deg"}),
    ("rocket-parallel-stage", ROCKET, {"geometry.h": "500um:700um", "geometry.l": "15mm:20mm"}),
    ("mercury-three-blade-pivot", MERCURY, {"geometry.h": "55um:75um", "geometry.l": "70mm:90mm",
     "geometry.b": "15mm:25mm"}),
)  # fmt: skip
"""An example, what is put over it, and the ranges that its designs are spread over."""


def apart(one, other):
    """Return the largest difference of factors, as a share; no verdict or model may differ."""
    (row, _), (alone, _) = one, other
    assert row._replace(cells={}) == alone._replace(cells={})
    pairs = [(row.cells[name], cell) for name, cell in alone.cells.items()]
    assert all(x == y for x, y in pairs if isinstance(y, str))
    known = [(x, y) for x, y in pairs if not isinstance(y, str) and not isnan(y) and x != y]
    return max((abs(x / y - 1.0) for x, y in known), default=0.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("designs", type=int, nargs="?", default=2048)
    parser.add_argument("--alone", type=int, default=20)
    asked = parser.parse_args()
    for name, over, ranges in CASES:
        spec = api.load(EXAMPLES / name / "flexure.yaml", overrides=over)
        ends = {place: dict(zip(("from", "to"), r.split(":"), strict=True))
                for place, r in ranges.items()}  # fmt: skip
        points = points_of(
            Study.model_validate({"vary": ends, "sample": "sobol", "points": asked.designs})
        )
        of = api.Portable.of(spec), "verdict", None
        rows_of(*of, points[:1])  # what is imported by then
        started = process_time()
        together = [
            row
            for start in range(0, len(points), BLOCK)
            for row in rows_of(*of, points[start : start + BLOCK])
        ]
        a_design = (process_time() - started) / len(points)
        some = range(0, len(points), max(1, len(points) // asked.alone))
        started = process_time()
        alone = [rows_of(*of, points[i : i + 1])[0] for i in some]
        alone_a_design = (process_time() - started) / len(alone)
        off = max(apart(together[i], row) for i, row in zip(some, alone, strict=True))
        ends_by = Counter(f"{row.status} by {row.model or 'none'}" for row, _ in together)
        memory = getrusage(RUSAGE_SELF).ru_maxrss / 1e3
        print(
            f"{name}: {1e3 * a_design:.2f} ms a design together, {1e3 * alone_a_design:.1f} ms "
            f"alone, {alone_a_design / a_design:.0f} times; largest difference {off:.0e}; "
            f"{memory:.0f} MB so far; {dict(ends_by)}"
        )


if __name__ == "__main__":
    main()
