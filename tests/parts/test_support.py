"""Support and deflection as a spec asks for them, against closed forms of one direction."""

from math import pi

import numpy as np
import pytest
from geometries_for_tests import spec
from judging import check_as_printed
from strategies import TITANIUM, Inconsistent, design

from flexcli.formulas import plate_factors as plates
from flexcli.formulas import sheet_factors as sheets
from flexcli.formulas.restrained_torsion import restrained_stiffness
from flexcli.results import Verdict

E, G = 114e9, 114e9 / 2.68
H, L, B = 1e-4, 20e-3, 5e-3
AREA, TURN = B * H, B * H**3 / 12.0
SHEAR = 2.4 * 1.34 * (H / L) ** 2
"""Φ of a blade between clamps."""

BLADE = {"b": B, "l": L, "poisson_ratio": 0.34}
PULLED, WIDE, TURNED = (
    float(factor(**BLADE))
    for factor in (sheets.axial_factor, sheets.guided_factor, sheets.bending_factor)
)
"""Of a blade between clamps in its own plane over the beam of it: along it, across its width in an
S and in an arc."""
ARC, S_SHAPE = (
    float(factor(**BLADE, h=H)) for factor in (plates.pure_bending_factor, plates.guided_factor)
)
"""Of the same in bending across its thickness."""

ROUNDING = 1e-9
"""Of a compliance in which stiffnesses of very different size meet."""

STROKE = {"work": {"stroke": {"translation": "0.1 mm", "cycles": 1e6}}}


def checks_of(kind, requirements, cases=None, **changes):
    geometry = spec(kind, **changes)
    moves = geometry["kind"] not in ("leaf-spring-stage", "guided-blade", "cantilever")
    turn = {"work": {"stroke": {"rotation": "1 deg", "cycles": 1e6}}}
    found = design(geometry, requirements, cases or (turn if moves else STROKE))
    checks = check_as_printed(found, found.fixed_sizes(), "spec").checks
    return [each for each in checks if each.verdict is not Verdict.NOT_JUDGED]


def measured(kind, direction, bound, **support):
    """Return the stiffness that is compared with a bound it does not reach."""
    (found,) = checks_of(kind, {"support": {"direction": direction, "min": bound, **support}})
    assert found.demand != found.capacity
    return found.capacity


def test_stage_is_as_stiff_along_its_blades_as_they_stretch():
    found = measured("leaf-spring-stage", "y", "1 N/um")
    assert found == pytest.approx(PULLED * 3 * E * AREA / L, rel=ROUNDING)


def test_stage_along_its_stroke_is_stated_at_its_own_middle():
    """About another point a force along the stroke would tilt it and seem softer."""
    found = measured("leaf-spring-stage", "x", "1 N/m")
    assert found == pytest.approx(S_SHAPE * 3 * E * B * H**3 / L**3 / (1 + SHEAR), rel=ROUNDING)


def test_stage_turns_by_the_stretch_of_its_blades_on_their_arms():
    found = measured("leaf-spring-stage", "theta_z", "1 N*m/rad")
    arms = PULLED * 2 * E * AREA / L * 15e-3**2
    assert found == pytest.approx(arms + ARC * 3 * E * TURN / L, rel=ROUNDING)


def test_cantilever_is_stated_at_its_tip():
    found = measured("cantilever", "x", "1 N/m")
    softer = 0.75 / ARC + 0.25 * (1 + SHEAR) / S_SHAPE
    assert found == pytest.approx(3 * E * TURN / L**3 / softer, rel=ROUNDING)


def test_a_point_is_counted_from_the_tip():
    """Half-way back a force bends the blade's two halves alike: 1/C = 12EI/l³, and its shear."""
    place = {"point": ["0 mm", "10 mm", "0 mm"]}
    found = measured("cantilever", "x", "1 N/m", **place)
    assert found == pytest.approx(S_SHAPE * 12 * E * TURN / L**3 / (1 + SHEAR), rel=ROUNDING)


