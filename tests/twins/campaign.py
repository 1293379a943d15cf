"""Random specs in the tool's own words, over every kind of joint, asked near their limits."""

from dataclasses import dataclass
from math import pi
from typing import NamedTuple

import numpy as np

from twins.kinds import (
    BARS,
    KINDS,
    LIMBS,
    NOTCHES,
    PIVOTS,
    ROOTED,
    TURNS,
)
from twins.rare_keys import draw_rare_keys
from twins.verdicts import ERROR, FALSE_FAIL, UNDECIDED, UNSAFE, Answer, answer, checked, spoken

ENDS = ("clamped-clamped", "clamped-guided", "clamped-pinned", "pinned-pinned", "clamped-free")
NEAR = 0.03
"""How far from a printed factor its requirement is set."""

LEAST, LONGEST = 1e-15, 1.0
"""Lengths [m]: a motion below the one is rounding, of what does not move by symmetry; nobody
asks for one beyond the other, nor beyond the length of what bends."""

LEAST_FACTOR = 0.1
"""A safety factor below which nobody asks: a stress ten times the strength."""

BY_SHELLS = ("yield", "fatigue", "parasitic_shift", "deflection", "support")
"""Requirements of which shells are asked in a joint of the plane."""

EASY = 1e-6
"""A factor that everything keeps: the first look at a design, which prints its factors."""


def m(value):
    return f"{float(value)!r} m"


def mouth(notch):
    """Return the height of the mouth of a notch hinge's geometry [m]."""
    sizes = {key: float(value.split()[0]) for key, value in notch.items() if key in "erh"}
    depth = float(notch["depth"].split()[0]) if "depth" in notch else sizes["r"]
    return sizes.get("e", sizes.get("h", 0.0)) + 2.0 * depth


def limb(hinged, density=4430.0):
    """Return the mass and inertia of a bar as high as the mouths between two hinges."""
    e, r, l, b = (float(hinged[key].split()[0]) for key in "erlb")
    mass = density * b * (e + 2.0 * r) * l
    return {"mass": f"{mass!r} kg", "inertia": f"{mass * l**2 / 12.0!r} kg*m^2"}


@dataclass
class Scene:
    """A spec without requirements, and the requirements that may be put to it."""

    kind: str
    spec: dict
    easy: dict


def scene(seed, kinds=KINDS):
    """Return the random spec of a seed."""
    return Writer(np.random.default_rng(seed), kinds[seed % len(kinds)]).scene(seed)


