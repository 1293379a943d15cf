"""A material's loss factor damps the modes of cases that state no Q."""

import pytest

import flexcli

SPEC = """
flexure: 1
material: {{extends: ti-6al-4v{loss}}}
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 10 mm, spacing: 20 mm, blades: 2}}
mechanism: {{kind: payload, mass: 100 g}}
cases: {{shaken: {{{case}}}}}
requirements: {{dynamic-yield: 1}}
"""
LOSS = ", loss_factor: {value: 2e-3, status: measured, source: ring-down of a coupon}"
ASD = "asd: {profile: gevs-qualification%s}"
SINE = "sine: {acceleration: 0.1 g, frequency: 20 Hz}%s"


def check(case, loss):
    return flexcli.check(SPEC.format(case=case, loss=loss))


@pytest.mark.parametrize(("case", "stated"), [(ASD, ", q: 500"), (SINE, ", q: 500")])
def test_a_loss_factor_stands_for_the_q_that_no_case_states(case, stated):
    by_material, by_case = check(case % "", LOSS), check(case % stated, "")
    assert by_material.checks[0].demand == pytest.approx(by_case.checks[0].demand)
    assert "material-damping" in {note.code for note in by_material.warnings}
    assert "material-damping" not in {note.code for note in by_case.warnings}


@pytest.mark.parametrize("case", [ASD, "axes: {x: {asd: gevs-qualification}}%s"])
def test_the_mechanism_damps_a_random_vibration_where_the_case_does_not(case):
    damped = SPEC.replace("mass: 100 g", "mass: 100 g, damping: {{q: 50}}")
    found = flexcli.check(damped.format(case=case % "", loss=LOSS))
    stated = check(ASD % ", q: 50", "")
    assert found.checks[0].demand == pytest.approx(stated.checks[0].demand)
    assert "material-damping" not in {note.code for note in found.warnings}


def test_a_stated_q_goes_before_the_materials():
    own = check(ASD % ", q: 50", LOSS)
    assert own.checks[0].demand == pytest.approx(check(ASD % ", q: 50", "").checks[0].demand)
    assert "material-damping" not in {note.code for note in own.warnings}


SHAKEN = SPEC.replace("{{{case}}}", "{{{case}, q: 50}}").replace(
    "{{extends: ti-6al-4v{loss}}}", "ti-6al-4v"
)


def test_the_stress_of_a_temperature_stands_beside_that_of_a_vibration():
    asd = "asd: {profile: gevs-qualification}"
    warm = "temperature: {bodies: {moving: 60 K}}"

    def stress(case, requirement="dynamic-yield: 1"):
        text = SHAKEN.format(case=case).replace("dynamic-yield: 1", requirement)
        if "asd" not in case:
            text = text.replace(", q: 50", "")
        check, *_ = flexcli.check(text, model="exact").checks
        return check

    both = stress(f"{asd}, {warm}")
    apart = stress(asd).demand + stress(warm, "yield: 1").demand
    assert both.demand == pytest.approx(apart, rel=1e-3)
    assert both.factor_range is not None
