"""The box around a mechanism: at rest, over its stroke, and as what sizes it."""

from math import atan2, cos, hypot, radians, sin

import numpy as np
import pytest
import yaml

import flexcli
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.shape import centre_line
from flexcli.results import Status, Verdict

STAGE = """flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, l: 40 mm, h: 0.2 mm, b: 5 mm, spacing: 20 mm}
cases: {push: {wrench: {y: 1 N}}}
requirements: {envelope: [30 mm, 50 mm, 6 mm]}
"""
GUIDE = """flexure: 1
material: ti-6al-4v
parameters: {l: 40 mm}
geometry:
  kind: space-layout
  bodies: {stage: {at: [l, 0 mm, 0 mm], box: [10 mm, 30 mm, 8 mm], density: 2810 kg/m^3}}
  blades:
    pair: {between: [ground, stage], from: [0 mm, 10 mm, 0 mm], to: [l, 10 mm, 0 mm],
           h: 0.2 mm, b: 5 mm, width: z, mirror: [y]}
  moving: stage
  motion: {translation: y}
cases: {op: {stroke: {translation: 2 mm}}}
requirements: {envelope: [50 mm, 40 mm, 10 mm]}
"""
CROSS = """flexure: 1
material: ti-6al-4v
geometry:
  kind: layout
  bodies: {rotor: {at: [0 mm, 0 mm], box: [30 mm, 10 mm, 4 mm]}}
  blades:
    one: {between: [ground, rotor], from: [-4 mm, -4 mm], to: [4 mm, 4 mm], h: 0.1 mm, b: 2 mm}
    two: {between: [ground, rotor], from: [4 mm, -4 mm], to: [-4 mm, 4 mm], h: 0.1 mm, b: 2 mm}
  moving: rotor
  motion: rotation
cases: {op: {stroke: {rotation: 10 deg}}}
requirements: {envelope: [40 mm, 20 mm, 5 mm]}
"""


TIP = """flexure: 1
material:
  {youngs_modulus: 114 GPa, yield_strength: 800 MPa, poisson_ratio: 0.34, density: 4430 kg/m^3}
geometry:
  kind: layout
  bodies: {tip: {at: [40 mm, 0 mm], com: [60 mm, 2 mm], box: [30 mm, 6 mm, 2 mm]}}
  blades:
    one: {between: [ground, tip], from: [0 mm, 0 mm], to: [40 mm, 0 mm], h: 0.3 mm, b: 2 mm}
  moving: tip
  motion: rotation
cases: {op: {stroke: {rotation: 8 deg}}}
requirements: {envelope: [500 mm, 500 mm, 500 mm]}
"""
BARE = TIP.replace(", com: [60 mm, 2 mm], box: [30 mm, 6 mm, 2 mm]", "")
NECKED, NOTCHED = (
    BARE.replace("h: 0.3 mm, b", f"profile: {profile}, b")
    for profile in (
        "{kind: necked-down, h: 0.3 mm, l_c: 4 mm}", "{kind: notch, e: 0.2 mm, depth: 2 mm}"
    )
)  # fmt: skip


PLACES = np.linspace(0.0, 1.0, 4001)


def box(text, model=None):
    """Return the sides by axis, and the ranges that they lie in, to rounding."""
    rows = [row for row in flexcli.check(text, model=model).checks if "envelope" in row.name]
    sides = [row.demand for row in rows]
    between = [(row.capacity / row.factor_range[1] * (1.0 - 1e-12),
                row.capacity / row.factor_range[0] * (1.0 + 1e-12)) for row in rows]  # fmt: skip
    return np.array(sides), np.array(between)


def tip_box(travels, thickness=0.3e-3, *, corners=True, share=lambda s: s):
    """Return the sides along x and y of a blade that a moment alone bends, and of its body.

    ``share`` is how much of the turn a section has, by its place over the length of 40 mm.
    """
    points, s = [], PLACES
    for theta in travels:
        phi = theta * share(s)
        steps = 40e-3 * np.diff(s)
        x, y = (
            np.append(0.0, np.cumsum(f((phi[1:] + phi[:-1]) / 2.0) * steps))
            for f in (np.cos, np.sin)
        )
        for side in (1.0, -1.0):
            h = side * thickness / 2.0
            points.append(np.stack([x - h * np.sin(phi), y + h * np.cos(phi)], axis=1))
        for u, v in ((5, -1), (5, 5), (35, -1), (35, 5)) if corners else ():
            a, b = u * 1e-3, v * 1e-3
            corner = [x[-1] + a * cos(theta) - b * sin(theta),
                      y[-1] + a * sin(theta) + b * cos(theta)]  # fmt: skip
            points.append(np.array([corner]))
    every = np.concatenate(points)
    return every.max(axis=0) - every.min(axis=0)


