"""Results as JUnit XML: a suite for each spec, a test case for each check.

The attributes and their order are those that the schema of Ant's JUnit task asks for, the
strictest in use; file and line stand in the text of a failure, for it has no attribute for them.
"""

from collections.abc import Sequence
from datetime import datetime
from xml.etree import ElementTree as Xml

from flexcli.errors import printable
from flexcli.report.formats import Page, Report
from flexcli.report.margins_text import sentence
from flexcli.report.problems import Problem, problems
from flexcli.results import Result

__all__ = ["render"]


def render(report: Report, _: Page) -> str:
    """Return the document; what is not ASCII is a character reference, so any stream takes it."""
    root = Xml.Element("testsuites")
    for number, result in enumerate(report.results):
        root.append(_suite(result, number))
    if report.passed_over:
        root.append(_passed_over(report))
    Xml.indent(root)
    body = Xml.tostring(root, encoding="us-ascii", xml_declaration=False).decode("ascii")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{body}\n'


def _passed_over(report: Report) -> Xml.Element:
    """Return a suite of what was not judged: its cases are skipped."""
    cases = []
    for spec, why in report.passed_over:
        cases.append(Xml.Element("testcase", name="passed over", classname=_clean(spec), time="0"))
        Xml.SubElement(cases[-1], "skipped", message=_clean(why))
    return _filled(f"{report.command} passed over", len(report.results), cases)


def _suite(result: Result, number: int) -> Xml.Element:
    found = list(problems(result))
    by_check = {problem.check: problem for problem in found if problem.check}
    cases = [_case(result, c.full_name, c.seconds, by_check.get(c.full_name), sentence(c))
             for c in result.checks]  # fmt: skip
    cases += [_case(result, f"{p.code} {i}", 0.0, p, "") for i, p in
              enumerate((p for p in found if not p.check), 1)]  # fmt: skip
    if not cases:
        cases.append(_case(result, result.command, 0.0, None, ""))
    spent = result.cost.seconds if result.cost is not None else 0.0
    notes = "; ".join(f"{note.text} [{note.code}]" for note in result.warnings)
    name = f"{result.command} {result.spec}"
    return _filled(name, number, cases, spent, found, result.title, notes)


def _filled(
    name: str,
    number: int,
    cases: Sequence[Xml.Element],
    seconds: float = 0.0,
    found: Sequence[Problem] = (),
    title: str = "",
    notes: str = "",
) -> Xml.Element:
    """Return a suite with all that the schema asks for."""
    suite = Xml.Element(
        "testsuite",
        name=_clean(name),
        timestamp=datetime.now().isoformat(timespec="seconds"),
        hostname="localhost",
        tests=str(len(cases)),
        failures=str(sum(not problem.is_finding for problem in found)),
        errors=str(sum(problem.is_finding for problem in found)),
        time=f"{seconds:.6f}",
        package="flexure",
        id=str(number),
    )
    Xml.SubElement(suite, "properties")
    suite.extend(cases)
    Xml.SubElement(suite, "system-out").text = _clean(title)
    Xml.SubElement(suite, "system-err").text = _clean(notes)
    return suite


def _case(
    result: Result, name: str, seconds: float, problem: Problem | None, text: str
) -> Xml.Element:
    spec = _clean(result.spec)
    case = Xml.Element("testcase", name=_clean(name), classname=spec, time=f"{seconds:.6f}")
    if problem is not None:
        kind = "error" if problem.is_finding else "failure"
        broken = Xml.SubElement(case, kind, message=_clean(problem.text), type=problem.code)
        place = f"{problem.file}:{problem.line}:{problem.column}: " if problem.line else ""
        broken.text = _clean(f"{place}{problem.text or text}")
    return case


def _clean(text: str) -> str:
    """Return a text that XML and its tokens can hold: one line, printable, single spaces."""
    return " ".join(printable(text).split())