class Writer:
    def __init__(self, rng, kind):
        self.rng, self.kind = rng, kind

    def log(self, low, high):
        return float(10.0 ** self.rng.uniform(np.log10(low), np.log10(high)))

    def one(self, *choices):
        return choices[int(self.rng.integers(len(choices)))]

    def scene(self, seed):
        rng = self.rng
        self.l = self.log(1e-3, 0.2)
        self.slender = self.log(3e-4, 0.3)
        self.h = self.l * self.slender
        self.b = min(self.h * self.log(0.5, 300.0), 3.0 * self.l)
        geometry = self.geometry()
        case, mechanism = self.case()
        cases = {"work": case}
        if rng.random() < 0.2:
            cases["other"] = self.case(mechanism, first=False)[0]
        material = self.material()
        spec = {"flexure": 1, "title": f"seed {seed}", "material": material, "geometry": geometry}
        if mechanism:
            spec["mechanism"] = mechanism
        spec["cases"] = cases
        if rng.random() < 0.25:
            effect = self.one("shear", "plate-widening", "large-rotation", "axial-extension")
            spec["effects"] = {effect: self.one("on", "off")}
        if rng.random() < 0.1:
            spec["accuracy"] = self.log(1e-3, 0.1)
        requirements = self.requirements(cases, mechanism, material)
        if self.kind in LIMBS and rng.random() < 0.5:
            geometry["limb"] = limb(geometry, self.log(1e3, 1e4))
        if self.kind in (*NOTCHES, *LIMBS) and rng.random() < 0.5:
            geometry["blocks"] = self.one("massive", m(mouth(geometry) * self.log(0.3, 3.0)))
        self.warmed_and_driven(spec, requirements)
        self.rooted(geometry)
        draw_rare_keys(self, spec, requirements, EASY)
        return Scene(self.kind, spec, requirements)

    def warmed_and_driven(self, spec, requirements):
        """Change the temperature of the first case, and ask what drives it: some specs, last."""
        rng, case, kind = self.rng, spec["cases"]["work"], self.kind
        alone = spec.get("mechanism", {}).get("kind") != "parallel-stage"
        if rng.random() < 0.1 and alone and kind not in (*BARS, "linkage"):
            change = self.log(0.1, 200.0) * self.one(-1, 1)
            warm = {"uniform": f"{change!r} K"} if rng.random() < 0.5 else {}
            if not warm or rng.random() < 0.5:
                moving = spec["geometry"].get("moving", "moving")
                warm["bodies"] = {self.one("ground", moving): f"{0.7 * change!r} K"}
            case["temperature"] = warm
            spec["material"]["thermal_expansion"] = f"{self.log(1e-6, 25e-6)!r} 1/K"
        if rng.random() < 0.15 and "stroke" in case and "temperature" not in case:
            arm = {"arm": "10 mm"} if "rotation" in case["stroke"] else {}
            drives = {"blocking_force": "1e6 N", "free_stroke": "10 m", "drives": "both-ways"}
            spec["actuator"] = drives | arm
            requirements["drive"] = {"factor": EASY}

    def material(self):
        rng = self.rng
        E = self.log(1e9, 400e9) if rng.random() < 0.1 else self.one(70e9, 114e9, 210e9)
        tensile = E * self.log(1e-3, 2e-2)
        words = {"name": "drawn", "youngs_modulus": f"{E!r} Pa"}
        if rng.random() < 0.9:
            words["poisson_ratio"] = self.one(0.3, 0.34, 0.0, 0.45)
        return words | {
            "density": f"{self.one(2700.0, 4430.0, 8000.0)!r} kg/m^3",
            "yield_strength": f"{tensile * 0.9!r} Pa",
            "tensile_strength": f"{tensile!r} Pa",
            "fatigue_amplitude": {
                "value": f"{tensile / 2!r} Pa",
                "cycles": 1e7,
                "stress_ratio": -1,
            },
        }

    def requirements(self, cases, mechanism, material):
        turns = self.kind in TURNS
        easy = {
            "yield": {"factor": EASY},
            "stiffness": {"min": "1e-12 N*m/rad" if turns else "1e-12 N/m"},
        }
        whole = {**cases.get("other", {}), **cases["work"]}
        if "stroke" in whole:
            easy["parasitic_shift"] = {"max": "1e3 m"}
            easy["fatigue"] = {
                "factor": EASY, "mean_stress": self.one("goodman", "soderberg", "swt", "none"),
            }  # fmt: skip
        if any("ends" in case or "lock" in case for case in cases.values()):
            easy["buckling"] = {"factor": EASY}
        if mechanism:
            easy["frequency"] = {"min": "1e-9 Hz"}
        if "acceleration" in whole and mechanism and mechanism["kind"] == "payload":
            easy["sag"] = {"max": "1e3 m"}
        if "wrench" in whole:
            easy["deflection"] = self.deflection(whole["wrench"])
        if self.rng.random() < 0.15:
            easy["support"] = [{"direction": self.one("x", "y", "z"), "min": "1e-12 N/m"}]
        if "asd" in whole or "shock" in whole:
            easy["dynamic-yield"] = {"factor": EASY}
        return easy

    def deflection(self, wrench):
        """Return the motion to ask for under a wrench, along one of its forces."""
        # what no force acts along is rounding, or of next order
        drawn = self.one("x", "y", "z")
        along = [axis for axis in wrench if len(axis) == 1]
        return {"direction": drawn if drawn in along else along[0], "max": "1e3 m"}

    # -- geometry --

    def geometry(self):
        h, l, b = m(self.h), m(self.l), m(self.b)
        blade = {"kind": self.kind, "h": h, "l": l, "b": b}
        rng, kind = self.rng, self.kind
        angle = f"{float(rng.uniform(10.0, 80.0))!r} deg"
        if kind == "rcc":
            return blade | {"p": m(self.l * self.one(0.0, rng.uniform(0, 2))), "half_angle": angle}
        if kind == "cross-spring":
            delta = self.one(-0.5, -1 / 3, -0.8727, -2 / 3, float(rng.uniform(-1.5, 1.0)))
            words = blade | {"delta": float(delta), "half_angle": angle}
            return words | ({"pairs": 2} if rng.random() < 0.1 else {})
        if kind == "star":
            n = int(rng.integers(2, 6))
            angles = [f"{float(rng.uniform(0, 360))!r} deg" for _ in range(n)]
            return blade | {"angles": angles, "p": m(self.l * rng.uniform(-1.0, 1.0))}
        if kind == "three-blade":
            return blade | {"p": m(self.l * self.one(0.0, rng.uniform(0, 1)))}
        if kind == "unseparated-cross":
            return blade | {"half_angle": angle, "crossing": float(rng.uniform(0.2, 0.8))}
        if kind == "leaf-spring-stage":
            words = blade | {"blades": int(rng.integers(2, 7))}
            near = m(max(self.l * self.log(0.1, 3.0), 1.5 * self.h))
            return words | ({"spacing": near} if rng.random() < 0.85 else {})
        if kind == "necked-down-stage":
            words = blade | {"l_c": m(self.l * rng.uniform(0.03, 0.5)), "blades": self.one(2, 3, 4)}
            near = m(max(self.l * self.log(0.2, 3.0), 1.5 * self.h))
            return words | ({"spacing": near} if rng.random() < 0.85 else {})
        if kind in ("layout", "layout-pivot"):
            return self.layout()
        if kind == "linkage":
            return self.linkage()
        if kind in ("notch-hinge", "hinged-stage", "hinged-pivot"):
            return self.notched(angle)
        if kind == "elliptic-hinge":
            depth = self.l * rng.uniform(0.05, 0.6)
            self.h = self.l**2 / 4.0 / depth * self.log(1e-3, 0.5)
            sizes = {"e": m(self.h), "depth": m(depth), "l": l, "b": m(self.h * self.log(1, 100))}
            return {"kind": kind, **sizes}
        if kind == "filleted-hinge":
            return blade | {"r": m(self.l * rng.uniform(0.01, 0.5))}
        if kind == "torsion-bar":
            warping = self.one("free", "restrained")
            bars = {"bars": self.one(1, 2), "shortening": self.one("free", "held")}
            return blade | bars | {"warping": warping}
        if kind == "round-torsion-bar":
            return {"kind": kind, "d": h, "l": l, "bars": self.one(1, 2)}
        if kind == "torsion-star":
            return blade | {"b": m(self.h * self.log(3.0, 50.0)), "strips": self.one(2, 3)}
        return blade

    def notched(self, angle):
        r = self.l * float(self.rng.uniform(0.05, 0.45))
        self.h = r * self.log(1e-4, 0.8)
        words = {"kind": self.kind, "e": m(self.h), "r": m(r), "b": m(self.h * self.log(1, 200))}
        if self.kind == "notch-hinge":
            self.l = 2.0 * r
            return words
        words["l"] = m(self.l)
        if self.kind == "hinged-pivot":
            far = self.l * self.rng.uniform(0.3, 1.5)
            return words | {"p": m(far), "half_angle": angle}
        return words | {"limbs": self.one(2, 3), "spacing": m(self.l)}

    def layout(self):
        rng, l, blades = self.rng, self.l, {}
        size = {"h": m(self.h), "b": m(self.b)}
        if self.kind == "layout-pivot":
            near = l * float(rng.uniform(-0.8, 0.8))
            for k in range(int(rng.integers(2, 4))):
                a = float(rng.uniform(0.0, 2.0 * pi))
                ends = [[m(r * np.cos(a)), m(r * np.sin(a))] for r in (near, near + l)]
                blades[f"b{k}"] = {
                    "between": ["ground", "st"],
                    "from": ends[0],
                    "to": ends[1],
                } | size
            bodies = {"st": {"at": ["0 m", "0 m"]}}
            return {
                "kind": "layout", "bodies": bodies, "blades": blades,
                "moving": "st", "motion": "rotation",
            }  # fmt: skip
        wide = l * float(rng.uniform(0.4, 2.0))
        for name, y in (("a", wide / 2), ("c", -wide / 2)):
            blades[f"out-{name}"] = {
                "between": ["ground", "frame"], "from": ["0 m", m(y)], "to": [m(l), m(y)],
            } | size  # fmt: skip
            blades[f"in-{name}"] = {
                "between": ["frame", "st"], "from": [m(l), m(y / 2)], "to": ["0 m", m(y / 2)],
            } | size  # fmt: skip
        frame = {"at": [m(l / 2), "0 m"]}
        if rng.random() < 0.4:
            frame["mass"] = f"{self.log(1e-3, 1.0)!r} kg"
        return {
            "kind": "layout", "blades": blades, "moving": "st",
            "bodies": {"frame": frame, "st": {"at": [m(l / 2), "0 m"]}},
            "motion": {"translation": "90 deg"},
        }  # fmt: skip

    def linkage(self):
        arm, size = 3.0 * self.l, {"h": m(self.h), "l": m(self.l), "b": m(self.b)}
        flexure = {"kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg", **size}
        places = {
            "theta": (["crank", "base"], 0.0, 0.0), "beta": (["rod", "crank"], 0.0, arm),
            "alpha": (["rod", "stage"], -arm, arm),
        }  # fmt: skip
        joints = {
            name: {"links": links, "at": [m(x), m(y)], "flexure": flexure}
            for name, (links, x, y) in places.items()
        }
        joints["z"] = {"links": ["base", "stage"], "along": [1, 0]}
        return {"kind": "linkage", "ground": "base", "input": "theta", "joints": joints}

    # -- cases --

    def case(self, mechanism=None, *, first=True):
        rng, case = self.rng, {}
        turns = self.kind in TURNS
        way = rng.random()
        if way < 0.75 or self.kind in (*BARS, "linkage"):
            case["stroke"] = self.stroke(turns)
        loaded = self.kind not in (*BARS, "linkage")
        if loaded and (not case or rng.random() < 0.4):
            case |= self.load()
        if first and loaded and rng.random() < 0.6:
            mechanism = self.mechanism(turns)
        if mechanism and mechanism["kind"] == "parallel-stage" and "stroke" in case:
            case["stroke"] = self.stroke(turns=False)
        if mechanism and rng.random() < 0.3:
            self.shaken(case, mechanism)
        if not case:
            case["stroke"] = self.stroke(turns)
        return case, mechanism

    def stroke(self, turns):
        slim = 1.0 / self.slender
        reach = self.log(1e-5, 1.0) * min(1.2, 0.01 * slim)
        if not turns:
            reach *= self.l * 0.5
        unit = "rad" if turns else "m"
        way, cycles = self.rng.random(), {"cycles": 1e7}
        travel = f"{reach!r} {unit}"
        if way > 0.6:
            travel = [f"0 {unit}", f"{reach!r} {unit}"]
        if way > 0.85:
            travel = [f"{-0.3 * reach!r} {unit}", f"{reach!r} {unit}"]
        return {"rotation" if turns else "translation": travel, **cycles}

    def load(self):
        euler = pi**2 * 100e9 * self.b * self.h**3 / 12.0 / self.l**2
        force = euler * self.log(1e-4, 1.5)
        way, case = self.rng.random(), {}
        if way < 0.6:
            case["load"] = {"force": f"{force!r} N"}
            if self.rng.random() < 0.5:
                sideways = self.kind in (*PIVOTS, "layout-pivot") and self.rng.random() < 0.5
                turn = float(self.rng.uniform(0, 360)) if sideways else self.one(0.0, 180.0)
                case["load"]["direction"] = f"{turn!r} deg"
        else:
            axis = self.one("x", "y", "z")
            case["wrench"] = {axis: f"{force * self.one(1, -1)!r} N"}
            if self.rng.random() < 0.3:
                axis = self.one("theta_x", "theta_y", "theta_z")
                case["wrench"][axis] = f"{force * self.l * 0.1!r} N*m"
        if self.rng.random() < 0.6:
            case["ends"] = self.one(*ENDS)
        return case

    def mechanism(self, turns):
        mass = self.log(1e-4, 2.0)
        if self.kind == "cantilever" and self.rng.random() < 0.4:
            offset = {"offset": m(self.l * 0.2)} if self.rng.random() < 0.4 else {}
            return {"kind": "tip-mass", "mass": f"{mass!r} kg", **offset}
        if self.kind in ("rcc", "cross-spring", "three-blade") and self.rng.random() < 0.3:
            lever = {"mass": f"{mass!r} kg", "com": "10 mm", "inertia": f"{mass * 1e-4!r} kg*m^2"}
            return {
                "kind": "parallel-stage", "height": "20 mm",
                "solid-1": lever, "solid-2": {"mass": f"{mass * 3!r} kg"}, "solid-3": lever,
            }  # fmt: skip
        words = {"kind": "payload", "mass": f"{mass!r} kg"}
        return words | ({"inertia": f"{mass * self.l**2!r} kg*m^2"} if turns else {})

    def shaken(self, case, mechanism):
        # a free parallel stage swings under an acceleration: the spec has to lock it
        free = mechanism["kind"] == "parallel-stage" and "stroke" in case
        kind = self.one("acceleration", "acceleration", "asd", "shock")
        kind = "asd" if free else kind
        if kind == "acceleration":
            level = f"{self.log(0.1, 1e3)!r} m/s^2"
            case["acceleration"] = {"level": level, "axis": self.one("x", "y", "z")}
        elif kind == "asd":
            case["asd"] = {"profile": "gevs-qualification", "q": 50}
        else:
            pulse = {"acceleration": f"{self.log(1.0, 500.0)!r} g", "duration": "5 ms"}
            case["shock"] = {"half-sine": pulse, "q": 50}
        if mechanism["kind"] == "parallel-stage" and "stroke" not in case:
            case["lock"] = "solid-2"

    def rooted(self, geometry):
        """Give the blades of some joints fillets, or cut them from one piece with their bodies."""
        if self.kind not in ROOTED or self.rng.random() > 0.2:
            return
        if self.rng.random() < 0.6:
            geometry["root_radius"] = m(min(self.h * self.log(0.3, 10.0), 0.45 * self.l))
        if "root_radius" not in geometry or self.rng.random() < 0.3:
            geometry["clamps"] = self.one("monolithic", "monolithic-flush", "rigid")


