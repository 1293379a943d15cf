from dataclasses import replace
from fractions import Fraction
from math import cos, pi, radians, sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from planar_joint import blade_rows, joint_stiffness
from planar_support import support_compliance
from support import compliance_from, support_stiffness

from flexcli.errors import SolveError
from flexcli.formulas.blade_spring import middle_stiffness
from flexcli.formulas.pivot import rotational_stiffness
from flexcli.formulas.profile import Constant, Notch
from flexcli.formulas.rigid_motion import axes_about_z, motion_at
from flexcli.formulas.stage import translational_stiffness
from flexcli.mechanics.layout import Blade, Body, Layout, Support

E, G = 114e9, 42.5e9
h, l, b = 0.3e-3, 20e-3, 8e-3
PLANE = np.ix_((0, 1, 5), (0, 1, 5))
ORIGIN = (0.0, 0.0, 0.0)

ROUNDING = 1e-11
"""Relative to the largest entry of a block: rotations into the axes and one factorisation."""


def blade(name, first, second, start, end, **changes):
    given_ = {"profile": Constant(h), "b": b, **changes}
    return Blade(name, first, second, start, end, **given_)


def pivot_blades(p, angles, first="ground", second="body", centre=(0.0, 0.0), **changes):
    """Blades from a body to another whose centre lines meet in one point."""
    x, y = centre
    return tuple(
        blade(
            f"{first}-{second}-{k}",
            first,
            second,
            (x + p * np.cos(a), y + p * np.sin(a)),
            (x + (p + l) * np.cos(a), y + (p + l) * np.sin(a)),
            **changes,
        )
        for k, a in enumerate(angles)
    )


def one_body(blades, **changes):
    return Layout((Body("body", (0.0, 0.0)),), tuple(blades), E, G, **changes)


def stage(first="ground", second="body", at=0.0, up=1.0):
    """Two parallel blades along ±y, 30 mm apart."""
    return tuple(
        blade(f"{first}-{second}-{k}", first, second, (x, at), (x, at + up * l))
        for k, x in enumerate((-15e-3, 15e-3))
    )


def assert_alike(found, expected, tolerance=ROUNDING):
    """Compare stiffness entry by entry, against the size of its row and column."""
    size = 1 / np.sqrt(np.diagonal(expected, axis1=-2, axis2=-1))
    scale = size[..., :, None] * size[..., None, :]
    np.testing.assert_allclose(found * scale, expected * scale, atol=tolerance)


@given(delta=st.floats(-1.2, 1.2), half_angle=st.floats(15, 75))
def test_planar_part_of_a_pivot_is_the_planar_joint(delta, half_angle):
    angles = (radians(half_angle), -radians(half_angle))
    layout = one_body(pivot_blades(delta * l, angles))
    K = support_stiffness(layout, "body", ORIGIN, shear_factor=np.inf)
    assert_alike(K[PLANE], joint_stiffness(E=E, h=h, l=l, b=b, p=delta * l, angles=angles))
    others = np.delete(np.delete(K, (2, 3, 4), axis=0), (0, 1, 5), axis=1)
    assert np.abs(others).max() < 1e-9 * np.abs(K).max()


def test_softest_compliance_of_a_pivot_is_its_rotation():
    layout = one_body(pivot_blades(2e-3, (0.7, -0.7)))
    C = support_compliance(layout, "body", ORIGIN, shear_factor=np.inf)
    K = rotational_stiffness(E=E, h=h, l=l, b=b, p=2e-3)
    # stretch of the blades lets the centre give way, by shares of the order (h/l)²
    assert C[5, 5] * K == pytest.approx(1.0, abs=2 * (h / l) ** 2)


