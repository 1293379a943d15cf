"""A linkage as a geometry: deflections, stresses and stiffness of its joints' own flexures."""

from math import cos, pi, radians

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.linear import linear
from flexcli.mechanics.linkages.travel import motion
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import AnyGeometry, Elastic

ADAPTER = TypeAdapter(AnyGeometry)
STEEL = Elastic(210e9, 0.3)


def pivot(**given):
    return {
        "kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg",
        "h": "0.2 mm", "l": "15 mm", "b": "5 mm", **given,
    }  # fmt: skip


def parallelogram(height="20 mm", width="30 mm"):
    links = {"p1": ("base", "left"), "p2": ("left", "top"), "p3": ("base", "right")}
    places = {"p1": ["0 mm", "0 mm"], "p2": ["0 mm", height], "p3": [width, "0 mm"]}
    joints = {
        name: {"links": list(ends), "at": places[name], "flexure": pivot()}
        for name, ends in links.items()
    }
    joints["p4"] = {"links": ["right", "top"], "at": [width, height], "flexure": pivot()}
    return {"kind": "linkage", "ground": "base", "input": "p1", "joints": joints}


def test_a_parallelogram_reflects_the_stiffness_of_its_four_pivots():
    linkage = ADAPTER.validate_python(parallelogram())
    sizes = linkage.sized({})
    one = linkage.joints["p1"].flexure
    own = one.stiffness(STEEL, one.sized({}))
    assert linkage.stiffness(STEEL, sizes) == pytest.approx(4.0 * own, rel=1e-9)


def test_every_pivot_of_a_parallelogram_has_the_stress_of_the_input():
    linkage = ADAPTER.validate_python(parallelogram())
    stresses = linkage.end_stresses(STEEL, linkage.sized({}), 0.1)
    assert {linkage.joint_of(place) for place in stresses} == {"p1", "p2", "p3", "p4"}
    inner = [abs(s) for place, s in stresses.items() if place.endswith("inner end")]
    assert inner == pytest.approx([inner[0]] * 4, rel=1e-9)
    assert inner[0] == pytest.approx(210e9 * 0.2e-3 * 0.1 / 15e-3 / 2, rel=1e-9)


def test_sizes_are_named_by_joint_and_free_ones_can_be_chosen():
    spec = parallelogram()
    spec["joints"]["p2"]["flexure"] = pivot(h="free")
    linkage = ADAPTER.validate_python(spec)
    assert linkage.free == ("h_p2",)
    sizes = linkage.sized({"h_p2": 0.3e-3})
    assert linkage.sizes_of("p2", sizes).h == 0.3e-3
    assert linkage.label("h_p2") == "blade thickness at p2"


def test_a_stroke_to_one_side_has_a_mean():
    linkage = ADAPTER.validate_python(parallelogram())
    sizes = linkage.sized({})
    amplitudes, means = linkage.stroke_stresses(STEEL, sizes, 0.05, 0.05)
    for place, amplitude in amplitudes.items():
        assert abs(means[place]) == pytest.approx(abs(amplitude), rel=1e-9)
    amplitudes, means = linkage.stroke_stresses(STEEL, sizes, 0.05, 0.0)
    assert means == {}


def test_the_layout_places_every_blade_where_its_joint_stands():
    linkage = ADAPTER.validate_python(parallelogram())
    layout = linkage.layout(STEEL, linkage.sized({}))
    assert {b.name for b in layout.bodies} == {"moving", "top", "right"}
    ends = {blade.name: (blade.first, blade.second) for blade in layout.blades}
    assert ends["p1 blade 1"] == ("ground", "moving")
    middle = [
        (np.array(b.start) + np.array(b.end)) / 2 for b in layout.blades if b.name[:2] == "p4"
    ]
    assert np.mean(middle, axis=0) == pytest.approx([30e-3, 20e-3])


def test_a_dead_point_within_the_stroke_is_said():
    spec = {
        "kind": "linkage", "ground": "base", "input": "theta",
        "joints": {
            "theta": {"links": ["base", "crank"], "at": ["0 mm", "0 mm"], "flexure": pivot()},
            "beta": {"links": ["crank", "rod"], "at": ["0 mm", "50 mm"]},
            "alpha": {"links": ["rod", "stage"], "at": ["-60 mm", "50 mm"]},
            "z": {"links": ["base", "stage"], "along": [1, 0]},
        },
    }  # fmt: skip
    linkage = ADAPTER.validate_python(spec)
    with pytest.raises(ValueError, match="stops at"):
        linkage.end_stresses(STEEL, linkage.sized({}), pi)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"input": "p9"}, "the input 'p9' is no joint"),
        ({"ground": "earth"}, "the ground 'earth' is no link"),
    ],
)
def test_a_wrong_name_is_refused(change, said):
    with pytest.raises(ValidationError, match=said):
        ADAPTER.validate_python({**parallelogram(), **change})


