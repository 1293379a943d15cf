"""What heat does to a stage that an actuator of another expansion holds, and CalculiX's word."""

import shutil
import subprocess
from itertools import product

import numpy as np
import pytest

import flexcli
from flexcli.engine.solid.calculix import run
from flexcli.formulas.handbook.actuator import thermal_stroke

ACTUATED = """
flexure: 1
material: {youngs_modulus: 114 GPa, poisson_ratio: 0.3, thermal_expansion: 9e-6 1/K,
           yield_strength: 800 MPa}
geometry:
  kind: layout
  bodies:
    actuator: {at: [5 mm, 0 mm]}
    stage: {at: [30 mm, 0 mm]}
  blades:
    foot: {between: [ground, actuator], from: [0 mm, 0 mm], to: [5 mm, 0 mm], h: 0.5 mm, b: 5 mm}
    head: {between: [actuator, stage], from: [25 mm, 0 mm], to: [30 mm, 0 mm], h: 0.5 mm, b: 5 mm}
    left: {between: [ground, stage], from: [30 mm, -40 mm], to: [30 mm, -10 mm], h: 0.4 mm, b: 5 mm}
    right: {between: [ground, stage], from: [50 mm, -40 mm], to: [50 mm, -10 mm],
            h: 0.4 mm, b: 5 mm}
  moving: stage
  motion: {translation: 0 deg}
cases: {hot: {temperature: {uniform: 20 K, expansion: {actuator: -5e-6 1/K, ground: 23.6e-6 1/K,
                                                       stage: 23.6e-6 1/K}}}}
requirements: {yield: 1, buckling: 1.5}
"""


def test_heat_moves_an_actuated_stage_by_what_two_springs_in_series_leave():
    """The frame grows under the stage, and the actuator with its hinges does not follow."""
    E, dT = 114e9, 20.0
    moved = flexcli.check(ACTUATED).values["x_hot"].value
    hinge, guide = E * 5e-3 * 0.5e-3 / 5e-3, 2.0 * 12.0 * E * 5e-3 * 0.4e-3**3 / 12.0 / 30e-3**3
    # the column of actuator and hinges, 30 mm long, against the frame from the origin to the stage
    column = (2.0 * 9e-6 * 5e-3 - 5e-6 * 20e-3) / 30e-3
    told = thermal_stroke(
        alpha=column, alpha_frame=23.6e-6, L=30e-3, dT=dT, k_T=hinge / 2.0, k=guide
    )
    # told is against the frame, moved from where the stage stood at assembly; the guides turn the
    # stage a little, and what clamps hold across is in no spring
    assert moved == pytest.approx(told + 23.6e-6 * dT * 30e-3, abs=1e-3 * abs(told))


BRIDGE = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, thermal_expansion: 9e-6 1/K}}
geometry:
  kind: layout
  bodies: {{stage: {{at: [0 mm, 0 mm]}}}}
  blades:
    left: {{between: [ground, stage], from: [-{l} mm, 0 mm], to: [0 mm, 0 mm],
           h: {h} mm, b: {b} mm}}
    right: {{between: [stage, ground], from: [0 mm, 0 mm], to: [{l} mm, 0 mm],
            h: {h} mm, b: {b} mm}}
  moving: stage
  motion: {{translation: 90 deg}}
cases: {{hot: {{ends: clamped-clamped, temperature: {{uniform: {change} K,
        expansion: {{ground: 0 1/K, stage: 0 1/K}}}}}}}}
