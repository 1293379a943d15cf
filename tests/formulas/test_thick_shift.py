"""The shift of thick blades: against exact blades that stretch or shear, and limits."""

from math import cos

import numpy as np
import pytest
from geometries_for_tests import geometry

from flexcli.formulas.section import shear_parameter
from flexcli.formulas.stage import shortening
from flexcli.formulas.thick_blades import pivot_stretch, shear_factor, stage_stretch
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.points import point_motion
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import Blade

E, NU, H, L, B = 114e9, 0.33, 1e-3, 20e-3, 2e-3


def layout_of(kind: str, **given: object) -> Layout:
    joint = geometry(kind, **given)
    return joint.layout(Elastic(E, NU), Blade(H, L, B))


@pytest.mark.parametrize(
    ("effects", "factor"),
    [
        (
            Effects(extension=False),
            shear_factor(shear_parameter(depth=H, l=L, poisson_ratio=NU)),
        ),
        (Effects(shear=False), 1.0 + stage_stretch(h=H, l=L)),
    ],
)
def test_a_guided_blade_shortens_as_its_shear_and_stretching_say(effects, factor):
    x = 1e-3 * L
    found = solve(layout_of("guided-blade"), {"moving": (None, x, 0.0)}, effects=effects)
    shift = -point_motion(found.checked(), "moving", (L, 0.0))[0, 0]
    assert shift == pytest.approx(shortening(l=L, x=x) * factor, rel=2e-5)


@pytest.mark.parametrize("delta", [-0.8, -0.5, -0.2, 0.3, 1.0])
def test_a_pivot_shifts_along_its_bisector_as_its_stretching_says(delta):
    theta, alpha = 1e-3, 0.7
    layout = layout_of("cross-spring", delta=delta, half_angle="0.7 rad", p=None)
    found = solve(layout, {"moving": (None, None, theta)}, effects=Effects(shear=False))
    x = point_motion(found.checked(), "moving", (0.0, 0.0))[0, 0]
    leading = (5.0 - 9.0 * (1.0 + 2.0 * delta) ** 2) / 60.0
    bracket = leading + pivot_stretch(h=H, l=L, p=delta * L, half_angle=alpha)
    assert x == pytest.approx(bracket * L * theta**2 / cos(alpha), rel=1e-4)


def test_thin_blades_do_not_stretch():
    h = np.array([1e-9, 1e-8])
    assert pivot_stretch(h=h, l=L, p=L, half_angle=1.0) == pytest.approx(0.0, abs=1e-11)
    assert stage_stretch(h=h, l=L) == pytest.approx(0.0, abs=1e-12)
    assert shear_factor(0.0) == 1.0
