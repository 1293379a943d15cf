"""Loads far beyond what a joint bears fail by equilibrium alone, where no model follows them."""

from math import pi, sqrt

import pytest
from twins.verdicts import checked

import flexcli

JOINTS = {
    "rcc": ({"h": "0.1 mm", "l": "20 mm", "b": "1 mm", "p": "2 mm", "half_angle": "45 deg"}, 2e-7),
    "filleted-hinge": ({"h": "0.1 mm", "l": "11 mm", "b": "0.2 mm", "r": "4.9 mm"}, 2e-8),
}
"""Sizes, and the area of all blades [m²]."""

STRENGTH, FORCE = 880e6, 100e3


def said(kind, factor):
    material = {"name": "m", "youngs_modulus": "114 GPa", "poisson_ratio": 0.34,
                "density": "4430 kg/m^3", "yield_strength": f"{STRENGTH} Pa"}  # fmt: skip
    spec = {
        "flexure": 1, "title": "overborne", "material": material,
        "geometry": {"kind": kind, **JOINTS[kind][0]},
        # pulled, for pushed it is seen to buckle
        "cases": {"work": {"load": {"force": f"{FORCE} N", "direction": "0 deg"},
                           "ends": "clamped-guided"}},
        "requirements": {"yield": factor},
    }  # fmt: skip
    return checked(spec, "yield")


@pytest.mark.parametrize("kind", JOINTS)
def test_a_force_beyond_all_sections_together_fails(kind):
    found, most = said(kind, 1.0), STRENGTH * JOINTS[kind][1] / FORCE
    assert found.verdict == "fail", found
    assert found.factors == pytest.approx((most,))
    assert found.ranges[0] == pytest.approx([0.0, most])


@pytest.mark.parametrize("kind", JOINTS)
def test_what_the_sections_may_bear_is_not_failed_by_their_area(kind):
    found = said(kind, 0.9 * STRENGTH * JOINTS[kind][1] / FORCE)
    assert found.verdict == "undecided", found


ALONE = """flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, density: 4430 kg/m^3,
           yield_strength: {strength} Pa}}
geometry: {{{kind}, h: 0.1 mm, l: 20 mm, b: 1 mm}}
mechanism: {mechanism}
cases: {{work: {{stroke: {{translation: [0 mm, {low} mm]}}, wrench: {{{force} N}}}}}}
requirements: {{yield: {factor}}}
"""


@pytest.mark.parametrize(
    ("kind", "area", "force", "mechanism"),
    [
        ("kind: cantilever", 1e-7, "z: -100", "{kind: tip-mass, mass: 1 g, offset: 1 mm}"),
        ("kind: leaf-spring-stage, blades: 2, spacing: 10 mm", 2e-7, "x: 1000",
         "{kind: payload, mass: 1 g}"),
    ],
)  # fmt: skip
def test_no_section_bears_more_whichever_way_a_force_is(kind, area, force, mechanism):
    """Across the plane, and along a stroke that starts where the loads leave the stage."""
    most = STRENGTH * area / abs(float(force[3:]))
    of = {"strength": STRENGTH, "kind": kind, "force": force, "mechanism": mechanism}
    said = [
        flexcli.verdicts(ALONE.format(**of, low=0.1, factor=asked)).checks[0]
        for asked in (1.01 * most, 0.9 * most)
    ]
    assert said[0].verdict.value == "fail", said[0]
    assert said[1].verdict.value != "pass"


def test_a_stubby_blade_yields_before_it_buckles_across_its_width():
    """Johnson's parabola at the 3.75 GPa of Euler's load, which the material never bears."""
    text = """flexure: 1
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.3, yield_strength: 830 MPa}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 2 mm, l: 10 mm, b: 1 mm}
cases: {push: {load: {force: 640 N}, ends: clamped-clamped}}
requirements: {buckling: 1}
"""
    (check,) = flexcli.verdicts(text).checks
    euler = 4.0 * pi**2 * 114e9 * 1e-3**2 / 12.0 / 10e-3**2
    stress = 830e6 * (1.0 - 830e6 / (4.0 * euler))
    assert check.factor == pytest.approx(stress * 2e-6 * sqrt(2.0) / 640.0, rel=1e-9)
    assert "yield first" in check.source
