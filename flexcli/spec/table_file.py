"""Tables of measured or published numbers in text files: columns with their units, and places.

Comma, semicolon, tab or blanks part the columns; between semicolons and tabs a number may have a
decimal comma. Lines that start with # or % and empty ones are passed over, as is what stands
above the heading.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from importlib import import_module
from io import BytesIO, StringIO
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Finding, SpecError, printable
from flexcli.parts.base import said
from flexcli.parts.record import Record
from flexcli.spec.document import MAX_FINDINGS, Position
from flexcli.spec.findings import nearest
from flexcli.units import DIMENSIONS, QuantityError, parse_quantity

__all__ = [
    "TABLES",
    "Columns",
    "TableFile",
    "is_over_time",
    "named_table",
    "read_table",
    "recorded",
]

MAX_BYTES = 500_000_000
"""Of a record, some twenty million samples."""

TABLES: dict[str, tuple[tuple[str, str], ...]] = {
    "asd": (("frequency", "frequency"), ("level", "acceleration density")),
    "srs": (("frequency", "frequency"), ("acceleration", "acceleration")),
    "record": (("time", "time"), ("acceleration", "acceleration")),
}
"""What the two columns of each kind of table are, and what they measure."""

UNEVEN = 1e-2
"""Allowed deviation of a time step, relative: files write times with few digits."""

STEP = "step"
"""Heading of a column that says where a level jumps."""

_WORDS = {"": False, "0": False, "false": False, "no": False,
          "1": True, "true": True, "yes": True}  # fmt: skip
_COMMENT = ("#", "%")
_BRACKETS = re.compile(r"\[(.*)\]|\((.*)\)\s*$")
_POWERS = str.maketrans({"⁴": "^4", "²": "^2", "³": "^3"})
_CAPITAL_G = re.compile(r"(?<![A-Za-z])G(?![A-Za-z])")

Floats = NDArray[np.float64]


class Columns(NamedTuple):
    """Data about a table that its heading lacks: units, and the column to take."""

    units: tuple[str, ...] = ()
    column: str = ""

    @classmethod
    def told(cls, units: str | None, column: str | None) -> "Columns":
        """Return what two options say, the units with a comma between."""
        each = tuple(unit.strip() for unit in (units or "").split(",") if unit.strip())
        return cls(each, column or "")


class TableFile(NamedTuple):
    """Two columns of a table, their units, and the line and the two columns where each row stands.

    ``steps`` says of each row whether the level jumps there; a long record has no places.
    """

    file: str
    keys: tuple[str, str]
    numbers: Floats
    units: tuple[str, str]
    places: tuple[tuple[int, int, int], ...]
    steps: tuple[bool, ...]
    lines: list[str]

    def points(self) -> list[dict[str, object]]:
        """Return its rows as a spec would write them."""
        first, second = self.keys
        found: list[dict[str, object]] = []
        for (a, b), jumps in zip(self.numbers.tolist(), self.steps, strict=True):
            row: dict[str, object] = {
                first: f"{a!r} {self.units[0]}",
                second: f"{b!r} {self.units[1]}",
            }
            found.append({**row, STEP: True} if jumps else row)
        return found

    def position(self) -> Position:
        """Return where its rows stand, as children of the whole."""
        children: dict[str | int, Position] = {}
        for index, (line, *columns) in enumerate(self.places):
            cells: dict[str | int, Position] = {
                key: self._at(line, column, {})
                for key, column in zip(self.keys, columns, strict=True)
            }
            children[index] = self._at(line, columns[0], cells)
        return self._at(1, 1, children)

    def _at(self, line: int, column: int, children: dict[str | int, Position]) -> Position:
        return Position(self.file, line, column, line, column, children)

    @property
    def si(self) -> Floats:
        """Return both columns in SI."""
        scales = [
            parse_quantity(f"1 {unit}", DIMENSIONS[dimension].name)
            for unit, dimension in zip(self.units, _dimensions(self.keys), strict=True)
        ]
        return np.asarray(self.numbers * np.array(scales))


def _dimensions(keys: tuple[str, str]) -> tuple[str, str]:
    found = next(each for each in TABLES.values() if tuple(key for key, _ in each) == keys)
    return found[0][1], found[1][1]


def named_table(value: Any, suffixes: tuple[str, ...]) -> tuple[str, Columns]:
    """Return path and columns of a table as a spec names it.

    It is a path, or ``{file: psd.csv, units: [Hz, g^2/Hz], column: 2}``.

    Raises
    ------
    SpecError
        When it is something else.

    """
    given = value if isinstance(value, dict) else {"file": value}
    file, units, column = given.get("file"), given.get("units", []), given.get("column", "")
    hint = "write psd.csv, or {file: psd.csv, units: [Hz, g^2/Hz], column: 2}"
    faults = []
    if strange := sorted(set(given) - {"file", "units", "column"}):
        faults.append(f"unknown key '{strange[0]}'")
    if not isinstance(file, str) or not file.lower().endswith(suffixes):
        faults.append(f"a list of points or a table is expected here, not {said(file)}")
    if not isinstance(units, list) or not all(isinstance(unit, str) for unit in units):
        faults.append(f"units are a list of two, not {said(units)}")
    if isinstance(column, bool) or not isinstance(column, str | int):
        faults.append(f"a column is a name or a number, not {said(column)}")
    if faults:
        raise SpecError([Finding("", fault, hint) for fault in faults])
    return str(file), Columns(tuple(units), str(column))


def read_table(path: Path, kind: str, told: Columns = Columns()) -> TableFile:  # noqa: B008
    """Read the two columns of a kind of table, or raise :class:`SpecError` with every finding.

    Parameters
    ----------
    path : Path
        The file.
    kind : str
        A key of :data:`TABLES`.
    told : Columns
        Units and column, where the heading does not tell them.

    """
    return _Reader(str(path), _text(path), kind, told).table()


def recorded(name: str, table: TableFile) -> Record:
    """Return the record of a table of time and acceleration; raise SpecError."""
    time, acceleration = table.si.T
    step = float(time[-1] - time[0]) / (time.size - 1)
    off = np.abs(time - time[0] - step * np.arange(time.size)).max() / step
    steps = np.abs(np.diff(time) / step - 1.0).max()
    if off > UNEVEN * time.size**0.5 and steps > UNEVEN:
        text = f"the samples are not at equal steps: one is {steps:.2g} of a step off"
        raise SpecError([Finding(name, text, "resample it evenly")])
    return Record(name, step, np.ascontiguousarray(acceleration))


def is_over_time(path: Path, told: Columns) -> bool:
    """Return whether the first column of a table is a time, as its heading or its units tell."""
    if told.units:
        return _measures(told.units[0], "time")
    return _Reader(str(path), _text(path), "record", told).is_over_time()


def _parquet_text(name: str, raw: bytes) -> str:
    """Return the columns of a Parquet file as text, their names as its heading."""
    try:
        csv, parquet = import_module("pyarrow.csv"), import_module("pyarrow.parquet")
    except ImportError as error:
        hint = "pip install 'flexcli[study]', or save it as CSV"
        raise SpecError([Finding(name, "Parquet needs the extra 'study'", hint)]) from error
    found = BytesIO()
    try:
        table = parquet.read_table(BytesIO(raw))
        csv.write_csv(table, found, csv.WriteOptions(include_header=False))
    except (OSError, ValueError) as error:
        text = f"cannot be read as Parquet: {printable(str(error))[:80]}"
        raise SpecError([Finding(name, text, "give the path of a table")]) from error
    return f"{','.join(table.column_names)}\n{found.getvalue().decode()}"


def _text(path: Path) -> str:
    name = str(path)
    try:
        if not path.is_file():
            raise SpecError([Finding(name, "there is no such file", "give the path of a table")])
        with path.open("rb") as stream:
            raw = stream.read(MAX_BYTES + 1)
    except OSError as error:
        text = f"cannot be read: {error.strerror}"
        raise SpecError([Finding(name, text, "give the path of a table")]) from error
    if name.lower().endswith(".parquet"):
        return _parquet_text(name, raw)
    if len(raw) > MAX_BYTES:
        text = f"is larger than {MAX_BYTES // 1_000_000} MB"
        raise SpecError([Finding(name, text, "cut the record into parts")])
    if raw[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return _decoded(name, raw, "utf-16")
    return _decoded(name, raw, "utf-8-sig")


def _decoded(name: str, raw: bytes, encoding: str) -> str:
    try:
        return raw.decode(encoding)
    except UnicodeDecodeError as error:
        line = raw[: error.start].count(b"\n") + 1
        raise SpecError([Finding(name, "is not UTF-8 text", "save it as UTF-8", line=line,
                                 column=1)]) from error  # fmt: skip


class _Row(NamedTuple):
    """A line that is no comment: its number from 1 on, its cells, where each starts."""

    line: int
    cells: list[str]
    columns: list[int]


class _Reader:
    """Finds heading, separator and columns of a text, and reads its numbers."""

    def __init__(self, file: str, text: str, kind: str, told: Columns) -> None:
        self.file, self.kind, self.told = file, kind, told
        self.lines = re.split(r"\r\n|[\n\r]", text)
        self.keys = (TABLES[kind][0][0], TABLES[kind][1][0])
        self.dimensions = (TABLES[kind][0][1], TABLES[kind][1][1])
        self.findings: list[Finding] = []
        self.width = 0
        self.separator = self._separator()
        self.has_decimal_commas = self.separator in (";", "\t")

    def table(self) -> TableFile:
        """Return the table, or raise what is wrong."""
        rows = self._rows()
        heads: list[_Row] = []
        first = next(rows, None)
        while first is not None and not self._is_numeric(first):
            heads.append(first)
            first = next(rows, None)
        if first is None:
            text = "holds no row of numbers" if heads else "is empty"
            raise SpecError([Finding(self.file, text, f"write {' and '.join(self.keys)} in a row")])
        named = next((len(head.cells) for head in heads[::-1] if len(head.cells) > 1), 0)
        self.width = max(named, len(first.cells)) if self._is_stepped(heads) else len(first.cells)
        first = self._row(first.line, self.lines[first.line - 1])
        heads = [head for head in heads if len(head.cells) == len(first.cells)][-2:]
        column = self._column(heads, first)
        step = self._step_column(heads)
        units = self._units(heads, (0, column), first)
        numbers, places, steps = self._numbers(first, column, step)
        return TableFile(self.file, self.keys, numbers, units, places, steps, self.lines)

    def is_over_time(self) -> bool:
        """Return whether the heading says that the first column is a time."""
        heads = []
        for row in self._rows():
            if self._is_numeric(row):
                break
            heads.append(row)
        return bool(self._unit_of(heads[-2:], 0, "time")[0])

    def _separator(self) -> str | None:
        """Return what parts the columns, by the lines of numbers; nothing stands for blanks."""
        for line in self.lines:
            if not line.strip() or line.lstrip().startswith(_COMMENT):
                continue
            if not re.match(r"\s*[+-]?[\d.]", line):
                continue
            return next((mark for mark in (";", "\t", ",") if mark in line), None)
        joined = "\n".join(self.lines[:50])
        return next((mark for mark in (";", "\t", ",") if mark in joined), None)

    def _rows(self) -> Iterator[_Row]:
        for number, line in enumerate(self.lines, start=1):
            if line.strip() and not line.lstrip().startswith(_COMMENT):
                yield self._row(number, line)

    def _row(self, number: int, line: str) -> _Row:
        if self.separator is None:
            found = [(m.group(), m.start() + 1) for m in re.finditer(r"\S+", line)]
        else:
            found, start = [], 0
            for cell in _cells(line, self.separator):
                before = len(cell) - len(cell.lstrip())
                found.append((cell.strip().strip('"').strip(), start + before + 1))
                start += len(cell) + 1
        while len(found) > max(self.width, 1) and not found[-1][0]:  # a separator at the end
            found.pop()
        return _Row(number, [cell for cell, _ in found], [at for _, at in found])

    def _number(self, cell: str) -> float:
        return float(cell.replace(",", ".") if self.has_decimal_commas else cell)

    def _is_numeric(self, row: _Row) -> bool:
        """Return whether a row holds numbers, so that it is no heading, sound or not."""
        try:
            self._number(row.cells[0])
        except ValueError:
            return False
        return True

    def _find(self, row: _Row | None, column: int, text: str, hint: str) -> None:
        if row is None:
            self.findings.append(Finding(self.file, printable(text), printable(hint)))
            return
        at = row.columns[min(column, len(row.columns) - 1)]
        line = self.lines[row.line - 1]
        shown = printable(line) if len(line) < 500 else ""
        self.findings.append(
            Finding(self.file, printable(text), printable(hint), "", row.line, at, shown)
        )
        if len(self.findings) >= MAX_FINDINGS:
            self._raise()

    def _raise(self) -> None:
        if self.findings:
            raise SpecError(self.findings)

    def _column(self, heads: Sequence[_Row], first: _Row) -> int:
        """Return which column holds the level, by what is told or by the heading."""
        width, told = len(first.cells), self.told.column
        if width < 2:
            self._find(first, 0, f"there is no second column with the {self.keys[1]}",
                       "write both in a row, a comma between")  # fmt: skip
            self._raise()
        names = heads[0].cells if heads else []
        if told.isdigit() and 2 <= int(told) <= width:
            return int(told) - 1
        if told:
            if told in names[1:]:
                return names.index(told)
            plain = [_without_unit(name) for name in names]
            if told in plain[1:]:
                return plain.index(told)
            known = nearest(told, plain[1:]) or f"give its number, 2 to {width}"
            self._find(heads[0] if heads else None, 0, f"there is no column '{told}'", known)
            self._raise()
        others = [i for i in range(1, width) if not (names and names[i].lower() == STEP)]
        if len(others) == 1:
            return others[0]
        fitting = [i for i in others if self._unit_of(heads, i, self.dimensions[1])[0]]
        if len(fitting) == 1:
            return fitting[0]
        listed = ", ".join(_without_unit(name) for name in names[1:]) or f"2 to {width}"
        self._find(heads[-1] if heads else first, 0, f"{width} columns, and nothing says which "
                   f"holds the {self.keys[1]}",
                   f"name it, --column or column: in the spec: {listed}")  # fmt: skip
        self._raise()
        raise AssertionError  # raised above

    @staticmethod
    def _is_stepped(heads: Sequence[_Row]) -> bool:
        """Return whether a heading has a column of steps, which most rows leave empty."""
        return any(STEP in [cell.lower() for cell in head.cells] for head in heads)

    @staticmethod
    def _step_column(heads: Sequence[_Row]) -> int | None:
        names = [cell.lower() for cell in heads[0].cells] if heads else []
        return names.index(STEP) if STEP in names else None

    def _unit_of(self, heads: Sequence[_Row], column: int, dimension: str) -> tuple[str, str]:
        """Return the unit that a heading tells, or that in brackets which does not fit."""
        wrong = ""
        for head in heads:
            for text, is_sure in _candidates(head.cells[column]):
                unit = _CAPITAL_G.sub("g", text.translate(_POWERS))
                if _measures(unit, dimension):
                    return unit, ""
                wrong = wrong or (text if is_sure else "")
        return "", wrong

    def _units(self, heads: Sequence[_Row], columns: Iterable[int], first: _Row) -> tuple[str, str]:
        """Return the units of both columns, as the heading tells them or as they are told."""
        found = []
        if self.told.units and len(self.told.units) != 2:
            self._find(None, 0, f"{len(self.told.units)} units are told of two columns",
                       "tell both, e.g. Hz, g^2/Hz")  # fmt: skip
        for n, column in enumerate(columns):
            dimension, key = self.dimensions[n], self.keys[n]
            expected = DIMENSIONS[dimension]
            unit, wrong = self._unit_of(heads, column, dimension)
            told = self.told.units[n] if len(self.told.units) == 2 else ""
            if told and not _measures(told, dimension):
                self._find(None, 0, f"'{told}' does not measure {expected.named}",
                           f"write e.g. {expected.unit}")  # fmt: skip
            elif told and unit and _size(told, dimension) != _size(unit, dimension):
                self._find(heads[-1], column, f"the heading says {unit}, and {told} is told",
                           "mend one of them")  # fmt: skip
            elif wrong and not told:
                self._find(heads[-1], column, f"'{wrong}' does not measure {expected.named}",
                           f"the {key} is in e.g. {expected.unit}")  # fmt: skip
            elif not (unit or told):
                pair = ", ".join(DIMENSIONS[each].unit for each in self.dimensions)
                self._find(heads[-1] if heads else first, column, f"no unit of the {key} is told",
                           f"write it in a heading, {key} [{expected.unit}], or tell both: "
                           f"units: [{pair}] in a spec, --units '{pair}'")  # fmt: skip
            found.append(unit or told)
        return found[0], found[1]

    def _numbers(
        self, first: _Row, column: int, step: int | None
    ) -> tuple[Floats, tuple[tuple[int, int, int], ...], tuple[bool, ...]]:
        if self.kind == "record":
            self._raise()
            quick = self._quickly(first, column)
            if quick is not None:
                return quick, (), ()
        numbers: list[tuple[float, float]] = []
        places: list[tuple[int, int, int]] = []
        steps: list[bool] = []
        for number, line in enumerate(self.lines[first.line - 1 :], start=first.line):
            if not line.strip() or line.lstrip().startswith(_COMMENT):
                continue
            row = self._row(number, line)
            if len(row.cells) != len(first.cells):
                self._find(row, 0, f"{len(row.cells)} columns, where the first row has "
                           f"{len(first.cells)}", "mend or remove the row")  # fmt: skip
                continue
            pair = self._pair(row, column)
            if pair is None:
                continue
            numbers.append(pair)
            places.append((number, row.columns[0], row.columns[column]))
            word = row.cells[step].lower() if step is not None else ""
            if word not in _WORDS:
                self._find(row, step or 0, f"'{word}' is neither true nor false", "write true")
            steps.append(_WORDS.get(word, False))
        if self.kind == "record":
            self._refuse_times(numbers, [line for line, *_ in places])
        elif not any(steps) and all(a > b for (a, _), (b, _) in pairwise(numbers)):
            numbers, places = numbers[::-1], places[::-1]  # written from the highest frequency down
        self._raise()
        return np.array(numbers), tuple(places), tuple(steps)

    def _quickly(self, first: _Row, column: int) -> Floats | None:
        """Return a long record by NumPy's own reader; nothing where a row needs a finding."""
        block = "\n".join(self.lines[first.line - 1 :])
        if self.has_decimal_commas:
            block = block.replace(",", ".")
        try:
            found: Floats = np.loadtxt(
                StringIO(block), delimiter=self.separator, comments=list(_COMMENT),
                usecols=(0, column), ndmin=2,
            )  # fmt: skip
        except ValueError:
            return None
        sound = np.isfinite(found).all() and (np.diff(found[:, 0]) > 0.0).all()
        return found if sound and found.shape[0] > 1 else None

    def _pair(self, row: _Row, column: int) -> tuple[float, float] | None:
        pair = []
        for n, at in enumerate((0, column)):
            cell = row.cells[at]
            try:
                value = self._number(cell)
            except ValueError:
                hint = "write a decimal point" if "," in cell else "mend or remove the row"
                self._find(row, at, f"'{cell}' is no number", hint)
                return None
            if not np.isfinite(value):
                self._find(row, at, f"the {self.keys[n]} is {cell}", "mend or remove the row")
                return None
            if value < 0.0 and self.kind != "record":
                self._find(row, at, f"the {self.keys[n]} {cell} is negative",
                           "mend or remove the row")  # fmt: skip
                return None
            if value == 0.0 and self.kind != "record":
                self._find(row, at, f"the {self.keys[n]} is 0, which has no place on log-log axes",
                           "remove the row")  # fmt: skip
                return None
            pair.append(value)
        return pair[0], pair[1]

    def _refuse_times(self, numbers: Sequence[tuple[float, float]], lines: Sequence[int]) -> None:
        if len(numbers) < 2:
            self._find(None, 0, "a record has two samples or more", "give the whole record")
        for index in range(1, len(numbers)):
            if numbers[index][0] <= numbers[index - 1][0]:
                row = self._row(lines[index], self.lines[lines[index] - 1])
                self._find(row, 0, f"the time {numbers[index][0]:g} does not rise from "
                           f"{numbers[index - 1][0]:g}", "put the rows in order")  # fmt: skip


def _cells(line: str, separator: str) -> list[str]:
    """Return the cells of a line, quotes kept, so that places stay where they are."""
    if '"' not in line:
        return line.split(separator)
    return re.split(f'{re.escape(separator)}(?=(?:[^"]*"[^"]*")*[^"]*$)', line)


def _candidates(text: str) -> Iterator[tuple[str, bool]]:
    """Yield what may be the unit in a heading, and whether it is meant as one for sure."""
    bracket = _BRACKETS.search(text)
    if bracket is not None:
        yield (bracket[1] or bracket[2] or "").strip(), True
    yield text.strip(), False
    for mark in (",", " in ", "_", " "):
        before, found, after = text.rpartition(mark)
        if found and before:
            yield after.strip().strip("()[]"), False


def _without_unit(text: str) -> str:
    return _BRACKETS.sub("", text).strip() or text


def _measures(unit: str, dimension: str) -> bool:
    return bool(unit) and _size(unit, dimension) is not None


def _size(unit: str, dimension: str) -> float | None:
    try:
        return parse_quantity(f"1 {unit}", dimension)
    except QuantityError:
        return None
