"""Solid elements agree with the exact model where both are right, and say so where they do not."""

import os
import shutil

import numpy as np
import pytest

import flexcli
from flexcli.engine.solid.calculix import run
from flexcli.engine.solid.states import solid_states
from flexcli.errors import NoSolution
from flexcli.formulas.notch import bending_factor
from flexcli.formulas.profile import Notch
from flexcli.mechanics.layout import Blade, Body, Layout

pytestmark = [
    pytest.mark.calculix,
    pytest.mark.skipif(shutil.which("ccx") is None, reason="ccx is not installed"),
]

SPEC = """\
flexure: 1
material: {{name: ours, youngs_modulus: 114 GPa, poisson_ratio: {nu}, density: 4.43 g/cm^3}}
geometry: {geometry}
{mechanism}
cases:
  a: {case}
requirements: {{stiffness: {{min: 1 {unit}}}}}
"""

MESH = 1e-3
"""What a mesh of this fineness leaves at most, over all of these."""


def numbers(geometry, case, nu=0.0, mechanism="", unit="N/m", **how):
    text = SPEC.format(geometry=geometry, case=case, nu=nu, mechanism=mechanism, unit=unit)
    result = flexcli.verify(text, **how)
    return {number.name: number for number in result.verification.numbers}, result


def test_without_poisson_s_ratio_a_blade_is_the_beam():
    found, _ = numbers(
        "{kind: cantilever, h: 0.5 mm, l: 20 mm, b: 2 mm}",
        "{stroke: {translation: 1 mm}}",
        mechanism="mechanism: {kind: tip-mass, mass: 5 g}",
        only=("k_stage", "k_end", "shift", "k_across", "f_0", "sigma"),
    )
    for name in ("k_stage", "k_end", "shift", "k_across", "f_0"):
        # the shift of finite strains is as unsure as the solid says
        allowed = MESH + found[name].solid_error
        assert found[name].apart == pytest.approx(0.0, abs=allowed), name
        assert found[name].solid_error < 0.01
    assert found["sigma"].apart == pytest.approx(0.0, abs=5e-3)


@pytest.mark.parametrize("ends", ["clamped-free", "clamped-pinned", "clamped-clamped"])
def test_a_pivot_buckles_where_the_exact_model_says(ends):
    found, _ = numbers(
        "{kind: rcc, p: 8 mm, half_angle: 30 deg, h: 0.4 mm, l: 20 mm, b: 2 mm}",
        f"{{load: {{force: 10 N, direction: 180 deg}}, ends: {ends}}}",
        unit="N*m/rad",
        only=("F_cr",),
    )
    critical = found["F_cr"]
    # a pivot that leans away gives the exact model a lower end alone
    assert critical.agrees
    assert critical.apart == pytest.approx(0.0, abs=3.0 * MESH)


def test_a_wide_blade_is_stiffer_than_its_beam_by_what_the_plate_factor_says():
    found, result = numbers(
        "{kind: leaf-spring-stage, blades: 2, spacing: 20 mm, h: 0.3 mm, l: 20 mm, b: 15 mm}",
        "{stroke: {translation: 0.5 mm}}",
        nu=0.34,
        model="closed-form",
        only=("k_stage",),
    )
    assert found["k_stage"].agrees
    beam = 24.0 * 114e9 * 15e-3 * 0.3e-3**3 / 12.0 / 20e-3**3
    assert found["k_stage"].solid > 1.08 * beam
    assert result.verification.model == "closed-form"


def test_a_notch_hinge_is_as_stiff_as_its_profile_and_thick_throat_say():
    found, _ = numbers(
        "{kind: notch-hinge, e: 0.2 mm, r: 2 mm, b: 1 mm}",
        "{stroke: {rotation: 10 mrad}}",
        nu=0.3,
        unit="N*m/rad",
        only=("k_pivot",),
    )
    assert found["k_pivot"].agrees


@pytest.mark.parametrize("e", [0.2e-3, 0.5e-3])
def test_the_stress_in_a_throat_has_neuber_s_peak(e):
    r, b, E = 1e-3, 0.5e-3, 114e9
    blade = Blade("hinge", "ground", "moving", (-r, 0.0), (r, 0.0), Notch(e, r), b)
    layout = Layout((Body("moving", (0.0, 0.0)),), (blade,), E, E / 2.0)
    states = solid_states(
        layout, {"moving": (None, None, 1e-6)}, (), lambda deck: run(deck.text, "throat"),
        fineness=2, is_linear=True,
    )  # fmt: skip
    (face,) = states.face_stresses(0)
    nominal = 6.0 * states.reactions[0, 0, 2] / (b * e**2)
    peak = float(np.abs(face.left).max()) / abs(nominal)
    assert peak > 1.02
    # Neuber's deep notch is a hyperbola
    assert peak == pytest.approx(float(bending_factor(e=e, r=r)), rel=0.02)


