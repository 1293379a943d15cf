"""Sums by panels against sums one by one: distant panels, smooth kernels, every level."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.panel_sums import NODES, Panels, node_shares, panel_sums

SMOOTH = 1e-12  # a panel of 0.4 kernel widths: interpolated to (5 + √26)^−16
DISTANT = 5e-11  # a pole three half-widths off: to 6e-13, times what many panels add


def by_panels(panels, places, strengths, targets, kernel, near):
    on, at = (np.floor((x - panels.begin) / panels.width).astype(int) for x in (places, targets))
    sources = np.zeros((panels.count, NODES))
    np.add.at(sources, on, strengths[:, None] * node_shares(panels.position(places, on)))
    field = panel_sums(panels, sources, kernel, near=near)
    found = np.sum(node_shares(panels.position(targets, at)) * field[at], axis=1)
    summed = near | (np.abs(on - at[:, None]) > 1)
    one_by_one = np.where(summed, kernel(places - targets[:, None]), 0.0) @ strengths
    return found, one_by_one


@given(
    roots=st.integers(1, 9),
    halvings=st.integers(0, 6),
    share=st.floats(1e-4, 0.4),
    seed=st.integers(0, 99),
)
def test_sums_over_distant_panels_are_those_one_by_one(roots, halvings, share, seed):
    generator = np.random.default_rng(seed)
    panels = Panels(-1.0, 2.0, roots, halvings)
    places, targets = generator.uniform(-1, 2, 60), generator.uniform(-1, 2, 40)
    width = share * panels.width
    found, wanted = by_panels(
        panels, places, generator.uniform(0, 1, 60), targets,
        lambda u: np.exp(0.5 * u) / (u * u + width**2), near=False,
    )  # fmt: skip
    assert found == pytest.approx(wanted, rel=DISTANT, abs=1e-300)


@given(roots=st.integers(1, 4), halvings=st.integers(0, 4), seed=st.integers(0, 99))
def test_a_kernel_wider_than_a_panel_is_summed_over_its_neighbours_too(roots, halvings, seed):
    generator = np.random.default_rng(seed)
    panels = Panels(3.0, 4.0, roots, halvings)
    places, targets = generator.uniform(3, 4, 50), generator.uniform(3, 4, 30)
    width = 2.5 * panels.width
    found, wanted = by_panels(
        panels, places, generator.uniform(0, 1, 50), targets,
        lambda u: 1 / (u * u + width**2), near=True,
    )  # fmt: skip
    assert found == pytest.approx(wanted, rel=SMOOTH)


def test_every_source_is_summed_once():
    panels = Panels(0.0, 1.0, 3, 4)
    middles = 0.5 * (panels.edges[1:] + panels.edges[:-1])
    found, _ = by_panels(panels, middles, np.ones(48), middles, np.ones_like, near=True)
    assert found == pytest.approx(48.0, rel=1e-13)
    found, _ = by_panels(panels, middles, np.ones(48), middles, np.ones_like, near=False)
    assert found == pytest.approx([46.0, *[45.0] * 46, 46.0], rel=1e-13)
