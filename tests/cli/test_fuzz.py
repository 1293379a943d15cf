"""Broken specs under every verb: no traceback, no hang, no file touched but the one asked for.

A few in every run; ``FUZZ_SECONDS=60 FUZZ_SEED=202648 pytest -rP -m fuzz`` runs a campaign. Each
mutant follows from its seed and number alone, which a failure names.
"""

import json
import os
import re
import signal
import warnings
from collections.abc import Iterator
from copy import deepcopy
from importlib import import_module
from pathlib import Path
from pkgutil import walk_packages
from random import Random
from time import monotonic
from typing import Any, NamedTuple

import pytest
import yaml
from typer.testing import CliRunner

import flexcli
from flexcli.cli.app import command_line

ROOT = Path(__file__).parents[2]
SOURCES = sorted(
    path
    for pattern in ("examples/*/flexure.yaml", "specs/*/*.yaml", "tests/spec/good/**/*.yaml")
    for path in ROOT.glob(pattern)
)
TEXTS = [path.read_text(encoding="utf-8") for path in SOURCES]
TREES = [yaml.safe_load(text) for text in TEXTS]

SEED = os.environ.get("FUZZ_SEED", "1")
SECONDS = float(os.environ.get("FUZZ_SECONDS", "0"))
FEW = 60

LIMIT = 1.0
"""Seconds that a verb may take: what takes longer must end by its time limit."""
HANG = 30.0
"""Seconds after which it has not done so, on a busy machine either."""

# what takes seconds comes seldom
VERBS = (
    *[("validate", "SPEC")] * 8,
    *[("check", "SPEC")] * 6,
    *[("check", "SPEC", "--model", "closed-form")] * 3,
    ("check", "SPEC", "--model", "exact"),
    ("check", "SPEC", "parts", "missing.yaml"),
    ("check", "."),
    ("size", "SPEC", "--write", "out.yaml"),
    ("simulate", "SPEC", "--points", "3", "--csv", "out.csv"),
    ("plan", "SPEC"),
    ("plan", "SPEC", "--audit"),
    ("accuracy", "SPEC"),
    ("balance", "SPEC", "--csv", "out.csv"),
    ("stops", "SPEC", "--no-simulate"),
    ("stops", "SPEC", "--simulate", "--csv", "out.csv"),
    ("stops", "SPEC", "--no-simulate", "--sweep", "--csv", "out.csv"),
    ("asd", "response", "SPEC"),
    ("asd", "worst-case", "SPEC"),
    ("asd", "worst-case", "SPEC", "--q", "30", "--duration", "2 min"),
    ("asd", "show", "SPEC"),
    ("asd", "grms", "SPEC", "gevs-acceptance"),
    ("asd", "validate", "SPEC"),
    ("asd", "scale", "SPEC", "--db", "3", "--write", "out.yaml"),
    ("asd", "envelope", "SPEC", "gevs-acceptance", "--write", "out.yaml"),
)
OPTIONS = (
    (), (), ("--format", "json"), ("--format", "json"), ("--format", "junit"),
    ("--format", "sarif"), ("--format", "github"), ("--format", "markdown"), ("--allow-outside",),
)  # fmt: skip
WORDS = re.compile(
    r"pydantic|Input should|Traceback|<class|np\.float|ValidationError|yaml\.|\bdict\b"
)
"""What libraries say, and a designer should not have to read."""

VALUES = (
    None, True, False, 0, -1, 1, 5, 1e300, 1e-300, float("nan"), float("inf"), "", " ", "0 mm",
    "1 um", "1 m", "-1 mm", "1e200 m", "1e-200 m", "1e999 m", "5 kg", "1 g", "90 deg", "0 deg",
    "1e9 Hz", "0.5 Hz", "1 MPa", "1e30 MPa", "100 %", "0 %", "free", "auto", "none",
    "../foreign.yaml", "parts/mine.yaml", "/dev/zero", "nothing.yaml", "ti-6al-4v", "rcc", "layout",
    "linkage", "x" * 500, "\u202e\x1b[31m", "naïve µ°σ", [], {}, [None], [1, 2], ["1 mm", "2 mm"],
    {"free": ["1 mm", None]}, {"free": None}, {"value": "1 MPa"}, {"kind": "rcc"}, {"kind": 5},
    {"extends": "ti-6al-4v"},
)  # fmt: skip
CHARACTERS = "{}[]:,-#&*!|>'\"%@`\t\n \\0159eEnmkgHz°µ\u0000\ud7ff\ufeff"


