"""Near the loads or the heat that buckle a joint: numbers of beams against CalculiX's solids.

What they bend of what is deformed grows without bound there, and so do its errors.
"""

import shutil

import pytest

import flexcli

calculix = [
    pytest.mark.calculix,
    pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed"),
]

SAME = """
material: {{youngs_modulus: 114 GPa, poisson_ratio: {nu}, thermal_expansion: 9e-6 1/K,
           density: 4430 kg/m^3, yield_strength: 800 MPa, over_temperature: {{
             youngs_modulus: {{points: [[100 K, 114 GPa], [900 K, 114 GPa]]}},
             yield_strength: {{points: [[100 K, 800 MPa], [900 K, 800 MPa]]}}}}}}
"""
"""A material that is the same at all temperatures."""

BRIDGE = """
flexure: 1
{material}
geometry:
  kind: {kind}
  bodies: {{stage: {{at: [0 mm, {d} mm{z}]}}}}
  blades:
    left: {{between: [ground, stage], from: [-22 mm, 0 mm{z}], to: [-2 mm, {d} mm{z}],
           h: 0.3 mm, b: {b} mm{width}}}
    right: {{between: [stage, ground], from: [2 mm, {d} mm{z}], to: [22 mm, 0 mm{z}],
            h: 0.3 mm, b: {b} mm{width}}}
  moving: stage
  motion: {{translation: {way}}}
cases: {{hot: {{temperature: {{uniform: {T} K, expansion: {{ground: 0 1/K, stage: 0 1/K}}}}}}}}
requirements: {{yield: 1, stiffness: {{min: 1 N/m}}}}
"""
"""Two blades that do not quite lie in a line between cold walls; straight they buckle at 20.6 K."""


def bridge(nu, b, d, T, *, in_space=False):
    words = {"kind": "layout", "z": "", "width": "", "way": "90 deg"}
    if in_space:
        words = {"kind": "space-layout", "z": ", 0 mm", "width": ", width: z", "way": "y"}
    return BRIDGE.format(material=SAME.format(nu=nu).strip(), b=b, d=d, T=T, **words)


def stress_of(text, **model):
    """Return the largest stress along blades, the range of it, by beams [Pa]."""
    rows = flexcli.verdicts(text, **model).checks
    row = next(row for row in rows if row.name == "yield (yield-strength)")
    return row.demand, tuple(row.capacity / factor for factor in reversed(row.factor_range))


def solids(text, name):
    """Return a number of a model and of solids, and by what share the mesh is unsure."""
    (found,) = flexcli.verify(text, only=(name,)).verification.numbers
    return found


@pytest.mark.parametrize(
    ("nu", "b", "d", "T", "apart"),
    [
        pytest.param(0.45, 4.0, 0.004, 20.0, -0.11, marks=calculix),
        pytest.param(0.3, 10.0, 0.01, 20.0, -0.071, marks=[*calculix, pytest.mark.slow]),
    ],
)
def test_the_stress_of_heat_near_thermal_buckling_is_in_its_range(nu, b, d, T, apart):
    text = bridge(nu, b, d, T)
    found = solids(text, "sigma")
    # as plates blades are stiffer than beams, which are nearer to buckling
    assert found.apart == pytest.approx(apart, abs=2.0 * found.solid_error)
    assert found.agrees
    largest, (low, high) = stress_of(text, model="exact")
    true = abs(found.solid) / found.model * largest
    assert low < true < high
    # beams in space have blades as wide as they are
    largest, (low, high) = stress_of(bridge(nu, b, d, T, in_space=True), model="exact")
    assert low < true < high
    near = (high - low) / largest
    _, (low, high) = stress_of(bridge(nu, b, d, T / 2.0, in_space=True), model="exact")
    far = (high - low) / stress_of(bridge(nu, b, d, T / 2.0, in_space=True), model="exact")[0]
    assert near > 3.0 * far


@pytest.mark.parametrize("T", [pytest.param(T, marks=calculix) for T in (16.0, 20.0)])
def test_the_stiffness_that_heat_leaves_is_in_its_range(T):
    """Plates are stiffer by a twentieth: of what heat leaves of it that is a tenth and more."""
    found = solids(bridge(0.3, 10.0, 0.01, T), "k_stage_hot")
    assert abs(found.apart) > 0.1
    assert found.agrees


