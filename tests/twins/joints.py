"""The joints of the specs as plane frames, and the true numbers of a design from them.

Sizes are SI numbers under the spec's own names. A frame's x is a pivot's axis of symmetry at rest
or the direction of a stage's blades; blades go from their inner end on the base to the moving body.
"""

from dataclasses import dataclass, replace
from math import cos, pi, sin

import numpy as np

from twins.reissner import GROUND, Beam, Frame, Mass, NoEquilibrium, Push

BODY = "moving"
X, Y, TURN = 0, 1, 2
PLACES = np.linspace(0.0, 1.0, 201)
EULER_HOLDS = {
    "clamped-clamped": (Y, TURN),
    "clamped-guided": (TURN,),
    "clamped-free": (),
    "clamped-pinned": (Y,),
}
"""What the body is kept from besides the way of the force, by the ends of its blades."""


@dataclass(frozen=True)
class Joint:
    """Beams between bodies; ``axis`` is what a stroke moves, ``kept`` what it keeps at zero."""

    beams: tuple
    bodies: tuple
    axis: int
    kept: tuple = ()
    centre: tuple = (0.0, 0.0)
    """The point whose parasitic shift counts."""

    @property
    def at(self):
        return dict(self.bodies)[BODY].at

    def turned(self, angle):
        """Return the joint turned about the origin."""
        c, s = cos(angle), sin(angle)

        def place(p):
            return (c * p[0] - s * p[1], s * p[0] + c * p[1])

        beams = tuple(b._replace(start=place(b.start), end=place(b.end)) for b in self.beams)
        bodies = tuple(
            (n, m._replace(at=place(m.at), com=None if m.com is None else place(m.com)))
            for n, m in self.bodies
        )
        return replace(self, beams=beams, bodies=bodies, centre=place(self.centre))


def joint_of(kind, **g):
    """Return the joint of a kind by its sizes."""
    return _KINDS[kind](g)


def _ray(angle, near, far, g, first=GROUND, second=BODY):
    c, s = cos(angle), sin(angle)
    return Beam(first, second, (near * c, near * s), (far * c, far * s), g["h"], g["b"])


def _star(angles, p, g):
    beams = tuple(_ray(angle, p, p + g["l"], g) for angle in angles)
    return Joint(beams, ((BODY, Mass((0.0, 0.0))),), TURN)


def _pair(g):
    p = g["p"] if "p" in g else g["delta"] * g["l"]
    return _star((g["half_angle"], -g["half_angle"]) * g.get("pairs", 1), p, g)


def _unseparated(g):
    near, far = g["crossing"] * g["l"], (1.0 - g["crossing"]) * g["l"]
    beams = []
    for angle in (g["half_angle"], -g["half_angle"]):
        beams += [_ray(angle, -near, 0.0, g, GROUND, "cross"), _ray(angle, 0.0, far, g, "cross")]
    bodies = (("cross", Mass((0.0, 0.0))), (BODY, Mass((0.0, 0.0))))
    return Joint(tuple(beams), bodies, TURN)


def _single(axis, kept=()):
    def make(g):
        l = g["l"]
        beam = Beam(GROUND, BODY, (0.0, 0.0), (l, 0.0), g["h"], g["b"])
        centre = (l / 2.0, 0.0) if axis == TURN else (l, 0.0)
        return Joint((beam,), ((BODY, Mass((l, 0.0))),), axis, kept, centre)

    return make


def _heights(g):
    n = g.get("blades", 2)
    return [(k - (n - 1) / 2.0) * g["spacing"] for k in range(n)]


def _leaf(g):
    l = g["l"]
    if "spacing" not in g:
        g, kept = {**g, "spacing": l}, (TURN,)  # so far apart that the stage cannot turn
    else:
        kept = ()
    beams = tuple(Beam(GROUND, BODY, (0.0, y), (l, y), g["h"], g["b"]) for y in _heights(g))
    return Joint(beams, ((BODY, Mass((l / 2.0, 0.0))),), Y, kept, (l / 2.0, 0.0))


def _necked(g):
    l, l_c, beams, bodies = g["l"], g["l_c"], [], []
    for k, y in enumerate(_heights(g)):
        middle = f"middle {k}"
        bodies.append((middle, Mass((l / 2.0, y))))
        beams.append(Beam(GROUND, middle, (0.0, y), (l_c, y), g["h"], g["b"]))
        beams.append(Beam(middle, BODY, (l - l_c, y), (l, y), g["h"], g["b"]))
    bodies.append((BODY, Mass((l / 2.0, 0.0))))
    return Joint(tuple(beams), tuple(bodies), Y, (), (l / 2.0, 0.0))


