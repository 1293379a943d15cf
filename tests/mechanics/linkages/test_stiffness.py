"""Springs of the joints at the input: energy, effort and stiffness agree with each other."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from linkages import crank_stage, four_bar, slider_crank

from flexcli.mechanics.linkages.stiffness import reflected
from flexcli.mechanics.linkages.travel import motion, travel
from flexcli.numerics.quadrature import gauss_rule

ROUNDING = 1e-12
stiffnesses = st.floats(0.1, 10.0)


def test_parallelogram_reflects_the_sum_of_its_pivots():
    theta = np.linspace(-1.2, 1.2, 9)
    linkage = four_bar((0.0, 0.0), (0.0, 0.7), (2.0, 0.7), (2.0, 0.0))
    found = reflected(motion(linkage, theta), {"A": 1.0, "B": 2.0, "C": 3.0, "D": 4.0})
    assert found.stiffness == pytest.approx(10.0, rel=1e-8)
    assert found.effort == pytest.approx(10.0 * theta, abs=1e-9)
    assert found.energy == pytest.approx(5.0 * theta**2, abs=1e-10)


def test_crank_stage_reflects_the_stages_spring_through_its_closed_form():
    # z = L (sin θ − cos α + 1) with sin α = 1 − cos θ: at rest z' = L, α' = 0, α'' = 1
    L, k = 50e-3, 864.0
    found = reflected(
        motion(crank_stage(L), 0.0), {"z": k, "alpha": 7.0, "beta": 0.5, "theta": 0.2}
    )
    assert found.stiffness == pytest.approx(k * L**2 + 0.5 + 0.2, rel=ROUNDING)
    assert found.effort == pytest.approx(0.0, abs=ROUNDING)


@settings(max_examples=15, deadline=None)
@given(k=st.lists(stiffnesses, min_size=4, max_size=4), end=st.floats(0.1, 1.0))
@pytest.mark.parametrize("drive", ["theta", "z"])
def test_work_at_the_input_is_the_energy_stored(drive, k, end):
    linkage = slider_crank(0.3, 1.0, 0.1, drive=drive)
    springs = dict(zip(("theta", "elbow", "wrist", "z"), k, strict=True))
    end *= 1.0 if drive == "theta" else 0.2
    x, w = gauss_rule(24)
    along = reflected(motion(linkage, end * x), springs)
    stored = reflected(motion(linkage, end), springs).energy
    assert end * (w @ along.effort) == pytest.approx(stored, rel=1e-9)
    effort = reflected(motion(linkage, end), springs).effort
    assert end * (w @ along.stiffness) == pytest.approx(effort, rel=1e-8)


def test_joints_left_out_are_free_and_stiffnesses_broadcast():
    followed = travel(slider_crank(0.3, 1.0), -0.5, 0.5).at(np.array([[-0.5], [0.2]]))
    k = np.array([1.0, 2.0, 3.0])
    found = reflected(followed, {"elbow": k})
    alone = reflected(followed, {"elbow": 1.0})
    for many, one in zip(found, alone, strict=True):
        assert many == pytest.approx(one * k, rel=ROUNDING)
    assert np.all(reflected(followed, {}).energy == 0.0)


def test_an_unknown_joint_is_refused():
    with pytest.raises(ValueError, match="no joint of the linkage is named ankle"):
        reflected(motion(slider_crank(0.3, 1.0), 0.1), {"ankle": 1.0})
