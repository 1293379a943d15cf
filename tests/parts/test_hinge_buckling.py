"""Hinges that buckle: ranges by beams, plates and plane bodies against solids by CalculiX."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
import yaml
from pydantic import TypeAdapter

import flexcli
from flexcli.engine.joint_models.buckling import HINGE_STRAINED
from flexcli.mechanics.layout import Load
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import AnyGeometry
from flexcli.parts.geometries.base import MOVING

E = 200e9

ROWS = json.loads((Path(__file__).parent / "hinges_buckled.json").read_text(encoding="utf-8"))
"""Geometries, ν, what holds the body, critical force [N] and its error, by
``tests/benchmarks/hinges_buckled.py``."""

SWAYING = [row for row in ROWS if row[2] == "swaying"]


def made(geometry):
    """Return a geometry clamped at its mouths, and its sizes."""
    joint = TypeAdapter(AnyGeometry).validate_python({**geometry, "blocks": "0 mm"})
    return joint, joint.sized({})


def spec_of(geometry, nu, ends, yields=None):
    material = {"name": "m", "youngs_modulus": f"{E} Pa", "poisson_ratio": nu}
    if yields is not None:
        material["yield_strength"] = f"{yields} Pa"
    return {
        "flexure": 1, "material": material, "geometry": {**geometry, "blocks": "0 mm"},
        "requirements": {"buckling": 1},
        "cases": {"work": {"load": {"force": "1 N"}, "ends": ends}},
    }  # fmt: skip


def found_of(spec, model="exact"):
    checks = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
    return min((c for c in checks if c.name == "buckling"), key=lambda check: check.factor)


@pytest.mark.parametrize("row", [row for row in ROWS if row not in SWAYING])
def test_the_range_of_a_hinge_holds_what_buckles_its_solid(row):
    geometry, nu, ends, force, error = row
    low, high = found_of(spec_of(geometry, nu, ends)).factor_range
    assert low <= force * (1.0 + error)
    assert force * (1.0 - error) <= high


@pytest.mark.parametrize("row", SWAYING)
def test_hinges_of_a_limb_that_sways_buckle_by_their_stiffness(row):
    """The far mouth is the middle of the shortest limb, on which no moment acts."""
    geometry, nu, _, force, error = row
    hinge, sizes = made(geometry)
    limb = {key: value for key, value in geometry.items() if key != "kind"}
    stage, limbs = made(
        {**limb, "kind": "hinged-stage", "l": "2 mm", "limbs": 2, "spacing": "9 mm"}
    )
    layout = hinge.layout(Elastic(E, nu), sizes)
    mouth = layout.blades[0].end
    layout = replace(layout, bodies=(layout.bodies[0]._replace(point=mouth),))
    beam = linear_critical(layout, {MOVING: (None,) * 3}, [Load(MOVING, mouth, (-1.0, 0.0))])
    wide, thick = stage.wide_blades(limbs, nu).buckling, hinge.thick_notches(sizes).factor
    strained = HINGE_STRAINED * beam.factor * beam.strain
    plate = wide["clamped-guided"]
    assert force * (1.0 + error) >= beam.factor * plate.low * thick.low * (1.0 - strained)
    assert force * (1.0 - error) <= beam.factor * plate.high * thick.high


def test_what_yields_first_is_off_by_little_of_what_the_elastic_force_is():
    """By Johnson's parabola the share that is off shrinks by σ_y/(4 σ_cr − σ_y)."""
    notch = {"kind": "notch-hinge", "e": "0.1 mm", "r": "1 mm", "b": "0.8 mm"}
    elastic = found_of(spec_of(notch, 0.45, "clamped-guided"))
    crushed = found_of(spec_of(notch, 0.45, "clamped-guided", yields=500e6))
    (least, most), (low, high) = elastic.factor_range, crushed.factor_range
    area = 0.1e-3 * 0.8e-3
    ends = [500e6 * area * (1.0 - 500e6 * area / 4.0 / end) for end in (least, most)]
    assert (low, high) == pytest.approx(
        ends, rel=2e-3
    )  # what it is strained by is less as it yields
