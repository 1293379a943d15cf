"""Scalars: the core schema of YAML 1.2, with either parser."""

import pytest
from yaml_texts import value


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1e-3", 1e-3),
        ("1E7", 1e7),
        ("+.5", 0.5),
        ("010", 10),
        ("0o17", "0o17"),
        ("0x1F", "0x1F"),
        ("1_000", "1_000"),
        ("1:30", "1:30"),
        ("2024-01-01", "2024-01-01"),
        ("no", "no"),
        ("on", "on"),
        ("y", "y"),
        ("true", True),
        ("False", False),
        ("null", None),
        ("~", None),
        (".inf", float("inf")),
        ("-.INF", float("-inf")),
        ("'1e-3'", "1e-3"),
        ('"true"', "true"),
        ("0.2 mm", "0.2 mm"),
        ("µm", "µm"),
        ("=", "="),
        ("9" * 400, float("inf")),
    ],
)
@pytest.mark.usefixtures("either_parser")
def test_scalars_follow_the_core_schema(text: str, expected: object) -> None:
    found = value(f"- {text}")
    assert found == [expected]
    assert isinstance(found, list)
    assert type(found[0]) is type(expected)
