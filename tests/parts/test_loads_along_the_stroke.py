"""The stress of a load along the stroke, which moves a joint by its force over the stiffness."""

import pytest
import yaml

import flexcli

L, H, B, P = 20e-3, 2e-3, 2e-3, 12e-3
"""A stocky blade, and how far it ends from the centre [m]."""

NU = 0.3

SPEC = {
    "flexure": 1,
    "material": {"name": "drawn", "youngs_modulus": "200 GPa", "poisson_ratio": NU,
                 "yield_strength": "1 GPa", "density": "8000 kg/m^3"},
    "geometry": {"kind": "three-blade", "l": "20 mm", "h": "2 mm", "b": "2 mm", "p": "12 mm"},
    "effects": {"plate-widening": "off"},
    "requirements": {"yield": 1.0},
}  # fmt: skip


def stress_per_moment():
    """Return the stress at the near end of Timoshenko's blade over the moment of all three.

    A body that turns by θ moves that end by p θ across the blade.
    """
    phi = 12.0 * 2.0 * (1.0 + NU) / (5.0 / 6.0) * H**2 / 12.0 / L**2
    end = (4.0 + phi + 6.0 * P / L) / (1.0 + phi)  # EI θ/l
    force = (6.0 + 12.0 * P / L) / (1.0 + phi) / L
    return 6.0 * end / (B * H**2) / (3.0 * (end + force * P))


@pytest.mark.parametrize("model", ["closed-form", "linear", "exact"])
def test_stress_of_a_moment_is_that_of_the_travel_which_it_makes(model):
    moment = 1e-6
    case = {"work": {"wrench": {"theta_z": f"{moment} N*m"}}}
    (found,) = flexcli.verdicts(yaml.safe_dump({**SPEC, "cases": case}), model=model).checks
    low, high = found.factor_range
    expected = stress_per_moment() * moment
    assert found.demand == pytest.approx(expected, rel=1e-4)
    assert low <= found.capacity / expected <= high


@pytest.mark.parametrize("stroke", ["0.1 deg", ["0 deg", "0.2 deg"]])
def test_a_moment_beside_a_stroke_is_in_the_range_of_what_both_bend(stroke):
    case = {"work": {"wrench": {"theta_z": "1 N*m"}, "stroke": {"rotation": stroke}}}
    text = yaml.safe_dump({**SPEC, "cases": case})
    ranges = [
        flexcli.verdicts(text, model=model).checks[0].factor_range
        for model in ("closed-form", "linear", "exact")
    ]
    assert max(low for low, _ in ranges) <= min(high for _, high in ranges)


def test_a_small_moment_beside_a_stroke_leaves_a_small_part_of_its_range():
    """Strokes are corrected by their travel, moments by what they move: closed forms shear 8 %."""
    width = []
    for moment in (1e-3, 1e-2, 0.1, 1.0, 10.0):
        case = {"work": {"wrench": {"theta_z": f"{moment} N*m"},
                         "stroke": {"rotation": ["0 deg", "0.2 deg"]}}}  # fmt: skip
        text = yaml.safe_dump({**SPEC, "cases": case})
        found = {m: flexcli.verdicts(text, model=m).checks[0] for m in ("closed-form", "exact")}
        (low, high), exact = found["closed-form"].factor_range, found["exact"].factor
        assert low <= exact <= high
        width.append(high / low - 1.0)
    assert width == sorted(width)
    assert width[0] < 0.2 * width[-1]


def test_a_moment_on_a_drawn_wide_blade_is_borne_by_its_section():
    blade = {"between": ["ground", "body"], "from": ["0 mm", "0 mm"], "to": ["0 mm", "20 mm"]}
    layout = {
        "kind": "layout",
        "bodies": {"body": {"at": ["0 mm", "20 mm"]}},
        "blades": {"wide": {**blade, "h": "0.2 mm", "b": "30 mm"}},
        "moving": "body",
        "motion": "rotation",
    }
    spec = {**SPEC, "geometry": layout, "cases": {"work": {"wrench": {"theta_z": "1e-3 N*m"}}}}
    spec.pop("effects")
    (found,) = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
    assert found.demand == pytest.approx(6.0 * 1e-3 / (30e-3 * 0.2e-3**2), rel=1e-3)
