"""Random specs over every kind of joint, near their limits: no bug, no unsafe pass, few undecided.

Run: python tests/benchmarks/campaign.py [specs] [--first SEED] [--kinds KIND …] [--found FILE].
Each spec is judged once with easy requirements; one of its printed numbers, 3 % up or down, becomes
the requirement, and a pass is held against the finest model. Prints what came of them by kind, and
writes the smallest spec of each kind of sin.
"""

import argparse
import sys
from collections import Counter, defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import yaml
from twins.campaign import KINDS, tried

SINS = (
    "", "undecided", "lacks a property", "unsafe pass", "finding", "traceback", "error",
    "nothing to ask",
)  # fmt: skip
INNOCENT = ("", "nothing to ask")


def main():
    """Try the specs and print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("specs", type=int, nargs="?", default=2000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*", default=KINDS)
    parser.add_argument("--found", type=Path)
    args = parser.parse_args()
    counts, examples, decided = defaultdict(Counter), {}, Counter()
    for seed in range(args.first, args.first + args.specs):
        found = tried(seed, tuple(args.kinds))
        counts[found.kind][found.sin] += 1
        counts["all"][found.sin] += 1
        decided.update(found.said.models)
        if found.sin not in INNOCENT:
            text = yaml.safe_dump(
                found.spec, sort_keys=False, width=10_000, default_flow_style=None
            )
            last = found.said.text.strip().splitlines()[-1:] or [""]
            key = (found.sin, found.kind, found.requirement, last[0][:60])
            best = found.finest.factors if found.finest else ""
            head = f"# seed {seed}: {' '.join(key)}; said {found.said.factors} finest {best}\n"
            if key not in examples or len(text) < len(examples[key][1]):
                examples[key] = (head, text)
    width = max(map(len, counts))
    print(f"{'kind':{width}} " + " ".join(f"{s or 'right':>16}" for s in SINS))
    for kind in sorted(counts):
        print(f"{kind:{width}} " + " ".join(f"{counts[kind][s]:16}" for s in SINS))
    print("rows decided by", dict(decided))
    if args.found:
        args.found.write_text("---\n".join(h + t for _, (h, t) in sorted(examples.items())))


if __name__ == "__main__":
    main()
