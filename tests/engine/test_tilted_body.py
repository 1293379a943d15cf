"""Pivots whose blades stand side by side: the body tilts, against frames in space."""

import numpy as np
import pytest
import yaml
from space_frame import Beam, Frame, beam_matrix
from twins.drawn_in_space import in_space

import flexcli
from flexcli.formulas.sheet_factors import held_growth

E, NU, L = 200e9, 0.3, 20e-3
G = E / 2.0 / (1.0 + NU)


def spec(h, b, delta, degrees, case, requirements, **geometry):
    """Return the text of a cross-spring, sizes in m."""
    joint = {
        "kind": "cross-spring", "h": f"{h!r} m", "l": f"{L} m", "b": f"{b!r} m",
        "delta": delta, "half_angle": f"{degrees} deg", **geometry,
    }  # fmt: skip
    material = {
        "youngs_modulus": f"{E} Pa", "poisson_ratio": NU, "yield_strength": "800 MPa",
        "fatigue_amplitude": {"value": "400 MPa", "cycles": 1e7, "stress_ratio": -1},
    }  # fmt: skip
    words = {"flexure": 1, "title": "cross-spring", "material": material, "geometry": joint}
    return yaml.safe_dump({**words, "cases": {"work": case}, "requirements": requirements})


def frame(h, b, delta, degrees, apart):
    """Return the pivot as two beams whose middle planes are apart, and each beam's own rows."""
    return star_frame(h, b, delta, (degrees, -degrees), (-apart / 2.0, apart / 2.0))


def blade_matrix(h, b):
    """Return the stiffness of a blade by the motions of its ends, along its axes."""
    J = b * h**3 / 3.0 * (1.0 - 0.63 * h / b)
    return beam_matrix(
        L, E * b * h, G * J, E * h * b**3 / 12.0, E * b * h**3 / 12.0,
        12.0 * E / (L**2 * 5.0 / 6.0 * G) * h**2 / 12.0,
        12.0 * E / (L**2 * 5.0 / 6.0 * G) * b**2 / 12.0,
    )  # fmt: skip


def star_frame(h, b, delta, directions, heights):
    """Return a pivot as beams in directions from x, at heights, and each beam's own rows."""
    matrix = blade_matrix(h, b)
    beams, rows = [], []
    for degrees, height in zip(directions, heights, strict=True):
        angle = np.radians(degrees)
        along = np.array([np.cos(angle), np.sin(angle), 0.0])
        axes = np.array([along, [-along[1], along[0], 0.0], [0.0, 0.0, 1.0]])
        up = np.array([0.0, 0.0, height])
        ends = delta * L * along + up, (delta + 1.0) * L * along + up
        beams.append(Beam(None, 0, *ends, axes, matrix))
        x, y, z = ends[1]
        rigid = np.eye(6)
        rigid[:3, 3:] = [[0, z, -y], [-z, 0, x], [y, -x, 0]]
        rows.append(matrix[:, 6:] @ np.kron(np.eye(2), axes) @ rigid)
    return Frame([(0.0, 0.0, 0.0)], beams), rows


def largest(rows, motion, h, b):
    """Return the largest normal stress at the ends of beams [Pa]."""
    found = 0.0
    for each in rows:
        for force in np.split(each @ motion, 2):
            axial, _, _, _, wide, thin = np.abs(force)
            found = max(found, axial / (b * h) + 6.0 * wide / (h * b**2) + 6.0 * thin / (b * h**2))
    return found


def drawn(text):
    """Return the text of a cross-spring as a drawn layout of its two blades."""
    words = yaml.safe_load(text)
    cross = words["geometry"]
    l, b = (float(cross[key].split()[0]) for key in ("l", "b"))
    blades = {}
    for name, side in (("one", 1.0), ("two", -1.0)):
        angle = side * np.radians(float(cross["half_angle"].split()[0]))
        ends = [[f"{float(r * each(angle))!r} m" for each in (np.cos, np.sin)]
                for r in (cross["delta"] * l, (1.0 + cross["delta"]) * l)]  # fmt: skip
        blades[name] = {
            "between": ["ground", "body"], "from": ends[0], "to": ends[1],
            "h": cross["h"], "b": cross["b"], "z": f"{-side * b / 2.0!r} m",
        }  # fmt: skip
    words["geometry"] = {
        "kind": "layout", "bodies": {"body": {"at": ["0 mm", "0 mm"]}}, "blades": blades,
        "moving": "body", "motion": "rotation", **{k: cross[k] for k in ("tilt",) if k in cross},
    }  # fmt: skip
    return yaml.safe_dump(words)


