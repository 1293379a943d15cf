"""The lowest frequency of a mechanism in space at its stroke, the drive locked, from a spec."""

from math import pi, sqrt

import numpy as np
import pytest

import flexcli
from flexcli.engine.joint_models.space_frequency import FOLLOWS, HEAVIEST

SPEC = """
flexure: 1
material: {{youngs_modulus: 200 GPa, yield_strength: 1800 MPa, poisson_ratio: 0.3{density}}}
geometry:
  kind: space-layout
  bodies:
    stage: {{at: [0 mm, 50 mm, 0 mm]{mass}}}
  blades:
    leaf: {{between: [ground, stage], from: [100 mm, 0 mm, 0 mm], to: [100 mm, 100 mm, 0 mm],
           h: 0.5 mm, b: 50 mm, width: z, mirror: [x]}}
  moving: stage
  motion: {{translation: x}}
cases:
  operation: {{stroke: {{translation: {stroke}}}}}
requirements:
  parasitic_frequency: {asked}
"""

HEAVY = ", mass: 50 kg"
BOX = ", box: [220 mm, 100 mm, 100 mm], density: 7800 kg/m^3"


def checks(tmp_path, asked, *, stroke="20 mm", mass=HEAVY, density=", density: 7800 kg/m^3", **how):
    spec = tmp_path / "flexure.yaml"
    text = SPEC.format(asked=asked, stroke=stroke, mass=mass, density=density)
    spec.write_text(text, encoding="utf-8")
    return flexcli.check(spec, **how).checks


def range_of(check):
    """Return the frequency [Hz] that a least one was held against, and the ends of its range."""
    low, high = check.factor_range
    return check.capacity, low * check.demand, high * check.demand


def test_a_heavy_point_vibrates_on_the_support_stiffness_of_solids(tmp_path):
    """CalculiX's 9.173e5 N/m along z at 20 mm; the mass has no inertia, so nothing else counts."""
    (check,) = checks(tmp_path, "{min: 5 Hz, at: full-stroke}")
    frequency, low, high = range_of(check)
    of_solids = sqrt(9.173e5 / 50.0) / (2.0 * pi)
    assert check.name == "parasitic frequency at stroke (min)"
    assert low < of_solids < high
    assert frequency == pytest.approx(of_solids, rel=0.02)


def test_what_is_high_enough_at_rest_fails_at_stroke(tmp_path):
    rest, stroke = checks(tmp_path, "[{min: 40 Hz}, {min: 40 Hz, at: full-stroke}]")
    assert rest.verdict == "pass"
    assert stroke.verdict == "fail"
    assert (rest.case, stroke.case) == ("", "operation")


@pytest.mark.parametrize("mass", [HEAVY, BOX])
def test_a_small_stroke_leaves_the_frequency_of_rest(tmp_path, mass):
    asked = "[{min: 1 Hz}, {min: 1 Hz, at: full-stroke}]"
    rest, stroke = checks(tmp_path, asked, stroke="10 um", mass=mass, model="exact")
    (at_rest, *_), (_, low, high) = range_of(rest), range_of(stroke)
    assert low < at_rest < high
    # blades of a share of the mass of the box are rounded to points at its ends
    assert stroke.capacity == pytest.approx(at_rest, rel=0.01)


def test_blades_of_unknown_density_widen_the_range_downwards(tmp_path):
    known, unknown = (
        range_of(checks(tmp_path, "{min: 1 Hz, at: full-stroke}", mass=BOX, density=each)[0])
        for each in (", density: 7800 kg/m^3", "")
    )
    assert unknown[1] < known[1]
    assert unknown[0] >= known[0]


def test_points_at_its_ends_are_heavier_than_a_beam_however_they_move():
    """The consistent mass of a cubic beam, over its mass, its length 1; Przemieniecki 1968."""
    consistent = np.array([
        [156.0, 22.0, 54.0, -13.0],
        [22.0, 4.0, 13.0, -3.0],
        [54.0, 13.0, 156.0, -22.0],
        [-13.0, -3.0, -22.0, 4.0],
    ]) / 420.0  # fmt: skip
    mass, inertia = HEAVIEST
    points = np.diag([mass, inertia, mass, inertia])
    assert np.linalg.eigvalsh(points - consistent)[0] > 0.0
    assert FOLLOWS * mass == pytest.approx(consistent[0, 0], rel=1e-12)
