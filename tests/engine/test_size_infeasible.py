"""Conflicts: the smallest set, and every proposed relaxation is applied and does."""

import re

import numpy as np
import pytest
from judging import size_as_printed
from strategies import CASES, LOADS, PUSH, Inconsistent, crossed, design, rcc, three_blade

from flexcli.engine import assess

TARGETS = {
    "mechanism": {"kind": "payload", "mass": "0.8 kg", "inertia": "1.72e-4 kg*m^2"},
    "material": {"youngs_modulus": "116 GPa"},
}
WEIGHT = {"mercury": {"acceleration": {"level": "3.7 m/s^2", "axis": "z"}}}


def conflict_of(spec):
    result = size_as_printed(spec, "spec")
    assert result.status.value == "infeasible"
    assert result.checks == ()
    return result.sizing


def proposed(text):
    """Return the value that a relaxation proposes, as it is printed."""
    return re.fullmatch(r".* → (.*)", text).group(1)


def two_percent(printed, side):
    """Return a printed value moved by 1 % against (side = −1) or along the relaxation."""
    number, _, unit = printed.partition(" ")
    return f"{float(number) * (1 + 0.01 * side)!r} {unit}".strip()


def spec_of(**changes):
    """Three requirements that conflict in h, l and b; any of them replaced."""
    given = {"fatigue": "2.5", "buckling": "2.5", "l": "8 mm", "b": "5 mm"} | changes
    given = {k: v.replace("µ", "u") for k, v in given.items()}
    geometry = rcc(l={"free": ["1 mm", given["l"]]}, b={"free": ["1 mm", given["b"]]})
    requirements = {"fatigue": float(given["fatigue"]), "buckling": float(given["buckling"])}
    cases = {"bend": {"stroke": {"rotation": "4 deg", "cycles": 1e7}}, "push": PUSH}
    return design(geometry, requirements, cases)


def test_the_smallest_conflict_is_named_and_proved():
    sizing = conflict_of(spec_of())
    assert {r.name.split(",")[0].split(":")[0] for r in sizing.conflict} == {
        "fatigue", "buckling", "most l", "most b",
    }  # fmt: skip
    assert sizing.certificate == "no smaller set conflicts"


@pytest.mark.parametrize(
    ("name", "key", "tighter"),
    [("fatigue", "fatigue", 1), ("buckling", "buckling", 1), ("most l", "l", -1),
     ("most b", "b", -1)],
)  # fmt: skip
def test_each_proposed_relaxation_does_and_one_percent_less_does_not(name, key, tighter):
    sizing = conflict_of(spec_of())
    (found,) = (r for r in sizing.conflict if r.name.startswith(name))
    value = proposed(found.text)
    assert size_as_printed(spec_of(**{key: value}), "spec").status.value == "pass"
    assert (
        size_as_printed(spec_of(**{key: two_percent(value, tighter)}), "spec").status.value
        == "infeasible"
    )


def test_a_single_requirement_can_conflict_with_the_given_sizes():
    def spec(factor=2.5):
        asked = {"fatigue": factor, "yield": {"factor": 1, "cases": ["push"]}}
        return design(rcc(h="1 mm", l="5 mm"), asked)

    (found,) = conflict_of(spec()).conflict
    assert found.name.startswith("fatigue")
    # both ends of the blade are eased together, as the spec states one factor
    factor = float(proposed(found.text))
    assert size_as_printed(spec(factor), "spec").status.value == "pass"
    assert size_as_printed(spec(factor * 1.01), "spec").status.value == "infeasible"


def test_two_bounds_that_exclude_each_other_are_the_conflict():
    def spec(most="20", least="50 mm"):
        geometry = rcc(h={"free": [None, "1 mm"]}, l={"free": [least, None]})
        return design(geometry, {"l/h": {"max": float(most)}})

    sizing = conflict_of(spec())
    assert len(sizing.conflict) == 3  # most h, least l and l/h
    texts = {r.name: proposed(r.text) for r in sizing.conflict}
    assert set(texts) == {"most h", "least l", "l/h (max): l/h"}
    assert float(texts["l/h (max): l/h"]) == pytest.approx(50.0, rel=1e-3)
    assert texts["least l"] == "20 mm" or texts["least l"] == "19.99 mm"
    with pytest.raises(Exception, match="without limit"):
        size_as_printed(spec(most=texts["l/h (max): l/h"]), "spec")  # feasible, and nothing holds b


