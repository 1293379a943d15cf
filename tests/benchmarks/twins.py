"""Verdicts against independent twins: each requirement 3 % above and below its true factor.

Run: python tests/benchmarks/twins.py [designs] [--first SEED] [--model MODEL] [--wrong FILE]
[--truth FILE]. Prints the score by kind, by requirement and by the model that decided, and what
deciding cost over asking the finest model of everything. ``--truth`` keeps the twins' numbers in a
file between runs; ``--wrong`` writes every spec that is not judged rightly.
"""

import argparse
import pickle
import sys
from collections import Counter, defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

import yaml
from twins.designs import drawn
from twins.verdicts import FORGOTTEN, RIGHT, SCORES, checked, score

from flexcli.mechanics.solids.unit_loads import neck_under_loads

FORGOTTEN.append(neck_under_loads)  # each answer takes the time of a process of its own


def truths(args):
    """Return the designs with their questions, from the file where they are known."""
    known = {}
    if args.truth and args.truth.exists():
        known = pickle.loads(args.truth.read_bytes())
    fresh = 0
    for seed in range(args.first, args.first + args.designs):
        if seed not in known:
            known[seed], fresh = drawn(seed), fresh + 1
            if args.truth and fresh % 20 == 0:
                args.truth.write_bytes(pickle.dumps(known))
    if args.truth and fresh:
        args.truth.write_bytes(pickle.dumps(known))
    return [known[seed] for seed in range(args.first, args.first + args.designs)]


def table(counts, title):
    """Print one line a key: how often each score."""
    width = max([len(str(key)) for key in counts] + [len(title)])
    print(f"\n{title:{width}} " + " ".join(f"{s:>11}" for s in SCORES))
    for key in sorted(counts, key=str):
        print(f"{key!s:{width}} " + " ".join(f"{counts[key][s]:11}" for s in SCORES))


def main():
    """Judge every question twice and print the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("designs", type=int, nargs="?", default=358)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--model")
    parser.add_argument("--finest", action="store_true", help="time the finest model besides")
    parser.add_argument("--truth", type=Path)
    parser.add_argument("--wrong", type=Path)
    args = parser.parse_args()
    by = {name: defaultdict(Counter) for name in ("kind", "requirement", "model", "all")}
    spent, finest, wrong, dropped = 0.0, 0.0, [], Counter()
    for design in truths(args):
        if design.dropped:
            dropped[design.kind] += 1
        for question in design.questions:
            for kept in (True, False):
                spec = design.asked(question, kept)
                said = checked(spec, question.name, args.model)
                result = score(said, kept)
                tag = f"{question.name} {question.tag}".strip()
                model = "/".join(sorted(set(said.models))) or "none"
                keys = {"kind": design.kind, "requirement": tag, "model": model, "all": "all"}
                for name, key in keys.items():
                    by[name][key][result] += 1
                spent += said.seconds
                if args.finest:
                    finest += checked(spec, question.name, "exact").seconds
                if result != RIGHT:
                    wrong.append((result, tag, kept, question.true, said, spec))
    for name, counts in by.items():
        table(counts, name)
    total = sum(by["all"]["all"].values())
    print(f"\n{total} questions, {sum(dropped.values())} designs without a truth {dict(dropped)}")
    if finest:
        print(f"the finest model everywhere costs {finest / spent:.2f} times what deciding does")
    if args.wrong:
        order = {s: k for k, s in enumerate(("error", "unsafe pass", "false fail", "undecided"))}
        with args.wrong.open("w") as out:
            for result, tag, kept, true, said, spec in sorted(wrong, key=lambda w: order[w[0]]):
                out.write(f"# {result}: {tag}, {'kept' if kept else 'missed'}; true {true:.6g}, ")
                out.write(f"said {said.verdict} {said.factors} {said.ranges} by {said.models}, ")
                out.write(f"exit {said.exit_code} {said.text[-300:]!r}\n")
                text = yaml.safe_dump(spec, sort_keys=False, width=10_000, default_flow_style=None)
                out.write(text + "---\n")


if __name__ == "__main__":
    main()
