"""Edges of bent blades, how far they curl, and how far points reach between travels."""

import numpy as np
import pytest

from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import Isotropic, SpaceBlade
from flexcli.mechanics.space.swept_box import Edges, Sweep, edges_of, swept_box

STEEL = Isotropic(E=200e9, G=200e9 / 2.6)


def curled(b, h, kappa, nu):
    """Return how far the sides of a long strip curl from its middle, by the plate's own equation.

    ``w⁗ + 4 a⁴ w = 0`` across it, ``w″ = −ν κ`` and ``w‴ = 0`` at its sides.
    """
    a = (3.0 * (1.0 - nu**2)) ** 0.25 * np.sqrt(kappa / h)
    c = a * b / 2.0
    sinh, cosh, sin, cos = np.sinh(c), np.cosh(c), np.sin(c), np.cos(c)
    bend = [[-2.0 * sinh * sin, 2.0 * cosh * cos],
            [-2.0 * (cosh * sin + sinh * cos), 2.0 * (sinh * cos - cosh * sin)]]  # fmt: skip
    one, two = np.linalg.solve(bend, [-nu * kappa / a**2, 0.0])
    y = np.linspace(0.0, c, 400)
    w = one * np.cosh(y) * np.cos(y) + two * np.sinh(y) * np.sin(y)
    return np.abs(w - w[0]).max()


@pytest.mark.parametrize("width", [0.5e-3, 2e-3, 5e-3, 8e-3, 12e-3, 40e-3])
def test_sides_curl_no_further_than_they_are_off(width):
    h, kappa, nu = 0.1e-3, 5.0, STEEL.nu
    blade = SpaceBlade("one", "ground", "body", (0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.0, 1.0),
                       Constant(h), width, STEEL)  # fmt: skip
    x, y, z = (np.broadcast_to(e, (2, 3)) for e in np.eye(3))
    line = np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0]])
    edges = Edges(line, x, y, z, np.full(2, h), np.full(2, kappa), np.zeros(2))
    found = edges_of(blade, edges, np.eye(3), 0.0)
    away = curled(width, h, kappa, nu)
    assert (found.off[:, 1] >= away).all()
    assert (found.off[:, 1] <= max(2.0 * away, nu * h)).all()
    assert np.ptp(found.points, axis=0) == pytest.approx([0.1, h, width], rel=1e-12)
    # and it is wider where it is compressed, by Poisson's ratio
    assert found.off[:, 2] == pytest.approx(nu * kappa * h / 2.0 * width / 2.0)


@pytest.mark.parametrize("count", [5, 8, 33])
def test_points_that_turn_reach_no_further_than_the_range_between_travels(count):
    turns = np.linspace(-0.4, 1.1, count)
    points = np.stack([np.cos(turns), np.sin(turns), 0.0 * turns], axis=-1)[None, :, None]
    box = swept_box([Sweep(np.concatenate([points, 0.0 * points], axis=2), np.zeros(1))])
    assert box.sides[0] < 1.0 <= box.most[0]
    assert box.least == pytest.approx(box.sides)
    assert box.most[2] == 0.0
