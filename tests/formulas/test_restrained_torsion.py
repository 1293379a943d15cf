from itertools import combinations_with_replacement

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.polynomial import legendre
from scipy.linalg import solve

from flexcli.formulas.restrained_torsion import (
    CARDS,
    restrained_stiffness,
    restrained_stresses,
    restraint_error,
)
from flexcli.formulas.torsion_section import shear_factor, torsion_constant, warping
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.torsion_bar import TorsionBar

E, NU = 114e9, 0.34
G = E / (2 * (1 + NU))
h, b = 0.1e-3, 10e-3
PLATE_E = E / (1 - NU**2)
J, POLAR = float(torsion_constant(h, b)), b * h * (b**2 + h**2) / 12
WARPING, LARGEST = (float(part) for part in warping(h, b))
APART = 1 - J / POLAR


def twisted_plate(aspect, nu):
    """K l/(G J) of a Kirchhoff plate l × 1, both ends clamped, one turned about x by Ritz's method.

    w = y g(x) + Σ a_ij X_i(x) Y_j(y) with X_i clamped at both ends and Y_j odd polynomials.
    """
    l = aspect
    x, w_x = legendre.leggauss(40)
    y, w_y = legendre.leggauss(30)

    def derivatives(c, nodes, side):
        return [legendre.legval(nodes, legendre.legder(c, m)) * (2 / side) ** m for m in range(3)]

    clamped = legendre.legmul([2 / 3, 0, -2 / 3], [2 / 3, 0, -2 / 3])
    along = [derivatives(legendre.legmul(clamped, [0] * i + [1]), x, l) for i in range(1, 28, 2)]
    across = [derivatives([0] * j + [1], y, 1.0) for j in range(1, 21, 2)]
    turning = derivatives(legendre.poly2leg([0.5, 0.75, 0, -0.25]), x, l)
    shapes = [(turning, [0.5 * part for part in across[0]])]
    shapes += [(one, other) for one in along for other in across]
    root = np.sqrt(np.outer(w_x * l / 2, w_y / 2)).ravel()
    xx = np.array([np.outer(f[2], g[0]).ravel() * root for f, g in shapes])
    yy = np.array([np.outer(f[0], g[2]).ravel() * root for f, g in shapes])
    xy = np.array([np.outer(f[1], g[1]).ravel() * root for f, g in shapes])
    energy = xx @ xx.T + yy @ yy.T + nu * (xx @ yy.T + yy @ xx.T) + 2 * (1 - nu) * xy @ xy.T
    size = 1 / np.sqrt(np.diag(energy))
    energy = energy * np.outer(size, size)
    rest = np.linalg.lstsq(energy[1:, 1:], energy[1:, 0], rcond=1e-13)[0]
    bending = (energy[0, 0] - energy[0, 1:] @ rest) / size[0] ** 2  # K over D = E h³/(12 (1 − ν²))
    return bending / (12 * (1 - nu**2)) * l / (1 / (2 * (1 + nu)) / 3)


