"""Bending of clamped strips of crystals and sheets: limits, symmetry, and solids."""

import numpy as np
import pytest

from flexcli.formulas import plate_factors as plates
from flexcli.formulas.anisotropy import cubic_stiffness, in_plane_compliance
from flexcli.formulas.directed_plates import beside_isotropic, strip_bending

SILICON = cubic_stiffness(165.7e9, 63.9e9, 79.6e9)
NIOBIUM = cubic_stiffness(246e9, 134e9, 28.7e9)

ISOTROPIC = 1.5e-3
"""Ritz's orders here and the fits of the isotropic factors, both below 1e-3."""

SOLID = 3e-3
"""What the thickness of these solids (h up to b/6) and their mesh change of a plate's factor."""


def isotropic(nu):
    return np.array([[1.0, -nu, 0.0], [-nu, 1.0, 0.0], [0.0, 0.0, 2.0 * (1.0 + nu)]])


def in_wafer(normal, first, degrees, *, thinned=False):
    """Return axes of a strip: along it, across its thickness, across its width."""
    n, x = (np.array(each) / np.linalg.norm(each) for each in (normal, first))
    y, a = np.cross(n, x), np.radians(degrees)
    along, aside = np.cos(a) * x + np.sin(a) * y, np.cos(a) * y - np.sin(a) * x
    return np.stack([along, n, -aside] if thinned else [along, aside, n])


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("b", [0.02, 0.2, 0.7, 2.0])
def test_an_isotropic_strip_is_as_stiff_as_the_factors_of_wide_blades(b, nu):
    found, error = strip_bending(isotropic(nu), b=b, l=1.0)
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    assert found.arc == pytest.approx(float(plates.pure_bending_factor(**at)), abs=ISOTROPIC)
    assert found.guided == pytest.approx(float(plates.guided_factor(**at)), abs=ISOTROPIC)
    assert found.loose == pytest.approx(found.arc, abs=1e-9)
    assert error < 1e-3


def test_stiffness_falls_to_its_limit_as_orders_rise(monkeypatch):
    """Ritz's stiffness is an upper bound, and each further order changes less."""
    S = in_plane_compliance(NIOBIUM, in_wafer((1, 1, 0), (1, -1, 0), 20.0, thinned=True))
    found, orders = [], [(4, 3), (5, 5), (6, 9), (7, 13), (8, 17)]
    for order in orders:
        monkeypatch.setattr("flexcli.formulas.directed_plates.ORDERS", (order, order))
        found.append(strip_bending(S, b=0.8, l=1.0)[0])
    for shape in zip(*found, strict=True):
        steps = -np.diff(shape)
        assert (steps > -1e-9).all()
        assert (steps[1:] < steps[:-1]).all()
        assert steps[-1] < 2e-4


def test_a_strip_turned_over_or_mirrored_is_as_stiff():
    S = in_plane_compliance(SILICON, in_wafer((1, 1, 1), (1, -1, 0), 10.0))
    mirror = np.diag([1.0, 1.0, -1.0])
    assert abs(S[0, 2]) > 0.05 * S[0, 0]
    one, other = (strip_bending(each, b=0.4, l=1.0)[0] for each in (S, mirror @ S @ mirror))
    assert one == pytest.approx(other, rel=1e-9)


def test_a_narrow_strip_is_held_by_its_clamps_as_a_bar_is():
    """An arc by 1/(1 − S_15²/(S_11 S_55)), free to twist by none of it, an S by none of it."""
    S = in_plane_compliance(SILICON, in_wafer((1, 1, 1), (1, -1, 0), 40.0))
    found, _ = strip_bending(S, b=0.005, l=1.0)
    held = 1.0 / (1.0 - S[0, 2] ** 2 / (S[0, 0] * S[2, 2]))
    assert held > 1.02
    assert found.arc == pytest.approx(held, abs=1e-3)
    assert found.loose == pytest.approx(1.0, abs=1e-3)
    assert found.guided == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize(
    ("crystal", "axes", "b", "arc", "loose", "guided"),
    [
        (SILICON, in_wafer((1, 1, 1), (1, -1, 0), 39.2035), 0.068087, 1.0220, 1.0022, 1.0063),
        (SILICON, in_wafer((1, 1, 0), (1, -1, 0), 43.0636, thinned=True), 0.28349, 1.0101, 1.0057,
         1.0135),
        (NIOBIUM, in_wafer((1, 1, 1), (1, -1, 0), 123.280), 0.61141, 1.1207, 1.1193, 1.1908),
    ],
)  # fmt: skip
def test_strips_are_as_stiff_as_solids_between_rigid_bodies(crystal, axes, b, arc, loose, guided):
    """CalculiX (C3D20R), h from l/140 to l/52; the S without what its shear gives way."""
    found, _ = strip_bending(in_plane_compliance(crystal, axes), b=b, l=1.0)
    assert found.arc == pytest.approx(arc, abs=SOLID)
    assert found.loose == pytest.approx(loose, abs=SOLID)
    assert found.guided == pytest.approx(guided, abs=SOLID)


def test_thick_blades_are_told_less_surely():
    S = in_plane_compliance(SILICON, in_wafer((1, 1, 1), (1, -1, 0), 40.0))
    at = {"b": 0.05, "l": 1.0, "poisson_ratio": 0.17}
    thin, thick = (beside_isotropic(S, h=h, **at) for h in (0.001, 0.04))
    for one, other in zip(thin, thick, strict=True):
        assert other[0] < one[0] < one[1] < other[1]
