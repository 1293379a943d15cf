"""Pass the tests that name the module which a mutation has changed; tests/mutation.toml runs it."""

import re
import subprocess
import sys
from pathlib import Path


def naming(module: Path, pattern: str) -> list[Path]:
    """Return the files that import a module; a package is imported by its own name."""
    named = module.parent if module.stem == "__init__" else module.with_suffix("")
    *folder, name = named.parts
    package = re.escape(".".join(folder))
    listed = rf"from {package} import (\([^)]*|[^\n(]*)\b{name}\b"
    wanted = re.compile(rf"{package}\.{name}\b|{listed}")
    return [path for path in sorted(Path().glob(pattern)) if wanted.search(path.read_text("utf-8"))]


def main() -> int:
    """Run pytest on the tests of what git says is changed, or of its users where few name it."""
    words = ["git", "diff", "--name-only", "--", "flexcli"]
    changed = subprocess.run(words, capture_output=True, text=True, check=True).stdout.split()
    tests = {f"tests/test_docstrings.py::test_docstring_examples_run[{name}]" for name in (
        module.removesuffix(".py").replace("/", ".") for module in changed if "formulas" in module
    )}  # fmt: skip
    for module in map(Path, changed):
        own = naming(module, "tests/**/test_*.py")
        if "requirements" in module.parts:
            own += [Path("tests/parts/requirements"), Path("tests/parts/test_requirements.py")]
        elif len(own) < 2:
            users = naming(module, "flexcli/**/*.py")
            own += [test for user in users for test in naming(user, "tests/**/test_*.py")[:6]]
        tests.update(str(path) for path in own if "browser" not in path.parts)
    words = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *sorted(tests)]
    return subprocess.run(words, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
