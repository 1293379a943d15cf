"""10 000 random pivots and stages by the exact solver: how many converge, what the others say.

Run: python tests/benchmarks/exact_random.py [designs]. δ from −1 to 1, α from 15° to 75°, h/l from
1e-5 to 0.3 (logarithmic), strokes to 90° of a pivot and to 0.5 l of a stage, radial loads to 0.95
of what a blade clamped at both ends bears.
"""

import sys
from collections import Counter

import numpy as np

from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load

E, G, CHUNK = 114e9, 42.5e9, 1250
FULL = np.radians(90.0)


def pivots(rng, n, stroke):
    """Return layout, motions held and loads of n pivots."""
    l, b = np.full(n, 20e-3), 10e-3
    h = l * 10.0 ** rng.uniform(-5.0, np.log10(0.3), n)
    delta, alpha = rng.uniform(-1.0, 1.0, n), np.radians(rng.uniform(15.0, 75.0, n))
    blades = []
    for name, side in (("upper", 1.0), ("lower", -1.0)):
        c, s = np.cos(alpha), side * np.sin(alpha)
        ends = [(r * c, r * s) for r in ((delta + 1.0) * l, delta * l)]
        blades.append(Blade(name, "ground", "out", *ends, Constant(h[:, None]), b))
    layout = Layout((Body("out", (0.0, 0.0)),), tuple(blades), E, G)
    critical = 4.0 * np.pi**2 * E * b * h**3 / 12.0 / l**2 * 2.0 * np.cos(alpha)
    load = rng.uniform(-0.95, 0.95, n) * critical * rng.integers(0, 2, n)
    theta = rng.uniform(-stroke, stroke, n)
    return layout, {"out": (None, None, theta)}, [Load("out", (0.0, 0.0), (load, 0.0))]


def stages(rng, n, stroke):
    """Return layout, motions held and loads of n parallelograms that keep their table upright."""
    l, b = 20e-3, 10e-3
    h = l * 10.0 ** rng.uniform(-5.0, np.log10(0.3), n)
    blades = tuple(
        Blade(name, "ground", "table", (0.0, y), (l, y), Constant(h[:, None]), b)
        for name, y in (("left", -l), ("right", l))
    )
    layout = Layout((Body("table", (l, 0.0)),), blades, E, G)
    critical = np.pi**2 * E * b * h**3 / 12.0 / l**2 * 2.0
    load = rng.uniform(-0.95, 0.95, n) * critical * rng.integers(0, 2, n)
    x = rng.uniform(-0.5, 0.5, n) * l * stroke / FULL
    return layout, {"table": (None, x, None)}, [Load("table", (l, 0.0), (load, 0.0))]


def main():
    """Print rates and outcomes by kind and stroke."""
    designs = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    rng = np.random.default_rng(6)
    print(f"{'kind':8} {'stroke':>7} {'designs':>8} {'per s':>7}  outcomes")
    for make in (pivots, stages):
        for degrees in (10, 30, 60, 90):
            count, spent, ends = designs // 8, 0.0, Counter()
            for first in range(0, count, CHUNK):
                size = min(CHUNK, count - first)
                layout, held, loads = make(rng, size, np.radians(degrees))
                found = solve(layout, held, loads=loads)
                assert np.isfinite(found.motions).all()
                spent += found.seconds
                ends.update(outcome.name for outcome in found.outcome)
                ends["stable"] += int(np.sum((found.unstable == 0) & found.converged))
            rate = count / spent
            print(f"{make.__name__:8} {degrees:6}° {count:8} {rate:7.0f}  {dict(ends)}")


if __name__ == "__main__":
    main()
