"""``flexure verify`` without ccx, and what it refuses."""

import json
from pathlib import Path

import pytest

SPEC = """\
flexure: 1
material: {name: ours, youngs_modulus: 114 GPa, poisson_ratio: 0.3}
geometry: {kind: cantilever, h: 0.5 mm, l: 20 mm, b: 2 mm}
cases:
  a: {stroke: {translation: 1 mm}}
requirements: {parasitic_shift: {max: 0.1 mm}}
"""


@pytest.fixture
def no_ccx(tmp_path, monkeypatch):
    """Have no program on the way."""
    monkeypatch.setenv("PATH", str(tmp_path))
    (tmp_path / "flexure.yaml").write_text(SPEC)


@pytest.mark.usefixtures("no_ccx")
def test_without_ccx_it_says_so_and_what_to_compare(flexure, tmp_path):
    told = flexure("verify")
    assert told.returncode == 1
    assert "UNDECIDED" in told.stdout
    assert "calculix-ccx" in told.stdout
    assert "stiffness at rest" in told.stdout
    assert [path.name for path in tmp_path.iterdir()] == ["flexure.yaml"]


@pytest.mark.usefixtures("no_ccx")
def test_its_decks_are_written_where_asked_and_nothing_is_replaced(flexure, tmp_path):
    told = flexure("verify", "-o", "decks", "--format", "json")
    content = json.loads(told.stdout)
    rows = content["verification"]["numbers"]
    assert content["status"] == "undecided"
    assert all(row["solid"] is None and row["agrees"] is None for row in rows)
    assert {row["name"] for row in rows} >= {"k_stage", "support_z", "k_end", "shift", "sigma"}
    written = {path.name for path in (tmp_path / "decks").iterdir()}
    assert "rest-mesh-1.inp" in written
    assert all(name.endswith(".inp") for name in written)
    again = flexure("verify", "-o", "decks")
    assert again.returncode == 2
    assert "--force" in again.stderr


@pytest.mark.usefixtures("no_ccx")
@pytest.mark.parametrize(
    ("asked", "options"),
    [("", ()), ("", ("--only", "support_z_end")), ("drive: locked, at: full-stroke", ())],
)
def test_support_at_stroke_is_compared_where_somebody_asks_for_it(
    flexure, tmp_path, asked, options
):
    if asked:
        support = f"requirements: {{support: {{direction: z, min: 1 N/m, {asked}}}}}\n"
        spec = SPEC.partition("requirements")[0] + support
        (tmp_path / "flexure.yaml").write_text(spec)
    told = flexure("verify", *options, "--format", "json")
    rows = json.loads(told.stdout)["verification"]["numbers"]
    assert any(row["name"] == "support_z_end" for row in rows) == bool(asked or options)


@pytest.mark.usefixtures("no_ccx")
def test_blades_that_meet_in_a_point_are_no_solid(flexure, tmp_path):
    crossed = SPEC.replace(
        "{kind: cantilever, h: 0.5 mm, l: 20 mm, b: 2 mm}",
        "{kind: unseparated-cross, half_angle: 45 deg, h: 0.5 mm, l: 20 mm, b: 2 mm}",
    ).replace("translation: 1 mm", "rotation: 1 mrad")
    (tmp_path / "crossed.yaml").write_text(crossed)
    told = flexure("verify", "crossed.yaml")
    assert told.returncode == 2
    assert "meet in a point" in told.stderr


@pytest.mark.usefixtures("no_ccx")
def test_what_draws_no_blades_says_so(flexure, tmp_path):
    bar = SPEC.replace("{kind: cantilever, h: 0.5 mm, l: 20 mm, b: 2 mm}",
                       "{kind: torsion-bar, h: 1 mm, l: 20 mm, b: 2 mm}")  # fmt: skip
    (tmp_path / "bar.yaml").write_text(bar.replace("translation: 1 mm", "rotation: 1 mrad"))
    told = flexure("verify", "bar.yaml")
    assert told.returncode == 2
    assert "not made of straight blades" in told.stderr


@pytest.mark.usefixtures("no_ccx")
def test_a_mechanism_in_space_is_compared_at_rest(flexure):
    path = str(Path(__file__).parents[2] / "examples" / "tripod-mount" / "flexure.yaml")
    told = flexure("verify", path, "--format", "json")
    content = json.loads(told.stdout)
    names = {row["name"] for row in content["verification"]["numbers"]}
    supports = {f"support_{way}" for way in ("x", "y", "z", "theta_x", "theta_y", "theta_z")}
    assert names == {"k_stage", "f_0", *supports}
    assert "at-rest" in {note["code"] for note in content["warnings"]}


@pytest.mark.usefixtures("no_ccx")
def test_clamps_that_give_are_compared_as_rigid_ones(flexure, tmp_path):
    giving = SPEC.replace("b: 2 mm}", "b: 2 mm, clamps: monolithic}")
    (tmp_path / "giving.yaml").write_text(giving)
    rows = {}
    for name in ("giving.yaml", "flexure.yaml"):
        content = json.loads(
            flexure("verify", name, "--only", "k_stage", "--format", "json").stdout
        )
        rows[name] = content["verification"]["numbers"][0]["model"]
        told = {note["code"] for note in content["warnings"]}
        assert ("rigid-clamps" in told) == (name == "giving.yaml")
    assert rows["giving.yaml"] == rows["flexure.yaml"]


@pytest.mark.slow
@pytest.mark.usefixtures("no_ccx")
def test_accuracy_with_solids_says_without_ccx_which_decks_there_are(flexure, tmp_path):
    told = flexure("accuracy", "--solid", "-o", "decks")
    assert "solid" not in [line.split()[0] for line in told.stdout.splitlines() if line.split()]
    assert "calculix-ccx" in told.stdout
    assert "rest-mesh-1" in told.stdout
    assert (tmp_path / "decks" / "rest-mesh-1.inp").is_file()
    plain = flexure("accuracy")
    assert plain.returncode == told.returncode
    assert "calculix" not in plain.stdout
