"""Blades with their mass between bodies: frequency equations of beams, and elements by hand."""

from itertools import pairwise
from math import pi, sqrt, tan, tanh

import numpy as np
import pytest
from strategies import design
from thick_beam import timoshenko

from flexcli.engine.check import check
from flexcli.formulas.handbook.tip_mass import tip_mass_frequencies
from flexcli.formulas.profile import Constant, NeckedDown, Notch, Tabulated
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.vibrating_layout import vibrating_layout
from flexcli.numerics.modes import natural_modes
from flexcli.results import Verdict

E, h, l, b, rho = 114e9, 0.5e-3, 30e-3, 10e-3, 4430.0
EI, LINE = E * b * h**3 / 12.0, rho * b * h
UNIT = sqrt(EI / LINE) / l**2  # rad/s per β²

FIRST, SECOND = 5e-6, 5e-5
"""Relative errors of the first and second mode: sixteen elements and six modes inside."""


def blade(profile=None, end=(l, 0.0)):
    thick = Constant(h) if profile is None else profile
    return Blade("blade", "ground", "tip", (0.0, 0.0), end, thick, b)


def angular(*, mass=0.0, c=0.0, J=0.0, profile=None, held=(), density=rho):
    body = Body("tip", (l, 0.0), mass, J, (l + c, 0.0))
    found = vibrating_layout(Layout((body,), (blade(profile),), E), density, held)
    return natural_modes(found.stiffness, found.mass).angular


def root(function, low, high):
    for _ in range(80):
        middle = (low + high) / 2.0
        low, high = (middle, high) if function(low) * function(middle) > 0.0 else (low, middle)
    return low


def test_a_free_cantilever_has_the_published_frequencies():
    # Blevins (1979), table 8-1: β = 1.87510407, 4.69409113
    found = angular()[:2] / UNIT
    assert found[0] == pytest.approx(1.87510407**2, rel=FIRST)
    assert found[1] == pytest.approx(4.69409113**2, rel=SECOND)


def test_a_guided_blade_without_payload_has_the_root_of_tan_and_tanh():
    # clamped at one end, sliding at the other: tan β + tanh β = 0
    beta = root(lambda x: tan(x) + tanh(x), 2.0, 3.0)
    found = angular(held=[("tip", 2), ("tip", 0)])[0]
    assert found == pytest.approx(beta**2 * UNIT, rel=FIRST)


@pytest.mark.parametrize("ratio", [0.0, 0.1, 1.0, 10.0, 1e3])
@pytest.mark.parametrize(("c", "J"), [(0.0, 0.0), (0.4, 0.0), (-0.3, 0.05), (0.2, 0.3)])
def test_a_tip_mass_beyond_the_end_has_the_frequencies_of_its_equation(ratio, c, J):
    m = ratio * LINE * l
    body = {"m": m, "c": c * l, "J": J * m * l**2}
    expected = tip_mass_frequencies(E=E, I=EI / E, L=l, mass_per_length=LINE, modes=2, **body)
    across = angular(mass=m, c=c * l, J=J * m * l**2, held=[("tip", 0)])
    found = across[:2] / (2.0 * pi)
    assert found[0] == pytest.approx(expected[0], rel=FIRST)
    # a heavy body makes of the second mode one of a blade held at both ends, or one of its own
    assert found[1] == pytest.approx(expected[1], rel=SECOND)


def test_a_heavy_body_leaves_rayleighs_share_of_the_blade():
    m = 1e4 * LINE * l
    light = angular(mass=m, density=0.0)[0]
    share = 2.0 * (1.0 - angular(mass=m)[0] / light) * m / (LINE * l)
    # second order in the ratio of 1e-4, and the rounding of the difference
    assert share == pytest.approx(33.0 / 140.0, rel=1e-3)


def test_all_mass_moves_with_the_base():
    layout = Layout((Body("tip", (l, 0.0), 0.2, 0.0, (l, 0.0)),), (blade(),), E)
    assert vibrating_layout(layout, rho).moved["y"] == pytest.approx(0.2 + LINE * l, rel=1e-9)


def test_a_cantilever_that_stands_with_its_base_presses_its_whole_mass_on_the_clamp():
    """Statics: its own inertia per acceleration bends the clamp by 3 m_b l/(b h²)."""
    layout = Layout((Body("tip", (l, 0.0), 0.0, 0.0, (l, 0.0)),), (blade(),), E)
    found = vibrating_layout(layout, rho)
    still = np.linalg.solve(found.stiffness, -found.pull["y"])
    stress = np.abs(found.bending["blade"] @ still).max()
    # the modes inside that are left out hold some of the curvature at the clamp
    assert stress == pytest.approx(3.0 * LINE * l * l / (b * h**2), rel=0.02)


def lumped(thickness, *, mass, elements=100):
    """Give ω of a cantilever of many short uniform elements by the transfer of their states."""
    edges = np.linspace(0.0, l, elements + 1)
    pieces = [(z - a, thickness((a + z) / 2.0)) for a, z in pairwise(edges)]

    def moment_and_force(omega):
        """Carry (w, φ, M, Q) from the tip, free but for the mass, to the clamp."""
        states = np.eye(4)
        for L, t in pieces:
            k = E * b * t**3 / 12.0
            m = rho * b * t * L
            half = np.array([
                [1.0, L / 2, L**2 / (8 * k), L**3 / (48 * k)],
                [0.0, 1.0, L / (2 * k), L**2 / (8 * k)],
                [0.0, 0.0, 1.0, L / 2],
                [0.0, 0.0, 0.0, 1.0],
            ])  # fmt: skip
            inertia = np.eye(4)
            inertia[3, 0] = m * omega**2
            states = half @ inertia @ half @ states
        tip = states[2:, 2:].copy()  # M and Q at the tip per those at the clamp
        tip[1] += mass * omega**2 * states[0, 2:]
        return float(np.linalg.det(tip))

    grid = np.linspace(1.0, 15.0 * UNIT, 60)
    for low, high in pairwise(grid):
        if moment_and_force(low) * moment_and_force(high) < 0.0:
            return root(moment_and_force, low, high)
    raise AssertionError


