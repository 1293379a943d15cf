"""Robust sizing against the design that the worst corners leave, and the yield that is asked."""

from functools import cache

import pytest
from scipy.optimize import fsolve

import flexcli
from flexcli.errors import NoSolution

STAGE = """\
flexure: 1
title: guide
model: closed-form
material: {youngs_modulus: 100 GPa, poisson_ratio: 0, yield_strength: 800 MPa}
geometry:
  kind: leaf-spring-stage
  blades: 2
  spacing: 20 mm
  h: {free: [20 um, 1 mm]}
  l: {free: [5 mm, 100 mm]}
  b: 10 mm
stroke: {translation: 1 mm}
requirements: {yield: 20, stiffness: {min: 0.3 N/mm}}
tolerances: {h: 20 um, l: 100 um, youngs_modulus: 2 %}
"""


@cache
def sized(robust):
    return flexcli.size(f"{STAGE}robust: {robust}\n" if robust else STAGE)


def size_of(found):
    return [found.values[name].value for name in ("h", "l")]


@pytest.mark.slow
def test_the_least_volume_of_the_worst_case_has_both_margins_used_up_at_their_corners():
    found = sized("worst-case")

    def worst(scaled):
        h, l = scaled[0] * 1e-6, scaled[1] * 1e-3
        k = 2.0 * 98e9 * 10e-3 * ((h - 20e-6) / (l + 100e-6)) ** 3
        stress = 3.0 * 102e9 * (h + 20e-6) * 1e-3 / (l - 100e-6) ** 2
        return [k / 300.0 - 1.0, stress / 40e6 - 1.0]

    h, l = fsolve(worst, [240.0, 43.0])
    # but for what is asked on top, 1e-4, and what the stroke stretches: (x/l)² = 5e-4
    assert size_of(found) == pytest.approx([h * 1e-6, l * 1e-3], rel=1e-3)
    assert found.status.value == "pass"
    for row in found.tolerances.checks:
        assert row.worst.by == "corner"
        assert row.worst.verdict == "pass"
        assert row.worst.share == pytest.approx(1.0, abs=5e-4)


@pytest.mark.slow
def test_a_share_of_the_parts_is_met_and_hardly_more():
    found = sized("{parts: 99 %}")
    assert found.status.value == "pass"
    low, _ = found.tolerances.together.interval
    assert low >= 0.99
    assert found.tolerances.together.passed < 0.9925
    none, part, all_ = (size_of(sized(robust)) for robust in ("", "{parts: 99 %}", "worst-case"))
    assert none[0] * none[1] < part[0] * part[1] < all_[0] * all_[1]


def test_the_design_that_is_not_robust_fails_in_half_of_the_parts():
    h, l = (f"{x} m" for x in size_of(sized("")))
    found = flexcli.tolerances(STAGE, overrides={"geometry.h": h, "geometry.l": l})
    assert found.status.value == "fail"
    assert found.tolerances.together.passed < 0.3


@pytest.mark.slow
def test_where_no_sizes_leave_room_for_the_tolerances_it_says_so():
    text = STAGE.replace("[20 um, 1 mm]", "[20 um, 0.22 mm]") + "robust: worst-case\n"
    plain = flexcli.size(text.replace("robust: worst-case\n", ""))
    assert plain.status.value == "pass"
    found = flexcli.size(text)
    assert found.status.value == "infeasible"
    assert "tolerances-too-wide" in [note.code for note in found.warnings]


def test_a_tolerance_as_large_as_the_size_that_is_chosen_has_no_answer():
    text = STAGE.replace("h: 20 um", "h: 300 um") + "robust: worst-case\n"
    with pytest.raises(NoSolution, match="as large as the number"):
        flexcli.size(text)
