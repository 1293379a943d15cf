import numpy as np
import pytest
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import spsolve

from flexcli.formulas.torsion_section import torsion_constant
from flexcli.formulas.torsion_shapes import (
    CIRCLE_CARDS,
    STAR_CARDS,
    STRIP_CARDS,
    circle_torsion_constant,
    star_arm,
    star_core_error,
    star_shear_factor,
    star_side_error,
    star_torsion_constant,
    strip_torsion_constant,
)
from flexcli.numerics.signomial import variables


def test_powers_are_close_to_the_exact_constant_for_every_ratio_of_sides():
    h = np.linspace(1e-3, 1.0, 1000)
    error = strip_torsion_constant(h, 1.0) / torsion_constant(h, 1.0) - 1.0
    assert np.abs(error).max() < 0.0021


def test_usual_last_term_is_within_half_a_percent():
    h = np.linspace(1e-3, 1.0, 1000)
    usual = h**3 * (1.0 / 3.0 - 0.21 * h * (1.0 - h**4 / 12.0))
    error = np.abs(usual / torsion_constant(h, 1.0) - 1.0).max()
    assert 0.004 < error < 0.005


def test_powers_take_signomials():
    h, b = variables("h", "b")
    at = {"h": 2e-4, "b": 5e-3}
    J = strip_torsion_constant(h, b).at(**at)
    assert pytest.approx(strip_torsion_constant(at["h"], at["b"]), rel=1e-12) == J


def star_by_elements(strips, arm, *, layers=8, cuts=2):
    """Return core and side stress of crossing strips of thickness 1, from half of one arm.

    −∇²ψ = 2 on the triangle of the core and the rectangle of the arm, quadrilaterals of nine nodes
    that crowd at the corner of two arms. Core: J − n b/3; side: the shear stress in the middle of
    an arm's side over that of a thin strip, by the waves across the arm there.
    """
    root, end = 0.5 / np.tan(np.pi / (2 * strips)), arm + 0.5 / np.tan(np.pi / (2 * strips))
    edges = np.append(1 - 0.5 ** np.arange(layers), 1.0)
    line = np.append(0, (edges[:-1] + np.diff(edges) * np.arange(1, cuts + 1)[:, None] / cuts).T)
    along = root + arm / 2 * np.append(1 - line[::-1], np.linspace(1, 2, 6 * cuts)[1:])
    core = np.array([[(s * root, s * t / 2) for t in line] for s in line])
    free = np.array([[(x, t / 2) for t in line] for x in along])
    quads = np.concatenate(
        [
            np.stack([g[:-1, :-1], g[1:, :-1], g[1:, 1:], g[:-1, 1:]], axis=2).reshape(-1, 4, 2)
            for g in (core, free)
        ]
    )
    nodes = np.array([(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1)])
    signs = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])

    def at(u, v):  # bilinear places
        return (1 + signs[:, 0] * u) * (1 + signs[:, 1] * v) / 4

    def line_shapes(u):
        return np.array([u * (u - 1) / 2, 1 - u * u, u * (u + 1) / 2])

    def line_slopes(u):
        return np.array([u - 0.5, -2 * u, u + 0.5])

    places = np.array([at(*each) for each in nodes]) @ quads
    keys = np.round(places.reshape(-1, 2) * 1e9)
    _, first, own = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    x, y = places.reshape(-1, 2)[first].T
    own = own.reshape(-1, 9)
    K, F = np.zeros((len(quads), 9, 9)), np.zeros((len(quads), 9))
    gauss = list(zip(*np.polynomial.legendre.leggauss(4), strict=True))
    for u, w_u in gauss:
        for v, w_v in gauss:
            slopes = signs * (1 + signs[:, ::-1] * [[v, u]]) / 4
            J = np.einsum("ka,mkd->mad", slopes, quads)
            area = np.linalg.det(J) * w_u * w_v
            one, other = line_shapes(u), line_shapes(v)
            d = np.array(
                [np.outer(line_slopes(u), other).ravel(), np.outer(one, line_slopes(v)).ravel()]
            )
            B = np.linalg.solve(J, np.broadcast_to(d, (len(quads), 2, 9)))
            K += area[:, None, None] * np.einsum("mdi,mdj->mij", B, B)
            F += 2 * area[:, None] * np.outer(one, other).ravel()
    rows, columns = np.repeat(own, 9, axis=1).ravel(), np.tile(own, 9).ravel()
    f = np.bincount(own.ravel(), F.ravel())
    inside = np.flatnonzero((x < end - 1e-9) & ((x < root - 1e-9) | (y < 0.5 - 1e-9)))
    psi = np.zeros(f.size)
    whole = csc_matrix((K.ravel(), (rows, columns)))
    psi[inside] = spsolve(whole[inside][:, inside], f[inside])
    middle = np.flatnonzero(np.abs(x - root - arm / 2) < 1e-9)
    middle = middle[np.argsort(y[middle])]
    at_y, over = y[middle], psi[middle] - (0.25 - y[middle] ** 2)
    sheared = 1.0
    for k in range(3):
        wave = (2 * k + 1) * np.pi
        share = over * np.cos(wave * at_y)
        step = (at_y[2::2] - at_y[:-2:2]) / 6
        sheared += 4 * wave * (-1) ** k * (step @ (share[:-2:2] + 4 * share[1:-1:2] + share[2::2]))
    return 4 * strips * float(f @ psi) - strips * 2 * end / 3, sheared