def turned(frame, theta):
    """Return the motion of the body that is turned about z, free otherwise."""
    motion = np.zeros(6)
    motion[5] = theta
    motion[:5] = np.linalg.solve(frame.K[:5, :5], -frame.K[:5, 5] * theta)
    return motion


@pytest.mark.parametrize(("delta", "degrees"), [(0.3, 45.0), (0.3, 15.0), (0.1, 60.0)])
def test_the_stiffness_is_that_of_a_body_that_may_tilt(delta, degrees):
    h, b = 1e-3, 2e-3
    case = {"stroke": {"rotation": "0.01 mrad", "cycles": 1e7}}
    side = spec(h, b, delta, degrees, case, {"stiffness": {"min": "1e-9 N*m/rad"}})
    upright = yaml.safe_load(side)
    upright["geometry"] |= {"kind": "rcc", "p": f"{upright['geometry'].pop('delta') * L} m"}
    told = [
        flexcli.check(text, model="linear").values["k_pivot"].value
        for text in (side, yaml.safe_dump(upright))
    ]
    true = []
    for apart in (b, 0.0):
        whole, _ = frame(h, b, delta, degrees, apart)
        true.append(float(whole.K[5] @ turned(whole, 1.0)))
    assert true[0] < 0.99 * true[1]
    assert told[0] / told[1] == pytest.approx(true[0] / true[1], rel=2e-3)


@pytest.mark.parametrize(("axis", "column"), [("x", 0), ("y", 1)])
def test_a_force_in_the_plane_tilts_the_body_and_its_stress_counts_so(axis, column):
    h, b, delta, degrees = 0.5e-3, 5e-3, -0.5, 60.0
    force = np.zeros(6)
    force[column] = 5.0
    (side, rows), (plane, alone) = (frame(h, b, delta, degrees, apart) for apart in (b, 0.0))
    true = float(largest(rows, np.linalg.solve(side.K, force), h, b))
    upright = largest(alone, np.linalg.solve(plane.K, force), h, b)
    assert true > 1.5 * upright
    case = {"wrench": {axis: "5 N"}}
    factor = 800e6 / true
    for required, verdict in ((0.85 * factor, "pass"), (1.2 * factor, "fail")):
        (check,) = flexcli.verdicts(
            spec(h, b, delta, degrees, case, {"yield": {"factor": required}})
        ).checks
        assert check.verdict == verdict, (check.factor_range, factor)
    (check,) = flexcli.verdicts(
        spec(h, b, delta, degrees, case, {"yield": {"factor": 1.2 * factor}}), model="closed-form"
    ).checks
    assert check.verdict != "pass"


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
def test_a_tilt_pulls_the_outer_blades_of_two_pairs_more(model):
    """Of two pairs that cross far off, a force along the bisector bends and pulls them apart."""
    h, b, delta, degrees = 0.02e-3, 4e-3, -2.0 / 3.0, 22.0
    turned = (degrees, -degrees, degrees, -degrees)
    side, rows = star_frame(h, b, delta, turned, (-1.5 * b, -0.5 * b, 0.5 * b, 1.5 * b))
    force = np.zeros(6)
    force[0] = 1e-6
    true = largest(rows, np.linalg.solve(side.K, force), h, b)
    text = spec(
        h, b, delta, degrees, {"wrench": {"x": "1e-6 N"}}, {"yield": {"factor": 1e-3}}, pairs=2
    )
    (told,) = flexcli.verdicts(text, model=model).checks
    low, high = told.factor_range
    assert 0.5 * 800e6 / true < low <= 800e6 / true <= high


@pytest.mark.parametrize("ends", ["clamped-free", "clamped-guided"])
@pytest.mark.parametrize("load", [{"load": {"force": "400 N", "direction": "180 deg"}},
                                  {"wrench": {"x": "-400 N"}}])  # fmt: skip
