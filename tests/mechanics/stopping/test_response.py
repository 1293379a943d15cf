from math import inf

import numpy as np
import pytest
from oscillators import oscillator

from flexcli.mechanics.stopping.laws import LinearStop, Stops
from flexcli.mechanics.stopping.response import stepped_response

ANGULAR = np.array([0.9, 1.0, 1.1, 1.2])


def test_without_stops_the_steps_are_the_linear_response():
    zeta = 0.05
    found = stepped_response(
        oscillator(damping=zeta),
        Stops(LinearStop(10.0), inf, inf),
        angular=ANGULAR,
        amplitude=0.1,
    )
    expected = 0.1 / np.hypot(1 - ANGULAR**2, 2 * zeta * ANGULAR)
    assert found.settled.all()
    np.testing.assert_allclose(found.travel, expected, rtol=1e-13)
    np.testing.assert_allclose(found.base_moment, expected, rtol=1e-13)
    assert (found.contacts == 0.0).all()


@pytest.fixture(scope="module")
def ways():
    """Give the travels going up and going down through resonance."""
    scene = oscillator(damping=0.01), Stops(LinearStop(100.0), 1.0, 1.0)
    up = stepped_response(*scene, angular=ANGULAR, amplitude=0.2)
    down = stepped_response(*scene, angular=ANGULAR[::-1], amplitude=0.2)
    return up.travel, down.travel[::-1], up.contacts


def test_going_up_stays_at_the_stops_where_going_down_does_not_reach_them(ways):
    up, down, contacts = ways
    assert up[0] == pytest.approx(down[0], rel=1e-2)
    assert up[-1] > 1.0 > down[-1]
    np.testing.assert_allclose(contacts[1:], 2.0)


def test_a_kick_lifts_the_motion_from_the_lower_to_the_upper_branch(ways):
    up, down, _ = ways
    scene = oscillator(damping=0.01), Stops(LinearStop(100.0), 1.0, 1.0)
    kicked = stepped_response(*scene, angular=ANGULAR[-1:], amplitude=0.2, kick=3.0)
    assert kicked.travel[0] == pytest.approx(up[-1], rel=1e-2)
    assert kicked.travel[0] > 1.0 > down[-1]