def test_ratio_of_two_directions_is_that_of_their_stiffnesses():
    """Lecture's "high stiffness-ratio": (l/h)² of a leaf spring, with its shear."""
    (found,) = checks_of(
        "leaf-spring-stage", {"support": {"direction": "y", "over": "x", "min": 1e4}}
    )
    assert found.name == "support y/x (min)"
    assert found.capacity == pytest.approx(
        PULLED / S_SHAPE * (L / H) ** 2 * (1 + SHEAR), rel=ROUNDING
    )
    assert found.unit == ""
    assert found.verdict is Verdict.PASS


def test_a_ratio_out_of_the_plane_is_known_as_well():
    (found,) = checks_of(
        "leaf-spring-stage", {"support": {"direction": "theta_y", "over": "theta_z", "min": 1e-9}}
    )
    low, high = found.factor_range
    assert high < 1.05 * low
    assert found.verdict is Verdict.PASS


def test_a_deflection_where_a_stroke_has_turned_the_blades_is_undecided():
    case = {"work": {"stroke": {"translation": "0.1 mm"}, "wrench": {"z": "1 N"}}}
    (found,) = checks_of(
        "leaf-spring-stage", {"deflection": {"direction": "z", "max": "1 m"}}, case
    )
    assert found.verdict is Verdict.UNDECIDED


def test_a_locked_drive_holds_its_motion_alone():
    locked, free = (
        measured("cantilever", "theta_z", "1 N*m/rad", drive=drive) for drive in ("locked", "free")
    )
    # a tip that turns without moving: 4EI/l of the beam, EI/l where it is free
    stiffer = ARC + 3.0 * S_SHAPE / (1 + SHEAR)
    assert free == pytest.approx(ARC * E * TURN / L, rel=ROUNDING)
    assert locked == pytest.approx(stiffer * E * TURN / L, rel=ROUNDING)


def test_ratio_of_two_rotations_is_a_ratio_too():
    each = [measured("leaf-spring-stage", axis, "1 N*m/rad") for axis in ("theta_x", "theta_z")]
    (found,) = checks_of(
        "leaf-spring-stage", {"support": {"direction": "theta_x", "over": "theta_z", "max": 1.0}}
    )
    assert found.demand == pytest.approx(each[0] / each[1], rel=ROUNDING)


def test_a_guide_keeps_its_blade_from_turning_in_every_direction_that_is_asked():
    """12EI/l³ along the stroke, not 3EI/l³ as of a free tip: one stiffness in every verb."""
    found = measured("guided-blade", "x", "1 N/m")
    assert found == pytest.approx(S_SHAPE * 12 * E * TURN / L**3 / (1 + SHEAR), rel=ROUNDING)


def test_hinges_much_wider_than_long_have_a_support_that_is_known():
    """Two sheets of b = 12 l_c in series at either end of the middle, with the shear of both."""
    b, neck, arm = 60e-3, 5e-3, 7.5e-3
    sizes = {"h": f"{H} m", "l": "20 mm", "l_c": f"{neck} m", "b": f"{b} m", "blades": 2,
             "spacing": "50 mm"}  # fmt: skip
    wide = {"b": b, "l": neck, "poisson_ratio": 0.34}
    turns = float(sheets.bending_factor(**wide)) * E * H * b**3 / 12.0 / neck
    shift = 12.0 * E * H * b**3 / 12.0 / neck**3 * float(sheets.guided_factor(**wide))
    shift /= 1.0 + 2.4 * 1.34 * (b / neck) ** 2
    stage = 2.0 / (2.0 / shift + 2.0 * arm**2 / turns)
    asked = {"support": {"direction": "z", "min": f"{stage!r} N/m", "drive": "locked"}}
    _, found = checks_of("necked-down-stage", asked, STROKE, **sizes)
    low, high = found.factor_range
    assert 0.97 < low < 1.0 < high < 1.03
    harder = {"support": {"direction": "z", "min": f"{1.05 * found.capacity!r} N/m"}}
    _, missed = checks_of("necked-down-stage", harder, STROKE, **sizes)
    assert missed.verdict is Verdict.FAIL


def test_several_supports_make_a_check_each():
    rows = [{"direction": axis, "min": "1 N/m"} for axis in ("x", "y", "z")]
    found = checks_of("rcc", {"support": rows})
    assert [check.name for check in found] == [f"support {a} (min)" for a in "xyz"]


