"""Moduli of crystals and sheets along any axes, against Bond's matrices and published values."""

import numpy as np
import pytest

from flexcli.formulas.anisotropy import (
    cubic_stiffness,
    orthotropic_stiffness,
    plate_anisotropy,
    sheared_in_plane,
    strip_constants,
)

SILICON = (165.7e9, 63.9e9, 79.6e9)
"""c11, c12, c44 [Pa] of Hopcroft, Nix & Kenny (2010)."""


def rows(along, aside):
    a, n = np.array(along, dtype=float), np.array(aside, dtype=float)
    a, n = a / np.linalg.norm(a), n / np.linalg.norm(n)
    return np.stack([a, np.cross(n, a), n])


@pytest.mark.parametrize(
    ("along", "published"), [((1, 1, 0), 169e9), ((1, 0, 0), 130e9), ((1, 1, 1), 188e9)]
)
def test_silicon_is_as_stiff_along_its_directions_as_published(along, published):
    aside = (1, -1, 0) if along != (1, 0, 0) else (0, 0, 1)
    found = strip_constants(cubic_stiffness(*SILICON), rows(along, aside))
    assert pytest.approx(published, abs=0.5e9) == found.E


def test_poissons_ratios_of_a_100_wafer_are_those_published():
    """0.064 in the plane along ⟨110⟩, 0.36 towards the normal, 0.28 along ⟨100⟩."""
    C = cubic_stiffness(*SILICON)
    assert strip_constants(C, rows((1, 1, 0), (1, -1, 0))).nu_width == pytest.approx(
        0.064, abs=2e-3
    )
    assert strip_constants(C, rows((1, 1, 0), (0, 0, 1))).nu_width == pytest.approx(0.36, abs=5e-3)
    assert strip_constants(C, rows((1, 0, 0), (0, 0, 1))).nu_width == pytest.approx(0.28, abs=5e-3)


@pytest.mark.parametrize("seed", range(5))
def test_moduli_along_any_axes_are_those_of_bonds_matrix(seed):
    rng = np.random.default_rng(seed)
    a, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    a = a * np.sign(np.linalg.det(a))
    C = cubic_stiffness(*SILICON)
    # σ' = M σ, so that C' = M C Mᵀ and S' is its inverse
    M = np.zeros((6, 6))
    pairs = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
    for p, (i, j) in enumerate(pairs):
        for q, (k, l) in enumerate(pairs):
            M[p, q] = a[i, k] * a[j, l] + (a[i, l] * a[j, k] if k != l else 0.0)
    S = np.linalg.inv(M @ C @ M.T)
    found = strip_constants(C, a)
    assert pytest.approx(1.0 / S[0, 0], rel=1e-12) == found.E
    assert found.E_width == pytest.approx(1.0 / S[2, 2], rel=1e-12)
    assert found.nu_width == pytest.approx(-S[2, 0] / S[0, 0], rel=1e-9)
    assert found.nu_length == pytest.approx(-S[0, 2] / S[2, 2], rel=1e-9)
    assert found.G_wide == pytest.approx(1.0 / S[4, 4], rel=1e-12)


def test_a_111_wafer_is_alike_in_all_its_directions():
    C = cubic_stiffness(*SILICON)
    n, x = np.ones(3) / 3**0.5, np.array([1.0, -1.0, 0.0]) / 2**0.5
    y = np.cross(n, x)
    each = [
        strip_constants(C, [np.cos(t) * x + np.sin(t) * y, np.cos(t) * y - np.sin(t) * x, n]).E
        for t in np.linspace(0.0, 3.0, 7)
    ]
    assert each == pytest.approx([each[0]] * 7, rel=1e-12)


