"""A case with a temperature: what is judged, what it moves, what is refused."""

import re
from math import pi, sqrt, tan, tanh

import pytest

import flexcli
from flexcli.errors import SpecError
from flexcli.formulas.held_at_clamps import held_face, held_middle
from flexcli.formulas.plate_factors import guided_factor
from flexcli.formulas.sheet_factors import held_growth
from flexcli.results import Status, Verdict

STAGE = """
flexure: 1
material: ti-6al-4v
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 10 mm, spacing: 20 mm, blades: 2}}
cases: {{c: {{{case}}}}}
requirements: {{{requirements}}}
"""
ALPHA, E = 8.6e-6, 113.8e9
PLAIN = (
    "{youngs_modulus: 113.8 GPa, poisson_ratio: 0.342, density: 4430 kg/m^3, "
    "yield_strength: 880 MPa, thermal_expansion: 8.6e-6 1/K}"
)
"""The same at all temperatures."""


def longer(b, h, l, nu=0.342):
    """Return by what factor a blade grows whose sections clamps hold as they are at assembly."""
    return 1.0 + float(held_growth(b=b, h=h, l=l, poisson_ratio=nu))


WIDE, NARROW = longer(10e-3, 0.2e-3, 20e-3), longer(2e-3, 0.2e-3, 40e-3)
"""Of the stage's blades, and of the bridge's."""


def spec(case, requirements="yield: 1"):
    return STAGE.format(case=case, requirements=requirements)


def refusal(case, **changes):
    text = spec(case)
    for old, new in changes.items():
        text = text.replace(old, new)
    with pytest.raises(SpecError) as refused:
        flexcli.check(text)
    return refused.value.findings[0]


def test_a_body_of_the_blades_material_and_temperature_stresses_nothing():
    result = flexcli.check(spec("temperature: {uniform: -100 K}"))
    assert result.status is Status.PASS
    assert max(check.demand for check in result.checks) < 1.0


def test_a_hotter_body_bends_the_blades_that_it_spreads():
    result = flexcli.check(spec("temperature: {bodies: {moving: 50 K}}"))
    spread = ALPHA * 50.0 * 10e-3
    check, held = result.checks
    assert "held across" in held.full_name
    # each blade is a guided plate, a little less than bent by that: it shears
    plate = float(guided_factor(b=10e-3, l=20e-3, h=0.2e-3, poisson_ratio=0.342))
    bent = 3.0 * E * 0.2e-3 * spread / 20e-3**2
    assert check.demand / (plate * bent) == pytest.approx(1.0, abs=1e-3)
    assert check.model == "exact"


def test_what_clamps_hold_across_may_add_to_all_that_bends_along():
    case = "stroke: {translation: 0.5 mm, cycles: 1e6}, temperature: {bodies: {moving: 50 K}}"
    along, held = flexcli.check(spec(case)).checks[:2]
    assert "held across" in held.full_name
    # at a face by von Mises beside what bends it the other way, and amid the clamp more than that
    face, size = held_face(poisson_ratio=0.342), E * ALPHA * 50.0
    Z, X, a = size * float(face.across), size * float(face.along), along.demand
    at_face = sqrt(a**2 + X**2 + X * Z + Z**2 + a * (2.0 * X + Z))
    amid = size * float(held_middle(poisson_ratio=0.342))
    # between both with half of what is bent, which pulls hardly
    between = amid + a / 2.0
    assert held.demand == pytest.approx(max(at_face, amid), rel=1e-2)
    low, high = held.factor_range
    assert low <= 880e6 / max(at_face, between) < high


UNLIKE = "temperature: {uniform: -20 K, expansion: {moving: 0 1/K, ground: 0 1/K}}"
"""Blades that shrink between bodies that do not, without a stress along."""


