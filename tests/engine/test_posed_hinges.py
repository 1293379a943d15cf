"""Joints of hinges where a stroke has brought them, by springs between bodies as they stand."""

import numpy as np
import pytest
import yaml

import flexcli
from flexcli.engine.joint_models.posed_hinges import posed
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.linear import assemble
from flexcli.parts.design import DesignSpec

SPEC = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, density: 4430 kg/m^3}}
geometry: {{{geometry}, limb: {{mass: 1 g, inertia: 1e-9 kg*m^2}}, blocks: massive}}
cases: {{work: {{stroke: {{{stroke}}}, wrench: {{{wrench}}}}}}}
requirements: {{deflection: {{direction: {axis}, max: {most}}}}}
"""
STAGE = "kind: hinged-stage, e: 0.1 mm, r: 2 mm, b: 4 mm, l: 40 mm, limbs: 2, spacing: 40 mm"
PIVOT = "kind: hinged-pivot, e: 0.1 mm, r: 2 mm, b: 4 mm, l: 40 mm, p: 10 mm, half_angle: 40 deg"


def spec_of(geometry, stroke, wrench="x: 1 mN", axis="x", most="1 m"):
    return SPEC.format(geometry=geometry, stroke=stroke, wrench=wrench, axis=axis, most=most)


@pytest.mark.parametrize(
    ("geometry", "stroke", "travel"),
    [(STAGE, "translation: 1 mm", 1e-3), (PIVOT, "rotation: 0.05 rad", 0.05)],
)
def test_springs_where_they_stand_give_way_as_exact_beams_do(geometry, stroke, travel):
    """But for what the forces in the hinges of the bent joint stiffen, of the order of its turn."""
    design = DesignSpec.model_validate(yaml.safe_load(spec_of(geometry, stroke)))
    layout = design.geometry.space_layout(design.material.elastic, design.fixed_sizes())
    drive, members = layout.drive, assemble(layout).members
    held = {drive.body: [travel if i == (3 if drive.turns else 0) else None for i in range(6)]}
    state = solve(layout, held, frames=drive_frame(drive)).checked()
    own = 6 * layout.index(drive.body) + (3 if drive.turns else 0)
    exact = support_compliance(state, drive.body, layout.body(drive.body).point, free=(own,))
    there, springs = posed(state, members)
    found = assemble(there, springs)
    point = there.body(drive.body).point
    linear = found.compliance(drive.body, point, locked=False)
    rest = assemble(layout).compliance(drive.body, layout.body(drive.body).point, locked=False)
    diagonal = np.diag(exact)
    assert np.diag(linear) == pytest.approx(diagonal, rel=0.05)
    # of a direction in which the stroke makes it give way it is more than the springs at rest know
    assert np.max(np.abs(np.diag(rest) / diagonal - 1.0)) > 0.3


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_a_turned_notch_deflects_within_its_range_as_solids_do(axis):
    """CalculiX, NLGEOM (``tests/benchmarks/hinge_deflections.py``): over what it does at rest."""
    solids = {"x": 1.2499, "y": 0.9921, "z": 1.0019}
    ends = []
    for turn in (1e-9, 0.1581):
        found = flexcli.verdicts(
            f"""
flexure: 1
material: {{youngs_modulus: 200 GPa, poisson_ratio: 0.3}}
geometry: {{kind: notch-hinge, e: 0.1 mm, r: 1 mm, b: 0.4 mm, blocks: 0 mm}}
cases: {{work: {{stroke: {{rotation: [0 rad, {turn} rad]}}, wrench: {{{axis}: 1 mN}}}}}}
requirements: {{deflection: {{direction: {axis}, max: 1 m}}}}
""",
            model="exact",
        )
        ends.append(next(c for c in found.checks if c.name.startswith("deflection")))
    rest, there = ends
    least, most = (1.0 / end / rest.demand for end in reversed(there.factor_range))
    assert least < solids[axis] < most < 1.6 * least


def test_a_deflection_along_a_small_stroke_is_as_sure_as_its_own_springs():
    """Blocks may be soft along blades, which a force along the stroke does not feel."""
    text = spec_of(STAGE, "translation: 0.2 mm")
    (row,) = (c for c in flexcli.verdicts(text).checks if c.name.startswith("deflection"))
    (exact,) = (
        c for c in flexcli.verdicts(text, model="exact").checks if c.name.startswith("deflection")
    )
    assert row.verdict.value == "pass"
    low, high = (exact.factor / end - 1.0 for end in reversed(exact.factor_range))
    assert -0.06 < low < high < 0.06
