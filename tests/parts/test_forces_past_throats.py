"""Forces that pass a hinge across its thickness: what no beam has of the stress beside it."""

import pytest
import yaml

import flexcli

MATERIAL = {
    "name": "drawn", "youngs_modulus": "114 GPa", "yield_strength": "900 MPa",
    "tensile_strength": "1 GPa", "density": "4430 kg/m^3",
}  # fmt: skip
NOTCH = {"kind": "notch-hinge", "r": "1 mm"}
SHALLOW = {"kind": "elliptic-hinge", "depth": "0.2 mm", "l": "0.9 mm"}
FILLETED = {"kind": "filleted-hinge", "r": "1 mm", "h": "0.3 mm", "l": "2.2 mm"}


def checked(geometry, wrench, requirements, model, nu=0.0):
    spec = {
        "flexure": 1,
        "title": "a load across a joint",
        "material": {**MATERIAL, "poisson_ratio": nu},
        "geometry": {**geometry, "blocks": "massive"} if "hinge" in geometry["kind"] else geometry,
        "cases": {"work": {"wrench": wrench}},
        "requirements": requirements,
    }
    return flexcli.verdicts(yaml.safe_dump(spec), model=model).checks[-1]


@pytest.mark.parametrize(
    ("geometry", "more"),
    [
        (NOTCH | {"e": "0.1 mm", "b": "0.4 mm"}, 1.03),
        (NOTCH | {"e": "0.4 mm", "b": "0.6 mm"}, 1.15),
        (SHALLOW | {"e": "0.3 mm", "b": "1 mm"}, 1.15),
        (FILLETED | {"b": "1 mm"}, 1.05),
    ],
)
def test_the_stress_of_a_force_across_the_throat_is_that_of_solids(geometry, more):
    beams, solids = (
        checked(geometry, {"y": "1 mN"}, {"yield": 1}, model) for model in ("exact", "solid")
    )
    low, high = beams.factor_range
    least, most = solids.factor_range
    assert low < most
    assert least < high
    # it is well above what the moment makes of the section, in the concentration of bending
    assert beams.factor == pytest.approx(solids.factor, rel=0.04)
    assert high < 1.25 * low
    nominal = checked(
        geometry | {"stress-concentration": "none"}, {"y": "1 mN"}, {"yield": 1}, "exact"
    )
    assert nominal.factor > more * beams.factor


@pytest.mark.parametrize(("b", "more"), [("1 mm", 1.07), ("2 mm", 1.05)])
def test_the_middle_of_wide_fillets_bears_more_of_a_force_across_as_of_a_moment(b, more):
    slender = {"kind": "filleted-hinge", "h": "0.1 mm", "r": "0.2 mm", "l": "6.4 mm", "b": b}
    beams, solids = (
        checked(slender, {"y": "1 mN"}, {"yield": 1}, model, 0.3) for model in ("exact", "solid")
    )
    assert beams.factor > more * solids.factor
    assert beams.factor_range[0] < solids.factor_range[0]
    assert beams.factor_range[0] > 0.75 * solids.factor


@pytest.mark.parametrize(("b", "within"), [("0.1 mm", 0.006), ("0.6 mm", 0.04), ("2 mm", 0.12)])
def test_blunt_fillets_clamp_a_blade_that_is_narrow_against_their_length_hardly(b, within):
    # r = 30 h; a clamp would raise the middle by 0.21, a tenth of it for each b/h
    blunt = {"kind": "filleted-hinge", "h": "0.1 mm", "r": "3 mm", "l": "8 mm", "b": b}
    beams, solids = (
        checked(blunt, {"theta_z": "1 uN*m"}, {"yield": 1}, model, 0.3)
        for model in ("exact", "solid")
    )
    low, high = beams.factor_range
    assert low < solids.factor_range[1]
    assert solids.factor_range[0] < high
    assert 1.0 - low / beams.factor < within


PIVOT = {
    "kind": "hinged-pivot", "e": "0.03 mm", "r": "1 mm", "b": "1 mm", "l": "6 mm", "p": "6 mm",
    "half_angle": "40 deg",
}  # fmt: skip


@pytest.mark.parametrize("nu", [0.3, 0.45])
@pytest.mark.parametrize(
    "geometry",
    [NOTCH | {"e": "20 um", "b": "0.15 mm"}, NOTCH | {"e": "0.2 mm", "b": "2 mm"}, PIVOT],
    ids=["narrow", "wide", "pivot"],
)
def test_the_middle_of_a_throat_bears_more_of_a_force_along_it_as_in_solids(geometry, nu):
    beams, solids = (
        checked(geometry, {"x": "1 mN"}, {"yield": 1}, model, nu) for model in ("exact", "solid")
    )
    low, high = beams.factor_range
    assert low < solids.factor < high
    assert beams.factor == pytest.approx(solids.factor, rel=0.01)
    assert high < 1.06 * low


def test_a_moment_alone_stresses_the_throat_as_before():
    geometry = NOTCH | {"e": "0.4 mm", "b": "0.6 mm"}
    beams, solids = (
        checked(geometry, {"theta_z": "1 uN*m"}, {"yield": 1}, model)
        for model in ("exact", "solid")
    )
    assert beams.factor == pytest.approx(solids.factor, rel=0.01)


@pytest.mark.parametrize("model", ["closed-form", "exact"])
def test_a_tiny_load_is_as_unsure_as_a_small_one(model):
    stage = {
        "kind": "hinged-stage", "e": "3 um", "r": "0.18 mm", "b": "59 um", "l": "2 mm",
        "spacing": "2 mm", "limbs": 2, "blocks": "0.2 mm",
    }  # fmt: skip
    easy = {"deflection": {"direction": "theta_y", "max": "1 rad"}}
    small, tiny = (
        checked(stage, {"theta_y": load}, easy, model, 0.3) for load in ("1e-9 N*m", "1e-12 N*m")
    )
    for one, other in zip(small.factor_range, tiny.factor_range, strict=True):
        assert one / small.factor == pytest.approx(other / tiny.factor, rel=1e-4)
    assert tiny.factor_range[1] > 1.05 * tiny.factor_range[0]


def test_what_is_guided_does_not_turn_however_it_is_twisted():
    blade = {"kind": "guided-blade", "h": "0.2 mm", "l": "20 mm", "b": "5 mm"}
    easy = {"deflection": {"direction": "theta_z", "max": "1 mrad"}}
    assert checked(blade, {"theta_z": "1 mN*m"}, easy, "exact").verdict == "pass"
