"""The JSON Schema against the tool itself: it accepts what the tool does, short of the relations.

A public validator is asked; ``BEYOND`` lists what no schema can express, by what findings say.
"""

import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

import pytest
import yaml
from jsonschema import Draft202012Validator

from flexcli.errors import SpecError
from flexcli.spec.load import KINDS as PARTS
from flexcli.spec.load import load
from flexcli.spec.read import read_document
from flexcli.spec.schema import KINDS
from flexcli.spec.schema import json_schema as made
from flexcli.unit_patterns import quantity_pattern
from flexcli.units import DIMENSIONS, QuantityError, parse_quantity

ROOT = Path(__file__).parent.parent.parent
WRONG = ROOT / "tests" / "wrong"
FOLDERS = ("examples", "specs", "tests/spec/good", "tests/cases")
LARGEST = 300_000
"""Characters of a schema that editors read at every key; theirs for CI files are of this size."""
MUTANTS = 500

BEYOND = {
    "between keys of a part": (
        "stands beside",  "has a slope, or the level", "no level is given",
        "placed by p or by delta", "no room for min or max", "names one quantity",
        "stroke is a translation or a rotation", "by 'points' or by 'basquin'",
        "a thickness is h or",
        "must name its source", "how far the tip may go", "this case loads nothing",
        "a support without stiffness", "straight on log-log axes",
        "a translation has no centre", "has no length$", "needs two modes",
    ),
    "between numbers": (
        "must rise", "do not rise", "is not below", "no width",
        "must reach beyond", "stands twice", "share this frequency", "keeps the frequency",
        "needs a point before", "a second level", "beyond any physical level", "runs from 0 to 1",
        "stand at 2 places", "is above the tensile", "must not rise", "a fifth of Young",
        "is below smallest-gap", "stroke is zero", "does not move", "this sweep takes",
        "longer than the", "overlap", "nothing that moves",
        "this wrench is zero",
        "this standard changes the shape", "the longer the arm", "no isotropic plate has",
    ),
    "a bound that depends on the unit a number is written in": (
        r"must be below (1|90 deg|to_cycles)$", "would make energy",
    ),
    "between parts of a design": (
        "no scaling with mass", "is in m, not", "is about$", "on exactly where", "what holds the",
        "needs the payload's inertia", "needs a mass", "needs masses", "needs the cycles",
        "the material has no", "needs material.poisson_ratio", "needs Poisson's ratio",
        "no body to lock", "cannot be locked", "axial support that the spec",
        "turns on pivots", "in N/m$", "in N.m/rad",
        "in plain numbers", "stops hold a", "does not stand along", "sits on a cantilever",
        "contact has no stress", "motion of this joint", "is moved, not turned",
        "two forces or of two moments",
        "needs spacing", "a total is for two",
        "robust against what", "is not of a blade", "there is no number",
        "^tolerances.*does not measure", "^tolerances.*has no unit", "as large as the number",
        "nothing is asked of",
        "follow from two of them", "actuator's growth", "stated thermal expansion", "has no arm",
        "no actuator that drives", "a sag is along one axis",
        "in its plane alone", "a load is one in a plane", "carries no mechanism",
        "in space under a vibration", "is judged at assembly, not", "not made of straight blades",
    ),
    "between bodies and blades of a layout": (
        "lies where", "not held to the ground", "this blade is thicker than wide",
        "the width points along", "no body has these moments", "there is no blade",
        "is no body", "does not move this body",
        "there is no body", "both ends of this blade", "need a travel along", "leave the centre",
    ),
    "names given elsewhere, and other files": (
        "there is no shipped", "there is no case", "there is no size", "there is no file",
        "is a folder", "holds stroke", "holds material", "is given twice", "never closed",
        "^parts/",
    ),
}  # fmt: skip
"""What findings say that no schema can find, by the reason."""


json_schema = cache(made)


@cache
def validator(kind: str) -> Any:
    return Draft202012Validator(json_schema(kind))


def kind_of(root: Any) -> str:
    """Return the kind of spec that a file is meant to be, as an editor would be told."""
    alone = set(root) - {"flexure"} if isinstance(root, dict) else set()
    return next((k for k in PARTS if alone == {k} and not isinstance(root[k], str)), "design")


def accepts(root: Any) -> bool:
    return bool(validator(kind_of(root)).is_valid(root))


def specs() -> Iterator[Path]:
    for folder in FOLDERS:
        for path in sorted((ROOT / folder).rglob("*.yaml")):
            if re.search(r"^flexure:", path.read_text(encoding="utf-8"), re.MULTILINE):
                yield path


SPECS = tuple(specs())


@pytest.mark.parametrize("kind", KINDS)
def test_a_schema_is_one_and_small(kind: str) -> None:
    schema = json_schema(kind)
    Draft202012Validator.check_schema(schema)
    assert schema["$id"].startswith("urn:")
    assert len(json.dumps(schema)) < LARGEST