requirements: {{buckling: 1}}
"""
"""Two strips between a stage that neither turns nor moves aside, and walls that stay cold."""

DECK = """*NODE, NSET=ALL
{nodes}
*ELEMENT, TYPE=C3D20R, ELSET=BLADE
{elements}
*MATERIAL, NAME=M
*ELASTIC
{E}, {nu}
*EXPANSION
{alpha}
*DENSITY
4430.
*SOLID SECTION, ELSET=BLADE, MATERIAL=M
*INITIAL CONDITIONS, TYPE=TEMPERATURE
ALL, 0.
*BOUNDARY
START, 1, 3
END, 1, 3
*STEP, NLGEOM
*STATIC
*TEMPERATURE
ALL, {change}
*END STEP
*STEP, PERTURBATION
*FREQUENCY
1
*END STEP
"""


def bricks(xs, ys, zs, is_solid=lambda i, j: True):
    """Return nodes and C3D20R elements, by their cells, between planes, where there is a solid."""
    place, rows = {}, {}

    def at(i, j, k):
        return place.setdefault((i, j, k), len(place) + 1)

    for cell in product(*(range(len(planes) - 1) for planes in (xs, ys, zs))):
        if not is_solid(*cell[:2]):
            continue
        x, y, z = (2 * index for index in cell)
        low = [(x, y, z), (x + 2, y, z), (x + 2, y + 2, z), (x, y + 2, z)]
        mid = [
            tuple((m + n) // 2 for m, n in zip(low[s], low[(s + 1) % 4], strict=True))
            for s in range(4)
        ]
        high, top = ([(p, q, r + 2) for p, q, r in each] for each in (low, mid))
        up = [(p, q, r + 1) for p, q, r in low]
        rows[cell] = [at(*each) for each in (*low, *high, *mid, *top, *up)]
    halves = [np.interp(np.arange(2 * len(p) - 1) / 2, np.arange(len(p)), p) for p in (xs, ys, zs)]
    nodes = {
        number: tuple(float(half[n]) for half, n in zip(halves, index, strict=True))
        for index, number in place.items()
    }
    return nodes, rows


def listed(nodes):
    """Return the lines of nodes."""
    return "\n".join(f"{n}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in nodes.items())


def elements_of(rows, first=1):
    """Return the lines of elements, numbered from ``first`` on."""
    return "\n".join(
        f"{e}, " + ", ".join(map(str, row[:10])) + ",\n" + ", ".join(map(str, row[10:]))
        for e, row in enumerate(rows, first)
    )


def set_of(name, members):
    """Return the lines of a set of nodes."""
    return f"*NSET, NSET={name}\n" + "\n".join(f"{n}," for n in members) + "\n"


@pytest.mark.calculix
@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
def test_solids_buckle_at_the_temperature_that_is_told(tmp_path):
    """Bricks between two walls, against the bridge of two such strips, its stage held."""
    l, h, b, alpha, E, nu = 40e-3, 0.4e-3, 2e-3, 9e-6, 114e9, 0.3
    spec = BRIDGE.format(l=l * 1e3, h=h * 1e3, b=b * 1e3, change=10.0)
    (told,) = flexcli.check(spec).checks
    nodes, rows = bricks(np.linspace(0.0, l, 21), [0.0, h], [0.0, b / 2.0, b])
    sets = "".join(
        set_of(name, [n for n, place in nodes.items() if np.isclose(place[0], x)])
        for name, x in (("START", 0.0), ("END", l))
    )
    shares, squares = (0.8, 0.9), []
    for share in shares:
        text = DECK.format(
            nodes=listed(nodes),
            elements=elements_of(rows.values()),
            E=E,
            nu=nu,
            alpha=alpha,
            change=share * told.factor * 10.0,
        )
        (tmp_path / "strip.inp").write_text(text.replace("*MATERIAL", sets + "*MATERIAL", 1))
        subprocess.run(["ccx", "strip"], cwd=tmp_path, check=True, capture_output=True, timeout=120)
        lines = (tmp_path / "strip.dat").read_text().splitlines()
        squares.append(next(float(x.split()[1]) for x in lines if x.split()[:1] == ["1"]))
    # ω² falls to nothing at the critical temperature, in a straight line near it
    critical = shares[1] + squares[1] * (shares[1] - shares[0]) / (squares[0] - squares[1])
    low, high = (end / told.factor for end in told.factor_range)
    assert low < critical < high
    assert critical == pytest.approx(1.0, abs=0.02)


WALLS = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, thermal_expansion: 9e-6 1/K,
           density: 4430 kg/m^3}}
geometry:
  kind: space-layout
  bodies: {{stage: {{at: [0 mm, 0 mm, 0 mm], mass: 1 kg,
                    inertia: [1e-6 kg*m^2, 1e-6 kg*m^2, 1e-6 kg*m^2]}}}}
  blades: {{strip: {{between: [ground, stage], from: [-20 mm, 0 mm, 0 mm], to: [0 mm, 0 mm, 0 mm],
                    h: {h} mm, b: {b} mm, width: z, mirror: [x]}}}}
  moving: stage
  motion: {{translation: y}}
cases: {{hot: {{temperature: {{uniform: {change} K, expansion: {{ground: 0 1/K, stage: 0 1/K}}}}}}}}
requirements: {{frequency: {{min: 1 Hz}}}}
"""
"""A heavy stage between two strips and walls: its frequency is that of their stiffness."""