def loaded(kind, wrench, deflection):
    case = {"load": {"wrench": wrench}}
    (found,) = checks_of(kind, {"deflection": deflection}, case)
    return found


def test_force_along_the_blades_stretches_them():
    found = loaded("leaf-spring-stage", {"y": "30 N"}, {"direction": "y", "max": "1 um"})
    assert found.demand == pytest.approx(30.0 * L / (PULLED * 3 * E * AREA), rel=ROUNDING)
    assert found.name == "deflection y (max)"
    assert found.case == "load"


@pytest.mark.parametrize("force", ["30 N", "-30 N"])
def test_deflection_counts_whichever_way_it_goes(force):
    found = loaded("leaf-spring-stage", {"y": force}, {"direction": "y", "max": "0.1 um"})
    assert found.demand > 0.0
    assert not found.passed


def test_wrench_acts_at_the_centre_and_the_point_is_only_watched():
    """A moment M on a pivot turns it by M/K and moves a point at a distance by the arm."""
    turned = loaded("rcc", {"theta_z": "1 N*mm"}, {"direction": "theta_z", "max": "1 rad"})
    place = {"point": ["8 mm", "0 mm", "0 mm"]}
    moved = loaded("rcc", {"theta_z": "1 N*mm"}, {"direction": "y", "max": "1 m", **place})
    assert moved.demand == pytest.approx(8e-3 * turned.demand, rel=1e-3)
    pushed = loaded("rcc", {"x": "1 N"}, {"direction": "x", "max": "1 um", **place})
    centre = loaded("rcc", {"x": "1 N"}, {"direction": "x", "max": "1 um"})
    assert pushed.demand == pytest.approx(centre.demand, rel=ROUNDING)


def test_loads_of_a_wrench_add():
    each = [
        loaded("cantilever", wrench, {"direction": "x", "max": "1 mm"}).demand
        for wrench in ({"x": "10 mN"}, {"theta_z": "0.1 N*mm"})
    ]
    both = loaded(
        "cantilever", {"x": "10 mN", "theta_z": "0.1 N*mm"}, {"direction": "x", "max": "1 mm"}
    )
    assert both.demand == pytest.approx(sum(each), rel=ROUNDING)


@pytest.mark.parametrize(
    ("kind", "changes", "material", "text"),
    [
        ("leaf-spring-stage", {"spacing": None}, TITANIUM, "needs spacing"),
        ("hinged-stage", {"spacing": None}, TITANIUM, "needs spacing"),
        ("torsion-bar", {"bars": 25}, TITANIUM, "more than 24 bars"),
        ("torsion-bar", {"bars": 1, "shortening": "held"}, TITANIUM, "axial support"),
        ("torsion-star", {"bars": 25}, TITANIUM, "more than 24 bars"),
        ("rcc", {}, {"youngs_modulus": "114 GPa"}, "material.poisson_ratio"),
    ],
)
def test_what_is_missing_is_named(kind, changes, material, text):
    motion = "translation" if kind.endswith("stage") else "rotation"
    stroke = {motion: "0.1 mm" if motion == "translation" else "1 deg", "cycles": 1e6}
    with pytest.raises(Inconsistent, match=text):
        design(
            spec(kind, **changes),
            {"support": {"direction": "x", "min": "1 N/um"}},
            {"work": {"stroke": stroke}},
            material=material,
        )


