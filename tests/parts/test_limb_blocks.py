"""What the hinges of limbs are cut into may be stated, which decides stages and pivots of them."""

from functools import cache
from itertools import pairwise
from math import cos, hypot, radians, tan

import pytest
from plates import hinged_limb
from specs_for_tests import in_steel

import flexcli
from flexcli.errors import SpecError
from flexcli.results import Status

E, ANGLE, DELTA = 100e9, 35.0, 0.4
R, B = 1e-3, 0.01e-3
"""Radius of the notches, and a width that keeps nothing flat [m]."""

LIMBS = {"short": (0.6, 2.4), "usual": (0.35, 5.0)}
"""Thickness of the throats and distance between them, in radii."""

BLOCKS = {"square": (1.0, 0.0), "clamped": (0.02, 0.0), "massive": (0.5, 1.0)}
"""Length of the blocks in heights of a mouth, and by which share of it they rise."""

KINDS = ["hinged-stage", "hinged-pivot"]


@cache
def body(limb, block):
    e, l = LIMBS[limb]
    length, rise = BLOCKS[block]
    return hinged_limb.solid(e=e, l=l, block=length, rise=rise, nu=0.0)


def geometry(kind, limb, block=None):
    e, l = LIMBS[limb]
    sizes = {"e": e, "r": 1.0, "l": l}
    found = {"kind": kind, **{name: f"{size!r} mm" for name, size in sizes.items()}}
    found["b"] = f"{B!r} m"
    if block:
        length, rise = BLOCKS[block]
        found["blocks"] = "massive" if rise else f"{length * (e + 2.0)!r} mm"
    if kind == "hinged-stage":
        return found | {"spacing": "20 mm"}
    return found | {"delta": DELTA, "half_angle": f"{ANGLE} deg"}


def moments(limb, block):
    """Return the moments of a limb by a rotation and across its middle, of a pivot turned by 1."""
    found = body(limb, block)
    across = found.swing + found.along / tan(radians(ANGLE)) ** 2
    middle = (0.5 + DELTA) * LIMBS[limb][1]
    return E * B * R**2 / found.turn, E * B * R**2 * middle / across, middle


def stiffness(kind, limb, block):
    """Return the stiffness of the plane bodies [N/m or N·m/rad]."""
    if kind == "hinged-stage":
        return 2.0 * E * B / body(limb, block).swing
    turn, force, middle = moments(limb, block)
    return 2.0 * (turn + force * middle)


def unit(kind):
    return "N/m" if kind == "hinged-stage" else "N*m/rad"


@pytest.mark.parametrize("block", BLOCKS)
@pytest.mark.parametrize("limb", LIMBS)
@pytest.mark.parametrize("kind", KINDS)
def test_stated_blocks_decide_a_stiffness_that_is_open_without_them(kind, limb, block):
    true = stiffness(kind, limb, block)
    room = 0.06 if block == "square" else 0.12
    for share, verdict in ((1.0 + room, Status.FAIL), (1.0 - room, Status.PASS)):
        least = {"stiffness": {"min": f"{share * true!r} {unit(kind)}"}}
        of = geometry(kind, limb, block)
        assert in_steel(of, least, verb=flexcli.verdicts).status is verdict
        if limb == "usual":
            continue
        result = in_steel(geometry(kind, limb), least, model="exact")
        if block == "clamped" and result.status is Status.FAIL:
            assert verdict is Status.FAIL  # no block gives way less
            continue
        assert result.status is Status.UNDECIDED
        assert "needs-blocks" in [note.code for note in result.warnings]


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
@pytest.mark.parametrize("kind", KINDS)
def test_every_model_has_the_stiffness_of_the_bodies_in_its_range(kind, model):
    for limb in LIMBS:
        for block in BLOCKS:
            true = stiffness(kind, limb, block)
            for stated in (block, None):
                asked = {"stiffness": {"min": f"{true!r} {unit(kind)}"}}
                of = geometry(kind, limb, stated)
                (found,) = in_steel(of, asked, model, verb=flexcli.verdicts).checks[-1:]
                if found.factor_range is not None:
                    assert found.factor_range[0] <= 1.0 <= found.factor_range[1]


@pytest.mark.parametrize("limb", LIMBS)
def test_the_stress_of_a_stroke_is_the_peak_in_the_bodies(limb):
    found = body(limb, "square")
    # half a limb's ends turn by −1 and move by 1, and the whole limb by twice as much
    turned = -0.5 * found.turned
    _, force, _ = moments(limb, "square")
    unit_force = force / (2.0 * E * B * R**2)
    across = found.swung * found.swing * unit_force
    along = abs(found.pulled) * found.along * unit_force / tan(radians(ANGLE))
    of_pivot = max((abs(turned + sign * across) + along).max() for sign in (1, -1))
    peaks = {
        "hinged-stage": ("translation", "m", 0.5 * abs(found.swung).max() / R),
        "hinged-pivot": ("rotation", "rad", of_pivot),
    }
    for kind, (way, of_travel, peak) in peaks.items():
        travel = float(1e6 / E / peak)  # 1 MPa
        found = in_steel(
            geometry(kind, limb, "square"), {"yield": 1},
            "exact", cases={"work": {"stroke": {way: f"{travel!r} {of_travel}"}}},
        )  # fmt: skip
        (row,) = (check for check in found.checks if check.name.startswith("yield"))
        low, high = row.factor_range
        assert low <= 1e3 <= high
        assert high < 1.2 * low