def test_stage_is_the_leaf_spring_stage_along_its_stroke():
    layout = one_body(stage())
    K = support_stiffness(layout, "body", (0.0, l / 2, 0.0), shear_factor=np.inf)
    assert K[0, 0] == pytest.approx(translational_stiffness(E=E, h=h, l=l, b=b), rel=ROUNDING)
    assert K[1, 1] == pytest.approx(2 * E * b * h / l, rel=ROUNDING)
    # stretch on the arm of 15 mm, beside which the blades' own turning is small
    assert K[5, 5] == pytest.approx(2 * E * b * h / l * (15e-3) ** 2 + E * b * h**3 / (6 * l))


def test_single_blade_has_the_closed_form_at_its_middle():
    layout = one_body([blade("blade", "ground", "body", (0.0, 0.0), (l, 0.0), z=3e-3)])
    K = support_stiffness(layout, "body", (l / 2, 0.0, 3e-3))
    expected = np.diag([float(k) for k in middle_stiffness(E=E, G=G, h=h, l=l, b=b)])
    assert_alike(K, expected)


def test_two_alike_side_by_side_are_twice_one():
    one = pivot_blades(2e-3, (0.7, -0.7))
    both = one + pivot_blades(2e-3, (0.7, -0.7))
    point = (1e-3, 2e-3, 3e-3)
    double = 2 * support_stiffness(one_body(one), "body", point)
    assert_alike(support_stiffness(one_body(both), "body", point), double)


def test_double_parallelogram_has_half_the_stiffness_along_its_stroke():
    blades = stage("ground", "shuttle") + stage("shuttle", "body", at=l, up=-1.0)
    layout = Layout((Body("shuttle", (0.0, l)), Body("body", (0.0, 0.0))), blades, E, G)
    C = support_compliance(layout, "body", ORIGIN, shear_factor=np.inf)
    K = translational_stiffness(E=E, h=h, l=l, b=b)
    # besides the strokes: stretch of the blades, (h/l)² of them, on the arm l/2
    assert C[0, 0] * K / 2 == pytest.approx(1.0, abs=(h / 15e-3) ** 2)


def chain(shift=0.0):
    """A pivot on a pivot, the second one turned."""
    blades = pivot_blades(2e-3, (0.7, -0.7), second="arm") + pivot_blades(
        -5e-3, (1.9, 0.2), "arm", "body", centre=(30e-3, 10e-3), z=4e-3
    )
    return Layout((Body("arm", (shift, 0.0)), Body("body", (30e-3, -shift))), blades, E, G)


def test_bodies_in_series_add_their_compliance():
    point = (30e-3, 10e-3, 0.0)
    first, second = chain().blades[:2], chain().blades[2:]
    one = one_body(replace(each, second="body") for each in first)
    other = one_body(replace(each, first="ground") for each in second)
    total = support_compliance(one, "body", point) + support_compliance(other, "body", point)
    assert_alike(support_compliance(chain(), "body", point), total)


def test_halves_in_series_are_the_whole_blade():
    halves = (
        blade("near", "ground", "middle", (0.0, 0.0), (l / 4, l / 4)),
        blade("far", "middle", "body", (l / 4, l / 4), (l / 2, l / 2)),
    )
    whole = blade("whole", "ground", "body", (0.0, 0.0), (l / 2, l / 2))
    bodies = Body("middle", (0.0, 0.0)), Body("body", (0.0, 0.0))
    point = (1e-3, -2e-3, 1e-3)
    assert_alike(
        support_compliance(Layout(bodies, halves, E, G), "body", point),
        support_compliance(one_body([whole]), "body", point),
    )


@pytest.mark.slow
@given(
    x=st.floats(-0.05, 0.05),
    y=st.floats(-0.05, 0.05),
    z=st.floats(-0.05, 0.05),
    a=st.floats(-pi, pi),
)
def test_moved_to_another_point_and_axes_it_agrees(x, y, z, a):
    axes = axes_about_z(a)
    C = support_compliance(chain(), "body", ORIGIN)
    assert_alike(
        support_compliance(chain(), "body", (x, y, z), axes), compliance_from(C, (x, y, z), axes)
    )


