"""The layers hold: which package may import which, no cycles, no printing below the report."""

import ast
import subprocess
import sys
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import flexcli

ROOT = Path(flexcli.__file__).parent

BASE = {"errors", "units", "results"}
"""L0: what everything may import."""

LAYERS = {
    "errors": set(),
    "units": {"errors"},
    "unit_patterns": {"errors", "units"},
    "results": {"errors"},
    "formulas": BASE | {"numerics"},
    "numerics": BASE,
    "mechanics": BASE | {"formulas", "numerics"},
    "parts": BASE | {"unit_patterns", "formulas", "numerics", "mechanics"},
    "spec": BASE | {"parts"},
    "engine": BASE | {"formulas", "numerics", "mechanics", "parts"},
    "report": BASE,
    "spectra": BASE | {"spec", "engine"},
    "api": BASE | {"parts", "spec", "engine", "report", "spectra"},
    "study": BASE | {"numerics", "parts", "api"},
    "cli": BASE | {"parts", "spec", "engine", "report", "api", "study"},
    "": {"api"},
    "__main__": {"cli"},
}
"""What each package may import, besides itself (the table of the design, layer by layer)."""

PRINTERS = {"rich", "typer", "logging"}


@cache
def modules():
    return tuple(sorted(ROOT.rglob("*.py")))


@cache
def name_of(path):
    parts = path.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


@cache
def names():
    return frozenset(name_of(path) for path in modules())


@cache
def tree_of(path):
    return ast.parse(path.read_text(encoding="utf-8"))


@cache
def imports_of(path):
    """Return the names of every module that a file imports, inside functions too."""
    found = set()
    for node in ast.walk(tree_of(path)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            inner = {f"{node.module}.{alias.name}" for alias in node.names}
            found |= {name if name in names() else node.module for name in inner}
    return frozenset(found)


def package_of(module):
    return module.split(".")[1] if module.count(".") else ""


def modules_of(package):
    found = [path for path in modules() if package_of(name_of(path)) == package]
    assert found
    return found


@pytest.mark.parametrize("own", sorted(LAYERS))
def test_imports_only_what_its_layer_may(own):
    for path in modules_of(own):
        for module in imports_of(path):
            other = package_of(module)
            if module.startswith("flexcli") and other not in ("", own):
                assert other in LAYERS[own], f"{name_of(path)} imports {module}"


def test_every_package_has_a_layer():
    found = {package_of(name) for name in names()}
    assert found == set(LAYERS)


def test_there_is_no_import_cycle():
    graph = {
        name_of(p): {m for m in imports_of(p) if m.startswith("flexcli.")} - {name_of(p)}
        for p in modules()
    }
    # a package's __init__ gathers its modules; what they import of the package is not a cycle
    packages = {name_of(p) for p in modules() if p.name == "__init__.py"}
    for name in packages:
        graph[name] = {m for m in graph[name] if not m.startswith(f"{name}.")}
    try:
        order = list(TopologicalSorter(graph).static_order())
    except CycleError as error:
        pytest.fail(f"import cycle: {error.args[1]}")
    assert set(order) >= set(graph)


@pytest.mark.parametrize("package", sorted(LAYERS.keys() - {"report", "cli"}))
def test_nothing_prints_below_the_report(package):
    for path in modules_of(package):
        called = [node.func for node in ast.walk(tree_of(path)) if isinstance(node, ast.Call)]
        name = name_of(path)
        assert "print" not in [func.id for func in called if isinstance(func, ast.Name)], name
        assert not {m.split(".")[0] for m in imports_of(path)} & PRINTERS, name


def test_the_command_line_imports_nothing_heavy_at_its_top():
    heavy = {"numpy", "scipy", "pint", "yaml", "pydantic", "rich"}
    for path in (ROOT / "cli").glob("*.py"):
        tree = tree_of(path)
        top = {
            alias.name.split(".")[0]
            for node in tree.body
            if isinstance(node, ast.Import)
            for alias in node.names
        } | {
            (node.module or "").split(".")[0]
            for node in tree.body
            if isinstance(node, ast.ImportFrom)
        }
        assert not top & heavy, path.name


def test_the_package_offers_what_the_api_does_and_imports_it_when_asked():
    from flexcli import api

    assert {*flexcli.__all__} - {"__version__"} == {*api.__all__}
    assert all(getattr(flexcli, name) is getattr(api, name) for name in api.__all__)
    code = "import sys, flexcli; print([m for m in sys.modules if 'numpy' in m or 'yaml' in m])"
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == "[]"
