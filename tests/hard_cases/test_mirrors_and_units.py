"""Mirrored designs give mirrored answers, and a unit changes no digit."""

from math import pi

import numpy as np
import pytest
from judging import check_as_printed, size_as_printed
from planar_joint import joint_stiffness
from stages import rider
from strategies import CASES, LOADS, TITANIUM, crossed, design, rcc

from flexcli.formulas.pivot import end_stresses, parasitic_shift, rotational_stiffness
from flexcli.mechanics.parallel_stage import Lever, Stage, system
from flexcli.mechanics.single_freedom import expand
from flexcli.parts.asd import RandomVibration
from flexcli.parts.geometries import Blade, Elastic
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.mechanisms.parallel_stage import ParallelStage
from flexcli.parts.response import random_response

E, H, L, B = 114e9, 0.6e-3, 17e-3, 10e-3
BLADE = Blade(H, L, B)

ROUNDING = 1e-14
"""Some ten operations."""
EIGEN = 1e-9
"""An eigenproblem whose stiffnesses differ by 1e6."""
SIZED = 1e-12
"""A solve in logarithms."""


@pytest.mark.parametrize("delta", [-0.5, -0.3, 0.0, 0.118, 2.0])
def test_a_pivot_mounted_the_other_way_round_swaps_its_ends(delta, kept):
    """From base to body or back is one pivot: δ and −1 − δ must not differ but in names."""
    there, back = delta * L, (-1 - delta) * L
    given = {"E": E, "h": H, "l": L}
    assert rotational_stiffness(**given, b=B, p=back) == pytest.approx(
        rotational_stiffness(**given, b=B, p=there), rel=10 * ROUNDING
    )
    kept(*(rotational_stiffness(**given, b=B, p=p) for p in (there, back)))
    inner, outer = end_stresses(**given, p=there, theta=0.02)
    scale = abs(inner) + abs(outer)
    assert end_stresses(**given, p=back, theta=0.02) == pytest.approx(
        (-outer, -inner), abs=ROUNDING * scale
    )
    one, other = (parasitic_shift(l=L, p=p, theta=0.02, half_angle=0.7) for p in (there, back))
    assert one == pytest.approx(other, abs=ROUNDING * L * 0.02**2 * (1 + 9 * delta**2))


def test_reversing_the_stroke_reverses_the_stresses_and_nothing_else():
    """A sign that is squared away in one place and not in another."""
    given = {"E": E, "h": H, "l": L, "p": 2e-3}
    forth, back = (end_stresses(**given, theta=theta) for theta in (0.02, -0.02))
    assert back == tuple(-stress for stress in forth)
    shifts = [parasitic_shift(l=L, p=2e-3, theta=t, half_angle=0.7) for t in (0.02, -0.02)]
    assert shifts[0] == shifts[1]


def test_a_mirrored_joint_has_a_mirrored_stiffness():
    """Across its axis of symmetry y and φ change sign, and with them four of nine entries."""
    angles = (0.9, -0.4)
    one, other = (
        joint_stiffness(E=E, h=H, l=L, b=B, p=2e-3, angles=[sign * a for a in angles])
        for sign in (1.0, -1.0)
    )
    mirror = np.diag([1.0, -1.0, -1.0])
    np.testing.assert_allclose(other, mirror @ one @ mirror, rtol=ROUNDING)


def stage(levers, across=0.0):
    first, third = levers
    return Stage(
        20e-3,
        68e-3,
        0.0,
        tuple(
            Lever(rider(m, s, across, 5e-6), rider(0.03, -0.02, across, 1e-6))
            for m, s in (first, third)
        ),
    )


def test_a_stage_seen_from_the_other_side_couples_alike():
    """Levers swapped and what stands across them mirrored: only couplings across change sign."""
    levers = ((0.017, 0.010), (0.021, 0.013))
    one, other = (
        expand(system(stage(pair, across), (15.0,) * 4, shift=shift, direction=0.0))
        for pair, across, shift in ((levers, 1e-3, 1e-3), (levers[::-1], -1e-3, -1e-3))
    )
    for even in ("mass", "stiffness", "coupling_x", "coupling_rotation"):
        assert getattr(other, even).value == pytest.approx(getattr(one, even).value, rel=ROUNDING)
    assert other.coupling_y.value == pytest.approx(-one.coupling_y.value, rel=ROUNDING)