def test_the_support_of_solids_is_that_of_linear_beams_in_space():
    # ν = 0: neither plates nor clamps stiffen the blades, but clamps hold their warping
    found, _ = numbers(
        "{kind: leaf-spring-stage, blades: 2, spacing: 20 mm, h: 0.5 mm, l: 20 mm, b: 2 mm}",
        "{stroke: {translation: 0.5 mm}}",
        only=("support_y", "support_z", "support_theta_z"),
    )
    for number in found.values():
        assert number.agrees
        assert number.apart == pytest.approx(0.0, abs=5e-3), number.name


def test_a_deck_that_ccx_cannot_read_says_why():
    with pytest.raises(NoSolution, match="ERROR"):
        run("*NODE\n1, 0., 0., 0.\n*STEP\n*STATIC\n*CLOAD\n7, 1, 1.\n*END STEP\n", "wrong")


def test_what_ccx_does_not_solve_is_no_agreement(tmp_path, monkeypatch):
    """A ccx that fails on curved states, beside one that agrees at rest."""
    ccx = tmp_path / "ccx"
    ccx.write_text(
        f'#!/bin/sh\nif grep -q NLGEOM "$2.inp"; then echo "*ERROR: no convergence"; exit 201; fi\n'
        f'exec {shutil.which("ccx")} "$@"\n',
        encoding="utf-8",
    )
    ccx.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    text = SPEC.format(
        geometry="{kind: guided-blade, h: 0.5 mm, l: 10 mm, b: 5 mm}", mechanism="", unit="N/m",
        case="{stroke: {translation: 0.5 mm}}", nu=0.3,
    )  # fmt: skip
    found = flexcli.verify(text, only=["k_stage", "shift"])
    rest, stroke = found.verification.numbers
    assert rest.agrees
    assert stroke.solid is None
    assert "no convergence" in stroke.why
    assert found.status.value == "undecided"


def test_solids_are_the_finest_model_of_accuracy_where_they_are_asked_for():
    text = SPEC.format(
        geometry="{kind: guided-blade, h: 0.5 mm, l: 10 mm, b: 5 mm}", mechanism="", unit="N/m",
        case="{stroke: {translation: 0.5 mm}}", nu=0.3,
    )  # fmt: skip
    files = {}
    found = flexcli.accuracy(text, solid=True, files=files).accuracy
    assert found.is_solid
    assert found.finest == found.models[-1].model == "solid"
    assert {"k_stage", "sigma", "k_end", "shift"} == {each.name for each in found.quantities}
    for quantity in found.quantities:
        readings = {reading.model: reading for reading in quantity.readings}
        assert readings["solid"].value == quantity.finest
        assert readings["solid"].seconds > readings["exact"].seconds
    (stiffness,) = (each for each in found.quantities if each.name == "k_stage")
    by_model = {reading.model: reading.error for reading in stiffness.readings}
    # a plate of b = l/2 between clamps is some 6 % stiffer than beams, which the corrections know
    assert by_model["exact"] > 0.05
    assert by_model["exact, corrected"] < 0.005
    assert any(name.endswith(".inp") for name in files)


def test_blades_with_stiff_middles_reach_their_stroke_and_agree_there():
    found, _ = numbers(
        "{kind: necked-down-stage, blades: 2, spacing: 20 mm, h: 0.4 mm, l_c: 3 mm, l: 20 mm, "
        "b: 0.8 mm}",
        "{stroke: {translation: 1 mm}}",
        only=("k_stage", "k_end"),
    )
    for number in found.values():
        # the middles are a thousand times as stiff as the hinges, which the solid's error counts
        assert number.agrees
        assert number.apart == pytest.approx(0.0, abs=MESH + number.solid_error), number.name
        assert number.solid_error < 5.0 * MESH


def test_long_stiff_middles_are_stretched_by_what_the_error_of_a_support_counts():
    found, _ = numbers(
        "{kind: necked-down-stage, blades: 2, spacing: 20 mm, h: 0.2 mm, l_c: 1 mm, l: 40 mm, "
        "b: 3 mm}",
        "{stroke: {translation: 1 um}}",
        only=("k_stage", "support_y"),
    )
    # 38 mm a thousand times as stiff as the 2 mm of the hinges
    stretched = 1.0 / (1.0 + 38.0 / 2.0 / 1e3) - 1.0
    assert found["support_y"].apart == pytest.approx(stretched, abs=MESH)
    assert all(number.agrees for number in found.values())
    assert found["k_stage"].solid_error < -stretched / 2.0


