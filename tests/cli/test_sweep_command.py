"""``flexure sweep`` as a user runs it, and the points of a study."""

import csv
import json
from importlib import import_module
from pathlib import Path
from xml.etree import ElementTree

import pytest

import flexcli
from flexcli.parts.study import Study, points_of

STAGE = """\
flexure: 1
title: guide
material: ti-6al-4v
geometry: {kind: leaf-spring-stage, blades: 2, spacing: 20 mm, h: 0.2 mm, l: 40 mm, b: 10 mm}
stroke: {translation: 1 mm, cycles: 1e6}
requirements: {yield: 1.5, stiffness: {max: 2 N/mm}}
"""

H = ["0.1 mm", "0.2 mm", "0.3 mm", "0.4 mm"]


@pytest.fixture
def spec(tmp_path):
    path = tmp_path / "guide.yaml"
    path.write_text(STAGE, encoding="utf-8")
    return path


def table(path):
    with Path(path).open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def test_every_row_is_what_check_says_of_that_design(flexure, spec, tmp_path):
    done = flexure(
        "sweep", str(spec), "--vary", "geometry.h=0.1mm:0.4mm:4", "-o", "h.csv", "-j", "1"
    )
    rows = table(tmp_path / "h.csv")
    assert [row["geometry.h"] for row in rows] == H
    statuses = set()
    for row, h in zip(rows, H, strict=True):
        found = flexcli.check(spec, overrides={"geometry.h": h})
        assert row["status"] == found.status.value
        statuses.add(row["status"])
        assert float(row["k_stage [N/m]"]) == found.values["k_stage"].value
        for check in found.checks:
            assert float(row[f"factor of {check.full_name}"]) == check.factor
            assert row[f"verdict on {check.full_name}"] == check.verdict.value
    assert {"pass", "fail"} <= statuses  # thick blades are too stiff
    assert done.returncode == 1
    assert "of 4 designs pass" in done.stdout


def test_columns_are_told_by_the_ends_of_their_paths(flexure, spec):
    cases = "cases: {a: {stroke: {translation: 1 mm}}, b: {stroke: {translation: 1 mm}}}"
    spec.write_text(STAGE.replace("stroke: {translation: 1 mm, cycles: 1e6}", cases))
    ways = ("geometry.h=0.2mm", "cases.a.stroke.translation=1mm", "cases.b.stroke.translation=2mm")
    told = flexure("sweep", str(spec), *(word for way in ways for word in ("--vary", way)))
    heads = told.stdout.split("Study\n")[1].splitlines()[0].split()
    assert heads[:3] == ["geometry.h", "a.stroke.translation", "b.stroke.translation"]


def test_verdicts_alone_are_those_of_the_checks(flexure, spec, tmp_path):
    for each in ("check", "verdict"):
        flexure("sweep", str(spec), "--each", each, "--vary", "geometry.h=0.1mm:0.4mm:4",
               "-o", f"{each}.csv", "-j", "1")  # fmt: skip
    full, alone = (table(tmp_path / f"{each}.csv") for each in ("check", "verdict"))
    kept = ("geometry.h", "status", "decided by", "model", "reason")
    told = ("factor of", "factor over required of", "verdict on", "model of")
    assert set(alone[0]) == {name for name in full[0] if name in kept or name.startswith(told)}
    assert alone == [{name: row[name] for name in alone[0]} for row in full]


@pytest.mark.slow
def test_several_processes_give_the_same_file(flexure, spec, tmp_path):
    vary = ["--vary", "geometry.h=0.1mm:0.2mm:2", "--vary", "material=ti-6al-4v,6061-t6"]
    for jobs in ("1", "2"):
        flexure("sweep", str(spec), *vary, "-j", jobs, "-o", f"{jobs}.csv")
    assert (tmp_path / "1.csv").read_bytes() == (tmp_path / "2.csv").read_bytes()
    assert len(table(tmp_path / "1.csv")) == 4


@pytest.mark.slow
def test_a_spec_from_stdin_is_swept_in_several_processes(process, spec, tmp_path):
    vary = ["--vary", "geometry.h=0.1mm:0.2mm:8", "-j", "2", "-o"]
    with spec.open(encoding="utf-8") as stream:
        process("sweep", "-", *vary, "stdin.csv", stdin=stream)
    process("sweep", str(spec), *vary, "file.csv")
    assert (tmp_path / "stdin.csv").read_bytes() == (tmp_path / "file.csv").read_bytes()
    assert table(tmp_path / "file.csv")[0]["status"] == "pass"


