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
