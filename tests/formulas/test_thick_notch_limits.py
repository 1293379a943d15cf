"""Thick notches in the limits of a thin throat: nothing but the beam is left."""

import pytest

from flexcli.formulas.notch import circular_stiffness
from flexcli.formulas.thick_notch import softening


@pytest.mark.parametrize("blocks", [1e-3, None])
@pytest.mark.parametrize("thin", [1e-3, 1e-4])
def test_a_thin_throat_shifts_as_its_beam(thin, blocks):
    found = softening(e=thin * 1e-3, depth=1e-3, l=2e-3, blocks=blocks)
    # what its bending spreads is some e/ρ of its length, with the radius ρ = 1 mm
    assert 1.0 - thin < found.shift_least < found.shift_most < 1.0 + thin


@pytest.mark.parametrize("thin", [1e-3, 1e-4])
def test_a_thin_circular_throat_is_softer_by_two_fifths_of_its_thickness_over_its_radius(thin):
    found = softening(e=thin * 1e-3, depth=1e-3, l=2e-3, blocks=1e-3)
    beam = 1.0 / circular_stiffness(E=1.0, e=thin * 1e-3, r=1e-3, b=1.0)
    assert found.more / beam == pytest.approx(0.4 * thin, rel=0.05)
