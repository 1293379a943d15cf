"""A blade with mass and a body beyond its end: textbook roots, a fine mesh, light blades."""

from math import pi
from pathlib import Path

import numpy as np
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import eigh
from scipy.optimize import brentq
from stages import at_the_tip

from flexcli.formulas.handbook.tip_mass import massless_frequencies, tip_mass_frequencies
from flexcli.formulas.section import second_moment
from flexcli.units import parse_quantity

SPECIMENS = Path(__file__).parents[2] / "examples" / "boundary-control" / "table-7-3.yaml"

UNIT = {"E": 1.0, "I": 1.0, "L": 1.0, "mass_per_length": 1.0}
offsets = st.floats(-0.5, 2.0)


def meshed(m, c, J, modes, elements=40):
    """Give frequencies of unit beam elements with consistent mass: error (x/elements)⁴."""
    size = 2 * elements + 2
    K, M = np.zeros((size, size)), np.zeros((size, size))
    l = 1.0 / elements
    stiffness = np.array(
        [
            [12, 6 * l, -12, 6 * l],
            [6 * l, 4 * l**2, -6 * l, 2 * l**2],
            [-12, -6 * l, 12, -6 * l],
            [6 * l, 2 * l**2, -6 * l, 4 * l**2],
        ]
    )
    inertia = np.array(
        [
            [156, 22 * l, 54, -13 * l],
            [22 * l, 4 * l**2, 13 * l, -3 * l**2],
            [54, 13 * l, 156, -22 * l],
            [-13 * l, -3 * l**2, -22 * l, 4 * l**2],
        ]
    )
    for i in range(0, 2 * elements, 2):
        K[i : i + 4, i : i + 4] += stiffness / l**3
        M[i : i + 4, i : i + 4] += inertia * l / 420
    M[-2:, -2:] += [[m, m * c], [m * c, J + m * c**2]]
    squared = eigh(K[2:, 2:], M[2:, 2:], eigvals_only=True, subset_by_index=(0, modes - 1))
    return np.sqrt(squared) / (2 * pi)


def test_bare_blade_has_the_roots_of_the_textbook():
    found = np.sqrt(2 * pi * tip_mass_frequencies(m=0.0, modes=6, **UNIT))
    exact = [
        brentq(lambda x: np.cos(x) + 1 / np.cosh(x), (n - 1) * pi, n * pi, xtol=1e-15)
        for n in range(1, 7)
    ]
    assert found == pytest.approx(exact, rel=1e-13)


@pytest.mark.parametrize("mu", [0.1, 1.0, 10.0, 1e3])
def test_mass_at_the_end_solves_its_transcendental_equation(mu):
    # 1 + cos x cosh x + μ x (cos x sinh x − sin x cosh x) = 0
    def equation(x):
        hyperbolic = np.cos(x) * np.sinh(x) - np.sin(x) * np.cosh(x)
        return 1 + np.cos(x) * np.cosh(x) + mu * x * hyperbolic

    found = np.sqrt(2 * pi * tip_mass_frequencies(m=mu, modes=3, **UNIT))
    brackets = [(1e-3, 1.9), (3.0, 4.7), (6.5, 7.9)]
    exact = [brentq(equation, *bracket, xtol=1e-15, rtol=1e-14) for bracket in brackets]
    assert found == pytest.approx(exact, rel=1e-11)


@settings(max_examples=25, deadline=None)
@given(st.floats(0.0, 20.0), offsets, st.floats(0.0, 5.0))
def test_frequencies_are_those_of_a_fine_mesh(m, c, J):
    found = tip_mass_frequencies(m=m, c=c, J=J, modes=4, **UNIT)
    # a body that is heavy and far out leaves the mesh rounding of 2e-5 in its lowest frequency
    assert found == pytest.approx(meshed(m, c, J, 4), rel=1e-4)
    assert (np.diff(found) > 0.0).all()