def test_a_study_of_a_stranger_names_no_file_outside(flexure, spec, tmp_path):
    (tmp_path / "in").mkdir()
    (tmp_path / "own.yaml").write_text("flexure: 1\nmaterial: {name: own}\n", encoding="utf-8")
    text = STAGE + "study: {vary: {material: [../own.yaml]}}\n"
    (tmp_path / "in" / "guide.yaml").write_text(text, encoding="utf-8")
    told = flexure("sweep", "in/guide.yaml")
    assert told.returncode == 2
    assert "outside the spec's folder" in told.stdout


def test_a_row_without_an_answer_says_why_and_the_rest_go_on(flexure, spec, tmp_path):
    vary = ["--vary", "material=ti-6al-4v,no-such-metal"]
    done = flexure("sweep", str(spec), *vary, "-o", "m.csv", "-j", "1")
    good, bad = table(tmp_path / "m.csv")
    assert (good["status"], bad["status"]) == ("pass", "error")
    assert "no-such-metal" in bad["reason"]
    assert done.returncode == 1


def test_resume_keeps_what_is_done(flexure, spec, tmp_path):
    run = ["sweep", str(spec), "--vary", "geometry.h=0.1mm:0.4mm:4", "-o", "h.csv", "-j", "1"]
    flexure(*run)
    whole = (tmp_path / "h.csv").read_text(encoding="utf-8")
    lines = whole.splitlines(keepends=True)
    marked = lines[1].replace("pass", "pass", 1).replace(",closed-form,", ",by hand,", 1)
    (tmp_path / "h.csv").write_text("".join([lines[0], marked, lines[2]]), encoding="utf-8")
    assert flexure(*run).returncode == 2  # a file that exists is not replaced
    flexure(*run, "--resume")
    rows = table(tmp_path / "h.csv")
    assert [row["geometry.h"] for row in rows] == H
    assert rows[0]["model"] == "by hand"  # kept, not done again
    assert rows[3]["status"] == "fail"


def test_a_spec_may_say_its_study(flexure, spec, tmp_path):
    study = "study: {vary: {geometry.l: {from: 30 mm, to: 60 mm, points: 3, spacing: log}}}\n"
    spec.write_text(STAGE + study, encoding="utf-8")
    done = flexure("sweep", str(spec), "--format", "json", "-j", "1")
    content = json.loads(done.stdout)["study"]
    lengths = [float(row["point"]["geometry.l"].split()[0]) for row in content["rows"]]
    assert lengths == pytest.approx([30.0, (30.0 * 60.0) ** 0.5, 60.0])
    assert content["points"] == 3


def test_each_design_may_be_sized(flexure, spec, tmp_path):
    spec.write_text(STAGE.replace("h: 0.2 mm", "h: {free: [50 um, 1 mm]}"), encoding="utf-8")
    vary = ["--vary", "requirements.stiffness.min=0.1 N/mm,0.5 N/mm"]
    flexure(
        "sweep", str(spec), *vary, "--each", "size", "--model", "source", "-o", "s.csv", "-j", "1"
    )
    soft, stiff = (float(row["h [m]"]) for row in table(tmp_path / "s.csv"))
    assert stiff / soft == pytest.approx(5 ** (1 / 3), rel=1e-6)  # k grows with h³


def test_parquet_has_the_units_in_its_schema(flexure, spec, tmp_path):
    parquet = import_module("pyarrow.parquet")
    vary = ("--vary", "geometry.h=0.1mm:0.2mm:2", "--vary", "material=ti-6al-4v")
    flexure("sweep", str(spec), *vary, "-o", "h.parquet", "-j", "1")
    found = parquet.read_table(tmp_path / "h.parquet")
    assert found.num_rows == 2
    assert found["geometry.h"].to_pylist() == [0.1, 0.2]
    assert found.schema.field("geometry.h").metadata[b"unit"] == b"mm"
    assert found["material"].to_pylist() == ["ti-6al-4v"] * 2
    field = found.schema.field("k_stage")
    assert field.metadata[b"unit"] == b"N/m"
    one = flexcli.check(spec, overrides={"geometry.h": "0.1 mm"}).values["k_stage"].value
    assert found["k_stage"][0].as_py() == one


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ((), "nothing varies"),
        (("--vary", "geometry.h"), "has no '='"),
        (("--vary", "geometry.h=0.1mm:0.3um:3"), "write both in one unit"),
        (("--vary", "study.seed=1,2"), "vary itself"),
        (("--vary", "geometry.h=1mm,2mm", "-o", "h.xlsx"), "neither .csv nor .parquet"),
    ],
)
def test_what_cannot_be_swept_is_a_finding(flexure, spec, options, text):
    done = flexure("sweep", str(spec), *options)
    assert done.returncode == 2
    assert text in " ".join(done.stderr.split())


