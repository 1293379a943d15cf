"""Ranges of all models against each other: each claims to hold the same truth, so they overlap.

Run: python tests/benchmarks/model_ranges.py [specs] [--first SEED] [--kinds KIND …] [--coupled].
Random specs of the campaign, or of loads that act together, are judged with easy requirements by
closed forms, linear and exact beams and shells in turn, single notches by solids too; a check of
which two ranges lie apart has a wrong one, and is printed with both.
"""

import argparse
import sys
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(__file__).parents[1]))

from twins.campaign import KINDS, NOTCHES, scene
from twins.coupled import COUPLED, coupled_scene

import flexcli
from flexcli.errors import SolveError, SpecError

MODELS = ("closed-form", "linear", "exact", "shell", "solid")
ROUNDING = 1e-7


def ranges(spec: dict) -> dict[tuple, dict[str, tuple[float, float]]]:
    """Return by check the ranges of its factor that models know."""
    found: dict[tuple, dict[str, tuple[float, float]]] = {}
    for model in MODELS:
        if model == "solid" and spec["geometry"]["kind"] not in NOTCHES:
            continue
        try:
            checks = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
        except SolveError:
            continue  # it has no such model
        for check in checks:
            if check.factor_range is not None:
                found.setdefault((check.name, check.case, check.path), {})[model] = (
                    check.factor_range
                )
    return found


def apart(known: dict[str, tuple[float, float]]) -> Iterator[tuple[str, str]]:
    """Yield the pairs of models whose ranges do not overlap."""
    for one, other in combinations(known, 2):
        (low, high), (least, most) = known[one], known[other]
        if low > most * (1.0 + ROUNDING) or least > high * (1.0 + ROUNDING):
            yield one, other


def main() -> None:
    """Print the checks of which two ranges lie apart, and how many were compared."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("specs", type=int, nargs="?", default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*")
    parser.add_argument("--coupled", action="store_true", help="loads that act together")
    asked = parser.parse_args()
    draw, kinds = (coupled_scene, COUPLED) if asked.coupled else (scene, KINDS)
    compared = wrong = refused = 0
    for seed in range(asked.first, asked.first + asked.specs):
        drawn = draw(seed, tuple(asked.kinds or kinds))
        try:
            found = ranges({**drawn.spec, "requirements": drawn.easy})
        except SpecError:
            refused += 1
            continue
        for (name, case, _), known in found.items():
            compared += len(known) > 1
            for one, other in apart(known):
                wrong += 1
                print(f"{seed} {drawn.kind}: {name}, {case}:", one, known[one], other, known[other])
    print(f"{compared} checks known to several models, {wrong} apart; {refused} specs refused")


if __name__ == "__main__":
    main()