@pytest.mark.slow
@given(a=st.floats(-pi, pi), x=st.floats(-1.0, 1.0))
def test_turning_and_moving_the_whole_layout_changes_nothing_in_its_own_axes(a, x):
    def placed(point):
        return x + cos(a) * point[0] - sin(a) * point[1], sin(a) * point[0] + cos(a) * point[1]

    layout = chain()
    turned = replace(
        layout,
        bodies=tuple(body._replace(point=placed(body.point)) for body in layout.bodies),
        blades=tuple(
            replace(each, start=placed(each.start), end=placed(each.end)) for each in layout.blades
        ),
    )
    at_rest = support_compliance(layout, "body", (1e-3, 2e-3, 0.0))
    axes = axes_about_z(a)
    found = support_compliance(turned, "body", (*placed((1e-3, 2e-3)), 0.0), axes)
    assert_alike(found, at_rest, 1e-9)


@given(
    thin=st.floats(-3.0, -1.0),
    wide=st.floats(-2.0, 0.0),
    x=st.floats(-0.05, 0.05),
    z=st.floats(-0.02, 0.02),
)
def test_matrices_are_symmetric_positive_definite(thin, wide, x, z):
    size = {"profile": Constant(l * 10**thin), "b": l * 10**wide}
    layout = one_body(pivot_blades(2e-3, (0.7, -0.7), **size))
    matrix = support_compliance(layout, "body", (x, 0.01, z))
    np.testing.assert_array_equal(matrix, matrix.T)
    scale = 1 / np.sqrt(np.diag(matrix))
    assert np.linalg.eigvalsh(matrix * np.outer(scale, scale)).min() > 0


def exact_rotation_compliance(thickness, p, angles):
    """The planar joint's compliance to a moment, in rational numbers from the rows on."""
    K = [[Fraction(0)] * 3 for _ in range(3)]
    bending, stretch = E * b * thickness**3 / 12, E * b * thickness / l
    for angle in angles:
        e, w, φ = ([Fraction(x) for x in row] for row in blade_rows(l=l, p=p, angle=angle))
        # at the middle of the blade: shift w − φ l/2, rotation φ
        shift = [one - other * Fraction(l) / 2 for one, other in zip(w, φ, strict=True)]
        for row, k in ((e, stretch), (shift, 12 * bending / l**3), (φ, bending / l)):
            for i, j in np.ndindex(3, 3):
                K[i][j] += Fraction(k) * row[i] * row[j]
    det = K[0][0] * K[1][1] - K[0][1] ** 2
    lost = K[0][2] ** 2 * K[1][1] - 2 * K[0][2] * K[1][2] * K[0][1] + K[1][2] ** 2 * K[0][0]
    return float(1 / (K[2][2] - lost / det))


@pytest.mark.parametrize("ratio", [1e-2, 1e-3, 1e-4, 1e-5])
def test_thin_blades_askew_lose_no_digits_of_the_rotation(ratio):
    thin, angles = ratio * l, (1.3, 0.1)
    blades = pivot_blades(2e-3, angles, profile=Constant(thin))
    C = support_compliance(one_body(blades), "body", ORIGIN, shear_factor=np.inf)
    assert C[5, 5] == pytest.approx(exact_rotation_compliance(thin, 2e-3, angles), rel=1e-11)


def test_where_a_body_is_stated_does_not_matter():
    point = (1e-3, 2e-3, 3e-3)
    one, other = (support_compliance(chain(shift), "body", point) for shift in (0.0, 0.3))
    assert_alike(one, other, 1e-10)


def test_support_springs_hold_their_body():
    support = Support("body", (1e-3, 2e-3), (1e4, 2e4, 3.0))
    bare = one_body(pivot_blades(2e-3, (0.7, -0.7)))
    held = replace(bare, supports=(support,))
    x, y, turn = support.stiffness
    moved = motion_at((1e-3, 2e-3, 0.0))
    added = moved.T @ np.diag([x, y, 0.0, 0.0, 0.0, turn]) @ moved
    expected = support_stiffness(bare, "body", ORIGIN) + added
    assert_alike(support_stiffness(held, "body", ORIGIN), expected)


