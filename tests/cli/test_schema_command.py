"""``flexure schema -o``: a file that editors take, written once."""

import json


def test_the_schema_is_written_to_a_file_that_is_not_there_yet(flexure, tmp_path):
    told = flexure("schema", "material", "-o", "m.schema.json")
    assert (told.returncode, told.stdout) == (0, "")
    written = json.loads((tmp_path / "m.schema.json").read_text(encoding="utf-8"))
    assert written == json.loads(flexure("schema", "material").stdout)


def test_the_schema_replaces_no_file(flexure, tmp_path):
    (tmp_path / "mine.json").write_text("mine")
    told = flexure("schema", "--output", "mine.json")
    assert told.returncode == 2
    assert "cannot write mine.json: it exists" in told.stderr
    assert (tmp_path / "mine.json").read_text() == "mine"
