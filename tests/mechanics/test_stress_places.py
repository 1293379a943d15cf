"""Where the stress of small motion is looked at along a piece."""

import numpy as np
import pytest

from flexcli.formulas.profile import Constant, Filleted, Notch, Tabulated
from flexcli.mechanics.stress_places import SAMPLED, stress_places

FINE = np.linspace(-1.0, 1.0, 4001)
L = 4.0
PROFILES = [
    *(Notch(e, 2.0) for e in (2e-3, 0.02, 0.1, 0.4, 2.0, 10.0)),
    *(Filleted(h, r) for h in (1e-3, 0.05, 1.0, 4.0) for r in (1.0, 2.0)),
    Tabulated((0.0, 0.3, 1.0), (0.1, 0.01, 0.02)),
    Tabulated((0.0, 0.3, 1.0), (0.01, 0.011, 1.0)),
]


def along(profile, places):
    each = [(piece, places(piece)) for piece in profile.pieces(L)]
    s = np.concatenate([np.ravel(piece.position(u)) for piece, u in each])
    h = np.concatenate([piece.thickness(u) * np.ones(u.size) for piece, u in each])
    return s, h


def test_a_uniform_piece_is_looked_at_where_it_ends():
    (piece,) = Constant(0.1).pieces(L)
    assert stress_places(piece).tolist() == [-1.0, 1.0]


@pytest.mark.parametrize("profile", PROFILES)
def test_the_stress_of_a_linear_moment_is_found_wherever_it_vanishes(profile):
    (s, h), (s_f, h_f) = along(profile, stress_places), along(profile, lambda _: FINE)
    near = np.geomspace(1e-5, 0.5, 40) * L
    for zero in (*np.linspace(-L, 2.0 * L, 201), *(L / 2.0 + near)):
        found, true = (np.abs((at - zero) / thick**2).max() for at, thick in ((s, h), (s_f, h_f)))
        assert (1.0 - 1e-6) * found <= true <= (1.0 + SAMPLED) * found


@pytest.mark.parametrize("profile", PROFILES[:6])
def test_so_is_the_mean_square_of_forces_and_moments_with_any_correlation(profile):
    rng, thin = np.random.default_rng(5), float(profile.e)

    def most(s, h, covariance):
        x, flat = (s - L / 2.0) / np.sqrt(thin * L), thin / h
        faces = (np.stack([flat, f * flat**2, f * x * flat**2]) for f in (1.0, -1.0))
        return max(np.einsum("ik,ij,jk->k", v, covariance, v).max() for v in faces)

    for _ in range(100):
        root = rng.normal(size=(3, 3)) * rng.choice([1.0, 0.1, 10.0], size=3)
        found, true = (
            most(*along(profile, places), root.T @ root)
            for places in (stress_places, lambda _: FINE)
        )
        assert np.sqrt(true) <= (1.0 + SAMPLED) * np.sqrt(found)
