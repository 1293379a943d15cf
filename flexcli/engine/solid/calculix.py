"""CalculiX: run a deck in a folder of its own, read back what it printed."""

import os
import re
import shutil
import subprocess
from collections.abc import Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import NoSolution

__all__ = ["Printed", "is_installed", "run"]

Floats = NDArray[np.float64]

PROGRAM = "ccx"

THREADS = "1"


class Printed(NamedTuple):
    """What a run left: the text of its .dat and .frd files, and the seconds that it took."""

    dat: str
    frd: str
    seconds: float

    def tables(self, what: str) -> Iterator[dict[int, Floats]]:
        """Yield the tables of the .dat file whose heading begins so: rows by node."""
        lines = iter(self.dat.splitlines())
        for line in lines:
            if not line.strip().startswith(what):
                continue
            next(lines, None)
            found: dict[int, Floats] = {}
            for row in lines:
                cells = row.split()
                if len(cells) < 2:
                    break
                found[int(cells[0])] = np.array([float(x) for x in cells[1:]])
            yield found

    def buckling(self) -> tuple[float, ...]:
        """Return the load factors of a buckling step, as they stand."""
        return tuple(row[0] for row in self._numbered("B U C K L I N G   F A C T O R"))

    def squares(self) -> tuple[float, ...]:
        """Return ω² of the modes of a frequency step [rad²/s²]."""
        return tuple(row[0] for row in self._numbered("E I G E N V A L U E   O U T P U T"))

    def _numbered(self, heading: str) -> Iterator[list[float]]:
        lines = iter(self.dat.splitlines())
        for line in lines:
            if line.strip().startswith(heading):
                break
        begun = False
        for line in lines:
            cells = line.split()
            if cells and re.fullmatch(r"\d+", cells[0]) and len(cells) > 1:
                begun = True
                yield [float(x) for x in cells[1:]]
            elif begun:
                return

    def fields(self, name: str) -> Iterator[dict[int, Floats]]:
        """Yield the fields of the .frd file of a name, step by step: components by node."""
        lines = iter(self.frd.splitlines())
        for line in lines:
            if line.startswith(" -4") and line.split()[1] == name:
                found: dict[int, Floats] = {}
                for row in lines:
                    if row.startswith(" -3"):
                        break
                    if row.startswith(" -1"):
                        cells = [row[i : i + 12] for i in range(13, len(row.rstrip()), 12)]
                        found[int(row[3:13])] = np.array([float(x) for x in cells])
                yield found


def is_installed() -> bool:
    """Return whether there is a CalculiX to run."""
    return shutil.which(PROGRAM) is not None


def run(deck: str, name: str, keep: Path | None = None) -> Printed:
    """Return what CalculiX prints of a deck; its files stay in the folder ``keep``, else nowhere.

    Raises
    ------
    NoSolution
        When it ends before it is done, with its last words.

    """
    begun = perf_counter()
    with TemporaryDirectory(prefix="flexure-") as folder:
        there = Path(folder)
        (there / f"{name}.inp").write_text(deck, encoding="ascii")
        threads = {"OMP_NUM_THREADS": os.environ.get("OMP_NUM_THREADS", THREADS)}
        ended = subprocess.run(
            [PROGRAM, "-i", name], cwd=there, env={**os.environ, **threads},
            capture_output=True, text=True, errors="replace", check=False,
        )  # fmt: skip
        texts: Mapping[str, str] = {
            end: (there / f"{name}.{end}").read_text(encoding="ascii", errors="replace")
            if (there / f"{name}.{end}").exists()
            else ""
            for end in ("dat", "frd")
        }
        if keep is not None:
            for end, text in texts.items():
                (keep / f"{name}.{end}").write_text(text, encoding="ascii", errors="replace")
    said = [line.strip() for line in ended.stdout.splitlines() if line.strip()]
    wrong = [line for line in said if "*ERROR" in line]
    if ended.returncode != 0 or wrong or "Job finished" not in ended.stdout:
        told = "; ".join(wrong) or (said[-1] if said else "it printed nothing")
        raise NoSolution(
            "calculix", f"CalculiX ended without an answer to {name}: {told}",
            "keep its deck with -o DIR and run ccx on it",
        )  # fmt: skip
    return Printed(texts["dat"], texts["frd"], perf_counter() - begun)