def holds(between, sides):
    """Return whether ranges along x and y hold sides."""
    return (between[:2, 0] <= sides).all() and (sides <= between[:2, 1]).all()


def test_at_rest_it_is_that_of_blades_and_bodies():
    text = GUIDE.replace(
        "{stroke: {translation: 2 mm}}", "{asd: {profile: gevs-acceptance, q: 50}}"
    )
    sides, between = box(text)
    assert sides == pytest.approx([45e-3, 30e-3, 8e-3], rel=1e-9)
    assert between == pytest.approx(np.stack([sides, sides], axis=1), rel=1e-9)


def test_a_load_along_blades_stretches_the_box_by_no_more_than_them():
    sides, between = box(STAGE)
    # x is along the stroke, y along the blades; F l/(2 E A)
    assert sides == pytest.approx([20e-3 + 0.2e-3, 40e-3 + 0.175e-6, 5e-3], rel=1e-6)
    assert (between[:, 0] <= sides).all()
    assert (sides <= between[:, 1]).all()
    assert between[:, 1] == pytest.approx(between[:, 0], rel=1e-4)


@pytest.mark.parametrize("model", ["linear", "exact"])
@pytest.mark.parametrize(("stroke", "low", "high"), [
    ("8 deg", -8.0, 8.0), ("[0 deg, 8 deg]", 0.0, 8.0), ("[3 deg, 8 deg]", 0.0, 8.0),
    ("[-2 deg, 9 deg]", -2.0, 9.0),
])  # fmt: skip
def test_long_arms_stay_in_the_range_over_strokes_of_any_mean(model, stroke, low, high):
    travels = radians(1.0) * np.linspace(low, high, 401)
    _, between = box(TIP.replace("8 deg", stroke), model)
    assert holds(between, tip_box(travels))


@pytest.mark.parametrize("element", ["rod", "blade"])
def test_a_drawing_turned_in_space_stays_in_its_range(element):
    # turned about (1, 2, 3) by 0.7 rad
    way, angle = np.array([1.0, 2.0, 3.0]) / np.sqrt(14.0), 0.7
    K = np.cross(way, np.eye(3), axisb=0, axisc=0)
    R = np.eye(3) + sin(angle) * K + (1.0 - cos(angle)) * K @ K

    def numbers(x, unit):
        return "[" + ", ".join(f"{each!r}{unit}" for each in (R @ x).tolist()) + "]"

    end, up = numbers(np.array([0.04, 0.0, 0.0]), " m"), numbers(np.array([0.0, 0.0, 1.0]), "")
    size = "d: 0.3 mm" if element == "rod" else f"h: 0.3 mm, b: 4 mm, width: {up}"
    text = f"""flexure: 1
material: {{youngs_modulus: 114 GPa, yield_strength: 800 MPa, poisson_ratio: 0.34}}
geometry:
  kind: space-layout
  bodies: {{tip: {{at: {end}}}}}
  {element}s:
    one: {{between: [ground, tip], from: [0 mm, 0 mm, 0 mm], to: {end}, {size}}}
  moving: tip
  motion: {{rotation: {{about: {up}}}}}
cases: {{op: {{stroke: {{rotation: [-2 deg, 9 deg]}}}}}}
requirements: {{envelope: [1 m, 1 m, 1 m]}}
"""
    points, s = [], PLACES[:, None]
    for theta in radians(1.0) * np.linspace(-2.0, 9.0, 81):
        phi, half = theta * s, theta * s / 2.0
        chord = 40e-3 * s * np.sinc(half / np.pi)
        none = 0.0 * s
        line = np.hstack([chord * np.cos(half), chord * np.sin(half), none]) @ R.T
        along = np.hstack([np.cos(phi), np.sin(phi), none]) @ R.T
        across = np.hstack([-np.sin(phi), np.cos(phi), none]) @ R.T
        round_ = np.sqrt(np.maximum(1.0 - along**2, 0.0))
        for i in (1.0, -1.0):
            for k in (1.0, -1.0):
                strip = i * across * 0.15e-3 + k * 2e-3 * R[:, 2]
                points.append(line + (i * round_ * 0.15e-3 if element == "rod" else strip))
    reach = np.ptp(np.concatenate(points), axis=0)
    for model in ("linear", "exact"):
        _, between = box(text, model)
        assert (between[:, 0] <= reach).all()
        assert (reach <= between[:, 1]).all()
        assert between[:, 1] == pytest.approx(between[:, 0], rel=0.05)