@pytest.mark.parametrize("limb", LIMBS)
@pytest.mark.parametrize("block", ["square", "clamped"])
def test_the_shift_is_that_of_the_bodies(limb, block):
    found, l = body(limb, block), LIMBS[limb][1] * R
    travel = 1e-3
    _, force, middle = moments(limb, block)
    turned = force * found.swing / (E * B * R**2) / middle  # of what rigid limbs would be moved by
    gamma = 1.0 + 2.0 * DELTA
    aside = 1.0 - turned
    of_pivot = (gamma * turned) ** 2 * found.sway - found.arc - 2.0 * gamma * aside
    pivot = travel**2 * l / (8.0 * cos(radians(ANGLE))) * of_pivot
    # the limbs stretch, which moves the centre across the bisector
    pivot = hypot(pivot, gamma * aside * travel * l / (2.0 * cos(radians(ANGLE))))
    stage = (travel * l) ** 2 / (2.0 * l) * found.sway
    for kind, way, size, true in (
        ("hinged-stage", "translation", f"{travel * l!r} m", stage),
        ("hinged-pivot", "rotation", f"{travel!r} rad", pivot),
    ):
        asked = {"parasitic_shift": {"max": f"{abs(true)!r} m"}}
        for stated in (block, None):
            result = in_steel(
                geometry(kind, limb, stated),
                asked,
                "exact",
                cases={"work": {"stroke": {way: size}}},
            )
            (row,) = (check for check in result.checks if check.name.startswith("parasitic"))
            if row.factor_range is None:
                assert stated is None
                continue
            low, high = row.factor_range
            assert low <= 1.0 <= (high or 1.0), (kind, stated)


def test_blocks_are_written_as_beside_a_single_notch():
    for wrong in ("solid", "-1 mm", 3):
        with pytest.raises(SpecError):
            in_steel(
                geometry("hinged-stage", "usual") | {"blocks": wrong}, {"mass": {"max": "1 kg"}}
            )


def stage_of_bars(block):
    """Return a stage of slender limbs as a joint, and drawn with its bars and blocks as blades."""
    e, r, l, apart, b = 0.05, 1.0, 12.0, 20.0, 3.0
    notch = {"kind": "notch", "e": f"{e} mm", "depth": f"{r} mm"}
    bodies, blades = {"stage": {"at": [f"{l / 2} mm", "0 mm"]}}, {}
    for name, y in (("left", -apart / 2), ("right", apart / 2)):
        ends = [-r, r, l - r, l + r]
        if block:
            ends = [-r - block, *ends, l + r + block]
        links = ["ground", *(f"{name}-{k}" for k in range(len(ends) - 2)), "stage"]
        bodies |= {
            link: {"at": [f"{x} mm", f"{y} mm"]}
            for link, x in zip(links[1:-1], ends[1:-1], strict=True)
        }
        for k, (start, end) in enumerate(pairwise(ends)):
            is_hinge = k % 2 == (1 if block else 0)
            blades[f"{name}-{k}"] = {
                "between": links[k : k + 2],
                "from": [f"{start} mm", f"{y} mm"], "to": [f"{end} mm", f"{y} mm"], "b": f"{b} mm",
                **({"profile": notch} if is_hinge else {"h": f"{e + 2 * r} mm"}),
            }  # fmt: skip
    drawn = {
        "kind": "layout", "bodies": bodies, "blades": blades, "moving": "stage",
        "motion": {"translation": "90 deg"},
    }  # fmt: skip
    sizes = {"e": f"{e} mm", "r": f"{r} mm", "l": f"{l} mm", "b": f"{b} mm"}
    return {"kind": "hinged-stage", **sizes, "spacing": f"{apart} mm"}, drawn


@pytest.mark.parametrize("block", [0.0, 3.0])
@pytest.mark.parametrize(("direction", "drawn_as"), [("z", "z"), ("y", "x")])
def test_bars_and_blocks_give_way_across_the_motion_too(block, direction, drawn_as):
    def support(geometry, along):
        asked = {"support": [{"direction": along, "min": "1 N/m"}]}
        (row,) = (c for c in in_steel(geometry, asked).checks if c.name.startswith("support"))
        return row

    joint, drawn = stage_of_bars(block)
    true = support(drawn, drawn_as).factor
    told = [support(joint | {"blocks": f"{block} mm"}, direction)]
    if block <= 2.05:
        told.append(support(joint, direction))
    for each in told:
        assert each.factor_range[0] < true < each.factor_range[1]
        assert each.factor_range[0] > 0.4 * true
