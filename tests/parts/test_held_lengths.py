"""What clamps that hold blades across make of their length, against solids of high order."""

import pytest
from plates.held_solid import bar, lengthening, notch

from flexcli.formulas.profile import Constant, Filleted, Notch
from flexcli.formulas.sheet_factors import held_growth
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.parts.material import Material
from flexcli.parts.temperature import HELD_ERROR, held_lengths, held_share

GROWTH = 1e-3


def blade(profile, l, b):
    return Blade("blade", "ground", "body", (0.0, 0.0), (l, 0.0), profile, b)


def told(profile, l, b, nu):
    """Return the lengthening per strain that is held, and its error [m]."""
    one = blade(profile, l, b)
    grown = Layout((Body("body", (l, 0.0)),), (one,), 1e9,
                   body_growth={"ground": 0.0, "body": 0.0},
                   blade_growth={"blade": GROWTH})  # fmt: skip
    words = {"name": "m", "youngs_modulus": "1 GPa", "yield_strength": "1 MPa"}
    if nu is not None:
        words["poisson_ratio"] = nu
    error = held_lengths(grown, Material.model_validate(words))["blade"] / GROWTH * l
    return held_share(one, 0.25 if nu is None else nu) * l, error


@pytest.mark.parametrize(
    ("h", "b", "nu"),
    [(0.1, 0.3, 0.3), (0.3, 0.3, 0.45), (0.25, 2.6, 0.3), (0.3, 0.3, 0.1), (0.3, 1.0, 0.45)],
)
def test_blades_held_across_are_longer_by_their_width_and_thickness(h, b, nu):
    value, error = told(Constant(h), 1.0, b, nu)
    assert error == pytest.approx(HELD_ERROR * value)
    assert lengthening(bar(l=1.0, h=h, b=b), nu) == pytest.approx(value, abs=error)


def test_width_and_thickness_may_be_told_the_other_way_round():
    at = {"l": 1.0, "poisson_ratio": 0.3}
    assert held_growth(b=0.1, h=0.4, **at) == held_growth(b=0.4, h=0.1, **at)


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
@pytest.mark.parametrize("b", [0.6, 8.0])
@pytest.mark.parametrize(
    ("profile", "sizes"),
    [
        (Notch(0.1, 1.0), {"e": 0.1, "depth": 1.0, "l": 2.0}),
        (Notch(1.5, 2.0), {"e": 1.5, "depth": 2.0, "l": 2.0}),
        (Filleted(0.3, 1.0), {"e": 0.3, "depth": 1.0, "l": 2.0, "straight": 4.0}),
    ],
)
def test_notches_are_longer_by_what_lies_between_rigid_mouths_and_blocks_as_high(
    profile, sizes, b, nu
):
    l = sizes["l"] + sizes.get("straight", 0.0)
    value, error = told(profile, l, b, nu)
    rigid = lengthening(notch(**sizes, b=b), nu)
    height = sizes["e"] + 2.0 * sizes["depth"]
    soft = lengthening(notch(**sizes, b=b, block=height), nu, end=l / 2.0)
    for solid in (rigid, soft):
        assert abs(solid - value) < error
    # no more than the two ends and a fifth of the larger
    assert error < abs(rigid - soft) / 2.0 + 0.55 * max(rigid, soft)


def test_fillets_at_the_roots_make_a_blade_as_thick_as_they_are():
    value, error = told(Filleted(1.0, 0.3), 20.0, 10.0, 0.3)
    solid = lengthening(notch(e=1.0, depth=0.3, l=0.6, straight=19.4, b=10.0), 0.3)
    assert abs(solid - value) < error < 0.13 * value


def test_a_poissons_ratio_that_is_not_given_may_be_any():
    value, error = told(Constant(0.02), 1.0, 0.5, None)
    for nu in (0.0, 0.1, 0.3, 0.499):
        assert abs(told(Constant(0.02), 1.0, 0.5, nu)[0] - value) <= error


def test_thickness_that_varies_otherwise_has_all_of_it_in_its_error():
    shallow = Notch(1.0, 0.2)
    value, error = told(shallow, 0.4, 1.0, 0.3)
    assert value == 0.0
    for block in (0.0, 1.4):
        solid = lengthening(notch(e=1.0, depth=0.2, l=0.4, b=1.0, block=block), 0.3, end=0.2)
        assert 0.0 < solid < error
