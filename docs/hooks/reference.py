"""The reference: commands, keys of a spec, formulas and materials, read from the code."""

from collections.abc import Iterable, Iterator
from typing import Any

import typer
from mkdocs.structure.files import File, Files
from typer.testing import CliRunner

from flexcli.cli.app import command_line
from flexcli.engine.explain import topics
from flexcli.results.explanation import Explanation, FieldRow, FormulaRow, SymbolRow
from flexcli.spec.load import load_shipped
from flexcli.spec.manual import entries, names
from flexcli.spec.shipped import shipped_names
from flexcli.units import show

SPECIAL = str.maketrans({"|": r"\|", "<": "&lt;", "*": r"\*", "_": r"\_", "`": "", "[": r"\["})


def on_files(files: Files, config: Any) -> Files:
    """Add the pages of the reference."""
    fields = {field.path: field for name in names() for field in entries(name)}
    found = topics()
    own = {name for topic in found for name in _own(topic)}
    pages = {
        "spec": _spec(fields.values()),
        "joints": _topics("Formulas of joints", [t for t in found if _own(t)]),
        "formulas": _topics("General formulas", [t for t in found if not _own(t)], own),
        "materials": _materials(),
    }
    for name, lines in pages.items():
        content = "\n".join(lines)
        files.append(File.generated(config, f"reference/{name}.md", content=content))
    return files


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Add the help of every command to the page about them."""
    if page.file.src_uri != "reference/commands.md":
        return markdown
    return "\n".join([markdown, *_commands()])


def _text(words: str) -> str:
    """Return words that are no markup, on one line."""
    return " ".join(words.split()).translate(SPECIAL)


def _table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> Iterator[str]:
    heads = list(heads)
    yield f"| {' | '.join(heads)} |"
    yield f"|{':--|' * len(heads)}"
    for row in rows:
        yield f"| {' | '.join(row)} |"
    yield ""


def _commands() -> Iterator[str]:
    group: Any = typer.main.get_command(command_line())
    for name, command in group.commands.items():
        for words in [[name], *([name, sub] for sub in getattr(command, "commands", ()))]:
            yield f"\n## flexure {' '.join(words)}\n"
            told = (
                CliRunner(env={"COLUMNS": "88"}).invoke(command_line(), [*words, "--help"]).output
            )
            yield f"```text\n{told.strip()}\n```"


def _spec(fields: Iterable[FieldRow]) -> Iterator[str]:
    yield "# Keys of a spec\n"
    yield "What `flexure explain KEY` tells, all at once; `flexure schema` has it for editors.\n"
    section = ""
    for field in sorted(fields, key=lambda each: each.path.split(".")):
        top = field.path.partition(".")[0].partition("[")[0]
        if top != section:
            section = top
            yield f"\n## {section}\n"
        if field.path != section or field.written.startswith("kind: "):
            kind = field.written if field.written.startswith("kind: ") else ""
            yield f"\n### `{field.path}{f', {kind}' if kind else ''}`\n"
        facts = [_text(field.written)]
        facts += ["must be given"] if field.required else []
        facts += [f"default: {_text(field.default)}"] if field.default else []
        yield f"{_text(field.text)}\n\n*{'; '.join(facts)}*\n"
        if field.kinds:
            yield f"Of {', '.join(field.kinds)}.\n"
        if field.axes:
            yield "```text\n" + field.axes.strip("\n") + "\n```\n"
        if field.keys:
            rows = (
                (f"`{k.name}`", "must be given" if k.required else _text(k.default), _text(k.text))
                for k in field.keys
            )
            yield from _table(("key", "default", "what it is"), rows)
        if field.example:
            yield f"```yaml\n{field.example.strip()}\n```\n"


def _own(topic: Explanation) -> set[str]:
    """Return the names of the formulas of a joint; none of a formula that is its own topic."""
    return {f.name for f in topic.formulas} - {topic.name}


def _topics(
    title: str, found: Iterable[Explanation], elsewhere: Iterable[str] = ()
) -> Iterator[str]:
    yield f"# {title}\n"
    yield "As `flexure explain` has them: each is held against its source by the tests.\n"
    told = set(elsewhere)
    for topic in found:
        formulas = [formula for formula in topic.formulas if formula.name not in told]
        told |= {formula.name for formula in formulas}
        if topic.formulas and topic.formulas[0].name == topic.name:
            for formula in formulas:
                yield from _formula(formula, "##")
            continue
        yield f"\n## {topic.name}\n\n{_text(topic.title)}\n"
        for formula in formulas:
            yield from _formula(formula, "###")


def _formula(formula: FormulaRow, depth: str) -> Iterator[str]:
    yield f"\n{depth} {formula.name}\n\n{_text(formula.title)}\n"
    if formula.equation:
        yield f"> {_text(formula.equation)}\n"
    rows = ((_text(s.name), _case(s), _text(s.meaning)) for s in (*formula.symbols, *formula.gives))
    yield from _table(("symbol", "worked case", "meaning"), rows)
    for row in formula.validity:
        yield f"- Valid for {_text(row.text)}: {_text(row.why)}"
    yield f"\n{_text(formula.notes)}\n\nSource: {_text(formula.source)}\n"


def _case(symbol: SymbolRow) -> str:
    if symbol.value is None or isinstance(symbol.value, str):
        return _text(symbol.value or "")
    return _text(f"{symbol.value:.5g} {symbol.unit}")


def _materials() -> Iterator[str]:
    yield "# Shipped materials\n"
    yield "Every number with its status and source, as `flexure materials NAME` prints it.\n"
    for name in shipped_names("material"):
        material = load_shipped("material", name)
        yield f"\n## {name}\n\n{_text(material.name)}\n"
        rows = (
            (_text(p.name), _text(show(p.value, p.unit)), _text(p.status), _text(p.source))
            for p in material.properties()
        )
        yield from _table(("property", "value", "status", "source"), rows)