@pytest.mark.parametrize(
    ("bounds", "direction"),
    [({"h": {"free": ["0.3 mm", "1 mm"]}}, +1), ({"h": {"free": ["0.1 mm", "0.2 mm"]}}, -1)],
)
def test_a_target_is_moved_to_the_side_that_does(bounds, direction):
    def spec(frequency="10 Hz", sag="645 nm"):
        asked = {"sag": {"equals": sag}, "frequency": {"equals": frequency}}
        return design(three_blade(l="80 mm", **bounds), asked, WEIGHT, **TARGETS)

    sizing = conflict_of(spec())
    texts = {r.name.split(" ")[0]: proposed(r.text).replace("µ", "u") for r in sizing.conflict}
    for key, given in (("frequency", 10.0), ("sag", 645e-9)):
        number, unit = texts[key].split(" ")
        value = float(number) * {"Hz": 1, "mHz": 1e-3, "nm": 1e-9, "um": 1e-6}[unit]
        assert (value > given) == (direction > 0)
        assert size_as_printed(spec(**{key: texts[key]}), "spec").status.value == "pass"
        less = f"{float(number) * (1 - 0.01 * direction)!r} {unit}"
        assert size_as_printed(spec(**{key: less}), "spec").status.value == "infeasible"


def test_a_bound_given_raised_to_a_power_is_relaxed_in_its_own_unit():
    def spec(least="50 Hz"):
        sizes = {"h": {"free": ["50 um", "0.2 mm"]}, "b": {"free": ["1 mm", "10 mm"]}}
        asked = {"frequency": {"min": least}}
        return design(three_blade(l="80 mm", **sizes), asked, WEIGHT, **TARGETS)

    (found,) = (r for r in conflict_of(spec()).conflict if r.name.startswith("frequency"))
    value = proposed(found.text)
    assert size_as_printed(spec(value), "spec").status.value == "pass"
    assert size_as_printed(spec(two_percent(value, 1)), "spec").status.value == "infeasible"


@pytest.mark.slow
def test_a_conflict_of_rows_that_are_not_convex_is_said_to_be_unproved():
    def spec(factor=2.5):
        sizes = {"l": {"free": ["3 mm", "5 mm"]}, "h": {"free": ["0.9 mm", "2 mm"]}, "b": "5 mm"}
        return design(crossed(p="-2 mm", **sizes), {"fatigue": factor})

    sizing = conflict_of(spec())
    assert "not proved" in sizing.certificate
    (found,) = (r for r in sizing.conflict if r.name.startswith("fatigue"))
    factor = float(proposed(found.text))
    assert size_as_printed(spec(factor), "spec").status.value == "pass"
    # of all designs between the bounds none has one per cent more
    h, l = np.linspace(0.9e-3, 2e-3, 50)[:, None], np.linspace(3e-3, 5e-3, 3000)
    margins = assess.factors(spec(factor), h=h, l=l, b=np.array(5e-3))["fatigue, bend"]
    # the grid misses the crest by half a step
    assert 0.999 < margins.max() < 1.01


def test_several_conflicts_are_not_mistaken_for_one():
    geometry = rcc(h="1 mm", l="5 mm", b={"free": ["1 mm", "1.5 mm"]})
    cases = CASES | {"push": PUSH | {"load": {"force": "64 kN"}}}
    sizing = conflict_of(design(geometry, LOADS, cases))
    for relaxation in sizing.conflict:
        assert relaxation.factor is None
        assert "others remain" in relaxation.text


def test_specs_that_contradict_themselves_are_refused_before_sizing():
    with pytest.raises(ValueError, match="lower bound"):
        design(rcc(h={"free": ["2 mm", "1 mm"]}), LOADS)
    with pytest.raises(Inconsistent):
        design(rcc(), {"fatigue": 2}, {"push": PUSH})
