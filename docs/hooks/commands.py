"""Commands in the pages are run when the site is built, and sections of the README are included.

A fence ``yaml NAME`` is a file, written where the commands of its page run. In a fence ``console``
each line ``$ flexure …`` is run and its output put below; ``# exit 1`` states another exit code
than 0. ``<!-- README: HEADING -->`` is that section of the README.
"""

import os
import posixpath
import re
import shlex
from contextlib import chdir
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from mkdocs.exceptions import PluginError
from typer.testing import CliRunner

from flexcli.cli.app import command_line

ROOT = Path(__file__).parents[2]

FENCE = re.compile(r"^```(yaml \S+|console)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
SECTION = re.compile(r"<!-- README: (.+) -->")


def on_page_markdown(markdown: str, page: Any, **_: Any) -> str:
    """Return a page with what its commands print."""
    here = page.file.src_uri
    markdown = SECTION.sub(lambda found: _section(found[1], here), markdown)
    with TemporaryDirectory() as folder, chdir(folder):
        os.symlink(ROOT / "examples", "examples")
        return FENCE.sub(lambda found: _shown(found[1], found[2], here), markdown)


def on_post_page(output: str, **_: Any) -> str:
    """Return a page whose wide blocks can be scrolled by keys, too."""
    return output.replace("<pre>", '<pre tabindex="0">')


def _section(heading: str, here: str) -> str:
    """Return a section of the README; its links lead to the same pages from here."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    found = re.search(rf"^#+ {re.escape(heading)}\n(.*?)(?=^#|\Z)", text, re.MULTILINE | re.DOTALL)
    if found is None:
        raise PluginError(f"the README has no section '{heading}'")
    folder = posixpath.join("docs", posixpath.dirname(here))
    return re.sub(
        r"\]\((docs/[^)]*)\)",
        lambda link: f"]({posixpath.relpath(link[1], folder)})",
        found[1].strip(),
    )


def _shown(kind: str, text: str, where: str) -> str:
    if kind != "console":
        Path(kind.partition(" ")[2]).write_text(text, encoding="utf-8")
        return f"```yaml\n{text}```"
    lines: list[str] = []
    for line in text.splitlines():
        command, _, code = line.removeprefix("$ ").partition("  # exit ")
        _, *arguments = shlex.split(command)
        done = CliRunner(env={"COLUMNS": "88"}).invoke(command_line(), arguments)
        if done.exit_code != int(code or 0):
            raise PluginError(f"{where}: '{command}' exits {done.exit_code}\n{done.output}")
        lines += [f"$ {command}", done.output.rstrip(), ""]
    return "\n".join(["```text", *lines[:-1], "```"])
