"""Checks of single hinges that a wide error left open though what is known decides them."""

from math import inf

import numpy as np
import pytest
import yaml

import flexcli
from flexcli.engine.joint_models.soft_blocks import with_soft_blocks
from flexcli.formulas.profile import Notch
from flexcli.mechanics.space.layout import Drive, Isotropic, SpaceBlade, SpaceBody, SpaceLayout
from flexcli.mechanics.space.linear import assemble
from flexcli.mechanics.space.springs import springs_of
from flexcli.results import Verdict

STEEL = {"youngs_modulus": "200 GPa", "poisson_ratio": 0.3, "yield_strength": "500 MPa",
         "density": "7800 kg/m^3"}  # fmt: skip
NOTCH = {"kind": "notch-hinge", "e": "0.5 mm", "r": "5 mm", "b": "10 mm"}


def judged(geometry, case, requirement):
    spec = {"flexure": 1, "material": STEEL, "geometry": geometry, "cases": {"c": case},
            "requirements": requirement}  # fmt: skip
    rows = flexcli.verdicts(yaml.safe_dump(spec)).checks
    return next(row for row in rows if row.name.startswith(next(iter(requirement))))


def test_hinges_in_narrow_blocks_that_stand_many_times_their_load_do_not_buckle():
    """A load across the plane bends the blocks, whose softness does not let the hinge turn away."""
    hinge = {"kind": "elliptic-hinge", "e": "0.1 mm", "depth": "0.5 mm", "l": "1.3 mm",
             "b": "0.25 mm", "blocks": "massive"}  # fmt: skip
    found = judged(hinge, {"wrench": {"z": "5 N"}}, {"buckling": {"factor": 5}})
    assert found.verdict is Verdict.PASS
    assert found.factor_range[1] == inf


def test_a_hinge_with_soft_blocks_gives_way_as_its_springs_at_their_softest():
    """Whose bars were held against solids; a plate beside a rigid body is up to 1/(1 − ν²) less."""
    e, r, b, L = 0.2e-3, 1e-3, 1.5e-3, 1e-3
    ends, middle = ((0.0, 0.0, 0.0), (2.0 * r, 0.0, 0.0)), (r, 0.0, 0.0)
    hinge = SpaceBlade(
        "h", "ground", "b", *ends, (0, 0, 1), Notch(e, r), b, Isotropic(200e9, 77e9),
        blocks=(0.0, L),
    )  # fmt: skip
    layout = SpaceLayout(
        (SpaceBody("b", middle, middle),), (hinge,), Drive("b", True, (0, 0, 1), middle)
    )
    found = np.diag(assemble(with_soft_blocks(layout)).compliance("b", middle, locked=False))
    alone = assemble(layout.__class__(layout.bodies, (bare(hinge),), layout.drive))
    alone = np.diag(alone.compliance("b", middle, locked=False))
    told, own = springs_of(hinge), springs_of(bare(hinge))
    softest = np.diag(assemble(layout).compliance("b", middle, locked=False)) / (1.0 + told.low)
    bars = softest - alone / (1.0 + own.low)
    bars[3] -= 0.25 * alone[3]
    assert np.all(found > alone)
    assert found - alone == pytest.approx(bars, rel=0.2)


def bare(hinge):
    return SpaceBlade(
        hinge.name, hinge.first, hinge.second, hinge.start, hinge.end, hinge.width, hinge.profile,
        hinge.b, hinge.material,
    )  # fmt: skip


def test_a_stroke_that_yields_a_hinge_fails_it_whatever_a_load_across_adds():
    hinge = {"kind": "filleted-hinge", "h": "1 mm", "r": "2 mm", "l": "10 mm", "b": "25 mm"}
    case = {"stroke": {"rotation": "0.2 rad"}, "wrench": {"z": "1 N"}}
    found = judged(hinge, case, {"yield": {"factor": 2}})
    assert found.verdict is Verdict.FAIL
    assert found.factor_range[0] == 0.0
    assert found.factor_range[1] == pytest.approx(found.factor, rel=0.15)


def test_a_load_along_a_hinge_does_not_move_it_across():
    found = judged(
        NOTCH, {"wrench": {"x": "10 N"}}, {"deflection": {"direction": "y", "max": "1 µm"}}
    )
    assert found.verdict is Verdict.PASS
    assert found.factor > 1e3


def test_a_load_across_that_exceeds_the_mean_s_limit_fails_a_small_stroke():
    """Its stress is where the amplitude is, or where that is nothing."""
    endured = {"value": "250 MPa", "cycles": 1e7, "stress_ratio": -1}
    strong = {"tensile_strength": "600 MPa", "fatigue_amplitude": endured}
    spec = {"flexure": 1, "material": STEEL | strong, "geometry": NOTCH,
            "cases": {"c": {"stroke": {"rotation": "1 µrad", "cycles": 1e7},
                            "wrench": {"theta_y": "10 N*m"}}},
            "requirements": {"fatigue": {"factor": 2, "mean_stress": "goodman"}}}  # fmt: skip
    (found,) = flexcli.verdicts(yaml.safe_dump(spec)).checks[-1:]
    assert found.verdict is Verdict.FAIL
    assert found.factor_range[1] < 1.5 * found.factor


def filleted(slender, width, radius):
    """Return the checks of a filleted hinge by a model; its sizes over h = 0.2 mm."""
    h = 0.2
    geometry = {
        "kind": "filleted-hinge", "h": f"{h} mm", "l": f"{slender * h} mm",
        "b": f"{width * h} mm", "r": f"{radius * h} mm", "blocks": "5 mm",
    }  # fmt: skip
    spec = {
        "flexure": 1,
        "material": {
            "youngs_modulus": "113 GPa", "poisson_ratio": 0.34, "yield_strength": "880 MPa",
        },
        "geometry": geometry,
        "cases": {"work": {"stroke": {"rotation": "0.001 rad"}}},
        "requirements": {"yield": 1e-3},
    }  # fmt: skip

    def check(model):
        found = flexcli.verdicts(yaml.safe_dump(spec), model=model).checks
        return next(each for each in found if each.name.startswith("yield"))

    return check


@pytest.mark.parametrize(("width", "radius"), [(1.05, 0.5), (3.0, 1.0), (10.0, 1.0), (30.0, 2.0)])
def test_fillets_bear_more_in_the_middle_of_slender_hinges_as_clamps_do(width, radius):
    """Solids have up to 17 % more than beams there, of b/l from 0.02 to 0.6."""
    check = filleted(50.0, width, radius)
    (low, high), (least, most) = (check(model).factor_range for model in ("closed-form", "solid"))
    assert low <= most
    assert least <= high


def test_solids_say_nothing_of_a_hinge_as_slender_as_a_blade():
    check = filleted(700.0, 3.0, 20.0)
    assert check("solid").factor_range is None
    assert check("exact").factor_range is not None
