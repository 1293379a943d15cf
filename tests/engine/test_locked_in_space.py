"""A mechanism of several joints that is locked, under a steady acceleration in any direction."""

import pytest
import yaml

import flexcli
from flexcli.errors import SpecError
from flexcli.results import Verdict

MATERIAL = {"youngs_modulus": "113 GPa", "poisson_ratio": 0.34, "yield_strength": "880 MPa",
            "density": "1e-6 kg/m^3"}  # fmt: skip
H, L, B, P, HEIGHT = 0.3e-3, 14e-3, 10e-3, 2e-3, 20e-3
MASS, COM = 17e-3, 10e-3
GEOMETRY = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg", "h": "0.3 mm", "l": "14 mm",
            "b": "10 mm"}  # fmt: skip
LEVER = {"mass": "17 g", "com": "10 mm", "inertia": "5e-6 kg*m^2"}
STAGE = {"kind": "parallel-stage", "height": "20 mm", "solid-1": LEVER,
         "solid-2": {"mass": "68 g"}, "solid-3": LEVER}  # fmt: skip


def judged(acceleration, name="yield", model=None, **case):
    text = yaml.safe_dump(
        {
            "flexure": 1, "material": MATERIAL, "geometry": GEOMETRY, "mechanism": STAGE,
            "cases": {"launch": {"lock": "solid-2", "acceleration": acceleration, **case}},
            "requirements": {"yield": 1.5, "buckling": 2},
        }
    )  # fmt: skip
    found = flexcli.verdicts(text, model=model)
    return next(check for check in found.checks if check.name.startswith(name))


def test_along_its_levers_each_bears_its_weight_by_the_pivot_at_its_ground():
    """Solid 2 is held: a lever hangs on both of its pivots, which share its weight along y.

    Both pivots of a lever are alike along y: each bears half, by two blades at 45 deg.
    """
    acceleration = 9.80665 * 20.0
    found = judged({"y": "20 g"})
    force = MASS * acceleration / 2.0
    axial = force / 2.0 / 0.5**0.5 / (B * H)
    low, high = (found.capacity / factor for factor in found.factor_range[::-1])
    # stretching bends the blades a little besides: 3 (h/l) tan α of the axial stress
    assert low <= axial * (1.0 + 3.0 * H / L) * 1.1
    assert high >= axial


def test_an_acceleration_in_space_is_the_sum_of_its_components():
    along_x, along_y, along_z, all_three = (
        judged(acceleration, model="linear").demand
        for acceleration in (
            {"x": "10 g", "y": "1e-6 g"}, {"y": "10 g"}, {"z": "10 g"},
            {"x": "10 g", "y": "10 g", "z": "10 g"},
        )
    )  # fmt: skip
    assert max(along_x, along_y, along_z) < all_three
    assert all_three <= (along_x + along_y + along_z) * (1.0 + 1e-9)


def test_the_stress_along_x_is_that_of_the_planar_model():
    planar = judged({"x": "20 g"}, model="exact")
    spatial = judged({"x": "20 g", "z": "1e-6 g"}, model="exact")
    assert spatial.model == "exact"
    assert spatial.factor == pytest.approx(planar.factor, rel=0.08)


def test_it_buckles_where_its_pivots_do_in_the_plane():
    planar = judged({"x": "2000 g"}, name="buckling", model="exact")
    spatial = judged({"x": "2000 g", "z": "1e-6 g"}, name="buckling", model="exact")
    assert "solid-2 locked" in spatial.quantity
    assert spatial.factor_range[0] <= planar.factor_range[1]
    assert spatial.factor_range[1] >= planar.factor_range[0]


def test_a_stage_that_is_not_locked_is_told_what_would_judge_it():
    text = yaml.safe_dump(
        {
            "flexure": 1, "material": MATERIAL, "geometry": GEOMETRY, "mechanism": STAGE,
            "cases": {"launch": {"acceleration": {"z": "20 g"}}}, "requirements": {"yield": 1.5},
        }
    )  # fmt: skip
    with pytest.raises(SpecError) as refused:
        flexcli.verdicts(text)
    assert "lock:" in refused.value.findings[0].hint


@pytest.mark.parametrize("name", ["yield", "buckling"])
@pytest.mark.parametrize("beside", [{"load": {"force": "1 N"}}, {"wrench": {"z": "1 N"}}])
def test_what_else_acts_is_for_a_case_of_its_own(name, beside):
    found = judged({"z": "20 g"}, name=name, **beside)
    assert found.verdict is Verdict.UNDECIDED
    assert found.factor_range is None
    assert "state each in a case of its own" in found.quantity
