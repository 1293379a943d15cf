"""Blades that miss their seats by finite motions: against bodies that are moved as far."""

from dataclasses import replace

import numpy as np
import pytest
from layouts_in_space import INERTIA, LOADS, STEEL, askew, guide

from flexcli.engine.joint_models.space_exact import beam_peaks
from flexcli.formulas.profile import Constant
from flexcli.mechanics.shell.first_guess import shells_from_beams
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.rotation import matrix_of, quaternion_of
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.layout import Drive, MissedSeat, SpaceBlade, SpaceBody, SpaceLayout

OFF = np.array([0.4e-3, -0.3e-3, 0.6e-3, 0.02, -0.05, 0.04])
HOW = {"levels": (20,)}


def turned_over(blade):
    """The same blade, its start where its end was."""
    return replace(
        blade, first=blade.second, second=blade.first, start=blade.end, end=blade.start
    )  # fmt: skip


def with_blade(layout, k, blade, *bodies):
    blades = (*layout.blades[:k], blade, *layout.blades[k + 1 :])
    return replace(layout, bodies=(*layout.bodies, *bodies), blades=blades)


def largest(state):
    return max(float(np.abs(each).max()) for each in beam_peaks(blade_stresses(state)).values())


@pytest.mark.parametrize("k", [0, 2])
def test_a_seat_of_the_ground_that_is_off_is_a_body_that_is_moved_as_far(k):
    one = turned_over(askew().blades[k])
    missed = solve(with_blade(askew(), k, one), loads=LOADS, missed=MissedSeat(k, OFF), **HOW)
    seat = SpaceBody("seat", one.end, one.end, 0.1, INERTIA)
    moved = with_blade(askew(), k, replace(one, second="seat"), seat)
    held = solve(moved, {"seat": tuple(OFF)}, loads=LOADS, **HOW)
    assert missed.checked().coordinates == pytest.approx(held.checked().coordinates[:2], abs=1e-10)
    assert largest(missed) == pytest.approx(largest(held), rel=1e-7)
    assert missed.unstable == held.unstable == 0
    point = askew().bodies[1].point
    each = [support_compliance(state, "two", point) for state in (missed, held)]
    assert each[0] == pytest.approx(each[1], rel=1e-6, abs=1e-9 * float(np.abs(each[0]).max()))


@pytest.mark.parametrize("k", [0, 1, 2])
def test_a_seat_that_moves_with_its_body_is_one_that_stands_still_as_seen_from_there(k):
    ends = [((0, 0, 0), (60e-3, 5e-3, 0)), ((10e-3, 40e-3, 3e-3), (70e-3, 50e-3, 10e-3)),
            ((0, 20e-3, -20e-3), (50e-3, 60e-3, -10e-3))]  # fmt: skip
    body, drive = SpaceBody("body", (60e-3, 30e-3, 0), (60e-3, 30e-3, 0)), askew().drive
    blades = [
        SpaceBlade(str(i), "ground", "body", *each, (0, 0.2, 1), Constant(0.3e-3), 8e-3, STEEL)
        for i, each in enumerate(ends)
    ]
    there = SpaceLayout((body,), tuple(blades), drive._replace(body="body"))
    seen = [replace(blade, first="body", second="ground") for blade in blades]
    missed = MissedSeat(k, OFF)
    each = [
        solve(replace(there, blades=tuple(those)), missed=missed, **HOW).checked()
        for those in (blades, seen)
    ]
    assert largest(each[0]) == pytest.approx(largest(each[1]), rel=1e-7)
    assert each[0].own_forces == pytest.approx(each[1].own_forces, rel=1e-6)
    # the ground is seen to move as the body does, the other way
    assert each[0].coordinates[0, 3:] == pytest.approx(-each[1].coordinates[0, 3:], rel=1e-7)


def test_a_body_on_one_blade_follows_its_seat_freely():
    one = SpaceBlade("b", "ground", "body", (0, 0, 0), (0.05, 0, 0), (0, 0, 1), Constant(0.2e-3),
                     5e-3, STEEL)  # fmt: skip
    body = SpaceBody("body", one.end, one.end)
    layout = SpaceLayout((body,), (one,), Drive("body", False, (0, 1.0, 0), one.end))
    state = solve(layout, missed=MissedSeat(0, OFF), **HOW).checked()
    R = matrix_of(quaternion_of(OFF[3:]))
    # the seat comes to the end of the blade: the body is where the inverse motion takes it
    assert state.motion_of("body", one.end) == pytest.approx(
        np.concatenate([-R.T @ OFF[:3], -OFF[3:]]), abs=1e-12
    )
    assert largest(state) < 1e-12 * STEEL.E


def test_shells_and_beams_that_hardly_curl_tell_the_same_of_a_seat_that_is_turned():
    layout = guide(h=2e-3, b=20e-3)
    missed = MissedSeat(0, np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.01]))
    beams = solve(layout, missed=missed, levels=(12, 18)).checked()
    shells = solve(layout, missed=missed, levels=(12,), made=shells_from_beams).checked()
    (one,), (other,) = (state.coordinates[:, [0, 1, 5]] for state in (beams, shells))
    assert other == pytest.approx(one, rel=0.02)
