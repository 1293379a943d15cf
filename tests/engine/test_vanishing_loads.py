"""A load, or a temperature, that does nothing leaves each number and its range as they were."""

import pytest
import yaml

import flexcli

MATERIAL = {"name": "m", "youngs_modulus": "114 GPa", "poisson_ratio": 0.3,
            "density": "4430 kg/m^3", "yield_strength": "880 MPa",
            "thermal_expansion": "9e-6 1/K"}  # fmt: skip
STAGE = {"kind": "leaf-spring-stage", "h": "0.1 mm", "l": "20 mm", "b": "0.4 mm", "blades": 2,
         "spacing": "10 mm"}  # fmt: skip
HINGED = {"kind": "hinged-stage", "e": "0.1 mm", "r": "1 mm", "b": "5 mm", "l": "30 mm", "limbs": 2,
          "spacing": "30 mm", "blocks": "2 mm"}  # fmt: skip
TEMPERATURE = {"temperature": {"uniform": "1e-9 K"}}
ACCELERATION = {"acceleration": {"x": "1e-12 m/s^2"}}


def judged(geometry, requirements, case, **more):
    spec = {"flexure": 1, "title": "next to nothing", "material": MATERIAL, "geometry": geometry,
            "mechanism": {"kind": "payload", "mass": "0.1 kg"}, "cases": {"work": case},
            "requirements": requirements, **more}  # fmt: skip
    (check,) = (
        each for each in flexcli.verdicts(yaml.safe_dump(spec)).checks if each.kind is not None
    )
    return check


@pytest.mark.parametrize("more", [TEMPERATURE, ACCELERATION], ids=["temperature", "acceleration"])
def test_a_deflection_at_a_stroke_keeps_its_range(more):
    case = {"stroke": {"translation": "0.5 mm"}, "wrench": {"x": "0.01 N"}}
    asked = {"deflection": {"direction": "x", "max": "1.0e-6 m"}}
    alone = judged(STAGE, asked, case)
    assert alone.factor_range[1] < 1.1 * alone.factor_range[0]
    both = judged(STAGE, asked, {**case, **more})
    assert both.factor_range == pytest.approx(alone.factor_range, rel=1e-3)
    assert both.verdict is alone.verdict


def test_what_a_temperature_strains_counts_in_it():
    case = {"stroke": {"translation": "0.5 mm"}, "wrench": {"x": "0.01 N"}}
    asked = {"deflection": {"direction": "x", "max": "1.0e-6 m"}}
    alone = judged(STAGE, asked, case)
    strained = {"temperature": {"bodies": {"moving": "200 K"}}}
    low, high = judged(STAGE, asked, {**case, **strained}).factor_range
    assert high - low > 1.05 * (alone.factor_range[1] - alone.factor_range[0])


def test_the_drive_of_hinges_keeps_its_range_beside_a_force_out_of_its_plane():
    case = {"stroke": {"translation": "0.05 mm"}}
    asked = {"drive": {"factor": 1.2}}
    actuator = {"blocking_force": "10 N", "free_stroke": "1 mm", "drives": "both-ways"}
    alone = judged(HINGED, asked, case, actuator=actuator)
    both = judged(HINGED, asked, {**case, "wrench": {"z": "1e-9 N"}}, actuator=actuator)
    assert both.factor_range == pytest.approx(alone.factor_range, rel=1e-6)
    pulled = judged(HINGED, asked, {**case, "wrench": {"z": "5 N"}}, actuator=actuator)
    assert pulled.factor_range[0] < alone.factor < pulled.factor_range[1]
    assert pulled.factor_range[1] - pulled.factor_range[0] > (
        alone.factor_range[1] - alone.factor_range[0]
    )


def test_a_joint_of_a_crystal_keeps_its_stiffness_beside_a_force_out_of_its_plane():
    crystal = {"name": "silicon", "density": "2330 kg/m^3", "tensile_strength": "300 MPa",
               "crystal": {"c11": "165.7 GPa", "c12": "63.9 GPa", "c44": "79.6 GPa"},
               "orientation": {"wafer": "111"}}  # fmt: skip
    asked = {"stiffness": {"min": "1 N/m"}}
    alone, both = (
        judged(HINGED, asked, case, material=crystal)
        for case in ({"wrench": {"x": "1 N"}}, {"wrench": {"x": "1 N", "z": "1e-9 N"}})
    )
    assert both.factor_range == pytest.approx(alone.factor_range, rel=1e-9)


