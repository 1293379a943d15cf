"""Print what a start of the command costs against importing what it stands on.

Bytecode is kept, as it is for users: without it our modules alone would be compiled at every start,
those of the libraries having been compiled as they were installed.

Run by hand: python tests/benchmarks/start_up.py
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter

sys.path.insert(0, str(Path(__file__).parents[1]))

from cli.test_start_up import EASY  # decided by the closed form alone

EXAMPLES = Path(__file__).parents[2] / "examples"
EXAMPLE = EXAMPLES / "rocket-parallel-stage" / "flexure.yaml"
REPEATS = 9
ENVIRONMENT = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
MAIN = "from flexcli.__main__ import main; main()"


def pair(first, second):
    """Return median seconds of two commands run in turn, and the median of their ratios."""
    times = []
    for _ in range(REPEATS + 1):
        row = []
        for command in (first, second):
            started = perf_counter()
            subprocess.run(
                [sys.executable, "-c", *command],
                stdout=subprocess.DEVNULL,
                check=True,
                timeout=60,
                env=ENVIRONMENT,
            )
            row.append(perf_counter() - started)
        times.append(row)
    warm = times[1:]
    ratio = median(a / b for a, b in warm)
    return median(a for a, _ in warm), median(b for _, b in warm), ratio


def main():
    with tempfile.TemporaryDirectory() as folder:
        sized = str(Path(folder) / "sized.yaml")
        easy = Path(folder) / "easy.yaml"
        easy.write_text(EASY, encoding="utf-8")
        command = [sys.executable, "-c", MAIN, "size", str(EXAMPLE), "--write", sized]
        subprocess.run(command, stdout=subprocess.DEVNULL, check=True, timeout=60)
        libraries = "import typer, pydantic, yaml, numpy"
        rows = (
            ("flexure --help", [MAIN, "--help"], "import typer", ["import typer"]),
            ("flexure check, easy", [MAIN, "check", str(easy)], libraries, [libraries]),
            ("flexure check, sized", [MAIN, "check", sized], libraries, [libraries]),
            (
                "flexure size",
                [MAIN, "size", str(EXAMPLE)],
                "import scipy.optimize",
                ["import scipy.optimize"],
            ),
        )
        for name, command, base_name, base in rows:
            own, other, ratio = pair(command, base)
            print(f"{name}: {own:.3f} s; {base_name}: {other:.3f} s; ratio {ratio:.2f}")


if __name__ == "__main__":
    main()
