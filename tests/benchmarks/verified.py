"""Random joints of the campaign beside solid elements of CalculiX, which share no code with models.

Run: python tests/benchmarks/verified.py [specs] [--first SEED] [--kinds KIND …] [--limit SECONDS]
[--model MODEL] [--space]: mechanisms in space, of blades and rods that point any way.
Each design is meshed and compared by `flexure verify`; a number that is apart from that of solids
by more than both errors is printed, with both. What takes longer than the limit is left out.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import yaml

sys.path.insert(0, str(Path(__file__).parents[1]))

from twins.campaign import KINDS, scene
from twins.space_scenes import space_scene

FLEXURE = str(Path(sys.executable).with_name("flexure"))


def verified(spec: dict, limit: float, model: str | None) -> tuple[int, dict]:
    """Return the exit code of `flexure verify` and what it printed."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "spec.yaml"
        file.write_text(yaml.safe_dump(spec))
        command = [FLEXURE, "verify", str(file), "--format", "json", "--time-limit", f"{limit}"]
        command += ["--model", model] if model else []
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, json.loads(done.stdout) if done.returncode in (0, 1) else {}


def main() -> None:
    """Print the numbers that solids put in question, and how many were compared."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("specs", type=int, nargs="?", default=30)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--kinds", nargs="*")
    parser.add_argument("--limit", type=float, default=120.0)
    parser.add_argument("--model")
    parser.add_argument("--space", action="store_true")
    asked = parser.parse_args()
    ended, compared, apart = Counter(), Counter(), Counter()
    for seed in range(asked.first, asked.first + asked.specs):
        drawn = space_scene(seed) if asked.space else scene(seed, tuple(asked.kinds or KINDS))
        code, found = verified({**drawn.spec, "requirements": drawn.easy}, asked.limit, asked.model)
        ended[code] += 1
        for row in (found.get("verification") or {}).get("numbers", []):
            compared[row["name"].split("_")[0]] += row["agrees"] is not None
            if row["agrees"] is False:
                apart[row["name"].split("_")[0]] += 1
                print(
                    f"{seed} {drawn.kind}: {row['name']} {row['model']!r} {row['model_error']}",
                    f"solid {row['solid']!r} {row['solid_error']!r} apart {row['apart']:+.4f}",
                    flush=True,
                )
    print(f"{sum(compared.values())} numbers of {ended} ends compared: {dict(compared)}")
    print(f"{sum(apart.values())} apart: {dict(apart)}")


if __name__ == "__main__":
    main()
