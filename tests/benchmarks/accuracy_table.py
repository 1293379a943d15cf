"""What accuracy costs: error and time of every model on three joints, as Markdown.

Run by hand: OMP_NUM_THREADS=1 python tests/benchmarks/accuracy_table.py

Times are medians; compare the rows of one run, and not runs or machines.
"""

import sys
from math import inf
from pathlib import Path

from judging import size_as_printed

from flexcli.engine.accuracy import accuracy
from flexcli.parts.design import DesignSpec
from flexcli.spec.load import load

ROCKET = Path(__file__).parents[2] / "examples" / "rocket-parallel-stage" / "flexure.yaml"
RUNS = 15
TITANIUM = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.34, "yield_strength": "830 MPa"}
BLADE = {"h": "0.1 mm", "l": "20 mm", "b": "5 mm"}
PIVOT = {"kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg", **BLADE}
STAGE = {"kind": "leaf-spring-stage", "blades": 2, "spacing": "30 mm", **BLADE}


def joint(geometry, stroke):
    """Return a design of one joint and its sizes."""
    design = DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": TITANIUM,
            "geometry": geometry,
            "cases": {"stroke": {"stroke": stroke}},
            "requirements": {"yield": 1},
        }
    )
    return design, design.fixed_sizes()


def rocket():
    """Return the pivot that sizing gives the stage of the rocket's take-off."""
    design = load(ROCKET).part
    values = size_as_printed(design, str(ROCKET)).values
    free = {name: values[name].value for name in design.geometry.free}
    return design, design.geometry.sized(free)


CASES = {
    "RCC pivot of the rocket's stage, θ = 1.17°, locked at take-off": rocket,
    "Symmetric cross-spring pivot, θ = 15°": lambda: joint(PIVOT, {"rotation": "15 deg"}),
    "Stage of two leaf springs, x/l = 0.2": lambda: joint(STAGE, {"translation": "4 mm"}),
}


def told(error, bound):
    """Return a relative error, or that it is below what the finest knows."""
    if error == inf:
        return "–"
    return f"≤ {bound:.0e}" if error < bound else f"{error:.1e}"


def rows(design, sizes):
    """Yield the lines of one table."""
    found = accuracy(design, sizes, "", RUNS, 1e-2).accuracy
    yield "| model | " + " | ".join(q.label for q in found.quantities) + " | time | ratio |"
    yield "|:--|" + "--:|" * (len(found.quantities) + 2)
    first = found.models[0].seconds
    for model in found.models:
        if model.missing:
            continue
        cells = []
        for quantity in found.quantities:
            error = next(r.error for r in quantity.readings if r.model == model.model)
            cells.append(told(error, quantity.bound))
        name = f"**{model.model}**" if model.pareto else model.model
        time = f"{model.seconds * 1e3:.3g} ms | {model.seconds / first:.3g}"
        yield f"| {name} | " + " | ".join(cells) + f" | {time} |"


def main():
    """Print all tables."""
    print("Errors are relative to the finest model; bold: no model is both faster and nearer.")
    for title, build in CASES.items():
        print(f"\n{title}\n")
        for row in rows(*build()):
            print(row)


if __name__ == "__main__":
    sys.exit(main())