def test_pairs_side_by_side_resist_tilting_on_their_arms_about_the_middle_of_the_pivot():
    """Blades that cross at mid-length, each a width beside the last: six springs on the axis each.

    Timoshenko's beams, times the factors of clamped plates and sheets.
    """
    pairs, b, half_angle = 3, 5e-3, 0.7
    shape = {"p": None, "delta": -0.5, "half_angle": "0.7 rad", "pairs": pairs}
    bounds = {"x": "1 N/um", "y": "1 N/um", "theta_x": "1 N*m/rad", "theta_y": "1 N*m/rad"}
    asked = [{"direction": way, "min": bound} for way, bound in bounds.items()]
    found = [check.capacity for check in checks_of("cross-spring", {"support": asked}, **shape)]
    bends = E * H * b**3 / 12.0 / L
    wide = 12.0 * E * H * b**3 / 12.0 / L**3 / (1.0 + 2.4 * 1.34 * (b / L) ** 2)
    twists = float(restrained_stiffness(E=E, G=G, h=H, b=b, l=L))
    own = np.array([PULLED * E * b * H / L, S_SHAPE * 12.0 * E * TURN / L**3 / (1.0 + SHEAR),
                    WIDE * wide, twists, TURNED * bends, ARC * E * TURN / L])  # fmt: skip
    K = np.zeros((6, 6))
    for index in range(2 * pairs):
        angle = half_angle if index % 2 == 0 else -half_angle
        turn = np.array([[np.cos(angle), np.sin(angle), 0.0],
                         [-np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])  # fmt: skip
        z = (index - (2 * pairs - 1) / 2.0) * b
        arm = np.array([[0.0, z, 0.0], [-z, 0.0, 0.0], [0.0, 0.0, 0.0]])  # u + φ × (0, 0, z)
        moved = np.block([[turn, turn @ arm], [np.zeros((3, 3)), turn]])
        K += moved.T @ np.diag(own) @ moved
    assert found == pytest.approx(1.0 / np.diag(np.linalg.inv(K))[[0, 1, 3, 4]], rel=1e-5)


@pytest.mark.parametrize("bars", [1, 2])
def test_torsion_bars_hold_their_body_as_cantilevers_that_carry_it(bars):
    """Their width along y: 3 E I/l³ of one with its end free; of two, 12 E I/l³ of either side."""
    l, h, b = 20e-3, 0.5e-3, 4e-3
    at = {"h": "0.5 mm", "l": "20 mm", "b": "4 mm", "bars": bars}
    asked = [{"direction": way, "min": "1 N/m"} for way in ("x", "y", "z")]
    found = checks_of("torsion-bar", {"support": asked}, **at)
    factors = [check.factor for check in found if check.name.startswith("support")]
    shape = 3.0 if bars == 1 else 24.0
    beams = [shape * E * b * h**3 / 12.0 / l**3, shape * E * h * b**3 / 12.0 / l**3]
    beams.append(bars * E * b * h / l)
    # plates, sheets and shear between clamps
    assert factors == pytest.approx(beams, rel=0.06 if bars == 1 else 0.13)


def test_four_bars_in_a_row_tilt_as_far_from_the_middle_as_they_stand():
    """Their body ends stand at ±l: 28 E I/l of either outer bar, 4 E I/l of the inner ones."""
    l, d = 20e-3, 0.5e-3
    bent = E * pi * d**4 / 64.0 / l
    sides = {"x": 48.0 * bent / l**2, "z": 4.0 * E * pi * d**2 / 4.0 / l}
    tilts = {"theta_x": 64.0 * bent, "theta_y": 64.0 * bent}
    asked = [{"direction": way, "min": "1 N/m"} for way in sides]
    asked += [{"direction": way, "min": "1 N*m/rad"} for way in tilts]
    found = checks_of("round-torsion-bar", {"support": asked}, d="0.5 mm", l="20 mm", bars=4)
    factors = [check.factor for check in found]
    assert factors == pytest.approx([*sides.values(), *tilts.values()], rel=0.01)


def test_the_third_bar_of_a_row_ends_at_its_free_side():
    """Its body ends stand at −l, −l and l: 28, 4 and 4 E I/l about a middle that may go aside."""
    l, d = 20e-3, 0.5e-3
    asked = {"support": {"direction": "theta_x", "min": "1 N*m/rad"}}
    (found,) = checks_of("round-torsion-bar", asked, d="0.5 mm", l="20 mm", bars=3)
    # each bar by how far its end goes aside and how it turns
    ends = np.array([[-1.0, 1.0], [-1.0, -1.0], [1.0, 1.0]])
    K = np.zeros((2, 2))
    for end, slope in ends:
        to_end = np.array([[1.0, end], [0.0, slope]])
        K += to_end.T @ np.array([[12.0, -6.0], [-6.0, 4.0]]) @ to_end
    stiff = E * pi * d**4 / 64.0 / l / np.linalg.inv(K)[1, 1]
    assert found.factor == pytest.approx(stiff, rel=0.01)
