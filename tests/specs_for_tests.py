"""Specs that several test files judge: a parallelogram in space, notched bodies of steel."""

import yaml

import flexcli

__all__ = ["in_steel", "parallelogram"]


def parallelogram(h, b):
    """Return two blades of 20 mm, 30 mm apart, to a stage that moves along x."""
    blade = {"between": ["ground", "stage"], "h": h, "b": b, "width": "z"}
    return {
        "kind": "space-layout",
        "bodies": {"stage": {"at": ["0 mm", "20 mm", "0 mm"]}},
        "blades": {
            name: {**blade, "from": [x, "0 mm", "0 mm"], "to": [x, "20 mm", "0 mm"]}
            for name, x in (("left", "-15 mm"), ("right", "15 mm"))
        },
        "moving": "stage",
        "motion": {"translation": "x"},
    }


def in_steel(geometry, requirements, model=None, verb=flexcli.check, **more):
    """Return what a verb says of a design whose width keeps nothing flat (ν = 0), E = 100 GPa."""
    spec = {
        "flexure": 1,
        "title": "notch",
        "material": {
            "name": "steel", "youngs_modulus": "100 GPa", "poisson_ratio": 0.0,
            "density": "8 g/cm^3", "yield_strength": "1 GPa",
        },
        "geometry": geometry,
        "requirements": requirements,
        **more,
    }  # fmt: skip
    return verb(yaml.safe_dump(spec), model=model)