@pytest.mark.parametrize("mass", [0.0, 0.3e-3])
def test_a_tapered_blade_agrees_with_the_transfer_of_states(mass):
    profile = Tabulated((0.0, 0.4, 1.0), (0.8e-3, 0.5e-3, 0.3e-3))

    def thickness(s):
        return float(np.interp(s / l, profile.fractions, profile.thicknesses))

    found = angular(mass=mass, profile=profile)[0]
    # lumps of 1/100 of the length: the error is of the order of their square
    assert found == pytest.approx(lumped(thickness, mass=mass), rel=3e-4)


def test_massless_blades_are_as_stiff_as_beams_of_their_profile():
    """A notch and a necked blade turn under a moment by ∫ 12/(E b h³) ds."""
    for profile in (Notch(0.1e-3, l / 2.0), NeckedDown(h, l / 6.0)):
        layout = Layout((Body("tip", (l, 0.0)),), (blade(profile),), E)
        found = vibrating_layout(layout)
        turn = np.linalg.solve(found.stiffness, np.array([0.0, 0.0, 1.0]))[2]
        u, weight = np.polynomial.legendre.leggauss(64)
        flexibility = sum(
            12.0 / (E * b) * float((piece.slope(u) / piece.thickness(u) ** 3) @ weight)
            for piece in profile.pieces(l)
        )
        assert turn == pytest.approx(flexibility, rel=1e-6)


def test_frequencies_scale_with_length_and_density():
    one = angular(mass=1e-4)
    body = Body("tip", (2 * l, 0.0), 8e-4, 0.0, (2 * l, 0.0))
    twice = Blade("blade", "ground", "tip", (0.0, 0.0), (2 * l, 0.0), Constant(2 * h), 2 * b)
    found = vibrating_layout(Layout((body,), (twice,), E), rho)
    other = natural_modes(found.stiffness, found.mass).angular
    np.testing.assert_allclose(other, one / 2.0, rtol=1e-9)


def test_a_symmetric_stage_keeps_its_modes_apart():
    """Two equal blades side by side: along the stroke nothing moves along the blades."""
    body = Body("tip", (l, 0.0), 0.1, 1e-6, (l, 0.0))
    blades = tuple(
        Blade(f"{y}", "ground", "tip", (0.0, y), (l, y), Constant(h), b) for y in (-8e-3, 8e-3)
    )
    found = vibrating_layout(Layout((body,), blades, E), rho)
    modes = natural_modes(found.stiffness, found.mass)
    x, y, phi = (row @ modes.shapes for row in found.motions["tip"])
    for k in range(4):
        assert min(abs(x[k]), abs(y[k]) + l * abs(phi[k])) < 1e-6 * max(abs(x[k]), abs(y[k]))


def test_a_guided_heavy_payload_turns_into_the_static_stiffness():
    heavy = 1e3
    found = angular(mass=heavy, held=[("tip", 2)])[0]
    assert found == pytest.approx(sqrt(12.0 * EI / l**3 / heavy), rel=1e-6)


THICK = {"E": E, "rho": rho, "l": l, "b": b}


@pytest.mark.parametrize("slender", [0.02, 0.1, 0.25])
@pytest.mark.parametrize("mass", [0.0, 1.0])
def test_a_thick_blade_has_the_frequency_of_timoshenkos_equations(slender, mass):
    # so many times its mass at the tip
    G, thick = E / 2.6, slender * l
    tip = mass * rho * b * thick * l
    body = Body("tip", (l, 0.0), tip, 0.0, (l, 0.0))
    one = Blade("blade", "ground", "tip", (0.0, 0.0), (l, 0.0), Constant(thick), b)
    found = vibrating_layout(Layout((body,), (one,), E, G), rho, thick=True)
    first = natural_modes(found.stiffness, found.mass).angular[0]
    below, above = (
        timoshenko(first * (1.0 + off), **THICK, G=G, h=thick, m=tip) for off in (-1e-4, 1e-4)
    )
    assert below * above < 0.0


@pytest.mark.parametrize(("share", "verdict"), [(0.98, Verdict.PASS), (1.02, Verdict.FAIL)])
def test_a_thick_blade_heavier_than_its_payload_is_decided_near_its_frequency(share, verdict):
    thick, tip = 0.2 * l, 0.05 * rho * b * 0.2 * l
    angular = root(lambda x: timoshenko(x, **THICK, G=E / 2.0, h=thick, m=tip), 1e4, 1e5)
    spec = design(
        {"kind": "cantilever", "h": f"{thick} m", "l": f"{l} m", "b": f"{b} m"},
        {"frequency": {"min": f"{share * angular / (2.0 * pi)!r} Hz"}},
        {"push": {"stroke": {"translation": "1 nm"}}},
        material={
            "name": "flat", "youngs_modulus": f"{E} Pa", "poisson_ratio": 0.0,
            "density": f"{rho} kg/m^3", "yield_strength": "1 GPa",
        },
        mechanism={"kind": "tip-mass", "mass": f"{tip!r} kg"},
    )  # fmt: skip
    row, _ = check(spec, spec.fixed_sizes(), "test").checks
    assert row.verdict is verdict