def linkage():
    """Return a crank, a rod and a stage on wide crossed blades; one joint hardly turns."""
    pivot = {"kind": "cross-spring", "delta": -0.5, "half_angle": "45 deg", "h": "0.3 mm",
             "l": "8 mm", "b": "14 mm"}  # fmt: skip
    at = {"theta": ["0 mm", "0 mm"], "beta": ["0 mm", "24 mm"], "alpha": ["-24 mm", "24 mm"]}
    links = {"theta": ["crank", "base"], "beta": ["rod", "crank"], "alpha": ["rod", "stage"]}
    joints = {name: {"links": links[name], "at": at[name], "flexure": pivot} for name in at}
    joints["z"] = {"links": ["base", "stage"], "along": [1, 0]}
    return {"kind": "linkage", "ground": "base", "input": "theta", "joints": joints}


def test_the_mean_of_a_stroke_counts_wide_blades_beside_a_moment_along_it():
    def yields(**more):
        spec = {"flexure": 1, "title": "linkage", "material": MATERIAL, "geometry": linkage(),
                "cases": {"work": {"stroke": {"rotation": "0.15 rad"}, **more}},
                "requirements": {"yield": 1.0}}  # fmt: skip
        found = flexcli.verdicts(yaml.safe_dump(spec), model="exact").checks
        return {check.name: check for check in found if check.kind is not None}

    alone, both = yields(), yields(wrench={"theta_z": "1e-15 N*m"})
    for name, check in alone.items():
        assert both[name].factor_range[0] <= check.factor_range[0] * (1.0 + 1e-3)


CROSSED = {"kind": "star", "h": "0.066 mm", "l": "1.5 mm", "b": "4.5 mm", "p": "-1.25 mm",
           "angles": ["25 deg", "273 deg"]}  # fmt: skip


def test_what_nobody_knows_is_not_as_sure_as_its_model():
    """Limbs of no stated mass weigh an unknown amount: it was told within 2 % what buckles them."""
    case = {"acceleration": {"level": "1 g", "axis": "y"}, "ends": "clamped-guided"}
    unknown = judged(HINGED, {"buckling": {"factor": 2}}, case)
    assert (unknown.verdict.value, unknown.factor_range) == ("undecided", None)
    limb = {"mass": "2 g", "inertia": "2e-7 kg*m^2"}
    known = judged({**HINGED, "limb": limb}, {"buckling": {"factor": 2}}, case)
    assert known.factor_range[0] > 0.9 * known.factor


BLADE = {"kind": "moment-blade", "h": "0.75 mm", "l": "7 mm", "b": "21 mm"}


@pytest.mark.parametrize(("force", "verdict"), [(0.85, "pass"), (-0.85, "fail")])
def test_a_wrench_buckles_as_it_is_stated_beside_a_temperature_too(force, verdict):
    """Pulled it bears 230 times as much, pushed 180: it leans away, past no critical point."""
    case = {"wrench": {"x": f"{force} N"}, "ends": "clamped-pinned"}
    asked = {"buckling": {"factor": 190}}
    alone, both = (judged(CROSSED, asked, {**case, **more}) for more in ({}, TEMPERATURE))
    assert (alone.verdict.value, both.verdict.value) == (verdict, verdict)


@pytest.mark.parametrize("asked", [100, 170, 240, 280, 450])
def test_no_share_passes_what_a_force_alone_fails(asked):
    case = {"wrench": {"x": "-0.85 N"}, "ends": "clamped-pinned"}
    needs = {"buckling": {"factor": asked}}
    alone, both = (judged(CROSSED, needs, {**case, **more}) for more in ({}, TEMPERATURE))
    assert {alone.verdict.value, both.verdict.value} != {"pass", "fail"}


def test_a_force_across_a_blade_alone_pushes_it_by_no_more_than_what_is_along_it():
    """What holds its end bears the rest: 8 kN across, 12 N along, of which it yields at 13.9 kN."""
    case = {"wrench": {"y": "8000 N", "x": "-12 N"}, "ends": "clamped-clamped"}
    check = judged(BLADE, {"buckling": {"factor": 2}}, case)
    assert check.verdict.value == "pass"
    along = judged(BLADE, {"buckling": {"factor": 2}}, {**case, "wrench": {"x": "-8000 N"}})
    assert along.verdict.value == "fail"
    assert 1.6 < along.factor < 880e6 * 0.75e-3 * 21e-3 / 8000.0
