"""The core of the equation of motion, against Lagrange's equation differentiated numerically.

The independent route writes positions in the plane, differentiates them by complex step, builds
the kinetic energy of all velocities in the inertial frame, and works Lagrange's equation out along
a motion of stage and base; it shares nothing with the core but the mechanism.
"""

import cmath
from math import cos, pi, sin, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st
from stages import rider

from flexcli.mechanics.layout import Body
from flexcli.mechanics.parallel_stage import Lever, Stage, system
from flexcli.mechanics.single_freedom import SingleFreedom, expand

STEP = 1e-30
"""Step of a derivative by complex step: there is no subtraction, so that it may be tiny."""

COMPLEX_STEP = 1e-11
"""Relative agreement of two exact routes of some ten operations."""

DIFFERENCE = 1e-7
"""Relative agreement where a central difference in time or place is taken."""

K = (15.0, 16.0, 14.0, 15.5)
SOLID_1 = rider(0.0171, 0.0104, 0.0011, 5.4e-6)
SOLID_3 = rider(0.0150, 0.0120, -0.0004, 4.4e-6)
BALANCE = rider(0.0356, -0.0242, 0.0007, 1.1e-6)
STAGE = Stage(0.02, 0.0681, 0.003, (Lever(SOLID_1, BALANCE), Lever(SOLID_3)))


def riders(stage):
    return [body for lever in stage.levers for body in lever.bodies]


def places(stage, x):
    """Return (m, J, x, y, φ) of every body at a displacement x of solid 2, complex or not."""
    theta = cmath.asin(x / stage.height)
    s, c = cmath.sin(theta), cmath.cos(theta)
    yield stage.platform, 0.0, x, stage.height * c + stage.platform_com, 0.0 * x
    for r in riders(stage):
        across, along = r.com
        yield r.mass, r.inertia, along * s + across * c, along * c - across * s, -theta


def kinetic(stage, x, dx, base_x, base_y, turn):
    """Return the kinetic energy with every velocity taken in the inertial frame."""
    energy = 0.0
    here = list(places(stage, x))
    near = list(places(stage, x + 1j * STEP))
    for (m, J, px, py, _), (_, _, qx, qy, qphi) in zip(here, near, strict=True):
        rate_x, rate_y, rate_phi = qx.imag / STEP, qy.imag / STEP, qphi.imag / STEP
        vx = rate_x * dx + base_x - turn * complex(py).real
        vy = rate_y * dx + base_y + turn * complex(px).real
        energy += 0.5 * m * (vx**2 + vy**2) + 0.5 * J * (rate_phi * dx + turn) ** 2
    return energy


def spring_force(stage, x):
    theta = cmath.asin((x + 1j * STEP) / stage.height)
    return (0.5 * sum(K) * theta**2).imag / STEP


def mixed(stage, x, **base):
    """Return ∂²T/∂ẋ∂(base velocity), from T quadratic in the velocities."""
    still = {"base_x": 0.0, "base_y": 0.0, "turn": 0.0}
    both = kinetic(stage, x, 1.0, **(still | base))
    return both - kinetic(stage, x, 1.0, **still) - kinetic(stage, x, 0.0, **(still | base))


strokes = st.floats(-0.015, 0.015)


@given(strokes)
def test_masses_and_couplings_at_finite_stroke_are_those_of_the_full_lagrangian(x):
    motion = expand(system(STAGE, K), cmath.asin(x / STAGE.height).real)
    assert motion.output.value == pytest.approx(x, abs=1e-17)
    mass = 2.0 * kinetic(STAGE, x, 1.0, 0.0, 0.0, 0.0)
    assert motion.mass.value == pytest.approx(mass, rel=COMPLEX_STEP)
    scale = mass * STAGE.height
    for term, base, size in (
        (motion.coupling_x, {"base_x": 1.0}, mass),
        (motion.coupling_y, {"base_y": 1.0}, mass),
        (motion.coupling_rotation, {"turn": 1.0}, scale),
    ):
        assert term.value == pytest.approx(mixed(STAGE, x, **base), abs=COMPLEX_STEP * size)


@given(strokes)
def test_force_and_stiffness_at_finite_stroke_are_those_of_the_potential(x):
    motion = expand(system(STAGE, K), cmath.asin(x / STAGE.height).real)
    tangent = (spring_force(STAGE, x + 1e-6) - spring_force(STAGE, x - 1e-6)) / 2e-6
    assert motion.force.value == pytest.approx(spring_force(STAGE, x), abs=1e-8)
    assert motion.stiffness.value == pytest.approx(tangent, rel=DIFFERENCE)