def test_the_response_of_a_mirrored_stage_is_mirrored(kept):
    """Solid 1 and solid 3 change places, and so must the forces on their pivots."""
    pivot = RCCPivot(kind="rcc", p="2 mm", half_angle="45 deg", h="0.6 mm", l="17 mm", b="10 mm")
    heavy, light = (
        {"mass": f"{m} g", "com": f"{s} mm", "inertia": "5e-6 kg*m^2"}
        for m, s in ((25, 12), (17, 9))
    )
    ends = [{"frequency": f, "level": "0.01 g^2/Hz"} for f in ("20 Hz", "2000 Hz")]
    shaken = RandomVibration.model_validate({"profile": {"points": ends}, "q": 50})
    found = []
    for first, third in ((heavy, light), (light, heavy)):
        mechanism = ParallelStage.model_validate(
            {"kind": "parallel-stage", "height": "20 mm", "solid-1": first,
             "solid-2": {"mass": "68 g"}, "solid-3": third}
        )  # fmt: skip
        structure = mechanism.structure(pivot, Elastic(E), BLADE, None)
        outputs = random_response(structure, shaken).outputs
        found.append({name: output.rms for name, output in outputs.items()})
    one, other = found
    swap = {"P1": "P3", "P2": "P4", "P3": "P1", "P4": "P2"}
    for name, value in one.items():
        mirrored = " ".join(swap.get(word, word) for word in name.split())
        assert other[mirrored] == pytest.approx(value, rel=EIGEN)
        kept(other[mirrored], value)


LENGTHS = {"m": 1.0, "mm": 1e3, "um": 1e6}


@pytest.mark.slow
@pytest.mark.parametrize("unit", ["mm", "um"])
@pytest.mark.parametrize("objective", ["balanced", "least-volume"])
def test_a_design_written_in_other_units_is_sized_to_the_same_digits(unit, objective, kept):
    """A default or a start with a unit of its own would move the answer by a little."""

    def sized(unit):
        bounds = {"l": {"free": [f"{x * LENGTHS[unit]!r} {unit}" for x in (1e-3, 50e-3)]}}
        geometry = rcc(p=f"{2e-3 * LENGTHS[unit]!r} {unit}", **bounds)
        result = size_as_printed(
            design(geometry, LOADS, CASES, size={"objective": objective}), "spec"
        )
        return [result.values[name].value for name in "hlb"]

    assert sized(unit) == pytest.approx(sized("m"), rel=SIZED)
    kept(sized(unit), sized("m"))


@pytest.mark.parametrize(
    ("stress", "turn", "force"),
    [(("0.5 GPa", "0.83 GPa"), f"{1.1746 * pi / 180!r} rad", "0.64 kN")],
)
def test_a_check_in_other_units_has_the_same_factors(stress, turn, force):
    """Degrees and radians, giga and mega: each conversion is right to its last digit."""
    other = {
        **TITANIUM,
        "youngs_modulus": "114000 MPa",
        "yield_strength": stress[1],
        "fatigue_amplitude": {"value": stress[0], "cycles": 1e7, "stress_ratio": -1},
    }
    cases = {
        "bend": {"stroke": {"rotation": turn, "cycles": 1e7}},
        "push": {"load": {"force": force}, "ends": "clamped-clamped"},
    }
    fixed = {"h": "0.6 mm", "l": "17 mm", "b": "10 mm"}
    one = check_as_printed(design(crossed(p="2 mm", **fixed), LOADS), BLADE, "spec")
    two = check_as_printed(
        design(crossed(p="2 mm", **fixed), LOADS, cases, material=other), BLADE, "spec"
    )
    assert [c.factor for c in two.checks] == pytest.approx(
        [c.factor for c in one.checks], rel=ROUNDING
    )
