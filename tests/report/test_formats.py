"""Every format from results made by hand: what it must say, and what its readers accept."""

import json
import re
from dataclasses import fields, replace
from math import inf, nan
from xml.etree import ElementTree

import pytest

from flexcli.errors import Finding
from flexcli.report.as_text import SECTIONS, findings_text
from flexcli.report.formats import Format, Page, Report
from flexcli.results import Check, Cost, Note, PassedOver, Place, Result, Status, Value, Verdict
from flexcli.results.result import HEADER
from flexcli.results.sizing import Relaxation, SizingResult

NASTY = "a|b, 50% ::`<&>`\x1b[31m\x9b1m\n*"
"""A name that means something to every format, and to terminals."""


def check(name="fatigue", verdict=Verdict.FAIL, factor=2.3, line=7, **changes):
    given = {
        "name": name, "case": "operation", "quantity": "bending stress", "demand": 217.3e6,
        "capacity": 500e6, "unit": "Pa", "factor": factor, "required": 2.5, "verdict": verdict,
        "source": "a book", "factor_range": (0.99 * factor, 1.01 * factor), "model": "exact",
        "seconds": 0.01, "place": Place("flexure.yaml", line, 3, f"requirements.{name}"),
    }  # fmt: skip
    return Check(**{**given, **changes})


NOT_JUDGED = check("shock", Verdict.NOT_JUDGED, nan, 9, demand=nan, capacity=nan,
                   factor_range=None, required=nan)  # fmt: skip
CHECKS = (
    check("yield", Verdict.PASS, 4.0, 6),
    check(),
    check("buckling", Verdict.UNDECIDED, 2.51, 8, factor_range=(2.4, 2.6)),
    NOT_JUDGED,
    check(NASTY, Verdict.FAIL, 1.0, 10),
    check("sag", Verdict.PASS, inf, 11),
)
FAILING = Result(
    "check", "flexure.yaml", Status.FAIL, "a stage", checks=CHECKS, cost=Cost(0.5, "exact", 0.01),
    warnings=(Note("no-density", "the density is missing: 50%"),),
)  # fmt: skip
FINDINGS = Result(
    "check", "bad.yaml", Status.ERROR,
    findings=(Finding("bad.yaml", "has no unit", "write 2 mm", "geometry.h", 3, 6, "  h: 2"),),
)  # fmt: skip
INFEASIBLE = Result(
    "size", "small.yaml", Status.INFEASIBLE,
    sizing=SizingResult("volume", "", conflict=(Relaxation("most l", 1.2, "give way"),)),
)  # fmt: skip
PASSING = replace(FAILING, status=Status.PASS, checks=CHECKS[:1], warnings=())
SOUND = Result("validate", "flexure.yaml", Status.PASS)
ALL = (FAILING, FINDINGS, INFEASIBLE, PASSING, SOUND)
MACHINES = [each for each in Format if each not in (Format.TEXT, Format.JSON)]


def told(style, *results, encoding="utf-8", width=100):
    report = Report(results[0].command, results, len(results) > 1)
    return style.render(report, Page(width, encoding=encoding))


@pytest.mark.parametrize("style", Format)
def test_every_format_names_each_problem_with_its_requirement(style):
    text = told(style, FAILING, INFEASIBLE)
    for word in ("fatigue", "buckling", "shock", "most l", "2.3"):
        assert word in text


@pytest.mark.parametrize("style", MACHINES)
def test_a_problem_has_its_line_and_a_pass_has_none(style):
    text = told(style, FAILING)
    for line in (7, 8, 9):
        assert re.search(rf"\b{line}\b", text)
    assert not re.search(r"fatigue.*\n?.*FAIL", told(style, PASSING))


@pytest.mark.parametrize("style", MACHINES)
def test_a_finding_is_an_error_with_its_line(style):
    text = told(style, FINDINGS)
    assert "geometry.h" in text
    assert "write 2 mm" in text
    assert re.search(r"bad\.yaml.*\b3\b|\b3\b", text)


@pytest.mark.parametrize("style", Format)
@pytest.mark.parametrize("encoding", ["ascii", "cp1252", "latin-1", "utf-8"])
def test_no_format_lets_a_name_steer_a_terminal_or_needs_more_than_the_encoding(style, encoding):
    text = told(style, *ALL, encoding=encoding)
    assert not set(text) & (set(map(chr, range(32))) - {"\n"} | set(map(chr, range(127, 160))))
    text.encode(encoding)


