"""The solid model of unseparated crosses, from a spec: what beams cannot decide."""

import json
from math import hypot, pi, radians
from pathlib import Path

import pytest

import flexcli
from flexcli.mechanics.solids.crossed_joint import crossed_joint

WHOLE = json.loads(
    (Path(__file__).parents[1] / "parts/crossed_whole.json").read_text(encoding="utf-8")
)
ASIDE = json.loads(
    (Path(__file__).parents[1] / "parts/crossed_aside.json").read_text(encoding="utf-8")
)
L, E = 0.1, 200e9
TURN = 2
STOUT = tuple(WHOLE[1][:4]), WHOLE[1][4]
SLENDER = (0.008, 0.02, 0.4, 50.0), 0.0
STROKE = {"stroke": {"rotation": "1e-5 rad", "cycles": 1e6}}
MEANT = {
    "stiffness": {"min": "1 N*m/rad"}, "frequency": {"min": "1 Hz"}, "yield": 1.0,
    "parasitic_shift": {"max": "1 m"}, "drive": 1.0, "fatigue": 1.0, "buckling": 1.0,
    "sag": {"max": "1 m"},
}  # fmt: skip


def spec(joint, nu, *asked, case=None, clamps=None, **more):
    h, b, crossing, degrees = joint
    geometry = {
        "kind": "unseparated-cross", "h": f"{h * L!r} m", "l": f"{L} m", "b": f"{b * L!r} m",
        "crossing": crossing, "half_angle": f"{degrees!r} deg",
    }  # fmt: skip
    material = {
        "name": "drawn", "youngs_modulus": f"{E} Pa", "poisson_ratio": nu,
        "density": "1 g/m^3", "yield_strength": "1 GPa",
        "fatigue_amplitude": {"value": "400 MPa", "cycles": 1e6},
    }  # fmt: skip
    words = {
        "flexure": 1,
        "material": material,
        "geometry": geometry if clamps is None else {**geometry, "clamps": clamps},
        "cases": {"work": STROKE if case is None else case},
        "requirements": {name: MEANT[name] for name in asked if name in MEANT},
        **more,
    }
    return json.dumps(words) + "\n"


def checked(joint, nu, asked, *, model="solid", **how):
    checks = flexcli.verdicts(spec(joint, nu, asked, **how), model=model).checks
    (check,) = (c for c in checks if c.name.startswith(asked.replace("_", " ")))
    return check


def supported(joint, nu, direction):
    asked = {"direction": direction, "min": "1 N*m/rad" if "theta" in direction else "1 N/m"}
    return checked(joint, nu, "support", requirements={"support": [asked]})


def test_a_stout_cross_is_as_stiff_as_its_solid():
    check = checked(*STOUT, "stiffness")
    (h, b, crossing, degrees), nu = STOUT
    found = crossed_joint(h, b, crossing, radians(degrees), nu).diagonal
    assert check.factor == pytest.approx(E * L**3 / found.value[TURN], rel=1e-9)
    least, most = check.factor_range
    assert least < check.factor < most < 1.03 * least
    assert least <= E * L**3 / WHOLE[1][7] <= most


@pytest.mark.parametrize("row", WHOLE)
def test_the_stress_of_a_small_stroke_is_the_nominal_one_of_what_calculix_has_in_its_arms(row):
    h, b, crossing, degrees, nu, *_, arms = row
    check = checked((h, b, crossing, degrees), nu, "yield")
    moment = 1e-5 * E * L**3 / row[7]
    worst = 0.0
    # arms at the base; those at the body bear half of the moment in the crossing too
    for N, V, M in (arms[4], arms[5]):
        for bending in (M, M - crossing * V):
            worst = max(worst, 6.0 * abs(bending) / (b * h**2) + abs(N) / (b * h))
    stress = worst * moment / L**3
    least, most = check.factor_range
    # those at the body are pulled by another force
    assert 1e9 / most == pytest.approx(stress, rel=0.05)
    assert most / least < 1.08


