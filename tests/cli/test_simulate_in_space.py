"""The stroke of a mechanism in space, on screen, in a file and as JSON."""

import json
from pathlib import Path

GUIDE = Path(__file__).parents[2] / "examples" / "leaf-spring-guide" / "flexure.yaml"


def test_the_support_over_the_stroke_is_on_screen_and_in_the_file(flexure, tmp_path):
    told = flexure("simulate", str(GUIDE), "--points", "3", "--csv", "stroke.csv")
    assert told.returncode == 0, told.stderr
    assert "Support over the stroke, drive locked" in told.stdout
    heading, *rows = (tmp_path / "stroke.csv").read_text(encoding="utf-8").splitlines()
    assert heading.startswith("case,travel [m],effort [N],stiffness [N/m]")
    assert len(rows) == 3


def test_json_has_every_travel_and_null_for_what_is_held(flexure):
    told = flexure("simulate", str(GUIDE), "--points", "2", "--format", "json")
    found = json.loads(told.stdout)
    (sweep,) = found["space_sweeps"]
    first, last = sweep["points"]
    stiffness = sorted(point["stiffness"] for point in sweep["points"])
    assert [found["values"][name]["value"] for name in ("k_least", "k_most")] == stiffness
    assert first["travel"] == -last["travel"] == -20e-3
    assert last["k_x"] is None
    assert last["k_z"] > 0.0
    assert last["frequency"] > 0.0
