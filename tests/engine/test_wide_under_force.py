"""Wide blades that their stroke pulls more than it bends them, and that loads pull at a stroke."""

import numpy as np
import pytest
import yaml
from twins.drawn_in_space import in_space

import flexcli
from flexcli.mechanics.shell.stresses import shell_stresses

STAR = {
    "flexure": 1,
    "material": {
        "name": "soft",
        "youngs_modulus": "70 GPa",
        "poisson_ratio": 0.45,
        "yield_strength": "100 MPa",
        "tensile_strength": "120 MPa",
    },
    "geometry": {
        "kind": "star",
        "h": "0.027 mm",
        "l": "16 mm",
        "b": "3.4 mm",
        "angles": ["0 deg", "20 deg", "80 deg", "200 deg"],
        "p": "-15.2 mm",
        "tilt": "held",
    },
    "cases": {"work": {"stroke": {"rotation": "0.025 rad"}}},
    "requirements": {"yield": 1.0},
}
"""Thin blades about a centre near their ends, kept in one plane: N l²/EI is some fifty."""


def judged(spec, model="exact"):
    return flexcli.verdicts(yaml.safe_dump(spec), model=model).checks[0]


def in_one_plane(spec):
    """Return the spec drawn in space, with its blades at one height."""
    free = {**spec, "geometry": {k: v for k, v in spec["geometry"].items() if k != "tilt"}}
    drawn = in_space(free, flexcli.load(yaml.safe_dump(free)))
    for blade in drawn["geometry"]["blades"].values():
        for end in ("from", "to"):
            blade[end] = [*blade[end][:2], "0 mm"]
    return drawn


@pytest.fixture
def mean_stresses(monkeypatch):
    """Largest stress along a blade of shells, mean over its width at a clamp, as asked for."""
    from flexcli.engine.joint_models import space_shell

    found, plain = [], space_shell.SpaceShellModel.signed_stresses

    def watched(self, state):
        for face in shell_stresses(state, corner=0.0):
            for end in (face.s.min(), face.s.max()):
                at = np.isclose(face.s, end)
                order = np.argsort(face.z[at])
                z, each = face.z[at][order], face.along[:, at][:, order]
                means = np.diff(z) @ (each[:, 1:] + each[:, :-1]).T / 2.0 / (z[-1] - z[0])
                found.append(np.abs(means).max())
        return plain(self, state)

    monkeypatch.setattr(space_shell.SpaceShellModel, "signed_stresses", watched)
    return found


def test_the_stress_of_pulled_blades_is_that_of_shells(mean_stresses):
    """As wide ones their blades bend within l/7 of the clamps: plates are far flatter there."""
    check = judged(STAR)
    judged(in_one_plane(STAR), "shell")
    low, high = check.factor_range
    assert low <= 100e6 / max(mean_stresses) <= high
    assert high / low <= 1.15


@pytest.mark.parametrize("width", ["3.4 mm", "8 mm"])
def test_what_drives_pulled_blades_is_that_of_shells(width):
    driven = {
        **STAR,
        "geometry": STAR["geometry"] | {"b": width},
        "actuator": {
            "blocking_force": "5 N",
            "free_stroke": "5 mm",
            "arm": "10 mm",
            "drives": "both-ways",
        },
        "requirements": {"drive": 1e-3},
    }
    drawn = in_one_plane(driven)
    (low, high), shells = judged(driven).factor_range, judged(drawn, "shell")
    assert low <= shells.factor <= high
    assert high / low <= 1.15


def test_of_narrow_blades_and_small_strokes_nothing_is_left_open():
    narrow = {**STAR, "geometry": STAR["geometry"] | {"b": "0.03 mm"}}
    little = {**STAR, "cases": {"work": {"stroke": {"rotation": "0.0005 rad"}}}}
    for spec in (narrow, little):
        low, high = judged(spec).factor_range
        assert high / low <= 1.02


def test_a_material_of_no_poissons_ratio_widens_nothing():
    still = {**STAR, "material": STAR["material"] | {"poisson_ratio": 0.0}}
    check = judged(still)
    assert check.factor_range[1] / check.factor_range[0] <= 1.0 + 1e-3
    unknown = {k: v for k, v in STAR["material"].items() if k != "poisson_ratio"}
    low, high = judged({**STAR, "material": unknown}).factor_range
    assert low < 0.95 * check.factor
    assert high >= check.factor


@pytest.mark.parametrize("model", ["closed-form", "linear"])
def test_a_load_along_wide_blades_at_a_stroke_widens_the_range_of_formulas(model):
    """A guided blade pulled by n = 20: its plate bends as another beam than at rest."""

    def spec(force, width):
        return {
            "flexure": 1,
            "material": STAR["material"],
            "geometry": {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": width,
                         "spacing": "60 mm"},
            "cases": {"work": {"stroke": {"translation": "0.05 mm"},
                               "load": {"force": force}}},
            "requirements": {"yield": 1.0},
        }  # fmt: skip

    pulled, exact = judged(spec("20 N", "20 mm"), model), judged(spec("20 N", "20 mm"))
    assert pulled.factor_range[0] <= exact.factor_range[1]
    assert exact.factor_range[0] <= pulled.factor_range[1]

    def spread(check):
        return check.factor_range[1] / check.factor_range[0]

    assert spread(pulled) > spread(judged(spec("0.01 N", "20 mm"), model)) + 1e-3


def test_a_load_along_a_hinge_at_a_stroke_leaves_its_stress_known():
    hinge = {
        "flexure": 1,
        "material": STAR["material"],
        "geometry": {"kind": "notch-hinge", "e": "0.1 mm", "r": "2 mm", "b": "3 mm"},
        "cases": {"work": {"stroke": {"rotation": "0.005 rad"}, "load": {"force": "2 N"},
                           "ends": "clamped-free"}},
        "requirements": {"yield": 1.0},
    }  # fmt: skip
    low, high = judged(hinge).factor_range
    assert high / low < 1.3
