"""Drawn blades with fillets give way as plane bodies do, and as those of the catalogue's joints."""

import numpy as np
import pytest
import yaml
from plates.filleted_blade import beam_compliances, over_beam
from pydantic import TypeAdapter

import flexcli
from flexcli.parts.geometries import AnyGeometry

ADAPTER = TypeAdapter(AnyGeometry)
FAR = 1e3
"""Distance of two guiding blades over their length: what they stretch turns nothing."""


def blade(start, end, profile, bodies=("ground", "stage")):
    places = {"from": start, "to": end}
    return {
        "between": list(bodies),
        "b": "3000 m",
        **{key: [f"{x!r} m" for x in map(float, place)] for key, place in places.items()},
        "profile": profile,
    }


def filleted(h, r):
    return {"kind": "filleted", "h": f"{h!r} m", "r": f"{r!r} m"}


def layout(blades, clamps, *, turns=True, at=(0.0, 0.0)):
    said = {
        "kind": "layout",
        "bodies": {"stage": {"at": [f"{x!r} m" for x in at]}},
        "blades": {f"b{i}": each for i, each in enumerate(blades)},
        "moving": "stage",
        "motion": "rotation" if turns else {"translation": "0 deg"},
        **({} if clamps is None else {"clamps": clamps}),
    }
    return ADAPTER.validate_python(said)


def changes(joint, nu):
    assert joint.thick_notches(joint.sized({})) is None
    return joint.compliant_clamps(joint.sized({}), nu)


def told_stiffness(clamps, x, straight, nu):
    """Return the ranges of the stiffness of drawn blades over their beams', as an arc and an S."""
    l, profile = straight + 2.0 / x, filleted(1.0, 1.0 / x)
    arc = layout([blade((0.0, 0.0), (l, 0.0), profile)], clamps)
    pair = [blade((at, 0.0), (at, l), profile) for at in (0.0, FAR * l)]
    s_shape = layout(pair, clamps, turns=False, at=(0.0, l))
    return [changes(joint, nu).stiffness for joint in (arc, s_shape)]


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.48])
@pytest.mark.parametrize("straight", [0.02, 0.3, 1.0, 4.0, 20.0])
@pytest.mark.parametrize("x", [0.1, 0.3, 1.0, 3.0])
def test_drawn_blades_with_fillets_between_walls_are_as_stiff_as_plane_bodies(x, straight, nu):
    """In plane stress, and in plane strain over the beam of that."""
    told = told_stiffness(None, x, straight, nu)
    for ratio in (nu, nu / (1.0 - nu)):
        true = over_beam(1.0 / x, straight, nu=ratio)
        for factor, stiffness in zip(told, true[:2], strict=True):
            assert factor.low <= stiffness <= factor.high
    if straight >= 4.0:
        assert all(factor.high / factor.low < 1.02 + 0.15 * nu for factor in told)


@pytest.mark.parametrize("nu", [0.0, 0.48])
@pytest.mark.parametrize("straight", [1.0, 4.0, 20.0])
@pytest.mark.parametrize("x", [0.1, 0.3, 1.0, 3.0])
def test_drawn_blades_with_fillets_cut_from_bodies_are_as_stiff_as_plane_bodies(x, straight, nu):
    told = told_stiffness("monolithic", x, straight, nu)
    for body in ((max(1.0 - 1.0 / x, 0.5), 2.0), (2.0, 2.0), (9.0, 9.0)):
        true = over_beam(1.0 / x, straight, body=body, nu=nu)
        for factor, stiffness in zip(told, true[:2], strict=True):
            assert factor.low <= stiffness <= factor.high


def driven(blades, compliances):
    """Return the stiffness against turning a body about the origin that clamped blades hold.

    ``compliances`` of each are of its rotation, its travel and its elongation, at E b = 1.
    """
    K = np.zeros((3, 3))
    for (start, end), (turn, across, along) in zip(blades, compliances, strict=True):
        c, s = np.subtract(end, start) / np.hypot(*np.subtract(end, start))
        x, y = np.add(start, end) / 2.0
        J = np.array([[c, s, s * x - c * y], [-s, c, c * x + s * y], [0.0, 0.0, 1.0]])
        K += J.T @ np.diag([1.0 / along, 1.0 / across, 1.0 / turn]) @ J
    return 1.0 / np.linalg.inv(K)[2, 2]


def compliances(h, r, straight, nu, over):
    scale = np.array([h**-2.0, 1.0, 1.0])
    return scale * beam_compliances(r / h, straight / h, nu=nu) / over


@pytest.mark.parametrize("seed", range(12))
def test_pivots_of_unlike_drawn_blades_with_fillets_are_as_stiff_as_plane_bodies(seed):
    """Every other one has a blade without fillets, which rigid clamps let give way nowhere."""
    rng = np.random.default_rng(seed)
    nu, places, sizes = rng.uniform(0.0, 0.48), [], []
    for angle in (0.3, 1.4, 4.0)[: rng.integers(2, 4)]:
        h = 10.0 ** rng.uniform(-0.3, 0.3)
        r, straight = h / 10.0 ** rng.uniform(-1.0, 0.5), h * rng.uniform(0.02, 15.0)
        start = (straight + r) * rng.uniform(-1.0, 1.0, 2)
        reach = (straight + 2.0 * r) * np.array([np.cos(angle), np.sin(angle)])
        places.append((start, start + reach))
        sizes.append((h, r, straight))
    blades = [blade(*at, filleted(h, r)) for at, (h, r, _) in zip(places, sizes, strict=True)]
    bodies = [compliances(h, r, s, nu, over_beam(r / h, s / h, nu=nu)) for h, r, s in sizes]
    beams = [compliances(*each, nu, np.ones(3)) for each in sizes]
    if seed % 2:
        places.append(((-4.0, 1.0), (-5.0, 13.0)))
        blades.append(blade(*places[-1], {"kind": "constant", "h": "0.9 m"}))
        l = np.hypot(1.0, 12.0)
        plain = np.array([12.0, l**2 + 2.4 * (1.0 + nu) * 0.9**2, 0.9**2]) * l / 0.9**3
        bodies.append(plain)
        beams.append(plain)
    told = changes(layout(blades, "rigid"), nu).stiffness
    assert told.low <= driven(places, bodies) / driven(places, beams) <= told.high