@pytest.mark.parametrize("sample", ["sobol", "latin-hypercube"])
def test_a_sample_is_spread_in_its_ranges_and_the_same_again(sample):
    study = Study.model_validate(
        {
            "vary": {
                "a": {"from": "1 mm", "to": "3 mm"},
                "b": {"from": "1 N", "to": "1e4 N", "spacing": "log"},
                "c": ["x", "y"],
            },
            "sample": sample,
            "points": 32,
            "seed": 5,
        }
    )
    points = points_of(study)
    assert points == points_of(study)
    assert points != points_of(study.model_copy(update={"seed": 6}))
    lengths = [float(point["a"].split()[0]) for point in points]
    forces = [float(point["b"].split()[0]) for point in points]
    assert len(points) == 32
    assert min(lengths) >= 1.0
    assert max(lengths) <= 3.0
    # both fill every fourth of a range with a fourth of the points; the log one in decades
    for k in range(4):
        assert sum(1 + k / 2 <= x < 1.5 + k / 2 for x in lengths) == 8
        assert sum(10.0**k <= x < 10.0 ** (k + 1) for x in forces) == 8
    assert sum(point["c"] == "x" for point in points) == 16


def circles(svg):
    """Return the marks of a plot, as (x, y, fill)."""
    found = ElementTree.fromstring(svg).iter("{http://www.w3.org/2000/svg}circle")
    return [(float(c.get("cx")), float(c.get("cy")), c.get("fill")) for c in found]


def test_a_plot_marks_every_design_by_how_it_ended(flexure, spec, tmp_path):
    done = flexure("sweep", str(spec), "--vary", "geometry.h=0.1mm:0.4mm:4", "-o", "h.csv",
                   "--plot", "h.svg", "-j", "1")  # fmt: skip
    statuses = [row["status"] for row in table(tmp_path / "h.csv")]
    marks = sorted(circles((tmp_path / "h.svg").read_text(encoding="utf-8")))
    assert len(marks) == 4
    fills = {status: {mark[2] for mark, s in zip(marks, statuses, strict=True) if s == status}
             for status in set(statuses)}  # fmt: skip
    assert all(len(each) == 1 for each in fills.values())
    assert len(set.union(*fills.values())) == len(fills)
    assert f"pass ({statuses.count('pass')})" in done.stderr
    # the margins of what is nearest its limit fall or stand lower where a design fails
    least = {status: max(m[1] for m, s in zip(marks, statuses, strict=True) if s == status)
             for status in ("pass", "fail")}  # fmt: skip
    assert least["fail"] > least["pass"]  # SVG counts downwards


def test_a_plot_of_a_value_has_a_curve_for_each_word(flexure, spec, tmp_path):
    flexure("sweep", str(spec), "--vary", "geometry.h=0.1mm:0.4mm:4", "--vary",
            "material=ti-6al-4v,6061-t6", "--value", "k_stage", "--plot", "k.svg",
            "-j", "1")  # fmt: skip
    text = (tmp_path / "k.svg").read_text(encoding="utf-8")
    assert all(word in text for word in ("ti-6al-4v", "6061-t6", "k_stage, N/mm", "geometry.h, mm"))
    assert len(circles(text)) == 8


def test_a_plot_of_two_numbers_is_a_map(flexure, spec, tmp_path):
    done = flexure("sweep", str(spec), "--vary", "geometry.h=0.1mm:0.4mm:4", "--vary",
                   "geometry.l=30mm:50mm:3", "--plot", "map.svg", "-j", "1")  # fmt: skip
    marks = circles((tmp_path / "map.svg").read_text(encoding="utf-8"))
    assert len({round(x, 1) for x, _, _ in marks}) == 4
    assert len({round(y, 1) for _, y, _ in marks}) == 3
    assert "factor over the required one from" in done.stderr.casefold()


