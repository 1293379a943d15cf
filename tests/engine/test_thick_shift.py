"""Shifts of first order by the stretching of thick, wide blades, against CalculiX's solids.

Each is the shift at 1 µrad by ``flexure verify`` on three meshes, with by how much the last two
differ. ``tests/benchmarks/thick_shifts.py`` draws others.
"""

import pytest
import yaml

import flexcli

MM, DEG = "{} mm", "{} deg"


def star(h, b, p, *angles):
    sizes = {"h": MM.format(h), "l": "20 mm", "b": MM.format(b), "p": MM.format(p)}
    return {"kind": "star", **sizes, "angles": [DEG.format(angle) for angle in angles]}


def pair(h, b, p, half_angle):
    sizes = {"h": MM.format(h), "l": "20 mm", "b": MM.format(b), "p": MM.format(p)}
    return {"kind": "rcc", **sizes, "half_angle": DEG.format(half_angle)}


SOLIDS = {
    "star, h/l 0.12": (star(2.427896, 53.532182, 12.183983, 341.513801, 75.815261, 182.031468),
                       0.19613108, 1.126891e-10, 5e-4),
    "star, h/l 0.07": (star(1.411012, 11.930054, 5.1029325, 33.089739, 159.100797, 214.132883),
                       0.41055223, 1.143853e-10, 1.0e-3),
    "star, h/l 0.23": (star(4.585738, 38.556006, 12.169464, 102.888497, 168.820874),
                       0.31490418, 2.628368e-9, 1.7e-3),
    "star, h/l 0.31": (star(6.1866626, 19.47506, 20.038024, 29.100969, 155.91011),
                       0.46239799, 1.279968e-9, 7.5e-3),
    "pair, h/l 0.11": (pair(2.2437025, 53.532182, 10.236629, 57.945978),
                       0.19613108, 1.826766e-10, 4e-4),
    "pair, h/l 0.07": (pair(1.3552413, 11.930054, 16.002011, 23.676638),
                       0.41055223, 7.165168e-10, 1.0e-3),
    "pair, h/l 0.27": (pair(5.3496067, 19.47506, 16.147117, 23.233441),
                       0.46239799, 7.218739e-9, 5.4e-3),
    "pair, h/l 0.20": (pair(4.0505767, 38.556006, 5.078614, 31.432055),
                       0.31490418, 1.612545e-9, 1.5e-3),
}  # fmt: skip
"""Geometry, ν, the shift of solids [m] and its error."""


@pytest.mark.parametrize("solid", SOLIDS.values(), ids=SOLIDS)
def test_solids_are_within_the_error_of_the_shift_of_thick_wide_blades(solid):
    geometry, nu, shift, unsure = solid
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": "70 GPa", "poisson_ratio": nu},
        "geometry": geometry,
        "cases": {"work": {"stroke": {"rotation": "1 urad"}}},
        "requirements": {"parasitic_shift": {"max": "1 m"}},
    }
    checks = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
    (check,) = (each for each in checks if each.name.startswith("parasitic shift"))
    low, high = check.factor_range
    assert low * (1.0 - unsure) <= 1.0 / shift <= high * (1.0 + unsure)
    assert high / low < 1.08
