"""Random specs whose loads act together: wrenches of several components beside what else there is.

The joints are those of the campaign; what the loads do by themselves is a thousandth to all of what
buckles or yields.
"""

from math import pi

import numpy as np

from twins.campaign import (
    BARS,
    ENDS,
    KINDS,
    LIMBS,
    NOTCHES,
    TURNS,
    Scene,
    Writer,
    limb,
    m,
    mouth,
)

COUPLED = tuple(kind for kind in KINDS if kind not in (*BARS, "linkage"))
"""Joints that bear a wrench."""

FORCES, MOMENTS = ("x", "y", "z"), ("theta_x", "theta_y", "theta_z")


def coupled_scene(seed, kinds=COUPLED):
    """Return the random spec of a seed, with everything asked easily."""
    return _CoupledWriter(np.random.default_rng(seed), kinds[seed % len(kinds)]).scene(seed)


class _CoupledWriter(Writer):
    def scene(self, seed):
        """Return one case of loads that act together."""
        rng = self.rng
        self.l = self.log(1e-3, 0.2)
        self.slender = self.log(1e-3, 0.2)
        self.h = self.l * self.slender
        self.b = min(self.h * self.log(0.5, 100.0), 3.0 * self.l)
        geometry = self.geometry()
        material = self.material()
        material.setdefault("poisson_ratio", 0.3)
        self.modulus, self.strength = (
            float(material[key].split()[0]) for key in ("youngs_modulus", "yield_strength")
        )
        if self.kind in ("leaf-spring-stage", "necked-down-stage"):
            geometry.setdefault("spacing", m(max(self.l, 1.5 * self.h)))
        if self.kind in LIMBS and rng.random() < 0.7:
            geometry["limb"] = limb(geometry)
        if self.kind in (*NOTCHES, *LIMBS):
            geometry["blocks"] = self.one("massive", m(mouth(geometry) * self.log(0.5, 3.0)))
        case, mechanism = self.together()
        spec = {"flexure": 1, "title": f"seed {seed}", "material": material, "geometry": geometry}
        if mechanism:
            spec["mechanism"] = mechanism
        spec["cases"] = {"work": case}
        return Scene(self.kind, spec, self.requirements(spec["cases"], mechanism, material))

    def deflection(self, wrench):
        """Return the motion to ask for under a wrench: along one of its components, or another."""
        axis = self.one(*wrench) if self.rng.random() < 0.8 else self.one(*FORCES, *MOMENTS)
        return {"direction": axis, "max": "1e3 m" if axis in FORCES else "1e3 rad"}

    def together(self):
        """Return a case of loads that act together, and the mechanism that has their mass."""
        rng, turns, case, mechanism = self.rng, self.kind in TURNS, {}, None
        if rng.random() < 0.5:
            case["stroke"] = self.stroke(turns)
        euler = pi**2 * self.modulus * self.b * self.h**3 / 12.0 / self.l**2
        bends = self.strength * self.b * self.h**2 / 6.0
        force, moment = self.one((euler, euler * self.l * 0.2), (bends / self.l, bends))
        way = rng.random()
        if way < 0.85:
            case["wrench"] = self.wrench(force, moment)
        if way > 0.65:
            case["load"] = {"force": f"{force * self.log(1e-3, 1.0)!r} N"}
            if rng.random() < 0.5:
                case["load"]["direction"] = f"{self.one(0.0, 180.0, rng.uniform(0, 360))!r} deg"
        if rng.random() < 0.3:
            case["ends"] = self.one(*ENDS)
        if rng.random() < 0.4:
            mass = self.log(1e-4, 2.0)
            mechanism = {"kind": "payload", "mass": f"{mass!r} kg"}
            if turns:
                mechanism["inertia"] = f"{mass * self.l**2!r} kg*m^2"
            level = f"{force * self.log(1e-3, 1.0) / mass!r} m/s^2"
            case["acceleration"] = {"level": level, "axis": self.one("x", "y", "z")}
        return case, mechanism

    def wrench(self, force, moment):
        """Return a wrench of one to four components, up to a force [N] and a moment [N m]."""
        axes = self.rng.permutation([*FORCES, *MOMENTS])[: int(self.rng.integers(1, 5))]
        size = {**dict.fromkeys(FORCES, (force, "N")), **dict.fromkeys(MOMENTS, (moment, "N*m"))}
        return {
            str(axis): f"{size[axis][0] * self.log(1e-3, 1.0) * self.one(1, -1)!r} {size[axis][1]}"
            for axis in axes
        }
