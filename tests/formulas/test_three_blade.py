from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from planar_support import support_compliance

from flexcli.formulas import pivot
from flexcli.formulas.profile import Constant
from flexcli.formulas.three_blade import CARDS, out_of_plane_compliance, out_of_plane_stiffness
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.numerics.signomial import variables

E, NU, l, m, g = 116e9, 0.34, 80e-3, 0.8, 3.7
G = E / (2 * (1 + NU))
"""Exercise 12 B; it gives no Poisson's ratio, 0.34 is that of titanium."""
b, h = 30e-3, 250e-6
"""Its result, as printed."""


def three_blades(thickness, width, p=0.0):
    spokes = [(np.cos(a), np.sin(a)) for a in (0.0, 2 * pi / 3, 4 * pi / 3)]
    blades = tuple(
        Blade(
            f"blade-{k}",
            "ground",
            "payload",
            (p * c, p * s),
            ((p + l) * c, (p + l) * s),
            Constant(thickness),
            width,
        )
        for k, (c, s) in enumerate(spokes)
    )
    return Layout((Body("payload", (0.0, 0.0)),), blades, E, G)


@given(ratio=st.floats(0.01, 1.0), p=st.floats(0.0, 0.05))
def test_formula_is_the_support_stiffness_along_the_axis(ratio, p):
    expected = out_of_plane_stiffness(E=E, G=G, h=h, l=l, b=ratio * l)
    # free to tilt or not: the three blades keep the body from it
    C = support_compliance(three_blades(h, ratio * l, p), "payload", (0.0, 0.0, 0.0))
    assert C[2, 2] == pytest.approx(1 / expected, rel=1e-9)


def test_exercise_sags_by_its_645_nm_only_without_shear():
    bending = pivot.out_of_plane_stiffness(E=E, h=h, l=l, b=b, blades=3)
    assert m * g / bending == pytest.approx(645e-9, abs=0.6e-9)
    sag = m * g * out_of_plane_compliance(E=E, G=G, h=h, l=l, b=b)
    Φ = 2.4 * (1 + NU) * 0.375**2
    assert sag == pytest.approx(645e-9 * (1 + Φ), rel=1e-3)
    assert sag == pytest.approx(937e-9, abs=1e-9)


def test_slender_blades_have_the_exercise_s_stiffness():
    narrow = 1e-4 * l
    K = out_of_plane_stiffness(E=E, G=G, h=h, l=l, b=narrow)
    bending = pivot.out_of_plane_stiffness(E=E, h=h, l=l, b=narrow, blades=3)
    assert bending == pytest.approx(K, rel=1e-7)


def test_compliance_takes_signomials():
    x, y, z = variables("h", "l", "b")
    C = out_of_plane_compliance(E=E, G=G, h=x, l=y, b=z)
    assert C.is_posynomial
    expected = out_of_plane_compliance(E=E, G=G, h=h, l=l, b=b)
    assert C.at(h=h, l=l, b=b) == pytest.approx(expected, rel=1e-12)


def test_array_call_equals_element_wise_calls():
    widths = np.array([1e-3, 1e-2, 5e-2])
    each = [out_of_plane_stiffness(E=E, G=G, h=h, l=l, b=width) for width in widths]
    np.testing.assert_allclose(
        out_of_plane_stiffness(E=E, G=G, h=h, l=l, b=widths), each, rtol=1e-14
    )


def test_table_of_the_card_is_the_share_that_shear_leaves():
    _, share = CARDS[0].tables["width"].columns["K_z/K_z(bending)"]
    assert share(0.375) == pytest.approx(1 / (1 + 3.2 * 0.375**2), rel=1e-12)
