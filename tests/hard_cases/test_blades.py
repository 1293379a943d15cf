"""Blades from films to blocks: closed forms and sizing keep their digits at any scale."""

from fractions import Fraction
from math import pi

import numpy as np
import pytest
from judging import size_as_printed
from strategies import BEND, crossed, design, rcc

from flexcli.formulas.buckling import euler_load
from flexcli.formulas.pivot import end_stresses, rotational_stiffness
from flexcli.formulas.section import second_moment
from flexcli.formulas.stage import end_stress, translational_stiffness

RATIOS = [1e-5, 1e-3, 0.03, 0.3]
"""h/l from a film to a block."""

FEW_ROUNDINGS = 1e-15
"""Some ten roundings of 1e-16."""
SIZED = 1e-13
"""A solve in logarithms, whose values of up to 50 round at 1e-14."""

E, L, B, P, THETA = 114e9, 17.5e-3, 10e-3, 2e-3, 0.0205


@pytest.mark.parametrize("ratio", RATIOS)
def test_stiffness_and_stress_keep_their_digits_from_film_to_block(ratio, kept):
    """Powers of h/l span fifteen decades: a formula that adds before it divides loses them."""
    h = ratio * L
    e, hh, l, b, p, theta = map(Fraction, (E, h, L, B, P, THETA))
    stiffness = 2 * 4 * e * b * hh**3 / 12 / l * (1 + 3 * p / l + 3 * (p / l) ** 2)
    found = rotational_stiffness(E=E, h=h, l=L, b=B, p=P)
    assert found == pytest.approx(float(stiffness), rel=FEW_ROUNDINGS)
    kept(found, float(stiffness))
    inner, outer = end_stresses(E=E, h=h, l=L, p=P, theta=THETA)
    assert inner == pytest.approx(float(e * hh * theta / l * (2 + 3 * p / l)), rel=FEW_ROUNDINGS)
    assert outer == pytest.approx(float(e * hh * theta / l * (1 + 3 * p / l)), rel=FEW_ROUNDINGS)


@pytest.mark.parametrize("ratio", RATIOS)
def test_stage_and_buckling_keep_their_digits_from_film_to_block(ratio):
    """Cubes of a micrometre are 1e-18: an absolute tolerance anywhere would call them zero."""
    h = ratio * L
    e, hh, l, b = map(Fraction, (E, h, L, B))
    assert translational_stiffness(E=E, h=h, l=L, b=B) == pytest.approx(
        float(2 * e * b * hh**3 / l**3), rel=FEW_ROUNDINGS
    )
    assert end_stress(E=E, h=h, l=L, x=h) == pytest.approx(
        float(3 * e * hh**2 / l**2), rel=FEW_ROUNDINGS
    )
    load = euler_load(E=E, I=second_moment(B, h), l=L, ends="clamped-clamped")
    assert load == pytest.approx(float(4 * e * b * hh**3 / 12 / l**2) * pi**2, rel=FEW_ROUNDINGS)


def slender(ratio, write):
    """Size a pivot of given l/h, lengths written by a function."""
    geometry = rcc(p=write(P), l={"free": [write(1e-3), write(0.1)]}, b=write(5e-3))
    bend = {"bend": {"stroke": {"rotation": "0.01 deg", "cycles": 1e7}}}
    result = size_as_printed(
        design(geometry, {"l/h": {"equals": 1 / ratio}, "fatigue": 1.0}, bend), "spec"
    )
    assert result.status.value == "pass"
    return np.array([result.values[name].value for name in "hlb"])


@pytest.mark.parametrize("ratio", RATIOS)
def test_micrometres_and_metres_give_the_same_digits(ratio, kept):
    """A wrong unit is wrong by 1e6; one converted twice is wrong in its last digits alone."""
    metres = slender(ratio, lambda x: f"{x!r} m")
    micrometres = slender(ratio, lambda x: f"{x * 1e6!r} um")
    assert micrometres == pytest.approx(metres, rel=SIZED)
    kept(micrometres, metres)
    assert metres[0] / metres[1] == pytest.approx(ratio, rel=SIZED)


@pytest.mark.parametrize("geometry", [rcc, crossed])
@pytest.mark.parametrize("scale", [1e-3, 1e3])
def test_a_design_a_thousand_times_smaller_has_the_same_shape(geometry, scale, kept):
    """Similar designs differ by a shift of logarithms alone: bounds or starts in SI would show."""

    def sized(scale):
        force = f"{640 * scale**2!r} N"
        cases = {
            "bend": BEND,
            "push": {"load": {"force": force}, "ends": "clamped-clamped"},
        }
        asked = {"fatigue": 2.5, "buckling": 2.5}
        spec = design(geometry(p=f"{2 * scale!r} mm"), asked, cases)
        result = size_as_printed(spec, "spec")
        assert result.status.value == "pass"
        return np.array([result.values[name].value for name in "hlb"])

    # where the volume is flat about its least, sizes are known to the root of its digits
    assert sized(scale) / scale == pytest.approx(sized(1.0), rel=1e-7)
    kept(sized(scale) / scale, sized(1.0))
