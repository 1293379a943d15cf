"""Decks of solid elements: the bricks fill the blade, and CalculiX would read every line."""

import re
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from flexcli.engine.solid.bricks import bricks, graded
from flexcli.engine.solid.deck import State, buckling_deck, compliance_deck, modes_deck, states_deck
from flexcli.engine.solid.model import solid_model, solid_model_in_space
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.space.layout import (
    Drive,
    Isotropic,
    SpaceBlade,
    SpaceBody,
    SpaceLayout,
    SpaceRod,
    SpaceSpring,
)
from flexcli.parts.elastic import NotAvailable

H, L, B = 0.4e-3, 20e-3, 3e-3
KEYWORDS = {
    "*NODE", "*ELEMENT", "*NSET", "*MATERIAL", "*ELASTIC", "*DENSITY", "*SOLID SECTION", "*MASS",
    "*RIGID BODY", "*BOUNDARY", "*STEP", "*STATIC", "*BUCKLE", "*FREQUENCY", "*CONTROLS", "*CLOAD",
    "*NODE PRINT", "*NODE FILE", "*EL FILE", "*END STEP", "*ORIENTATION", "*EXPANSION",
    "*INITIAL CONDITIONS", "*TEMPERATURE",
}  # fmt: skip
"""Of CalculiX's manual, version 2.20."""


def pivot(profile=None, mass=0.0):
    """Return two blades at right angles, side by side."""
    profile = profile or Constant(H)
    ends = L / 2.0 * np.array([np.cos(0.7), np.sin(0.7)])
    blades = tuple(
        Blade(
            f"blade {k}", "ground", "moving", (-ends[0], -side * ends[1]),
            (ends[0], side * ends[1]), profile, B, z,
        )
        for k, side, z in ((1, 1.0, -B), (2, -1.0, B))
    )  # fmt: skip
    body = Body("moving", (0.0, 0.0), mass, mass * 1e-5, (1e-3, 0.0))
    return Layout((body,), blades, 114e9, 42e9)


PUSH = Load("moving", (0.0, 0.0), (-3.0, 1.0), 0.02)


def decks(is_half):
    """Return one deck of each kind, with the model it is of."""
    layout = pivot(mass=0.1)
    model = solid_model(layout, is_half=is_half)
    state = State({"moving": (None, None, 0.05)}, [PUSH])
    growth = {"body_growth": {"ground": 2e-3, "moving": -1e-3}}
    warm = replace(layout, blade_growth={b.name: 1e-3 for b in layout.blades}, **growth)
    return model, {
        "warm": states_deck(solid_model(warm, is_half=is_half), [state, state]),
        "states": states_deck(model, [state, state]),
        "small": states_deck(model, [state], is_linear=True),
        "support": compliance_deck(model, "moving", guided=True),
        "modes": modes_deck(model, 4430.0, ["moving"]),
        "buckling": buckling_deck(model, State({}, [PUSH]), {"moving": 0.3}),
    }


@pytest.mark.parametrize("is_half", [False, True])
@pytest.mark.parametrize("fineness", [1, 2, 3])
def test_bricks_fill_a_blade(fineness, is_half):
    pieces = Constant(H).pieces(L)
    solid = bricks([pieces], B, fineness=fineness, is_half=is_half)
    assert solid.volume == pytest.approx(H * L * B, rel=1e-12)
    assert solid.elements.shape[0] % fineness**3 == 0


@pytest.mark.parametrize(
    ("profile", "volume"),
    [
        (NeckedDown(H, 4e-3), 8e-3 * H * B),
        (Tabulated((0.0, 0.3, 1.0), (H, 2 * H, H)), 1.5 * H * L * B),
    ],
)
def test_bricks_fill_what_flexes(profile, volume):
    layout = pivot(profile)
    assert solid_model(layout).volume == pytest.approx(2.0 * volume, rel=1e-12)


