"""Restrained warping: the stress of beams against the moments of thin shells and elastic blocks."""

from dataclasses import replace

import numpy as np
import pytest
from layouts_in_space import strip

from flexcli.engine.joint_models.beam_peaks import section_peaks, unsure_of_peaks
from flexcli.engine.joint_models.space_errors import warping_errors
from flexcli.formulas.profile import NeckedDown
from flexcli.mechanics.shell.first_guess import shells_from_beams
from flexcli.mechanics.shell.stresses import shell_stresses
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.layout import Isotropic
from flexcli.mechanics.space.warping_error import warping_error

EDGE = 0.63
"""Share of h/b that shells lack of the edges of a section in torsion."""

COARSE = 0.012
"""What so few modes leave of the moment of warping."""


def twisted(b, h, nu, turn=0.0, shift=0.0, twist=3e-3):
    """Return beams and shells of a strip of 100 mm, bent across its thickness and twisted."""
    material = Isotropic(E=200e9, G=100e9 / (1.0 + nu), density=0.0)
    layout = strip(h=h, b=b, l=0.1, material=material)
    held = {"tip": (None, 0.1 * shift, 0.0, twist, 0.0, turn)}
    return (
        solve(layout, held, levels=(24,)),
        solve(layout, held, levels=(0, 16), made=shells_from_beams),
    )


def nominal_warping(shells, b, at_end):
    """Return the largest stress of a clamp's moment ∫σ y z dA, were it spread as y z [Pa]."""
    (found,) = shell_stresses(shells, corner=0.0)  # all but a thickness from the corners
    here = np.isclose(found.s, 0.1 if at_end else 0.0)
    z, bent = found.z[here] / (b / 2.0), (found.along[0] - found.along[1])[here] / 2.0
    odd = np.arange(1, 10, 2)
    spread, *_ = np.linalg.lstsq(z[:, None] ** odd, bent, rcond=None)
    return abs(3.0 * float(np.sum(spread / (odd + 2.0))))


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize(("b", "turn", "shift"), [
    (15e-3, 0.0, 0.0), (50e-3, 0.0, 0.0), (100e-3, 0.0, 0.0),
    (15e-3, 0.2, 0.0), (50e-3, 0.0, 0.1), (15e-3, 0.4, 0.2), (50e-3, 0.4, 0.2),
])  # fmt: skip
def test_the_moment_of_warping_is_that_of_shells_at_rest_and_bent(nu, b, turn, shift):
    h = 0.01 * b
    beams, shells = twisted(b, h, nu, turn, shift)
    (stress,), (error,) = blade_stresses(beams), warping_errors(beams)
    at_end = bool(turn or shift)  # the clamp that is warped the most
    found = nominal_warping(shells, b, at_end) * (1.0 - EDGE * h / b)
    assert error.low - COARSE <= found / stress.warping.max() - 1.0 <= error.high + COARSE
    assert error.high - error.low < 0.03 + 0.1 * at_end


def test_what_is_unsure_of_warping_is_of_the_corners_that_it_strains():
    beams, _ = twisted(20e-3, 0.4e-3, 0.3)
    stresses, (error,) = blade_stresses(beams), warping_errors(beams)
    unsure = unsure_of_peaks(stresses, [error])
    assert unsure.low == pytest.approx(error.low, abs=1e-3)  # it is all of the stress
    assert unsure.high == max(error.high, 0.0) == 0.0
    # warping that is larger is so with its sign, which bending has not
    bent, _ = twisted(20e-3, 0.4e-3, 0.3, turn=0.02)
    (stress,) = blade_stresses(bent)
    more = section_peaks(stress, 0.5) - section_peaks(stress)
    corners = np.abs(more[[0, -1], :4])
    assert corners == pytest.approx(0.5 * stress.warping[[0, -1], None] * np.ones(4), rel=0.05)
    assert np.all(more[:, 4:] == 0.0)


def test_thick_bars_have_less_and_what_nobody_compared_a_fifth():
    (square,) = strip(h=9e-3, b=10e-3).blades
    assert warping_error(square).low < -0.3
    assert warping_error(square).high < 0.01
    necked = replace(square, profile=NeckedDown(0.2e-3, 10e-3))
    assert warping_error(necked) == (-0.2, 0.2)
