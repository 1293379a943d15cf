"""What a plan tells of a vibration besides its modes: the inside of blades, and stops that give."""

from pathlib import Path

import numpy as np
import pytest
import yaml

import flexcli

EXAMPLE = Path(__file__).parents[2] / "examples" / "boundary-control" / "flexure.yaml"
E, RHO = 71.7e9, 2810.0


def rows(source):
    return {row.name: row for row in flexcli.plan(source).effects}


def leaves(h):
    return yaml.safe_dump(
        {
            "flexure": 1,
            "material": {"youngs_modulus": f"{E} Pa", "density": f"{RHO} kg/m^3",
                         "poisson_ratio": 0.33, "yield_strength": "500 MPa"},
            "geometry": {"kind": "leaf-spring-stage", "h": f"{h} m", "l": "60 mm", "b": "15 mm",
                         "spacing": "20 mm"},
            "mechanism": {"kind": "payload", "mass": "50 g"},
            "cases": {"launch": {"asd": {"profile": "gevs-acceptance", "q": 20, "axis": "x"}}},
            "requirements": {"dynamic-yield": 1.25},
        }
    )  # fmt: skip


@pytest.mark.parametrize("h", [0.1e-3, 0.3e-3])
def test_blades_move_inside_from_the_frequency_of_one_between_held_ends(h):
    found = rows(leaves(h))["blade modes, launch"]
    beam = 22.3733 / (2 * np.pi) * h / np.sqrt(12.0) / 60e-3**2 * np.sqrt(E / RHO)
    # up to 1/√(1 − ν²) as a plate, and a little less where the stage gives
    assert 0.98 * beam < found.indicator < 1.06 * beam
    assert 0.0 < found.estimate < 1.0


def test_a_ball_gives_by_hertz_at_the_force_of_statics():
    found = rows(EXAMPLE)["end stops, contact"]
    place = flexcli.stops(EXAMPLE, simulate=False).stops.chosen
    modulus, radius = 53.2e9, 50e-3  # of the contact, as chapter 9 has them
    deep = (9.0 * place.R_stop**2 / (16.0 * radius * modulus**2)) ** (1.0 / 3.0)
    assert found.indicator == pytest.approx(deep / place.delta_G, rel=2e-3)
    assert found.estimates["travel"] < 0.012, "less than the run between both contacts tells"


def shaken(accuracy, **more):
    cases = {"launch": {"asd": {"profile": "gevs-qualification", "q": 20}}}
    spec = yaml.safe_load(leaves(0.3e-3)) | {"cases": cases, "accuracy": accuracy} | more
    return yaml.safe_dump(spec)


def test_the_plan_of_a_response_takes_the_cheapest_model_within_the_accuracy():
    (rough,) = flexcli.plan(shaken("20 %")).plan.scenes
    assert rough.model == "modes, closed-form"
    assert rough.estimated_error <= 0.2
    # the stage swings below the band, where Miles has nothing; no finer model is asked
    assert [row.name for row in rough.models] == ["modes, closed-form"]
    (fine,) = flexcli.plan(shaken("0.001 %")).plan.scenes
    names = ["modes, closed-form", "modes, linear", "modes, exact"]
    assert [row.name for row in fine.models] == names
    assert [row.cost for row in fine.models] == sorted(row.cost for row in fine.models)
    assert fine.estimated_error == min(row.error for row in fine.models)


def test_the_plan_takes_miles_where_his_formula_is_accurate_enough():
    stiffer = yaml.safe_load(shaken("20 %"))
    stiffer["geometry"]["h"] = "1 mm"
    (planned,) = flexcli.plan(yaml.safe_dump(stiffer)).plan.scenes
    assert planned.model == "Miles"
    assert [row.name for row in planned.models] == ["Miles"], "no finer asked"


@pytest.mark.parametrize("h", ["0.3 mm", "1 mm"])  # below the band, and in it
def test_a_plan_has_the_error_that_judges_the_response(h):
    source = yaml.safe_load(shaken("20 %"))
    source["geometry"]["h"] = h
    source = yaml.safe_dump(source)
    (planned,) = flexcli.plan(source).plan.scenes
    (check,) = (c for c in flexcli.check(source).checks if c.name == "dynamic yield")
    low, high = (end / check.factor - 1.0 for end in check.factor_range)
    ends = 1.0 / (1.0 + low) - 1.0, 1.0 / (1.0 + high) - 1.0
    assert planned.estimated_error == pytest.approx(max(map(abs, ends)), rel=1e-9)


def test_a_response_is_by_the_model_of_its_plan():
    found = flexcli.asd_response(shaken("0.001 %"))
    (planned,) = flexcli.plan(shaken("0.001 %")).plan.scenes
    named = planned.model.removeprefix("modes, ")
    other = flexcli.asd_response(shaken("20 %", model=named))
    assert found.values["f_1_launch"].value == other.values["f_1_launch"].value


def test_stops_are_planned_by_the_contacts_that_judge_them():
    (planned,) = flexcli.plan(EXAMPLE).plan.scenes
    names = ["operating line", "rigid contact", "linear contact", "Hertz contact"]
    assert [row.name for row in planned.models] == names
    errors = [row.error for row in planned.models]
    assert errors == sorted(errors, reverse=True)