class Block:
    """An elastic block l × b × h (b = G = 1) between rigid bodies, one turned by 1 about x.

    Ritz's method with products of Legendre polynomials, those along x zero at both ends; of each
    parity the half that a twist has.
    """

    PARITY = ((0, 1, 1), (1, 0, 1), (1, 1, 0))

    def __init__(self, *, thick, long, nu, orders=(10, 8, 3)):
        self.sides = np.array([long, 1.0, thick]) / 2
        rules = [legendre.leggauss(2 * n + 6) for n in orders]
        self.x = [u * side for (u, _), side in zip(rules, self.sides, strict=True)]
        self.w = [w * side for (_, w), side in zip(rules, self.sides, strict=True)]
        self.orders, self.lame = orders, 2 * nu / (1 - 2 * nu)
        self.shapes = [[self.along(i, d, u) for d, (u, _) in enumerate(rules)] for i in range(3)]
        n = int(np.prod(orders))
        K = np.zeros((3 * n, 3 * n))
        for i, j in combinations_with_replacement(range(3), 2):  # symmetric: the upper triangle
            both = self.lame * self.product(i, i, j, j) + self.product(i, j, j, i)
            if i == j:
                both = both + sum(self.product(i, d, i, d) for d in range(3))
            K[i * n : (i + 1) * n, j * n : (j + 1) * n] = both
        # about a twist x/l without warping, whose strains are xy = −z/l and xz = y/l
        F = np.zeros(3 * n)
        for d, away, sign in ((1, 2, -1.0), (2, 1, 1.0)):
            power = [0, 0, 0]
            power[away] = 1
            F[:n] += sign / long * self.integral(0, d, power)
            F[d * n : (d + 1) * n] += sign / long * self.integral(d, 0, power)
        self.motion = solve(K, -F, assume_a="pos", overwrite_a=True, check_finite=False)
        self.stiffness = thick * (1 + thick**2) / 12 / long + F @ self.motion
        self.thick, self.long = thick, long

    def along(self, i, d, u):
        """Return the values and slopes of the polynomials of motion i along direction d."""
        rows = []
        for k in range(self.PARITY[i][d], 2 * self.orders[d] + self.PARITY[i][d], 2):
            c = np.zeros(k + 3)
            c[k], c[k + 2] = (-1.0, float(d == 0)) if d == 0 else (1.0, 0.0)
            rows.append(c * np.sqrt(k + 0.5))
        slopes = [legendre.legval(u, legendre.legder(c)) / self.sides[d] for c in rows]
        return np.array([legendre.legval(u, c) for c in rows]), np.array(slopes)

    def product(self, i, d, j, e):
        found = np.ones((1, 1))
        for axis in range(3):
            one, other = self.shapes[i][axis][axis == d], self.shapes[j][axis][axis == e]
            found = np.kron(found, (one * self.w[axis]) @ other.T)
        return found

    def integral(self, i, d, power):
        """Return ∫ u_i,d x^a y^b z^c of the shapes."""
        found = np.ones(1)
        for axis, (x, w) in enumerate(zip(self.x, self.w, strict=True)):
            found = np.kron(found, (self.shapes[i][axis][axis == d] * w) @ x ** power[axis])
        return found

    def at(self, i, place, d):
        """Return the slopes along d of the shapes of motion i at a place, from −1 to 1."""
        row = np.ones(1)
        for axis, u in enumerate(place):
            row = np.kron(row, self.along(i, axis, np.array([u]))[axis == d][:, 0])
        return row

    def of_motion(self, i, row):
        n = row.size
        return float(row @ self.motion[i * n : (i + 1) * n])

    @property
    def shear(self):
        """Return the shear stress in the middle of the broad side, at mid-length."""

        bent, warped_by = (
            self.of_motion(i, self.at(i, (0.0, 0.0, 1.0), d)) for i, d in ((1, 0), (0, 1))
        )
        return abs(bent + warped_by - self.thick / 2 / self.long)

    @property
    def narrow_shear(self):
        """Return the shear stress in the middle of the narrow side, at mid-length."""
        bent, warped_by = (
            self.of_motion(i, self.at(i, (0.0, 1.0, 0.0), d)) for i, d in ((2, 0), (0, 2))
        )
        return abs(bent + warped_by + 0.5 / self.long)

    def clamped_stress(self, y, z):
        """Return σ at an end, at places y and z of the section from −1 to 1."""
        along = self.along(0, 0, np.array([1.0]))[1][:, 0]
        across = (self.along(0, axis, u)[0] for axis, u in ((1, y), (2, z)))
        u_x = self.motion[: int(np.prod(self.orders))].reshape(self.orders)
        return (2.0 + self.lame) * np.einsum("ijk,i,jy,kz->yz", u_x, along, *across)

    @property
    def warping_moment(self):
        """Return ∫ σ y z dA at an end: the work of its stresses on u = y z (2x/l)²."""
        strains = {
            (0, 0): ((1, 1, 1), 2.0), (0, 1): ((2, 0, 1), 1.0), (0, 2): ((2, 1, 0), 1.0),
        }  # fmt: skip
        work = self.lame * sum(
            2.0 * self.of_motion(i, self.integral(i, i, (1, 1, 1))) for i in range(3)
        )
        for (i, d), (power, size) in strains.items():
            work += size * self.of_motion(i, self.integral(i, d, power))
            work += size * self.of_motion(d, self.integral(d, i, power))
        # what the twist without warping has of it
        x2 = self.long**3 / 12
        work += x2 * self.thick * (1 - self.thick**2) / 12 / self.long
        return abs(work) * 4 / self.long**2 / 2


