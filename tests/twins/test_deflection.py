"""Deflections under a wrench that nearly buckles, and at a stroke, against beam columns."""

from math import pi, sqrt, tan, tanh

import pytest

from twins.verdicts import checked

E, H, B, L = 114e9, 0.1e-3, 1e-3, 20e-3
EI = E * B * H**3 / 12.0

PLATE = 0.02
"""What clamps make a blade of b/l = 0.05 stiffer than a beam, at most, and as much again."""


def spec(kind, case, limit, direction="x"):
    sizes = {"kind": kind, "h": f"{H} m", "b": f"{B} m", "l": f"{L} m"}
    return {
        "flexure": 1,
        "title": "loaded across and along",
        "material": {
            "name": "m", "youngs_modulus": f"{E} Pa", "poisson_ratio": 0.34,
            "density": "4430 kg/m^3", "yield_strength": "880 MPa",
        },
        "geometry": sizes,
        "cases": {"work": case},
        "requirements": {"deflection": {"direction": direction, "max": f"{limit!r} m"}},
    }  # fmt: skip


def columns(share, across):
    """Return the tip's deflections of a cantilever under a force of a share of Euler's, ±."""
    force = share * pi**2 * EI / (4.0 * L**2)
    u = sqrt(force / EI) * L
    return force, across / force * L * (tan(u) / u - 1.0), across / force * L * (1 - tanh(u) / u)


@pytest.mark.parametrize("share", [0.05, 0.3, 0.6])
def test_a_force_along_a_cantilever_that_may_push_makes_more_of_its_deflection(share):
    across = 1e-5
    force, pushed, pulled = columns(share, across)
    assert pulled < across * L**3 / (3.0 * EI) < pushed
    wrench = {"wrench": {"x": f"{across} N", "y": f"{force} N"}}
    error = PLATE / (1.0 - share)
    small = checked(spec("cantilever", wrench, pushed * (1.0 - 3.0 * error)), "deflection")
    assert small.verdict == "fail", small
    wide = checked(spec("cantilever", wrench, pushed * (1.0 + 4.0 * error)), "deflection")
    assert wide.verdict == "pass", wide


def test_a_stroke_far_below_a_thickness_changes_no_deflection_out_of_the_plane():
    """k_z of a cantilever that bends across its width: 3 E I_z/l³, with shear below 1 %."""
    case = {"stroke": {"translation": "0.2 um"}, "wrench": {"z": "0.01 N"}}
    bent = 0.01 * L**3 / (3.0 * E * H * B**3 / 12.0)
    for limit, verdict in ((0.96 * bent, "fail"), (1.04 * bent, "pass")):
        said = checked(spec("cantilever", case, limit, "z"), "deflection")
        assert said.verdict == verdict, said


def test_a_stroke_of_many_thicknesses_softens_a_stage_along_its_blades():
    """Blades bent by w pull straight: w²/h² counts beside one, far more than what is asked."""
    case = {"stroke": {"translation": "1 mm"}, "wrench": {"y": "1 mN"}}
    straight = 1e-3 * L / (2.0 * E * B * H)
    stage = spec("leaf-spring-stage", case, 2.0 * straight, "y")
    stage["geometry"] |= {"blades": 2, "spacing": "20 mm"}
    assert checked(stage, "deflection").verdict != "pass"


@pytest.mark.parametrize("kind", ["cantilever", "rcc", "guided-blade"])
def test_no_load_in_the_plane_of_a_joint_moves_it_out_of_it(kind):
    """By symmetry, at its stroke as at rest."""
    stroke = {"rotation": "5 mrad"} if kind == "rcc" else {"translation": "0.1 mm"}
    found = spec(kind, {"stroke": stroke, "wrench": {"y": "1 uN"}}, 1e-12, "z")
    found["geometry"] |= {"p": "2 mm", "half_angle": "40 deg"} if kind == "rcc" else {}
    said = checked(found, "deflection")
    assert said.verdict == "pass", said


def test_a_wrench_that_may_buckle_the_joint_fails_its_deflection():
    """A pull of Euler's load of the cantilever and a quarter more: a wrench acts either way."""
    force = 1.25 * pi**2 * EI / (4.0 * L**2)
    shortens = force * L / (E * B * H)
    case = {"wrench": {"y": f"{-force} N"}}
    said = checked(spec("cantilever", case, 2.0 * shortens, "y"), "deflection")
    assert said.verdict == "fail", said
    assert said.factors == (pytest.approx(0.8, rel=PLATE),)


@pytest.mark.parametrize("share", [0.3, 0.6])
def test_a_body_that_stands_on_its_blade_sags_across_as_a_beam_column_does(share):
    """A mass at the tip, shaken along and across at once by no more than a sag is asked along."""
    found = spec("cantilever", {"acceleration": {"level": "1 m/s^2", "axis": "y"}}, 1.0)
    mass = share * pi**2 * EI / (4.0 * L**2)
    found["mechanism"] = {"kind": "payload", "mass": f"{mass} kg"}
    shortens = mass * L / (E * B * H)
    for limit, verdict in ((0.98, "fail"), (1.02, "pass")):
        found["requirements"] = {"sag": {"max": f"{limit * shortens!r} m"}}
        said = checked(found, "sag")
        assert said.verdict == verdict, said


def test_a_body_too_heavy_to_stand_on_its_blade_fails_its_sag():
    """An acceleration acts either way; near Euler's load nobody is sure that the blade stands."""
    for share, verdict in ((0.75, "pass"), (0.97, "undecided"), (1.5, "fail")):
        found = spec("cantilever", {"acceleration": {"level": "1 m/s^2", "axis": "y"}}, 1.0)
        mass = share * pi**2 * EI / (4.0 * L**2)
        found["mechanism"] = {"kind": "payload", "mass": f"{mass} kg"}
        found["requirements"] = {"sag": {"max": f"{1.1 * mass * L / (E * B * H)!r} m"}}
        said = checked(found, "sag")
        assert said.verdict == verdict, said


def test_a_deflection_along_bent_blades_is_decided_by_the_tangent_at_the_stroke():
    """x/l = p h²/(12 l²) − 3 w²/(5 l²) + p w²/(700 l²) of guided blades, and f = (12 + 6 p/5) w/l.

    p and f over EI/l² of each; with f held, p moves w by −w/10 (Awtar et al. 2007).
    """
    w = 3e-4
    straight = 1e-3 * L / (2.0 * E * B * H)
    bent = 1e-3 * w**2 * L * (0.12 + 1.0 / 700.0) / (2.0 * EI)
    assert bent > 10.0 * straight
    case = {"stroke": {"translation": f"{w} m"}, "wrench": {"y": "1 mN"}}
    for limit, verdict in ((0.92, "fail"), (1.08, "pass")):
        stage = spec("leaf-spring-stage", case, limit * (straight + bent), "y")
        stage["geometry"] |= {"blades": 2, "spacing": "20 mm"}
        said = checked(stage, "deflection")
        assert said.verdict == verdict, said
