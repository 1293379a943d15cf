"""The exact and the linear model answer requirements: closed forms are their limit."""

from math import cos, sin

import numpy as np
import pytest
from geometries_for_tests import MATERIAL, SAMPLES, spec
from planar_support import support_compliance
from strategies import crossed, design, rcc, stage

from flexcli.engine import assess
from flexcli.engine.check import check
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import AS_PRINTED, Ask
from flexcli.results import Status

OF_BEAMS = 0.25
"""By which springs in space may be off beams that may warp: solids of notches are."""

WITHOUT_LAYOUT = {"torsion-bar", "round-torsion-bar", "torsion-star"}
TURNS = {"rcc", "cross-spring", "unseparated-cross", "three-blade", "star", "moment-blade",
         "notch-hinge", "elliptic-hinge", "filleted-hinge", "hinged-pivot"}  # fmt: skip


def ask_of(kind, joint_model, travel=1e-3):
    stroke = (
        {"rotation": f"{travel!r} rad"}
        if kind in TURNS | WITHOUT_LAYOUT
        else {"translation": f"{travel!r} mm"}
    )
    found = design(spec(kind), {"yield": 1}, {"turn": {"stroke": stroke}}, material=MATERIAL)
    sizes = found.fixed_sizes()
    return Ask(found.material, found.geometry, None, sizes, found.scene("turn"), joint_model)


@pytest.mark.parametrize("kind", sorted(set(SAMPLES) - WITHOUT_LAYOUT))
@pytest.mark.parametrize("joint_model", [LinearModel(), ExactModel()], ids=["linear", "exact"])
def test_closed_forms_are_the_limit_of_a_small_stroke(kind, joint_model):
    fine, coarse = ask_of(kind, joint_model), ask_of(kind, AS_PRINTED)
    k, k_closed = joint_model.stiffness(fine), float(AS_PRINTED.stiffness(coarse))
    assert k == pytest.approx(k_closed, rel=5e-3)  # shear of slender blades
    _, stresses = joint_model.stresses(fine)
    _, closed = AS_PRINTED.stresses(coarse)
    most = max(abs(float(s.largest)) for s in stresses)
    # hinges at the ends of limbs bend about their own centres: c/l is left out of their stress
    assert most == pytest.approx(max(abs(float(s.largest)) for s in closed), rel=2e-2)


def test_the_stiffness_at_rest_is_settled_on_one_layout(monkeypatch):
    """Its levels of nodes differ in nothing else, whatever a temperature does before."""
    drawn = []

    def noted(self, *of):
        drawn.append(of)
        return draw(self, *of)

    joint_model = ExactModel(levels=(6, 9, 14, 21))
    ask = ask_of("rcc", joint_model)
    draw = type(ask.geometry).plane_layout
    monkeypatch.setattr(type(ask.geometry), "plane_layout", noted)
    k = joint_model.stiffness(ask)
    assert len(drawn) == 1
    assert k == pytest.approx(ExactModel(levels=(30, 31)).stiffness(ask), rel=1e-9)


NO_SHIFT = {"three-blade", "star"}
"""Whose closed forms have none: their centre stays by symmetry, or moves as nobody has written."""


@pytest.mark.parametrize("kind", sorted(set(SAMPLES) - WITHOUT_LAYOUT - NO_SHIFT))
def test_the_shift_is_of_the_same_point_in_every_model_with_its_sign(kind):
    joint_model = ExactModel()
    shift = joint_model.parasitic_shift(ask_of(kind, joint_model, travel=0.05))
    closed = float(AS_PRINTED.parasitic_shift(ask_of(kind, AS_PRINTED, travel=0.05)))
    assert closed != 0.0
    # limbs are taken to turn about the middles of their hinges
    assert shift == pytest.approx(closed, rel=0.03)


