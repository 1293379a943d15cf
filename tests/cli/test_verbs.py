"""Each verb as a user runs it: exit code, what is printed, what is written."""

import json

import pytest
import yaml


@pytest.fixture
def sized(tmp_path, sizing):
    path = tmp_path / "sized.yaml"
    path.write_text(sizing.design)
    return path


def edited(path, **sizes):
    spec = yaml.safe_load(path.read_text())
    spec["geometry"].update(sizes)
    path.write_text(yaml.safe_dump(spec))


def without_cost(document):
    """Return the checks without what two files of one design may differ in."""
    return [
        {key: row[key] for key in row if key not in ("cost", "place")} for row in document["checks"]
    ]


def test_the_written_design_passes_check_with_the_checks_of_the_sizing(flexure, sized, sizing):
    told = flexure("check", sized.name, "--format", "json")
    checking = json.loads(told.stdout)
    assert told.returncode == 0
    assert checking["status"] == sizing.document["status"] == "pass"
    assert without_cost(checking) == without_cost(sizing.document)


def test_every_check_tells_its_verdict_range_model_and_cost(sizing):
    """A verdict is no more than the range of the factor allows."""
    for check in sizing.document["checks"]:
        low, high = check["factor_range"]
        assert low <= check["factor"] <= high
        assert check["verdict"] == "pass"
        assert low >= check["required"]
        assert check["model"] in sizing.document["cost"]["by_model"]


def test_the_written_design_is_undecided_by_the_formulas_as_printed(flexure, sized):
    """Nobody can tell how far off they are under the force at take-off."""
    told = flexure("check", sized.name, "--model", "source", "--format", "json")
    document = json.loads(told.stdout)
    assert told.returncode == 1
    assert document["status"] == "undecided"
    assert {check["model"] for check in document["checks"]} == {"source"}
    verdicts = {
        check["name"]: (check["verdict"], check["factor_range"]) for check in document["checks"]
    }
    for name in ("buckling", "yield (fatigue-amplitude)"):
        assert verdicts[name] == ("undecided", None)
    verdict, (low, high) = verdicts["fatigue"]
    assert verdict == ("pass" if low >= 2.5 else "undecided")
    assert 2.45 <= low < high


@pytest.mark.slow
def test_a_written_design_finds_files_from_its_new_folder(flexure, tmp_path, example_text):
    (tmp_path / "mine.yaml").write_text(
        "flexure: 1\nmaterial: {youngs_modulus: 114 GPa, tensile_strength: 900 MPa, "
        "fatigue_amplitude: {value: 500 MPa, cycles: 1e7}}\n"
    )
    (tmp_path / "flexure.yaml").write_text(example_text.replace("ti-6al-4v-course", "mine.yaml"))
    (tmp_path / "out").mkdir()
    assert flexure("size", "--write", "out/sized.yaml").returncode == 0
    assert yaml.safe_load((tmp_path / "out/sized.yaml").read_text())["material"] == "../mine.yaml"
    assert flexure("check", "out/sized.yaml", "--allow-outside").returncode == 0
    told = flexure("check", "out/sized.yaml")
    assert told.returncode == 2
    assert "--allow-outside" in told.stderr


def test_a_design_that_fails_exits_1(flexure, sized):
    edited(sized, h="900 um")
    told = flexure("check", sized.name)
    assert told.returncode == 1
    assert "FAIL" in told.stdout


def test_many_files_end_with_the_worst_and_one_summary(flexure, sized, tmp_path):
    good, thick, bad = sized, tmp_path / "thick.yaml", tmp_path / "bad.yaml"
    thick.write_text(good.read_text())
    edited(thick, h="900 um")
    told = flexure("check", good.name, thick.name)
    assert told.returncode == 1
    assert "Summary" in told.stdout
    bad.write_text("flexure: 1\n")
    document = flexure("check", good.name, thick.name, bad.name, "--format", "json")
    assert document.returncode == 2
    statuses = [r["status"] for r in json.loads(document.stdout)["results"]]
    assert statuses == ["pass", "fail", "error"]


def test_a_name_is_printed_as_it_stands(flexure, sized):
    sized.write_text(sized.read_text().replace("take-off", "'[red] :rocket:'"))
    told = flexure("check", sized.name, COLUMNS="160").stdout
    assert told.count("buckling, [red] :rocket:") == 2, "in the table and with its source"


def test_an_infeasible_spec_exits_1_names_the_conflict_and_writes_nothing(
    flexure, tmp_path, example_text
):
    text = example_text.replace("l: free", "l: {free: [1 mm, 3 mm]}").replace(
        "objective: balanced", "objective: least-volume"
    )
    (tmp_path / "flexure.yaml").write_text(text)
    told = flexure("size", "--format", "json", "--write", "sized.yaml")
    document = json.loads(told.stdout)
    assert told.returncode == 1
    assert document["status"] == "infeasible"
    assert {"most l"} <= {row["name"] for row in document["sizing"]["conflict"]}
    assert not (tmp_path / "sized.yaml").exists()


def test_a_spec_with_findings_writes_nothing(flexure, tmp_path, example_text):
    (tmp_path / "flexure.yaml").write_text(example_text.replace("2 mm", "2"))
    assert flexure("size", "--write", "sized.yaml").returncode == 2
    assert [p.name for p in tmp_path.iterdir()] == ["flexure.yaml"]


def test_writing_into_a_missing_folder_is_one_line(flexure, tmp_path, example_text):
    (tmp_path / "flexure.yaml").write_text(example_text)
    told = flexure("size", "--model", "source", "--write", "none/sized.yaml")
    assert told.returncode == 2
    assert len(told.stderr.splitlines()) == 1


def test_validate_tells_the_kind_of_each_file(flexure, tmp_path):
    (tmp_path / "s.yaml").write_text("flexure: 1\nstroke: {rotation: 5 deg}\n")
    (tmp_path / "g.yaml").write_text(
        "flexure: 1\n"
        "geometry: {kind: rcc, p: 2 mm, half_angle: 45 deg, h: free, l: free, b: free}\n"
    )
    (tmp_path / "bad.yaml").write_text("flexure: 1\nstroke: {rotation: 5}\n")
    told = flexure("validate", "s.yaml", "g.yaml", "bad.yaml")
    assert told.returncode == 2
    assert "stroke" in told.stdout
    assert "geometry" in told.stdout
    assert "bad.yaml:2:20: stroke.rotation" in told.stderr


def test_materials_lists_and_shows_with_sources(flexure):
    assert "ti-6al-4v" in flexure("materials").stdout
    shown = json.loads(flexure("materials", "ti-6al-4v-course", "--format", "json").stdout)
    modulus = shown["materials"]["ti-6al-4v-course"]["properties"]["youngs_modulus"]
    assert modulus["value"] == 114e9
    assert modulus["status"] == "course"
    assert modulus["source"]


def test_an_unknown_material_gets_the_nearest_name(flexure):
    told = flexure("materials", "ti-6al4v")
    assert told.returncode == 2
    assert "did you mean 'ti-6al-4v'?" in told.stderr


def test_the_schema_accepts_every_key_of_the_example(flexure, example_text):
    schema = json.loads(flexure("schema").stdout)
    assert set(yaml.safe_load(example_text)) <= set(schema["properties"])
    assert schema["additionalProperties"] is False