class Fault(NamedTuple):
    """What a run did wrong, and whether that is a bug that blocks."""

    text: str
    is_bug: bool = True


class Mutant(NamedTuple):
    """A broken spec and the command that reads it."""

    text: str
    arguments: tuple[str, ...]


def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Yield the path of every value inside another."""
    if not isinstance(value, dict | list):
        return
    for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
        yield (*path, key)
        yield from places(inner, (*path, key))


def at(value: Any, path: tuple[Any, ...]) -> Any:
    for step in path:
        value = value[step]
    return value


def broken_tree(random: Random, tree: Any) -> Any:
    """Return values with one replaced, taken out, renamed, added or brought from elsewhere."""
    tree = deepcopy(tree)
    path = random.choice(list(places(tree)))
    parent, key = at(tree, path[:-1]), path[-1]
    other = random.choice(TREES)
    match random.randrange(6):
        case 0 | 1:
            parent[key] = deepcopy(random.choice(VALUES))
        case 2:
            del parent[key]
        case 3:
            parent[key] = deepcopy(at(other, random.choice(list(places(other)))))
        case 4 if isinstance(parent, dict):
            wrong = random.choice(list(places(other)))[-1]
            parent[str(wrong)] = parent.pop(key)
        case _:
            new = deepcopy(at(other, random.choice(list(places(other)))))
            if isinstance(parent, dict):
                parent[random.choice(["extra", "kind", "free", "cases", "value"])] = new
            else:
                parent.append(new)
    return tree


def broken_number(random: Random, text: str) -> str:
    """Return a text with one of its numbers changed by orders of magnitude, or in sign."""
    found = list(re.finditer(r"(?<![\w.])-?\d+\.?\d*(?:e-?\d+)?", text))
    if not found:
        return text
    number = random.choice(found)
    value = float(number.group()) * random.choice(
        [-1, 0, 1e-6, 1e-3, 0.1, 0.5, 2, 10, 1e3, 1e6, 1e15]
    )
    return text[: number.start()] + repr(value) + text[number.end() :]


def broken_text(random: Random, text: str) -> str:
    """Return a text with characters or lines changed."""
    lines = text.split("\n")
    i, j = random.randrange(len(lines)), random.randrange(len(text))
    match random.randrange(4):
        case 0:
            return text[:j] + random.choice(CHARACTERS) + text[j + random.randrange(3) :]
        case 1:
            return "\n".join([*lines[:i], *lines[i + 1 :]])
        case 2:
            return "\n".join([*lines[: i + 1], *lines[i:]])
        case _:
            return text[:j]


def mutant(number: int) -> Mutant:
    """Return the mutant of a number, the same whenever the seed is."""
    random = Random(f"{SEED} {number}")
    which = random.randrange(len(SOURCES))
    text, tree = TEXTS[which], TREES[which]
    for _ in range(random.choice([1, 1, 1, 2, 4])):
        if random.random() < 0.6:
            tree = broken_tree(random, tree)
            if not list(places(tree)):
                break
            text = yaml.safe_dump(tree, allow_unicode=True, sort_keys=False)
        elif random.random() < 0.7:
            text = broken_number(random, text)
        else:
            text = broken_text(random, text) if text else text
    arguments = random.choice(VERBS)
    return Mutant(text, (*arguments, *random.choice(OPTIONS)))


def contents(folder: Path) -> dict[str, tuple[int, bytes]]:
    """Return every file below a folder with its time and content."""
    return {
        str(path.relative_to(folder)): (path.stat().st_mtime_ns, path.read_bytes())
        for path in folder.rglob("*")
        if path.is_file()
    }


def hung(*_: Any) -> None:
    raise TimeoutError


def faults(given: Mutant, folder: Path) -> Iterator[Fault]:
    """Run a mutant in a folder of its own and yield what it did wrong."""
    home = folder / "home"
    (home / "parts").mkdir(parents=True, exist_ok=True)
    (folder / "foreign.yaml").write_text("flexure: 1\nmaterial: {youngs_modulus: 1 GPa} # secret\n")
    (home / "parts" / "mine.yaml").write_text("flexure: 1\nmaterial: {extends: ti-6al-4v}\n")
    (home / "spec.yaml").write_text(given.text, encoding="utf-8", errors="replace")
    for left in ("out.yaml", "out.csv"):
        (home / left).unlink(missing_ok=True)
    before = contents(folder)
    arguments = ["spec.yaml" if each == "SPEC" else each for each in given.arguments]
    os.chdir(home)
    previous = signal.signal(signal.SIGALRM, hung)
    signal.setitimer(signal.ITIMER_REAL, HANG)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            told = CliRunner().invoke(command_line(), [*arguments, "--time-limit", str(LIMIT)])
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, previous)
        os.chdir(ROOT)
    if isinstance(told.exception, TimeoutError):
        yield Fault("hangs")
    elif told.exception is not None and not isinstance(told.exception, SystemExit):
        yield Fault(f"ends with {told.exception!r}")
    elif told.exit_code not in (0, 1, 2):
        yield Fault(f"exits {told.exit_code}")
    asked = {f"home/{each}" for each in given.arguments if each.startswith("out.")}
    after = contents(folder)
    touched = {name for name in {*before, *after} if before.get(name) != after.get(name)} - asked
    if touched:
        yield Fault(f"touches {sorted(touched)}")
    said = told.stdout + told.stderr
    if word := WORDS.search(said):
        yield Fault(f"says '{word.group()}'", is_bug=False)
    if "secret" in said:
        yield Fault("shows a line of a foreign file")
    if "json" in given.arguments and "Usage:" not in told.stderr:
        try:
            json.loads(told.stdout)
        except ValueError:
            yield Fault("prints no JSON", is_bug=False)


def found(number: int, folder: Path) -> list[tuple[str, bool]]:
    given = mutant(number)
    return [
        (f"mutant {number} of seed {SEED} {fault.text}: flexure {' '.join(given.arguments)}\n"
         f"{given.text}", fault.is_bug)
        for fault in faults(given, folder)
    ]  # fmt: skip


@pytest.fixture(scope="session")
def imported() -> None:
    """Import everything before, so that no time limit ends an import of a library for good."""
    for module in walk_packages(flexcli.__path__, "flexcli."):
        import_module(module.name)


@pytest.fixture
def folder(imported: None, tmp_path: Path) -> Iterator[Path]:
    here = Path.cwd()
    yield tmp_path
    os.chdir(here)


@pytest.mark.parametrize("tenth", range(6))
def test_a_broken_spec_ends_well_under_every_verb(folder: Path, tenth: int) -> None:
    each = FEW // 6
    all_found = [f for n in range(tenth * each, (tenth + 1) * each) for f in found(n, folder)]
    assert not all_found, "\n\n".join(text for text, _ in all_found)


@pytest.mark.fuzz
@pytest.mark.skipif(not SECONDS, reason="a campaign is asked for by FUZZ_SECONDS")
@pytest.mark.parametrize("worker", range(2))
def test_a_campaign_finds_no_bug(folder: Path, worker: int) -> None:
    end, number, bugs, others = monotonic() + SECONDS, 1000 + worker, [], []
    while monotonic() < end:
        for text, is_bug in found(number, folder):
            (bugs if is_bug else others).append(text)
        number += 2
    print(f"{(number - 1000) // 2} mutants of seed {SEED}, {len(bugs)} bugs", *others, sep="\n")
    assert not bugs, "\n\n".join(bugs)
