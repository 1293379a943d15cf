"""Drawn layouts as specs, and what shells are asked of them."""

import yaml
from drawn_layouts import E

import flexcli
from flexcli.parts.requirements import AS_PRINTED


def spec_of(drawn):
    """Return the spec of a drawn layout that moves from rest, asked for its shift."""
    turns = drawn.spec["motion"] == "rotation"
    motion, unit = ("rotation", "rad") if turns else ("translation", "m")
    return {
        "flexure": 1, "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": drawn.nu},
        "geometry": drawn.spec,
        "cases": {"work": {"stroke": {motion: [f"0 {unit}", f"{drawn.travel} {unit}"]}}},
        "requirements": {"parasitic_shift": {"max": "1 m"}},
    }  # fmt: skip


def asked(spec):
    """Return the question of the shift of a spec's only case."""
    design = flexcli.load(yaml.safe_dump(spec)).part
    (scene,) = design.scenes()
    return design.ask(scene, design.fixed_sizes(), AS_PRINTED)