def test_the_shift_holds_that_of_calculix_both_ways():
    for row in WHOLE:
        h, b, crossing, degrees, nu, *_, across, along, _ = row
        for theta in (1e-5, 1e-2):
            case = {"stroke": {"rotation": f"{theta} rad"}}
            joint = h, b, crossing, degrees
            check = checked(joint, nu, "parasitic_shift", case=case)
            shift = hypot(along * theta**2, across * theta) * L
            least, most = check.factor_range
            assert 1.0 / most <= shift <= 1.0 / least


def test_a_large_stroke_shifts_and_drives_as_calculix_has_it():
    # NLGEOM at 0.1 rad, the mesh of crossed_solids.py: motions along and across, and the moment
    # over that at 1 mrad and the rotation
    along, across, softer = 0.01870233e-3, 0.00551805e-3, 1601.934 / 16.03971 / 100.0
    h, b, crossing, degrees, nu, *_ = WHOLE[0]
    joint, case = (h, b, crossing, degrees), {"stroke": {"rotation": "0.1 rad"}}
    least, most = checked(joint, nu, "parasitic_shift", case=case).factor_range
    assert 1.0 / most <= hypot(along, across) <= 1.0 / least
    drive = checked(
        joint, nu, "drive", case=case,
        actuator={"blocking_force": "1e6 N", "free_stroke": "10 m", "arm": "10 mm",
                  "drives": "both-ways"},
    )  # fmt: skip
    low, high = (drive.demand * drive.factor / end for end in reversed(drive.factor_range))
    K = checked(joint, nu, "stiffness").factor
    assert low <= K * 0.1 / 0.01 * softer <= high


@pytest.mark.parametrize("asked", ["stiffness", "yield", "parasitic_shift"])
@pytest.mark.parametrize("theta", [1e-3, 0.1])
def test_a_slender_cross_is_one_of_beams(asked, theta):
    case = {"stroke": {"rotation": [f"{-0.5 * theta} rad", f"{theta} rad"]}}
    beams, solid = (
        checked(*SLENDER, asked, case=case, model=model) for model in ("exact", "solid")
    )
    # of a shift the middle of a range is told
    assert solid.factor == pytest.approx(beams.factor, rel=0.04 if "shift" in asked else 0.01)
    assert solid.factor_range[0] <= beams.factor_range[1]
    assert beams.factor_range[0] <= solid.factor_range[1]


@pytest.mark.parametrize("direction", ["0 deg", "90 deg"])
@pytest.mark.parametrize("ends", ["clamped-free", "clamped-clamped", "clamped-guided"])
def test_a_slender_cross_bears_loads_as_one_of_beams(direction, ends):
    load = {"force": "5 N", "direction": direction}
    for case in ({"load": load, "ends": ends}, {**STROKE, "load": load, "ends": ends}):
        beams, solid = (
            checked(*SLENDER, "yield", case=case, model=model) for model in ("exact", "solid")
        )
        assert solid.factor == pytest.approx(beams.factor, rel=0.02)


def test_a_load_on_a_stout_cross_is_borne_as_calculix_has_it():
    h, b, crossing, degrees, nu, *_, arms = WHOLE[1]
    case = {"load": {"force": "1 kN", "direction": "0 deg"}, "ends": "clamped-guided"}
    check = checked((h, b, crossing, degrees), nu, "yield", case=case)
    worst = 0.0
    for N, V, M in arms[:2]:
        for bending in (M, M - crossing * V):
            worst = max(worst, 6.0 * abs(bending) / (b * h**2) + abs(N) / (b * h))
    assert 1e9 / check.factor == pytest.approx(worst * 1e3 / L**2, rel=0.15)


def test_a_crossing_may_relieve_what_beams_have_under_a_load():
    # beams were told to have no more than a solid, which has 4 % less
    joint, case = (0.20235, 0.2075, 0.566, 37.86), {"wrench": {"y": "1 N"}}
    beams, solid = (
        checked(joint, 0.0, "yield", case=case, model=model) for model in ("exact", "solid")
    )
    assert solid.factor_range[0] > beams.factor
    assert beams.factor_range[1] > solid.factor_range[1]