@pytest.mark.parametrize(
    ("clamps", "expected"),
    [
        ("", Verdict.UNDECIDED),
        ("clamps: monolithic", Verdict.UNDECIDED),
        ("clamps: rigid", Verdict.FAIL),
        ("clamps: rigid, root_radius: 0.1 mm", Verdict.UNDECIDED),
    ],
)
def test_what_clamps_hold_across_and_through_is_not_passed_by_what_they_hold_across(
    clamps, expected
):
    def held(factor):
        stage = spec(UNLIKE, f"yield: {factor}").replace("ti-6al-4v", PLAIN)
        checks = flexcli.check(stage.replace("blades: 2", f"blades: 2, {clamps}")).checks
        return next(check for check in checks if "held across" in check.full_name)

    size = E * ALPHA * 20.0
    # a plate that its clamps hold across bears this, with all that its moduli may change by cold
    plate = size / (1.0 - 0.342**2) * 1.016
    amid = size * float(held_middle(poisson_ratio=0.342))
    factor = 880e6 / (1.01 * plate)
    assert amid * factor > 880e6
    assert held(factor).verdict is expected
    # where a clamp holds little of what the blade bears, whatever it does is passed
    assert held(880e6 / (1.5 * amid)).verdict is Verdict.PASS


def test_a_sheet_that_is_soft_along_its_blades_is_held_by_its_fibres_across():
    def held(turned):
        sheet = (
            "{orthotropic: {E_1: 140 GPa, E_2: 10 GPa, G_12: 5 GPa, nu_12: 0.3}, "
            f"orientation: {{width: in-plane, turned: {turned} deg}}, density: 1600 kg/m^3, "
            "yield_strength: 880 MPa, thermal_expansion: 8.6e-6 1/K}"
        )
        stage = spec(UNLIKE, "yield: 1").replace("blades: 2", "blades: 2, clamps: rigid")
        checks = flexcli.check(stage.replace("ti-6al-4v", sheet)).checks
        return next(check for check in checks if "held across" in check.full_name)

    for turned in (0, 90):
        least, most = (held(turned).capacity / factor for factor in held(turned).factor_range[::-1])
        # the stiffest direction counts, wherever it is, and nobody knows that as much is held
        assert least == pytest.approx(0.0, abs=1e-3 * most)
        assert most > 1.5 * 140e9 * ALPHA * 20.0


def test_stroke_and_temperature_act_together():
    stroke = "stroke: {translation: 0.5 mm, cycles: 1e6}"
    alone = flexcli.check(spec(stroke)).checks[0].demand
    warm = "temperature: {bodies: {moving: 400 K}}"
    apart = flexcli.check(spec(warm)).checks[0].demand
    together = flexcli.check(spec(f"{stroke}, {warm}")).checks[0].demand
    # one blade bends more by one and less by the other: at some face they add up
    assert together == pytest.approx(alone + apart, rel=0.02)


def test_the_motion_by_the_temperature_alone_is_told():
    case = "temperature: {uniform: 40 K, expansion: {moving: 0 1/K, ground: 0 1/K}}"
    values = flexcli.check(spec(case)).values
    moved = [values[f"{name}_c"].value for name in ("x", "y", "theta")]
    # the blades alone grow; they lie across the stroke, x
    assert abs(moved[1]) == pytest.approx(WIDE * ALPHA * 40.0 * 20e-3, rel=1e-6)
    assert moved[0] == pytest.approx(0.0, abs=1e-12)
    assert moved[2] == pytest.approx(0.0, abs=1e-9)


def test_a_gradient_along_the_blades_differs_from_one_across_them():
    def turned(axis):
        case = f"temperature: {{gradient: {{{axis}: 1000 K/m}}}}"
        return abs(flexcli.check(spec(case)).values["theta_c"].value)

    # across the blades one is warmer than the other, and longer
    assert turned("x") == pytest.approx(WIDE * ALPHA * 1000.0 * 20e-3, rel=0.02)
    assert turned("y") < 1e-3 * turned("x")


def test_a_model_that_has_no_temperature_passes_nothing():
    assert flexcli.check(spec("temperature: {uniform: 5 K}"), model="linear").status is not (
        Status.PASS
    )


def test_a_temperature_that_nothing_looks_at_is_not_judged():
    case = "temperature: {uniform: 5 K}"
    result = flexcli.check(spec(case, "stiffness: {min: 1 N/m}"))
    assert Verdict.NOT_JUDGED in {check.verdict for check in result.checks}
    assert result.status is Status.UNDECIDED


