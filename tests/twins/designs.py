"""Random designs of every planar joint with their true numbers, each asked just above and below.

A question holds a requirement that the true number keeps by 3 % and one that it misses by 3 %.
Blades are beams in a plane here: specs switch thick notches off, what blades are that are one piece
where they cross, and plate widening, or have no Poisson's ratio to widen by; cross-springs are
held upright.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from math import degrees, pi, radians

import numpy as np

from twins.joints import (
    EULER_HOLDS,
    TURN,
    Loads,
    Twin,
    goodman_factor,
    joint_of,
    yield_factor,
)
from twins.reissner import NoEquilibrium

MARGIN = 0.03
PIVOTS = ("rcc", "cross-spring", "star", "three-blade", "unseparated-cross")
STAGES = ("cantilever", "guided-blade", "leaf-spring-stage", "necked-down-stage", "layout")
HINGES = ("moment-blade", "notch-hinge", "elliptic-hinge", "filleted-hinge")
KINDS = PIVOTS + STAGES + HINGES


@dataclass(frozen=True)
class Question:
    """A requirement by name, its true number, and it kept and missed by 3 %."""

    name: str
    true: float
    kept: object
    missed: object
    tag: str = ""


@dataclass
class Drawn:
    """A spec without requirements, and the questions put to it."""

    kind: str
    seed: int
    spec: dict
    questions: list = field(default_factory=list)
    dropped: str = ""

    def asked(self, question, kept):
        """Return the spec with one requirement, kept or missed.

        Buckling is asked of elastic blades: the twin knows no yielding.
        """
        block = question.kept if kept else question.missed
        spec = {**self.spec, "requirements": {question.name: block}}
        if question.name == "buckling":
            spec["material"] = {k: v for k, v in spec["material"].items() if k != "yield_strength"}
        return spec


def factor(name, true, tag="", **also):
    true = float(true)
    kept, missed = ({"factor": true * (1.0 + s * MARGIN), **also} for s in (-1.0, 1.0))
    return Question(name, true, kept, missed, tag)


def bound(name, true, unit, side):
    true = float(true)
    sign = -1.0 if side == "min" else 1.0
    kept, missed = ({side: f"{true * (1.0 + s * sign * MARGIN)!r} {unit}"} for s in (1.0, -1.0))
    return Question(name, true, kept, missed)


def drawn(seed, kinds=KINDS, *, quick=False) -> Drawn:
    """Return the design of a seed with its questions; what has no truth is dropped and says so.

    Quick ones ask of no buckling, whose true loads take seconds each.
    """
    rng = np.random.default_rng(seed)
    return _Draw(rng, kinds[seed % len(kinds)], seed, quick=quick).made()


def drawn_twin(seed, kind, degree):
    """Return the twin of a random joint of a kind."""
    draw = _Draw(np.random.default_rng(seed), kind, seed)
    sizes, _ = draw.sizes()
    return Twin(joint_of(kind, **sizes), draw.E, draw.nu, draw.density, degree=degree)


def designs(count, first=0, kinds=KINDS) -> Iterator[Drawn]:
    for seed in range(first, first + count):
        yield drawn(seed, kinds)


class _Draw:
    def __init__(self, rng, kind, seed, *, quick=False):
        self.quick = quick
        self.rng, self.kind, self.seed = rng, kind, seed
        self.E = float(rng.choice([70e9, 114e9, 210e9]))
        self.nu = 0.0  # its truth is that of beams, which no width stiffens
        self.density = float(rng.choice([2700.0, 4430.0, 7900.0]))
        self.turns = kind in PIVOTS + HINGES

    def _log(self, low, high):
        return float(10.0 ** self.rng.uniform(np.log10(low), np.log10(high)))

    def sizes(self):
        """Return the joint's sizes in SI and the spec's words for them."""
        rng, kind = self.rng, self.kind
        l = self._log(5e-3, 100e-3)
        h = l * self._log(2e-3, 0.15)
        b = h * self._log(2.0, 30.0)
        if kind in ("notch-hinge", "elliptic-hinge", "filleted-hinge"):
            return self._hinge(b)
        g = {"h": h, "l": l, "b": b}
        if kind in ("rcc", "cross-spring", "unseparated-cross"):
            g["half_angle"] = radians(float(rng.uniform(20.0, 70.0)))
        if kind == "rcc":
            g["p"] = l * float(rng.uniform(0.0, 1.0))
        if kind == "cross-spring":
            g["delta"] = float(rng.choice([-0.5, rng.uniform(-1.2, 1.0), -0.1273]))
        if kind == "star":
            count = int(rng.integers(2, 5))
            start = float(rng.uniform(0.0, pi))
            g["angles"] = tuple(start + k * float(rng.uniform(0.5, 1.3)) for k in range(count))
            g["p"] = l * float(rng.uniform(-0.8, 0.8))
        if kind == "three-blade":
            g["p"] = l * float(rng.choice([0.0, rng.uniform(0.0, 0.5)]))
        if kind == "unseparated-cross":
            g["crossing"] = float(rng.uniform(0.3, 0.7))
        if kind in ("leaf-spring-stage", "necked-down-stage"):
            g["blades"] = int(rng.integers(2, 5))
            g["spacing"] = l * float(rng.uniform(0.3, 2.0))
        if kind == "necked-down-stage":
            g["l_c"] = l * float(rng.uniform(0.1, 0.45))
            g["h"] = h = g["l_c"] * self._log(5e-3, 0.15)
            g["b"] = h * self._log(2.0, 30.0)
        if kind == "layout":
            g |= {
                "outer": l * float(rng.uniform(1.0, 2.0)),
                "inner": l * float(rng.uniform(0.2, 0.8)),
            }
        return g, self._words(g)

    def _hinge(self, b):
        if self.kind == "notch-hinge":
            r = self._log(0.5e-3, 5e-3)
            e = r * self._log(5e-3, 0.2)
            g = {"e": e, "r": r, "b": e * self._log(2.0, 20.0)}
        elif self.kind == "elliptic-hinge":
            l = self._log(2e-3, 10e-3)
            depth = l * float(self.rng.uniform(0.1, 0.5))
            e = l * l / (4.0 * depth) * self._log(5e-3, 0.2)
            g = {"e": e, "depth": depth, "l": l, "b": e * self._log(2.0, 20.0)}
        else:
            l = self._log(2e-3, 20e-3)
            h = l * self._log(5e-3, 0.1)
            r = l * float(self.rng.uniform(0.05, 0.3))
            g = {"h": h, "r": r, "l": l, "b": h * self._log(2.0, 20.0)}
        return g, self._words(g) | {"stress-concentration": "none"}

    def _words(self, g):
        if self.kind == "layout":
            return self._drawn_layout(g)
        words = {"kind": self.kind} | (
            {"tilt": "held"} if self.kind in ("cross-spring", "star") else {}
        )
        for name, value in g.items():
            if name == "half_angle":
                words[name] = f"{degrees(value)!r} deg"
            elif name == "angles":
                words[name] = [f"{degrees(v)!r} deg" for v in value]
            elif name in ("delta", "crossing", "blades"):
                words[name] = value
            else:
                words[name] = f"{value!r} m"
        return words

    def _drawn_layout(self, g):
        at = [f"{g['l'] / 2.0!r} m", "0 m"]
        strips = {}
        for part, bodies, x in (
            ("outer", ["ground", "frame"], (0.0, g["l"])),
            ("inner", ["frame", "stage"], (g["l"], 0.0)),
        ):
            for name, side in (("a", 0.5), ("c", -0.5)):
                y = side * g[part]
                strips[f"{part}-{name}"] = {
                    "between": bodies,
                    "from": [f"{x[0]!r} m", f"{y!r} m"],
                    "to": [f"{x[1]!r} m", f"{y!r} m"],
                    "h": f"{g['h']!r} m",
                    "b": f"{g['b']!r} m",
                }
        return {
            "kind": "layout",
            "moving": "stage",
            "motion": {"translation": "90 deg"},
            "bodies": {"frame": {"at": at}, "stage": {"at": at}},
            "blades": strips,
        }

    # -- the scene --

    def made(self) -> Drawn:
        g, words = self.sizes()
        self.g = g
        self.twin = Twin(joint_of(self.kind, **g), self.E, self.nu, self.density)
        spec = {"flexure": 1, "title": f"twin {self.seed}", "geometry": words}
        spec["effects"] = {"thick-notch": "off"}
        if self.kind == "unseparated-cross":
            spec["effects"]["clamp-compliance"] = "off"  # its beams meet in a point
        found = Drawn(self.kind, self.seed, spec)
        try:
            self._fill(found)
        except NoEquilibrium as error:
            found.questions, found.dropped = [], str(error)
        return found

    def _fill(self, found):
        rng = self.rng
        case, travels = {}, ()
        scene = rng.choice(["stroke", "stroke", "stroke+load", "load", "wrench", "acceleration"])
        if self.kind in HINGES and scene not in ("stroke", "stroke+load"):
            scene = "stroke"
        if self.kind == "layout" and scene in ("load", "wrench"):
            scene = "stroke+load"
        if scene != "load" and (scene in ("stroke", "stroke+load") or rng.random() < 0.5):
            case["stroke"], travels = self._stroke()
        loads, senses, ends = Loads(), (1.0,), None
        stiff = self.twin.stiffness()
        payload = self._payload(stiff, travels)
        if scene in ("stroke+load", "load"):
            loads, senses, ends = self._load(case, travels)
        elif scene == "wrench":
            loads, senses = self._wrench(case), (1.0, -1.0)
        elif scene == "acceleration":
            loads, senses = self._acceleration(case, payload, stiff)
        hold = EULER_HOLDS[ends] if ends else ()
        if not travels and not ends:
            hold = self.twin.joint.kept  # a guide's tip cannot turn whatever acts
        stresses = self.twin.face_stresses(travels, loads, senses, hold)
        largest = max(float(np.abs(rows).max()) for rows in stresses)
        strength = largest * float(rng.uniform(1.1, 3.0))
        tensile = strength * float(rng.uniform(1.05, 1.4))
        amplitude = tensile * float(rng.uniform(0.4, 0.55))
        if strength > self.E / 12.0 or strength < 1e3:
            raise NoEquilibrium(f"a stress of {largest:.3g} Pa is no design")
        found.spec |= {
            "material": {
                "name": "drawn",
                "youngs_modulus": f"{self.E!r} Pa",
                "poisson_ratio": self.nu,
                "density": f"{self.density!r} kg/m^3",
                "yield_strength": f"{strength!r} Pa",
                "tensile_strength": f"{tensile!r} Pa",
                "fatigue_amplitude": {
                    "value": f"{amplitude!r} Pa", "cycles": 1e7, "stress_ratio": -1,
                },
            },
            "mechanism": payload,
            "cases": {"work": case},
        }  # fmt: skip
        ask = found.questions.append
        ask(factor("yield", yield_factor(stresses, strength)))
        if travels and scene in ("stroke", "stroke+load"):
            mean = str(rng.choice(["goodman", "goodman", "none"]))
            true = goodman_factor(stresses, amplitude, tensile, mean)
            if np.isfinite(true):
                ask(factor("fatigue", true, mean_stress=mean))
        if scene == "stroke":
            unit = "N*m/rad" if self.turns else "N/m"
            ask(bound("stiffness", stiff, unit, str(rng.choice(["min", "max"]))))
            mass, inertia = self.payload
            ask(bound("frequency", self.twin.frequency(mass, inertia), "Hz", "min"))
            # a joint that is not its own mirror image shifts otherwise the other way
            shift = max(self.twin.shift(travel) for travel in travels if travel)
            if shift > 1e-12:
                ask(bound("parasitic_shift", shift, "m", "max"))
        if scene == "acceleration" and self.along_stroke:
            weight = self.payload[0] * self.level
            ask(bound("sag", weight / stiff, "m", "max"))
        if ends is not None and not self.quick and self.kind not in ("layout", *HINGES):
            self._ask_buckling(ask, case, travels, ends)

    def _stroke(self):
        rng, l = self.rng, self.g.get("l", 2.0 * self.g.get("r", 1.0))
        h = self.g.get("h", self.g.get("e"))
        if self.kind in ("notch-hinge", "elliptic-hinge", "filleted-hinge"):
            reach = self._log(2e-3, 0.1)
        else:
            reach = self._log(3e-3, 0.5 if self.turns else 0.3)
            limit = 0.01 * l / h / (2.0 if self.turns else 3.0)  # a strain of some 1 %
            reach = min(reach, limit) * (1.0 if self.turns else l)
        way = rng.random()
        ends = (-reach, reach) if way < 0.6 else (0.0, reach)
        if way > 0.85:
            ends = (0.3 * reach, reach) if way < 0.93 else (-0.4 * reach, reach)
        unit, name = ("rad", "rotation") if self.turns else ("m", "translation")
        text = f"{reach!r} {unit}" if ends[0] == -reach else [f"{v!r} {unit}" for v in ends]
        return {name: text, "cycles": 1e7}, ends[::-1]

    def _payload(self, stiff, travels):
        mass = self._log(1e-3, 1.0)
        least = 0.6 if self.kind in HINGES else 0.2  # lest it swings across the hinge first
        inertia = mass * (self.g.get("l", 0.01) * float(self.rng.uniform(least, 1.0))) ** 2
        self.payload = (mass, inertia if self.turns else 0.0)
        words = {"kind": "payload", "mass": f"{mass!r} kg"}
        return words | ({"inertia": f"{inertia!r} kg*m^2"} if self.turns else {})

    def _load(self, case, travels):
        """Put a force in the plane, of either sense where no direction is said."""
        rng = self.rng
        thin = min(
            float(np.min(b.h)) if not callable(b.h) else self.g.get("e", self.g.get("h"))
            for b in self.twin.joint.beams
        )
        beam = self.twin.joint.beams[0]
        euler = pi**2 * self.E * beam.b * thin**3 / 12.0 / beam.length**2
        if self.kind in ("cantilever", "moment-blade"):
            force = euler * self._log(1e-3, 0.15)
        elif self.kind == "unseparated-cross":
            force = euler * self._log(1e-2, 0.3)
        else:
            force = euler * self._log(1e-2, 0.6)
        directions = [None, 0.0, pi]
        if self.kind in PIVOTS:
            directions += [pi / 2.0, float(rng.uniform(0.0, 2.0 * pi))]
        direction = directions[int(rng.integers(len(directions)))]
        case["load"] = {"force": f"{force!r} N"}
        if direction is not None:
            case["load"]["direction"] = f"{degrees(direction)!r} deg"
        self.direction = direction
        ends = None
        if not travels or (self.kind in PIVOTS and rng.random() < 0.7):
            ends = str(rng.choice(["clamped-clamped", "clamped-guided"]))
            if travels:
                ends = "clamped-guided"
            if not travels and self.kind in PIVOTS and rng.random() < 0.4:
                ends = str(rng.choice(["clamped-free", "clamped-pinned"]))
            if not travels and self.kind == "cantilever":
                ends = str(rng.choice(sorted(EULER_HOLDS)))
            if not travels and self.kind in (
                "guided-blade",
                "leaf-spring-stage",
                "necked-down-stage",
            ):
                ends = str(rng.choice(["clamped-clamped", "clamped-guided"]))
            if direction not in (None, 0.0, pi) and not travels:
                ends = "clamped-guided" if self.kind != "star" else "clamped-free"
            case["ends"] = ends
        a = direction or 0.0
        vector = (force * np.cos(a), force * np.sin(a))
        return Loads((vector,)), self._senses(), ends

    def _senses(self):
        """Return in which senses a load acts: in the one that it states, else in both."""
        return (1.0, -1.0) if self.direction is None else (1.0,)

    def _wrench(self, case):
        rng, l, h, b = self.rng, self.g["l"], self.g["h"], self.g["b"]
        if self.kind == "necked-down-stage":
            l = self.g["l_c"]
        strain = self._log(1e-4, 2e-3)
        force = strain * self.E * b * h * (0.05 if "stroke" in case else 1.0) * h / l
        angle = float(rng.uniform(0.0, 2.0 * pi))
        moment = 0.0
        if self.kind in PIVOTS and "stroke" not in case:
            moment = strain * self.E * b * h * h / 12.0
        if self.kind not in PIVOTS:
            angle = 0.0 if rng.random() < 0.5 else angle
            force *= 0.3
        fx, fy = float(force * np.cos(angle)), float(force * np.sin(angle))
        if "stroke" in case and self.kind not in PIVOTS:
            fy = 0.0  # the drive takes it
        # a stage's x is along its stroke, its y along the blades towards the base
        x, y = (fx, fy) if self.kind in PIVOTS else (fy, -fx)
        case["wrench"] = {"x": f"{x!r} N", "y": f"{y!r} N"}
        if moment:
            case["wrench"]["theta_z"] = f"{moment!r} N*m"
        return Loads(((fx, fy),), moment)

    def _acceleration(self, case, payload, stiff):
        """Accelerate the payload along x (stroke, bisector) or y (along a stage's blades)."""
        rng, (mass, _), l = self.rng, self.payload, self.g["l"]
        axis = "y" if "stroke" in case or rng.random() < 0.5 else "x"
        h, b = self.g["h"], self.g["b"]
        if axis == "x" and not self.turns:
            force = float(stiff) * l * self._log(1e-4, 0.05)
        else:
            force = 0.08 * pi**2 * self.E * b * h**3 / 12.0 / l**2 * self._log(0.03, 1.0)
        self.level = force / mass
        self.along_stroke = axis == "x" and not self.turns
        # a drawing's x is as drawn: along its blades
        said = {"x": "y", "y": "x"}[axis] if self.kind == "layout" else axis
        case["acceleration"] = {"level": f"{self.level!r} m/s^2", "axis": said}
        vector = (force, 0.0) if (axis == "x") == self.turns else (0.0, force)
        return Loads((vector,)), (1.0, -1.0)

    def _ask_buckling(self, ask, case, travels, ends):
        if self.kind == "star" or (travels and self.twin.joint.axis != TURN):
            return
        force = float(case["load"]["force"].split()[0])
        travel = max(travels, key=abs) if travels else None
        true = min(
            self.twin.critical(sense, self.direction or 0.0, ends, travel)
            for sense in self._senses()
        )
        if np.isfinite(true) and true > 0.0:
            ask(factor("buckling", true / force))