def test_what_cannot_be_plotted_leaves_the_table(flexure, spec, tmp_path):
    done = flexure("sweep", str(spec), "--vary", "material=ti-6al-4v,6061-t6", "--plot", "m.svg",
                   "-j", "1")  # fmt: skip
    assert "designs pass" in done.stdout
    assert "nothing was written to m.svg" in done.stderr
    assert not (tmp_path / "m.svg").exists()


@pytest.mark.parametrize(("name", "there", "text"), [("m.pdf", False, ".svg nor .png"),
                                                     ("m.svg", True, "--force")])  # fmt: skip
def test_a_plot_that_cannot_be_written_is_said_before_the_work(
    flexure, spec, tmp_path, name, there, text
):
    if there:
        (tmp_path / name).write_text("mine", encoding="utf-8")
    done = flexure("sweep", str(spec), "--vary", "geometry.h=0.1mm:0.4mm:4", "--plot", name)
    assert done.returncode == 2
    assert text in done.stderr + done.stdout
    assert not there or (tmp_path / name).read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize(
    ("each", "example", "vary", "verb"),
    [
        ("balance", "force-balanced-stage", "mechanism.height=18mm,20mm", flexcli.balance),
        ("response", "boundary-control-random", "geometry.b=10mm,12mm", flexcli.asd_response),
        ("stops", "boundary-control", "geometry.b=10mm,12mm", flexcli.stops),
    ],
)
def test_a_row_has_the_values_of_any_verb(flexure, tmp_path, each, example, vary, verb):
    spec = Path(__file__).parents[2] / "examples" / example / "flexure.yaml"
    flexure("sweep", str(spec), "--each", each, "--vary", vary, "-o", "rows.csv", "-j", "1")
    path, _, values = vary.partition("=")
    for row, value in zip(table(tmp_path / "rows.csv"), values.split(","), strict=True):
        found = verb(spec, overrides={path: value})
        assert row["status"] == found.status.value
        assert found.values
        for name, one in found.values.items():
            told = row[f"{name} [{one.unit}]" if one.unit else name]
            assert float(told) == pytest.approx(one.value, rel=1e-9)


def test_a_model_is_refused_where_none_is_chosen(flexure, spec):
    done = flexure("sweep", str(spec), "--each", "simulate", "--model", "linear",
                   "--vary", "geometry.h=0.1mm,0.2mm")  # fmt: skip
    assert done.returncode == 2
    assert "simulate has models of its own" in done.stderr


def test_a_range_without_points_is_one_for_a_sample(flexure, spec):
    run = ("sweep", str(spec), "--sample", "sobol", "--points", "2", "--format", "json", "-j", "1")
    done = flexure(*run, "--vary", "geometry.h=0.1mm:0.2mm")
    found = json.loads(done.stdout)
    assert [row["status"] for row in found["study"]["rows"]] == ["pass", "pass"]


ROD = """\
flexure: 1
material: ti-6al-4v
geometry:
  kind: space-layout
  bodies: {tip: {at: [0 mm, 0 mm, 50 mm], mass: 10 g}}
  blades: {}
  rods: {one: {between: [ground, tip], from: [0 mm, 0 mm, 0 mm], to: [0 mm, 0 mm, 50 mm], d: 1 mm}}
  moving: tip
  motion: {translation: x}
requirements: {stiffness: {max: 1 N/um}}
"""


def test_a_resumed_table_in_space_is_that_of_one_run(flexure, tmp_path):
    """Freedoms are whole numbers, which stay so."""
    whole, halved, spec = (tmp_path / name for name in ("whole.csv", "halved.csv", "rod.yaml"))
    spec.write_text(ROD, encoding="utf-8")
    run = ("sweep", str(spec), "--vary", "geometry.rods.one.d=1mm,2mm", "-j", "1")
    flexure(*run, "-o", str(whole))
    halved.write_text("".join(whole.read_text().splitlines(keepends=True)[:2]))
    flexure(*run, "-o", str(halved), "--resume")
    assert halved.read_text() == whole.read_text()