COLD = """\
flexure: 1
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, blades: 2, spacing: 20 mm, h: 0.2 mm, l: 20 mm, b: 4 mm}
mechanism: {kind: payload, mass: 100 g}
cases:
  cold: {temperature: {uniform: -60 K, expansion: {moving: 23.6e-6 1/K}}}
  sun: {stroke: {translation: 0.5 mm}, temperature: {bodies: {moving: 12 K}, gradient: {y: 40 K/m}}}
requirements: {stiffness: {min: 1 N/m}}
"""


def test_solids_grow_as_the_temperature_of_the_case_says():
    # what a mesh, a plate of this width and clamps that hold it across leave
    most = {
        "k_stage_cold": 5e-3, "f_0_cold": 5e-3, "shift_cold": 0.01, "k_end_sun": 5e-3,
        "sigma_sun": 5e-3,
    }  # fmt: skip
    found = flexcli.verify(COLD, only=tuple(most)).verification.numbers
    assert {number.name for number in found} == set(most)
    for number in found:
        assert number.agrees, number.name
        assert number.apart == pytest.approx(0.0, abs=most[number.name]), number.name


def test_clamps_that_hardly_move_hold_thick_blades_as_stiffly_as_others():
    thick = COLD.replace("h: 0.2 mm", "h: 4 mm").replace("spacing: 20 mm", "spacing: 10 mm")
    names = ("k_stage", "k_stage_cold")
    found = flexcli.verify(
        thick.replace("-60 K, expansion: {moving: 23.6e-6 1/K}", "1 mK"), only=names
    ).verification.numbers
    rest, cold = (number.solid for number in found)
    assert cold == pytest.approx(rest, rel=1e-3)


def test_wide_blades_that_their_clamps_hold_across_grow_along_themselves():
    narrow, wide = (
        flexcli.verify(text, only=("shift_cold",)).verification.numbers[0]
        for text in (COLD, COLD.replace("b: 4 mm", "b: 16 mm"))
    )
    assert wide.agrees
    assert wide.apart == pytest.approx(0.0, abs=0.01)
    # beams of either width would be as long
    assert abs(wide.solid) > 1.1 * abs(narrow.solid)


SILICON = """\
flexure: 1
material: {extends: silicon, orientation: {wafer: "100", turned: 30 deg}}
geometry: {kind: cross-spring, delta: -0.5, half_angle: 45 deg, h: 50 um, l: 5 mm, b: 1 mm}
cases: {a: {stroke: {rotation: 2 deg}}}
requirements: {stiffness: {min: 1 N*mm/rad}}
"""


def test_solids_of_a_crystal_have_the_support_of_its_directions():
    """Two blades that lie differently in the wafer, by all the constants of the crystal."""
    names = ("support_x", "support_z", "support_theta_x")
    for number in flexcli.verify(SILICON, only=names).verification.numbers:
        assert number.agrees, number.name
        assert number.apart == pytest.approx(0.0, abs=5e-3), number.name
        assert number.model_error.high - number.model_error.low < 0.1


def test_solids_have_the_support_of_exact_beams_at_full_stroke():
    names = ("support_z_end", "support_theta_x_end", "support_theta_y_end")
    found, _ = numbers(
        "{kind: leaf-spring-stage, blades: 2, spacing: 10 mm, h: 0.2 mm, l: 10 mm, b: 2 mm}",
        "{stroke: {translation: 0.5 mm}}", nu=0.3, only=names, meshes=1,
    )  # fmt: skip
    rest, _ = numbers(
        "{kind: leaf-spring-stage, blades: 2, spacing: 10 mm, h: 0.2 mm, l: 10 mm, b: 2 mm}",
        "{stroke: {translation: 0.5 mm}}", nu=0.3, only=("support_z",), meshes=1,
    )  # fmt: skip
    for name in names:
        assert found[name].apart == pytest.approx(0.0, abs=0.01), name
    # a bent blade gives way by twist: a twentieth of its stroke takes 3.6 %
    assert found["support_z_end"].solid < 0.98 * rest["support_z"].solid
    assert set(found) == set(names)


