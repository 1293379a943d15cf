"""Joined blades of one piece where they cross: the ranges of exact beams hold solids and planes."""

import json
from math import cos, radians, sin
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pydantic import TypeAdapter

import flexcli
from flexcli.formulas.profile import Constant
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.own_weight import POINTS
from flexcli.mechanics.stresses import blade_stress
from flexcli.parts.geometries import AnyGeometry

L, E = 0.1, 200e9
MESHED = 0.025
"""What the mesh of solids leaves too much of what a crossing stiffens: 2.5 % at 84°."""

MEANT: dict[str, Any] = {
    "stiffness": {"min": "1 N*m/rad"}, "parasitic_shift": {"max": "1 m"}, "buckling": 1.0,
}  # fmt: skip


def rows(name: str) -> Any:
    return json.loads((Path(__file__).parent / name).read_text(encoding="utf-8"))


def drawn(joint: Any, nu: float) -> dict[str, Any]:
    """Return material and geometry of a spec, of sizes over the length."""
    h, b, crossing, degrees = joint
    return {
        "flexure": 1,
        "material": {"name": "drawn", "youngs_modulus": f"{E} Pa", "poisson_ratio": nu},
        "geometry": {
            "kind": "unseparated-cross", "h": f"{h * L!r} m", "l": f"{L} m", "b": f"{b * L!r} m",
            "crossing": crossing, "half_angle": f"{degrees!r} deg",
        },
    }  # fmt: skip


def numbers(
    joint: tuple[float, float, float, float], nu: float, asked: str, **case: Any
) -> tuple[float, float, float]:
    """Return a number [SI] of sizes over the length by corrected exact beams, and its range."""
    words = {
        **drawn(joint, nu),
        "cases": {"work": case or {"stroke": {"rotation": "1e-6 rad"}}},
        "requirements": {asked: MEANT[asked]},
    }  # fmt: skip
    (check,) = (
        c
        for c in flexcli.verdicts(json.dumps(words) + "\n", model="exact").checks
        if c.name.startswith(asked.replace("_", " "))
    )
    assert check.factor_range is not None
    low, high = check.factor_range
    if asked == "parasitic_shift":  # the limit over the shift
        return 1.0 / check.factor, 1.0 / high, 1.0 / low
    return check.factor, low, high


@pytest.mark.parametrize("row", rows("crossed_solids.json"))
def test_the_stiffness_of_solids_is_in_the_range_of_exact_beams(row):
    """``tests/benchmarks/crossed_solids.py``: halves that reach 0.5 h to 80 h beyond the crossing.

    Beams that meet in a point are half as stiff at 72°.
    """
    *joint, rigid, some, most = row
    h, b, *_ = joint
    for nu, solid in ((0.0, rigid), (0.3, some), (0.45, most)):
        value, low, high = (
            each / (8.0 * E * b * h**3 * L**3 / 12.0) for each in numbers(joint, nu, "stiffness")
        )
        assert low <= solid <= high + MESHED * max(solid - 1.0, 0.1)
        assert high - low < (0.02 + 0.35 * nu) * value  # and tells something


@pytest.mark.parametrize("row", rows("plane_joints.json"))
def test_the_stiffness_of_planes_is_in_the_range_of_exact_beams(row):
    """``tests/benchmarks/plane_crossing.py``; as blades much narrower than thick are."""
    h, crossing, degrees, nu, plane, _ = row
    b = 0.01 * h
    _, low, high = (
        each / (8.0 * E * b * h**3 * L**3 / 12.0)
        for each in numbers((h, b, crossing, degrees), nu, "stiffness")
    )
    assert low <= plane <= high