@pytest.mark.parametrize("style", Format)
def test_of_many_results_each_is_told(style):
    text = told(style, *ALL)
    for spec in ("flexure.yaml", "bad.yaml", "small.yaml"):
        assert spec.split(".")[0] in text


def test_every_section_of_a_result_has_its_renderer():
    assert set(SECTIONS) == {field.name for field in fields(Result)} - HEADER


# JSON


def test_json_tells_places_and_always_a_cost():
    document = json.loads(told(Format.JSON, FAILING))
    assert document["checks"][1]["place"]["line"] == 7
    assert document["cost"]["seconds"] == 0.5
    assert json.loads(told(Format.JSON, FINDINGS))["cost"]["seconds"] is None
    assert "cost" in json.loads(told(Format.JSON, *ALL))


def test_json_gives_names_back_whatever_the_encoding():
    for encoding in ("ascii", "utf-8"):
        document = json.loads(told(Format.JSON, FAILING, encoding=encoding))
        assert document["checks"][4]["name"] == NASTY


# JUnit, by the rules of the XML schema of Ant's JUnit task (Windy Road's JUnit.xsd)

SUITE = {"name", "timestamp", "hostname", "tests", "failures", "errors", "time", "package", "id"}
CASE = {"name", "classname", "time"}


def test_junit_has_what_the_schema_of_ant_asks_for():
    root = ElementTree.fromstring(told(Format.JUNIT, *ALL))
    assert root.tag == "testsuites"
    for number, suite in enumerate(root):
        assert suite.tag == "testsuite"
        assert set(suite.attrib) == SUITE
        assert suite.get("id") == str(number)
        assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d", suite.get("timestamp"))
        cases = suite.findall("testcase")
        order = ["properties", *["testcase"] * len(cases), "system-out", "system-err"]
        assert [child.tag for child in suite] == order
        for case in cases:
            assert set(case.attrib) == CASE
            assert case.get("name") == " ".join(case.get("name").split()) != ""  # an xs:token
            assert re.fullmatch(r"\d+(\.\d+)?", case.get("time"))  # an xs:decimal
            assert [child.tag for child in case] in ([], ["failure"], ["error"])
            assert all(child.get("type") for child in case)
        assert suite.get("tests") == str(len(cases)) != "0"
        assert suite.get("failures") == str(len(suite.findall("testcase/failure")))
        assert suite.get("errors") == str(len(suite.findall("testcase/error")))


def test_junit_fails_the_cases_that_do_not_pass():
    suite = ElementTree.fromstring(told(Format.JUNIT, FAILING))[0]
    failed = {case.get("name").split(",")[0] for case in suite.iter("testcase") if len(case)}
    assert {"fatigue", "buckling", "shock"} <= failed
    assert failed.isdisjoint({"yield", "sag"})
    text = next(case[0].text for case in suite.iter("testcase") if "fatigue" in case.get("name"))
    assert text.startswith("flexure.yaml:7:3: ")


# SARIF, by the properties that version 2.1.0 requires (sections 3.13 to 3.30)


def test_sarif_has_what_the_standard_requires():
    log = json.loads(told(Format.SARIF, *ALL))
    assert log["version"] == "2.1.0"
    assert log["$schema"].endswith("sarif-2.1.0.json")
    (run,) = log["runs"]
    driver = run["tool"]["driver"]
    assert driver["name"] == "flexure"
    rules = [rule["id"] for rule in driver["rules"]]
    assert len(set(rules)) == len(rules)
    for result in run["results"]:
        assert result["ruleId"] in rules
        assert result["level"] in ("none", "note", "warning", "error")
        assert result["message"]["text"]
        for location in result["locations"]:
            physical = location["physicalLocation"]
            assert re.fullmatch(r"[\w./%~-]+", physical["artifactLocation"]["uri"])
            assert physical.get("region", {"startLine": 1})["startLine"] >= 1
            assert physical.get("region", {"startColumn": 1})["startColumn"] >= 1


def test_sarif_says_whether_the_tool_could_do_its_work():
    def successful(result):
        return json.loads(told(Format.SARIF, result))["runs"][0]["invocations"][0]

    assert successful(FAILING) == {"executionSuccessful": True}
    assert successful(FINDINGS) == {"executionSuccessful": False}