def test_an_orthotropic_sheet_has_its_own_constants_back_and_those_of_its_angle():
    E_1, E_2, G, nu = 140e9, 10e9, 5e9, 0.3
    C = orthotropic_stiffness(E_1=E_1, E_2=E_2, G_12=G, nu_12=nu)

    def at(angle):
        c, s = np.cos(angle), np.sin(angle)
        return strip_constants(C, [[c, s, 0.0], [0.0, 0.0, 1.0], [s, -c, 0.0]])

    assert pytest.approx(E_1) == at(0.0).E
    assert pytest.approx(E_2) == at(np.pi / 2.0).E
    assert (at(0.0).nu_width, at(0.0).G_wide) == pytest.approx((nu, G))
    # the off-axis modulus of any text on laminates
    c, s = np.cos(0.5), np.sin(0.5)
    inverse = c**4 / E_1 + s**4 / E_2 + (1.0 / G - 2.0 * nu / E_1) * c**2 * s**2
    assert pytest.approx(1.0 / inverse) == at(0.5).E
    # along its axes it does not twist as it bends; askew and wide it is as stiff as Q̄_11 says
    assert max(at(0.0).held, at(np.pi / 2.0).held) == pytest.approx(0.0, abs=1e-12)
    shared = 1.0 - nu**2 * E_2 / E_1
    stiff = (c**4 * E_1 + s**4 * E_2 + 2.0 * c**2 * s**2 * nu * E_2) / shared
    stiff += 4.0 * c**2 * s**2 * G
    own = at(0.5)
    plate = own.E / (1.0 - own.nu_width * own.nu_length)
    assert 1.0 + own.held == pytest.approx(max(stiff / plate, 1.0 / (1.0 - twist(own, 0.5))))


def twist(strip, angle):
    """S̄_16²/(S̄_11 S̄_66) of a sheet of E_1, E_2, G, ν_12 of the test above."""
    c, s = np.cos(angle), np.sin(angle)
    S_11, S_22, S_12, S_66 = 1.0 / 140e9, 1.0 / 10e9, -0.3 / 140e9, 1.0 / 5e9
    S_16 = (2.0 * S_11 - 2.0 * S_12 - S_66) * s * c**3 - (2.0 * S_22 - 2.0 * S_12 - S_66) * s**3 * c
    return S_16**2 * strip.E * strip.G_wide


def test_an_isotropic_plate_is_none_of_them():
    E, nu = 200e9, 0.3
    C = orthotropic_stiffness(E_1=E, E_2=E, G_12=E / 2.0 / (1.0 + nu), nu_12=nu)
    found = strip_constants(C, np.eye(3))
    assert plate_anisotropy(found) == pytest.approx(0.0, abs=1e-12)
    assert found.nu == pytest.approx(nu)


@pytest.mark.parametrize("constants", [(1.0, 2.0, 1.0), (1.0, 0.5, -1.0), (1.0, -0.6, 1.0)])
def test_a_crystal_that_would_fall_apart_is_refused(constants):
    with pytest.raises(ValueError, match="no crystal"):
        cubic_stiffness(*constants)


def test_an_isotropic_strip_shears_as_its_beam_and_thins_at_its_clamps_alone():
    E, nu = 70e9, 0.3
    C = orthotropic_stiffness(E_1=E, E_2=E, G_12=E / (2.0 * (1.0 + nu)), nu_12=nu)
    by_square, by_first = sheared_in_plane(strip_constants(C, np.eye(3)))
    assert by_square == pytest.approx(0.0, abs=1e-12)
    assert by_first == pytest.approx(0.45 * nu**2, rel=1e-9)


def test_a_strip_along_a_sheet_of_little_shear_stiffness_is_softer_by_its_shear():
    """Of Timoshenko's beam, bent to an S: Φ = 1.2 E/G (h/l)²."""
    C = orthotropic_stiffness(E_1=140e9, E_2=10e9, G_12=5e9, nu_12=0.3)
    strip = strip_constants(C, np.eye(3))
    by_square, by_first = sheared_in_plane(strip)
    slender = 0.01
    isotropic, own = (1.0 + x * slender**2 for x in (2.4 * (1.0 + strip.nu), 1.2 * 140.0 / 5.0))
    assert isotropic / own - 1.0 == pytest.approx(-by_square * slender**2, rel=0.01)
    assert by_first < 0.01  # nothing couples along its axes
