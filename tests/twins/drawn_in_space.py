"""Joints of the plane drawn anew in space, whose bodies have all six freedoms."""

from typing import NamedTuple

import numpy as np
import yaml

import flexcli
from flexcli.errors import SolveError, SpecError
from flexcli.formulas.profile import Constant
from flexcli.parts.elastic import Elastic, NotAvailable
from twins.campaign import scene

JOINTS = ("rcc", "cross-spring", "star", "three-blade", "cantilever", "leaf-spring-stage",
          "layout", "layout-pivot")  # fmt: skip
PLAIN = {"stroke", "wrench", "acceleration", "asd", "shock", "temperature"}
"""What of a case has the same words in space."""

SHAKES = {"asd", "shock"}
SHAKEN = ("stiffness", "frequency", "dynamic-yield", "support")
SAME = ("yield", "fatigue", "stiffness", "deflection", "frequency", "dynamic-yield", "support",
        "parasitic_shift", "drive")  # fmt: skip
"""Requirements of the same words, in cases that shake the base and in others: the yield of a
drawing in space has nothing of what shakes it. Its shift is all of its motion aside, out of the
plane too, where that of a joint of the plane is in the plane: of one that tilts they differ."""

ROUNDING = 1e-7


def turned(vector, turn):
    """Return a vector turned about z, as words."""
    x, y, z = vector
    c, s = np.cos(turn), np.sin(turn)
    return [float(c * x - s * y), float(s * x + c * y), float(z)]


def metres(vector):
    return [f"{each!r} m" for each in vector]


def in_space(spec, loaded):
    """Return a planar spec drawn in space, along the axes of its cases; None where it can't be."""
    design = loaded.part
    geometry, sizes, material = design.geometry, design.fixed_sizes(), design.material
    if geometry.is_guided or material.poisson_ratio is None or geometry.has_masses:
        return None
    if getattr(geometry, "tilt", "free") == "held" or "effects" in spec:
        return None
    if getattr(geometry, "clamps", None) not in (None, "rigid"):
        return None
    E, nu = material.elastic
    try:
        layout = geometry.space_layout(Elastic(E, nu), sizes)
    except NotAvailable:
        return None
    if layout.springs or not all(isinstance(b.profile, Constant) for b in layout.blades):
        return None
    back, drive = -geometry.axes, layout.drive
    if material.is_directed and abs(np.sin(back)) > ROUNDING:
        return None  # its directions are of the axes in which blades are drawn
    mechanism = spec.get("mechanism")
    if mechanism is not None and mechanism["kind"] != "payload":
        return None
    bodies = {}
    for body in layout.bodies:
        words = {"at": metres(turned(body.point, back))}
        if mechanism is not None and body.name == drive.body:
            x, y = geometry.payload_point(body.point[:2])
            about = mechanism.get("inertia", "1e-20 kg*m^2")
            words |= {"com": metres(turned((x, y, 0.0), back)), "mass": mechanism["mass"],
                      "inertia": [about] * 3}  # fmt: skip
        bodies[body.name] = words
    blades = {}
    for k, blade in enumerate(layout.blades):
        blades[f"b{k}"] = {
            "between": [blade.first, blade.second],
            "from": metres(turned(blade.start, back)), "to": metres(turned(blade.end, back)),
            "h": f"{float(blade.profile.h)!r} m", "b": f"{blade.b!r} m", "width": "z",
        }  # fmt: skip
    way = turned(drive.direction, back)
    motion = {"rotation": {"about": [0, 0, 1]}} if drive.turns else {"translation": way}
    cases = {}
    for name, case in spec["cases"].items():
        if not set(case) <= PLAIN:
            return None
        cases[name] = {**case, **_warmed(case, drive.body)}
    drawing = {"kind": "space-layout", "bodies": bodies, "blades": blades,
               "moving": drive.body, "motion": motion}  # fmt: skip
    kept = {key: words for key, words in spec.items() if key not in ("mechanism", "geometry")}
    return {**kept, "geometry": drawing, "cases": cases}


def _warmed(case, moving):
    """Return the temperature of a case with its bodies' names in space, if it has one."""
    warm = case.get("temperature", {})
    if "bodies" not in warm:
        return {}
    bodies = {"ground" if key == "ground" else moving: more for key, more in warm["bodies"].items()}
    return {"temperature": {**warm, "bodies": bodies}}


def as_wrenches(spec):
    """Return a spec whose directed loads are wrenches, which act either way; others are left."""
    design, cases = flexcli.load(yaml.safe_dump(spec)).part, {}
    for name, case in spec["cases"].items():
        words = dict(case)
        if "direction" in case.get("load", {}) and "wrench" not in case:
            x, y, *_ = design.scene(name).stated
            x, y, _ = turned((x, y, 0.0), -design.geometry.axes)
            words["wrench"] = {"x": f"{x!r} N", "y": f"{y!r} N"}
            del words["load"]
        cases[name] = words
    return {**spec, "cases": cases}


def ranges(spec):
    """Return by check the range of its factor by the exact model, and its factor."""
    checks = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
    return {(c.name, c.case, c.path): (c.factor_range, c.factor) for c in checks}


class Compared(NamedTuple):
    """How many checks were compared, and a line for each of which the two ranges lie apart."""

    compared: int
    apart: list[str]


def apart(seed, kinds=JOINTS):
    """Return how a seed's spec compares with itself in space; None where it can't be drawn."""
    found = scene(seed, kinds)
    shaken = any(set(case) & SHAKES for case in found.spec["cases"].values())
    kept = SHAKEN if shaken else SAME
    easy = {name: words for name, words in found.easy.items() if name in kept}
    if not easy:
        return None
    try:
        spec = as_wrenches({**found.spec, "requirements": easy})
        loaded = flexcli.load(yaml.safe_dump(spec))
        twin, tilts = in_space(spec, loaded), loaded.part.geometry.may_tilt(loaded=True)
        if twin is None:
            return None
        own, other = ranges(spec), ranges(twin)
    except (SolveError, SpecError):
        return None  # what lacks a property, blades thicker than wide, loads beyond what it bears
    compared, lines = 0, []
    for key in own.keys() & other.keys():
        (mine, factor), (theirs, in_space_) = own[key], other[key]
        if mine is None or theirs is None or (tilts and key[0].startswith("parasitic shift")):
            continue
        compared += 1
        (low, high), (least, most) = mine, theirs
        if low > most * (1.0 + ROUNDING) or least > high * (1.0 + ROUNDING):
            lines.append(
                f"{seed} {found.kind} {key[0]}, {key[1]}: {factor:.6g} [{low:.6g}, {high:.6g}], "
                f"in space {in_space_:.6g} [{least:.6g}, {most:.6g}]"
            )
    return Compared(compared, lines)
