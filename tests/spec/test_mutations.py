"""Good designs, broken at one line: the finding must stand at that line, and nothing else end it.

A mistake shows where it was made, with two exceptions: a missing key shows at the key of the
mapping that lacks it, and YAML may notice a broken line only at the next one.
"""

import re
from collections.abc import Callable
from pathlib import Path
from random import Random
from shutil import copytree
from typing import NamedTuple

import pytest

from flexcli.errors import SpecError
from flexcli.spec.load import load

GOOD = Path(__file__).parent / "good"
DESIGNS = sorted(GOOD.glob("*.yaml"))
TRIES = 4

CASES = ("work", "push", "turn", "weight", "take-off")
TEXTS = ("title", "name", "source", "status")
SIGNED = ("com", "arm", "bisector", "direction", "thermal_expansion", "delta", "exponent",
          "stress_ratio", "poisson_ratio")  # fmt: skip
REQUIRED = ("kind", "half_angle", "h", "l", "b", "height", "mass", "com", "arm", "inertia",
            "youngs_modulus", "value", "frequency", "level", "axis", "force", "q", "coefficient",
            "exponent", "to_cycles", "reference", "uniform_to", "material", "flexure", "cycles",
            "amplitude", "factor", "max")  # fmt: skip
OPTIONAL = {("stroke", "cycles"), ("fatigue_amplitude", "cycles"), ("requirements", "mass"),
            ("requirements", "frequency"), ("mechanism", "inertia"), ("round", "h"),
            ("round", "l"), ("round", "b")}  # fmt: skip
"""Where a name that is required elsewhere may be left out."""

LEAF = re.compile(r"^(?P<indent> *(?:- )?)(?P<key>[\w/-]+): (?P<value>\S.*)$")
KEY = re.compile(r"^(?P<indent> *(?:- )?)(?P<key>[\w/-]+):(?P<rest>.*)$")
QUANTITY = re.compile(r"^(?P<number>-?[\d.]+(?:e-?\d+)?+) ?(?P<unit>[A-Za-z°][^\s,}\]]*)$")


class Broken(NamedTuple):
    """Lines of a spec, and those at which the mistake may show."""

    lines: list[str]
    at: set[int]


Mutation = Callable[[list[str], int, Random], Broken | None]


def leaf(line: str) -> tuple[str, str, str] | None:
    """Return what stands before the value, the key and the value of a 'key: value' line."""
    found = LEAF.match(line)
    if found is None:
        return None
    return f"{found['indent']}{found['key']}: ", found["key"], found["value"]


def replaced(lines: list[str], i: int, line: str, *more: int) -> Broken:
    return Broken([*lines[:i], line, *lines[i + 1 :]], {i + 1, *more})


def indent(line: str) -> int:
    return len(line) - len(line.lstrip(" -"))


def parent(lines: list[str], i: int) -> int:
    """Return the number of the line whose key holds a line, or of the first line."""
    for above in range(i - 1, -1, -1):
        if indent(lines[above]) < indent(lines[i]):
            return above + 1
        if lines[above].lstrip().startswith("- ") and indent(lines[above]) == indent(lines[i]):
            return above + 1
    return 1


def misspell_key(lines: list[str], i: int, random: Random) -> Broken | None:
    found = KEY.match(lines[i])
    if found is None or found["key"] in CASES:
        return None
    key, at = found["key"], random.randrange(len(found["key"]))
    wrong = random.choice([key[:at] + "x" + key[at:], f"{key}s", key + key[-1], key.upper() + "_"])
    return replaced(lines, i, f"{found['indent']}{wrong}:{found['rest']}")