def test_blades_side_by_side_buckle_as_they_tilt_a_body_with_free_ends(ends, load):
    h, b, delta, degrees = 0.3e-3, L, -0.1, 30.0
    asked = {"buckling": {"factor": 0.1}}
    case = {**load, "ends": ends}
    free, held = (
        min(flexcli.verdicts(spec(h, b, delta, degrees, case, asked, tilt=tilt), model="exact")
            .checks, key=lambda check: check.factor)
        for tilt in ("free", "held")
    )  # fmt: skip
    if ends != "clamped-free":
        assert free.factor == pytest.approx(held.factor, rel=1e-9)
        return
    pushed = {"wrench": {"x": "-400 N"}}
    words = yaml.safe_load(spec(h, b, delta, degrees, pushed, {"yield": {"factor": 1.0}}))
    drawn = in_space(words, flexcli.load(yaml.safe_dump(words))) | {"requirements": asked}
    (true,) = flexcli.verdicts(yaml.safe_dump(drawn), model="exact").checks
    assert free.factor == pytest.approx(true.factor, rel=1e-6)
    assert free.factor < 0.7 * held.factor


@pytest.mark.parametrize(("delta", "rises"), [(-0.4, True), (0.1, False), (-1.2, False)])
def test_blades_of_a_star_that_cross_pass_side_by_side_and_tilt_its_body(delta, rises):
    h, b, directions = 0.5e-3, 5e-3, (0.0, 100.0, 220.0)
    heights = [rises * each for each in (-b, 0.0, b)]
    whole, rows = star_frame(h, b, delta, directions, heights)
    force = np.array([0.0, 20.0, 0.0, 0.0, 0.0, 0.0])
    moved = np.linalg.solve(whole.K, force)
    words = yaml.safe_load(spec(h, b, delta, 0.0, {"wrench": {"y": "20 N"}}, {}))
    del words["geometry"]["half_angle"]
    words["geometry"] |= {"kind": "star", "angles": [f"{each} deg" for each in directions]}
    words["requirements"] = {
        "yield": {"factor": 1.0}, "deflection": [{"direction": "y", "max": "1 m"}],
    }  # fmt: skip
    words["effects"] = {"warping": "off"}  # the beams of the frame warp freely
    stress, deflection = flexcli.verdicts(yaml.safe_dump(words), model="exact").checks
    true = float(largest(rows, moved, h, b))
    low, high = stress.factor_range
    assert low <= 800e6 / true <= high
    assert stress.factor == pytest.approx(800e6 / true, rel=5e-3)
    assert deflection.demand == pytest.approx(moved[1], rel=0.02)
    notes = flexcli.check(yaml.safe_dump(words)).warnings
    assert "blades-meet" not in {note.code for note in notes}
    words["geometry"]["tilt"] = "held"
    upright, _ = flexcli.verdicts(yaml.safe_dump(words), model="exact").checks
    if rises:
        assert upright.factor_range[0] > 800e6 / true
    else:
        assert upright.factor == pytest.approx(stress.factor, rel=1e-9)


@pytest.mark.parametrize(("delta", "directions"), [(-0.5, (45.0, -45.0, 45.0, -45.0)),
                                                   (-0.4, (0.0, 100.0, 220.0))])  # fmt: skip
