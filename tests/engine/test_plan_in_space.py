"""A plan in space: its estimates hold what is left out, and it takes the cheapest that does."""

from math import pi

import pytest
import yaml

import flexcli
from flexcli.results import Status

L, B, H = 100e-3, 20e-3, 0.5e-3
E = 190e9
MASS = 0.8
TO_EACH = {"h": f"{H} m", "b": f"{B} m", "width": "z", "mirror": ["x"]}
LEAF = {"between": ["ground", "stage"], "from": ["40 mm", "0 mm", "0 mm"],
        "to": ["40 mm", "100 mm", "0 mm"], **TO_EACH}  # fmt: skip


def guide(**case):
    return {
        "flexure": 1,
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.3, "yield_strength": "1 GPa",
                     "density": "8000 kg/m^3"},
        "geometry": {
            "kind": "space-layout",
            "bodies": {"stage": {"at": ["0 mm", "100 mm", "0 mm"], "mass": f"{MASS} kg",
                                 "com": ["0 mm", "100 mm", "0 mm"],
                                 "inertia": ["1e-3 kg*m^2", "1e-3 kg*m^2", "1e-3 kg*m^2"]}},
            "blades": {"leaf": LEAF},
            "moving": "stage",
            "motion": {"translation": "x"},
        },
        "cases": {"work": case},
        "requirements": {"yield": 1.5} if "stroke" in case else {"dynamic-yield": 1.5},
    }  # fmt: skip


def plan(spec, **how):
    return flexcli.plan(yaml.safe_dump(spec), **how)


@pytest.mark.parametrize(("stroke", "model"), [("20 um", "linear"), ("15 mm", "exact")])
def test_a_large_stroke_takes_exact_blades_and_a_small_one_does_not(stroke, model):
    spec = guide(stroke={"translation": stroke})
    found = plan({**spec, "accuracy": "10 %"}).plan
    assert found.model == model
    assert found.estimated_error <= 0.1
    costs = {row.name: row.cost for row in found.models}
    assert list(costs) == ["linear", "exact"][: 1 + (model == "exact")], "no finer one is asked"


@pytest.mark.slow
def test_what_effects_change_stays_within_their_estimates():
    support = {"support": {"direction": "z", "min": "1 N/m", "at": "full-stroke"}}
    spec = guide(stroke={"translation": "10 mm"})
    result = plan({**spec, "requirements": {"yield": 1.5, **support}}, audit=True)
    asked = {"stiffness", "stress", "shift", "frequency", "support"}
    names = {"large rotation": {"stress", "shift"}, "plate widening": asked,
             "anticlastic": asked, "warping": asked}  # fmt: skip
    assert {row.effect for row in result.audit} == set(names)
    for effect, quantities in names.items():
        rows = [row for row in result.audit if row.effect == effect]
        assert {row.quantity for row in rows} == quantities
        for row in rows:
            assert abs(row.true) <= row.estimate * (1.0 + 1e-6) + 1e-9, row
    (warps,) = (r for r in result.audit if (r.effect, r.quantity) == ("warping", "support"))
    assert warps.true > 0.5


def test_values_of_a_spec_that_asks_for_accuracy_are_by_the_model_of_its_plan():
    spec = {**guide(stroke={"translation": "10 mm"}), "accuracy": "10 %"}
    result = flexcli.check(yaml.safe_dump(spec))
    assert result.status is Status.PASS
    assert result.values["shift"].model == result.plan.model
    assert result.values["shift"].estimated_error <= 0.1


@pytest.mark.slow
def test_stiffening_is_the_axial_force_over_that_which_buckles_a_guided_blade():
    # far below its modes along the blades, each of them bears half of the mass
    level = 50.0
    sine = {"acceleration": f"{level} m/s^2", "frequency": "2 Hz", "axis": "y"}
    found = plan(guide(sine=sine, q=20))
    (row,) = (e for e in found.effects if e.name.startswith("stress stiffening"))
    I = B * H**3 / 12.0
    blade = 8000.0 * L * B * H
    share = (MASS + blade) * level / 2.0 * L**2 / (pi**2 * E * I)
    # a wide blade bends up to 1/(1 - ν²) stiffer, and half of its mass hangs on the stage
    assert 0.88 * share <= row.indicator <= 1.01 * share


@pytest.mark.slow
def test_rows_of_a_vibration_in_space_tell_modes_blade_mass_and_second_order():
    vibration = {"axes": {"x": {"asd": "gevs-acceptance", "scale": "-20 dB"}}, "q": 20}
    found = {row.name.partition(",")[0]: row for row in plan(guide(**vibration)).effects}
    assert {"duration in the peak", "large rotation", "stress stiffening", "higher modes",
            "blade mass"} <= set(found)  # fmt: skip
