"""The swing of a stress over a reversing stroke, by exact beams in space."""

import pytest
import yaml

import flexcli

E, G, L, BORNE = 100e9, 100e9 / 2.6, 50e-3, 300e6


def factor(members, motion, stroke, **wrench):
    """Return the factor of a fatigue strength on the swing of a stroke by exact beams."""
    fatigue = {"value": f"{BORNE} Pa", "cycles": 1e7, "stress_ratio": -1}
    material = {"youngs_modulus": f"{E} Pa", "poisson_ratio": 0.3, "yield_strength": "1 GPa",
                "tensile_strength": "1.1 GPa", "fatigue_amplitude": fatigue}  # fmt: skip
    beside = {"wrench": wrench} if wrench else {}
    body = {"at": ["0 mm", "0 mm", "50 mm"]}
    spec = {
        "flexure": 1, "material": material,
        "geometry": {"kind": "space-layout", "bodies": {"top": body}, **members, "moving": "top",
                     "motion": motion},
        "cases": {"work": {"stroke": {**stroke, "cycles": 1e6}, **beside}},
        "requirements": {"fatigue": {"factor": 1.5, "mean_stress": "none"}},
    }  # fmt: skip
    checks = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
    (check,) = (each for each in checks if each.name.startswith("fatigue"))
    return check.factor


def member(at, **sizes):
    """Return a member from the ground to the body, along z at x [mm]."""
    ends = {"from": [f"{at} mm", "0 mm", "0 mm"], "to": [f"{at} mm", "0 mm", "50 mm"]}
    return {"between": ["ground", "top"], **ends, **sizes}


def test_rods_bent_to_and_fro_swing_by_all_of_their_stress():
    d, moved = 1e-3, 0.1e-3
    rods = {"rods": {"one": member(20, d="1 mm", repeat={"count": 3, "about": "z"})}}
    told = factor(rods, {"translation": "x"}, {"translation": f"{moved} m"})
    # 3 E d δ/l², less their shear and the tilt of the body by their stretching
    assert told == pytest.approx(BORNE / (3.0 * E * d * moved / L**2), rel=0.03)


@pytest.mark.parametrize(
    ("kind", "sizes", "tau_of_thickness"),
    [("rods", {"d": "1 mm"}, 0.5), ("blades", {"h": "1 mm", "b": "1 mm", "width": "x"}, 0.675)],
)
def test_what_is_twisted_to_and_fro_swings_by_all_of_its_stress(kind, sizes, tau_of_thickness):
    turned = 0.01
    told = factor({kind: {"one": member(0, **sizes)}}, {"rotation": {"about": "z"}},
                  {"rotation": f"{turned} rad"})  # fmt: skip
    # τ = k G h φ', k of Saint-Venant
    stress = 3.0**0.5 * tau_of_thickness * G * 1e-3 * turned / L
    assert told == pytest.approx(BORNE / stress, rel=0.01)


def test_a_steady_torque_does_not_swing_where_the_normal_stress_changes_sign():
    """Two bars twisted by 0.3 N·mm: it told 2.5 times the amplitude of the stroke alone."""
    size = {"h": "0.8 mm", "b": "1.1 mm", "width": [1, -1.3, 0]}
    ends = {"from": ["0 mm", "15 mm", "0 mm"], "to": ["0 mm", "15 mm", "50 mm"]}
    blade = {"between": ["ground", "top"], **ends, **size, "mirror": ["y"]}
    stroke = {"translation": ["3.15 um", "6.3 um"]}
    alone, beside = (
        factor({"blades": {"one": blade}}, {"translation": "y"}, stroke, **loads)
        for loads in ({}, {"theta_z": "0.3 N*mm", "z": "0.36 N"})
    )
    assert beside == pytest.approx(alone, rel=0.02)
