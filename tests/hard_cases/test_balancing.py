"""Balancing at its corners: masses that vanish, arms that oppose, one side, no stiffness."""

from math import isfinite, pi

import pytest
from stages import rider
from strategies import TITANIUM

from flexcli.engine.balance import balance as balance_verb
from flexcli.formulas.spectrum_integrals import rms_displacement
from flexcli.formulas.transfer import natural_frequency, transfer
from flexcli.mechanics.parallel_stage import NO_BALANCE, Lever, Stage, system
from flexcli.mechanics.single_freedom import expand
from flexcli.parts.design import DesignSpec
from flexcli.parts.mechanisms.force_balance import Unknown, balance
from flexcli.parts.mechanisms.free_value import Free

H, M_1, M_2, ARM_1 = 20e-3, 17.138708e-3, 68.1223e-3, 10.411598e-3
NEEDED = M_2 * H + 2 * M_1 * ARM_1
"""Static moment to balance [kg·m]."""

ROUNDING = 1e-13
"""Some ten operations."""


def stage(first, third, platform=M_2):
    """Give the stage of exercise 9 with (mass, arm) of its balancing masses, or none."""
    levers = tuple(
        Lever(
            rider(M_1, ARM_1, 0.0, 5e-6), NO_BALANCE if b is None else rider(b[0], -b[1], 0.0, 0.0)
        )
        for b in (first, third)
    )
    return Stage(H, platform, 0.0, levers)


def left(solution):
    """Part of the coupling that a solution leaves."""
    return abs(solution.stage.moment / solution.stage.without_balance().moment)


def arm(*sides, least=None):
    return Unknown("arm", sides, Free(least, None))


@pytest.mark.parametrize("exponent", [-3, -10, -30, -200])
def test_a_mass_that_tends_to_zero_needs_an_arm_that_grows_as_its_inverse(exponent, kept):
    """The arm goes to infinity: an absolute tolerance on the moment would stop short of it."""
    mass = 10.0**exponent
    solution = balance(stage((mass, 0.0), (mass, 0.0)), [arm(0, 1)], 0.0)
    assert solution.met
    assert solution.found[0] * 2 * mass == pytest.approx(NEEDED, rel=ROUNDING)
    kept(solution.found[0] * 2 * mass, NEEDED)
    assert left(solution) < ROUNDING


def test_a_mass_so_small_that_its_arm_is_no_number_is_refused():
    """Beyond 1e-308 the arm overflows to infinity, which balances nothing."""
    solution = balance(stage((5e-324, 0.0), (5e-324, 0.0)), [arm(0, 1)], 0.0)
    assert not solution.met
    assert all(isfinite(value) for value in solution.found)


def test_a_mass_of_zero_says_that_it_has_no_moment():
    """Zero times any arm is zero: the equation for the arm has no solution."""
    solution = balance(stage((0.0, 0.0), (0.0, 0.0)), [arm(0, 1)], 0.0)
    assert not solution.met
    assert "no moment at any arm" in solution.reason


@pytest.mark.parametrize("off", [1e-3, 1e-6, 1e-9])
def test_arms_of_nearly_opposite_sign_balance_with_masses_that_grow(off, kept):
    """The rate is a difference of nearly equal arms: it loses digits, but not its sign."""
    start = stage((1.0, 0.02 * (1 + off)), (1.0, -0.02))
    solution = balance(start, [Unknown("mass", (0, 1), Free(None, None))], 0.0)
    assert solution.met
    assert solution.found[0] == pytest.approx(NEEDED / (0.02 * off), rel=1e-15 / off)
    kept(solution.found[0], NEEDED / (0.02 * off))


def test_arms_of_exactly_opposite_sign_cancel_and_say_so():
    """The rate is zero, or rounding of either sign, and the mass would be enormous."""
    for arms in ((0.02, -0.02), (0.02 * (1 + 1e-15), -0.02)):
        solution = balance(
            stage((1.0, arms[0]), (1.0, arms[1])), [Unknown("mass", (0, 1), Free(None, None))], 0.0
        )
        assert not solution.met
        assert "cancel each other" in solution.reason


def test_one_balancing_mass_on_one_side_does_the_work_of_two(kept):
    """A formula for two equal sides divides by two."""
    one = balance(stage((0.07, 0.0), None), [arm(0)], 0.0)
    two = balance(stage((0.035, 0.0), (0.035, 0.0)), [arm(0, 1)], 0.0)
    assert one.found[0] == pytest.approx(two.found[0], rel=ROUNDING)
    kept(one.found[0], two.found[0])
    assert left(one) < ROUNDING
    assert one.stage.levers[1].balance == NO_BALANCE


@pytest.mark.parametrize("side", [0, 1])
def test_either_side_alone_is_the_mirror_of_the_other(side):
    """An index of a side in the wrong place is seen on one side only."""
    masses = [None, None]
    masses[side] = (0.05, 0.0)
    solution = balance(stage(*masses), [arm(side)], 0.0)
    assert solution.found[0] == pytest.approx(NEEDED / 0.05, rel=ROUNDING)
    motion = expand(system(solution.stage, (15.0,) * 4))
    assert abs(motion.coupling_x.value) < ROUNDING * NEEDED / H
    assert motion.mass.value == pytest.approx(
        M_2 + (sum(M_1 * ARM_1**2 + 5e-6 for _ in range(2)) + 0.05 * solution.found[0] ** 2) / H**2,
        rel=ROUNDING,
    )


def test_a_free_mass_on_no_stiffness_moves_as_the_base_leaves_it():
    """T = τ/(m ω²) has no resonance: a form divided by k is 0/0 at every frequency."""
    assert natural_frequency(0.0, 2.0) == 0.0
    found = transfer([1.0, 100.0], m=2.0, k=0.0, coupling=1.0, Q=50.0)
    expected = [0.5 / (2 * pi * f) ** 2 for f in (1.0, 100.0)]
    assert found.real == pytest.approx(expected, rel=ROUNDING)
    assert abs(found.imag).max() == 0.0


def design(**mechanism):
    solid = {"mass": "17 g", "com": "10 mm", "inertia": "5e-6 kg*m^2"}
    ends = [{"frequency": f"{f} Hz", "level": "0.01 g^2/Hz"} for f in (20, 2000)]
    return DesignSpec.model_validate(
        {
            "flexure": 1,
            "material": TITANIUM,
            "geometry": {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg",
                         "h": "0.6 mm", "l": "17 mm", "b": "10 mm"},
            "mechanism": {"kind": "parallel-stage", "height": "20 mm", "solid-1": solid,
                          "solid-2": {"mass": "68 g"}, "solid-3": solid, **mechanism},
            "cases": {"work": {"stroke": {"translation": "0.4 mm", "cycles": 1e7}}},
            "requirements": {"fatigue": 1.0},
            "balance": {"asd": {"profile": {"points": ends}, "q": 50}},
        }
    )  # fmt: skip


def test_the_verb_balances_pivots_of_zero_stiffness(kept):
    """No stiffness means no frequency to divide by, and a displacement that is still finite."""
    spec = design(**{"pivot-stiffness": "0 N*m/rad"})
    result = balance_verb(spec, "spec")
    values = {name: value.value for name, value in result.values.items()}
    assert values["k_eq"] == values["f_final"] == values["f_init"] == 0.0
    assert all(isfinite(value) for value in values.values())
    applied = spec.balance.asd.applied()
    free = rms_displacement(applied.frequency, applied.level)
    share = values["tau_coupling"] / values["m_eq_final"]
    assert values["x_rms_final"] == pytest.approx(free * share, rel=ROUNDING)
    kept(values["x_rms_final"], free * share)
