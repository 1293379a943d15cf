"""A batch of designs: one exact solve equals many, and a design that fails fails alone."""

import numpy as np
import pytest
from geometries_for_tests import ELASTIC, SAMPLES, geometry

from flexcli.errors import Outcome
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.mesh import Effects
from flexcli.parts.geometries.base import MOVING

KINDS = sorted(set(SAMPLES) - {"torsion-bar", "round-torsion-bar", "torsion-star"})


@pytest.mark.parametrize("kind", KINDS)
def test_a_batch_equals_its_designs_one_by_one(kind):
    joint = geometry(kind)
    one = joint.sized({})
    scales = np.array([0.9, 1.0, 1.2])
    many = one._make(
        size * (scales if i == 0 else 1.0 + 0.0 * scales) for i, size in enumerate(one)
    )
    travel = 0.05 if joint.motion == "rotation" else 0.02 * getattr(one, "l", 1e-3)
    held = {MOVING: joint.held(travel)}
    together = solve(joint.layout(ELASTIC, many), held, effects=Effects())
    assert together.designs == 3
    for i, scale in enumerate(scales):
        sizes = one._make(size * (scale if n == 0 else 1.0) for n, size in enumerate(one))
        alone = solve(joint.layout(ELASTIC, sizes), held, effects=Effects())
        size = np.abs(alone.motions[0]).max()
        assert together.motions[i] == pytest.approx(alone.motions[0], rel=1e-8, abs=1e-9 * size)


def test_a_design_that_fails_fails_alone():
    joint = geometry("rcc")
    h, l, b = joint.sized({})
    lengths = np.array([l, l])
    travels = np.array([0.1, 40.0])  # six turns: no path leads there
    layout = joint.layout(ELASTIC, joint.dimensions(h + 0 * lengths, lengths, b + 0 * lengths))
    found = solve(layout, {MOVING: (None, None, travels)})
    assert found.outcome[0] is Outcome.CONVERGED
    assert found.outcome[1] is not Outcome.CONVERGED
    assert 0.0 <= found.reached[1] < 1.0
