"""Random specs over every kind of joint, near their limits: no bug, no unsafe pass, few undecided.

Run: python tests/benchmarks/campaign.py [specs] [--first SEED] [--kinds KIND …] [--rows FILE]
[--near SHARE] [--alone].
Each spec is judged with easy requirements; its printed numbers, each 3 % (or SHARE) up or down,
become the requirements, all at once or one of them alone, which are judged by default and by the
finest model. Prints what came of them by kind, by requirement and by keys that few specs have,
which model decided, and what deciding cost over asking the finest model of everything. Each spec
adds a line to FILE (JSON) as it is done, so that a run which was stopped goes on where it was; with
0 specs the tables are those of the file.
"""

import argparse
import json
import signal
import sys
from collections import Counter, defaultdict
from pathlib import Path
from time import process_time

sys.path.insert(0, str(Path(__file__).parents[1]))

from twins.campaign import KINDS, NEAR, tried
from twins.rare_keys import what_is_rare
from twins.verdicts import FORGOTTEN

from flexcli.mechanics.solids.unit_loads import neck_under_loads

FORGOTTEN.append(neck_under_loads)  # each answer takes the time of a process of its own

SINS = (
    "", "undecided", "lacks a property", "leaves out", "unsafe pass", "false fail", "finding",
    "exit 101", "error", "too long", "nothing to ask",
)  # fmt: skip


class TooLong(BaseException):
    """A spec took longer than it may."""


def row_of(seed, kinds, longest, **asked):
    """Return what came of a seed's spec, as one line of the file."""

    def stop(*_):
        raise TooLong

    signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, longest)
    started = process_time()
    try:
        found = tried(seed, kinds, **asked)
    except TooLong:
        kind = kinds[seed % len(kinds)]
        return {"seed": seed, "kind": kind, "outcomes": [{"requirement": "", "sin": "too long"}]}
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
    row = {"seed": seed, "kind": found.kind, "spent": process_time() - started}
    row["rare"] = what_is_rare(found.spec)
    row["seconds"] = [each.deciding if each else 0.0 for each in (found.said, found.finest)]
    outcomes = [
        {
            "requirement": each.requirement, "sin": each.sin, "said": each.said.verdict,
            "models": each.said.models, "factors": each.said.factors, "ranges": each.said.ranges,
            "finest": each.finest.verdict, "best": each.finest.factors,
            "best_ranges": each.finest.ranges, "text": each.said.text[-200:],
        }
        for each in found.outcomes
    ] or [{"requirement": "", "sin": found.sin, "text": found.said.bug[-400:]}]  # fmt: skip
    if any(each["sin"] not in ("", "nothing to ask") for each in outcomes):
        row["spec"] = found.spec
    return row | {"outcomes": outcomes}


def table(counts, title):
    """Print one line a key: how often each sin."""
    width = max([len(key) for key in counts] + [len(title)])
    print(f"\n{title:{width}} " + " ".join(f"{s or 'right':>16}" for s in SINS))
    for key in sorted(counts):
        print(f"{key:{width}} " + " ".join(f"{counts[key][s]:16}" for s in SINS))


def tables(rows):
    """Print what came of all rows of a file."""
    kinds, asked, decided = defaultdict(Counter), defaultdict(Counter), Counter()
    rare = defaultdict(Counter)
    for row in rows:
        for name in row.get("rare", ()):
            rare[name].update(each["sin"] for each in row["outcomes"])
        for each in row["outcomes"]:
            kinds[row["kind"]][each["sin"]] += 1
            asked[each["requirement"]][each["sin"]] += 1
            asked["all"][each["sin"]] += 1
            decided.update(each.get("models", ()))
    table(kinds, "kind")
    table(asked, "requirement")
    table(rare, "specs with")
    print(f"\n{len(rows)} specs; rows decided by {dict(decided)}")
    timed = [row["seconds"] for row in rows if all(row.get("seconds", [0.0]))]
    if timed:
        said, finest = (sum(each) for each in zip(*timed, strict=True))
        ratios = sorted(best / ours for ours, best in timed)
        middle = ratios[len(ratios) // 2]
        print(f"the finest model everywhere costs {finest / said:.2f} times what deciding does;")
        print(f"in the middle spec {middle:.2f} times")


def main():
    """Try the specs and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("specs", type=int, nargs="?", default=2000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*", default=KINDS)
    parser.add_argument("--rows", type=Path)
    parser.add_argument("--near", type=float, default=NEAR, help="distance from a limit, a share")
    parser.add_argument("--alone", action="store_true", help="one requirement of each spec")
    parser.add_argument("--longest", type=float, default=120.0, help="time of one spec [s]")
    args = parser.parse_args()
    rows = []
    if args.rows and args.rows.exists():
        rows = [json.loads(line) for line in args.rows.read_text().splitlines()]
    known = {row["seed"] for row in rows}
    for seed in range(args.first, args.first + args.specs):
        if seed in known:
            continue
        row = row_of(seed, tuple(args.kinds), args.longest, near=args.near, alone=args.alone)
        rows.append(row)
        if args.rows:
            with args.rows.open("a") as file:
                file.write(json.dumps(rows[-1], default=float) + "\n")
    tables(rows)


if __name__ == "__main__":
    main()
