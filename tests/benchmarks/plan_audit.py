"""How often a plan is right over 200 random scenes, and what its accuracies cost on one spec.

Run: python tests/benchmarks/plan_audit.py [scenes] [seed]
"""

import sys
from pathlib import Path
from statistics import median
from time import perf_counter
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))
from random_scenes import MATERIAL, scenes

from flexcli.engine.check import check
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.plan import plan, planned_model
from flexcli.engine.planning.audit import audit
from flexcli.parts.design import DesignSpec

PIVOT = {
    "kind": "cross-spring", "delta": -0.3, "half_angle": "45 deg",
    "h": "0.3 mm", "l": "10 mm", "b": "2 mm",
}  # fmt: skip
RUNS = 9
CONTROL = ExactModel(tolerance=1e-12, levels=(10, 15, 22, 33, 50))
"""As fine as can be, on other nodes than those of the model that is judged."""


def rates(count: int, seed: int) -> None:
    """Print how many effects were left out wrongly, and how many were on for nothing."""
    left = wrong = switched = idle = bounded = 0
    for design in scenes(count, seed):
        sizes = design.fixed_sizes()
        found = plan(design, sizes)
        rows = audit(design, sizes, found)
        for effect in found.effects:
            mine = [row for row in rows if row.effect == effect.name]
            true = [abs(row.true) for row in mine if row.true is not None]
            bounded += len(mine) - len(true)
            if not effect.on:
                left += 1
                wrong += any(share > found.accuracy for share in true)
            elif true:
                switched += 1
                idle += max(true) < found.accuracy / 10.0
    print(f"{count} scenes, seed {seed}")
    print(f"off: {left}, of which change a number by more than the accuracy: {wrong}")
    print(f"on: {switched}, of which change every number by less than a tenth of it: {idle}")
    print(f"numbers that the finest model does not tell: {bounded}")


def promises() -> None:
    """Print model, declared and measured cost, and true error for four accuracies of one spec."""
    reference: float | None = None
    for accuracy in (0.1, 0.01, 0.001, 1e-6):
        design = _design(accuracy)
        sizes = design.fixed_sizes()
        found = plan(design, sizes)
        joint_model = planned_model(found)
        result, truth = check(design, sizes, "", joint_model), check(design, sizes, "", CONTROL)
        errors = [
            abs(result.values[name].value / truth.values[name].value - 1.0)
            for name in ("k_pivot", "shift")
        ]
        errors.append(abs(result.checks[0].demand / truth.checks[0].demand - 1.0))
        seconds = median(_seconds(design, sizes, joint_model) for _ in range(RUNS))
        reference = reference or seconds
        print(
            f"{accuracy:8.1e}  {joint_model.name}: declared {found.cost:.3g}, measured "
            f"{seconds / reference:.3g}, true error {max(errors):.1e}"
        )


def _design(accuracy: float) -> DesignSpec:
    spec: dict[str, Any] = {
        "flexure": 1,
        "material": {"name": "titanium", **MATERIAL},
        "geometry": PIVOT,
        "cases": {"work": {"stroke": {"rotation": "4 deg"}}},
        "requirements": {"yield": 1.0},
        "accuracy": accuracy,
        "effects": {"plate-widening": "off", "anticlastic": "off"},
    }
    return DesignSpec.model_validate(spec)


def _seconds(design: DesignSpec, sizes: Any, joint_model: Any) -> float:
    begun = perf_counter()
    check(design, sizes, "", joint_model)
    return perf_counter() - begun


if __name__ == "__main__":
    asked = [int(word) for word in sys.argv[1:]]
    rates(*(asked + [200, 0][len(asked) :]))
    promises()