IN_SPACE = """
flexure: 1
material: {name: ours, youngs_modulus: 114 GPa, poisson_ratio: 0.3, density: 4.43 g/cm^3}
geometry:
  kind: space-layout
  bodies:
    plate: {at: [0 mm, 0 mm, 20 mm], com: [0 mm, 1 mm, 22 mm], mass: 50 g,
            inertia: [1e-5 kg*m^2, 2e-5 kg*m^2, 2e-5 kg*m^2]}
  blades:
    leaf: {between: [ground, plate], from: [0 mm, 0 mm, 0 mm], to: [0 mm, 0 mm, 20 mm],
           h: 0.5 mm, b: 6 mm, width: y}
  rods:
    strut: {between: [ground, plate], from: [10 mm, 30 mm, 0 mm], to: [10 mm, 5 mm, 20 mm], d: 1 mm}
  moving: plate
  motion: {translation: x}
cases: {a: {acceleration: {level: 1 g, axis: x}}}
requirements: {frequency: {min: 1 Hz}}
"""


def test_a_mechanism_in_space_has_the_stiffness_and_the_modes_of_its_solids():
    """A blade and a rod askew to the axes, by springs of beams and plates and by bricks."""
    result = flexcli.verify(IN_SPACE)
    found = {number.name: number for number in result.verification.numbers}
    assert {"k_stage", "support_x", "support_theta_z", "f_0"} <= found.keys()
    assert result.status.value == "pass"
    for name, number in found.items():
        assert number.agrees, name
        assert abs(number.apart) < 0.01, name
        assert number.solid_error < 5e-3, name


SMALL_SHIFT, SMALL_TURN = "{stroke: {translation: 1 um}}", "{stroke: {rotation: 0.1 mrad}}"
STUBBY = (
    "{{kind: necked-down-stage, h: {h}, l_c: 2 mm, l: 15 mm, b: {b}, blades: 2, spacing: 10 mm}}"
)


@pytest.mark.parametrize(
    ("geometry", "nu"),
    [
        (STUBBY.format(h="3 mm", b="40 mm"), 0.3),
        (STUBBY.format(h="2 mm", b="40 mm"), 0.45),
        ("{kind: three-blade, h: 0.7 mm, l: 5 mm, b: 15 mm, p: 1 mm}", 0.45),
        ("{kind: guided-blade, h: 1 mm, l: 10 mm, b: 20 mm}", 0.45),
    ],
)
def test_short_wide_blades_are_as_stiff_as_their_range_says(geometry, nu):
    """Plates told it to 7e-4; clamps keep thick ends from thinning as well."""
    turns = "three" in geometry
    case = SMALL_TURN if turns else SMALL_SHIFT
    found, _ = numbers(geometry, case, nu=nu, unit="N*m/rad" if turns else "N/m",
                       only=("k_pivot" if turns else "k_stage",))  # fmt: skip
    (own,) = found.values()
    assert own.apart > 1e-3 + own.solid_error  # beyond the plate
    assert own.model_error.low <= 0.0 <= own.model_error.high
    assert own.apart - own.solid_error <= own.model_error.high


def test_what_a_spec_leaves_out_is_in_the_model_that_solids_are_held_against():
    """Widening, loads out of the plane, blocks: what is the same in both is compared."""
    text = SPEC.format(
        geometry="{kind: cantilever, h: 0.4 mm, l: 10 mm, b: 6 mm}",
        case="{stroke: {translation: 0.1 mm}, wrench: {theta_y: 0.1 N*m}}",
        nu=0.3, mechanism="effects: {plate-widening: off}", unit="N/m",
    )  # fmt: skip
    result = flexcli.verify(text, only=("k_stage", "support_z", "sigma"))
    assert [number.agrees for number in result.verification.numbers] == [True] * 3
    assert "all-effects" in {note.code for note in result.warnings}
    hinge = "{{kind: notch-hinge, e: 0.1 mm, r: 2 mm, b: 0.3 mm{}}}"
    bare, stated = (
        numbers(hinge.format(more), SMALL_TURN, nu=0.3, unit="N*m/rad", only=("support_z",))[0]
        for more in (", blocks: 0 mm", ", blocks: 5 mm")
    )
    assert stated["support_z"].agrees
    assert stated["support_z"].model == bare["support_z"].model


def test_a_blade_too_slender_for_its_solid_says_so():
    found, result = numbers(
        "{kind: cantilever, h: 10 um, l: 80 mm, b: 30 um}", SMALL_SHIFT, nu=0.3, only=("k_stage",)
    )
    assert found["k_stage"].solid_error is None
    assert "rounding" in found["k_stage"].why
    assert result.status.value == "undecided"


def test_the_force_that_asks_how_stiff_a_bent_blade_is_along_itself_bends_it_no_further():
    """It was as large as E I/l²: solids were 0.6 % softer than the tangent that it stands for."""
    found, _ = numbers(
        "{kind: moment-blade, h: 10 um, l: 4 mm, b: 80 um}",
        "{stroke: {rotation: 5 mrad}}",
        unit="N*m/rad",
        only=("k_across",),
    )
    assert found["k_across"].apart == pytest.approx(0.0, abs=2e-3)


