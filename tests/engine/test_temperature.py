"""A case with a temperature: what is judged, what it moves, what is refused."""

import pytest

import flexcli
from flexcli.errors import SpecError
from flexcli.results import Status, Verdict

STAGE = """
flexure: 1
material: ti-6al-4v
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 10 mm, spacing: 20 mm, blades: 2}}
cases: {{c: {{{case}}}}}
requirements: {{{requirements}}}
"""
ALPHA, E = 8.6e-6, 113.8e9


def spec(case, requirements="yield: 1"):
    return STAGE.format(case=case, requirements=requirements)


def refusal(case, **changes):
    text = spec(case)
    for old, new in changes.items():
        text = text.replace(old, new)
    with pytest.raises(SpecError) as refused:
        flexcli.check(text)
    return refused.value.findings[0]


def test_a_body_of_the_blades_material_and_temperature_stresses_nothing():
    result = flexcli.check(spec("temperature: {uniform: -100 K}"))
    assert result.status is Status.PASS
    assert max(check.demand for check in result.checks) < 1.0


def test_a_hotter_body_bends_the_blades_that_it_spreads():
    result = flexcli.check(spec("temperature: {bodies: {moving: 50 K}}"))
    spread = ALPHA * 50.0 * 10e-3
    (check,) = result.checks
    # each blade is a guided one, a little less than bent by that: it shears
    assert 0.999 < check.demand / (3.0 * E * 0.2e-3 * spread / 20e-3**2) < 1.0
    assert check.model == "exact"


def test_stroke_and_temperature_act_together():
    stroke = "stroke: {translation: 0.5 mm, cycles: 1e6}"
    alone = flexcli.check(spec(stroke)).checks[0].demand
    warm = "temperature: {bodies: {moving: 400 K}}"
    apart = flexcli.check(spec(warm)).checks[0].demand
    together = flexcli.check(spec(f"{stroke}, {warm}")).checks[0].demand
    # one blade bends more by one and less by the other: at some face they add up
    assert together == pytest.approx(alone + apart, rel=0.02)


def test_the_motion_by_the_temperature_alone_is_told():
    case = "temperature: {uniform: 40 K, expansion: {moving: 0 1/K, ground: 0 1/K}}"
    values = flexcli.check(spec(case)).values
    moved = [values[f"{name}_c"].value for name in ("x", "y", "theta")]
    # the blades alone grow; they lie across the stroke, x
    assert abs(moved[1]) == pytest.approx(ALPHA * 40.0 * 20e-3, rel=1e-6)
    assert moved[0] == pytest.approx(0.0, abs=1e-12)
    assert moved[2] == pytest.approx(0.0, abs=1e-9)


def test_a_gradient_along_the_blades_differs_from_one_across_them():
    def turned(axis):
        case = f"temperature: {{gradient: {{{axis}: 1000 K/m}}}}"
        return abs(flexcli.check(spec(case)).values["theta_c"].value)

    # across the blades one is warmer than the other, and longer
    assert turned("x") == pytest.approx(ALPHA * 1000.0 * 20e-3, rel=0.02)
    assert turned("y") < 1e-3 * turned("x")


def test_what_no_model_has_at_a_temperature_is_not_decided():
    case = "temperature: {uniform: 5 K}, load: {force: 1 N}, ends: clamped-guided"
    result = flexcli.check(spec(case, "buckling: 2"))
    assert result.status is Status.UNDECIDED
    assert {check.verdict for check in result.checks} == {Verdict.UNDECIDED}
    assert flexcli.check(spec("temperature: {uniform: 5 K}"), model="linear").status is not (
        Status.PASS
    )


def test_a_temperature_that_nothing_looks_at_is_not_judged():
    case = "temperature: {uniform: 5 K}"
    result = flexcli.check(spec(case, "stiffness: {min: 1 N/m}"))
    assert Verdict.NOT_JUDGED in {check.verdict for check in result.checks}
    assert result.status is Status.UNDECIDED


@pytest.mark.parametrize(
    ("case", "changes", "text", "hint"),
    [
        ("temperature: {uniform: 0 K}", {}, "changes nothing", "uniform"),
        ("temperature: {bodies: {stage: 3 K}}", {}, "has no body 'stage'", "ground, moving"),
        ("temperature: {uniform: 20 degC}", {}, "degC", "K"),
        (
            "temperature: {uniform: 3 K}, "
            "sine: {acceleration: 1 g, frequency: 50 Hz}", {}, "beside a vibration", "case",
        ),
        (
            "temperature: {uniform: 3 K}",
            {"ti-6al-4v": "{name: t, youngs_modulus: 114 GPa, yield_strength: 800 MPa}"},
            "no thermal_expansion", "give it",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be_meant_is_refused(case, changes, text, hint):
    found = refusal(case, **changes)
    assert text in found.text
    assert hint in found.hint
