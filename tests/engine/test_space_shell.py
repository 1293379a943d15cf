"""The shell model of a mechanism in space, from a spec: what beams cannot decide."""

import pytest

import flexcli
from flexcli.errors import SolveError

GUIDE = """
flexure: 1
{model}
material: {{youngs_modulus: 200 GPa, yield_strength: 1800 MPa, poisson_ratio: 0.3}}
geometry:
  kind: space-layout
  bodies:
    stage: {{at: [0 mm, 50 mm, 0 mm], mass: 1 kg}}
  {blades}
  moving: stage
  motion: {{translation: x}}
cases:
  operation: {{stroke: {{translation: 20 mm}}{wrench}}}
requirements:
{requirements}
"""

LEAF = """blades:
    leaf: {between: [ground, stage], from: [100 mm, 0 mm, 0 mm], to: [100 mm, 100 mm, 0 mm],
           h: 0.5 mm, b: 50 mm, width: z, mirror: [x]}"""

SOLID = {"y": 3.561e6, "z": 9.173e5, "theta_x": 1311.4, "theta_y": 9283.5, "theta_z": 35809.0}
"""CalculiX 2.20, C3D20R, at the middle of the blades, drive locked, 20 mm of stroke."""


def spec(tmp_path, requirements, *, blades=LEAF, wrench="", model=""):
    path = tmp_path / "flexure.yaml"
    text = GUIDE.format(requirements=requirements, blades=blades, wrench=wrench, model=model)
    path.write_text(text, encoding="utf-8")
    return path


def only(result):
    (check,) = result.checks
    return check


@pytest.mark.slow
def test_support_at_stroke_is_that_of_solids_within_half_of_what_beams_tell(tmp_path):
    units = {axis: "N/m" if axis in "yz" else "N*m/rad" for axis in SOLID}
    wanted = ", ".join(
        f"{{direction: {axis}, min: 1 {units[axis]}, at: full-stroke, drive: locked}}"
        for axis in SOLID
    )
    path = spec(tmp_path, f"  support: [{wanted}]")
    by = {model: flexcli.verdicts(path, model=model).checks for model in ("exact", "shell")}
    for axis, exact, shell in zip(SOLID, *by.values(), strict=True):
        low, high = shell.factor_range
        assert low <= SOLID[axis] <= high
        assert high - low < (exact.factor_range[1] - exact.factor_range[0]) / 2.0
        assert shell.source.endswith("thin shells")


@pytest.mark.slow
def test_what_beams_leave_undecided_shells_decide(tmp_path):
    """0.917 N/µm of solids: 4 % above the limit, within what beams tell."""
    path = spec(tmp_path, "  support: {direction: z, min: 0.88 N/um, at: full-stroke}")
    assert only(flexcli.check(path, model="exact")).verdict.value == "undecided"
    check = only(flexcli.check(path))
    assert (check.model, check.verdict.value) == ("shell", "pass")


@pytest.mark.slow
def test_stress_drive_force_and_shift_of_a_stroke_are_a_plates(tmp_path):
    """3 E h s/l² times the plate's 1.08: von Mises at a clamp is −2 to +11 % off that."""
    wanted = "  yield: 2.5\n  parasitic_shift: {max: 2.6 mm}"
    path = spec(tmp_path, wanted, model="model: shell")
    result = flexcli.check(path)
    by_name = {check.name: check for check in result.checks}
    stress = by_name["yield (yield-strength)"]
    nominal = 3 * 200e9 * 0.5e-3 * 20e-3 / 0.01 * 1.07
    assert 0.98 * nominal < stress.demand < 1.11 * nominal
    assert by_name["parasitic shift (max)"].demand == pytest.approx(2.4417e-3, rel=5e-3)
    # 12 E I/l³ of two blades, times the plate's factor of its width
    k = result.values["k_stage"]
    assert k.value == pytest.approx(24 * 200e9 * 50e-3 * 0.5e-3**3 / 12 / 1e-3 * 1.068, rel=0.02)
    (sweep,) = flexcli.simulate(path, points=2).space_sweeps
    for point in sweep.points:
        assert abs(point.effort) == pytest.approx(56.87, rel=0.01)
        assert point.error < 0.025
        assert point.frequency > 0.0


