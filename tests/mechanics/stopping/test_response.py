from math import inf

import numpy as np
import pytest
from oscillators import oscillator, stepped

from flexcli.mechanics.stopping.laws import LinearStop, Stops

ANGULAR = np.array([0.9, 1.0, 1.1, 1.2])


def test_without_stops_the_steps_are_the_linear_response():
    zeta = 0.05
    steps, travel = stepped(
        oscillator(damping=zeta),
        Stops(LinearStop(10.0), inf, inf),
        angular=ANGULAR,
        amplitude=0.1,
    )
    expected = 0.1 / np.hypot(1 - ANGULAR**2, 2 * zeta * ANGULAR)
    assert all(step.settled and step.contacts == 0.0 for step in steps)
    np.testing.assert_allclose(travel, expected, rtol=1e-13)
    moments = [step.peaks.base_moment for step in steps]
    np.testing.assert_allclose(moments, expected, rtol=1e-13)


@pytest.fixture(scope="module")
def ways():
    """Give the travels going up and going down through resonance."""
    scene = oscillator(damping=0.01), Stops(LinearStop(100.0), 1.0, 1.0)
    steps, up = stepped(*scene, angular=ANGULAR, amplitude=0.2)
    _, down = stepped(*scene, angular=ANGULAR[::-1], amplitude=0.2)
    return up, down[::-1], [step.contacts for step in steps]


def test_going_up_stays_at_the_stops_where_going_down_does_not_reach_them(ways):
    up, down, contacts = ways
    assert up[0] == pytest.approx(down[0], rel=1e-2)
    assert up[-1] > 1.0 > down[-1]
    np.testing.assert_allclose(contacts[1:], 2.0)


def test_a_kick_lifts_the_motion_from_the_lower_to_the_upper_branch(ways):
    up, down, _ = ways
    scene = oscillator(damping=0.01), Stops(LinearStop(100.0), 1.0, 1.0)
    _, kicked = stepped(*scene, angular=ANGULAR[-1:], amplitude=0.2, kick=3.0)
    assert kicked[0] == pytest.approx(up[-1], rel=1e-2)
    assert kicked[0] > 1.0 > down[-1]