def _hinge(thickness, l, b, throat):
    """Return a hinge about its middle; elements shrink towards a throat of that half-length."""
    share = throat / l
    half = [0.0]
    while (half[-1] + share) < 0.5 and len(half) < 6:
        half.append(half[-1] + share * 1.6 ** (len(half) - 1))
    half = [v for v in half if v < 0.42] + [0.5]
    breaks = tuple(sorted({0.5 - v for v in half} | {0.5 + v for v in half}))
    beam = Beam(GROUND, BODY, (-l / 2.0, 0.0), (l / 2.0, 0.0), thickness, b, breaks)
    return Joint((beam,), ((BODY, Mass((0.0, 0.0))),), TURN)


def _notch(g):
    e, r = g["e"], g["r"]

    def thickness(u):
        return e + 2.0 * (r - np.sqrt(np.maximum(r * r - ((2.0 * u - 1.0) * r) ** 2, 0.0)))

    return _hinge(thickness, 2.0 * r, g["b"], np.sqrt(e * r))


def _elliptic(g):
    e, depth, l = g["e"], g["depth"], g["l"]

    def thickness(u):
        return e + 2.0 * depth * (1.0 - np.sqrt(np.maximum(1.0 - (2.0 * u - 1.0) ** 2, 0.0)))

    return _hinge(thickness, l, g["b"], np.sqrt(e * l * l / (4.0 * depth)))


def _filleted(g):
    h, r, l = g["h"], g["r"], g["l"]

    def thickness(u):
        inside = np.maximum(r - l * np.minimum(u, 1.0 - u), 0.0)
        return h + 2.0 * (r - np.sqrt(np.maximum(r * r - inside**2, 0.0)))

    s = r / l
    breaks = [0.0, 0.3 * s, 0.6 * s, 0.85 * s, s]
    breaks = tuple(breaks + [0.5] + [1.0 - v for v in reversed(breaks)])
    beam = Beam(GROUND, BODY, (-l / 2.0, 0.0), (l / 2.0, 0.0), thickness, g["b"], breaks)
    return Joint((beam,), ((BODY, Mass((0.0, 0.0))),), TURN)


def _folded(g):
    """Return two stages in series: outer blades to a frame, inner ones back to the stage."""
    l, wide, narrow = g["l"], g["outer"] / 2.0, g["inner"] / 2.0
    beams = [Beam(GROUND, "frame", (0.0, y), (l, y), g["h"], g["b"]) for y in (wide, -wide)]
    beams += [Beam("frame", BODY, (l, y), (0.0, y), g["h"], g["b"]) for y in (narrow, -narrow)]
    at = (l / 2.0, 0.0)
    bodies = (("frame", Mass(at, g.get("frame_mass", 0.0))), (BODY, Mass(at)))
    return Joint(tuple(beams), bodies, Y, (), at)


_KINDS = {
    "cantilever": _single(Y),
    "guided-blade": _single(Y, (TURN,)),
    "moment-blade": _single(TURN),
    "leaf-spring-stage": _leaf,
    "necked-down-stage": _necked,
    "rcc": _pair,
    "cross-spring": _pair,
    "star": lambda g: _star(g["angles"], g["p"] if "p" in g else g["delta"] * g["l"], g),
    "three-blade": lambda g: _star((0.0, 2.0 * pi / 3.0, 4.0 * pi / 3.0), g.get("p", 0.0), g),
    "unseparated-cross": _unseparated,
    "notch-hinge": _notch,
    "elliptic-hinge": _elliptic,
    "filleted-hinge": _filleted,
    "layout": _folded,
}


@dataclass(frozen=True)
class Loads:
    """What acts besides a stroke, in the frame's axes: forces [N] at the body's point, a moment."""

    forces: tuple = ()
    moment: float = 0.0

    def pushes(self, joint, sense=1.0):
        if not self.forces and not self.moment:
            return []
        total = np.sum(self.forces, axis=0) if self.forces else np.zeros(2)
        return [Push(BODY, joint.at, tuple(sense * total), sense * self.moment)]


