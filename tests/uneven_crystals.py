"""Random pivots of crystals and sheets whose blades point in directions of unlike stiffness."""

from math import cos, radians, sin

import numpy as np

L = 20.0
"""Length of each blade [mm]."""

MATERIALS = (
    {"crystal": {"c11": "165.7 GPa", "c12": "63.9 GPa", "c44": "79.6 GPa"}},  # silicon
    {"crystal": {"c11": "128.5 GPa", "c12": "48.3 GPa", "c44": "66.8 GPa"}},  # germanium
    {"crystal": {"c11": "246.5 GPa", "c12": "147.3 GPa", "c44": "124.7 GPa"}},  # nickel
    {"orthotropic": {"E_1": "140 GPa", "E_2": "10 GPa", "G_12": "5 GPa", "nu_12": 0.3}},
    {"orthotropic": {"E_1": "40 GPa", "E_2": "12 GPa", "G_12": "4.5 GPa", "nu_12": 0.26}},
)

KINDS = ("three-blade", "rcc", "cross-spring", "star", "layout")


def uneven_spec(seed):
    """Return the spec of a seed, asked for stiffness and yield at a small stroke."""
    rng = np.random.default_rng(seed)
    kind, material = (each[int(rng.integers(len(each)))] for each in (KINDS, MATERIALS))
    h = L / float(np.exp(rng.uniform(np.log(18.0), np.log(200.0))))
    b = min(h * float(np.exp(rng.uniform(np.log(1.5), np.log(60.0)))), 1.9 * L)
    orientation = {"turned": f"{rng.uniform(0.0, 90.0)} deg"}
    if "crystal" in material:
        orientation["wafer"] = str(rng.choice(["100", "110", "111"]))
    size = {"h": f"{h} mm", "b": f"{b} mm"}
    geometry = {"kind": kind, **size, "l": f"{L} mm"}
    if kind in ("rcc", "three-blade", "star"):
        geometry["p"] = f"{rng.uniform(0.5, 10.0)} mm"
    if kind in ("rcc", "cross-spring"):
        geometry["half_angle"] = f"{rng.uniform(20.0, 70.0)} deg"
    if kind == "cross-spring":
        geometry["delta"] = -float(rng.uniform(0.1, 0.5))
    if kind == "star":
        others = rng.uniform(50.0, 110.0), rng.uniform(140.0, 250.0)
        geometry["angles"] = [f"{angle} deg" for angle in (0.0, *others)]
    if kind == "layout":
        blades = {}
        for k, middle in enumerate((30.0, 150.0, 270.0)):
            angle, inner = radians(middle + rng.uniform(-50.0, 50.0)), rng.uniform(5.0, 15.0)
            way = np.array([cos(angle), sin(angle)])
            ends = ("from", (inner + L) * way), ("to", inner * way)
            places = {key: [f"{x:.6f} mm" for x in place] for key, place in ends}
            blades[f"blade-{k}"] = {"between": ["ground", "body"], **places, **size}
        geometry = {
            "kind": "layout", "bodies": {"body": {"at": ["0 m", "0 m"]}}, "blades": blades,
            "moving": "body", "motion": "rotation",
        }  # fmt: skip
    return {
        "flexure": 1,
        "material": {**material, "orientation": orientation, "yield_strength": "800 MPa"},
        "geometry": geometry,
        "cases": {"work": {"stroke": {"rotation": "0.1 mrad"}}},
        "requirements": {"yield": 1e-9, "stiffness": {"min": "1e-12 N*m/rad"}},
    }  # fmt: skip