@pytest.mark.parametrize("kind", sorted(set(SAMPLES) - WITHOUT_LAYOUT))
def test_the_stiffness_along_the_motion_is_that_of_the_support(kind):
    """k_pivot is the support stiffness about z, k_stage that along x, k_z that along z."""
    joint_model = ExactModel()
    ask = ask_of(kind, joint_model)
    layout, turn = ask.geometry.layout(ask.material.elastic, ask.sizes), ask.geometry.axes
    axes = ((cos(turn), sin(turn), 0.0), (-sin(turn), cos(turn), 0.0), (0.0, 0.0, 1.0))
    centre = (*layout.body(MOVING).point, 0.0)
    C = support_compliance(layout, MOVING, centre, axes)
    if ask.geometry.is_guided:
        C = C - np.outer(C[:, 5], C[5]) / C[5, 5]
    index = 5 if ask.geometry.motion == "rotation" else 0
    # blades one above the other let a pivot rock a little as it turns
    rocks = 2e-4 if kind == "cross-spring" else 1e-6
    assert joint_model.stiffness(ask) == pytest.approx(1.0 / C[index, index], rel=rocks)
    for place, axis in enumerate("xyz"):
        weighed = ask._replace(scene=ask.scene._replace(axis=axis, acceleration=1.0))
        found = joint_model.sag_stiffness(weighed)
        assert found == pytest.approx(1.0 / C[place, place], rel=OF_BEAMS)


def test_what_is_not_made_of_blades_says_so():
    ask = ask_of("torsion-bar", ExactModel())
    with pytest.raises(NotAvailable, match="straight blades"):
        ExactModel().stiffness(ask)


LOADED = {
    "push": {"load": {"force": "10 N", "direction": "0 deg"}, "ends": "clamped-clamped"},
}


def critical(geometry, ends, joint_model):
    case = {"push": {"load": {"force": "10 N"}, "ends": ends}}
    found = design(geometry, {"buckling": 1}, case, material=MATERIAL)
    limits = found.limits(found.fixed_sizes(), joint_model)
    return min(float(limit.capacity) for limit in limits)


def test_a_locked_rcc_pivot_buckles_at_eulers_load():
    slender = rcc(h="50 um", l="20 mm", b="5 mm")
    exact = critical(slender, "clamped-clamped", ExactModel())
    assert exact == pytest.approx(critical(slender, "clamped-clamped", AS_PRINTED), rel=1e-3)


def test_the_three_holds_of_an_rcc_pivot_are_three_numbers():
    slender = rcc(h="50 um", l="20 mm", b="5 mm")
    locked, guided, free = (
        critical(slender, ends, ExactModel())
        for ends in ("clamped-clamped", "clamped-guided", "clamped-free")
    )
    assert free < 0.9 * guided
    assert guided <= locked * (1 + 1e-6)


def test_a_stage_buckles_at_eulers_load_of_guided_blades():
    slender = stage(h="50 um", l="20 mm", b="5 mm", spacing="30 mm")
    exact = critical(slender, "clamped-free", ExactModel())
    closed = critical(slender, "clamped-guided", AS_PRINTED)
    assert exact == pytest.approx(closed, rel=2e-3)


def test_the_closed_form_stress_of_a_pivot_is_on_the_unsafe_side():
    cases = {"turn": {"stroke": {"rotation": "10 deg"}}}
    pivot = design(
        crossed(delta=-0.5, h="0.1 mm", l="20 mm", b="5 mm"), {"yield": 1}, cases, material=MATERIAL
    )
    off = design(rcc(h="0.1 mm", l="20 mm", b="5 mm"), {"yield": 1}, cases, material=MATERIAL)
    for one in (pivot, off):
        sizes = one.fixed_sizes()
        closed = assess.checks(one.limits(sizes))[0].demand
        exact = assess.checks(one.limits(sizes, ExactModel()))[0].demand
        assert exact > closed


def test_check_says_which_model_made_each_number():
    cases = {"turn": {"stroke": {"rotation": "5 deg"}}}
    one = design(rcc(h="0.1 mm", l="20 mm", b="5 mm"), {"yield": 1}, cases, material=MATERIAL)
    result = check(one, one.fixed_sizes(), "spec", "exact")
    assert result.status is Status.PASS
    assert result.cost.model == "exact"
    assert result.values["k_pivot"].model == "exact"
    assert result.values["shift"].model == "exact"