class Twin:
    """A joint of a material, and its true numbers by the plane frame."""

    def __init__(self, joint, E, nu, density=0.0, *, shear=True, degree=8):
        G = E / (2.0 * (1.0 + (nu or 0.0))) if shear else 1e6 * E
        self.joint, self.E, self.G, self.density, self.degree = joint, E, G, density, degree

    def frame(self, joint=None):
        joint = joint or self.joint
        return Frame(joint.bodies, joint.beams, self.E, self.G, self.density, self.degree)

    def held(self, travel, also=()):
        found = {(BODY, axis): 0.0 for axis in (*self.joint.kept, *also)}
        return found | {(BODY, self.joint.axis): travel}

    def stiffness(self):
        """Return the stiffness along the motion at rest [N/m or N·m/rad]."""
        frame = self.frame()
        return frame.tangent_stiffness(frame.rest(), (), self.held(0.0), (BODY, self.joint.axis))

    def frequency(self, mass, inertia):
        """Return the lowest frequency in the plane [Hz], a payload with its centre in the joint."""
        centre = self.joint.centre
        bodies = tuple(
            (n, m._replace(mass=mass, inertia=inertia or 0.0, com=centre) if n == BODY else m)
            for n, m in self.joint.bodies
        )
        frame = self.frame(replace(self.joint, bodies=bodies))
        kept = {(BODY, axis): 0.0 for axis in self.joint.kept}
        return float(frame.frequencies(1, kept)[0])

    def shift(self, travel):
        """Return how far the centre, or the stage along its blades, leaves its path [m]."""
        frame = self.frame()
        state = frame.stable_solve(self.held(travel))
        moved = frame.motion(state, BODY, self.joint.centre)
        return abs(moved[X]) if self.joint.axis == Y else float(np.hypot(*moved))

    def face_stresses(self, travels, loads=None, senses=(1.0,), hold=()):
        """Return stresses [Pa] per sense and end of the stroke, of each face, everywhere.

        ``travels`` are the ends of the stroke, or nothing without one; ``hold`` are axes kept.
        """
        frame, loads = self.frame(), loads or Loads()
        found = []
        for sense in senses:
            rows, pushes = [], loads.pushes(self.joint, sense)
            start = self._sagged(frame, pushes, hold) if travels and pushes else 0.0
            for travel in travels or (None,):
                held = {(BODY, axis): 0.0 for axis in hold}
                if travel is not None:
                    held = self.held(start + travel, hold)
                state = frame.stable_solve(held, pushes)
                if not frame.stands(state, pushes, held):
                    raise NoEquilibrium("the loads buckle it")
                rows.append(np.concatenate(frame.faces(state, PLACES), axis=None))
            found.append(np.stack(rows))
        return found

    def _sagged(self, frame, pushes, hold):
        """Return where loads leave the joint along its motion: there the stroke starts."""
        held = {(BODY, axis): 0.0 for axis in (*self.joint.kept, *hold)}
        state = frame.stable_solve(held, pushes)
        if not frame.stands(state, pushes, held):
            raise NoEquilibrium("the loads buckle it before it moves")
        moved = state.bodies[frame.names.index(BODY), self.joint.axis]
        return moved if self.joint.axis == TURN else moved * frame.length

    def critical(self, force, direction, ends, travel=None):
        """Return the least force along a direction [rad] that buckles the joint in its plane [N].

        The stroke's motion, and what the ends of the blades hold, stay held.
        """
        joint = self.joint.turned(-direction)
        frame = self.frame(joint)
        held = {(BODY, axis): 0.0 for axis in (*EULER_HOLDS[ends], *joint.kept)}
        start = None
        if travel is not None:
            held[BODY, joint.axis] = travel
            start = frame.stable_solve(held)
        load = Push(BODY, joint.at, (1.0 if force > 0.0 else -1.0, 0.0))
        clamped = sum(
            4.0 * pi**2 * self.E * b.b * np.min(_thickness(b)) ** 3 / 12.0 / b.length**2
            for b in joint.beams
        )
        return frame.critical([load], held, start=start, most=4.0 * clamped)


def _thickness(beam):
    return beam.h(PLACES) if callable(beam.h) else np.array([beam.h])


def yield_factor(stresses, strength):
    """Return R over the largest stress of all states."""
    return strength / max(float(np.abs(rows).max()) for rows in stresses)


def goodman_factor(stresses, amplitude, tensile, mean_stress="goodman"):
    """Return the factor on half the range with its mean (tension only), worst place and sense."""
    use = 0.0
    for one, other in stresses:
        half, mean = np.abs(one - other) / 2.0, np.maximum((one + other) / 2.0, 0.0)
        if mean_stress == "none":
            mean = 0.0 * mean
        use = max(use, float((half / amplitude + mean / tensile).max()))
    return 1.0 / use
