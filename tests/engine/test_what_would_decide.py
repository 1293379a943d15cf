"""An undecided check names what the spec leaves open that may decide it."""

import pytest

import flexcli

WARM = """
flexure: 1
material:
  youngs_modulus: 114 GPa
  poisson_ratio: 0.3
  yield_strength: 160 MPa
  tensile_strength: 200 MPa
  thermal_expansion: 9e-6 1/K
  {known}
geometry:
  {{kind: leaf-spring-stage, h: 0.3 mm, l: 20 mm, b: 4 mm, blades: 2, spacing: 20 mm{clamps}}}
cases: {{cold: {{stroke: {{translation: 0.1 mm}}, temperature: {cold}}}}}
requirements: {{yield: {factor}}}
"""
ALL_OVER = """over_temperature:
    elongation: {points: [[4 K, -0.26 %], [293 K, 0 %], [700 K, 0.366 %]]}
    youngs_modulus: {points: [[4 K, 114 GPa], [700 K, 114 GPa]]}
    yield_strength: {points: [[4 K, 160 MPa], [700 K, 160 MPa]]}
    tensile_strength: {points: [[4 K, 200 MPa], [700 K, 200 MPa]]}"""


def judged(factor, cold, known="", clamps=""):
    result = flexcli.check(WARM.format(factor=factor, cold=cold, known=known, clamps=clamps))
    return {row.name: row for row in result.checks}, {
        note.code: note.text for note in result.warnings
    }


def test_clamps_that_nobody_states_are_named_where_they_hold_a_warm_blade_across():
    # ground and body shrink, the blades do not: clamps press these across
    cold = "{bodies: {ground: -20 K, moving: -20 K}}"
    rows, notes = judged(5.0, cold)
    name = "yield (yield-strength, held across)"
    assert rows[name].verdict == "undecided"
    assert notes["needs-clamps"].endswith(f"may decide {name}")
    rows, notes = judged(5.0, cold, clamps=", clamps: rigid")
    assert rows[name].verdict == "fail"
    assert "needs-clamps" not in notes


@pytest.mark.parametrize(("known", "verdict"), [("", "undecided"), (ALL_OVER, "pass")])
def test_a_material_known_at_assembly_alone_is_named_far_from_there(known, verdict):
    rows, _ = judged(1.0, "{uniform: 80 K}", ALL_OVER)
    (row,) = (row for name, row in rows.items() if "across" not in name)
    rows, notes = judged(0.98 * row.factor, "{uniform: 80 K}", known)
    assert rows[row.name].verdict == verdict
    assert ("needs-over-temperature" in notes) == (verdict == "undecided")
