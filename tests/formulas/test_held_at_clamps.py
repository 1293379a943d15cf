"""What rigid clamps hold of a blade's growth, against solids, sheets and the tensor itself."""

from math import sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.held_at_clamps import (
    HELD_MIDDLE_ERROR,
    held_face,
    held_middle,
    held_together,
)


@pytest.mark.parametrize(
    ("b", "l", "nu", "printed"),
    [
        (1, 5, 0.0, 1.586),
        (4, 20, 0.0, 1.588),
        (3, 10, 0.2, 1.629),
        (4, 20, 0.3, 1.698),
        (10, 20, 0.3, 1.704),
        (10, 10, 0.3, 1.690),
        (1, 1, 0.3, 1.652),
        (10, 20, 0.45, 1.894),
        (2, 20, 0.48, 1.950),
    ],
)
def test_amid_a_clamp_it_is_that_of_solids_as_wide_as_long_at_most(b, l, nu, printed):
    """CalculiX 2.20, an eighth of a blade in 1536 C3D20R, thickness 1, graded to the edges."""
    assert b <= l
    assert float(held_middle(poisson_ratio=nu)) == pytest.approx(printed, rel=HELD_MIDDLE_ERROR)


def test_without_contraction_width_and_thickness_are_two_strips_that_add_up():
    # what either holds along the blade is the same share of its own strain
    strip = float(held_face(poisson_ratio=0.0).along)
    assert float(held_middle(poisson_ratio=0.0)) == pytest.approx(1.0 + 2.0 * strip, rel=3e-3)


def test_what_keeps_its_volume_is_drawn_out_along_by_what_both_sides_lose():
    # strains −ε, −ε and 2 ε: the stresses differ by 2 G · 3 ε, and G = E/3
    assert float(held_middle(poisson_ratio=0.5)) == pytest.approx(2.0, rel=1e-12)


@pytest.mark.parametrize(
    ("nu", "across", "along"), [(0.0, 1.000, 0.293), (0.3, 0.934, 0.221), (0.45, 0.913, 0.193)]
)
def test_at_a_face_it_is_that_of_a_sheet_whose_clamp_holds_its_width(nu, across, along):
    """CalculiX 2.20, a quarter of a sheet of b = l/2 in 1600 C3D20R that may thicken."""
    face = held_face(poisson_ratio=nu)
    assert float(face.across) == pytest.approx(across, abs=2e-3)
    assert float(face.along) == pytest.approx(along, abs=2e-3)


@given(
    st.floats(0.0, 5.0), st.floats(0.0, 2.0), st.floats(0.0, 1.0), st.floats(0.0, 0.5),
    st.sampled_from((-1.0, 1.0)),
)  # fmt: skip
def test_what_is_along_and_what_is_held_are_no_more_together_than_is_told(a, Z, X, kappa, sign):
    """Bending whose clamp keeps it from narrowing by any share κ, of von Mises' stress a."""
    bent = sign * a / sqrt(1.0 - kappa + kappa**2)
    x, z = bent + X, kappa * bent - Z
    true = sqrt(x**2 - x * z + z**2)
    assert true <= float(held_together(along=a, across=Z, held=X)) * (1.0 + 1e-12) + 1e-12


def test_what_pulls_and_what_is_held_across_is_von_mises_of_both():
    pulled = np.array([0.0, 1.0, 3.0])
    told = held_together(along=pulled, across=2.0, held=0.5)
    x, z = pulled + 0.5, -2.0
    assert told == pytest.approx(np.sqrt(x**2 - x * z + z**2))
