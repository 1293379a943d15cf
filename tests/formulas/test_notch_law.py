"""The lecture's scaling law of the notch hinge, and the domain that it claims for 2.6 %."""

import numpy as np
import pytest

from flexcli.formulas.notch import LAW_CARDS, circular_stiffness, law_stiffness
from flexcli.numerics.signomial import variables

PRINTED = 0.07  # lecture: K ≈ 0.07 E b e^2.5 r^−0.5
CLAIM = 0.026  # lecture: error smaller than 2.6 % over the validity domain
SHARE = PRINTED / (2 / (9 * np.pi))


def error(ratio, share=1.0):
    hinge = {"E": 1.0, "b": 1.0, "e": ratio, "r": 1.0}
    return share * law_stiffness(**hinge) / circular_stiffness(**hinge) - 1


def test_the_printed_coefficient_is_the_exact_one_rounded():
    K = law_stiffness(E=1.0, b=1.0, e=1.0, r=1.0)
    assert round(K, 2) == PRINTED
    assert pytest.approx(2 / (9 * np.pi), rel=1e-15) == K


def test_the_law_is_the_limit_of_a_thin_throat():
    # error −e/(8r) + O((e/r)²)
    for ratio in (1e-3, 1e-4, 1e-5):
        assert error(ratio) == pytest.approx(-ratio / 8, rel=2 * ratio + 1e-10)


def test_the_lectures_scalings_hold():
    hinge = {"E": 210e9, "b": 10e-3, "e": 50e-6, "r": 3e-3}  # lecture, standard hinge
    K = law_stiffness(**hinge)
    for name, power in {"E": 1, "b": 1, "e": 2.5, "r": -0.5}.items():
        scaled = law_stiffness(**(hinge | {name: 2 * hinge[name]}))
        assert scaled / K == pytest.approx(2**power, rel=1e-14)


def test_the_standard_hinge_is_within_the_claim():
    # e = 50 µm, r = 3 mm
    assert abs(error(50e-6 / 3e-3, SHARE)) < CLAIM


def test_the_claimed_error_is_exceeded_over_the_claimed_domain():
    # 1 µm < e < 1 mm, 0.1 mm < r < 1 m: worst at the corner of the thickest, sharpest notch
    e, r = np.meshgrid(np.geomspace(1e-6, 1e-3, 61), np.geomspace(1e-4, 1.0, 81))
    missed = error(e / r, SHARE)
    assert np.abs(missed).max() == pytest.approx(-error(10.0, SHARE), rel=1e-12)
    assert error(10.0, SHARE) == pytest.approx(-0.527, abs=5e-4)
    assert error(10.0) == pytest.approx(-0.522, abs=5e-4)


def test_the_claimed_error_holds_where_the_radius_is_five_throats():
    # 2.6 % is the error of 2/(9π) at r = 5e; with 0.07 it is reached at r = 8.1e
    ratios = np.geomspace(1e-7, 0.2, 400)
    assert np.abs(error(ratios)).max() == pytest.approx(CLAIM, abs=5e-4)
    assert np.abs(error(ratios)).max() < CLAIM < abs(error(0.21))
    assert abs(error(0.1234, SHARE)) < CLAIM < abs(error(0.1236, SHARE))


def test_the_error_falls_steadily_so_that_its_range_is_one_interval():
    assert (np.diff(error(np.geomspace(1e-4, 10.0, 500))) < 0).all()


def test_the_chart_gives_the_errors():
    (card,) = LAW_CARDS
    for name, share in (("error of 2/(9π)", 1.0), ("error of 0.07", SHARE)):
        _, column = card.tables["e/r"].columns[name]
        assert column(0.1) == pytest.approx(error(0.1, share), rel=1e-12)


def test_the_law_is_a_monomial_of_the_dimensions():
    e, r, b = variables("e", "r", "b")
    K = law_stiffness(E=210e9, b=b, e=e, r=r)
    assert K.is_monomial
    at = {"e": 1e-4, "r": 4e-3, "b": 1e-2}
    assert K.at(**at) == pytest.approx(law_stiffness(E=210e9, **at), rel=1e-12)