PUSHED = """*STEP, NLGEOM
*STATIC
*BOUNDARY
END, 2, 2, {push}
*NODE PRINT, NSET=END, TOTALS=ONLY
RF
*END STEP
"""


@pytest.mark.calculix
@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
@pytest.mark.parametrize(("thick", "wide"), [(0.05, 0.2), (0.1, 0.3), (0.05, 1.5)])
def test_solids_of_thick_and_wide_blades_soften_in_heat_as_far_as_is_told(thick, wide):
    l, E, nu, alpha = 20e-3, 114e9, 0.3, 9e-6
    h, b, push = thick * l, wide * l, 2e-6
    # a fifth of the strain at which a strip between its walls buckles
    change = 0.2 * np.pi**2 * thick**2 / 3.0 / alpha
    checks = flexcli.check(WALLS.format(h=h * 1e3, b=b * 1e3, change=change)).checks
    cold, hot = (each for each in checks if each.name.startswith("frequency"))
    cuts = l * (1.0 - np.cos(np.linspace(0.0, np.pi, 25))) / 2.0
    nodes, rows = bricks(cuts, [0.0, h / 2.0, h], np.linspace(0.0, b, 5))
    sets = "".join(
        set_of(name, [n for n, place in nodes.items() if np.isclose(place[0], x)])
        for name, x in (("START", 0.0), ("END", l))
    )
    stiffness = []
    for warmer in (0.0, change):
        text = DECK.format(
            nodes=listed(nodes), elements=elements_of(rows.values()), E=E, nu=nu, alpha=alpha,
            change=warmer,
        )  # fmt: skip
        text = text.replace("*MATERIAL", sets + "*MATERIAL", 1)
        text = text[: text.index("*STEP, PERTURBATION")] + PUSHED.format(push=push)
        *_, last = (line.split() for line in run(text, "strip").dat.splitlines() if line.strip())
        stiffness.append(float(last[1]) / push)
    softer = (stiffness[1] / stiffness[0]) ** 0.5
    low, high = (end / hot.factor * hot.capacity / cold.capacity for end in hot.factor_range)
    assert low < softer < high
    assert high - low < 1.0 - softer


FRAME = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: 0.3, thermal_expansion: 9e-6 1/K,
           yield_strength: 800 MPa, over_temperature: {{
             youngs_modulus: {{points: [[100 K, 114 GPa], [500 K, 114 GPa]]}},
             yield_strength: {{points: [[100 K, 800 MPa], [500 K, 800 MPa]]}}}}}}
geometry:
  kind: layout
  bodies: {{stage: {{at: [0 mm, 20 mm]}}}}
  blades:
    left: {{between: [ground, stage], from: [-10 mm, 0 mm], to: [-10 mm, 20 mm],
           h: 0.4 mm, b: 0.8 mm}}
    right: {{between: [ground, stage], from: [10 mm, 0 mm], to: [10 mm, 20 mm],
            h: 0.4 mm, b: 0.8 mm}}
  moving: stage
  motion: {{translation: 0 deg}}
