"""Pydantic's errors as findings: every type of error, hints, and no step of pydantic's own."""

from typing import Any

import pytest
from pydantic import BaseModel, TypeAdapter, ValidationError

from flexcli.errors import Finding, SpecError
from flexcli.parts.design import DesignSpec
from flexcli.parts.named import marked
from flexcli.spec.document import MAX_FINDINGS
from flexcli.spec.findings import findings_of, nearest, path_text
from flexcli.spec.load import KINDS
from flexcli.spec.parse import parse_document

DESIGN = """
flexure: 1
material: {youngs_modulus: 113.8 GPa, fatigue_amplitude: {value: 510 MPa}}
geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: 0.1 mm, l: 10 mm, b: 5 mm}
cases:
  work:
    stroke: {rotation: 2 deg, cycles: 1e7}
requirements:
  fatigue: 1.5
"""


def findings(text: str, model: Any = DesignSpec) -> list[Finding]:
    document = parse_document(text, "spec.yaml")
    with pytest.raises(ValidationError) as raised:
        TypeAdapter(model).validate_python(document.value)
    return findings_of(raised.value, model, document)


def finding(text: str, model: Any = DesignSpec) -> Finding:
    (only,) = findings(text, model)
    return only


def changed(old: str, new: str) -> str:
    assert old in DESIGN
    return DESIGN.replace(old, new)


@pytest.mark.parametrize(
    ("word", "hint"),
    [
        ("fatige", "did you mean 'fatigue'?"),
        ("FATIGUE", "did you mean 'fatigue'?"),
        ("solid_1", "did you mean 'solid-1'?"),
        ("zzz", "one of: fatigue, solid-1"),
        ("x" * 100_000, "one of: fatigue, solid-1"),
    ],
)
def test_the_nearest_name_is_offered_or_all(word: str, hint: str) -> None:
    assert nearest(word, ["solid-1", "fatigue"]) == hint


def test_nothing_is_offered_where_there_is_nothing() -> None:
    assert nearest("word", []) == ""


def test_many_names_are_cut_short() -> None:
    assert nearest("zzz", [f"a{n:02d}" for n in range(50)]).endswith("a11, …")


@pytest.mark.parametrize(
    ("path", "text"),
    [
        ((), ""),
        (("a",), "a"),
        (("cases", "take-off", "asd", "points", 2, "level"), "cases.take-off.asd.points[2].level"),
        ((0, "a"), "[0].a"),
    ],
)
def test_a_path_is_written_as_people_do(path: tuple[str | int, ...], text: str) -> None:
    assert path_text(path) == text


@pytest.mark.parametrize(
    ("old", "new", "path"),
    [
        ("fatigue: 1.5", "fatigue: -1", "requirements.fatigue"),
        ("fatigue: 1.5", "fatigue: [1.5, -1]", "requirements.fatigue[1]"),
        ("fatigue: 1.5", "fatigue: {factor: -1}", "requirements.fatigue.factor"),
        ("113.8 GPa", "113.8", "material.youngs_modulus"),
        ("113.8 GPa", "{value: 113.8}", "material.youngs_modulus.value"),
        ("h: 0.1 mm", "h: 0.1", "geometry.h"),
        ("h: 0.1 mm", "h: {free: [0.1, null]}", "geometry.h.free[0]"),
        ("rotation: 2 deg", "rotation: 2", "cases.work.stroke.rotation"),
        ("rotation: 2 deg", "rotation: [0, 2 deg]", "cases.work.stroke.rotation[0]"),
        ("kind: rcc", "kind: [rcc]", "geometry.kind"),
    ],
)
def test_a_path_has_no_steps_of_pydantic(old: str, new: str, path: str) -> None:
    assert finding(changed(old, new)).path == path


@pytest.mark.parametrize(
    ("size", "path"),
    [
        ("{objective: balancd}", "size.objective"),
        ("{objective: [h]}", "size.objective"),
        ("{objective: {minimize: x}}", "size.objective.minimize"),
        ("{objective: {minimise: h}}", "size.objective.minimise"),
        ("{objective: {}}", "size.objective"),
        ("{round: {b: [1]}}", "size.round.b[0]"),
    ],
)
def test_a_choice_of_shapes_gives_one_finding(size: str, path: str) -> None:
    found = findings(f"{DESIGN}size: {size}\n")
    assert path in {f.path for f in found}
    assert len(found) == len({(f.line, f.column) for f in found})


def test_a_missing_key_shows_at_the_key_of_its_mapping() -> None:
    found = finding(changed("p: 2 mm, ", ""))
    assert (found.line, found.column, found.path) == (4, 1, "geometry")
    assert found.hint.startswith("add 'p: 2 mm' (Distance from the centre")


