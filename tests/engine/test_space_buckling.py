"""Buckling of mechanisms in space from a spec, against plates between guided ends."""

from math import pi

import pytest

import flexcli
from flexcli.formulas.plate_buckling import buckling_factor

SPEC = """
flexure: 1
material: {{youngs_modulus: 200 GPa, yield_strength: 1800 MPa, poisson_ratio: 0.3}}
geometry:
  kind: space-layout
  bodies:
    stage: {{at: [0 mm, 50 mm, 0 mm]}}
  blades:
    leaf: {{between: [ground, stage], from: [100 mm, 0 mm, 0 mm], to: [100 mm, 100 mm, 0 mm],
           h: 0.5 mm, b: 20 mm, width: z, mirror: [x]}}
  moving: stage
  motion: {{translation: x}}
cases:
  push: {{wrench: {{y: {force} N}}}}
requirements:
  buckling: 2
"""


def checked(tmp_path, force):
    spec = tmp_path / "flexure.yaml"
    spec.write_text(SPEC.format(force=force), encoding="utf-8")
    (check,) = flexcli.verdicts(spec).checks
    return check


@pytest.mark.slow
def test_a_guide_pushed_down_its_blades_sways_at_the_load_of_its_plates(tmp_path):
    """2 π² E I/l² of both blades times the plate's factor, the drive free."""
    EI = 200e9 * 20e-3 * 0.5e-3**3 / 12.0
    plate = float(
        buckling_factor(b=20e-3, l=0.1, h=0.5e-3, ends="clamped-guided", poisson_ratio=0.3)
    )
    check = checked(tmp_path, -50)
    assert check.model == "exact"
    assert check.verdict.value == "fail"
    assert check.factor == pytest.approx(2 * pi**2 * EI / 0.1**2 * plate / 50.0, rel=0.01)


def test_a_guide_that_is_pulled_does_not_buckle(tmp_path):
    check = checked(tmp_path, 50)
    assert check.verdict.value == "pass"
    assert check.factor_range[0] > 4.0
    assert check.factor_range[1] == float("inf")


@pytest.mark.slow
def test_blades_as_heavy_as_their_body_leave_its_buckling_under_an_acceleration_open(tmp_path):
    """Two blades of 7.85 g on a body of 15.7 g: half of them may count or not."""
    text = SPEC.replace(
        "{{wrench: {{y: {force} N}}}}", "{{acceleration: {{level: 300 g, axis: y}}}}"
    )
    text = text.replace("poisson_ratio: 0.3", "poisson_ratio: 0.3, density: 7850 kg/m^3")
    spec = tmp_path / "flexure.yaml"
    spec.write_text(text.replace("50 mm, 0 mm]", "50 mm, 0 mm], mass: 15.7 g").format(), "utf-8")
    (check,) = (c for c in flexcli.verdicts(spec, model="exact").checks if c.name == "buckling")
    low, high = check.factor_range
    assert (high - low) / 2.0 > 0.5 * check.factor


@pytest.mark.slow
@pytest.mark.parametrize(("b", "force"), [(10, 8.4), (20, 28.0), (30, 42.0), (60, 90.0)])
def test_beams_bear_along_the_width_of_a_guide_what_shells_do_within_their_range(
    tmp_path, b, force
):
    # sections of wide blades are distorted as they turn aside between ends that stand still
    text = SPEC.replace("{{y: {force} N}}", "{{z: {force} N}}")
    text = text.replace("[100 mm, 100 mm, 0 mm]", "[100 mm, 20 mm, 0 mm]")
    text = text.replace("h: 0.5 mm, b: 20 mm", f"h: 0.05 mm, b: {b} mm")
    spec = tmp_path / "flexure.yaml"
    spec.write_text(text.replace("100 mm", "15 mm").format(force=force), encoding="utf-8")
    straight, beams, shells = (
        flexcli.verdicts(spec, model=model).checks[0] for model in ("linear", "exact", "shell")
    )
    assert straight.factor_range[0] <= shells.factor
    assert beams.factor_range[0] <= shells.factor <= beams.factor_range[1]
    assert beams.factor > 1.02 * shells.factor


def test_very_wide_hinges_pushed_along_their_width_stand_as_solids_of_them_do():
    """Two hinges of b = 26 l_c: 127.8 times this load by CalculiX's solids, rigid in the middle."""
    found = flexcli.check("""\
flexure: 1
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.0, yield_strength: 900 MPa}
geometry: {kind: necked-down-stage, h: 1.3872 mm, l: 52.998 mm, b: 158.994 mm, l_c: 6.1352 mm,
  blades: 2, spacing: 70.4 mm}
cases: {work: {wrench: {z: 15416 N}, ends: clamped-clamped}}
requirements: {buckling: 2}
""")
    (check,) = (c for c in found.checks if c.name == "buckling")
    assert check.verdict.value == "pass"
    assert 2.0 < check.factor_range[0] < 127.8
