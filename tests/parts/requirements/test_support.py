"""Support stiffness and deflection, against what they are made of."""

import pytest
import yaml
from specs_for_tests import parallelogram

import flexcli
from flexcli.errors import SpecError

STAGE = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "10 mm", "spacing": "30 mm"}
MATERIAL = {"youngs_modulus": "114 GPa", "poisson_ratio": 0.3, "yield_strength": "800 MPa"}


def checks(requirements, geometry=STAGE, material=MATERIAL):
    spec = {"flexure": 1, "material": material, "geometry": geometry, "requirements": requirements}
    return flexcli.check(yaml.safe_dump(spec)).checks


def test_a_ratio_of_stiffnesses_is_as_unsure_as_both():
    bounds = [
        {"direction": "y", "min": "1 N/m"},
        {"direction": "x", "min": "1 N/m"},
        {"direction": "y", "over": "x", "min": 1},
    ]
    one, other, ratio = (check.factor_range for check in checks({"support": bounds}))
    assert other[1] > other[0]
    assert ratio == pytest.approx((one[0] / other[1], one[1] / other[0]), rel=1e-9)


def test_clamps_that_may_give_way_lower_the_least_support_and_not_the_most():
    asked = {"support": {"direction": "y", "min": "1 N/m"}}
    (held,) = checks(asked, {**STAGE, "clamps": "rigid"})
    (may,) = checks(asked, {**STAGE, "clamps": "monolithic"})
    assert may.factor_range[0] < held.factor_range[0]
    assert may.factor_range[1] == pytest.approx(held.factor_range[1])


def test_a_strength_that_a_misalignment_needs_is_asked_for():
    layout = parallelogram("0.1 mm", "2 mm")
    asked = {"misalignment_stress": {"of": "left", "rotation": {"about": "z", "by": "1 mrad"},
                                     "factor": 2, "allowable": "tensile-strength"}}  # fmt: skip
    with pytest.raises(SpecError, match="tensile_strength"):
        checks(asked, layout)


@pytest.mark.parametrize("beyond", [5e-3, -5e-3])
def test_a_point_beyond_the_tip_of_a_blade_is_softer_across_its_width_and_one_before_it_stiffer(
    beyond,
):
    E, h, l, b = 114e9, 0.2e-3, 20e-3, 2e-3
    blade = {"kind": "cantilever", "h": f"{h} m", "l": f"{l} m", "b": f"{b} m"}
    # x is the stroke, so that the blade stands along y, its root where y is positive
    asked = {"direction": "z", "min": "1 N/m", "point": ["0 m", f"{-beyond} m", "0 m"]}
    (found,) = checks({"support": asked}, blade, {**MATERIAL, "poisson_ratio": 0.0})
    bends = (l**3 / 3.0 + beyond * l**2 + beyond**2 * l) / (E * h * b**3 / 12.0)
    # shear adds some (b/l)²
    assert found.capacity == pytest.approx(1.0 / bends, rel=2.0 * (b / l) ** 2)


@pytest.mark.parametrize("share", [1.0, 0.1, 0.01])
def test_a_force_along_the_width_of_a_strip_that_a_torque_turns_bends_it_the_other_way(share):
    """Straight beams told ±0.7 % of a deflection that is twice as much: it comes in third order."""
    strip = {"kind": "cantilever", "h": "0.24867 mm", "l": "77.94 mm", "b": "20.31 mm"}
    wrench = {"z": f"{-0.287 * share!r} N", "theta_y": f"{0.00223 * share!r} N*m"}
    asked = {
        "flexure": 1, "geometry": strip, "cases": {"turned": {"wrench": wrench}},
        "material": {"name": "m", "youngs_modulus": "70 GPa", "poisson_ratio": 0.0},
        "requirements": {"deflection": {"direction": "z", "max": "1 mm"}},
    }  # fmt: skip
    linear, exact = (
        flexcli.verdicts(yaml.safe_dump(asked), model=model).checks[0]
        for model in ("linear", "exact")
    )
    assert exact.factor_range is not None
    if linear.factor_range is not None:
        least, most = linear.factor_range
        assert least <= exact.factor_range[1]
        assert exact.factor_range[0] <= most
    assert (linear.factor_range is None) == (share == 1.0)
