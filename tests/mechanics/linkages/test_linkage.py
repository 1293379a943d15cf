"""Linkages as described: mistakes of the description, degrees of freedom, joints that repeat."""

import pytest
from linkages import crank_stage, four_bar, slider_crank

from flexcli.errors import SolveError
from flexcli.mechanics.linkages.linkage import Linkage, Prismatic, Revolute
from flexcli.mechanics.linkages.mobility import require_one_freedom


def three_cranks(lean=0.0):
    """A stage on three parallel cranks of height one, unless the middle one leans."""
    feet = {"left": 0.0, "middle": 1.0, "right": 2.0}
    joints = [Revolute(f"{n} foot", "base", n, (p, 0.0)) for n, p in feet.items()]
    joints += [
        Revolute(f"{n} head", n, "stage", (p + lean * (n == "middle"), 1.0))
        for n, p in feet.items()
    ]
    return Linkage(tuple(joints), ground="base", input="left foot")


def refusal(linkage):
    with pytest.raises(SolveError) as caught:
        require_one_freedom(linkage)
    return caught.value


# -- mistakes of the description -----------------------------------------------------------------


def test_all_mistakes_are_told_at_once():
    joints = (
        Revolute("hub", "base", "arm", (0.0, float("nan"))),
        Revolute("hub", "base", "leg", (0.0, 0.0)),
        Prismatic("stage", "arm", "arm", (0.0, 0.0)),
    )
    with pytest.raises(ValueError, match="two joints are named 'hub'") as caught:
        Linkage(joints, ground="bass", input="hip")
    assert str(caught.value).split("; ") == [
        "two joints are named 'hub'",
        "the ground 'bass' is no link",
        "the input 'hip' is no joint",
        "joint 'hub' has a coordinate that is not finite",
        "joint 'stage' joins 'arm' with itself",
        "joint 'stage' has a direction of no length",
    ]


# -- degrees of freedom ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "linkage",
    [
        crank_stage(0.05),
        slider_crank(0.3, 1.0),
        four_bar((0.0, 0.0), (0.0, 1.0), (2.0, 1.0), (2.0, 0.0)),
    ],
    ids=["crank-stage", "slider-crank", "parallelogram"],
)
def test_known_linkages_have_one_freedom(linkage):
    assert linkage.count == 1
    require_one_freedom(linkage)


def test_an_open_chain_is_under_constrained_and_names_what_moves_by_itself():
    arm = (Revolute("hub", "base", "arm", (0.0, 0.0)), Revolute("elbow", "arm", "hand", (1.0, 0.0)))
    found = refusal(Linkage(arm, ground="base", input="hub"))
    assert found.code == "under-constrained"
    assert "2 degrees of freedom" in found.text
    assert found.remedy.endswith("with 'hub' held: hand")


def test_a_third_parallel_crank_is_over_constrained_and_its_joints_are_named():
    found = refusal(three_cranks())
    assert found.code == "over-constrained"
    assert "counts 0 degrees of freedom, yet has 1" in found.text
    assert "middle head" in found.text
    assert "leave out a link" in found.remedy


def test_a_third_crank_that_leans_holds_the_stage():
    found = refusal(three_cranks(lean=0.3))
    assert found.code == "over-constrained"
    assert "nothing in it can move" in found.text


def test_a_slide_of_three_prismatic_joints_is_over_constrained():
    # a wedge: the three joints all hold the angle, which two of them do already
    joints = (
        Prismatic("x", "base", "wedge", (1.0, 0.0)),
        Prismatic("y", "base", "follower", (0.0, 1.0)),
        Prismatic("flank", "wedge", "follower", (2.0, 1.0)),
    )
    found = refusal(Linkage(joints, ground="base", input="x"))
    assert found.code == "over-constrained"
    assert "(x, y, flank)" in found.text


def test_a_flat_parallelogram_is_singular_at_rest():
    found = refusal(four_bar((0.0, 0.0), (1.0, 0.0), (3.0, 0.0), (2.0, 0.0)))
    assert found.code == "singular-at-rest"
    assert "2 degrees of freedom as assembled" in found.text
    assert "(A, B, C, D)" in found.text


def test_a_stage_at_the_end_of_its_stroke_cannot_be_the_input():
    stretched = slider_crank(0.3, 1.0, angle=0.0, drive="z")
    found = refusal(stretched)
    assert found.code == "dead-point-at-rest"
    assert "'z' at a standstill" in found.text
    require_one_freedom(slider_crank(0.3, 1.0, angle=0.0, drive="theta"))
