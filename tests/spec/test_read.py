"""Files to documents, and the finding when a file cannot be read."""

import os
from pathlib import Path

import pytest

from flexcli.errors import SpecError
from flexcli.spec.read import MAX_BYTES, read_document


def test_a_byte_order_mark_is_no_column(tmp_path: Path) -> None:
    file = tmp_path / "spec.yaml"
    file.write_bytes(b"\xef\xbb\xbfa: 1\n")
    assert read_document(file).position.children["a"].column == 4


def test_files_that_cannot_be_read_are_findings(tmp_path: Path) -> None:
    loop = tmp_path / "loop.yaml"
    loop.symlink_to(loop)
    pipe = tmp_path / "pipe.yaml"
    os.mkfifo(pipe)
    large = tmp_path / "large.yaml"
    large.write_bytes(b"#" * (MAX_BYTES + 1))
    latin = tmp_path / "latin.yaml"
    latin.write_bytes("a: 1\nb: µ\n".encode("latin-1"))
    for path, says, line in (
        (tmp_path / "none.yaml", "no such file", 0),
        (tmp_path, "is a folder", 0),
        (loop, "leads to no file", 0),
        (pipe, "is a device", 0),
        (large, "too large", 0),
        (latin, "not UTF-8", 2),
        (tmp_path / ("n" * 300 + ".yaml"), "cannot be read", 0),
    ):
        with pytest.raises(SpecError) as raised:
            read_document(path)
        (finding,) = raised.value.findings
        assert says in finding.text
        assert finding.line == line
        assert finding.hint
        assert finding.where.startswith(str(path))
