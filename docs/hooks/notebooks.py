"""The notebooks are run when the site is built: each cell with what it shows."""

import ast
import io
from contextlib import chdir, redirect_stdout
from pathlib import Path
from pprint import pformat
from typing import Any

from mkdocs.structure.files import File, Files

ROOT = Path(__file__).parents[2]


def on_files(files: Files, config: Any) -> Files:
    """Add a page and the pictures of each notebook."""
    for path in sorted((ROOT / "docs" / "notebooks").glob("*.py")):
        names: dict[str, Any] = {}
        page: list[str] = []
        cells = path.read_text(encoding="utf-8").split("# %%")[1:]
        for number, cell in enumerate(cells):
            head, _, body = cell.partition("\n")
            if "markdown" in head:
                page.append("\n".join(line.removeprefix("#")[1:] for line in body.splitlines()))
                continue
            page.append(f"```python\n{body.strip()}\n```")
            with chdir(ROOT):
                printed, value = _run(body, names)
            if hasattr(value, "_repr_svg_"):
                name = f"python/{path.stem}-{number}.svg"
                files.append(File.generated(config, name, content=value._repr_svg_()))
                page.append(f"![{value.kind}, drawn to scale]({path.stem}-{number}.svg)")
            elif hasattr(value, "_repr_html_"):
                page.append(value._repr_html_())
            elif printed or value is not None:
                shown = printed or pformat(value, width=88, sort_dicts=False)
                page.append(f"```text\n{shown.strip()}\n```")
        text = "\n\n".join(page)
        files.append(File.generated(config, f"python/{path.stem}.md", content=text))
    return files


def _run(body: str, names: dict[str, Any]) -> tuple[str, Any]:
    """Run a cell; return what it prints and the value of its last line."""
    tree = ast.parse(body)
    last = tree.body[-1]
    out = io.StringIO()
    with redirect_stdout(out):
        if not isinstance(last, ast.Expr):
            exec(compile(tree, "<cell>", "exec"), names)
            return out.getvalue(), None
        exec(compile(ast.Module(tree.body[:-1], []), "<cell>", "exec"), names)
        value = eval(compile(ast.Expression(last.value), "<cell>", "eval"), names)
    return out.getvalue(), value