@pytest.mark.slow
@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("thick", [0.02, 0.07, 0.12, 0.2, 0.35, 1.0])
def test_the_errors_of_a_bar_hold_against_an_elastic_block(thick, nu):
    nodes, weights = legendre.leggauss(60)
    for long in (0.25, 0.5, 3.0) if thick in (0.07, 0.2) else (0.3, 1.0):
        orders = (28 if long > 2 else 20, 10, 4)
        block = Block(thick=thick, long=long, nu=nu, orders=orders)
        at = {"h": thick, "b": 1.0, "l": long}
        error = restraint_error(nu=nu, **at)
        found = restrained_stresses(E=2 * (1 + nu), G=1.0, theta=1.0, **at)
        K = float(restrained_stiffness(E=2 * (1 + nu), G=1.0, **at))
        assert error.stiffness.low <= block.stiffness / K - 1 <= error.stiffness.high
        assert error.shear.low <= block.shear / float(found.shear) - 1 <= error.shear.high
        narrow = block.narrow_shear / float(found.narrow) - 1
        assert error.narrow.low <= narrow <= error.narrow.high
        # σ = E' ψ f', with ψ the section's warping: its moment about y z as of its largest value
        y, z = np.meshgrid(nodes / 2, nodes * thick / 2, indexing="ij")
        moment = np.sum(np.outer(weights, weights) * thick / 4 * warped(y, z, thick) * y * z)
        ours = moment * float(found.normal) / float(warping(thick, 1.0).largest)
        assert error.normal.low <= block.warping_moment / ours - 1
        if thick <= 0.5:
            assert block.warping_moment / ours - 1 <= error.normal.high


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("thick", [0.5, 0.7, 1.0])
def test_thick_bars_are_stressed_less_at_their_clamps_than_computed(thick, nu):
    # of a square y z is no measure of its warping ψ: the stress that has the work of ψ is
    block = Block(thick=thick, long=1.0, nu=nu, orders=(12, 10, 8))
    at = {"h": thick, "b": 1.0, "l": 1.0}
    nodes, weights = legendre.leggauss(60)
    y, z = np.meshgrid(nodes / 2, nodes * thick / 2, indexing="ij")
    psi, area = warped(y, z, thick), np.outer(weights, weights)
    stress = block.clamped_stress(nodes, nodes)
    true = abs(np.sum(area * stress * psi)) / np.sum(area * psi**2) * warping(thick, 1.0).largest
    computed = restrained_stresses(E=2 * (1 + nu), G=1.0, theta=1.0, **at).normal
    assert restraint_error(nu=nu, **at).normal.high < 0.003
    assert -0.3 < true / computed - 1.0 < -0.1


def test_the_stress_of_a_thick_bar_is_as_sure_as_its_shear_where_that_is_more():
    bar = TorsionBar(kind="torsion-bar", h="60 um", l="2 mm", b="65 um", warping="restrained")
    sizes, elastic = bar.sized({}), Elastic(1.0, 0.45)
    told = bar.end_stresses(elastic, sizes, 0.01)
    assert told["broad side"] > told["corners at the clamps"]
    assert bar.end_errors(sizes, 0.45).stress < 0.01


