"""A parasitic shift at a temperature: the share of the stroke, that of the heat, and the range."""

import numpy as np
import pytest
import yaml
from twins.drawn_in_space import in_space

import flexcli
from flexcli.formulas.sheet_factors import held_growth

ALPHA, NU = 8.6e-6, 0.342
MATERIAL = {"name": "m", "youngs_modulus": "113.8 GPa", "poisson_ratio": NU,
            "density": "4430 kg/m^3", "yield_strength": "880 MPa",
            "thermal_expansion": f"{ALPHA} 1/K"}  # fmt: skip
STAGE = {"kind": "leaf-spring-stage", "h": "1 mm", "l": "20 mm", "b": "20 mm", "blades": 2,
         "spacing": "20 mm"}  # fmt: skip
PIVOT = {"kind": "cross-spring", "h": "0.4 mm", "l": "20 mm", "b": "10 mm", "delta": -0.3,
         "half_angle": "45 deg"}  # fmt: skip
RCC = {"kind": "rcc", "h": "0.1 mm", "l": "20 mm", "b": "5 mm", "half_angle": "45 deg",
       "p": "5 mm"}  # fmt: skip
NOTCH = {"kind": "notch-hinge", "e": "1 mm", "r": "5 mm", "b": "15 mm"}
HOT, PUSHED = {"bodies": {"moving": "40 K", "ground": "40 K"}}, {"translation": "0.2 mm"}
WARM = {"uniform": "20 K", "bodies": {"moving": "40 K"}}


def spec(geometry, temperature=None, stroke=None, material=None, most=1e-3):
    case = {"temperature": temperature, "stroke": stroke}
    return {
        "flexure": 1,
        "material": MATERIAL | (material or {}),
        "geometry": geometry,
        "cases": {"c": {key: words for key, words in case.items() if words}},
        "requirements": {"parasitic_shift": {"max": f"{most!r} m"}},
    }


def only(spec, model=None):
    (check,) = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
    return check


def sizes(spec, model=None):
    """Return between which sizes a shift is [m]."""
    check = only(spec, model)
    low, high = check.factor_range
    return check.capacity / high, check.capacity / low


@pytest.mark.parametrize(
    ("geometry", "temperature", "stroke", "solid", "width"),
    [
        (STAGE, HOT, None, 4.1478e-6, 0.016),
        (STAGE, HOT, PUSHED, 5.3491e-6, 0.018),
        (PIVOT, WARM, None, 7.0499e-6, 0.005),
        (PIVOT, WARM, {"rotation": "1 deg"}, 6.5493e-6, 0.006),
        (NOTCH, {"bodies": {"moving": "60 K", "ground": "60 K"}}, None, 6.9632e-6, 0.6),
        (NOTCH, {"bodies": {"moving": "60 K", "ground": "60 K"}}, {"rotation": "0.5 deg"},
         6.9410e-6, 0.6),
    ],
)  # fmt: skip
def test_a_warm_shift_is_that_of_solids(geometry, temperature, stroke, solid, width):
    """CalculiX, C3D20R, 2160 bricks of blades and 3888 of the notch, clamps rigid."""
    low, high = sizes(spec(geometry, temperature, stroke), "exact")
    assert low < solid < high
    assert high / low - 1.0 < width


def test_what_a_stroke_leaves_open_counts_on_its_own_share_alone():
    turn = {"rotation": "20 mrad"}
    alone, heat, both = (
        sizes(spec(PIVOT, *each), "exact") for each in ((None, turn), (WARM, None), (WARM, turn))
    )
    of_stroke, of_heat, of_both = (high - low for low, high in (alone, heat, both))
    # a little is of how they act on each other
    assert of_stroke + of_heat < of_both < 1.2 * (of_stroke + of_heat)
    assert of_stroke / alone[0] > 1.5 * of_both / both[0]


def test_shells_narrow_the_share_of_the_stroke():
    stroke, warm = {"rotation": "2 deg"}, {"uniform": "1 K", "bodies": {"moving": "1 K"}}
    each = spec(RCC, warm, stroke)
    (low, high), (least, most) = sizes(each, "shell"), sizes(each, "exact")
    assert least < low < high < most
    assert high - low < 0.5 * (most - least)


def test_a_stroke_to_one_side_has_no_end_on_the_other():
    grown = {"gradient": {"y": "500 K/m"}}
    one, other, both = (
        only(spec(RCC, grown, {"rotation": ends}), "exact").demand
        for ends in (["0 deg", "3 deg"], ["-3 deg", "0 deg"], "3 deg")
    )
    assert both == pytest.approx(max(one, other), rel=1e-6)
    assert min(one, other) < (1.0 - 1e-4) * both


