"""Flattening of a curved wide blade against the least energy of its section."""

import numpy as np
import pytest

from flexcli.formulas import plate_flattening as flattening
from flexcli.formulas.plate_factors import bound


def energy(kappa, nu, h, b):
    """Return the least energy of a section: even powers of y, free sides, E = 1."""
    D, s = h**3 / (12.0 * (1.0 - nu**2)), b / 2.0
    y, weight = np.polynomial.legendre.leggauss(40)
    y, weight = y * s, weight * s
    powers = np.arange(0, 18, 2)
    w = (y[:, None] / s) ** powers
    w2 = powers * (powers - 1) / s**2 * (y[:, None] / s) ** np.maximum(powers - 2, 0)
    A = (w.T * weight) @ w * h * kappa**2 + (w2.T * weight) @ w2 * D
    right = -D * nu * kappa * (weight @ w2)
    return D * kappa**2 * b / 2.0 - right @ np.linalg.solve(A, right) / 2.0


@pytest.mark.parametrize("kappa", [0.05, 0.3, 1.0])
def test_moment_and_stiffness_are_slopes_of_the_least_energy(kappa):
    nu, h, b, step = 0.3, 1e-3, 60e-3, 1e-3
    beta = flattening.flat_width(b=b, h=h, curvature=kappa, poisson_ratio=nu)
    ends = kappa * (1.0 + step * np.array([-1.0, 0.0, 1.0]))
    low, middle, high = (energy(k, nu, h, b) for k in ends)
    EI = b * h**3 / 12.0
    moment = (high - low) / (2.0 * step * kappa)
    rate = (high - 2.0 * middle + low) / (step * kappa) ** 2
    secant = flattening.secant_factor(beta=beta, poisson_ratio=nu)
    tangent = flattening.tangent_factor(beta=beta, poisson_ratio=nu)
    assert secant == pytest.approx(moment / (EI * kappa), rel=1e-5)  # differences of second order
    assert tangent == pytest.approx(rate / EI, rel=1e-5)


FACTORS = [flattening.energy_factor, flattening.secant_factor, flattening.tangent_factor]


@pytest.mark.parametrize("factor", FACTORS)
def test_flattening_runs_from_beam_to_plate_without_a_step(factor):
    change = factor(beta=np.array([0.0, 0.2999999, 0.3000001, 1e6]), poisson_ratio=0.3) - 1.0
    assert change[0] == 0.0
    assert change[2] == pytest.approx(change[1], rel=1e-5)
    assert change[3] == pytest.approx(float(bound(0.3)), rel=1e-5)


def test_clamps_and_curvature_are_never_counted_twice():
    nu = 0.3
    flat = 1.0 / (1.0 - nu**2)
    k = np.linspace(1.0, flat, 21)
    both = flattening.held_and_curved(held=k[:, None], curved=k, poisson_ratio=nu)
    assert (both >= np.maximum(k[:, None], k) - 1e-12).all()
    assert (both <= flat + 1e-12).all()
    assert both[:, 0] == pytest.approx(k, rel=1e-12)
    assert both[-1] == pytest.approx(np.full(21, flat), rel=1e-12)
    assert flattening.held_and_curved(held=1.0, curved=1.0, poisson_ratio=0.0) == 1.0


def test_moment_and_tangent_are_the_rates_of_the_energy():
    # U = f(κ) κ²/2, β = c √κ: M = U', and the tangent is M'
    kappa = np.linspace(0.2, 40.0, 4001)
    energy, moment, tangent = (f(beta=np.sqrt(kappa), poisson_ratio=0.3) for f in FACTORS)
    rate = np.gradient(energy * kappa**2 / 2.0, kappa, edge_order=2)
    assert rate / kappa == pytest.approx(moment, rel=1e-4)
    assert np.gradient(moment * kappa, kappa, edge_order=2) == pytest.approx(tangent, rel=1e-3)
