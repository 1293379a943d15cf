"""Random mechanisms in space: one or two bodies on blades and rods that point any way."""

from typing import NamedTuple

import numpy as np

from twins.coupled import FORCES, MOMENTS

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


def loaded_scene(seed):
    """Return that mechanism under a wrench, and some with a stroke, an acceleration or a shaking.

    Loads strain a blade to between 1e-6 and some share of yielding, as bending tells by its size.
    """
    drawn, rng = space_scene(seed), np.random.default_rng(seed + 10**6)
    geometry = drawn.spec["geometry"]
    members = [*geometry.get("blades", {}).values(), *geometry.get("rods", {}).values()]
    moment = min(_bears(member) for member in members)
    share = _log(rng, 1e-6, 0.5)
    wrench = {}
    for way in _two(rng):
        size = rng.choice([-1.0, 1.0]) * share * moment / (1.0 if way in MOMENTS else LENGTH)
        wrench[way] = f"{float(size)!r} {'N*m' if way in MOMENTS else 'N'}"
    case = {"wrench": wrench}
    if rng.random() < 0.4:
        turns = "rotation" in geometry["motion"]
        travel = _log(rng, 1e-6, 1e-2) * (1.0 if turns else LENGTH)
        unit = "rad" if turns else "m"
        case["stroke"] = {"rotation" if turns else "translation": f"{travel!r} {unit}"}
    if rng.random() < 0.3:
        case["acceleration"] = {
            "level": f"{_log(rng, 1e-3, 10.0)!r} g",
            "axis": str(rng.choice([*"xyz"])),
        }
    if rng.random() < 0.3:
        case |= {"asd": {"profile": "gevs-qualification", "q": 20}}
    easy = {
        **drawn.easy, "yield": {"factor": 1e-9}, "buckling": {"factor": 1e-9},
        "support": [
            {"direction": way, "min": f"1e-12 {'N*m/rad' if way in MOMENTS else 'N/m'}"}
            for way in _two(rng)
        ],
        "deflection": [
            {"direction": way, "max": f"1e3 {'rad' if way in MOMENTS else 'm'}"}
            for way in _two(rng)
        ],
        "parasitic_frequency": {"min": "1e-9 Hz"},
    }  # fmt: skip
    if "stroke" in case:
        easy["parasitic_shift"] = {"max": "1e3 m"}
        case["stroke"]["cycles"] = 1e6
    if "asd" in case:
        easy["dynamic-yield"] = {"factor": 1e-9}
    return drawn._replace(spec={**drawn.spec, "cases": {"work": case}}, easy=easy)


def _two(rng):
    return [str(way) for way in rng.permutation([*FORCES, *MOMENTS])[:2]]


def _bears(member):
    """Return about the moment that a member bears [N·m]."""
    number = {key: float(member[key].split()[0]) for key in ("h", "b", "d") if key in member}
    d = number.get("d")
    section = d**3 / 10.0 if d else number["b"] * number["h"] ** 2 / 6.0
    return 800e6 * section


def _log(rng, low, high):
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def _way(rng):
    found = rng.normal(size=3)
    return found / np.linalg.norm(found)


def _metres(place):
    return [f"{float(x)!r} m" for x in place]
