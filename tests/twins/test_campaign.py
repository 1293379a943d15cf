"""Random specs near their limits: no bug, and no pass that the finest model fails.

One a kind of joint here; `tests/benchmarks/campaign.py` tries thousands.
"""

import pytest

from twins.campaign import BUG, KINDS, tried
from twins.verdicts import UNSAFE


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(len(KINDS)), ids=lambda seed: KINDS[seed])
def test_a_random_spec_near_its_limit_is_judged_without_a_sin(seed):
    found = tried(seed)
    assert found.sin != BUG, (found.spec, found.said.bug)
    for each in found.outcomes:
        assert each.sin != UNSAFE, (found.spec, each.said.factors, each.finest.factors)
        for said in (each.said, each.finest):
            assert all(map(is_inside, said.factors, said.ranges)), (found.spec, said)


def is_inside(factor, between):
    """Return whether a factor is between the ends of its range, an end of nothing being none."""
    if factor is None or between is None:
        return True
    low, high = between
    return low * (1.0 - 1e-9) <= factor and (high is None or factor <= high * (1.0 + 1e-9))