class Outcome(NamedTuple):
    """What was said of one requirement near its limit, by default and by the finest model."""

    requirement: str
    said: object
    finest: object
    sin: str


class Tried(NamedTuple):
    """A spec whose requirements are all near their limits, and what came of each.

    ``said`` and ``finest`` are the whole answers; ``sin`` is that of the spec itself, if any.
    """

    kind: str
    spec: dict
    said: object
    finest: object
    outcomes: tuple[Outcome, ...] = ()
    sin: str = ""


CLEAN = ""
BUG = "exit 101"
LACKS = "lacks a property"
OMITS = "leaves out"
NOT_ASKED = "nothing to ask"
OPEN = {
    "needs-poisson-ratio": "poisson_ratio", "needs-density": "density", "needs-blocks": "blocks",
    "needs-spacing": "spacing", "limbs-without-mass": "limb", "needs-clamps": "clamps",
    "needs-over-temperature": "over_temperature", "needs-inertia": "inertia",
}  # fmt: skip
"""Notes on what the spec does not give: a property of the material, or of the geometry.

What stands between the necks of a stage has no key: a layout with masses would decide."""


def near_its_limits(seed, kinds=KINDS, near=NEAR, *, alone=False):
    """Return a seed's spec, every requirement a share above or below its factor.

    One of them at random where it is ``alone``. It is the outcome instead where there is nothing
    to ask.
    """
    found = scene(seed, kinds)
    rng = np.random.default_rng(seed + 10**6)
    while True:
        spec = {**found.spec, "requirements": found.easy}
        first = answer(spec)
        said = first.about("yield")
        if said.exit_code == 101:
            return Tried(found.kind, spec, first, None, sin=BUG)
        if said.exit_code != 2:
            break
        # what this joint or case has no answer for is a finding of the spec: it asks for less
        named = {place.split(".")[1].split("[")[0] for place in said.places if "." in place}
        gone = [key for key in found.easy if spoken(key) in map(spoken, named)]
        if not gone:
            return Tried(found.kind, spec, first, None, sin="finding")
        found.easy = {key: value for key, value in found.easy.items() if key not in gone}
        if not found.easy:
            return Tried(found.kind, spec, first, None, sin=NOT_ASKED)
    blocks = {}
    for name, easy in found.easy.items():
        of_name = (row for row in said.rows if _key(row["name"], found.easy) == name)
        rows = [row for row in of_name if _asks(row, _longest(found.spec["geometry"]))]
        if rows:
            row = rows[int(rng.integers(len(rows)))]
            apart = (1.0 + near) ** rng.choice([-1.0, 1.0])
            blocks[name] = _near(easy, row, apart)
    _aimed(blocks, np.random.default_rng(seed + 2 * 10**6))
    if alone and blocks:
        name = sorted(blocks)[int(rng.integers(len(blocks)))]
        blocks = {name: blocks[name]}
    sin = CLEAN if blocks else NOT_ASKED
    return Tried(found.kind, {**found.spec, "requirements": blocks}, first, None, sin=sin)


