"""The own motion of a mechanism with all that has mass, against small systems by hand."""

from math import pi, sqrt, tan

import numpy as np
import pytest
import yaml
from thick_beam import timoshenko

from flexcli.engine import omitted_effects
from flexcli.formulas.handbook.tip_mass import tip_mass_frequencies
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects.blade_mass import BladeMass
from flexcli.parts.elastic import Elastic
from flexcli.parts.mechanisms.carried import carried
from flexcli.parts.own_motion import (
    either_mode,
    hanging_mass,
    own_angular,
    own_mode,
    structure_of,
)

E, RHO = 114e9, 4430.0
MATERIAL = {"name": "titanium", "youngs_modulus": "114 GPa", "poisson_ratio": 0.3,
            "yield_strength": "900 MPa", "density": "4430 kg/m^3"}  # fmt: skip
STRIP = {"h": "0.3 mm", "b": "10 mm"}


def folded(frame="2 kg", stage="1 kg"):
    """Two parallel stages in series, the second folded back: the frame carries the stage."""

    def pair(name, bodies, ends, y):
        return {
            f"{name}-{side}": {
                "between": list(bodies), **STRIP,
                "from": [f"{ends[0]} mm", f"{sign * y} mm"],
                "to": [f"{ends[1]} mm", f"{sign * y} mm"],
            }
            for side, sign in ((1, -1), (2, 1))
        }  # fmt: skip

    return {
        "kind": "layout",
        "moving": "stage",
        "motion": {"translation": "90 deg"},
        "bodies": {
            "frame": {"at": ["25 mm", "0 mm"], "mass": frame},
            "stage": {"at": ["25 mm", "0 mm"], "mass": stage},
        },
        "blades": pair("outer", ("ground", "frame"), (0, 50), 40)
        | pair("inner", ("frame", "stage"), (50, 0), 15),
    }


def design(geometry, mechanism=None, case=None, **more):
    given = {
        "flexure": 1,
        "material": {**MATERIAL, **more.pop("material", {})},
        "geometry": geometry,
        "cases": {"op": case or {"stroke": {"translation": "1 mm"}}},
        "requirements": {"frequency": {"min": "1 Hz"}},
        **more,
    }
    if mechanism is not None:
        given["mechanism"] = mechanism
    return DesignSpec.model_validate(yaml.safe_load(yaml.safe_dump(given)))


def frequency(found, *, thick=False):
    sizes = found.fixed_sizes()
    elastic = found.material.elastic
    joint = carried(found.geometry, elastic, sizes, thick=thick).motion_stiffness
    mode = own_mode(found.mechanism, joint, found.geometry, elastic, sizes)
    return sqrt(float(mode.stiffness) / mode.mass) / (2.0 * pi)


def change(found):
    return BladeMass().changes(omitted_effects.setting(found, found.fixed_sizes()))


@pytest.mark.parametrize("payload", [None, {"kind": "payload", "mass": "50 g"}])
def test_all_bodies_of_a_folded_stage_move(payload):
    k = 24.0 * E * 10e-3 * 0.3e-3**3 / 12.0 / 50e-3**3
    M = np.diag([2.0, 1.0 + (0.05 if payload else 0.0)])
    K = k * np.array([[2.0, -1.0], [-1.0, 1.0]])
    lowest = sqrt(min(np.linalg.eigvals(np.linalg.solve(M, K)).real)) / (2.0 * pi)
    # the blades' stretching lets the bodies rock by (h/spacing)²
    assert frequency(design(folded(), payload)) == pytest.approx(lowest, rel=1e-3)


def test_a_light_frame_leaves_the_stage_on_two_springs_in_series():
    k = 12.0 * E * 10e-3 * 0.3e-3**3 / 12.0 / 50e-3**3
    found = frequency(design(folded(frame="0 g")))
    assert found == pytest.approx(sqrt(k / 1.0) / (2.0 * pi), rel=1e-3)


def test_everything_in_a_folded_stage_hangs_on_it():
    """Along the stroke the stage sags by its weight on both pairs, the frame's on the outer."""
    found = design(folded())
    sizes = found.fixed_sizes()
    mass = hanging_mass(None, found.geometry, found.material.elastic, sizes, "x")
    assert mass == pytest.approx(1.0 + 2.0 / 2.0, rel=1e-3)
    payload = design(folded(), {"kind": "payload", "mass": "0.5 kg"})
    carried_mass = hanging_mass(
        payload.mechanism, payload.geometry, payload.material.elastic, sizes, "x"
    )
    assert carried_mass == pytest.approx(1.5 + 2.0 / 2.0, rel=1e-3)


CANTILEVER = {"kind": "cantilever", "h": "0.5 mm", "l": "30 mm", "b": "10 mm"}