@pytest.mark.parametrize("arm", [1.0, 1.4, 2.2])
@pytest.mark.parametrize("strips", [2, 3, 4, 5, 6])
def test_the_core_of_crossing_strips_is_known_to_its_error(strips, arm):
    width = 2.0 * arm + 1.0 / np.tan(np.pi / (2.0 * strips))
    assert star_arm(1.0, width, strips) == pytest.approx(arm, rel=1e-12)
    core, sheared = star_by_elements(strips, arm)
    found = star_torsion_constant(1.0, width, strips) - strips * width / 3.0
    assert found == pytest.approx(core, abs=star_core_error(arm, strips))
    factor = star_shear_factor(1.0, width, strips)
    assert factor == pytest.approx(sheared, rel=star_side_error(arm, strips))


@pytest.mark.parametrize("strips", [8, 30])
def test_of_many_strips_the_core_changes_the_stress_by_no_more_than_told(strips):
    _, sheared = star_by_elements(strips, 1.0)
    assert 0.2 < sheared - 1.0 < star_side_error(1.0, strips)


def test_the_core_of_four_strips_is_that_of_finite_differences():
    """Edges at an angle are rough in a grid: first order in the step."""
    width = 6.0
    coarse, fine = (star_by_finite_differences(4, width, cells) for cells in (40, 80))
    # cells that an edge cuts count whole or not at all: of some 500 on the rim half a cell each
    assert star_torsion_constant(1.0, width, 4) == pytest.approx(2.0 * fine - coarse, abs=0.3)


def star_by_finite_differences(strips, width, cells):
    """Return J of strips of thickness 1 that cross; cells whose middle is inside count whole."""
    step = 1.0 / cells
    count = int(np.ceil((width / 2.0 + 1.0) / step)) + 1
    line = (np.arange(-count, count) + 0.5) * step
    x, y = np.meshgrid(line, line, indexing="ij")
    turns = np.pi * np.arange(strips) / strips
    inside = np.zeros_like(x, dtype=bool)
    for c, s in zip(np.cos(turns), np.sin(turns), strict=True):
        inside |= (abs(c * x + s * y) <= width / 2.0) & (abs(c * y - s * x) <= 0.5)
    number = np.full(x.shape, -1)
    number[inside] = np.arange(inside.sum())
    own, (i, j) = number[inside], np.nonzero(inside)
    rows, columns, values = [own], [own], [np.full(own.size, 4.0)]
    for di, dj in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        other = number[i + di, j + dj]
        near = other >= 0
        values[0] += ~near  # the edge is half a cell away
        rows.append(own[near])
        columns.append(other[near])
        values.append(np.full(near.sum(), -1.0))
    entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
    return 2.0 * step**2 * float(spsolve(csc_matrix(entries), np.full(own.size, 2 * step**2)).sum())


def test_circle_has_its_polar_second_moment():
    radius, weights = np.polynomial.legendre.leggauss(4)
    r = 0.5 * (radius + 1.0) / 2.0
    polar = np.sum(2.0 * np.pi * r**3 * weights / 4.0)
    assert circle_torsion_constant(1.0) == pytest.approx(polar, rel=1e-14)


@pytest.mark.parametrize(
    "card", [*CIRCLE_CARDS, *STAR_CARDS, *STRIP_CARDS], ids=lambda card: card.name
)
def test_array_call_equals_element_wise_calls(card):
    arrays = {
        name: value * np.array([1.0, 1.5, 2.5]) if isinstance(value, float) else value
        for name, value in card.example.items()
    }
    one_by_one = [
        card.function(
            **{n: float(v[k]) if isinstance(v, np.ndarray) else v for n, v in arrays.items()}
        )
        for k in range(3)
    ]
    np.testing.assert_allclose(card.function(**arrays), one_by_one, rtol=1e-14)


@pytest.mark.parametrize("strips", [2, 3, 4, 5, 6])
def test_the_error_of_a_core_is_a_small_share_of_it(strips):
    core = star_torsion_constant(1.0, 20.0, strips=strips) - strips * 20.0 / 3.0
    long = star_core_error(star_arm(1.0, 20.0, strips=strips), strips)
    assert 0.0 < long < 0.015 * abs(core)
