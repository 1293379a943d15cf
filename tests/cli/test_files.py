"""Files that the user names: what is written, what is kept, what is never touched."""

import json
import os
import stat

import pytest
import yaml

SPEC = """\
# a pivot of our gimbal
flexure: 1
material: ti-6al-4v   # titanium
geometry:
  kind: rcc
  p: 2 mm
  half_angle: 45 deg
  h:                # thickness
    free: [0.1 mm, 1 mm]
  l: 10 mm
  b: {free: [1 mm, 3 mm]}  # within the gimbal

cases: {work: {stroke: {rotation: 2 deg}}}
requirements: {yield: 1, stiffness: {min: 0.3 N*m/rad}}
"""
PROFILE = ("asd", "scale", "gevs-qualification", "--db", "3")


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "flexure.yaml"
    path.write_text(SPEC)
    return path


def size(flexure, *more):
    return flexure("size", "--model", "source", *more)


def test_a_sized_design_keeps_comments_and_order_and_says_what_sized_it(flexure, spec, tmp_path):
    from flexcli import __version__

    told = json.loads(size(flexure, "--write", "sized.yaml", "--format", "json").stdout)
    lines = (tmp_path / "sized.yaml").read_text().splitlines()
    assert f"flexure {__version__} on 20" in lines[0]
    assert lines[0].startswith("#")
    was = SPEC.splitlines()
    same = [line for line in lines[1:] if line in was]
    assert [line for line in was if line not in lines] == [was[8], was[10]], "only what was free"
    assert same == [line for line in was if line in lines]
    assert next(line for line in lines if "# within the gimbal" in line).startswith("  b: ")
    read = yaml.safe_load("\n".join(lines))["geometry"]
    assert float(read["h"].split()[0]) == pytest.approx(
        told["values"]["h"]["value"] * 1e6, rel=1e-9
    )


def test_a_sized_design_has_what_was_set_on_the_command_line(flexure, spec, tmp_path):
    more = (
        "--set",
        "geometry.l=11 mm",
        "--set",
        "accuracy=5 %",
        "--set",
        "size.objective=least-volume",
    )
    size(flexure, *more, "--set", "requirements.stiffness.min=0.4 N*m/rad", "--write", "sized.yaml")
    text = (tmp_path / "sized.yaml").read_text()
    read = yaml.safe_load(text)
    assert read["geometry"]["l"] == "11 mm"
    assert read["accuracy"] == "5 %"
    assert read["size"] == {"objective": "least-volume"}
    assert read["requirements"] == {"yield": 1, "stiffness": {"min": "0.4 N*m/rad"}}
    assert "# titanium" in text


def test_a_design_with_an_alias_is_written_right_though_anew(flexure, spec, tmp_path):
    text = SPEC.replace("b: {free: [1 mm, 3 mm]}", "b: *any").replace(
        "h:                #", "h: &any  #"
    )
    spec.write_text(text)
    told = json.loads(size(flexure, "--write", "sized.yaml", "--format", "json").stdout)
    check = flexure("check", "sized.yaml", "--model", "source", "--format", "json")
    values = json.loads(check.stdout)["values"]
    assert [values[n]["value"] for n in "hb"] == [told["values"][n]["value"] for n in "hb"]


def test_a_sized_design_that_is_sized_again_has_one_note(flexure, spec, tmp_path):
    size(flexure, "--write", "sized.yaml")
    size(flexure, "sized.yaml", "--write", "again.yaml")
    assert (tmp_path / "again.yaml").read_text().count("sized by flexure") == 1


@pytest.mark.parametrize(
    "arguments", [("size", "--model", "source", "--write"), (*PROFILE, "--write")]
)
def test_a_file_is_replaced_only_by_force(flexure, spec, tmp_path, arguments):
    old = tmp_path / "old.yaml"
    old.write_text("mine")
    told = flexure(*arguments, "old.yaml")
    assert told.returncode == 2
    assert told.stderr.splitlines() == [
        "flexure: cannot write old.yaml: it exists; --force replaces it"
    ]
    assert told.stdout, "the result is printed all the same"
    assert old.read_text() == "mine"
    assert flexure(*arguments, "old.yaml", "--force").returncode != 2
    assert yaml.safe_load(old.read_text())["flexure"] == 1


def test_a_table_does_not_take_the_place_of_the_spec(flexure, spec):
    spec.write_text(
        SPEC.replace("    free: [0.1 mm, 1 mm]", "    0.2 mm").replace(
            "{free: [1 mm, 3 mm]}", "2 mm"
        )
    )
    before = spec.read_text()
    told = flexure("simulate", "--points", "2", "--csv", "flexure.yaml", "--format", "json")
    assert told.returncode == 2
    assert json.loads(told.stdout)["sweeps"]
    assert len(told.stderr.splitlines()) == 1
    assert spec.read_text() == before


@pytest.mark.parametrize("kind", ["device", "pipe", "folder", "stdin"])
def test_what_is_no_file_is_never_written_even_by_force(flexure, spec, tmp_path, kind):
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe.yaml")
    target = {"device": "/dev/null", "pipe": "pipe.yaml", "folder": "folder", "stdin": "-"}[kind]
    mode = os.stat("/dev/null").st_mode
    told = size(flexure, "--write", target, "--force", "--format", "json")
    assert told.returncode == 2
    assert len(told.stderr.splitlines()) == 1
    assert json.loads(told.stdout)["values"]
    assert os.stat("/dev/null").st_mode == mode
    assert stat.S_ISFIFO((tmp_path / "pipe.yaml").stat().st_mode)
    assert {p.name for p in tmp_path.rglob("*")} == {"flexure.yaml", "folder", "pipe.yaml"}


def test_a_link_keeps_its_target_and_a_file_its_mode(flexure, spec, tmp_path):
    (tmp_path / "store").mkdir()
    real, link, new = (
        tmp_path / "store" / "real.yaml",
        tmp_path / "link.yaml",
        tmp_path / "new.yaml",
    )
    real.write_text("old")
    real.chmod(0o640)
    link.symlink_to(real)
    new.symlink_to(tmp_path / "store" / "born.yaml")
    assert size(flexure, "--write", "link.yaml", "--force").returncode != 2
    assert size(flexure, "--write", "new.yaml").returncode != 2
    assert link.is_symlink()
    assert new.is_symlink()
    assert stat.S_IMODE(real.stat().st_mode) == 0o640
    assert yaml.safe_load(real.read_text())["flexure"] == 1
    assert {p.name for p in (tmp_path / "store").iterdir()} == {"real.yaml", "born.yaml"}


def test_nothing_to_write_is_said(flexure, spec, tmp_path):
    spec.write_text(SPEC.replace("0.3 N*m/rad", "1 kN*m/rad"))
    told = size(flexure, "--write", "sized.yaml")
    assert told.returncode == 1
    assert "nothing was written to sized.yaml: no sizes were chosen" in told.stderr
    assert not (tmp_path / "sized.yaml").exists()


def test_a_failed_write_leaves_nothing_behind(flexure, spec, tmp_path):
    (tmp_path / "file").write_text("")
    for target in ("none/sized.yaml", "file/sized.yaml", "x" * 300):
        told = size(flexure, "--write", target)
        assert told.returncode == 2
        assert len(told.stderr.splitlines()) == 1
        assert told.stdout
    assert {p.name for p in tmp_path.iterdir()} == {"flexure.yaml", "file"}
