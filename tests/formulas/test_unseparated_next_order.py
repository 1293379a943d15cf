"""Next-order formulas of joined crossed blades against the exact solver."""

import numpy as np
import pytest
from mechanisms_for_tests import E, G

from flexcli.formulas import unseparated as closed
from flexcli.formulas import unseparated_next_order as following
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.mesh import Effects

H, L, B = 1e-4, 20e-3, 10e-3
ANGLES = 0.04 * 2.0 ** np.arange(3)


def crossed(c, alpha):
    blades = []
    for name, angle in (("up", alpha), ("down", -alpha)):
        e = L * np.array([np.cos(angle), np.sin(angle)])
        base, far = tuple(-c * e), tuple((1.0 - c) * e)
        blades.append(Blade(name, "ground", "cross", base, (0.0, 0.0), Constant(H), B))
        blades.append(Blade(f"{name} far", "cross", "out", (0.0, 0.0), far, Constant(H), B))
    bodies = (Body("cross", (0.0, 0.0)), Body("out", (0.0, 0.0)))
    return Layout(bodies, tuple(blades), E, G)


@pytest.mark.parametrize(("c", "degrees"), [(0.5, 45.0), (0.3, 30.0), (0.7, 60.0)])
def test_moment_and_shift_are_right_to_the_next_power(c, degrees):
    alpha = np.radians(degrees)
    effects = Effects(extension=False, shear=False)
    held = {"out": (None, None, ANGLES)}
    found = solve(crossed(c, alpha), held, effects=effects, tolerance=1e-12).checked()
    at = {"crossing": c, "theta": ANGLES, "half_angle": alpha}
    K = closed.unseparated_stiffness(E=E, h=H, l=L, b=B)
    moment = found.reactions[:, 1, 2] / (K * ANGLES) - 1.0
    assert orders(moment - following.moment_change(**at)) == pytest.approx([4, 4], abs=0.3)
    shift = closed.unseparated_shift(l=L, **at) + following.next_shift(l=L, **at)
    assert orders(found.motions[:, 1, 0] + shift) == pytest.approx([6, 6], abs=0.4)


def orders(remainder):
    return np.log2(np.abs(remainder[1:] / remainder[:-1]))
