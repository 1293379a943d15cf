"""Lateral stiffness of a leaf-spring guide at stroke: closed form against exact beams in space."""

import numpy as np
import pytest

from flexcli.formulas.guide_support import lateral_stiffness, twist_share
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.layout import (
    BeamEffects,
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
)

E, G, L = 190e9, 190e9 / 2.6, 0.1
MIDDLE = (0.0, L / 2.0, 0.0)
AS_DERIVED = BeamEffects(plate=False, curling=False)


def closed(h, b, x):
    return lateral_stiffness(h=h, b=b, l=L, x=x, youngs_modulus=E, shear_modulus=G, blades=2)


def exact(h, b, x, effects):
    blades = tuple(
        SpaceBlade(
            str(at), "ground", "stage", (at, 0.0, 0.0), (at, L, 0.0), (0.0, 0.0, 1.0),
            Constant(h), b, Isotropic(E, G),
        )
        for at in (L, -L)
    )  # fmt: skip
    drive = Drive("stage", False, (1.0, 0.0, 0.0), MIDDLE)
    layout = SpaceLayout((SpaceBody("stage", MIDDLE, MIDDLE),), blades, drive)
    held = {"stage": (x, None, None, None, None, None)}
    state = solve(layout, held, effects=effects, tolerance=1e-5).checked()
    return 1.0 / support_compliance(state, "stage", MIDDLE)[2, 2]


@pytest.mark.parametrize(("h", "b", "x"), [(0.5e-3, 50e-3, 0.02), (0.5e-3, 10e-3, 0.01)])
def test_lateral_stiffness_is_that_of_exact_beams_without_plates(h, b, x):
    assert closed(h, b, x) == pytest.approx(exact(h, b, x, AS_DERIVED), rel=0.01)  # as its card


@pytest.mark.parametrize(
    ("h", "b", "x"), [(0.5e-3, 50e-3, 0.02), (0.15e-3, 30e-3, 0.02), (0.5e-3, 20e-3, 0.005)]
)
def test_plates_and_curling_change_lateral_stiffness_by_what_its_card_tells(h, b, x):
    change = exact(h, b, x, BeamEffects()) / closed(h, b, x) - 1.0
    assert -0.01 <= change <= 0.22


def test_twist_share_solves_the_torsion_of_the_cubic_torque():
    p, n = 8.0, np.arange(1, 401)[:, None]
    xi, weight = np.polynomial.legendre.leggauss(700)
    xi = (xi + 1.0) / 2.0
    a = np.sin(n * np.pi * xi) @ (weight / 2.0 * 4.0 * (xi - 0.5) ** 3)
    series = np.sum(2.0 * a**2 / (1.0 + (n[:, 0] * np.pi / p) ** 2))
    assert twist_share(held=p) == pytest.approx(series, rel=1e-5)  # 400 of its terms


def test_ends_that_may_warp_leave_one_over_28():
    assert twist_share(held=1e7) == pytest.approx(1.0 / 28.0, rel=2e-6)  # less 1/(2p)
