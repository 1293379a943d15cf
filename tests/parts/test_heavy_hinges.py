"""The mass of a hinge in its frequency: what stiffens or softens it somewhere changes that little.

The independent route are beams of many short elements, whose sections are more or less compliant
than their thickness says.
"""

from math import sqrt

import numpy as np
import pytest
import yaml
from scipy.linalg import eigh

from flexcli import check, load
from flexcli.engine import omitted_effects
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects.blade_mass import BladeMass

E, RHO = 70e9, 2700.0
HALF = 40

KINDS = {
    "notch": {"kind": "notch-hinge", "e": 2.0, "r": 10.0, "b": 60.0},
    "thin": {"kind": "notch-hinge", "e": 0.2, "r": 10.0, "b": 30.0},
    "ellipse": {"kind": "elliptic-hinge", "e": 1.0, "depth": 3.0, "l": 20.0, "b": 80.0},
    "fillets": {"kind": "filleted-hinge", "h": 1.0, "r": 4.0, "l": 20.0, "b": 20.0},
}
"""Hinges; sizes in mm."""

BODIES = [(30.0, 1.0), (1.0, 0.3), (0.1, 0.5), (1e-2, 0.1)]
"""Inertia and mass of the payload over those of the hinge."""


def sizes_of(kind):
    given = {k: 1e-3 * v for k, v in KINDS[kind].items() if k != "kind"}
    depth = given.get("depth", given.get("r"))
    e, l = given.get("e", given.get("h")), given.get("l", 2.0 * depth)
    round_ = 2.0 * depth if kind == "fillets" else l
    return e, depth, l, round_, given["b"]


def beam(kind):
    """Return nodes from mouth to mouth, and thickness and face's slope between them."""
    e, depth, l, round_, _ = sizes_of(kind)
    near = min(sqrt(e * round_**2 / 4.0 / depth), round_ / 2.0)
    curved = near * np.sinh(np.arcsinh(round_ / 2.0 / near) * np.linspace(0.0, 1.0, HALF))
    straight = (l - round_) / 2.0
    x = straight + curved
    if straight > 0.0:
        x = np.concatenate([np.linspace(0.0, straight, HALF)[:-1], x])
    x = np.concatenate([-x[::-1][:-1], x])
    s = np.maximum(np.abs(x[1:] + x[:-1]) / 2.0 - straight, 0.0) / (round_ / 2.0)
    slope = 2.0 * depth / round_ * s / np.sqrt(1.0 - s**2)
    return x, e + 2.0 * depth * (1.0 - np.sqrt(1.0 - s**2)), slope


def of_one_freedom(kind, body, stiffer=1.0):
    """Return the frequency with all mass over that of stiffness and payload's inertia alone."""
    x, h, _ = beam(kind)
    b, g, n = sizes_of(kind)[-1], stiffer * np.ones(len(h)), len(x)
    K, M = np.zeros((2 * n, 2 * n)), np.zeros((2 * n, 2 * n))
    for i, L in enumerate(np.diff(x)):
        own, EI = slice(2 * i, 2 * i + 4), g[i] * E * b * h[i] ** 3 / 12.0
        bend = [[12, 6 * L, -12, 6 * L], [6 * L, 4 * L**2, -6 * L, 2 * L**2],
                [-12, -6 * L, 12, -6 * L], [6 * L, 2 * L**2, -6 * L, 4 * L**2]]  # fmt: skip
        move = [[156, 22 * L, 54, -13 * L], [22 * L, 4 * L**2, 13 * L, -3 * L**2],
                [54, 13 * L, 156, -22 * L], [-13 * L, -3 * L**2, -22 * L, 4 * L**2]]  # fmt: skip
        K[own, own] += EI / L**3 * np.array(bend)
        M[own, own] += RHO * b * h[i] * L / 420.0 * np.array(move)
    mass, inertia = payload(kind, body)
    to_middle = np.array([1.0, -x[-1]])
    M[-2:, -2:] += mass * np.outer(to_middle, to_middle)
    M[-1, -1] += inertia
    K, M = K[2:, 2:], M[2:, 2:]
    stiffness = 1.0 / np.linalg.inv(K)[-1, -1]
    return sqrt(eigh(K, M, eigvals_only=True)[0]) / sqrt(stiffness / inertia)


