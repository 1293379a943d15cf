"""Random mechanisms in space: one or two bodies on blades and rods that point any way."""

from typing import NamedTuple

import numpy as np

LENGTH = 20e-3
"""Of a blade, about [m]."""


class SpaceScene(NamedTuple):
    """A spec without requirements, and easy ones for it."""

    spec: dict
    easy: dict
    kind: str = "space-layout"


def space_scene(seed):
    """Return the mechanism of a seed: two to five members hold each body on the one before it."""
    rng = np.random.default_rng(seed)
    bodies, blades, rods, before, height = {}, {}, {}, "ground", 0.0
    for name in ("frame", "top")[int(rng.integers(2)) :]:
        height += 1.5 * LENGTH
        place = [*rng.uniform(-LENGTH, LENGTH, 2), height]
        bodies[name] = {
            "at": _metres(place),
            "com": _metres(place + rng.uniform(-0.3, 0.3, 3) * LENGTH),
            "mass": f"{_log(rng, 1e-3, 1.0)!r} kg",
            "inertia": [f"{_log(rng, 1e-7, 1e-4)!r} kg*m^2"] * 3,
        }
        for k in range(int(rng.integers(2, 6))):
            start, way = rng.uniform(-1.5, 1.5, 3) * LENGTH, _way(rng)
            l = LENGTH * _log(rng, 0.5, 2.0)
            member = {
                "between": [before, name], "from": _metres(start),
                "to": _metres(start + l * way),
            }  # fmt: skip
            if rng.random() < 0.3:
                rods[f"{name}-rod-{k}"] = {**member, "d": f"{l * _log(rng, 0.01, 0.12)!r} m"}
                continue
            h = l * _log(rng, 3e-3, 0.12)
            b = float(np.clip(l * _log(rng, 0.03, 2.0), h, 2.0 * l))
            width = np.cross(way, _way(rng))
            blades[f"{name}-{k}"] = {
                **member, "h": f"{h!r} m", "b": f"{b!r} m", "width": [float(x) for x in width],
            }  # fmt: skip
        before = name
    axis = [float(x) for x in _way(rng)]
    turns = rng.random() < 0.5
    geometry = {
        "kind": "space-layout", "bodies": bodies, "moving": before,
        "motion": {"rotation": {"about": axis, "at": bodies[before]["at"]}} if turns
        else {"translation": axis},
    }  # fmt: skip
    geometry |= {key: each for key, each in (("blades", blades), ("rods", rods)) if each}
    material = {
        "name": "drawn", "youngs_modulus": "114 GPa", "density": "4430 kg/m^3",
        "poisson_ratio": float(rng.choice([0.0, 0.3, 0.34, 0.45])), "yield_strength": "800 MPa",
    }  # fmt: skip
    unit = "N*m/rad" if turns else "N/m"
    return SpaceScene(
        {
            "flexure": 1, "title": f"space seed {seed}", "material": material,
            "geometry": geometry, "cases": {"work": {"wrench": {"x": "1 uN"}}},
        },
        {"stiffness": {"min": f"1e-12 {unit}"}, "frequency": {"min": "1e-9 Hz"}},
    )  # fmt: skip


def _log(rng, low, high):
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _way(rng):
    found = rng.normal(size=3)
    return found / np.linalg.norm(found)


def _metres(place):
    return [f"{float(x)!r} m" for x in place]