def test_bodies_that_do_not_fit_tilt_and_their_stress_counts_so(delta, directions):
    """The body grows about its point: each blade's end goes out along it, and all are pulled."""
    h, b, warm = 0.5e-3, 5e-3, 2.0 * 12e-6
    heights = [(k - (len(directions) - 1) / 2.0) * b for k in range(len(directions))]
    whole, rows = star_frame(h, b, delta, directions, heights)
    matrix = blade_matrix(h, b)
    # clamps hold the blades' ends across by the mean of what both grow, which shortens them
    shorter = float(held_growth(b=b, h=h, l=L, poisson_ratio=NU)) / 2.0
    out = (1.0 + delta + shorter) * L
    outward = [warm * np.array([out, 0.0, z, 0.0, 0.0, 0.0]) for z in heights]
    # what holds the body where it is, by the virtual work of the blades' ends
    pull = sum(row[6:].T @ out for row, out in zip(rows, outward, strict=True))
    motion, found = np.linalg.solve(whole.K, -pull), 0.0
    for row, out in zip(rows, outward, strict=True):
        forces = row @ motion + matrix[:, 6:] @ out
        found = max(found, float(largest([np.eye(12)], forces, h, b)))
    case = {"temperature": {"bodies": {"moving": "2 K"}}}
    words = yaml.safe_load(spec(h, b, delta, 45.0, case, {"yield": {"factor": 1.0}}))
    words["material"]["thermal_expansion"] = "12e-6 1/K"
    if len(directions) == 4:
        words["geometry"]["pairs"] = 2
    else:
        del words["geometry"]["half_angle"]
        words["geometry"] |= {"kind": "star", "angles": [f"{each} deg" for each in directions]}
    checks = flexcli.verdicts(yaml.safe_dump(words)).checks
    low, high = next(c.factor_range for c in checks if c.name == "yield (yield-strength)")
    assert 0.99 * low <= 800e6 / found <= 1.01 * high
    # kept upright it is sheared by as much, and by more in its plane
    words["geometry"]["tilt"] = "held"
    checks = flexcli.verdicts(yaml.safe_dump(words)).checks
    held = next(c.factor_range for c in checks if c.name == "yield (yield-strength)")
    assert held[0] <= 1.01 * high


def test_a_stroke_of_blades_that_cross_in_the_middle_tilts_nothing():
    case, of = {"stroke": {"rotation": "0.1 deg", "cycles": 1e7}}, {"yield": {"factor": 1.0}}
    checks = [
        flexcli.verdicts(spec(0.8e-3, 5e-3, delta, 45.0, case, of), model="linear").checks[0]
        for delta in (-0.5, 0.0)
    ]
    widths = [high / low - 1.0 for low, high in (check.factor_range for check in checks)]
    assert widths[0] < 0.02 < widths[1] - widths[0]


@pytest.mark.parametrize(("of_case", "of_joint"), [({"ends": "clamped-guided"}, {}),
                                                    ({}, {"tilt": "held"})])  # fmt: skip
def test_what_is_stated_to_hold_the_body_keeps_it_upright(of_case, of_joint):
    case, of = {"wrench": {"x": "5 N"}}, {"yield": {"factor": 1e-3}}
    free, held = (
        flexcli.verdicts(
            spec(0.5e-3, 5e-3, -0.5, 60.0, case | more, of, **joint), model="exact"
        ).checks[0]
        for more, joint in (({}, {}), (of_case, of_joint))
    )
    assert held.factor > 1.4 * free.factor


def test_a_case_of_vibration_alone_has_the_stiffness_of_a_body_that_may_tilt():
    of = {"stiffness": {"min": "1e-9 N*m/rad"}, "dynamic-yield": {"factor": 1e-3}}
    words = yaml.safe_load(spec(1e-3, 2e-3, 0.3, 45.0, {}, of))
    words["mechanism"] = {"kind": "payload", "mass": "20 g", "inertia": "1e-6 kg*m^2"}
    told = []
    for case in ({"asd": {"profile": "gevs-qualification", "q": 50}},
                 {"stroke": {"rotation": "0.01 mrad", "cycles": 1e7}}):  # fmt: skip
        text = yaml.safe_dump(words | {"cases": {"work": case}})
        if "asd" not in case:
            text = text.replace("dynamic-yield", "yield")
        told.append(flexcli.check(text, model="linear").values["k_pivot"].value)
    assert told[0] == pytest.approx(told[1], rel=1e-6)


@pytest.mark.parametrize(("b", "delta", "degrees"), [(2e-3, 0.3, 15.0), (5e-3, 0.6, 10.0)])
def test_a_body_that_tilts_is_driven_by_less(b, delta, degrees):
    """As much less as frames are softer, whose blades widen alike."""
    h, theta = 0.5e-3, 1e-3
    efforts = [
        float((matrix := frame(h, b, delta, degrees, apart)[0]).K[5] @ turned(matrix, theta))
        for apart in (b, 0.0)
    ]
    found = []
    for tilt in ("free", "held"):
        case = {"stroke": {"rotation": f"{theta} rad"}}
        words = yaml.safe_load(spec(h, b, delta, degrees, case, {"drive": 1e-6}, tilt=tilt))
        words["actuator"] = {"blocking_force": "100 N", "free_stroke": "10 mm", "arm": "20 mm",
                             "drives": "both-ways"}  # fmt: skip
        found.append(flexcli.verdicts(yaml.safe_dump(words), model="exact").checks[0])
    free, held = found
    true = held.factor * efforts[1] / efforts[0]
    assert free.factor_range[0] <= true <= free.factor_range[1]
    assert true > held.factor_range[1]