def test_the_stress_of_a_narrow_bar_is_told_with_an_error_to_either_side():
    thick, long, nu = 0.05, 1.0, 0.3
    block = Block(thick=thick, long=long, nu=nu, orders=(12, 10, 3))
    bar = TorsionBar(
        kind="torsion-bar", h="50 um", l="1 mm", b="1 mm", warping="restrained", shortening="held"
    )
    sizes, twist = bar.sized({}), 1e-6
    told = bar.end_stresses(Elastic(1.0, nu), sizes, twist)["corners at the clamps"]
    change = bar.bending(Elastic(1.0, nu), sizes, twist).rotation()["stress"]
    # the block is as wide and as stiff as 1: σ of its moment, at Saint-Venant's largest warping
    section = warping(thick, 1.0)
    y, z = np.meshgrid(*(legendre.leggauss(60)[0] / 2 * side for side in (1, thick)), indexing="ij")
    weights = np.outer(*(legendre.leggauss(60)[1] / 2 * side for side in (1, thick)))
    moment = float(np.sum(weights * warped(y, z, thick) * y * z)) / float(section.largest)
    true = block.warping_moment / moment / (2 * (1 + nu)) * twist
    assert change.value == pytest.approx(0.0, abs=1e-5)
    assert change.sign == 0
    assert true / told - 1.0 == pytest.approx(0.0, abs=change.error)
    assert change.error < 0.015


def warped(y, z, thick):
    """Return Saint-Venant's warping of a section 1 × thick."""
    psi = y * z
    for k in range(20):
        rate = (2 * k + 1) * np.pi / thick
        fading = np.exp(rate * (abs(y) - 0.5)) * (1.0 - np.exp(-2.0 * rate * abs(y)))
        wave = np.sin(rate * z) * np.sign(y) * fading / (1.0 + np.exp(-rate))
        psi = psi - 8.0 * thick**2 / np.pi**3 * (-1) ** k / (2 * k + 1) ** 3 * wave
    return psi


@pytest.mark.parametrize("nu", [0.0, 0.2, 0.3, 0.4, 0.45, 0.5])
@pytest.mark.parametrize("aspect", [0.25, 0.5, 1.0, 1.7, 2.0, 4.0])
def test_a_bar_tells_how_far_its_stiffness_may_be_from_that_of_a_clamped_plate(aspect, nu):
    bar = TorsionBar(kind="torsion-bar", h="1 um", l="1 mm", b="1 mm", warping="restrained")
    sizes = bar.sized({})._replace(h=1e-7, l=aspect * 1e-3, b=1e-3)
    K = float(bar.stiffness(Elastic(1.0, nu), sizes)) * 2 * (1 + nu)
    true = twisted_plate(aspect, nu) * 1e-7**3 * 1e-3 / 3 / (aspect * 1e-3)
    assert true / K - 1.0 == pytest.approx(0.0, abs=bar.end_errors(sizes, nu).stiffness)
    assert bar.end_errors(sizes, nu).stiffness < 0.005


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("aspect", [0.25, 0.5, 1.0, 2.0])
def test_the_moments_of_warping_of_a_clamped_plate_are_within_the_range_of_the_stress(aspect, nu):
    # at both ends they are what its torque does beyond Saint-Venant's, whose twist is that of its
    # ends: T l = G J θ + 2 M
    thin = 1e-6
    at = {"h": thin, "b": 1.0, "l": aspect}
    beyond = twisted_plate(aspect, nu) * thin**3 / 3 - float(torsion_constant(thin, 1.0))
    found = float(restrained_stresses(E=2 * (1 + nu), G=1.0, theta=1.0, **at).normal)
    section = warping(thin, 1.0)
    moment = found / float(section.largest) * float(section.constant)
    error = restraint_error(nu=nu, **at).normal
    assert error.low <= beyond / 2 / moment - 1 <= error.high
    assert error.high - error.low < 0.015