SHEET = """\
flexure: 1
material:
  orthotropic: {{E_1: 140 GPa, E_2: 60 GPa, G_12: 20 GPa, nu_12: 0.3}}
  orientation: {{turned: {turned} deg}}
geometry: {geometry}
requirements: {{stiffness: {{min: 1 {unit}}}}}
"""


@pytest.mark.parametrize("turned", [0.0, 22.9, 45.0])
def test_thick_blades_of_a_sheet_shear_by_their_own_modulus_and_are_kept_from_it(turned):
    """Beams had G of an isotropic material: 4 % too stiff along the sheet, 2 % too soft across."""
    geometry = "{kind: guided-blade, h: 7 mm, l: 80 mm, b: 5 mm}"
    text = SHEET.format(turned=turned, geometry=geometry, unit="N/m")
    (own,) = flexcli.verify(text, only=("k_stage",)).verification.numbers
    assert abs(own.apart) > 0.012
    assert own.model_error.low < own.apart < own.model_error.high


def test_blades_of_a_pivot_at_an_angle_to_the_sheet_are_kept_from_shearing_as_they_bend():
    geometry = "{kind: rcc, h: 2.7 mm, l: 80 mm, b: 2 mm, p: 0 mm, half_angle: 22.9 deg}"
    text = SHEET.format(turned=0, geometry=geometry, unit="N*m/rad")
    (own,) = flexcli.verify(text, only=("k_pivot",)).verification.numbers
    assert own.apart > 0.009
    assert own.apart < own.model_error.high < 0.04


def test_a_small_critical_force_is_found():
    """CalculiX looks next to a load factor of one; the first of these is below a fifth."""
    geometry = "{kind: rcc, p: 8 mm, half_angle: 30 deg, h: 40 um, l: 20 mm, b: 1 mm}"
    case = "{load: {force: 1 mN, direction: 180 deg}, ends: clamped-clamped}"
    found, _ = numbers(geometry, case, unit="N*m/rad", only=("F_cr",))
    assert found["F_cr"].model < 0.2
    assert found["F_cr"].apart == pytest.approx(0.0, abs=3.0 * MESH)


def test_the_stress_of_blades_shorter_than_four_thicknesses_is_not_compared():
    """What is two thicknesses from one clamp is beside the other."""
    found, _ = numbers(
        "{kind: guided-blade, h: 3 mm, l: 10 mm, b: 3 mm}", SMALL_SHIFT, nu=0.3, only=("sigma",)
    )
    assert "too short" in found["sigma"].why


ASKEW = """\
flexure: 1
material:
  extends: silicon
  orientation: {{wafer: "{wafer}", turned: {turned} deg, width: {width}}}
geometry: {geometry}
cases: {{a: {{stroke: {{{stroke}}}}}}}
requirements: {{stiffness: {{min: {least} {unit}}}}}
"""


@pytest.mark.parametrize(
    ("wafer", "turned", "width", "geometry", "stroke", "unit", "most"),
    [
        ("111", 10, "normal", "{kind: cantilever, h: 0.3 mm, l: 10 mm, b: 2 mm}",
         "translation: 1 um", "N/m", 0.02),
        ("100", 30, "in-plane",
         "{kind: leaf-spring-stage, h: 0.3 mm, l: 10 mm, b: 2 mm, spacing: 10 mm, blades: 2}",
         "translation: 1 um", "N/m", 0.02),
        ("111", 25, "normal",
         "{kind: rcc, h: 0.2 mm, l: 10 mm, b: 3 mm, p: 2 mm, half_angle: 40 deg}",
         "rotation: 1 mrad", "N*m/rad", 0.025),
    ],
)  # fmt: skip
def test_solids_of_blades_that_twist_as_they_bend_are_within_what_plates_tell(
    wafer, turned, width, geometry, stroke, unit, most
):
    words = {"wafer": wafer, "turned": turned, "width": width, "geometry": geometry,
             "stroke": stroke, "unit": unit}  # fmt: skip
    (number, *_) = flexcli.verify(ASKEW.format(**words, least=1)).verification.numbers
    # plates are asked near what is required alone
    checked = flexcli.check(ASKEW.format(**words, least=number.solid))
    low, high = next(row.factor_range for row in checked.checks if row.kind)
    assert high / low < 1.0 + most
    assert low * (1.0 - MESH) <= 1.0 <= high * (1.0 + MESH)
    assert number.agrees