def delete_required_key(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    above = parent(lines, i)
    key_above = KEY.match(lines[above - 1])
    if found is None or found[1] not in REQUIRED or lines[i].lstrip().startswith("-"):
        return None
    if key_above is not None and (key_above["key"], found[1]) in OPTIONAL:
        return None
    return Broken([*lines[:i], *lines[i + 1 :]], {above})


def strip_unit(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    quantity = QUANTITY.match(found[2]) if found else None
    return replaced(lines, i, found[0] + quantity["number"]) if found and quantity else None


def wrong_dimension(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    quantity = QUANTITY.match(found[2]) if found else None
    if found is None or quantity is None:
        return None
    others = {"kg", "s", "MPa", "rad/s", "m/s"} - {quantity["unit"]}
    if quantity["unit"] in ("g", "kg"):
        others -= {"kg"}
    if quantity["unit"] in ("min", "s"):
        others -= {"s"}
    if quantity["unit"].endswith("Pa"):
        others -= {"MPa"}
    return replaced(lines, i, f"{found[0]}{quantity['number']} {random.choice(sorted(others))}")


def unknown_unit(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    quantity = QUANTITY.match(found[2]) if found else None
    if found is None or quantity is None:
        return None
    unit = random.choice([f"{quantity['unit']}x", "furlong", "degC", "mm^77", quantity["unit"] * 9])
    return replaced(lines, i, f"{found[0]}{quantity['number']} {unit}")


def make_negative(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    if found is None or found[1] in (*SIGNED, *TEXTS) or not found[2][0].isdigit():
        return None
    return replaced(lines, i, f"{found[0]}-{found[2]}")


def no_number(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    if found is None or not found[2][0].isdigit() or found[1] in TEXTS:
        return None
    wrong = [".nan", ".inf", "-.inf", "true", "no", "ten", "1e999", "0x1F", "1_0", "1:30", "0,5 mm"]
    return replaced(lines, i, found[0] + random.choice(wrong))


def beyond_size(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    quantity = QUANTITY.match(found[2]) if found else None
    if found is None or quantity is None:
        return None
    number = random.choice(["1e200", "1e-200", "1e999999999", "1e-999999999999", "9" * 70])
    return replaced(lines, i, f"{found[0]}{number} {quantity['unit']}")


def other_shape(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    if found is None:
        return None
    shapes = ["[[1, 2], 3]", "{colour: red}", "null", "~", "", "[]", "true"]
    if found[2].startswith("{"):
        shapes = ["[[1, 2], 3]", "null", "~", "", "[]", "true"]
    if found[1] == "title":
        shapes.remove("true")
    return replaced(lines, i, found[0] + random.choice(shapes))


def duplicate_line(lines: list[str], i: int, random: Random) -> Broken | None:
    if leaf(lines[i]) is None or lines[i].lstrip().startswith("-"):
        return None
    return Broken([*lines[: i + 1], *lines[i:]], {i + 2})


def bad_indentation(lines: list[str], i: int, random: Random) -> Broken | None:
    before = leaf(lines[i - 1]) if i else None
    if before is None or before[2][0] in "{[" or indent(lines[i - 1]) != indent(lines[i]):
        return None
    if leaf(lines[i]) is None or lines[i].lstrip().startswith("-"):
        return None
    return replaced(lines, i, " " * random.choice([1, 3]) + lines[i])


def tab(lines: list[str], i: int, random: Random) -> Broken | None:
    if not lines[i].startswith("  "):
        return None
    return replaced(lines, i, "\t" + lines[i].lstrip())


def break_reference(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    if found is None or found[1] not in ("material", "profile", "stroke") or found[2][0] in "{[":
        return None
    return replaced(lines, i, found[0] + random.choice(["nothing", "no/thing.yaml", "a.yaml", "/"]))


def unbalanced_bracket(lines: list[str], i: int, random: Random) -> Broken | None:
    places = [k for k, c in enumerate(lines[i]) if c in "{}[]"]
    if not places:
        return None
    k = random.choice(places)
    return replaced(lines, i, lines[i][:k] + lines[i][k + 1 :])


def missing_colon(lines: list[str], i: int, random: Random) -> Broken | None:
    if leaf(lines[i]) is None or leaf(lines[i])[2][0] in "{[":  # type: ignore[index]
        return None
    return replaced(lines, i, lines[i].replace(": ", " ", 1), i + 2, parent(lines, i))


def unclosed_quote(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    quote = random.choice("'\"")
    return replaced(lines, i, f"{found[0]}{quote}{found[2]}") if found else None


def insert_unknown_key(lines: list[str], i: int, random: Random) -> Broken | None:
    if leaf(lines[i]) is None:
        return None
    key = random.choice(["colour", "thicknes", "note_", "E", "0"])
    return Broken(
        [*lines[: i + 1], f"{' ' * indent(lines[i])}{key}: red", *lines[i + 1 :]], {i + 2}
    )


def forbidden_yaml(lines: list[str], i: int, random: Random) -> Broken | None:
    found = leaf(lines[i])
    if found is None:
        return None
    wrong = [
        "!!python/name:os.system",
        "!mm 5",
        "*nothing",
        "&a [*a]",
        "@home",
        "%5",
        "\x07",
        "`x`",
    ]
    return replaced(lines, i, found[0] + random.choice(wrong))


MUTATIONS: tuple[Mutation, ...] = (
    misspell_key,
    delete_required_key,
    strip_unit,
    wrong_dimension,
    unknown_unit,
    make_negative,
    no_number,
    beyond_size,
    other_shape,
    duplicate_line,
    bad_indentation,
    tab,
    break_reference,
    unbalanced_bracket,
    missing_colon,
    unclosed_quote,
    insert_unknown_key,
    forbidden_yaml,
)


def mutants() -> list[tuple[str, Path, Broken]]:
    """Return broken specs, some of every mutation of every design, the same in every run."""
    made = []
    for design in DESIGNS:
        lines = design.read_text(encoding="utf-8").splitlines()
        for mutation in MUTATIONS:
            random = Random(f"{design.stem} {mutation.__name__}")
            order = random.sample(range(len(lines)), len(lines))
            found = [(i, b) for i in order if (b := mutation(lines, i, random)) is not None]
            for i, broken in found[:TRIES]:
                made.append((f"{design.stem}-{mutation.__name__}-line-{i + 1}", design, broken))
    return made


MUTANTS = mutants()


@pytest.mark.parametrize("design", DESIGNS, ids=lambda path: path.stem)
def test_the_design_is_good_before_it_is_broken(design: Path) -> None:
    assert load(design).kind == "design"


@pytest.mark.parametrize(
    ("design", "broken"), [m[1:] for m in MUTANTS], ids=[name for name, *_ in MUTANTS]
)
def test_a_broken_line_is_found(design: Path, broken: Broken, tmp_path: Path) -> None:
    copytree(GOOD / "parts", tmp_path / "parts")
    spec = tmp_path / "flexure.yaml"
    spec.write_text("\n".join(broken.lines) + "\n", encoding="utf-8")
    with pytest.raises(SpecError) as raised:
        load(spec)
    findings = raised.value.findings
    assert {f.line for f in findings if f.file == str(spec)} & broken.at, findings
    for finding in findings:
        assert finding.text
        assert finding.hint


def test_there_are_many_mutants_of_every_kind() -> None:
    assert len(MUTANTS) > 200
    for mutation in MUTATIONS:
        assert any(mutation.__name__ in name for name, *_ in MUTANTS)