def tried(seed, kinds=KINDS, near=NEAR, *, alone=False):
    """Return what comes of a seed's spec with its requirements near their limits."""
    found = near_its_limits(seed, kinds, near, alone=alone)
    if found.sin:
        return found
    spec = found.spec
    said, finest = answer(spec), finest_answer(spec)
    if finest.exit_code == 2 and said.exit_code != 2:
        finest = said  # a joint that closed forms alone describe
    if said.bug or finest.bug:
        return found._replace(said=said if said.bug else finest, sin=BUG)
    outcomes = (_outcome(spec, name, said, finest) for name in spec["requirements"])
    return Tried(found.kind, spec, said, finest, tuple(outcomes))


def finest_answer(spec):
    """Return what the finest model says of each row, by exact beams where no finer one does.

    Of notches that is their solid where it has a range, of other joints shells where they are asked
    of and have a narrower one. No plan is made, of which these two have none.
    """
    spec = {key: each for key, each in spec.items() if key != "accuracy"}
    beams = answer(spec, "exact")
    if beams.bug or beams.exit_code == 2:
        return beams
    if spec["geometry"]["kind"] in (*NOTCHES, *LIMBS):
        finer = answer(spec, "solid")
    else:
        asked = {key: each for key, each in spec["requirements"].items() if key in BY_SHELLS}
        finer = answer({**spec, "requirements": asked}, "shell") if asked else Answer({}, 0, 0.0)
    if finer.bug:
        return finer
    if finer.exit_code == 2:
        return beams
    told = {_place(row): row for row in finer.found.get("checks", []) if row["factor_range"]}
    rows = [_finer(row, told.get(_place(row))) for row in beams.found["checks"]]
    # what a row that is not taken cost, and what it found for others, was spent as well
    kept = [row for row in rows if told.get(_place(row)) is row]
    whole = beams._replace(found={**beams.found, "checks": rows})
    return whole._replace(beside=finer.deciding - finer._replace(found={"checks": kept}).deciding)