def test_a_mistake_in_the_command_line_has_no_place_in_a_file():
    wrong = Finding("--q", "-1 is no quality factor")
    result = Result("asd worst-case", "flat", Status.ERROR, findings=(wrong,))
    (found,) = json.loads(told(Format.SARIF, result))["runs"][0]["results"]
    assert "locations" not in found
    assert told(Format.GITHUB, result).startswith("::error title=finding::--q: -1 is no")


# GitHub's workflow commands: ::name key=value,key=value::text, with %, CR and LF escaped in the
# text, and : and , besides in values

COMMAND = re.compile(r"::(error|warning) ((?:\w+=[^:,]*)(?:,\w+=[^:,]*)*)::(.*)")


def unescaped(text):
    for escape, meant in (("%2C", ","), ("%3A", ":"), ("%0A", "\n"), ("%0D", "\r"), ("%25", "%")):
        text = text.replace(escape, meant)
    return text


def test_github_commands_come_back_as_they_were_meant():
    commands = [c for line in told(Format.GITHUB, FAILING).splitlines() if line.startswith("::")
                for c in [COMMAND.fullmatch(line)]]  # fmt: skip
    assert all(commands)
    levels = [command[1] for command in commands]
    assert levels == ["error"] * 4 + ["warning"]
    told_of = [dict(pair.split("=", 1) for pair in command[2].split(",")) for command in commands]
    assert {each["file"] for each in told_of} == {"flexure.yaml"}
    by_line = {each.get("line"): unescaped(each["title"]) for each in told_of}
    assert by_line["7"] == "fatigue, operation"
    assert by_line["10"].startswith("a|b, 50% ::`<&>`")
    assert commands[-1][3] == "the density is missing: 50%25"


def test_github_shows_no_command_that_a_name_made():
    lines = told(Format.GITHUB, replace(FAILING, spec="::error::x")).splitlines()
    assert sum(line.startswith("::") for line in lines) == 5


# Markdown


def test_markdown_keeps_its_table_whole_whatever_the_names():
    text = told(Format.MARKDOWN, FAILING)
    rows = [line for line in text.splitlines() if line.startswith("|")]
    assert len(rows) == 2 + len(CHECKS)
    assert {len(re.findall(r"(?<!\\)\|", row)) for row in rows} == {10}
    assert text.startswith("### ❌ FAIL")
    assert r"\`\<\&\>\`" in text


# text


def test_the_verdict_comes_first_then_what_fails_then_the_rest_and_values_after():
    value = Value(1.0, "m", "length")
    text = told(Format.TEXT, replace(FAILING, values={"x": value}))
    assert text.startswith("FAIL  check flexure.yaml")
    order = ["a stage", "Margins", "fatigue, operation [", "buckling, operation [",
             "shock, operation [", "yield, operation [", "Values", "Sources"]  # fmt: skip
    assert [text.index(word) for word in order] == sorted(text.index(word) for word in order)


def test_the_sentence_under_the_verdict_is_of_the_worst_check():
    second = told(Format.TEXT, replace(FAILING, checks=CHECKS[:4])).splitlines()[2]
    assert "fatigue, operation" in second
    assert "2.3" in second


def test_a_source_that_many_checks_share_is_told_once():
    assert told(Format.TEXT, FAILING).count("a book") == 1


