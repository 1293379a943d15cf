"""Branches of motions with contact: folds, where they close, and the blow that leads there."""

from math import inf, pi

import numpy as np
import pytest
from oscillators import oscillator, steady_steps

from flexcli.mechanics.stopping.branch import Bifurcation, branch_end, branch_steps
from flexcli.mechanics.stopping.kick import least_kick
from flexcli.mechanics.stopping.laws import LinearStop, Stops
from flexcli.mechanics.stopping.periodic import MotionPoint
from flexcli.mechanics.stopping.response import stepped_motion
from flexcli.mechanics.stopping.result import MotionKind

STOPS = Stops(LinearStop(100.0), 1.0, 1.0)


@pytest.fixture(scope="module")
def branch():
    """Give a blade on its motion with contact, and where that ends on the way up."""
    motion = stepped_motion(oscillator(damping=0.05), STOPS, 0.2)
    for omega in (1.0, 1.2, 1.4):
        motion.follow(omega)
    return motion, branch_end(motion.driven, motion.motion, rising=True)


@pytest.mark.slow
def test_at_a_fold_two_motions_meet_and_none_lies_beyond(branch):
    motion, end = branch
    assert end.kind is Bifurcation.FOLD
    driven = motion.driven
    found = [step.end.motion for step in branch_steps(driven, motion.motion, rising=True)]
    stable = [m for m in found if m.is_stable and m.contacts]
    past = [m for m in found if not m.is_stable]
    assert max(m.angular for m in found) <= end.angular * (1.0 + 1e-6)
    # on either side of it one multiplier lies below 1 and one above
    assert max(m.largest for m in stable) < 1.0 < min(m.largest for m in past)
    near = min(found, key=lambda m: abs(m.angular - end.angular))
    assert driven.periodic(end.angular * 0.999, near.start) is not None
    assert driven.periodic(end.angular * 1.001, near.start) is None


@pytest.mark.slow
def test_the_unstable_motions_end_where_the_one_without_contact_meets_the_stop(branch):
    motion, end = branch
    driven = motion.driven
    last = list(branch_steps(driven, motion.motion, rising=True))[-1]
    assert last.start.motion.contacts
    assert not last.end.motion.contacts
    # 0.2/√((1 − ω²)² + (0.1 ω)²) = 1 above resonance
    b = 1.0 - 0.1**2 / 2.0
    touch = np.sqrt(b + np.sqrt(b**2 - 1.0 + 0.2**2))
    assert last.end.motion.angular == pytest.approx(touch, rel=1e-2)
    assert last.end.motion.start.q == pytest.approx(
        driven.steady(last.end.motion.angular, last.end.motion.start.phase).q, abs=1e-8
    )
    assert end.angular > touch


def test_going_down_contact_ends_where_the_linear_motion_just_touches(branch):
    motion, _ = branch
    end = branch_end(motion.driven, motion.motion, rising=False)
    b = 1.0 - 0.1**2 / 2.0
    assert end.kind is Bifurcation.GRAZE
    assert end.angular == pytest.approx(np.sqrt(b - np.sqrt(b**2 - 1.0 + 0.2**2)), rel=1e-9)


def test_the_least_blow_leads_to_contact_for_good_and_a_smaller_one_does_not(branch):
    motion, _ = branch
    driven, contact = motion.driven, motion.motion
    kick = least_kick(driven, contact, lambda: True)
    assert 0.0 < kick.none < kick.enough

    def contacts(blow, phase, periods):
        steady = driven.steady(contact.angular, phase)
        struck = MotionPoint(steady.q, steady.rate + blow, phase)
        return driven.run(contact.angular, struck, periods).contact_count

    assert contacts(kick.enough, kick.phase, 200) - contacts(kick.enough, kick.phase, 190) == 20
    assert contacts(0.95 * kick.enough, kick.phase, 200) < 20
    phases = np.linspace(0.0, 2.0 * pi, 12, endpoint=False)
    assert not any(contacts(0.999 * kick.none, phase, 3) for phase in phases)


@pytest.mark.slow
def test_what_has_no_periodic_motion_is_called_so_and_what_dies_slowly_is_waited_for():
    scene = oscillator(), Stops(LinearStop(20.0), 1.0, 1.0)
    (beat,) = steady_steps(*scene, angular=[2.0**0.5], amplitude=0.1, kick=2.0)
    assert beat.outcome is MotionKind.APERIODIC
    # at Q = 500 a free swing of 30 gaps takes 540 periods to stay between the stops
    scene = oscillator(damping=0.001), Stops(LinearStop(1.0), 1.0, inf)
    (slow,) = steady_steps(*scene, angular=[3.0], amplitude=1e-3, kick=30.0)
    assert slow.outcome is MotionKind.PERIODIC
    assert slow.contacts == 0.0
    assert slow.peaks.travel == pytest.approx(1e-3 / 8.0, rel=1e-5)
