"""What stands beside a vibration: loads of one case act at once, however they are written."""

from math import pi, sqrt

import pytest

import flexcli
from flexcli.results import Status, Verdict

E, H, L, B = 114e9, 0.2e-3, 20e-3, 4e-3
I = B * H**3 / 12.0
PUSH = 2.0 * pi**2 * E * I / L**2
"""Force along both blades that buckles the stage [N]."""
SPEC = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0, yield_strength: 830 MPa,
           tensile_strength: 900 MPa, density: 1e-3 kg/m^3,
           sn_amplitudes: {{points: [{{cycles: 1e3, amplitude: 800 MPa}},
                                     {{cycles: 1e9, amplitude: 100 MPa}}], stress_ratio: -1}}}}
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 4 mm, blades: 2, spacing: 10 mm}}
mechanism: {{kind: payload, mass: 0.1 kg}}
cases: {{launch: {{{shakes}{stands}}}}}
requirements: {{{asked}}}
"""
SHAKES = {
    "random": "asd: {profile: gevs-qualification, q: 20, duration: 60 s}",
    "shock": "shock: {half-sine: {acceleration: 10 g, duration: 5 ms}, q: 20}",
    "sine": "sine: {acceleration: 1 g, axis: x, frequency: 30 Hz}, q: 20",
}
STANDS = {
    "wrench": ", wrench: {x: 2 N}",
    "acceleration": ", acceleration: {level: 20 m/s^2, axis: x}",
    "stroke": ", stroke: {translation: 1 mm}",
}


def row(shakes, stands="", asked="dynamic-yield: 1", model=None):
    """Return the row of what is asked, and the status."""
    text = SPEC.format(shakes=SHAKES[shakes], stands=stands, asked=asked)
    found = flexcli.check(text, model=model)
    name = asked.split(":")[0].replace("-", " ")
    return next(each for each in found.checks if each.name.startswith(name)), found.status


@pytest.mark.parametrize("stands", STANDS)
@pytest.mark.parametrize("shakes", SHAKES)
def test_the_stress_that_stands_is_added_to_that_of_the_modes(shakes, stands):
    alone, _ = row(shakes)
    beside, _ = row(shakes, STANDS[stands])
    static, _ = row(shakes, STANDS[stands], "yield: 1")
    # a stroke moves the modes a little
    within = 5e-3 if stands == "stroke" else 1e-3
    assert beside.demand == pytest.approx(alone.demand + static.demand, rel=within)
    assert "what stands beside it" in beside.quantity


def test_two_stresses_that_are_borne_alone_and_not_together_are_no_pass():
    # 563 MPa by the wrench and 286 MPa by the modes, of 830 MPa
    _, status = row("random", ", wrench: {x: 3 N}", "dynamic-yield: 1, yield: 1")
    assert status is Status.FAIL


def test_what_a_push_softens_moves_the_modes_within_the_range():
    """The stage is one oscillator, whose stiffness a push lowers to 1 − P/P_cr of itself."""
    pushed = f", wrench: {{y: {0.2 * PUSH} N}}"
    alone, _ = row("sine")
    beside, _ = row("sine", pushed)
    static = 0.1 * PUSH / (B * H)  # of each blade
    own = sqrt(24.0 * E * I / L**3 / 0.1)

    def peak(angular):
        """Motion under the base's own, and so stress, per acceleration."""
        drive = 2.0 * pi * 30.0
        return 1.0 / abs(angular**2 - drive**2 + 1j * angular * drive / 20.0)

    true = alone.demand * peak(own * sqrt(0.8)) / peak(own) + static
    low, high = sorted(beside.capacity / factor for factor in beside.factor_range)
    assert low < true < high
    assert row("sine", f", wrench: {{y: {0.7 * PUSH} N}}")[0].verdict is Verdict.UNDECIDED


def test_the_life_beside_a_load_is_that_with_its_mean_stress():
    beside, _ = row("random", STANDS["wrench"], "dynamic-life: 1")
    static, _ = row("random", STANDS["wrench"], "yield: 1")
    mean = f"dynamic-life: {{factor: 1, mean_stress: {static.demand!r} Pa}}"
    stated, _ = row("random", "", mean)
    assert beside.capacity == pytest.approx(stated.capacity, rel=1e-6)
    assert beside.capacity < 0.9 * row("random", "", "dynamic-life: 1")[0].capacity


def test_the_force_that_stands_is_added_before_it_buckles():
    asked = "dynamic-buckling: 1"
    ends = ", ends: clamped-clamped"
    alone, _ = row("random", ends, asked)
    beside, _ = row("random", f"{ends}, load: {{force: {0.3 * PUSH} N}}", asked)
    assert beside.demand == pytest.approx(alone.demand + 0.15 * PUSH, rel=1e-3)
