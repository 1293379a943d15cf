"""Wide hinges that buckle, against fits to plates of constant thickness and limits."""

import numpy as np
import pytest

from flexcli.formulas.plate_buckling import BUCKLING_ERROR, buckling_factor
from flexcli.formulas.plate_factors import bound
from flexcli.formulas.profile import Constant, Filleted, Notch
from flexcli.mechanics.hinge_plate import half_of
from flexcli.mechanics.wide_hinge import wide_hinge
from flexcli.mechanics.wide_hinge_buckling import _beam, _bent, _least, buckled_hinge
from flexcli.parts.bending.wide_notch import LIMBS_BUCKLED

WHERE_THE_POINT_IS_NO_MATTER = ("clamped-clamped", "clamped-guided", "pinned-pinned")

RITZ = 2e-4
"""What both Ritz solutions of few functions are off by."""


@pytest.mark.parametrize("ends", WHERE_THE_POINT_IS_NO_MATTER)
@pytest.mark.parametrize("b", [0.2, 0.5, 1.0, 3.0])
def test_a_hinge_of_constant_thickness_buckles_as_the_clamped_strip(b, ends):
    found = buckled_hinge(Constant, (1e-3,), 1.0, b, 0.3, ends)
    strip = float(buckling_factor(b=b, l=1.0, poisson_ratio=0.3, ends=ends))
    assert found.factor == pytest.approx(strip, abs=BUCKLING_ERROR[ends] + RITZ)


@pytest.mark.parametrize("profile", [(Notch, (0.05, 1.0)), (Filleted, (0.1, 0.5))])
def test_a_narrow_hinge_buckles_as_its_beam_and_a_wide_one_nearly_as_if_kept_flat(profile):
    for ends in WHERE_THE_POINT_IS_NO_MATTER:
        narrow, wide = (
            buckled_hinge(*profile, 2.0, b, 0.45, ends).factor - 1.0 for b in (1e-3, 20.0)
        )
        assert 0.0 <= narrow < 1e-4
        flat = float(bound(0.45))
        assert 0.85 * flat < wide <= flat


@pytest.mark.parametrize("nu", [0.1, 0.45])
@pytest.mark.parametrize(
    "profile", [(Notch, (0.005, 1.0)), (Notch, (0.2, 1.0)), (Notch, (0.8, 1.0))]
)
def test_hinges_of_a_swaying_limb_widen_nearly_as_bent_to_arcs(profile, nu):
    """What ``LIMBS_BUCKLED`` allows for; the half of a limb is a column with a rigid arm."""
    kind, numbers = profile
    whole = half_of(kind(*numbers), 2.0, 1.0)
    bends = 2.0 * float(whole.dx @ (1.0 / whole.d))
    full = half_of(kind(*numbers), 2.0, 1.0, bends)
    near = half_of(kind(*numbers), 2.0, min(1.0, 4.0 * bends), bends)
    for width in (0.3, 1.0, 4.0):
        arc = wide_hinge(kind, numbers, 2.0, width * bends, nu).stiffness - 1.0
        parts = [_bent(full, near, width, nu, 12, odd=odd) for odd in (False, True)]
        beams = [_beam(part, 1.0 - nu**2) for part in parts]
        for arm in (1.0, 2.0, 10.0):
            plate, beam = (swayed(*each, full.end, arm / bends) for each in (parts, beams))
            assert abs(plate / beam - 1.0 - arc) < LIMBS_BUCKLED * arc


def swayed(even, odd, end, arm):
    """Return the force at the end of an arm from the middle of a hinge that buckles it."""
    n, size = len(even.K), len(even.K) + len(odd.K)
    K, G = np.zeros((size, size)), np.zeros((size, size))
    K[:n, :n], K[n:, n:], G[n:, n:] = even.K, odd.K, odd.G
    G[:n, :n] = even.G + np.outer(even.turn, even.turn) * (arm - end / 2.0)
    G[:n, n:] = np.outer(even.turn, odd.across) / 2.0
    G[n:, :n] = G[:n, n:].T
    return _least(K, G, [])