BEAM = {"h": 0.5e-3, "l": 30e-3, "b": 10e-3}
BODIES = [
    {"m": grams * 1e-3, "c": offset} for grams in (0.03, 0.3, 3.0, 300.0) for offset in (0.0, 10e-3)
] + [{"m": 3e-3, "J": 4e-7}]


def carrying(m, c=0.0, J=0.0, **more):
    """Give a cantilever with a body at its tip."""
    body = {"kind": "payload", "mass": f"{m} kg", "inertia": f"{J} kg*m^2"}
    if not J:
        body = {"kind": "tip-mass", "mass": f"{m} kg", "offset": f"{c} m"}
    return design(CANTILEVER, body, **more)


@pytest.mark.parametrize("body", BODIES)
def test_a_blade_that_does_not_shear_has_the_frequency_of_the_beam_equation(body):
    """Nobody knows a shear modulus without Poisson's ratio."""
    found = carrying(**body, material={"poisson_ratio": None})
    h, l, b = BEAM.values()
    line = RHO * b * h
    exact = tip_mass_frequencies(E=E, I=b * h**3 / 12.0, L=l, mass_per_length=line, **body)[0]
    made = frequency(found) * (1.0 + change(found)["frequency"].value)
    assert made == pytest.approx(float(exact), rel=1e-5)


@pytest.mark.parametrize("body", BODIES)
def test_a_blade_that_shears_has_the_frequency_of_timoshenkos_equations(body):
    found = carrying(**body)
    made = frequency(found, thick=True) * (1.0 + change(found)["frequency"].value)
    below, above = (
        timoshenko(2.0 * pi * made * (1.0 + off), E=E, G=E / 2.6, rho=RHO, **BEAM, **body)
        for off in (-1e-5, 1e-5)
    )
    assert below * above < 0.0


STAGE = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "10 mm"}
LIGHT = {"kind": "payload", "mass": "2 g"}


def test_no_density_means_anything_from_no_mass_to_the_densest_metal():
    known = change(design(STAGE, LIGHT))["frequency"]
    silent = design(STAGE, LIGHT)
    material = silent.material.model_copy(update={"density": None})
    unknown = change(silent.model_copy(update={"material": material}))["frequency"]
    assert unknown.value is None
    assert unknown.sign == -1
    assert unknown.bound > abs(known.value)
    heaviest = change(design(STAGE, LIGHT, material={"density": "22.6 g/cm^3"}))["frequency"]
    lowest = (1.0 + heaviest.value) * (1.0 - heaviest.error)
    assert 1.0 - unknown.bound == pytest.approx(lowest, rel=1e-9)


def test_limbs_without_a_stated_mass_lower_the_frequency_nobody_knows_how_far():
    hinged = {"kind": "hinged-stage", "e": "0.1 mm", "r": "2 mm", "l": "30 mm", "b": "10 mm",
              "spacing": "40 mm"}  # fmt: skip
    found = change(design(hinged, {"kind": "payload", "mass": "0.2 kg"}))["frequency"]
    assert found.value is None
    assert (found.bound, found.sign) == (1.0, -1)  # anywhere from 0 to √(k/m)


@pytest.mark.parametrize("ratio", [1e-3, 0.1, 2.0])
def test_a_torsion_bar_s_inertia_has_the_root_of_beta_tan_beta(ratio):
    d, l = 1e-3, 40e-3
    bar = RHO * pi * d**4 / 32.0 * l
    spec = design(
        {"kind": "round-torsion-bar", "d": "1 mm", "l": "40 mm"},
        {"kind": "payload", "mass": "1 g", "inertia": f"{bar / ratio!r} kg*m^2"},
        {"stroke": {"rotation": "1 deg"}},
    )
    beta = sqrt(ratio) * (1.0 + change(spec)["frequency"].value)
    assert beta * tan(beta) == pytest.approx(ratio, rel=1e-9)


TURNING = {
    "moment-blade": {"h": "0.1 mm", "l": "20 mm", "b": "5 mm"},
    "rcc": {"h": "0.1 mm", "l": "20 mm", "b": "5 mm", "p": "3 mm", "half_angle": "40 deg"},
    "three-blade": {"h": "0.1 mm", "l": "20 mm", "b": "5 mm", "p": "1 mm"},
    "notch-hinge": {"e": "0.05 mm", "r": "2 mm", "b": "5 mm"},
}


@pytest.mark.parametrize("kind", TURNING)
def test_a_payload_in_the_centre_of_a_pivot_of_light_blades_only_turns(kind):
    body = {"kind": "payload", "mass": "20 g", "inertia": "4000 g*mm^2"}
    spec = {"stroke": {"rotation": "1 deg"}}
    light = {"density": "1e-3 kg/m^3"}
    found = change(design({"kind": kind, **TURNING[kind]}, body, spec, material=light))
    # the centre of the pivot yields by (h/l)²
    assert abs(found["frequency"].value) < 1e-3


