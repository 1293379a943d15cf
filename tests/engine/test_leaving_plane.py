"""Drawn joints of narrow blades buckle out of their plane, where blades alone hold a body."""

from math import pi, sqrt

import numpy as np
import pytest
import yaml

import flexcli

E, H, L = 70e9, 0.5e-3, 30e-3
FORCE = 5.0


def check(width, model, ends="clamped-free", **case):
    """Return the buckling of a parallelogram drawn in its plane, pushed along its blades."""
    blades = {
        name: {"between": ["ground", "stage"], "from": ["0 mm", y], "to": [f"{L} m", y],
               "h": f"{H} m", "b": f"{width} m"}
        for name, y in (("left", "-10 mm"), ("right", "10 mm"))
    }  # fmt: skip
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.0},
        "geometry": {
            "kind": "layout",
            "bodies": {"stage": {"at": [f"{L} m", "0 mm"]}},
            "blades": blades,
            "moving": "stage",
            "motion": {"translation": "90 deg"},
        },
        "cases": {"work": {"load": {"force": f"{FORCE} N", **case}, "ends": ends}},
        "requirements": {"buckling": 0.05},
    }
    found = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
    return min((each for each in found if "buckling" in each.name), key=lambda each: each.factor)


def in_plane(width):
    """Return the force that lets both blades sway between ends that do not turn [N]."""
    return 2.0 * pi**2 * E * width * H**3 / 12.0 / L**2


def aside(width):
    """Return the force that bends both aside, their tops free to turn with the stage [N]."""
    return 2.0 * pi**2 * E * H * width**3 / 12.0 / (4.0 * L**2)


@pytest.mark.parametrize("model", ["linear", "exact", None])
@pytest.mark.parametrize("share", [1.05, 1.3, 1.6])
def test_narrow_blades_bend_aside_with_their_stage(share, model):
    width = share * H
    found = check(width, model)
    low, high = found.factor_range
    assert low <= aside(width) / FORCE <= high
    assert "out of its plane" in found.quantity
    if model == "exact":
        assert found.factor == pytest.approx(aside(width) / FORCE, rel=5e-3)
        assert high / low < 1.15


@pytest.mark.parametrize("share", [3.0, 10.0])
def test_wide_blades_buckle_in_the_plane(share):
    found = check(share * H, "exact")
    assert found.factor == pytest.approx(in_plane(share * H) / FORCE, rel=5e-3)


def test_what_the_ends_hold_does_not_leave_the_plane():
    found = check(1.3 * H, "exact", ends="clamped-guided")
    assert found.factor == pytest.approx(in_plane(1.3 * H) / FORCE, rel=5e-3)


def test_a_pull_along_narrow_blades_buckles_nothing():
    pushed, pulled = (check(1.3 * H, "exact", direction=way) for way in ("180 deg", "0 deg"))
    assert pushed.factor == pytest.approx(aside(1.3 * H) / FORCE, rel=5e-3)
    assert pulled.factor > 10.0 * pushed.factor


SPRINGY = {
    "necked-down-stage": {"h": "0.2 mm", "l": "40 mm", "l_c": "1 mm", "spacing": "10 mm"},
    "hinged-stage": {
        "e": "0.2 mm",
        "r": "2 mm",
        "l": "40 mm",
        "spacing": "10 mm",
        "blocks": "0 mm",
    },
}
"""Stages of two limbs on two hinges each, stiff between them."""


def tipped(kind, width):
    """Return the force, of either sense, that tips a stage on its limbs across their width [N].

    Of links of length L on hinges of stiffness K the potential is ``K a²/2 + K (φ − a)²/2`` each,
    and their body's point, where F acts, stands half their length back along it: F = √2 K/L.
    """
    h, between = 0.2e-3, 40e-3
    flexes = 1e-3 / h  # ∫dx/h along a hinge
    if kind == "hinged-stage":
        x = np.linspace(-2e-3, 2e-3, 20001)
        flexes = float(np.trapezoid(1.0 / (h + 2.0 * (2e-3 - np.sqrt(2e-3**2 - x**2))), x))
    else:
        between -= 1e-3  # from the middle of one to that of the other
    return 2.0 * sqrt(2.0) * E * width**3 / 12.0 / flexes / between


@pytest.mark.parametrize("way", ["0 deg", "180 deg"])
@pytest.mark.parametrize("kind", SPRINGY)
def test_stages_on_narrow_hinges_tip_out_of_their_plane_pulled_or_pushed(kind, way):
    width = 0.2e-3 if way == "180 deg" else 0.3e-3
    spec = {
        "flexure": 1,
        "material": {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.0},
        "geometry": {"kind": kind, "b": f"{width} m", **SPRINGY[kind]},
        "cases": {"work": {"load": {"force": "1 N", "direction": way}, "ends": "clamped-free"}},
    }
    true = tipped(kind, width)

    def judged(share, model=None):
        asked = {**spec, "requirements": {"buckling": share * true}}
        checks = flexcli.verdicts(yaml.safe_dump(asked), model=model).checks
        return next(str(check.verdict) for check in checks if check.name == "buckling")

    assert judged(1.15) != "pass"
    # both ask the same straight blades
    assert judged(2.0, "linear" if way == "180 deg" else "closed-form") != "pass"
    assert judged(0.15) == "pass"
