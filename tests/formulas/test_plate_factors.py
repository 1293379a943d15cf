"""Plate factors against Ritz solutions of clamped plates and solids that share no code."""

from functools import cache

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from plates import clamped_block, notched_block
from plates.clamped_strip import PURE, S_SHAPE, Strip
from pydantic import TypeAdapter

from flexcli.formulas import clamps, plate_buckling, plate_shortening
from flexcli.formulas import plate_factors as plates
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.profile import Constant
from flexcli.formulas.restrained_torsion import restrained_stiffness
from flexcli.formulas.torsion_section import torsion_constant
from flexcli.mechanics.wide_hinge import wide_hinge
from flexcli.parts.bending.base import SHORTEST
from flexcli.parts.bending.wide import NECKS_BUCKLED
from flexcli.parts.geometries import AnyGeometry

RITZ = 5e-5
"""What the Ritz solution of few functions is off by, against 1e-3 that is asked of the fits."""

SOLID = 1e-3
"""What the solid of few functions is off by."""

WIDTHS = (0.05, 0.2, 0.5, 1.0, 2.0, 10.0)
RATIOS = (0.2, 0.3, 0.45)

END_MOTIONS = {
    "clamped-clamped": [],
    "clamped-guided": [2],
    "clamped-pinned": [3],
    "pinned-pinned": [1, 3],
    "clamped-free": [2, 3],
}
"""Which of w, w' at the first and at the second end are free."""


@cache
def strip(b, nu, odd=False):
    return Strip(b, nu, odd=odd, bubbles=3)


def test_ritz_solution_converges():
    coarse, fine = Strip(0.5, 0.3, bubbles=3), Strip(0.5, 0.3, levels=3, bubbles=5)
    assert coarse.bending_factor() == pytest.approx(fine.bending_factor(), rel=RITZ)
    assert coarse.guided_factor() == pytest.approx(fine.guided_factor(), rel=RITZ)
    assert coarse.bending_factor() >= fine.bending_factor()  # an upper bound


def test_ritz_solution_has_the_frequencies_of_leissas_square_plate():
    """Leissa (1973), J. Sound Vib. 31, C-F-C-F, ν = 0.3: bounds from above, 1 % high at most."""
    even, odd = (strip(1.0, 0.3, odd=odd).frequencies(2) for odd in (False, True))
    found = sorted([*even, *odd])[:3]
    for own, published in zip(found, (22.272, 26.529, 43.664), strict=True):
        assert 0.99 * published < own <= published


@pytest.mark.slow
@pytest.mark.parametrize("nu", RATIOS)
@pytest.mark.parametrize("b", WIDTHS)
def test_bending_factors_are_those_of_the_plate(b, nu):
    plate, blade = strip(b, nu), {"b": b, "l": 1.0, "poisson_ratio": nu}
    within = plates.FIT_ERROR + RITZ
    pure, bent = plates.pure_bending_factor(**blade), plates.guided_factor(**blade)
    assert pure == pytest.approx(plate.bending_factor(), rel=within)
    assert bent == pytest.approx(plate.guided_factor(), rel=within)
    assert abs(pure - plate.bending_factor()) <= plates.factor_error(pure, pure) + RITZ
    assert abs(bent - plate.guided_factor()) <= plates.factor_error(bent, bent) + RITZ


def test_pivot_and_cantilever_are_mixtures_that_the_plate_itself_makes():
    """Energies of the plate for other end motions: a turn about a centre, a tip free to turn."""
    b, nu, delta = 0.5, 0.3, 0.4
    plate, blade = strip(b, nu), {"b": b, "l": 1.0, "poisson_ratio": nu}
    # w(0) = 0, w'(0) = 0, w(1) = v, w'(1) = θ

    def turned(v, theta):
        return Polynomial([0.0, 0.0, 3.0 * v - theta, theta - 2.0 * v])

    beam = 4.0 + 12.0 * delta + 12.0 * delta**2  # of EI θ²/l, v = (1 + δ) θ l
    ratio = plate.energy(turned(1.0 + delta, 1.0)) / (b * beam)
    assert plates.pivot_factor(delta=delta, **blade) == pytest.approx(ratio, rel=1e-3)
    energies = [plate.energy(turned(1.0, theta)) for theta in (0.0, 1.5, 3.0)]
    least = np.polynomial.Polynomial.fit((0.0, 1.5, 3.0), energies, 2)
    lowest = least(least.deriv().roots()[0])
    assert plates.cantilever_factor(**blade) == pytest.approx(lowest / (3.0 * b), rel=1e-3)


def test_factors_run_from_beam_to_plate():
    for factor in (plates.pure_bending_factor, plates.guided_factor):
        assert factor(b=1e-6, l=1.0, poisson_ratio=0.3) == pytest.approx(1.0, abs=1e-6)
        wide = factor(b=1e4, l=1.0, poisson_ratio=0.3)
        assert wide == pytest.approx(1.0 / (1.0 - 0.3**2), rel=1e-4)
        assert factor(b=1.0, l=1.0, poisson_ratio=0.0) == 1.0