def test_a_linkage_with_two_freedoms_is_refused():
    spec = parallelogram()
    del spec["joints"]["p4"]
    with pytest.raises(ValidationError, match="freedom"):
        ADAPTER.validate_python(spec)


def test_a_stage_cannot_be_a_pivot():
    spec = parallelogram()
    spec["joints"]["p2"]["along"] = [1, 0]
    with pytest.raises(ValidationError, match="makes no translation"):
        ADAPTER.validate_python(spec)


def test_the_crank_of_exercise_12_c_turns_to_one_side_only():
    from pathlib import Path

    from flexcli.spec.load import load

    root = Path(__file__).parents[2] / "examples/crank-linear-stage/flexure.yaml"
    design = load(root).part
    ranges = design.geometry.deflections(-radians(15), radians(15))
    assert ranges["alpha"].least == pytest.approx(0.0, abs=1e-12)
    assert ranges["z"].greatest - ranges["z"].least == pytest.approx(25.88e-3, abs=5e-6)


def crank(links, arm="50 mm"):
    """A crank that drives a guided stage over a rod, all three pivots of thin blades."""
    thin = pivot(h="0.02 mm")
    joints = {
        "theta": {"links": links, "at": ["0 mm", "0 mm"], "flexure": thin},
        "beta": {"links": ["rod", "crank"], "at": ["0 mm", arm], "flexure": thin},
        "alpha": {"links": ["rod", "stage"], "at": [f"-{arm}", arm], "flexure": thin},
        "z": {"links": ["base", "stage"], "along": [1, 0]},
    }
    spec = {"kind": "linkage", "ground": "base", "input": "theta", "joints": joints}
    return ADAPTER.validate_python(spec)


@pytest.mark.parametrize("links", [["base", "crank"], ["crank", "base"]])
@pytest.mark.parametrize("turn", [0.1, -0.1])
def test_blades_on_an_ideal_guide_move_as_the_rigid_links_do(links, turn):
    """The centres of the three pivots move by 5 θ² l/(60 cos 45°) at most: so far it is off."""
    linkage = crank(links)
    layout = linkage.plane_layout(STEEL, linkage.sized({}))
    state = solve(layout, {"moving": linkage.held(turn)}).checked()
    x, y, phi = state.motions[0, layout.index("stage")]
    assert (y, phi) == pytest.approx((0.0, 0.0), abs=1e-18)
    rigid = float(motion(linkage.rigid, turn).deflections["z"])
    assert abs(x) == pytest.approx(abs(rigid), abs=3 * 5 * turn**2 * 15e-3 / (60 * cos(pi / 4)))
    # the crank turns against the rod farther to one side: the input's own sense is kept
    against = abs(phi_of(state, "moving") - phi_of(state, "rod"))
    ends = [float(motion(linkage.rigid, t).deflections["beta"]) for t in (turn, -turn)]
    assert against == pytest.approx(abs(ends[0]), rel=0.02)
    assert against != pytest.approx(abs(ends[1]), rel=0.02)


def phi_of(state, body):
    return float(state.motions[0, state.layout.index(body), 2])


def test_a_linkage_on_an_ideal_guide_has_the_stiffness_that_its_pivots_reflect():
    """Thin blades: stretching adds (h/l)² and their centres' motion nothing at rest."""
    linkage = crank(["base", "crank"])
    sizes = linkage.sized({})
    layout = linkage.plane_layout(STEEL, sizes)
    found = linear(layout, {"moving": linkage.held(1.0)}).reactions[0, layout.index("moving"), 2]
    assert found == pytest.approx(linkage.stiffness(STEEL, sizes), rel=1e-4)


def test_ideal_joints_that_no_solver_has_are_named():
    spec = parallelogram()
    del spec["joints"]["p3"]["flexure"]
    linkage = ADAPTER.validate_python(spec)
    with pytest.raises(NotAvailable, match="ideal joint p3"):
        linkage.plane_layout(STEEL, linkage.sized({}))