@pytest.mark.parametrize(
    ("case", "changes", "text", "hint"),
    [
        ("temperature: {uniform: 0 K}", {}, "changes nothing", "uniform"),
        ("temperature: {bodies: {stage: 3 K}}", {}, "has no body 'stage'", "ground, moving"),
        ("temperature: {uniform: 20 degC}", {}, "degC", "K"),
        (
            "temperature: {uniform: 3 K}",
            {"ti-6al-4v": "{name: t, youngs_modulus: 114 GPa, yield_strength: 800 MPa}"},
            "no thermal_expansion", "give it",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be_meant_is_refused(case, changes, text, hint):
    found = refusal(case, **changes)
    assert text in found.text
    assert hint in found.hint


BRIDGE = """
flexure: 1
material: {{youngs_modulus: 113.8 GPa, poisson_ratio: 0.342, density: 4430 kg/m^3,
           yield_strength: 880 MPa, thermal_expansion: 8.6e-6 1/K}}
geometry:
  kind: layout
  bodies: {{stage: {{at: [0 mm, 0 mm], mass: 10 g}}}}
  blades:
    left: {{between: [ground, stage], from: [-42 mm, 0 mm], to: [-2 mm, 0 mm], h: 0.2 mm, b: 2 mm}}
    right: {{between: [stage, ground], from: [2 mm, 0 mm], to: [42 mm, 0 mm], h: 0.2 mm, b: 2 mm}}
  moving: stage
  motion: {{translation: 90 deg}}
cases: {{hot: {{temperature: {{uniform: {change} K, expansion: {{ground: 0 1/K, stage: 0 1/K}}}}}}}}
requirements: {{buckling: 1.5, frequency: {{min: 1 Hz}}}}
"""
EULER = pi**2 / 12.0 * (0.2e-3 / 40e-3) ** 2 / ALPHA / NARROW
"""Rise of temperature at which a blade of these held ends buckles, guided: π² EI/l² = E A α ΔT."""


def test_heated_blades_between_held_ends_buckle_at_eulers_temperature():
    passes = flexcli.check(BRIDGE.format(change=0.5 * EULER))
    buckling = next(check for check in passes.checks if check.name == "buckling")
    assert buckling.verdict is Verdict.PASS
    assert buckling.factor == pytest.approx(2.0, rel=1e-3)
    fails = flexcli.check(BRIDGE.format(change=1.1 * EULER))
    assert fails.status is Status.FAIL
    # beyond it nothing stands that a frequency could be told of
    open_ = next(check for check in fails.checks if check.name == "frequency")
    assert open_.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("share", [0.5, -0.5])
def test_compressed_blades_vibrate_slower_and_stretched_ones_faster(share):
    checks = flexcli.check(BRIDGE.format(change=share * EULER)).checks
    rest, warm = (check for check in checks if check.name == "frequency (min)")
    assert (rest.case, warm.case) == ("", "hot")
    # a guided strut under P: k/k_0 = (v/2)³/(3 (tan(v/2) − v/2)), v² = P l²/EI
    v = pi * abs(share) ** 0.5 / 2.0
    tangent = tan(v) if share > 0.0 else tanh(v)
    ratio = abs(v**3 / (3.0 * (tangent - v)))
    # the blades shear, and the error that is stated has their sections, which grow
    assert warm.capacity / rest.capacity == pytest.approx(ratio**0.5, rel=2e-4)


def test_loads_and_temperature_buckle_together():
    text = BRIDGE.format(change=0.5 * EULER)
    # a force along x presses one blade and pulls the other: both together bear it at less
    pushed = text.replace("hot: {", "hot: {wrench: {x: 0.5 N}, ")
    factors = [
        next(check for check in flexcli.check(each).checks if check.name == "buckling").factor
        for each in (text, pushed)
    ]
    assert 1.0 < factors[1] < factors[0]


def test_a_load_across_heated_blades_does_not_hide_that_they_buckle():
    """A hair of a force across bows them from the first on, and nothing gets unstable then."""
    text = BRIDGE.format(change=1.5 * EULER).replace("hot: {", "hot: {wrench: {y: 1e-4 N}, ")
    buckling = next(check for check in flexcli.check(text).checks if check.name == "buckling")
    assert buckling.verdict is not Verdict.PASS
    assert buckling.factor_range[0] < 1.0


def test_a_temperature_alone_is_followed_as_far_as_with_the_loads_beside_it():
    """A factor beyond the share that is looked at without being asked for was never decided."""
    text = BRIDGE.format(change=EULER / 40.0).replace("buckling: 1.5", "buckling: 12")
    pulled = text.replace("hot: {", "hot: {load: {force: 1e-3 N, direction: 90 deg}, ")
    buckling = next(check for check in flexcli.check(pulled).checks if check.name == "buckling")
    assert buckling.verdict is Verdict.PASS


def test_a_shift_at_the_end_of_a_stroke_counts_the_temperature():
    stroke = "stroke: {translation: 0.5 mm}"
    warm = "temperature: {uniform: 40 K, expansion: {moving: 0 1/K, ground: 0 1/K}}"
    bound = "parasitic_shift: {max: 1 mm}"

    def shift(case):
        return max(check.demand for check in flexcli.check(spec(case, bound)).checks)

    # outwards the blades grow by 6.9 µm, of which the stroke takes 7.5 µm back
    alone, both, heat = shift(stroke), shift(f"{stroke}, {warm}"), shift(warm)
    assert heat == pytest.approx(WIDE * ALPHA * 40.0 * 20e-3, rel=1e-6)
    assert both == pytest.approx(abs(alone - heat), abs=0.01 * heat)


def test_a_body_is_called_by_its_own_name():
    text = BRIDGE.format(change=1.0).replace("uniform: 1.0 K", "bodies: {stage: 1 K, ground: 1 K}")
    assert flexcli.check(text).status is Status.PASS
    with pytest.raises(SpecError) as refused:
        flexcli.check(text.replace("{stage: 1 K", "{table: 1 K"))
    assert "ground, stage" in refused.value.findings[0].hint


MOUNT = """
flexure: 1
material: {material}
geometry:
  kind: space-layout
  bodies: {{mirror: {{at: [0 mm, 0 mm, 0 mm], mass: 400 g,
                     inertia: [3e-4 kg*m^2, 3e-4 kg*m^2, 5e-4 kg*m^2]}}}}
  blades:
    leg: {{between: [ground, mirror], from: [50 mm, -20 mm, 0 mm], to: [50 mm, 20 mm, 0 mm],
          h: 0.4 mm, b: 8 mm, width: z, repeat: {{count: 3, about: z}}}}
  moving: mirror
  motion: {{translation: z}}
cases: {{c: {{{case}}}}}
requirements: {{{requirements}}}
"""
TANGENTIAL = (0.4e-3, 40e-3, 50e-3)
"""Thickness and length of the mount's blades, and their distance from its axis [m]."""


def mount(case, requirements, material=PLAIN):
    text = MOUNT.format(case=case, requirements=requirements, material=material)
    return flexcli.check(text)


def test_tangential_blades_bend_by_what_the_ring_shrinks_around_the_mirror():
    cold = "temperature: {uniform: -100 K, expansion: {mirror: 0 1/K}}"
    result = mount(cold, "yield: 1, parasitic_motion: {direction: theta_z, max: 5 mrad}")
    assert result.status is Status.PASS
    h, l, R = TANGENTIAL
    shrinks = ALPHA * 100.0
    # each blade's end turns with the mirror by φ, R φ = α ΔT l/2, and stays behind by α ΔT R
    turn = shrinks * l / 2.0 / R
    # the mirror's clamps hold it across, half of what all would do
    longer_by = (1.0 + longer(8e-3, h, l)) / 2.0
    assert result.values["theta_z_c"].value == pytest.approx(-turn * longer_by, rel=0.01)
    at_start, at_end = (
        E * h / l**2 * abs(3.0 * shrinks * R + rest * turn * l) for rest in (1.0, 2.0)
    )
    stress = next(check for check in result.checks if check.name.startswith("yield"))
    # plates between clamps are stiffer than beams by a little, b/l = 0.2
    assert stress.demand == pytest.approx(max(at_start, at_end), rel=0.15)
    for axis in "xyz":
        assert result.values[f"{axis}_c"].value == pytest.approx(0.0, abs=1e-12)


HELD = "uniform: -200 K, expansion: {mirror: 0 1/K, ground: 23.6e-6 1/K}"


def test_what_clamps_hold_across_is_told_where_it_is_much_of_the_strength_and_nobody_judges_it():
    def told(case, requirements="mass: {max: 1 kg}"):
        notes = mount(f"temperature: {{{case}}}", requirements).warnings
        return [note.text for note in notes if note.code == "held-across"]

    (text,) = told(HELD)
    # between the bench and the blades it is most: E (23.6 − 8.6)e-6 · 200 K, amid a clamp
    most = float(re.search(r"some (\d+) MPa", text)[1])
    middle = float(held_middle(poisson_ratio=0.342))
    assert most == pytest.approx(middle * E * 15e-6 * 200.0 / 1e6, rel=0.01)
    assert told("uniform: -200 K") == []
    # a strain of 4.3e-5 is 5 MPa, of 880 MPa
    assert told("uniform: -5 K, expansion: {mirror: 0 1/K}") == []
    assert told(HELD, "yield: 1") == []


def test_yield_judges_what_clamps_hold_across_with_what_stands_along():
    def held(case, factor=1.0):
        checks = mount(f"temperature: {{{case}}}", f"yield: {factor}").checks
        return {c.full_name.partition(",")[2].strip(" )").startswith("held"): c for c in checks}

    rows = held(HELD)
    along, both = rows[False], rows[True]
    # in space nobody tells a pull from bending: all of it adds to what is amid a clamp
    amid = float(held_middle(poisson_ratio=0.342)) * E * 15e-6 * 200.0
    assert both.demand == pytest.approx(amid + along.demand, rel=1e-3)
    # clamps that give way leave what stands along
    assert both.factor_range[1] >= along.factor_range[1]
    assert both.factor_range[0] < both.factor
    # what passes with free clamps alone is not passed
    asked = (along.factor * both.factor) ** 0.5
    assert {c.verdict for c in held(HELD, asked).values()} == {Verdict.PASS, Verdict.UNDECIDED}
    assert True not in held("uniform: -200 K")


def test_a_gradient_across_a_mount_moves_its_centre_along_any_axis():
    h, l, R = TANGENTIAL
    moved = longer(8e-3, h, l) * ALPHA * 200.0 * R * l
    # (2/3) Σ α ΔT l t over the blades, t the tangent at each: across the gradient
    for axis, expected in (("x", (0.0, 1.0)), ("y", (-1.0, 0.0)), ("z", (0.0, 0.0))):
        result = mount(f"temperature: {{gradient: {{{axis}: 200 K/m}}}}", "yield: 1")
        assert result.status is Status.PASS
        found = [result.values[f"{other}_c"].value for other in "xyz"]
        assert found == pytest.approx([*(moved * e for e in expected), 0.0], abs=1e-3 * moved)


def test_linear_and_exact_blades_agree_on_a_strained_mount():
    cold = "temperature: {uniform: -100 K, expansion: {mirror: 0 1/K}}"
    text = MOUNT.format(case=cold, requirements="yield: 1", material=PLAIN)
    linear, exact = (flexcli.check(text, model=name).checks[0] for name in ("linear", "exact"))
    low, high = sorted((linear.factor_range[0], linear.factor_range[1]))
    assert low < exact.factor < high
    assert exact.factor == pytest.approx(linear.factor, rel=5e-3)


@pytest.mark.slow
def test_a_bridge_in_space_buckles_and_slows_as_in_its_plane():
    text = """
flexure: 1
material: {{youngs_modulus: 113.8 GPa, poisson_ratio: 0.342, density: 4430 kg/m^3,
           yield_strength: 880 MPa, thermal_expansion: 8.6e-6 1/K}}
geometry:
  kind: space-layout
  bodies: {{stage: {{at: [0 mm, 0 mm, 0 mm], mass: 10 g, inertia: [1e-6 kg*m^2, 1e-6 kg*m^2,
                                                                 1e-6 kg*m^2]}}}}
  blades: {{b: {{between: [ground, stage], from: [-42 mm, 0 mm, 0 mm], to: [-2 mm, 0 mm, 0 mm],
               h: 0.2 mm, b: 2 mm, width: z, mirror: [x]}}}}
  moving: stage
  motion: {{translation: y}}
cases: {{hot: {{temperature: {{uniform: {change} K, expansion: {{ground: 0 1/K, stage: 0 1/K}}}}}}}}
requirements: {{buckling: 1.5, frequency: {{min: 1 Hz}}}}
"""
    plane = flexcli.check(BRIDGE.format(change=0.5 * EULER)).checks
    space = flexcli.check(text.format(change=0.5 * EULER)).checks
    pairs = [
        tuple(next(c for c in checks if (c.name, c.case) == key) for checks in (plane, space))
        for key in (("buckling", "hot"), ("frequency (min)", ""), ("frequency (min)", "hot"))
    ]
    for one, other in pairs:
        # plates of b/l = 0.05 stretch and bend within 2 % like beams
        assert other.capacity == pytest.approx(one.capacity, rel=0.02)
        assert other.verdict is Verdict.PASS


CURVES = """{extends: ti-6al-4v, over_temperature: {
  elongation: {points: [[80 K, -0.2 %], [293 K, 0 %]]},
  youngs_modulus: {points: [[80 K, 120 GPa], [293 K, 100 GPa]]},
  yield_strength: {points: [[80 K, 1600 MPa], [293 K, 800 MPa]]}}}"""


def test_modulus_strength_and_length_follow_their_points():
    requirements = "yield: 1, stiffness: {min: 1 N/m}"
    cold = "temperature: {uniform: -213 K, expansion: {mirror: 0 1/K}}"
    checks = mount(cold, requirements, CURVES).checks
    plain = mount(cold, requirements).checks
    stress, own = (next(c for c in each if c.name.startswith("yield")) for each in (checks, plain))
    assert stress.capacity == pytest.approx(2.0 * own.capacity)
    strain = 0.002 / (ALPHA * 213)
    assert stress.demand == pytest.approx(own.demand * 1.2 * strain, rel=1e-3)
    rest, warm = (c for c in checks if c.name == "stiffness (min)")
    assert warm.capacity == pytest.approx(1.2 * rest.capacity, rel=0.01)


def test_nothing_is_taken_beyond_the_points():
    with pytest.raises(SpecError) as refused:
        mount("temperature: {uniform: -220 K}", "yield: 1", CURVES)
    (found,) = refused.value.findings
    assert "73 to 293 K" in found.text
    assert "80 to 293 K" in found.hint


HOT = """
flexure: 1
material: {material}
geometry: {{kind: leaf-spring-stage, h: 0.2 mm, l: 20 mm, b: 10 mm, spacing: 20 mm, blades: 2}}
cases: {{hot: {{stroke: {{translation: 0.5 mm, cycles: 1e4}}, temperature: {{{temperature}}}}}}}
requirements: {{{requirements}}}
"""
TABLE = (
    "{extends: 7075-t6, "
    "over_temperature: {yield_strength: {points: [[293 K, 1 GPa], [500 K, 0.2 GPa]]}}}"
)


def hot(material, temperature, requirements):
    text = HOT.format(material=material, temperature=temperature, requirements=requirements)
    return flexcli.check(text).checks


@pytest.mark.parametrize(
    "temperature", ["uniform: 150 K", "bodies: {moving: 150 K, ground: 150 K}"]
)
def test_a_strength_far_above_assembly_is_unknown_where_nobody_gave_it_there(temperature):
    """Of 7075-T6 little is left at 170 °C: its clamps are as hot as the bodies."""
    checks = hot("7075-t6", temperature, "yield: 1.01, fatigue: 1.01")
    assert {check.verdict for check in checks} == {Verdict.UNDECIDED}
    (check,) = (c for c in hot(TABLE, temperature, "yield: 1.01") if "held" not in c.full_name)
    assert check.verdict is Verdict.PASS
    # a straight line between the points of the table
    assert check.capacity == pytest.approx(503e6 * (1.0 - 0.8 * 150.0 / 207.0), rel=1e-6)


def test_a_strength_that_nobody_gave_may_be_less_by_what_heat_takes():
    """Aluminium and annealed stainless steels lose less than 0.4 % a kelvin up to 80 K."""
    (warm,) = hot("7075-t6", "uniform: 50 K", "yield: 1")
    (cold,) = hot("7075-t6", "uniform: -50 K", "yield: 1")
    least, _ = (check.factor_range[0] / check.factor for check in (warm, cold))
    assert least == pytest.approx(0.8 * cold.factor_range[0] / cold.factor, rel=1e-3)


def test_a_modulus_that_nobody_gave_is_unsure_by_as_much_as_shipped_curves_change():
    drift = 0.0
    for name in ("6061-t6", "304-annealed", "316-annealed", "invar-36"):
        moduli = flexcli.load(
            HOT.format(material=name, temperature="uniform: -9 K", requirements="yield: 1")
        ).part.material
        points = moduli.over_temperature.youngs_modulus.points
        top = moduli.over_temperature.youngs_modulus.at(293.0)
        drift = max(drift, *(abs(E / top - 1.0) / (293.0 - T) for T, E in points if T < 280.0))
    checks = hot("7075-t6", "uniform: -200 K", "stiffness: {max: 3 N/mm}")
    rest, cold = (
        next(c for c in checks if c.name == "stiffness (max)" and c.case == case)
        for case in ("", "hot")
    )
    low, high = (end / cold.factor for end in cold.factor_range)
    assert low < 1.0 / (1.0 + 200.0 * drift)
    assert high > 1.0 / (1.0 - 200.0 * drift)
    assert rest.factor_range[0] > 0.95 * rest.factor


WIDE_BRIDGE = """
flexure: 1
material: {{youngs_modulus: 200 GPa, yield_strength: 400 MPa, poisson_ratio: 0.3,
           thermal_expansion: 12e-6 1/K}}
geometry:
  kind: space-layout
  bodies: {{middle: {{at: [0 mm, 0 mm, 0 mm]}}}}
  blades:
    arm: {{between: [ground, middle], from: [60 mm, 0 mm, 0 mm], to: [10 mm, 0 mm, 0 mm],
          h: 0.5 mm, b: 40 mm, width: z, mirror: [x]}}
  moving: middle
  motion: {{translation: y}}
cases:
  day: {{temperature: {{{change}gradient: {{{axis}: 500 K/m}}}}}}
requirements: {{{requirement}}}
"""


@pytest.mark.parametrize(("axis", "half"), [("z", 20e-3), ("y", 0.25e-3)])
def test_a_gradient_across_a_held_section_is_in_the_range_of_its_stress(axis, half):
    """E α g b/2 beside what the blade bears of the change of its middle, held at both ends."""
    text = WIDE_BRIDGE.format(axis=axis, change="uniform: -20 K, ", requirement="yield: 1")
    (check,) = flexcli.check(text, model="exact").checks
    bent = 200e9 * 12e-6 * 500.0 * half
    low, high = check.factor_range
    assert low <= 400e6 / (check.demand + bent)
    assert low > 400e6 / (1.1 * check.demand + 1.6 * bent)
    assert check.factor < high


@pytest.mark.parametrize(("factor", "verdict"), [(10, "pass"), (17, "undecided")])
def test_a_gradient_alone_across_held_sections_counts(factor, verdict):
    """Its middle is as warm as at assembly: 24 MPa of bending are all that there is."""
    text = WIDE_BRIDGE.format(axis="z", change="", requirement=f"yield: {factor}")
    (check,) = flexcli.check(text).checks
    assert check.verdict.value == verdict


@pytest.mark.parametrize(("most", "verdict"), [(5, "undecided"), (30, "pass")])
def test_a_blade_that_a_gradient_bends_moves_its_end_by_no_more_than_is_told(most, verdict):
    """A free strip is bent to the curvature α g: its end moves by α g l²/2, 7.5 µm."""
    lone = WIDE_BRIDGE.replace(", mirror: [x]", "")
    wanted = f"parasitic_motion: {{direction: z, max: {most} um}}"
    (check,) = (
        c
        for c in flexcli.check(lone.format(axis="z", change="", requirement=wanted)).checks
        if c.name.startswith("parasitic")
    )
    assert check.verdict.value == verdict
