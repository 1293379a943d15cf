"""Results as GitHub's workflow commands, which become annotations beside the lines of the spec.

https://docs.github.com/actions/reference/workflow-commands-for-github-actions
"""

from flexcli.report.charset import plain
from flexcli.report.formats import Page, Report
from flexcli.report.margins_text import decisive, sentence
from flexcli.report.problems import Problem, problems
from flexcli.results import Result

__all__ = ["render"]

_DATA = str.maketrans({"%": "%25", "\r": "%0D", "\n": "%0A"})
_PROPERTY = _DATA | str.maketrans({":": "%3A", ",": "%2C"})


def render(report: Report, page: Page) -> str:
    """Return an error for each problem, a warning for each note, and a line for each result."""
    lines = []
    for result in report.results:
        lines += [_command("error", problem, page.encoding) for problem in problems(result)]
        lines += [
            _command("warning", Problem(note.code, note.text, result.spec), page.encoding)
            for note in result.warnings
        ]
        lines.append(plain(_told(result), page.encoding))
    # no colon starts them either
    lines += [f"passed over {plain(f'{s}: {why}', page.encoding)}" for s, why in report.passed_over]
    return "".join(f"{line}\n" for line in lines)


def _command(level: str, problem: Problem, encoding: str) -> str:
    properties = {"file": problem.file, "line": problem.line, "col": problem.column}
    properties["title"] = problem.check or problem.code
    told = ",".join(
        f"{name}={_escaped(str(value), _PROPERTY, encoding)}"
        for name, value in properties.items()
        if value
    )
    return f"::{level} {told}::{_escaped(problem.text, _DATA, encoding)}"


def _escaped(text: str, table: dict[int, str], encoding: str) -> str:
    return plain(text, encoding).translate(table)


def _told(result: Result) -> str:
    """Return a line for the log without a leading colon, so that GitHub takes it for no command."""
    worst = decisive(result.checks)
    said = f": {sentence(worst)}" if worst is not None else ""
    return f"{result.status.value.upper()}  {result.command} {result.spec}{said}"
