"""Sheet factors against Ritz solutions in plane stress that share no code with them."""

import pytest
from plates.clamped_sheet import Sheet
from plates.thick_block import axial_factor

from flexcli.formulas import sheet_factors as sheets

RITZ = 5e-5


@pytest.mark.slow
def test_ritz_solution_converges():
    for bends in (False, True):
        coarse = Sheet(0.5, 0.3, bends=bends, bubbles=3)
        fine = Sheet(0.5, 0.3, bends=bends, bubbles=5)
        for name in ("guided_factor", "bending_factor") if bends else ("axial_factor",):
            assert getattr(coarse, name)() == pytest.approx(getattr(fine, name)(), rel=RITZ)


@pytest.mark.slow
@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("b", [0.2, 1.0, 5.0])
def test_factors_are_those_of_the_sheet(b, nu):
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    along, bent = (Sheet(b, nu, bends=bends, bubbles=3) for bends in (False, True))
    within = sheets.SHEET_ERROR + RITZ
    assert sheets.axial_factor(**at) == pytest.approx(along.axial_factor(), rel=within)
    assert sheets.bending_factor(**at) == pytest.approx(bent.bending_factor(), rel=within)
    assert sheets.guided_factor(**at) == pytest.approx(
        bent.guided_factor(), rel=sheets.GUIDED_ERROR + RITZ
    )


def test_factors_run_from_beam_to_plane_strain():
    for factor in (sheets.axial_factor, sheets.bending_factor):
        assert factor(b=0.0, l=1.0, poisson_ratio=0.3) == 1.0
        assert factor(b=1e6, l=1.0, poisson_ratio=0.3) == pytest.approx(1.0 / 0.91, rel=1e-4)
    assert sheets.guided_factor(b=1e6, l=1.0, poisson_ratio=0.3) == pytest.approx(1.2, rel=1e-4)


def test_a_blade_held_across_grows_by_poissons_ratio_where_it_is_wide_and_not_where_narrow():
    narrow, wide = sheets.held_growth(b=[1e-6, 5.0], l=1.0, poisson_ratio=0.3)
    assert narrow == pytest.approx(0.0, abs=1e-6)
    assert 0.8 * 0.3 < wide < 0.3
    assert sheets.held_growth(b=1.0, l=1.0, poisson_ratio=0.0) == 0.0


def test_the_compliances_of_bending_and_of_shear_add_up():
    at = {"b": 0.5, "l": 1.0, "poisson_ratio": 0.3}
    Phi = 2.4 * 1.3 * 0.5**2

    def compliance(shear):
        return (1.0 + Phi / shear) / sheets.guided_factor(**at, shear=shear)

    stiff = compliance(1e12)
    assert compliance(1.0) - stiff == pytest.approx(2.0 * (compliance(2.0) - stiff), rel=1e-9)


@pytest.mark.parametrize(("h", "b", "nu"), [(0.3, 3.0, 0.3), (0.6, 0.6, 0.45), (0.1, 0.5, 0.48)])
def test_a_block_stretches_as_bricks_of_high_order(h, b, nu):
    solid = axial_factor(h=h, b=b, nu=nu)
    k = float(sheets.block_axial_factor(h=h, l=1.0, b=b, poisson_ratio=nu))
    assert abs(solid - k) <= sheets.HELD_ERROR * (k - 1.0)
    assert solid - float(sheets.axial_factor(b=b, l=1.0, poisson_ratio=nu)) > 0.01 * h
