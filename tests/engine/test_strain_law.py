"""What the law of finite strain may change in a shift, against strips bent by each law."""

import numpy as np
import pytest
import yaml
from scipy.optimize import root
from shell_shifts import asked as case_of
from twins.campaign import scene

import flexcli
from flexcli.engine.joint_models.corrections import setting_of
from flexcli.engine.joint_models.crossed_states import solid_of
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.strain_law import off_by_strain_law

GREEN, HENCKY = (
    (lambda stretch: (stretch**2 - 1.0) / 2.0, lambda stretch: stretch),
    (np.log, lambda stretch: 1.0 / stretch),
)
"""Strain by a stretch, and its derivative."""


def asked(geometry, nu, travel, motion="rotation"):
    spec = {
        "flexure": 1, "material": {"youngs_modulus": "70 GPa", "poisson_ratio": nu},
        "geometry": geometry, "cases": {"work": {"stroke": {motion: travel}}},
        "requirements": {"parasitic_shift": {"max": "1 m"}},
    }  # fmt: skip
    return case_of(spec)._replace(joint_model=ExactModel())


def growth(law, curvature, nu, places=31):
    """Return by how much the middle of a strip of unit thickness grows as a moment bends it.

    Its radii are those at which the energy of all its fibres is least, in plane stress.
    """
    strain, slope = law
    y = np.linspace(-0.5, 0.5, places)
    step = y[1] - y[0]

    def unbalanced(radii):
        found = np.zeros(places)
        for share in (0.5 - 3**-0.5 / 2.0, 0.5 + 3**-0.5 / 2.0):
            along = curvature * (radii[:-1] * (1.0 - share) + radii[1:] * share)
            through = np.diff(radii) / step
            one, two = strain(along), strain(through)
            pull = (one + nu * two) * slope(along) / (1.0 - nu**2)
            press = (two + nu * one) * slope(through) / (1.0 - nu**2)
            found[:-1] += step / 2.0 * (pull * curvature * (1.0 - share) - press / step)
            found[1:] += step / 2.0 * (pull * curvature * share + press / step)
        return found

    radii = root(unbalanced, 1.0 / curvature + y, tol=1e-12).x
    return curvature * radii[places // 2] - 1.0


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
def test_strips_bent_by_either_law_grow_within_the_error(nu):
    h, l, turn = 2e-3, 20e-3, 0.4
    blade = {"kind": "moment-blade", "h": f"{h} m", "l": f"{l} m", "b": "5 mm"}
    ask = asked(blade, nu, f"{turn} rad")
    shift = ExactModel().parasitic_shift(ask)
    told = off_by_strain_law(ask, shift) * abs(shift) / l
    grown = [abs(growth(law, turn * h / l, nu)) for law in (GREEN, HENCKY)]
    assert max(grown) == pytest.approx(told, rel=0.03)


@pytest.mark.parametrize(("ratio", "angle"), [(19, 68), (28, 50), (40, 45)])
def test_solids_of_a_joined_cross_differ_by_as_much(ratio, angle):
    cross = {
        "kind": "unseparated-cross", "h": f"{20 / ratio} mm", "l": "20 mm", "b": "5 mm",
        "half_angle": f"{angle} deg",
    }  # fmt: skip
    ask = asked(cross, 0.3, "10 mrad")
    low, high = solid_of(ask).shift
    shift = ExactModel().parasitic_shift(ask)
    told = off_by_strain_law(ask, shift) * abs(shift) / ask.scene.travel**2
    assert told == pytest.approx((high - low) / 2.0, rel=0.25), "corners bear more, and are few"


STAGE = {
    "kind": "leaf-spring-stage",
    "h": "1 mm",
    "l": "40 mm",
    "b": "2 mm",
    "blades": 2,
    "spacing": "40 mm",
}
CLOSED = [
    {"kind": "rcc", "h": "1 mm", "l": "40 mm", "b": "2 mm", "p": "10 mm", "half_angle": "40 deg"},
    {
        "kind": "cross-spring",
        "h": "1 mm",
        "l": "40 mm",
        "b": "2 mm",
        "delta": -0.3,
        "half_angle": "30 deg",
    },
    {"kind": "cantilever", "h": "1 mm", "l": "40 mm", "b": "2 mm"},
    {"kind": "guided-blade", "h": "1 mm", "l": "40 mm", "b": "2 mm"},
    STAGE,
]  # fmt: skip


@pytest.mark.parametrize("geometry", CLOSED, ids=lambda of: of["kind"])
def test_the_closed_form_of_slender_blades_is_that_of_their_beams(geometry):
    motion = "rotation" if "half_angle" in geometry else "translation"
    ask = asked(geometry, 0.3, "1 mrad" if motion == "rotation" else "40 um", motion)
    shift = ExactModel().parasitic_shift(ask)
    told = setting_of(ask).bending.strain_law(0.3)
    assert off_by_strain_law(ask, shift) == pytest.approx(told, rel=0.03)


def test_a_linkage_with_ideal_joints_has_a_known_shift():
    drawn = scene(3820004, ("linkage",))
    asked_of = {"parasitic_shift": drawn.easy["parasitic_shift"]}
    checks = flexcli.verdicts(yaml.safe_dump({**drawn.spec, "requirements": asked_of})).checks
    shifts = [check for check in checks if check.name.startswith("parasitic shift")]
    assert shifts
    assert all(check.factor_range is not None for check in shifts)