@pytest.mark.parametrize("path", SPECS, ids=lambda p: str(p.relative_to(ROOT)))
def test_what_the_tool_reads_is_valid(path: Path) -> None:
    root = read_document(path).value
    errors = [e.json_path for e in validator(kind_of(root)).iter_errors(root)]
    assert not errors


def objects(node: Any) -> Iterator[Any]:
    """Yield every description of a mapping in a schema."""
    for inner in node.values() if isinstance(node, dict) else node:
        if isinstance(inner, dict | list):
            yield from objects(inner)
    if isinstance(node, dict) and node.get("type") == "object":
        yield node


def keys() -> Iterator[tuple[str, Any]]:
    """Yield every key that a design may have with its schema, once."""
    found = {
        (name, json.dumps(inner)): inner
        for each in objects(json_schema("design"))
        for name, inner in each.get("properties", {}).items()
        if isinstance(inner, dict) and name != "free"
    }
    return ((name, inner) for (name, _), inner in found.items())


def examples(schema: Any) -> list[Any]:
    """Return the examples of a key, its own or those of what it is written as."""
    choices = (schema, *schema.get("anyOf", ()))
    definitions = json_schema("design")["$defs"]
    meant = [definitions[c["$ref"].rpartition("/")[2]] if "$ref" in c else c for c in choices]
    found = [e for each in (*choices, *meant) for e in each.get("examples", ())]
    return [schema["const"]] if "const" in schema else found


KEYS = tuple(keys())


def test_every_key_is_described_with_an_example() -> None:
    assert len(KEYS) > 250
    assert not [name for name, schema in KEYS if len(schema.get("description", "")) < 8]
    assert not [name for name, schema in KEYS if not examples(schema)]


def test_every_example_is_what_its_key_takes() -> None:
    definitions = json_schema("design")["$defs"]
    for name, schema in KEYS:
        validate = Draft202012Validator({"$defs": definitions, **schema})
        for example in examples(schema):
            assert validate.is_valid(example), f"{name}: {example}"


def reason(text: str) -> str | None:
    """Return why no schema finds what a finding says, nothing where one could."""
    return next(
        (why for why, said in BEYOND.items() if any(re.search(s, text) for s in said)), None
    )


def wrong() -> Iterator[tuple[str, Any, list[str]]]:
    """Yield each wrong spec that is JSON too: its name, its values, what is wrong with it."""
    for path in sorted(WRONG.glob("*.yaml")):
        if path.stem.endswith(".expected"):
            continue
        try:
            document = read_document(path)
            json.dumps(document.value, allow_nan=False)
        except (SpecError, ValueError):
            continue
        if not document.findings:
            expected = yaml.safe_load((WRONG / f"{path.stem}.expected.yaml").read_text("utf-8"))
            yield path.stem, document.value, [said(**finding) for finding in expected]


def said(path: str, text: str, file: str = "", **_: Any) -> str:
    """Return a finding in one line, the file only where it is another one."""
    return f"{file} {path}: {text}".lstrip()


@pytest.mark.slow
def test_a_wrong_spec_is_invalid_unless_only_relations_are_wrong() -> None:
    told = {name: (accepts(root), texts) for name, root, texts in wrong()}
    unequal = {n: t for n, (valid, t) in told.items() if valid != all(map(reason, t))}
    assert not unequal
    assert sum(not valid for valid, _ in told.values()) > len(told) / 3


def test_each_thing_beyond_a_schema_is_found_in_a_wrong_spec() -> None:
    texts = [text for _, _, findings in wrong() for text in findings]
    said = [pattern for patterns in BEYOND.values() for pattern in patterns]
    assert not [s for s in said if not any(re.search(s, text) for text in texts)]


def places(value: Any, holder: str = "") -> Iterator[tuple[Any, Any, str]]:
    """Yield every value inside a value: what holds it, its key there, the key of what holds it."""
    inner = list(value.items() if isinstance(value, dict) else enumerate(value))
    for key, each in inner:
        yield value, key, holder
        if isinstance(each, dict | list):
            yield from places(each, str(key))


def misspelt(word: str, random: Random) -> str:
    """Return a word of which a letter is left out, doubled or changed, or changes its place."""
    i = random.randrange(len(word))
    rest = word[i + 1 :]
    swapped = word[:i] + rest[:1] + word[i] + rest[1:]
    return random.choice((word[:i] + rest, word[: i + 1] + word[i:], f"{word[:i]}q{rest}", swapped))


NAMED = {"cases", "joints", "bodies", "blades"}
"""Mappings whose keys a designer chooses: no typo can be seen there."""
QUANTITY = re.compile(r"^([-+.0-9e]+ )(\S.*)$")
OTHER = {dict: (7, "much", []), list: (7, "much", {}), str: (7, [1], {"of": 1}, True)}
"""Values of other types than what stands there; a number is replaced as a text is."""