@pytest.mark.parametrize("clamps", ["rigid", "monolithic"])
def test_a_drawn_stage_with_fillets_is_told_as_that_of_the_catalogue(clamps):
    pair = [blade((at, 0.0), (at, 12e-3), filleted(0.3e-3, 0.4e-3)) for at in (-10e-3, 10e-3)]
    drawn = layout(pair, clamps, turns=False, at=(0.0, 6e-3))
    sizes = {"h": "0.3 mm", "l": "12 mm", "b": "3000 m", "root_radius": "0.4 mm"}
    said = {"kind": "leaf-spring-stage", "clamps": clamps, "spacing": "20 mm", **sizes}
    known = ADAPTER.validate_python(said)
    one, other = (changes(each, 0.3) for each in (known, drawn))
    for name in ("stiffness", "stress", "buckling", "softest", "loaded", "shift"):
        assert np.allclose(getattr(one, name), getattr(other, name), rtol=1e-6, atol=0.0), name
    springs = [each.root_springs(each.sized({}), 0.3) for each in (known, drawn)]
    assert springs[0] == pytest.approx(springs[1], rel=1e-6)


@pytest.mark.parametrize("at", [(0.0, 6e-3), (1e-3, 6e-3)])
def test_a_stage_whose_point_is_beside_the_middle_of_its_blades_leaves_its_path_as_it_turns(at):
    """So that the shortening of its blades is not all that its shift is of."""
    pair = [blade((x, 0.0), (x, 12e-3), filleted(0.3e-3, 0.4e-3)) for x in (-10e-3, 10e-3)]
    low, high = changes(layout(pair, "rigid", turns=False, at=at), 0.3).shift
    assert (low < 0.0 < high) == (at[0] != 0.0)


def test_the_shift_of_unlike_blades_may_change_as_that_which_shortens_the_most():
    """Alone, beside others, and whichever is drawn first."""
    profiles = [filleted(1.0, 0.2), filleted(1.0, 4.0), {"kind": "constant", "h": "1 m"}]
    places = [((0.0, 0.0), (20.0 * np.cos(a), 20.0 * np.sin(a))) for a in (0.0, 1.0, 2.0)]
    each = [blade(*at, profile) for at, profile in zip(places, profiles, strict=True)]
    alone = [changes(layout([one], None), 0.3).shift[1] for one in each[:2]]
    for drawn in (each, each[::-1]):
        shift = changes(layout(drawn, None), 0.3).shift
        assert shift == pytest.approx((-max(alone), max(alone)))
    assert max(alone) > 1.1 * min(alone) > 0.0


SOLIDS = [
    (0.6, 2.0, 12.0, 1.0, 0.3, 102.63, 0.0038),
    (0.4, 0.4, 8.0, 2.0, 0.3, 116.02, 0.0006),
    (0.5, 2.5, 12.0, 4.0, 0.4, 356.96, 0.0035),
]
"""Thickness, radius, length, width [mm], ν and stiffness [N/mm] with its error of stages of two
blades 20 mm apart, E = 200 GPa, rigid clamps: CalculiX's bricks by ``flexure verify``."""


@pytest.mark.parametrize("is_drawn", [True, False])
@pytest.mark.parametrize(("h", "r", "l", "b", "nu", "stiffness", "off"), SOLIDS)
def test_stages_of_narrow_and_wide_blades_with_fillets_are_as_stiff_as_solids(
    h, r, l, b, nu, stiffness, off, is_drawn
):
    """Blunt fillets hold narrow blades less than clamps do, as in the first."""
    geometry = {"kind": "leaf-spring-stage", "h": f"{h} mm", "l": f"{l} mm", "spacing": "20 mm"}
    geometry |= {"b": f"{b} mm", "root_radius": f"{r} mm"}
    if is_drawn:
        profile = {"kind": "filleted", "h": f"{h} mm", "r": f"{r} mm"}
        pair = {
            name: {
                "between": ["ground", "stage"], "b": f"{b} mm", "profile": profile,
                "from": [x, "0 mm"], "to": [x, f"{l} mm"],
            }
            for name, x in (("left", "-10 mm"), ("right", "10 mm"))
        }  # fmt: skip
        stage = {"stage": {"at": ["0 mm", f"{l / 2.0} mm"]}}
        geometry = {"kind": "layout", "bodies": stage, "blades": pair, "moving": "stage"}
        geometry |= {"motion": {"translation": "0 deg"}}
    said = {
        "flexure": 1,
        "title": "fillets",
        "material": {"name": "drawn", "youngs_modulus": "200 GPa", "poisson_ratio": nu},
        "geometry": {**geometry, "clamps": "rigid"},
        "requirements": {"stiffness": {"min": "1 N/mm"}},
    }
    low, high = flexcli.check(yaml.safe_dump(said), model="linear").checks[-1].factor_range
    assert low <= stiffness * (1.0 + off)
    assert stiffness * (1.0 - off) <= high
    assert low <= stiffness or off < 1e-3
    assert high / low < (1.2 if nu > 0.3 else 1.05)
