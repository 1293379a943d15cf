"""``flexure asd`` as a user runs it: exit code, what is printed, what is written."""

import csv
import json
import math
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "rocket-parallel-stage" / "flexure.yaml"
CONTRACT = {"flexure", "command", "version", "spec", "status", "values", "warnings", "findings",
            "cost"}  # fmt: skip

GOOD = """flexure: 1
asd:
  points:
    - {frequency: 20 Hz, level: 0.02 g^2/Hz}
    - {frequency: 200 Hz, level: 0.2 g^2/Hz}
    - {frequency: 2000 Hz, level: 0.2 g^2/Hz}
"""


def answer(told):
    assert told.returncode == 0, told.stderr
    return json.loads(told.stdout)


@pytest.mark.parametrize(
    "arguments",
    [
        ["list"],
        ["show", "gevs-qualification"],
        ["grms", "gevs-acceptance", "falcon-payload"],
        ["envelope", "gevs-acceptance", "falcon-payload"],
        ["scale", "gevs-acceptance", "--db", "-3"],
        ["worst-case", "exercise-9-rocket", "--q", "100"],
    ],
    ids=lambda arguments: arguments[0],
)
def test_every_command_keeps_the_contract(flexure, arguments):
    document = answer(flexure("asd", *arguments, "--format", "json"))
    assert set(document) >= CONTRACT
    assert document["command"] == f"asd {arguments[0]}"
    assert document["status"] == "pass"
    assert flexure("asd", *arguments).stdout.startswith(f"PASS  asd {arguments[0]}")


def test_the_list_shows_computed_and_published_and_status(flexure):
    rows = {
        row["name"]: row for row in answer(flexure("asd", "list", "--format", "json"))["profiles"]
    }
    assert rows["gevs-qualification"]["status"] == "verified"
    assert rows["gevs-qualification"]["g_rms"] == pytest.approx(14.14 * 9.80665, rel=1e-3)
    assert rows["mil-std-1540b-unit-acceptance"]["status"] == "unverified"
    line = next(x for x in flexure("asd", "list").stdout.splitlines() if x.startswith("gevs-q"))
    assert line.split()[1:6] == ["14.14", "g", "14.1", "g", "verified"]


def test_show_gives_slopes_and_sources(flexure):
    text = flexure("asd", "show", "gevs-qualification").stdout
    for word in ("+5.97 dB/oct", "GSFC-STD-7000", "Table 2.4-3", "verified", "g_rms", "m_4"):
        assert word in text


def test_exercise_9_gives_251_g_at_2000_hz(flexure):
    text = flexure("asd", "worst-case", "exercise-9-rocket", "--q", "100").stdout
    assert "251 g" in text
    assert "2000 Hz" in text


def test_the_design_gives_the_number_that_size_prints(flexure, sizing):
    sizing = sizing.document["values"]
    found = answer(flexure("asd", "worst-case", str(EXAMPLE), "--format", "json"))["values"]
    for name in ("g_rms_worst", "f_worst"):
        assert found[name]["value"] == pytest.approx(sizing[name]["value"], rel=1e-12)


def test_worst_case_takes_the_design_of_the_folder_and_another_q(flexure, tmp_path, example_text):
    (tmp_path / "flexure.yaml").write_text(example_text)
    rows = answer(flexure("asd", "worst-case", "--q", "25", "--q", "400", "--format", "json"))
    low, high = (row["g_rms_worst"] for row in rows["worst_cases"])
    assert high == pytest.approx(4 * low, rel=1e-12)  # √Q


def test_the_rms_over_frequency_is_a_table_whose_greatest_is_the_worst_case(flexure, tmp_path):
    (tmp_path / "flat.yaml").write_text(GOOD)
    told = flexure(
        "asd", "worst-case", "flat.yaml", "--q", "100", "-o", "rms.csv", "--format", "json"
    )
    with (tmp_path / "rms.csv").open() as file:
        rows = [
            {k.split(" [")[0]: float(x) for k, x in row.items()} for row in csv.DictReader(file)
        ]
    worst = answer(told)["worst_cases"][0]["g_rms_worst"]
    assert max(row["miles"] for row in rows) == pytest.approx(worst, rel=1e-12)
    for row in rows:
        miles = math.sqrt(math.pi / 2 * row["frequency"] * 100 * row["level"])
        assert row["miles"] == pytest.approx(miles, rel=1e-12)
    # far inside a flat part Miles' white noise is what the oscillator sees
    middle = min(rows, key=lambda row: abs(math.log(row["frequency"] / 630)))
    assert middle["exact"] == pytest.approx(middle["miles"], rel=0.01)


def test_a_written_envelope_validates_and_serves_a_design(flexure, tmp_path, example_text):
    told = flexure("asd", "envelope", "gevs-acceptance", "falcon-payload", "--write", "mine.yaml")
    assert told.returncode == 0
    assert flexure("validate", "mine.yaml").returncode == 0
    assert flexure("asd", "validate", "mine.yaml").returncode == 0
    (tmp_path / "flexure.yaml").write_text(example_text.replace("exercise-9-rocket", "mine.yaml"))
    assert flexure("asd", "worst-case").returncode == 0