@pytest.mark.parametrize(
    ("profile", "l", "area"),
    [
        (Notch(H, 2e-3), 4e-3, 4e-3 * H + 2.0 * (2.0 - np.pi / 2.0) * 4e-6),
        (Filleted(H, 1e-3), L, L * H + 4e-6 * (1.0 - np.pi / 4.0)),
    ],
)
def test_bricks_fill_a_curved_hinge_but_its_corners(profile, l, area):
    # the corner where the face stands on the body, half a percent of a radius, is rigid:
    # it is as thick as the body there
    errors = []
    for fineness in (1, 2, 4):
        solid = bricks([profile.pieces(l)], B, fineness=fineness)
        errors.append(area * B - solid.volume)
    missing = errors[-1] / (area * B)
    assert 0.0 < missing < 0.02
    # what curved edges of second order leave falls with each finer mesh
    assert abs(errors[1] - errors[2]) < abs(errors[0] - errors[1]) / 4.0


def test_bricks_are_alike_on_every_side():
    solid = bricks([Constant(H).pieces(L)], B)
    seen = {tuple(np.round(place, 12)) for place in solid.places}
    for mirror in ((L, 1, 1, -1), (0.0, -1, 1, 1), (0.0, 1, -1, 1)):
        shift, t, z, s = mirror
        image = solid.places * np.array([s, t, z]) + np.array([shift, 0.0, 0.0])
        assert {tuple(np.round(place, 12) + 0.0) for place in image} == {
            tuple(np.array(place) + 0.0) for place in seen
        }


