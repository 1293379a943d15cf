"""A stage that is pulled turns over where its blades stretch: strings, linear beams, checks."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import flexcli
from flexcli.formulas.profile import Constant, NeckedDown
from flexcli.formulas.pulled_stage import overturning_tension
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.parts.geometries.joint_buckling import PULLED


@pytest.mark.parametrize("across", [True, False])
def test_stiff_blades_are_strings_that_turn_the_body_by_half_their_length(across):
    """EA r² θ/l against N l θ/2 at ends that follow, N l θ/4 where the chord turns by θ/2."""
    upright = 1e9
    found = overturning_tension(upright=upright, xi=1.0, across=across)
    assert found == pytest.approx((4.0 if across else 2.0) * upright, rel=1e-4)


def _bent_evenly(n: float, xi: float) -> float:
    """Return the moment about mid-length per rotation about it, by a blade's equation."""

    def slopes(x, state, force):
        _, turn, moment = state
        bends = min(x, 1.0 - x) < xi / 2.0
        return [turn, moment if bends else 0.0, n * turn - force]

    ends = []
    for moment, force in ((1.0, 0.0), (0.0, 1.0)):
        state, at = [0.0, 0.0, moment], 0.0
        for to in (xi / 2.0, 1.0 - xi / 2.0, 1.0):
            if to > at:
                tiny = 1e-12 * (to - at)
                found = solve_ivp(
                    slopes, (at + tiny, to - tiny), state, args=(force,), rtol=1e-10, atol=1e-12
                )
                state, at = found.y[:, -1], to
        ends.append(state)
    (w_m, turn_m, end_m), (w_f, turn_f, end_f) = ends
    start, force = np.linalg.solve([[w_m, w_f], [turn_m, turn_f]], [0.5, 1.0])
    return float(start * end_m + force * end_f + force / 2.0 - n / 2.0)


@pytest.mark.parametrize("xi", [1.0, 0.6, 0.2])
@pytest.mark.parametrize("upright", [2.0, 40.0])
def test_held_across_it_is_where_the_equation_of_the_blade_has_no_moment_left(xi, upright):
    found = float(overturning_tension(upright=upright, xi=xi, across=True))
    start = 2.0 * (1.0 / xi + upright)
    known = brentq(lambda n: _bent_evenly(n, xi) + upright, start, 3.0 * start)
    assert found == pytest.approx(known, rel=1e-6)


@pytest.mark.parametrize("nu", [0.0, 0.49])
@pytest.mark.parametrize("r", [0.04, 0.2])
@pytest.mark.parametrize(("h", "xi"), [(0.01, 1.0), (0.05, 1.0), (0.02, 0.5), (0.01, 0.2)])
@pytest.mark.parametrize("across", [True, False])
def test_shear_and_stretching_lower_it_by_less_than_is_told(across, h, xi, r, nu):
    profile = Constant(h) if xi == 1.0 else NeckedDown(h, xi / 2.0)
    blades = tuple(
        Blade(f"blade {y}", "ground", "moving", (0.0, y), (1.0, y), profile, 1.0) for y in (-r, r)
    )
    layout = Layout((Body("moving", (0.5, 0.0)),), blades, 1.0, 0.5 / (1.0 + nu))
    held = {"moving": (None, 0.0 if across else None, None)}
    pull = [Load("moving", (0.5, 0.0), (1.0, 0.0))]
    exact = linear_critical(layout, held, pull, strain=2.0).factor
    n = float(overturning_tension(upright=12.0 * r**2 / (h**2 * xi), xi=xi, across=across))
    slender, strain = 2.0 * n * h**3 / 12.0, n * h**2 / 12.0
    assert slender / (1.0 + PULLED * strain) <= exact <= slender * (1.0 + 1e-9)


@pytest.mark.parametrize("ends", ["clamped-pinned", "clamped-free"])
@pytest.mark.parametrize(
    "shape",
    ["kind: leaf-spring-stage", "kind: necked-down-stage\n  l_c: 2 mm"],
    ids=lambda s: s[:14],
)
def test_a_narrow_stage_that_is_pulled_is_not_told_to_bear_what_it_does_not(shape, ends):
    text = f"""
flexure: 1
title: pulled
geometry:
  {shape}
  blades: 2
  h: 0.05 mm
  l: 20 mm
  b: 5 mm
  spacing: 0.5 mm
material: {{name: steel, youngs_modulus: 200 GPa, poisson_ratio: 0.3}}
cases: {{work: {{ends: {ends}, load: {{force: 10 N, direction: 0 deg}}}}}}
requirements: {{buckling: {{factor: 1}}}}
"""
    factors = []
    for model in ("closed-form", "linear", "exact"):
        checks = flexcli.verdicts(text, model=model).checks
        (check,) = (check for check in checks if check.name == "buckling")
        assert check.factor_range is not None
        factors.append((check.factor, *check.factor_range))
    assert factors[0][0] < 50.0
    for factor, *_ in factors[1:]:
        assert factors[0][1] <= factor <= factors[0][2]
