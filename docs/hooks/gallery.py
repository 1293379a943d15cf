"""The gallery: every example with its drawing, and its source's numbers beside those of today."""

import re
import shlex
from pathlib import Path
from typing import Any

import yaml
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files

import flexcli
from flexcli.results import Result
from flexcli.results.drawing import Drawing
from flexcli.units import show

ROOT = Path(__file__).parents[2] / "examples"


def on_files(files: Files, config: Any) -> Files:
    """Add a page and a drawing of each example, their index, and what their sources hide."""

    def add(name: str, content: str) -> None:
        files.append(File.generated(config, name, content=content))

    index = ["# Gallery", "", "Every example, drawn by `flexure draw` when this site was built."]
    hidden = [
        "# What the sources hide", "",
        "Where a source is silent, rounds, slips or contradicts itself, as its example found out.",
    ]  # fmt: skip
    for folder in sorted(path.parent for path in ROOT.glob("*/expected.yaml")):
        expected = yaml.safe_load((folder / "expected.yaml").read_text(encoding="utf-8"))
        title, _, text = (folder / "README.md").read_text(encoding="utf-8").partition("\n")
        title = title.removeprefix("# ")
        drawn, result = _run(folder / "flexure.yaml", expected["command"])
        add(f"gallery/{folder.name}.svg", drawn._repr_svg_() or "")
        picture = f"![{title}, drawn to scale]({folder.name}.svg)"
        spec = (folder / "flexure.yaml").read_text(encoding="utf-8").strip()
        table = ["| quantity | source | ours |", "|:--|--:|--:|", *_rows(result, expected)]
        page = [
            f"# {title}", "", picture, text, "",
            f"## Numbers of `flexure {expected['command']}`", "",
            f"`flexure {expected['command'].split()[0]}` as it is, with the models that decide, "
            f"ends with **{expected['verdict']}**.", "",
            *table, "", "## The spec", "", f"```yaml\n{spec}\n```",
        ]  # fmt: skip
        add(f"gallery/{folder.name}.md", "\n".join(page))
        index += ["", f"## [{title}]({folder.name}.md)", "", picture]
        said = re.split(r"^\|.*\n(?!\|)", text, maxsplit=1, flags=re.MULTILINE)[-1]
        deeper = re.sub(r"^#", "##", said.strip(), flags=re.MULTILINE)
        hidden += ["", f"## [{title}](gallery/{folder.name}.md)", "", deeper]
    add("gallery/index.md", "\n".join(index))
    add("sources.md", "\n".join(hidden))
    return files


def _run(path: Path, command: str) -> tuple[Drawing, Result]:
    """Return the drawing of an example, of the sizes that its command chose, and what it found."""
    verb, *options = shlex.split(command)
    given: dict[str, Any] = {}
    while options:
        match options:
            case ["--model", name, *options]:
                given["model"] = name
            case ["--no-simulate", *options]:
                given["simulate"] = False
            case _:
                raise PluginError(f"{path}: '{command}' has options that the gallery does not know")
    spec = flexcli.load(path)
    found = getattr(flexcli, verb)(spec, **given)
    return flexcli.drawing(flexcli.sized(spec, found) if verb == "size" else spec), found


def _rows(result: Result, expected: dict[str, Any]) -> list[str]:
    rows = []
    for row in expected["printed"]:
        kind, name, *attribute = row["of"].removeprefix("1/").split(".")
        if kind == "values":
            value, unit = result.values[name].value, result.values[name].unit
            label = result.values[name].label
        else:
            (check,) = (check for check in result.checks if check.name == name)
            value = getattr(check, attribute[0])
            unit = check.unit if attribute[0] in ("demand", "capacity") else ""
            label = f"{attribute[0]} of {check.full_name}"
        inverse = row["of"].startswith("1/")
        ours = show(1.0 / value if inverse else value, unit, 5)
        symbol = "" if kind != "values" else f", 1/{name}" if inverse else f", {name}"
        rows.append(f"| {label}{symbol} | {row['printed']} | {ours} |")
    return rows