def test_a_stout_cross_swings_as_its_stiffness_has_it():
    payload = {"kind": "payload", "mass": "1 g", "inertia": "1e-2 kg*m^2"}
    K = checked(*STOUT, "stiffness").factor
    f = checked(*STOUT, "frequency", mechanism=payload)
    assert f.factor == pytest.approx((K / 1e-2) ** 0.5 / (2.0 * pi), rel=1e-6)
    assert f.factor_range[1] / f.factor_range[0] < 1.02


def test_a_drive_turns_a_stout_cross_by_its_solid():
    actuator = {"blocking_force": "1 kN", "free_stroke": "1 m", "arm": "10 mm"}
    check = checked(*STOUT, "drive", actuator=actuator)
    K = checked(*STOUT, "stiffness").factor
    assert check.demand == pytest.approx(1e-5 * K / 0.01, rel=1e-3)


@pytest.mark.parametrize(
    ("direction", "at", "power"), [("x", 5, 1), ("y", 6, 1), ("theta_z", 7, 3)]
)
def test_supports_in_the_plane_are_those_of_calculix(direction, at, power):
    h, b, crossing, degrees, nu, *_ = WHOLE[1]
    found = supported((h, b, crossing, degrees), nu, direction)
    least, most = found.factor_range
    assert least <= E * L**power / WHOLE[1][at] * (1.0 + 2e-3)
    assert E * L**power / WHOLE[1][at] <= most * (1.0 + 2e-3)
    assert most < 1.03 * least


@pytest.mark.parametrize(
    ("direction", "at", "power"), [("z", 5, 1), ("theta_x", 6, 3), ("theta_y", 7, 3)]
)
def test_supports_out_of_the_plane_are_those_of_calculix(direction, at, power):
    row = ASIDE[1]
    found = supported(tuple(row[:4]), row[4], direction)
    least, most = found.factor_range
    assert least <= E * L**power / row[at] <= most
    assert most < 1.03 * least


@pytest.mark.parametrize(("axis", "at"), [("x", 5), ("y", 6)])
def test_a_stout_cross_sags_in_its_plane_as_calculix_has_it(axis, at):
    h, b, crossing, degrees, nu, *_ = WHOLE[1]
    case = {"acceleration": {"level": "10 m/s^2", "axis": axis}}
    payload = {"kind": "payload", "mass": "3 kg", "inertia": "1e-2 kg*m^2"}
    found = checked((h, b, crossing, degrees), nu, "sag", case=case, mechanism=payload)
    least, most = found.factor_range
    sag = 30.0 * WHOLE[1][at] / (E * L)
    assert 1.0 / most * (1.0 - 3e-3) <= sag <= 1.0 / least * (1.0 + 3e-3)
    assert most < 1.05 * least


def test_a_stout_cross_sags_aside_as_calculix_has_it():
    row = ASIDE[1]
    case = {"acceleration": {"level": "10 m/s^2", "axis": "z"}}
    payload = {"kind": "payload", "mass": "3 kg", "inertia": "1e-2 kg*m^2"}
    found = checked(tuple(row[:4]), row[4], "sag", case=case, mechanism=payload)
    least, most = found.factor_range
    assert 1.0 / most <= 30.0 * row[5] / (E * L) <= 1.0 / least
    assert most < 1.05 * least


def test_solids_decide_what_beams_leave_open():
    text = spec(*STOUT, "yield", "fatigue", "parasitic_shift")
    open_ = flexcli.verdicts(text, model="exact").checks
    assert any(check.factor_range is None for check in open_)
    found = flexcli.verdicts(text).checks
    assert all(check.factor_range is not None for check in found)


@pytest.mark.parametrize("clamps", ["monolithic", "monolithic-flush"])
def test_there_are_no_solids_of_roots_that_give_way(clamps):
    assert "has no solid model" in checked(*STOUT, "stiffness", clamps=clamps).quantity
    assert checked(*STOUT, "stiffness", clamps=clamps, model=None).factor > 0.0


def test_solids_do_not_buckle():
    case = {"load": {"force": "1 N", "direction": "0 deg"}, "ends": "clamped-free"}
    assert checked(*STOUT, "buckling", case=case).factor_range is None