@pytest.mark.parametrize("formula", ["pure", "s", *EFFECTIVE_LENGTH])
def test_factors_grow_with_width_and_poissons_ratio(formula):
    b = np.geomspace(1e-4, 1e4, 400)[:, None]
    nu = np.linspace(0.01, 0.5, 50)
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    if formula == "pure":
        k = plates.pure_bending_factor(**at)
    elif formula == "s":
        k = plates.guided_factor(**at)
    else:
        k = plate_buckling.buckling_factor(ends=formula, **at)
    assert (np.diff(k, axis=0) >= -1e-12).all()
    assert (np.diff(k, axis=1) >= -1e-12).all()
    assert (k >= 1.0).all()
    assert (k <= 1.0 + plates.bound(nu) + 1e-12).all()


@pytest.mark.slow
@pytest.mark.parametrize("ends", END_MOTIONS)
@pytest.mark.parametrize(("b", "nu"), [(0.2, 0.3), (0.5, 0.45), (1.0, 0.2), (2.0, 0.3)])
def test_buckling_factors_are_those_of_the_plate(ends, b, nu):
    euler = (np.pi / EFFECTIVE_LENGTH[ends]) ** 2
    true = Strip(b, nu, bubbles=3).critical(END_MOTIONS[ends]) / euler
    factor = plate_buckling.buckling_factor(b=b, l=1.0, ends=ends, poisson_ratio=nu)
    assert factor == pytest.approx(true, rel=plate_buckling.BUCKLING_ERROR[ends] + 5.0 * RITZ)


@pytest.mark.parametrize(("b", "nu"), [(0.1, 0.3), (0.5, 0.45), (2.0, 0.34)])
def test_under_any_axial_force_a_plate_bends_as_stiff_as_beams_of_two_factors(b, nu):
    """The ends turn alike or against each other, pulled by twice Euler's load or pushed."""
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    hinged = float(plate_buckling.buckling_factor(ends="pinned-pinned", **at))
    low = hinged - plate_buckling.BUCKLING_ERROR["pinned-pinned"]
    high = float(plates.pure_bending_factor(**{**at, "b": SHORTEST * b}))
    plate, beam = strip(b, nu), strip(b, 0.0)
    for force in np.pi**2 * np.linspace(-2.0, 3.8, 12):
        true = plate.stiffness(force)
        least, most = (k * beam.stiffness(force / k) for k in (low, high))
        for turns in ([0.0, 1.0, 0.0, 1.0], [0.0, 1.0, 0.0, -1.0]):
            assert turns @ (true - least) @ turns >= -RITZ * b
            assert turns @ (most - true) @ turns >= -RITZ * b


@pytest.mark.slow
@pytest.mark.parametrize("middle", [0.0, 1.0, 10.0])
@pytest.mark.parametrize(("b", "nu"), [(0.1, 0.3), (0.36, 0.45), (1.0, 0.34)])
def test_hinges_of_a_blade_that_buckles_bend_to_an_arc_or_to_an_s(b, nu, middle):
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    arc, bent = (float(k(**at)) for k in (plates.pure_bending_factor, plates.guided_factor))
    off = NECKS_BUCKLED * (arc - 1.0)
    free = {"clamped-clamped": [2, 3], "clamped-pinned": [2, 3, 5], "clamped-guided": [2, 3, 4],
            "pinned-pinned": [1, 2, 3, 5], "clamped-free": [2, 3, 4, 5]}  # fmt: skip
    for ends, moves in free.items():
        plate, beam = (strip(b, each).critical_of_two(middle, moves) for each in (nu, 0.0))
        most = bent if ends == "clamped-clamped" else arc + off
        assert arc - off - RITZ <= plate / beam <= most + RITZ


@pytest.mark.parametrize(("b", "within"), [(0.1, 0.002), (0.5, 0.004), (1.0, 0.007)])
def test_restrained_torsion_is_that_of_the_plate(b, within):
    nu, h = 0.3, 1e-5
    true = strip(b, nu, odd=True).twist_factor()
    thin = b * h**3 / 3.0 / float(torsion_constant(h, b))
    K = restrained_stiffness(E=2.0 * (1.0 + nu), G=1.0, h=h, b=b, l=1.0)
    assert K * thin / (b * h**3 / 3.0) == pytest.approx(true, rel=within)


@pytest.mark.parametrize(("b", "nu"), [(0.1, 0.3), (0.5, 0.45), (2.0, 0.2)])
def test_shortening_is_that_of_the_plate(b, nu):
    plate, blade = strip(b, nu), {"b": b, "l": 1.0, "poisson_ratio": nu}
    pure, bent = 24.0 * plate.shortening(PURE), plate.shortening(S_SHAPE) / 0.6
    assert plate_shortening.pure_shortening_factor(**blade) == pytest.approx(pure, abs=2e-3)
    assert plate_shortening.s_shortening_factor(**blade) == pytest.approx(bent, abs=6e-4)