cases: {{hot: {{temperature: {{{change}, expansion: {{stage: {stage} 1/K, ground: 0 1/K}}}}}}}}
requirements: {{yield: 1}}
"""
"""A stage on two blades, which it spreads where it grows, and leans on where one is longer."""

FRAME_DECK = """*NODE, NSET=ALL
{nodes}
*ELEMENT, TYPE=C3D20R, ELSET=BLADES
{blades}
*ELEMENT, TYPE=C3D20R, ELSET=STAGE
{stage}
{fixed}*MATERIAL, NAME=OURS
*ELASTIC
114e9, 0.3
*EXPANSION
9e-6
*MATERIAL, NAME=STIFF
*ELASTIC
114e12, 0.3
*EXPANSION
{alpha}
*SOLID SECTION, ELSET=BLADES, MATERIAL=OURS
*SOLID SECTION, ELSET=STAGE, MATERIAL=STIFF
*INITIAL CONDITIONS, TYPE=TEMPERATURE
ALL, 0.
*BOUNDARY
FIXED, 1, 3
*STEP, NLGEOM
*STATIC
*TEMPERATURE
{warm}
*NODE FILE
U
*EL FILE
S
*END STEP
"""


@pytest.mark.calculix
@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
@pytest.mark.parametrize(
    ("uniform", "slope", "stage"), [(100.0, 0.0, 24e-6), (-100.0, 0.0, 0.0), (100.0, 2e3, 0.0)]
)
def test_solids_bend_and_move_as_the_temperature_is_told_to(uniform, slope, stage):
    """Blades and stage in bricks, each node as warm as its place."""
    apart, l, h, b = 20e-3, 20e-3, 0.4e-3, 0.8e-3
    change = f"uniform: {uniform} K"
    if slope:
        change += f", gradient: {{x: {slope} K/m}}"
    result = flexcli.check(FRAME.format(change=change, stage=stage))
    told = next(check for check in result.checks if "held across" not in check.name)
    values = result.values
    inner, outer = (apart - h) / 2.0, (apart + h) / 2.0
    cuts = 32
    # short bricks at the clamps
    ys = [*(l * (1.0 - np.cos(np.linspace(0.0, np.pi, cuts + 1))) / 2.0), l + 2e-3, l + 4e-3]
    nodes, rows = bricks(
        [-outer, -apart / 2.0, -inner, 0.0, inner, apart / 2.0, outer], ys, [0.0, b / 2.0, b],
        lambda i, j: j >= cuts or i in (0, 1, 4, 5),
    )  # fmt: skip
    of_blades = [row for cell, row in rows.items() if cell[1] < cuts]
    of_stage = [row for cell, row in rows.items() if cell[1] >= cuts]
    text = FRAME_DECK.format(
        nodes=listed(nodes),
        blades=elements_of(of_blades),
        stage=elements_of(of_stage, len(of_blades) + 1),
        fixed=set_of("FIXED", [n for n, place in nodes.items() if place[1] == 0.0]),
        alpha=stage,
        warm="\n".join(f"{n}, {uniform + slope * x:.12g}" for n, (x, _, _) in nodes.items()),
    )
    solid = run(text, "frame")
    (moved,), (stress,) = solid.fields("DISP"), solid.fields("STRESS")
    left, centre, right = (
        np.mean([moved[n] for n, place in nodes.items() if np.allclose(place[:2], (x, l))], axis=0)
        for x in (-inner, 0.0, inner)
    )
    turned = (right[1] - left[1]) / (2.0 * inner)
    # clamps keep the blades from growing across, which adds ν α ΔT over a thickness or so of length
    near, none = 0.01, 1e-9
    assert values["x_hot"].value == pytest.approx(centre[0], rel=near, abs=none)
    assert values["y_hot"].value == pytest.approx(centre[1], rel=near, abs=none)
    assert values["theta_hot"].value == pytest.approx(turned, rel=near, abs=none / apart)
    # bending and pull are straight lines along a blade, which its clamps do not follow
    worst = 0.0
    for face in (-outer, -inner, inner, outer):
        along = np.array(
            [
                (place[1], stress[n][1])
                for n, place in nodes.items()
                if np.isclose(place[0], face) and 0.25 * l < place[1] < 0.75 * l
            ]
        )
        worst = max(worst, *np.abs(np.polyval(np.polyfit(*along.T, 1), (0.0, l))))
    # what clamps leave where nothing else strains: a ten-thousandth of the stress of held blades
    left_over = 1e-4 * 114e9 * 9e-6 * 100.0
    low, high = (told.capacity / factor for factor in reversed(told.factor_range))
    assert low - left_over < worst < high + left_over


HELD = """
flexure: 1
material: {{youngs_modulus: 114 GPa, poisson_ratio: {nu}, thermal_expansion: 9e-6 1/K,
           yield_strength: 800 MPa, over_temperature: {{
             youngs_modulus: {{points: [[100 K, 114 GPa], [500 K, 114 GPa]]}},
             yield_strength: {{points: [[100 K, 800 MPa], [500 K, 800 MPa]]}}}}}}