def test_what_a_guide_keeps_upright_is_judged_by_beams():
    text = (
        BARE[: BARE.index("geometry:")]
        + """
geometry: {kind: guided-blade, l: 40 mm, h: 0.2 mm, b: 5 mm}
cases: {op: {stroke: {translation: 3 mm}}}
requirements: {envelope: [7 mm, 41 mm, 6 mm]}
"""
    )
    rows = [row for row in flexcli.check(text).checks if "envelope" in row.name]
    assert {row.model for row in rows} == {"exact"}
    # its end stays upright: both strokes and its thickness
    assert rows[0].demand == pytest.approx(6.2e-3, rel=1e-6)


def test_beams_know_a_blade_bent_far():
    travels = np.linspace(-radians(30.0), radians(30.0), 401)
    for text, corners in ((TIP, True), (BARE, False)):
        sides, between = box(text.replace("8 deg", "30 deg"), "exact")
        expected = tip_box(travels, corners=corners)
        assert holds(between, expected)
        assert sides[:2] == pytest.approx(expected, rel=1e-3)


@pytest.mark.parametrize("stroke", ["8 deg", "[0 deg, 8 deg]"])
def test_a_hinge_kinks_where_it_is_thin(stroke):
    low = 0.0 if "[" in stroke else -8.0
    travels = radians(1.0) * np.linspace(low, 8.0, 201)

    h = 0.2e-3 + 4e-3 * (1.0 - np.sqrt(np.maximum(1.0 - (2.0 * PLACES - 1.0) ** 2, 0.0)))

    def notched(s):
        soft = np.append(0.0, np.cumsum((h[1:] ** -3 + h[:-1] ** -3) / 2.0))
        return soft / soft[-1]

    def necked(s):
        return (np.minimum(s, 0.1) + np.maximum(s - 0.9, 0.0)) / 0.2

    for text, thickness, share in ((NECKED, 0.3e-3, necked), (NOTCHED, h, notched)):
        sides, between = box(text.replace("8 deg", stroke), "linear")
        expected = tip_box(travels, thickness, corners=False, share=share)
        assert holds(between, expected)
        assert sides[:2] == pytest.approx(expected, rel=0.01)


@pytest.mark.parametrize("model", ["linear", "exact"])
def test_a_moment_without_a_stroke_moves_it_either_way(model):
    # M l/(E I), 10°
    moment = radians(10.0) * 114e9 * 2e-3 * 0.3e-3**3 / 12.0 / 40e-3
    text = TIP.replace("stroke: {rotation: 8 deg}", f"wrench: {{theta_z: {moment!r} N*m}}")
    _, between = box(text, model)
    expected = tip_box(np.linspace(-radians(10.0), radians(10.0), 201))
    assert holds(between, expected)
    assert (between[:2, 1] <= 1.15 * expected).all()
    assert "under its wrench" in flexcli.check(text, model=model).checks[0].quantity


@pytest.mark.parametrize("model", ["linear", "exact"])
def test_loads_beside_a_stroke_move_it_further(model):
    moment = radians(3.0) * 114e9 * 2e-3 * 0.3e-3**3 / 12.0 / 40e-3
    both = f"stroke: {{rotation: 6 deg}}, wrench: {{theta_z: {moment!r} N*m}}"
    _, between = box(TIP.replace("stroke: {rotation: 8 deg}", both), model)
    assert holds(between, tip_box(np.linspace(-radians(9.0), radians(9.0), 201)))


@pytest.mark.parametrize("model", ["linear", "exact"])
def test_a_temperature_makes_it_grow(model):
    text = STAGE.replace("{wrench: {y: 1 N}}", "{temperature: {uniform: 50 K}}")
    _, between = box(text, model)
    grown = (1.0 + 8.6e-6 * 50.0) * np.array([20e-3 + 0.2e-3, 40e-3, 5e-3])
    assert (between[:, 0] <= grown).all()
    assert (grown <= between[:, 1]).all()


@pytest.mark.parametrize("model", ["linear", "exact"])
def test_over_a_stroke_it_grows_by_what_the_body_moves(model):
    sides, between = box(GUIDE, model)
    expected = [45e-3, 30e-3 + 2 * 2e-3, 8e-3]
    # the stage comes back by 0.6 x²/l = 60 µm, on the side where the box ends at rest
    assert sides == pytest.approx(expected, rel=1e-3)
    assert (between[:, 0] <= expected).all()
    assert (between[:, 1] >= np.multiply(expected, 1.0 - 1e-9)).all()