def _finer(row, other):
    """Return the row of a finer model, of shells where it is no less sure than that of beams."""
    if other is None or (other["model"] == "shell" and _width(other) > _width(row)):
        return row
    return other


def _width(row):
    low, high = row["factor_range"] or (0.0, None)
    return np.inf if high is None else (high - low) / abs(row["factor"] or 1.0)


def _place(row):
    return row["name"], row["case"]


def _longest(geometry):
    """Return the length of a joint's blades or hinges, where it is stated [m]."""
    stated = (geometry[key] for key in ("l", "r") if key in geometry)
    return max((float(length.split()[0]) for length in stated), default=LONGEST)


def _asks(row, longest):
    """Return whether a row has a number that a requirement can be set near to."""
    factor, required = row["factor"], row["required"]
    if factor is None or required is None:
        return False
    if row["unit"] == "m" and not LEAST <= row["demand"] <= longest:
        return False
    if required == EASY and factor < LEAST_FACTOR:
        return False
    return 0.0 < factor < (1e15 if required == EASY else 1e24)


def _outcome(spec, name, said, finest):
    ours, best = said.about(name), finest.about(name)
    sin = CLEAN
    if said.exit_code == 2:
        sin = "finding"
    elif ours.verdict == "pass" and best.verdict == "fail":
        sin = UNSAFE
    elif ours.verdict == "fail" and best.verdict == "pass":
        sin = FALSE_FAIL
    elif ours.verdict == UNDECIDED:
        sin = LACKS if _lacks(ours, spec, name) else UNDECIDED
        sin = OMITS if sin == UNDECIDED and _omits(spec, name) else sin
    elif ours.verdict == ERROR:
        sin = ERROR
    return Outcome(name, ours, best, sin)


