"""Stiffness of a stopped cantilever: printed numbers, and a beam of two exact elements."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.section import second_moment
from flexcli.formulas.stop_stiffness import (
    bent_shape,
    contact_stiffness,
    free_stiffness,
    height_share,
    stiffness_ratio,
)
from flexcli.units import parse_quantity

SPECIMENS = Path(__file__).parents[2] / "examples" / "boundary-control" / "table-7-3.yaml"
shares = st.floats(1e-3, 0.999)
lengths = st.floats(1e-4, 1.0)


def stiffness_at(nodes, rigidity):
    """Assemble a clamped beam of exact cubic elements: (w, θ) at each node but the clamped one."""
    size = 2 * len(nodes)
    K = np.zeros((size + 2, size + 2))
    heights = [0.0, *nodes]
    for i, (low, high) in enumerate(pairwise(heights)):
        l = high - low
        rows = [[12, 6 * l, -12, 6 * l], [6 * l, 4 * l**2, -6 * l, 2 * l**2]]
        rows += [[-12, -6 * l, 12, -6 * l], [6 * l, 2 * l**2, -6 * l, 4 * l**2]]
        K[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += rigidity / l**3 * np.array(rows)
    return K[2:, 2:]


# -- printed numbers ---------------------------------------------------------------------------


@pytest.mark.parametrize("sample", range(4))
def test_free_stiffness_of_the_four_specimens_is_the_printed_one(sample):
    # Monti (2014), table 7.1: 22.9, 12.1, 7.5 and 4.6 N/mm
    data = yaml.safe_load(SPECIMENS.read_text())
    row = data["samples"][sample]
    h, b, L = (parse_quantity(row[name], "length") for name in ("h", "b", "L"))
    E = parse_quantity(data["youngs_modulus"], "stress")
    printed = parse_quantity(row["k_free"], "stiffness")
    found = free_stiffness(E=E, I=second_moment(b, h), L=L)
    assert found == pytest.approx(printed, abs=50.0)


def test_screen_of_the_test_bench_shows_our_stiffness():
    # section 7.2: R = 69037.1 N·mm², k_free = 4.62933 N/mm of sample 4
    I = second_moment(9.856e-3, 1.068e-3)
    rigidity = 69e9 * I * 1e6
    assert rigidity == pytest.approx(69037.1, abs=0.05)
    assert free_stiffness(E=69e9, I=I, L=35.5e-3) / 1e3 == pytest.approx(4.62933, abs=5e-6)


# -- independent routes and limits -------------------------------------------------------------


@given(shares)
def test_contact_stiffness_is_that_of_a_beam_with_its_node_held(a):
    K = stiffness_at([a, 1.0], 1.0)
    free = [1, 2, 3]  # the deflection at the stop is held
    compliance = np.linalg.inv(K[np.ix_(free, free)])[1, 1]
    assert contact_stiffness(E=1.0, I=1.0, L_a=a, L_b=1.0 - a) * compliance == pytest.approx(
        1.0, rel=1e-9
    )


@given(shares)
def test_shape_is_that_of_a_tip_loaded_beam(a):
    K = stiffness_at([a, 1.0], 1.0)
    w = np.linalg.solve(K, [0.0, 0.0, 1.0, 0.0])
    assert bent_shape(a) == pytest.approx(w[0] / w[2], rel=1e-9)


@given(lengths, lengths)
def test_denominator_is_the_one_the_source_writes(L_a, L_b):
    L = L_a + L_b
    source = 4 * L**3 - 3 * L * L_a * (2 * L_a + 3 * L_b) + L_a**2 * (2 * L_a + 3 * L_b)
    ours = 12.0 / contact_stiffness(E=1.0, I=1.0, L_a=L_a, L_b=L_b)
    assert ours == pytest.approx(source, abs=1e-13 * L**3)


@given(lengths, lengths)
def test_ratio_is_contact_over_free(L_a, L_b):
    beam = {"E": 7.0, "I": 3.0}
    contact = contact_stiffness(L_a=L_a, L_b=L_b, **beam)
    ratio = contact / free_stiffness(L=L_a + L_b, **beam)
    assert stiffness_ratio(L_a=L_a, L_b=L_b) == pytest.approx(ratio, rel=1e-12)
    assert ratio >= 1.0


@given(st.floats(1e-6, 1.0 - 1e-6))
def test_height_share_inverts_the_ratio(a):
    ratio = stiffness_ratio(L_a=a, L_b=1.0 - a)
    # near the clamped end the ratio is flat and keeps few digits of a
    assert height_share(ratio) == pytest.approx(a, abs=1e-14)


def test_heights_of_an_array_are_those_of_its_elements():
    ratios = np.array([[1.0, 1.5], [30.0, 1e9]])
    together = height_share(ratios)
    assert together.shape == (2, 2)
    assert together == pytest.approx(np.vectorize(height_share)(ratios), rel=1e-15)
    assert together[0, 0] == pytest.approx(0.0, abs=1e-15)


def test_a_stop_that_softens_is_refused():
    with pytest.raises(ValueError, match="only stiffens"):
        height_share(0.99)
