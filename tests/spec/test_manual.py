"""``explain`` as the manual of the spec: each piece of YAML is one that a whole spec takes."""

import copy
import json
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

from flexcli.errors import SpecError
from flexcli.parts.effects import EFFECTS
from flexcli.results.explanation import FieldRow
from flexcli.spec.load import load
from flexcli.spec.manual import entries, names
from flexcli.spec.parse import parse_document
from flexcli.spec.read import read_document
from flexcli.spec.schema import json_schema
from flexcli.spec.sketches import AXES

ROOT = Path(__file__).parent.parent.parent
WHOLE = [
    read_document(path).value
    for path in (
        ROOT / "examples" / "rocket-parallel-stage" / "flexure.yaml",
        ROOT / "examples" / "boundary-control" / "flexure.yaml",
        ROOT / "examples" / "force-balanced-stage" / "flexure.yaml",
        ROOT / "examples" / "folded-stage" / "flexure.yaml",
        ROOT / "examples" / "piezo-nanopositioner" / "flexure.yaml",
    )
]
"""Specs whose sections the manual's take the place of."""
BARE = {"flexure": 1, "material": "ti-6al-4v", "requirements": {"l/h": {"min": 1}}}
TURNS = {"kind": "rcc", "p": "2 mm", "half_angle": "45 deg", "h": "0.2 mm", "l": "20 mm",
         "b": "5 mm"}  # fmt: skip
SLIDES = {"kind": "leaf-spring-stage", "h": "0.2 mm", "l": "20 mm", "b": "5 mm", "spacing": "1 cm"}
WORN = {
    "youngs_modulus": "114 GPa",
    "tensile_strength": "950 MPa",
    "sn_amplitudes": {"basquin": {"coefficient": "2 GPa", "exponent": -0.08, "to_cycles": "1e7"}},
}
PAYLOAD = {"kind": "payload", "mass": "20 g", "inertia": "5e-6 kg*m^2"}
CASE = {
    "stroke": {"cycles": "1e6"},
    "load": {"force": "1 N"},
    "wrench": {"z": "3 N"},
    "acceleration": {"level": "9.81 m/s^2", "axis": "y"},
    "asd": {"profile": "gevs-qualification", "q": 100, "duration": "60 s"},
    "ends": "clamped-clamped",
}


def rows() -> list[FieldRow]:
    """Return every entry of the manual, each once."""
    return list({row.example: row for name in names() for row in entries(name)}.values())


def wholes(row: FieldRow) -> list[dict[str, Any]]:
    """Return specs with the YAML of an entry in its place."""
    piece = parse_document(row.example, "").value
    lasting = {"w": {"asd": CASE["asd"]}}
    found = [{**whole, **piece} for whole in WHOLE]
    found += [{**whole, "requirements": {"yield": 1.5}, **piece} for whole in WHOLE]
    found += [{**WHOLE[0], "material": WORN, "cases": lasting, **piece}]
    found += [{**WHOLE[0], "tolerances": {"youngs_modulus": "2 %"}, **piece}]
    shift = {"yield": 1.5, "parasitic_shift": {"max": "1 mm"}}
    found += [{**WHOLE[0], "requirements": shift, **piece}]
    for stroke in ({"rotation": "1 deg"}, {"translation": "10 um"}):
        found += [{**BARE, "requirements": {"mass": {"max": "1 kg"}}, "stroke": stroke, **piece}]
    for geometry, stroke in ((TURNS, "rotation"), (SLIDES, "translation")):
        size = {"rotation": "1 deg", "translation": "10 um"}[stroke]
        case = {**CASE, "stroke": {stroke: size, "cycles": "1e6"}}
        for chosen in (case, {"stroke": case["stroke"]}, {"wrench": case["wrench"]}):
            base = {**BARE, "geometry": geometry, "mechanism": PAYLOAD, "cases": {"w": chosen}}
            found += [base | piece, {k: v for k, v in base.items() if k != "mechanism"} | piece]
    return copy.deepcopy(found)


@pytest.fixture(scope="module")
def manual() -> list[FieldRow]:
    return rows()


@pytest.mark.slow
def test_each_piece_of_yaml_is_taken_by_a_whole_spec(
    manual: list[FieldRow], tmp_path: Path
) -> None:
    refused = []
    table = "frequency [Hz],level [g^2/Hz]\n20,0.01\n2000,0.01\n"
    (tmp_path / "psd.csv").write_text(table, encoding="utf-8")
    record = "time [s],acceleration [g]\n0,0\n0.001,3\n0.002,0\n"
    (tmp_path / "base.csv").write_text(record, encoding="utf-8")
    for row in filter(lambda row: row.example, manual):
        for spec in wholes(row):
            path = tmp_path / "spec.yaml"
            path.write_text(json.dumps(spec), encoding="utf-8")
            with suppress(SpecError):
                load(path)
                break
        else:
            refused.append(row.example)
    assert not refused


def test_every_key_kind_and_effect_has_an_entry() -> None:
    known = set(names())
    assert {effect.key for effect in EFFECTS} <= known
    assert set(AXES) <= known
    assert {"lock", "cases", "sag", "payload", "parallel-stage", "stops", "ball", "h"} <= known
    assert all(entries(name) for name in known)
    assert entries("no-such-key") == ()


@pytest.mark.parametrize("name", ["geometry.h", "cases.lock", "requirements.sag", "solid-2.com"])
def test_a_path_is_found_by_its_last_steps(name: str) -> None:
    last = name.rpartition(".")[2]
    assert all(row.path.endswith(last) for row in entries(name))
    assert 0 < len(entries(name)) <= len(entries(last))


@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("cases.<name>.lock", "cases.<name>.lock"),
        ("cases.launch.asd.q", "cases.<name>.asd.q"),
        ("cases.drop.shock.srs[1].frequency", "cases.<name>.shock.srs[].frequency"),
    ],
)
def test_a_path_is_found_as_findings_print_it(name: str, path: str) -> None:
    assert [row.path for row in entries(name)] == [path]


@pytest.mark.parametrize(("name", "key"), [("cases", "shock"), ("blades", "between")])
def test_what_has_names_of_a_specs_own_lists_the_keys_of_each(name: str, key: str) -> None:
    assert any(key in {each.name for each in row.keys} for row in entries(name))


def test_the_axes_of_every_kind_of_geometry_are_drawn() -> None:
    geometry = json_schema("design")["$defs"]
    kinds = {
        part["properties"]["kind"]["const"]
        for name, part in geometry.items()
        if "kind" in part.get("properties", {})
    }
    for kind in AXES:
        (entry,) = (row for row in entries(kind) if row.path == "geometry")
        assert max(map(len, entry.axes.splitlines())) <= 80
    assert set(AXES) <= kinds


def test_an_entry_says_units_default_and_whether_it_must_be_given() -> None:
    (lock,) = entries("cases.lock")
    assert (lock.written, lock.default, lock.required) == ("a text", "", False)
    (height,) = entries("mechanism.height")
    assert "um, mm, cm, m" in height.written
    assert height.required
    (sigma,) = entries("cases.asd.sigma")
    assert sigma.default == "3"
