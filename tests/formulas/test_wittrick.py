"""The shift that Wittrick's crossing leaves, against exact blades."""

import numpy as np
import pytest
from mechanisms_for_tests import pivot

from flexcli.formulas.pivot import WITTRICK
from flexcli.formulas.pivot_next_order import shift_across
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.mesh import Effects

L = 20e-3
SLENDER = Effects(extension=False, shear=False)
NEXT_ORDER = 1e-3
"""What the term of θ⁵ adds at 1° to that of θ³, between half-angles of 20° and 70°."""


def exact(delta, half_angle, theta):
    """Shift of the centre along and across the bisector [m], the outer ends fixed."""
    layout = pivot(delta=delta, alpha=half_angle)
    found = solve(layout, held={"out": (None, None, theta)}, effects=SLENDER).checked()
    return found.motions[0, 0, :2]


@pytest.mark.parametrize("half_angle", np.radians([20.0, 35.0, 45.0, 60.0, 70.0]))
@pytest.mark.parametrize("delta", [WITTRICK, -1.0 - WITTRICK])
def test_what_is_left_is_the_cube_of_the_rotation_across_the_bisector(half_angle, delta):
    theta = np.radians(1.0)
    along, across = exact(delta, half_angle, theta)
    formula = abs(shift_across(l=L, p=delta * L, theta=theta, half_angle=half_angle))
    assert abs(across) == pytest.approx(formula, rel=NEXT_ORDER)
    root = 5**0.5 / 315 * np.cos(half_angle) / np.sin(half_angle) ** 2
    assert formula == pytest.approx(root * theta**3 * L, rel=1e-9)
    assert abs(along) < 0.1 * abs(across)


def test_along_the_bisector_the_fourth_power_is_left():
    one, two = (exact(WITTRICK, np.pi / 4, np.radians(a))[0] for a in (2.0, 4.0))
    assert two / one == pytest.approx(16.0, rel=1e-3)
    assert one / (L * np.radians(2.0) ** 4) == pytest.approx(0.0065, abs=5e-5)


def test_the_shift_is_a_hundredth_of_the_symmetric_pivots_at_ten_degrees():
    theta = np.radians(10.0)
    left, symmetric = (np.hypot(*exact(d, np.pi / 4, theta)) for d in (WITTRICK, -0.5))
    assert left / symmetric == pytest.approx(0.015, abs=5e-4)