def _lacks(said, spec, name):
    """Return whether a property that the spec does not give would decide."""
    missing = [OPEN[code] for code in said.notes if code in OPEN]
    has_limb = spec["geometry"]["kind"] in LIMBS
    if not missing or ("limb" in missing and not has_limb):
        return bool(missing)
    spec = {**spec, "requirements": {name: spec["requirements"][name]}}
    material, geometry = dict(spec["material"]), dict(spec["geometry"])
    for each, value in (("poisson_ratio", 0.3), ("density", "4430 kg/m^3")):
        if each in missing:
            material.setdefault(each, value)
    if "over_temperature" in missing:
        material["over_temperature"] = _over_temperature(material)
    given = {
        "spacing": lambda: geometry["l"],
        "limb": lambda: limb(geometry),
        "blocks": lambda: m(mouth(geometry)),
    }
    geometry |= {key: value() for key, value in given.items() if key in missing}
    if "inertia" in missing and "inertia" in spec["mechanism"]:
        about_z = spec["mechanism"]["inertia"]
        inertia = dict.fromkeys(("xx", "yy", "zz"), about_z)
        spec["mechanism"] = {**spec["mechanism"], "inertia": inertia}
    clamps = ("rigid", "monolithic") if "clamps" in missing else (None,)
    each = (
        {**spec, "material": material, "geometry": geometry | ({"clamps": one} if one else {})}
        for one in clamps
    )
    return any(checked(one, name).verdict != UNDECIDED for one in each)


