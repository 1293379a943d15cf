import numpy as np
import pytest
from scipy.sparse import csc_matrix
from scipy.sparse.linalg import spsolve

from flexcli.formulas.torsion_section import torsion_constant
from flexcli.formulas.torsion_shapes import (
    CIRCLE_CARDS,
    STAR_CARDS,
    STAR_ERROR,
    STRIP_CARDS,
    circle_torsion_constant,
    star_torsion_constant,
    strip_torsion_constant,
    warping_constant,
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


def plus_by_finite_differences(width, cells):
    """J of a plus of two strips of thickness 1: −∇²ψ = 2 on a quarter, zero on its edge."""
    step = 0.5 / cells
    far = round(width / 2.0 / step)
    i, j = np.meshgrid(range(far + 1), range(far + 1), indexing="ij")
    inside = ((i < cells) & (j < far)) | ((j < cells) & (i < far))
    number = np.where(inside, np.cumsum(inside).reshape(inside.shape) - 1, -1)
    i, j, own = i[inside], j[inside], number[inside]
    rows, columns, values = [own], [own], [np.full(own.size, 4.0)]
    for di, dj in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        other = number[np.abs(i + di), np.abs(j + dj)]
        near = other >= 0
        rows.append(own[near])
        columns.append(other[near])
        values.append(np.full(near.sum(), -1.0))
    entries = np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))
    psi = spsolve(csc_matrix(entries), np.full(own.size, 2.0 * step**2))
    weight = np.where(i == 0, 0.5, 1.0) * np.where(j == 0, 0.5, 1.0)
    return 8.0 * step**2 * float(weight @ psi)


def test_plus_section_is_that_of_thin_strips_with_its_core():
    width = 6.0
    coarse, fine = (plus_by_finite_differences(width, cells) for cells in (8, 16))
    # the re-entrant corner makes the error fall with step^(4/3)
    exact = fine + (fine - coarse) / (2.0 ** (4.0 / 3.0) - 1.0)
    assert star_torsion_constant(1.0, width, strips=2) == pytest.approx(exact, abs=STAR_ERROR[2])
    assert 2.0 * torsion_constant(1.0, width) / exact - 1.0 == pytest.approx(-0.5 / width, abs=0.01)


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


@pytest.mark.parametrize("strips", [3, 4, 5, 6])
def test_the_core_of_crossing_strips_is_known_to_its_error(strips):
    """Edges at an angle are rough in a grid: first order in the step."""
    width = 10.0
    coarse, fine = (star_by_finite_differences(strips, width, cells) for cells in (12, 24))
    found = star_torsion_constant(1.0, width, strips=strips)
    assert found == pytest.approx(2.0 * fine - coarse, abs=STAR_ERROR[strips])


def test_circle_has_its_polar_second_moment():
    radius, weights = np.polynomial.legendre.leggauss(4)
    r = 0.5 * (radius + 1.0) / 2.0
    polar = np.sum(2.0 * np.pi * r**3 * weights / 4.0)
    assert circle_torsion_constant(1.0) == pytest.approx(polar, rel=1e-14)


def test_warping_constant_is_the_square_of_y_z_over_the_section():
    nodes, weights = np.polynomial.legendre.leggauss(3)
    h, b = 0.3, 2.0
    integral = (weights @ (nodes * h / 2) ** 2 * h / 2) * (weights @ (nodes * b / 2) ** 2 * b / 2)
    assert warping_constant(h, b) == pytest.approx(integral, rel=1e-13)


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