def test_a_written_profile_holds_the_same_floats(flexure, tmp_path):
    (tmp_path / "good.yaml").write_text(GOOD)
    scaled = answer(flexure(
        "asd", "scale", "good.yaml", "--db", "1.7", "--write", "s.yaml", "--format", "json",
    ))  # fmt: skip
    again = answer(flexure("asd", "show", "s.yaml", "--format", "json"))
    assert again["breakpoints"] == scaled["breakpoints"]
    assert again["values"] == scaled["values"]


def test_a_step_is_no_number_in_json(flexure, tmp_path):
    more = ("2000 Hz, level: 0.1 g^2/Hz, step: true", "3000 Hz, level: 0.1 g^2/Hz")
    stepped = GOOD + "".join(f"    - {{frequency: {point}}}\n" for point in more)
    (tmp_path / "step.yaml").write_text(stepped)
    rows = answer(flexure("asd", "show", "step.yaml", "--format", "json"))["breakpoints"]
    assert [row["slope"] for row in rows][2:] == [None, 0.0, None]
    assert "step" in flexure("asd", "show", "step.yaml").stdout


WRONG = {
    "unsorted": ("200 Hz", "20000 Hz", 6, "frequencies must rise"),
    "duplicate": ("2000 Hz", "200 Hz", 6, "this point stands twice"),
    "zero": ("0.02 g", "0 g", 4, "must be above 0"),
    "negative": ("0.02 g", "-0.02 g", 4, "must be above 0"),
    "unit": ("0.02 g^2/Hz", "0.02 g", 4, "does not measure"),
    "no unit": ("20 Hz,", "20,", 4, "has no unit"),
}


@pytest.mark.parametrize("mistake", WRONG)
@pytest.mark.parametrize("verb", ["validate", "show", "grms", "worst-case"])
def test_bad_profiles_are_findings_with_their_line(flexure, tmp_path, verb, mistake):
    old, new, line, text = WRONG[mistake]
    assert GOOD.count(old) >= 1
    (tmp_path / "bad.yaml").write_text(GOOD.replace(old, new, 1))
    q = ["--q", "10"] if verb == "worst-case" else []
    told = flexure("asd", verb, "bad.yaml", *q, "--format", "json")
    assert told.returncode == 2
    (finding,) = json.loads(told.stdout)["findings"]
    assert finding["line"] == line
    assert text in finding["text"]
    plain = flexure("asd", verb, "bad.yaml", *q)
    assert plain.stderr.startswith(f"bad.yaml:{line}:")
    assert plain.returncode == 2


def test_one_point_is_no_profile(flexure, tmp_path):
    (tmp_path / "bad.yaml").write_text("".join(GOOD.splitlines(keepends=True)[:4]))
    told = flexure("asd", "validate", "bad.yaml")
    assert told.returncode == 2
    assert "two points or more" in told.stderr


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (["worst-case", "gevs-acceptance"], "a profile needs a quality factor"),
        (["worst-case", "gevs-acceptance", "--q", "0"], "0 is no quality factor"),
        (["worst-case", "gevs-acceptance", "--q", "-3"], "-3 is no quality factor"),
        (["worst-case", "gevs-acceptance", "--q", "nan"], "nan is no quality factor"),
        (["worst-case", "gevs-acceptance", "--q", "0.3"], "critical damping"),
        (["worst-case", "gevs-acceptance", "--q", "9", "--duration", "60"], "has no unit"),
        (["worst-case", "gevs-acceptance", "--q", "9", "--duration", "0 s"], "above 0"),
        (["worst-case", "gevs"], "there is no shipped asd"),
        (["worst-case"], "there is no such file"),
        (["show", "nothing.yaml"], "nothing.yaml"),
        (["show", str(EXAMPLE)], "is a design, not an ASD profile"),
        (["scale", "gevs-acceptance", "--db", "3", "--write", "mine.txt"], "end it in .yaml"),
        (["scale", "gevs-acceptance", "--db", "nan"], "give decibels"),
    ],
)
def test_bad_usage_exits_2_and_says_what_would_be_right(flexure, arguments, text):
    told = flexure("asd", *arguments)
    assert told.returncode == 2
    assert told.stdout == ""
    assert text in told.stderr


def test_a_design_without_vibration_has_no_worst_case(flexure, tmp_path, example_text):
    lines = example_text.splitlines(keepends=True)
    calm = [x for x in lines if "asd:" not in x and "take-off" not in x and "lock:" not in x]
    calm = [x for x in calm if "buckling" not in x]
    (tmp_path / "flexure.yaml").write_text("".join(calm))
    told = flexure("asd", "worst-case")
    assert told.returncode == 2
    assert "no case has an asd" in told.stderr


def test_many_files_end_with_the_worst(flexure, tmp_path):
    (tmp_path / "good.yaml").write_text(GOOD)
    (tmp_path / "bad.yaml").write_text(GOOD.replace("0.02", "0", 1))
    told = flexure("asd", "validate", "good.yaml", "bad.yaml", "--format", "json")
    assert told.returncode == 2
    assert [r["status"] for r in json.loads(told.stdout)["results"]] == ["pass", "error"]