def payload(kind, body):
    x, h, _ = beam(kind)
    dm = RHO * sizes_of(kind)[-1] * h * np.diff(x)
    J, m = body
    return m * dm.sum(), J / 2.0 * float(dm @ ((x[1:] + x[:-1]) / 2.0) ** 2)


def spec(kind, body, nu, **asked):
    mass, inertia = payload(kind, body)
    shape = {k: v if k == "kind" else f"{v} mm" for k, v in KINDS[kind].items()}
    material = {"name": "m", "youngs_modulus": f"{E} Pa", "density": f"{RHO} kg/m^3",
                "yield_strength": "400 MPa"}  # fmt: skip
    return {
        "flexure": 1,
        "material": material | ({} if nu is None else {"poisson_ratio": nu}),
        "geometry": {**shape, "blocks": "0 mm"},
        "mechanism": {"kind": "payload", "mass": f"{mass} kg", "inertia": f"{inertia} kg*m^2"},
        "cases": {"op": {"stroke": {"rotation": "1 mrad"}}},
        "requirements": {"frequency": {"min": "1 Hz"}, **asked},
    }


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("body", BODIES)
def test_what_changes_a_hinges_sections_leaves_its_mass_as_it_counts(kind, body):
    made = DesignSpec.model_validate(spec(kind, body, None))
    changed = BladeMass().changes(omitted_effects.setting(made, made.fixed_sizes()))
    error, (x, h, slope) = changed["frequency"].error, beam(kind)
    at, share = np.abs(x[1:] + x[:-1]) / 2.0, np.diff(x) / h**3
    inner = np.cumsum(share[np.argsort(at)])[np.argsort(np.argsort(at))] < share.sum() / 2.0
    plain = of_one_freedom(kind, body)
    sloped = 1.0 + 1.2 * slope**2 / (1.0 + 0.3 * slope**2)
    for softer in (sloped, np.where(inner, 0.75, 1.0), np.where(inner, 1.0, 0.75)):
        found = of_one_freedom(kind, body, 1.0 / softer)
        assert abs(found / plain - 1.0) <= error


def test_a_hinge_whose_mouths_give_way_is_not_told_closer_where_two_modes_mix():
    """A heavy payload shakes across the hinge almost as slowly as it turns about it."""
    kind, body = "notch", (1.0, 5.0)
    made = DesignSpec.model_validate(spec(kind, body, None))
    changed = BladeMass().changes(omitted_effects.setting(made, made.fixed_sizes()))
    assert changed["frequency"].other == np.inf


@pytest.mark.parametrize("kind", KINDS)
def test_the_frequency_of_a_heavy_hinge_is_about_as_sure_as_its_stiffness(tmp_path, kind):
    """Half the range of the stiffness, and what the mass of the hinge leaves: up to 2 % here."""
    asked = spec(kind, (1.0, 0.3), 0.3, stiffness={"min": "1e-6 N*m/rad"})
    del asked["geometry"]["blocks"]
    file = tmp_path / "hinge.yaml"
    file.write_text(yaml.safe_dump({**asked, "model": "exact"}), encoding="utf-8")
    stiffness, frequency = (
        next(c for c in check(load(file)).checks if c.name.startswith(name))
        for name in ("stiffness", "frequency")
    )
    width = [c.factor_range[1] / c.factor - c.factor_range[0] / c.factor
             for c in (stiffness, frequency)]  # fmt: skip
    assert width[1] <= width[0] / 2.0 + 0.04