geometry: {{kind: leaf-spring-stage, h: 1 mm, l: {l} mm, b: {b} mm, spacing: 40 mm, blades: 2,
           clamps: rigid}}
cases: {{hot: {{{stroke}temperature: {{uniform: 100 K,
        expansion: {{moving: 0 1/K, ground: 0 1/K}}}}}}}}
requirements: {{yield: 1}}
"""
"""A stage whose bodies do not grow, so that clamps hold its blades alone."""

HELD_DECK = """*NODE, NSET=ALL
{nodes}
*ELEMENT, TYPE=C3D20R, ELSET=BLADE
{elements}
*MATERIAL, NAME=M
*ELASTIC
114e9, {nu}
*SOLID SECTION, ELSET=BLADE, MATERIAL=M
"""

HELD_STEP = """*STEP
*STATIC
*BOUNDARY, OP=NEW
{fixed}
*NODE FILE
RF
*EL FILE
S
*END STEP
"""


def towards(end, first, cells):
    """Return planes from 0 to an end, of cells that grow evenly from the first one there on."""
    growth = np.linspace(0.0, 1.0, cells + 1)
    power = np.log(first / end) / np.log(1.0 - growth[-2])
    return end * (1.0 - (1.0 - growth) ** power)


def held_solid(h, b, l, nu, strain, shift):
    """Return places, and stresses beside an S by a shift of one sign and the other, of an eighth.

    Linear solids that clamps hold across, free to grow along, and bent: x from a clamp on, y across
    the thickness, z across the width. Stresses are (signs, nodes, components).
    """
    xs, ys, zs = (towards(end, 0.02 * h, n) for end, n in ((l / 2, 14), (h / 2, 7), (b / 2, 12)))
    nodes, rows = bricks(l / 2 - xs[::-1], ys, zs)
    ids, places = np.array(list(nodes)), np.array(list(nodes.values()))
    start, middle, low, inner = (
        ids[np.isclose(places[:, axis], at, atol=1e-9)]
        for axis, at in ((0, 0.0), (0, l / 2), (1, 0.0), (2, 0.0))
    )

    def step(*fixed):
        known = {(node, axis): find(nodes[node]) for who, axis, find in fixed for node in who}
        lines = (f"{node}, {axis}, {axis}, {at:.12g}" for (node, axis), at in known.items())
        return HELD_STEP.format(fixed="\n".join(lines))

    def none(_):
        return 0.0

    even = (low, 2, none), (inner, 3, none), (middle, 1, none)
    odd = (low, 1, none), (low, 3, none), (inner, 3, none), (middle, 2, none), (middle, 3, none)
    text = HELD_DECK.format(nodes=listed(nodes), elements=elements_of(rows.values()), nu=nu)
    text += step(
        *even, (start, 1, none), (start, 2, lambda at: -strain * at[1]),
        (start, 3, lambda at: -strain * at[2]),
    )  # fmt: skip
    text += step(*even, (start, 1, lambda at: -strain * l), (start, 2, none), (start, 3, none))
    text += step(*odd, (start, 1, none), (start, 2, lambda at: shift / 2.0), (start, 3, none))
    solid = run(text, "held")
    held, pulled, bent = (np.array([each[n] for n in ids]) for each in solid.fields("STRESS"))
    along, by_pull, _ = (sum(each[n][0] for n in start) for each in solid.fields("FORC"))
    free = held - along / by_pull * pulled
    return places, np.array([free + bent, free - bent])


def von_mises(stress):
    xx, yy, zz, *sheared = np.moveaxis(stress, -1, 0)
    apart = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(apart / 2.0 + 3.0 * sum(each**2 for each in sheared))


@pytest.mark.calculix
@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
@pytest.mark.parametrize(
    ("b", "l", "nu", "stroke"),
    [(3.0, 24.0, 0.2, 0.0), (6.0, 20.0, 0.4, 0.25), (20.0, 12.0, 0.3, 0.02)],
)
def test_solids_that_clamps_hold_are_stressed_as_far_as_is_told(b, l, nu, stroke):
    """All of a blade but the edges at its clamp, which are singular, warm and bent to an S."""
    moved = f"stroke: {{translation: {stroke} mm}}, " if stroke else ""
    checks = flexcli.check(HELD.format(b=b, l=l, nu=nu, stroke=moved)).checks
    told = next(check for check in checks if "held across" in check.name)
    h = 1.0
    places, stress = held_solid(h, b, l, nu, 9e-6 * 100.0, stroke)
    x, to_face, to_side = places[:, 0], h / 2.0 - places[:, 1], b / 2.0 - places[:, 2]
    inner = (np.hypot(x, to_face) >= 0.25 * h) & (np.hypot(x, to_side) >= max(h / 2.0, b / 40.0))
    found = von_mises(stress)
    worst, (amid,) = found[:, inner].max(), np.flatnonzero(~places.any(axis=1))
    least, most = (told.capacity / factor for factor in reversed(told.factor_range))
    assert least < worst < most
    # it is no bound alone: more than two thirds of it are there
    assert worst > 0.67 * most
    if not stroke:
        assert found[0, amid] == pytest.approx(told.demand, rel=0.03)
    # the bound of a plate whose clamp holds its width is less than what is there
    assert worst > 114e9 * 9e-4 / (1.0 - nu**2)


WARM = """
flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 10 mm, spacing: 20 mm, blades: 2}
cases: {c: {stroke: {translation: 0.5 mm, cycles: 1e5}, temperature: {bodies: {moving: 400 K}}}}
requirements: {yield: 1}
"""


def test_the_plan_tells_what_expansion_changes_and_the_audit_agrees():
    result = flexcli.plan(WARM, audit=True)
    (row,) = (row for row in result.plan.effects if row.name == "expansion")
    (true,) = (row for row in result.audit if row.effect == "expansion")
    # linear blades against exact ones: of an estimate no more is asked than its size
    assert row.estimates["stress"] == pytest.approx(true.true, rel=0.1)
    # no closed form and no linear model has it
    assert result.plan.model == "exact"


def test_a_spec_may_leave_expansion_out():
    without = flexcli.check(WARM + "effects: {expansion: off}\n").checks[0]
    never = flexcli.check(WARM.replace(", temperature: {bodies: {moving: 400 K}}", "")).checks[0]
    assert without.demand == pytest.approx(never.demand)
