"""A blade from clamp to tip: shapes solve the beam's equation, stresses follow from curvature."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas import single_blade as blade
from flexcli.formulas import stage

BLADE = {"E": 200e9, "h": 300e-6, "l": 50e-3, "b": 10e-3}
I = 10e-3 * 300e-6**3 / 12


def curvature(shape, s, step=1e-4):
    """Second difference, exact for cubics."""
    return (shape(s - step) - 2 * shape(s) + shape(s + step)) / step**2


@given(st.floats(0.1, 0.9))
def test_the_stress_is_half_the_thickness_times_modulus_times_curvature(share):
    s, x, theta = share * 50e-3, 1e-3, 0.02
    E, h, l = BLADE["E"], BLADE["h"], BLADE["l"]
    cases = [
        (lambda at: blade.force_shape(l=l, x=x, s=at), blade.force_stress(E=E, h=h, l=l, x=x, s=s)),
        (
            lambda at: blade.guided_shape(l=l, x=x, s=at),
            blade.guided_stress(E=E, h=h, l=l, x=x, s=s),
        ),
        (
            lambda at: blade.moment_shape(l=l, theta=theta, s=at),
            blade.moment_stress(E=E, h=h, l=l, theta=theta),
        ),
    ]
    for shape, stress in cases:
        assert E * h / 2 * curvature(shape, s) == pytest.approx(stress, rel=1e-6, abs=1e3)


def test_the_tip_is_where_it_was_put_and_the_guided_one_does_not_turn():
    l = BLADE["l"]
    assert blade.force_shape(l=l, x=1e-3, s=l) == pytest.approx(1e-3)
    assert blade.guided_shape(l=l, x=1e-3, s=l) == pytest.approx(1e-3)
    near = l * (1 - 1e-6)
    slope = (blade.guided_shape(l=l, x=1e-3, s=l) - blade.guided_shape(l=l, x=1e-3, s=near)) / (
        l - near
    )
    assert slope == pytest.approx(0.0, abs=1e-6)


def test_the_work_of_the_tip_is_the_energy_of_bending():
    s, w = np.polynomial.legendre.leggauss(8)
    s, w, l = (s + 1) / 2 * BLADE["l"], w / 2 * BLADE["l"], BLADE["l"]
    given = {name: BLADE[name] for name in ("E", "h", "l")}
    for stiffness, travel, stress in (
        (blade.force_stiffness(**BLADE), 1e-3, blade.force_stress(**given, x=1e-3, s=s)),
        (blade.guided_stiffness(**BLADE), 1e-3, blade.guided_stress(**given, x=1e-3, s=s)),
        (
            blade.moment_stiffness(**BLADE),
            0.02,
            blade.moment_stress(**given, theta=0.02) + 0.0 * s,
        ),
    ):
        moment = stress * 2 * I / BLADE["h"]
        energy = w @ moment**2 / (2 * BLADE["E"] * I)
        assert stiffness * travel**2 / 2 == pytest.approx(energy, rel=1e-12)
    assert l == BLADE["l"]


@pytest.mark.parametrize("blades", [2, 3, 7])
def test_a_stage_of_n_blades_is_n_guided_blades(blades):
    K = stage.translational_stiffness(**BLADE, blades=blades)
    assert pytest.approx(blades * blade.guided_stiffness(**BLADE)) == K
    given = {name: BLADE[name] for name in ("E", "h", "l")}
    assert stage.end_stress(**given, x=1e-3) == pytest.approx(
        blade.guided_stress(**given, x=1e-3, s=0.0)
    )
