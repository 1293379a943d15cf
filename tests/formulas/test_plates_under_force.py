"""Wide blades that a force pulls or pushes, against plates by Ritz's method that share no code."""

from functools import cache

import numpy as np
import pytest
from plates.clamped_strip import Strip
from scipy.optimize import brentq

from flexcli.formulas import plates_under_force as forced
from flexcli.formulas.beam_column import s_bending, uniform_bending
from flexcli.formulas.plate_factors import guided_factor, pure_bending_factor

RITZ = 1e-3
"""What the Ritz solution is off by; where blades are narrow it is much of their widening."""

PULLS = (-9.0, -5.0, -2.0, 2.0, 5.0, 12.0, 25.0, 58.0, 120.0, 600.0)

ARC, S = np.array([0.0, -0.5, 0.0, 0.5]), np.array([-0.5, 0.0, 0.5, 0.0])
"""Motions of the ends (w, w', w, w'): turned against each other, moved across."""


@cache
def strip(b, nu):
    return Strip(b, nu, bubbles=4)


def end_moments(b, nu, n):
    """Return the end moment of an arc and of an S over the beam's at rest."""
    held = strip(b, nu).stiffness(-n) / b
    return (ARC @ held)[3], -(S @ held)[1] / 6.0


def stiffness(moment, shape, n):
    """Return EI over the beam's of the beam under the same force that has this moment."""
    return brentq(lambda k: k * float(shape(n / k)) - moment, 0.8, 2.5)


@pytest.mark.parametrize(
    ("b", "nu"),
    [
        (0.22, 0.45),
        (1.0, 0.3),
        *(
            pytest.param(b, nu, marks=pytest.mark.slow)
            for b in (0.1, 0.5, 2.0)
            for nu in (0.2, 0.5)
        ),
    ],
)
def test_a_pulled_plate_is_as_stiff_as_the_factors_say(b, nu):
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    for n in PULLS:
        arc, bent = end_moments(b, nu, n)
        for moment, shape, factor in (
            (arc, uniform_bending, forced.arc_under_force),
            (bent, s_bending, forced.s_under_force),
        ):
            true = stiffness(moment, shape, n)
            assert factor(n=n, **at) == pytest.approx(
                true, abs=forced.FORCE_ERROR * (true - 1.0) + RITZ
            )


def test_without_a_force_a_plate_is_that_at_rest():
    b, nu = np.geomspace(0.02, 20.0, 40)[:, None], np.linspace(0.0, 0.5, 6)
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    for n in (0.0, 1e-9, -1e-9):
        np.testing.assert_allclose(forced.arc_under_force(n=n, **at), pure_bending_factor(**at))
        np.testing.assert_allclose(forced.s_under_force(n=n, **at), guided_factor(**at))
        for ends in ((1.0, 1.0, 1.0), (-1.0, 1.0, 0.0)):
            first, last, mean = ends
            found = forced.under_force(first=first, last=last, mean=mean, n=n, **at)
            np.testing.assert_allclose(found, 1.0, atol=1e-9)


def test_a_blade_pulled_ever_harder_is_kept_flat_all_over():
    at = {"b": 0.1, "l": 1.0, "poisson_ratio": 0.4}
    for factor in (forced.arc_under_force, forced.s_under_force):
        k = factor(n=np.geomspace(1.0, 1e8, 60), **at)
        assert (np.diff(k) > 0.0).all()
        assert k[-1] == pytest.approx(1.0 / (1.0 - 0.4**2), rel=1e-3)


@pytest.mark.parametrize("grows", [True, False])
@pytest.mark.parametrize("n", PULLS)
@pytest.mark.parametrize("mix", [0.0, 0.4, 1.0])
def test_the_moments_of_a_plate_lie_in_the_range(n, mix, grows):
    """A blade turned by 1 at its ends and moved across: the force stays, or grows as it does."""
    b, nu = 0.3, 0.4
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    beam = (1.0 - mix) * float(uniform_bending(n)), mix * float(s_bending(n))
    rest = (1.0 - mix) * pure_bending_factor(**at) + mix * guided_factor(**at)
    low, high = forced.under_force(
        first=beam[0] - beam[1], last=sum(beam), mean=1.0 - mix, n=n, grows=grows, **at
    )
    more = float(forced.arc_under_force(n=n, **at)) if grows else 1.0
    for force in {n, more * n}:
        arc, bent = end_moments(b, nu, force)
        true = ((1.0 - mix) * arc + mix * bent) / sum(beam) / rest
        assert low - RITZ <= true <= high + RITZ


def test_beyond_the_force_that_buckles_a_clamped_blade_nothing_is_known():
    blade = {"b": 0.3, "l": 1.0, "poisson_ratio": 0.3}
    found = forced.under_force(first=-1.0, last=1.0, mean=0.0, n=-31.0, **blade)
    assert tuple(map(float, found)) == (0.0, np.inf)


@pytest.mark.parametrize("n", [-20.0, -31.0, -50.0])
def test_without_poissons_ratio_a_plate_is_a_beam_under_any_force(n):
    blade = {"b": 0.3, "l": 1.0, "poisson_ratio": 0.0}
    found = forced.under_force(first=-1.0, last=1.0, mean=0.0, n=n, **blade)
    assert tuple(map(float, found)) == pytest.approx((1.0, 1.0))
