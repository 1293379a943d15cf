"""The parallel stage against the closed forms of exercise 9 part I, and what balance means."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st
from stages import rider

from flexcli.mechanics.parallel_stage import Lever, Stage, system
from flexcli.mechanics.single_freedom import expand

H, M_1, M_2, M_BAL = 20e-3, 17.138708e-3, 68.122300e-3, 35.565044e-3
L_C1, J_1, J_BAL = 10.411598e-3, 5.3569824e-6, 1.1271682e-6
L_BAL = (2 * M_1 * L_C1 + M_2 * H) / (2 * M_BAL)
K_1 = 15.51

ROUNDING = 1e-13
"""Relative agreement of two orders of the same dozen operations."""


def exercise(arm=L_BAL):
    lever = Lever(rider(M_1, L_C1, 0.0, J_1), rider(M_BAL, -arm, 0.0, J_BAL))
    return Stage(H, M_2, 0.0, (lever, lever))


def at_rest(stage):
    return expand(system(stage, (K_1,) * 4))


def test_the_arm_of_the_source_is_printed_as_it_prints_it():
    assert round(L_BAL * 1e3, 4) == 24.1716


@pytest.mark.parametrize("arm", [0.0, 10e-3, L_BAL, 40e-3])
def test_mass_stiffness_and_coupling_are_the_closed_forms_of_the_source(arm):
    """With l_c1,tot in the cross term, where the source's kinetic energy slips to l_c1."""
    m_tot = M_1 + M_BAL
    l_tot = (M_BAL * arm - M_1 * L_C1) / m_tot
    J_tot = J_1 + J_BAL + (l_tot + L_C1) ** 2 * M_1 + (arm - l_tot) ** 2 * M_BAL
    m_eq = (2 * J_tot + 2 * m_tot * l_tot**2 + M_2 * H**2) / H**2
    motion = at_rest(exercise(arm))
    assert motion.mass.value == pytest.approx(m_eq, rel=ROUNDING)
    assert motion.stiffness.value == pytest.approx(4 * K_1 / H**2, rel=ROUNDING)
    tau = (M_2 * H - 2 * m_tot * l_tot) / H
    assert motion.coupling_x.value == pytest.approx(tau, abs=ROUNDING * m_eq)


def test_equivalent_masses_are_those_printed():
    assert round(at_rest(exercise().without_balance()).mass.value * 1e3, 1) == 104.2
    assert round(at_rest(exercise()).mass.value * 1e3, 1) == 213.7


def test_the_slip_of_the_source_would_leave_another_arm():
    """With l_c1 in the cross term, as in its kinetic energy, no arm could balance at all."""
    slipped = M_2 - 2 * (M_1 + M_BAL) * L_C1 / H
    assert abs(slipped) > 0.1 * M_2


lengths = st.floats(-0.05, 0.05)
riders = st.builds(rider, st.floats(1e-3, 0.1), lengths, st.floats(-5e-3, 5e-3), st.floats(0, 1e-5))
levers = st.builds(Lever, riders, riders)
stages = st.builds(
    lambda height, platform, a, b: Stage(height, platform, 0.0, (a, b)),
    st.floats(5e-3, 0.1), st.floats(1e-3, 0.2), levers, levers,
)  # fmt: skip


@given(stages, st.floats(-0.5, 0.5))
def test_swapping_the_sides_changes_nothing(stage, theta):
    mirrored = replace(stage, levers=stage.levers[::-1])
    one, other = (expand(system(s, (1.0, 2.0, 3.0, 4.0)), theta) for s in (stage, mirrored))
    for term in ("mass", "stiffness", "coupling_x", "coupling_y", "coupling_rotation"):
        left, right = getattr(one, term), getattr(other, term)
        size = one.mass.value * (1.0 + stage.height)
        assert left.coefficients == pytest.approx(right.coefficients, abs=1e-12 * size, rel=1e-12)


@given(st.floats(-1.0, 1.0))
def test_a_stage_balanced_at_rest_is_balanced_at_every_angle_along_both_axes(theta):
    """Its centre of mass stays on the line of the base pivots: no order in θ is left."""
    motion = expand(system(exercise(), (K_1,) * 4), theta)
    before = at_rest(exercise().without_balance()).coupling_x.value
    assert abs(motion.coupling_x.value) < 1e-12 * before
    assert abs(motion.coupling_y.value) < 1e-12 * before


def test_a_centre_of_mass_beside_the_line_of_the_pivots_is_a_coupling_of_first_order():
    """τ_x = S/H − E/H tan θ and τ_y = −(S tan θ + E)/H with E = Σ m e."""
    lever = Lever(rider(M_1, L_C1, 1e-3, J_1), rider(M_BAL, -L_BAL, 0.0, J_BAL))
    motion = at_rest(Stage(H, M_2, 0.0, (lever, lever)))
    E = 2 * M_1 * 1e-3
    tau = motion.coupling_x.coefficients
    assert tau[1] == pytest.approx(-E / H, rel=1e-12)
    assert tau[3] == pytest.approx(-E / H / 3.0, rel=1e-12)
    assert motion.coupling_y.value == pytest.approx(-E / H, rel=1e-12)


@given(stages)
def test_slopes_of_the_coupling_are_its_derivatives(stage):
    """By complex step on the static moment over H."""

    def coupling(changed):
        return (changed.moment / changed.height).imag / 1e-30

    def stepped(number):
        return number + 1e-30j

    found = {term.name: term.slope for term in stage.coupling_terms()}
    expected = {
        "solid-2 mass": coupling(replace(stage, platform=stepped(stage.platform))),
        "height": coupling(replace(stage, height=stepped(stage.height))),
    }
    for side, lever in enumerate(stage.levers):
        for part, key, sign in (("solid", "com", 1.0), ("balance", "arm", -1.0)):
            body = getattr(lever, part)
            changed = {
                "mass": body._replace(mass=stepped(body.mass)),
                key: body._replace(com=(body.com[0], stepped(body.com[1]))),
            }
            for name, one in changed.items():
                new = replace(lever, **{part: one})
                pair = (new, stage.levers[1]) if side == 0 else (stage.levers[0], new)
                slope = coupling(replace(stage, levers=pair))
                expected[f"{part}-{2 * side + 1} {name}"] = slope * (sign if name == key else 1.0)
    assert found == pytest.approx(expected, rel=1e-12, abs=1e-12)


def test_pivots_that_shift_alike_bring_back_coupling_in_the_first_order():
    """2κθ (M + m_2)/H at small θ: the base pivots move all, the upper ones solid 2 once more."""
    kappa = 3.5e-3
    motion = expand(system(exercise(), (K_1,) * 4, shift=kappa))
    total = M_2 + 2 * (M_1 + M_BAL)
    assert motion.coupling_x.coefficients[1] == pytest.approx(
        2 * kappa * (total + M_2) / H, rel=1e-12
    )


def test_the_torque_on_the_base_is_that_of_the_inertia_about_the_pivots():
    """τ_φ = −m_eq H where solid 2 has its centre of mass in the line of the upper pivots."""
    motion = at_rest(exercise())
    assert motion.coupling_rotation.value == pytest.approx(-motion.mass.value * H, rel=1e-12)
