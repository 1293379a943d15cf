"""Wide blades joined where they cross, turned far: their shift by thin shells of both halves."""

import numpy as np
import pytest
from blades_at_stroke import SHELLS
from layouts_in_space import strip
from scipy.optimize import brentq

from flexcli.engine import omitted_effects
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve as solve_in_plane
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.layout import Isotropic
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import MODEL_EFFECTS

E, L, H = 200e9, 0.1, 0.0015


def half(share, b, nu, turn):
    """Return moments at the line and shortenings of a half that turns about it: beams, shells.

    Both as of a blade of length L, of which it is a share.
    """
    h, b, material = H / share * L, b / share * L, Isotropic(E, E / 2.0 / (1.0 + nu), 0.0)
    blade = Blade("b", "ground", "tip", (0.0, 0.0), (L, 0.0), Constant(h), b)
    beam = Layout((Body("tip", (L, 0.0)),), (blade,), E, material.G)
    planar = solve_in_plane(beam, {"tip": (None, np.sin(turn) * L, turn)}).checked()
    held = {"tip": (None, np.sin(turn) * L, 0.0, 0.0, 0.0, turn)}
    thin = solve(strip(h=h, b=b, l=L, material=material), held, **SHELLS)
    (x, y, _), (f, g, m) = planar.motions[0, 0], planar.end_forces[0, 0]
    beams = (m + (L + x) * g - y * f, np.cos(turn) * L - L - x)
    (x, y, *_), (f, g, *_, m) = thin.motion_of("tip", (L, 0.0, 0.0)), thin.end_forces[0]
    return np.array([beams, (m + (L + x) * g - y * f, np.cos(turn) * L - L - x)])


def shift(which, crossing, b, nu, turn):
    """Return how much both halves shorten that bear the same moment, by beams or by shells."""
    shares = crossing, 1.0 - crossing

    def each(part):
        turns = part * turn, (1.0 - part) * turn
        return [half(s, b, nu, t)[which] for s, t in zip(shares, turns, strict=True)]

    def apart(part):
        one, other = (m * s**3 for (m, _), s in zip(each(part), shares, strict=True))
        return one - other

    part = brentq(apart, 0.8 * crossing, 1.25 * crossing, xtol=1e-4)
    return sum(s * moved for (_, moved), s in zip(each(part), shares, strict=True))


@pytest.mark.parametrize(
    ("crossing", "b", "nu"), [(0.5, 1.6, 0.45), (0.7, 0.4, 0.45), (0.7, 0.82, 0.3)]
)
def test_joined_blades_turned_far_shift_as_shells_of_their_halves(crossing, b, nu):
    """Curvature keeps nearly all of them flat, so that they shift as beams do.

    What it may flatten unevenly is what clamps and line leave, a third of a plate at most.
    """
    design = DesignSpec.model_validate({
        "flexure": 1,
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": nu, "yield_strength": "1 GPa"},
        "geometry": {
            "kind": "unseparated-cross", "h": f"{H * L} m", "l": f"{L} m", "b": f"{b * L} m",
            "crossing": crossing, "half_angle": "60 deg",
        },
        "cases": {"work": {"stroke": {"rotation": "0.35 rad"}}},
        "requirements": {"yield": 1.0},
    })  # fmt: skip
    effect = next(each for each in MODEL_EFFECTS if each.name is EffectName.PLATE_WIDENING)
    found = effect.changes(omitted_effects.setting(design, design.fixed_sizes()))["shift"]
    beams, shells = (shift(which, crossing, b, nu, 0.35) for which in (0, 1))
    assert shells / beams - 1.0 == pytest.approx(found.value, abs=found.error)
    assert abs(shells / beams - 1.0) < 0.4 * found.value
    assert found.error < 2.0 * found.value + 0.01
