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


def star_by_harmonic_functions(strips, arm, order):
    """Return core and side stress of crossing strips of thickness 1, from half of one arm.

    −∇²ψ = 2 on the triangle of the core and the rectangle of the arm: the thin strip's ¼ − y²
    and harmonic functions, those of the corner that two arms make among them, fitted to what the
    edges and the lines of symmetry ask. Core: J − n b/3; side: the shear stress in the middle of
    an arm's side over that of a thin strip.
    """
    half = np.pi / (2.0 * strips)
    root = 0.5 / np.tan(half)
    end, corner = root + arm, root + 0.5j
    powers = (np.arange(order) + 0.5) * np.pi / (np.pi - half)
    rates = (2.0 * np.arange(order) + 1.0) * np.pi

    def basis(z):
        """Return the functions and their slopes along x and y, each (points, functions)."""
        w = np.conj(z - corner)
        turn = np.where(np.angle(w) < -1e-9, np.angle(w) + 2.0 * np.pi, np.angle(w))
        found = []
        for p in powers:
            slope = p * np.abs(w) ** (p - 1.0) * np.exp(1j * (p - 1.0) * turn)
            found.append((np.abs(w) ** p * np.sin(p * turn), slope.imag, -slope.real))
        for k in rates:
            for at, sign in ((np.exp(-k * z.real), -1.0), (np.exp(k * (z.real - end)), 1.0)):
                wave = np.cos(k * z.imag)
                found.append((wave * at, sign * k * wave * at, -k * np.sin(k * z.imag) * at))
        for j in range(order - 4):
            slope = j * (z / end) ** max(j - 1, 0) / end
            found.append((((z / end) ** j).real, slope.real, -slope.imag))
        return np.moveaxis(np.array(found), 0, -1)

    t = 0.5 * (1.0 - np.cos(np.pi * (np.arange(240) + 0.5) / 240))
    axis, side, edge, middle = t * end + 0j, root + t * arm + 0.5j, end + 0.5j * t, t * corner
    _, dx, dy = basis(middle)
    rows = np.vstack(
        [basis(axis)[2], basis(side)[0], basis(edge)[0], np.cos(half) * dy - np.sin(half) * dx]
    )
    asked = np.concatenate(
        [0.0 * t, 0.0 * t, edge.imag**2 - 0.25, 2.0 * np.cos(half) * middle.imag]
    )
    size = np.linalg.norm(rows, axis=0)
    shares = np.linalg.lstsq(rows / size, asked, rcond=1e-13)[0] / size
    x, w = np.polynomial.legendre.leggauss(60)
    x, w = (x + 1.0) / 2.0, w / 2.0
    X, Y = (part.ravel() for part in np.meshgrid(x, x, indexing="ij"))
    weight = np.outer(w, w).ravel()
    volume = 0.0
    for z, area in (
        (root + arm * X + 0.5j * Y, 0.5 * arm * weight),
        (X * (root + 0.5j * Y), 0.5 * root * X * weight),
    ):
        volume += area @ (0.25 - z.imag**2 + basis(z)[0] @ shares)
    sheared = 1.0 - basis(np.array([root + arm / 2.0 + 0.5j]))[2] @ shares
    return 8.0 * strips * volume - strips * 2.0 * end / 3.0, float(sheared[0])


@pytest.mark.parametrize("arm", [1.0, 1.5, 2.2])
@pytest.mark.parametrize("strips", [2, 3, 4, 5, 6])
def test_the_core_of_crossing_strips_is_known_to_its_error(strips, arm):
    width = 2.0 * arm + 1.0 / np.tan(np.pi / (2.0 * strips))
    assert star_arm(1.0, width, strips) == pytest.approx(arm, rel=1e-12)
    core, sheared = star_by_harmonic_functions(strips, arm, 18)
    found = star_torsion_constant(1.0, width, strips) - strips * width / 3.0
    assert found == pytest.approx(core, abs=star_core_error(arm, strips))
    if strips <= 3:  # what the joint says of its stress
        assert sheared == pytest.approx(1.0, abs=0.5 * np.exp(-np.pi * arm / 2.0))


def test_the_core_of_four_strips_is_that_of_finite_differences():
    """Edges at an angle are rough in a grid: first order in the step."""
    width = 6.0
    coarse, fine = (star_by_finite_differences(4, width, cells) for cells in (20, 40))
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
