"""Limbs between two notches as solids: against CalculiX's and against plane bodies."""

import json
from pathlib import Path

import numpy as np
import pytest

from flexcli.formulas.hinged_limb import limb_softening
from flexcli.mechanics.solids.limb import RigidLimb, about
from flexcli.mechanics.solids.neck import Neck
from flexcli.mechanics.solids.unit_loads import FINE, NeckUnderLoads

ROWS = json.loads((Path(__file__).parents[1] / "space/limbs.json").read_text(encoding="utf-8"))
MESHED = 3e-3
"""What CalculiX's mesh has more or less: it cuts the last of a notch, before the mouth, short."""


def limb(e, l, b, nu, block):
    """Return the solid of a limb whose notches have a radius of one."""
    return NeckUnderLoads(Neck(e, 1.0, 2.0, b, 0.0, block, l / 2.0 - 1.0), 1.0, nu)


@pytest.mark.parametrize("index", range(len(ROWS)))
def test_six_compliances_of_limbs_are_those_of_calculix(index):
    *sizes, compliances, _ = ROWS[index]
    solid = limb(*sizes)
    for k, expected in enumerate(compliances):
        found, off = solid.compliance(k)
        assert found == pytest.approx(expected, rel=off + MESHED)


@pytest.mark.parametrize("index", [0, 1, 4])
def test_stresses_of_limbs_are_those_of_calculix(index):
    *sizes, _, largest = ROWS[index]
    stress, is_last = limb(*sizes).stresses(np.eye(6), FINE)
    xx, yy, zz, yz, zx, xy = np.moveaxis(stress, -1, 0)
    apart = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    found = np.sqrt(apart / 2.0 + 3.0 * (yz**2 + zx**2 + xy**2))
    assert not is_last[found.argmax(axis=1)].any()
    # what CalculiX extrapolates to its nodes is up to 4 % more, as of single notches
    assert found.max(axis=1) == pytest.approx(np.array(largest), rel=0.055)


@pytest.mark.parametrize(("e", "l", "block"), [(0.2, 5.0, 2.2), (1.0, 2.5, 3.0), (0.5, 2.2, 1.0)])
def test_a_narrow_limb_is_a_plane_body(e, l, block):
    b = e / 10.0
    solid, plane = limb(e, l, b, 0.3, block), limb_softening(e=e, r=1.0, l=l, blocks=block)
    for index, span in ((0, plane.along), (1, plane.swing), (5, plane.turn)):
        found, off = solid.compliance(index)
        assert span.low * (1.0 - off) <= found * b <= span.high * (1.0 + off)


def test_a_limb_that_is_rigid_between_its_necks_gives_way_less_than_a_bar():
    neck = Neck(0.5, 1.0, 2.0, 3.0)
    rigid = RigidLimb(NeckUnderLoads(neck, 1.0, 0.3), 4.0)
    bar = limb(0.5, 4.0, 3.0, 0.3, 0.0)
    for index in range(6):
        assert rigid.compliance(index)[0] < bar.compliance(index)[0]
    # by a force across its middle each throat is bent half a limb away
    stress, _ = rigid.stresses(np.eye(6)[[1]], FINE)
    alone, _ = rigid.each.stresses(np.array([[0.0, 1.0, 0.0, 0.0, 0.0, 2.0]]), FINE)
    assert np.abs(stress[..., 0]).max() == pytest.approx(np.abs(alone[..., 0]).max(), rel=1e-9)


def test_a_wrench_about_another_place_has_the_moment_of_its_forces_there():
    wrench = np.array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    force, moment = wrench[:3], wrench[3:]
    moved = about(wrench, 0.5)
    assert moved[:3] == pytest.approx(force)
    assert moved[3:] == pytest.approx(moment - np.cross([0.5, 0.0, 0.0], force))
