"""Any bar between rigid clamps: its springs are between those of beams and of rigid sections."""

import numpy as np
import pytest

import flexcli
from flexcli.formulas.bar_limits import ROUND_FACTOR, bar_limits
from flexcli.formulas.clamped_blade import clamped_blade, clamped_rod
from flexcli.formulas.torsion_section import torsion_constant
from flexcli.results import Verdict

E = 70e9


def limits_of(h, l, b, nu):
    return bar_limits(
        E=E, G=E / 2.0 / (1.0 + nu), l=l, area=b * h, I_y=h * b**3 / 12.0, I_z=b * h**3 / 12.0,
        J=float(torsion_constant(h, b)), shear_factor=5.0 / 6.0,
    )  # fmt: skip


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize(
    ("h", "b"), [(0.002, 0.1), (0.02, 1.0), (0.1, 0.3), (0.3, 0.3), (0.3, 3.0), (0.05, 30.0)]
)
def test_blades_that_solids_know_are_between_the_limits(h, b, nu):
    """``clamped-blade``, whose errors hold CalculiX's solids."""
    least, most = limits_of(h, 1.0, b, nu)
    found = clamped_blade(E=E, G=E / 2.0 / (1.0 + nu), h=h, l=1.0, b=b)
    assert np.all(least <= found.stiffness * (1.0 + found.high) * (1.0 + 1e-9))
    assert np.all(found.stiffness * (1.0 + found.low) <= most * (1.0 + 1e-9))
    assert np.all(least <= most * (1.0 + 1e-9))


def test_slender_rods_are_within_what_is_told_of_them():
    d, l, nu = 0.02, 1.0, 0.3
    I, G = np.pi * d**4 / 64.0, E / 2.6
    limits = bar_limits(
        E=E, G=G, l=l, area=np.pi * d**2 / 4.0, I_y=I, I_z=I, J=2.0 * I, shear_factor=ROUND_FACTOR
    )
    found = clamped_rod(E=E, G=G, d=d, l=l)
    assert np.all(limits.least <= found.stiffness * (1.0 + found.high) * (1.0 + 1e-9))
    assert np.all(found.stiffness * (1.0 + found.low) <= limits.most)
    # sections that stay rigid are stiffer by (1 − ν)/((1 + ν)(1 − 2ν)), but in torsion
    held = (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu))
    assert limits.most / limits.least == pytest.approx([held] * 3 + [1.0, held, held], rel=1e-3)


def test_the_shear_of_a_circle_is_in_balance_and_has_that_energy():
    """By polar quadrature: ``∫ (τ_xz² + τ_xy²) dA`` is ``V²/(κ A)``, and ``∫ τ_xz dA`` is V."""
    r, w = np.polynomial.legendre.leggauss(12)
    r, w = (r + 1.0) / 2.0, w / 2.0
    angle = np.arange(48) * 2.0 * np.pi / 48
    y, z = np.outer(r, np.cos(angle)), np.outer(r, np.sin(angle))
    area = np.outer(w * r, np.full(48, 2.0 * np.pi / 48))
    along, aside = (1.0 - z**2) / 3.0 * 4.0 / np.pi, -y * z / 3.0 * 4.0 / np.pi
    assert np.sum(along * area) == pytest.approx(1.0)
    assert np.sum((along**2 + aside**2) * area) * np.pi == pytest.approx(1.0 / ROUND_FACTOR)


def test_without_lateral_contraction_what_stretches_and_bends_evenly_is_a_beam():
    least, most = limits_of(0.7, 1.0, 0.9, 0.0)
    even = [0, 4, 5]
    assert least[even] == pytest.approx(most[even], rel=1e-12)
    assert least[0] == pytest.approx(E * 0.63)
    assert np.all(most[1:3] / least[1:3] < 1.2)


WIDE_STAR = """flexure: 1
material: {{youngs_modulus: 70 GPa, poisson_ratio: {nu}}}
geometry: {{kind: torsion-star, h: 0.2 mm, l: 2 mm, b: 3.4 mm, strips: 2}}
cases: {{work: {{stroke: {{rotation: 1e-5 rad}}}}}}
requirements: {{support: [{{direction: {way}, min: 1 N/m}}]}}
"""


def support(nu, way):
    checks = flexcli.verdicts(WIDE_STAR.format(nu=nu, way=way), model="exact").checks
    return next(check for check in checks if check.name.startswith("support"))


def test_a_star_wider_than_long_is_stretched_as_any_bar():
    """Nobody compared it with solids: it had no range at all."""
    area = 0.2e-3 * (2.0 * 3.4e-3 - 0.2e-3)
    row = support(0, "z")
    assert row.factor_range == pytest.approx([E * area / 2e-3] * 2)
    row = support(0.3, "z")
    low, high = row.factor_range
    assert low == pytest.approx(E * area / 2e-3)
    assert high / low == pytest.approx(0.7 / (1.3 * 0.4))


def test_a_deflection_across_a_wide_star_is_no_less_than_that_of_any_bar():
    text = WIDE_STAR.format(nu=0.3, way="x")
    text = text.replace("{stroke: {rotation: 1e-5 rad}}", "{wrench: {x: 1 uN, z: 1 uN}}")
    asked = "deflection: [{direction: x, max: 1 m}, {direction: z, max: 1 m}]"
    text = f"{text.split('requirements')[0]}requirements: {{{asked}}}\n"
    found = {c.name[:12]: c for c in flexcli.verdicts(text, model="exact").checks}
    assert found["deflection x"].verdict is Verdict.UNDECIDED
    low, high = found["deflection z"].factor_range
    assert 1.0 < high / low < 2.0


def test_across_a_wide_star_only_what_it_bears_at_most_is_told():
    row = support(0.3, "x")
    assert row.verdict is Verdict.UNDECIDED
    low, high = row.factor_range
    assert low == 0.0
    assert row.factor < high < 10.0 * row.factor