def test_blades_at_two_heights_resist_tilting_on_their_arm():
    pairs = [
        blade(f"blade-{k}", "ground", "body", (0.0, 0.0), (l, 0.0), z=z)
        for k, z in enumerate((-10e-3, 10e-3))
    ]
    K = support_stiffness(one_body(pairs), "body", (l / 2, 0.0, 0.0))
    k = middle_stiffness(E=E, G=G, h=h, l=l, b=b)
    assert K[4, 4] == pytest.approx(2 * (float(k.theta_y) + k.x * 1e-4), rel=ROUNDING)
    assert K[3, 3] == pytest.approx(2 * (float(k.theta_x) + k.y * 1e-4), rel=ROUNDING)


def test_batch_equals_designs_one_by_one():
    thick, wide, shift = (np.linspace(1.0, 2.0, 4) * size for size in (h, b, 1e-3))

    def layout(thickness, width, move):
        return Layout(
            (Body("arm", (move, 0.0)), Body("body", (0.03, move))),
            (
                blade("a", "ground", "arm", (move, 0.0), (l, move), profile=thickness, b=width),
                blade("b", "ground", "arm", (0.0, l), (l, l), profile=Constant(h)),
                blade("c", "arm", "body", (0.0, 0.0), (0.0, l), profile=Notch(50e-6, l / 2)),
            ),
            E,
            G,
        )

    many = layout(Constant(thick[:, None]), wide, shift)
    found = support_compliance(many, "body", (shift, 0.0, 0.0))
    assert found.shape == (4, 6, 6)
    for k in range(4):
        one = layout(Constant(thick[k]), wide[k], shift[k])
        assert_alike(found[k], support_compliance(one, "body", (shift[k], 0.0, 0.0)))


def test_restrained_warping_stiffens_torsion_alone():
    layout = one_body([blade("blade", "ground", "body", (0.0, 0.0), (l, 0.0))])
    point = (l / 2, 0.0, 0.0)
    free = support_stiffness(layout, "body", point)
    held = support_stiffness(layout, "body", point, warping="restrained")
    assert held[3, 3] > 1.1 * free[3, 3]
    held[3, 3] = free[3, 3]
    assert_alike(held, free)


def test_body_that_hangs_on_nothing_is_named_with_its_remedy():
    layout = chain()
    loose = replace(layout, bodies=(*layout.bodies, Body("loose", (0.0, 0.0))))
    with pytest.raises(
        SolveError, match="a body besides body can move without resistance: hold every body"
    ):
        support_compliance(loose, "body", ORIGIN)


@pytest.mark.parametrize("ratio", [1e-2, 1e-5])
def test_bodies_that_hang_on_each_other_alone_are_found(ratio):
    adrift = pivot_blades(2e-3, (0.9, -0.4), "loose", "other", profile=Constant(ratio * l))
    layout = chain()
    more = Body("loose", (0.1, 0.2)), Body("other", (-0.3, 0.1))
    layout = replace(layout, bodies=layout.bodies + more, blades=layout.blades + adrift)
    with pytest.raises(SolveError, match="a body besides body can move without resistance"):
        support_compliance(layout, "body", ORIGIN)


def test_body_without_a_spring_has_no_compliance():
    layout = one_body([])
    with pytest.raises(SolveError, match="body can move without resistance"):
        support_compliance(layout, "body", ORIGIN)


def test_missing_shear_modulus_is_asked_for():
    with pytest.raises(SolveError, match="Poisson's ratio"):
        support_compliance(replace(chain(), G=None), "body", ORIGIN)


def test_unknown_body_is_refused():
    with pytest.raises(ValueError, match="no body is named platform"):
        support_compliance(chain(), "platform", ORIGIN)
