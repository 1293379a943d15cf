"""What accelerated blades weigh is in the stresses of a joint, or in their range."""

from dataclasses import replace

import numpy as np
import pytest
import yaml

import flexcli
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Body, Load
from flexcli.mechanics.stresses import greatest_stress
from flexcli.parts.geometries.base import MOVING

MATERIAL = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.33, "yield_strength": "800 MPa",
            "density": "4430 kg/m^3"}  # fmt: skip
RCC = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg", "h": "0.3 mm", "l": "14 mm",
       "b": "1 mm"}  # fmt: skip
STAGE = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "1 mm",
         "spacing": "15 mm"}  # fmt: skip
CANTILEVER = {"kind": "cantilever", "h": "0.3 mm", "l": "20 mm", "b": "1 mm"}
DESIGNS = {"rcc": RCC, "stage": STAGE, "cantilever": CANTILEVER}
MASS = 2e-3
PARTS = 24


def spec(geometry, acceleration, requirements=None, **more):
    material = {k: v for k, v in {**MATERIAL, **more.pop("material", {})}.items() if v is not None}
    return yaml.safe_dump(
        {
            "flexure": 1, "material": material, "geometry": geometry,
            "mechanism": {"kind": "payload", "mass": f"{MASS} kg"},
            "cases": {"launch": {"acceleration": acceleration, **more}},
            "requirements": requirements or {"yield": 1.5},
        }
    )  # fmt: skip


def judged(*of, name="yield", model=None, **more):
    found = flexcli.verdicts(spec(*of, **more), model=model)
    return next(check for check in found.checks if check.name.startswith(name))


def in_pieces(layout, density, x, y):
    """Return a layout whose blades are chains of many with masses between, and their loads."""
    bodies, blades, loads = list(layout.bodies), [], []
    for blade in layout.blades:
        places = np.linspace(blade.start, blade.end, PARTS + 1)
        length = np.hypot(*np.subtract(blade.end, blade.start))
        mass = density * blade.b * blade.profile.h * length / PARTS
        names = [blade.first, *(f"{blade.name}.{k}" for k in range(1, PARTS)), blade.second]
        inner = ((names[k], tuple(places[k])) for k in range(1, PARTS))
        bodies += [Body(name, place, mass, 0.0, place) for name, place in inner]
        loads.append(Load(blade.second, blade.end, (mass / 2.0 * x, mass / 2.0 * y)))
        for k in range(PARTS):
            start, end = map(tuple, places[k : k + 2])
            blades.append(
                replace(
                    blade, name=f"{blade.name}:{k}", start=start, end=end,
                    first=names[k], second=names[k + 1],
                )
            )  # fmt: skip
    loads += [Load(b.name, b.com, (b.mass * x, b.mass * y)) for b in bodies if b.mass]
    return replace(layout, bodies=tuple(bodies), blades=tuple(blades)), loads


def stress_in_pieces(geometry, x, y):
    """Return the largest stress under an acceleration, of blades with their mass all along [Pa]."""
    part = flexcli.load(spec(geometry, {"x": "1 g"})).part
    layout = part.geometry.layout(part.material.elastic, part.fixed_sizes())
    turn = part.geometry.axes
    x, y = np.cos(turn) * x - np.sin(turn) * y, np.sin(turn) * x + np.cos(turn) * y
    most = 0.0
    for sense in (1.0, -1.0):
        pieces, loads = in_pieces(layout, 4430.0, sense * x, sense * y)
        point = layout.body(MOVING).point
        loads.append(Load(MOVING, point, (sense * MASS * x, sense * MASS * y)))
        state = solve(pieces, {}, loads=loads).checked()
        most = max(most, float(greatest_stress(state).total.max()))
    return most


@pytest.mark.parametrize("axis", ["x", "y"])
@pytest.mark.parametrize("kind", DESIGNS)
def test_the_stress_is_that_of_blades_with_their_mass_all_along(kind, axis):
    along = 5.0 if (kind, axis) == ("stage", "x") or kind == "cantilever" else 100.0
    truth = stress_in_pieces(DESIGNS[kind], *(along * 9.80665 * (axis == a) for a in "xy"))
    of = DESIGNS[kind], {axis: f"{along} g"}
    for model in (None, "exact"):
        check = judged(*of, model=model)
        low, high = (check.capacity / factor for factor in check.factor_range[::-1])
        assert low * (1.0 - 1e-9) <= truth <= high * (1.0 + 1e-9), model
    assert check.demand == pytest.approx(truth, rel=0.02)
    massless = judged(*of, model="exact", material={"density": "1e-6 kg/m^3"})
    assert massless.demand < 0.995 * truth


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
def test_blades_of_unknown_density_may_weigh_what_the_densest_do(model):
    of = RCC, {"y": "100 g"}
    unknown = judged(*of, model=model, material={"density": None})
    light, heavy = (
        judged(*of, model="exact", material={"density": f"{density} kg/m^3"})
        for density in (1e-6, 22_600)
    )
    known = unknown.factor_range
    assert known is None or known[0] <= heavy.factor <= light.factor <= known[1]