def test_what_heat_leaves_of_a_stiffness_is_the_more_unsure_the_less_it_is():
    """Of K₀ (1 − s) an error ε of K₀ is ε/(1 − s)."""
    widths = []
    for T in (2.0, 10.0):
        rows = flexcli.verdicts(bridge(0.3, 10.0, 0.01, T), model="exact").checks
        row = [row for row in rows if row.name.startswith("stiffness")][-1]
        low, high = map(float, row.factor_range)
        widths.append((high - low) / row.factor)
    # of what buckles beams, 20.6 K
    far, near = (share / (1.0 - share) for share in (2.0 / 20.6, 10.0 / 20.6))
    assert widths[1] / widths[0] > 0.5 * near / far > 3.0


SPREAD = """
flexure: 1
{material}
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: {b} mm, spacing: 600 mm, blades: 2}}
cases: {{hot: {{temperature: {{bodies: {{moving: 100 K}}}}}}}}
requirements: {{yield: 1}}
"""
"""A hot body bends the blades that it spreads."""


@pytest.mark.parametrize(
    ("nu", "b"), [pytest.param(0.45, 20.0, marks=calculix),
                  pytest.param(0.3, 4.0, marks=[*calculix, pytest.mark.slow])],
)  # fmt: skip
def test_wide_blades_that_a_hot_body_bends_are_plates(nu, b):
    text = SPREAD.format(material=SAME.format(nu=nu).strip(), b=b)
    found = solids(text, "sigma")
    assert abs(found.apart) <= found.solid_error  # beams would have a fifth less, at ν = 0.45
    largest, (low, high) = stress_of(text)
    assert low < found.solid / found.model * largest < high


PUSHED = """
flexure: 1
{material}
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 10 mm, spacing: 20 mm, blades: 2}}
cases: {{push: {{wrench: {{y: 33.75 N, x: 0.02 N}}, ends: clamped-guided}}}}
requirements: {{yield: 1}}
"""
"""A stage that is pushed along its blades by nine tenths of what buckles beams."""


@pytest.mark.parametrize("nu", [pytest.param(0.3, marks=calculix)])
def test_the_stress_of_loads_near_buckling_is_in_its_range(nu):
    text = PUSHED.format(material=SAME.format(nu=nu).strip())
    found = solids(text, "sigma")
    assert found.agrees
    plates, _ = stress_of(text, model="shell")
    beams, (low, high) = stress_of(text, model="exact")
    true = found.solid / found.model * plates
    assert beams > 1.15 * true
    assert low < true < high


SEAT = """
flexure: 1
{material}
geometry:
  kind: space-layout
  bodies: {{stage: {{at: [0 mm, 0.02 mm, 0 mm]}}}}
  blades:
    left: {{between: [ground, stage], from: [-22 mm, 0 mm, 0 mm], to: [-2 mm, 0.02 mm, 0 mm],
           h: 0.3 mm, b: 10 mm, width: z}}
    right: {{between: [stage, ground], from: [2 mm, 0.02 mm, 0 mm], to: [22 mm, 0 mm, 0 mm],
            h: 0.3 mm, b: 10 mm, width: z}}
  moving: stage
  motion: {{translation: y}}
requirements: {{misalignment_stress: {{of: left, factor: 1e-6,
                                       translation: {{along: x, by: {off} um}}}}}}
"""
"""A seat that is off presses two blades that do not quite lie in a line; they buckle at 7.4 um."""


def missed(off, model):
    """Return the stress by a seat that is off so many micrometres, and half of its range."""
    text = SEAT.format(material=SAME.format(nu=0.3).strip(), off=off)
    row = next(c for c in flexcli.verdicts(text, model=model).checks if "misalign" in c.name)
    least, most = (row.capacity / factor / row.demand for factor in reversed(row.factor_range))
    return row.demand, (most - least) / 2.0


def test_the_stress_of_a_seat_near_buckling_is_as_unsure_as_what_it_bends():
    beams, shells = ([missed(off, model) for off in (0.5, 6.0)] for model in ("exact", "shell"))
    # by how much the stress grows shells tell without the springs of beams
    grows = [near[0] / far[0] for far, near in (beams, shells)]
    assert abs(grows[1] / grows[0] - 1.0) < beams[1][1]
    assert beams[1][1] > 5.0 * beams[0][1]
    # errors of shells grow as well, from where their support is off alike
    _, middle = missed(3.0, "shell")
    assert shells[1][1] > middle + 0.01
