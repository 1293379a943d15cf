"""Verdicts of specs that say nearly the same: none passes what the other fails.

Run: python tests/benchmarks/neighbours.py [specs] [--first SEED] [--near SHARE] [--each COUNT]
Random specs of the campaign, near their limits, are judged beside neighbours that should have the
same verdicts: with a load or a temperature that is next to nothing, or with all lengths twice or a
thousand times as large and loads, masses and times in proportion. Each may be undecided where the
other is not (``open``); ranges that lie apart, or a pass beside a fail, show a wrong one
(``apart``). ``ends:`` that hold a body in its plane do not where a load leaves it, and a wrench
makes a directed load act either way: such neighbours are left out.
"""

import argparse
import random
import sys
from collections.abc import Iterator
from copy import deepcopy
from pathlib import Path
from typing import Any

import yaml

sys.path.insert(0, str(Path(__file__).parents[1]))

from twins.campaign import near_its_limits
from twins.single_loads import bending

import flexcli
from flexcli.errors import SolveError, SpecError
from flexcli.results import Check, Verdict

POWERS = {
    "m": 1, "N": 2, "N*m": 3, "N/m": 1, "N*m/rad": 3, "kg": 3, "kg*m^2": 5, "kg/m^3": 0, "Pa": 0,
    "GPa": 0, "MPa": 0, "K": 0, "K/m": -1, "1/K": 0, "m/s^2": -1, "g": -1, "Hz": -1, "s": 1,
    "ms": 1, "m/s": 0, "rad": 0, "deg": 0,
}  # fmt: skip
"""Power of the lengths with which a quantity grows at the same strain."""

NOTHING = 1e-14
"""Of the moment that makes a blade yield: a load that is next to nothing."""

SAME = 1e-6
"""Share by which ranges may miss each other."""

FIXED = ("asd", "shock")
"""Loads in tables of their own, which do not grow with the lengths."""


class NotScalable(Exception):
    """A quantity whose growth with the lengths is not known."""


def scaled(words: Any, factor: float) -> Any:
    """Return a spec whose lengths are so many times as large, at the same strain."""
    if isinstance(words, dict):
        return {key: scaled(value, factor) for key, value in words.items()}
    if isinstance(words, list):
        return [scaled(value, factor) for value in words]
    number, _, unit = words.partition(" ") if isinstance(words, str) else ("", "", "")
    try:
        value = float(number)
    except ValueError:
        return words
    if unit not in POWERS:
        raise NotScalable(unit)
    return f"{value * factor ** POWERS[unit]!r} {unit}"


def smallest_load(spec: dict) -> tuple[str, str]:
    """Return a force and a moment that are next to nothing for a spec's blades."""
    strength = float(spec["material"].get("yield_strength", "1e8").split()[0])
    moment, l = bending(spec["geometry"], NOTHING * strength)
    return f"{moment / l!r} N", f"{moment!r} N*m"


def neighbours(spec: dict) -> Iterator[tuple[str, dict]]:
    """Yield specs that say nearly the same, by what they have besides."""
    case = spec["cases"]["work"]
    force, moment = smallest_load(spec)
    loads = {**dict.fromkeys("xyz", force)}
    loads |= {f"theta_{axis}": moment for axis in "xyz"}
    held = case.get("ends", "clamped-free") != "clamped-free" or "lock" in case
    for axis, load in loads.items():
        leaves = axis in ("z", "theta_x", "theta_y")
        given = axis in case.get("wrench", {}) or "direction" in case.get("load", {})
        if not given and not (held and leaves):
            near = deepcopy(spec)
            near["cases"]["work"].setdefault("wrench", {})[axis] = load
            yield f"wrench along {axis}", near
    if "temperature" not in case and "thermal_expansion" not in spec["material"]:
        for heat in ({"uniform": "1e-10 K"}, {"gradient": {"x": "1e-9 K/m"}}):
            near = deepcopy(spec)
            near["cases"]["work"]["temperature"] = heat
            near["material"]["thermal_expansion"] = "1e-5 1/K"
            yield f"temperature {next(iter(heat))}", near
    if not any(name in each for name in FIXED for each in spec["cases"].values()):
        for factor in (2.0, 1e3):
            yield f"{factor:g} times as large", scaled(spec, factor)


def checks_of(spec: dict) -> dict[tuple, Check]:
    """Return the checks of a spec by their names, cases and places."""
    found = flexcli.verdicts(yaml.safe_dump(spec)).checks
    return {(check.name, check.case, check.path): check for check in found}


def compared(one: Check, other: Check) -> str:
    """Return how two checks of the same number lie to each other."""
    if {one.verdict, other.verdict} == {Verdict.PASS, Verdict.FAIL}:
        return "apart"
    if one.factor_range is not None and other.factor_range is not None:
        (low, high), (least, most) = one.factor_range, other.factor_range
        if low > most * (1.0 + SAME) or least > high * (1.0 + SAME):
            return "apart"
    return "same" if one.verdict is other.verdict else "open"


def main() -> None:
    """Print the checks that are not the same, and how many were compared."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("specs", type=int, nargs="?", default=50)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--near", type=float, default=0.3)
    parser.add_argument("--each", type=int, default=5, help="neighbours of a spec")
    asked = parser.parse_args()
    counts = dict.fromkeys(("same", "open", "apart"), 0)
    for seed in range(asked.first, asked.first + asked.specs):
        found = near_its_limits(seed, near=asked.near)
        if found.sin:
            continue
        try:
            base, each = checks_of(found.spec), list(neighbours(found.spec))
        except (SpecError, SolveError, NotScalable):
            continue
        random.Random(seed).shuffle(each)
        for what, spec in each[: asked.each]:
            try:
                others = checks_of(spec)
            except (SpecError, SolveError) as error:
                print(f"{seed} {found.kind}, {what}: refused: {error}", flush=True)
                continue
            for key, one in base.items():
                if key in others:
                    said = compared(one, others[key])
                    counts[said] += 1
                    if said != "same":
                        pairs = (one, others[key])
                        told = ((c.verdict.value, c.model, c.factor_range) for c in pairs)
                        print(said, seed, found.kind, what, key[0], key[1], *told, flush=True)
    print(", ".join(f"{count} {said}" for said, count in counts.items()))


if __name__ == "__main__":
    main()