def mutate(root: Any, random: Random) -> Any:
    """Return a copy of a spec with one typo: in a key, in a unit, or a value of a wrong type."""
    spec = json.loads(json.dumps(root))
    holder, key, name = random.choice(list(places(spec)))
    value = holder[key]
    quantity = QUANTITY.match(value) if isinstance(value, str) else None
    if random.random() < 0.4 and isinstance(holder, dict) and name not in NAMED:
        holder[misspelt(key, random)] = holder.pop(key)
    elif quantity is not None and random.random() < 0.7:
        holder[key] = quantity[1] + misspelt(quantity[2], random)
    else:
        holder[key] = random.choice(OTHER.get(type(value), OTHER[str]))
    return spec


@pytest.fixture(scope="module")
def typos(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[Any, bool, list[str]]]:
    """Return typos that the tool refuses: values, whether the schema takes them, the findings."""
    folder, random = tmp_path_factory.mktemp("typos"), Random(14)
    roots = [read_document(path).value for path in SPECS if "examples" not in path.parts]
    whole = [root for root in roots if ".yaml" not in json.dumps(root)]
    found: list[tuple[Any, bool, list[str]]] = []
    while len(found) < MUTANTS:
        spec = mutate(random.choice(whole), random)
        path = folder / f"{len(found)}.yaml"
        path.write_text(json.dumps(spec, ensure_ascii=False), encoding="utf-8")
        valid = accepts(spec)
        try:
            load(path)
        except SpecError as error:
            found.append((spec, valid, [said(f.path, f.text) for f in error.findings]))
        else:
            assert valid, f"{spec} is read by the tool"
    return found


@pytest.mark.slow
def test_of_500_typos_the_schema_alone_finds_95_percent(typos: Any) -> None:
    assert sum(not valid for _, valid, _ in typos) >= 0.95 * MUTANTS


@pytest.mark.slow
def test_a_typo_that_the_schema_lets_pass_is_beyond_any(typos: Any) -> None:
    assert not [texts for _, valid, texts in typos if valid and not all(map(reason, texts))]


UNITS = ("N m", "Nm", "mNm", "kN·mm", "m²", "m/s²", "m/s**2", "g²/Hz", "(m/s²)²/Hz", "µm", "μm",
         "°", "arcsec", "inch", "inches", "kpsi", "lbf/in", "N / mm", "lbf*in/deg", "/K", "ppm/K",
         "dB/decade", "%", "percent", "mg", "min", "Mm", "mPa", "kkg", "mm2", "qm", "MN",
         "kilometers", "J", "mJ", "ksi", "lb/in^3", "kHz/min", "")  # fmt: skip
"""Units and what looks like them, everyday ones apart."""


@pytest.mark.parametrize("dimension", DIMENSIONS)
def test_a_pattern_takes_the_units_that_the_tool_reads(dimension: str) -> None:
    everyday = [unit for each in DIMENSIONS.values() for unit in each.units]
    for unit in (*everyday, *UNITS):
        for number in ("2", "-.5e-2", "+1.e3", "\N{MINUS SIGN}4", "1,5", "two"):
            text = f"{number} {unit}".rstrip()
            try:
                parse_quantity(text, dimension)
                read = True
            except QuantityError:
                read = False
            assert bool(re.search(quantity_pattern(dimension), text)) is read, text


@pytest.mark.parametrize(("sign", "numbers"), [
    ("+", {"1 mm": True, "0 mm": False, "0.0e3 mm": False, "-1 mm": False, "+0.01 mm": True}),
    ("0+", {"1 mm": True, "0 mm": True, "0.0e3 mm": True, "-1 mm": False}),
    ("-", {"1 mm": False, "0 mm": False, "-0.0 mm": False, "-0.1 mm": True}),
])  # fmt: skip
def test_a_pattern_knows_the_sign(sign: str, numbers: dict[str, bool]) -> None:
    pattern = quantity_pattern("length", sign)
    assert {text: bool(re.search(pattern, text)) for text in numbers} == numbers


@pytest.mark.parametrize(("material", "valid"), [
    ("ti-6al-4v", True), ("parts/mine.yaml", True), ({"youngs_modulus": "110 GPa"}, True),
    ({"extends": "ti-6al-4v", "density": "4400 kg/m^3"}, True), ({"extends": 7}, False),
    ({"density": "4400 kg/m^3"}, False), (["ti-6al-4v"], False), (7, False),
])  # fmt: skip
def test_a_material_is_named_written_out_or_extended(material: Any, valid: bool) -> None:
    root = read_document(SPECS[0]).value
    assert accepts({**root, "material": material}) is valid