@pytest.mark.parametrize(
    ("b", "nu"), [(0.05, 0.3), (0.2, 0.3), (0.5, 0.3), (1.0, 0.45), (2.0, 0.2)]
)
def test_clamp_stress_is_that_of_the_plate_in_mid_width(b, nu):
    plate = Strip(b, nu, bubbles=5)
    blade = {"b": b, "l": 1.0, "poisson_ratio": nu}
    for shape, formula in (
        (PURE, clamps.pure_bending_peak),
        (S_SHAPE, clamps.s_shape_peak),
    ):
        beam = shape.deriv(2)(1.0)
        true = plate.curvature(shape, 1.0, 0.0)[0] / beam / (1.0 - nu**2)
        assert formula(**blade) == pytest.approx(
            true, abs=0.009
        )  # 0.008 of the fit, the rest of the strip


def test_clamp_stress_is_a_sixth_to_a_quarter_above_the_beams_and_von_mises_a_tenth():
    b = np.linspace(0.01, 0.5, 50)
    for formula in (clamps.pure_bending_peak, clamps.s_shape_peak):
        peak = formula(b=b, l=1.0, poisson_ratio=0.3)
        assert ((peak > 1.15) & (peak < 1.26)).all()
        equivalent = clamps.at_clamp(peak=peak, poisson_ratio=0.3)
        assert ((equivalent > 1.02) & (equivalent < 1.12)).all()


@pytest.mark.parametrize(("b", "nu"), [(8.0, 0.3), (32.0, 0.3), (32.0, 0.45)])
def test_rigid_clamps_stiffen_a_wide_blade_beyond_the_plate_by_what_is_told(b, nu):
    """They keep it from thinning as well, and shear does not follow the bending of a plate."""
    blade, h = {"b": b, "h": 0.1, "nu": nu}, 0.1
    for solid, fit, ends in (
        (clamped_block.bending_factor, plates.pure_bending_factor, 2.0),
        (clamped_block.guided_factor, plates.guided_factor, 6.0),
    ):
        plate = float(fit(b=b, l=1.0, h=h, poisson_ratio=nu))
        less, more = plates.beyond_plate(h=h, l=1.0, poisson_ratio=nu, ends=ends)
        beyond = solid(**blade) / plate - 1.0
        assert -less - plates.FIT_ERROR - SOLID < beyond < more + plates.FIT_ERROR + SOLID
        # and it is no bound out of proportion
        assert more < 5e-3 + 4.0 * abs(beyond)
    assert beyond > plates.FIT_ERROR  # no plate tells that


def test_a_thin_or_narrow_blade_is_no_stiffer_than_its_plate():
    less, more = plates.beyond_plate(h=1e-3, l=1.0, poisson_ratio=0.3)
    assert less < 1e-6
    assert more < 1e-4
    _, narrow = plates.beyond_plate(h=0.1, l=1.0, poisson_ratio=0.3, flat=0.0, ends=2.0)
    assert narrow == 0.0


@pytest.mark.slow
def test_a_thick_blade_has_the_factor_of_a_narrower_plate():
    b, h, nu = 0.2, 0.02, 0.3
    at = {"b": b, "l": 1.0, "poisson_ratio": nu}
    k, thin = plates.pure_bending_factor(h=h, **at), plates.pure_bending_factor(**at)
    true = clamped_block.bending_factor(b=b, h=h, nu=nu)
    assert true < thin
    assert abs(k - true) <= plates.factor_error(k, thin)


@cache
def solid_notch(e, b, nu):
    return notched_block.stiffness(e=e, b=b, nu=nu)


@pytest.mark.parametrize(
    ("nu", "sharp", "wide"),
    [(0.45, 0.02, 6), (0.45, 0.1, 2), (0.45, 0.1, 20), (0.45, 0.5, 6), (0.3, 0.5, 20)],
)
def test_a_wide_notch_is_as_stiff_as_the_solid(nu, sharp, wide):
    """Over a notch too narrow to be kept flat, as the factor is over the beam."""
    hinge = TypeAdapter(AnyGeometry).validate_python(
        {"kind": "notch-hinge", "e": f"{sharp} mm", "r": "1 mm", "b": f"{wide * sharp} mm"}
    )
    found = hinge.wide_blades(hinge.sized({}), nu).stiffness
    true = solid_notch(sharp, wide * sharp, nu) / solid_notch(sharp, 0.2 * sharp, nu)
    assert found.low - SOLID <= true <= found.high + SOLID
    assert found.high - found.low <= 0.35 * plates.bound(nu)  # a range that tells something


@pytest.mark.parametrize("b", [0.2, 0.5, 1.0, 3.0, 20.0])
def test_a_hinge_of_constant_thickness_is_the_clamped_strip(b):
    found = wide_hinge(Constant, (1e-3,), 1.0, b, 0.3)
    assert found.stiffness == pytest.approx(strip(b, 0.3).bending_factor(), rel=2e-4)
    # the middle moves by θ² l (1 − f/3)/8, f what the blade shortens more than the beam
    shortening = plate_shortening.pure_shortening_factor(b=b, l=1.0, poisson_ratio=0.3)
    assert found.shift == pytest.approx(1.0 - (shortening - 1.0) / 2.0, abs=1.5e-3)