def _over_temperature(material):
    """Return what a material is at all temperatures, as it is at assembly where nothing is told."""
    told = dict(material.get("over_temperature", {}))
    strengths = ("yield_strength", "tensile_strength", "fatigue_amplitude", "youngs_modulus")
    for each in strengths:
        value = material.get(each)
        value = value["value"] if isinstance(value, dict) else value
        if value is not None:
            told.setdefault(each, {"points": [["4 K", value], ["700 K", value]]})
    rate = float(material["thermal_expansion"].split()[0])
    longer = [[f"{T} K", f"{100.0 * rate * (T - 293.0)!r} %"] for T in (4.0, 293.0, 700.0)]
    return {"elongation": {"points": longer}, **told}


def _omits(spec, name):
    """Return whether an effect that the spec itself leaves out would decide."""
    if "off" not in spec.get("effects", {}).values():
        return False
    whole = {key: value for key, value in spec.items() if key != "effects"}
    whole["requirements"] = {name: spec["requirements"][name]}
    return checked(whole, name).verdict != UNDECIDED


def _key(name, easy):
    keys = [key for key in easy if spoken(name).startswith(spoken(key))]
    return max(keys, key=len, default="")


def _aimed(blocks, rng):
    """Turn some bounds into targets, of which the printed number is just in or out of reach."""
    for name in ("stiffness", "frequency"):
        block = blocks.get(name)
        if isinstance(block, dict) and "min" in block and rng.random() < 0.15:
            number, unit = block["min"].split()
            reach = float(10.0 ** rng.uniform(-2.0, -0.3))
            # the bound was the number times (1 + near) or over it, which is the margin here too
            target = float(float(number) * (1.0 + reach) ** rng.choice([-1.0, 1.0]))
            blocks[name] = {"equals": f"{target!r} {unit}", "tolerance": reach}


def _near(block, row, share):
    """Return the requirement set to a printed number times a share."""
    if isinstance(block, list):
        return [_near(block[0], row, share)]
    block = dict(block)
    if "factor" in block:
        block["factor"] = float(row["factor"] * share)
    for side, number in (("min", "capacity"), ("max", "demand")):
        if side in block:
            unit = block[side].split()[1]
            block[side] = f"{abs(row[number]) * float(share)!r} {unit}"
    return block