@pytest.mark.parametrize("nu", [-0.3, -0.7])
@pytest.mark.parametrize("aspect", [0.25, 1.0, 3.0])
def test_the_range_has_plates_that_widen_as_they_stretch(aspect, nu):
    at = {"h": 1e-6, "b": 1.0, "l": aspect}
    K = float(restrained_stiffness(E=2 * (1 + nu), G=1.0, **at))
    error = restraint_error(nu=nu, **at).stiffness
    assert error.low < twisted_plate(aspect, nu) * 1e-6**3 / 3 / aspect / K - 1 < error.high


@pytest.mark.parametrize(("thick", "long"), [(0.5, 0.35), (0.4, 0.3), (0.7, 0.6)])
def test_the_narrow_sides_of_a_short_thick_bar_bear_the_most(thick, long):
    nu, twist = 0.3, 1e-6
    block = Block(thick=thick, long=long, nu=nu, orders=(12, 10, 6))
    bar = TorsionBar(
        kind="torsion-bar", h=f"{thick} mm", l=f"{long} mm", b="1 mm", warping="restrained",
        shortening="held",
    )  # fmt: skip
    sizes, elastic = bar.sized({}), Elastic(1.0, nu)
    places = bar.end_stresses(elastic, sizes, twist)
    true = np.sqrt(3.0) * block.narrow_shear / (2 * (1 + nu)) * twist
    change = bar.bending(elastic, sizes, twist).rotation()["stress"]
    assert true > 1.15 * max(places["broad side"], places["corners at the clamps"])
    assert true / places["narrow side"] - 1.0 == pytest.approx(0.0, abs=change.error)


@pytest.mark.parametrize("nu", [0.0, 0.3])
@pytest.mark.parametrize(("aspect", "near"), [(0.5, 0.01), (1.0, 0.007), (3.0, 0.004)])
def test_stiffness_is_that_of_a_clamped_plate(aspect, near, nu):
    thin = 1e-4
    K = restrained_stiffness(E=2 * (1 + nu), G=1.0, h=thin, b=1.0, l=aspect)
    ours = float(K) * aspect / (thin**3 / 3)
    assert ours == pytest.approx(twisted_plate(aspect, nu), rel=near)


def test_long_strip_twists_as_if_it_could_warp():
    for l in (1.0, 10.0):
        K = restrained_stiffness(E=E, G=G, h=h, b=b, l=l)
        free = G * torsion_constant(h, b) / l
        lead = 2 * np.sqrt(APART * PLATE_E * WARPING / (G * J)) / l
        assert float(K / free) == pytest.approx(1 / (1 - lead), rel=1e-12)


def test_a_very_short_bar_keeps_its_sections_as_they_are():
    K = restrained_stiffness(E=E, G=G, h=h, b=b, l=1e-3 * h)
    assert float(K) == pytest.approx(G * POLAR / (1e-3 * h), rel=1e-6)


@given(exponent=st.floats(-1.0, 4.0))
def test_stiffness_is_more_than_both_its_parts(exponent):
    l = b * 10.0**exponent
    free, bending = G * J / l, 12 * PLATE_E * WARPING / APART**2 / l**3
    K = float(restrained_stiffness(E=E, G=G, h=h, b=b, l=l))
    # in a row with the polar stiffness, of which a strip has too much to matter
    in_a_row = (free + bending) / (1 + (free + bending) / (G * POLAR / l))
    assert (1 - 1e-3) * in_a_row <= K <= (1 + 1e-12) * (1.2 * free + bending)


def test_stiffness_is_smooth_where_the_forms_change():
    switch = 2 * np.sqrt(PLATE_E * WARPING / (APART * G * J))
    below, above = restrained_stiffness(
        E=E, G=G, h=h, b=b, l=switch * np.array([1 - 1e-9, 1 + 1e-9])
    )
    assert float(below / above) == pytest.approx(1.0, abs=1e-8)
    assert below > above


