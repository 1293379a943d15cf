"""A slender sample of every flexure that a spec can name, at any scale and of any sizes."""

from collections.abc import Callable
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries import GEOMETRIES, Geometry
from flexcli.parts.geometries.any_flexure import AnyFlexure
from flexcli.parts.named import Kinds

ELASTIC = Elastic(114e9, 0.34)

MATERIAL = {
    "name": "titanium",
    "youngs_modulus": "114 GPa",
    "yield_strength": "800 MPa",
    "poisson_ratio": 0.34,
    "density": "4430 kg/m^3",
}

BLADE = {"h": 0.1, "l": 20.0, "b": 5.0}
NOTCHED = {"e": 0.05, "r": 2.0, "l": 40.0, "b": 5.0}
BENT = {"half_angle": "40 deg"}

SAMPLES: dict[str, dict[str, Any]] = {
    "cantilever": BLADE,
    "guided-blade": BLADE,
    "moment-blade": BLADE,
    "rcc": {**BLADE, **BENT, "p": 3.0},
    "cross-spring": {**BLADE, **BENT, "p": -6.0},
    "unseparated-cross": {**BLADE, **BENT, "crossing": 0.4},
    "three-blade": {**BLADE, "p": 1.0},
    "star": {**BLADE, "angles": ["-50 deg", "0 deg", "60 deg"], "p": 2.0},
    "leaf-spring-stage": {**BLADE, "blades": 3, "spacing": 15.0, "drive": 6.0},
    "necked-down-stage": {**BLADE, "l_c": 4.0, "blades": 3, "spacing": 15.0},
    "notch-hinge": {"e": 0.05, "r": 2.0, "b": 5.0},
    "elliptic-hinge": {"e": 0.05, "depth": 1.0, "l": 6.0, "b": 5.0},
    "filleted-hinge": {"h": 0.1, "r": 0.5, "l": 10.0, "b": 5.0},
    "hinged-stage": {**NOTCHED, "limbs": 3, "spacing": 15.0},
    "hinged-pivot": {**NOTCHED, **BENT, "p": -10.0},
    "torsion-bar": {"h": 0.5, "l": 20.0, "b": 4.0, "bars": 2, "warping": "restrained"},
    "round-torsion-bar": {"d": 0.5, "l": 20.0, "bars": 2},
    "torsion-star": {"h": 0.2, "l": 20.0, "b": 4.0, "strips": 3},
}
"""What a spec says of each kind: the numbers that are not counts or shares are lengths in mm."""

RATIOS = {"crossing", "delta"}


def kinds(union: Kinds = GEOMETRIES) -> dict[str, type[Geometry]]:
    """Return every geometry by the name that a spec gives it."""
    return union.by_kind


def spec(kind: str, scale: float = 1.0, **changes: Any) -> dict[str, Any]:
    """Return what a spec says of a sample, all its lengths times a scale."""
    said = {**SAMPLES[kind], **changes}
    return {
        "kind": kind,
        **{
            name: f"{value * scale!r} mm"
            if isinstance(value, float) and name not in RATIOS
            else value
            for name, value in said.items()
        },
    }


ADAPTER: TypeAdapter[Geometry] = TypeAdapter(AnyFlexure)


def geometry(kind: str, scale: float = 1.0, **changes: Any) -> Geometry:
    """Return a sample as the part that a spec makes of it."""
    return ADAPTER.validate_python(spec(kind, scale, **changes))


def travel(part: Geometry) -> float:
    """Return a small travel of a sample: 10 mrad, or 0.1 mm."""
    return 1e-2 if part.motion == "rotation" else 1e-4


def asked(form: Callable[..., Any], *arguments: Any) -> Any:
    """Return what a part answers, or why it has no answer."""
    try:
        return form(*arguments)
    except NotAvailable as reason:
        return reason


SPREAD = 1.3
"""Largest factor on a length of a sample, or on what is one over it."""


def varied(kind: str, rng: np.random.Generator) -> Geometry:
    """Return a joint of a kind with sizes, places, angles and numbers of its own."""
    changes: dict[str, Any] = {}
    for name, value in SAMPLES[kind].items():
        factor = float(SPREAD ** rng.uniform(-1.0, 1.0))
        if name == "angles":
            told = [float(each.split()[0]) + rng.uniform(-10.0, 10.0) for each in value]
            changes[name] = [f"{each!r} deg" for each in told]
        elif name in ("blades", "limbs"):
            changes[name] = int(rng.integers(2, 5))
        elif isinstance(value, float):
            changes[name] = value * factor
        elif str(value).endswith(" deg"):
            changes[name] = f"{float(value.split()[0]) * factor!r} deg"
    return geometry(kind, **changes)
