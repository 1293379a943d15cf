"""Ranges of all models against each other: each claims to hold the same truth, so they overlap.

Run: python tests/benchmarks/model_ranges.py [specs] [--first SEED] [--kinds KIND …]
[--coupled | --single [--share SHARE] | --space].
Random specs of the campaign, of loads that act together, of one small load at a time, or of
mechanisms in space, are judged with easy requirements by closed forms, linear and exact beams and
shells in turn, notches and joined crosses by solids too, single loads by exact beams of the joint
drawn in space; a check of which two ranges lie apart has a wrong one, and is printed with both.
"""

import argparse
import sys
from collections.abc import Iterator
from contextlib import suppress
from itertools import combinations
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(__file__).parents[1]))

from twins.campaign import KINDS, LIMBS, NOTCHES, scene
from twins.coupled import COUPLED, coupled_scene
from twins.single_loads import SMALL, single_loads, twin_of
from twins.space_scenes import loaded_scene

import flexcli
from flexcli.errors import SolveError, SpecError

MODELS = ("closed-form", "linear", "exact", "shell", "solid")
CROSS = "unseparated-cross"
ROUNDING = 1e-7


def ranges(spec: dict, twin: dict | None = None) -> dict[tuple, dict[str, tuple[float, float]]]:
    """Return by check the ranges of its factor that models know, exact beams of a twin too."""
    found: dict[tuple, dict[str, tuple[float, float]]] = {}
    asked = [(model, model, spec) for model in MODELS]
    if twin is not None:
        asked.append(("exact in space", "exact", twin))
    for name, model, words in asked:
        if model == "solid" and spec["geometry"]["kind"] not in (*NOTCHES, *LIMBS, CROSS):
            continue
        try:
            checks = flexcli.verdicts(yaml.safe_dump(words), model=model).checks
        except SolveError:
            continue  # it has no such model
        for check in checks:
            if check.factor_range is not None:
                known = found.setdefault((check.name, check.case, check.path), {})
                known[name] = check.factor_range
    return found


def apart(known: dict[str, tuple[float, float]]) -> Iterator[tuple[str, str]]:
    """Yield the pairs of models whose ranges do not overlap."""
    for one, other in combinations(known, 2):
        (low, high), (least, most) = known[one], known[other]
        if low > most * (1.0 + ROUNDING) or least > high * (1.0 + ROUNDING):
            yield one, other


def specs(seed: int, kinds: tuple, asked: argparse.Namespace) -> Iterator[tuple[dict, dict | None]]:
    """Yield the specs of a seed, with the twin in space where one is asked."""
    if asked.single:
        for drawn in single_loads(seed, kinds, asked.share):
            with suppress(SpecError):
                yield drawn.spec, twin_of(drawn.spec)
        return
    if asked.space:
        drawn = loaded_scene(seed)
    else:
        drawn = (coupled_scene if asked.coupled else scene)(seed, kinds)
    yield {**drawn.spec, "requirements": drawn.easy}, None


def main() -> None:
    """Print the checks of which two ranges lie apart, and how many were compared."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("specs", type=int, nargs="?", default=100)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*")
    ways = parser.add_mutually_exclusive_group()
    ways.add_argument("--coupled", action="store_true", help="loads that act together")
    ways.add_argument("--single", action="store_true", help="one small load at a time")
    ways.add_argument("--space", action="store_true", help="mechanisms in space")
    parser.add_argument("--share", type=float, default=SMALL, help="of yielding, a single load")
    asked = parser.parse_args()
    kinds = tuple(asked.kinds or (COUPLED if asked.coupled or asked.single else KINDS))
    compared = wrong = refused = 0
    for seed in range(asked.first, asked.first + asked.specs):
        for spec, twin in specs(seed, kinds, asked):
            try:
                found = ranges(spec, twin)
            except SpecError:
                refused += 1
                continue
            for (name, case, _), known in found.items():
                compared += len(known) > 1
                for one, other in apart(known):
                    wrong += 1
                    wrench = spec["cases"].get(case, {}).get("wrench", "")
                    print(
                        f"{seed} {spec['geometry']['kind']}: {name}, {case}:",
                        one, known[one], other, known[other], wrench,
                        flush=True,
                    )  # fmt: skip
    print(f"{compared} checks known to several models, {wrong} apart; {refused} specs refused")


if __name__ == "__main__":
    main()