def test_a_joint_of_the_plane_has_no_shell_model_of_its_stress_without_poissons_ratio(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(
        "flexure: 1\nmodel: shell\nmaterial: {youngs_modulus: 200 GPa, yield_strength: 1 GPa}\n"
        "geometry: {kind: cross-spring, delta: -0.5, half_angle: 45 deg, h: 0.2 mm, l: 20 mm,"
        " b: 8 mm}\ncases: {operation: {stroke: {rotation: 5 deg}}}\nrequirements: {yield: 1.5}\n",
        encoding="utf-8",
    )
    with pytest.raises(SolveError, match="no shell model"):
        flexcli.check(path)


def test_rods_alone_stay_undecided_and_say_why(tmp_path):
    rods = """rods:
    wire: {between: [ground, stage], from: [20 mm, 0 mm, 20 mm], to: [20 mm, 100 mm, 20 mm],
           d: 1 mm, mirror: [x, z]}"""
    path = spec(tmp_path, "  support: {direction: y, min: 1 N/m, at: full-stroke}", blades=rods)
    check = only(flexcli.check(path, model="shell"))
    assert check.verdict.value == "undecided"
    assert "rods" in check.quantity


@pytest.mark.slow
def test_accuracy_in_space_holds_beams_against_shells(tmp_path):
    """What beams are off by at stroke is within what they tell, along z below 3.5 %."""
    path = spec(tmp_path, "  yield: 1.5")
    found = flexcli.accuracy(path, runs=1).accuracy
    names = [model.model for model in found.models]
    assert names[:3] == ["linear", "exact", "shell"]
    quantities = {each.name: each for each in found.quantities}
    by = {each.model: each for each in quantities["support_z"].readings}
    assert by["shell"].value == pytest.approx(SOLID["z"], rel=0.01)
    assert 0.01 < by["exact"].error < 0.035
    assert by["shell"].error < 0.004
    assert "support_x" not in quantities
    assert set(found.models[0].missing) == {f"support_{axis}" for axis in SOLID}


def test_a_crossed_pivot_wider_than_the_beams_compared_is_judged_as_shells(tmp_path):
    """Beyond b = 3 l beams tell no error; they differ by what they tell of narrower blades."""
    path = tmp_path / "flexure.yaml"
    path.write_text(
        "flexure: 1\nmaterial: {youngs_modulus: 200 GPa, poisson_ratio: 0.3}\n"
        "geometry: {kind: cross-spring, delta: -0.5, half_angle: 45 deg, h: 0.2 mm, l: 20 mm,"
        " b: 64 mm}\ncases: {operation: {stroke: {rotation: 10 deg}}}\nrequirements:\n"
        "  support: {direction: z, min: 0.01 N/um, at: full-stroke, drive: locked}\n",
        encoding="utf-8",
    )
    exact = only(flexcli.check(path, model="exact"))
    assert exact.verdict.value == "undecided"
    check = only(flexcli.check(path))
    assert (check.model, check.verdict.value) == ("shell", "pass")
    assert check.source.endswith("thin shells")
    assert check.factor == pytest.approx(exact.factor, rel=0.06)


CANTILEVER = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, yield_strength: 800 MPa}}
geometry:
  kind: space-layout
  bodies: {{top: {{at: [0 mm, 0 mm, 20 mm], mass: 1 kg}}}}
  blades:
    leaf: {{between: [ground, top], from: [0 mm, 0 mm, 0 mm], to: [0 mm, 0 mm, 20 mm],
           h: 0.1 mm, b: {b} mm, width: y}}
  moving: top
  motion: {{translation: x}}
cases: {{pushed: {{wrench: {{{wrench}}}}}}}
requirements: {{yield: 1}}
"""


@pytest.mark.parametrize("b", [5, 20, 30])
@pytest.mark.parametrize("wrench", ["z: 0.1 N", "y: 0.1 N", "theta_x: 1 N*mm"])
def test_the_stress_of_shells_is_nominal_outside_of_the_corners_of_clamps(b, wrench):
    """Where a sheet is pulled or bent in its plane its corners have no bound, unlike beams."""
    text = CANTILEVER.format(b=b, wrench=wrench)
    beams, shells = (
        only(flexcli.verdicts(text, model=model)).factor_range for model in ("exact", "shell")
    )
    assert shells[0] <= beams[1] * (1.0 + 1e-9)
    assert beams[0] <= shells[1] * (1.0 + 1e-9)


TWISTED = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, yield_strength: 830 MPa}}
geometry:
  kind: space-layout
  bodies: {{tip: {{at: [40 mm, 0 mm, 0 mm]}}}}
  blades:
    strip: {{between: [ground, tip], from: [0 mm, 0 mm, 0 mm], to: [40 mm, 0 mm, 0 mm],
            h: 0.2 mm, b: {b}, width: z}}
  moving: tip
  motion: {{rotation: {{about: x, at: [0 mm, 0 mm, 0 mm]}}}}
cases: {{twist: {{stroke: {{rotation: 20 mrad}}}}}}
requirements: {{yield: 1}}
"""


@pytest.mark.parametrize("b", ["4 mm", "10 mm", "30 mm"])
def test_the_stress_of_a_twisted_strip_is_not_less_by_shells_than_by_beams(b):
    each = [only(flexcli.check(TWISTED.format(b=b), model=m)) for m in ("linear", "shell")]
    stress = [[row.capacity / factor for factor in reversed(row.factor_range)] for row in each]
    assert max(low for low, _ in stress) < min(high for _, high in stress)
