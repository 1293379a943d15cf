"""Thick wide blades against solids between rigid bodies, by bricks and by Ritz's method."""

import numpy as np
import pytest
from plates.clamped_block import bending_factor, guided_factor
from plates.thick_block import factors

from flexcli.formulas import plate_factors as plates
from flexcli.formulas import thick_plates as thick

OF_MESH = 0.006
"""What finer bricks take of what the clamps of a solid stiffen (ν = 0.45, b = h), at most."""

OF_RITZ = 0.04
"""The same of solids by Ritz's method, whose functions know nothing of their edges."""

FORMULAS = (thick.thick_arc_factor, thick.thick_s_factor)


def _in_range(formula, solid, h, b, nu, of_mesh):
    k = float(formula(h=h, l=1.0, b=b, poisson_ratio=nu))
    error = float(thick.thick_error(k, h=h, l=1.0, poisson_ratio=nu))
    assert k - error <= solid <= k + error + of_mesh * (solid - 1.0)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
def test_solids_drawn_at_random_are_in_the_range(seed):
    rng = np.random.default_rng(seed)
    h = float(rng.uniform(0.1, 0.5))
    b, nu = float(h * np.exp(rng.uniform(0.0, np.log(5.0)))), float(rng.uniform(0.1, 0.48))
    for formula, solid in zip(FORMULAS, factors(h=h, b=b, nu=nu), strict=True):
        _in_range(formula, solid, h, b, nu, OF_MESH)


@pytest.mark.parametrize(("h", "b", "nu"), [(0.3, 1.2, 0.3), (0.3, 1.7, 0.45), (0.2, 1.0, 0.3)])
def test_blades_that_shear_much_are_softer_than_plates(h, b, nu):
    """Solids that share no code; plates with a beam's shear were told stiffer than these."""
    for formula, solver in zip(FORMULAS, (bending_factor, guided_factor), strict=True):
        _in_range(formula, solver(h=h, b=b, nu=nu), h, b, nu, OF_RITZ)


def test_thin_blades_have_the_factors_of_plates():
    b = np.array([0.01, 0.1, 0.5, 1.0, 3.0, 20.0])
    for nu in (0.2, 0.45):
        for formula, plate in zip(
            FORMULAS, (plates.pure_bending_factor, plates.guided_factor), strict=True
        ):
            found = formula(h=1e-6, l=1.0, b=b, poisson_ratio=nu)
            np.testing.assert_allclose(found, plate(b=b, l=1.0, poisson_ratio=nu), rtol=1e-4)


def test_without_poissons_ratio_an_arc_is_that_of_a_beam_and_an_s_nearly():
    h, b = np.array([0.05, 0.2, 0.3]), np.array([0.5, 1.0, 3.0])
    np.testing.assert_allclose(thick.thick_arc_factor(h=h, l=1.0, b=b, poisson_ratio=0.0), 1.0)
    s_shape = thick.thick_s_factor(h=h, l=1.0, b=b, poisson_ratio=0.0)
    # 0.0017 at 0.3: bricks of the fourth order, any width
    np.testing.assert_allclose(s_shape, [1.0, 1.0005, 1.0017], atol=2e-4)


def test_beyond_the_fit_its_error_grows():
    at = {"l": 1.0, "poisson_ratio": 0.3}
    known = thick.thick_error(1.08, h=0.3, **at)
    assert thick.thick_error(1.08, h=0.6, **at) == pytest.approx(7.0 * known)
    assert thick.thick_error(1.08, h=1e-3, **at) < 0.3 * known