@pytest.mark.parametrize("close", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("style", [*MACHINES, Format.TEXT])
def test_a_failing_row_never_prints_equal_numbers(style, close):
    demand, capacity = 500e6 * (1.0 + close), 500e6
    row = check(factor=1.0 - close, required=1.0, demand=demand, capacity=capacity)
    text = told(style, replace(FAILING, checks=(row,), warnings=())).replace("\n", " ")
    text = " ".join(text.split())
    pair = re.search(r"factor of (\S+) where (\S+) is asked: (\S+) MPa against (\S+) MPa", text)
    assert pair is not None
    assert pair[1] != pair[2]
    assert pair[3] != pair[4]


def test_what_cancels_is_shown_as_nothing_and_what_is_small_is_not():
    values = {
        "tau_init": Value(0.086, "kg", "before"),
        "tau_final": Value(1.1e-17, "kg", "after"),
        "small": Value(1e-9, "kg", "a small mass"),
        "alone": Value(1e-17, "s", "nothing to compare it with"),
    }
    text = told(Format.TEXT, replace(PASSING, values=values))
    shown = {line.split()[0]: " ".join(line.split()[1:3]) for line in text.splitlines() if line}
    assert shown["tau_final"].startswith("0 ")
    assert shown["small"] == "0.001 mg"
    assert shown["alone"].startswith("1e-14")


@pytest.mark.parametrize(
    ("value", "error", "shown"),
    [
        (4.1234, 0.003, "4.12 N/m"),
        (4.1234, 0.03, "4.1 N/m"),
        (155.3, 0.34, "160 N/m"),
        (155.3, 1e-9, "155.3 N/m"),
        (155.3, None, "155.3 N/m"),
    ],
)
def test_a_value_has_the_digits_that_its_error_leaves(value, error, shown):
    values = {"k": Value(value, "N/m", "stiffness", estimated_error=error)}
    assert shown in told(Format.TEXT, replace(PASSING, values=values))


def test_an_error_that_nobody_can_tell_is_said_to_be_so():
    text = told(Format.TEXT, replace(PASSING, values={"k": Value(1.0, "N/m", "stiffness")}))
    assert "?: error unknown" in text


def test_findings_are_placed_for_editors_and_marked_with_a_caret():
    text = findings_text(FINDINGS.findings)
    assert text.splitlines()[0] == "bad.yaml:3:6: geometry.h: has no unit"
    assert text.splitlines()[2].index("^") == text.splitlines()[1].index("2") + 0


@pytest.mark.parametrize("width", [40, 80, 200])
@pytest.mark.parametrize("encoding", ["ascii", "utf-8"])
def test_every_width_shows_name_and_verdict_and_breaks_no_word(width, encoding):
    result = replace(FAILING, checks=CHECKS[:4])
    text = told(Format.TEXT, result, width=width, encoding=encoding)
    assert max(map(len, text.splitlines())) <= width
    verdicts = ("FAIL", "undecided", "not judged", "pass")
    for verdict, name in zip(verdicts, ("fatigue", "buckling", "shock", "yield"), strict=True):
        assert re.search(rf"^{verdict} +{name}, operation", text, re.MULTILINE)
    whole = told(Format.TEXT, result, width=1000, encoding=encoding)
    words, found = ({word.rstrip(",") for word in each.split()} for each in (whole, text))
    assert not {word for word in found - words if not re.fullmatch(r"[█░┃╂#.|+]+", word)}


# What was passed over: named by every format, a problem to none


PASSED_OVER = Report(
    "check", (FAILING,), True, (PassedOver("a b/ci.yaml", "no spec: ::`x`, 50%"),)
)  # fmt: skip


def test_junit_skips_what_was_passed_over():
    suite = ElementTree.fromstring(Format.JUNIT.render(PASSED_OVER, Page()))[-1]
    assert set(suite.attrib) == SUITE
    assert (suite.get("tests"), suite.get("failures"), suite.get("errors")) == ("1", "0", "0")
    (case,) = suite.findall("testcase")
    assert case.get("classname") == "a b/ci.yaml"
    assert case.find("skipped").get("message") == "no spec: ::`x`, 50%"


def test_sarif_notes_what_was_passed_over():
    (run,) = json.loads(Format.SARIF.render(PASSED_OVER, Page()))["runs"]
    (note,) = run["invocations"][0]["toolExecutionNotifications"]
    assert note["level"] == "note"
    assert note["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == "a%20b/ci.yaml"
    assert {result["ruleId"] for result in run["results"]} <= {
        "fail",
        "undecided",
        "not-judged",
    } | {"warning"}


@pytest.mark.parametrize("style", [Format.GITHUB, Format.MARKDOWN])
def test_what_was_passed_over_is_a_line_that_starts_no_command(style):
    last = style.render(PASSED_OVER, Page()).splitlines()[-1]
    assert "passed over" in last
    assert "a b/ci.yaml" in last
    assert not last.startswith("::")
    if style is Format.MARKDOWN:
        assert "`x`" not in last.replace("\\`", "")


@pytest.mark.parametrize("encoding", ["ascii", "utf-8"])
@pytest.mark.parametrize("width", range(40, 80, 3))
def test_a_number_and_its_unit_stand_in_one_line(width, encoding):
    note = Note("long", "a blade of 12 mm and 3.5 N·mm/rad bears 217.3 MPa at 20 µm " * 3)
    text = told(Format.TEXT, replace(FAILING, warnings=(note,)), width=width, encoding=encoding)
    assert not re.search(r"[\d.]$\n +([mkMGuµ]?(m|Pa|g|Hz)|N[*·]mm/rad)\b", text, re.MULTILINE)
    assert max(map(len, text.splitlines())) <= width
    assert "\ue000" not in text
