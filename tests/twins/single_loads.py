"""Random joints under one small force or moment at a time: what no larger load hides.

The joints are those of the campaign. Loads are a millionth of what makes a blade yield, so that all
models tell the first order, to within their errors of it.
"""

from dataclasses import replace

import numpy as np
import yaml

import flexcli
from twins.campaign import scene
from twins.coupled import COUPLED, FORCES, MOMENTS
from twins.drawn_in_space import JOINTS, in_space

SMALL = 1e-6
"""Of the moment that makes a blade yield, or of that over its length."""


def single_loads(seed, kinds=COUPLED, share=SMALL):
    """Yield the joint of a seed under three loads, each a share of what makes a blade yield."""
    drawn, rng = scene(seed, kinds), np.random.default_rng(seed)
    spec = {key: drawn.spec[key] for key in ("flexure", "title", "geometry", "material")}
    material, geometry = {"poisson_ratio": 0.3, **spec["material"]}, dict(spec["geometry"])
    if not {"youngs_modulus", "yield_strength"} <= set(material):
        return  # a crystal's numbers depend on where its blades point
    if geometry["kind"] in ("leaf-spring-stage", "necked-down-stage"):
        geometry.setdefault("spacing", geometry["l"])
    moment, l = bending(geometry, share * float(material["yield_strength"].split()[0]))
    for way in map(str, rng.permutation([*FORCES, *MOMENTS])[:3]):
        load = f"{moment / l!r} N" if way in FORCES else f"{moment!r} N*m"
        asked = {
            "yield": {"factor": 1e-9},
            "deflection": {"direction": way, "max": "1e3 m" if way in FORCES else "1e3 rad"},
        }
        case = {"cases": {"work": {"wrench": {way: load}}}, "requirements": asked}
        yield replace(drawn, spec={**spec, "material": material, "geometry": geometry, **case})


def twin_of(spec):
    """Return a spec drawn in space, or None where it can't be."""
    if spec["geometry"]["kind"] not in JOINTS:
        return None
    return in_space(spec, flexcli.load(yaml.safe_dump(spec)))


def bending(geometry, strength):
    """Return the moment of a blade of that stress [N·m], and some length of it [m]."""
    blades = geometry.get("blades")
    sizes = next(iter(blades.values())) if isinstance(blades, dict) else geometry

    def size(*names):
        found = (each[name] for each in (sizes, geometry) for name in names if name in each)
        return float(str(next(found, "0.05 m")).split()[0])

    return strength * size("b", "d") * size("h", "e", "d") ** 2 / 6.0, size("l", "r")