@pytest.mark.parametrize("row", [row for row in rows("plane_joints.json") if row[2] != 52.0])
def test_a_plane_of_joined_blades_moves_across_within_the_range_of_exact_beams(row):
    """All that moves the centre at so small a stroke; beams alone have a fifth to forty times it.

    At 52° and 59° what the crossing changes is as much as what there is.
    """
    h, crossing, degrees, nu, _, across = row
    _, low, high = numbers((h, 0.01 * h, crossing, degrees), nu, "parasitic_shift")
    assert low <= abs(across) * L * 1e-6 <= high
    if nu == 0.0:
        assert high / low < (2.5 if degrees == 59.19 else 1.2)  # and tells something


@pytest.mark.parametrize("row", rows("crossed_buckling.json"))
def test_what_buckles_solids_is_in_the_range_of_exact_beams(row):
    """``tests/benchmarks/crossed_solids.py``: a force along the bisector, no turning."""
    *joint, nu, across, solid = row
    h, b, *_ = joint
    _, low, high = (
        each / (E * b * h**3 * L**2 / 12.0)
        for each in numbers(
            joint, nu, "buckling", ends="clamped-clamped" if across else "clamped-guided",
            load={"force": "1 N", "direction": "180 deg"},
        )
    )  # fmt: skip
    assert low <= solid <= high


def deflection(joint: Any, nu: float, axis: str) -> tuple[float, float]:
    """Return the range of a motion by a force or moment along an axis, as if l = E = 1."""
    unit, most = ("N*m", "1 rad") if axis.startswith("theta") else ("N", "1 m")
    words = {
        **drawn(joint, nu),
        "cases": {"work": {"wrench": {axis: f"1e-3 {unit}"}}},
        "requirements": {"deflection": [{"direction": axis, "max": most}]},
    }  # fmt: skip
    checks = flexcli.verdicts(json.dumps(words) + "\n", model="exact").checks
    (found,) = (c.factor_range for c in checks if c.name.startswith("deflection"))
    assert found is not None
    size = 1e3 * E * (L**3 if unit == "N*m" else L)
    return size / found[1], size / found[0]


@pytest.mark.parametrize("row", rows("crossed_aside.json"))
def test_solids_give_way_out_of_their_plane_within_the_range_of_exact_beams(row):
    """``tests/benchmarks/crossed_solids.py``; beams alone were 26 % softer about x at 80°."""
    *joint, nu, along_z, about_x, about_y = row
    for axis, solid in (("z", along_z), ("theta_x", about_x), ("theta_y", about_y)):
        low, high = deflection(joint, nu, axis)
        assert low <= solid <= high
        # no less than with a rigid crossing, which little of a motion along z hangs on
        assert low > (0.9 if axis == "z" else 0.73) * solid


def test_a_joint_is_no_stiffer_than_with_a_rigid_crossing():
    """``tests/benchmarks/plane_crossing.py``: halves that begin where both no longer share."""
    h, crossing, degrees, _, across = rows("plane_deflections.json")[4]
    words = {
        **drawn((h, h / 2.0, crossing, degrees), 0.0),
        "requirements": {"support": [{"direction": "y", "min": "1 N/m"}]},
    }
    found = flexcli.verdicts(json.dumps(words) + "\n", model="exact").checks[0].factor_range
    assert found is not None
    plane = E * h / 2.0 * L / across
    assert found[0] < plane < found[1] < 1.1 * plane


@pytest.mark.parametrize("row", rows("plane_deflections.json"))
def test_planes_give_way_to_a_force_within_the_range_of_exact_beams(row):
    """``tests/benchmarks/plane_crossing.py``; along nearly parallel blades 6 % more than beams."""
    h, crossing, degrees, along, across = row
    for axis, plane in (("x", along), ("y", across)):
        low, high = deflection((h, h / 2.0, crossing, degrees), 0.0, axis)
        assert low <= plane / (h / 2.0) <= high


