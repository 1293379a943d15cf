"""Springs of blades that are stiffer one way, against Ritz solutions that share no code."""

import numpy as np
import pytest
from plates.clamped_sheet import Sheet
from plates.clamped_strip import Strip

from flexcli.formulas.clamped_blade import Across, clamped_blade

THIN = 1e-5


@pytest.mark.parametrize(
    ("b", "nu", "shear"),
    [
        (0.3, 0.3, 1.5),
        *(
            pytest.param(b, nu, shear, marks=pytest.mark.slow)
            for b in (0.05, 0.8, 2.0)
            for nu in (0.02, 0.42)
            for shear in (0.25, 4.0)
        ),
    ],
)
def test_springs_are_those_of_the_directed_plate_and_sheet_within_their_error(b, nu, shear):
    """Twice as stiff across its width as along: as wide as 2^(−¼) of itself."""
    E, wider = 1.0, 2.0**-0.25
    G = shear * E / wider**2 / (2.0 * (1.0 + nu))
    width = b / wider
    found = clamped_blade(E=E, G=G, h=THIN, l=1.0, b=width, across=Across(nu, wider, G))
    bent, twisted = (Strip(b, nu, odd=odd, shear=shear, bubbles=3) for odd in (False, True))
    along, aside = (Sheet(b, nu, bends=bends, shear=shear, bubbles=3) for bends in (False, True))
    I, J = width * THIN**3 / 12.0, width * THIN**3 / 3.0
    # the sheet tells its S shape over Timoshenko's of the same width and modulus along it
    Phi = 1.2 * E / G * width**2
    true = np.array([
        E * THIN * width * along.axial_factor(),
        12.0 * E * I * bent.guided_factor(),
        E * THIN * width**3 / (1.0 + Phi) * aside.guided_factor(),
        G * J * twisted.twist_factor(),
        E * THIN * width**3 / 12.0 * aside.bending_factor(),
        E * I * bent.bending_factor(),
    ])  # fmt: skip
    off = true / found.stiffness - 1.0
    ritz = 2e-4
    assert (off >= found.low - ritz).all()
    assert (off <= found.high + ritz).all()
    # and says no more than that
    assert max(-found.low.min(), found.high.max()) < 0.14


@pytest.mark.parametrize(
    ("h", "by_force", "by_moment"), [(0.03, 0.0023, 0.0013), (0.1, 0.0053, 0.0034)]
)
def test_thick_wide_blades_are_within_their_error_as_stiff_as_solids(h, by_force, by_moment):
    """How much stiffer CalculiX's solids are at the tip (ν = 0.45, b = 3 l, three meshes)."""
    found = clamped_blade(E=1.0, G=1.0 / 2.9, h=h, l=1.0, b=3.0)
    plain, stiff = found.stiffness, found.stiffness * (1.0 + found.high)
    tip, most = (1.0 / (1.0 / k[1] + 0.25 / k[5]) for k in (plain, stiff))
    assert plain[5] * (1.0 + by_moment) < stiff[5]
    assert tip * (1.0 + by_force) < most
    assert most < tip * (1.0 + 4.0 * by_force)