@pytest.mark.parametrize("lightness", [1e4, 1e8, 1e14])
def test_light_blade_tends_to_the_massless_one(lightness):
    blade = {"E": 1.0, "I": 1.0, "L": 1.0}
    body = {"m": 1.0, "c": 0.5, "J": 0.1}
    found = tip_mass_frequencies(mass_per_length=1.0 / lightness, modes=2, **blade, **body)
    limit = massless_frequencies(**blade, **body)
    assert found == pytest.approx(limit, rel=1.0 / lightness + 1e-13)
    assert (found <= np.array(limit) * (1 + 1e-13)).all()


def test_blade_of_a_heavy_mass_adds_its_33_140ths():
    found = tip_mass_frequencies(m=1e3, **UNIT)[0]
    assert 3.0 / (2 * pi * found) ** 2 - 1e3 == pytest.approx(33 / 140, abs=1e-4)


def test_series_and_closed_form_agree_where_they_meet():
    # the first root of a body that puts x just below and just above 1
    m = 3.0 - 33 / 140
    around = tip_mass_frequencies(m=m + np.linspace(-0.3, 0.3, 61), **UNIT)[:, 0]
    x = np.sqrt(2 * pi * around)
    assert x[0] > 1.0 > x[-1]
    assert np.abs(np.diff(x, n=4)).max() < 1e-9


def test_micrometres_and_metres_give_the_same_digits():
    # lengths × s, E I × s⁴ and masses unchanged leave E I/(m L³) × s
    here = tip_mass_frequencies(m=0.5, c=0.3, J=0.2, modes=3, **UNIT)
    s = 1e-6
    there = tip_mass_frequencies(
        E=1.0, I=s**4, L=s, mass_per_length=1.0 / s, m=0.5, c=0.3 * s, J=0.2 * s**2, modes=3
    )
    assert there / s**0.5 == pytest.approx(here, rel=1e-12)


def test_arrays_equal_elements():
    m = np.array([[0.0], [1.0]])
    c = np.array([0.0, 0.5, 1.0])
    together = tip_mass_frequencies(m=m, c=c, J=0.1, modes=2, **UNIT)
    assert together.shape == (2, 3, 2)
    single = [[tip_mass_frequencies(m=a, c=b, J=0.1, modes=2, **UNIT) for b in c] for a in m[:, 0]]
    assert together == pytest.approx(np.array(single), rel=1e-14)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"m": -1.0}, "not be negative"),
        ({"J": -1.0}, "not be negative"),
        ({"c": np.inf}, "c finite"),
        ({"modes": 0}, "at least 1"),
        ({"L": 0.0}, "L must be"),
    ],
)
def test_what_has_no_frequency_is_refused(change, said):
    with pytest.raises(ValueError, match=said):
        tip_mass_frequencies(**{**UNIT, "m": 1.0, **change})


@pytest.mark.parametrize("sample", range(4))
def test_one_offset_and_inertia_explain_the_measured_frequencies(sample):
    # Monti (2014), table 7.3; the three numbers are fitted on samples 1 and 4 without and with
    # the heaviest insert (tests/benchmarks/tip_mass_frequencies.py) and predict the rest
    data = yaml.safe_load(SPECIMENS.read_text())
    row = data["samples"][sample]
    h, b, L = (parse_quantity(row[name], "length") for name in ("h", "b", "L"))
    inserts = np.array([parse_quantity(text, "mass") for text in data["inserts"]])
    bare = (parse_quantity(data["tip_mass"], "mass"), 10.64e-3, 2.221e-6)
    body = at_the_tip(bare, (inserts, 15.51e-3, 0.0))
    blade = {"E": parse_quantity(data["youngs_modulus"], "stress"), "I": second_moment(b, h)}
    blade |= {"L": L, "mass_per_length": 2700.0 * b * h}
    measured = np.array([parse_quantity(text, "frequency") for text in row["frequencies"]])
    assert tip_mass_frequencies(**blade, **body)[:, 0] == pytest.approx(measured, rel=0.021)
    point = tip_mass_frequencies(m=body["m"], **blade)[:, 0]
    assert (point / measured > 1.6).all()
