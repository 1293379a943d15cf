"""Strips between clamps that are bent so far that curvature flattens them: by thin shells."""

import numpy as np
from blades_at_stroke import SHELLS
from layouts_in_space import strip

from flexcli.engine import omitted_effects
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve as solve_in_plane
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.layout import Isotropic
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import MODEL_EFFECTS

E, L = 200e9, 0.1
KINDS = ("moment-blade", "guided-blade", "cantilever", "cross-spring")
SMALL = 1e-4
"""Travel over the thickness at which nothing is flattened yet."""


def bent_by(kind, travel, delta=0.0):
    """Return how far the tip of a blade moves across itself, over its length, and its turn.

    None is free: of a blade under a moment, a guide, a cantilever, or of a pivot's blade whose
    inner end is δ l from the centre.
    """
    return {
        "moment-blade": (None, travel),
        "guided-blade": (travel, 0.0),
        "cantilever": (travel, None),
        "cross-spring": (-delta * travel, travel),
    }[kind]


def risen(kind, travel, *, b, h, nu, delta=0.0):
    """Return by how much more the moment of the more bent end rises with the travel than a beam's.

    ``b`` and ``h`` are over the length, the travel in radians or over it.
    """
    material = Isotropic(E, E / 2.0 / (1.0 + nu), 0.0)
    shell = strip(h=h * L, b=b * L, l=L, material=material)
    blade = Blade("b", "ground", "tip", (0.0, 0.0), (L, 0.0), Constant(h * L), b * L)
    beam = Layout((Body("tip", (L, 0.0)),), (blade,), E, material.G)

    def moments(travel):
        across, turn = bent_by(kind, travel, delta)
        across = across if across is None else across * L
        planar = solve_in_plane(beam, {"tip": (None, across, turn)}).checked()
        thin = solve(shell, {"tip": (None, across, 0.0, 0.0, 0.0, turn)}, **SHELLS)
        (x, y, _), (f, g, m) = planar.motions[0, 0], planar.end_forces[0, 0]
        beams = np.array([m + (L + x) * g - y * f, m])
        (x, y, *_), (f, g, *_, m) = thin.motion_of("tip", (L, 0.0, 0.0)), thin.end_forces[0]
        return beams, np.array([m + (L + x) * g - y * f, m])

    bent, at_rest = np.array(moments(travel)), np.array(moments(SMALL * h))
    end = int(np.argmax(np.abs(bent[0])))
    beams, shells = bent[:, end] / at_rest[:, end]
    return float(shells / beams) - 1.0


def told(kind, travel, *, b, h, nu, delta=0.0):
    """Return the change of the stress that is told of that travel, without the plate's at rest."""
    shape = {"kind": kind, "h": f"{h * L} m", "l": f"{L} m", "b": f"{b * L} m"}
    if kind == "cross-spring":
        shape |= {"delta": delta, "half_angle": "40 deg"}
    turns = kind in ("moment-blade", "cross-spring")
    stroke = {"rotation": f"{travel} rad"} if turns else {"translation": f"{travel * L} m"}
    material = {"youngs_modulus": "200 GPa", "poisson_ratio": nu, "yield_strength": "1 GPa"}
    design = DesignSpec.model_validate(
        {
            "flexure": 1, "material": material, "geometry": shape,
            "cases": {"work": {"stroke": stroke}}, "requirements": {"yield": 1.0},
        }
    )  # fmt: skip
    effect = next(each for each in MODEL_EFFECTS if each.name == "anticlastic")
    return effect.changes(omitted_effects.setting(design, design.fixed_sizes()))["stress"]


def drawn(rng):
    """Return the kind, travel and sizes of a random blade that thin shells take."""
    kind = str(rng.choice(KINDS))
    b, h = 10.0 ** rng.uniform(-1.0, 0.3), 10.0 ** rng.uniform(-3.0, -1.7)
    sizes = {"b": b, "h": min(h, b / 8.0), "nu": float(rng.choice([0.3, 0.45]))}
    delta = float(rng.uniform(-1.2, 0.5)) if kind == "cross-spring" else 0.0
    return kind, float(10.0 ** rng.uniform(-2.5, -0.9)), {**sizes, "delta": delta}
