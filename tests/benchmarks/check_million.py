"""Check a million (h, l, b) triples in one call and print the designs per second.

Run by hand: python tests/benchmarks/check_million.py
"""

from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from flexcli.engine.assess import checks, factors
from flexcli.parts.geometries import Blade
from flexcli.spec.load import load

EXAMPLE = Path(__file__).parents[2] / "examples" / "rocket-parallel-stage" / "flexure.yaml"
DESIGNS, ALONE, REPEATS = 1_000_000, 500, 5


def seconds(work):
    times = []
    for _ in range(REPEATS):
        started = perf_counter()
        work()
        times.append(perf_counter() - started)
    return median(times), min(times), max(times)


def main():
    design = load(EXAMPLE).part
    generator = np.random.default_rng(20_261_121)
    h = 10 ** generator.uniform(-4.3, -3.0, DESIGNS)
    l = 10 ** generator.uniform(-2.3, -1.3, DESIGNS)
    b = 10 ** generator.uniform(-3.0, -2.0, DESIGNS)
    together, low, high = seconds(lambda: factors(design, h=h, l=l, b=b))
    margins = factors(design, h=h, l=l, b=b)
    passing = np.logical_and.reduce([m >= 1.0 for m in margins.values()])

    def one_by_one():
        for row in zip(h[:ALONE], l[:ALONE], b[:ALONE], strict=True):
            checks(design.limits(Blade(*map(float, row))))

    apart, _, _ = seconds(one_by_one)
    print(f"{DESIGNS:,} designs, {len(margins)} checks each; {passing.mean():.1%} pass")
    rate, rate_apart = DESIGNS / together, ALONE / apart
    print(f"one call:   {together:.3f} s ({low:.3f} to {high:.3f}), {rate:,.0f} designs/s")
    print(f"one by one: {rate_apart:,.0f} designs/s")
    print(f"ratio: {rate / rate_apart:.0f}")


if __name__ == "__main__":
    main()