def test_the_limit_of_small_strokes_is_m_eq_k_eq_and_tau():
    rest = expand(system(STAGE, K))
    for x in (1e-4, 1e-6, 1e-8):
        mass = 2.0 * kinetic(STAGE, x, 1.0, 0.0, 0.0, 0.0)
        assert abs(mass / rest.mass.value - 1.0) < 2.0 * (x / STAGE.height) ** 2 + COMPLEX_STEP
        assert abs(spring_force(STAGE, x) / x / rest.stiffness.value - 1.0) < (
            (x / STAGE.height) ** 2 + COMPLEX_STEP
        )
        tau = mixed(STAGE, x, base_x=1.0)
        assert abs(tau - rest.coupling_x.value) < 2.0 * mass * x / STAGE.height


@pytest.mark.parametrize("time", [0.1, 0.7, 1.3])
def test_the_equation_of_motion_holds_along_a_motion_of_stage_and_base(time):
    """F = m ü + ½ m' u̇² + V' + τ_x γ̈_x + τ_y γ̈_y + τ_φ Ω̇ − ½ I' Ω², all terms at once."""

    def motion_of(t):
        """Stage x, base (γ_x, γ_y) in axes that turn with it, rotation rate: positions, rates."""
        return 0.008 * sin(3.0 * t), 0.024 * cos(3.0 * t), 0.3 * sin(2.0 * t)

    def momentum(t):
        x, dx, turn = motion_of(t)
        still = kinetic(STAGE, x, 0.0, 0.0, 0.0, turn)
        one = kinetic(STAGE, x, 1.0, 0.0, 0.0, turn)
        mass = 2.0 * kinetic(STAGE, x, 1.0, 0.0, 0.0, 0.0)
        return one - still - 0.5 * mass + mass * dx

    def energy(x, dx, turn):
        return kinetic(STAGE, x, dx, 0.0, 0.0, turn)

    h = 1e-5
    x, dx, turn = motion_of(time)
    inertial = (momentum(time + h) - momentum(time - h)) / (2 * h)
    slope = (energy(x + 1e-7, dx, turn) - energy(x - 1e-7, dx, turn)) / 2e-7
    force = inertial - slope + spring_force(STAGE, x)

    terms = expand(system(STAGE, K), cmath.asin(x / STAGE.height).real)
    per_x = 1.0 / terms.output_rate.value
    ddx, dturn = -9.0 * x, 0.6 * cos(2.0 * time)

    def moment_of_inertia(at):
        return sum(m * (complex(px).real ** 2 + complex(py).real ** 2)
                   for m, _, px, py, _ in places(STAGE, at))  # fmt: skip

    spread = (moment_of_inertia(x + 1e-7) - moment_of_inertia(x - 1e-7)) / 2e-7
    expected = (
        terms.mass.value * ddx
        + 0.5 * terms.mass.derivative().value * per_x * dx**2
        + terms.force.value
        + terms.coupling_rotation.value * dturn
        - 0.5 * spread * turn**2
    )
    assert force == pytest.approx(expected, rel=DIFFERENCE)


def linear_stage(shortening=0.0):
    return SingleFreedom(
        [(Body("stage", (0.0, 0.0), 1.0), lambda q: (q, q * q * -shortening, 0.0))],
        864.0,
        lambda q: q,
    )


def test_the_linear_stage_of_exercise_12_a():
    motion = expand(linear_stage())
    assert round(sqrt(motion.stiffness.value / motion.mass.value) / (2 * pi), 2) == 4.68
    assert round(motion.coupling_x.value * 9.81 / motion.stiffness.value * 1e3, 1) == 11.4


def test_gravity_along_the_blades_of_a_stage_stiffens_it_by_its_weight_over_their_length():
    motion = expand(linear_stage(0.6 / 0.05))
    assert motion.coupling_y.value == 0.0
    assert motion.gravity_stiffness(0.0, 9.81) == pytest.approx(1.2 * 9.81 / 0.05)
    assert motion.gravity_stiffness(0.0, -9.81) == pytest.approx(-1.2 * 9.81 / 0.05)


def test_the_rotary_stage_of_exercise_12_b_feels_its_base_turn_and_nothing_else():
    J, k = 1.72e-4, 0.679
    stage = SingleFreedom(
        [(Body("payload", (0.0, 0.0), 0.8, J), lambda q: (0.0, 0.0, q))],
        k,
        lambda q: q,
    )
    motion = expand(stage, 0.1)
    assert motion.mass.value == motion.coupling_rotation.value == J
    assert motion.coupling_x.value == motion.coupling_y.value == 0.0
    assert round(sqrt(motion.stiffness.value / motion.mass.value) / (2 * pi), 1) == 10.0


@given(st.floats(-1.2, 1.2), st.floats(0.001, 0.1), st.floats(-0.05, 0.05))
def test_energies_are_positive(theta, mass, along):
    stage = Stage(0.02, 0.01, 0.0, (Lever(rider(mass, along, 0.0, 1e-6)), Lever(SOLID_3)))
    motion = expand(system(stage, K), theta)
    assert motion.mass.value > 0.0
    assert motion.potential.value >= 0.0