PIVOT = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg",
         "h": "0.6 mm", "l": "17 mm", "b": "10 mm"}  # fmt: skip
LEVER = {"mass": "17 g", "com": "10 mm", "inertia": "5e-6 kg*m^2"}
LEVERS = {"kind": "parallel-stage", "height": "20 mm", "solid-1": LEVER,
          "solid-2": {"mass": "68 g"}, "solid-3": LEVER}  # fmt: skip


@pytest.mark.parametrize("bisector", ["0 deg", "90 deg", "30 deg"])
def test_the_blades_of_a_parallel_stage_move_with_its_levers(bisector):
    """By kinetic energy of the static shapes, and by the modes: a few thousandths apart."""
    stage = {**LEVERS, "bisector": bisector}
    turned = {"stroke": {"translation": "0.1 mm"}}
    modes = design(PIVOT, stage, turned)
    stated = design(PIVOT, {**stage, "pivot-stiffness": "15 N*m/rad"}, turned)
    elastic, sizes = Elastic(E, 0.3), modes.fixed_sizes()
    light, heavy = (
        own_angular(structure_of(modes.mechanism, modes.geometry, elastic, sizes, None, rho))
        for rho in (0.0, RHO)
    )
    assert heavy < light
    static = change(stated)["frequency"].value
    assert static == pytest.approx(heavy / light - 1.0, rel=0.01)


def test_a_sag_counts_the_blades():
    """A cantilever's own weight at its tip is 3/8 of its mass."""
    found = design(
        CANTILEVER, {"kind": "payload", "mass": "3 g"},
        {"acceleration": {"level": "1 g", "axis": "x"}}, requirements={"sag": {"max": "1 mm"}},
    )  # fmt: skip
    share = change(found)["sag"].value * 3e-3 / (RHO * 0.5e-3 * 10e-3 * 30e-3)
    # shear: its part of the sag of a uniform load is larger than of a load at the tip
    assert share == pytest.approx(3.0 / 8.0, rel=1e-3)


def test_the_sag_of_a_blade_that_outweighs_what_it_carries_is_as_sure_as_its_own_part():
    """Timoshenko's cantilever under its own weight sags by q l⁴/(8 E I) + q l²/(2 κ G A)."""
    h, b, l, m = 3e-3, 10e-3, 30e-3, 0.1e-3
    found = change(
        design(
            CANTILEVER | {"h": "3 mm"}, {"kind": "payload", "mass": "0.1 g"},
            {"acceleration": {"level": "1 g", "axis": "x"}}, requirements={"sag": {"max": "1 mm"}},
        )
    )["sag"]  # fmt: skip
    I, A, G = b * h**3 / 12.0, b * h, E / 2.6
    q, kappa = RHO * A, 5.0 / 6.0
    light = m * l**3 / (3.0 * E * I) + m * l / (kappa * G * A)
    own = q * l**4 / (8.0 * E * I) + q * l**2 / (2.0 * kappa * G * A)
    assert found.value > 10.0
    assert (1.0 + own / light) / (1.0 + found.value) == pytest.approx(1.0, abs=found.error)
    assert found.error < 0.05


@pytest.mark.parametrize(("outer", "counts"), [("1.3 mm", True), ("1.45 mm", False)])
def test_a_mode_whose_part_is_about_as_small_as_counts_is_in_the_range(outer, counts):
    """A heavy frame on stiff blades has 1.2 % or 0.9 % of the stage's compliance; 1 % counts."""
    geometry = folded(frame="50000 kg", stage="1 kg")
    for name in ("outer-1", "outer-2"):
        geometry["blades"][name]["h"] = outer
    found = design(geometry)
    of = found.geometry, Elastic(E, 0.3), found.fixed_sizes()
    structure = structure_of(None, *of)
    share = (0.3 / float(outer.split()[0])) ** 3 / (1.0 + (0.3 / float(outer.split()[0])) ** 3)
    assert (share > 0.01) == counts
    frame, stage = (
        sqrt(2.0 * 12.0 * E * 10e-3 * h**3 / 12.0 / (50e-3) ** 3 / mass)
        for h, mass in ((float(outer.split()[0]) * 1e-3, 5e4), (0.3e-3, 1.0))
    )
    own, other = (frame, stage) if counts else (stage, frame)
    assert own_angular(structure) == pytest.approx(own, rel=0.02)
    assert either_mode(structure) == pytest.approx(abs(other / own - 1.0), rel=0.05)
    assert change(found)["frequency"].error > 0.9 * either_mode(structure)


def test_a_mode_that_surely_counts_leaves_the_frequency_sure():
    found = design(folded())
    assert (
        either_mode(structure_of(None, found.geometry, Elastic(E, 0.3), found.fixed_sizes())) == 0
    )
