"""Hinges that buckle: ranges by beams, plates and plane bodies against solids by CalculiX."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import yaml
from pydantic import TypeAdapter
from scipy.linalg import solveh_banded

import flexcli
from flexcli.engine.joint_models.buckling import HINGE_STRAINED
from flexcli.formulas.thick_notch import bends_more, softening
from flexcli.mechanics.layout import Load
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.parts.bending.thick import thick_fillets, thick_notch
from flexcli.parts.effects.hinges import _of_bowed
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


def column(e, depth, l, straight, *, is_thick, places=4001):
    """Return its compliance E b θ/M, and the force that buckles it between pinned ends, over E b.

    By finite differences: ``w'' + P w/EI = 0``, as many places as leave 1e-5 of both.
    """
    end = (straight + l) / 2.0
    x = np.linspace(-end, end, places)[1:-1]
    u = np.clip((np.abs(x) - straight / 2.0) / (l / 2.0), 0.0, 1.0 - 1e-12)
    h = e + 2.0 * depth * (1.0 - np.sqrt(1.0 - u**2))
    slope = 2.0 * depth / l * u / np.sqrt(1.0 - u**2)
    bends = 12.0 / h**3 * (1.0 + (bends_more(slope) if is_thick else 0.0))
    dx = x[1] - x[0]
    banded = np.array([np.full(x.size, -1.0), np.full(x.size, 2.0)]) / dx**2
    w = np.cos(np.pi * x / (2.0 * end))
    for _ in range(60):
        w = solveh_banded(banded, bends * w)
        w /= w.max()
    return bends.sum() * dx, np.sum(np.diff(w, prepend=0.0, append=0.0) ** 2) / dx / np.sum(
        bends * w**2 * dx
    )


@pytest.mark.parametrize("seed", range(12))
def test_a_hinge_with_pinned_ends_loses_what_a_column_of_softer_sections_does(seed):
    random = np.random.default_rng(seed)
    depth, straight = 1.0, float(random.uniform(0.0, 8.0)) if seed % 2 else 0.0
    e = 10.0 ** random.uniform(-1.5, 0.0)
    l = 2.0 if seed % 2 else float(random.uniform(1.5, 6.0))
    beam, plain = column(e, depth, l, straight, is_thick=False)
    _, soft = column(e, depth, l, straight, is_thick=True)
    at = {"turn": 1.0 / beam, "blocks": "massive"}
    thick = (
        thick_fillets(h=e, r=depth, l=straight + l, **at)
        if seed % 2
        else thick_notch(e=e, depth=depth, l=l, **at)
    )
    found = softening(e=e, depth=depth, l=l, straight=straight, blocks="massive")
    assert 0.0 <= found.bowed < plain / soft - 1.0 < (found.more + found.error) / beam
    change = _of_bowed(thick.factor, thick.bowed)
    middle = 1.0 + change.value
    assert middle * (1.0 - change.error) <= soft / plain <= middle * (1.0 + change.error)
    # surer than a range about all that it loses in stiffness, either way
    assert change.error < 1.0 - thick.factor.low
