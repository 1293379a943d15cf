"""Modes at their corners: nearly equal ones, one at the band's end, coordinates without mass."""

from math import pi, sqrt

import numpy as np
import pytest

from flexcli.formulas.modal_response import response_moments
from flexcli.formulas.oscillator import oscillator_response
from flexcli.numerics.modes import natural_modes
from flexcli.parts.asd import RandomVibration
from flexcli.parts.geometries import Blade, Elastic
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.mechanisms.payload import Payload
from flexcli.parts.response import random_response
from flexcli.parts.structure import Structure

FREQUENCY, LEVEL = np.array([20.0, 2000.0]), np.array([2.0, 2.0])
APART = 1e-6
"""Relative distance of two modes."""

PANELS = 1e-11
"""What Gauss rules on graded panels leave."""
EIGEN = 1e-9
"""An eigenproblem of some coordinates, whose stiffnesses differ by 1e6."""


def moment(angular, coefficients, Q, residual=0.0):
    return float(
        response_moments(
            frequency=FREQUENCY,
            level=LEVEL,
            scale="log",
            angular=np.asarray(angular),
            Q=Q,
            coefficients=np.atleast_2d(coefficients),
            residual=np.array([residual]),
            orders=(0.0,),
        )[0, 0]
    )


@pytest.mark.parametrize("Q", [0.5, 10.0, 1e3, 1e6])
def test_two_modes_1e_6_apart_with_the_same_sign_are_one_of_twice_the_size(Q):
    """Added as independent they would give half of the mean square."""
    pair = 2 * pi * 100.0 * np.array([1.0, 1.0 + APART / max(Q, 1.0)])
    one = moment(pair[:1], [1.0], Q)
    # they differ by a share of the bandwidth, at most APART of the response
    assert moment(pair, [0.5, 0.5], Q) == pytest.approx(one, rel=3 * APART)


@pytest.mark.parametrize("Q", [10.0, 1e3])
def test_two_modes_1e_6_apart_of_opposite_sign_leave_their_difference(Q, kept):
    """The sum cancels to 1e-6 Q of each: a response built from mean squares keeps nothing."""
    pair = 2 * pi * 100.0 * np.array([1.0, 1.0 + APART])
    found = moment(pair, [1.0, -1.0], Q)
    # the difference over one product of denominators, on the panels of the sum
    f, width = _panels(100.0, Q)
    w = 2 * pi * f
    first, second = (a**2 - w**2 + 1j * w * a / Q for a in pair)
    gap = (pair[1] - pair[0]) * (pair[1] + pair[0] + 1j * w / Q)
    exact = float((np.abs(gap / (first * second)) ** 2 * 2.0) @ width)
    # rounding of each over what is left of both
    assert found == pytest.approx(exact, rel=max(PANELS, 1e-15 / (APART * Q) * 1e2))
    kept(found, exact)


def _panels(fn, Q):
    """Give points and weights of a fine Gauss rule that closes in on a resonance."""
    x, w = np.polynomial.legendre.leggauss(24)
    series = fn / Q * np.geomspace(0.05, 1e5, 80)
    edges = np.unique(np.clip(np.concatenate([fn - series, [fn], fn + series]), 20.0, 2000.0))
    half = np.diff(edges)[:, None] / 2
    middle = (edges[1:] + edges[:-1])[:, None] / 2
    return (middle + half * x).ravel(), (half * w).ravel()


def test_the_response_does_not_depend_on_how_nearly_equal_modes_are_mixed():
    """Shapes of nearly equal modes are arbitrary: only what they make together has a meaning."""
    M = np.eye(2)
    K = (2 * pi * 100.0) ** 2 * np.diag([1.0, 1.0 + 2 * APART])
    rows, influence = np.array([[1.0, 0.3]]), np.array([1.0, 0.5])
    found = []
    for turn in (0.0, 0.4, 1.1):
        T = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
        structure = Structure(
            T.T @ M @ T,
            T.T @ K @ T,
            {"x": T.T @ M @ influence},
            {"x": float(influence @ M @ influence)},
            {"travel": rows @ T},
        )
        found.append(random_response(structure, vibration(20.0, 2000.0)).outputs["travel"].rms)
    assert found == pytest.approx([found[0]] * 3, rel=EIGEN)


def vibration(low, high, **use):
    ends = [{"frequency": f"{f!r} Hz", "level": "0.01 g^2/Hz"} for f in (low, high)]
    return RandomVibration.model_validate({"profile": {"points": ends}, "q": 50, **use})


@pytest.mark.parametrize("Q", [0.5, 10.0, 1e3, 1e6])
@pytest.mark.parametrize("fn", [20.0, 2000.0])
def test_a_mode_at_the_band_s_end_is_the_single_oscillator(fn, Q, kept):
    """Half of its resonance is in the band: a panel that begins there must not be dropped."""
    found = sqrt(moment([2 * pi * fn], [1.0], Q))
    single = oscillator_response(FREQUENCY, LEVEL, fn, Q)
    assert found == pytest.approx(float(single.relative_displacement), rel=1e-9)
    kept(found, single.relative_displacement)


def test_a_massless_coordinate_has_no_mode_and_follows_the_others():
    """Inverting the mass matrix divides by zero; a tiny mass instead makes a false mode."""
    K = np.array([[3.0, -1.0], [-1.0, 1.0]])
    without, nearly = (natural_modes(K, np.diag([1.0, m])) for m in (0.0, 1e-20))
    assert without.angular.size == nearly.angular.size == 1
    # the free end follows the first coordinate, so that its spring carries nothing
    assert without.angular[0] == pytest.approx(sqrt(2.0), rel=1e-14)
    np.testing.assert_allclose(without.shapes[1], without.shapes[0], rtol=1e-14)
    assert nearly.angular[0] == pytest.approx(float(without.angular[0]), rel=1e-14)


def test_a_payload_without_inertia_responds_as_one_whose_inertia_tends_to_zero(kept):
    """Its rotation has no mass: the mode leaves for infinity, and what it carried stays."""
    pivot = RCCPivot(kind="rcc", p="2 mm", half_angle="45 deg", h="0.6 mm", l="17 mm", b="10 mm")
    blade = Blade(0.6e-3, 17e-3, 10e-3)
    found = []
    for inertia in ({}, {"inertia": "1e-20 kg*m^2"}):
        payload = Payload(kind="payload", mass="0.5 kg", **inertia)
        structure = payload.structure(pivot, Elastic(114e9), blade, None)
        response = random_response(structure, vibration(20.0, 2000.0, axis="x and y"))
        found.append(response.outputs["stress joint"].rms)
    assert found[0] == pytest.approx(found[1], rel=EIGEN)
    assert found[0] > 0.0
    kept(*found)