@pytest.mark.parametrize(("delta", "tilt", "told"), [
    (-0.2, "free", True), (-0.2, "held", False), (-0.5, "free", False)
])  # fmt: skip
def test_a_shift_of_a_body_held_upright_says_what_a_tilt_would_add(delta, tilt, told):
    h, b, theta = 1e-3, 2e-3, 0.01
    case = {"stroke": {"rotation": f"{theta} rad", "cycles": 1e7}}
    of = {"parasitic_shift": {"max": "1 mm"}}
    notes = flexcli.check(spec(h, b, delta, 45.0, case, of, tilt=tilt)).warnings
    said = [note.text for note in notes if note.code == "held-upright"]
    assert bool(said) is told
    if told:
        free, upright = (frame(h, b, delta, 45.0, apart)[0] for apart in (b, 0.0))
        moved = float(np.hypot(*(turned(free, theta) - turned(upright, theta))[:2]))
        number = float(said[0].partition("moves by ")[2].split()[0])
        assert number == pytest.approx(moved, rel=0.03)


MASS, ABOUT = 0.1, 1e-5
PAYLOAD = {
    "kind": "payload", "mass": f"{MASS} kg", "damping": {"q": 50.0},
    "inertia": {"xx": f"{ABOUT} kg*m^2", "yy": f"{ABOUT} kg*m^2", "zz": f"{ABOUT} kg*m^2"},
}  # fmt: skip


def shaken(frame, rows, axis, f, Q, h, b):
    """Return the largest stress that a base moving by 1 m/s² at f makes, mode by mode [Pa]."""
    mass = np.diag([MASS] * 3 + [ABOUT] * 3)
    root = np.sqrt(np.diag(mass))
    squares, modes = np.linalg.eigh(frame.K / np.outer(root, root))
    omega, own = 2.0 * np.pi * f, np.sqrt(squares)
    gain = 1.0 / (own**2 - omega**2 + 1j * omega * own / Q)
    shapes = modes / root[:, None]
    motion = shapes @ (gain * (shapes.T @ mass[:, axis]))
    phases = np.exp(1j * np.linspace(0.0, np.pi, 73))
    return max(largest(rows, (motion * turn).real, h, b) for turn in phases)


@pytest.mark.parametrize("as_drawn", [False, True])
@pytest.mark.parametrize(("axis", "column"), [("x", 0), ("y", 1)])
@pytest.mark.parametrize("f", [20.0, 900.0])
def test_a_base_shaken_in_the_plane_tilts_the_body(axis, column, f, as_drawn):
    h, b, Q = 0.5e-3, 5e-3, PAYLOAD["damping"]["q"]
    side, rows = frame(h, b, -0.5, 45.0, b)
    plane, alone = frame(h, b, -0.5, 45.0, 0.0)
    true = shaken(side, rows, column, f, Q, h, b)
    upright = shaken(plane, alone, column, f, Q, h, b)
    assert true > 1.3 * upright
    sine = {"acceleration": "1 m/s^2", "frequency": f"{f} Hz", "axis": axis}
    words = yaml.safe_load(
        spec(h, b, -0.5, 45.0, {"sine": sine}, {"dynamic-yield": {"factor": 1.0}})
    )
    words["mechanism"], words["material"]["density"] = PAYLOAD, "1 kg/m^3"
    text = yaml.safe_dump(words)
    (check,) = flexcli.verdicts(drawn(text) if as_drawn else text, model="exact").checks
    # blades that clamps keep from warping are stiffer in torsion than the frame's
    assert check.demand == pytest.approx(true, rel=0.1)


