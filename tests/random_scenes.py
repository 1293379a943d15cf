"""Random designs for the plan: kinds, shapes, strokes, loads and accuracies from a seed."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from flexcli.parts.design import DesignSpec

KINDS = ("rcc", "cross-spring", "leaf-spring-stage", "guided-blade", "cantilever")
MATERIAL = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.33, "yield_strength": "900 MPa"}


def scenes(count: int, seed: int = 0) -> Iterator[DesignSpec]:
    """Yield designs: δ −1…1, α 20…70°, h/l 1e-3…0.1, θ or x/l to 0.3, b/h 1…50."""
    rng = np.random.default_rng(seed)
    for _ in range(count):
        yield DesignSpec.model_validate(_spec(rng))


def _spec(rng: np.random.Generator) -> dict[str, Any]:
    kind = str(rng.choice(KINDS))
    l, h_over_l = 20e-3, 10.0 ** rng.uniform(-3.0, -1.0)
    h = h_over_l * l
    b = min(h * 10.0 ** rng.uniform(0.0, np.log10(50.0)), 2.0 * l)
    geometry: dict[str, Any] = {"kind": kind} | {
        name: f"{value!r} m" for name, value in (("h", h), ("l", l), ("b", b))
    }
    travel = 10.0 ** rng.uniform(-3.0, np.log10(0.3))
    stroke = {"translation": f"{travel * l!r} m"}
    if kind in ("rcc", "cross-spring"):
        delta = float(rng.uniform(0.0 if kind == "rcc" else -1.0, 1.0))
        geometry["half_angle"] = f"{rng.uniform(20.0, 70.0)!r} deg"
        geometry |= {"p": f"{delta * l!r} m"} if kind == "rcc" else {"delta": delta}
        stroke = {"rotation": f"{travel!r} rad"}
    if kind == "leaf-spring-stage":
        geometry["spacing"] = f"{float(rng.uniform(0.5, 2.0)) * l!r} m"
    case: dict[str, Any] = {"stroke": stroke}
    if rng.random() < 0.4:  # up to a third of Euler's load for guided ends
        euler = np.pi**2 * 114e9 * b * h**3 / 12.0 / l**2
        case["load"] = {"force": f"{float(10.0 ** rng.uniform(-4.0, -0.5) * euler)!r} N"}
        if kind == "cantilever":
            case["load"]["force"] = f"{float(10.0 ** rng.uniform(-4.0, -1.2) * euler)!r} N"
    return {
        "flexure": 1,
        "material": {"name": "titanium", **MATERIAL},
        "geometry": geometry,
        "cases": {"work": case},
        "requirements": {"yield": 1.5},
        "accuracy": float(10.0 ** rng.uniform(-3.0, -1.0)),
    }
