"""What loads amplify near buckling: against the amplification 1/(1 − s) itself."""

from math import inf

import numpy as np
import pytest

from flexcli.formulas.amplified import FURTHER, amplified, bent_by_forces, bent_part, relieved


def amplification(s):
    """Return by how much loads amplify that are a share of what buckles a joint."""
    return 1.0 / (1.0 - s)


@pytest.mark.parametrize("softer", [1e-3, 0.02, 0.05, 0.1])
@pytest.mark.parametrize("share", [0.1, 0.5, 0.8, 0.9])
def test_the_error_of_what_is_amplified_is_that_of_a_softer_joint(share, softer):
    here, further = (np.array(s * amplification(s)) for s in (share, (1.0 + FURTHER) * share))
    bent = bent_by_forces(np.array(0.0), None, here, further)
    if share * (1.0 + softer) >= 1.0:
        assert amplified(bent, softer) == inf
        return
    # of the same load, the share of what buckles it that it is is larger
    true = amplification(share * (1.0 + softer)) / amplification(share) - 1.0
    assert amplified(bent, softer) == pytest.approx(true, rel=1e-9)


@pytest.mark.parametrize("off", [1e-3, 0.02, 0.1, 0.5])
@pytest.mark.parametrize("share", [-4.0, -0.5, -0.1, 0.1, 0.5, 0.8, 0.95])
def test_what_is_relieved_is_that_of_a_stiffer_joint_or_of_one_pulled_straight(share, off):
    here, further = (np.array(s * amplification(s)) for s in (share, (1.0 + FURTHER) * share))
    bent = bent_part(np.array(0.0), here, further) / abs(here)
    there = share * (1.0 + off) if share < 0.0 else share / (1.0 + off)
    less = 1.0 - amplification(there) / amplification(share)
    assert less * (1.0 - 1e-9) <= relieved(bent, off) <= 1.2 * less + off**2


def test_what_acts_in_first_order_bends_nothing_of_what_is_deformed():
    rest = np.array([3.0, -1.0, 0.0])
    load = np.array([0.5, 2.0, 1.0])
    assert bent_part(rest, rest + load, rest + (1.0 + FURTHER) * load) == pytest.approx(0.0)
    assert amplified(0.0, 0.1) == 0.0
