"""Bodies of another material than the blades, by its name: their mass, and how they grow."""

import pytest

import flexcli
from flexcli.errors import SpecError

MOUNT = """
flexure: 1
material: ti-6al-4v
geometry:
  kind: space-layout
  bodies:
    mirror: {{at: [0 mm, 0 mm, 0 mm], box: [100 mm, 100 mm, 20 mm], {body}}}
  blades:
    tangent: {{between: [ground, mirror], from: [75 mm, -20 mm, 0 mm], to: [75 mm, 20 mm, 0 mm],
              h: 0.5 mm, b: 8 mm, width: z, repeat: {{count: 3, about: z}}}}
  moving: mirror
  motion: {{translation: z}}
cases:
  cold: {{temperature: {{uniform: -100 K{expansion}}}}}
requirements:
  yield: 1.5
  frequency: {{min: 50 Hz}}
"""

OWN = "material: {density: 2700 kg/m^3, youngs_modulus: 70 GPa, thermal_expansion: 23e-6 1/K}"


def checked(body, expansion=""):
    return flexcli.check(MOUNT.format(body=body, expansion=expansion))


def numbers(result):
    return [(c.full_name, c.demand, c.capacity, c.factor_range) for c in result.checks]


def test_a_material_stands_for_its_density_and_expansion():
    by_material = checked(OWN)
    by_number = checked("density: 2700 kg/m^3", ", expansion: {mirror: 23e-6 1/K}")
    assert numbers(by_material) == numbers(by_number)
    assert by_material.values == by_number.values


def test_a_shipped_material_is_found_by_its_name():
    """Aluminium shrinks more than the blades and the ground, which are of titanium."""
    aluminium, titanium = (
        {c.name: c.demand for c in checked(body).checks if c.case == "cold"}
        for body in ("material: 7075-t6", "density: 2810 kg/m^3")
    )
    assert aluminium["yield (yield-strength)"] > 1e3 * titanium["yield (yield-strength)"]
    assert checked("material: 7075-t6").values["f_0"].value == pytest.approx(
        checked("density: 2810 kg/m^3").values["f_0"].value, rel=0.01
    )


def test_an_expansion_of_the_case_is_over_that_of_the_material():
    stated = ", expansion: {mirror: 1e-6 1/K}"
    assert numbers(checked(OWN, stated)) == numbers(checked("density: 2700 kg/m^3", stated))


@pytest.mark.parametrize(
    ("body", "text"),
    [
        ("material: {density: 2700 kg/m^3, youngs_modulus: 70 GPa}", "no thermal_expansion"),
        ("material: {youngs_modulus: 70 GPa, thermal_expansion: 23e-6 1/K}", "no density"),
        ("material: 7075-t6, density: 2810 kg/m^3", "given twice"),
        ("material: 7075-t7", "7075-t6"),
    ],
)
def test_a_body_of_half_a_material_is_a_finding_with_its_place(body, text):
    with pytest.raises(SpecError) as error:
        checked(body)
    (finding,) = error.value.findings
    assert text in finding.text + finding.hint
    assert finding.line
