"""A steady acceleration in any direction, as a user states it by its components."""

import json

import pytest

PIVOT = """\
flexure: 1
material: ti-6al-4v
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.1 mm, l: 10 mm, b: 5 mm}
mechanism: {kind: payload, mass: 50 g}
cases:
  launch: {CASE}
requirements: {yield: 1.5}
"""
SPACE = """\
flexure: 1
material: ti-6al-4v
geometry:
  kind: space-layout
  bodies:
    stage: {at: [40 mm, 0 mm, 0 mm], mass: 0.2 kg, inertia: [1e-5 kg*m^2, 1e-5 kg*m^2, 1e-5 kg*m^2]}
  blades:
    leaf: {between: [ground, stage], from: [0 mm, 12 mm, 0 mm], to: [40 mm, 12 mm, 0 mm],
           h: 0.2 mm, b: 12 mm, width: z, mirror: [y]}
  moving: stage
  motion: {translation: y}
cases:
  launch: {CASE}
requirements: {yield: 1.5}
"""


@pytest.mark.parametrize(("spec", "mass", "off"), [(PIVOT, 0.05, 1e-3), (SPACE, 0.2, 0.02)])
def test_an_acceleration_stresses_as_the_wrench_of_its_mass_does(
    spec, mass, off, flexure, tmp_path
):
    parts = {"x": 6.0, "y": 2.0, "z": -30.0}
    whole = "acceleration: {" + ", ".join(f"{k}: {a} m/s^2" for k, a in parts.items()) + "}"
    wrench = "wrench: {" + ", ".join(f"{k}: {mass * a!r} N" for k, a in parts.items()) + "}"
    demands = []
    for case in (whole, wrench):
        (tmp_path / "flexure.yaml").write_text(spec.replace("CASE", case))
        told = flexure("check", "--format", "json")
        assert told.returncode in (0, 1), told.stdout + told.stderr
        demands.append([each["demand"] for each in json.loads(told.stdout)["checks"]])
    # the blades weigh as well: 44 mg beside 50 g, 0.9 g beside 200 g
    assert demands[0] == pytest.approx(demands[1], rel=off)