def test_an_unstated_inertia_of_a_shaken_body_is_named_and_counts():
    case = {"sine": {"acceleration": "1 m/s^2", "frequency": "900 Hz", "axis": "x"}}
    words = yaml.safe_load(spec(0.5e-3, 5e-3, -0.5, 45.0, case, {"dynamic-yield": {"factor": 1.0}}))
    widths = []
    for inertia in (f"{ABOUT} kg*m^2", PAYLOAD["inertia"]):
        words["mechanism"] = {**PAYLOAD, "inertia": inertia}
        (check,) = flexcli.verdicts(yaml.safe_dump(words), model="exact").checks
        low, high = check.factor_range
        widths.append(high / low)
        words["requirements"]["dynamic-yield"]["factor"] = (low * high) ** 0.5
        notes = flexcli.check(yaml.safe_dump(words)).warnings
        assert ("needs-inertia" in {note.code for note in notes}) is (len(widths) == 1)
    assert widths[1] < 1.5 < widths[0]


def test_a_drawn_layout_of_blades_at_several_heights_tilts_as_the_pivot_does():
    h, b = 0.5e-3, 5e-3
    force = ({"wrench": {"x": "5 N"}}, {"yield": {"factor": 1.0}})
    stroke = {"stroke": {"rotation": "1 deg", "cycles": 1e7}}
    of = {"yield": {"factor": 1.0}, "stiffness": {"min": "1e-9 N*m/rad"}}
    for delta, (case, asked) in ((-0.5, force), (0.3, (stroke, of))):
        for tilt in ("free", "held"):
            text = spec(h, b, delta, 45.0, case, asked, tilt=tilt)
            pivot, layout = (flexcli.verdicts(t, model="exact").checks for t in (text, drawn(text)))
            for one, other in zip(pivot, layout, strict=True):
                assert other.demand == pytest.approx(one.demand, rel=2e-3)


def test_a_source_keeps_the_body_upright_under_vibration():
    case = {"asd": {"profile": "gevs-qualification", "q": 50}}
    words = yaml.safe_load(
        spec(0.5e-3, 5e-3, -0.5, 45.0, case, {"dynamic-yield": {"factor": 1e-3}})
    )
    words["mechanism"] = PAYLOAD
    told = []
    for tilt in ("free", "held"):
        words["geometry"]["tilt"] = tilt
        told.append(flexcli.verdicts(yaml.safe_dump(words), model="source").checks[0].demand)
    assert told[0] == pytest.approx(told[1], rel=1e-9)


@pytest.mark.parametrize(("delta", "tilt", "told"), [(0.3, "free", True), (0.3, "held", False),
                                                     (-0.5, "free", False)])  # fmt: skip
def test_a_simulated_sweep_says_that_it_keeps_the_body_upright(delta, tilt, told):
    case = {"stroke": {"rotation": "1 deg", "cycles": 1e7}}
    text = spec(0.5e-3, 5e-3, delta, 45.0, case, {"yield": {"factor": 1e-3}}, tilt=tilt)
    codes = {note.code for note in flexcli.simulate(text, points=3).warnings}
    assert ("held-upright" in codes) is told


@pytest.mark.parametrize("inertia", [f"{ABOUT} kg*m^2", PAYLOAD["inertia"]])
def test_a_frequency_reaches_down_to_the_mode_that_rocks_the_body(inertia):
    """A soft tilt is below the rotation, which it takes along where blades cross off the middle."""
    h, b, delta, degrees = 0.5e-3, 2e-3, 0.3, 45.0
    side, _ = frame(h, b, delta, degrees, b)
    root = np.sqrt(np.array([MASS] * 3 + [ABOUT] * 3))
    squares, modes = np.linalg.eigh(side.K / np.outer(root, root))
    shares = (modes[5] / root[5]) ** 2 / squares
    taking = squares[shares > 0.01 * shares.sum()]
    true = float(np.sqrt(taking[0])) / (2.0 * np.pi)
    case = {"stroke": {"rotation": "0.01 mrad", "cycles": 1e7}}
    words = yaml.safe_load(spec(h, b, delta, degrees, case, {"frequency": {"min": "1 Hz"}}))
    words["mechanism"] = {**PAYLOAD, "inertia": inertia}
    words["material"]["density"] = "1 kg/m^3"
    free, *_ = flexcli.verdicts(yaml.safe_dump(words), model="linear").checks
    words["geometry"]["tilt"] = "held"
    held, *_ = flexcli.verdicts(yaml.safe_dump(words), model="linear").checks
    assert true < 0.8 * held.factor_range[0]
    assert free.factor_range[0] < 1.02 * true
    assert free.factor_range[1] > 0.99 * held.factor