E_0, STEEP = 113.8e9, 1e-3
SOFTENS = {"over_temperature": {"youngs_modulus": {"points": [
    [f"{293 + change} K", f"{E_0 * (1.0 - STEEP * change)!r} Pa"] for change in (-290, 390)
]}}}  # fmt: skip
STAR = {"kind": "star", "h": "0.1 mm", "l": "40 mm", "b": "2 mm", "p": "10 mm",
        "angles": ["0 deg", "110 deg", "250 deg"]}  # fmt: skip


def test_blades_of_their_own_moduli_share_what_does_not_fit_by_them():
    """A body stands where the pulls of its spokes balance: Σ k (n·u − δ) n = 0, k as E."""
    cold = {"uniform": "-120 K", "gradient": {"x": "2000 K/m"},
           "expansion": {"ground": "0 1/K", "moving": "0 1/K"}}  # fmt: skip
    still = {"rotation": "1e-9 rad"}
    own, alike = (spec(STAR, cold, still, each) for each in (SOFTENS, None))
    design = flexcli.load(yaml.safe_dump(own)).part
    layout = design.geometry.layout(design.material.elastic, design.fixed_sizes())
    changes = design.scene("c").temperature.changes(layout, design.geometry.axes).blades
    held = 1.0 + float(held_growth(b=2e-3, h=1e-4, l=40e-3, poisson_ratio=NU))

    def moved(steep):
        pulls, off = np.zeros((2, 2)), np.zeros(2)
        for blade in layout.blades:
            n = np.subtract(blade.end, blade.start)
            l, change = np.hypot(*n), changes[blade.name]
            k = 1.0 - steep * change
            pulls += k * np.outer(n, n) / l**2
            off += k * ALPHA * change * held * n
        return float(np.hypot(*np.linalg.solve(pulls, off)))

    for each, steep in ((own, STEEP), (alike, 0.0)):
        low, high = sizes(each, "exact")
        assert low < moved(steep) < high
    # where nobody says how the modulus changes it may by as much as any does
    (low, high), (least, most) = sizes(own, "exact"), sizes(alike, "exact")
    assert high / low < 1.01
    assert least < low < high < most
    assert moved(STEEP) / moved(0.0) - 1.0 == pytest.approx(
        only(own, "exact").demand / only(alike, "exact").demand - 1.0, rel=0.05
    )
    assert abs(moved(STEEP) / moved(0.0) - 1.0) > 0.03


@pytest.mark.parametrize("stroke", [{"rotation": "1 deg"}, {"rotation": ["0 deg", "3 deg"]}])
def test_a_joint_drawn_in_space_has_the_same(stroke):
    flat = spec(RCC, {"uniform": "30 K", "bodies": {"ground": "40 K"}}, stroke)
    twin = in_space(flat, flexcli.load(yaml.safe_dump(flat)))
    assert twin is not None
    mine, theirs = sizes(flat, "exact"), sizes(twin, "exact")
    assert mine[0] < theirs[1]
    assert theirs[0] < mine[1]


def test_a_poissons_ratio_that_is_not_given_leaves_open_what_any_makes():
    unknown = spec(STAGE, HOT)
    del unknown["material"]["poisson_ratio"]
    low, high = sizes(unknown, "exact")
    for nu in (0.0, 0.25, 0.45):
        assert low < only(spec(STAGE, HOT, material={"poisson_ratio": nu}), "exact").demand < high


def drawn(geometry, temperature, stroke, material):
    """Return a stage drawn in space, what moves along y asked besides."""
    own = spec(geometry, temperature, stroke, material)
    twin = in_space(own, flexcli.load(yaml.safe_dump(own)))
    asked = [{"direction": "y", "max": "1 mm"}]
    return own, twin, {**twin, "requirements": {"parasitic_motion": asked}}


@pytest.mark.parametrize("table", [SOFTENS, None])
@pytest.mark.parametrize(
    ("grown", "stroke"),
    [
        ({"gradient": {"x": "2000 K/m"}, "expansion": {"moving": "3e-6 1/K"}}, None),
        ({"gradient": {"x": "2000 K/m"}}, {"translation": ["0 um", "0.2 um"]}),
        ({"gradient": {"x": "-2000 K/m"}}, {"translation": ["0.2 um", "0.2 um"]}),
    ],
)
def test_blades_whose_moduli_differ_by_temperature_move_a_body_aside_in_space_too(
    table, grown, stroke
):
    """In the first order: the plane's blades have their own moduli, those in space one."""
    one, twin, along = drawn({**STAGE, "spacing": "25 mm"}, grown, stroke, table)
    shift, (least, most) = only(one, "exact").demand, sizes(twin, "exact")
    assert least <= shift <= most
    checks = flexcli.verdicts(yaml.safe_dump(along)).checks
    assert max(check.demand for check in checks) >= shift
