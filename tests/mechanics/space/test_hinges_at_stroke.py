"""Stress of loads across tapers and hinges, at rest and at a stroke, against solids."""

import json
from pathlib import Path

import numpy as np
import pytest

from flexcli.formulas.profile import Filleted, Notch, Tabulated
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.stresses import added_states, largest_of
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceLoad,
)
from flexcli.mechanics.space.springs import springs_of
from flexcli.mechanics.space.stresses import equivalent, hinge_error, stress_rows

SOLIDS = json.loads((Path(__file__).parent / "hinges_at_stroke.json").read_text(encoding="utf-8"))
"""``tests/benchmarks/hinges_at_stroke.py``: at random over the ranges that are told."""

KINDS = {
    "taper": lambda *h: Tabulated(tuple(np.linspace(0.0, 1.0, len(h)).tolist()), h),
    "notch": Notch, "filleted": Filleted,
}  # fmt: skip


def hinge(kind, numbers, l, b, nu):
    profile, material = KINDS[kind](*(1e-3 * n for n in numbers)), Isotropic(2e11, 1e11 / (1 + nu))
    ends = (0.0, 0.0, 0.0), (1e-3 * l, 0.0, 0.0)
    return SpaceBlade("h", "ground", "b", *ends, (0, 0, 1), profile, 1e-3 * b, material)


KNOWN = [row for row in SOLIDS if hinge_error(hinge(*row[:5])) is not None]
"""Those within the ranges: some tapers are steeper or wider than those whose springs are told."""


def at_rest(blade, load):
    """Return the largest stress of V_z, T, M_y at the middle of a blade [Pa]."""
    V, T, M = load
    found = springs_of(blade)
    M += (float(found.springs.across_width) - found.l / 2.0) * V
    rows, forces = stress_rows(blade, found), np.array([0, 0, V, T, M, 0, 0, 0, 0])
    return float(equivalent(rows.normal @ forces, rows.shear @ forces).max())


def added_at_stroke(blade, held, loads):
    """Yield the largest stress that loads add at a stroke, by exact beams [Pa]."""
    middle = tuple(np.add(blade.start, blade.end) / 2.0)
    drive = Drive("b", True, (0, 0, 1), middle)
    layout = SpaceLayout((SpaceBody("b", middle, middle),), (blade,), drive)
    way, a = {"b": (None, held[0], None, None, None, held[1])}, middle[0]
    plain = solve(layout, way, levels=(40,)).checked()
    for V, T, M in loads:
        forces = {(0, 0): V, (0, a): T / 2 / a, (0, -a): -T / 2 / a,
                  (-a, 0): M / 2 / a, (a, 0): -M / 2 / a}  # fmt: skip
        acting = tuple(
            SpaceLoad("b", (middle[0] + x, y, 0.0), (0.0, 0.0, F)) for (x, y), F in forces.items()
        )
        state = solve(layout, way, loads=acting, levels=(40,)).checked()
        yield largest_of(layout, added_states(state, plain))


def test_stress_across_tapers_and_hinges_at_rest_is_within_what_is_told():
    assert len(KNOWN) > 30
    for *shape, _, cases in KNOWN:
        blade = hinge(*shape)
        low, high = hinge_error(blade)
        for *load, solid, _ in cases:
            assert 1.0 + low < solid / at_rest(blade, load) < 1.0 + high, shape


@pytest.mark.parametrize(
    "row",
    [
        pytest.param(row, marks=[] if k % 8 == 0 else pytest.mark.slow)
        for k, row in enumerate(KNOWN)
    ],
)
def test_stress_across_tapers_and_hinges_at_a_stroke_is_within_what_is_told(row):
    *shape, held, cases = row
    blade = hinge(*shape)
    low, high = hinge_error(blade)
    found = added_at_stroke(blade, held, [load for *load, _, _ in cases])
    for (*_, solid), told in zip(cases, found, strict=True):
        assert 1.0 + low < solid / told < 1.0 + high


def test_a_moment_across_a_thin_twisted_strip_adds_to_the_shear_at_its_edges():
    """√(σ² + 3 τ²) of both, which are there but for a thickness, where the ends may warp."""
    material = Isotropic(200e9, 77e9)
    profile = KINDS["taper"](0.2e-3, 0.2e-3 * (1 + 1e-9))
    ends = (0.0, 0.0, 0.0), (0.1, 0.0, 0.0)
    blade = SpaceBlade("h", "ground", "b", *ends, (0, 0, 1), profile, 10e-3, material, warps=True)
    bent, sheared = 1e-2 * 6.0 / (0.2e-3 * 10e-3**2), 1e-4 * 3.0 / (10e-3 * 0.2e-3**2)
    both = np.hypot(bent, 3.0**0.5 * sheared)
    assert at_rest(blade, (0.0, 1e-4, 1e-2)) == pytest.approx(both, rel=0.03)
