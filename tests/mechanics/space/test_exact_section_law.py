"""How a strip that is bent and twisted curls, against the least energy over its profile."""

import numpy as np
import pytest

from flexcli.formulas.plate_flattening import secant_factor, tangent_factor
from flexcli.mechanics.space.exact.section_law import curled

NU = 0.3
MODES = 14


def least_energy(kappa, tau, width):
    """``∫ (1 − ν²)⁻¹ ½ (κ² + 2νκw″ + w″² + 2(1 − ν)τ²) + 6/h² (ε − κw + ½τ²y²)² dy``, b = 1.

    In units of EI/b, over even polynomials w of y and the stretch ε of the axis (the first of
    them); ``width`` is β⁴/κ², so that h² = 3(1 − ν²)/width. Without Saint-Venant's torsion.
    """
    h2 = 3.0 * (1.0 - NU**2) / width
    u, weights = np.polynomial.legendre.leggauss(60)
    y, weights = u / 2.0, weights / 2.0
    profiles = [np.polynomial.legendre.Legendre.basis(2 * k) for k in range(MODES)]
    w = np.array([p(u) for p in profiles])
    curl = np.array([4.0 * p.deriv(2)(u) if k else 0.0 * u for k, p in enumerate(profiles)])
    stretch = -kappa * w
    stretch[0] = 1.0
    plate = 1.0 / (1.0 - NU**2)
    A = (plate * curl * weights) @ curl.T + 12.0 / h2 * (stretch * weights) @ stretch.T
    b = plate * NU * kappa * curl @ weights + 12.0 / h2 * (stretch * weights) @ (
        tau**2 * y**2 / 2.0
    )
    rest = 0.5 * plate * kappa**2 + 6.0 / h2 * weights @ (tau**2 * y**2 / 2.0) ** 2
    return rest - 0.5 * b @ np.linalg.solve(A, b)


@pytest.mark.parametrize("kappa", [0.02, 0.3, 2.0])
@pytest.mark.parametrize("tau", [0.0, 0.1, 0.3])
def test_moment_and_torque_are_the_slopes_of_the_least_energy(kappa, tau):
    width, step = 900.0, 1e-4
    moment, torque = (
        (least_energy(kappa + a, tau + b, width) - least_energy(kappa - a, tau - b, width))
        / (2.0 * step)
        for a, b in ((step, 0.0), (0.0, step))
    )
    found = curled(*map(np.array, (moment, tau, 0.0, width, NU)))
    assert found.kappa == pytest.approx(kappa, rel=1e-5)
    # the torque of the profile is Saint-Venant's and this
    assert found.torque == pytest.approx(torque, rel=1e-5, abs=1e-8)


@pytest.mark.parametrize("beta", [0.3, 2.0, 10.0, 24.9, 25.1, 80.0])
def test_an_untwisted_strip_flattens_as_ashwell_says(beta):
    kappa = 1.5
    width = beta**4 / kappa**2
    moment = kappa * float(secant_factor(beta=beta, poisson_ratio=NU))
    found = curled(*map(np.array, (moment, 0.0, 0.0, width, NU)))
    assert found.kappa == pytest.approx(kappa, rel=1e-10)
    assert 1.0 / found.compliance == pytest.approx(
        tangent_factor(beta=beta, poisson_ratio=NU), rel=1e-8
    )


def test_much_curvature_stiffens_a_strip_against_twist_by_its_poissons_ratio():
    """GJ → GJ/(1 − ν), GJ = 2EI/(1 + ν)."""
    found = curled(*map(np.array, (50.0, 0.0, 0.0, 1e8, NU)))
    added = float(found.stiffness) / (2.0 / (1.0 + NU))
    assert added == pytest.approx(NU / (1.0 - NU), rel=1e-2)


def test_the_derivatives_are_those_of_what_they_are_taken_of():
    at, step = (1.7, 0.25), 1e-5

    def law(M, tau):
        return curled(*map(np.array, (M, tau, 0.06, 4000.0, NU)))

    here = law(*at)
    by_M, by_tau = (
        [
            (getattr(law(at[0] + a, at[1] + b), name) - getattr(law(at[0] - a, at[1] - b), name))
            / (2.0 * step)
            for name in ("kappa", "torque")
        ]
        for a, b in ((step, 0.0), (0.0, step))
    )
    assert by_M == pytest.approx([here.compliance, -here.coupling], rel=1e-7)
    assert by_tau == pytest.approx([here.coupling, here.stiffness], rel=1e-7)