def test_a_misspelled_key_is_not_also_missing() -> None:
    found = finding(changed("p: 2 mm", "pp: 2 mm"))
    assert found.path == "geometry.pp"
    assert found.hint == "did you mean 'p'?"


def test_a_key_in_the_wrong_place_is_told_where_it_belongs() -> None:
    found = finding(changed(", cycles: 1e7}", "}\n    cycles: 1e7"))
    assert found.hint == "'cycles' belongs in cases.<name>.stroke"


def test_a_key_that_belongs_far_away_is_told_what_may_stand_here_besides() -> None:
    found = finding(changed(", cycles: 1e7}", ", cycles: 1e7, amplitude: 2 deg}"))
    assert "belongs in" in found.hint
    assert "rotation" in found.hint


def test_a_key_of_another_kind_lists_the_keys_of_this_one() -> None:
    found = finding(changed("p: 2 mm", "p: 2 mm, blades: 4"))
    assert found.hint == "one of: b, clamps, h, half_angle, kind, l, p, root_radius"


def test_names_inside_the_program_are_not_offered() -> None:
    hints = {f.hint for f in findings(changed("p: 2 mm", "p: 2 mm, least: 4, most: 3"))}
    assert hints == {"one of: b, clamps, h, half_angle, kind, l, p, root_radius"}


def test_every_mistake_is_found_in_one_pass() -> None:
    text = (
        DESIGN.replace("113.8 GPa", "113.8")
        .replace("2 mm", "2 kg")
        .replace("45 deg", "95 deg")
        .replace("0.1 mm", "-0.1 mm")
        .replace("10 mm", "true")
        .replace("5 mm", ".inf")
        .replace("2 deg", "2 mm")
        .replace("1e7", "0")
        .replace("fatigue: 1.5", "fatigue: none\n  bukling: 2")
    )
    assert len(findings(text)) == 10


def test_findings_are_bounded_and_say_so() -> None:
    text = DESIGN + "".join(f"key{n}: 1\n" for n in range(1000))
    found = findings(text)
    assert len(found) == MAX_FINDINGS + 1
    assert "900 more" in found[-1].text


def models(annotation: Any, seen: set[type]) -> set[type]:
    from flexcli.spec.findings import _models  # the package's own walk over its types

    for model in _models(annotation):
        if model not in seen:
            seen.add(model)
            for info in model.model_fields.values():
                models(marked(info.annotation, info.metadata), seen)
    return seen


WRONG: tuple[Any, ...] = (None, True, 1, -1.5, "text", "5 mm", [], [1], {}, {"x": 1},
                          {"kind": "x"}, {"kind": [1]}, {"free": [1, 2]}, {"free": 1},
                          {"minimize": None})  # fmt: skip


@pytest.mark.parametrize(
    "model", sorted(models(DesignSpec, set()), key=lambda m: m.__name__), ids=lambda m: m.__name__
)
def test_every_part_refuses_in_our_words(model: type[BaseModel]) -> None:
    document = parse_document("spec: 1\n", "spec.yaml")
    fields = [info.alias or name for name, info in model.model_fields.items()]
    tries = [*WRONG, *({field: wrong} for field in fields for wrong in WRONG)]
    for value in tries:
        try:
            model.model_validate(value)
        except ValidationError as error:
            for found in findings_of(error, model, document):
                assert found.hint, (value, found)
                assert "Input" not in found.text, (value, found)
                assert "Value error" not in found.text, (value, found)


@pytest.mark.parametrize("kind", KINDS)
def test_the_findings_of_a_kind_start_at_its_key(kind: str) -> None:
    document = parse_document(f"flexure: 1\n{kind}: 5\n", "spec.yaml")
    with pytest.raises(ValidationError) as raised:
        TypeAdapter(KINDS[kind]).validate_python(5)
    (found,) = findings_of(raised.value, KINDS[kind], document, (kind,))
    assert (found.line, found.path) == (2, kind)
    assert "a mapping is expected here, not 5" in found.text


def test_an_error_lists_its_findings_in_the_order_of_the_file() -> None:
    made = [Finding("a", "x", line=3), Finding("a", "x", line=1), Finding("a", "x", line=2)]
    assert [f.line for f in SpecError(made).findings] == [1, 2, 3]


def test_a_place_is_written_as_editors_understand_it() -> None:
    assert Finding("a.yaml", "x", line=3, column=4).where == "a.yaml:3:4"
    assert Finding("a.yaml", "x").where == "a.yaml"
