"""Stops as forces: Hertz in series with what gives, no pull, restitution kept."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.engine.comparing.penalty_law import RIGID_PENALTY, penalty_law
from flexcli.mechanics.stopping.laws import (
    HertzStop,
    LinearStop,
    RigidStop,
)
from flexcli.mechanics.stopping.modal_blade import ModalBlade


def blade(stop_residual=0.0):
    """Give an oscillator of unit mass and stiffness, with what its left-out modes give."""
    one = np.ones(1)
    return ModalBlade(
        angular=one, damping=0 * one, base=one, tip=one, stop=one, base_moment=one,
        stop_residual=stop_residual,
    )  # fmt: skip


@given(st.floats(-9, 3), st.floats(-6, 6), st.floats(-6, 6))
def test_the_push_of_a_ball_is_hertz_on_what_the_compliances_leave(approach, stiffness, softness):
    x, k, C = 10.0**approach, 10.0**stiffness, 10.0**softness
    # half of the compliance is the mount's, half that of the left-out modes
    push = penalty_law(blade(stop_residual=C / 2), HertzStop(k, compliance=C / 2))
    F = push(x, 0.0)
    assert (F / k) ** (2 / 3) + C * F == pytest.approx(x, rel=1e-12)


def test_a_ball_that_dissipates_pushes_more_on_the_way_in_and_never_pulls():
    push = penalty_law(blade(), HertzStop(2.0, dissipation=0.1))
    assert push(1.0, 1.0) == pytest.approx(1.1 * 2.0, rel=1e-14)
    assert push(1.0, -11.0) == 0.0


def test_a_damped_spring_lies_in_series_with_the_left_out_modes_and_never_pulls():
    push = penalty_law(blade(stop_residual=0.5), LinearStop(2.0, damping=3.0))
    assert push(0.1, 0.2) == pytest.approx(0.1 / (0.5 + 0.5) + 3.0 * 0.2, rel=1e-14)
    assert push(0.1, -1.0) == 0.0


def test_an_elastic_rigid_stop_is_a_spring_many_times_as_stiff_as_the_blade():
    push = penalty_law(blade(), RigidStop(1.0))
    assert push(1e-3, 5.0) == pytest.approx(RIGID_PENALTY * 1e-3, rel=1e-12)
