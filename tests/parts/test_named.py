"""Parts by name: the tables of classes agree with what the classes say of themselves."""

from typing import Annotated, Any, get_args

import pytest
from pydantic import BaseModel, TypeAdapter, ValidationError

from flexcli.parts.base import Part
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import GEOMETRIES, Geometry
from flexcli.parts.mechanisms import MECHANISMS, Mechanism
from flexcli.parts.named import Kinds, Named
from flexcli.parts.requirements import Requirement, Requirements
from flexcli.spec.findings import findings_of
from flexcli.spec.parse import parse_document


@pytest.mark.parametrize("kind", GEOMETRIES.paths)
def test_a_geometry_stands_under_its_own_kind(kind: str) -> None:
    found = GEOMETRIES.by_kind[kind]
    assert issubclass(found, Geometry)
    assert get_args(found.model_fields["kind"].annotation) == (kind,)


@pytest.mark.parametrize("kind", MECHANISMS.paths)
def test_a_mechanism_stands_under_its_own_kind(kind: str) -> None:
    found = MECHANISMS.by_kind[kind]
    assert issubclass(found, Mechanism)
    assert get_args(found.model_fields["kind"].annotation) == (kind,)


def markers(annotation: Any) -> list[Named]:
    if isinstance(annotation, Named):
        return [annotation]
    inner = (*get_args(annotation), *getattr(annotation, "__metadata__", ()))
    return [m for each in inner for m in markers(each)]


@pytest.mark.parametrize("field", Requirements.model_fields)
def test_a_requirement_is_one(field: str) -> None:
    marker = markers(Requirements.model_fields[field].annotation)[0]
    assert issubclass(marker.classes[0], Requirement)


class Holder(Part):
    """What a spec may hold: one of two kinds, and a part by name."""

    one: Annotated[Any, Kinds({k: GEOMETRIES.paths[k] for k in ("rcc", "star")})]
    other: Annotated[Any, Named("flexcli.parts.shock:Shock")] | None = None


RCC = {"kind": "rcc", "h": "1 mm", "l": "9 mm", "b": "5 mm", "p": "1 mm", "half_angle": "9 deg"}


@pytest.mark.parametrize(
    ("given", "place", "kind"),
    [
        ({"one": {**RCC, "kind": "ring"}}, ("one",), "union_tag_invalid"),
        ({"one": {"h": "1 mm"}}, ("one",), "union_tag_not_found"),
        ({"one": {**RCC, "h": "1 kg"}}, ("one", "rcc", "h", "fixed"), "spec"),
        ({"one": {**RCC, "q": 1}}, ("one", "rcc", "q"), "extra_forbidden"),
        ({"one": RCC, "other": {"x": 1}}, ("other", "x"), "extra_forbidden"),
    ],
)
def test_a_mistake_in_a_named_part_is_told_where_it_is(
    given: dict[str, Any], place: tuple[str, ...], kind: str
) -> None:
    with pytest.raises(ValidationError) as raised:
        Holder.model_validate(given)
    assert [(e["loc"], e["type"]) for e in raised.value.errors()] == [(place, kind)]


def test_a_part_stays_what_it_is_when_it_is_given_again() -> None:
    part = TypeAdapter(Holder).validate_python({"one": RCC})
    assert isinstance(part.one, BaseModel)
    assert Holder(one=part.one).one is part.one


def test_a_kind_that_nobody_knows_is_answered_by_the_nearest_of_all() -> None:
    text = "geometry: {kind: leaf-sprng-stage}\n"
    document = parse_document(f"flexure: 1\n{text}", "spec.yaml")
    with pytest.raises(ValidationError) as raised:
        DesignSpec.model_validate(document.value)
    hints = [f.hint for f in findings_of(raised.value, DesignSpec, document)]
    assert any("did you mean 'leaf-spring-stage'" in hint for hint in hints)