def test_elements_are_short_at_both_clamps_and_grow_by_steps():
    cuts = graded(20e-3, 0.1e-3)
    sizes = np.diff(cuts)
    assert sizes[0] <= 0.1e-3
    assert sizes == pytest.approx(sizes[::-1], rel=1e-12)
    assert max(b / a for a, b in pairwise(sizes[: sizes.size // 2 + 1])) < 4.0 + 1e-9
    assert cuts[-1] == pytest.approx(20e-3, rel=1e-12)


@pytest.mark.parametrize("is_half", [False, True])
@pytest.mark.parametrize("name", ["states", "small", "support", "modes", "buckling"])
def test_a_deck_names_only_what_it_defines(name, is_half):
    _, made = decks(is_half)
    lines = made[name].text.splitlines()
    keywords = [line.split(",")[0] for line in lines if re.match(r"\*[A-Z]", line)]
    assert set(keywords) <= KEYWORDS
    assert keywords.count("*STEP") == keywords.count("*END STEP") > 0
    nodes, elements, sets, within = set(), [], {}, ""
    for line in lines:
        if line.startswith("*"):
            within = line
            continue
        cells = [cell for cell in line.replace(" ", "").split(",") if cell]
        if within.startswith(("*NODE,", "*NODE\n")) or within == "*NODE":
            assert int(cells[0]) not in nodes
            nodes.add(int(cells[0]))
        elif within.startswith("*ELEMENT"):
            elements += [int(cell) for cell in cells]
        elif within.startswith("*NSET"):
            sets.setdefault(within.split("=")[1], []).extend(map(int, cells))
    for of in sets.values():
        assert set(of) <= nodes
        assert len(of) == len(set(of))
    used = set(
        re.findall(
            r"\bNSET=([A-Z0-9]+)", "\n".join(l for l in lines if "PRINT" in l or "FILE" in l)
        )
    )
    used |= set(re.findall(r"RIGID BODY, NSET=([A-Z0-9]+)", "\n".join(lines)))
    assert used <= set(sets) | {"BODIES"}
    assert all(len(line) <= 200 for line in lines)
    # no node is tied to two bodies, and none is tied and held
    tied = [n for set_, of in sets.items() if set_.startswith(("BODY", "NEAR", "FAR")) for n in of]
    assert len(tied) == len(set(tied))
    assert not set(tied) & {*sets["GROUND"], *sets.get("MIDDLE", [])}


def test_half_a_model_bears_half_of_forces_and_masses():
    whole, half = (decks(is_half)[1] for is_half in (False, True))

    def numbers(text, keyword):
        found = re.findall(rf"\*{keyword}[^\n]*\n((?:[^*\n][^\n]*\n)+)", text)
        return [float(line.split(",")[-1]) for block in found for line in block.splitlines()]

    for deck, keyword in (("states", "CLOAD"), ("modes", "MASS,")):
        both = numbers(whole[deck].text, keyword), numbers(half[deck].text, keyword)
        assert both[1] == pytest.approx([x / 2.0 for x in both[0]], rel=1e-12)
        assert both[0]


def test_a_hinged_blade_has_a_stiff_middle_of_no_mass():
    model = solid_model(pivot(NeckedDown(H, 4e-3)))
    assert [body.name for body in model.bodies] == ["moving"]
    stretch = model.stretches[0]
    middle = stretch.bricks.places[stretch.bricks.elements[stretch.bricks.stiff], 0]
    assert (middle.min(), middle.max()) == pytest.approx((4e-3, L - 4e-3), abs=1e-12)
    deck = modes_deck(model, 4430.0, ["moving"]).text
    weights = [float(x) for x in re.findall(r"\*DENSITY\n(\S+)", deck)]
    assert weights[1] < 1e-6 * weights[0]


def test_no_solid_without_a_shear_modulus():
    flat = pivot()
    with pytest.raises(NotAvailable, match="poisson_ratio"):
        solid_model(Layout(flat.bodies, flat.blades, flat.E))


STEEL = Isotropic(200e9, 77e9, 7850.0)
TENSOR = ((5e-5, 1e-5, 0.0), (1e-5, 4e-5, 0.0), (0.0, 0.0, 6e-5))
IN_SPACE = SpaceLayout(
    (SpaceBody("moving", (0.0, 0.0, L), (1e-3, 2e-3, 3e-3), 0.2, TENSOR),),
    (
        SpaceBlade("wide", "ground", "moving", (0.0, 0.0, 0.0), (0.0, 0.0, L), (1.0, 1.0, 0.0),
                   Constant(H), B, STEEL),
        SpaceRod("round", "moving", "ground", (3e-3, 0.0, L), (3e-3, L, L), 1e-3, STEEL),
    ),
    Drive("moving", False, (1.0, 0.0, 0.0), (0.0, 0.0, L)),
)  # fmt: skip


def test_blades_and_rods_in_space_stand_where_they_are_drawn():
    for fineness, allowed in ((1, 5e-3), (2, 5e-4), (4, 5e-5)):
        model = solid_model_in_space(IN_SPACE, fineness=fineness)
        wide, rod = model.stretches
        assert wide.bricks.volume == pytest.approx(B * H * L, rel=1e-12)
        # arcs of second order: their error falls with the fourth power
        assert rod.bricks.volume == pytest.approx(np.pi / 4.0 * 1e-6 * L, rel=allowed)
        off = np.hypot(rod.places[:, 0] - 3e-3, rod.places[:, 2] - L)
        assert off.max() == pytest.approx(0.5e-3, rel=1e-12)
        corner = H / 2.0 * np.array([1.0, -1.0, 0.0]) + B / 2.0 * np.array([1.0, 1.0, 0.0])
        apart = np.linalg.norm(wide.places - corner / np.sqrt(2.0), axis=1)
        assert apart.min() < 1e-15
    tied = np.concatenate([s.places for s in model.stretches])[model.bodies[0].nodes]
    assert np.all((np.abs(tied[:, 2] - L) < 1e-12) | (np.abs(tied[:, 1]) < 1e-12))


def test_point_masses_of_a_body_in_space_have_its_inertia():
    body = IN_SPACE.bodies[0]
    (solid,) = solid_model_in_space(IN_SPACE).bodies
    places, masses = (np.array(each) for each in zip(*solid.masses, strict=True))
    assert masses.sum() == pytest.approx(0.2)
    assert masses @ places / 0.2 == pytest.approx(np.array(body.com))
    r = places - np.array(body.com)
    tensor = np.einsum("k,ij,k->ij", masses, np.eye(3), (r**2).sum(axis=1))
    tensor -= np.einsum("k,ki,kj->ij", masses, r, r)
    assert tensor == pytest.approx(np.array(TENSOR), abs=1e-15)


def test_solids_in_space_have_one_isotropic_material_and_no_springs():
    other = replace(IN_SPACE.blades[1], material=Isotropic(1e9, 4e8))
    with pytest.raises(NotAvailable, match="several materials"):
        solid_model_in_space(replace(IN_SPACE, blades=(IN_SPACE.blades[0], other)))
    spring = SpaceSpring("moving", (0.0, 0.0, L), (1.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    with pytest.raises(NotAvailable, match="springs"):
        solid_model_in_space(replace(IN_SPACE, springs=(spring,)))