@pytest.mark.parametrize("axis", ["x", "y"])
def test_closed_forms_have_in_their_range_what_blades_weigh(axis):
    of = {**CANTILEVER, "h": "1 mm"}, {axis: "5 g"}
    plain, exact = (judged(*of, model=model) for model in ("closed-form", "exact"))
    assert plain.factor_range is not None
    assert plain.factor_range[0] <= exact.factor <= plain.factor_range[1]
    assert plain.factor_range[0] < 0.99 * plain.factor


def test_limbs_of_unknown_mass_leave_the_stress_of_an_acceleration_open():
    stage = {"kind": "hinged-stage", "e": "0.1 mm", "r": "2 mm", "l": "20 mm", "b": "5 mm",
             "spacing": "15 mm"}  # fmt: skip
    open_, known = (
        judged({**stage, **limb}, {"y": "20 g"}, model="exact")
        for limb in ({}, {"limb": {"mass": "2 g", "inertia": "6e-8 kg*m^2"}})
    )
    assert open_.factor_range is None
    assert known.factor_range is not None


def test_what_blades_weigh_takes_its_share_of_what_buckles():
    of = {**STAGE, "h": "0.1 mm"}, {"y": "20 g"}
    requirements = {"buckling": 1.5}
    case = {
        "requirements": requirements,
        "name": "buckling",
        "model": "closed-form",
        "ends": "clamped-guided",
    }
    heavy, light = (
        judged(*of, **case, material={"density": f"{rho} kg/m^3"}) for rho in (4430, 1e-6)
    )
    blades = 2 * 4430.0 * 0.1e-3 * 20e-3 * 1e-3
    share = 1.0 / (1.0 + blades / MASS) - 1.0
    low, bare = (check.factor_range[0] / check.factor - 1.0 for check in (heavy, light))
    assert low - bare == pytest.approx(share, rel=0.05)


WIDE = {"kind": "cantilever", "h": "0.2 mm", "l": "20 mm", "b": "10 mm"}
FORCE = 0.1


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
@pytest.mark.parametrize("stroke", [None, ("-0.1 mm", "0.1 mm"), ("0.1 mm", "0.4 mm")])
def test_a_force_along_the_stroke_makes_its_own_stress_however_wide_blades_are(model, stroke):
    """6 F l/(b h²) beside 3 E h x/(2 l²) of the stroke, which plates raise by some 6 %."""
    case = {"wrench": {"x": f"{FORCE} N"}}
    reach = 0.0
    if stroke is not None:
        case["stroke"] = {"translation": list(stroke)}
        reach = 0.1e-3 if stroke[0].startswith("-") else 0.4e-3
    text = yaml.safe_dump(
        {
            "flexure": 1, "material": MATERIAL, "geometry": WIDE, "cases": {"c": case},
            "requirements": {"yield": 1.5},
        }
    )  # fmt: skip
    (check,) = flexcli.verdicts(text, model=model).checks
    of_force = 6.0 * FORCE * 20e-3 / (10e-3 * 0.2e-3**2)
    of_stroke = 1.5 * 114e9 * 0.2e-3 * reach / 20e-3**2
    least, most = of_force + of_stroke, of_force + of_stroke / (1.0 - 0.33**2)
    low, high = (check.capacity / factor for factor in check.factor_range[::-1])
    assert low < most
    assert high > least
    assert 0.98 * least < check.demand < 1.04 * most
    if stroke is None:
        assert check.demand == pytest.approx(of_force, rel=1e-3)
    else:
        assert low <= of_force + 1.065 * of_stroke <= high


def test_fillets_weigh_as_their_profile_does():
    """Fillets are short: the stress across blades is near that of uniform ones, and no less."""
    filleted, plain = (
        judged({**STAGE, "h": "0.3 mm", **more}, {"y": "100 g"}, model="exact")
        for more in ({"root_radius": "0.1 mm"}, {})
    )
    light = judged(
        {**STAGE, "h": "0.3 mm", "root_radius": "0.1 mm"}, {"y": "100 g"}, model="exact",
        material={"density": "1e-6 kg/m^3"},
    )  # fmt: skip
    assert filleted.demand > light.demand
    assert 0.98 * plain.demand < filleted.demand < 2.0 * plain.demand