@pytest.mark.parametrize("l", [5e-3, 20e-3, 60e-3])
@pytest.mark.parametrize("width", [1.5 * h, b])
def test_stresses_are_those_of_the_differential_equations(l, width):
    """``G I_p φ' = T + G (I_p − J) f``, ``E' Γ f'' = G (I_p − J)(f − φ')``, f = 0 at the ends."""
    θ, n = 0.05, 1000
    l = l * width / b
    GJ, polar = G * float(torsion_constant(h, width)), width * h * (width**2 + h**2) / 12
    constant, largest = (float(part) for part in warping(h, width))
    apart, EΓ, step = G * polar - GJ, PLATE_E * constant, l / n
    hold = apart * (1 - apart / (G * polar))
    A = np.diag(np.full(n - 1, hold + 2 * EΓ / step**2))
    A -= np.diag(np.full(n - 2, EΓ / step**2), 1) + np.diag(np.full(n - 2, EΓ / step**2), -1)
    f = np.linalg.solve(A, np.full(n - 1, apart / (G * polar)))
    rate = (1 + apart * f) / (G * polar)
    unit = θ / (step * (rate.sum() + 1 / (G * polar)))
    found = restrained_stresses(E=E, G=G, h=h, b=width, l=l, theta=θ)
    k, middle = float(shear_factor(h, width)), n // 2 - 1
    shear = G * h * unit * ((k - 0.5) * f[middle] + 0.5 * rate[middle])
    bend = unit * (4 * f[0] - f[1]) / (2 * step)
    assert float(found.shear) == pytest.approx(shear, rel=1e-4)
    assert float(found.normal) == pytest.approx(PLATE_E * largest * bend, rel=2e-3)


@given(l=st.floats(1e-3, 1.0), θ=st.floats(1e-3, 0.2))
def test_torque_is_the_bimoment_and_the_twist_of_half_the_strip(l, θ):
    K = float(restrained_stiffness(E=E, G=G, h=h, b=b, l=l))
    σ = float(restrained_stresses(E=E, G=G, h=h, b=b, l=l, theta=θ).normal)
    bimoment = WARPING * σ / LARGEST
    # T = G J f − E'Γ f''/(1 − J/I_p), and ∫φ' = θ over the whole length
    warps = (θ - K * θ * l / (G * POLAR)) / APART
    assert K * θ * l / 2 == pytest.approx(G * J * warps / 2 + bimoment / APART, rel=1e-9)


def test_moduli_that_no_isotropic_material_has_are_refused():
    with pytest.raises(ValueError, match="no isotropic material"):
        restrained_stiffness(E=3.5 * G, G=G, h=h, b=b, l=0.1)


def test_array_call_equals_element_wise_calls():
    l, width = np.array([[1e-3], [50e-3]]), np.array([1e-3, 10e-3, 50e-3])
    at = restrained_stresses(E=E, G=G, h=h, b=width, l=l, theta=0.1)
    K = restrained_stiffness(E=E, G=G, h=h, b=width, l=l)
    for i, j in np.ndindex(2, 3):
        one = {"E": E, "G": G, "h": h, "b": width[j], "l": l[i, 0]}
        assert K[i, j] == restrained_stiffness(**one)
        assert at.normal[i, j] == restrained_stresses(**one, theta=0.1).normal
        assert at.shear[i, j] == restrained_stresses(**one, theta=0.1).shear


def test_table_of_the_card_falls_to_one():
    table = CARDS[0].tables["slenderness"]
    _, ratio = table.columns["K l/(G J)"]
    found = [ratio(value) for value in table.values]
    assert found == sorted(found, reverse=True)
    assert found[-1] == pytest.approx(1.0, abs=0.011)


def test_the_error_of_a_slender_bar_is_that_of_what_it_was_compared_with():
    error = restraint_error(nu=0.3, h=0.01, b=1.0, l=1e6)
    assert (*error.shear, *error.stiffness) == pytest.approx((-2e-3, 2e-3, 0.0, 0.0), abs=1e-6)


def test_the_shear_of_a_short_bar_is_known_to_a_twentieth():
    error = restraint_error(nu=0.3, h=0.01, b=1.0, l=0.35)
    assert error.shear.high == pytest.approx(0.05, abs=5e-3)