def most_in_crossing(degrees: float, crossing: float, rigid: float, turn: float) -> float:
    """Return the largest bending in a crossing out to which blades are rigid, by exact beams."""
    blades = []
    for a in (radians(degrees), -radians(degrees)):
        along = np.array([cos(a), sin(a)])
        arms = {
            ("ground", "cross"): (-crossing, -rigid),
            ("cross", "moving"): (rigid, 1.0 - crossing),
        }
        for bodies, ends in arms.items():
            places = [tuple((end * along).tolist()) for end in ends]
            blades.append(Blade(f"{a} {ends}", *bodies, *places, Constant(1e-3), 1e-3))
    bodies = (Body("cross", (0.0, 0.0)), Body("moving", (0.0, 0.0)))
    state = solve(Layout(bodies, tuple(blades), 1.0, 0.4), {"moving": (None, None, turn)})
    found = []
    for blade in state.layout.blades:
        stress = blade_stress(state, blade.name, POINTS)
        s, bends = stress.s.ravel(), stress.bending.ravel()
        root, next_to = (0, 1) if blade.first == "cross" else (-1, -2)
        # a rigid piece bears what it is joined to, with a constant force across it
        slope = (bends[next_to] - bends[root]) / abs(s[next_to] - s[root])
        found.append(abs(bends[root] - rigid * slope))
    return max(found)


@pytest.mark.parametrize(
    ("degrees", "crossing"),
    [(8.0, 0.35), (35.0, 0.2), (52.0, 0.12), (74.0, 0.1), (75.0, 0.35), (83.0, 0.5)],
)
@pytest.mark.parametrize("turn", [0.05, 0.3, 0.6])
def test_a_turn_changes_what_a_crossing_adds_to_the_stress_within_its_error(
    degrees, crossing, turn
):
    """By exact beams that begin beyond it: at 83° and 0.6 rad it is all lost."""
    joint = TypeAdapter(AnyGeometry).validate_python({
        "kind": "unseparated-cross", "h": "0.1 mm", "l": "20 mm", "b": "1 mm",
        "crossing": crossing, "half_angle": f"{degrees} deg",
    })  # fmt: skip
    clamps = joint.compliant_clamps(joint.sized({}), 0.3)
    at_rest, turned = (
        most_in_crossing(degrees, crossing, 0.02, each)
        / most_in_crossing(degrees, crossing, 0.0, each)
        - 1.0
        for each in (1e-4, turn)
    )
    told, adds = clamps.turned, clamps.stiffness.high - 1.0
    if turn <= told.farthest:
        assert told.least * turn <= (turned / at_rest - 1.0) * adds
        assert (turned / at_rest - 1.0) * adds <= (told.most + told.grows * turn**2) * turn
    else:
        assert degrees == 83.0


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
@pytest.mark.parametrize(
    "joint", [(0.103, 0.215, 0.562, 75.0), (0.05, 0.2, 0.4, 60.0), (0.02, 0.2, 0.3, 20.0)]
)
def test_a_joined_pivot_swings_as_its_stiffness_has_it(joint, model):
    # what its crossing stiffens counted twice in its frequency
    inertia = 1e-4
    words = drawn(joint, 0.3)
    words |= {
        "material": {**words["material"], "density": "1 g/m^3"},  # hardly moves anything itself
        "mechanism": {"kind": "payload", "mass": "1 g", "inertia": f"{inertia} kg*m^2"},
        "requirements": {"stiffness": {"min": "1 N*m/rad"}, "frequency": {"min": "1 Hz"}},
    }
    checks = {c.name: c for c in flexcli.verdicts(json.dumps(words) + "\n", model=model).checks}
    K, f = (checks[f"{name} (min)"] for name in ("stiffness", "frequency"))
    assert f.factor == pytest.approx((K.factor / inertia) ** 0.5 / (2.0 * np.pi), rel=1e-6)
    if K.factor_range is not None:
        for end, other in zip(f.factor_range, K.factor_range, strict=True):
            assert end / f.factor == pytest.approx((other / K.factor) ** 0.5, rel=5e-3)