def test_a_corner_that_turns_reaches_as_far_as_it_turns():
    turn, radius, corner = radians(10.0), hypot(15e-3, 5e-3), atan2(5.0, 15.0)
    expected = [2.0 * radius * cos(corner - turn), 2.0 * radius * sin(corner + turn), 4e-3]
    small, between = box(CROSS, "linear")
    beams, _ = box(CROSS, "exact")
    # the axis drifts by some 40 µm, which small motion knows to second order
    assert small == pytest.approx(expected, abs=0.1e-3)
    assert (between[:, 0] <= beams).all()
    assert (beams <= between[:, 1]).all()
    assert between[:2, 1] == pytest.approx(between[:2, 0], rel=0.01)
    assert between[2] == pytest.approx([4e-3, 4e-3], rel=1e-9)


def test_bent_blades_stay_within_the_box_and_its_doubt():
    text = CROSS.replace(", box: [30 mm, 10 mm, 4 mm]", "").replace("10 deg", "20 deg")
    _, between = box(text, "exact")
    layout = flexcli.load(text).part.geometry.layout(
        flexcli.load(text).part.material.elastic, flexcli.load(text).part.fixed_sizes()
    )
    lines = []
    for turn in np.linspace(-radians(20.0), radians(20.0), 5):
        state = solve(layout, {"moving": (None, None, np.array([turn]))}).checked()
        lines += [centre_line(state, name).place[0] for name in ("one", "two")]
    points = np.concatenate(lines)
    reach = points.max(axis=0) - points.min(axis=0)
    # half a thickness on either side
    assert (reach <= between[:2, 1]).all()
    assert (reach + 0.2e-3 >= between[:2, 0]).all()


def test_what_has_no_outline_is_told():
    text = CROSS.replace(", box: [30 mm, 10 mm, 4 mm]", "")
    assert "without the outline of moving" in flexcli.check(text).checks[0].quantity
    assert "without" not in flexcli.check(CROSS).checks[0].quantity
    assert "the thick middle of one" in flexcli.check(NECKED).checks[0].quantity
    shaken = GUIDE.replace("2 mm}", "2 mm}, asd: {profile: gevs-acceptance, q: 50}")
    assert "without the motion by its asd" in flexcli.check(shaken).checks[0].quantity


def test_a_box_too_long_fails_and_a_list_of_boxes_is_by_case():
    found = flexcli.check(GUIDE.replace("[50 mm, 40 mm", "[50 mm, 33 mm"))
    assert [row.verdict for row in found.checks if row.name == "envelope y (max)"] == [Verdict.FAIL]
    listed = "[{sides: [50 mm, 40 mm, 10 mm], cases: [op]}]"
    assert flexcli.check(GUIDE.replace("[50 mm, 40 mm, 10 mm]", listed)).checks


@pytest.mark.slow
def test_a_layout_is_sized_by_its_envelope():
    text = GUIDE.replace("l: 40 mm", "l: {free: [20 mm, 80 mm]}") + "model: linear\n"
    text = text.replace("{envelope", "{yield: 1.5, envelope")
    found = flexcli.size(text + "size: {objective: {maximize: l}}\n")
    assert found.status is Status.PASS
    # the blades, and half of the stage beyond them, to within the doubt of small motion
    assert found.values["l"].value == pytest.approx(45e-3, rel=0.015)
    assert found.values["l"].value < 45e-3


def test_a_stage_is_sized_to_stay_in_its_box():
    box = ["50 mm", "40 mm", "10 mm"]
    free = {"h": {"free": ["0.05 mm", "1 mm"]}, "l": {"free": ["5 mm", "60 mm"]}}
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": "114 GPa", "yield_strength": "800 MPa",
                     "poisson_ratio": 0.34, "density": "4430 kg/m^3"},
        "geometry": {"kind": "leaf-spring-stage", "spacing": "30 mm", "b": "5 mm", **free},
        "cases": {"work": {"stroke": {"translation": "0.5 mm"}}},
        "requirements": {"yield": 1.5, "stiffness": {"max": "5 N/mm"}, "envelope": box},
        "size": {"objective": {"minimize": "mass"}},
    }  # fmt: skip
    result = flexcli.size(yaml.safe_dump(spec))
    assert result.status is Status.PASS
    assert sum(check.name.startswith("envelope") for check in result.checks) == 3
