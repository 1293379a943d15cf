"""What a clamp holds beside what is along: which of both places counts, and how far it is sure."""

from math import isclose, isnan, nan

from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.held_at_clamps import HELD_EDGES, HELD_MIDDLE_ERROR
from flexcli.parts.held_at_clamps import HeldAtClamps

SURE = HeldAtClamps(100e6, 0.3, (0.3,), 1.0, True)
stresses = st.floats(0.0, 1e9)


def test_a_pull_adds_to_what_is_amid_a_clamp_and_bending_does_not():
    assert isclose(SURE.likely(10e6, 10e6), SURE.middle + 10e6)
    assert isclose(SURE.likely(10e6, 0.0), SURE.middle)
    # much bending is at the faces, where it counts whole
    assert SURE.likely(1e9, 0.0) > 1e9
    edges = SURE.middle * (1.0 + HELD_EDGES)
    assert isclose(SURE.most(10e6, 10e6), edges + 10e6)
    assert isclose(SURE.most(10e6, 0.0), edges + 5e6)


@given(stresses, st.floats(0.0, 1.0), st.floats(0.0, 0.5), st.booleans())
def test_what_is_likely_is_within_what_may_be(along, share, nu, sure):
    held, axial = HeldAtClamps(100e6, nu, (nu,), 1.0, sure), share * along
    assert held.least(along, axial) <= held.likely(along, axial) <= held.most(along, axial)


def test_a_clamp_that_may_give_way_leaves_no_less_than_what_is_along():
    assert SURE._replace(is_sure=False).least(3e6, 1e6) == 3e6
    assert isclose(SURE.least(3e6, 1e6), SURE.middle * (1.0 - HELD_MIDDLE_ERROR) - 1e6)


def test_without_poissons_ratio_it_is_the_worst_of_all():
    either = SURE._replace(nus=(0.0, 0.5))
    assert either.most(0.0, 0.0) == SURE._replace(nus=(0.5,)).most(0.0, 0.0)
    assert either.most(1e9, 0.0) == SURE._replace(nus=(0.0,)).most(1e9, 0.0)
    assert either.least(0.0, 0.0) == SURE._replace(nus=(0.0,)).least(0.0, 0.0)


def test_of_a_stress_along_that_nobody_knows_nobody_knows_more():
    assert isnan(SURE.most(nan, nan))
