"""Random drawn layouts of wide blades, and their shift by beams of the plane and by shells."""

from typing import NamedTuple

import numpy as np
from pydantic import TypeAdapter

from flexcli.mechanics.equilibrium import solve as solve_in_plane
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.shell.first_guess import SHELL_LEVELS, shells_from_beams
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.planar import from_plane
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import AnyGeometry
from flexcli.parts.geometries.base import MOVING

KINDS = ("pair", "star", "parallel", "folded")
ADAPTER = TypeAdapter(AnyGeometry)
L, E = 0.02, 1e11


class Drawn(NamedTuple):
    """A layout as a spec has it, Poisson's ratio, and how far it moves [rad or m]."""

    spec: dict
    nu: float
    travel: float

    @property
    def geometry(self):
        return ADAPTER.validate_python(self.spec)

    def told(self):
        """Return what plates change of its shift, and the error, as the tool tells."""
        return self.wide().path.change([self.travel])

    def wide(self):
        """Return what plates change of its numbers."""
        geometry = self.geometry
        return geometry.wide_blades(geometry.sized({}), self.nu)

    def shifts(self):
        """Return how far it leaves its path by beams of the plane, and by thin shells [m]."""
        geometry = self.geometry
        turns, held = geometry.motion == "rotation", geometry.held(self.travel)
        layout = geometry.layout(Elastic(E, self.nu), geometry.sized({}))
        state = solve_in_plane(layout, {MOVING: held}).checked()
        point = (0.0, 0.0) if turns else layout.body(MOVING).point
        beams = point_motion(state, MOVING, point)[0]
        space = from_plane(layout, MOVING, turns=turns)
        drive = space.drive
        motion = {drive.body: [None] * 6}
        motion[drive.body][3 if turns else 0] = self.travel
        shells = solve(
            space, motion, frames=drive_frame(drive), tolerance=5e-3, levels=SHELL_LEVELS,
            made=shells_from_beams,
        ).checked().motion_of(drive.body, drive.point)[:2]  # fmt: skip
        kept = slice(0, 2 if turns else 1)
        return float(np.linalg.norm(beams[kept])), float(np.linalg.norm(shells[kept]))


def drawn_layout(seed, kind):
    """Return the random layout of a seed: pivots of two or three blades, or uneven stages."""
    rng = np.random.default_rng(seed)
    h, b = L * 10 ** rng.uniform(-2.3, -1.3), L * rng.uniform(0.15, 1.2)
    nu = float(rng.choice([0.3, 0.45]))

    def blade(bodies, start, end):
        return {
            "between": list(bodies), "from": _metres(start), "to": _metres(end),
            "h": f"{h * rng.uniform(0.8, 1.2)} m", "b": f"{b * rng.uniform(0.8, 1.2)} m",
        }  # fmt: skip

    travel, motion, bodies = 10 ** rng.uniform(-3.0, -1.0), "rotation", {"st": (0.0, 0.0)}
    if kind in ("pair", "star"):
        angles = rng.uniform(0.0, 2.0 * np.pi) + np.arange(3) * 2.0 * np.pi / 3.0
        angles += rng.uniform(-0.6, 0.6, 3)
        if kind == "pair":
            angles = angles[0] + np.array([0.0, rng.choice([-1.0, 1.0]) * rng.uniform(0.06, 1.5)])
        blades = {}
        for k, angle in enumerate(angles):
            near, long = rng.uniform(-0.8, 0.5) * L, rng.uniform(0.7, 1.3) * L
            along, away = np.array([np.cos(angle), np.sin(angle)]), 0.02 * L * rng.normal(size=2)
            ends = (near + long) * along + away, near * along + away
            blades[f"b{k}"] = blade(("ground", "st"), *ends)
    else:
        travel, motion = travel * L, {"translation": "90 deg"}
        l = L * rng.uniform(0.8, 1.2, 4)
        if kind == "parallel":
            bodies = {"st": (L, L / 2.0)}
            far = (l[1], L + rng.uniform(-0.2, 0.2) * l[1])
            blades = {
                "a": blade(("ground", "st"), (0.0, 0.0), (l[0], 0.0)),
                "b": blade(("ground", "st"), (0.0, L), far),
            }
        else:
            bodies = {"fr": (L, 0.0), "st": (0.0, 0.0)}
            blades = {}
            for k, side in enumerate((1.0, -1.0)):
                out, back = (0.0, 1.5 * side * L), (L, 0.75 * side * L)
                blades[f"out{k}"] = blade(("ground", "fr"), out, (l[2 * k], out[1]))
                blades[f"in{k}"] = blade(("fr", "st"), back, (L - l[2 * k + 1], back[1]))
    spec = {
        "kind": "layout", "bodies": {name: {"at": _metres(at)} for name, at in bodies.items()},
        "blades": blades, "moving": "st", "motion": motion,
    }  # fmt: skip
    return Drawn(spec, nu, float(travel))


def _metres(point):
    return [f"{float(x)!r} m" for x in point]
