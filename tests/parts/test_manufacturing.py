"""What a process can make holds every design: what is below a limit fails by its name."""

import pytest
import yaml

import flexcli
from flexcli.errors import SpecError
from flexcli.results import Status, Verdict

STAGE = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "10 mm", "spacing": "5 mm"}
HINGE = {"kind": "notch-hinge", "e": "0.1 mm", "r": "1 mm", "b": "5 mm"}
DRAWN = {
    "kind": "layout",
    "bodies": {"stage": {"at": ["0 mm", "10 mm"]}},
    "blades": {
        "table": {
            "between": ["ground", "stage"], "from": ["0 mm", "0 mm"], "to": ["0 mm", "20 mm"],
            "b": "5 mm", "profile": {"kind": "tabulated", "at": [0, 0.5, 1],
                                     "h": ["0.3 mm", "0.05 mm", "0.3 mm"]},
        },
        "round": {
            "between": ["ground", "stage"], "from": ["9 mm", "0 mm"], "to": ["9 mm", "20 mm"],
            "b": "5 mm", "profile": {"kind": "filleted", "h": "0.2 mm", "r": "0.1 mm"},
        },
    },
    "moving": "stage",
    "motion": {"translation": "0 deg"},
}  # fmt: skip


def text(geometry, stroke="translation: 0.1 mm", **manufacturing):
    name, _, value = stroke.partition(": ")
    return yaml.safe_dump(
        {
            "flexure": 1,
            "material": {"youngs_modulus": "200 GPa", "yield_strength": "1 GPa",
                         "poisson_ratio": 0.3},
            "geometry": geometry,
            "stroke": {name: value},
            "requirements": {"yield": 1.0},
            "manufacturing": {"process": "wire-edm", **manufacturing},
        }
    )  # fmt: skip


@pytest.mark.parametrize(
    ("geometry", "key", "limit", "found", "factor"),
    [
        (STAGE, "least_thickness", "0.25 mm", "least thickness", 0.8),
        (STAGE, "aspect", 40, "aspect", 0.8),
        (STAGE, "least_gap", "6 mm", "least gap", 4.8 / 6.0),
        ({**STAGE, "root_radius": "0.1 mm"}, "least_radius", "0.2 mm", "least radius", 0.5),
        ({**STAGE, "clamps": "monolithic"}, "least_radius", "0.2 mm", "least radius", 0.0),
        (DRAWN, "least_thickness", "0.1 mm", "least thickness", 0.5),
        (DRAWN, "least_radius", "0.2 mm", "least radius", 0.5),
    ],
)
def test_what_is_beyond_a_limit_fails_and_names_it(geometry, key, limit, found, factor):
    result = flexcli.check(text(geometry, **{key: limit}))
    (check,) = (check for check in result.checks if check.name == found)
    assert check.verdict is Verdict.FAIL
    assert result.status is Status.FAIL
    assert check.factor == pytest.approx(factor)
    assert f"manufacturing.{key}" in check.quantity
    assert check.source == "wire-edm"


def test_the_radius_of_a_notch_and_what_is_clamped_pass():
    turn = "rotation: 0.1 deg"
    assert flexcli.check(text(HINGE, turn, least_radius="0.9 mm")).status is Status.PASS
    assert flexcli.check(text(HINGE, turn, least_radius="1.1 mm")).status is Status.FAIL
    clamped = flexcli.check(text(STAGE, least_radius="0.2 mm", least_thickness="0.1 mm"))
    assert [check.name for check in clamped.checks] == ["least thickness", "yield (yield-strength)"]
    assert clamped.status is Status.PASS


def test_sizing_keeps_the_limits_or_proves_that_it_cannot():
    free = {**STAGE, "h": "free", "l": "free"}
    found = flexcli.size(text(free, least_thickness="0.25 mm", aspect=38))
    assert found.status is Status.PASS
    assert found.values["h"].value == pytest.approx(10e-3 / 38)
    rough = flexcli.size(text({**free, "root_radius": "0.1 mm"}, least_radius="0.2 mm"))
    assert rough.status is Status.INFEASIBLE


def test_a_process_alone_states_nothing_and_is_refused():
    with pytest.raises(SpecError, match="no limit of the process"):
        flexcli.check(text(STAGE))
